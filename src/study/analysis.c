/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/analysis.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/vec3.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/grow.h"
#include "load/drag.h"
#include "load/interception.h"
#include "solve/unload.h"
#include "study/sheltered.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* ---- Loads and displacements of rows and totals of the tree at one wind speed ---- */

struct totals {
    double air[3]; /* force of the wind on the whole tree [N]       */
    double weight; /* of wood, leaves and added loads, on rows and at tips [N] */
};

/* Gauss-Legendre, five points on 0..1 */
static const double gauss_s[5] = { 0.046910077030668004, 0.23076534494715845, 0.5, 0.76923465505284155,
                                   0.95308992296933200 };
static const double gauss_w[5] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                   0.23931433524968324, 0.11846344252809454 };

static double norm(const double a[3]) { return sqrt(wf_dot(a, a)); }

/* A row as a curve: its ends and the tangents there, both scaled to the row's length. */
struct curve {
    double p0[3], p1[3], t0[3], t1[3];
    double length; /* unloaded [m] */
};

static void curve_unloaded(const struct wf_tree *t, size_t i, struct curve *c)
{
    const double p0[3] = { t->x0[i], t->y0[i], t->z0[i] }, p1[3] = { t->x1[i], t->y1[i], t->z1[i] };
    for (int k = 0; k < 3; k++) {
        c->p0[k] = p0[k];
        c->p1[k] = p1[k];
        c->t0[k] = c->t1[k] = p1[k] - p0[k];
    }
    c->length = norm(c->t0);
}

static void curve_bent(const struct wf_tree *t, const struct wf_response *r, size_t i, struct curve *c)
{
    curve_unloaded(t, i, c);
    int32_t below = t->parent[i];
    if (below >= 0) { /* the base moves with the parent's end, like a rigid arm where the axes do not meet */
        const double end[3] = { t->x1[below], t->y1[below], t->z1[below] };
        double arm[3], turned[3], turn[9];
        for (int k = 0; k < 3; k++) arm[k] = c->p0[k] - end[k];
        rotation_matrix(r->turn + 3 * below, turn);
        m3_apply(turn, arm, turned);
        for (int k = 0; k < 3; k++) c->p0[k] = end[k] + r->end[3 * below + k] + turned[k];
    }
    for (size_t k = 0; k < 3; k++) {
        c->p1[k] += r->end[3 * i + k];
        c->t0[k] = c->length * r->tangent0[3 * i + k];
        c->t1[k] = c->length * r->tangent1[3 * i + k];
    }
}

/* Position and unit tangent at s in 0..1. */
static void curve_at(const struct curve *c, double s, double x[3], double tangent[3])
{
    double s2 = s * s, s3 = s2 * s;
    for (int k = 0; k < 3; k++) {
        double rise = c->p1[k] - c->p0[k];
        x[k] = c->p0[k] + (3 * s2 - 2 * s3) * rise + (s3 - 2 * s2 + s) * c->t0[k] + (s3 - s2) * c->t1[k];
        tangent[k] = 6 * (s - s2) * rise + (3 * s2 - 4 * s + 1) * c->t0[k] + (3 * s2 - 2 * s) * c->t1[k];
    }
    double length = norm(tangent);
    for (int k = 0; k < 3; k++) tangent[k] /= length;
}

static struct wf_line_point line_point(const struct wf_tree *t, size_t i, double s)
{
    double outer = wf_between(t->r0[i], t->r1[i], s), inner = wf_between(t->i0[i], t->i1[i], s);
    double wood = t->density[i] * WF_PI * (outer * outer - inner * inner);
    return (struct wf_line_point){
        .diameter = 2.0 * outer,
        .drag = t->drag[i],
        .lift = t->lift[i],
        .sail = wf_between(t->sail0[i], t->sail1[i], s),
        .mass = wood + wf_between(t->burden0[i], t->burden1[i], s),
    };
}

/* Ratio of the crown's streamlined frontal area in the wind at x to its still-air frontal area. */
static double crown_share(const struct wf_loads *l, const double x[3])
{
    double u[3], gradient[9], derivative;
    if (!l->wind || !l->streamline) return 1.0;
    l->wind->sample(l->wind, x, u, gradient);
    return l->streamline->share(&l->streamline_par, norm(u), &derivative);
}

struct sums {
    double air[3], weight[3], area;
};

static void integrate(const struct wf_tree *t, const struct wf_loads *l, const struct curve *c, size_t i,
                      const double direction[3], double crown_drag, struct sums *out)
{
    *out = (struct sums){ 0 };
    for (int g = 0; g < 5; g++) {
        double x[3], tangent[3], seen[3], ds = gauss_w[g] * c->length;
        struct wf_line_point p = line_point(t, i, gauss_s[g]);
        struct wf_line_parts parts;
        curve_at(c, gauss_s[g], x, tangent);
        wf_load_parts_on_line(l, &p, x, tangent, &parts);
        for (int k = 0; k < 3; k++) {
            out->air[k] += ds * (parts.drag_axis[k] + parts.drag_crown[k] + parts.lift[k]);
            out->weight[k] += ds * parts.weight[k];
        }
        wf_cross(direction, tangent, seen);
        out->area += ds * p.diameter * norm(seen);
        if (crown_drag > 0.0) out->area += ds * p.sail / crown_drag * crown_share(l, x);
    }
}

/* Rotation of the axis at the row's end, without twist [rad]. */
static double slope_at_end(const struct curve *unloaded, const struct wf_response *r, size_t i)
{
    const double *turn = r->turn + 3 * i, *now = r->tangent1 + 3 * i;
    double before[3], across[3], matrix[9];
    if (r->small_deflection) {
        wf_cross(unloaded->t1, turn, across);
        return norm(across) / unloaded->length;
    }
    rotation_matrix(turn, matrix);
    m3_apply_transposed(matrix, now, before);
    wf_cross(before, now, across);
    return atan2(norm(across), wf_dot(before, now));
}

/* Given: tree, the loads passed to the solver, its result, direction the wind blows towards (unit vector),
 * crown drag coefficient by which the sail columns were multiplied. Returned: columns of n in *out and the
 * totals. Method: horizontal forces of the wind are the solver's own loads (wf_response.load), so that the
 * drag of all rows sums to the base shear; a horizontal dead load would count as wind. The vertical part of
 * lift, weight and area come from five-point Gauss quadrature along each row. A geometrically exact result is
 * sampled on its bent shape (cubic Hermite curve through the row's ends and end tangents); a small-deflection
 * result on the unloaded shape, on which its loads were computed. Projected area of the axis is that of its
 * surface seen along the wind; that of the crown is its still-air frontal area times the streamlining share,
 * so that the whole reduction of drag is counted as a reduction of area. Deflection and slope are measured
 * from the unloaded shape, so they include the sag under weight. */
static enum wf_status fill_figures(const struct wf_tree *t, const struct wf_loads *l,
                                   const struct wf_response *r, const double direction[3], double crown_drag,
                                   struct wf_arena *a, struct wf_figures *out, struct totals *totals,
                                   struct wf_err *e)
{
    double **column[] = { &out->projected_area, &out->drag, &out->lift, &out->deflection, &out->slope };
    for (size_t k = 0; k < WF_COUNT(column); k++)
        if (!(*column[k] = WF_TAKE(a, t->n, double)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for the figures of %zu rows", t->n);
    for (size_t i = 0; i < t->n; i++) {
        struct curve unloaded, bent;
        struct sums row;
        double across[3];
        curve_unloaded(t, i, &unloaded);
        bent = unloaded;
        if (!r->small_deflection) curve_bent(t, r, i, &bent);
        integrate(t, l, &bent, i, direction, crown_drag, &row);
        /* horizontally the solver's own loads, so that the drag sums to the base shear */
        row.air[0] = r->load[3 * i];
        row.air[1] = r->load[3 * i + 1];
        out->drag[i] = wf_dot(row.air, direction);
        for (int k = 0; k < 3; k++) across[k] = row.air[k] - out->drag[i] * direction[k];
        out->lift[i] = norm(across);
        out->projected_area[i] = row.area;
        out->deflection[i] = norm(r->end + 3 * i);
        out->slope[i] = slope_at_end(&unloaded, r, i);
        for (int k = 0; k < 3; k++) totals->air[k] += row.air[k];
        totals->weight += norm(row.weight) + (t->mass1 ? t->mass1[i] * l->gravity * l->weight_scale : 0.0);
    }
    return WF_OK;
}

/* ---- One wind speed: wind -> load -> solve -> fail -> figures ---- */

size_t wf_tip_row(const struct wf_tree *t)
{
    size_t tip = 0;
    double highest = -INFINITY;
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] == 0 && t->z1[i] > highest) {
            highest = t->z1[i];
            tip = i;
        }
    return tip;
}

static void totals_fill(const struct wf_analysis *an, const struct totals *all, struct wf_at_speed *out)
{
    const double *to = an->wind.direction, *force = out->response.base_force,
                 *moment = out->response.base_moment;
    size_t tip = wf_tip_row(&an->tree);
    double across = 0.0;
    out->drag = all->air[0] * to[0] + all->air[1] * to[1] + all->air[2] * to[2];
    for (int k = 0; k < 3; k++) across += pow(all->air[k] - out->drag * to[k], 2.0);
    out->lift = sqrt(across);
    out->weight = all->weight;
    out->tip_deflection = out->figures.deflection[tip];
    out->tip_deflection_share = out->tip_deflection / an->tallness;
    out->tip_angle = out->figures.slope[tip];
    out->base_shear = hypot(force[0], force[1]);
    out->base_moment = hypot(moment[0], moment[1]);
}

static void totals_unknown(struct wf_at_speed *out)
{
    out->drag = out->lift = out->weight = out->tip_deflection = out->tip_deflection_share = NAN;
    out->tip_angle = out->base_shear = out->base_moment = NAN;
    out->breakage.largest_stress = NAN;
    out->breakage.largest_stress_row = -1;
    wf_criteria_check(NULL, NULL, NULL, out->worst);
}

/* The tree in the wind that its own crown reduces. The grid is coarser than that of maps because it is made
 * anew for every shape. */
static enum wf_status solve_sheltered(const struct wf_analysis *an, const struct wf_loads *l,
                                      const struct wf_solve_options *o, struct wf_arena *a,
                                      struct wf_sheltered *out, struct wf_response *r, struct wf_diag *d,
                                      struct wf_err *e)
{
    struct wf_shelter_request q;
    wf_shelter_request_default(&q);
    q.law = wf_shelter_law_named(an->scenario.shelter);
    q.slabs = 24;
    q.cells = 64;
    if (an->species->crown.drag_coefficient.given) q.crown_drag = an->species->crown.drag_coefficient.value;
    return wf_sheltered_solve(&an->tree, l, &q, an->solver, o, a, out, r, d, e);
}

/* Compute stresses, criteria and figures from the response. */
static enum wf_status fill_at_speed(const struct wf_analysis *an, const struct wf_loads *l,
                                    struct wf_arena *a, struct wf_at_speed *out, struct wf_err *e)
{
    struct totals totals = { 0 };
    enum wf_status s = wf_breakage_check(&an->tree, &out->response, a, &out->breakage, e);
    if (s) return s;
    wf_criteria_check(&an->tree, &out->response, &out->breakage, out->worst);
    s = fill_figures(&an->tree, l, &out->response, an->wind.direction,
                     an->species->crown.drag_coefficient.value, a, &out->figures, &totals, e);
    if (!s) totals_fill(an, &totals, out);
    return s;
}

/* Given: an analysis whose tree, wind, loads, species, solver are set; a speed at the reference height [m/s].
 * Returned: WF_OK and *out; where the solver finds no equilibrium (WF_EUNSTABLE, WF_ENOCONV) also WF_OK with
 * that status in out->status, the totals NAN and the load factor in out->response; another code when the run
 * must end. */
static enum wf_status speed_solve(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  double speed, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_wind wind = an->wind;
    struct wf_loads loads = an->loads;
    struct wf_sheltered sheltered = { 0 };
    struct wf_err why = { 0 };
    enum wf_status s = WF_OK;
    memset(out, 0, sizeof *out);
    out->speed = speed;
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    loads.wind = speed > 0.0 ? &wind : NULL;
    if (an->scenario.shelter && loads.wind)
        out->status = solve_sheltered(an, &loads, o, a, &sheltered, &out->response, d, &why);
    else
        out->status = an->solver->solve(&an->tree, &loads, o, a, &out->response, d, &why);
    if (out->status == WF_EUNSTABLE || out->status == WF_ENOCONV)
        totals_unknown(out);
    else if (out->status)
        s = wf_fail(e, out->status, "%s", why.text);
    else
        s = fill_at_speed(an, sheltered.passes ? &sheltered.loads : &loads, a, out, e);
    wf_sheltered_end(&sheltered);
    return s;
}

enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag quiet = { .arena = &scratch };
    enum wf_status s = speed_solve(an, o, speed, &scratch, &quiet, out, e);
    wf_arena_free(&scratch);
    struct wf_at_speed kept = *out;
    /* the columns are freed with the scratch arena: keep the scalars, clear the pointers */
    kept.response = (struct wf_response){ .imbalance = out->response.imbalance,
                                          .load_factor = out->response.load_factor,
                                          .iterations = out->response.iterations,
                                          .steps = out->response.steps,
                                          .small_deflection = out->response.small_deflection };
    memcpy(kept.response.base_force, out->response.base_force, sizeof kept.response.base_force);
    memcpy(kept.response.base_moment, out->response.base_moment, sizeof kept.response.base_moment);
    kept.breakage = (struct wf_breakage){ .largest_stress = out->breakage.largest_stress,
                                          .largest_stress_row = out->breakage.largest_stress_row };
    kept.figures = (struct wf_figures){ 0 };
    *out = kept;
    return s;
}

/* ---- Set up ---- */

/* Replace a shape drawn or measured under the tree's own weight by its stress-free shape. */
static enum wf_status unload(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_solve_options o;
    struct wf_loads weight = an->loads;
    struct wf_tree free;
    double left, moved;
    weight.wind = NULL;
    wf_solve_options_default(&o);
    enum wf_status s = wf_unload(&an->tree, &weight, &o, a, &free, &left, &moved, e);
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

enum wf_status wf_analysis_set_up(struct wf_analysis *an, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    enum wf_status s = wf_grow(an->model, an->species, a, &an->tree, d, e);
    if (s || (s = wf_tree_check(&an->tree, d, e))) return s;
    an->tallness = wf_tree_height(&an->tree);
    s = wf_scenario_loads(&an->scenario, an->species, &an->wind, &an->loads, e);
    if (!s && an->model->shape == WF_SHAPE_UNDER_WEIGHT) s = unload(an, a, d, e);
    if (!s && an->scenario.water > 0) wf_intercept(&an->tree, an->scenario.water); /* it was drawn dry */
    return s;
}

/* Memory of an analysis beside one solution, for a row of the tree. Measured with 20 000 and 100 000 rows,
 * one wind speed and one thread: 5.5 kB a row in all without the searches, 7.1 kB with them. */
enum { ROW_BYTES = 2700 };

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
    *out = (struct wf_analysis){
        .species = sp, .model = m, .solver = solver, .scenario = *sc, .search = q, .n = n, .diag = d
    };
    if ((s = wf_analysis_set_up(out, a, d, e)) || (s = check_memory(out, n, e))) return s;
    if (!(out->at = WF_TAKE(a, n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu speeds", n);
    struct wf_err why = { 0 };
    struct wf_arena scratch = { 0 };
    struct wf_known *known = wf_known_take(&scratch);
    size_t k = 0;
    bool searched = false;
    if (!known) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    while (k < n && !(k && wf_interrupted()) && !s)
        if (!(s = speed_solve(out, o, speeds[k], a, d, &out->at[k], &why))) k++;
    if (!s && k == n && q.solved) q.solved(out, q.context);
    if (!s) s = k < n ? WF_EINTERRUPTED : wf_analysis_breaks(out, o, known, out->breaks, &why);
    searched = !s;
    if (!s) s = wf_analysis_sweep(out, o, known, a, d, &why);
    wf_arena_free(&scratch);
    if (s == WF_EINTERRUPTED && k) s = keep_finished(out, k, searched, a, d, &why);
    if (s) return wf_fail(e, s, "%s", why.text);
    wf_limits_check(out, d);
    return WF_OK;
}
