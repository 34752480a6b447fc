/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/speed.h"
#include "base/num.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "data/species.h"
#include "load/drag.h"
#include "solve/beam.h"
#include "solve/beam_many.h"
#include "solve/track.h"
#include "study/peak.h"
#include "study/sheltered.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>

/* ---- Loads and displacements of rows and totals of the tree at one wind speed ---- */

static const struct wf_steady unknown = { NAN, NAN, NAN, NAN, NAN, NAN };

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

/* Ratio of the crown's streamlined frontal area in the wind at x to its still-air frontal area. */
static double crown_share(const struct wf_loads *l, const double x[3])
{
    double u[3], gradient[9], derivative;
    if (!l->wind || !l->streamline) return 1.0;
    l->wind->sample(l->wind, x, u, gradient);
    return wf_streamline_share(l->streamline, &l->streamline_par, norm(u), &derivative);
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
        struct wf_line_point p = wf_line_point_of(t, i, gauss_s[g]);
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
        out->slope[i] = wf_response_slope(t, r, i);
        for (int k = 0; k < 3; k++) totals->air[k] += row.air[k];
        totals->weight += norm(row.weight) + (t->mass1 ? t->mass1[i] * l->gravity * l->weight_scale : 0.0);
    }
    return WF_OK;
}

/* ---- One wind speed: wind -> load -> solve -> fail -> figures ---- */

/* Where the end of a row is in the bent shape. */
static void end_at(const struct wf_tree *t, const struct wf_response *r, size_t row, double place[3])
{
    const double drawn[3] = { t->x1[row], t->y1[row], t->z1[row] };
    for (size_t k = 0; k < 3; k++) place[k] = drawn[k] + r->end[3 * row + k];
}

static void totals_fill(const struct wf_analysis *an, const struct totals *all, struct wf_at_speed *out)
{
    const double *to = an->wind.direction, *force = out->response.base_force,
                 *moment = out->response.base_moment;
    const size_t tip = wf_tip_row(&an->tree);
    double across = 0.0;
    out->drag = all->air[0] * to[0] + all->air[1] * to[1] + all->air[2] * to[2];
    for (int k = 0; k < 3; k++) across += pow(all->air[k] - out->drag * to[k], 2.0);
    out->lift = sqrt(across);
    out->weight = all->weight;
    out->tip_deflection = norm(out->response.end + 3 * tip);
    out->top_deflection = norm(out->response.end + 3 * wf_top_row(&an->tree));
    out->tip_deflection_share = out->tip_deflection / an->tallness;
    out->tip_angle = wf_response_slope(&an->tree, &out->response, tip);
    out->base_shear = hypot(force[0], force[1]);
    out->base_moment = hypot(moment[0], moment[1]);
    for (size_t k = 0; k < an->loads.ties; k++) {
        const struct wf_tie *tie = &an->loads.tie[k];
        double place[3], pull[3];
        end_at(&an->tree, &out->response, (size_t)tie->segment, place);
        out->tie[k] = wf_tie_pull(tie, place, pull, NULL);
    }
    for (size_t k = 0; k < an->loads.links; k++) out->link[k] = out->response.link[k];
}

static void totals_unknown(struct wf_at_speed *out)
{
    out->drag = out->lift = out->weight = out->tip_deflection = out->tip_deflection_share = NAN;
    out->top_deflection = out->tip_angle = out->base_shear = out->base_moment = NAN;
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

/* Stresses and criteria of the response, or of its change from the state at rest. */
static enum wf_status fill_stresses(const struct wf_analysis *an, const struct wf_breakage *like,
                                    struct wf_arena *a, struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_response change;
    const struct wf_response *r = &out->response;
    enum wf_status s = WF_OK;
    if (an->scenario.weight_unstressed) {
        s = wf_response_change(&an->tree, &an->still->response, r, a, &change, e);
        r = &change;
    }
    if (!s) s = wf_breakage_check(&an->tree, r, like, a, &out->breakage, e);
    if (!s) wf_criteria_check(&an->tree, &out->response, &out->breakage, out->worst);
    return s;
}

/* Compute stresses, criteria and figures from the response. */
static enum wf_status fill_at_speed(const struct wf_analysis *an, const struct wf_loads *l,
                                    const struct wf_breakage *like, struct wf_arena *a,
                                    struct wf_at_speed *out, struct wf_err *e)
{
    struct totals totals = { 0 };
    enum wf_status s = fill_stresses(an, like, a, out, e);
    if (s) return s;
    s = fill_figures(&an->tree, l, &out->response, an->wind.direction,
                     an->species->crown.drag_coefficient.value, a, &out->figures, &totals, e);
    if (!s) totals_fill(an, &totals, out);
    return s;
}

static double row_weight(const struct wf_tree *t, const struct wf_loads *l, size_t i)
{
    struct curve c;
    double sum = 0.0;
    curve_unloaded(t, i, &c);
    for (int g = 0; g < 5; g++) sum += gauss_w[g] * c.length * wf_line_point_of(t, i, gauss_s[g]).mass;
    return sum * l->gravity * l->weight_scale;
}

/* Weight of the rows [N]; NULL: not enough memory. */
static double *row_weights(const struct wf_tree *t, const struct wf_loads *l, struct wf_arena *a)
{
    double *out = wf_arena_take_unset(a, t->n, sizeof *out);
    for (size_t i = 0; i < t->n && out; i++) out[i] = row_weight(t, l, i);
    return out;
}

/* As fill_at_speed, without columns of figures: totals from the solver's own loads, of which the weight is
 * known (`rows`, by row_weights). Vertical dead line loads cannot be told from lift in them. */
static enum wf_status fill_totals(const struct wf_analysis *an, const struct wf_loads *l, const double *rows,
                                  const struct wf_breakage *like, struct wf_arena *a, struct wf_at_speed *out,
                                  struct wf_err *e)
{
    const struct wf_tree *t = &an->tree;
    const struct wf_response *r = &out->response;
    struct totals totals = { 0 };
    if (l->line) return fill_at_speed(an, l, like, a, out, e);
    enum wf_status s = fill_stresses(an, like, a, out, e);
    if (s) return s;
    for (size_t i = 0; i < t->n; i++) {
        const double weight = rows[i];
        for (int k = 0; k < 3; k++) totals.air[k] += r->load[3 * i + (size_t)k];
        totals.air[2] += weight;
        totals.weight += weight + (t->mass1 ? t->mass1[i] * l->gravity * l->weight_scale : 0.0);
    }
    totals_fill(an, &totals, out);
    return WF_OK;
}

/* The analysis' loads in a state of a speed, with their wind. */
static void blow(const struct wf_analysis *an, double speed, enum wf_part part, struct wf_wind *wind,
                 struct wf_loads *loads)
{
    *wind = an->wind;
    *loads = an->loads;
    wind->speed = wf_scenario_speed(&an->scenario, speed) * wf_peak_wind(an->peak, part);
    wf_loads_blow(loads, wind);
    loads->wind_scale *= wf_peak_factor(an->peak, speed, part);
}

/* Given: what a solver returned, and why. Returned: WF_OK with out->status, its totals unknown where it found
 * no equilibrium; another code when the run must end. */
static enum wf_status note_status(enum wf_status s, const struct wf_err *why, struct wf_at_speed *out,
                                  struct wf_err *e)
{
    out->status = s;
    if (s && s != WF_EUNSTABLE && s != WF_ENOCONV) return wf_fail(e, s, "%s", why->text);
    if (s) totals_unknown(out);
    return WF_OK;
}

/* A solved beam and its memory. */
struct kept {
    struct wf_arena memory;
    struct wf_beam beam;
    bool solved;
};

struct wf_given {
    double speed; /* of the states [m/s] */
    struct kept state[WF_PARTS];
    const struct kept *last; /* of them, while the speed is solved; NULL: none is yet */
    bool parallel;           /* other threads solve at the same time: what they share is not touched */
    struct wf_beam_few few;  /* a mesh for further states */
};

static void free_state(struct wf_given *g, enum wf_part part)
{
    wf_arena_free(&g->state[part].memory);
    g->state[part].solved = false;
}

static void free_states(struct wf_given *g)
{
    for (int k = 0; k < WF_PARTS; k++) free_state(g, (enum wf_part)k);
    g->last = NULL;
}

/* What is known after the states of a speed, for further ones: of the first speed also the states in which
 * they begin, that of the mean wind is not among these. to: NULL, nothing is kept. */
static void leave(struct wf_given *now, struct wf_given *to, bool solved)
{
    if (to && !(to->speed > 0) && solved) {
        free_states(to); /* of still air */
        to->speed = now->speed;
        memcpy(to->state, now->state, sizeof to->state);
        free_state(to, WF_PART_MEAN);
    } else
        free_states(now);
    if (to)
        to->few = now->few;
    else
        wf_arena_free(&now->few.memory);
}

struct wf_given *wf_given_open(struct wf_arena *a) { return WF_TAKE(a, 1, struct wf_given); }

void wf_given_close(struct wf_given *g, struct wf_arena *a)
{
    if (!g) return;
    free_states(g);
    wf_arena_join(a, &g->few.memory);
}

const struct wf_beam_few *wf_given_few(const struct wf_given *g) { return g ? &g->few : NULL; }

/* The states in mean winds about which sways were found; NULL: there are none. */
static struct wf_track *mean_states(const struct wf_analysis *an)
{
    return an->peak ? an->peak->about : NULL;
}

/* That of a speed; NULL: none. */
static const struct wf_beam *mean_state(const struct wf_analysis *an, double speed)
{
    struct wf_wind wind;
    struct wf_loads loads;
    struct wf_track *all = mean_states(an);
    blow(an, speed, WF_PART_MEAN, &wind, &loads);
    return all && loads.wind ? wf_track_near(all, wind.speed) : NULL;
}

/* As the solver 'beam', from what is known of other states. Returned: also the solution, where there is one.
 */
static enum wf_status solve_beam(const struct wf_analysis *an, const struct wf_solve_options *o,
                                 const struct wf_loads *l, enum wf_part part, struct wf_given *g,
                                 struct wf_arena *a, struct wf_response *r, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct kept *now = &g->state[part];
    struct wf_arena newton = { 0 };
    struct wf_beam_outcome how = { 0 };
    enum wf_status s = wf_response_alloc(r, an->tree.n, a, e);
    if (!s) s = wf_solve_check(&an->tree, l, d, e);
    if (s) return s;
    const bool begun = !g->parallel && part != WF_PART_BRANCHES;
    const struct wf_beam *soon = begun ? mean_state(an, g->speed) : NULL;
    const struct wf_beam_known known = { .near = g->last ? &g->last->beam : NULL,
                                         .good = g->last ? &g->last->beam.mesh : NULL,
                                         .soon = soon,
                                         .few = &g->few };
    s = wf_beam_solve(&an->tree, l, o, &known, &now->memory, &newton, &now->beam, &how, e);
    r->load_factor = how.load_factor;
    if (!s) wf_beam_read(&now->beam, r);
    wf_arena_free(&newton);
    if (s) {
        wf_arena_free(&now->memory);
        return s;
    }
    wf_beam_warn(&now->beam, &how, d);
    now->solved = true;
    g->last = now;
    return WF_OK;
}

/* The tree in one of the states of a wind speed; otherwise as wf_speed_solve. */
static enum wf_status solve_state(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  double speed, enum wf_part part, struct wf_given *g, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_wind wind;
    struct wf_loads loads;
    struct wf_sheltered sheltered = { 0 };
    struct wf_err why = { 0 };
    enum wf_status s;
    *out = (struct wf_at_speed){ .speed = speed, .steady = unknown };
    blow(an, speed, part, &wind, &loads);
    if (an->scenario.shelter && loads.wind)
        s = solve_sheltered(an, &loads, o, a, &sheltered, &out->response, d, &why);
    else if (an->solver == &wf_solver_beam)
        s = solve_beam(an, o, &loads, part, g, a, &out->response, d, &why);
    else
        s = an->solver->solve(&an->tree, &loads, o, a, &out->response, d, &why);
    s = note_status(s, &why, out, e);
    if (!s && !out->status)
        s = fill_at_speed(an, sheltered.passes ? &sheltered.loads : &loads, NULL, a, out, e);
    wf_sheltered_end(&sheltered);
    return s;
}

/* ---- The states of one wind speed together ---- */

/* Section forces and stresses of a branch's row. */
static void take_row(const struct wf_breakage *from, size_t i, struct wf_breakage *to)
{
    double *const to_column[] = { to->shear0,   to->shear1,   to->axial0,   to->axial1,    to->bending0,
                                  to->bending1, to->torsion0, to->torsion1, to->stress0,   to->stress1,
                                  to->safety0,  to->safety1,  to->peak,     to->peak_place };
    const double *const column[] = { from->shear0,   from->shear1,    from->axial0,   from->axial1,
                                     from->bending0, from->bending1,  from->torsion0, from->torsion1,
                                     from->stress0,  from->stress1,   from->safety0,  from->safety1,
                                     from->peak,     from->peak_place };
    for (size_t k = 0; k < WF_COUNT(column); k++) to_column[k][i] = column[k][i];
    for (int c = 0; c < WF_CRITERIA; c++)
        if (to->use[c]) to->use[c][i] = from->use[c][i], to->use_place[c][i] = from->use_place[c][i];
}

/* The largest stress of stem and branches, from the columns. */
static void take_stresses(const struct wf_tree *t, const struct wf_breakage *from, struct wf_breakage *to)
{
    to->largest_stress = 0.0;
    to->largest_stress_row = -1;
    for (size_t i = 0; i < t->n; i++) {
        if (t->level[i] > 0) take_row(from, i, to);
        if (to->largest_stress_row < 0 || to->peak[i] > to->largest_stress)
            to->largest_stress = to->peak[i], to->largest_stress_row = (int32_t)i;
    }
}

void wf_speed_take_branches(const struct wf_analysis *an, const struct wf_at_speed *branches,
                            struct wf_at_speed *at)
{
    if (at->status) return;
    if (branches->status) {
        at->status = branches->status;
        at->response.load_factor = branches->response.load_factor;
        totals_unknown(at);
        return;
    }
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_worst *stem = &at->worst[c][WF_SCOPE_STEM],
                              *branch = &branches->worst[c][WF_SCOPE_BRANCHES];
        at->worst[c][WF_SCOPE_BRANCHES] = *branch;
        at->worst[c][WF_SCOPE_TREE] = branch->row < 0 || stem->safety <= branch->safety ? *stem : *branch;
    }
    for (size_t k = 0; k < an->loads.links; k++)
        if (fabs(branches->link[k]) > fabs(at->link[k])) at->link[k] = branches->link[k];
    if (at->breakage.n && branches->breakage.n)
        take_stresses(&an->tree, &branches->breakage, &at->breakage);
    else if (branches->breakage.largest_stress > at->breakage.largest_stress)
        at->breakage.largest_stress = branches->breakage.largest_stress,
        at->breakage.largest_stress_row = branches->breakage.largest_stress_row;
}

static struct wf_steady steady_of(const struct wf_at_speed *at)
{
    return (struct wf_steady){ at->drag,      at->tip_deflection, at->top_deflection,
                               at->tip_angle, at->base_shear,     at->base_moment };
}

enum wf_status wf_speed_solve(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_given *given, struct wf_arena *a, struct wf_diag *d,
                              struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag quiet = { .arena = &scratch };
    struct wf_at_speed mean, branches;
    struct wf_given now = { .speed = speed, .parallel = !given };
    const bool gusts = wf_peak_differs(an->peak);
    if (given) now.few = given->few;
    /* the mean wind last: a mesh that is good in more wind is good in it */
    enum wf_status s = solve_state(an, o, speed, WF_PART_STEM, &now, a, d, out, e);
    if (!s && wf_peak_branches(an->peak)) {
        s = solve_state(an, o, speed, WF_PART_BRANCHES, &now, &scratch, &quiet, &branches, e);
        if (!s) wf_speed_take_branches(an, &branches, out);
    }
    if (!s && gusts) s = solve_state(an, o, speed, WF_PART_MEAN, &now, &scratch, &quiet, &mean, e);
    if (!s) out->steady = steady_of(gusts ? &mean : out);
    leave(&now, given, !s);
    wf_arena_free(&scratch);
    return s;
}

void wf_speed_drop_columns(struct wf_at_speed *at)
{
    struct wf_response *r = &at->response;
    *r = (struct wf_response){ .imbalance = r->imbalance,
                               .load_factor = r->load_factor,
                               .iterations = r->iterations,
                               .steps = r->steps,
                               .small_deflection = r->small_deflection,
                               .base_force = { r->base_force[0], r->base_force[1], r->base_force[2] },
                               .base_moment = { r->base_moment[0], r->base_moment[1], r->base_moment[2] } };
    at->breakage = (struct wf_breakage){ .largest_stress = at->breakage.largest_stress,
                                         .largest_stress_row = at->breakage.largest_stress_row };
    at->figures = (struct wf_figures){ 0 };
}

enum wf_status wf_speed_totals(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                               struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag quiet = { .arena = &scratch };
    enum wf_status s = wf_speed_solve(an, o, speed, NULL, &scratch, &quiet, out, e);
    wf_stage_step(1);
    wf_arena_free(&scratch);
    wf_speed_drop_columns(out);
    return s;
}

/* The states of a block as results: figures, then totals alone. */
static enum wf_status fill_block(const struct wf_analysis *const *an, struct wf_beam_state *state, size_t n,
                                 struct wf_arena *a, struct wf_at_speed *out, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < n && !s; k++) {
        out[k].response = state[k].response;
        s = note_status(state[k].status, &state[k].why, &out[k], e);
        if (!s && !out[k].status) s = fill_at_speed(an[k], state[k].loads, NULL, a, &out[k], e);
        wf_speed_drop_columns(&out[k]);
        wf_stage_step(1);
    }
    return s;
}

static enum wf_status solve_block(const struct wf_analysis *const *an, const double *speed, size_t n,
                                  enum wf_part part, const struct wf_solve_options *o,
                                  struct wf_at_speed *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_wind wind[WF_BEAM_BLOCK];
    struct wf_loads loads[WF_BEAM_BLOCK];
    struct wf_beam_state state[WF_BEAM_BLOCK];
    for (size_t k = 0; k < n; k++) {
        blow(an[k], speed[k], part, &wind[k], &loads[k]);
        state[k] = (struct wf_beam_state){ .loads = &loads[k] };
        out[k] = (struct wf_at_speed){ .speed = speed[k], .steady = unknown };
    }
    enum wf_status s = wf_beam_many(&an[0]->tree, state, n, o, wf_given_few(an[0]->given), &scratch, NULL, e);
    if (!s) s = fill_block(an, state, n, &scratch, out, e);
    wf_arena_free(&scratch);
    return s;
}

/* A block at the peak of the load on the tree, and of that on branches. */
static enum wf_status solve_states(const struct wf_analysis *const *an, const double *speed, size_t n,
                                   const struct wf_solve_options *o, struct wf_at_speed *out,
                                   struct wf_err *e)
{
    struct wf_at_speed branches[WF_BEAM_BLOCK];
    enum wf_status s = solve_block(an, speed, n, WF_PART_STEM, o, out, e);
    if (s || !wf_peak_branches(an[0]->peak)) return s;
    s = solve_block(an, speed, n, WF_PART_BRANCHES, o, branches, e);
    for (size_t k = 0; k < n && !s; k++) wf_speed_take_branches(an[k], &branches[k], &out[k]);
    return s;
}

enum wf_status wf_speed_totals_many(const struct wf_analysis *const *an, const double *speed, size_t n,
                                    const struct wf_solve_options *o, struct wf_at_speed *out,
                                    struct wf_err *e)
{
    enum wf_status s = WF_OK;
    bool together = an[0]->solver == &wf_solver_beam && !an[0]->scenario.shelter;
    for (size_t k = 0; k < n && !s; k += together ? WF_BEAM_BLOCK : 1) {
        size_t some = n - k < WF_BEAM_BLOCK ? n - k : WF_BEAM_BLOCK;
        s = together ? solve_states(an + k, speed + k, some, o, out + k, e)
                     : wf_speed_totals(an[k], o, speed[k], &out[k], e);
    }
    return s;
}

/* Share by which the wind on the tree is faster where slopes are taken: small against what bends the
 * response, large against what Newton's method has left of the weight's equilibrium, which in a light wind is
 * not small beside the wind's answer. */
static double share_of(double speed)
{
    const double most = 1e-4, light = 0.5; /* [m/s] */
    return most / (1.0 + speed * speed / (light * light));
}

/* The solution of a given speed; NULL: none. */
static const struct wf_beam *given_state(const struct wf_analysis *an, enum wf_part part, double speed)
{
    const struct wf_given *g = an->given;
    return g && g->speed == speed && g->state[part].solved ? &g->state[part].beam : NULL;
}

enum wf_status wf_speed_track(const struct wf_analysis *an, enum wf_part part, struct wf_track *k,
                              double speed, const struct wf_track_start *near, struct wf_arena *a,
                              struct wf_speed_answers *out, struct wf_err *e)
{
    struct wf_wind wind, more;
    struct wf_loads loads, side;
    struct wf_tracked t;
    struct wf_err why = { 0 };
    *out = (struct wf_speed_answers){ .at = { .speed = speed, .steady = unknown } };
    blow(an, speed, part, &wind, &loads);
    const double share = share_of(loads.wind ? wind.speed : 0.0);
    const struct wf_track_start start = { .share = share,
                                          .other = near ? near->other : NULL,
                                          .alone = near && near->alone,
                                          .paced = part == WF_PART_MEAN ? NULL : mean_states(an),
                                          .from = given_state(an, part, speed) };
    blow(an, speed * (1.0 + share), part, &more, &side);
    enum wf_status s = wf_track_solve(k, &loads, speed > 0.0 ? &side : NULL, &start, a, &t, &why);
    if (start.from) free_state(an->given, part); /* the track has it now */
    out->at.response = t.at;
    out->irregular = t.irregular;
    s = note_status(s, &why, &out->at, e);
    if (s || out->at.status) return s;
    const double *rows = row_weights(&an->tree, &loads, a); /* of which both loads have as much */
    if (!rows) return wf_fail(e, WF_ENOMEM, "not enough memory for the weight of %zu rows", an->tree.n);
    s = fill_totals(an, &loads, rows, NULL, a, &out->at, e);
    if (s || !t.sided) return s;
    out->step = speed * share * (1.0 + 0.5 * share); /* the answer to the side's loads, which grow about with
                                                        the square of the speed, is that of first order */
    out->side.response = t.side;
    return fill_totals(an, &side, rows, &out->at.breakage, a, &out->side, e);
}
