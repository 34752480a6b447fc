/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_element.h"
#include "solve/beam_kernel.h"
#include "solve/beam_mesh.h"

/* One element: its position, its loads, its internal forces and its curvature. */

void wf_beam_place(const struct wf_beam_part *p, const struct wf_beam_shape *u,
                   const struct wf_beam_pose *base, struct wf_beam_stage *s, struct wf_beam_pose *end)
{
    place_element(p, u, base, s, end);
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

void wf_beam_couple(const struct wf_beam_flat *flat, double couple[2][3])
{
    memset(couple, 0, 2 * sizeof *couple);
    if (flat) side_couple(flat, couple);
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
    balance_element(h, s, flat, load, end, at, base);
}

void wf_beam_curvature(const struct wf_beam_part *p, const struct wf_beam_shape *u, double k[2][3])
{
    curvature_of(p, u, k);
}
