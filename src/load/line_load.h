/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_LINE_LOAD_H
#define WF_LOAD_LINE_LOAD_H
/* The load on one point of an axis and its exact derivatives, for a double or for many lanes (base/real.h).
 * They are evaluated at every Gauss point of every element in every iteration, so: no allocation, one square
 * root per speed, no division by a speed that may be zero. */
#include "base/vec3.h"
#include "load/drag.h"
#include "load/load.h"
#include "wind/wind_kernel.h"

/* struct wf_line_load of a real */
#if WF_WIDTH == 1
#define real_load wf_line_load
#else
struct real_load {
    real force[3], by_place[9], by_turn[9];
};
#endif

/* Velocity of the air at a point, and the coefficients k of force = k * velocity. */
struct axis_flow {
    real u[3], du[9];
    real along;             /* U.t [m/s] */
    real across;            /* |Un| [m/s] */
    real speed;             /* |U| [m/s] */
    real n[3], m[3];        /* Un/|Un| and t x Un/|Un|; zero when |Un| = 0 */
    real e[3];              /* U/|U|; zero in still air */
    real drag, drag_grow;   /* axis drag / Un [N s/m2], and |Un| d(drag)/d|Un| */
    real lift;              /* lift / (t x Un) [N s/m2]; equals its |Un| d(lift)/d|Un| */
    real crown, crown_grow; /* crown drag / U [N s/m2], and |U| d(crown)/d|U| */
};

/* unit = v / |v|, zero for a zero vector: every use multiplies it by a force that vanishes with |v|.
 * Returned: |v|. */
WF_INLINE real split_direction(const real v[3], real unit[3])
{
    real size = real_sqrt(wf_dot(v, v)),
         inverse = real_choose(real_below(real_of(0), size), 1 / size, real_of(0));
    for (int i = 0; i < 3; i++) unit[i] = v[i] * inverse;
    return size;
}

/* Speeds and directions of the air that passes an axis. Given: u and du of *f; unit tangent t. */
WF_INLINE void flow_past(const real t[3], struct axis_flow *f)
{
    real un[3];
    f->along = wf_dot(f->u, t);
    for (int i = 0; i < 3; i++) un[i] = f->u[i] - f->along * t[i];
    f->across = split_direction(un, f->n);
    wf_cross(t, f->n, f->m);
    f->speed = split_direction(f->u, f->e);
}

/* Forces by coefficients. Given: diameter, lift and sail of the point; half the air's density; drag
 * coefficient of the axis and share of the crown's drag area, with their derivatives by speed; *f after
 * flow_past. */
WF_INLINE void flow_forces(real diameter, real lift, real sail, real half, real cd, real cd_slope, real share,
                           real share_slope, struct axis_flow *f)
{
    real a = half * diameter * f->across, c = half * sail * f->speed;
    f->drag = a * cd;
    f->drag_grow = a * (cd + cd_slope * f->across);
    f->lift = a * lift;
    f->crown = c * share;
    f->crown_grow = c * (share + share_slope * f->speed);
}

/* Add the force of the air, and set its derivatives. varies: du is not zero. */
WF_INLINE void flow_load(const struct axis_flow *f, const real t[3], int varies, struct real_load *out)
{
    const real T[9] = { real_of(0), -t[2], t[1], t[2], real_of(0), -t[0], -t[1], t[0], real_of(0) }; /* t x */
    for (int i = 0; i < 3; i++)
        out->force[i] += f->across * (f->drag * f->n[i] + f->lift * f->m[i]) + f->crown * f->u[i];

    /* d force / dU, times dU / dx. With P = 1 - t t': dUn = P dU, d|Un| = n.dU, d(t x Un) = t x dU. */
    if (varies)
        for (int i = 0; i < 3; i++) {
            real by_u[3];
            for (int j = 0; j < 3; j++) {
                by_u[j] = f->lift * T[3 * i + j] - f->drag * t[i] * t[j] +
                          (f->drag_grow * f->n[i] + f->lift * f->m[i]) * f->n[j] +
                          f->crown_grow * f->e[i] * f->e[j];
                if (i == j) by_u[j] += f->drag + f->crown;
            }
            for (int j = 0; j < 3; j++)
                out->by_place[3 * i + j] =
                    by_u[0] * f->du[j] + by_u[1] * f->du[3 + j] + by_u[2] * f->du[6 + j];
        }

    /* Turning the axis by w: dt = w x t, so with b = t x U = |Un| m
     *   dUn = (U.t) t x w - t (b.w),  d|Un| = -(U.t) (m.w),  db = t (U.w) - (U.t) w. */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            real lift = t[i] * f->u[j] - f->along * (f->m[i] * f->m[j]);
            if (i == j) lift -= f->along;
            out->by_turn[3 * i + j] = f->drag * (f->along * T[3 * i + j] - t[i] * f->across * f->m[j]) -
                                      f->drag_grow * f->along * f->n[i] * f->m[j] + f->lift * lift;
        }
}

/* How the force of the air changes with its speed and density, which grow by these shares. */
WF_INLINE void flow_growth(const struct axis_flow *f, real speed, real density, real change[3])
{
    const real drag = f->across * (speed * (f->drag + f->drag_grow) + density * f->drag),
               lift = f->across * (2 * speed + density) * f->lift,
               crown = speed * (f->crown + f->crown_grow) + density * f->crown;
    for (int i = 0; i < 3; i++) change[i] = drag * f->n[i] + lift * f->m[i] + crown * f->u[i];
}

/* Many lanes at once, which differ in wind and air. Wind fields and laws without a formula for lanes are
 * evaluated for one lane after the other. */

/* Wind, air and weight of the lanes. */
struct air {
    const struct wf_loads *loads[WF_WIDTH];
    enum wf_profile_form profile;
    enum wf_share_form crown;
    enum wf_drag_form axis;
    bool blows; /* in some lane */
    real speed, direction[3], reference, exponent, displacement, roughness, least, scale;
    real half;                         /* density / 2 */
    real viscosity, vogel, vogel_from; /* of the laws */
    real held;                         /* speed above which the crown's share is held */
    real weight, dead;                 /* factors of weight and of dead loads */
    const struct wf_law_values *table;
    real grows_speed, grows_density; /* shares by which they grow (flow_growth) */
    size_t rises;                    /* slopes of the table's points, if it has few */
    double rise[64];
};

/* Given: the loads of each lane. */
static inline void set_air(const struct wf_loads *const *loads, struct air *a)
{
    const struct wf_loads *first = loads[0];
    size_t n = 0;
    *a =
        (struct air){ .profile = WF_PROFILE_UNIFORM, .crown = WF_SHARE_NONE, .axis = first->axis_drag->form };
    for (int k = WF_WIDTH; k-- > 0;)
        if (loads[k]->wind) first = loads[k], a->blows = true;
    if (a->blows) a->profile = wf_wind_form(first->wind);
    if (first->streamline) a->crown = first->streamline->form;
    a->table = &first->streamline_par;
    for (int k = 0; k < WF_WIDTH; k++) {
        const struct wf_loads *l = loads[k];
        const struct wf_wind *w = l->wind ? l->wind : first->wind;
        a->loads[k] = l;
        real_lane(a->weight, k) = l->gravity * l->weight_scale, real_lane(a->dead, k) = l->point_scale;
        real_lane(a->viscosity, k) = l->air_viscosity;
        if (!w) continue;
        if (l->streamline != first->streamline) a->crown = WF_SHARE_BY_CALL;
        if (a->crown == WF_SHARE_TABLE &&
            memcmp(l->streamline_par.list, a->table->list, sizeof a->table->list))
            a->crown = WF_SHARE_BY_CALL;
        if (l->axis_drag != first->axis_drag) a->axis = WF_DRAG_BY_CALL;
        enum wf_profile_form form = wf_wind_form(w);
        if (form == WF_PROFILE_OTHER || (form != a->profile && a->profile != WF_PROFILE_OTHER))
            a->profile = form == WF_PROFILE_OTHER ? form : WF_PROFILE_BY_CALL;
        real_lane(a->vogel, k) = l->streamline_par.number[0],
                            real_lane(a->vogel_from, k) = l->streamline_par.number[1];
        real_lane(a->held, k) = l->streamline_par.held > 0 ? l->streamline_par.held : INFINITY;
        real_lane(a->half, k) = l->wind ? 0.5 * l->air_density * l->wind_scale : 0;
        real_lane(a->speed, k) = l->wind ? w->speed : 0;
        for (int i = 0; i < 3; i++) real_lane(a->direction[i], k) = w->direction[i];
        real_lane(a->reference, k) = w->reference_height, real_lane(a->exponent, k) = w->exponent;
        real_lane(a->displacement, k) = w->displacement, real_lane(a->roughness, k) = w->roughness;
        real_lane(a->least, k) = w->least;
    }
    if (a->crown == WF_SHARE_TABLE && a->table->n <= sizeof a->rise / sizeof *a->rise)
        for (a->rises = a->table->n; n < a->rises; n++)
            a->rise[n] = wf_smooth_slope(a->table->list[0], a->table->list[1], a->rises, n);
    if (a->profile >= WF_PROFILE_TERRAIN) a->reference = real_max(a->reference, a->least);
    if (a->profile == WF_PROFILE_LOG)
        a->scale = log_profile_scale(a->speed, a->reference, a->displacement, a->roughness);
    else if (a->profile == WF_PROFILE_TERRAIN)
        a->scale = log_profile_scale(a->speed, a->reference, real_of(0), a->roughness);
}

/* The wind lane by lane. */
static __attribute__((noinline, unused)) void sample_each(const struct air *a, const real x[3], real u[3],
                                                          real du[9])
{
    for (int k = 0; k < WF_WIDTH; k++) {
        double at[3], v[3] = { 0, 0, 0 }, slope[9] = { 0 };
        const struct wf_wind *w = a->loads[k]->wind;
        for (int i = 0; i < 3; i++) at[i] = real_lane(x[i], k);
        if (w) w->sample(w, at, v, slope);
        for (int i = 0; i < 3; i++) real_lane(u[i], k) = v[i];
        for (int i = 0; i < 9; i++) real_lane(du[i], k) = slope[i];
    }
}

WF_INLINE void sample_lanes(const struct air *a, const real x[3], real u[3], real du[9])
{
    real speed = a->speed, slope = { 0 };
    if (a->profile <= WF_PROFILE_BY_CALL) {
        sample_each(a, x, u, du);
        return;
    }
    if (a->profile == WF_PROFILE_LOG)
        speed = log_profile(a->scale, a->displacement, a->roughness, x[2], &slope);
    else if (a->profile == WF_PROFILE_POWER)
        speed = power_profile(a->speed, a->reference, a->exponent, x[2], &slope);
    else if (a->profile == WF_PROFILE_TERRAIN)
        speed = terrain_profile(a->scale, a->roughness, a->least, x[2], &slope);
    else if (a->profile == WF_PROFILE_FLOOR)
        speed = floor_profile(a->speed, a->reference, a->exponent, a->least, x[2], &slope);
    for (int i = 0; i < 3; i++) {
        u[i] = speed * a->direction[i];
        du[3 * i] = du[3 * i + 1] = real_of(0);
        du[3 * i + 2] = slope * a->direction[i];
    }
}

static __attribute__((noinline, unused)) void share_each(const struct air *a, const real *speed, real *share,
                                                         real *slope)
{
    for (int k = 0; k < WF_WIDTH; k++) {
        const struct wf_loads *l = a->loads[k];
        double by = 0, at = real_lane(*speed, k);
        real_lane(*share, k) =
            l->streamline ? wf_streamline_share(l->streamline, &l->streamline_par, at, &by) : 1;
        real_lane(*slope, k) = by;
    }
}

WF_INLINE real crown_share(const struct air *a, real speed, real *slope)
{
    real share = real_of(1), by = real_of(0);
    real_truth held = real_below(a->held, speed);
    real at = real_choose(held, a->held, speed);
    if (a->crown == WF_SHARE_VOGEL)
        share = vogel_share(a->vogel, a->vogel_from, at, &by);
    else if (a->crown == WF_SHARE_TABLE)
        share = table_share(a->table, a->rises ? a->rise : NULL, at, &by);
    else if (a->crown == WF_SHARE_BY_CALL)
        share_each(a, &at, &share, &by);
    *slope = real_choose(held, real_of(0), by);
    return share;
}

static __attribute__((noinline, unused)) void drag_each(const struct air *a, const real *speed,
                                                        const real *diameter, real *cd, real *slope)
{
    for (int k = 0; k < WF_WIDTH; k++) {
        const struct wf_loads *l = a->loads[k];
        double by = 0, at = real_lane(*speed, k);
        real_lane(*cd, k) =
            l->axis_drag->coefficient(&l->axis_drag_par, at, real_lane(*diameter, k), l->air_viscosity, &by);
        real_lane(*slope, k) = by;
    }
}

WF_INLINE real axis_drag(const struct air *a, real speed, real diameter, real *slope)
{
    if (a->axis == WF_DRAG_BARK) return bark_drag_law(speed, diameter, a->viscosity, slope);
    real copy = speed, thick = diameter, cd, by;
    drag_each(a, &copy, &thick, &cd, &by);
    *slope = by;
    return cd;
}

/* Given: dead load per length [N/m], point, position, unit tangent. Returned: *out. varies: the wind's
 * gradient counts. */
WF_INLINE void load_lanes(const struct air *a, const struct wf_line_point *line, const double dead[3],
                          const real x[3], const real t[3], int varies, struct real_load *out)
{
    for (int i = 0; i < 3; i++) out->force[i] = a->dead * dead[i];
    out->force[2] -= line->mass * a->weight;
    for (int i = 0; i < 9; i++) out->by_place[i] = out->by_turn[i] = real_of(0);
    if (!a->blows) return;
    struct axis_flow f;
    real cd = real_of(line->drag), cd_slope = { 0 }, share = real_of(1), share_slope = { 0 };
    sample_lanes(a, x, f.u, f.du);
    flow_past(t, &f);
    if (isnan(line->drag)) cd = axis_drag(a, f.across, real_of(line->diameter), &cd_slope);
    if (line->sail > 0) share = crown_share(a, f.speed, &share_slope);
    flow_forces(real_of(line->diameter), real_of(line->lift), real_of(line->sail), a->half, cd, cd_slope,
                share, share_slope, &f);
    flow_load(&f, t, varies, out);
}

/* Points of one state side by side, in the wind of `a`, whose lanes are alike. */
struct real_point {
    real x[3], t[3];                         /* position, unit tangent */
    real diameter, drag, lift, sail, weight; /* as struct wf_line_point; weight per length [N/m] */
};

/* As wf_load_on_line. change (NULL: not wanted): by the growth of the air's speed and density. */
WF_INLINE void load_points(const struct air *a, const struct real_point *p, struct real_load *out,
                           real change[3])
{
    for (int i = 0; i < 3 && change; i++) change[i] = real_of(0);
    out->force[0] = out->force[1] = real_of(0);
    out->force[2] = p->weight;
    for (int i = 0; i < 9; i++) out->by_place[i] = out->by_turn[i] = real_of(0);
    if (!a->blows) return;
    struct axis_flow f;
    real cd = p->drag, cd_slope = { 0 }, share = real_of(1), share_slope = { 0 };
    sample_lanes(a, p->x, f.u, f.du);
    flow_past(p->t, &f);
    real_truth by_law = ~real_not_above(cd, real_of(INFINITY)), leafy = real_below(real_of(0), p->sail);
    if (real_any(by_law)) {
        real slope, law = axis_drag(a, f.across, p->diameter, &slope);
        cd = real_choose(by_law, law, cd), cd_slope = real_choose(by_law, slope, cd_slope);
    }
    if (real_any(leafy)) {
        real slope, law = crown_share(a, f.speed, &slope);
        share = real_choose(leafy, law, share), share_slope = real_choose(leafy, slope, share_slope);
    }
    flow_forces(p->diameter, p->lift, p->sail, a->half, cd, cd_slope, share, share_slope, &f);
    flow_load(&f, p->t, 1, out);
    if (change) flow_growth(&f, a->grows_speed, a->grows_density, change);
}
#endif
