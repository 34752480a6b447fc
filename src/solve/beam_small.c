/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_small.h"
#include "base/vec3.h"
#include "solve/beam_element.h"
#include "solve/beam_kernel.h"
#include "solve/beam_mesh.h"

enum wf_status wf_beam_linearise(struct wf_beam *b, bool frozen, struct wf_arena *a, struct wf_err *e)
{
    b->small = WF_TAKE(a, b->mesh.n, struct wf_beam_small);
    b->sides = WF_TAKE(a, b->mesh.n, struct wf_beam_sides);
    b->root_moved = wf_arena_take(a, b->mesh.tree->n, sizeof *b->root_moved);
    if (!b->small || !b->sides || !b->root_moved)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the small motions of %zu elements", b->mesh.n);
    b->frozen = frozen;
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL))
        return wf_fail(
            e, WF_EUNSTABLE,
            "the stiffness matrix of the equilibrium is singular: no small motions exist about it");
    return WF_OK;
}

void wf_beam_law_moment(const struct wf_beam *b, size_t i, double moment[2][3])
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
    double k[2][3], bent[3];
    wf_beam_curvature(p, &b->shape[i], k);
    for (int j = 0; j < 2; j++) {
        m3_apply(base->L, k[j], bent);
        law_hold(p, wf_beam_flat_of(b, i), &b->stage[i], j, bent, moment[j]);
    }
}

void wf_beam_turn_along(const struct wf_beam *b, size_t i, const double given[2][3], double turned[2][3])
{
    struct wf_beam_pose ground;
    struct turns o;
    double local[3];
    turns_of(&b->shape[i], &o);
    for (int j = 0; j < 2; j++)
        turn_with_section(&b->shape[i], &o, wf_beam_base(b, i, &ground)->L, j, given[j], local, turned[j]);
}

_Static_assert(sizeof(wf_four) == WF_BEAM_SIDES * sizeof(double), "a side is a lane");

/* y += A x */
WF_INLINE void apply6(double A[6][6], wf_four x[6], wf_four y[6])
{
    for (int i = 0; i < 6; i++) {
        wf_four sum = y[i];
        for (int c = 0; c < 6; c++) sum += A[i][c] * x[c];
        y[i] = sum;
    }
}

/* y = A x */
WF_INLINE void apply3(const double A[9], wf_four x[3], wf_four y[3])
{
    for (int i = 0; i < 3; i++) y[i] = A[3 * i] * x[0] + A[3 * i + 1] * x[1] + A[3 * i + 2] * x[2];
}

/* y += f a x x */
WF_INLINE void add_cross(double f, const double a[3], wf_four x[3], wf_four y[3])
{
    y[0] += f * (a[1] * x[2] - a[2] * x[1]);
    y[1] += f * (a[2] * x[0] - a[0] * x[2]);
    y[2] += f * (a[0] * x[1] - a[1] * x[0]);
}

/* y = p x + (q - p) t (t.x), as v3_section */
WF_INLINE void section(double p, double q, const double t[3], wf_four x[3], wf_four y[3])
{
    wf_four along = (q - p) * (t[0] * x[0] + t[1] * x[1] + t[2] * x[2]);
    for (int i = 0; i < 3; i++) y[i] = p * x[i] + along * t[i];
}

/* Moment per length at Gauss point j, by the force on the end and the disturbing forces; stretch there. */
WF_INLINE void turn_down(const struct wf_beam_part *p, const struct wf_beam_stage *g, struct wf_beam_small *q,
                         struct wf_beam_disturbance *x, int j, wf_four k[6], wf_four stretch[3],
                         wf_four turn[3])
{
    wf_four own[3], n[3], give[3];
    for (int i = 0; i < 3; i++) {
        own[i] = p->h * (gauss_down[j][0] * x->force[0][i] + gauss_down[j][1] * x->force[1][i]);
        n[i] = k[i] + own[i];
    }
    section(p->cs[j], p->ca[j], g->t[j], n, stretch);
    section(p->cs[j], p->ca[j], g->t[j], own, give);
    for (int i = 0; i < 3; i++) stretch[i] += x->stretch[j][i], give[i] += x->stretch[j][i];
    apply3(q->Vn[j], k, turn);
    add_cross(1, g->rp[j], own, turn);
    add_cross(-1, q->n[j], give, turn);
    for (int i = 0; i < 3; i++) turn[i] += x->couple[j][i];
}

/* One element under a disturbance and the wrench v->push from above. Returned: v->y at a fixed base,
 * v->stretch, wrench on the base. */
WF_INLINE void answer_down(const struct wf_beam_part *p, const struct wf_beam_stage *g,
                           struct wf_beam_small *q, struct wf_beam_disturbance *x, struct wf_beam_sides *v,
                           wf_four down[6])
{
    wf_four turn[2][3], d[6], y[6] = { 0 }, k[6];
    memcpy(k, v->push, sizeof k);
    for (int j = 0; j < 2; j++) turn_down(p, g, q, x, j, k, v->stretch[j], turn[j]);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            d[3 * j + i] = k[3 + i] - x->law[j][i] +
                           p->h * (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        down[i] = k[i] + 0.5 * p->h * (x->force[0][i] + x->force[1][i]);
        down[3 + i] = k[3 + i] + 0.5 * p->h * (turn[0][i] + turn[1][i]);
    }
    apply6(q->R, d, y);
    apply6(q->T, y, down);
    memcpy(v->y, y, sizeof y);
}

/* Motion of one element for the change `below` of its base. Returned: displacement and twist at the Gauss
 * points (may be NULL); in v->y the change of its end. */
WF_INLINE void answer_up(const struct wf_beam_part *p, const struct wf_beam_stage *g,
                         struct wf_beam_answer *x, struct wf_beam_small *q, const wf_four below[6],
                         struct wf_beam_sides *v, wf_four *motion)
{
    wf_four dr[2][3], spin[2][3], y[6], base[6], *end = v->y;
    memcpy(y, v->y, sizeof y), memcpy(base, below, sizeof base);
    apply6(x->X, base, y);
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++) spin[j][i] = base[3 + i] + y[3 * j + i];
        apply3(q->Y[j], spin[j], dr[j]);
        for (int i = 0; i < 3; i++) dr[j][i] += v->stretch[j][i];
    }
    for (int j = 0; j < 2 && motion; j++) {
        const double *t = g->t[j];
        for (int i = 0; i < 3; i++)
            motion[4 * j + i] = base[i] + p->h * (gauss_up[j][0] * dr[0][i] + gauss_up[j][1] * dr[1][i]);
        motion[4 * j + 3] = t[0] * spin[j][0] + t[1] * spin[j][1] + t[2] * spin[j][2];
    }
    for (int i = 0; i < 3; i++) {
        wf_four spun = base[3 + i];
        for (int c = 0; c < 6; c++) spun += q->P[3 + i][c] * y[c];
        end[i] = base[i] + 0.5 * p->h * (dr[0][i] + dr[1][i]), end[3 + i] = spun;
    }
}

/* Rotation of a root plate, and the root's wrench on the ground: that for a fixed plate plus the effect of
 * its spin. */
static void ground_root(struct wf_beam *b, size_t row, wf_four down[6], const wf_four *root,
                        wf_four ground[6])
{
    const struct wf_tree *t = b->mesh.tree;
    const double arm[3] = { t->x0[row] - t->x0[0], t->y0[row] - t->y0[0], t->z0[row] - t->z0[0] };
    wf_four m[3], all[6], *p = b->root_moved[row];
    for (int i = 0; i < 3; i++) m[i] = down[3 + i] + (root ? root[i] : (wf_four){ 0 });
    memset(p, 0, sizeof b->root_moved[row]);
    apply3(b->root_give[row], m, p + 3);
    for (int i = 0; i < 6; i++) {
        const double *by = b->root_hold[row][i];
        all[i] = down[i] + by[0] * p[3] + by[1] * p[4] + by[2] * p[5];
        ground[i] += all[i];
    }
    add_cross(1, arm, all, ground + 3);
}

typedef void disturbance_source(const void *ctx, const struct wf_beam *b, size_t i,
                                struct wf_beam_disturbance *out);

/* Tips to base: wrenches. Inlined for each source. */
WF_INLINE void answer_all_down(struct wf_beam *b, disturbance_source *source, const void *ctx,
                               const wf_four (*root)[3], wf_four ground[6])
{
    for (size_t i = b->mesh.n; i-- > 0;) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_disturbance x;
        wf_four down[6];
        memset(&x, 0, sizeof x);
        if (source) source(ctx, b, i, &x);
        answer_down(p, &b->stage[i], &b->small[i], &x, &b->sides[i], down);
        if (p->parent >= 0)
            for (int c = 0; c < 6; c++) b->sides[p->parent].push[c] += down[c];
        else
            ground_root(b, (size_t)p->row, down, root ? root[p->row] : NULL, ground);
    }
}

/* Base to tips: motions, times `root` unless it is NULL. */
WF_INLINE void answer_all_up(struct wf_beam *b, const double *root, wf_four *motion)
{
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_sides *v = &b->sides[i];
        answer_up(p, &b->stage[i], &b->answer[i], &b->small[i],
                  p->parent >= 0 ? b->sides[p->parent].y : b->root_moved[p->row], v,
                  motion ? motion + 8 * i : NULL);
        for (size_t c = 0; c < 8 && root; c++) motion[8 * i + c] *= root[8 * i + c];
    }
}

WF_WIDE void wf_beam_answer_small(struct wf_beam *b, disturbance_source *source, const void *ctx,
                                  const wf_four (*node)[6], const wf_four (*root)[3],
                                  struct wf_beam_small_answer *out)
{
    memset(out->ground, 0, sizeof out->ground);
    for (size_t i = 0; i < b->mesh.n; i++)
        if (node)
            memcpy(b->sides[i].push, node[i], sizeof b->sides[i].push);
        else
            memset(b->sides[i].push, 0, sizeof b->sides[i].push);
    answer_all_down(b, source, ctx, root, out->ground);
    answer_all_up(b, NULL, out->motion);
    for (size_t i = 0; out->ends && i < b->mesh.n; i++)
        memcpy(out->ends[i], b->sides[i].y, sizeof *out->ends);
}

size_t wf_beam_motion_size(const struct wf_beam *b) { return b->mesh.n * (b->mesh.mass1 ? 11 : 8); }

/* Motions times the square root of their mass, and that root. */
struct inertia {
    const double *root;
    const wf_four *in;
};

/* Their inertia at the Gauss points, per length: the mass there is half the element's length times that per
 * length. */
WF_INLINE void inertia_disturbance(const void *ctx, const struct wf_beam *b, size_t i,
                                   struct wf_beam_disturbance *out)
{
    const struct inertia *x = ctx;
    const wf_four *in = x->in + 8 * i;
    const double *root = x->root + 8 * i, per_length = 2 / b->mesh.part[i].h;
    for (int j = 0; j < 2; j++) {
        wf_four spin = per_length * root[4 * j + 3] * in[4 * j + 3];
        for (int c = 0; c < 3; c++) {
            out->force[j][c] = per_length * root[4 * j + c] * in[4 * j + c];
            out->couple[j][c] = spin * b->stage[i].t[j][c];
        }
    }
}

WF_WIDE void wf_beam_inertia_answer(struct wf_beam *b, const double *root, const wf_four *in, wf_four *out)
{
    const size_t n = b->mesh.n;
    const struct inertia x = { root, in };
    wf_four ground[6] = { 0 };
    for (size_t i = 0; i < n; i++) {
        memset(b->sides[i].push, 0, sizeof b->sides[i].push);
        for (size_t c = 8 * n + 3 * i; b->mesh.mass1 && c < 8 * n + 3 * i + 3; c++)
            b->sides[i].push[c - 8 * n - 3 * i] = root[c] * in[c];
    }
    answer_all_down(b, inertia_disturbance, &x, NULL, ground);
    answer_all_up(b, root, out);
    for (size_t i = 0; b->mesh.mass1 && i < n; i++)
        for (size_t c = 0; c < 3; c++) out[8 * n + 3 * i + c] = root[8 * n + 3 * i + c] * b->sides[i].y[c];
}

void wf_beam_motion_mass(const struct wf_beam *b, double *mass)
{
    size_t n = b->mesh.n;
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        for (size_t j = 0; j < 2; j++) {
            for (size_t c = 0; c < 3; c++) mass[8 * i + 4 * j + c] = 0.5 * p->h * p->line[j].mass;
            mass[8 * i + 4 * j + 3] = 0.5 * p->h * p->spin[j];
        }
        for (size_t c = 0; b->mesh.mass1 && c < 3; c++) mass[8 * n + 3 * i + c] = b->mesh.mass1[i];
    }
}
