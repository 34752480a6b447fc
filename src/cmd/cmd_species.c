/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/num.h"
#include "base/said.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "data/species.h"
#include "data/species_names.h"
#include "load/drag.h"
#include "load/load.h"
#include <stdio.h>
#include <string.h>

struct species_options {
    struct wf_args args;
    const char *search; /* NULL: all tables are listed */
    const char *lang;
};

static bool search_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_args *args = options;
    (void)row;
    return wf_option_unused(args->n && strcmp(args->operand[0], "list") != 0, why, "without 'list'");
}

#define OPTIONS struct species_options
static const struct wf_option options[] = {
    TEXT("--search", search, "TEXT", NULL,
         "with list: only tables one of whose names has this text in it: Latin, English, Chinese, German, "
         "French; "
         "letter case and accents make no difference",
         .unused = search_unused),
    WF_SPOKEN_ROW(lang),
    { 0 },
};
#undef OPTIONS

/* found: the name by which the table was found; NULL: without a search. */
static void list_one(const struct wf_species *sp, const char *found)
{
    wf_show(stdout, "%-18s %-8s %-28s %s", sp->key, strcmp(sp->preset, "corrected") ? "printed" : "",
            sp->name, sp->latin ? sp->latin : "");
    wf_show(stdout, found ? "; found by %s\n" : "\n", found);
}

static int nothing_found(const struct wf_species_library *l, const char *text, struct wf_arena *a)
{
    enum { NEAR_MAX = 6 };
    const struct wf_species *near[NEAR_MAX];
    size_t n = wf_species_near(l, text, a, near, NEAR_MAX);
    wf_show(stderr, "windfirm species: no table has '%s' in a name", text);
    for (size_t i = 0; i < n; i++) wf_show(stderr, "%s%s", i ? ", " : "; the nearest: ", near[i]->key);
    wf_show(stderr, "\n");
    return 2;
}

static int list_species(const char *search, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    struct wf_species_library l;
    size_t shown = 0;
    if (wf_species_library_read(wf_share(), &wf_laws, a, &l, &d, &e)) return wf_complain(&e);
    for (size_t i = 0; i < l.n; i++) wf_show_name(l.species[i].name, l.species[i].name_zh);
    for (size_t i = 0; i < l.n; i++) {
        const char *found = search ? wf_species_name_with(&l.species[i], search, a) : NULL;
        if (search && !found) continue;
        if (!shown++) wf_show(stdout, "%-18s %-8s %-28s %s\n", "name", "preset", "species", "latin");
        list_one(&l.species[i], found);
    }
    wf_print_findings(&d, false);
    if (search && !shown) return nothing_found(&l, search, a);
    return d.errors ? 2 : 0;
}

/* A key of the table, in other languages the name of the value; of: "crown." for the values of a crown. */
static const char *key_said(const char *of, const char *key, struct wf_arena *a)
{
    const char *whole = wf_arena_print(a, "%s%s", of, key);
    const struct wf_said said = { .message = "{1}", .n = 1, .arg = { whole } };
    const char *own = whole ? wf_show_words(&said, a) : NULL;
    return own && strcmp(own, whole) != 0 ? own : key;
}

/* of: "crown." for those of a crown; table: of the part, in which the value's key is. */
static void show_value(struct wf_units *u, const char *of, const char *table, const struct wf_property *p)
{
    const struct wf_value *v = p->value;
    char value[40], range[96] = "", low[40], high[40], key[96];
    if (!v->given) return;
    wf_quantity_print(u, v->value, p->dimension, p->unit, value, sizeof value);
    if (v->low < v->high) {
        wf_quantity_print(u, v->low, p->dimension, p->unit, low, sizeof low);
        low[strcspn(low, " ")] = '\0';
        wf_quantity_print(u, v->high, p->dimension, p->unit, high, sizeof high);
        high[strcspn(high, " ")] = '\0';
        snprintf(range, sizeof range, "%s..%s", low, high);
    }
    struct wf_arena a = { 0 };
    snprintf(key, sizeof key, "%s%s", table, p->key);
    wf_show(stdout, "  %-22s %-14s %-14s %-9s %s\n", key_said(of, key, &a), value, range,
            wf_standing_text(v->standing), v->source ? v->source : "");
    wf_arena_free(&a);
}

static void show_level(struct wf_units *u, const struct wf_level *l)
{
    struct wf_property p;
    for (size_t i = 0; wf_level_property(l, i, &p); i++) show_value(u, "", "", &p);
    for (size_t k = 0; k < l->wall.n; k++)
        wf_show(stdout, "  %-22s %.4g of the radius at %.4g of the length%s%s\n", k ? "" : "wall",
                l->wall.v[k], l->wall.s[k], k ? "" : ", ", k ? "" : wf_standing_text(l->wall_note.standing));
}

static void show_crown(struct wf_units *u, const struct wf_species *sp)
{
    struct wf_property p;
    const struct wf_law *law = wf_law_named(wf_laws.streamlining, sp->streamlining.law);
    for (size_t i = 0; wf_crown_property(sp, i, &p); i++) show_value(u, "crown.", "", &p);
    for (size_t i = 0; wf_law_property(law, &sp->streamlining, i, &p); i++)
        show_value(u, "crown.", "streamlining.", &p);
}

static int show_species(const char *name, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    struct wf_species sp;
    struct wf_units *u;
    enum wf_status s = wf_species_named(name, a, &sp, &d, &e);
    wf_print_findings(&d, false);
    if (s) return d.errors ? 2 : wf_complain(&e);
    if (wf_units_open(&u, &e)) return wf_complain(&e);
    wf_show_name(sp.name, sp.name_zh);
    wf_show(stdout, "%s, %s%s%s%s%s\nfile: %s; preset: %s\n", sp.key, sp.name, sp.name_zh ? " " : "",
            sp.name_zh ? sp.name_zh : "", sp.latin ? ", " : "", sp.latin ? sp.latin : "", sp.file, sp.preset);
    for (size_t i = 0; i < sp.aliases; i++)
        wf_show(stdout, i + 1 < sp.aliases ? "%s%s" : "%s%s\n", i ? ", " : "names: ", sp.alias[i]);
    if (sp.note) wf_show(stdout, "%s\n", sp.note);
    for (size_t i = 0; i < sp.levels; i++) {
        wf_show(stdout, "\nlevel %zu: %s\n", i, sp.level[i].name);
        show_level(u, &sp.level[i]);
    }
    wf_show(stdout, "\ncrown\n");
    show_crown(u, &sp);
    wf_units_close(u);
    return 0;
}

int wf_cmd_species(int argc, char **argv)
{
    static const char about[] = "  windfirm species list\n  windfirm species list --search linde\n"
                                "  windfirm species show moso_bamboo";
    static const char *const words[] = { "list", "show" };
    struct wf_arena arena = { 0 };
    struct species_options o;
    int code = wf_args_read(argc, argv, options, about, 1, 2, &arena, &o.args);
    if (code < 0) {
        const char *what = o.args.operand[0];
        if (strcmp(what, "list") == 0 && o.args.n == 1)
            code = list_species(o.search, &arena);
        else if (strcmp(what, "show") == 0 && o.args.n == 2)
            code = show_species(o.args.operand[1], &arena);
        else {
            wf_show(stderr, "windfirm species: '%s' is neither 'list' nor 'show NAME'%s\n", what,
                    wf_did_you_mean(what, words, WF_COUNT(words)).text);
            code = 2;
        }
    }
    wf_arena_free(&arena);
    return code;
}
