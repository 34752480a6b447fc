#include "solve/beam.h"
#include "solve/beam_refine.h"
#include "solve/beam_response.h"
#include "solve/vec.h"

static double largest_displacement(const struct wf_beam *b)
{
    const struct wf_tree *t = b->mesh.tree;
    double most = 0;
    for (size_t i = 0; i < t->n; i++) {
        const double *r = b->pose[b->mesh.last[i]].r;
        double d[3] = { r[0] - t->x1[i], r[1] - t->y1[i], r[2] - t->z1[i] };
        most = fmax(most, wf_dot(d, d));
    }
    return sqrt(most);
}

/* Farthest end from the first base [m]. */
static double size(const struct wf_tree *t)
{
    double most = 0;
    for (size_t i = 0; i < t->n; i++) {
        double d[3] = { t->x1[i] - t->x0[0], t->y1[i] - t->y0[0], t->z1[i] - t->z0[0] };
        most = fmax(most, wf_dot(d, d));
    }
    return sqrt(most);
}

/* Longest chain of rows from the ground: among so many the allowed error is shared. */
static double deepest(const struct wf_tree *t, double *depth)
{
    double most = 1;
    for (size_t i = 0; i < t->n; i++) {
        depth[i] = 1 + (t->parent[i] >= 0 ? depth[t->parent[i]] : 0);
        most = fmax(most, depth[i]);
    }
    return most;
}

/* Distributed load on each row as the mesh sums it, 3n [N]. */
static void row_loads(const struct wf_beam *b, double *load)
{
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        double sum[3] = { 0, 0, 0 };
        for (int32_t k = b->mesh.first[i]; k <= b->mesh.last[i]; k++) {
            struct wf_line_load q[2];
            wf_beam_load(&b->mesh.part[k], &b->loads, &b->stage[k], q);
            for (int j = 0; j < 2; j++) v3_add(sum, 0.5 * b->mesh.part[k].h, q[j].force);
        }
        memcpy(load + 3 * i, sum, sizeof sum);
    }
}

/* Error of each row's load as a share of the reaction, taken to fall with the power 1.3 of the piece length:
 * wind near the ground grows with a low power of height, and a load with a corner inside a row converges no
 * faster. */
static double load_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *before,
                         const double *now, double *share)
{
    double force = sqrt(wf_dot(fine->base.n, fine->base.n)), sum = 0;
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        double kc = coarse->mesh.last[i] - coarse->mesh.first[i] + 1,
               kf = fine->mesh.last[i] - fine->mesh.first[i] + 1, d[3];
        for (size_t k = 0; k < 3; k++) d[k] = now[3 * i + k] - before[3 * i + k];
        share[i] = kf > kc && force > 0 ? sqrt(wf_dot(d, d)) / force / (pow(kf / kc, 1.3) - 1) : 0;
        sum += share[i];
    }
    return sum;
}

/* Pieces that bring each row's share of the error to its part of the target; never fewer than there are, so
 * that the shape carried over is one Newton goes on from. While the load is `off` times as far out as
 * allowed, also more for the rows that make most of that. */
static void choose(const struct wf_beam *b, const double *share, double target, const double *bear,
                   double off, int32_t *pieces)
{
    double most = 0, more = off > 1 ? fmax(pow(1.5 * off, 0.77), 2) : 1;
    for (size_t i = 0; i < b->mesh.tree->n; i++) most = fmax(most, bear[i]);
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        int32_t now = b->mesh.last[i] - b->mesh.first[i] + 1;
        double want = pow(share[i] / target, 0.25);
        if (bear[i] > 0.1 * most) want = fmax(want, more);
        pieces[i] = (int32_t)fmin(fmax(ceil(now * want), now), 64.0 * now);
    }
}

enum wf_status wf_beam_solve(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, struct wf_arena *work, struct wf_beam *b,
                             struct wf_beam_outcome *out, struct wf_err *e)
{
    enum { MESHES = 6 };
    const double safety = 0.25;
    const double rounding =
        1e-12; /* of the size: what places are good to, so a tree that does not move ends too */
    int32_t *pieces = WF_TAKE(work, t->n, int32_t);
    double *reach = WF_TAKE(work, t->n, double), *share = WF_TAKE(work, t->n, double);
    double *before = WF_TAKE(work, 3 * t->n, double), *load = WF_TAKE(work, 3 * t->n, double),
           *bear = WF_TAKE(work, t->n, double);
    if (!pieces || !reach || !share || !before || !load || !bear)
        return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;

    enum wf_status status = wf_beam_init(b, t, l, o, pieces, work, e);
    if (!status) status = wf_beam_settle(b, work, out, e);
    if (status || !(o->mesh_tolerance > 0)) return status;

    double depth = deepest(t, share);
    row_loads(b, before);
    wf_tree_reach(t, reach);
    for (size_t i = 0; i < t->n; i++) pieces[i] = 2 * start;
    for (int mesh = 1; mesh < MESHES; mesh++) {
        struct wf_beam fine;
        struct wf_beam_outcome again;
        status = wf_beam_init(&fine, t, l, o, pieces, work, e);
        if (status) return status;
        wf_beam_carry(b, &fine);
        status = wf_beam_settle(&fine, work, &again, e);
        if (status || again.beyond_limit) *out = again;
        if (status) return status;
        fine.iterations += b->iterations, fine.steps += b->steps;
        double allowed = o->mesh_tolerance * safety;
        double target = fmax(allowed * largest_displacement(&fine), rounding * size(t));
        double error = wf_beam_mesh_error(b, &fine, reach, share);
        row_loads(&fine, load);
        double reactions = load_error(b, &fine, before, load, bear);
        *b = fine;
        memcpy(before, load, 3 * t->n * sizeof *load);
        if (error <= target && reactions <= allowed) break;
        choose(b, share, target / depth, bear, reactions / allowed, pieces);
    }
    return WF_OK;
}

void wf_beam_warn(const struct wf_beam *b, const struct wf_beam_outcome *out, struct wf_diag *d)
{
    if (!d) return;
    if (b->loose > 0)
        wf_diag_warn(
            d, "loose-parts",
            "%zu small parts, each bearing less than 1 %% of the load, are balanced but not stable: they may "
            "snap to another shape",
            b->loose);
    if (out->beyond_limit)
        wf_diag_warn(d, "limit-point",
                     "the tree gives way at %.3g of the load; the answer is where it comes to rest",
                     out->load_factor);
}

static enum wf_status solve(const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    struct wf_beam_outcome out = { 0 };
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    if (status) return status;
    status = wf_solve_check(t, l, d, e);
    if (!status) status = wf_beam_solve(t, l, o, &work, &b, &out, e);
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
    .solve = solve,
};
