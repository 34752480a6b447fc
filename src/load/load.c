/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/load.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include "data/species.h"
#include "load/drag.h"

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

/* A spring between two places. Returned: its force [N]; *u along it, *length [m]. */
static double spring(double stiffness, double unstretched, bool pushes, const double from[3],
                     const double to[3], double u[3], double *length)
{
    const double least = 1e-9; /* of its length: a cable at rest is slack, whatever is rounded */
    double square = 0;
    for (int k = 0; k < 3; k++) u[k] = to[k] - from[k], square += u[k] * u[k];
    *length = sqrt(square);
    for (int k = 0; k < 3; k++) u[k] /= *length;
    double stretch = *length - unstretched;
    return pushes || stretch > least * unstretched ? stiffness * stretch : 0;
}

double wf_tie_pull(const struct wf_tie *t, const double at[3], double force[3], double by_place[9])
{
    double u[3], length, pull = spring(t->stiffness, t->length, false, at, t->anchor, u, &length);
    for (int k = 0; k < 3; k++) force[k] = pull > 0 ? pull * u[k] : 0;
    for (int k = 0; k < 9 && by_place; k++) {
        double along = u[k / 3] * u[k % 3];
        by_place[k] = pull > 0 ? -t->stiffness * along - pull / length * ((k % 4 == 0) - along) : 0;
    }
    return pull;
}

double wf_link_pull(const struct wf_link *k, const double from[3], const double to[3], double force[3])
{
    double u[3], length, pull = spring(k->stiffness, k->length, k->pushes, from, to, u, &length);
    for (int i = 0; i < 3; i++) force[i] = pull * u[i];
    return pull;
}

double wf_link_axes(const double from[3], const double to[3], double axis[3][3])
{
    double length;
    (void)spring(0, 0, true, from, to, axis[0], &length);
    const double *u = axis[0];
    bool steep = fabs(u[2]) > 0.7;
    const double other[3] = { steep, 0, !steep };
    wf_cross(u, other, axis[1]);
    double size = sqrt(wf_dot(axis[1], axis[1]));
    for (int i = 0; i < 3; i++) axis[1][i] /= size;
    wf_cross(u, axis[1], axis[2]);
    return length;
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

/* Where a streamlining law is held: at the end of what its source covers, else of what the law covers. */
static double held_from(const struct wf_law_use *use, const struct wf_streamline_law *l)
{
    double end = isnan(use->high) ? l->law.high : use->high;
    return use->beyond == WF_BEYOND_HOLD && !l->rigid && isfinite(end) ? end : 0;
}

enum wf_status wf_loads_laws(struct wf_loads *l, const struct wf_species *sp, struct wf_err *e)
{
    const struct wf_law_use *crown = &sp->streamlining, *axis = &sp->axis_drag;
    if (crown->law) {
        l->streamline = wf_streamline_named(crown->law);
        if (!l->streamline)
            return wf_fail(e, WF_EINPUT, "%s: unknown streamlining law '%s'", sp->key, crown->law);
        l->streamline_par = law_values_of(crown, &l->streamline->law);
        l->streamline_par.held = held_from(crown, l->streamline);
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

bool wf_loads_sheared(const struct wf_loads *l)
{
    return l->sheared || (l->wind && wf_wind_form(l->wind) != WF_PROFILE_UNIFORM);
}

void wf_loads_blow(struct wf_loads *l, const struct wf_wind *wind)
{
    l->wind = wind;
    l->sheared = wf_loads_sheared(l);
    if (!(wind->speed > 0)) l->wind = NULL;
}

struct wf_line_point wf_line_point_of(const struct wf_tree *t, size_t i, double s)
{
    double outer = wf_between(t->r0[i], t->r1[i], s);
    return (struct wf_line_point){
        .diameter = 2.0 * outer,
        .drag = t->drag[i],
        .lift = t->lift[i],
        .sail = wf_between(t->sail0[i], t->sail1[i], s),
        .mass = t->density[i] * wf_tree_area(t, i, s) + wf_between(t->burden0[i], t->burden1[i], s),
    };
}
