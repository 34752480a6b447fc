/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/reduction.h"
#include "base/vec3.h"
#include "data/model.h"
#include "study/removal.h"
#include <math.h>

/* The crown's outline, as far as its tips reach from a point. */
struct outline {
    double from[3];
    size_t n;
    double *way, *reach; /* 3n unit vectors; [m] */
};

static double length_of(const double v[3]) { return sqrt(wf_dot(v, v)); }

/* Where the lowest branch leaves the stem, on the stem's axis. Returned: whether there is one. */
static bool find_base(const struct wf_tree *t, double out[3])
{
    size_t lowest = t->n;
    for (size_t i = 0; i < t->n; i++) {
        bool leaves = t->level[i] > 0 && t->parent[i] >= 0 && t->level[t->parent[i]] == 0;
        if (leaves && (lowest == t->n || t->z0[i] < t->z0[lowest])) lowest = i;
    }
    if (lowest == t->n) return false;
    size_t below = (size_t)t->parent[lowest];
    out[0] = t->x1[below], out[1] = t->y1[below], out[2] = t->z1[below];
    return true;
}

static enum wf_status see(const struct wf_tree *t, struct wf_arena *a, struct outline *out, struct wf_err *e)
{
    bool *carries = WF_TAKE(a, t->n, bool);
    out->way = WF_TAKE(a, 3 * t->n, double), out->reach = WF_TAKE(a, t->n, double);
    if (!carries || !out->way || !out->reach)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    for (size_t i = 0; i < t->n; i++)
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
    for (size_t i = 0; i < t->n; i++) {
        const double v[3] = { t->x1[i] - out->from[0], t->y1[i] - out->from[1], t->z1[i] - out->from[2] };
        double r = length_of(v);
        if (carries[i] || !(r > 0)) continue;
        for (size_t k = 0; k < 3; k++) out->way[3 * out->n + k] = v[k] / r;
        out->reach[out->n++] = r;
    }
    return WF_OK;
}

/* How far a point lies beyond the reduced outline [m]; negative: within. */
static double beyond(const struct outline *o, const struct wf_reduced *how, const double p[3])
{
    const double cone = 0.93969262078590838; /* cos 20 deg */
    double v[3], reach = 0;
    for (int k = 0; k < 3; k++) v[k] = p[k] - o->from[k];
    double r = length_of(v);
    for (size_t j = 0; j < o->n; j++)
        if (wf_dot(v, &o->way[3 * j]) >= cone * r) reach = fmax(reach, o->reach[j]);
    reach = fmax(reach, r);
    return r - (how->length > 0 ? reach - how->length : (1 - how->share) * reach);
}

static void point_of(const struct wf_tree *t, size_t i, double s, double p[3])
{
    p[0] = t->x0[i] + s * (t->x1[i] - t->x0[i]);
    p[1] = t->y0[i] + s * (t->y1[i] - t->y0[i]);
    p[2] = t->z0[i] + s * (t->z1[i] - t->z0[i]);
}

/* The share of a row, from its base, that is left. The stem up to the lowest branch stays. */
static double left_of(const struct wf_tree *t, size_t i, const struct outline *o,
                      const struct wf_reduced *how)
{
    const double shortest = 1e-3; /* [m] */
    double p[3], low = 0, high = 1;
    point_of(t, i, 1, p);
    if ((t->level[i] == 0 && p[2] <= o->from[2]) || beyond(o, how, p) <= 0) return 1;
    point_of(t, i, 0, p);
    if (beyond(o, how, p) > 0 && !(t->level[i] == 0 && p[2] <= o->from[2])) return 0;
    for (int k = 0; k < 30; k++) {
        double s = 0.5 * (low + high);
        point_of(t, i, s, p);
        *(beyond(o, how, p) > 0 ? &high : &low) = s;
    }
    return low * wf_tree_length(t, i) > shortest ? low : 0;
}

static enum wf_status cut(struct wf_analysis *an, const double *left, size_t rows, struct wf_arena *a,
                          struct wf_err *e)
{
    struct wf_tree *t = &an->tree, out;
    int32_t *to = WF_TAKE(a, t->n, int32_t);
    if (!to) return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    enum wf_status s = wf_tree_alloc_like(t, rows, a, &out, e);
    for (size_t i = 0, at = 0; i < t->n && !s; i++) {
        if (!(left[i] > 0)) continue;
        wf_tree_copy_part(t, i, 0, left[i], &out, at);
        out.parent[at] = t->parent[i] < 0 ? -1 : to[t->parent[i]];
        if (t->mass1 && left[i] == 1) out.mass1[at] = t->mass1[i];
        to[i] = (int32_t)at++;
    }
    if (s) return s;
    double gone = wf_crown_gone(t, &out);
    if (gone > 0.95)
        return wf_fail(e, WF_EINPUT, "%s: such a reduction leaves less than a twentieth of the crown",
                       an->model->name);
    an->cut = 1 - (1 - an->cut) * (1 - gone);
    *t = out;
    return WF_OK;
}

enum wf_status wf_reduction_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_reduced *how = &an->scenario.reduced;
    struct outline o = { .n = 0 };
    const struct wf_tree *t = &an->tree;
    if (how->thin > 0) an->cut = 1 - (1 - an->cut) * (1 - how->thin);
    if (!(how->share > 0) && !(how->length > 0)) return WF_OK;
    if (!find_base(t, o.from))
        return wf_fail(e, WF_EINPUT, "%s: no branch is drawn that could be cut back", an->model->name);
    double *left = WF_TAKE(a, t->n, double);
    if (!left) return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    enum wf_status s = see(t, a, &o, e);
    size_t rows = 0;
    for (size_t i = 0; i < t->n && !s; i++) {
        left[i] = t->parent[i] >= 0 && left[t->parent[i]] < 1 ? 0 : left_of(t, i, &o, how);
        rows += left[i] > 0;
    }
    return s ? s : cut(an, left, rows, a, e);
}
