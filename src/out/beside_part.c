/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/beside_part.h"
#include "base/num.h"
#include "out/folder.h"
#include "study/brace.h"
#include "study/guy.h"
#include <math.h>
#include <string.h>

/* ---- What holds a tree ---- */

/* What holds a tree, with its forces. */
static json_t *hold_part(struct wf_doc *d, const struct wf_beside_hold *h)
{
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "name", h->kind);
    wf_doc_text(d, o, "from_point", h->from);
    wf_doc_text(d, o, "to_point", h->to);
    wf_doc_quantity(d, o, "pull", h->force, "N", "no equilibrium");
    wf_doc_quantity(d, o, "speed", h->speed, "m/s", "no equilibrium");
    if (isfinite(h->wind_from)) wf_doc_quantity(d, o, "from", h->wind_from, "rad", NULL);
    wf_doc_quantity(d, o, "pull_critical", h->critical, "N",
                    "no critical wind was found, or the time was used up");
    wf_doc_quantity(d, o, "breaking", h->breaking, "N", "not given");
    wf_doc_quantity(d, o, "safety", h->safety, "1",
                    "not assessed: no breaking load is given, or it does not pull");
    return o;
}

/* Those of a tree: its guys, or its braces. */
static json_t *holds_part(struct wf_doc *d, const struct wf_analysis *a, bool guys)
{
    json_t *list = wf_doc_array(d);
    struct wf_arena scratch = { 0 };
    struct wf_err unsaid = { WF_OK, "" };
    const struct wf_beside_hold *hold;
    size_t n, first = a->scenario.guys;
    if (wf_beside_holds(a, &scratch, &n, &hold, &unsaid)) d->failed = true, n = 0;
    for (size_t k = guys ? 0 : first; k < (guys && n ? first : n); k++) {
        json_t *o = wf_doc_add(d, list, hold_part(d, &hold[k]));
        const struct wf_guy *g = guys ? &a->scenario.guy[k] : NULL;
        const struct wf_brace *b = guys ? NULL : &a->scenario.brace[k - first];
        if (g) {
            wf_doc_quantity(d, o, "height", g->height, "m", NULL);
            wf_doc_quantity(d, o, "distance", g->distance, "m", NULL);
            wf_doc_quantity(d, o, "towards", g->towards, "rad", NULL);
        }
        wf_doc_quantity(d, o, "stiffness", g ? g->stiffness : b->stiffness, "N/m", NULL);
        wf_doc_quantity(d, o, "pretension", g ? g->pretension : b->pretension, "N", NULL);
        if (b) wf_doc_quantity(d, o, "slack", b->slack, "m", NULL);
    }
    wf_arena_free(&scratch);
    return list;
}

json_t *wf_part_guys(struct wf_doc *d, const struct wf_analysis *a) { return holds_part(d, a, true); }
json_t *wf_part_braces(struct wf_doc *d, const struct wf_analysis *a) { return holds_part(d, a, false); }

/* ---- A tree beside itself ---- */

json_t *wf_part_around(struct wf_doc *d, size_t n, const struct wf_assess_direction *x)
{
    json_t *list = wf_doc_array(d);
    for (size_t k = 0; k < n; k++) {
        json_t *at = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_quantity(d, at, "from", x[k].from, "rad", NULL);
        wf_doc_quantity(d, at, "breakage", x[k].breakage.safety, "1", "not assessed");
        wf_doc_quantity(d, at, "overturning", x[k].overturning.safety, "1", "not assessed");
    }
    return list;
}

/* Of a tree with something changed: keys of all versions. */
static void put_changed(struct wf_doc *d, json_t *o, const char *name, const struct wf_beside *x)
{
    wf_doc_text(d, o, "name", name);
    wf_doc_number(d, o, "cut", x->cut);
    wf_doc_flag(d, o, "flagged", x->cut > WF_ASSESS_CUT_FLAGGED);
    wf_doc_quantity(d, o, "drag", x->drag, "N", "no equilibrium");
    wf_doc_quantity(d, o, "weight", x->weight, "N", "no equilibrium");
    wf_doc_quantity(d, o, "base_moment", x->base_moment, "N m", "no equilibrium");
    wf_doc_quantity(d, o, "safety", x->safety, "1", "not assessed, or no equilibrium");
    wf_doc_quantity(d, o, "critical_speed", x->critical, "m/s", "not found");
    wf_doc_quantity(d, o, "searched_to", x->searched, "m/s", "");
}

static void put_assessed(struct wf_doc *d, json_t *o, const struct wf_beside *x)
{
    wf_doc_quantity(d, o, "breakage", x->breakage, "1", "not assessed");
    wf_doc_quantity(d, o, "overturning", x->overturning, "1", "not assessed");
    wf_doc_text(d, o, "word", wf_assess_rows[x->word].name);
    wf_doc_put(d, o, "directions", wf_part_around(d, x->directions, x->direction));
}

/* `stands`: the tree as it stands; NULL: not known. */
static json_t *changed_part(struct wf_doc *d, const struct wf_beside *x, const struct wf_beside *stands)
{
    json_t *o = wf_doc_object(d);
    put_changed(d, o, x->name ? x->name : "", x);
    wf_doc_quantity(d, o, "speed", x->speed, "m/s", NULL);
    wf_doc_quantity(d, o, "branch_safety", x->branches, "1", "no branch is listed, or no equilibrium");
    wf_doc_number(d, o, "branch_gusts", x->branch_gusts);
    wf_doc_number(d, o, "branch_damping", x->damping);
    wf_doc_flag(d, o, "gustier", stands && wf_beside_gustier(x, stands));
    if (x->assessed) put_assessed(d, o, x);
    json_t *holds = wf_doc_put(d, o, "holds", wf_doc_array(d));
    for (size_t i = 0; i < x->holds; i++) wf_doc_add(d, holds, hold_part(d, &x->hold[i]));
    return o;
}

json_t *wf_part_beside(struct wf_doc *d, size_t n, const struct wf_beside *list)
{
    json_t *out = wf_doc_array(d);
    const struct wf_beside *stands = n && !list[0].name ? &list[0] : NULL;
    for (size_t k = 0; k < n; k++) wf_doc_add(d, out, changed_part(d, &list[k], stands));
    return out;
}

json_t *wf_part_removals(struct wf_doc *d, const struct wf_besides *all)
{
    json_t *out = NULL;
    for (size_t k = 1; k < all->n; k++) {
        if (!all->item[k].removal) continue;
        const char *part = strchr(all->item[k].name, '=');
        if (!out) put_changed(d, wf_doc_add(d, out = wf_doc_array(d), wf_doc_object(d)), "", &all->item[0]);
        put_changed(d, wf_doc_add(d, out, wf_doc_object(d)), part ? part + 1 : "", &all->item[k]);
    }
    return out;
}

/* ---- Tables ---- */

static void text_cell(FILE *f, const char *text)
{
    fputs(",\"", f);
    for (const char *c = text; *c; c++) {
        if (*c == '"') putc('"', f);
        putc(*c, f);
    }
    putc('"', f);
}

static void cells(FILE *f, const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++) wf_folder_cell(f, x[k], 10);
}

static void lead(FILE *f, size_t tree, const char *species, double wind, const char *scenario)
{
    fprintf(f, "%zu", tree);
    text_cell(f, species ? species : "");
    wf_folder_cell(f, wind, 10);
    text_cell(f, scenario ? scenario : "");
}

size_t wf_besides_rows(FILE *f, size_t tree, const char *species, const struct wf_besides *all)
{
    for (size_t k = 0; k < all->n; k++) {
        const struct wf_beside *x = &all->item[k];
        const double value[] = { x->cut,      x->drag,     x->weight,   x->base_moment, x->safety,
                                 x->branches, x->critical, x->searched, x->breakage,    x->overturning };
        lead(f, tree, species, x->speed, x->name);
        cells(f, value, WF_COUNT(value));
        fprintf(f, ",%s\n", x->assessed ? wf_assess_rows[x->word].name : "");
    }
    return all->n;
}

static void hold_row(FILE *f, size_t tree, const char *species, const char *name,
                     const struct wf_beside_hold *h)
{
    const double value[] = { h->force, h->wind_from * (180 / WF_PI), h->critical, h->breaking, h->safety };
    lead(f, tree, species, h->speed, name);
    text_cell(f, h->kind), text_cell(f, h->from), text_cell(f, h->to);
    cells(f, value, WF_COUNT(value));
    putc('\n', f);
}

size_t wf_holds_rows(FILE *f, size_t tree, const char *species, const struct wf_besides *all)
{
    size_t rows = 0;
    for (size_t k = 0; k < all->n; k++)
        for (size_t i = 0; i < all->item[k].holds; i++, rows++)
            if (f) hold_row(f, tree, species, all->item[k].name, &all->item[k].hold[i]);
    return rows;
}
