/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/species_names.h"
#include "base/file.h"
#include "base/text.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum wf_status wf_species_library_read(const char *share, const struct wf_laws *laws, struct wf_arena *a,
                                       struct wf_species_library *out, struct wf_diag *d, struct wf_err *e)
{
    const char **keys, *path;
    size_t n = wf_shipped_names(share, "species", a, &keys);
    *out = (struct wf_species_library){ .species = n ? WF_TAKE(a, n, struct wf_species) : NULL };
    if (!n) return wf_fail(e, WF_EINPUT, "no species tables are installed");
    if (!out->species) return wf_fail(e, WF_ENOMEM, "no memory for the species tables");
    for (size_t i = 0; i < n; i++) {
        enum wf_status s = wf_shipped_path(share, "species", keys[i], a, &path, NULL);
        if (!s) s = wf_species_read(path, laws, a, &out->species[out->n], d, NULL);
        if (s == WF_ENOMEM) return wf_fail(e, s, "no memory for the species tables");
        out->n += !s;
    }
    return WF_OK;
}

/* The k-th of the Latin names; *n: how many there are where k is beyond. */
static const char *latin_name(const char *latin, size_t k, size_t *n, struct wf_arena *a)
{
    static const char between[] = " / ";
    const char *s = latin, *end;
    for (*n = 0; s; s = end ? end + strlen(between) : NULL, ++*n) {
        end = strstr(s, between);
        if (*n == k) return end ? wf_arena_print(a, "%.*s", (int)(end - s), s) : s;
    }
    return NULL;
}

const char *wf_species_name(const struct wf_species *sp, size_t k, struct wf_arena *a)
{
    const char *const own[] = { sp->key, sp->name, sp->name_zh };
    size_t n = 0;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (own[i] && n++ == k) return own[i];
    size_t latins;
    const char *latin = latin_name(sp->latin, k - n, &latins, a);
    if (latin) return latin;
    return k - n - latins < sp->aliases ? sp->alias[k - n - latins] : NULL;
}

/* Ask `fits` of every name of a species, folded; NULL: no name fits. */
typedef bool name_fits(const char *name, const char *wanted);
static const char *name_that(const struct wf_species *sp, const char *wanted, name_fits *fits,
                             struct wf_arena *a)
{
    const char *name;
    for (size_t k = 0; (name = wf_species_name(sp, k, a)); k++) {
        const char *folded = wf_text_folded(name, a);
        if (folded && fits(folded, wanted)) return name;
    }
    return NULL;
}

static bool is_same(const char *name, const char *wanted) { return !strcmp(name, wanted); }

static bool contains(const char *name, const char *wanted) { return strstr(name, wanted); }

/* One within the other. A short one says little: of ASCII four letters, of others, which are Chinese, two. */
static bool overlaps(const char *name, const char *wanted)
{
    enum { LEAST = 4 };
    return strlen(name) >= LEAST && strlen(wanted) >= LEAST && (strstr(name, wanted) || strstr(wanted, name));
}

/* The same first word, where there are two: a genus. */
static bool has_genus(const char *name, const char *wanted)
{
    size_t n = strcspn(wanted, " ");
    return n >= 3 && name[n] == ' ' && !strncmp(name, wanted, n);
}

static bool is_near(const char *name, const char *wanted)
{
    return wf_word_is_near(wanted, wf_word_distance(wanted, name));
}

const char *wf_species_name_with(const struct wf_species *sp, const char *text, struct wf_arena *a)
{
    const char *wanted = wf_text_folded(text, a);
    const char *same = wanted ? name_that(sp, wanted, is_same, a) : NULL;
    return same || !wanted ? same : name_that(sp, wanted, contains, a);
}

/* Tables with a name that fits. */
static size_t tables_that(const struct wf_species_library *l, const char *wanted, name_fits *fits,
                          struct wf_arena *a, const struct wf_species **out, size_t room)
{
    size_t n = 0;
    for (size_t i = 0; wanted && i < l->n && n < room; i++)
        if (name_that(&l->species[i], wanted, fits, a)) out[n++] = &l->species[i];
    return n;
}

size_t wf_species_near(const struct wf_species_library *l, const char *name, struct wf_arena *a,
                       const struct wf_species **out, size_t room)
{
    static name_fits *const ways[] = { overlaps, has_genus, is_near };
    const char *wanted = wf_text_folded(name, a);
    size_t n = 0;
    for (size_t i = 0; i < sizeof ways / sizeof *ways && !n; i++)
        n = tables_that(l, wanted, ways[i], a, out, room);
    return n;
}

/* "; did you mean 'a' (Latin name) or 'b' (Latin name)?" */
static const char *tables_text(const char *before, const struct wf_species **of, size_t n, struct wf_arena *a)
{
    const char *text = before;
    for (size_t i = 0; text && i < n; i++)
        text = wf_arena_print(a, "%s%s'%s'%s%s%s", text,
                              !i          ? " "
                              : i + 1 < n ? ", "
                                          : " or ",
                              of[i]->key, of[i]->latin ? " (" : "", of[i]->latin ? of[i]->latin : "",
                              of[i]->latin ? ")" : "");
    return text;
}

static bool near_key(const struct wf_species_library *l, const char *name, struct wf_arena *a)
{
    const char **keys = WF_TAKE(a, l->n + 1, const char *);
    for (size_t i = 0; keys && i < l->n; i++) keys[i] = l->species[i].key;
    return keys && wf_nearest(name, keys, l->n);
}

enum wf_status wf_species_path(const char *share, const char *name, const struct wf_laws *laws,
                               struct wf_arena *a, const char **path, struct wf_err *e)
{
    enum { NEAR_MAX = 6 };
    const struct wf_species *found[NEAR_MAX];
    struct wf_species_library l;
    struct wf_diag d = { .arena = a }; /* tables with mistakes have no names */
    struct wf_err unknown = { 0 };
    if (!wf_shipped_path(share, "species", name, a, path, &unknown)) return WF_OK;
    if (wf_species_library_read(share, laws, a, &l, &d, NULL))
        return wf_fail(e, unknown.code, "%s", unknown.text);
    size_t n = tables_that(&l, wf_text_folded(name, a), is_same, a, found, NEAR_MAX);
    if (n == 1) return *path = found[0]->file, WF_OK;
    if (n)
        return wf_fail(e, WF_EINPUT, "%s: several species tables have that name%s?", name,
                       tables_text("; did you mean", found, n, a));
    n = tables_that(&l, wf_text_folded(name, a), overlaps, a, found, NEAR_MAX); /* larch is no birch */
    if (!n && !near_key(&l, name, a)) n = wf_species_near(&l, name, a, found, NEAR_MAX);
    if (!n) return wf_fail(e, unknown.code, "%s", unknown.text); /* with the nearest key, or with all */
    return wf_fail(e, WF_EINPUT, "%s: there is no such file, and no shipped species table of that name%s?",
                   name, tables_text("; did you mean", found, n, a));
}
