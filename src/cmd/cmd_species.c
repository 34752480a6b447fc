/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/cmd.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/load.h"
#include <glob.h>
#include <stdio.h>
#include <string.h>

static int list_species(struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    glob_t found;
    const char *pattern = wf_arena_print(a, "%s/species/*.yaml", wf_share());
    if (!pattern || glob(pattern, 0, NULL, &found))
        return wf_complain(&(struct wf_err){ WF_EINPUT, "no species tables are installed" });
    printf("%-18s %-8s %-28s %s\n", "name", "preset", "species", "latin");
    for (size_t i = 0; i < found.gl_pathc; i++) {
        struct wf_species sp;
        if (wf_species_read(found.gl_pathv[i], &wf_laws, a, &sp, &d, NULL)) continue;
        printf("%-18s %-8s %-28s %s\n", sp.key, strcmp(sp.preset, "corrected") ? "printed" : "", sp.name,
               sp.latin ? sp.latin : "");
    }
    globfree(&found);
    wf_print_findings(&d, false);
    return d.errors ? 2 : 0;
}

/* What is shown of a level or crown: its key, where it is, its dimension and a unit to read it in. */
struct shown {
    const char *key;
    size_t at;
    enum wf_dimension dimension;
    const char *unit;
};
#define OF(type, field, dimension, unit)                                                                     \
    {                                                                                                        \
#field, offsetof(struct type, field), dimension, unit                                                \
    }

static const struct shown level_rows[] = {
    OF(wf_level, youngs_modulus, WF_DIM_PRESSURE, "GPa"),
    OF(wf_level, shear_modulus, WF_DIM_PRESSURE, "GPa"),
    OF(wf_level, density, WF_DIM_DENSITY, "kg/m3"),
    OF(wf_level, modulus_of_rupture, WF_DIM_PRESSURE, "MPa"),
    OF(wf_level, radius, WF_DIM_LENGTH, "mm"),
    OF(wf_level, damping_ratio, WF_DIM_NONE, ""),
    OF(wf_level, knot_factor, WF_DIM_NONE, ""),
    OF(wf_level, drag_coefficient, WF_DIM_NONE, ""),
    OF(wf_level, lift_coefficient, WF_DIM_NONE, ""),
};
static const struct shown crown_rows[] = {
    { "drag_coefficient", offsetof(struct wf_species, crown_drag), WF_DIM_NONE, "" },
    { "leaf_mass_per_area", offsetof(struct wf_species, leaf_mass_per_area), WF_DIM_MASS_PER_AREA, "kg/m2" },
    { "frontal_share", offsetof(struct wf_species, leaf_frontal_share), WF_DIM_NONE, "" },
};

static void show_values(struct wf_units *u, const char *base, const struct shown *row, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const struct wf_value *v = (const struct wf_value *)(const void *)(base + row[i].at);
        char value[40], range[96] = "", low[40];
        if (!v->given) continue;
        wf_quantity_print(u, v->value, row[i].dimension, row[i].unit, value, sizeof value);
        if (v->low < v->high) {
            wf_quantity_print(u, v->low, row[i].dimension, row[i].unit, low, sizeof low);
            low[strcspn(low, " ")] = '\0';
            char high[40];
            wf_quantity_print(u, v->high, row[i].dimension, row[i].unit, high, sizeof high);
            high[strcspn(high, " ")] = '\0';
            snprintf(range, sizeof range, "%s..%s", low, high);
        }
        printf("  %-22s %-14s %-14s %-9s %s\n", row[i].key, value, range, wf_standing_text(v->standing),
               v->source ? v->source : "");
    }
}

/* The sourced values of a crown's law. */
static void show_law(struct wf_units *u, const struct wf_law *law, const struct wf_law_use *use)
{
    for (size_t k = 0, n = wf_law_count(law); k < n; k++) {
        const struct wf_law_parameter *p = &law->parameter[k];
        char name[64];
        snprintf(name, sizeof name, "streamlining %s", p->name);
        const struct shown row = { name, 0, p->dimension, p->unit ? p->unit : "" };
        if (p->kind == WF_LAW_VALUE) show_values(u, (const char *)&use->parameter[k], &row, 1);
    }
}

static int show_species(const char *name, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    struct wf_species sp;
    struct wf_units *u;
    if (wf_species_read(wf_shipped("species", name, a), &wf_laws, a, &sp, &d, &e)) {
        wf_print_findings(&d, false);
        return d.errors ? 2 : wf_complain(&e);
    }
    if (wf_units_open(&u, &e)) return wf_complain(&e);
    printf("%s, %s%s%s%s%s\nfile: %s; preset: %s\n", sp.key, sp.name, sp.name_zh ? " " : "",
           sp.name_zh ? sp.name_zh : "", sp.latin ? ", " : "", sp.latin ? sp.latin : "", sp.file, sp.preset);
    if (sp.note) printf("%s\n", sp.note);
    for (size_t i = 0; i < sp.levels; i++) {
        printf("\nlevel %zu: %s\n", i, sp.level[i].name);
        show_values(u, (const char *)&sp.level[i], level_rows, sizeof level_rows / sizeof *level_rows);
        for (size_t k = 0; k < sp.level[i].wall.n; k++)
            printf("  %-22s %.4g of the radius at %.4g of the length%s%s\n", k ? "" : "wall",
                   sp.level[i].wall.v[k], sp.level[i].wall.s[k], k ? "" : ", ",
                   k ? "" : wf_standing_text(sp.level[i].wall_note.standing));
    }
    printf("\ncrown\n");
    show_values(u, (const char *)&sp, crown_rows, sizeof crown_rows / sizeof *crown_rows);
    show_law(u, wf_law_named(wf_laws.streamlining, sp.streamlining.law), &sp.streamlining);
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
        const char *what = args.operand[0], *near = wf_nearest(what, words, 2);
        if (strcmp(what, "list") == 0 && args.n == 1)
            code = list_species(&arena);
        else if (strcmp(what, "show") == 0 && args.n == 2)
            code = show_species(args.operand[1], &arena);
        else {
            fprintf(stderr, "windfirm species: '%s' is neither 'list' nor 'show NAME'%s%s%s\n", what,
                    near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
            code = 2;
        }
    }
    wf_arena_free(&arena);
    return code;
}
