/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/analysis.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "data/model.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "grow/grow.h"
#include "grow/silhouette.h"
#include "load/interception.h"
#include "load/winter.h"
#include "solve/beam.h"
#include "study/brace.h"
#include "study/guy.h"
#include "study/node.h"
#include "study/reduction.h"
#include "study/removal.h"
#include "study/rest.h"
#include "study/sway.h"
#include "study/unions.h"
#include "study/verdict.h"
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* ---- Set up ---- */

/* The crown as seen from above, on which snow lies [m2]. */
static double snowed_on(const struct wf_analysis *an)
{
    double width = wf_silhouette_size(an->model, wf_tree_height(&an->tree)).breadth;
    return wf_crown_projection(&an->tree, isnan(width) ? 0 : width);
}

/* Can snow lie on it? Asked before the tree's state at rest is computed. */
static enum wf_status check_snow(const struct wf_analysis *an, struct wf_err *e)
{
    if (!(an->scenario.snow > 0)) return WF_OK;
    if (an->model->season == WF_LEAF_OFF || wf_crown_projection(&an->tree, 1) == 0)
        return wf_fail(e, WF_EINPUT,
                       "%s: snow lies on a crown in leaf; the tree has no leaves. Ice can be on bare axes",
                       an->model->name);
    if (snowed_on(an) > 0) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: how much snow lies on the crown follows from its width, which is not known; "
                   "give --crown-width with --crown-depth",
                   an->model->name);
}

/* Snow and ice, which came after the tree was drawn. */
static void winter(struct wf_analysis *an, struct wf_diag *d)
{
    static const char *const together =
        "The given winds act together with it; a wind in which it stays on the tree is less than a design "
        "wind (snow falls off above about 9 m/s)";
    double area = snowed_on(an), mass = area * an->scenario.snow;
    if (an->scenario.snow > 0) {
        wf_snow_onto(&an->tree, mass);
        wf_diag_warn(d, "snow", "%s: %.4g kg of snow, %.3g kg/m2 on the crown's %.4g m2 seen from above. %s",
                     an->model->name, mass, an->scenario.snow, area, together);
    }
    if (!(an->scenario.ice > 0)) return;
    mass = wf_ice_onto(&an->tree, an->scenario.ice);
    wf_diag_warn(
        d, "ice",
        "%s: %.4g kg of ice, %.3g mm thick on all axes and both sides of the leaves (917 kg/m3); the "
        "wind finds the axes by twice that thicker, the leaves as they are. %s",
        an->model->name, mass, 1e3 * an->scenario.ice, together);
    if (!wf_tree_branched(&an->tree) && wf_crown_projection(&an->tree, 1) > 0)
        wf_diag_warn(
            d, "ice-undrawn",
            "%s: the crown's branches are not drawn, so no ice is on them%s: the mass of ice, the wind's "
            "load and the sway's period are too low. A tree with branches gives them",
            an->model->name,
            wf_tree_leaf_area(&an->tree) > 0 ? "" : ", nor on leaves, whose area is not known");
}

/* Rain on the leaves. A crown in leaf that is given by its outline or width has as many as its frontal area
 * takes by the species' share. */
static void rain(struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_crown *c = &an->species->crown;
    double film = an->scenario.water;
    if (!(film > 0)) return;
    bool unknown = !(wf_tree_leaf_area(&an->tree) > 0) && an->model->season == WF_LEAF_ON;
    if (unknown && c->frontal_share.value > 0) {
        double area = wf_leaves_of_sail(&an->tree, c->drag_coefficient.value, c->frontal_share.value);
        if (area > 0)
            wf_diag_warn(
                d, "rain-leaf-area",
                "%s: leaf area is not given; rain is put on %.4g m2 of leaves, the crown's frontal area over "
                "the species' frontal share of %.3g (%.3g to %.3g)",
                an->model->name, area, c->frontal_share.value, c->frontal_share.low, c->frontal_share.high);
    }
    wf_intercept(&an->tree, film);
}

static enum wf_status anchor(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    struct wf_anchorage *found = WF_TAKE(a, 1, struct wf_anchorage);
    if (!found) return wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
    enum wf_status s = wf_anchorage_find(an->scenario.anchorage, &an->tree, an->species, a, found, e);
    an->anchorage = found;
    return s;
}

void wf_analysis_turned(struct wf_analysis *an)
{
    const struct wf_scenario *s = &an->scenario;
    double towards = isnan(s->corridor_towards) ? s->azimuth : s->corridor_towards;
    an->tree.room = (struct wf_room){ s->corridor, { cos(towards), sin(towards) }, s->tip_angle };
    if (an->anchorage) an->tree.anchorage = an->anchorage->moment;
    if (an->anchorage && s->anchorage) an->tree.anchorage *= wf_anchorage_left(s->anchorage, s->azimuth);
}

/* The diaphragms of a culm, where they are specified. */
static enum wf_status diaphragms(struct wf_analysis *an, struct wf_err *e)
{
    an->tree.node_spacing = an->scenario.node_spacing;
    if (!(an->tree.node_spacing > 0) || an->species->level[0].wall.n) return WF_OK;
    return wf_fail(
        e, WF_EUSAGE,
        "--node-spacing %.4g m: diaphragms are of culms; the stem of %s is solid, or hollow by decay",
        an->tree.node_spacing, an->species->name);
}

enum wf_status wf_analysis_draw(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d,
                                struct wf_err *e)
{
    enum wf_status s = wf_grow(an->model, an->species, a, &an->tree, d, e);
    if (s || (s = wf_tree_check(&an->tree, d, e)) || (s = wf_removal_onto(an, a, e)) ||
        (s = wf_reduction_onto(an, a, e)))
        return s;
    if (an->misread) wf_tree_scale(&an->tree, an->misread->height, an->misread->radius);
    an->tallness = wf_tree_height(&an->tree);
    s = wf_scenario_loads(&an->scenario, an->species, &an->wind, &an->loads, e);
    if (!s) s = wf_guys_onto(an, a, e);
    if (!s) s = wf_braces_onto(an, a, e);
    if (!s) s = anchor(an, a, e);
    if (!s) s = diaphragms(an, e);
    return s ? s : check_snow(an, e);
}

enum wf_status wf_analysis_set_up(struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s = wf_analysis_draw(an, a, d, e);
    if (s) return s;
    wf_analysis_turned(an);
    an->branch_strength = wf_branches_limit(an->scenario.branch_strength, an->species, &an->tree);
    s = wf_rest_set_up(an, o, a, d, e);
    if (!s) rain(an, d); /* it was drawn dry */
    if (!s) winter(an, d);
    return s;
}

/* Memory of an analysis beside one solution, for a row of the tree. Measured with 20 000 rows, one wind
 * speed and one thread: 15.6 kB a row in all when the searches are not ended by their time. */
enum { ROW_BYTES = 11000 };

/* Memory that this process can have [bytes]: the machine's, or what a limit of the shell leaves; INFINITY:
 * unknown. */
static double memory_there(void)
{
    double pages = (double)sysconf(_SC_PHYS_PAGES), page = (double)sysconf(_SC_PAGESIZE);
    double there = pages > 0 && page > 0 ? pages * page : INFINITY;
    struct rlimit r;
    if (!getrlimit(RLIMIT_AS, &r) && r.rlim_cur != RLIM_INFINITY) there = fmin(there, (double)r.rlim_cur);
    if (!getrlimit(RLIMIT_DATA, &r) && r.rlim_cur != RLIM_INFINITY) there = fmin(there, (double)r.rlim_cur);
    return there;
}

/* Refuse a tree for which there is not enough memory, instead of being killed by the system hours later. */
static enum wf_status check_memory(const struct wf_analysis *an, size_t speeds, struct wf_err *e)
{
    double there = memory_there();
    double needed = (double)an->tree.n * (WF_SOLUTION_BYTES + ROW_BYTES + 400.0 * (double)speeds);
    if (needed <= 0.75 * there) return WF_OK;
    return wf_fail(e, WF_ENOMEM,
                   "%zu segments at %zu wind speed%s need about %.2g GB of memory; there are %.2g GB, of "
                   "which it may take three quarters. Take fewer segments or wind speeds",
                   an->tree.n, speeds, speeds == 1 ? "" : "s", 1e-9 * needed, 1e-9 * there);
}

bool wf_analysis_grown(const struct wf_analysis *an, size_t level)
{
    for (size_t i = 0; i < an->tree.n; i++)
        if (wf_model_wood(an->model, an->species, &an->tree, i) == &an->species->level[level]) return true;
    return false;
}

/* ---- The whole analysis ---- */

static enum wf_status check_call(const struct wf_scenario *sc, const struct wf_search *q,
                                 const struct wf_solver *solver, const struct wf_solve_options *o,
                                 const double *speeds, size_t n, struct wf_err *e)
{
    if (n == 0) return wf_fail(e, WF_EUSAGE, "no wind speed is given");
    if (solver->clamped && (o->root_stiffness[0] > 0.0 || o->root_stiffness[1] > 0.0))
        return wf_fail(e, WF_EUSAGE,
                       "root stiffness has no effect with the solver '%s', which clamps the base",
                       solver->name);
    if (sc->guys && !solver->ties)
        return wf_fail(e, WF_EUSAGE, "guys have no effect with the solver '%s'", solver->name);
    if (sc->braces && !solver->ties)
        return wf_fail(e, WF_EUSAGE, "cables and rods have no effect with the solver '%s'", solver->name);
    for (size_t k = 0; k < n; k++)
        if (!(speeds[k] >= 0.0 && speeds[k] <= 200.0))
            return wf_fail(e, WF_EUSAGE, "wind speed %.6g m/s is outside 0..200 m/s", speeds[k]);
    enum wf_status s = wf_scenario_check(sc, e);
    if (!s && !(q->speed_max >= 1.0 && q->speed_max <= 200.0))
        s = wf_fail(e, WF_EUSAGE, "highest speed searched %.6g m/s is outside 1..200", q->speed_max);
    if (!s && !(q->beyond >= 0.0 && q->beyond <= 2.0))
        s = wf_fail(e, WF_EUSAGE, "search beyond the highest wind: %.6g times it is outside 0..2", q->beyond);
    if (!s && !(q->seconds > 0.0)) s = wf_fail(e, WF_EUSAGE, "the time of the search must be above 0 s");
    return s;
}

enum { CURVE_SOLUTIONS = 12 }; /* that the curves take in most trees, beside those of the searches */

/* An interrupt: the speeds that were solved stay and make the curves; the critical speeds only where all were
 * found. */
static enum wf_status keep_finished(struct wf_analysis *an, size_t speeds, bool searched, struct wf_arena *a,
                                    struct wf_diag *d, struct wf_err *e)
{
    wf_diag_warn(d, "interrupted", "interrupted: %zu of %zu wind speeds%s", speeds, an->n,
                 searched ? "; curves at these alone" : ", no critical wind speed");
    an->n = an->sweep_n = speeds;
    if (!(an->sweep = WF_TAKE(a, speeds, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu speeds", speeds);
    for (size_t k = 0; k < speeds; k++) an->sweep[k] = an->at[k];
    for (int c = 0; c < WF_CRITERIA && !searched; c++)
        for (int scope = 0; scope < WF_SCOPES; scope++) {
            struct wf_break *b = &an->breaks[c][scope];
            *b = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
            b->critical = (struct wf_critical){ .outcome = WF_CRITICAL_INTERRUPTED,
                                                .speed = NAN,
                                                .speed_high = an->search.speed_max,
                                                .gradient = NAN };
        }
    return WF_OK;
}

/* The lowest modes in still air, for the reader. NULL: the peak load does not need the sway, the tree has no
 * state, it is so large that they would take long, or they are so many twigs' that they hardly differ. */
static const struct wf_sway_modes *lowest_modes(const struct wf_analysis *an,
                                                const struct wf_solve_options *o, struct wf_arena *a)
{
    enum { LOWEST = 4, LARGE = 20000, VECTORS = 64, MANY = 200 };
    struct wf_err unsaid = { WF_OK, "" };
    struct wf_sway_modes *out = WF_TAKE(a, 1, struct wf_sway_modes);
    if (!out || !an->peak->method->sways || !an->peak->sways || an->tree.n > LARGE) return NULL;
    struct wf_solve_options shown = *o;
    /* nothing is computed from them: frequencies err by less than this tolerance, with many rows already on
     * the first mesh */
    if (o->mesh_tolerance > 0.0)
        shown.mesh_tolerance = an->tree.n < MANY ? fmax(o->mesh_tolerance, 1e-3) : 0.0;
    return wf_sway_modes(an, &shown, 0.0, VECTORS, LOWEST, a, out, &unsaid) ? NULL : out;
}

/* Forces of what holds the tree in the wind in which it is lost; branches are solved in their own state too,
 * on the mesh of the search. Given: an analysis with its critical winds and the nodes of their search.
 * Returned: an->held; not known where the time of the search is used up. */
static enum wf_status find_held(struct wf_analysis *an, const struct wf_solve_options *o,
                                struct wf_nodes *nodes, struct wf_err *e)
{
    const struct wf_solve_options quick = wf_nodes_quick(o);
    const struct wf_node *node;
    struct wf_at_speed at;
    struct wf_err why = { WF_OK, "" };
    for (size_t k = 0; k < WF_TIES_MAX; k++) an->held.tie[k] = NAN;
    for (size_t k = 0; k < WF_LINKS_MAX; k++) an->held.link[k] = NAN;
    if (!an->loads.ties && !an->loads.links) return WF_OK;
    const struct wf_break *loss = wf_verdict_of((const struct wf_break(*)[WF_SCOPES])an->breaks).loss;
    if (!loss || loss->critical.outcome != WF_CRITICAL_FOUND) return WF_OK;
    const double speed = loss->critical.speed;
    enum wf_status s;
    if (!wf_nodes_tracked(an))
        s = wf_speed_totals(an, o, speed, &at, &why);
    else if (!(s = wf_nodes_solve(nodes, &quick, speed, &node, &why)))
        at = node->at;
    if (s && wf_nodes_late(nodes)) return WF_OK;
    if (s) return wf_fail(e, s, "%s", why.text);
    for (size_t k = 0; k < an->loads.ties && !at.status; k++) an->held.tie[k] = at.tie[k];
    for (size_t k = 0; k < an->loads.links && !at.status; k++) an->held.link[k] = at.link[k];
    return WF_OK;
}

/* The given speeds as nodes, then the lowest critical one. */
static enum wf_status analyze_bare(struct wf_analysis *an, const struct wf_solve_options *o,
                                   const double *speeds, struct wf_err *e)
{
    struct wf_nodes *nodes = wf_nodes_open(an, NULL);
    if (!nodes) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    const struct wf_node *node;
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < an->n && !s; k++) {
        if ((s = wf_nodes_solve(nodes, o, speeds[k], &node, e))) continue;
        an->at[k] = node->at;
        if (!node->at.status) an->branch_safety = wf_node_branch_safety(an, node);
    }
    if (!s) s = wf_analysis_breaks(an, o, nodes, an->breaks, e);
    if (!s) s = find_held(an, o, nodes, e);
    wf_nodes_close(nodes);
    return s;
}

/* The list of unions, where it is specified. */
static enum wf_status list_unions(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    if (!an->search.unions) return WF_OK;
    struct wf_unions *u = WF_TAKE(a, 1, struct wf_unions);
    an->unions = u;
    return u ? wf_unions_list(&an->tree, an->search.branches_from, a, u, e)
             : wf_fail(e, WF_ENOMEM, "no memory for unions");
}

/* The given speeds, the critical ones, the curves. */
static enum wf_status solve_winds(struct wf_analysis *out, const struct wf_solve_options *o,
                                  const double *speeds, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    const size_t n = out->n;
    enum wf_status s = WF_OK;
    if (!wf_nodes_tracked(out)) wf_sway_reach(out, INFINITY);
    if (!out->search.bare) out->modes = lowest_modes(out, o, a);
    if (!(out->at = WF_TAKE(a, n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu speeds", n);
    if (out->search.bare) {
        s = analyze_bare(out, o, speeds, e);
        if (!s) wf_limits_check(out, d);
        if (!s) wf_limits_root(out, o->root_stiffness, d);
        return s;
    }
    struct wf_err why = { 0 };
    struct wf_nodes *nodes = NULL;
    struct wf_given *given = wf_given_open(a);
    size_t k = 0;
    bool searched = false;
    wf_stage_begin(n, false, "%s: wind speeds", out->species->name);
    while (k < n && !(k && wf_interrupted()) && !s)
        if (!(s = wf_speed_solve(out, o, speeds[k], given, a, d, &out->at[k], &why))) k++, wf_stage_step(1);
    out->given = given;
    if (!s && k == n && out->search.solved) out->search.solved(out, out->search.context);
    if (!s && k < n) s = WF_EINTERRUPTED;
    if (!s && !(nodes = wf_nodes_open(out, NULL)))
        s = wf_fail(&why, WF_ENOMEM, "not enough memory for the search of the critical speed");
    wf_stage_begin(WF_SEARCH_SOLUTIONS, true, "%s: critical wind speed", out->species->name);
    if (!s) s = wf_analysis_breaks(out, o, nodes, out->breaks, &why);
    if (!s) s = find_held(out, o, nodes, &why);
    searched = !s;
    wf_stage_begin(CURVE_SOLUTIONS, true, "%s: curves", out->species->name);
    if (!s) s = wf_analysis_sweep(out, o, nodes, a, d, &why);
    wf_nodes_close(nodes);
    wf_given_close(given, a);
    if (s == WF_EINTERRUPTED && k) s = keep_finished(out, k, searched, a, d, &why);
    if (s) return wf_fail(e, s, "%s", why.text);
    wf_limits_check(out, d);
    wf_limits_root(out, o->root_stiffness, d);
    return WF_OK;
}

enum wf_status wf_analyze(const struct wf_species *sp, const struct wf_model *m, const struct wf_scenario *sc,
                          const struct wf_search *search, const struct wf_solver *solver,
                          const struct wf_solve_options *o, const double *speeds, size_t n,
                          struct wf_arena *a, struct wf_diag *d, struct wf_analysis *out, struct wf_err *e)
{
    struct wf_search q;
    wf_search_default(&q);
    if (search) q = *search;
    enum wf_status s = check_call(sc, &q, solver, o, speeds, n, e);
    if (s) return s;
    for (size_t k = 0; k < n; k++) q.speed_max = fmax(q.speed_max, q.beyond * speeds[k]);
    *out = (struct wf_analysis){ .species = sp,
                                 .model = m,
                                 .solver = solver,
                                 .scenario = *sc,
                                 .search = q,
                                 .n = n,
                                 .diag = d,
                                 .branch_safety = NAN };
    if ((s = wf_analysis_set_up(out, o, a, d, e)) || (s = check_memory(out, n, e))) return s;
    if ((s = list_unions(out, a, e))) return s;
    s = wf_sway_begin(out, o, speeds, n, a, d, e);
    if (!s) s = solve_winds(out, o, speeds, a, d, e);
    wf_sway_end(out);
    return s;
}
