/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One kernel of several lanes; compiled for each width (WF_WIDTH). */
#include "solve/beam_lanes.h"
#include "base/num.h"
#include "load/line_load.h"
#include "solve/beam_condense.h"
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>

#define NAMED(width) NAMED_(width)
#define NAMED_(width) wf_lanes_##width

/* What is collected above the end of an element on the way down; its change on the way up. */
struct above {
    struct wf_beam_reaction node;
    struct wf_beam_wrench w;
};
struct change {
    real place[3], spin[3];
    real L[9]; /* rotation before the change */
};
union slot {
    struct above above;
    struct change change;
};

/* What is read: struct wf_lanes_row and struct wf_lanes_sums of a real. */
struct real_row {
    struct wf_beam_wrench base, end;
    real load[3];
};
struct real_sums {
    struct wf_beam_wrench ground;
    real force[3], moment[3];
};

struct work {
    const struct wf_beam_mesh *mesh;
    const struct wf_lanes_joints *joints;
    struct air air;
    enum variation kind; /* of the loads, by the profile of the wind */
    struct wf_beam_shape *shape;
    struct wf_beam_pose *pose;
    real *
        answer; /* per element a row for each unknown: the columns from `first_column` on, and the constant */
    real (*before)[2][3]; /* rotation vectors before the last step */
    union slot *slot;
    real_truth moving; /* lanes whose last step is being computed; the others keep their state */
    bool all_move;     /* all of them do, or the others are done with: their poses and answers may change */
    real_truth guard;  /* lanes far from equilibrium */
    real_truth broken; /* lanes whose tangent is singular */
    struct beam_misfit misfit;
    real base[3];         /* force on the ground */
    real margin;          /* see struct wf_beam_stability */
    real negative, bears; /* likewise */
    real turn, bend; /* largest squared rotation of a node in the last step; largest squared rotation in an
                        element */
};

static struct work work_of(const struct wf_lanes *x)
{
    return (struct work){ .mesh = x->mesh,
                          .joints = x->joints,
                          .shape = (void *)x->shape,
                          .pose = (void *)x->pose,
                          .answer = (void *)x->answer,
                          .before = (void *)x->step,
                          .slot = (void *)x->slot,
                          .moving = ~(real_truth){ 0 },
                          .all_move = true };
}

static void set_loads(const struct wf_lanes *x, struct work *w)
{
    set_air(x->loads, &w->air);
    w->kind = w->air.profile == WF_PROFILE_OTHER ? VARIES : VARIES_UPWARDS;
}

/* From the tips down. */

static const struct wf_beam_pose *base_of(const struct work *w, const struct wf_beam_part *p,
                                          struct wf_beam_pose *ground)
{
    const struct wf_tree *t = w->mesh->tree;
    if (p->parent >= 0) return &w->pose[p->parent];
    ground->r[0] = real_of(t->x0[p->row]), ground->r[1] = real_of(t->y0[p->row]),
    ground->r[2] = real_of(t->z0[p->row]);
    for (int i = 0; i < 9; i++) ground->L[i] = real_of(i % 4 == 0);
    return ground;
}

/* An element that would leap, taken by itself: changes of its unknowns. */
static __attribute__((noinline)) void apart_answer(const struct wf_beam_part *p,
                                                   const struct wf_beam_shape *u, const real L[9],
                                                   const struct wf_beam_wrench at[2], by_base A)
{
    struct turns o;
    struct kinematics k;
    struct wf_beam_stage s;
    turns_of(u, &o);
    for (int j = 0; j < 2; j++) axis_of(p, u, &o, L, j, &s);
    kinematics_of(p, u, &o, L, &s, NULL, &k);
    stiffen_kinematics(&k, 1 + element_damping(p, NULL, &k, &s, at));
    bend_apart(p, NULL, &k, &s, at, columns_of(0, TO_SIDE), A);
}

/* Reactions from above the end of element i, and the loads at its end. */
WF_INLINE void collect(const struct work *w, size_t i, struct above *out)
{
    int32_t slot = w->joints->slot[i];
    if (slot >= 0)
        *out = w->slot[slot].above;
    else
        *out = (struct above){ 0 };
    if (w->mesh->mass1) out->w.n[2] -= w->mesh->mass1[i] * w->air.weight;
}

/* Pass the reaction on to the element below, the first of whose reactions it may be. */
WF_INLINE void pass_down(struct work *w, size_t i, const struct wf_beam_part *p, int from, by_base B,
                         real_truth apart, const struct wf_beam_wrench *down)
{
    if (p->parent < 0) {
        for (int c = 0; c < 3; c++) w->base[c] += down->n[c];
        return;
    }
    struct above *to = &w->slot[w->joints->slot[p->parent]].above;
    if (real_any(apart))
        for (int r = 0; r < 6; r++)
            for (int c = from; c < 7; c++) B[r][c] = real_choose(apart, real_of(0), B[r][c]);
    if (w->joints->opens[i]) {
        for (int r = 0; r < 6; r++) {
            for (int c = from; c < 6; c++) to->node.K[r][c] = B[r][c];
            to->node.k[r] = B[r][6];
        }
        to->w = *down;
        return;
    }
    for (int r = 0; r < 6; r++) {
        for (int c = from; c < 6; c++) to->node.K[r][c] += B[r][c];
        to->node.k[r] += B[r][6];
    }
    for (int c = 0; c < 3; c++) to->w.n[c] += down->n[c], to->w.m[c] += down->m[c];
}

WF_INLINE void keep_answer(const struct work *w, size_t i, int from, by_base A)
{
    real *to = w->answer + i * (size_t)(6 * (7 - from));
    for (int r = 0; r < 6; r++)
        for (int c = from; c < 7; c++, to++)
            *to = w->all_move ? A[r][c] : real_choose(w->moving, A[r][c], *to);
}

WF_INLINE void count_unstable(struct work *w, const struct wf_beam_part *p, real S[6][6],
                              const struct kinematics *k, const struct wf_beam_wrench *down)
{
    real found = unstable_directions(p, S, k, w->margin);
    real_truth some = real_below(real_of(0), found);
    w->negative += found;
    if (real_any(some))
        w->bears = real_choose(some, real_max(w->bears, real_sqrt(wf_dot(down->n, down->n))), w->bears);
}

/* Element i: internal forces, residual, linearisation and elimination. */
WF_INLINE void down_element(struct work *w, size_t i, enum variation kind, bool counting)
{
    const struct wf_beam_part *p = &w->mesh->part[i];
    const double half = 0.5 * p->h;
    const int from = first_column(kind);
    const struct columns b = columns_of(from, TO_SIDE);
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = base_of(w, p, &ground);
    struct wf_beam_shape *u = &w->shape[i];
    struct turns o;
    struct wf_beam_stage s;
    struct real_load load[2];
    struct above above;
    struct wf_beam_wrench at[2], down;
    struct kinematics k;
    struct statics q;
    real P[6][6], S[6][6], T[6][6], Mn[2][9];
    by_base A, Z, B;
    real_truth apart = { 0 };
    turns_of(u, &o);
    stage_of(p, u, &o, base, &s);
    for (int j = 0; j < 2; j++)
        load_lanes(&w->air, &p->line[j], p->dead[j], s.r[j], s.t[j], kind != VARIES_NOT, &load[j]);
    collect(w, i, &above);
    balance_element(p->h, &s, NULL, load, &above.w, at, &down);
    kinematics_of(p, u, &o, base->L, &s, NULL, &k);
    statics_of(p, NULL, &s, load, kind, at, &q);
    misfit_add(p, NULL, &s, at, k.k, q.gap, &w->misfit);
    stiffen_kinematics(&k, 1 + element_damping(p, NULL, &k, &s, at));
    for (int j = 0; j < 2; j++) {
        real g[3];
        strain_of(p, base->L, &s, at, j, g);
        for (int c = 0; c < 3; c++) u->g[j][c] = real_choose(w->moving, g[c], u->g[j][c]);
    }
    end_motion_of(half, &k, &q, NULL, b, P, Z);
    element_equations(p, NULL, &k, &q, &s, at, NULL, from, S, A, Mn);
    attach_part_above(Mn, &above.node, P, Z, b, S, A);
    if (counting) count_unstable(w, p, S, &k, &down);
    w->broken |= solve6(S, A, b);
    if (real_any(w->guard) && real_any(apart = w->guard & leaps(A, P))) {
        by_base alone;
        apart_answer(p, u, base->L, at, alone);
        for (int r = 0; r < 6; r++)
            for (int c = from; c < 7; c++) A[r][c] = real_choose(apart, alone[r][c], A[r][c]);
    }
    for (int r = 0; r < 6; r++)
        for (int c = from; c < 7; c++) A[r][c] = -A[r][c];
    keep_answer(w, i, from, A);
    base_wrench_of(half, &q, load, NULL, b, T, B);
    follow_answer(half, &q, &above.node, P, T, A, b, Z, B);
    pass_down(w, i, p, from, B, apart, &down);
}

static __attribute__((noinline)) void down_upwards(struct work *w)
{
    for (size_t i = w->mesh->n; i-- > 0;) down_element(w, i, VARIES_UPWARDS, false);
}
static __attribute__((noinline)) void down_upwards_counting(struct work *w)
{
    for (size_t i = w->mesh->n; i-- > 0;) down_element(w, i, VARIES_UPWARDS, true);
}
static __attribute__((noinline)) void down_varies(struct work *w)
{
    for (size_t i = w->mesh->n; i-- > 0;) down_element(w, i, VARIES, false);
}
static __attribute__((noinline)) void down_varies_counting(struct work *w)
{
    for (size_t i = w->mesh->n; i-- > 0;) down_element(w, i, VARIES, true);
}

/* Compute the residual and the tangent of the lanes that move; of the others they stay. */
static void sweep_down(struct work *w, bool counting)
{
    struct beam_misfit kept = w->misfit;
    w->misfit = (struct beam_misfit){ 0 };
    w->broken = (real_truth){ 0 };
    w->negative = w->bears = real_of(0);
    for (int i = 0; i < 3; i++) w->base[i] = real_of(0);
    if (w->kind == VARIES)
        (counting ? down_varies_counting : down_varies)(w);
    else
        (counting ? down_upwards_counting : down_upwards)(w);
    w->misfit.bending = real_choose(w->moving, w->misfit.bending, kept.bending);
    w->misfit.energy = real_choose(w->moving, w->misfit.energy, kept.energy);
    w->misfit.strain = real_choose(w->moving, w->misfit.strain, kept.strain);
    w->misfit.turn = real_choose(w->moving, w->misfit.turn, kept.turn);
}

/* From the base up. */

/* Newton correction of an element's rotation vectors, in the axes of its base. */
WF_INLINE void correction(const real *answer, const struct wf_beam_shape *u, const struct turns *o,
                          const struct change *base, int from, real dv[2][3])
{
    const double limit = 0.7; /* rad */
    for (int j = 0; j < 2; j++) {
        real y[3], local[3], Ti[9];
        for (int i = 0; i < 3; i++) {
            const real *X = answer + (3 * j + i) * (7 - from);
            y[i] = X[6 - from];
            for (int c = from; c < 3; c++) y[i] += X[c - from] * base->place[c];
            for (int c = 0; c < 3; c++) y[i] += X[3 - from + c] * base->spin[c];
        }
        m3_apply_transposed(base->L, y, local);
        rotation_tangent_inverse(&o->at[j], u->v[j], o->x[j], Ti);
        m3_apply(Ti, local, dv[j]);
    }
    real most = real_max(wf_dot(dv[0], dv[0]), wf_dot(dv[1], dv[1]));
    real_truth far = real_below(real_of(limit * limit), most);
    if (!real_any(far)) return;
    real share = real_choose(far, limit / real_sqrt(most), real_of(1));
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++) dv[j][i] *= share;
}

/* Spin of the element's end by the correction dv, and that of its base. */
WF_INLINE void end_spin(const struct turns *o, const struct change *base, real dv[2][3], real spin[3])
{
    real d[3], local[3], Te[9];
    for (int i = 0; i < 3; i++) d[i] = gauss_end[0] * dv[0][i] + gauss_end[1] * dv[1][i];
    rotation_tangent(&o->to_end, o->end, o->x_end, Te);
    m3_apply(Te, d, local);
    m3_apply(base->L, local, spin);
    for (int i = 0; i < 3; i++) spin[i] += base->spin[i];
}

WF_INLINE void correct_element(struct work *w, size_t i, int from, struct change *end)
{
    const struct wf_beam_part *p = &w->mesh->part[i];
    struct wf_beam_shape *u = &w->shape[i];
    struct change still = { .place = { real_of(0), real_of(0), real_of(0) } }, *base = &still;
    struct turns o;
    real dv[2][3];
    if (p->parent >= 0)
        base = &w->slot[w->joints->slot[p->parent]].change;
    else
        for (int c = 0; c < 9; c++) still.L[c] = real_of(c % 4 == 0);
    turns_of(u, &o);
    correction(w->answer + i * (size_t)(6 * (7 - from)), u, &o, base, from, dv);
    end_spin(&o, base, dv, end->spin);
    w->turn = real_max(wf_dot(end->spin, end->spin), w->turn);
    for (int j = 0; j < 2; j++)
        for (int c = 0; c < 3; c++) {
            w->before[i][j][c] = u->v[j][c];
            u->v[j][c] = real_choose(w->moving, u->v[j][c] + dv[j][c], u->v[j][c]);
        }
}

WF_INLINE void place_end(struct work *w, size_t i)
{
    const struct wf_beam_part *p = &w->mesh->part[i];
    struct wf_beam_pose ground;
    struct turns o;
    struct wf_beam_pose end;
    turns_of(&w->shape[i], &o);
    end_of(p, &w->shape[i], &o, base_of(w, p, &ground), &end);
    if (!w->all_move) {
        const struct wf_beam_pose *old = &w->pose[i];
        for (int c = 0; c < 3; c++) end.r[c] = real_choose(w->moving, end.r[c], old->r[c]);
        for (int c = 0; c < 9; c++) end.L[c] = real_choose(w->moving, end.L[c], old->L[c]);
    }
    w->pose[i] = end;
    w->bend = real_max(w->bend, real_max(o.x[0], o.x[1]));
}

/* Place all elements. */
static __attribute__((noinline)) void sweep_up(struct work *w)
{
    w->bend = real_of(0);
    for (size_t i = 0; i < w->mesh->n; i++) place_end(w, i);
}

/* Correct and place all elements of the lanes that move. */
static __attribute__((noinline)) void step_up(struct work *w)
{
    const int from = first_column(w->kind);
    w->bend = w->turn = real_of(0);
    for (size_t i = 0; i < w->mesh->n; i++) {
        struct change end;
        struct wf_beam_pose old = w->pose[i];
        correct_element(w, i, from, &end);
        place_end(w, i);
        int32_t slot = w->joints->slot[i];
        if (slot < 0) continue;
        for (int c = 0; c < 3; c++) end.place[c] = w->pose[i].r[c] - old.r[c];
        memcpy(end.L, old.L, sizeof end.L);
        w->slot[slot].change = end;
    }
}

/* Shorten the last step of the lanes that move, to that share of it. */
static void step_back(struct work *w, real share)
{
    for (size_t i = 0; i < w->mesh->n; i++)
        for (int j = 0; j < 2; j++)
            for (int c = 0; c < 3; c++) {
                real *v = &w->shape[i].v[j][c], less = w->before[i][j][c] + share * (*v - w->before[i][j][c]);
                *v = real_choose(w->moving, less, *v);
            }
    sweep_up(w);
}

/* Newton's method; beam_newton.c says why its numbers are these. */

static real_truth converged(const struct work *w, double t)
{
    const double rounding = 8 * DBL_EPSILON;
    const struct beam_misfit *m = &w->misfit;
    return real_not_above(m->bending, t * t * m->energy) &
           real_not_above(real_sqrt(m->strain), t * real_sqrt(m->turn) + rounding);
}

/* Lanes whose last step, of that share of the whole, reduced the residual. */
static real_truth improved(const struct work *w, const struct beam_misfit *before, real share)
{
    return (real_not_above(w->misfit.bending, before->bending * (1 - 1e-4 * share)) |
            real_not_above(w->misfit.bending, 1e-24 * w->misfit.energy)) &
           ~w->broken & real_below(w->misfit.bending, real_of(INFINITY));
}

static void start(const struct wf_lanes *x, struct work *w)
{
    *w = work_of(x);
    set_loads(x, w);
    w->guard = ~(real_truth){ 0 };
    sweep_up(w);
    sweep_down(w, false);
}

/* Stable lanes, by the last counting sweep; its numbers are kept in *x for the lanes `here`. */
static real_truth stable(const struct work *w, real_truth here, struct wf_lanes *x)
{
    const double small = 0.01; /* of the force on the ground: parts that may snap to another shape */
    for (int k = 0; k < WF_WIDTH; k++)
        if (real_lane(here, k)) x->loose[k] = (size_t)real_lane(w->negative, k);
    return real_not_above(w->bears, small * real_sqrt(wf_dot(w->base, w->base)));
}

/* One step of the lanes `live`. Returned: those whose residual fell. */
static real_truth newton_step(struct work *w, struct wf_lanes *x, real_truth live, real_truth *counted,
                              real_truth *steady)
{
    const double turn_limit = 3, near = 1e-4;
    struct beam_misfit before = w->misfit;
    real_truth last = real_not_above(before.bending, near * near * before.energy);
    w->moving = live;
    w->all_move = true;
    w->guard = real_below(1e-3 * before.energy, before.bending);
    step_up(w);
    live &= real_below(w->turn, real_of(INFINITY));
    real share = real_of(1);
    w->moving = live & real_below(real_of(turn_limit * turn_limit), w->turn);
    if (real_any(w->moving)) {
        w->all_move = false;
        share = real_choose(w->moving, turn_limit / real_sqrt(w->turn), share);
        step_back(w, share);
    }
    w->all_move = true;
    w->margin = 1e-6 + 0.5 * w->bend;
    real_truth count = last & live;
    bool counting = real_any(count);
    w->moving = live;
    sweep_down(w, counting);
    real_truth good = improved(w, &before, share), halve = live & ~good;
    if (counting) *counted = (*counted & ~live) | (count & good), *steady = stable(w, count & good, x);
    for (int halvings = 1; halvings < 8 && real_any(halve); halvings++) {
        share *= 0.5;
        w->moving = halve;
        w->all_move = false;
        step_back(w, real_of(0.5));
        sweep_down(w, false);
        good |= halve & improved(w, &before, share);
        halve &= ~good;
    }
    return live & good;
}

static void newton(struct wf_lanes *x)
{
    enum { FEW = 20 };
    struct work w;
    real_truth rest = { 0 }, counted = { 0 }, steady = { 0 }, still = { 0 };
    start(x, &w);
    real_truth live = real_below(w.misfit.bending, real_of(INFINITY)) & ~w.broken;
    for (int k = 0; k < WF_WIDTH; k++) {
        x->iterations[k] = 0;
        if (!x->wanted[k]) real_lane(live, k) = 0;
    }
    for (int i = 0; i <= FEW; i++) {
        rest |= live & converged(&w, x->options->tolerance);
        live &= ~rest;
        if (!real_any(live) || i == FEW) break;
        for (int k = 0; k < WF_WIDTH; k++) x->iterations[k] += real_lane(live, k) != 0;
        real_truth now = { 0 }, still_now = { 0 };
        live = newton_step(&w, x, live, &now, &still_now);
        counted |= now, steady |= now & still_now;
    }
    real_truth left = rest & ~counted;
    if (real_any(left)) {
        w.moving = (real_truth){ 0 };
        w.all_move = true; /* no answer is needed any more */
        w.guard = (real_truth){ 0 };
        sweep_up(&w);
        w.margin = 1e-6 + 0.5 * w.bend;
        sweep_down(&w, true);
        still = stable(&w, left, x);
        steady |= left & still;
    }
    for (int k = 0; k < WF_WIDTH; k++)
        x->end[k] = real_lane(rest, k) && real_lane(steady, k) ? WF_LANE_RESTS : WF_LANE_LEFT;
}

static void iterate(struct wf_lanes *x)
{
    struct work w = work_of(x);
    set_loads(x, &w);
    sweep_down(&w, false);
    step_up(&w);
}

/* Reading the present shape. */

/* Loads and forces of element i, as struct wf_lanes_row of its row. */
WF_INLINE void read_element(struct work *w, size_t i, const real first[3], struct real_row *rows,
                            struct real_sums *sums)
{
    const struct wf_beam_part *p = &w->mesh->part[i];
    struct real_row *row = &rows[p->row];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = base_of(w, p, &ground);
    struct turns o;
    struct wf_beam_stage s;
    struct real_load load[2];
    struct above above;
    struct wf_beam_wrench at[2], down;
    turns_of(&w->shape[i], &o);
    stage_of(p, &w->shape[i], &o, base, &s);
    for (int j = 0; j < 2; j++) load_lanes(&w->air, &p->line[j], p->dead[j], s.r[j], s.t[j], 0, &load[j]);
    collect(w, i, &above);
    balance_element(p->h, &s, NULL, load, &above.w, at, &down);
    if ((int32_t)i == w->mesh->last[p->row]) row->end = above.w;
    for (int j = 0; j < 2; j++) {
        real arm[3], lever[3];
        for (int c = 0; c < 3; c++) arm[c] = s.r[j][c] - first[c];
        wf_cross(arm, load[j].force, lever);
        v3_add(row->load, real_of(0.5 * p->h), load[j].force);
        v3_add(sums->moment, real_of(0.5 * p->h), lever);
    }
    if ((int32_t)i == w->mesh->first[p->row]) {
        row->base = down;
        v3_add(sums->force, real_of(1), row->load);
    }
    if (p->parent < 0) {
        real arm[3], lever[3];
        for (int c = 0; c < 3; c++) arm[c] = base->r[c] - first[c];
        wf_cross(arm, down.n, lever);
        for (int c = 0; c < 3; c++) sums->ground.n[c] += down.n[c], sums->ground.m[c] += down.m[c] + lever[c];
        return;
    }
    struct wf_beam_wrench *to = &w->slot[w->joints->slot[p->parent]].above.w;
    if (w->joints->opens[i]) *to = (struct wf_beam_wrench){ 0 };
    for (int c = 0; c < 3; c++) to->n[c] += down.n[c], to->m[c] += down.m[c];
}

static void read_all(struct wf_lanes *x)
{
    struct work w = work_of(x);
    const struct wf_tree *t = x->mesh->tree;
    struct real_row *rows = (void *)x->row;
    struct real_sums *sums = (void *)x->sums;
    const real first[3] = { real_of(t->x0[0]), real_of(t->y0[0]), real_of(t->z0[0]) };
    set_loads(x, &w);
    sweep_up(&w);
    memset(rows, 0, t->n * sizeof *rows);
    memset(sums, 0, sizeof *sums);
    for (size_t i = x->mesh->n; i-- > 0;) read_element(&w, i, first, rows, sums);
    for (size_t i = 0; x->mesh->mass1 && i < x->mesh->n; i++) {
        real arm[3], lever[3], f[3] = { real_of(0), real_of(0), -x->mesh->mass1[i] * w.air.weight };
        for (int c = 0; c < 3; c++) arm[c] = w.pose[i].r[c] - first[c];
        wf_cross(arm, f, lever);
        for (int c = 0; c < 3; c++) sums->force[c] += f[c], sums->moment[c] += lever[c];
    }
}

/* From one mesh to another. */

/* Rotation from the base of a coarse element to arc fraction s (0..1) of its row. Returned: the element. */
WF_INLINE size_t rotation_at(const struct work *w, size_t row, double s, real R[9])
{
    double x;
    const int32_t at = w->mesh->first[row] + wf_beam_piece_at(w->mesh, row, s, &x);
    const struct wf_beam_shape *u = &w->shape[at];
    /* the quadratic through 0 at the base and the two Gauss points */
    double a = x * (x - gauss_place[1]) / (gauss_place[0] * (gauss_place[0] - gauss_place[1]));
    double c = x * (x - gauss_place[0]) / (gauss_place[1] * (gauss_place[1] - gauss_place[0]));
    real v[3];
    for (int i = 0; i < 3; i++) v[i] = a * u->v[0][i] + c * u->v[1][i];
    rotation_matrix(v, R);
    return (size_t)at;
}

/* Rotation vector of R, whose angle is small as a rule. */
WF_INLINE void small_rotation_vector(const real R[9], real v[3])
{
    v[0] = 0.5 * (R[7] - R[5]), v[1] = 0.5 * (R[2] - R[6]), v[2] = 0.5 * (R[3] - R[1]);
    real s2 = wf_dot(v, v), c = 0.5 * (R[0] + R[4] + R[8] - 1);
    /* asin(s) / s */
    real f = 1 + s2 * (1. / 6 + s2 * (3. / 40 + s2 * (5. / 112 + s2 * (35. / 1152 + s2 * (63. / 2816)))));
    real_truth large = real_below(real_of(0.05), s2) | real_below(c, real_of(0));
    for (int k = 0; k < WF_WIDTH && real_any(large); k++) {
        double s = sqrt(real_lane(s2, k));
        if (real_lane(large, k)) real_lane(f, k) = s > 0 ? atan2(s, real_lane(c, k)) / s : 1;
    }
    for (int i = 0; i < 3; i++) v[i] *= f;
}

static void turn_by_base(const struct work *w, size_t i, real R[9])
{
    struct wf_beam_pose ground;
    real copy[9];
    memcpy(copy, R, sizeof copy);
    m3_mul(base_of(w, &w->mesh->part[i], &ground)->L, copy, R);
}

static void carry(const struct wf_lanes *coarse, struct wf_lanes *fine)
{
    struct work from = work_of(coarse), to = work_of(fine);
    for (size_t i = 0; i < fine->mesh->n; i++) {
        size_t row = (size_t)fine->mesh->part[i].row;
        const int32_t k = (int32_t)i - fine->mesh->first[row], cut = wf_beam_pieces(fine->mesh, row);
        const double s0 = wf_beam_cut(fine->mesh, row, k, cut), s1 = wf_beam_cut(fine->mesh, row, k + 1, cut);
        for (int j = 0; j < 2; j++) {
            real base[9], at[9], R[9];
            size_t below = rotation_at(&from, row, s0, base);
            size_t here = rotation_at(&from, row, wf_between(s0, s1, gauss_place[j]), at);
            if (below != here) turn_by_base(&from, below, base), turn_by_base(&from, here, at);
            m3_mul_transposed(base, at, R);
            small_rotation_vector(R, to.shape[i].v[j]);
        }
    }
}

/* ---- Loads at many points of one state ---- */

static void take_points(const struct wf_loads *l, size_t n, const struct wf_lanes_point *p,
                        struct real_point *q)
{
    for (size_t k = 0; k < WF_WIDTH; k++) {
        const struct wf_lanes_point *from = &p[k < n ? k : n - 1]; /* lanes to spare repeat the last */
        const struct wf_line_point *line = from->line;
        for (int i = 0; i < 3; i++) real_lane(q->x[i], k) = from->x[i], real_lane(q->t[i], k) = from->t[i];
        real_lane(q->diameter, k) = line->diameter, real_lane(q->drag, k) = line->drag;
        real_lane(q->lift, k) = line->lift, real_lane(q->sail, k) = line->sail;
        real_lane(q->weight, k) = -line->mass * l->gravity * l->weight_scale;
    }
}

static void loads(const struct wf_loads *l, const struct wf_beam_growth *growth, size_t n,
                  const struct wf_lanes_point *p, struct wf_line_load *out, double (*change)[3])
{
    const struct wf_loads *all[WF_WIDTH];
    struct air air;
    for (int k = 0; k < WF_WIDTH; k++) all[k] = l;
    set_air(all, &air);
    if (growth) air.grows_speed = real_of(growth->speed), air.grows_density = real_of(growth->density);
    for (size_t from = 0; from < n; from += WF_WIDTH) {
        struct real_point point;
        struct real_load q;
        real grown[3];
        size_t some = n - from < WF_WIDTH ? n - from : WF_WIDTH;
        take_points(l, some, p + from, &point);
        load_points(&air, &point, &q, growth ? grown : NULL);
        for (size_t k = 0; k < some && growth; k++)
            for (int i = 0; i < 3; i++) change[from + k][i] = real_lane(grown[i], k);
        for (size_t k = 0; k < some; k++) {
            struct wf_line_load *to = &out[from + k];
            for (int i = 0; i < 3; i++)
                to->force[i] = real_lane(q.force[i], k) + l->point_scale * p[from + k].dead[i];
            for (int i = 0; i < 9; i++)
                to->by_place[i] = real_lane(q.by_place[i], k), to->by_turn[i] = real_lane(q.by_turn[i], k);
        }
    }
}

const struct wf_lanes_kernel NAMED(WF_WIDTH) = {
    .width = WF_WIDTH, .loads = loads, .newton = newton, .iterate = iterate, .read = read_all, .carry = carry
};

#if WF_WIDTH == 1 /* once */

static bool has_width(size_t width)
{
#ifdef __x86_64__
    if (width == 4) return __builtin_cpu_supports("avx2");
    if (width == 8) return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
#endif
    return true;
}

const struct wf_lanes_kernel *wf_lanes_kernel(size_t n)
{
#ifdef __x86_64__
    size_t width = n > 4 && has_width(8) ? 8 : 4;
#else
    size_t width = 4;
#endif
    const char *named = getenv("WINDFIRM_LANES");
    if (named && strlen(named) == 1 && strchr("148", *named)) width = (size_t)(*named - '0');
    if (width == 8 && has_width(8)) return &wf_lanes_8;
    return width >= 4 && has_width(4) ? &wf_lanes_4 : &wf_lanes_1;
}

#endif
