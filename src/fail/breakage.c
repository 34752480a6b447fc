/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/vec3.h"
#include "data/section.h"
#include "fail/fail.h"
#include <math.h>

/* Forces and moments on a section, split along and across its axis, and its outer-fibre stress. */
struct section_load {
    double shear, axial, bending, torsion, stress;
};

static struct section_load section_load_at(const double force[3], const double moment[3],
                                           const double axis[3], double outer, double inner)
{
    struct section_load s = { .axial = wf_dot(force, axis), .torsion = wf_dot(moment, axis) };
    double v[3], m[3];
    for (int k = 0; k < 3; k++) v[k] = force[k] - s.axial * axis[k], m[k] = moment[k] - s.torsion * axis[k];
    s.shear = sqrt(wf_dot(v, v));
    s.bending = sqrt(wf_dot(m, m));
    s.stress = s.bending * outer / wf_ring_inertia(outer, inner) + fabs(s.axial) / wf_ring_area(outer, inner);
    return s;
}

/* Stress at s (0..1) of row i: moment by the cubic through both ends, the rest linear. */
static double stress_inside(const struct wf_tree *t, const struct wf_response *r, size_t i, double s)
{
    double length = wf_tree_length(t, i), left = 1 - s, force[3], moment[3], axis[3], slope0[3], slope1[3];
    const double *f0 = r->force0 + 3 * i, *f1 = r->force1 + 3 * i, *t0 = r->tangent0 + 3 * i,
                 *t1 = r->tangent1 + 3 * i;
    wf_cross(f0, t0, slope0); /* dM/ds = -t x F */
    wf_cross(f1, t1, slope1);
    for (size_t k = 0; k < 3; k++) {
        force[k] = left * f0[k] + s * f1[k];
        axis[k] = left * t0[k] + s * t1[k];
        moment[k] = left * left * (1 + 2 * s) * r->moment0[3 * i + k] +
                    s * s * (3 - 2 * s) * r->moment1[3 * i + k] +
                    length * s * left * (left * slope0[k] - s * slope1[k]);
    }
    double size = sqrt(wf_dot(axis, axis));
    if (!(size > 0)) return 0; /* the two end tangents cancel: only the ends of this row count */
    for (int k = 0; k < 3; k++) axis[k] /= size;
    return section_load_at(force, moment, axis, left * t->r0[i] + s * t->r1[i],
                           left * t->i0[i] + s * t->i1[i])
        .stress;
}

/* Largest stress of row i and its place: one of its ends, unless the stress rises inwards from both. In that
 * case a grid of sixteenths is refined three times around its best point. */
static double row_peak(const struct wf_tree *t, const struct wf_response *r, size_t i, double stress0,
                       double stress1, double *place)
{
    enum { GRID = 16, ROUNDS = 4 };
    const double near = 1.0 / 64;
    double best = fmax(stress0, stress1), low = 0, high = 1;
    *place = stress1 > stress0 ? 1 : 0;
    if (!(stress_inside(t, r, i, near) > stress0 && stress_inside(t, r, i, 1 - near) > stress1)) return best;
    for (int round = 0; round < ROUNDS; round++) {
        double step = (high - low) / GRID;
        for (int k = 1; k < GRID; k++) {
            double s = low + k * step, stress = stress_inside(t, r, i, s);
            if (stress > best) best = stress, *place = s;
        }
        low = fmax(0, *place - step), high = fmin(1, *place + step);
    }
    return best;
}

static double safety_factor(double strength, double stress)
{
    if (!(strength > 0)) return NAN;
    return stress > 0 ? strength / stress : INFINITY;
}

static bool take_columns(struct wf_breakage *b, size_t n, struct wf_arena *a)
{
    double **column[] = { &b->shear0,   &b->shear1,   &b->axial0,   &b->axial1,    &b->bending0,
                          &b->bending1, &b->torsion0, &b->torsion1, &b->stress0,   &b->stress1,
                          &b->safety0,  &b->safety1,  &b->peak,     &b->peak_place };
    b->n = n;
    for (size_t k = 0; k < sizeof column / sizeof *column; k++)
        if (!(*column[k] = WF_TAKE(a, n, double))) return false;
    return true;
}

/* Stress at a place of row i that is known. */
static double stress_at(const struct wf_tree *t, const struct wf_response *r, size_t i, double stress0,
                        double stress1, double place)
{
    if (place <= 0) return stress0;
    return place >= 1 ? stress1 : stress_inside(t, r, i, place);
}

enum wf_status wf_breakage_check(const struct wf_tree *t, const struct wf_response *r, const double *places,
                                 struct wf_arena *a, struct wf_breakage *b, struct wf_err *e)
{
    *b = (struct wf_breakage){ .largest_stress_row = -1 };
    if (r->n != t->n)
        return wf_fail(e, WF_EINTERNAL, "breakage: the answer has %zu segments, the tree %zu", r->n, t->n);
    if (!take_columns(b, t->n, a))
        return wf_fail(e, WF_ENOMEM, "breakage: not enough memory for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) {
        struct section_load s0 =
            section_load_at(r->force0 + 3 * i, r->moment0 + 3 * i, r->tangent0 + 3 * i, t->r0[i], t->i0[i]);
        struct section_load s1 =
            section_load_at(r->force1 + 3 * i, r->moment1 + 3 * i, r->tangent1 + 3 * i, t->r1[i], t->i1[i]);
        b->shear0[i] = s0.shear, b->shear1[i] = s1.shear;
        b->axial0[i] = s0.axial, b->axial1[i] = s1.axial;
        b->bending0[i] = s0.bending, b->bending1[i] = s1.bending;
        b->torsion0[i] = s0.torsion, b->torsion1[i] = s1.torsion;
        b->stress0[i] = s0.stress, b->stress1[i] = s1.stress;
        b->safety0[i] = safety_factor(t->strength[i], s0.stress);
        b->safety1[i] = safety_factor(t->strength[i], s1.stress);

        if (places)
            b->peak[i] = stress_at(t, r, i, s0.stress, s1.stress, b->peak_place[i] = places[i]);
        else
            b->peak[i] = row_peak(t, r, i, s0.stress, s1.stress, &b->peak_place[i]);
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

bool wf_breakage_known(const struct wf_tree *t, size_t row) { return t->strength[row] > 0; }

double wf_breakage_safety(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                          size_t row, double *place)
{
    (void)r;
    *place = b->peak_place[row];
    return safety_factor(t->strength[row], b->peak[row]);
}
