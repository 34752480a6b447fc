/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/vec3.h"
#include "data/section.h"
#include "fail/fail.h"
#include <math.h>

/* Load on the section at share `at` of row i. */
static struct wf_section_load section_load_at(const struct wf_tree *t, const struct wf_response *r, size_t i,
                                              double at, const double force[3], const double moment[3],
                                              const double axis[3])
{
    struct wf_section_load s = { .axial = wf_dot(force, axis), .torsion = wf_dot(moment, axis) };
    double v[3], m[3];
    for (int k = 0; k < 3; k++) v[k] = force[k] - s.axial * axis[k], m[k] = moment[k] - s.torsion * axis[k];
    s.shear = sqrt(wf_dot(v, v));
    s.bending = sqrt(wf_dot(m, m));
    if (!wf_section_is_ring(t, i)) {
        struct wf_fibre f = wf_fibre_stress(t, r, i, at, force, moment, axis);
        s.stress = fmax(f.high, -f.low), s.compression = -f.low, s.twist = f.twist;
        return s;
    }
    double outer = wf_wood_radius(t, i, at), inner = wf_between(t->i0[i], t->i1[i], at);
    double inertia = wf_ring_inertia(outer, inner);
    double bent = s.bending * outer / inertia, drawn = s.axial / wf_ring_area(outer, inner);
    s.stress = bent + fabs(drawn);
    s.compression = bent - drawn;
    s.twist = 0.5 * fabs(s.torsion) * outer / inertia;
    return s;
}

enum { GRID = 16, ROUNDS = 4 };

/* A row of a solved tree, with the loads of its ends and, where they were computed, of places near them and
 * within. Loads serve all rules. */
struct row {
    const struct wf_tree *t;
    const struct wf_response *r;
    size_t i;
    double length, slope0[3], slope1[3]; /* slopes of the moment at the ends: dM/ds = -t x F */
    struct wf_section_load end[2], near[2];
    bool ended[2], have[2];
    struct grid {
        bool there;
        double low, step; /* of the place s */
        struct wf_section_load load[GRID];
    } grid[ROUNDS];
};

/* Load at s (0..1) of a row: moment by the cubic through both ends, the rest linear. */
static struct wf_section_load load_inside(const struct row *w, double s)
{
    const struct wf_tree *t = w->t;
    const struct wf_response *r = w->r;
    size_t i = w->i;
    double left = 1 - s, force[3], moment[3], axis[3];
    const double *f0 = r->force0 + 3 * i, *f1 = r->force1 + 3 * i, *t0 = r->tangent0 + 3 * i,
                 *t1 = r->tangent1 + 3 * i;
    for (size_t k = 0; k < 3; k++) {
        force[k] = left * f0[k] + s * f1[k];
        axis[k] = left * t0[k] + s * t1[k];
        moment[k] = left * left * (1 + 2 * s) * r->moment0[3 * i + k] +
                    s * s * (3 - 2 * s) * r->moment1[3 * i + k] +
                    w->length * s * left * (left * w->slope0[k] - s * w->slope1[k]);
    }
    double size = sqrt(wf_dot(axis, axis));
    /* the two end tangents cancel: only the ends of this row count */
    if (!(size > 0)) return (struct wf_section_load){ 0 };
    for (int k = 0; k < 3; k++) axis[k] /= size;
    return section_load_at(t, r, i, s, force, moment, axis);
}

static void begin_row(const struct wf_tree *t, const struct wf_response *r, size_t i, struct row *w)
{
    w->t = t, w->r = r, w->i = i;
    w->length = wf_tree_length(t, i);
    wf_cross(r->force0 + 3 * i, r->tangent0 + 3 * i, w->slope0);
    wf_cross(r->force1 + 3 * i, r->tangent1 + 3 * i, w->slope1);
    w->ended[0] = w->ended[1] = w->have[0] = w->have[1] = false;
    for (int round = 0; round < ROUNDS; round++) w->grid[round].there = false;
}

static const struct wf_section_load *load_at_end(struct row *w, int end)
{
    const struct wf_response *r = w->r;
    const size_t i = w->i;
    const double *force = end ? r->force1 : r->force0, *moment = end ? r->moment1 : r->moment0,
                 *axis = end ? r->tangent1 : r->tangent0;
    if (!w->ended[end])
        w->end[end] = section_load_at(w->t, r, i, end, force + 3 * i, moment + 3 * i, axis + 3 * i);
    w->ended[end] = true;
    return &w->end[end];
}

/* What is compared between places of a row: the stress, or with a rule stress over resistance. */
static double measure(const struct row *w, const struct wf_section_rule *rule, double s,
                      const struct wf_section_load *l)
{
    return rule ? rule->stress(w->t, w->i, s, l) / rule->resistance(w->t, w->i, s) : l->stress;
}

static double measure_inside(const struct row *w, const struct wf_section_rule *rule, double s)
{
    const struct wf_section_load l = load_inside(w, s);
    return measure(w, rule, s, &l);
}

/* The measure near an end. The load there serves all rules. */
static double measure_near(struct row *w, const struct wf_section_rule *rule, int end)
{
    const double near = 1.0 / 64, s = end ? 1 - near : near;
    if (!w->have[end]) w->near[end] = load_inside(w, s), w->have[end] = true;
    return measure(w, rule, s, &w->near[end]);
}

/* The loads within a row at low + k step, k from 1. */
static const struct wf_section_load *loads_between(struct row *w, int round, double low, double step)
{
    struct grid *g = &w->grid[round];
    if (g->there && g->low == low && g->step == step) return g->load;
    g->there = true, g->low = low, g->step = step;
    for (int k = 1; k < GRID; k++) g->load[k] = load_inside(w, low + k * step);
    return g->load;
}

/* Largest measure of a row and its place: one of its ends, unless it rises inwards from both. In that case a
 * grid of sixteenths is refined three times around its best point. */
static double row_peak(struct row *w, const struct wf_section_rule *rule, double *place)
{
    double at0 = measure(w, rule, 0, load_at_end(w, 0)), at1 = measure(w, rule, 1, load_at_end(w, 1));
    double best = fmax(at0, at1), low = 0, high = 1;
    *place = at1 > at0 ? 1 : 0;
    const int larger = at1 > at0; /* from it the measure seldom rises inwards */
    if (!(measure_near(w, rule, larger) > (larger ? at1 : at0))) return best;
    if (!(measure_near(w, rule, !larger) > (larger ? at0 : at1))) return best;
    for (int round = 0; round < ROUNDS; round++) {
        double step = (high - low) / GRID;
        const struct wf_section_load *load = loads_between(w, round, low, step);
        for (int k = 1; k < GRID; k++) {
            double s = low + k * step, x = measure(w, rule, s, &load[k]);
            if (x > best) best = x, *place = s;
        }
        low = fmax(0, *place - step), high = fmin(1, *place + step);
    }
    return best;
}

/* The measure at a place that is known. */
static double measure_at(struct row *w, const struct wf_section_rule *rule, double place)
{
    if (place > 0 && place < 1) return measure_inside(w, rule, place);
    return measure(w, rule, place, load_at_end(w, place >= 1));
}

static bool take_columns(const struct wf_tree *t, bool ends, struct wf_breakage *b, struct wf_arena *a)
{
    enum { ALWAYS = 2 }; /* the rest are of the ends */
    double **column[] = { &b->peak,    &b->peak_place, &b->shear0,   &b->shear1,   &b->axial0,
                          &b->axial1,  &b->bending0,   &b->bending1, &b->torsion0, &b->torsion1,
                          &b->stress0, &b->stress1,    &b->safety0,  &b->safety1 };
    b->n = t->n;
    for (size_t k = 0; k < (ends ? sizeof column / sizeof *column : ALWAYS); k++)
        if (!(*column[k] = wf_arena_take_unset(a, t->n, sizeof **column[k]))) return false;
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *x = &wf_criteria[c];
        if (c == WF_BREAKAGE || !x->section || !wf_criterion_known(x, t, WF_SCOPE_TREE)) continue;
        b->use[c] = wf_arena_take_unset(a, t->n, sizeof *b->use[c]);
        b->use_place[c] = wf_arena_take_unset(a, t->n, sizeof *b->use_place[c]);
        if (!b->use[c] || !b->use_place[c]) return false;
    }
    return true;
}

/* Section forces and stresses of a row at its ends. */
static void check_ends(struct row *w, struct wf_breakage *b)
{
    size_t i = w->i;
    const struct wf_section_load *s0 = load_at_end(w, 0), *s1 = load_at_end(w, 1);
    b->shear0[i] = s0->shear, b->shear1[i] = s1->shear;
    b->axial0[i] = s0->axial, b->axial1[i] = s1->axial;
    b->bending0[i] = s0->bending, b->bending1[i] = s1->bending;
    b->torsion0[i] = s0->torsion, b->torsion1[i] = s1->torsion;
    b->stress0[i] = s0->stress, b->stress1[i] = s1->stress;
    b->safety0[i] = wf_safety_factor(w->t->strength[i], s0->stress);
    b->safety1[i] = wf_safety_factor(w->t->strength[i], s1->stress);
}

/* Stress and use of a row where they are largest. */
static void check_row(struct row *w, const struct wf_breakage *like, struct wf_breakage *b)
{
    size_t i = w->i;
    if (like)
        b->peak[i] = measure_at(w, NULL, b->peak_place[i] = like->peak_place[i]);
    else
        b->peak[i] = row_peak(w, NULL, &b->peak_place[i]);
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_section_rule *rule = wf_criteria[c].section;
        if (!b->use[c]) continue;
        b->use_place[c][i] = like ? like->use_place[c][i] : 0;
        if (!rule->known(w->t, i))
            b->use[c][i] = NAN;
        else if (like)
            b->use[c][i] = measure_at(w, rule, b->use_place[c][i]);
        else
            b->use[c][i] = row_peak(w, rule, &b->use_place[c][i]);
    }
}

double wf_safety_factor(double strength, double stress)
{
    if (!(strength > 0)) return NAN;
    return stress > 0 ? strength / stress : INFINITY;
}

enum wf_status wf_breakage_check(const struct wf_tree *t, const struct wf_response *r,
                                 const struct wf_breakage *like, struct wf_arena *a, struct wf_breakage *b,
                                 struct wf_err *e)
{
    *b = (struct wf_breakage){ .largest_stress_row = -1 };
    if (r->n != t->n)
        return wf_fail(e, WF_EINTERNAL, "breakage: the answer has %zu segments, the tree %zu", r->n, t->n);
    if (!take_columns(t, !like, b, a))
        return wf_fail(e, WF_ENOMEM, "breakage: not enough memory for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) {
        struct row w;
        begin_row(t, r, i, &w);
        if (!like) check_ends(&w, b);
        check_row(&w, like, b);
        if (b->largest_stress_row < 0 || b->peak[i] > b->largest_stress)
            b->largest_stress = b->peak[i], b->largest_stress_row = (int32_t)i;
    }
    return WF_OK;
}

/* The least rotation that takes one unit vector to another, as a matrix. */
static void least_turn(const double from[3], const double to[3], double R[9])
{
    double axis[3], v[3];
    wf_cross(from, to, axis);
    double sine = sqrt(wf_dot(axis, axis)), angle = atan2(sine, wf_dot(from, to));
    for (int k = 0; k < 3; k++) v[k] = sine > 0 ? angle / sine * axis[k] : 0;
    rotation_matrix(v, R);
}

/* The rotation of the end of row i from the state at rest. */
static void turn_of_end(const struct wf_response *rest, const struct wf_response *r, size_t i, double R[9])
{
    const double *turn = rest->turn + 3 * i, back[3] = { -turn[0], -turn[1], -turn[2] };
    double now[9], inverse[9];
    rotation_matrix(r->turn + 3 * i, now);
    rotation_matrix(back, inverse);
    m3_mul(now, inverse, R);
}

static void take_off(const double R[9], const double *from, double *to)
{
    double turned[3];
    m3_apply(R, from, turned);
    for (int k = 0; k < 3; k++) to[k] -= turned[k];
}

enum wf_status wf_response_change(const struct wf_tree *t, const struct wf_response *rest,
                                  const struct wf_response *r, struct wf_arena *a, struct wf_response *out,
                                  struct wf_err *e)
{
    *out = *r;
    if (r->n != t->n || rest->n != t->n)
        return wf_fail(e, WF_EINTERNAL,
                       "change of stress: the tree has %zu segments, the answers %zu and %zu", t->n, r->n,
                       rest->n);
    double **column[] = { &out->force0, &out->moment0, &out->force1, &out->moment1 };
    for (size_t k = 0; k < sizeof column / sizeof *column; k++) {
        double *own = WF_TAKE(a, 3 * t->n, double);
        if (!own) return wf_fail(e, WF_ENOMEM, "not enough memory for the forces of %zu segments", t->n);
        for (size_t i = 0; i < 3 * t->n; i++) own[i] = (*column[k])[i];
        *column[k] = own;
    }
    for (size_t i = 0; i < t->n; i++) {
        double R[9];
        if (t->parent[i] < 0)
            least_turn(rest->tangent0 + 3 * i, r->tangent0 + 3 * i, R);
        else
            turn_of_end(rest, r, (size_t)t->parent[i], R);
        take_off(R, rest->force0 + 3 * i, out->force0 + 3 * i);
        take_off(R, rest->moment0 + 3 * i, out->moment0 + 3 * i);
        turn_of_end(rest, r, i, R);
        take_off(R, rest->force1 + 3 * i, out->force1 + 3 * i);
        take_off(R, rest->moment1 + 3 * i, out->moment1 + 3 * i);
    }
    return WF_OK;
}
