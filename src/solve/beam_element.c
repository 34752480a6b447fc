/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_element.h"
#include "base/vec3.h"
#include "solve/beam_mesh.h"

/* One element: its position, its loads, its internal forces and its curvature. */

void wf_beam_place(const struct wf_beam_part *p, const struct wf_beam_shape *u,
                   const struct wf_beam_pose *base, struct wf_beam_stage *s, struct wf_beam_pose *end)
{
    double last[3], R[9];
    for (int j = 0; j < 2; j++) {
        double t[3];
        rotation_matrix(u->v[j], R);
        m3_apply(R, p->t[j], t);
        m3_apply(base->L, t, s->t[j]);
        for (int i = 0; i < 3; i++) t[i] += u->g[j][i];
        m3_apply(base->L, t, s->rp[j]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            s->r[j][i] = base->r[i] + p->h * (gauss_up[j][0] * s->rp[0][i] + gauss_up[j][1] * s->rp[1][i]);
        end->r[i] = base->r[i] + 0.5 * p->h * (s->rp[0][i] + s->rp[1][i]);
        last[i] = gauss_end[0] * u->v[0][i] + gauss_end[1] * u->v[1][i];
    }
    rotation_matrix(last, R);
    m3_mul(base->L, R, end->L);
}

void wf_beam_turn(const struct wf_beam_shape *u, const double L[9], struct wf_beam_flat *flat)
{
    double R[9];
    for (int j = 0; j < 2; j++) {
        rotation_matrix(u->v[j], R);
        m3_apply(R, flat->across[j], flat->across[j]);
        m3_apply(L, flat->across[j], flat->across[j]);
    }
}

/* side across x (0, 0, -weight) */
void wf_beam_couple(const struct wf_beam_flat *flat, double couple[2][3])
{
    for (int j = 0; j < 2; j++) {
        double moment = flat ? flat->side[j] * flat->weight : 0;
        couple[j][0] = flat ? -moment * flat->across[j][1] : 0;
        couple[j][1] = flat ? moment * flat->across[j][0] : 0;
        couple[j][2] = 0;
    }
}

void wf_beam_load(const struct wf_beam_part *p, const struct wf_loads *l, const struct wf_beam_stage *s,
                  struct wf_line_load load[2])
{
    for (int j = 0; j < 2; j++) {
        wf_load_on_line(l, &p->line[j], s->r[j], s->t[j], &load[j]);
        v3_add(load[j].force, l->point_scale, p->dead[j]);
    }
}

void wf_beam_balance(double h, const struct wf_beam_stage *s, const struct wf_beam_flat *flat,
                     const struct wf_line_load load[2], const struct wf_beam_wrench *end,
                     struct wf_beam_wrench at[2], struct wf_beam_wrench *base)
{
    double turn[2][3], couple[2][3];
    wf_beam_couple(flat, couple);
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++)
            at[j].n[i] =
                end->n[i] + h * (gauss_down[j][0] * load[0].force[i] + gauss_down[j][1] * load[1].force[i]);
        wf_cross(s->rp[j], at[j].n, turn[j]);
        v3_add(turn[j], 1, couple[j]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            at[j].m[i] = end->m[i] + h * (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        base->n[i] = end->n[i] + 0.5 * h * (load[0].force[i] + load[1].force[i]);
        base->m[i] = end->m[i] + 0.5 * h * (turn[0][i] + turn[1][i]);
    }
}

void wf_beam_curvature(const struct wf_beam_part *p, const struct wf_beam_shape *u, double k[2][3])
{
    for (int j = 0; j < 2; j++) {
        double slope[3], once[3], twice[3], x = wf_dot(u->v[j], u->v[j]);
        struct rotation o = rotation_of(x);
        for (int i = 0; i < 3; i++)
            slope[i] = (gauss_slope[j][0] * u->v[0][i] + gauss_slope[j][1] * u->v[1][i]) / p->h;
        wf_cross(u->v[j], slope, once);
        wf_cross(u->v[j], once, twice);
        for (int i = 0; i < 3; i++) k[j][i] = slope[i] + o.a * once[i] + o.b * twice[i];
    }
}
