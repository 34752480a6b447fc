/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/rest.h"
#include "base/num.h"
#include "data/model.h"
#include "data/section.h"
#include "data/species.h"
#include "grow/grow.h"
#include "grow/silhouette.h"
#include "solve/firm.h"
#include "solve/unload.h"
#include "study/brace.h"
#include "study/guy.h"
#include "study/reduction.h"
#include "study/removal.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LISTED = 8 };

/* A list in words, of at most LISTED entries. */
struct listing {
    char text[LISTED * 120];
    size_t n;
};

__attribute__((format(printf, 2, 3))) static void list(struct listing *l, const char *form, ...)
{
    size_t used = strlen(l->text);
    va_list arg;
    if (l->n++ >= LISTED) return;
    if (used) used += (size_t)snprintf(l->text + used, sizeof l->text - used, "; ");
    va_start(arg, form);
    (void)vsnprintf(l->text + used, sizeof l->text - used, form, arg);
    va_end(arg);
}

/* Replace a shape drawn or measured under the tree's own weight by its stress-free shape. */
static enum wf_status unload(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e)
{
    struct wf_loads weight = an->loads;
    struct wf_tree free;
    double left, moved;
    weight.wind = NULL, weight.ties = weight.links = 0;
    enum wf_status s = wf_unload(&an->tree, &weight, o, a, &free, &left, &moved, e);
    if (s) return s;
    an->tree = free;
    wf_diag_warn(
        d, "unloaded",
        "%s, %s: taken as standing under its own weight. Its stress-free shape is up to %.3g m away; under "
        "its weight it returns to the shape given within %.2g m. Deflections count from the stress-free "
        "shape",
        an->model->name, an->species->name, moved, left);
    return WF_OK;
}

/* The tree stands with what it carried on the day of the shape. */
static enum wf_status stand(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_model then = *an->model;
    enum wf_season season = then.scanned == WF_SCANNED_LEAF_OFF  ? WF_LEAF_OFF
                            : then.scanned == WF_SCANNED_LEAF_ON ? WF_LEAF_ON
                                                                 : then.season;
    if (then.generator == WF_GENERATOR_MEASURED && then.scanned == WF_SCANNED_AS_SEASON &&
        (then.leaf_area_on > 0 || !isnan(wf_silhouette_area(&then.silhouette))))
        wf_diag_warn(
            d, "scan-season",
            "%s: taken as scanned %s; --scanned says on which day it was: leaves that came or fell since "
            "then move the tree",
            then.name, season == WF_LEAF_ON ? "with its leaves" : "without leaves");
    if (season == then.season) return wf_tree_stand(&an->tree, &an->tree, a, e);
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_tree worn;
    wf_model_set_season(&then, season);
    struct wf_analysis same = *an; /* to have the same rows */
    enum wf_status s = wf_grow(&then, an->species, &scratch, &worn, &unsaid, e);
    same.tree = worn, same.misread = NULL;
    if (!s) s = wf_removal_onto(&same, &scratch, e);
    if (!s) s = wf_reduction_onto(&same, &scratch, e);
    if (!s) s = wf_guys_onto(&same, &scratch, e);
    if (!s) s = wf_braces_onto(&same, &scratch, e);
    if (!s) s = wf_tree_stand(&an->tree, &same.tree, a, e);
    wf_arena_free(&scratch);
    return s;
}

void wf_rest_warn_of_parts(const char *who, const struct wf_tree *t, const struct wf_firm *f,
                           struct wf_diag *d)
{
    struct listing l = { .text = "" };
    for (size_t i = 0; i < f->n; i++) {
        const struct wf_firm_part *p = &f->part[i];
        list(&l,
             "segment %lld and above (%.3g kg, %.2g m up): carries %.2g of its own weight, E and G x %.3g",
             (long long)t->id[p->row], p->mass, t->z0[p->row] - t->z0[0], p->factor, p->raise);
    }
    wf_diag_warn(d, "stiffened",
                 "%s: %zu part%s under %g %% of the tree's mass would not stand in the shape drawn with this "
                 "wood, alone or with what carries it, and %s stiffened to carry %g times %s own weight (a "
                 "rule): %s%s",
                 who, f->n, f->n == 1 ? "" : "s", 100 * WF_REST_SMALL, f->n == 1 ? "was" : "were",
                 WF_REST_FIRM, f->n == 1 ? "its" : "their", l.text, f->n > LISTED ? "; ..." : "");
}

/* The cavities of a tree in words, which may be why it does not stand; "" where there are none. */
static const char *hollowed(const struct wf_tree *t, char *text, size_t size)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < t->n; i++)
        if (t->section && t->section->hollow && t->section->hollow[i])
            low = fmin(low, t->z0[i] - t->z0[0]), high = fmax(high, t->z1[i] - t->z0[0]);
    if (high > low)
        (void)snprintf(text, size, " or cavity (between %.3g and %.3g m)", low, high);
    else
        *text = '\0';
    return text;
}

enum wf_status wf_rest_refuse(const char *who, const char *else_say, const struct wf_tree *t,
                              const struct wf_firm *f, struct wf_err *e)
{
    char cavity[64];
    (void)hollowed(t, cavity, sizeof cavity);
    if (f->refused < 0)
        return wf_fail(e, WF_EUNSTABLE, "%s: does not stand with this wood or root%s%s", who, cavity,
                       f->root ? ": the root plate is too soft for its weight" : "");
    return wf_fail(
        e, WF_EUNSTABLE,
        "%s: does not stand with this wood or root%s: from segment %lld (%s, %.3g m up) on, the part "
        "drawn would fall over under its own weight. Check the units of the radii, the wood%s and the "
        "leaf area; %s",
        who, cavity, (long long)t->id[f->refused], t->level[f->refused] ? "branch" : "stem",
        t->z0[f->refused] - t->z0[0], *cavity ? ", the wall that is left" : "", else_say);
}

/* Stiffen what would not stand. */
static enum wf_status make_firm(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_firm f;
    const char *who = wf_arena_print(a, "%s, %s", an->model->name, an->species->name);
    if (!who) return wf_fail(e, WF_ENOMEM, "not enough memory for the state at rest");
    enum wf_status s = wf_firm(&an->tree, &an->loads, o, WF_REST_SMALL, WF_REST_FIRM, a, &f, e);
    if (s) return s;
    if (f.gave_up)
        return wf_rest_refuse(who, "--rest stress-free takes the shape as free of stress", &an->tree, &f, e);
    if (f.n) wf_rest_warn_of_parts(who, &an->tree, &f, d);
    if (f.n && an->model->stands_strictly)
        return wf_fail(
            e, WF_EUNSTABLE,
            "%s, %s: %zu part%s would not stand in the shape drawn; nothing was computed (--strict)",
            an->model->name, an->species->name, f.n, f.n == 1 ? "" : "s");
    return WF_OK;
}

struct used {
    double share; /* of the strength, by weight alone */
    size_t row;
};

static int by_share(const void *a, const void *b)
{
    double x = ((const struct used *)a)->share, y = ((const struct used *)b)->share;
    return (x < y) - (x > y);
}

/* Rows whose weight alone uses more of the strength than is credible, the worst first. */
static size_t find_doubtful(const struct wf_tree *t, const struct wf_breakage *b, struct used *out)
{
    size_t n = 0;
    for (size_t i = 0; i < t->n; i++) {
        if (!(t->strength[i] > 0.0)) continue;
        double share = b->peak[i] / t->strength[i];
        if (share > WF_REST_CREDIBLE) out[n++] = (struct used){ share, i };
    }
    qsort(out, n, sizeof *out, by_share);
    return n;
}

/* Does the stem's row carry so much that its own weight cannot be doubted away? */
static bool holds_the_tree(const struct wf_tree *t, const struct wf_response *r, size_t i)
{
    return t->level[i] == 0 && fabs(r->force0[3 * i + 2]) >= WF_REST_SMALL * fabs(r->base_force[2]);
}

static enum wf_status doubt(struct wf_analysis *an, const struct wf_response *r, const struct wf_breakage *b,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_tree *t = &an->tree;
    struct listing l = { .text = "" };
    struct used *found = WF_TAKE(a, t->n, struct used);
    bool *doubtful = WF_TAKE(a, t->n, bool);
    size_t kept = 0;
    if (!found || !doubtful) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    size_t n = find_doubtful(t, b, found);
    for (size_t k = 0; k < n; k++) {
        size_t i = found[k].row;
        bool keep = holds_the_tree(t, r, i);
        kept += keep;
        doubtful[i] = !keep;
        list(&l, "segment %lld (%s, %.2g m up): %.0f %%", (long long)t->id[i],
             t->level[i] ? "branch" : "stem", t->z0[i] - t->z0[0], 100 * found[k].share);
    }
    if (!n) return WF_OK;
    if (n > kept) t->doubtful = doubtful;
    wf_diag_warn(
        d, "not-credible",
        "%s, %s: not credible as drawn: in %zu segment%s the tree's own weight alone uses more than %g %% "
        "of the strength of the wood: %s%s. The radius, the wood or the leaf area is in doubt there. %s%s",
        an->model->name, an->species->name, n, n == 1 ? "" : "s", 100 * WF_REST_CREDIBLE, l.text,
        n > LISTED ? "; ..." : "",
        n == 1 && kept ? "It decides like all others, because the stem carries the tree"
        : n == 1 ? "It stays in the tables, but no safety factor and no critical wind speed is taken from it"
        : n > kept ? "They stay in the tables, but no safety factor and no critical wind speed is theirs"
                   : "They decide like all others, because the stem carries the tree",
        kept && n > kept ? "; those of the stem that carry the tree decide all the same" : "");
    return WF_OK;
}

/* The state at rest, in `a`. */
static enum wf_status find_still(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                                 struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_loads weight = an->loads;
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_tree then = an->tree;
    struct wf_still *still = WF_TAKE(a, 1, struct wf_still);
    if (!still) return wf_fail(e, WF_ENOMEM, "not enough memory for the state at rest");
    weight.wind = NULL, weight.ties = weight.links = 0;
    if (then.standing) /* with what it carried on that day */
        then.burden0 = then.standing->burden0, then.burden1 = then.standing->burden1;
    enum wf_status s = an->solver->solve(&then, &weight, o, a, &still->response, &unsaid, e);
    if (!s) s = wf_breakage_check(&then, &still->response, NULL, a, &still->breakage, e);
    if (!s) an->still = still;
    wf_arena_free(&scratch);
    return s;
}

/* A tree whose shape, or its unloaded shape, is free of stress: the state at rest is needed where the weight
 * is taken off the stresses. */
static enum wf_status still_of_free(struct wf_analysis *an, const struct wf_solve_options *o,
                                    struct wf_arena *a, struct wf_err *e)
{
    return an->scenario.weight_unstressed ? find_still(an, o, a, e) : WF_OK;
}

static enum wf_status set_up_shape(struct wf_analysis *an, const struct wf_solve_options *o,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    enum wf_standing_shape shape = an->model->shape;
    if (shape == WF_SHAPE_STRESS_FREE || !(an->loads.gravity > 0.0)) return WF_OK;
    if (shape == WF_SHAPE_UNLOADED) return unload(an, o, a, d, e);
    if (!an->solver->stands && an->solver->as_printed) {
        wf_diag_warn(d, "not-at-rest", "%s: the solver '%s' takes the shape drawn as free of stress",
                     an->model->name, an->solver->name);
        return WF_OK;
    }
    if (!an->solver->stands) return unload(an, o, a, d, e);
    enum wf_status s = stand(an, a, d, e);
    if (!s) s = make_firm(an, o, a, d, e);
    if (an->misread) an->tree.doubtful = an->misread->doubtful;
    if (!s && (!an->misread || an->scenario.weight_unstressed)) s = find_still(an, o, a, e);
    return s || an->misread ? s : doubt(an, &an->still->response, &an->still->breakage, a, d, e);
}

/* What the weight above each root adds to the moment on it per angle that the tree turns about it, the most
 * [N m/rad]; NAN: not enough memory. */
static double weight_stiffness(const struct wf_analysis *an, struct wf_arena *scratch)
{
    const struct wf_tree *t = &an->tree;
    size_t *root = WF_TAKE(scratch, t->n, size_t);
    double *sum = WF_TAKE(scratch, t->n, double), most = 0.0;
    if (!root || !sum) return NAN;
    for (size_t i = 0; i < t->n; i++) {
        double along = wf_line_point_of(t, i, 0.5).mass * wf_tree_length(t, i);
        root[i] = t->parent[i] < 0 ? i : root[t->parent[i]];
        const double ground = t->z0[root[i]];
        sum[root[i]] += along * (0.5 * (t->z0[i] + t->z1[i]) - ground);
        if (t->mass1) sum[root[i]] += t->mass1[i] * (t->z1[i] - ground);
        most = fmax(most, sum[root[i]]);
    }
    return most * an->loads.gravity * an->loads.weight_scale;
}

/* A tree on a spring softer than that finds its equilibrium where it lies or hangs, with small stresses. */
static enum wf_status check_root(const struct wf_analysis *an, const struct wf_solve_options *o,
                                 struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    double softest = fmin(o->root_stiffness[0], o->root_stiffness[1]), needed;
    if (!(softest > 0.0) || an->loads.ties) return WF_OK; /* guys may hold it */
    needed = weight_stiffness(an, &scratch);
    wf_arena_free(&scratch);
    if (isnan(needed)) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", an->tree.n);
    if (softest > needed) return WF_OK;
    return wf_fail(
        e, WF_EINPUT,
        "%s: roots of %.3g kN m/rad do not hold the tree upright: its own weight needs more than %.3g kN "
        "m/rad. Check the unit: a plain number is in N m/rad",
        an->model->name, 1e-3 * softest, 1e-3 * needed);
}

enum wf_status wf_rest_set_up(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e)
{
    struct wf_solve_options own;
    if (!o) wf_solve_options_default(&own), o = &own;
    an->still = NULL;
    enum wf_status s = check_root(an, o, e);
    if (!s) s = set_up_shape(an, o, a, d, e);
    if (!s && !an->still) s = still_of_free(an, o, a, e);
    if (!s && an->scenario.weight_unstressed)
        wf_diag_warn(d, "weight-not-counted",
                     "%s, %s: self weight not counted: unsafe for leaning trees and limbs. Stresses, safety "
                     "and critical winds are those of the change from the state at rest, as strain gauges "
                     "show it that were set to zero in place",
                     an->model->name, an->species->name);
    return s;
}
