/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam.h"
#include "base/vec3.h"
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"
#include "solve/beam_mesh.h"
#include "solve/beam_newton.h"
#include <string.h>

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

void wf_beam_read_shape(const struct wf_beam_mesh *m, size_t i, const double base_L[9],
                        const struct wf_beam_pose *end, struct wf_response *r)
{
    const struct wf_tree *t = m->tree;
    double at[3], axis[3], tip[3];
    wf_beam_still_at(m, i, tip);
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

/* Memory of two meshes: of the newer, and of the shape of the one before, with which it is compared. */
struct two_meshes {
    struct wf_arena before, shape, newton;
};

/* Iterations of Newton's method from a neighbour, from which it converges soon or not at all; where what
 * follows is cheap. */
enum { FOLLOW_ITERATIONS = 32, SOON = 12 };

/* Newton's method from the shape of another solution, whatever its mesh, if it converges soon. a: NULL, or
 * for what follows where it does not: wf_beam_settle_parts, and steps of the wind's load from that on the
 * other. */
static bool rests_beside(struct wf_beam *b, const struct wf_beam *from, size_t iterations, struct wf_arena *a)
{
    const struct wf_solve_options *own = b->options;
    struct wf_solve_options soon = *own;
    soon.iterations_max = iterations;
    wf_beam_carry(from, b);
    b->options = &soon;
    bool rests = wf_beam_rests_soon(b, a);
    if (!rests && a && b->loads.wind) {
        wf_beam_carry(from, b);
        rests = wf_beam_approach(b, b->loads.wind->speed, from->loads.wind_scale, a);
    }
    b->options = own;
    return rests;
}

/* As wf_beam_settle; where Newton's method stalls, first from the shape of `near` (NULL: none). */
static enum wf_status settle_near(struct wf_beam *b, const struct wf_beam *near, struct wf_arena *newton,
                                  struct wf_beam_outcome *out, struct wf_err *e)
{
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (wf_beam_rests(b) || (near && rests_beside(b, near, FOLLOW_ITERATIONS, newton))) return WF_OK;
    return wf_beam_step_to_rest(b, newton, out, e);
}

/* The same, first from the shape of `soon` (NULL: none) if Newton's method converges soon there. */
static enum wf_status settle_soon(struct wf_beam *b, const struct wf_beam *soon, const struct wf_beam *near,
                                  struct wf_arena *newton, struct wf_beam_outcome *out, struct wf_err *e)
{
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (soon && rests_beside(b, soon, SOON, NULL)) return WF_OK;
    if (soon) wf_beam_unbend(b);
    return settle_near(b, near ? near : soon, newton, out, e);
}

/* Pieces of the mesh that is begun with: half as many as that of `from`, or as many; at least those of the
 * first mesh. */
static void begin_pieces(const struct wf_tree *t, const struct wf_solve_options *o,
                         const struct wf_beam *from, bool half, int32_t *pieces)
{
    wf_beam_first_pieces(t, o, pieces);
    for (size_t i = 0; i < t->n && from; i++) {
        int32_t now = wf_beam_pieces(&from->mesh, i), some = half ? (now + 1) / 2 : now;
        if (some > pieces[i]) pieces[i] = some;
    }
}

/* The first of the meshes, and its solution: half as fine as that of `from`, from whose shape Newton's method
 * converges there soon or not at all, else the same; without it the first mesh. */
static enum wf_status solve_first(const struct wf_tree *t, const struct wf_loads *l,
                                  const struct wf_solve_options *o, const struct wf_beam_known *known,
                                  struct two_meshes *m, int32_t *pieces, struct wf_beam *b,
                                  struct wf_beam_outcome *out, struct wf_err *e)
{
    const struct wf_beam *const from = known->from, *const near = known->near;
    begin_pieces(t, o, from, true, pieces);
    enum wf_status s = wf_beam_init(b, t, l, o, pieces, &m->shape, &m->newton, e);
    if (s || !from) return s ? s : settle_soon(b, known->soon, near, &m->newton, out, e);
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (rests_beside(b, from, SOON, NULL)) return WF_OK;
    wf_arena_free(&m->shape), wf_arena_free(&m->newton);
    begin_pieces(t, o, from, false, pieces);
    s = wf_beam_init(b, t, l, o, pieces, &m->shape, &m->newton, e);
    if (s) return s;
    wf_beam_carry(from, b);
    return settle_near(b, near, &m->newton, out, e);
}

/* At least as many pieces a row as a mesh has, unless that takes more than `most` times the elements: from a
 * mesh much coarser Newton's method starts too far away. Returned: did a row get more? */
static bool join_pieces(const struct wf_beam_mesh *good, double most, int32_t *pieces)
{
    double now = 0, joined = 0;
    for (size_t i = 0; i < good->tree->n; i++)
        now += pieces[i], joined += fmax(pieces[i], wf_beam_pieces(good, i));
    for (size_t i = 0; i < good->tree->n && joined <= most * now; i++)
        pieces[i] = (int32_t)fmax(pieces[i], wf_beam_pieces(good, i));
    return joined > now && joined <= most * now;
}

/* The solution whose shape is tried where Newton's method stalls on a further mesh; NULL: there is none. */
static const struct wf_beam *near_of(const struct wf_beam_known *known)
{
    return known->near ? known->near : known->soon;
}

/* A solution on a finer mesh, from that of b on the coarser one. Returned: also the loads of the check on it.
 */
static enum wf_status solve_finer(const struct wf_beam *b, const int32_t *pieces,
                                  const struct wf_solve_options *o, const struct wf_beam_known *known,
                                  struct two_meshes *m, struct wf_beam_check *check, struct wf_beam *fine,
                                  struct wf_beam_outcome *out, struct wf_err *e)
{
    wf_arena_free(&m->newton);
    wf_arena_free(&m->before);
    m->before = m->shape;
    m->shape = (struct wf_arena){ 0 };
    enum wf_status s = wf_beam_init(fine, b->mesh.tree, &b->loads, o, pieces, &m->shape, &m->newton, e);
    if (s) return s;
    wf_beam_carry(b, fine);
    s = settle_near(fine, near_of(known), &m->newton, out, e);
    if (!s) wf_beam_row_loads(&fine->mesh, (const double(*)[2][3])fine->load, check->load);
    fine->iterations += b->iterations, fine->steps += b->steps;
    return s;
}

bool wf_beam_few_good(const struct wf_beam_few *few, const struct wf_loads *l, double tolerance)
{
    return few && few->pieces && wf_beam_good_by_far(&few->goods, l, tolerance);
}

/* Note the mesh of few more elements than the coarse one that is expected to be good. */
static enum wf_status keep_few(const struct wf_beam *coarse, const struct wf_beam *fine,
                               struct wf_beam_check *check, struct wf_beam_few *few, struct wf_err *e)
{
    const size_t n = coarse->mesh.tree->n;
    struct wf_beam_good expected;
    int32_t *pieces = few->pieces ? few->pieces : WF_TAKE(&few->memory, n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", n);
    const struct wf_beam_good first = wf_beam_check_first(coarse, fine, check, pieces);
    wf_beam_note_good(&few->first, &first);
    few->pieces = wf_beam_check_few(coarse, fine, check, pieces, &expected) ? pieces : NULL;
    few->goods = (struct wf_beam_goods){ 0 };
    wf_beam_note_good(&few->goods, &expected);
    return WF_OK;
}

/* The solution on a mesh of few more elements than the first, which is good. */
static enum wf_status solve_on_few(const struct wf_tree *t, const struct wf_loads *l,
                                   const struct wf_solve_options *o, const struct wf_beam_known *known,
                                   struct two_meshes *m, struct wf_beam *b, struct wf_beam_outcome *out,
                                   struct wf_err *e)
{
    enum wf_status s = wf_beam_init(b, t, l, o, known->few->pieces, &m->shape, &m->newton, e);
    b->mesh.goods = known->few->goods;
    const struct wf_beam *const soon = known->soon ? known->soon : known->near;
    return s ? s : settle_soon(b, soon, known->near, &m->newton, out, e);
}

/* The solution on a mesh that met the tolerance at other loads and is good by far at these, from the shape of
 * a near one, if Newton's method converges soon there. Returned: *done. */
static enum wf_status solve_on_good(const struct wf_tree *t, const struct wf_loads *l,
                                    const struct wf_solve_options *o, const struct wf_beam_known *known,
                                    struct two_meshes *m, int32_t *pieces, struct wf_beam *b,
                                    struct wf_beam_outcome *out, bool *done, struct wf_err *e)
{
    const struct wf_beam_mesh *good = known->good;
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    *done = false;
    if (known->from || !known->soon || !good || !(o->mesh_tolerance > 0) ||
        !wf_beam_good_by_far(&good->goods, l, o->mesh_tolerance))
        return WF_OK;
    for (size_t i = 0; i < t->n; i++) pieces[i] = wf_beam_pieces(good, i);
    enum wf_status s = wf_beam_init(b, t, l, o, pieces, &m->shape, &m->newton, e);
    b->mesh.goods = good->goods;
    *done = !s && rests_beside(b, known->soon, SOON, NULL);
    if (!*done) wf_arena_free(&m->shape), wf_arena_free(&m->newton);
    return s;
}

static enum wf_status solve_on_meshes(const struct wf_tree *t, const struct wf_loads *l,
                                      const struct wf_solve_options *o, const struct wf_beam_known *known,
                                      struct wf_arena *work, struct two_meshes *m, struct wf_beam *b,
                                      struct wf_beam_outcome *out, struct wf_err *e)
{
    enum { MESHES = 6 };
    const double slightly = 1.25;
    struct wf_beam_check check;
    int32_t *pieces = WF_TAKE(work, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    struct wf_beam_few *few = known->from ? NULL : known->few;
    if (wf_beam_few_good(few, l, o->mesh_tolerance)) return solve_on_few(t, l, o, known, m, b, out, e);
    bool done;
    enum wf_status status = solve_on_good(t, l, o, known, m, pieces, b, out, &done, e);
    if (status || done) return status;
    struct wf_solve_options compared = *o; /* this mesh's solution is not the answer */
    compared.tolerance = fmax(o->tolerance, 0.01 * o->mesh_tolerance);
    status = solve_first(t, l, &compared, known, m, pieces, b, out, e);
    b->options = o;
    if (status || !(o->mesh_tolerance > 0) || wf_beam_unmoved(b)) return status;

    status = wf_beam_check_make(t, work, &check, e);
    if (status) return status;
    wf_beam_row_loads(&b->mesh, (const double(*)[2][3])b->load, check.before);
    wf_beam_second_pieces(t, pieces);
    const bool joined = known->good && join_pieces(known->good, slightly, pieces);
    for (int mesh = 1; mesh < MESHES; mesh++) {
        struct wf_beam fine;
        struct wf_beam_outcome again;
        status = solve_finer(b, pieces, o, known, m, &check, &fine, &again, e);
        if (status || again.beyond_limit) *out = again;
        if (status) return status;
        bool met = wf_beam_check_meets(b, &fine, &check);
        if (mesh == 1 && few && !joined) status = keep_few(b, &fine, &check, few, e);
        if (!met) wf_beam_check_choose(&fine, &check, pieces);
        *b = fine;
        if (met || status) break;
    }
    const struct wf_beam_good found = wf_beam_check_fine(&check, l);
    wf_beam_note_good(&b->mesh.goods, &found);
    return status;
}

enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_beam_known *known,
                             struct wf_arena *work, struct wf_arena *newton, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e)
{
    static const struct wf_beam_known nothing;
    struct two_meshes m = { 0 };
    enum wf_status status = solve_on_meshes(t, l, o, known ? known : &nothing, work, &m, b, out, e);
    wf_arena_free(&m.before);
    wf_arena_join(work, &m.shape);
    wf_arena_join(newton, &m.newton);
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
    if (!status) status = wf_beam_solve(t, l, o, NULL, &work, &work, &b, &out, e);
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
        wf_lanes_kernel(WF_LANES_MOST)->loads(&b->loads, NULL, 2 * n, point, load, NULL);
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
