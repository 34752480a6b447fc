/* One linear step on the beam elements: loads and balance of the unbent tree, small displacements and
 * rotations. */
#include "solve/beam.h"
#include "solve/beam_response.h"
#include "solve/gauss.h"
#include "solve/vec.h"

/* Rotation of a root plate under a moment. */
static void plate_tilt(const struct wf_beam *b, const double moment[3], double q[3])
{
    for (int j = 0; j < 2; j++)
        if (b->options->root_stiffness[j] > 0) q[j] = moment[j] / b->options->root_stiffness[j];
}

/* Rotation q and displacement u of the unbent tree under its internal forces:
 * q' = G m,  u' = q x t + H n,  by the same collocation as the full element. */
static void displace(struct wf_beam *b, double (*u)[3], double (*q)[3])
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
            plate_tilt(b, base.m, q0);
        for (int j = 0; j < 2; j++) v3_section(1 / p->ei[j], 1 / p->gj[j], s->t[j], at[j].m, k[j]);
        for (int j = 0; j < 2; j++) {
            double turn[3], stretch[3];
            for (int c = 0; c < 3; c++)
                turn[c] = q0[c] + p->h * (gauss_up[j][0] * k[0][c] + gauss_up[j][1] * k[1][c]);
            wf_cross(turn, s->t[j], up[j]);
            v3_section(p->cs[j], p->ca[j], s->t[j], at[j].n, stretch);
            v3_add(up[j], 1, stretch);
        }
        for (int c = 0; c < 3; c++) {
            q[i][c] = q0[c] + 0.5 * p->h * (k[0][c] + k[1][c]);
            u[i][c] = u0[c] + 0.5 * p->h * (up[0][c] + up[1][c]);
        }
    }
}

struct answer {
    struct wf_beam beam;
    double (*u)[3], (*q)[3];
};

static enum wf_status answer_on(const struct wf_tree *t, const struct wf_loads *l,
                                const struct wf_solve_options *o, int32_t pieces_each, int32_t *pieces,
                                struct wf_arena *work, struct answer *x, struct wf_err *e)
{
    for (size_t i = 0; i < t->n; i++) pieces[i] = pieces_each;
    enum wf_status status = wf_beam_init(&x->beam, t, l, o, pieces, work, e);
    if (status) return status;
    x->u = wf_arena_take(work, x->beam.mesh.n, sizeof *x->u);
    x->q = wf_arena_take(work, x->beam.mesh.n, sizeof *x->q);
    if (!x->u || !x->q) return wf_fail(e, WF_ENOMEM, "no room for %zu displacements", x->beam.mesh.n);
    wf_beam_sweep_up(&x->beam);
    wf_beam_sweep_down(&x->beam, false, NULL);
    displace(&x->beam, x->u, x->q);
    return WF_OK;
}

/* Error of the finer of two meshes of ratio 2, relative to the largest displacement and rotation. */
static double error_of(const struct answer *coarse, const struct answer *fine)
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

static void read_linear(const struct answer *x, struct wf_response *r)
{
    const struct wf_beam *b = &x->beam;
    wf_beam_read(b, r);
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        int32_t last = b->mesh.last[i], below = b->mesh.part[b->mesh.first[i]].parent;
        double c[3], q0[3] = { 0, 0, 0 };
        if (below < 0) plate_tilt(b, r->moment0 + 3 * i, q0);
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

static enum wf_status solve(const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *d, struct wf_err *e)
{
    const int32_t most = 512;
    struct wf_arena work = { 0 };
    struct answer x, last;
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    int32_t *pieces = WF_TAKE(&work, t->n, int32_t), cut = 1;
    if (!status && !pieces) status = wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    if (!status) status = wf_solve_check_round(t, "the linear solver", e);
    if (!status) status = wf_solve_check(t, l, d, e);
    if (!status) status = answer_on(t, l, o, cut, pieces, &work, &x, e);
    while (!status && o->mesh_tolerance > 0 && cut < most) {
        last = x;
        status = answer_on(t, l, o, cut *= 2, pieces, &work, &x, e);
        if (!status && error_of(&last, &x) <= 0.25 * o->mesh_tolerance) break;
    }
    if (!status) read_linear(&x, r);
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
    .solve = solve,
};
