/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The boundary-value problem of a tree of rods, by multiple shooting on the tree.
 *
 * Unknowns are position, rotation, force and moment at the base of every piece. Integrated to its end, each
 * piece must meet the bases of the pieces on it, and its force and moment must equal the sum of theirs and
 * of the loads at its end (Feng et al. 1999, eqs 4 and 5); at a free tip that sum is empty. Newton's
 * equations have the structure of the tree: from the tips down, the change of force and moment at a piece's
 * base is computed as a linear function of the change of its pose, a 6 x 6 block per piece; from the root up
 * the changes follow. Damping by the natural monotonicity test (Deuflhard 2004, Newton Methods for Nonlinear
 * Problems, sec. 3.3); a derivative is reused while convergence is fast enough. */
#include "solve/rod.h"
#include "base/num.h"
#include "solve/beam.h"
#include "solve/beam_mesh.h"
#include "solve/rod_integrate.h"
#include <gsl/gsl_linalg.h>

struct wf_rod_node { /* one a piece */
    struct wf_rod_pose pose;
    struct wf_rod_wrench wrench; /* at the piece's base */
    double tilt[3];              /* tilt of the root plate, for pieces on the ground */
};
struct wf_rod_end { /* where the integration of a piece arrives */
    struct wf_rod_pose pose;
    struct wf_rod_wrench wrench;
    double tally[3];
};
struct wf_rod_block {
    double J[144];        /* derivative of the end by the base */
    double K[36], lu[36]; /* change of the base's wrench by its pose; factor of the 6x6 block */
    size_t order[6];      /* its row order */
    double root[9];       /* for pieces on a root plate: change of tilt by moment */
};

struct wf_rod {
    const struct wf_tree *tree;
    struct wf_loads loads; /* a copy of the caller's */
    const struct wf_solve_options *options;
    struct wf_rod_integrator integrator;
    size_t n;
    struct wf_rod_piece *piece;
    int32_t *last; /* per row: its last piece */
    struct wf_rod_node *node, *trial;
    struct wf_rod_end *end;
    struct wf_rod_block *block;
    double (*off)[12];                  /* residual: pose against the end below, wrench at the end */
    double (*step)[12];                 /* Newton step */
    double (*next)[12];                 /* next (simplified) Newton step, with the same derivative */
    double (*tilt)[3], (*next_tilt)[3]; /* of the root plates */
    double (*change)[6];                /* change of the ends' poses, while solving */
    int32_t *first_point, *next_point;  /* per row, per load: point loads of a row; -1 ends */
    double size;                        /* length that scales positions [m] */
    size_t iterations, steps;
    const char *fault;
};

/* Residual of the present nodes. */

/* External force and moment at the end of a piece that ends its row: point mass, dead and follower loads.
 * Given: rotation q of the end. Returned: added to *w; by_spin (36, may be NULL): derivative by (position,
 * spin), added. */
static void rod_end_load(const struct wf_rod *r, size_t i, const double q[4], struct wf_rod_wrench *w,
                         double *by_spin)
{
    const struct wf_loads *l = &r->loads;
    const struct wf_rod_piece *p = &r->piece[i];
    if (!p->last) return;
    if (r->tree->mass1) w->n[2] -= l->weight_scale * l->gravity * r->tree->mass1[p->row];
    for (int32_t k = r->first_point[p->row]; k >= 0; k = r->next_point[k]) {
        const struct wf_point_load *o = &l->point[k];
        double f[3], m[3], N[9] = { 0 }, M[9] = { 0 };
        memcpy(f, o->force, sizeof f), memcpy(m, o->moment, sizeof m);
        if (o->kind == WF_POINT_FOLLOWER) wf_rod_turn(q, o->force, f), wf_rod_turn(q, o->moment, m);
        v3_add(w->n, l->point_scale, f), v3_add(w->m, l->point_scale, m);
        if (!by_spin || o->kind != WF_POINT_FOLLOWER) continue;
        m3_add_cross(N, -l->point_scale, f), m3_add_cross(M, -l->point_scale, m);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                by_spin[6 * a + 3 + b] += N[3 * a + b], by_spin[6 * (3 + a) + 3 + b] += M[3 * a + b];
    }
}

/* Residuals: poses against the ends below, forces and moments at the ends (eqs 4, 5). */
static void set_misfit(struct wf_rod *r, const struct wf_rod_node *node)
{
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_end *end = &r->end[i];
        struct wf_rod_wrench outside = { { 0 }, { 0 } };
        double *off = r->off[i];
        rod_end_load(r, i, end->pose.q, &outside, NULL);
        for (int k = 0; k < 3; k++) {
            off[k] = off[3 + k] = 0;
            off[6 + k] = end->wrench.n[k] - outside.n[k];
            off[9 + k] = end->wrench.m[k] - outside.m[k];
        }
    }
    for (size_t i = 0; i < r->n; i++) {
        int32_t below = r->piece[i].parent;
        if (below < 0) continue;
        const struct wf_rod_pose *under = &r->end[below].pose;
        double back[4] = { under->q[0], -under->q[1], -under->q[2], -under->q[3] }, turn[4];
        for (int k = 0; k < 3; k++) {
            r->off[i][k] = node[i].pose.r[k] - under->r[k];
            r->off[below][6 + k] -= node[i].wrench.n[k];
            r->off[below][9 + k] -= node[i].wrench.m[k];
        }
        wf_rod_times(node[i].pose.q, back, turn);
        wf_rod_vector(turn, r->off[i] + 3);
    }
}

static bool integrate_pieces(struct wf_rod *r, const struct wf_rod_node *node)
{
    for (size_t i = 0; i < r->n; i++) {
        struct wf_rod_end *o = &r->end[i];
        if (!wf_rod_along(&r->integrator, &r->piece[i], &node[i].pose, &node[i].wrench, &o->pose, &o->wrench,
                          o->tally)) {
            if (r->integrator.fault) r->fault = r->integrator.fault;
            return false;
        }
    }
    set_misfit(r, node);
    return true;
}

/* Newton's equations, eliminated along the tree. */

/* C = A B, 6 x 6, with B a block of a 12 x 12 matrix */
static void multiply_block6(const double A[36], const double *B, double C[36])
{
    for (size_t i = 0; i < 6; i++)
        for (size_t j = 0; j < 6; j++) {
            double sum = 0;
            for (size_t k = 0; k < 6; k++) sum += A[6 * i + k] * B[12 * k + j];
            C[6 * i + j] = sum;
        }
}

static void lu_solve(const struct wf_rod_block *b, double x[6])
{
    size_t order[6];
    memcpy(order, b->order, sizeof order);
    gsl_matrix_const_view lu = gsl_matrix_const_view_array(b->lu, 6, 6);
    gsl_permutation rows = { 6, order };
    gsl_vector_view v = gsl_vector_view_array(x, 6);
    gsl_linalg_LU_svx(&lu.matrix, &rows, &v.vector);
}

static bool lu_factor(struct wf_rod_block *b)
{
    gsl_matrix_view lu = gsl_matrix_view_array(b->lu, 6, 6);
    gsl_permutation rows = { 6, b->order };
    int sign;
    gsl_permutation_init(&rows);
    if (gsl_linalg_LU_decomp(&lu.matrix, &rows, &sign)) return false;
    for (size_t k = 0; k < 6; k++)
        if (!(fabs(b->lu[7 * k]) > 0)) return false;
    return true;
}

/* Root plate: springs c resist the tilt v, c v = T' m (0 = clamped). Returned: b->root; T, tangent of the
 * rotation vector. */
static void root_factor(const struct wf_rod *r, const double v[3], struct wf_rod_block *b, double T[9])
{
    const double *c = r->options->root_stiffness;
    double x = wf_dot(v, v), K[9], KT[9], TKT[9], Tt[9];
    struct rotation o = rotation_of(x);
    rotation_tangent(&o, v, x, T);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) K[3 * i + j] = b->K[6 * (3 + i) + 3 + j], Tt[3 * i + j] = T[3 * j + i];
    m3_mul(K, T, KT);
    m3_mul(Tt, KT, TKT);
    double a = c[0] - TKT[0], d = c[1] - TKT[4], det = a * d - TKT[1] * TKT[3];
    memset(b->root, 0, sizeof b->root);
    if (c[0] > 0 && c[1] > 0)
        b->root[0] = d / det, b->root[1] = TKT[1] / det, b->root[3] = TKT[3] / det, b->root[4] = a / det;
    else if (c[0] > 0)
        b->root[0] = 1 / a;
    else if (c[1] > 0)
        b->root[4] = 1 / d;
}

/* Eliminate from the tips down. K of a piece first sums the reaction at its end, then becomes the reaction
 * of its base: (D - K B) dw = (K A - C) dp. */
static bool factor_tree(struct wf_rod *r)
{
    for (size_t i = 0; i < r->n; i++) {
        struct wf_rod_block *b = &r->block[i];
        if (!wf_rod_vary(&r->integrator, &r->piece[i], &r->node[i].pose, &r->node[i].wrench, b->J))
            return false;
        memset(b->K, 0, sizeof b->K);
    }
    for (size_t i = r->n; i-- > 0;) {
        struct wf_rod_block *b = &r->block[i];
        struct wf_rod_wrench unused = { { 0 }, { 0 } };
        double KA[36], KB[36], column[6];
        rod_end_load(r, i, r->end[i].pose.q, &unused, b->K);
        multiply_block6(b->K, b->J, KA);
        multiply_block6(b->K, b->J + 6, KB);
        for (size_t j = 0; j < 6; j++)
            for (size_t k = 0; k < 6; k++) b->lu[6 * j + k] = b->J[12 * (6 + j) + 6 + k] - KB[6 * j + k];
        if (!lu_factor(b)) return false;
        for (size_t k = 0; k < 6; k++) {
            for (size_t j = 0; j < 6; j++) column[j] = KA[6 * j + k] - b->J[12 * (6 + j) + k];
            lu_solve(b, column);
            for (size_t j = 0; j < 6; j++) b->K[6 * j + k] = column[j];
        }
        int32_t below = r->piece[i].parent;
        for (size_t k = 0; below >= 0 && k < 36; k++) r->block[below].K[k] += b->K[k];
    }
    return true;
}

static void apply_block6(const double *A, size_t wide, const double x[6], double y[6])
{
    for (size_t i = 0; i < 6; i++)
        for (size_t k = 0; k < 6; k++) y[i] += A[wide * i + k] * x[k];
}

/* Newton step of a root's pose (0, spin) and of its tilt. */
static void root_step(const struct wf_rod *r, const struct wf_rod_node *node, struct wf_rod_block *b,
                      const double k[6], double pose[6], double tilt[3])
{
    const double *c = r->options->root_stiffness;
    double T[9], sum[3], push[3];
    memset(pose, 0, 6 * sizeof *pose);
    memset(tilt, 0, 3 * sizeof *tilt);
    if (!(c[0] > 0) && !(c[1] > 0)) return;
    root_factor(r, node->tilt, b, T);
    for (int j = 0; j < 3; j++) sum[j] = node->wrench.m[j] + k[3 + j];
    m3_apply_transposed(T, sum, push);
    for (int j = 0; j < 2; j++) push[j] -= c[j] * node->tilt[j];
    push[2] = 0;
    m3_apply(b->root, push, tilt);
    m3_apply(T, tilt, pose + 3);
}

/* Newton step for the present residual with the present factors: constants from the tips down, changes from
 * the root up. */
static void solve_changes(struct wf_rod *r, const struct wf_rod_node *node, double (*step)[12],
                          double (*tilt)[3])
{
    for (size_t i = 0; i < r->n; i++)
        for (int k = 0; k < 6; k++) step[i][6 + k] = -r->off[i][6 + k];
    for (size_t i = r->n; i-- > 0;) {
        double *k = step[i] + 6, against[6], lift[6] = { 0 };
        int32_t below = r->piece[i].parent;
        lu_solve(&r->block[i], k);
        if (below < 0) continue;
        for (int j = 0; j < 6; j++) against[j] = -r->off[i][j];
        apply_block6(r->block[i].K, 6, against, lift);
        for (int j = 0; j < 6; j++) step[below][6 + j] += k[j] + lift[j];
    }
    for (size_t i = 0; i < r->n; i++) {
        int32_t below = r->piece[i].parent;
        double *p = step[i];
        if (below < 0)
            root_step(r, &node[i], &r->block[i], p + 6, p, tilt[i]);
        else
            for (int j = 0; j < 6; j++) p[j] = r->change[below][j] - r->off[i][j];
        apply_block6(r->block[i].K, 6, p, p + 6);
        memset(r->change[i], 0, sizeof r->change[i]);
        apply_block6(r->block[i].J, 12, p, r->change[i]);
        apply_block6(r->block[i].J + 6, 12, p + 6, r->change[i]);
    }
}

static void move_nodes(const struct wf_rod *r, double share, const double (*step)[12],
                       const double (*tilt)[3], struct wf_rod_node *to)
{
    for (size_t i = 0; i < r->n; i++) {
        const double *p = step[i];
        double v[3], q[4];
        to[i] = r->node[i];
        for (int k = 0; k < 3; k++) {
            to[i].pose.r[k] += share * p[k];
            to[i].wrench.n[k] += share * p[6 + k];
            to[i].wrench.m[k] += share * p[9 + k];
            v[k] = share * p[3 + k];
        }
        wf_rod_quaternion(v, q);
        wf_rod_times(q, r->node[i].pose.q, to[i].pose.q);
        if (r->piece[i].parent >= 0) continue;
        for (int k = 0; k < 3; k++) to[i].tilt[k] += share * tilt[i][k];
        wf_rod_quaternion(to[i].tilt, to[i].pose.q);
    }
}

static double vector_length(const double v[3]) { return sqrt(wf_dot(v, v)); }

/* Size of a step: the largest of positions by the tree's size, rotations, and forces and moments as rotation
 * along a piece. */
static double change_size(const struct wf_rod *r, const double (*step)[12], double *turn)
{
    double most = 0;
    *turn = 0;
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_piece *p = &r->piece[i];
        *turn = fmax(*turn, vector_length(step[i] + 3));
        double force = vector_length(step[i] + 6) * p->h * p->h / p->stiffness;
        double moment = vector_length(step[i] + 9) * p->h / p->stiffness;
        most = fmax(fmax(most, vector_length(step[i]) / r->size), fmax(force, moment));
    }
    return fmax(most, *turn);
}

/* Size of the solution relative to the unloaded tree, by the same measure: the scale of the relative
 * accuracy. */
static double answer_size(const struct wf_rod *r)
{
    double most = 0;
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_piece *p = &r->piece[i];
        double moment = vector_length(r->node[i].wrench.m) * p->h / p->stiffness, turn[3];
        double force = vector_length(r->node[i].wrench.n) * p->h * p->h / p->stiffness;
        wf_rod_vector(r->node[i].pose.q, turn);
        most = fmax(fmax(most, force), fmax(moment, vector_length(turn)));
    }
    return fmin(most, 1);
}

static void swap_nodes(struct wf_rod *r)
{
    struct wf_rod_node *node = r->node;
    r->node = r->trial;
    r->trial = node;
}

/* Newton. */

/* Choose the integration steps of all pieces anew at the present nodes, to an accuracy, and keep them from
 * here on. Returned: size of the next Newton step with the present derivative; NAN when the integration
 * fails. */
static double fix_steps(struct wf_rod *r, double accuracy)
{
    double turn;
    r->integrator.fixed = false;
    wf_rod_accuracy(&r->integrator, accuracy);
    if (!integrate_pieces(r, r->node)) return NAN;
    r->integrator.fixed = true;
    solve_changes(r, r->node, r->step, r->tilt);
    return change_size(r, (const double(*)[12])r->step, &turn);
}

/* Newton's method at the present loads from the present nodes. Returned: true with ends that belong to the
 * nodes; false when it stalled, with the nodes reached. */
static bool rod_newton(struct wf_rod *r)
{
    const double tolerance = r->options->tolerance, rounding = 1e-14, near = 1e-3;
    const double serves = fmax(0.1 * r->options->mesh_tolerance, tolerance);
    double turn, size, share = 1;
    bool fresh = false;
    r->integrator.fixed = false;
    wf_rod_accuracy(&r->integrator, tolerance);
    if (!integrate_pieces(r, r->node)) return false;
    for (size_t round = 0; round < r->options->iterations_max; round++) {
        r->iterations++;
        if (!fresh) {
            if (!factor_tree(r)) return false;
            solve_changes(r, r->node, r->step, r->tilt);
            share = 1;
        }
        size = change_size(r, (const double(*)[12])r->step, &turn);
        double scale = fmax(answer_size(r), 1e-12), next = INFINITY;
        if (!r->integrator.fixed && size < near * scale) size = fix_steps(r, 0.01 * tolerance * scale);
        if (!isfinite(size)) return false;
        share = fmin(share, turn > 1 ? 1 / turn : 1);
        if (!r->integrator.fixed)
            wf_rod_accuracy(&r->integrator, 0.01 * tolerance * fmin(1, fmax(scale, size)));
        for (;; share *= 0.5) {
            if (share < 1e-3) return false;
            move_nodes(r, share, (const double(*)[12])r->step, (const double(*)[3])r->tilt, r->trial);
            if (!integrate_pieces(r, r->trial)) continue;
            solve_changes(r, r->trial, r->next, r->next_tilt);
            next = change_size(r, (const double(*)[12])r->next, &turn);
            if (next <= (1 - 0.25 * share) * size || next <= tolerance * scale + rounding) break;
        }
        swap_nodes(r);
        if (share >= 1 && fmin(size, next) <= tolerance * scale + rounding) {
            /* converged if steps chosen anew at the solution give the same */
            size = fix_steps(r, 0.01 * tolerance * scale);
            if (size <= serves * scale + rounding) return true;
            if (!isfinite(size)) return false;
            fresh = true;
            continue;
        }
        /* reuse the derivative while it gains a digit per step */
        fresh = share >= 1 && next < 0.1 * size;
        share = fmin(1, 2 * share);
        if (fresh) {
            double(*step)[12] = r->step, (*tilt)[3] = r->tilt;
            r->step = r->next, r->next = step, r->tilt = r->next_tilt, r->next_tilt = tilt;
        }
    }
    return false;
}

/* Setting up. */

/* Unloaded pose, zero forces. */
static void rod_rest(struct wf_rod *r)
{
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_piece *p = &r->piece[i];
        double axis[3];
        r->node[i] = (struct wf_rod_node){ .pose.q = { 1, 0, 0, 0 } };
        wf_row_axis(r->tree, (size_t)p->row, p->s0, r->node[i].pose.r, axis);
    }
}

static void sort_points(struct wf_rod *r)
{
    for (size_t i = 0; i < r->tree->n; i++) r->first_point[i] = -1;
    for (size_t k = r->loads.points; k-- > 0;) {
        int32_t row = r->loads.point[k].segment;
        r->next_point[k] = r->first_point[row];
        r->first_point[row] = (int32_t)k;
    }
}

/* Cut the tree into pieces and start from its unloaded shape. `r` must not move. rod_done frees what is
 * not in the arena. Errors: WF_EUSAGE (point load on a row that does not exist), WF_ENOMEM. */
static enum wf_status rod_init(struct wf_rod *r, const struct wf_tree *t, const struct wf_loads *l,
                               const struct wf_solve_options *o, bool printed, struct wf_arena *a,
                               struct wf_err *e)
{
    *r = (struct wf_rod){ .tree = t, .loads = *l, .options = o };
    for (size_t k = 0; k < l->points; k++)
        if (l->point[k].segment < 0 || (size_t)l->point[k].segment >= t->n)
            return wf_fail(e, WF_EUSAGE, "point load %zu: no segment %d (there are %zu)", k,
                           (int)l->point[k].segment, t->n);
    /* as printed a row is one segment; otherwise trees of few rows are cut as in the beam solver */
    r->piece = wf_rod_cut(t, l, printed || t->n >= 24 ? 1 : (int32_t)(23 / t->n + 1), a, &r->n);
    r->first_point = WF_TAKE(a, t->n, int32_t);
    r->next_point = WF_TAKE(a, l->points, int32_t);
    r->node = WF_TAKE(a, r->n, struct wf_rod_node);
    r->trial = WF_TAKE(a, r->n, struct wf_rod_node);
    r->end = WF_TAKE(a, r->n, struct wf_rod_end);
    r->block = WF_TAKE(a, r->n, struct wf_rod_block);
    r->off = wf_arena_take(a, r->n, sizeof *r->off);
    r->step = wf_arena_take(a, r->n, sizeof *r->step);
    r->next = wf_arena_take(a, r->n, sizeof *r->next);
    r->tilt = wf_arena_take(a, r->n, sizeof *r->tilt);
    r->next_tilt = wf_arena_take(a, r->n, sizeof *r->next_tilt);
    r->change = wf_arena_take(a, r->n, sizeof *r->change);
    if (!r->piece || !r->first_point || !r->next_point || !r->node || !r->trial || !r->end || !r->block ||
        !r->off || !r->step || !r->next || !r->tilt || !r->next_tilt || !r->change)
        return wf_fail(e, WF_ENOMEM, "not enough memory for rods of %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++)
        r->size = fmax(r->size, hypot(t->x1[i] - t->x0[0], hypot(t->y1[i] - t->y0[0], t->z1[i] - t->z0[0])));
    sort_points(r);
    rod_rest(r);
    return wf_rod_open(&r->integrator, t, &r->loads, printed, a, e);
}

static void rod_done(struct wf_rod *r) { wf_rod_close(&r->integrator); }

/* A beam on the same pieces, one element per piece. */
static enum wf_status beam_of_rod(const struct wf_rod *r, const struct wf_solve_options *o,
                                  struct wf_arena *a, struct wf_beam *b, struct wf_err *e)
{
    int32_t *cut = WF_TAKE(a, r->tree->n, int32_t);
    if (!cut) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", r->tree->n);
    for (size_t i = 0; i < r->n; i++) cut[r->piece[i].row]++;
    return wf_beam_init(b, r->tree, &r->loads, o, cut, a, a, e);
}

/* Set the beam to the shape of the rod: along each piece the quadratic of rotation that matches its
 * curvature at the base and its end. */
static void pose_beam(const struct wf_rod *r, struct wf_beam *b)
{
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_piece *p = &r->piece[i];
        const double *q = r->node[i].pose.q, back[4] = { q[0], -q[1], -q[2], -q[3] };
        struct wf_rod_section c;
        double turn[4], v[3], t[3], axis[3], place[3], k[3], base[3];
        wf_rod_times(back, r->end[i].pose.q, turn);
        wf_rod_vector(turn, v);
        wf_row_axis(r->tree, (size_t)p->row, p->s0, place, axis);
        wf_rod_turn(q, axis, t);
        wf_rod_section_at(r->tree, &r->loads, (size_t)p->row, p->s0, &c);
        v3_section(p->h / c.ei, p->h / c.gj, t, r->node[i].wrench.m, k);
        wf_rod_turn(back, k, base);
        for (int j = 0; j < 2; j++)
            for (int x = 0; x < 3; x++)
                b->shape[i].v[j][x] = gauss_place[j] * (base[x] + gauss_place[j] * (v[x] - base[x]));
        if (p->parent < 0) memcpy(b->tilt[p->row], r->node[i].tilt, sizeof b->tilt[p->row]);
    }
    wf_beam_sweep_up(b);
}

/* Largest rotation between two states [rad]. Where it is large, Newton may have converged to another branch
 * of solutions. */
static double largest_turn_since(const struct wf_rod *r, const struct wf_rod_node *from)
{
    double most = 0;
    for (size_t i = 0; i < r->n; i++) {
        const double *q = from[i].pose.q, back[4] = { q[0], -q[1], -q[2], -q[3] };
        double turn[4], v[3];
        wf_rod_times(r->node[i].pose.q, back, turn);
        wf_rod_vector(turn, v);
        most = fmax(most, sqrt(wf_dot(v, v)));
    }
    return most;
}

/* Newton from the present nodes. The result is accepted when no part has rotated by more than 40 degrees and
 * the beam solver finds it stable. */
static bool close_from_nodes(struct wf_rod *r, struct wf_beam *b, struct wf_rod_node *kept)
{
    memcpy(kept, r->node, r->n * sizeof *kept);
    r->fault = NULL;
    if (!rod_newton(r) || largest_turn_since(r, kept) > 0.7) return false;
    pose_beam(r, b);
    r->steps++;
    return wf_beam_stable(b);
}

/* Set the nodes from the beam's equilibrium. */
static void start_from_beam(struct wf_rod *r, const struct wf_beam *b)
{
    for (size_t i = 0; i < r->n; i++) {
        struct wf_beam_pose ground;
        const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
        struct wf_beam_wrench at[2], root;
        struct wf_line_load load[2];
        double v[3];
        wf_beam_load(&b->mesh.part[i], &b->loads, &b->stage[i], load);
        wf_beam_balance(b->mesh.part[i].h, &b->stage[i], NULL, load, &b->wrench[i], at, &root);
        rotation_vector(base->L, v);
        wf_rod_quaternion(v, r->node[i].pose.q);
        memcpy(r->node[i].pose.r, base->r, sizeof base->r);
        memcpy(r->node[i].wrench.n, root.n, sizeof root.n);
        memcpy(r->node[i].wrench.m, root.m, sizeof root.m);
        memcpy(r->node[i].tilt, b->tilt[r->piece[i].row], sizeof r->node[i].tilt);
    }
}

/* Equilibrium: Newton from the unloaded shape; if that fails, from the equilibrium of the beam solver, which
 * uses load steps and, beyond a limit point, creep. */
static enum wf_status rod_settle(struct wf_rod *r, const struct wf_solve_options *o, struct wf_arena *a,
                                 double *load_factor, struct wf_diag *d, struct wf_err *e)
{
    struct wf_beam b;
    struct wf_beam_outcome out = { .load_factor = 1 };
    struct wf_err why = { 0 };
    struct wf_rod_node *kept = WF_TAKE(a, r->n, struct wf_rod_node);
    struct wf_solve_options equal = *o;
    equal.mesh_tolerance = 0; /* the pieces of a row are as long as those of the rod */
    enum wf_status status =
        kept ? beam_of_rod(r, &equal, a, &b, e) : wf_fail(e, WF_ENOMEM, "not enough memory for rods");
    if (status) return status;
    if (!close_from_nodes(r, &b, kept)) {
        if ((status = wf_beam_settle(&b, a, &out, &why))) {
            *load_factor = out.load_factor;
            return wf_fail(e, status, "%s", why.text);
        }
        start_from_beam(r, &b);
        if (!close_from_nodes(r, &b, kept))
            return wf_fail(e, WF_ENOCONV, "%s",
                           r->fault ? r->fault
                           : r->integrator.printed
                               ? "the printed equations did not converge; use shorter segments"
                               : "the integration from root to tips did not converge");
    }
    *load_factor = 1;
    wf_beam_warn(&b, &out, d);
    return WF_OK;
}

struct rod_tally {
    double force[3], moment[3];
};

static void tally_rod_load(struct rod_tally *sum, const double arm[3], const double force[3],
                           const double moment[3])
{
    double lever[3];
    wf_cross(arm, force, lever);
    v3_add(sum->force, 1, force);
    v3_add(sum->moment, 1, moment);
    v3_add(sum->moment, 1, lever);
}

/* Columns of the response. Loads and their moments are summed apart from the integration, to check it. */
static void rod_read(const struct wf_rod *r, struct wf_response *out)
{
    const struct wf_tree *t = r->tree;
    const double first[3] = { t->x0[0], t->y0[0], t->z0[0] };
    struct rod_tally sum = { { 0 }, { 0 } };
    for (size_t i = 0; i < r->n; i++) {
        const struct wf_rod_piece *p = &r->piece[i];
        const struct wf_rod_node *base = &r->node[i];
        const struct wf_rod_end *end = &r->end[i];
        size_t row = 3 * (size_t)p->row;
        double arm[3], place[3], axis[3], load[3];
        for (int k = 0; k < 3; k++) {
            arm[k] = base->pose.r[k] - first[k];
            load[k] = base->wrench.n[k] - end->wrench.n[k];
        }
        v3_add(out->load + row, 1, load);
        tally_rod_load(&sum, arm, load, end->tally);
        if (p->s0 <= 0) {
            memcpy(out->force0 + row, base->wrench.n, sizeof base->wrench.n);
            memcpy(out->moment0 + row, base->wrench.m, sizeof base->wrench.m);
            wf_row_axis(t, (size_t)p->row, 0, place, axis);
            wf_rod_turn(base->pose.q, axis, out->tangent0 + row);
        }
        if (p->parent < 0) {
            double lever[3];
            wf_cross(arm, base->wrench.n, lever);
            v3_add(out->base_force, 1, base->wrench.n);
            v3_add(out->base_moment, 1, base->wrench.m);
            v3_add(out->base_moment, 1, lever);
        }
        if (!p->last) continue;
        const double tip[3] = { t->x1[p->row], t->y1[p->row], t->z1[p->row] };
        struct wf_rod_wrench outside = { { 0 }, { 0 } };
        rod_end_load(r, i, end->pose.q, &outside, NULL);
        for (int k = 0; k < 3; k++) arm[k] = end->pose.r[k] - first[k];
        tally_rod_load(&sum, arm, outside.n, outside.m);
        memcpy(out->force1 + row, end->wrench.n, sizeof end->wrench.n);
        memcpy(out->moment1 + row, end->wrench.m, sizeof end->wrench.m);
        wf_row_axis(t, (size_t)p->row, 1, place, axis);
        wf_rod_turn(end->pose.q, axis, out->tangent1 + row);
        wf_rod_vector(end->pose.q, out->turn + row);
        for (size_t k = 0; k < 3; k++) out->end[row + k] = end->pose.r[k] - tip[k];
    }
    double off[2] = { 0 }, whole[2] = { 0 };
    for (int k = 0; k < 3; k++) {
        off[0] = hypot(off[0], out->base_force[k] - sum.force[k]);
        off[1] = hypot(off[1], out->base_moment[k] - sum.moment[k]);
        whole[0] = hypot(whole[0], sum.force[k]), whole[1] = hypot(whole[1], sum.moment[k]);
    }
    for (int k = 0; k < 2; k++)
        if (whole[k] > 0) out->imbalance = fmax(out->imbalance, off[k] / whole[k]);
}

static enum wf_status rod_solve(bool printed, const struct wf_tree *t, const struct wf_loads *l,
                                const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *out,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_rod r = { 0 };
    struct wf_solve_options rigid = *o;
    rigid.inextensible = true;
    enum wf_status status = wf_response_alloc(out, t->n, a, e);
    if (!status) status = wf_solve_check_round(t, "the rod solver", e);
    if (status || (status = wf_tree_check(t, d, e))) return status;
    if (printed && t->bend && d)
        wf_diag_warn(d, "straight-rows",
                     "the printed rod treats curved segments as straight between their ends");
    wf_quiet_begin();
    status = rod_init(&r, t, l, &rigid, printed, &work, e);
    if (!status) status = rod_settle(&r, &rigid, &work, &out->load_factor, d, e);
    if (!status) rod_read(&r, out);
    out->iterations = r.iterations, out->steps = r.steps;
    rod_done(&r);
    wf_quiet_end();
    wf_arena_free(&work);
    return status;
}

static enum wf_status rod_solve_frame(const struct wf_tree *t, const struct wf_loads *l,
                                      const struct wf_solve_options *o, struct wf_arena *a,
                                      struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return rod_solve(false, t, l, o, a, r, d, e);
}

static enum wf_status rod_solve_angles(const struct wf_tree *t, const struct wf_loads *l,
                                       const struct wf_solve_options *o, struct wf_arena *a,
                                       struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return rod_solve(true, t, l, o, a, r, d, e);
}

#define FENG                                                                                                 \
    "Feng J., Yan T., Chen Y., Wu E. 1999. Research on whole tree's movement and tree's inner wind field, "  \
    "J. Software, eqs 1-5"

const struct wf_solver wf_solver_rod = {
    .name = "rod",
    .title = "inextensible rods integrated from root to tips, free tips found by multiple shooting",
    .source = FENG "; frame by quaternion; Deuflhard 2004, Newton Methods for Nonlinear Problems, sec. 3.3",
    .validity = "Elastic wood that does not stretch, static mean wind; any deflection. Loads follow the bent "
                "shape.",
    .solve = rod_solve_frame,
};
const struct wf_solver wf_solver_rod_as_printed = {
    .name = "rod-as-printed",
    .title = "inextensible rods in three angles a segment as printed by Feng et al. 1999",
    .source = FENG,
    .validity =
        "reproduces the printed equations: products of first derivatives are left out, so the answer "
        "depends on the number of segments and agrees with 'rod' as they are refined; no answer where "
        "a segment turns by 90 degrees",
    .as_printed = true,
    .solve = rod_solve_angles,
};
