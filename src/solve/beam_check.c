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

void wf_beam_unbend(struct wf_beam *b)
{
    memset(b->shape, 0, b->mesh.n * sizeof *b->shape);
    memset(b->tilt, 0, b->feet * sizeof *b->tilt);
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

void wf_beam_row_loads(const struct wf_beam_mesh *m, const double (*at)[2][3], double *load)
{
    for (size_t i = 0; i < m->tree->n; i++) {
        double sum[3] = { 0, 0, 0 };
        for (int32_t k = m->first[i]; k <= m->last[i]; k++)
            for (int j = 0; j < 2; j++) v3_add(sum, 0.5 * m->part[k].h, at[k][j]);
        memcpy(load + 3 * i, sum, sizeof sum);
    }
}

/* The error of a row's load is assumed to fall with this power of the piece length: wind near the ground
 * grows with a low power of height, and a load with a kink inside a row converges no faster. */
static const double load_order = 1.3;

static double distance(const double a[3], const double b[3])
{
    double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    return sqrt(wf_dot(d, d));
}

/* Estimated error of each row's load relative to the base reaction, and their sum. The load on the fine mesh
 * differs from that on the coarse one also by the change of the shape, and in the shape carried to the fine
 * mesh also by the error within the elements: the smaller of the differences counts. */
static double load_error(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c)
{
    double force = sqrt(wf_dot(fine->base.n, fine->base.n)), sum = 0;
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        const double kc = wf_beam_pieces(&coarse->mesh, i), kf = wf_beam_pieces(&fine->mesh, i),
                     *before = c->before + 3 * i,
                     off = fmin(distance(c->load + 3 * i, before), distance(c->begun + 3 * i, before));
        c->bear[i] = kf > kc && force > 0 ? off / force / (pow(kf / kc, load_order) - 1) : 0;
        sum += c->bear[i];
    }
    return sum;
}

/* By how much shorter pieces have to be for loads whose error is `off` times what is allowed. */
static double shorter(double off) { return pow(1.5 * off, 0.77); }

/* Pieces of a row, of which `now` is the least and `times` as many the most. */
static int32_t pieces_within(double want, int32_t now, double times)
{
    return (int32_t)fmin(fmax(ceil(want), now), times * now);
}

/* Pieces of the rows of `from` whose own errors are above `each`, no row coarser. Returned: the error at the
 * worst node that is then expected [m]. c: errors on the mesh of `solved`. */
static double choose_by_shape(const struct wf_beam *from, const struct wf_beam *solved,
                              struct wf_beam_check *c, double each, int32_t *pieces)
{
    const struct wf_tree *t = from->mesh.tree;
    const double shorter_by = pow(each, -0.25), most = 64;
    double worst = 0;
    for (size_t i = 0; i < t->n; i++) {
        const double had = wf_beam_pieces(&solved->mesh, i), want = had * c->root[i] * shorter_by;
        pieces[i] = pieces_within(want, wf_beam_pieces(&from->mesh, i), most);
        const double ratio = had / pieces[i], square = ratio * ratio;
        c->rest[i] = c->share[i] * square * square + (t->parent[i] >= 0 ? c->rest[t->parent[i]] : 0);
        worst = fmax(worst, c->rest[i]);
    }
    return worst;
}

static double count(const int32_t *pieces, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += pieces[i];
    return sum;
}

/* Cut the rows that cause most of the error of the loads until no more is left than allowed, or there are
 * `growth` times as many elements of a mesh that is not small: where rows bend far, most of what their loads
 * differ by is gone once their shapes are right, which the next comparison shows. Given: in c->rest the rows'
 * errors. Returned: in c->left what is left. */
static void choose_by_loads(const struct wf_beam *from, struct wf_beam_check *c, double allowed,
                            int32_t *pieces)
{
    enum { PASSES = 32 };
    const double longer = 1.5, many = 0.2, times = 256, growth = 1.25, small = 4096;
    const size_t n = from->mesh.tree->n;
    const double limit = fmax(growth * count(pieces, n), small);
    for (int k = 0;; k++) {
        double most = 0;
        c->left = 0;
        for (size_t i = 0; i < n; i++) most = fmax(most, c->rest[i]), c->left += c->rest[i];
        if (!(c->left > allowed) || k == PASSES || count(pieces, n) > limit) return;
        for (size_t i = 0; i < n; i++) {
            if (!(c->rest[i] > many * most)) continue;
            const int32_t had = pieces[i];
            pieces[i] = pieces_within(longer * had, wf_beam_pieces(&from->mesh, i), times);
            c->rest[i] *= pow((double)had / pieces[i], load_order);
        }
    }
}

/* New number of pieces per row of the mesh `from`, of which none is coarsened, so that the carried-over shape
 * is a valid Newton start. Rows with the largest errors of their own are refined until positions meet their
 * target [m] (least: as few as meet it, else all above an equal share), then those that cause most of what is
 * left of the error of the loads, if that is more than is allowed: a row's loads improve as its shape where
 * it is refined for that. c: errors on the mesh of `solved`. Returned: their sum. */
static double choose_pieces(const struct wf_beam *from, const struct wf_beam *solved, struct wf_beam_check *c,
                            double target, double allowed, bool least, int32_t *pieces)
{
    const double wider = 1.25;
    const size_t n = from->mesh.tree->n;
    double each = target / c->depth;
    for (size_t i = 0; i < n; i++) c->root[i] = sqrt(sqrt(c->share[i]));
    while (least && each < target && choose_by_shape(from, solved, c, wider * each, pieces) <= target)
        each *= wider;
    c->worst = choose_by_shape(from, solved, c, each, pieces);
    for (size_t i = 0; i < n; i++) {
        const double had = wf_beam_pieces(&solved->mesh, i);
        c->rest[i] = c->bear[i] * pow(had / pieces[i], pieces[i] > had ? 4 : load_order);
    }
    choose_by_loads(from, c, allowed, pieces);
    return count(pieces, n);
}

enum wf_status wf_beam_check_make(const struct wf_tree *t, struct wf_arena *a, struct wf_beam_check *c,
                                  struct wf_err *e)
{
    *c = (struct wf_beam_check){ .reach = WF_TAKE(a, t->n, double),
                                 .share = WF_TAKE(a, t->n, double),
                                 .bear = WF_TAKE(a, t->n, double),
                                 .rest = WF_TAKE(a, t->n, double),
                                 .root = WF_TAKE(a, t->n, double),
                                 .before = WF_TAKE(a, 3 * t->n, double),
                                 .load = WF_TAKE(a, 3 * t->n, double),
                                 .begun = WF_TAKE(a, 3 * t->n, double) };
    if (!c->reach || !c->share || !c->bear || !c->rest || !c->root || !c->before || !c->load || !c->begun)
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

/* What is known of a mesh from the parts of its error. */
static struct wf_beam_good good_of(const struct wf_loads *l, double place, double loads, double turn)
{
    const double error = isnan(place + loads + turn) ? (double)INFINITY : fmax(place, loads);
    struct wf_beam_good g = { .pace = wf_beam_pace(l), .error = error, .turn = turn };
    if (l->wind) memcpy(g.along, l->wind->direction, sizeof g.along);
    return g;
}

/* A mesh is chosen for a share of the tolerance, so that one more is seldom solved. */
static const double aim = 0.15, aim_few = 0.25;

bool wf_beam_check_meets(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c)
{
    /* half of the tolerance: the rest is the estimate's own error; loads more, whose rows' errors are summed
     * without their signs */
    const double enough = 0.5, enough_loads = 0.8, tolerance = fine->options->mesh_tolerance;
    c->scale = allowed_error(fine, tolerance) / tolerance;
    c->place = beam_mesh_error(coarse, fine, c->reach, c->share) / c->scale;
    c->loads = load_error(coarse, fine, c);
    c->turn = tip_lack(coarse, fine, wf_tip_row(fine->mesh.tree));
    memcpy(c->before, c->load, 3 * fine->mesh.tree->n * sizeof *c->load);
    return c->place <= enough * tolerance && c->loads <= enough_loads * tolerance && c->turn <= 1;
}

/* The same for the loads, whose rows' errors are summed without their signs: those of many rows cancel in
 * part.
 */
static double aim_loads(size_t rows)
{
    const double least = 0.1, most = 0.6, few = 40;
    return fmin(fmax(least * sqrt((double)rows / few), least), most);
}

void wf_beam_check_choose(const struct wf_beam *fine, struct wf_beam_check *c, int32_t *pieces)
{
    const double tolerance = fine->options->mesh_tolerance;
    const size_t tip = wf_tip_row(fine->mesh.tree);
    (void)choose_pieces(fine, fine, c, aim * tolerance * c->scale, aim_loads(fine->mesh.tree->n) * tolerance,
                        true, pieces);
    if (!(c->turn <= 1)) pieces[tip] = (int32_t)fmax(pieces[tip], 2 * wf_beam_pieces(&fine->mesh, tip));
}

bool wf_beam_check_few(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c,
                       int32_t *pieces, struct wf_beam_good *expected)
{
    const double few = 1.6, allowed = aim_few * fine->options->mesh_tolerance;
    double elements = choose_pieces(coarse, fine, c, allowed * c->scale, allowed, true, pieces);
    *expected = good_of(&fine->loads, c->worst / c->scale, c->left, c->turn);
    return elements <= few * (double)coarse->mesh.n;
}

struct wf_beam_good wf_beam_check_first(const struct wf_beam *coarse, const struct wf_beam *fine,
                                        struct wf_beam_check *c, int32_t *pieces)
{
    (void)choose_pieces(coarse, fine, c, INFINITY, INFINITY, false, pieces);
    return good_of(&fine->loads, c->worst / c->scale, c->left, c->turn);
}

/* Pieces of a mesh that meets a tolerance, from the errors of a solution on one twice as fine as that of b:
 * rows by their own errors or, where that takes fewer elements, all alike. */
static void choose_again(const struct wf_beam *b, const struct wf_beam *fine, struct wf_beam_check *c,
                         double target, double tolerance, int32_t *pieces)
{
    const double loads = pow(2, load_order) * c->loads / tolerance; /* on the mesh of b */
    double alike = ceil(fmax(2 * pow(c->place / tolerance, 0.25), shorter(fmax(loads, 1))));
    double elements = choose_pieces(b, fine, c, target, tolerance, false, pieces);
    if (elements <= alike * (double)b->mesh.n) return;
    for (size_t i = 0; i < b->mesh.tree->n; i++) pieces[i] = (int32_t)alike * wf_beam_pieces(&b->mesh, i);
}

struct wf_beam_good wf_beam_check_fine(const struct wf_beam_check *c, const struct wf_loads *l)
{
    return good_of(l, c->place, c->loads, c->turn);
}

/* The error of the mesh of b, and a mesh that meets the tolerance. fine: a solution on one twice as fine. */
static struct wf_beam_good off_beside(const struct wf_beam *b, const struct wf_beam *fine,
                                      struct wf_beam_check *c, double tolerance, int32_t *pieces)
{
    double allowed = allowed_error(fine, tolerance);
    const size_t tip = wf_tip_row(b->mesh.tree);
    c->place = beam_mesh_error(b, fine, c->reach, c->share) / allowed * tolerance;
    c->loads = load_error(b, fine, c);
    c->turn = tip_lack(b, fine, tip);
    struct wf_beam_good found = /* on the mesh of b, 2^4 times that of positions on the fine one */
        good_of(&b->loads, 16 * c->place, pow(2, load_order) * c->loads, c->turn);
    choose_again(b, fine, c, allowed, tolerance, pieces);
    const int32_t now = wf_beam_pieces(&b->mesh, tip), most = now > 64 ? now : 64;
    if (c->turn >
        1) /* to the first order of the piece length at least; of a tip that hangs free any mesh is off */
        pieces[tip] = (int32_t)fmax(pieces[tip], fmin(ceil(2 * c->turn) * now, most));
    return found;
}

enum wf_status wf_beam_mesh_off(const struct wf_beam *b, double tolerance, struct wf_beam_good *out,
                                int32_t *pieces, struct wf_err *e)
{
    const struct wf_tree *t = b->mesh.tree;
    struct wf_arena work = { 0 };
    struct wf_beam fine;
    struct wf_beam_check check;
    enum wf_status s = wf_beam_check_make(t, &work, &check, e);
    *out = (struct wf_beam_good){ .error = INFINITY };
    for (size_t i = 0; i < t->n && !s; i++) pieces[i] = 2 * wf_beam_pieces(&b->mesh, i);
    if (!s) s = wf_beam_init(&fine, t, &b->loads, b->options, pieces, &work, &work, e);
    if (!s) {
        wf_beam_carry(b, &fine);
        wf_beam_sweep_up(&fine);
        fine.misfit = b->misfit; /* close to equilibrium: one step leaves the square of what is missing */
        bool swept = wf_beam_sweep_down(&fine, true, NULL);
        wf_beam_row_loads(&b->mesh, (const double(*)[2][3])b->load, check.before);
        wf_beam_row_loads(&fine.mesh, (const double(*)[2][3])fine.load, check.begun);
        swept = swept && wf_beam_finish(&fine);
        wf_beam_row_loads(&fine.mesh, (const double(*)[2][3])fine.load, check.load);
        if (swept) *out = off_beside(b, &fine, &check, tolerance, pieces);
    }
    wf_arena_free(&work);
    return s;
}

/* ---- What is known of a mesh ---- */

double wf_beam_pace(const struct wf_loads *l) { return l->wind ? l->wind->speed * sqrt(l->wind_scale) : 0; }

void wf_beam_note_good(struct wf_beam_goods *g, const struct wf_beam_good *found)
{
    g->at[g->n++ % WF_BEAM_GOOD] = *found;
}

double wf_beam_expected_error(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance,
                              double power)
{
    const double pace = wf_beam_pace(l);
    double least = INFINITY;
    for (size_t i = 0; i < g->n && i < WF_BEAM_GOOD && pace > 0; i++) {
        if (!(g->at[i].pace > 0)) continue;
        const double ratio = pace / g->at[i].pace, off = fmax(g->at[i].error / tolerance, g->at[i].turn);
        least = fmin(least, off * fmax(pow(ratio, power), sqrt(1 / ratio)));
    }
    return least;
}

bool wf_beam_good_by_far(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance)
{
    const double most = 0.4;
    return wf_beam_expected_error(g, l, tolerance, 2) <= most;
}
