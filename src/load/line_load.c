/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/line_load.h"

/* The load on one point of an axis, with the wind and the laws of the loads. */

static inline void flow_at(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                           const double t[3], struct axis_flow *f)
{
    double cd = p->drag, cd_slope = 0, share = 1, share_slope = 0;
    l->wind->sample(l->wind, x, f->u, f->du);
    flow_past(t, f);
    if (isnan(cd))
        cd =
            l->axis_drag->coefficient(&l->axis_drag_par, f->across, p->diameter, l->air_viscosity, &cd_slope);
    if (l->streamline && p->sail > 0)
        share = wf_streamline_share(l->streamline, &l->streamline_par, f->speed, &share_slope);
    flow_forces(p->diameter, p->lift, p->sail, 0.5 * l->air_density * l->wind_scale, cd, cd_slope, share,
                share_slope, f);
}

void wf_load_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                     const double t[3], struct wf_line_load *out)
{
    *out = (struct wf_line_load){ .force = { 0, 0, -p->mass * l->gravity * l->weight_scale } };
    if (!l->wind) return;
    struct axis_flow f;
    double varies = 0;
    flow_at(l, p, x, t, &f);
    for (int i = 0; i < 9; i++) varies += fabs(f.du[i]);
    flow_load(&f, t, varies > 0, out);
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
