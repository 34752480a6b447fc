/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/unload.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_mesh.h"

static void set_end(struct wf_tree *t, size_t i, const double chord[3])
{
    double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
    if (t->parent[i] >= 0) {
        size_t p = (size_t)t->parent[i];
        base[0] = t->x1[p], base[1] = t->y1[p], base[2] = t->z1[p];
    }
    t->x0[i] = base[0], t->y0[i] = base[1], t->z0[i] = base[2];
    t->x1[i] = base[0] + chord[0], t->y1[i] = base[1] + chord[1], t->z1[i] = base[2] + chord[2];
}

static void chord_of(const struct wf_tree *t, size_t i, double c[3])
{
    c[0] = t->x1[i] - t->x0[i], c[1] = t->y1[i] - t->y0[i], c[2] = t->z1[i] - t->z0[i];
}

/* Copy a tree with its own coordinates and arcs; other columns are shared. */
static enum wf_status copy_shape(const struct wf_tree *t, struct wf_arena *a, struct wf_tree *out,
                                 struct wf_err *e)
{
    double **const to[] = { &out->x0, &out->y0, &out->z0, &out->x1, &out->y1, &out->z1 };
    const double *const from[] = { t->x0, t->y0, t->z0, t->x1, t->y1, t->z1 };
    *out = *t;
    for (int c = 0; c < 6; c++) {
        if (!(*to[c] = WF_TAKE(a, t->n, double)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
        memcpy(*to[c], from[c], t->n * sizeof(double));
    }
    if (!(out->bend = WF_TAKE(a, 3 * t->n, double)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    if (t->bend) memcpy(out->bend, t->bend, 3 * t->n * sizeof(double));
    return WF_OK;
}

/* Remove the elastic curvature from row i. b: the scanned tree under its weight, undeformed; L: rotation
 * from the stress-free to the scanned state at the row's base (in) and end (out). */
static void straighten(const struct wf_beam *b, size_t i, double L[9], struct wf_tree *out)
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    const struct wf_beam_stage *s = &b->stage[i];
    struct wf_line_load load[2];
    struct wf_beam_wrench at[2], base;
    double k[2][3], chord[3] = { 0, 0, 0 }, bend[3] = { 0, 0, 0 }, turn[3], R[9], end[9];
    wf_beam_load(p, &b->loads, s, load);
    wf_beam_balance(p->h, s, NULL, load, &b->wrench[i], at, &base);
    for (int j = 0; j < 2; j++) v3_section(1 / p->ei[j], 1 / p->gj[j], s->t[j], at[j].m, k[j]);
    for (int j = 0; j < 2; j++) {
        double here[9], axis[3], curve[3];
        for (int c = 0; c < 3; c++) turn[c] = p->h * (gauss_up[j][0] * k[0][c] + gauss_up[j][1] * k[1][c]);
        rotation_matrix(turn, R);
        m3_mul(R, L, here);
        m3_apply_transposed(here, s->t[j], axis);
        m3_apply_transposed(here, k[j], curve);
        v3_add(chord, 0.5 * p->h, axis);
        v3_add(bend, -0.5, curve);
    }
    wf_cross(k[1], k[0], turn);
    for (int c = 0; c < 3; c++)
        turn[c] = 0.5 * p->h * (k[0][c] + k[1][c]) + GAUSS_ROOT3 / 12 * p->h * p->h * turn[c];
    rotation_matrix(turn, R);
    m3_mul(R, L, end);
    memcpy(L, end, sizeof end);
    set_end(out, i, chord);
    double along = wf_dot(bend, chord) / wf_dot(chord, chord);
    v3_add(bend, -along, chord);
    v3_add(out->bend + 3 * i, 1, bend);
}

static enum wf_status straighten_all(const struct wf_tree *t, const struct wf_loads *l,
                                     const struct wf_solve_options *o, struct wf_arena *work,
                                     struct wf_tree *out, struct wf_err *e)
{
    struct wf_beam b;
    double(*L)[9] = wf_arena_take(work, t->n, sizeof *L);
    if (!L) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    enum wf_status status = wf_beam_init(&b, t, l, o, NULL, work, work, e);
    if (status) return status;
    wf_beam_sweep_up(&b);
    wf_beam_sweep_down(&b, false, NULL);
    for (size_t i = 0; i < t->n; i++) {
        double tilt[3] = { 0, 0, 0 };
        if (t->parent[i] >= 0)
            memcpy(L[i], L[t->parent[i]], sizeof L[i]);
        else {
            for (int c = 0; c < 2; c++)
                if (o->root_stiffness[c] > 0) tilt[c] = b.base.m[c] / o->root_stiffness[c];
            rotation_matrix(tilt, L[i]);
        }
        straighten(&b, i, L[i], out);
    }
    return WF_OK;
}

/* Move each row's end in *out by its own share of the error under weight, seen from the row's base.
 * Returned: largest error [m]. */
static double correct(const struct wf_tree *scan, const struct wf_beam *b, struct wf_tree *out)
{
    double worst = 0;
    for (size_t i = 0; i < scan->n; i++) {
        double want[3], have[3], own[3], chord[3];
        struct wf_beam_pose ground;
        const struct wf_beam_pose *base = wf_beam_base(b, (size_t)b->mesh.first[i], &ground);
        const struct wf_beam_pose *end = &b->pose[b->mesh.last[i]];
        const double miss[3] = { scan->x1[i] - end->r[0], scan->y1[i] - end->r[1], scan->z1[i] - end->r[2] };
        worst = fmax(worst, sqrt(wf_dot(miss, miss)));
        chord_of(scan, i, want);
        for (int c = 0; c < 3; c++) have[c] = end->r[c] - base->r[c], own[c] = want[c] - have[c];
        m3_apply_transposed(base->L, own, own);
        chord_of(out, i, chord);
        v3_add(chord, 1, own);
        set_end(out, i, chord);
        double *bend =
            out->bend + 3 * i; /* an arc's curvature must remain perpendicular to its moved chord */
        v3_add(bend, -wf_dot(bend, chord) / wf_dot(chord, chord), chord);
    }
    return worst;
}

enum wf_status wf_unload(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                         struct wf_arena *a, struct wf_tree *out, double *left, double *moved,
                         struct wf_err *e)
{
    enum { PASSES = 40 };
    struct wf_loads weight = *l;
    weight.wind = NULL, weight.points = 0, weight.line = NULL;
    struct wf_arena work = { 0 };
    enum wf_status status = wf_solve_check_round(t, "the search for the unloaded shape", e);
    if (!status) status = wf_solve_check(t, l, NULL, e);
    if (!status) status = copy_shape(t, a, out, e);
    if (!status) status = straighten_all(t, &weight, o, &work, out, e);
    wf_arena_free(&work);
    double size = 0, before = INFINITY;
    for (size_t i = 0; i < t->n; i++) size = fmax(size, fabs(t->z1[i]));
    for (int pass = 0; pass < PASSES && !status; pass++) {
        struct wf_beam b;
        struct wf_beam_outcome fell;
        status = wf_beam_solve(out, &weight, o, NULL, &work, &work, &b, &fell, e);
        if (!status) {
            *left = correct(t, &b, out);
            if (*left <= 1e-9 * size || *left > 0.9 * before)
                pass = PASSES; /* converged, or no further progress */
            before = *left;
        }
        wf_arena_free(&work);
    }
    *moved = 0;
    for (size_t i = 0; i < t->n && !status; i++) {
        const double d[3] = { out->x1[i] - t->x1[i], out->y1[i] - t->y1[i], out->z1[i] - t->z1[i] };
        *moved = fmax(*moved, sqrt(wf_dot(d, d)));
    }
    if (!status && *left > 1e-3 * size)
        return wf_fail(e, WF_EUNSTABLE,
                       "no stress-free shape found: under its weight the tree's equilibrium is %.3g m away "
                       "from the scanned shape",
                       *left);
    return status;
}
