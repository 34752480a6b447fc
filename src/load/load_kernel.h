/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_LOAD_KERNEL_H
#define WF_LOAD_LOAD_KERNEL_H
/* The load on one point of an axis and its exact derivatives, for a double or for many lanes (base/real.h).
 * They are evaluated at every Gauss point of every element in every iteration, so: no allocation, one square
 * root per speed, no division by a speed that may be zero. */
#include "base/vec3.h"
#include "load/load.h"

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

/* Forces by coefficients. Given: half the air's density; drag coefficient of the axis and share of the
 * crown's drag area, with their derivatives by speed; *f after flow_past. */
WF_INLINE void flow_forces(const struct wf_line_point *p, real half, real cd, real cd_slope, real share,
                           real share_slope, struct axis_flow *f)
{
    real a = half * p->diameter * f->across, c = half * p->sail * f->speed;
    f->drag = a * cd;
    f->drag_grow = a * (cd + cd_slope * f->across);
    f->lift = a * p->lift;
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
#endif
