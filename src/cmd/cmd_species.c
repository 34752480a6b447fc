/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/load.h"
#include <stdio.h>
#include <string.h>

static int list_species(struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    const char **names, *path;
    size_t n = wf_shipped_names(wf_share(), "species", a, &names);
    if (!n) return wf_complain(&(struct wf_err){ WF_EINPUT, "no species tables are installed" });
    wf_show(stdout, "%-18s %-8s %-28s %s\n", "name", "preset", "species", "latin");
    for (size_t i = 0; i < n; i++) {
        struct wf_species sp;
        if (wf_shipped_path(wf_share(), "species", names[i], a, &path, NULL)) continue;
        if (wf_species_read(path, &wf_laws, a, &sp, &d, NULL)) continue;
        wf_show(stdout, "%-18s %-8s %-28s %s\n", sp.key, strcmp(sp.preset, "corrected") ? "printed" : "",
                sp.name, sp.latin ? sp.latin : "");
    }
    wf_print_findings(&d, false);
    return d.errors ? 2 : 0;
}

/* table: of the part, in which the value's key is. */
static void show_value(struct wf_units *u, const char *table, const struct wf_property *p)
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
    snprintf(key, sizeof key, "%s%s", table, p->key);
    wf_show(stdout, "  %-22s %-14s %-14s %-9s %s\n", key, value, range, wf_standing_text(v->standing),
            v->source ? v->source : "");
}

static void show_level(struct wf_units *u, const struct wf_level *l)
{
    struct wf_property p;
    for (size_t i = 0; wf_level_property(l, i, &p); i++) show_value(u, "", &p);
    for (size_t k = 0; k < l->wall.n; k++)
        wf_show(stdout, "  %-22s %.4g of the radius at %.4g of the length%s%s\n", k ? "" : "wall",
                l->wall.v[k], l->wall.s[k], k ? "" : ", ", k ? "" : wf_standing_text(l->wall_note.standing));
}

static void show_crown(struct wf_units *u, const struct wf_species *sp)
{
    struct wf_property p;
    const struct wf_law *law = wf_law_named(wf_laws.streamlining, sp->streamlining.law);
    for (size_t i = 0; wf_crown_property(sp, i, &p); i++) show_value(u, "", &p);
    for (size_t i = 0; wf_law_property(law, &sp->streamlining, i, &p); i++)
        show_value(u, "streamlining.", &p);
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
    wf_show(stdout, "%s, %s%s%s%s%s\nfile: %s; preset: %s\n", sp.key, sp.name, sp.name_zh ? " " : "",
            sp.name_zh ? sp.name_zh : "", sp.latin ? ", " : "", sp.latin ? sp.latin : "", sp.file, sp.preset);
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
    static const char about[] = "  windfirm species list\n  windfirm species show moso_bamboo";
    static const char *const words[] = { "list", "show" };
    static const struct wf_option none[] = { { 0 } };
    struct wf_arena arena = { 0 };
    struct wf_args args;
    int code = wf_args_read(argc, argv, none, about, 1, 2, &arena, &args);
    if (code < 0) {
        const char *what = args.operand[0];
        if (strcmp(what, "list") == 0 && args.n == 1)
            code = list_species(&arena);
        else if (strcmp(what, "show") == 0 && args.n == 2)
            code = show_species(args.operand[1], &arena);
        else {
            wf_show(stderr, "windfirm species: '%s' is neither 'list' nor 'show NAME'%s\n", what,
                    wf_did_you_mean(what, words, WF_COUNT(words)).text);
            code = 2;
        }
    }
    wf_arena_free(&arena);
    return code;
}
