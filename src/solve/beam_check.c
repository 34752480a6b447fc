/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_check.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_ends.h"
#include <math.h>
#include <string.h>

/* ---- Start shape ---- */

/* Rotation from the unloaded to the loaded state at fraction s (0..1) of a row. */
static void beam_rotation_at(const struct wf_beam *b, size_t row, double s, double L[9])
{
    int32_t from = b->mesh.first[row], cut = b->mesh.last[row] - from + 1;
    int32_t k = (int32_t)fmin(floor(s * cut), cut - 1);
    double x = s * cut - k, v[3], R[9];
    const struct wf_beam_shape *u = &b->shape[from + k];
    /* the quadratic through 0 at the base and the two Gauss points */
    double a = x * (x - gauss_place[1]) / (gauss_place[0] * (gauss_place[0] - gauss_place[1]));
    double c = x * (x - gauss_place[0]) / (gauss_place[1] * (gauss_place[1] - gauss_place[0]));
    for (int i = 0; i < 3; i++) v[i] = a * u->v[0][i] + c * u->v[1][i];
    struct wf_beam_pose ground;
    rotation_matrix(v, R);
    m3_mul(wf_beam_base(b, (size_t)(from + k), &ground)->L, R, L);
}

void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine)
{
    memcpy(fine->tilt, coarse->tilt, fine->mesh.tree->n * sizeof *fine->tilt);
    wf_beam_links_carry(coarse, fine);
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        int32_t from = fine->mesh.first[i], cut = fine->mesh.last[i] - from + 1;
        const bool same = wf_beam_pieces(&coarse->mesh, i) == cut;
        for (int32_t k = 0; k < cut; k++) {
            double base[9], at[9], R[9];
            if (same) {
                memcpy(fine->shape[from + k].v, coarse->shape[coarse->mesh.first[i] + k].v,
                       sizeof fine->shape->v);
                continue;
            }
            beam_rotation_at(coarse, i, (double)k / cut, base);
            for (int j = 0; j < 2; j++) {
                beam_rotation_at(coarse, i, (k + gauss_place[j]) / cut, at);
                m3_mul_transposed(base, at, R);
                rotation_vector(R, fine->shape[from + k].v[j]);
            }
        }
    }
}

bool wf_beam_unmoved(const struct wf_beam *b)
{
    const double slight = 1e-9; /* [rad] */
    double most = 0;
    if (!b->mesh.still) return false;
    for (size_t i = 0; i < b->feet; i++) most = fmax(most, wf_dot(b->tilt[i], b->tilt[i]));
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) most = fmax(most, wf_dot(b->shape[i].v[j], b->shape[i].v[j]));
    return most <= slight * slight;
}

/* Position and rotation of the end of row i relative to its base, in the axes of the base; of a standing tree
 * the change from the given shape. */
static void seen_from_base(const struct wf_beam *b, size_t i, double place[3], double L[9])
{
    size_t from = (size_t)b->mesh.first[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, from, &ground), *end = &b->pose[b->mesh.last[i]];
    double d[3] = { end->r[0] - base->r[0], end->r[1] - base->r[1], end->r[2] - base->r[2] };
    m3_apply_transposed(base->L, d, place);
    m3_mul_transposed(base->L, end->L, L);
    if (!b->mesh.still) return;
    const double foot[3] = { b->mesh.tree->x0[i], b->mesh.tree->y0[i], b->mesh.tree->z0[i] };
    int32_t below = b->mesh.tree->parent[i];
    v3_add(place, -1, b->mesh.still[i]);
    v3_add(place, 1, below < 0 ? foot : b->mesh.still[below]);
}

/* Path length from each row's end to its farthest tip [m]. */
static void tree_reach(const struct wf_tree *t, double *reach)
{
    for (size_t i = 0; i < t->n; i++) reach[i] = 0;
    for (size_t i = t->n; i-- > 0;) {
        if (t->parent[i] < 0) continue;
        double far = reach[i] + wf_tree_length(t, i);
        if (far > reach[t->parent[i]]) reach[t->parent[i]] = far;
    }
}

/* Estimated error of position at the worst node [m], from solutions on a mesh and a finer one of the same
 * tree. Each row's own contribution (its end relative to its base) falls with the fourth power of the piece
 * length; its error of rotation moves everything beyond it, up to `reach` away. share[n]: contribution of
 * each row [m]; a row that was not refined keeps its old value. */
static double beam_mesh_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *reach,
                              double *share)
{
    const struct wf_tree *t = fine->mesh.tree;
    double worst = 0;
    for (size_t i = 0; i < t->n; i++) {
        double a[3], b[3], A[9], B[9], R[9], turn[3];
        double kc = wf_beam_pieces(&coarse->mesh, i), kf = wf_beam_pieces(&fine->mesh, i);
        double fall = pow(kf / kc, 4) - 1; /* error(coarse) = error(fine) (kf/kc)^4 */
        seen_from_base(coarse, i, a, A);
        seen_from_base(fine, i, b, B);
        m3_mul_transposed(A, B, R);
        rotation_vector(R, turn);
        v3_add(a, -1, b);
        if (fall > 0) share[i] = (sqrt(wf_dot(a, a)) + reach[i] * sqrt(wf_dot(turn, turn))) / fall;
    }
    /* largest sum along a path from the ground: summed in place of the rows' own shares, then undone */
    for (size_t i = 0; i < t->n; i++) {
        if (t->parent[i] >= 0) share[i] += share[t->parent[i]];
        worst = fmax(worst, share[i]);
    }
    for (size_t i = t->n; i-- > 0;)
        if (t->parent[i] >= 0) share[i] -= share[t->parent[i]];
    return worst;
}

/* Mesh refinement to a tolerance: solutions on two meshes are compared row by row. */

static double largest_displacement(const struct wf_beam *b)
{
    const struct wf_tree *t = b->mesh.tree;
    double most = 0;
    for (size_t i = 0; i < t->n; i++) {
        double d[3];
        wf_beam_still_at(&b->mesh, i, d);
        v3_add(d, -1, b->pose[b->mesh.last[i]].r);
        most = fmax(most, wf_dot(d, d));
    }
    return sqrt(most);
}

/* Farthest end from the first base [m]. */
static double tree_size(const struct wf_tree *t)
{
    double most = 0;
    for (size_t i = 0; i < t->n; i++) {
        double d[3] = { t->x1[i] - t->x0[0], t->y1[i] - t->y0[0], t->z1[i] - t->z0[0] };
        most = fmax(most, wf_dot(d, d));
    }
    return sqrt(most);
}

/* Number of rows on the longest path from the ground; the allowed error is divided by it. */
static double longest_row_chain(const struct wf_tree *t, double *depth)
{
    double most = 1;
    for (size_t i = 0; i < t->n; i++) {
        depth[i] = 1 + (t->parent[i] >= 0 ? depth[t->parent[i]] : 0);
        most = fmax(most, depth[i]);
    }
    return most;
}

void wf_beam_row_loads(const struct wf_beam *b, double *load)
{
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        double sum[3] = { 0, 0, 0 };
        for (int32_t k = b->mesh.first[i]; k <= b->mesh.last[i]; k++) {
            for (int j = 0; j < 2; j++) v3_add(sum, 0.5 * b->mesh.part[k].h, b->load[k][j]);
        }
        memcpy(load + 3 * i, sum, sizeof sum);
    }
}

/* The error of a row's load is assumed to fall with this power of the piece length: wind near the ground
 * grows with a low power of height, and a load with a kink inside a row converges no faster. */
static const double load_order = 1.3;

/* Estimated error of each row's load relative to the base reaction. */
static double load_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *before,
                         const double *now, double *share)
{
    double force = sqrt(wf_dot(fine->base.n, fine->base.n)), sum = 0;
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        double kc = wf_beam_pieces(&coarse->mesh, i), kf = wf_beam_pieces(&fine->mesh, i), d[3];
        for (size_t k = 0; k < 3; k++) d[k] = now[3 * i + k] - before[3 * i + k];
        share[i] = kf > kc && force > 0 ? sqrt(wf_dot(d, d)) / force / (pow(kf / kc, load_order) - 1) : 0;
        sum += share[i];
    }
    return sum;
}

/* By how much shorter pieces have to be for loads whose error is `off` times what is allowed. */
static double shorter(double off) { return pow(1.5 * off, 0.77); }

/* New number of pieces per row of the mesh `from`, of which none is coarsened, so that the carried-over shape
 * is a valid Newton start. Rows above their share of the error target are refined (share: on the mesh of
 * `solved`), and those that cause most of the error of the loads (`bear`) by `more`. Returned: their sum. */
static double choose_pieces(const struct wf_beam *from, const struct wf_beam *solved, const double *share,
                            double target, const double *bear, double more, int32_t *pieces)
{
    const size_t n = from->mesh.tree->n;
    double most = 0, elements = 0;
    for (size_t i = 0; i < n; i++) most = fmax(most, bear[i]);
    for (size_t i = 0; i < n; i++) {
        int32_t now = wf_beam_pieces(&from->mesh, i);
        double want = wf_beam_pieces(&solved->mesh, i) * pow(share[i] / target, 0.25);
        if (bear[i] > 0.1 * most) want = fmax(want, now * more);
        pieces[i] = (int32_t)fmin(fmax(ceil(want), now), 64.0 * now);
        elements += pieces[i];
    }
    return elements;
}

enum wf_status wf_beam_check_make(const struct wf_tree *t, struct wf_arena *a, struct wf_beam_check *c,
                                  struct wf_err *e)
{
    *c = (struct wf_beam_check){ .reach = WF_TAKE(a, t->n, double),
                                 .share = WF_TAKE(a, t->n, double),
                                 .bear = WF_TAKE(a, t->n, double),
                                 .before = WF_TAKE(a, 3 * t->n, double),
                                 .load = WF_TAKE(a, 3 * t->n, double) };
    if (!c->reach || !c->share || !c->bear || !c->before || !c->load)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    c->depth = longest_row_chain(t, c->share);
    tree_reach(t, c->reach);
    return WF_OK;
}

/* By how much the turn of the tree's tip, whose thin end bends most, differs from that on a finer mesh, of
 * what is allowed. */
static double tip_lack(const struct wf_beam *coarse, const struct wf_beam *fine, size_t tip)
{
    double R[9], off[3], turn[3];
    const double limit = 1e-3, *L = fine->pose[fine->mesh.last[tip]].L;
    m3_mul_transposed(coarse->pose[coarse->mesh.last[tip]].L, L, R);
    rotation_vector(R, off), rotation_vector(L, turn);
    return sqrt(wf_dot(off, off) / (limit * limit * wf_dot(turn, turn) + 1e-20));
}

/* Error of positions within a tolerance [m]. */
static double allowed_error(const struct wf_beam *b, double tolerance)
{
    const double rounding = 1e-12; /* relative to the tree's size: positions are no more accurate than this,
                                      so a tree that hardly moves converges too */
    return fmax(tolerance * largest_displacement(b), rounding * tree_size(b->mesh.tree));
}

bool wf_beam_check_meets(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c,
                         int32_t *pieces)
{
    /* a mesh is chosen for a quarter of the tolerance, so that one more is seldom solved, and taken with half
     * of it: the rest is the estimate's own error; loads with all of it, whose rows' errors are summed
     * without their signs */
    const double aim = 0.25, enough = 2, enough_loads = 4;
    const struct wf_tree *t = fine->mesh.tree;
    double allowed = fine->options->mesh_tolerance * aim;
    double target = allowed_error(fine, allowed);
    double error = beam_mesh_error(coarse, fine, c->reach, c->share);
    double reactions = load_error(coarse, fine, c->before, c->load, c->bear);
    memcpy(c->before, c->load, 3 * t->n * sizeof *c->load);
    const size_t tip = wf_tip_row(t);
    bool turns = tip_lack(coarse, fine, tip) <= 1;
    if (error <= enough * target && reactions <= enough_loads * allowed && turns) return true;
    double off = reactions / allowed, more = off > 1 ? fmax(shorter(off), 2) : 1;
    (void)choose_pieces(fine, fine, c->share, target / c->depth, c->bear, more, pieces);
    if (!turns) pieces[tip] = (int32_t)fmax(pieces[tip], 2 * wf_beam_pieces(&fine->mesh, tip));
    return false;
}

/* Pieces of a mesh that meets a tolerance, from the errors of a solution on one twice as fine as that of b:
 * rows by their own errors or, where that takes fewer elements, all alike. error, reactions: of positions and
 * loads on the mesh of b, of what is allowed. */
static void choose_again(const struct wf_beam *b, const struct wf_beam *fine, const struct wf_beam_check *c,
                         double target, double error, double reactions, int32_t *pieces)
{
    double more = shorter(fmax(reactions, 1)), alike = ceil(fmax(pow(error, 0.25), more));
    double elements = choose_pieces(b, fine, c->share, target / c->depth, c->bear, more, pieces);
    if (elements <= alike * (double)b->mesh.n) return;
    for (size_t i = 0; i < b->mesh.tree->n; i++) pieces[i] = (int32_t)alike * wf_beam_pieces(&b->mesh, i);
}

/* The error of the mesh of b, of what is allowed, and a mesh that meets the tolerance. fine: a solution on
 * one twice as fine. */
static double off_beside(const struct wf_beam *b, const struct wf_beam *fine, struct wf_beam_check *c,
                         double tolerance, int32_t *pieces)
{
    wf_beam_row_loads(b, c->before);
    wf_beam_row_loads(fine, c->load);
    /* of the coarse mesh: 2^4 and 2^1.3 times that of the fine one */
    double allowed = allowed_error(fine, tolerance);
    double error = 16 * beam_mesh_error(b, fine, c->reach, c->share) / allowed;
    double reactions = pow(2, load_order) * load_error(b, fine, c->before, c->load, c->bear) / tolerance;
    const size_t tip = wf_tip_row(b->mesh.tree);
    double turns = tip_lack(b, fine, tip);
    choose_again(b, fine, c, allowed, error, reactions, pieces);
    const int32_t now = wf_beam_pieces(&b->mesh, tip), most = now > 64 ? now : 64;
    if (turns >
        1) /* to the first order of the piece length at least; of a tip that hangs free any mesh is off */
        pieces[tip] = (int32_t)fmax(pieces[tip], fmin(ceil(2 * turns) * now, most));
    return isnan(error + reactions + turns) ? INFINITY : fmax(fmax(error, reactions), turns);
}

enum wf_status wf_beam_mesh_off(const struct wf_beam *b, double tolerance, double *error, int32_t *pieces,
                                struct wf_err *e)
{
    const struct wf_tree *t = b->mesh.tree;
    struct wf_arena work = { 0 };
    struct wf_beam fine;
    struct wf_beam_check check;
    enum wf_status s = wf_beam_check_make(t, &work, &check, e);
    *error = INFINITY;
    for (size_t i = 0; i < t->n && !s; i++) pieces[i] = 2 * wf_beam_pieces(&b->mesh, i);
    if (!s) s = wf_beam_init(&fine, t, &b->loads, b->options, pieces, &work, &work, e);
    if (!s) {
        wf_beam_carry(b, &fine);
        wf_beam_sweep_up(&fine);
        fine.misfit = b->misfit; /* close to equilibrium: one step leaves the square of what is missing */
        if (wf_beam_step(&fine, NULL)) *error = off_beside(b, &fine, &check, tolerance, pieces);
    }
    wf_arena_free(&work);
    return s;
}
