/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/load.h"
#include "base/vec3.h"
#include "data/species.h"
#include "load/drag.h"
#include <math.h>

const struct wf_laws wf_laws = { .streamlining = { wf_streamline_laws, sizeof *wf_streamline_laws },
                                 .axis_drag = { wf_axis_drag_laws, sizeof *wf_axis_drag_laws } };

void wf_loads_default(struct wf_loads *l)
{
    *l = (struct wf_loads){ .air_density = 1.225,
                            .air_viscosity = 1.4607e-5,
                            .gravity = 9.81,
                            .wind_scale = 1,
                            .weight_scale = 1,
                            .point_scale = 1,
                            .axis_drag = &wf_axis_drag_laws[0] };
}

/* Parameters of a law in the order of its row, from the values of the species. */
static struct wf_law_values law_values_of(const struct wf_law_use *use, const struct wf_law *l)
{
    struct wf_law_values v = { 0 };
    for (size_t k = 0, n = wf_law_count(l); k < n; k++) {
        v.number[k] = use->parameter[k].value;
        if (l->parameter[k].kind != WF_LAW_LIST) continue;
        v.list[k] = use->list[k].v;
        v.n = use->list[k].n;
    }
    return v;
}

enum wf_status wf_loads_laws(struct wf_loads *l, const struct wf_species *sp, struct wf_err *e)
{
    const struct wf_law_use *crown = &sp->streamlining, *axis = &sp->axis_drag;
    if (crown->law) {
        l->streamline = wf_streamline_named(crown->law);
        if (!l->streamline)
            return wf_fail(e, WF_EINPUT, "%s: unknown streamlining law '%s'", sp->key, crown->law);
        l->streamline_par = law_values_of(crown, &l->streamline->law);
    }
    if (axis->law) {
        l->axis_drag = wf_axis_drag_named(axis->law);
        if (!l->axis_drag) return wf_fail(e, WF_EINPUT, "%s: unknown axis drag law '%s'", sp->key, axis->law);
        l->axis_drag_par = law_values_of(axis, &l->axis_drag->law);
    }
    return WF_OK;
}

double *wf_loads_streamline_number(struct wf_loads *l, const char *name)
{
    int k = l->streamline ? wf_law_find(&l->streamline->law, name) : -1;
    return k < 0 ? NULL : &l->streamline_par.number[k];
}

/* The load on one point of an axis and its exact derivatives. They are evaluated at every Gauss point of
 * every element in every iteration, so: no allocation, one square root per speed, no division by a speed
 * that may be zero. */

/* Velocity of the air at a point, and the coefficients k of force = k * velocity. */
struct axis_flow {
    double u[3], du[9];
    double along;             /* U.t [m/s] */
    double across;            /* |Un| [m/s] */
    double n[3], m[3];        /* Un/|Un| and t x Un/|Un|; zero when |Un| = 0 */
    double drag, drag_grow;   /* axis drag / Un [N s/m2], and |Un| d(drag)/d|Un| */
    double lift;              /* lift / (t x Un) [N s/m2]; equals its |Un| d(lift)/d|Un| */
    double crown, crown_grow; /* crown drag / U [N s/m2], and |U| d(crown)/d|U| */
    double e[3];              /* U/|U|; zero in still air */
};

/* unit = v / |v|, zero for a zero vector: every use multiplies it by a force that vanishes with |v|.
 * Returned: |v|. */
static inline double split_direction(const double v[3], double unit[3])
{
    double size = sqrt(wf_dot(v, v)), inverse = size > 0 ? 1 / size : 0;
    for (int i = 0; i < 3; i++) unit[i] = v[i] * inverse;
    return size;
}

static inline void flow_at(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                           const double t[3], struct axis_flow *f)
{
    double un[3], half = 0.5 * l->air_density * l->wind_scale, cd = p->drag, cd_slope = 0, share = 1,
                  share_slope = 0;
    l->wind->sample(l->wind, x, f->u, f->du);
    f->along = wf_dot(f->u, t);
    for (int i = 0; i < 3; i++) un[i] = f->u[i] - f->along * t[i];
    f->across = split_direction(un, f->n);
    wf_cross(t, f->n, f->m);
    double speed = split_direction(f->u, f->e);

    if (isnan(cd))
        cd =
            l->axis_drag->coefficient(&l->axis_drag_par, f->across, p->diameter, l->air_viscosity, &cd_slope);
    double a = half * p->diameter * f->across;
    f->drag = a * cd;
    f->drag_grow = a * (cd + cd_slope * f->across);
    f->lift = a * p->lift;

    if (l->streamline && p->sail > 0) share = l->streamline->share(&l->streamline_par, speed, &share_slope);
    double c = half * p->sail * speed;
    f->crown = c * share;
    f->crown_grow = c * (share + share_slope * speed);
}

void wf_load_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                     const double t[3], struct wf_line_load *out)
{
    *out = (struct wf_line_load){ .force = { 0, 0, -p->mass * l->gravity * l->weight_scale } };
    if (!l->wind) return;
    struct axis_flow f;
    flow_at(l, p, x, t, &f);

    const double T[9] = { 0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0 }; /* t x */
    double varies = 0;
    for (int i = 0; i < 3; i++)
        out->force[i] += f.across * (f.drag * f.n[i] + f.lift * f.m[i]) + f.crown * f.u[i];

    /* d force / dU, times dU / dx. With P = 1 - t t': dUn = P dU, d|Un| = n.dU, d(t x Un) = t x dU. */
    for (int i = 0; i < 9; i++) varies += fabs(f.du[i]);
    if (varies > 0)
        for (int i = 0; i < 3; i++) {
            double by_u[3];
            for (int j = 0; j < 3; j++)
                by_u[j] = (i == j ? f.drag + f.crown : 0) - f.drag * t[i] * t[j] + f.lift * T[3 * i + j] +
                          (f.drag_grow * f.n[i] + f.lift * f.m[i]) * f.n[j] + f.crown_grow * f.e[i] * f.e[j];
            for (int j = 0; j < 3; j++)
                out->by_place[3 * i + j] = by_u[0] * f.du[j] + by_u[1] * f.du[3 + j] + by_u[2] * f.du[6 + j];
        }

    /* Turning the axis by w: dt = w x t, so with b = t x U = |Un| m
     *   dUn = (U.t) t x w - t (b.w),  d|Un| = -(U.t) (m.w),  db = t (U.w) - (U.t) w. */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out->by_turn[3 * i + j] = f.drag * (f.along * T[3 * i + j] - t[i] * f.across * f.m[j]) -
                                      f.drag_grow * f.along * f.n[i] * f.m[j] +
                                      f.lift * (t[i] * f.u[j] - f.along * ((i == j) + f.m[i] * f.m[j]));
}

void wf_load_parts_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                           const double t[3], struct wf_line_parts *out)
{
    *out = (struct wf_line_parts){ .weight = { 0, 0, -p->mass * l->gravity * l->weight_scale } };
    if (!l->wind) return;
    struct axis_flow f;
    flow_at(l, p, x, t, &f);
    for (int i = 0; i < 3; i++) {
        out->drag_axis[i] = f.drag * f.across * f.n[i];
        out->drag_crown[i] = f.crown * f.u[i];
        out->lift[i] = f.lift * f.across * f.m[i];
    }
}
