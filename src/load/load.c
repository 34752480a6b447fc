/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/load.h"
#include "data/species.h"
#include "load/drag.h"
#include "load/load_kernel.h"
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
        share = l->streamline->share(&l->streamline_par, f->speed, &share_slope);
    flow_forces(p, 0.5 * l->air_density * l->wind_scale, cd, cd_slope, share, share_slope, f);
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
