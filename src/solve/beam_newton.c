/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_newton.h"
#include "base/abreast.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"
#include "solve/beam_parts.h"
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

/* Does the element stand on one that is held? */
static bool on_held(const struct wf_beam *b, size_t i)
{
    int32_t below = b->mesh.part[i].parent;
    return b->only && below >= 0 && b->only->held[below];
}

/* Are the elements that do not stand on the ground computed by groups? */
static bool by_groups(const struct wf_beam *b) { return b->groups.n && !b->only && !(b->creep > 0); }

/* A stem by itself is computed beside those of other jobs. */
static bool in_team(const struct wf_beam *b)
{
    return b->chain && wf_abreast_inside() && !b->only && !(b->creep > 0) && !b->off && !b->weak &&
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
                                     .side = b->side->v[0],
                                     .off = b->off,
                                     .weak = b->weak,
                                     .frozen = b->frozen };
}

void wf_beam_sweep_up(struct wf_beam *b)
{
    struct wf_beam_pose ground;
    const bool groups = by_groups(b), many = groups || in_team(b);
    b->counted = false;
    for (size_t k = 0; k < wf_beam_moving(b); k++) {
        size_t i = wf_beam_moved(b, k);
        if (!(many && b->mesh.part[i].parent >= 0))
            wf_beam_place(&b->mesh.part[i], &b->shape[i], wf_beam_base(b, i, &ground), &b->stage[i],
                          &b->pose[i]);
    }
    if (many) {
        struct wf_groups_sweep all = groups_of(b);
        if (groups)
            wf_groups_kernel(WF_LANES_MOST)->up(&all);
        else
            wf_beam_team_up(&all);
    }
    for (size_t k = 0; b->flat && k < wf_beam_moving(b); k++) {
        size_t i = wf_beam_moved(b, k);
        b->flat[i] = b->mesh.flat[i];
        wf_beam_turn(&b->shape[i], wf_beam_base(b, i, &ground)->L, &b->flat[i]);
    }
}

/* Off-axis weight at the present load scale. */
static void set_side_weight(struct wf_beam *b)
{
    for (size_t k = 0; b->flat && k < wf_beam_moving(b); k++)
        b->flat[wf_beam_moved(b, k)].weight = b->loads.weight_scale * b->loads.gravity;
}

static bool eliminate_element(struct wf_beam *b, size_t i, const double L[9],
                              const struct wf_beam_creep *creep, const struct wf_line_load load[2],
                              const struct wf_beam_wrench at[2], struct wf_beam_reaction *below,
                              struct wf_beam_also *also)
{
    const struct wf_beam_part *p = &b->mesh.part[i];
    also->small = b->small ? &b->small[i] : NULL;
    also->side = &b->side[i];
    if (b->flat)
        return wf_beam_eliminate_flat(p, &b->flat[i], &b->shape[i], L, creep, &b->stage[i], load, at,
                                      &b->node[i], &b->answer[i], below, also);
    return wf_beam_eliminate(p, &b->shape[i], L, creep, &b->stage[i], load, at, &b->node[i], &b->answer[i],
                             below, also);
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
    const struct wf_beam_growth *growth; /* NULL: none */
    size_t most;                         /* at once */
    size_t n, used;
    struct wf_line_load load[AHEAD][2];
    double change[AHEAD][2][3]; /* by the growth */
};

/* The loads of the k-th element that moves and of those that follow it on the way down. */
static void load_ahead(const struct wf_beam *b, size_t k, struct ahead *a)
{
    struct wf_lanes_point point[2 * AHEAD];
    size_t points = 0;
    for (k++; k-- > 0 && points < 2 * a->most;) {
        size_t i = wf_beam_moved(b, k);
        for (int j = 0; j < 2; j++)
            point[points++] = (struct wf_lanes_point){ b->stage[i].r[j], b->stage[i].t[j],
                                                       b->mesh.part[i].dead[j], &b->mesh.part[i].line[j] };
    }
    a->kernel->loads(&b->loads, a->growth, points, point, &a->load[0][0], a->change[0]);
    a->n = points / 2, a->used = 0;
}

static struct wf_line_load *load_of(const struct wf_beam *b, size_t k, struct ahead *a)
{
    if (a->used == a->n) load_ahead(b, k, a);
    struct wf_line_load *load = a->load[a->used++];
    for (int j = 0; j < 2 && b->frozen; j++)
        memset(load[j].by_place, 0, sizeof load[j].by_place),
            memset(load[j].by_turn, 0, sizeof load[j].by_turn);
    return load;
}

/* The elements that do not stand on the ground, by groups or beside those of other trees. */
static bool many_down(struct wf_beam *b, bool tangent, struct wf_beam_also *also,
                      const struct wf_beam_growth *growth)
{
    struct wf_groups_sweep x = groups_of(b);
    struct wf_beam_stability *count = also->count;
    x.tangent = tangent, x.guard = also->guard, x.counting = count;
    if (growth) x.grows = true, x.growth = *growth;
    if (count) x.margin = count->margin;
    bool whole = by_groups(b) ? wf_groups_kernel(WF_LANES_MOST)->down(&x) : wf_beam_team_down(&x);
    b->misfit = (struct wf_beam_misfit){ x.bending, x.energy, x.strain, x.turn };
    if (count) count->negative = x.negative, count->bears = x.bears;
    also->apart = x.apart;
    return whole;
}

/* What stands on the ground: its wrench, and with the tangent (else NULL) its reaction. */
static void ground_element(struct wf_beam *b, size_t i, const struct wf_beam_pose *base,
                           const struct wf_beam_wrench *down, const struct wf_beam_reaction *root,
                           struct wf_beam_stability *count)
{
    struct wf_beam_pose lowest;
    const double *first = wf_beam_base(b, 0, &lowest)->r;
    double arm[3] = { base->r[0] - first[0], base->r[1] - first[1], base->r[2] - first[2] }, lever[3];
    wf_cross(arm, down->n, lever);
    v3_add(b->base.n, 1, down->n);
    v3_add(b->base.m, 1, down->m);
    v3_add(b->base.m, 1, lever);
    size_t unstable = count ? count->negative : 0;
    tilt_root(b, (size_t)b->mesh.part[i].row, down, root, count);
    if (count && count->negative > unstable) count->bears = INFINITY;
    if (root) memcpy(b->root_side[b->mesh.part[i].row], root->side, sizeof root->side);
}

/* An element on the way down. false: its tangent is singular. */
static bool down_element(struct wf_beam *b, size_t k, bool tangent, struct ahead *ahead,
                         struct wf_beam_also *also)
{
    const size_t i = wf_beam_moved(b, k);
    const struct wf_beam_part *p = &b->mesh.part[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
    const struct wf_beam_flat *flat = wf_beam_flat_of(b, i);
    const struct wf_beam_creep slow = { b->creep, (const double(*)[3])(b->creep > 0 ? b->k0[i] : NULL) };
    const struct wf_beam_creep *creep = b->creep > 0 ? &slow : NULL;
    struct wf_line_load *load = load_of(b, k, ahead);
    struct wf_beam_wrench at[2], down;
    struct wf_beam_reaction root = { { { 0 } }, { 0 }, { 0 } };
    bool grounded = p->parent < 0, cut = on_held(b, i);
    double before = b->misfit.bending;
    for (int j = 0; j < 2; j++) memcpy(b->load[i][j], load[j].force, sizeof b->load[i][j]);
    wf_beam_balance(p->h, &b->stage[i], flat, load, &b->wrench[i], at, &down);
    wf_beam_misfit_add(p, &b->shape[i], base->L, creep, &b->stage[i], flat, at, &b->misfit);
    size_t unstable = also->count ? also->count->negative : 0;
    also->change = ahead->growth ? ahead->change[ahead->used - 1] : NULL;
    if (tangent && !eliminate_element(b, i, base->L, creep, load, at,
                                      grounded || cut ? &root : &b->node[p->parent], also))
        return false;
    if (also->count && also->count->negative > unstable) {
        also->count->bears = fmax(also->count->bears, sqrt(wf_dot(down.n, down.n)));
        if (b->weak) b->weak[i] = true;
    }
    if (b->off) b->off[i] = b->misfit.bending - before;
    if (cut) return true;
    if (grounded) {
        ground_element(b, i, base, &down, tangent ? &root : NULL, also->count);
        return true;
    }
    v3_add(b->wrench[p->parent].n, 1, down.n);
    v3_add(b->wrench[p->parent].m, 1, down.m);
    return true;
}

/* The elimination takes the forces of links as given. */
bool wf_beam_has_side(const struct wf_beam *b)
{
    const struct wf_wind *now = b->loads.wind, *then = b->other ? b->other->wind : NULL;
    return now && then && now->speed > 0 && wf_wind_form(now) != WF_PROFILE_OTHER && !b->links && !b->only &&
           !(b->creep > 0);
}

/* The change of the wind: its force grows about with the square of the speed. */
static struct wf_beam_growth growth_of(const struct wf_beam *b)
{
    const double faster = b->other->wind->speed / b->loads.wind->speed;
    return (struct wf_beam_growth){ 0.5 * (faster * faster - 1),
                                    b->other->wind_scale / b->loads.wind_scale - 1 };
}

/* guard: as of wf_beam_eliminate; an element that is then taken by itself leaves no count. The change to the
 * other loads comes with the count: the last tangent of Newton's method is wanted. */
static bool sweep_down(struct wf_beam *b, bool tangent, bool guard, struct wf_beam_stability *count)
{
    const bool groups = by_groups(b) || in_team(b), grows = tangent && count && wf_beam_has_side(b);
    const struct wf_beam_growth growth = grows ? growth_of(b) : (struct wf_beam_growth){ 0 };
    struct ahead ahead = { .kernel = wf_lanes_kernel(WF_LANES_MOST),
                           .growth = grows ? &growth : NULL,
                           .most = groups ? 1 : AHEAD };
    struct wf_beam_also also = { .guard = guard, .count = count };
    b->misfit = (struct wf_beam_misfit){ 0 }, b->counted = b->finished = false;
    if (tangent) b->sided = false;
    if (count) count->negative = 0, count->bears = 0;
    if (!b->only) b->base = (struct wf_beam_wrench){ { 0 }, { 0 } };
    wf_beam_ends_load(b);
    set_side_weight(b);
    if (tangent) wf_beam_ends_react(b);
    if (groups && !many_down(b, tangent, &also, ahead.growth)) return false;
    for (size_t k = wf_beam_moving(b); k-- > 0;) {
        if (groups && b->mesh.part[wf_beam_moved(b, k)].parent >= 0) continue;
        if (!down_element(b, k, tangent, &ahead, &also)) return false;
    }
    if (b->links && !b->only && !wf_beam_links_join(b, tangent, count)) return false;
    if (count) b->stability = *count;
    bool finite = isfinite(b->misfit.bending);
    b->counted = count && finite && !also.apart;
    if (grows) b->sided = finite && !also.apart;
    if (tangent) b->apart = also.apart;
    return finite;
}

bool wf_beam_sweep_down(struct wf_beam *b, bool tangent, struct wf_beam_stability *count)
{
    /* far from equilibrium the tangent is guarded (beam_eliminate.h); near it the tangent is exact */
    return sweep_down(b, tangent, !count && b->misfit.bending > 1e-3 * b->misfit.energy, count);
}

/* The beam and Newton's method. */

/* Forces and where they act: a sweep writes all before it reads it. */
static bool take_forces(struct wf_beam *b, struct wf_arena *a)
{
    const size_t n = b->mesh.n;
    b->stage = wf_arena_take_unset(a, n, sizeof *b->stage);
    b->wrench = wf_arena_take_unset(a, n, sizeof *b->wrench);
    b->load = wf_arena_take_unset(a, n, sizeof *b->load);
    return b->stage && b->wrench && b->load;
}

bool wf_beam_take_newton(struct wf_beam *b, struct wf_arena *a)
{
    const size_t n = b->mesh.n;
    struct wf_beam_only *p = &b->part;
    if (!take_forces(b, a)) return false;
    b->node = wf_arena_take_unset(a, n, sizeof *b->node);
    b->answer = wf_arena_take_unset(a, n, sizeof *b->answer);
    b->change = wf_arena_take_unset(a, n, sizeof *b->change);
    b->dv = wf_arena_take_unset(a, n, sizeof *b->dv);
    b->side = wf_arena_take_unset(a, n, sizeof *b->side);
    b->root_side = wf_arena_take_unset(a, b->mesh.tree->n, sizeof *b->root_side);
    if (!b->chain) b->off = wf_arena_take_unset(a, n, sizeof *b->off);
    p->id = wf_arena_take_unset(a, n, sizeof *p->id);
    p->held = wf_arena_take_unset(a, n, sizeof *p->held);
    p->root = wf_arena_take_unset(a, n, sizeof *p->root);
    p->place = wf_arena_take_unset(a, n, sizeof *p->place);
    p->saved = wf_arena_take_unset(a, n, sizeof *p->saved);
    return b->node && b->answer && b->change && b->dv && b->side && b->root_side && (b->chain || b->off) &&
           p->id && p->held && p->root && p->place && p->saved;
}

/* Rows up to the last that stands on the ground. */
static size_t feet_of(const struct wf_tree *t)
{
    size_t n = t->n;
    while (n && t->parent[n - 1] >= 0) n--;
    return n;
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
    const size_t n = b->mesh.n, feet = b->feet = feet_of(t);
    b->chain = n > 1 && !b->mesh.flat;
    for (size_t i = 0; i < n && b->chain; i++) b->chain = b->mesh.part[i].parent == (int32_t)i - 1;
    b->tilt = wf_arena_take(a, t->n, sizeof *b->tilt);
    b->root_step = wf_arena_take(a, feet, sizeof *b->root_step);
    b->root_change = wf_arena_take(a, feet, sizeof *b->root_change);
    b->root_give = wf_arena_take(a, feet, sizeof *b->root_give);
    b->root_hold = wf_arena_take(a, feet, sizeof *b->root_hold);
    b->shape = WF_TAKE(a, n, struct wf_beam_shape);
    b->pose = WF_TAKE(a, n, struct wf_beam_pose);
    if (b->mesh.flat) b->flat = WF_TAKE(a, n, struct wf_beam_flat);
    if (!b->tilt || !b->root_step || !b->root_change || !b->root_give || !b->root_hold || !b->shape ||
        !b->pose || (b->mesh.flat && !b->flat) ||
        !(newton ? wf_beam_take_newton(b, newton) : take_forces(b, a)))
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
    for (size_t k = 0; k < wf_beam_moving(b); k++) {
        const size_t i = wf_beam_moved(b, k);
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
    for (size_t k = 0; k < wf_beam_moving(b); k++) {
        size_t i = wf_beam_moved(b, k);
        for (int j = 0; j < 2; j++) v3_add(b->shape[i].v[j], share, b->dv[i][j]);
    }
    for (size_t i = 0; i < b->mesh.tree->n && !b->only; i++)
        if (b->mesh.tree->parent[i] < 0) v3_add(b->tilt[i], share, b->root_step[i]);
    if (b->links) wf_beam_links_stretch(b, share);
    wf_beam_sweep_up(b);
}

/* The margin allows for neutral directions (a fallen stem may rotate about the vertical without any work)
 * and for the tangent, which is symmetric only to second order in an element's own rotation. */
static double stability_margin(const struct wf_beam *b)
{
    double turn = 0;
    for (size_t k = 0; k < wf_beam_moving(b); k++)
        for (int j = 0; j < 2; j++) {
            const double *v = b->shape[wf_beam_moved(b, k)].v[j];
            turn = fmax(turn, wf_dot(v, v));
        }
    return 1e-6 + 0.5 * turn;
}

/* ---- Small parts by themselves ---- */

/* Square of the residual over the energy. */
static double relative(const struct wf_beam *b) { return b->misfit.bending / b->misfit.energy; }

static enum wf_status newton(struct wf_beam *b, bool watch);

/* A larger part, of which some twig may take its time: with line search. */
static bool newton_search(struct wf_beam *b)
{
    enum { MOST = 8 };
    const struct wf_solve_options *own = b->options;
    struct wf_solve_options some = *own;
    some.iterations_max = MOST, some.tolerance = 1e-3;
    b->options = &some;
    bool found = !newton(b, false);
    b->options = own;
    return found;
}

/* The elements of a list as they were before `share` of their last corrections, which are saved. */
static void set_back(struct wf_beam *b, const int32_t *id, size_t n, double share)
{
    for (size_t k = 0; k < n; k++) {
        double(*v)[3] = b->shape[id[k]].v, (*saved)[6] = b->part.saved[id[k]];
        memcpy(v, saved[0], sizeof saved[0]);
        for (int j = 0; j < 2; j++) v3_add(v[j], -share, saved[1] + 3 * j);
    }
}

/* A small part by itself by whole steps of Newton's method, of which only the turn of each element is
 * limited: a twig that turns over passes states that are farther from equilibrium. Where it does not converge
 * it is as before. context: share of the last corrections that was taken back. */
static bool newton_of_part(struct wf_beam *b, void *context)
{
    enum { MOST = 16 };
    const double close = 1e-6; /* square of the residual, relative */
    const size_t large = 100;  /* elements */
    const double *share = context;
    if (b->only->n > large) return newton_search(b);
    wf_beam_sweep_up(b);
    b->misfit = (struct wf_beam_misfit){ .bending = 1, .energy = 1 };
    bool finite = wf_beam_sweep_down(b, true, NULL);
    for (; finite && b->iterations < MOST && relative(b) > close; b->iterations++) {
        finite = isfinite(newton_corrections(b));
        if (!finite) break;
        apply_correction(b, 1);
        finite = wf_beam_sweep_down(b, true, NULL);
    }
    if (finite && relative(b) <= close) return true;
    set_back(b, b->only->id, b->only->n, *share);
    wf_beam_sweep_up(b);
    return false;
}

/* Newton's method of each small part by itself where `least` of the residual is in few elements: one twig
 * that turns over would shorten the steps of the whole tree. Before it they are set back by `share` of their
 * last corrections. Returned: were there such parts? */
static bool relax_parts(struct wf_beam *b, double least, double few, double share)
{
    enum { FAILED = 4 };
    const double slight = 0.1, effort = 1;
    const double elements = (double)b->mesh.n;
    if (b->only || b->creep > 0 || b->tries <= 0) return false;
    struct wf_beam_parts parts = wf_beam_find_parts(b, slight);
    if (parts.share < least || !parts.n || (double)parts.n > few * elements) return false;
    b->part.n = parts.n;
    for (size_t k = 0; k < parts.n; k++) {
        size_t i = (size_t)b->part.id[k];
        double(*saved)[6] = b->part.saved[i];
        memcpy(saved[0], b->shape[i].v, sizeof saved[0]);
        memcpy(saved[1], b->dv[i], sizeof saved[1]);
    }
    set_back(b, b->part.id, parts.n, share);
    b->tries -= wf_beam_each_part(b, parts.n, effort * elements, newton_of_part, &share) ? 1 : FAILED;
    wf_beam_sweep_up(b);
    return true;
}

/* As it was before relax_parts. */
static void put_back_parts(struct wf_beam *b)
{
    set_back(b, b->part.id, b->part.n, 0);
    for (size_t k = 0; k < b->part.n; k++) {
        size_t i = (size_t)b->part.id[k];
        memcpy(b->dv[i], b->part.saved[i][1], sizeof b->dv[i]);
    }
    wf_beam_sweep_up(b);
}

static bool step_reduces(const struct wf_beam *b, const struct wf_beam_misfit *before, double share)
{
    return b->misfit.bending <= before->bending * (1 - 1e-4 * share) ||
           b->misfit.bending <= 1e-24 * b->misfit.energy; /* at rounding */
}

/* The whole step, of which the blocking small parts are taken out: they go on from where they were. false:
 * the residual does not fall so; all is as before. */
static bool step_without_parts(struct wf_beam *b, const struct wf_beam_misfit *before, double share)
{
    const double least = 0.5, few = 0.05;
    if (!relax_parts(b, least, few, share)) return false;
    const struct wf_beam_misfit tried = b->misfit;
    if (wf_beam_sweep_down(b, true, NULL) && step_reduces(b, before, share)) return true;
    put_back_parts(b);
    b->misfit = tried;
    return false;
}

/* One Newton step, halved until the residual falls. With `watch`, unstable directions are counted in
 * what is probably the last step, which saves wf_beam_stable a sweep. false: no step length reduces the
 * residual. */
static bool newton_step(struct wf_beam *b, bool watch)
{
    const double turn_limit = 3; /* [rad] rotation of a node in one step */
    /* relative residual before the last step: convergence is quadratic */
    const double near = fmin(fmax(1e-3, 3 * sqrt(b->options->tolerance)), 0.3);
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
        if (!step_reduces(b, &before, share)) {
            if (whole && step_without_parts(b, &before, share)) return true;
            continue;
        }
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

/* Is the residual that of small parts, and does it hardly fall? `was`: before the last step. */
static bool stalls(const struct wf_beam *b, double was)
{
    const double small = 1e-3, hardly = 0.8;
    return was <= small && relative(b) > hardly * was && !newton_converged(b);
}

/* The step that is likely the last is swept without the tangent, at a quarter of the cost. Whether the
 * equilibrium is stable was then counted a step before. Only with a tolerance that leaves nothing for a
 * further step with the tangent. Returned: does it converge? If not, nothing has changed. */
static bool land(struct wf_beam *b, bool watch)
{
    const double likely = 0.1;
    const double t = b->options->tolerance;
    const struct wf_beam_misfit before = b->misfit;
    const bool counted = b->counted;
    if (!(t <= WF_BEAM_TIGHT && relative(b) <= likely * t) || (watch && !counted) || b->only || b->links)
        return false;
    if (!isfinite(newton_corrections(b))) return false;
    apply_correction(b, 1);
    if (wf_beam_sweep_down(b, false, NULL) && newton_converged(b)) {
        b->counted = counted, b->finished = true;
        b->iterations++;
        return true;
    }
    apply_correction(b, -1);
    b->misfit = before;
    return false;
}

static enum wf_status newton(struct wf_beam *b, bool watch)
{
    enum { STALL = 16 }; /* where the square of the residual has not halved in so many, it seldom converges */
    enum { TRIES = 8 };
    const double nearly = 0.8, few = 0.5;
    double before = INFINITY, relaxed_at = INFINITY;
    if (!b->only) b->tries = b->off && !b->links && !b->by_steps ? TRIES : 0;
    wf_beam_sweep_up(b);
    struct wf_beam_stability count = { .margin = stability_margin(b) };
    bool swept = sweep_down(b, true, true, watch && b->close ? &count : NULL);
    if (!swept) return WF_ENOCONV;
    b->close = false;
    for (size_t i = 0; i < b->options->iterations_max && !newton_converged(b); i++) {
        if (i % STALL == 0) {
            if (b->misfit.bending > 0.5 * before) return WF_ENOCONV;
            before = b->misfit.bending;
        }
        if (land(b, watch)) return WF_OK;
        b->iterations++;
        double was = relative(b);
        if (!newton_step(b, watch)) return WF_ENOCONV;
        if (b->hasty && stalls(b, was)) return WF_ENOCONV;
        if (!(relative(b) > 0.25 * was && relative(b) < 0.25 * relaxed_at) || newton_converged(b)) continue;
        if (!relax_parts(b, nearly, few, 0)) continue;
        relaxed_at = relative(b);
        if (!wf_beam_sweep_down(b, true, NULL)) return WF_ENOCONV;
    }
    return newton_converged(b) ? WF_OK : WF_ENOCONV;
}

enum wf_status wf_beam_newton(struct wf_beam *b) { return newton(b, b->other); }

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
    if (b->finished) return true;
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
