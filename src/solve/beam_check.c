/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_check.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* ---- Start shape ---- */

/* Rotation from the unloaded to the loaded state at fraction x (0..1) of an element. */
static void rotation_in(const struct wf_beam *b, size_t element, double x, double L[9])
{
    double v[3], R[9];
    const struct wf_beam_shape *u = &b->shape[element];
    /* the quadratic through 0 at the base and the two Gauss points */
    double a = x * (x - gauss_place[1]) / (gauss_place[0] * (gauss_place[0] - gauss_place[1]));
    double c = x * (x - gauss_place[0]) / (gauss_place[1] * (gauss_place[1] - gauss_place[0]));
    for (int i = 0; i < 3; i++) v[i] = a * u->v[0][i] + c * u->v[1][i];
    struct wf_beam_pose ground;
    rotation_matrix(v, R);
    m3_mul(wf_beam_base(b, element, &ground)->L, R, L);
}

/* The element at fraction s (0..1) of a row, and *x, the fraction of it there. */
static size_t element_at(const struct wf_beam *b, size_t row, double s, double *x)
{
    return (size_t)(b->mesh.first[row] + wf_beam_piece_at(&b->mesh, row, s, x));
}

/* The rotation at fraction s of a row. */
static void beam_rotation_at(const struct wf_beam *b, size_t row, double s, double L[9])
{
    double x;
    const size_t element = element_at(b, row, s, &x);
    rotation_in(b, element, x, L);
}

void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine)
{
    memcpy(fine->tilt, coarse->tilt, fine->mesh.tree->n * sizeof *fine->tilt);
    wf_beam_links_carry(coarse, fine);
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        int32_t from = fine->mesh.first[i], cut = fine->mesh.last[i] - from + 1;
        const bool same = wf_beam_pieces(&coarse->mesh, i) == cut && coarse->mesh.graded == fine->mesh.graded;
        for (int32_t k = 0; k < cut; k++) {
            double base[9], at[9], R[9];
            if (same) {
                memcpy(fine->shape[from + k].v, coarse->shape[coarse->mesh.first[i] + k].v,
                       sizeof fine->shape->v);
                continue;
            }
            const double s0 = wf_beam_cut(&fine->mesh, i, k, cut),
                         s1 = wf_beam_cut(&fine->mesh, i, k + 1, cut);
            beam_rotation_at(coarse, i, s0, base);
            for (int j = 0; j < 2; j++) {
                beam_rotation_at(coarse, i, wf_between(s0, s1, gauss_place[j]), at);
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

/* The error of positions falls with this power of the piece length, and so does that of smooth loads. */
static const double smooth_order = 4;

/* The power with which a row's own error falls between its mesh of so many pieces and a finer one: where the
 * thin end of the last piece is much thinner than its base, most of the bending is there, and the error does
 * not fall as fast yet. */
static double position_order(const struct wf_tree *t, size_t i, double pieces)
{
    const double much = 0.5, slow = 1;
    const double end = fmin(t->r0[i], t->r1[i]), base = end + fabs(t->r0[i] - t->r1[i]) / pieces;
    return end < much * base ? slow : smooth_order;
}

/* Estimated error of position at the worst node [m], from solutions on a mesh and a finer one of the same
 * tree. Each row's own contribution (its end relative to its base) falls with a power of the piece length;
 * its error of rotation moves everything beyond it, up to `reach` away. share[n]: contribution of each row
 * [m]; a row that was not refined keeps its old value. */
static double beam_mesh_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *reach,
                              double *share)
{
    const struct wf_tree *t = fine->mesh.tree;
    double worst = 0;
    for (size_t i = 0; i < t->n; i++) {
        double a[3], b[3], A[9], B[9], R[9], turn[3];
        double kc = wf_beam_pieces(&coarse->mesh, i), kf = wf_beam_pieces(&fine->mesh, i);
        double fall =
            pow(kf / kc, position_order(t, i, kc)) - 1; /* error(coarse) = error(fine) (kf/kc)^order */
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

/* Where nothing else is known the error of a row's load is assumed to fall with this power of the piece
 * length, as that of a load which grows with a low power of the way or has a kink inside the row. */
static const double load_order = 1.3;

static double distance(const double a[3], const double b[3])
{
    double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    return sqrt(wf_dot(d, d));
}

/* Position and unit tangent of the loaded axis at fraction s (0..1) of a row, whose unloaded tangent there is
 * `still`. */
static void axis_at(const struct wf_beam *b, size_t row, double s, const double still[3], double at[3],
                    double tangent[3])
{
    double x;
    const size_t piece = element_at(b, row, s, &x);
    const double *const g = gauss_place, narrow = g[1] - g[0];
    /* lengths of the axis to x and to the end along the tangents at the Gauss points, [1]: whole */
    const double to[2] = { (g[1] * x - 0.5 * x * x) / narrow, (0.5 * x * x - g[0] * x) / narrow };
    const struct wf_beam_part *p = &b->mesh.part[piece];
    const struct wf_beam_pose *end = &b->pose[piece];
    double R[9], L[9], t[3], whole[3];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, piece, &ground);
    rotation_in(b, piece, x, L);
    m3_apply(L, still, tangent);
    memcpy(at, base->r, sizeof base->r), memcpy(whole, base->r, sizeof whole);
    for (int j = 0; j < 2; j++) {
        rotation_matrix(b->shape[piece].v[j], R);
        m3_mul(base->L, R, L);
        m3_apply(L, p->t[j], t);
        v3_add(at, p->h * to[j], t), v3_add(whole, 0.5 * p->h, t);
    }
    for (int c = 0; c < 3; c++) at[c] += x * (end->r[c] - whole[c]); /* what the axis is stretched by */
}

/* Points at which the loads are computed side by side, and what they add to. */
enum { PROBES = 64 };
struct probes {
    const struct wf_beam *beam;
    size_t n;
    double at[PROBES][3], tangent[PROBES][3], dead[PROBES][3], length[PROBES];
    struct wf_line_point line[PROBES];
    double *load[PROBES];
};

static void add_probed(struct probes *x)
{
    struct wf_lanes_point point[PROBES];
    struct wf_line_load out[PROBES];
    for (size_t q = 0; q < x->n; q++)
        point[q] = (struct wf_lanes_point){ x->at[q], x->tangent[q], x->dead[q], &x->line[q] };
    if (x->n) wf_lanes_kernel(WF_LANES_MOST)->loads(&x->beam->loads, NULL, x->n, point, out, NULL);
    for (size_t q = 0; q < x->n; q++) v3_add(x->load[q], x->length[q], out[q].force);
    x->n = 0;
}

/* Set load[3] to the distributed load on a row as integrated over `cut` pieces [N], once all is added. */
static void probe_row(struct probes *x, size_t row, int32_t cut, double *load)
{
    const struct wf_tree *t = x->beam->mesh.tree;
    const double length = wf_tree_length(t, row), *const line = x->beam->loads.line;
    memset(load, 0, 3 * sizeof *load);
    for (int32_t k = 0; k < 2 * cut; k++) {
        const double s0 = wf_beam_cut(&x->beam->mesh, row, k / 2, cut),
                     s1 = wf_beam_cut(&x->beam->mesh, row, k / 2 + 1, cut),
                     s = wf_between(s0, s1, gauss_place[k % 2]);
        double still[3], drawn[3];
        if (x->n == PROBES) add_probed(x);
        const size_t q = x->n++;
        wf_row_axis(t, row, s, drawn, still);
        axis_at(x->beam, row, s, still, x->at[q], x->tangent[q]);
        x->line[q] = wf_line_point_of(t, row, s);
        x->length[q] = 0.5 * length * (s1 - s0), x->load[q] = load;
        for (size_t c = 0; c < 3; c++)
            x->dead[q][c] = line ? wf_between(line[6 * row + c], line[6 * row + 3 + c], s) : 0;
    }
}

/* By how much finer a mesh is in a row. */
static double finer(const struct wf_beam *coarse, const struct wf_beam *fine, size_t i)
{
    return (double)wf_beam_pieces(&fine->mesh, i) / wf_beam_pieces(&coarse->mesh, i);
}

/* Loads on the coarse mesh and on one twice as fine as the fine mesh, in the shape of the latter, of the rows
 * of whose errors that are possible [N] it matters. */
static void probe_rows(const struct wf_beam *coarse, const struct wf_beam *fine, double matters,
                       struct wf_beam_check *c)
{
    const size_t n = fine->mesh.tree->n;
    struct probes x = { .beam = fine };
    for (size_t i = 0; i < n; i++) {
        c->looked[i] = finer(coarse, fine, i) > 1 && c->bear[i] > matters;
        if (c->looked[i]) probe_row(&x, i, wf_beam_pieces(&coarse->mesh, i), c->again + 3 * i);
    }
    add_probed(&x);
    for (size_t i = 0; i < n; i++) {
        if (!c->looked[i]) continue;
        const double off = distance(c->load + 3 * i, c->again + 3 * i);
        if (off / (pow(finer(coarse, fine, i), load_order) - 1) > matters)
            probe_row(&x, i, 2 * wf_beam_pieces(&fine->mesh, i), c->closer + 3 * i);
        else
            memcpy(c->closer + 3 * i, c->load + 3 * i, 3 * sizeof *c->closer);
    }
    add_probed(&x);
}

/* The error of a row's integral, from the loads on the coarse mesh, on the fine mesh, r times as fine, and on
 * one twice as fine, all in the shape of the fine mesh; they show the order too. */
static void look_closer(double r, size_t i, struct wf_beam_check *c)
{
    const double part = 1 - pow(2, -load_order), likely = 2.5; /* half more than at a kink */
    const double off = distance(c->load + 3 * i, c->again + 3 * i),
                 left = distance(c->closer + 3 * i, c->load + 3 * i);
    const double least = off / (pow(r, likely) - 1), most = off / (pow(r, load_order) - 1);
    const double order = left > 0 ? log1p(part * off / left) / log(r) : load_order;
    c->bear[i] = left > 0 ? fmin(most, fmax(left / part, least)) : most;
    c->order[i] = fmin(fmax(order, load_order), smooth_order);
}

/* The force to which errors of loads are relative: that of the wind; in little wind a share of all, for no
 * load is known better than to rounding of the weight [N]. */
static double force_of(const struct wf_beam *b)
{
    const double share = 0.02, *n = b->base.n;
    return fmax(fmax(hypot(n[0], n[1]), share * sqrt(wf_dot(n, n))), DBL_MIN);
}

/* Estimated errors of the loads: of each row's integral, which stays where the row was not refined, and what
 * the error of the shape changes of them, by which they differ on the coarse mesh. Returned: their sum;
 * c->rough: that on the coarse mesh. */
static double load_error(const struct wf_beam *coarse, const struct wf_beam *fine, double tolerance,
                         struct wf_beam_check *c)
{
    const size_t n = fine->mesh.tree->n;
    const double force = force_of(fine), small = 0.1, matters = force * small * tolerance / (double)n;
    double sum = 0, moved = 0;
    c->rough = 0;
    for (size_t i = 0; i < n; i++) {
        const double r = finer(coarse, fine, i), off = distance(c->load + 3 * i, c->before + 3 * i);
        if (r > 1) c->order[i] = load_order;
        c->bear[i] = r > 1 ? off / (pow(r, load_order) - 1) : c->bear[i] * force;
        c->rough += off;
    }
    probe_rows(coarse, fine, matters, c);
    for (size_t i = 0; i < n; i++) {
        if (c->looked[i]) {
            const double r = finer(coarse, fine, i), *again = c->again + 3 * i;
            moved += distance(again, c->before + 3 * i) / (pow(r, smooth_order) - 1);
            look_closer(r, i, c);
        }
        c->bear[i] /= force;
        sum += c->bear[i];
    }
    c->moved = moved / force;
    c->rough = c->rough / force + sum;
    return sum + c->moved;
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
            c->rest[i] *= pow((double)had / pieces[i], c->order[i]);
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
        c->rest[i] = c->bear[i] * pow(had / pieces[i], c->order[i]);
    }
    choose_by_loads(from, c, allowed, pieces);
    if (c->place > 0) c->left += c->moved * c->worst / (c->place * c->scale);
    return count(pieces, n);
}

enum wf_status wf_beam_check_make(const struct wf_tree *t, struct wf_arena *a, struct wf_beam_check *c,
                                  struct wf_err *e)
{
    *c = (struct wf_beam_check){ .reach = WF_TAKE(a, t->n, double),
                                 .share = WF_TAKE(a, t->n, double),
                                 .bear = WF_TAKE(a, t->n, double),
                                 .order = WF_TAKE(a, t->n, double),
                                 .rest = WF_TAKE(a, t->n, double),
                                 .root = WF_TAKE(a, t->n, double),
                                 .before = WF_TAKE(a, 3 * t->n, double),
                                 .load = WF_TAKE(a, 3 * t->n, double),
                                 .again = WF_TAKE(a, 3 * t->n, double),
                                 .closer = WF_TAKE(a, 3 * t->n, double),
                                 .looked = WF_TAKE(a, t->n, bool) };
    if (!c->reach || !c->share || !c->bear || !c->order || !c->rest || !c->root || !c->before || !c->load ||
        !c->again || !c->closer || !c->looked)
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
    const double known = isnan(place + loads + turn) ? (double)INFINITY : 0;
    struct wf_beam_good g = {
        .pace = wf_beam_pace(l), .place = fmax(place, known), .loads = fmax(loads, known), .turn = turn
    };
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
    c->loads = load_error(coarse, fine, tolerance, c);
    c->place = beam_mesh_error(coarse, fine, c->reach, c->share) / c->scale;
    c->turn = tip_lack(coarse, fine, wf_tip_row(fine->mesh.tree));
    memcpy(c->before, c->load, 3 * fine->mesh.tree->n * sizeof *c->load);
    return c->place <= enough * tolerance && c->loads <= enough_loads * tolerance && c->turn <= 1;
}

/* The same for the loads, whose rows' errors are summed without their signs: those of many rows cancel in
 * part.
 */
static double aim_loads(size_t rows)
{
    const double least = 0.3, most = 0.6, few = 40;
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
    const double loads = c->rough / tolerance;
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
    const double allowed = allowed_error(fine, tolerance);
    const size_t tip = wf_tip_row(b->mesh.tree);
    c->loads = load_error(b, fine, tolerance, c);
    c->scale = allowed / tolerance;
    c->place = beam_mesh_error(b, fine, c->reach, c->share) / c->scale;
    c->turn = tip_lack(b, fine, tip);
    struct wf_beam_good found = /* on the mesh of b, 2^4 times that of positions on the fine one */
        good_of(&b->loads, 16 * c->place, c->rough, c->turn);
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
    *out = (struct wf_beam_good){ .place = INFINITY };
    for (size_t i = 0; i < t->n && !s; i++) pieces[i] = 2 * wf_beam_pieces(&b->mesh, i);
    if (!s) s = wf_beam_init(&fine, t, &b->loads, b->options, pieces, &work, &work, e);
    if (!s) {
        wf_beam_carry(b, &fine);
        wf_beam_sweep_up(&fine);
        fine.misfit = b->misfit; /* close to equilibrium: one step leaves the square of what is missing */
        bool swept = wf_beam_sweep_down(&fine, true, NULL);
        wf_beam_row_loads(&b->mesh, (const double(*)[2][3])b->load, check.before);
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

/* The expected error of what is allowed; that of loads, which grows slowly, counts by a share. */
static double expected_error(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance,
                             double power, double share)
{
    const double pace = wf_beam_pace(l);
    double least = INFINITY;
    for (size_t i = 0; i < g->n && i < WF_BEAM_GOOD && pace > 0; i++) {
        if (!(g->at[i].pace > 0)) continue;
        const struct wf_beam_good *at = &g->at[i];
        const double ratio = pace / at->pace, slowly = fmax(sqrt(ratio), sqrt(1 / ratio)),
                     bent = fmax(at->place / tolerance, at->turn) * fmax(pow(ratio, power), slowly);
        least = fmin(least, fmax(bent, share * at->loads / tolerance * slowly));
    }
    return least;
}

double wf_beam_expected_error(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance,
                              double power)
{
    return expected_error(g, l, tolerance, power, 1);
}

bool wf_beam_good_by_far(const struct wf_beam_goods *g, const struct wf_loads *l, double tolerance)
{
    const double most = 0.5, most_loads = 0.8;
    return expected_error(g, l, tolerance, 2, most / most_loads) <= most;
}
