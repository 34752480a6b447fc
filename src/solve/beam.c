/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam.h"
#include "base/vec3.h"
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"

/* Reading a solved beam: the columns of a response. */

/* Force and moment at the base of element i; its load and the load's moment about `first` are added to
 * `load` and `moment`. */
static void add_element_loads(const struct wf_beam *b, size_t i, const double first[3],
                              struct wf_beam_wrench *base, double load[3], double moment[3])
{
    struct wf_line_load q[2] = { 0 };
    struct wf_beam_wrench at[2];
    double couple[2][3];
    const struct wf_beam_part *p = &b->mesh.part[i];
    for (int j = 0; j < 2; j++) memcpy(q[j].force, b->load[i][j], sizeof q[j].force);
    wf_beam_couple(wf_beam_flat_of(b, i), couple);
    wf_beam_balance(p->h, &b->stage[i], wf_beam_flat_of(b, i), q, &b->wrench[i], at, base);
    for (int j = 0; j < 2; j++) {
        double arm[3], lever[3];
        for (int k = 0; k < 3; k++) arm[k] = b->stage[i].r[j][k] - first[k];
        wf_cross(arm, q[j].force, lever);
        v3_add(load, 0.5 * p->h, q[j].force);
        v3_add(moment, 0.5 * p->h, lever);
        v3_add(moment, 0.5 * p->h, couple[j]);
    }
}

/* Add loads at element ends and their moments about `first`. Computed apart from the sweep that gives the
 * reactions, so that the sum checks them. */
static void add_end_loads(const struct wf_beam *b, const double first[3], double force[3], double moment[3])
{
    const struct wf_loads *l = &b->loads;
    double lever[3], arm[3];
    for (size_t i = 0; b->mesh.mass1 && i < b->mesh.n; i++) {
        const double f[3] = { 0, 0, -l->weight_scale * l->gravity * b->mesh.mass1[i] };
        for (int k = 0; k < 3; k++) arm[k] = b->pose[i].r[k] - first[k];
        wf_cross(arm, f, lever);
        v3_add(force, 1, f), v3_add(moment, 1, lever);
    }
    for (size_t q = 0; q < l->points; q++) {
        const struct wf_point_load *p = &l->point[q];
        const struct wf_beam_pose *at = &b->pose[b->mesh.last[p->segment]];
        double f[3], m[3];
        memcpy(f, p->force, sizeof f), memcpy(m, p->moment, sizeof m);
        if (p->kind == WF_POINT_FOLLOWER) m3_apply(at->L, f, f), m3_apply(at->L, m, m);
        for (int k = 0; k < 3; k++) arm[k] = at->r[k] - first[k];
        wf_cross(arm, f, lever);
        v3_add(force, l->point_scale, f);
        v3_add(moment, l->point_scale, m), v3_add(moment, l->point_scale, lever);
    }
    for (size_t q = 0; q < l->ties; q++) {
        const double *at = b->pose[b->mesh.last[l->tie[q].segment]].r;
        double f[3];
        (void)wf_tie_pull(&l->tie[q], at, f, NULL);
        for (int k = 0; k < 3; k++) arm[k] = at[k] - first[k];
        wf_cross(arm, f, lever);
        v3_add(force, 1, f), v3_add(moment, 1, lever);
    }
}

static double distance_between(const double a[3], const double b[3])
{
    double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    return sqrt(wf_dot(d, d));
}

/* Where the end of row i is before it moves [m]. */
static void still_at(const struct wf_beam_mesh *m, size_t i, double place[3])
{
    const struct wf_tree *t = m->tree;
    const double drawn[3] = { t->x1[i], t->y1[i], t->z1[i] };
    memcpy(place, m->still ? m->still[i] : drawn, sizeof drawn);
}

void wf_beam_read_shape(const struct wf_beam_mesh *m, size_t i, const double base_L[9],
                        const struct wf_beam_pose *end, struct wf_response *r)
{
    const struct wf_tree *t = m->tree;
    double at[3], axis[3], tip[3];
    still_at(m, i, tip);
    wf_row_axis(t, i, 0, at, axis);
    m3_apply(base_L, axis, r->tangent0 + 3 * i);
    wf_row_axis(t, i, 1, at, axis);
    m3_apply(end->L, axis, r->tangent1 + 3 * i);
    rotation_vector(end->L, r->turn + 3 * i);
    for (size_t k = 0; k < 3; k++) r->end[3 * i + k] = end->r[k] - tip[k];
}

void wf_beam_read_balance(const struct wf_beam_wrench *ground, const double force[3], const double moment[3],
                          struct wf_response *r)
{
    memcpy(r->base_force, ground->n, sizeof r->base_force);
    memcpy(r->base_moment, ground->m, sizeof r->base_moment);
    double f = sqrt(wf_dot(force, force)), m = sqrt(wf_dot(moment, moment));
    r->imbalance = fmax(f > 0 ? distance_between(force, ground->n) / f : 0,
                        m > 0 ? distance_between(moment, ground->m) / m : 0);
}

static void read_beam_row(const struct wf_beam *b, size_t i, const double first[3], struct wf_response *r,
                          double force[3], double moment[3])
{
    size_t from = (size_t)b->mesh.first[i], to = (size_t)b->mesh.last[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, from, &ground);
    const struct wf_beam_pose *end = &b->pose[to];
    double load[3] = { 0, 0, 0 };
    for (size_t k = to + 1; k-- > from;) {
        struct wf_beam_wrench w;
        add_element_loads(b, k, first, &w, load, moment);
        if (k == from)
            memcpy(r->force0 + 3 * i, w.n, sizeof w.n), memcpy(r->moment0 + 3 * i, w.m, sizeof w.m);
    }
    v3_add(force, 1, load);
    wf_beam_read_shape(&b->mesh, i, base->L, end, r);
    for (size_t k = 0; k < 3; k++) {
        r->force1[3 * i + k] = b->wrench[to].n[k];
        r->moment1[3 * i + k] = b->wrench[to].m[k];
        r->load[3 * i + k] = load[k];
    }
}

void wf_beam_read(const struct wf_beam *b, struct wf_response *r)
{
    const struct wf_tree *t = b->mesh.tree;
    const double first[3] = { t->x0[0], t->y0[0], t->z0[0] };
    double force[3] = { 0, 0, 0 }, moment[3] = { 0, 0, 0 };
    for (size_t i = 0; i < t->n; i++) read_beam_row(b, i, first, r, force, moment);
    add_end_loads(b, first, force, moment);
    wf_beam_read_balance(&b->base, force, moment, r);
    r->iterations = b->iterations, r->steps = b->steps;
    wf_beam_links_read(b, r->link);
}

/* From one mesh to another: start shape and error. */

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
        for (int32_t k = 0; k < cut; k++) {
            double base[9], at[9], R[9];
            beam_rotation_at(coarse, i, (double)k / cut, base);
            for (int j = 0; j < 2; j++) {
                beam_rotation_at(coarse, i, (k + gauss_place[j]) / cut, at);
                m3_mul_transposed(base, at, R);
                rotation_vector(R, fine->shape[from + k].v[j]);
            }
        }
    }
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
        still_at(&b->mesh, i, d);
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

/* Distributed load on each row as integrated on the mesh, 3n [N]. */
static void row_loads(const struct wf_beam *b, double *load)
{
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        double sum[3] = { 0, 0, 0 };
        for (int32_t k = b->mesh.first[i]; k <= b->mesh.last[i]; k++) {
            for (int j = 0; j < 2; j++) v3_add(sum, 0.5 * b->mesh.part[k].h, b->load[k][j]);
        }
        memcpy(load + 3 * i, sum, sizeof sum);
    }
}

/* Estimated error of each row's load relative to the base reaction, assumed to fall with the power 1.3 of
 * the piece length: wind near the ground grows with a low power of height, and a load with a kink inside a
 * row converges no faster. */
static double load_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *before,
                         const double *now, double *share)
{
    double force = sqrt(wf_dot(fine->base.n, fine->base.n)), sum = 0;
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        double kc = wf_beam_pieces(&coarse->mesh, i), kf = wf_beam_pieces(&fine->mesh, i), d[3];
        for (size_t k = 0; k < 3; k++) d[k] = now[3 * i + k] - before[3 * i + k];
        share[i] = kf > kc && force > 0 ? sqrt(wf_dot(d, d)) / force / (pow(kf / kc, 1.3) - 1) : 0;
        sum += share[i];
    }
    return sum;
}

/* New number of pieces per row. Rows above their share of the error target are refined; none is coarsened,
 * so the carried-over shape is a valid Newton start. off = load error / allowed; above 1 the rows that cause
 * most of it (`bear`) are refined too. */
static void choose_pieces(const struct wf_beam *b, const double *share, double target, const double *bear,
                          double off, int32_t *pieces)
{
    double most = 0, more = off > 1 ? fmax(pow(1.5 * off, 0.77), 2) : 1;
    for (size_t i = 0; i < b->mesh.tree->n; i++) most = fmax(most, bear[i]);
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        int32_t now = wf_beam_pieces(&b->mesh, i);
        double want = pow(share[i] / target, 0.25);
        if (bear[i] > 0.1 * most) want = fmax(want, more);
        pieces[i] = (int32_t)fmin(fmax(ceil(now * want), now), 64.0 * now);
    }
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

/* Is the turn of the tree's tip, whose thin end bends most, that of a finer mesh? */
static bool tip_agrees(const struct wf_beam *coarse, const struct wf_beam *fine, size_t tip)
{
    double R[9], off[3], turn[3];
    const double limit = 1e-3, *L = fine->pose[fine->mesh.last[tip]].L;
    m3_mul_transposed(coarse->pose[coarse->mesh.last[tip]].L, L, R);
    rotation_vector(R, off), rotation_vector(L, turn);
    return wf_dot(off, off) <= limit * limit * wf_dot(turn, turn) + 1e-20;
}

bool wf_beam_check_meets(const struct wf_beam *coarse, const struct wf_beam *fine, struct wf_beam_check *c,
                         int32_t *pieces)
{
    const double safety = 0.25;
    const double rounding = 1e-12; /* relative to the tree's size: positions are no more accurate than this,
                                      so a tree that hardly moves converges too */
    const struct wf_tree *t = fine->mesh.tree;
    double allowed = fine->options->mesh_tolerance * safety;
    double target = fmax(allowed * largest_displacement(fine), rounding * tree_size(t));
    double error = beam_mesh_error(coarse, fine, c->reach, c->share);
    double reactions = load_error(coarse, fine, c->before, c->load, c->bear);
    memcpy(c->before, c->load, 3 * t->n * sizeof *c->load);
    const size_t tip = wf_tip_row(t);
    bool turns = tip_agrees(coarse, fine, tip);
    if (error <= target && reactions <= allowed && turns) return true;
    choose_pieces(fine, c->share, target / c->depth, c->bear, reactions / allowed, pieces);
    if (!turns) pieces[tip] = (int32_t)fmax(pieces[tip], 2 * wf_beam_pieces(&fine->mesh, tip));
    return false;
}

/* Memory of two meshes: of the newer, and of the shape of the one before, with which it is compared. */
struct two_meshes {
    struct wf_arena before, shape, newton;
};

/* As wf_beam_settle; where Newton's method stalls, first from the shape of `near` (NULL: none). */
static enum wf_status settle_near(struct wf_beam *b, const struct wf_beam *near, struct wf_arena *newton,
                                  struct wf_beam_outcome *out, struct wf_err *e)
{
    enum { FOLLOW_ITERATIONS = 32 }; /* from a neighbour it converges soon or not at all */
    const struct wf_solve_options *own = b->options;
    struct wf_solve_options follow = *own;
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (wf_beam_rests(b)) return WF_OK;
    if (!near) return wf_beam_step_to_rest(b, newton, out, e);
    follow.iterations_max = FOLLOW_ITERATIONS;
    wf_beam_carry(near, b);
    b->options = &follow;
    bool rests = wf_beam_rests(b) || wf_beam_settle_parts(b, newton);
    b->options = own;
    return rests ? WF_OK : wf_beam_step_to_rest(b, newton, out, e);
}

static enum wf_status solve_on_meshes(const struct wf_tree *t, const struct wf_loads *l,
                                      const struct wf_solve_options *o, const struct wf_beam *from,
                                      const struct wf_beam *near, struct wf_arena *work, struct two_meshes *m,
                                      struct wf_beam *b, struct wf_beam_outcome *out, struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_beam_check check;
    int32_t *pieces = WF_TAKE(work, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;

    enum wf_status status = wf_beam_init(b, t, l, o, pieces, &m->shape, &m->newton, e);
    if (!status && from) wf_beam_carry(from, b);
    if (!status) status = settle_near(b, near, &m->newton, out, e);
    if (status || !(o->mesh_tolerance > 0)) return status;

    status = wf_beam_check_make(t, work, &check, e);
    if (status) return status;
    row_loads(b, check.before);
    for (size_t i = 0; i < t->n; i++) pieces[i] = 2 * start;
    for (int mesh = 1; mesh < MESHES; mesh++) {
        struct wf_beam fine;
        struct wf_beam_outcome again;
        wf_arena_free(&m->newton);
        wf_arena_free(&m->before);
        m->before = m->shape;
        m->shape = (struct wf_arena){ 0 };
        status = wf_beam_init(&fine, t, l, o, pieces, &m->shape, &m->newton, e);
        if (status) return status;
        wf_beam_carry(b, &fine);
        status = settle_near(&fine, near, &m->newton, &again, e);
        if (status || again.beyond_limit) *out = again;
        if (status) return status;
        fine.iterations += b->iterations, fine.steps += b->steps;
        row_loads(&fine, check.load);
        bool met = wf_beam_check_meets(b, &fine, &check, pieces);
        *b = fine;
        if (met) break;
    }
    return WF_OK;
}

enum wf_status wf_beam_mesh_meets(const struct wf_beam *b, double tolerance, bool *meets, struct wf_err *e)
{
    const struct wf_tree *t = b->mesh.tree;
    struct wf_arena work = { 0 };
    struct wf_beam fine;
    int32_t *pieces = WF_TAKE(&work, t->n, int32_t);
    double *reach = WF_TAKE(&work, t->n, double), *share = WF_TAKE(&work, t->n, double),
           *load = WF_TAKE(&work, 6 * t->n, double);
    enum wf_status s = pieces && reach && share && load
                           ? WF_OK
                           : wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    *meets = false;
    for (size_t i = 0; i < t->n && !s; i++) pieces[i] = 2 * wf_beam_pieces(&b->mesh, i);
    if (!s) s = wf_beam_init(&fine, t, &b->loads, b->options, pieces, &work, &work, e);
    if (!s) {
        wf_beam_carry(b, &fine);
        wf_beam_sweep_up(&fine);
        fine.misfit = b->misfit; /* close to equilibrium: one step leaves the square of what is missing */
        if (wf_beam_step(&fine, NULL)) {
            tree_reach(t, reach);
            row_loads(b, load);
            row_loads(&fine, load + 3 * t->n);
            /* of the coarse mesh: 2^4 and 2^1.3 times that of the fine one */
            double error = 16 * beam_mesh_error(b, &fine, reach, share);
            double reactions = pow(2, 1.3) * load_error(b, &fine, load, load + 3 * t->n, share);
            *meets = error <= tolerance * largest_displacement(&fine) && reactions <= tolerance &&
                     tip_agrees(b, &fine, wf_tip_row(t));
        }
    }
    wf_arena_free(&work);
    return s;
}

enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_beam *from,
                             const struct wf_beam *near, struct wf_arena *work, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e)
{
    struct two_meshes m = { 0 };
    enum wf_status status = solve_on_meshes(t, l, o, from, near, work, &m, b, out, e);
    wf_arena_free(&m.before);
    wf_arena_join(work, &m.shape);
    wf_arena_join(work, &m.newton);
    return status;
}

void wf_beam_warn(const struct wf_beam *b, const struct wf_beam_outcome *out, struct wf_diag *d)
{
    if (!d) return;
    if (b->loose > 0)
        wf_diag_warn(d, "loose-parts",
                     "%zu small parts, each carrying less than 1 %% of the load, are in unstable "
                     "equilibrium: they may "
                     "snap to another shape",
                     b->loose);
    if (out->beyond_limit)
        wf_diag_warn(
            d, "limit-point",
            "the tree becomes unstable at %.3g of the load; the result is the stable equilibrium it falls to",
            out->load_factor);
}

/* The solver row: large deflections. */

static enum wf_status beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                                 const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                                 struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    struct wf_beam_outcome out = { 0 };
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    if (status) return status;
    status = wf_solve_check(t, l, d, e);
    if (!status) status = wf_beam_solve(t, l, o, NULL, NULL, &work, &b, &out, e);
    if (!status) wf_beam_read(&b, r);
    r->load_factor = out.load_factor;
    if (!status) wf_beam_warn(&b, &out, d);
    wf_arena_free(&work);
    return status;
}

const struct wf_solver wf_solver_beam = {
    .name = "beam",
    .title = "geometrically exact beams, large deflections",
    .source = "Simo 1985, Comput. Methods Appl. Mech. Eng. 49:55-70; Antman 2005, Nonlinear Problems of "
              "Elasticity, "
              "ch. 8; Gauss collocation: Hairer, Lubich & Wanner 2006, II.1.3",
    .validity = "Elastic wood, static mean wind; any deflection. Loads follow the bent shape.",
    .tracked = true,
    .ties = true,
    .stands = true,
    .solve = beam_solve,
};

/* The linear solver: one step on the beam elements, with loads and equilibrium of the undeformed tree, small
 * displacements and rotations. */

/* Rotation of the root plate of a row under a moment. */
static void plate_tilt(const struct wf_beam *b, size_t row, const double moment[3], double q[3])
{
    for (int j = 0; j < 2; j++) {
        double rest = b->mesh.root ? b->mesh.root[row][j] : 0;
        if (b->options->root_stiffness[j] > 0) q[j] = (moment[j] - rest) / b->options->root_stiffness[j];
    }
}

/* The loads of the undeformed tree do not change in this solution: as dead loads they are computed once. */
static void linear_hold_loads(struct wf_beam *b)
{
    enum { SOME = 32 };                    /* elements at once, side by side */
    if (b->loads.point_scale != 1) return; /* dead loads would be scaled by it again */
    for (size_t from = 0; from < b->mesh.n; from += SOME) {
        size_t n = b->mesh.n - from < SOME ? b->mesh.n - from : SOME;
        struct wf_lanes_point point[2 * SOME];
        struct wf_line_load load[2 * SOME];
        for (size_t k = 0; k < 2 * n; k++) {
            const struct wf_beam_stage *s = &b->stage[from + k / 2];
            const struct wf_beam_part *p = &b->mesh.part[from + k / 2];
            point[k] = (struct wf_lanes_point){ s->r[k % 2], s->t[k % 2], p->dead[k % 2], &p->line[k % 2] };
        }
        wf_lanes_kernel(WF_LANES_MOST)->loads(&b->loads, 2 * n, point, load);
        for (size_t k = 0; k < 2 * n; k++) {
            struct wf_beam_part *p = &b->mesh.part[from + k / 2];
            memcpy(p->dead[k % 2], load[k].force, sizeof p->dead[k % 2]);
            p->line[k % 2].mass = 0;
        }
    }
    b->loads.wind = NULL;
}

/* wf_beam_sweep_up for the undeformed tree. */
static void linear_place(struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_stage *s = &b->stage[i];
        struct wf_beam_pose ground;
        const double *base = wf_beam_base(b, i, &ground)->r;
        memcpy(s->t, p->t, sizeof s->t), memcpy(s->rp, p->t, sizeof s->rp);
        for (int c = 0; c < 3; c++) {
            for (int j = 0; j < 2; j++)
                s->r[j][c] = base[c] + p->h * (gauss_up[j][0] * p->t[0][c] + gauss_up[j][1] * p->t[1][c]);
            b->pose[i].r[c] = base[c] + 0.5 * p->h * (p->t[0][c] + p->t[1][c]);
            b->pose[i].L[4 * c] = 1;
        }
    }
}

/* Rotation q and displacement u of the undeformed tree from its internal forces: q' = G m - k0,  u' = q x t
 * + H n - g0,  by the same collocation as the full element. */
static void linear_displacements(struct wf_beam *b, double (*u)[3], double (*q)[3])
{
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        const struct wf_beam_stage *s = &b->stage[i];
        struct wf_line_load load[2];
        struct wf_beam_wrench at[2], base;
        double k[2][3], up[2][3], q0[3] = { 0, 0, 0 }, u0[3] = { 0, 0, 0 };
        wf_beam_load(p, &b->loads, s, load);
        wf_beam_balance(p->h, s, NULL, load, &b->wrench[i], at, &base);
        if (p->parent >= 0)
            memcpy(q0, q[p->parent], sizeof q0), memcpy(u0, u[p->parent], sizeof u0);
        else
            plate_tilt(b, (size_t)p->row, base.m, q0);
        for (int j = 0; j < 2; j++) {
            v3_section(1 / p->ei[j], 1 / p->gj[j], s->t[j], at[j].m, k[j]);
            v3_add(k[j], -1, p->k0[j]);
        }
        for (int j = 0; j < 2; j++) {
            double turn[3], stretch[3];
            for (int c = 0; c < 3; c++)
                turn[c] = q0[c] + p->h * (gauss_up[j][0] * k[0][c] + gauss_up[j][1] * k[1][c]);
            wf_cross(turn, s->t[j], up[j]);
            v3_section(p->cs[j], p->ca[j], s->t[j], at[j].n, stretch);
            v3_add(up[j], 1, stretch);
            v3_add(up[j], -1, p->g0[j]);
        }
        for (int c = 0; c < 3; c++) {
            q[i][c] = q0[c] + 0.5 * p->h * (k[0][c] + k[1][c]);
            u[i][c] = u0[c] + 0.5 * p->h * (up[0][c] + up[1][c]);
        }
    }
}

struct linear_answer {
    struct wf_beam beam;
    double (*u)[3], (*q)[3];
};

static enum wf_status linear_answer_on(const struct wf_tree *t, const struct wf_loads *l,
                                       const struct wf_solve_options *o, int32_t pieces_each, int32_t *pieces,
                                       struct wf_arena *work, struct linear_answer *x, struct wf_err *e)
{
    for (size_t i = 0; i < t->n; i++) pieces[i] = pieces_each;
    enum wf_status status = wf_beam_init(&x->beam, t, l, o, pieces, work, NULL, e);
    if (status) return status;
    x->u = wf_arena_take(work, x->beam.mesh.n, sizeof *x->u);
    x->q = wf_arena_take(work, x->beam.mesh.n, sizeof *x->q);
    if (!x->u || !x->q)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu displacements", x->beam.mesh.n);
    linear_place(&x->beam);
    linear_hold_loads(&x->beam);
    wf_beam_sweep_down(&x->beam, false, NULL);
    linear_displacements(&x->beam, x->u, x->q);
    return WF_OK;
}

/* Estimated error on the finer of two meshes of ratio 2, relative to the largest displacement and rotation:
 * a fifteenth of their difference, at order 4. */
static double linear_mesh_error(const struct linear_answer *coarse, const struct linear_answer *fine)
{
    double off[2] = { 0, 0 }, size[2] = { 0, 0 };
    for (size_t i = 0; i < fine->beam.mesh.tree->n; i++) {
        size_t a = (size_t)coarse->beam.mesh.last[i], b = (size_t)fine->beam.mesh.last[i];
        for (int c = 0; c < 3; c++) {
            off[0] = fmax(off[0], fabs(coarse->u[a][c] - fine->u[b][c]));
            off[1] = fmax(off[1], fabs(coarse->q[a][c] - fine->q[b][c]));
            size[0] = fmax(size[0], fabs(fine->u[b][c]));
            size[1] = fmax(size[1], fabs(fine->q[b][c]));
        }
    }
    return fmax(size[0] > 0 ? off[0] / size[0] : 0, size[1] > 0 ? off[1] / size[1] : 0) / 15;
}

static void linear_read(const struct linear_answer *x, struct wf_response *r)
{
    const struct wf_beam *b = &x->beam;
    wf_beam_read(b, r);
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        int32_t last = b->mesh.last[i], below = b->mesh.part[b->mesh.first[i]].parent;
        double c[3], q0[3] = { 0, 0, 0 };
        if (below < 0) plate_tilt(b, i, r->moment0 + 3 * i, q0);
        memcpy(r->end + 3 * i, x->u[last], sizeof *x->u);
        memcpy(r->turn + 3 * i, x->q[last], sizeof *x->q);
        wf_cross(x->q[last], r->tangent1 + 3 * i, c);
        v3_add(r->tangent1 + 3 * i, 1, c);
        wf_cross(below < 0 ? q0 : x->q[below], r->tangent0 + 3 * i, c);
        v3_add(r->tangent0 + 3 * i, 1, c);
    }
    r->load_factor = 1;
    r->iterations = r->steps = 1;
    r->small_deflection = true;
}

static enum wf_status linear_solve(const struct wf_tree *t, const struct wf_loads *l,
                                   const struct wf_solve_options *o, struct wf_arena *a,
                                   struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    const int32_t most = 512;
    struct wf_arena work = { 0 };
    struct linear_answer x, last;
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    int32_t *pieces = WF_TAKE(&work, t->n, int32_t), cut = 1;
    if (!status && !pieces) status = wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    if (!status) status = wf_solve_check_round(t, "the linear solver", e);
    if (!status) status = wf_solve_check(t, l, d, e);
    if (!status) status = linear_answer_on(t, l, o, cut, pieces, &work, &x, e);
    while (!status && o->mesh_tolerance > 0 && cut < most) {
        last = x;
        status = linear_answer_on(t, l, o, cut *= 2, pieces, &work, &x, e);
        if (!status && linear_mesh_error(&last, &x) <= 0.25 * o->mesh_tolerance) break;
    }
    if (!status) linear_read(&x, r);
    wf_arena_free(&work);
    return status;
}

const struct wf_solver wf_solver_linear = {
    .name = "linear",
    .title = "linear beams, small deflections",
    .source = "Euler-Bernoulli beam theory",
    .validity =
        "Deflections below 10 % of height and slopes below 15 degrees: loads and balance of the unbent tree.",
    .small_deflection = true,
    .stands = true,
    .solve = linear_solve,
};
