/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/explain.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "solve/solve.h"
#include <stdlib.h>
#include <string.h>

/* Displacement of the end of a branch less that of a rigid branch fixed to the end of its parent row [m]. */
static double own(const struct wf_tree *t, const struct wf_response *r, const struct wf_explain_axis *b)
{
    const size_t i = b->first, k = b->last;
    const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
    double arm[3] = { t->x1[k] - base[0], t->y1[k] - base[1], t->z1[k] - base[2] }, moved[3], sum = 0;
    memcpy(moved, arm, sizeof moved);
    int32_t foot = t->parent[i];
    double at[3] = { 0 };
    if (foot >= 0) {
        double R[9];
        rotation_matrix(r->turn + 3 * foot, R);
        m3_apply(R, arm, moved);
        memcpy(at, r->end + 3 * foot, sizeof at);
    }
    for (size_t x = 0; x < 3; x++) {
        double off = r->end[3 * k + x] - at[x] - (moved[x] - arm[x]);
        sum += off * off;
    }
    return sqrt(sum);
}

static void find_axes(const struct wf_tree *t, struct wf_explain *out)
{
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        struct wf_explain_axis *b = out->axes ? &out->axis[out->axes - 1] : NULL;
        if (b && p == (int32_t)b->last && t->level[p] == t->level[i]) {
            b->last = i;
            b->length += wf_tree_length(t, i);
            continue;
        }
        out->axis[out->axes++] = (struct wf_explain_axis){ .first = i,
                                                           .last = i,
                                                           .level = t->level[i],
                                                           .length = wf_tree_length(t, i),
                                                           .radius = t->r0[i],
                                                           .height = t->z0[i] };
    }
}

static size_t number_of_solvers(void)
{
    size_t n = 0;
    while (wf_solvers[n]) n++;
    return n;
}

static double size_of(const double v[3]) { return sqrt(wf_dot(v, v)); }

enum wf_status wf_explain_run(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                              struct wf_arena *a, struct wf_diag *d, struct wf_explain *out, struct wf_err *e)
{
    const struct wf_tree *t = &an->tree;
    struct wf_wind wind = an->wind;
    struct wf_loads loads = an->loads;
    struct wf_response beam, r;
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    wf_loads_blow(&loads, &wind);
    *out = (struct wf_explain){ .axis = WF_TAKE(a, t->n, struct wf_explain_axis),
                                .room = WF_TAKE(a, t->n, double) };
    if (!out->axis || !out->room) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    find_axes(t, out);
    wf_stage_begin(number_of_solvers(), false, "methods");
    enum wf_status status = wf_solvers[0]->solve(t, &loads, o, a, &beam, d, e);
    if (status) return status;
    for (size_t b = 0; b < out->axes; b++) out->axis[b].beam = own(t, &beam, &out->axis[b]);
    const size_t tip = 3 * wf_tip_row(t);
    for (size_t s = 1; wf_solvers[s] && out->methods < WF_EXPLAIN_METHODS; s++) {
        struct wf_err why = { 0 };
        wf_stage_step(1);
        if (wf_interrupted())
            return wf_fail(e, WF_EINTERRUPTED, "interrupted before every method was applied");
        size_t m = out->methods++;
        out->method[m] = wf_solvers[s];
        out->status[m] = wf_solvers[s]->solve(t, &loads, o, a, &r, d, &why);
        if (out->status[m] == WF_ENOMEM) return wf_fail(e, WF_ENOMEM, "%s", why.text);
        if (out->status[m])
            wf_diag_warn(d, "no-answer", "solver '%s' has no answer: %s", wf_solvers[s]->name, why.text);
        bool ok = !out->status[m];
        out->tip[m] = ok ? size_of(r.end + tip) / size_of(beam.end + tip) : NAN;
        for (size_t b = 0; b < out->axes; b++)
            out->axis[b].ratio[m] = ok ? own(t, &r, &out->axis[b]) / out->axis[b].beam : NAN;
    }
    return WF_OK;
}

int32_t wf_explain_top(const struct wf_explain *x)
{
    int32_t top = 0;
    for (size_t b = 0; b < x->axes; b++) top = x->axis[b].level > top ? x->axis[b].level : top;
    return top;
}

void wf_explain_spread(const struct wf_explain *x, size_t method, int32_t level,
                       struct wf_explain_spread *out)
{
    double *r = x->room;
    *out = (struct wf_explain_spread){ .low = NAN, .middle = NAN, .high = NAN };
    for (size_t b = 0; b < x->axes; b++) {
        if (x->axis[b].level != level) continue;
        out->branches++;
        if (isfinite(x->axis[b].ratio[method])) r[out->answers++] = x->axis[b].ratio[method];
    }
    size_t n = out->answers;
    if (!n) return;
    qsort(r, n, sizeof *r, wf_ascending);
    out->low = r[0], out->high = r[n - 1], out->middle = 0.5 * (r[(n - 1) / 2] + r[n / 2]);
}

double wf_explain_share(const struct wf_explain *x, size_t method, double off)
{
    double n = 0;
    for (size_t b = 0; b < x->axes; b++) n += fabs(x->axis[b].ratio[method] - 1) <= off;
    return n / (double)x->axes;
}
