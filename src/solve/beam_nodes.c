/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_nodes.h"
#include "base/vec3.h"
#include <string.h>

/* Loads at element ends: point masses, dead and follower forces and moments. */
void wf_beam_load_nodes(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    memset(b->wrench, 0, b->mesh.n * sizeof *b->wrench);
    if (b->mesh.mass1)
        for (size_t i = 0; i < b->mesh.n; i++)
            b->wrench[i].n[2] -= l->weight_scale * l->gravity * b->mesh.mass1[i];
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        size_t i = (size_t)b->mesh.last[q->segment];
        double f[3], m[3];
        memcpy(f, q->force, sizeof f), memcpy(m, q->moment, sizeof m);
        if (q->kind == WF_POINT_FOLLOWER) m3_apply(b->pose[i].L, f, f), m3_apply(b->pose[i].L, m, m);
        v3_add(b->wrench[i].n, l->point_scale, f);
        v3_add(b->wrench[i].m, l->point_scale, m);
    }
    for (size_t k = 0; k < l->ties; k++) {
        size_t i = (size_t)b->mesh.last[l->tie[k].segment];
        double f[3];
        (void)wf_tie_pull(&l->tie[k], b->pose[i].r, f, NULL);
        v3_add(b->wrench[i].n, 1, f);
    }
}

/* Follower loads rotate with their section: dn = spin x n. Cables resist as their ends move. */
void wf_beam_react_nodes(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    memset(b->node, 0, b->mesh.n * sizeof *b->node);
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        if (q->kind != WF_POINT_FOLLOWER || b->frozen) continue;
        size_t i = (size_t)b->mesh.last[q->segment];
        double f[3], m[3], N[9] = { 0 }, M[9] = { 0 };
        m3_apply(b->pose[i].L, q->force, f), m3_apply(b->pose[i].L, q->moment, m);
        m3_add_cross(N, -l->point_scale, f), m3_add_cross(M, -l->point_scale, m);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                b->node[i].K[r][3 + c] += N[3 * r + c];
                b->node[i].K[3 + r][3 + c] += M[3 * r + c];
            }
    }
    for (size_t k = 0; k < l->ties; k++) {
        size_t i = (size_t)b->mesh.last[l->tie[k].segment];
        double f[3], by[9];
        (void)wf_tie_pull(&l->tie[k], b->pose[i].r, f, by);
        for (int r = 0; r < 9; r++) b->node[i].K[r / 3][r % 3] += by[r];
    }
}
