/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/figures.h"
#include "base/num.h"
#include "base/vec3.h"
#include "load/drag.h"
#include <math.h>

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
    if (below >= 0) { /* the base rides on the parent's end, on a rigid arm where the axes do not meet */
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

/* Place and unit tangent at s in 0..1. */
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

/* Share of the crown's still-air area left in the wind at x. */
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

/* Turn of the axis at the row's end, without twist [rad]. */
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

enum wf_status wf_figures_fill(const struct wf_tree *t, const struct wf_loads *l, const struct wf_response *r,
                               const double direction[3], double crown_drag, struct wf_arena *a,
                               struct wf_figures *out, struct wf_totals *totals, struct wf_err *e)
{
    double **column[] = { &out->projected_area, &out->drag, &out->lift, &out->deflection, &out->slope };
    for (size_t k = 0; k < WF_COUNT(column); k++)
        if (!(*column[k] = WF_TAKE(a, t->n, double)))
            return wf_fail(e, WF_ENOMEM, "no room for the figures of %zu rows", t->n);
    *totals = (struct wf_totals){ 0 };
    for (size_t i = 0; i < t->n; i++) {
        struct curve unloaded, bent;
        struct sums row;
        double across[3];
        curve_unloaded(t, i, &unloaded);
        bent = unloaded;
        if (!r->small_deflection) curve_bent(t, r, i, &bent);
        integrate(t, l, &bent, i, direction, crown_drag, &row);
        /* along the ground the solver's own loads, so that the drag adds up to the base shear */
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
