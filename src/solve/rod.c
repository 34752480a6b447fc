/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/rod.h"
#include "base/num.h"
#include "solve/beam.h"
#include "solve/beam_mesh.h"
#include "solve/rod_shoot.h"

/* A beam on the same pieces, one element per piece. */
static enum wf_status beam_of_rod(const struct wf_rod *r, const struct wf_solve_options *o,
                                  struct wf_arena *a, struct wf_beam *b, struct wf_err *e)
{
    int32_t *cut = WF_TAKE(a, r->tree->n, int32_t);
    if (!cut) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", r->tree->n);
    for (size_t i = 0; i < r->n; i++) cut[r->piece[i].row]++;
    return wf_beam_init(b, r->tree, &r->loads, o, cut, a, e);
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
    if (!wf_rod_newton(r) || largest_turn_since(r, kept) > 0.7) return false;
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
    enum wf_status status = kept ? beam_of_rod(r, o, a, &b, e) : wf_fail(e, WF_ENOMEM, "no room for rods");
    if (status) return status;
    if (!close_from_nodes(r, &b, kept)) {
        status = wf_beam_settle(&b, a, &out, &why);
        if (status) {
            *load_factor = out.load_factor;
            return wf_fail(e, status, "%s", why.text);
        }
        start_from_beam(r, &b);
        if (!close_from_nodes(r, &b, kept))
            return wf_fail(e, WF_ENOCONV, "%s",
                           r->fault                ? r->fault
                           : r->integrator.printed ? "the printed equations do not close from root to tips; "
                                                     "shorter segments bring them nearer to beam theory"
                                                   : "the integration from root to tips did not close");
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

/* Columns of the response. Loads and their moments are summed independently of the integration, to check
 * it. */
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
        wf_rod_end_load(r, i, end->pose.q, &outside, NULL);
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
                     "the printed rod takes curved segments as straight between their ends");
    wf_quiet_begin();
    status = wf_rod_init(&r, t, l, &rigid, printed, &work, e);
    if (!status) status = rod_settle(&r, &rigid, &work, &out->load_factor, d, e);
    if (!status) rod_read(&r, out);
    out->iterations = r.iterations, out->steps = r.steps;
    wf_rod_done(&r);
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
