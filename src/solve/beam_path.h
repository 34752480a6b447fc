/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_PATH_H
#define WF_SOLVE_BEAM_PATH_H
/* Small motions of one element after another, by the factors of an eliminated tangent (struct wf_beam_small):
 * inlined parts for whole trees (solve/beam_small.h), and elements that carry one another, alone. */
#include "base/vec3.h"
#include "solve/beam_state.h"

/* Right-hand sides that are solved together: each factor of the tangent is read once for all of them.
 * Innermost index of the arrays below; a side that is not needed is zero. */
enum { WF_BEAM_SIDES = 4 };

/* A disturbance of one element at its two Gauss points, at fixed shape, per unit of its cause. */
struct wf_beam_disturbance {
    wf_four force[2][3];   /* on the axis, per reference length [N/m] */
    wf_four couple[2][3];  /* on the axis, per reference length [N m/m] */
    wf_four law[2][3];     /* change of the material law's moment at the present curvature [N m];
                                            for a    change of ln E of the element this is the moment itself:
                                            wf_beam_law_moment */
    wf_four stretch[2][3]; /* change of the strain of the axis at the present forces [-] */
};

/* Work space of one element. */
struct wf_beam_sides {
    wf_four push[6];       /* wrench on its end */
    wf_four y[6];          /* spins of its Gauss points; then the change of its end */
    wf_four stretch[2][3]; /* strains there at constant spin */
};

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
WF_INLINE void ground_root(struct wf_beam *b, size_t row, wf_four down[6], const wf_four *root,
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

/* Memory of small motions, in `a`. Errors: WF_ENOMEM. */
enum wf_status wf_beam_small_take(struct wf_beam *b, struct wf_arena *a, struct wf_err *e);

/* Elements alone that carry one another, from tips to bases; others stand still. Given: path[n], wrenches
 * b->sides[].push on their ends, which are used up. Returned: b->sides[].y, changes of the ends. */
void wf_beam_answer_path(struct wf_beam *b, const int32_t *path, size_t n);
/* The same in lane 0, added to the Newton correction: to b->answer, b->node and the roots. Returned:
 * strain[n], the changes of the unknowns g. */
void wf_beam_correct_path(struct wf_beam *b, const int32_t *path, size_t n, double (*strain)[2][3]);
#endif
