/* The structure of a validation case as a tree of rows, before any splitting. */
#include "base/vec.h"
#include "cases/build.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void add_share(double *s, size_t *n, const struct wf_place *p)
{
    if (p->kind == WF_PLACE_AT) s[(*n)++] = p->share;
}

/* Row boundaries as shares of the length: evenly spaced, and wherever the case names a place. */
static double *boundaries(const struct wf_case *c, struct wf_arena *a, size_t *rows)
{
    size_t even = (size_t)c->rows, n = 0, kept = 0;
    double *s = WF_TAKE(a, even + 1 + c->loads.n + c->masses.n + c->wants.n, double);
    if (!s) return NULL;
    for (size_t i = 0; i <= even; i++) s[n++] = (double)i / (double)even;
    const struct wf_case_load *l = c->loads.data;
    const struct wf_case_mass *m = c->masses.data;
    const struct wf_want *w = c->wants.data;
    for (size_t i = 0; i < c->loads.n; i++) add_share(s, &n, &l[i].at);
    for (size_t i = 0; i < c->masses.n; i++) add_share(s, &n, &m[i].at);
    for (size_t i = 0; i < c->wants.n; i++) add_share(s, &n, &w[i].at);
    qsort(s, n, sizeof *s, ascending);
    for (size_t i = 1; i < n; i++)
        if (s[i] - s[kept] > 1e-9) s[++kept] = s[i];
    *rows = kept;
    return s;
}

/* Point of the unloaded axis at arc length s [m]: straight, or a circle from its root tangent f towards n. */
static void axis_point(const struct wf_case *c, const double f[3], const double n[3], double s, double x[3])
{
    double r = c->arc[0], u = s, v = 0.0;
    if (c->shape == WF_SHAPE_ARC) u = r * sin(s / r), v = r * (1.0 - cos(s / r));
    for (int j = 0; j < 3; j++) x[j] = u * f[j] + v * n[j];
}

static void unit(const double in[3], double out[3])
{
    double size = sqrt(wf_dot(in, in));
    for (int j = 0; j < 3; j++) out[j] = in[j] / size;
}

static enum wf_status single_axis(const struct wf_case *c, struct wf_arena *a, struct wf_setup *s,
                                  struct wf_tree *t, struct wf_err *e)
{
    bool arc = c->shape == WF_SHAPE_ARC;
    double length = wf_case_length(c), f[3], n[3] = { 0 }, curvature[3];
    size_t rows;
    double *share = boundaries(c, a, &rows);
    if (!share) return wf_fail(e, WF_ENOMEM, "no memory");
    if (wf_tree_alloc(t, rows, a, e)) return e->code;
    if (arc && !(t->bend = WF_TAKE(a, 3 * rows, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    s->end = share + 1;
    unit(arc ? c->arc_from : c->direction, f);
    if (arc) unit(c->arc_towards, n);
    wf_cross(f, n, curvature);
    for (size_t i = 0; i < rows; i++) {
        double x[3], r[2], q[2];
        t->parent[i] = (int32_t)i - 1;
        t->id[i] = (int64_t)i + 1;
        axis_point(c, f, n, share[i] * length, x);
        t->x0[i] = x[0], t->y0[i] = x[1], t->z0[i] = x[2];
        axis_point(c, f, n, share[i + 1] * length, x);
        t->x1[i] = x[0], t->y1[i] = x[1], t->z1[i] = x[2];
        for (size_t k = 0; k < 2; k++) {
            wf_case_radius(c, r, q);
            double at = share[i + k], outer = r[0] + at * (r[1] - r[0]), inner = q[0] + at * (q[1] - q[0]);
            (k ? t->r1 : t->r0)[i] = outer;
            (k ? t->i1 : t->i0)[i] = inner;
        }
        for (size_t j = 0; arc && j < 3; j++) t->bend[3 * i + j] = curvature[j] / c->arc[0];
    }
    return WF_OK;
}

static enum wf_status branches(const struct wf_case *c, struct wf_arena *a, struct wf_tree *t,
                               struct wf_err *e)
{
    const struct wf_case_branch *b = c->branches.data;
    const struct wf_case_node *node = c->nodes.data;
    if (wf_tree_alloc(t, c->branches.n, a, e)) return e->code;
    for (size_t i = 0; i < c->branches.n; i++) {
        const struct wf_case_node *from = node, *to = node;
        while (from->id != b[i].from) from++;
        while (to->id != b[i].to) to++;
        t->parent[i] = -1;
        for (size_t k = 0; k < i; k++)
            if (b[k].to == b[i].from) t->parent[i] = (int32_t)k;
        t->level[i] = t->parent[i] < 0 ? 0 : t->level[t->parent[i]] + 1;
        t->id[i] = b[i].to;
        t->x0[i] = from->x[0], t->y0[i] = from->x[1], t->z0[i] = from->x[2];
        t->x1[i] = to->x[0], t->y1[i] = to->x[1], t->z1[i] = to->x[2];
        t->r0[i] = b[i].radius[0], t->r1[i] = b[i].radius[1];
    }
    return WF_OK;
}

/* Beside the case file, or in the folder that WINDFIRM_REFERENCE names (for files too large to ship). */
static enum wf_status tree_file(const struct wf_case *c, struct wf_arena *a, struct wf_tree *t,
                                struct wf_err *e)
{
    const char *slash = strrchr(c->file, '/'), *folder = getenv("WINDFIRM_REFERENCE");
    const char *beside =
        wf_arena_print(a, "%.*s%s", slash ? (int)(slash - c->file + 1) : 0, c->file, c->tree_file);
    const char *apart = folder ? wf_arena_print(a, "%s/%s", folder, c->tree_file) : NULL;
    if (!beside) return wf_fail(e, WF_ENOMEM, "no memory");
    if (access(beside, R_OK) == 0) return wf_case_tree_read(beside, a, t, e);
    if (apart && access(apart, R_OK) == 0) return wf_case_tree_read(apart, a, t, e);
    return wf_fail(e, WF_EMISSING, "tree file %s is not there%s", c->tree_file,
                   folder ? "" : "; WINDFIRM_REFERENCE can name a folder that holds it");
}

enum wf_status wf_case_shape_build(const struct wf_case *c, struct wf_arena *a, struct wf_setup *s,
                                   struct wf_tree *t, struct wf_err *e)
{
    switch (c->shape) {
    case WF_SHAPE_CANTILEVER:
    case WF_SHAPE_ARC:
        return single_axis(c, a, s, t, e);
    case WF_SHAPE_BRANCHES:
        return branches(c, a, t, e);
    case WF_SHAPE_TREE:
        return tree_file(c, a, t, e);
    case WF_SHAPE_FLOW:
    case WF_SHAPE_FIT:
    case WF_SHAPE_NONE:
        break;
    }
    return wf_fail(e, WF_EINTERNAL, "%s:%zu: a case without a structure", c->file, c->line);
}
