/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/solve.h"
#include "base/num.h"
#include "base/vec3.h"
#include <math.h>

enum wf_status wf_response_alloc(struct wf_response *r, size_t n, struct wf_arena *a, struct wf_err *e)
{
    double **const column[] = { &r->end,     &r->turn,     &r->force0,   &r->moment0, &r->force1,
                                &r->moment1, &r->tangent0, &r->tangent1, &r->load };
    *r = (struct wf_response){ .n = n };
    for (size_t i = 0; i < WF_COUNT(column); i++)
        if (!(*column[i] = WF_TAKE(a, 3 * n, double)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for the response of %zu segments", n);
    return WF_OK;
}

double wf_response_slope(const struct wf_tree *t, const struct wf_response *r, size_t row)
{
    const double *turn = r->turn + 3 * row, *now = r->tangent1 + 3 * row;
    double before[3], across[3], matrix[9];
    if (r->small_deflection) {
        const double chord[3] = { t->x1[row] - t->x0[row], t->y1[row] - t->y0[row], t->z1[row] - t->z0[row] };
        wf_cross(chord, turn, across);
        return sqrt(wf_dot(across, across) / wf_dot(chord, chord));
    }
    rotation_matrix(turn, matrix);
    m3_apply_transposed(matrix, now, before);
    wf_cross(before, now, across);
    return atan2(sqrt(wf_dot(across, across)), wf_dot(before, now));
}

void wf_solve_options_default(struct wf_solve_options *o)
{
    *o = (struct wf_solve_options){
        .tolerance = 1e-9, .mesh_tolerance = 1e-6, .iterations_max = 100, .threads = 1
    };
}

static bool finite3(const double x[3]) { return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]); }

static enum wf_status check_links(const struct wf_tree *t, const struct wf_loads *l, struct wf_err *e)
{
    if (l->links > WF_LINKS_MAX)
        return wf_fail(e, WF_EINPUT, "%zu cables or rods between two points; %d are possible", l->links,
                       (int)WF_LINKS_MAX);
    for (size_t k = 0; k < l->links; k++) {
        const struct wf_link *x = &l->link[k];
        for (int i = 0; i < 2; i++)
            if (x->segment[i] < 0 || (size_t)x->segment[i] >= t->n)
                return wf_fail(e, WF_EINPUT, "cable %zu is fixed to row %ld; the tree has rows 0 to %zu",
                               k + 1, (long)x->segment[i], t->n - 1);
        if (x->segment[0] == x->segment[1])
            return wf_fail(e, WF_EINPUT, "cable %zu has both ends at segment %lld", k + 1,
                           (long long)t->id[x->segment[0]]);
        if (!(x->stiffness > 0) || !isfinite(x->stiffness) || !(x->length > 0) || !isfinite(x->length))
            return wf_fail(e, WF_EINPUT, "cable %zu: its stiffness and its length must be above 0", k + 1);
    }
    return WF_OK;
}

static enum wf_status check_solver_loads(const struct wf_tree *t, const struct wf_loads *l, struct wf_err *e)
{
    if (!isfinite(l->gravity) || !isfinite(l->wind_scale) || !isfinite(l->weight_scale) ||
        !isfinite(l->point_scale))
        return wf_fail(e, WF_EINPUT, "gravity or a load factor is not a finite number");
    if (l->wind && !(isfinite(l->wind->speed) && finite3(l->wind->direction) && isfinite(l->air_density)))
        return wf_fail(e, WF_EINPUT, "the wind or the air's density is not a finite number");
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *p = &l->point[k];
        if (p->segment < 0 || (size_t)p->segment >= t->n)
            return wf_fail(e, WF_EINPUT, "point load %zu acts on row %ld; the tree has rows 0 to %zu", k + 1,
                           (long)p->segment, t->n - 1);
        if (!finite3(p->force) || !finite3(p->moment))
            return wf_fail(e, WF_EINPUT, "point load %zu on segment %lld is not a finite number", k + 1,
                           (long long)t->id[p->segment]);
    }
    for (size_t i = 0; l->line && i < 2 * t->n; i++)
        if (!finite3(l->line + 3 * i))
            return wf_fail(e, WF_EINPUT, "the line load on segment %lld is not a finite number",
                           (long long)t->id[i / 2]);
    return check_links(t, l, e);
}

enum wf_status wf_solve_check(const struct wf_tree *t, const struct wf_loads *l, struct wf_diag *d,
                              struct wf_err *e)
{
    struct wf_arena own = { 0 };
    struct wf_diag faults = { .arena = &own };
    enum wf_status status = wf_tree_check(t, d ? d : &faults, d ? e : NULL);
    if (status && !d)
        status = wf_fail(e, status, "%s", faults.first ? faults.first->text : "the tree has no segments");
    wf_arena_free(&own);
    return status ? status : check_solver_loads(t, l, e);
}

enum wf_status wf_solve_check_round(const struct wf_tree *t, const char *what, struct wf_err *e)
{
    if (!t->section) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: %s supports round sections only", t->name ? t->name : "tree", what);
}
