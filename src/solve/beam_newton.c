/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_newton.h"
#include "base/abreast.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"
#include "solve/beam_rest.h"
#include "solve/beam_team.h"
#include <float.h>

enum { AHEAD = 8 }; /* elements whose loads are computed together */

/* Sweeps over all elements. A parent always precedes its children, so each sweep is one loop. */

const struct wf_beam_pose *wf_beam_base(const struct wf_beam *b, size_t i, struct wf_beam_pose *ground)
{
    const struct wf_tree *t = b->mesh.tree;
    const struct wf_beam_part *p = &b->mesh.part[i];
    if (p->parent >= 0) return &b->pose[p->parent];
    ground->r[0] = t->x0[p->row], ground->r[1] = t->y0[p->row], ground->r[2] = t->z0[p->row];
    rotation_matrix(b->tilt[p->row], ground->L);
    return ground;
}

static bool held(const struct wf_beam *b, size_t i) { return b->held && b->held[i]; }

/* Does the element stand on one that is held? */
static bool on_held(const struct wf_beam *b, size_t i)
{
    int32_t below = b->mesh.part[i].parent;
    return b->held && below >= 0 && b->held[below];
}

/* Are the elements that do not stand on the ground computed by groups? */
static bool by_groups(const struct wf_beam *b) { return b->groups.n && !b->held && !(b->creep > 0); }

/* A stem by itself is computed beside those of other jobs. */
static bool in_team(const struct wf_beam *b)
{
    return b->chain && wf_abreast_inside() && !b->held && !(b->creep > 0) && !b->off && !b->weak &&
           !b->loads.ties && !b->loads.links;
}

static struct wf_groups_sweep groups_of(const struct wf_beam *b)
{
    return (struct wf_groups_sweep){ .mesh = &b->mesh,
                                     .groups = &b->groups,
                                     .loads = &b->loads,
                                     .shape = &b->shape->v[0][0],
                                     .pose = b->pose->r,
                                     .stage = &b->stage->r[0][0],
                                     .wrench = b->wrench->n,
                                     .load = &b->load[0][0][0],
                                     .node = &b->node->K[0][0],
                                     .answer = &b->answer->X[0][0],
                                     .small = b->small ? &b->small->R[0][0] : NULL,
                                     .off = b->off,
                                     .weak = b->weak,
                                     .frozen = b->frozen };
}

void wf_beam_sweep_up(struct wf_beam *b)
{
    struct wf_beam_pose ground;
    const bool groups = by_groups(b), many = groups || in_team(b);
    b->counted = false;
    for (size_t i = 0; i < b->mesh.n; i++)
        if (!held(b, i) && !(many && b->mesh.part[i].parent >= 0))
            wf_beam_place(&b->mesh.part[i], &b->shape[i], wf_beam_base(b, i, &ground), &b->stage[i],
                          &b->pose[i]);
    if (many) {
        struct wf_groups_sweep all = groups_of(b);
        if (groups)
            wf_groups_kernel(WF_LANES_MOST)->up(&all);
        else
            wf_beam_team_up(&all);
    }
    for (size_t i = 0; b->flat && i < b->mesh.n; i++) {
        if (held(b, i)) continue;
        b->flat[i] = b->mesh.flat[i];
        wf_beam_turn(&b->shape[i], wf_beam_base(b, i, &ground)->L, &b->flat[i]);
    }
}

/* Off-axis weight at the present load scale. */
static void set_side_weight(struct wf_beam *b)
{
    for (size_t i = 0; b->flat && i < b->mesh.n; i++)
        b->flat[i].weight = b->loads.weight_scale * b->loads.gravity;
}

static bool eliminate_element(struct wf_beam *b, size_t i, const double L[9],
                              const struct wf_beam_creep *creep, const struct wf_line_load load[2],
                              const struct wf_beam_wrench at[2], struct wf_beam_reaction *below, bool guard,
                              struct wf_beam_stability *count)
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_small *small = b->small ? &b->small[i] : NULL;
    if (b->flat)
        return wf_beam_eliminate_flat(p, &b->flat[i], &b->shape[i], L, creep, &b->stage[i], load, at,
                                      &b->node[i], &b->answer[i], below, guard, count, small);
    return wf_beam_eliminate(p, &b->shape[i], L, creep, &b->stage[i], load, at, &b->node[i], &b->answer[i],
                             below, guard, count, small);
}

/* Root plate of a row: springs c about x and y resist the tilt v, c v = T' m - m0, with m0 the moment in the
 * given shape of a standing tree (stiffness 0 = clamped). Adds
 * the plate's residual; given the reaction r of the tree on it, computes its Newton correction, its
 * compliance, and whether it is stable. */
static void tilt_root(struct wf_beam *b, size_t row, const struct wf_beam_wrench *w,
                      const struct wf_beam_reaction *r, struct wf_beam_stability *count)
{
    const double *c = b->options->root_stiffness, *v = b->tilt[row], still[3] = { 0 };
    const double rate = b->creep, *v0 = rate > 0 ? b->tilt0[row] : still;
    const double *m0 = b->mesh.root ? b->mesh.root[row] : still;
    double x = wf_dot(v, v), T[9], m[3], inverse[9] = { 0 }, *p = b->root_change[row];
    memset(p, 0, 6 * sizeof *p);
    if (!(c[0] > 0) && !(c[1] > 0)) return;
    struct rotation o = rotation_of(x);
    rotation_tangent(&o, v, x, T);
    m3_apply_transposed(T, w->m, m);
    v3_add(m, -1, m0);
    for (int j = 0; j < 2; j++)
        if (c[j] > 0) {
            double miss = c[j] * ((1 + rate) * v[j] - rate * v0[j]) - m[j];
            b->misfit.bending += 0.5 * miss * miss / c[j];
            b->misfit.energy += 0.5 * m[j] * m[j] / c[j];
        }
    if (!r) return;
    double K[9], KT[9], Tt[9], TKT[9], D[9], step[9], k[3], push[3];
    const double back[3] = { -v[0], -v[1], -v[2] };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) K[3 * i + j] = r->K[3 + i][3 + j], Tt[3 * i + j] = T[3 * j + i];
    m3_mul(K, T, KT);
    m3_mul(Tt, KT, TKT);
    rotation_tangent_slope(&o, back, w->m, D); /* T(v)' = T(-v): d(T' m)/dv = -D */
    double S[2][2] = { { (1 + rate) * c[0] - TKT[0] + D[0], D[1] - TKT[1] },
                       { D[3] - TKT[3], (1 + rate) * c[1] - TKT[4] + D[4] } };
    for (int j = 0; j < 2; j++) /* no spring: clamped about that axis */
        if (!(c[j] > 0)) S[j][j] = INFINITY, S[0][1] = S[1][0] = 0;
    double rest = S[1][1] - S[1][0] * (S[0][1] / S[0][0]), across = S[0][1] / S[0][0] / rest;
    if (count)
        count->negative += (size_t)(S[0][0] < -count->margin * c[0]) + (size_t)(rest < -count->margin * c[1]);
    inverse[0] = (1 + across * S[1][0]) / S[0][0], inverse[1] = -across;
    inverse[3] = -S[1][0] / S[0][0] / rest, inverse[4] = 1 / rest;
    m3_apply_transposed(T, r->k + 3, k);
    for (int j = 0; j < 3; j++) push[j] = j < 2 ? k[j] + m[j] - c[j] * ((1 + rate) * v[j] - rate * v0[j]) : 0;
    m3_apply(inverse, push, b->root_step[row]);
    m3_apply(T, b->root_step[row], p + 3);
    m3_mul(T, inverse, step);
    m3_mul(step, Tt, b->root_give[row]);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 3; j++) b->root_hold[row][i][j] = r->K[i][3 + j];
}

/* Loads of elements, computed some ahead of the sweep down, side by side. */
struct ahead {
    const struct wf_lanes_kernel *kernel;
    size_t most; /* at once */
    size_t n, used;
    struct wf_line_load load[AHEAD][2];
};

/* The loads of element i and of those that follow it on the way down. */
static void load_ahead(const struct wf_beam *b, size_t i, struct ahead *a)
{
    struct wf_lanes_point point[2 * AHEAD];
    size_t points = 0;
    for (size_t k = i + 1; k-- > 0 && points < 2 * a->most;)
        for (int j = 0; j < 2 && !held(b, k); j++)
            point[points++] = (struct wf_lanes_point){ b->stage[k].r[j], b->stage[k].t[j],
                                                       b->mesh.part[k].dead[j], &b->mesh.part[k].line[j] };
    a->kernel->loads(&b->loads, points, point, &a->load[0][0]);
    a->n = points / 2, a->used = 0;
}

static struct wf_line_load *load_of(const struct wf_beam *b, size_t i, struct ahead *a)
{
    if (a->used == a->n) load_ahead(b, i, a);
    struct wf_line_load *load = a->load[a->used++];
    for (int j = 0; j < 2 && b->frozen; j++)
        memset(load[j].by_place, 0, sizeof load[j].by_place),
            memset(load[j].by_turn, 0, sizeof load[j].by_turn);
    return load;
}

/* The elements that do not stand on the ground, by groups or beside those of other trees. */
static bool many_down(struct wf_beam *b, bool tangent, bool guard, struct wf_beam_stability *count)
{
    struct wf_groups_sweep x = groups_of(b);
    x.tangent = tangent, x.guard = guard, x.counting = count;
    if (count) x.margin = count->margin;
    bool whole = by_groups(b) ? wf_groups_kernel(WF_LANES_MOST)->down(&x) : wf_beam_team_down(&x);
    b->misfit = (struct wf_beam_misfit){ x.bending, x.energy, x.strain, x.turn };
    if (count) count->negative = x.negative, count->bears = x.bears;
    return whole;
}

bool wf_beam_sweep_down(struct wf_beam *b, bool tangent, struct wf_beam_stability *count)
{
    const bool groups = by_groups(b) || in_team(b);
    struct ahead ahead = { .kernel = wf_lanes_kernel(WF_LANES_MOST), .most = groups ? 1 : AHEAD };
    struct wf_beam_pose ground, lowest;
    const double *first = wf_beam_base(b, 0, &lowest)->r;
    /* far from equilibrium the tangent is guarded (beam_eliminate.h); near it the tangent is exact */
    bool guard = !count && b->misfit.bending > 1e-3 * b->misfit.energy;
    b->misfit = (struct wf_beam_misfit){ 0 };
    b->counted = false;
    if (count) count->negative = 0, count->bears = 0;
    if (!b->held) b->base = (struct wf_beam_wrench){ { 0 }, { 0 } };
    wf_beam_ends_load(b);
    set_side_weight(b);
    if (tangent) wf_beam_ends_react(b);
    if (groups && !many_down(b, tangent, guard, count)) return false;
    for (size_t i = b->mesh.n; i-- > 0;) {
        if (held(b, i) || (groups && b->mesh.part[i].parent >= 0)) continue;
        const struct wf_beam_part *p = &b->mesh.part[i];
        const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
        const struct wf_beam_flat *flat = wf_beam_flat_of(b, i);
        const struct wf_beam_creep slow = { b->creep, (const double(*)[3])(b->creep > 0 ? b->k0[i] : NULL) };
        const struct wf_beam_creep *creep = b->creep > 0 ? &slow : NULL;
        struct wf_line_load *load = load_of(b, i, &ahead);
        struct wf_beam_wrench at[2], down;
        struct wf_beam_reaction root = { { { 0 } }, { 0 } };
        bool grounded = p->parent < 0, cut = on_held(b, i);
        double before = b->misfit.bending;
        for (int j = 0; j < 2; j++) memcpy(b->load[i][j], load[j].force, sizeof b->load[i][j]);
        wf_beam_balance(p->h, &b->stage[i], flat, load, &b->wrench[i], at, &down);
        wf_beam_misfit_add(p, &b->shape[i], base->L, creep, &b->stage[i], flat, at, &b->misfit);
        size_t unstable = count ? count->negative : 0;
        if (tangent && !eliminate_element(b, i, base->L, creep, load, at,
                                          grounded || cut ? &root : &b->node[p->parent], guard, count))
            return false;
        if (count && count->negative > unstable) {
            count->bears = fmax(count->bears, sqrt(wf_dot(down.n, down.n)));
            if (b->weak) b->weak[i] = true;
        }
        if (b->off) b->off[i] = b->misfit.bending - before;
        if (cut) continue;
        if (!grounded) {
            v3_add(b->wrench[p->parent].n, 1, down.n);
            v3_add(b->wrench[p->parent].m, 1, down.m);
            continue;
        }
        double arm[3] = { base->r[0] - first[0], base->r[1] - first[1], base->r[2] - first[2] }, lever[3];
        wf_cross(arm, down.n, lever);
        v3_add(b->base.n, 1, down.n);
        v3_add(b->base.m, 1, down.m);
        v3_add(b->base.m, 1, lever);
        unstable = count ? count->negative : 0;
        tilt_root(b, (size_t)p->row, &down, tangent ? &root : NULL, count);
        if (count && count->negative > unstable) count->bears = INFINITY;
    }
    if (b->links && !wf_beam_links_join(b, tangent, count)) return false;
    if (count) b->stability = *count;
    b->counted = count && isfinite(b->misfit.bending);
    return isfinite(b->misfit.bending);
}

/* The beam and Newton's method. */

/* What Newton's method works with. */
static bool take_newton(struct wf_beam *b, struct wf_arena *a)
{
    size_t n = b->mesh.n;
    b->node = WF_TAKE(a, n, struct wf_beam_reaction);
    b->answer = WF_TAKE(a, n, struct wf_beam_answer);
    b->change = wf_arena_take(a, n, sizeof *b->change);
    b->dv = wf_arena_take(a, n, sizeof *b->dv);
    return b->node && b->answer && b->change && b->dv;
}

enum wf_status wf_beam_init(struct wf_beam *b, const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, const int32_t *pieces, struct wf_arena *a,
                            struct wf_arena *newton, struct wf_err *e)
{
    *b = (struct wf_beam){ .loads = *l, .options = o };
    enum wf_status status = wf_beam_mesh_build(t, l, o, pieces, a, &b->mesh, e);
    if (status) return status;
    wf_beam_rest(&b->mesh, l->gravity * l->weight_scale);
    if (newton && !b->mesh.flat && (status = wf_beam_groups_make(&b->mesh, a, &b->groups, e))) return status;
    struct wf_arena *forces = newton ? newton : a;
    size_t n = b->mesh.n;
    b->chain = n > 1 && !b->mesh.flat;
    for (size_t i = 0; i < n && b->chain; i++) b->chain = b->mesh.part[i].parent == (int32_t)i - 1;
    b->tilt = wf_arena_take(a, t->n, sizeof *b->tilt);
    b->root_step = wf_arena_take(a, t->n, sizeof *b->root_step);
    b->root_change = wf_arena_take(a, t->n, sizeof *b->root_change);
    b->root_give = wf_arena_take(a, t->n, sizeof *b->root_give);
    b->root_hold = wf_arena_take(a, t->n, sizeof *b->root_hold);
    b->shape = WF_TAKE(a, n, struct wf_beam_shape);
    b->pose = WF_TAKE(a, n, struct wf_beam_pose);
    b->stage = WF_TAKE(forces, n, struct wf_beam_stage);
    if (b->mesh.flat) b->flat = WF_TAKE(a, n, struct wf_beam_flat);
    b->wrench = WF_TAKE(forces, n, struct wf_beam_wrench);
    b->load = wf_arena_take(forces, n, sizeof *b->load);
    if (!b->tilt || !b->root_step || !b->root_change || !b->root_give || !b->root_hold || !b->shape ||
        !b->pose || !b->stage || !b->wrench || !b->load || (newton && !take_newton(b, newton)) ||
        (b->mesh.flat && !b->flat))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the state of %zu beam elements", n);
    return l->links && newton ? wf_beam_links_take(b, a, newton, e) : WF_OK;
}

/* Limit an element's own rotation; everything above it moves accordingly. base, end: changes of its ends. */
static void limit_turn(const struct wf_beam_pose *at_base, const struct wf_beam_pose *at_end,
                       const double base[6], double dv[2][3], double end[6])
{
    const double limit = 0.7; /* rad */
    double most = fmax(wf_dot(dv[0], dv[0]), wf_dot(dv[1], dv[1])), arm[3], swing[3];
    if (most <= limit * limit) return;
    double share = limit / sqrt(most);
    for (int i = 0; i < 3; i++) arm[i] = at_end->r[i] - at_base->r[i];
    wf_cross(base + 3, arm, swing);
    for (int i = 0; i < 3; i++) {
        double place = base[i] + swing[i];
        dv[0][i] *= share, dv[1][i] *= share;
        end[i] = place + share * (end[i] - place);
        end[3 + i] = base[3 + i] + share * (end[3 + i] - base[3 + i]);
    }
}

/* Newton corrections of all unknowns, from the base up. Returned: largest rotation of a node [rad]. */
static double newton_corrections(struct wf_beam *b)
{
    static const double still[6];
    double most = 0;
    if (b->links) wf_beam_links_keep(b);
    for (size_t i = 0; i < b->mesh.n; i++) {
        if (held(b, i)) continue;
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_pose ground;
        const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
        const double *below = p->parent >= 0 ? b->change[p->parent] : b->root_change[p->row];
        if (on_held(b, i)) below = still;
        wf_beam_correct(&b->shape[i], base->L, &b->answer[i], &b->node[i], below, b->dv[i], b->change[i]);
        limit_turn(base, &b->pose[i], below, b->dv[i], b->change[i]);
        most = fmax(most, wf_dot(b->change[i] + 3, b->change[i] + 3));
    }
    return sqrt(most);
}

static void apply_correction(struct wf_beam *b, double share)
{
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2 && !held(b, i); j++) v3_add(b->shape[i].v[j], share, b->dv[i][j]);
    for (size_t i = 0; i < b->mesh.tree->n && !b->held; i++)
        if (b->mesh.tree->parent[i] < 0) v3_add(b->tilt[i], share, b->root_step[i]);
    if (b->links) wf_beam_links_stretch(b, share);
    wf_beam_sweep_up(b);
}

/* The margin allows for neutral directions (a fallen stem may rotate about the vertical without any work)
 * and for the tangent, which is symmetric only to second order in an element's own rotation. */
static double stability_margin(const struct wf_beam *b)
{
    double turn = 0;
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2 && !held(b, i); j++)
            turn = fmax(turn, wf_dot(b->shape[i].v[j], b->shape[i].v[j]));
    return 1e-6 + 0.5 * turn;
}

static bool step_reduces(const struct wf_beam *b, const struct wf_beam_misfit *before, double share)
{
    return b->misfit.bending <= before->bending * (1 - 1e-4 * share) ||
           b->misfit.bending <= 1e-24 * b->misfit.energy; /* at rounding */
}

/* One Newton step, halved until the residual falls. With `watch`, unstable directions are counted in
 * what is probably the last step, which saves wf_beam_stable a sweep. false: no step length reduces the
 * residual. */
static bool newton_step(struct wf_beam *b, bool watch)
{
    const double turn_limit = 3; /* [rad] rotation of a node in one step */
    /* relative residual before the last step: convergence is quadratic */
    const double near = fmin(fmax(1e-4, 3 * sqrt(b->options->tolerance)), 0.3);
    double turn = newton_corrections(b), share = turn > turn_limit ? turn_limit / turn : 1, done = 0;
    struct wf_beam_misfit before = b->misfit;
    struct wf_beam_stability count;
    bool last = watch && before.bending <= near * near * before.energy;
    if (!isfinite(turn)) return false;
    for (int halvings = 0; halvings < 8; halvings++, share *= 0.5) {
        struct wf_beam_misfit tried = b->misfit;
        bool whole =
            halvings == 0; /* a shorter step is tried without the tangent first, at a quarter of the cost */
        apply_correction(b, share - done);
        done = share;
        if (last) count.margin = stability_margin(b);
        if (!wf_beam_sweep_down(b, whole, whole && last ? &count : NULL)) continue;
        if (!step_reduces(b, &before, share)) continue;
        if (whole) return true;
        b->misfit = tried; /* the guard of the sweep looks at it */
        if (wf_beam_sweep_down(b, true, last ? &count : NULL)) return true;
    }
    return false;
}

static bool newton_converged(const struct wf_beam *b)
{
    const double rounding = 8 * DBL_EPSILON; /* of unit tangents */
    double t = b->options->tolerance;
    return b->misfit.bending <= t * t * b->misfit.energy && b->misfit.strain <= t * b->misfit.turn + rounding;
}

static enum wf_status newton(struct wf_beam *b, bool watch)
{
    enum { STALL = 16 }; /* where the square of the residual has not halved in so many, it seldom converges */
    double before = INFINITY;
    b->misfit = (struct wf_beam_misfit){ .bending = 1, .energy = 1 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL)) return WF_ENOCONV;
    for (size_t i = 0; i < b->options->iterations_max && !newton_converged(b); i++) {
        if (i % STALL == 0) {
            if (b->misfit.bending > 0.5 * before) return WF_ENOCONV;
            before = b->misfit.bending;
        }
        b->iterations++;
        if (!newton_step(b, watch)) return WF_ENOCONV;
    }
    return newton_converged(b) ? WF_OK : WF_ENOCONV;
}

enum wf_status wf_beam_newton(struct wf_beam *b) { return newton(b, false); }

/* Fallbacks that reach equilibrium at full load, or report that there is none; they always terminate. */

enum { EFFORT = 300 }; /* Newton iterations allowed for load steps, and again for creep, before giving up */

struct saved_shape {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
};

static void save_shape(const struct wf_beam *b, struct saved_shape *s)
{
    memcpy(s->shape, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(s->tilt, b->tilt, b->mesh.tree->n * sizeof *b->tilt);
}

static void restore_shape(struct wf_beam *b, const struct saved_shape *s)
{
    memcpy(b->shape, s->shape, b->mesh.n * sizeof *b->shape);
    memcpy(b->tilt, s->tilt, b->mesh.tree->n * sizeof *b->tilt);
}

static void scale_loads(struct wf_beam *b, const struct wf_loads *full, double share)
{
    b->loads.wind_scale = share * full->wind_scale;
    b->loads.weight_scale = share * full->weight_scale;
    b->loads.point_scale = share * full->point_scale;
    wf_beam_rest(&b->mesh, b->loads.gravity * b->loads.weight_scale);
}

/* A twig that may snap to another shape does not bring down the tree: parts that carry less than a hundredth
 * of the force on the ground are counted (loose), not refused. */
bool wf_beam_stable(struct wf_beam *b)
{
    const double small = 0.01;
    struct wf_beam_stability count = { .margin = stability_margin(b) };
    if (!b->counted && !wf_beam_sweep_down(b, true, &count)) return false;
    b->loose = b->stability.negative;
    return b->stability.bears <= small * sqrt(wf_dot(b->base.n, b->base.n));
}

bool wf_beam_rests(struct wf_beam *b) { return newton(b, true) == WF_OK && wf_beam_stable(b); }

bool wf_beam_finish(struct wf_beam *b)
{
    if (!isfinite(newton_corrections(b))) return false;
    apply_correction(b, 1);
    return wf_beam_sweep_down(b, false, NULL);
}

bool wf_beam_step(struct wf_beam *b, bool *stable)
{
    struct wf_beam_stability count = { .margin = stable ? stability_margin(b) : 0 };
    bool swept = wf_beam_sweep_down(b, true, stable ? &count : NULL);
    if (stable) *stable = swept && wf_beam_stable(b);
    return swept && wf_beam_finish(b);
}

bool wf_beam_apart(const struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.n; i++) {
        bool follows = false;
        for (int r = 0; r < 6 && !follows; r++)
            for (int c = 0; c < 6; c++) follows = follows || b->answer[i].X[r][c] != 0;
        if (!follows) return true;
    }
    return false;
}

/* Load steps from the unloaded tree, halved where Newton stalls or the state is unstable. Returned: share of
 * the load reached. */
static double load_steps(struct wf_beam *b, const struct wf_loads *full, struct saved_shape *last)
{
    double share = 0, size = 0.25;
    for (size_t i = 0; i < b->mesh.n; i++)
        if (!held(b, i)) b->shape[i] = (struct wf_beam_shape){ 0 };
    if (!b->held) memset(b->tilt, 0, b->mesh.tree->n * sizeof *b->tilt);
    save_shape(b, last);
    size_t most = b->iterations + EFFORT;
    while (share < 1 && size > 2e-4 && b->iterations < most) {
        double next = fmin(1, share + size);
        scale_loads(b, full, next);
        if (wf_beam_rests(b)) {
            share = next;
            size *= 2;
            b->steps++;
            save_shape(b, last);
        } else {
            restore_shape(b, last);
            size *= 0.5;
        }
    }
    return share;
}

/* Perturb the shape by a small sideways bow, so that it can leave an unstable equilibrium. */
static void perturb_shape(struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.tree->n && !b->held; i++)
        for (int j = 0; j < 2; j++)
            if (b->options->root_stiffness[j] > 0) b->tilt[i][j] += j ? 2e-4 : 6e-5;
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2 && !held(b, i); j++)
            b->shape[i].v[j][1] += 1e-4 * (j + 1), b->shape[i].v[j][0] += 3e-5 * (j + 1);
}

/* Kelvin-Voigt creep under the full load: each step solves the tree with a section moment G^-1 (k + rate (k
 * - k_old)), an implicit Euler step of viscous motion of length 1/rate. If the step is short enough it has a
 * stable solution, however far away the elastic one is. (An unstable equilibrium of a longer step would lead
 * back to the shape that is to be left, and is refused.) The rate falls while the steps succeed; at rate 0
 * the elastic equilibrium remains. */
static bool creep_to_rest(struct wf_beam *b, struct saved_shape *last)
{
    double rate = 64;
    size_t most = b->iterations + EFFORT;
    b->tilt0 = last->tilt;
    for (int k = 0; k < 400 && b->iterations < most; k++) {
        save_shape(b, last);
        for (size_t i = 0; i < b->mesh.n; i++) wf_beam_curvature(&b->mesh.part[i], &b->shape[i], b->k0[i]);
        b->creep = rate;
        bool moved = wf_beam_rests(b);
        b->creep = 0;
        b->steps++;
        if (!moved) {
            restore_shape(b, last);
            rate *= 4;
            if (rate > 1e9) return false;
            continue;
        }
        rate *= 0.6;
        if (rate > 0.02) continue;
        save_shape(b, last);
        if (wf_beam_rests(b)) return true;
        restore_shape(b, last);
        if (rate < 1e-8)
            rate = 1; /* ever slower creep has not left an unstable shape: start again with a fast step */
    }
    return false;
}

/* What the fallbacks need beside the beam. */
struct fallback {
    struct saved_shape last;
    double *off;
    bool *held;
};

static bool take_fallback(struct wf_beam *b, struct wf_arena *a, struct fallback *f)
{
    f->last.shape = WF_TAKE(a, b->mesh.n, struct wf_beam_shape);
    f->last.tilt = wf_arena_take(a, b->mesh.tree->n, sizeof *f->last.tilt);
    b->k0 = wf_arena_take(a, b->mesh.n, sizeof *b->k0);
    f->off = WF_TAKE(a, b->mesh.n, double);
    f->held = WF_TAKE(a, b->mesh.n, bool);
    return f->last.shape && f->last.tilt && b->k0 && f->off && f->held;
}

static double carried(const struct wf_beam *b, size_t i)
{
    return sqrt(wf_dot(b->wrench[i].n, b->wrench[i].n));
}

/* The lowest element of the part that is to be settled with element i: it carries less than a hundredth of
 * the force on the ground or, where i itself carries more, hardly more than i. -1: the part would be a large
 * one. */
static int32_t part_of(const struct wf_beam *b, size_t i, double force)
{
    const double small = 0.01, large = 0.2, hardly = 1.2;
    const double limit = fmax(small * force, hardly * carried(b, i));
    int32_t root = (int32_t)i, below;
    if (!(carried(b, i) <= large * force)) return -1;
    while ((below = b->mesh.part[root].parent) >= 0 && carried(b, (size_t)below) <= limit) root = below;
    return below < 0 ? -1 : root;
}

/* Hold all but the parts in which Newton's residual is. false: they would be large. */
static bool hold_the_rest(struct wf_beam *b, struct fallback *f)
{
    const double slight = 1e-3;
    double most = 0;
    b->off = f->off;
    b->held = NULL;
    wf_beam_sweep_up(b);
    bool swept = wf_beam_sweep_down(b, true, NULL);
    b->off = NULL;
    if (!swept || b->misfit.bending > 1e-3 * b->misfit.energy) return false;
    const double force = sqrt(wf_dot(b->base.n, b->base.n));
    for (size_t i = 0; i < b->mesh.n; i++) most = fmax(most, f->off[i]), f->held[i] = true;
    for (size_t i = 0; i < b->mesh.n; i++) {
        if (!(f->off[i] >= slight * most)) continue;
        int32_t root = part_of(b, i, force);
        if (root < 0) return false;
        f->held[root] = false;
    }
    for (size_t i = 0; i < b->mesh.n; i++) /* and all above them */
        if (b->mesh.part[i].parent >= 0 && !f->held[b->mesh.part[i].parent]) f->held[i] = false;
    return true;
}

/* Load steps, then creep. */
static bool step_and_creep(struct wf_beam *b, const struct wf_loads *full, struct fallback *f,
                           struct wf_beam_outcome *out)
{
    out->load_factor = load_steps(b, full, &f->last);
    if (out->load_factor >= 1) return true;
    restore_shape(b, &f->last);
    scale_loads(b, full, 1);
    perturb_shape(b);
    out->beyond_limit = true;
    return creep_to_rest(b, &f->last);
}

/* Load steps of the parts that are not held, the motion of their bases given; where a part has no continuous
 * path to the full load, it falls to the shape that creep leads to. */
static bool settle_free_parts(struct wf_beam *b, struct fallback *f)
{
    const struct wf_loads now = b->loads;
    struct wf_beam_outcome out;
    b->held = f->held;
    bool moved = step_and_creep(b, &now, f, &out);
    b->held = NULL;
    b->loads = now;
    return moved;
}

bool wf_beam_settle_parts(struct wf_beam *b, struct wf_arena *a)
{
    enum { ROUNDS = 4 };
    struct fallback f = { 0 };
    if (!take_fallback(b, a, &f)) return false;
    for (int round = 0; round < ROUNDS && hold_the_rest(b, &f); round++) {
        if (!settle_free_parts(b, &f)) return false;
        if (wf_beam_rests(b)) return true;
    }
    return false;
}

enum wf_status wf_beam_step_to_rest(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                                    struct wf_err *e)
{
    const struct wf_loads full = b->loads;
    struct fallback f = { 0 };
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (!take_fallback(b, a, &f)) return wf_fail(e, WF_ENOMEM, "not enough memory for load steps");
    if (step_and_creep(b, &full, &f, out)) return WF_OK;
    return wf_fail(e, WF_EUNSTABLE,
                   "no stable equilibrium found at full load; the last one is at %.4g of the load",
                   out->load_factor);
}

enum wf_status wf_beam_settle(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                              struct wf_err *e)
{
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    return wf_beam_rests(b) ? WF_OK : wf_beam_step_to_rest(b, a, out, e);
}
