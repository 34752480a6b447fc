/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/measure.h"
#include "base/num.h"
#include "base/vec3.h"
#include "cases/gusts.h"
#include "data/section.h"
#include "study/prism_check.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Stress inside a row. */

/* Axis direction at a row's base or end: deformed, or undeformed where the response is one of small
 * deflection. */
static void axis_at(const struct wf_tree *t, const struct wf_response *r, size_t row, bool end,
                    double axis[3])
{
    const double *bent = (end ? r->tangent1 : r->tangent0) + 3 * row;
    const double chord[3] = { t->x1[row] - t->x0[row], t->y1[row] - t->y0[row], t->z1[row] - t->z0[row] };
    double size = sqrt(wf_dot(chord, chord));
    for (int k = 0; k < 3; k++) axis[k] = r->small_deflection ? chord[k] / size : bent[k];
}

/* Extreme-fibre bending stress at share s of a row [Pa]. */
static double stress_at(const struct wf_tree *t, const struct wf_response *r, size_t row, double s)
{
    double axis0[3], axis1[3], slope0[3], slope1[3], m[3], axis[3], length = wf_tree_length(t, row);
    axis_at(t, r, row, false, axis0);
    axis_at(t, r, row, true, axis1);
    /* the cubic with the end moments and, from dM/ds = -t x F, the end slopes */
    wf_cross(r->force0 + 3 * row, axis0, slope0);
    wf_cross(r->force1 + 3 * row, axis1, slope1);
    double h00 = (1 + 2 * s) * (1 - s) * (1 - s), h10 = s * (1 - s) * (1 - s), h01 = s * s * (3 - 2 * s),
           h11 = s * s * (s - 1);
    for (size_t k = 0; k < 3; k++) {
        m[k] = h00 * r->moment0[3 * row + k] + h01 * r->moment1[3 * row + k] +
               length * (h10 * slope0[k] + h11 * slope1[k]);
        axis[k] = (1 - s) * axis0[k] + s * axis1[k];
    }
    double outer = wf_between(t->r0[row], t->r1[row], s), inner = wf_between(t->i0[row], t->i1[row], s);
    double twist = wf_dot(m, axis), bending = wf_dot(m, m) - twist * twist / wf_dot(axis, axis);
    return sqrt(fmax(bending, 0.0)) * outer / wf_ring_inertia(outer, inner);
}

/* Largest extreme-fibre bending stress [Pa] inside a row, and its place as a share of the row's length.
 * Between the row's ends the moment is the cubic through the moments and shear forces at them: exact at
 * small deflection for loads per length up to linear. */
static double span_stress(const struct wf_tree *t, const struct wf_response *r, size_t row, double *share)
{
    enum { SAMPLES = 64 };
    const double golden = 0.61803398874989484820;
    size_t best = 0;
    for (size_t i = 1; i <= SAMPLES; i++)
        if (stress_at(t, r, row, (double)i / SAMPLES) > stress_at(t, r, row, (double)best / SAMPLES))
            best = i;
    double a = fmax(0.0, ((double)best - 1) / SAMPLES), b = fmin(1.0, ((double)best + 1) / SAMPLES);
    for (int i = 0; i < 48; i++) { /* golden section down to rounding */
        double left = b - golden * (b - a), right = a + golden * (b - a);
        if (stress_at(t, r, row, left) < stress_at(t, r, row, right))
            a = left;
        else
            b = right;
    }
    double s = 0.5 * (a + b);
    for (int k = 0; k < 2; k++) /* a maximum at an end of the row: take the end itself */
        if (stress_at(t, r, row, k) >= stress_at(t, r, row, s)) s = k;
    *share = s;
    return stress_at(t, r, row, s);
}

/* Potential flow. */

static double or_zero(double v) { return isnan(v) ? 0.0 : v; }

const char *wf_flow_missing(const struct wf_case *c)
{
    if (strcmp(c->flow, "cylinder") == 0)
        return isnan(c->flow_speed) ? "speed" : isnan(c->flow_radius) ? "cylinder_radius" : NULL;
    if (isnan(c->flow_strength)) return "strength";
    return strcmp(c->flow, "finite-line-source") == 0 && isnan(c->flow_segment[0]) ? "segment" : NULL;
}

/* Velocity at the point of the want. Errors: WF_EINPUT inside a cylinder or on a source. */
static enum wf_status measure_velocity(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    const struct wf_case *c = m->of;
    const double *x = w->at.point;
    out[2] = 0.0;
    if (strcmp(c->flow, "cylinder") == 0) {
        if (hypot(x[0], x[1]) < c->flow_radius)
            return wf_fail(e, WF_EINPUT, "%s:%zu: the point lies inside the cylinder", c->file, w->line);
        wf_flow_cylinder(c->flow_speed, c->flow_radius, or_zero(c->flow_circulation), x, out);
    } else if (strcmp(c->flow, "line-source") == 0) {
        wf_flow_line_source(c->flow_strength, x, out);
    } else if (strcmp(c->flow, "point-source") == 0) {
        wf_flow_point_source(c->flow_strength, x, out);
    } else {
        wf_flow_segment_source(c->flow_strength, c->flow_segment[0], c->flow_segment[1], x, out);
    }
    if (!isfinite(out[0] + out[1] + out[2]))
        return wf_fail(e, WF_EINPUT, "%s:%zu: the point lies on the source", c->file, w->line);
    return WF_OK;
}

static enum wf_status measure_pressure_coefficient(const struct wf_measured *m, const struct wf_want *w,
                                                   double out[3], struct wf_err *e)
{
    double u[3];
    if (strcmp(m->of->flow, "cylinder") != 0 || m->of->flow_speed == 0.0)
        return wf_fail(e, WF_EINPUT, "%s:%zu: a pressure coefficient needs a stream: flow cylinder, speed",
                       m->of->file, w->line);
    if (measure_velocity(m, w, u, e)) return e->code;
    out[0] = wf_flow_pressure(m->of->flow_speed, u);
    return WF_OK;
}

/* Static solutions and drag. */

enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    enum wf_status status = solver->solve(&s->tree, &s->loads, &s->options, a, r, &d, e);
    if (status) return status;
    char text[800];
    if (d.errors) return wf_fail(e, WF_EINPUT, "%s", wf_finding_print(d.first, text, sizeof text));
    if (!(r->load_factor >= 1.0))
        return wf_fail(e, WF_EUNSTABLE, "the solver reached only %.4g of the load", r->load_factor);
    return WF_OK;
}

/* Drag of the undeformed tree along the wind [N]: line load integrated with four Gauss points per row (exact
 * for a uniform wind). Errors: WF_EINPUT when there is no wind. */
static enum wf_status rigid_drag(const struct wf_setup *s, double *drag, struct wf_err *e)
{
    static const double place[2] = { 0.33998104358485626480, 0.86113631159405257522 };
    static const double weight[2] = { 0.65214515486254614263, 0.34785484513745385737 };
    const struct wf_tree *t = &s->tree;
    if (!s->loads.wind) return wf_fail(e, WF_EINPUT, "without wind there is no drag to compare with");
    *drag = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double base[3] = { t->x0[i], t->y0[i], t->z0[i] }, end[3] = { t->x1[i], t->y1[i], t->z1[i] }, axis[3],
               x[3];
        double length = wf_tree_length(t, i), chord = 0.0;
        for (int k = 0; k < 3; k++) axis[k] = end[k] - base[k], chord += axis[k] * axis[k];
        for (int k = 0; k < 3; k++) axis[k] /= sqrt(chord);
        for (int g = 0; g < 4; g++) {
            double u = 0.5 * (1.0 + (g % 2 ? 1.0 : -1.0) * place[g / 2]);
            struct wf_line_parts parts;
            struct wf_line_point p = { .diameter = 2.0 * wf_between(t->r0[i], t->r1[i], u),
                                       .drag = t->drag[i] };
            for (int k = 0; k < 3; k++) x[k] = wf_between(base[k], end[k], u);
            wf_load_parts_on_line(&s->loads, &p, x, axis, &parts);
            *drag += 0.5 * weight[g / 2] * length * wf_dot(parts.drag_axis, s->wind.direction);
        }
    }
    return WF_OK;
}

/* Local Vogel exponent d ln F / d ln U - 2 of the base force F along the wind: fourth-order central
 * difference over four runs at U exp(-2h), U exp(-h), U exp(h), U exp(2h), h = 0.01. What their meshes leave
 * is divided by h. Errors: the solver's, WF_EINPUT. */
static enum wf_status local_vogel(const struct wf_setup *s, const struct wf_solver *solver,
                                  struct wf_arena *a, double *v, struct wf_err *e)
{
    static const double step[4] = { -2, -1, 1, 2 }, coefficient[4] = { 1. / 12, -8. / 12, 8. / 12, -1. / 12 };
    const double h = 0.01;
    if (!s->loads.wind) return wf_fail(e, WF_EINPUT, "without wind there is no Vogel exponent");
    *v = -2.0;
    for (int i = 0; i < 4; i++) {
        struct wf_setup other = *s;
        struct wf_response r;
        other.loads.wind = &other.wind;
        other.wind.speed = s->wind.speed * exp(step[i] * h);
        other.options.mesh_tolerance *= 0.1 * h;
        if (wf_setup_solve(&other, solver, a, &r, e)) return e->code;
        double f = wf_dot(r.base_force, s->wind.direction);
        if (!(f > 0.0)) return wf_fail(e, WF_EINPUT, "the force along the wind is not positive");
        *v += coefficient[i] * log(f) / h;
    }
    return WF_OK;
}

/* The quantities, one function per row of wf_quantities. */

static int32_t row_of_want(const struct wf_measured *m, const struct wf_want *w)
{
    return wf_setup_row(m->setup, &w->at);
}

/* Value of a response column at a place; at the base `base`, zero where base is NULL (the base is fixed). */
static void column_at(const double *column, int32_t row, const double *base, double out[3])
{
    for (int k = 0; k < 3; k++) out[k] = row >= 0 ? column[3 * row + k] : base ? base[k] : 0.0;
}

static enum wf_status measure_displacement(const struct wf_measured *m, const struct wf_want *w,
                                           double out[3], struct wf_err *e)
{
    (void)e;
    column_at(m->response->end, row_of_want(m, w), NULL, out);
    return WF_OK;
}

static enum wf_status measure_position(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    int32_t i = row_of_want(m, w);
    (void)e;
    column_at(m->response->end, i, NULL, out);
    const double *const x[3] = { i < 0 ? t->x0 : t->x1, i < 0 ? t->y0 : t->y1, i < 0 ? t->z0 : t->z1 };
    for (int k = 0; k < 3; k++) out[k] += x[k][i < 0 ? 0 : i];
    return WF_OK;
}

static enum wf_status measure_rotation(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    (void)e;
    column_at(m->response->turn, row_of_want(m, w), NULL, out);
    return WF_OK;
}

static enum wf_status measure_force(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                    struct wf_err *e)
{
    (void)e;
    column_at(m->response->force1, row_of_want(m, w), m->response->base_force, out);
    return WF_OK;
}

static enum wf_status measure_moment(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                     struct wf_err *e)
{
    (void)e;
    column_at(m->response->moment1, row_of_want(m, w), m->response->base_moment, out);
    return WF_OK;
}

static enum wf_status measure_stress(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                     struct wf_err *e)
{
    int32_t i = row_of_want(m, w);
    (void)e;
    out[0] = stress_at(&m->setup->tree, m->response, i < 0 ? 0 : (size_t)i, i < 0 ? 0.0 : 1.0);
    return WF_OK;
}

/* Largest stress of the whole tree [Pa] and its distance from the base of a single axis, as share of its
 * length. */
static double largest_stress(const struct wf_measured *m, double *place)
{
    const struct wf_tree *t = &m->setup->tree;
    double best = -1.0, at = 0.0, length = 0.0, share;
    for (size_t i = 0; i < t->n; i++) {
        double s = span_stress(t, m->response, i, &share), own = wf_tree_length(t, i);
        if (s > best) best = s, at = length + share * own;
        length += own;
    }
    *place = at / length;
    return best;
}

static enum wf_status measure_max_stress(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                         struct wf_err *e)
{
    double place;
    (void)w, (void)e;
    out[0] = largest_stress(m, &place);
    return WF_OK;
}

static enum wf_status measure_max_stress_place(const struct wf_measured *m, const struct wf_want *w,
                                               double out[3], struct wf_err *e)
{
    (void)w;
    if (m->of->shape == WF_SHAPE_BRANCHES || m->of->shape == WF_SHAPE_TREE)
        return wf_fail(e, WF_EINPUT, "max_stress_position is a share of the length of a cantilever or arc");
    (void)largest_stress(m, out);
    return WF_OK;
}

/* Largest and mean displacement of the ends of rows that carry no other row [m]. */
static enum wf_status tip_displacements(const struct wf_measured *m, double *largest, double *mean,
                                        struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    bool *carries = WF_TAKE(m->arena, t->n, bool);
    size_t count = 0;
    if (!carries) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < t->n; i++)
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
    *largest = *mean = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        const double *u = m->response->end + 3 * i;
        if (carries[i]) continue;
        *largest = fmax(*largest, sqrt(wf_dot(u, u)));
        *mean += sqrt(wf_dot(u, u));
        count++;
    }
    *mean /= (double)count;
    return WF_OK;
}

static enum wf_status measure_max_tip(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                      struct wf_err *e)
{
    double mean;
    (void)w;
    return tip_displacements(m, out, &mean, e);
}

static enum wf_status measure_mean_tip(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    double largest;
    (void)w;
    return tip_displacements(m, &largest, out, e);
}

static enum wf_status measure_reconfiguration(const struct wf_measured *m, const struct wf_want *w,
                                              double out[3], struct wf_err *e)
{
    (void)w;
    double rigid = 0;
    if (rigid_drag(m->setup, &rigid, e)) return e->code;
    out[0] = wf_dot(m->response->base_force, m->setup->wind.direction) / rigid;
    return WF_OK;
}

static enum wf_status measure_vogel(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                    struct wf_err *e)
{
    (void)w;
    return local_vogel(m->setup, m->solver, m->arena, out, e);
}

static enum wf_status measure_bending_stiffness(const struct wf_measured *m, const struct wf_want *w,
                                                double out[3], struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    int32_t i = row_of_want(m, w);
    (void)e;
    double r = i < 0 ? t->r0[0] : t->r1[i], q = i < 0 ? t->i0[0] : t->i1[i];
    out[0] = t->stiff ? t->stiff[4 * (i < 0 ? 0 : i) + 2] : t->youngs[i < 0 ? 0 : i] * wf_ring_inertia(r, q);
    return WF_OK;
}

static enum wf_status measure_imbalance(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                        struct wf_err *e)
{
    (void)w, (void)e;
    out[0] = m->response->imbalance;
    return WF_OK;
}

static enum wf_status measure_frequency(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                        struct wf_err *e)
{
    (void)e;
    out[0] = m->frequency[w->number - 1];
    return WF_OK;
}

static enum wf_status measure_angular_frequency(const struct wf_measured *m, const struct wf_want *w,
                                                double out[3], struct wf_err *e)
{
    (void)e;
    out[0] = 2.0 * WF_PI * m->frequency[w->number - 1];
    return WF_OK;
}

static enum wf_status measure_buckling(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    (void)w, (void)e;
    out[0] = m->buckling_factor;
    return WF_OK;
}

/* A uniform cantilever as a chain of w->number prisms, under the forces and moments at its tip. */
static enum wf_status prisms(const struct wf_measured *m, const struct wf_want *w,
                             struct wf_prism_answer *out, struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    const struct wf_case_load *load = m->of->loads.data;
    const double axis[3] = { t->x1[0] - t->x0[0], t->y1[0] - t->y0[0], t->z1[0] - t->z0[0] };
    struct wf_prism_rod rod = { .length = m->of->length, .radius = t->r0[0], .youngs = t->youngs[0] };
    double sum[2] = { 0 }, length = sqrt(wf_dot(axis, axis));
    rod.shear = t->shear[0], rod.density = t->density[0];
    if (m->of->shape != WF_SHAPE_CANTILEVER || t->r1[t->n - 1] < t->r0[0] || t->i0[0] > 0 || t->stiff)
        return wf_fail(e, WF_EINPUT, "%s:%zu: prisms are of a uniform solid cantilever", m->of->file,
                       w->line);
    for (size_t i = 0; i < m->of->loads.n; i++) {
        double along = wf_dot(load[i].value, axis) / length;
        double across = sqrt(fmax(0, wf_dot(load[i].value, load[i].value) - along * along));
        if (load[i].at.kind != WF_PLACE_TIP ||
            fabs(load[i].moment ? across : along) > 1e-12 * (across + along))
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: prisms take a force across and a moment about the axis, at the tip",
                           m->of->file, load[i].line);
        sum[load[i].moment] += load[i].moment ? along : across;
    }
    return wf_prism_cantilever(&rod, w->number, sum[0], sum[1], m->arena, out, e);
}

static enum wf_status measure_prism(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                    struct wf_err *e)
{
    struct wf_prism_answer a = { 0 };
    enum wf_status s = prisms(m, w, &a, e);
    const char *name = w->quantity->name;
    out[0] = !strcmp(name, "prism_deflection") ? a.tip : !strcmp(name, "prism_twist") ? a.turn : a.frequency;
    return s;
}

static enum wf_status measure_gust(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                   struct wf_err *e)
{
    (void)e;
    wf_gust_answer(m->of, w->quantity->name, out);
    return WF_OK;
}

static enum wf_status measure_stand(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                    struct wf_err *e)
{
    return wf_stand_answer(m->of, m->setup, w->quantity->name, m->arena, out, e);
}

const struct wf_quantity wf_quantities[] = {
    { "displacement", WF_DIM_LENGTH, true, WF_NEED_PLACE, WF_BY_SOLVER, measure_displacement },
    { "position", WF_DIM_LENGTH, true, WF_NEED_PLACE, WF_BY_SOLVER, measure_position },
    { "rotation", WF_DIM_ANGLE, true, WF_NEED_PLACE, WF_BY_SOLVER, measure_rotation },
    { "force", WF_DIM_FORCE, true, WF_NEED_PLACE, WF_BY_SOLVER, measure_force },
    { "moment", WF_DIM_MOMENT, true, WF_NEED_PLACE, WF_BY_SOLVER, measure_moment },
    { "stress", WF_DIM_PRESSURE, false, WF_NEED_PLACE, WF_BY_SOLVER, measure_stress },
    { "max_stress", WF_DIM_PRESSURE, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_max_stress },
    { "max_stress_position", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_max_stress_place },
    { "max_tip_displacement", WF_DIM_LENGTH, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_max_tip },
    { "mean_tip_displacement", WF_DIM_LENGTH, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_mean_tip },
    { "reconfiguration_number", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_reconfiguration },
    { "vogel_exponent", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_vogel },
    { "imbalance", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, measure_imbalance },
    { "bending_stiffness", WF_DIM_BENDING_STIFFNESS, false, WF_NEED_PLACE, WF_BY_SETUP,
      measure_bending_stiffness },
    { "frequency", WF_DIM_FREQUENCY, false, WF_NEED_NUMBER, WF_BY_MODES, measure_frequency },
    { "angular_frequency", WF_DIM_FREQUENCY, false, WF_NEED_NUMBER, WF_BY_MODES, measure_angular_frequency },
    { "buckling_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_BUCKLING, measure_buckling },
    { "prism_deflection", WF_DIM_LENGTH, false, WF_NEED_NUMBER, WF_BY_SETUP, measure_prism },
    { "prism_twist", WF_DIM_ANGLE, false, WF_NEED_NUMBER, WF_BY_SETUP, measure_prism },
    { "prism_frequency", WF_DIM_FREQUENCY, false, WF_NEED_NUMBER, WF_BY_SETUP, measure_prism },
    { "velocity", WF_DIM_SPEED, true, WF_NEED_POINT, WF_BY_FLOW, measure_velocity },
    { "pressure_coefficient", WF_DIM_NONE, false, WF_NEED_POINT, WF_BY_FLOW, measure_pressure_coefficient },
    { "gust_background", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "gust_resonance", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "gust_peak_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "gust_load_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "structural_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "pressure_ratio", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_GUST, measure_gust },
    { "critical_wind", WF_DIM_SPEED, false, WF_NEED_NOTHING, WF_BY_STAND, measure_stand },
    { "stand_gust_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_STAND, measure_stand },
    { "peak_base_moment", WF_DIM_MOMENT, false, WF_NEED_NOTHING, WF_BY_STAND, measure_stand },
    { "fitted_modulus", WF_DIM_PRESSURE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "fitted_stiffness", WF_DIM_ROTATIONAL_STIFFNESS, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "fitted_number", WF_DIM_NONE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "intervals_that_cover", WF_DIM_NONE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { .name = NULL },
};

/* Reading and printing what is wanted. */

bool wf_place_read(struct wf_words *w, struct wf_place *p)
{
    static const char *const known[] = { "base", "tip", "node", "row", "at" };
    size_t kind;
    long long id;
    *p = (struct wf_place){ .row = -1 };
    if (!wf_words_choice(w, "place", known, WF_COUNT(known), &kind)) return false;
    p->kind =
        (enum wf_place_kind[]){ WF_PLACE_BASE, WF_PLACE_TIP, WF_PLACE_NODE, WF_PLACE_ROW, WF_PLACE_AT }[kind];
    if (p->kind == WF_PLACE_NODE || p->kind == WF_PLACE_ROW) {
        if (!wf_words_whole(w, "node or row id", 0, INT64_MAX, &id)) return false;
        p->id = id;
    }
    if (p->kind == WF_PLACE_AT) {
        if (!wf_words_number(w, "share of the length", &p->share)) return false;
        if (p->share < 0.0 || p->share > 1.0)
            return wf_words_wrong(w, w->next - 1, "a share of the length must be in 0..1, not %g", p->share);
    }
    return true;
}

static bool quantity_read(struct wf_words *w, const struct wf_quantity **q)
{
    const char *names[64];
    size_t n = 0, k;
    while (n < 64 && wf_quantities[n].name) names[n] = wf_quantities[n].name, n++;
    if (!wf_words_choice(w, "quantity", names, n, &k)) return false;
    *q = &wf_quantities[k];
    return true;
}

static bool where_read(struct wf_words *w, struct wf_want *want)
{
    long long number;
    size_t n;
    switch (want->quantity->need) {
    case WF_NEED_NOTHING:
        return true;
    case WF_NEED_PLACE:
        return wf_place_read(w, &want->at);
    case WF_NEED_NUMBER:
        if (!wf_words_whole(w, "number of the mode", 1, 1000, &number)) return false;
        want->number = (size_t)number;
        return true;
    case WF_NEED_NAME:
        if (!wf_words_peek(w)) return wf_words_wrong(w, w->n, "the name of a fitted parameter is expected");
        want->name = w->word[w->next++];
        return true;
    case WF_NEED_POINT:
        break;
    }
    want->at.kind = WF_PLACE_POINT;
    for (n = 0; n < 3; n++)
        if (!wf_words_number(w, "coordinate of the point", &want->at.point[n])) return false;
    return true;
}

static bool tolerance_read(struct wf_words *w, struct wf_want *want)
{
    size_t at = w->next;
    want->tolerance = NAN;
    if (!wf_words_skip(w, "within")) return true;
    want->absolute = wf_words_skip(w, "absolute");
    if (!wf_words_number(w, "tolerance", &want->tolerance)) return false;
    if (want->tolerance <= 0.0) return wf_words_wrong(w, w->next - 1, "a tolerance must be positive");
    if (want->absolute) want->tolerance *= want->unit_factor;
    if (!want->absolute && want->tolerance > 0.5)
        return wf_words_wrong(w, at, "a relative tolerance must not exceed 0.5");
    return true;
}

/* A relative tolerance needs a wanted value other than zero. */
static bool tolerance_fits(struct wf_words *w, const struct wf_want *want)
{
    double size = 0.0;
    for (int i = 0; i < 3; i++)
        if (!isnan(want->value[i])) size += fabs(want->value[i]);
    if (size > 0.0 || want->absolute) return true;
    return wf_words_wrong(w, w->n, "the wanted value is zero: write 'within absolute TOLERANCE'");
}

static bool unit_read(struct wf_words *w, struct wf_want *want)
{
    struct wf_err e = { WF_OK, "" };
    want->unit_factor = 1.0;
    if (!*want->unit) return true;
    const char *one = wf_arena_print(w->arena, "1 %s", want->unit);
    if (!one || wf_quantity_read(w->units, one, want->quantity->dimension, &want->unit_factor, &e))
        return wf_words_wrong(w, w->n, "%s", one ? e.text : "no memory");
    return true;
}

bool wf_want_read(struct wf_words *w, struct wf_want *want)
{
    static const char *const component[] = { "x", "y", "z", "norm" };
    *want = (struct wf_want){ .line = w->line, .component = 0, .value = { NAN, NAN, NAN } };
    if (!quantity_read(w, &want->quantity) || !where_read(w, want)) return false;
    size_t low = 1, at = w->next, count;
    if (want->quantity->vector) {
        want->component = -1;
        for (int k = 0; k < 4 && want->component < 0; k++)
            if (wf_words_skip(w, component[k])) want->component = k;
        if (want->component < 0) low = 3;
        if (low == 3 && !(wf_words_peek(w) && strchr("+-.0123456789", *wf_words_peek(w))))
            return wf_words_wrong(w, at, "a vector needs three values, or x, y, z or norm and one value");
    }
    if (!wf_words_quantities(w, want->quantity->dimension, low, low, low == 3, "within", want->value, &count,
                             &want->unit) ||
        !unit_read(w, want) || !tolerance_read(w, want))
        return false;
    if (low == 3 && isnan(want->value[0]) && isnan(want->value[1]) && isnan(want->value[2]))
        return wf_words_wrong(w, at, "no value is wanted");
    return tolerance_fits(w, want) && wf_words_end(w);
}

void wf_want_print(const struct wf_want *w, int component, char *buf, size_t size)
{
    static const char *const axis[] = { " x", " y", " z", " norm" };
    char at[128] = "";
    switch (w->at.kind) {
    case WF_PLACE_NONE:
        break;
    case WF_PLACE_BASE:
        (void)snprintf(at, sizeof at, " base");
        break;
    case WF_PLACE_TIP:
        (void)snprintf(at, sizeof at, " tip");
        break;
    case WF_PLACE_NODE:
        (void)snprintf(at, sizeof at, " node %lld", (long long)w->at.id);
        break;
    case WF_PLACE_ROW:
        (void)snprintf(at, sizeof at, " row %lld", (long long)w->at.id);
        break;
    case WF_PLACE_AT:
        (void)snprintf(at, sizeof at, " at %g", w->at.share);
        break;
    case WF_PLACE_POINT:
        (void)snprintf(at, sizeof at, " %g %g %g", w->at.point[0], w->at.point[1], w->at.point[2]);
    }
    if (w->name) (void)snprintf(at, sizeof at, " %s", w->name);
    if (w->number) (void)snprintf(at, sizeof at, " %zu", w->number);
    (void)snprintf(buf, size, "%s%s%s", w->quantity->name, at, w->quantity->vector ? axis[component] : "");
}
