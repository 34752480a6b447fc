/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/rod_shoot.h"
#include "solve/beam_mesh.h"
#include <gsl/gsl_linalg.h>

/* Residual of the present nodes. */

void wf_rod_end_load(const struct wf_rod *r, size_t i, const double q[4], struct wf_rod_wrench *w,
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
        wf_rod_end_load(r, i, end->pose.q, &outside, NULL);
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
        wf_rod_end_load(r, i, r->end[i].pose.q, &unused, b->K);
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

bool wf_rod_newton(struct wf_rod *r)
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

enum wf_status wf_rod_init(struct wf_rod *r, const struct wf_tree *t, const struct wf_loads *l,
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
        return wf_fail(e, WF_ENOMEM, "no room for rods of %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++)
        r->size = fmax(r->size, hypot(t->x1[i] - t->x0[0], hypot(t->y1[i] - t->y0[0], t->z1[i] - t->z0[0])));
    sort_points(r);
    rod_rest(r);
    return wf_rod_open(&r->integrator, t, &r->loads, printed, a, e);
}

void wf_rod_done(struct wf_rod *r) { wf_rod_close(&r->integrator); }
