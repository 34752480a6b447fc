/* One linear step on the beam elements: loads and balance of the unbent tree, small displacements and
 * rotations. */
#include "solve/beam.h"
#include "solve/beam_response.h"
#include "solve/gauss.h"
#include "solve/vec.h"

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
        if (p->parent >= 0)
            memcpy(q0, q[p->parent], sizeof q0), memcpy(u0, u[p->parent], sizeof u0);
        else
            for (int j = 0; j < 2; j++)
                if (b->options->root_stiffness[j] > 0) q0[j] = b->base.m[j] / b->options->root_stiffness[j];
        wf_beam_load(p, &b->loads, s, load);
        wf_beam_balance(p->h, s, load, &b->wrench[i], at, &base);
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

static enum wf_status solve(const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    double(*u)[3] = NULL, (*q)[3] = NULL;
    int32_t *pieces = WF_TAKE(&work, t->n, int32_t);
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    if (!status) status = wf_tree_check(t, d, e);
    for (size_t i = 0; !status && i < t->n; i++)
        pieces[i] = o->mesh_tolerance > 0 ? (int32_t)(63 / t->n + 2) : 1;
    if (!status) status = wf_beam_init(&b, t, l, o, pieces, &work, e);
    if (!status) {
        u = wf_arena_take(&work, b.mesh.n, sizeof *u);
        q = wf_arena_take(&work, b.mesh.n, sizeof *q);
        if (!u || !q) status = wf_fail(e, WF_ENOMEM, "no room for %zu displacements", b.mesh.n);
    }
    if (!status) {
        wf_beam_sweep_up(&b);
        wf_beam_sweep_down(&b, false, NULL);
        displace(&b, u, q);
        wf_beam_read(&b, r);
        for (size_t i = 0; i < t->n; i++) {
            int32_t last = b.mesh.last[i], below = b.mesh.part[b.mesh.first[i]].parent;
            memcpy(r->end + 3 * i, u[last], sizeof *u);
            memcpy(r->turn + 3 * i, q[last], sizeof *q);
            double c[3];
            wf_cross(q[last], r->tangent1 + 3 * i, c);
            v3_add(r->tangent1 + 3 * i, 1, c);
            if (below < 0) continue;
            wf_cross(q[below], r->tangent0 + 3 * i, c);
            v3_add(r->tangent0 + 3 * i, 1, c);
        }
        r->load_factor = 1;
        r->iterations = r->steps = 1;
        r->small_deflection = true;
    }
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
