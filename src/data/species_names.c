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

/* Words of everyday for trees that several tables are of, or none exactly, and their genera. */
static const struct {
    const char *words, *genera;
} kinds[] = {
    { "pine pin 松 松树", "pinus" },
    { "maple ahorn erable 槭 槭树 枫树", "acer" },
    { "willow weide saule 柳 柳树", "salix" },
    { "spruce 云杉", "picea" },
    { "larch larche laerche meleze 落叶松", "larix" },
    { "bamboo bambus bambou 竹 竹子 竹树", "phyllostachys guadua" },
    { "白蜡 白蜡树", "fraxinus" },
    { "山毛榉 水青冈", "fagus" },
    { "chestnut kastanie", "aesculus" },
    { "栎 柞树 红栎 栓皮栎 麻栎 蒙古栎", "quercus" },
};

/* The same first word, where there are two: a genus. */
static bool has_genus(const char *name, const char *wanted)
{
    size_t n = strcspn(wanted, " ");
    return n >= 3 && name[n] == ' ' && !strncmp(name, wanted, n);
}

/* "Acer", "Acer sp." and "maple" are a genus alone. */
static bool is_genus(const char *name, const char *wanted)
{
    char genus[40];
    const char *rest = wanted + strcspn(wanted, " ");
    (void)snprintf(genus, sizeof genus, "%.*s", (int)strcspn(name, " "), name);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        if (wf_text_among(kinds[k].words, wanted)) return wf_text_among(kinds[k].genera, genus);
    return wf_text_among("sp sp. spp spp. species", *rest ? rest + 1 : "sp") && has_genus(name, wanted);
}

/* Is `word` one of the words of a text? */
static bool has_word(const char *text, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = text; n >= 3 && (at = strstr(at, word)); at++)
        if ((at == text || at[-1] == ' ') && (!at[n] || at[n] == ' ')) return true;
    return false;
}

/* "red oak" has the name oak, and "Chinese fir" the word fir. */
static bool shares_word(const char *name, const char *wanted)
{
    return has_word(wanted, name) || has_word(name, wanted);
}

/* A third of the characters may differ; of two Chinese ones the second. */
static bool is_near(const char *name, const char *wanted)
{
    size_t characters = 0, n = strlen(wanted), d = wf_word_distance(wanted, name);
    for (const char *p = wanted; *p; p++) characters += (*p & 0xC0) != 0x80;
    bool pair = characters == 2 && n == 6 && !strncmp(name, wanted, 3);
    return wf_word_is_near(wanted, d) && (3 * d <= characters || pair);
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
    static name_fits *const ways[] = { is_genus, shares_word, overlaps, has_genus, is_near };
    const char *wanted = wf_text_folded(name, a);
    size_t n = 0;
    for (size_t i = 0; i < sizeof ways / sizeof *ways && !n; i++)
        n = tables_that(l, wanted, ways[i], a, out, room);
    return n;
}

/* "; say which: 'a' (Latin name) or 'b' (Latin name)"; of many the keys alone. */
static const char *tables_text(const char *before, const struct wf_species **of, size_t n, struct wf_arena *a)
{
    enum { WITH_LATIN = 3 };
    const char *text = before;
    for (size_t i = 0; text && i < n; i++) {
        const char *latin = of[i]->latin, *end = latin ? strstr(latin, " / ") : NULL;
        bool named = latin && n <= WITH_LATIN;
        text = wf_arena_print(a, "%s%s'%s'%s%.*s%s", text,
                              !i          ? " "
                              : i + 1 < n ? ", "
                                          : " or ",
                              of[i]->key, named ? " (" : "",
                              !named ? 0
                              : end  ? (int)(end - latin)
                                     : (int)strlen(latin),
                              named ? latin : "", named ? ")" : "");
    }
    return text;
}

/* "Tilia cordata 'Greenspire'" is a Tilia cordata. Returned: NULL where no cultivar is named. */
static const char *without_cultivar(const char *name, struct wf_arena *a)
{
    static const char *const quote[] = { " '", " \"", " \xE2\x80\x98", " \xE2\x80\x9E", " \xE2\x80\x9C" };
    for (size_t k = 0; k < sizeof quote / sizeof *quote; k++) {
        const char *at = strstr(name, quote[k]);
        if (at && at > name) return wf_arena_print(a, "%.*s", (int)(at - name), name);
    }
    return NULL;
}

enum wf_status wf_species_path(const char *share, const char *name, const struct wf_laws *laws,
                               struct wf_arena *a, const char **path, struct wf_err *e)
{
    enum { NEAR_MAX = 8 };
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
        return wf_fail(e, WF_EINPUT, "%s: several species tables have that name%s", name,
                       tables_text("; say which:", found, n, a));
    const char *species = without_cultivar(name, a);
    if (species) return wf_species_path(share, species, laws, a, path, e);
    n = tables_that(&l, wf_text_folded(name, a), is_genus, a, found, NEAR_MAX);
    if (n > 1)
        return wf_fail(e, WF_EINPUT, "%.60s: no shipped species table is of all of these trees%s", name,
                       tables_text("; say which:", found, n, a));
    if (!n) n = wf_species_near(&l, name, a, found, NEAR_MAX);
    if (!n)
        return wf_fail(e, WF_EINPUT,
                       "%.60s: there is no such file, and no shipped species table of that name; 'windfirm "
                       "species list' shows them",
                       name);
    return wf_fail(e, WF_EINPUT, "%.60s: there is no such file, and no shipped species table of that name%s?",
                   name, tables_text("; did you mean", found, n, a));
}
