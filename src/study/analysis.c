/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/analysis.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/vec3.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/grow.h"
#include "load/drag.h"
#include "solve/unload.h"
#include "study/sheltered.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>
#include <time.h>

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
    return !s && an->model->shape == WF_SHAPE_UNDER_WEIGHT ? unload(an, a, d, e) : s;
}

bool wf_analysis_grown(const struct wf_analysis *an, size_t level)
{
    for (size_t i = 0; i < an->tree.n; i++)
        if (wf_model_wood(an->model, an->species, &an->tree, i) == &an->species->level[level]) return true;
    return false;
}

/* ---- The critical wind speeds, by criterion and part of the tree ---- */

/* Results at speeds already solved: all searches use the same speeds at first. */
enum { KNOWN_MAX = 200 };
struct known {
    double deadline; /* of the process's time [s] */
    bool over;       /* the deadline ended a search */
    int n;
    double tolerance[KNOWN_MAX]; /* of the mesh */
    struct wf_at_speed at[KNOWN_MAX];
};

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    enum wf_criterion_id criterion;
    enum wf_scope scope;
    struct known *known;
    double speed_max; /* [m/s] */
};

static double processor_seconds(void)
{
    struct timespec t;
    return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) ? 0.0 : (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static const struct wf_at_speed *recall(const struct search *q, double speed)
{
    const struct known *k = q->known;
    for (int i = 0; i < k->n; i++)
        if (k->at[i].speed == speed && k->tolerance[i] == q->o->mesh_tolerance) return &k->at[i];
    return NULL;
}

static void keep(struct known *k, double tolerance, const struct wf_at_speed *at)
{
    if (k->n == KNOWN_MAX) return;
    k->tolerance[k->n] = tolerance;
    k->at[k->n++] = *at;
}

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    const struct wf_at_speed *known = recall(q, speed);
    if (known) *at = *known;
    if (known) return WF_OK;
    q->known->over = q->known->over || processor_seconds() > q->known->deadline;
    /* any status that is no answer about the tree ends the search; find_break then looks at `over` */
    if (q->known->over) return wf_fail(e, WF_EINTERNAL, "the time of the search is used up");
    enum wf_status s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (!s) keep(q->known, q->o->mesh_tolerance, at);
    return s;
}

static double safety(const struct search *q, const struct wf_at_speed *at)
{
    return at->worst[q->criterion][q->scope].safety;
}

static bool falls(const struct search *q, const struct wf_at_speed *at)
{
    return at->status || !(safety(q, at) > 1.0);
}

/* Load over resistance at the worst section. */
static enum wf_status utilisation(void *ctx, double speed, double *value, struct wf_err *e)
{
    const struct search *s = ctx;
    struct wf_at_speed at;
    enum wf_status status = search_totals(s, speed, &at, e);
    if (status) return status;
    if (at.status) return wf_fail(e, at.status, "no equilibrium at %.6g m/s", speed);
    *value = 1.0 / safety(s, &at);
    return WF_OK;
}

/* Refine the critical speed found on a coarse mesh to the mesh tolerance of the options, by secant steps with
 * the coarse mesh's slope, which differs little. Returned: c->speed, and *at, the totals at it. */
static enum wf_status polish(const struct search *search, struct wf_critical *c, struct wf_at_speed *at,
                             struct wf_err *e)
{
    const double near = 3e-6; /* of the resistance */
    for (int k = 0;; k++) {
        enum wf_status s = search_totals(search, c->speed, at, e);
        c->evaluations++;
        if (s || at->status) return s;
        double excess = 1.0 / safety(search, at) - 1.0;
        double step = excess / c->gradient;
        if (fabs(excess) <= near || k == 4 || !(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed -= step;
    }
}

/* A batch of speeds solved in parallel. */
struct batch {
    const struct search *search;
    double speed[WF_CRITICAL_RUNGS + 1];
    struct wf_at_speed at[WF_CRITICAL_RUNGS + 1];
    bool kept[WF_CRITICAL_RUNGS + 1];
};

static enum wf_status rung(void *context, size_t k, struct wf_err *e)
{
    struct batch *b = context;
    b->kept[k] = false;
    if (processor_seconds() > b->search->known->deadline) return WF_OK;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Solve the speeds that wf_critical_search will step through, as many at a time as there are threads, until
 * the tree fails at one, and store the results. Errors are ignored: wf_critical_search solves that speed
 * again and reports them. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    struct known *known = q->known;
    size_t threads = wf_parallel_threads(q->o->threads);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    for (int k = 0; k <= WF_CRITICAL_RUNGS && !fell;) {
        size_t n = 0;
        for (; k <= WF_CRITICAL_RUNGS && n < threads; k++) {
            double speed = wf_critical_rung(q->speed_max, k);
            const struct wf_at_speed *at = recall(q, speed);
            if (at)
                fell = fell || falls(q, at);
            else
                b->speed[n++] = speed;
        }
        enum wf_status s = wf_parallel(n, q->o->threads, rung, b, e);
        if (s) {
            wf_arena_free(&scratch);
            return s;
        }
        for (size_t i = 0; i < n; i++) {
            fell = fell || !b->kept[i] || falls(q, &b->at[i]);
            if (b->kept[i]) keep(known, q->o->mesh_tolerance, &b->at[i]);
        }
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

static void place_at(const struct wf_tree *t, const struct wf_worst *w, struct wf_break *out)
{
    out->row = w->row;
    out->height = t->z0[w->row] + w->place * (t->z1[w->row] - t->z0[w->row]);
}

/* The highest speed to be searched: the range given, or the lowest given speed above it at which this part of
 * the tree failed. */
static double search_top(const struct search *q)
{
    double top = INFINITY;
    for (size_t k = 0; q->an->at && k < q->an->n; k++) {
        const struct wf_at_speed *at = &q->an->at[k];
        if (at->speed <= q->an->search.speed_max && falls(q, at)) return q->an->search.speed_max;
        if (falls(q, at)) top = fmin(top, at->speed);
    }
    return isfinite(top) ? top : q->an->search.speed_max;
}

/* What is known of a search that was ended: between which speeds the tree fails. */
static void bracket(const struct search *q, struct wf_critical *c)
{
    *c = (struct wf_critical){ WF_CRITICAL_UNSEARCHED, NAN, 0.0, q->speed_max, NAN, 0 };
    for (int i = 0; i < q->known->n; i++)
        if (falls(q, &q->known->at[i])) c->speed_high = fmin(c->speed_high, q->known->at[i].speed);
    for (int i = 0; i < q->known->n; i++) {
        double speed = q->known->at[i].speed;
        if (speed < c->speed_high && !falls(q, &q->known->at[i])) c->speed_low = fmax(c->speed_low, speed);
    }
}

/* The search itself, and the result at its end. */
static enum wf_status search_break(struct search *search, const struct wf_solve_options *quick,
                                   const struct wf_solve_options *fine, struct wf_break *out,
                                   struct wf_err *e)
{
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    search->o = quick;
    enum wf_status s = climb(search, e);
    if (!s) s = wf_critical_search(utilisation, search, search->speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search->o = fine;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(search, c, &at, e) : search_totals(search, 0.0, &at, e);
    const struct wf_worst *worst = &at.worst[search->criterion][search->scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&search->an->tree, worst, out);
    return WF_OK;
}

static enum wf_status find_break(struct search search, struct wf_break *out, struct wf_err *e)
{
    const struct wf_solve_options *fine = search.o;
    struct wf_solve_options quick = *fine;
    struct wf_err why = { 0 };
    if (fine->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(fine->mesh_tolerance, 1e-4);
    const struct wf_break nothing = { .at = { .speed = NAN }, .row = -1, .height = NAN };
    *out = nothing;
    if (!wf_criterion_known(&wf_criteria[search.criterion], &search.an->tree, search.scope)) {
        out->critical =
            (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    search.speed_max = search_top(&search);
    enum wf_status s = search_break(&search, &quick, fine, out, &why);
    if (!s) return WF_OK;
    if (!search.known->over) return wf_fail(e, s, "%s", why.text);
    *out = nothing;
    bracket(&search, &out->critical);
    return WF_OK;
}

/* Result of the branches as far as it follows from that of the whole tree. */
static void branches(const struct wf_analysis *an, const struct wf_criterion *c, const struct wf_break *tree,
                     struct wf_break *out)
{
    bool known = wf_criterion_known(c, &an->tree, WF_SCOPE_BRANCHES);
    *out = *tree;
    if (known && (tree->row < 0 || an->tree.level[tree->row] > 0)) return;
    *out = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
    out->critical = (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                          .speed = NAN,
                                          .gradient = NAN };
    if (!known) return;
    out->critical.speed_low = tree->critical.outcome == WF_CRITICAL_FOUND ? tree->critical.speed_low : 0.0;
    out->critical.speed_high = an->search.speed_max;
}

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct known *known = WF_TAKE(&scratch, 1, struct known);
    enum wf_status s = WF_OK;
    if (!known) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    known->deadline = processor_seconds() + an->search.seconds;
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        struct search search = { an, o, (enum wf_criterion_id)c, WF_SCOPE_TREE, known, NAN };
        s = find_break(search, &out[c][WF_SCOPE_TREE], e);
        if (s) break;
        out[c][WF_SCOPE_STEM] = out[c][WF_SCOPE_TREE];
        branches(an, &wf_criteria[c], &out[c][WF_SCOPE_TREE], &out[c][WF_SCOPE_BRANCHES]);
        search.scope = WF_SCOPE_STEM;
        if (wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            s = find_break(search, &out[c][WF_SCOPE_STEM], e);
    }
    wf_arena_free(&scratch);
    return s;
}

/* ---- The whole analysis ---- */

/* Points of the curves. */
struct sweep_points {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    struct wf_at_speed *at;
    double deadline; /* of the process's time [s] */
    bool *skipped;   /* the deadline came before this point */
};

static enum wf_status sweep_point(void *context, size_t k, struct wf_err *e)
{
    const struct sweep_points *c = context;
    c->skipped[k] = processor_seconds() > c->deadline;
    if (c->skipped[k]) return WF_OK;
    return wf_speed_totals(c->an, c->o, c->at[k].speed, &c->at[k], e);
}

/* Totals at speeds from 0 beyond the given and the critical speeds, at a round step; a quarter of it for the
 * first steps, where the deflection of a slender tree grows fastest. */
static enum wf_status sweep(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                            struct wf_diag *d, struct wf_err *e)
{
    enum { QUARTERED = 5, STEPS = 40 };
    static const double steps[] = { 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0 };
    struct wf_solve_options curve = *o;
    double top = 1.0, step = 0.0;
    if (o->mesh_tolerance > 0.0) curve.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4); /* finer than drawn */
    for (size_t k = 0; k < an->n; k++) top = fmax(top, an->at[k].speed);
    const struct wf_critical *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    if (first->outcome == WF_CRITICAL_FOUND) top = fmax(top, fmin(1.1 * first->speed, an->search.speed_max));
    for (size_t k = 0; k < WF_COUNT(steps); k++)
        if ((step = steps[k]) * STEPS >= top) break;
    an->sweep_n = (size_t)ceil(top / step - 1e-9) + 3 * QUARTERED + 1;
    if (!(an->sweep = WF_TAKE(a, an->sweep_n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", an->sweep_n);
    for (size_t k = 0; k < an->sweep_n; k++)
        an->sweep[k].speed = step * (k < 4 * QUARTERED ? 0.25 * (double)k : (double)k - 3 * QUARTERED);
    struct sweep_points c = { an, &curve, an->sweep, processor_seconds() + an->search.seconds,
                              WF_TAKE(a, an->sweep_n, bool) };
    if (!c.skipped) return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", an->sweep_n);
    if (an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_UNSEARCHED) c.deadline = 0.0;
    enum wf_status s = wf_parallel(an->sweep_n, o->threads, sweep_point, &c, e);
    bool whole = true;
    for (size_t k = 0; k < an->sweep_n; k++) whole = whole && !c.skipped[k];
    if (s || whole) return s;
    an->sweep_n = an->n, an->sweep = an->at; /* no more than the speeds given */
    wf_diag_warn(d, "search-ended",
                 "%s: the time for the curves (%.4g s) is used up: curves join the given wind speeds alone",
                 an->species->name, an->search.seconds);
    return WF_OK;
}

void wf_search_default(struct wf_search *s) { *s = (struct wf_search){ 100.0, INFINITY, NULL, NULL }; }

static enum wf_status check_call(const struct wf_scenario *sc, const struct wf_search *q,
                                 const double *speeds, size_t n, struct wf_err *e)
{
    if (n == 0) return wf_fail(e, WF_EUSAGE, "no wind speed is given");
    for (size_t k = 0; k < n; k++)
        if (!(speeds[k] >= 0.0 && speeds[k] <= 200.0))
            return wf_fail(e, WF_EUSAGE, "wind speed %.6g m/s is outside 0..200 m/s", speeds[k]);
    enum wf_status s = wf_scenario_check(sc, e);
    if (!s && !(q->speed_max >= 1.0 && q->speed_max <= 200.0))
        s = wf_fail(e, WF_EUSAGE, "highest speed searched %.6g m/s is outside 1..200", q->speed_max);
    if (!s && !(q->seconds > 0.0)) s = wf_fail(e, WF_EUSAGE, "the time of the search must be above 0 s");
    return s;
}

enum wf_status wf_analyze(const struct wf_species *sp, const struct wf_model *m, const struct wf_scenario *sc,
                          const struct wf_search *search, const struct wf_solver *solver,
                          const struct wf_solve_options *o, const double *speeds, size_t n,
                          struct wf_arena *a, struct wf_diag *d, struct wf_analysis *out, struct wf_err *e)
{
    struct wf_search q;
    wf_search_default(&q);
    if (search) q = *search;
    enum wf_status s = check_call(sc, &q, speeds, n, e);
    if (s) return s;
    *out = (struct wf_analysis){
        .species = sp, .model = m, .solver = solver, .scenario = *sc, .search = q, .n = n, .diag = d
    };
    if ((s = wf_analysis_set_up(out, a, d, e))) return s;
    if (!(out->at = WF_TAKE(a, n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu speeds", n);
    for (size_t k = 0; k < n; k++)
        if ((s = speed_solve(out, o, speeds[k], a, d, &out->at[k], e))) return s;
    if (q.solved) q.solved(out, q.context);
    if ((s = wf_analysis_breaks(out, o, out->breaks, e))) return s;
    if ((s = sweep(out, o, a, d, e))) return s;
    wf_limits_check(out, d);
    return WF_OK;
}
