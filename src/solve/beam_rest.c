/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_rest.h"
#include "base/vec3.h"
#include "solve/beam_kernel.h"

/* The given shape as a state of the element. */
static void stage_at_rest(const struct wf_beam_part *p, struct wf_beam_stage *s)
{
    *s = (struct wf_beam_stage){ 0 };
    memcpy(s->t, p->t, sizeof s->t);
    memcpy(s->rp, p->t, sizeof s->rp);
}

/* Internal forces of element i under the weight, and what they make of its section. */
static void rest_of(struct wf_beam_mesh *m, size_t i, double weight, struct wf_beam_wrench *down)
{
    struct wf_beam_part *p = &m->part[i];
    const struct wf_beam_standing *x = &m->standing[i];
    struct wf_beam_stage s;
    struct wf_line_load load[2] = { { { 0 }, { 0 }, { 0 } }, { { 0 }, { 0 }, { 0 } } };
    struct wf_beam_wrench end, at[2];
    struct wf_beam_flat flat, *section = NULL;
    stage_at_rest(p, &s);
    if (m->flat) {
        flat = m->flat[i];
        flat.weight = weight;
        memcpy(flat.side, x->side, sizeof flat.side);
        section = &flat;
    }
    memcpy(end.n, x->n, sizeof end.n);
    memcpy(end.m, x->m, sizeof end.m);
    for (int j = 0; j < 2; j++) load[j].force[2] -= x->mass[j] * weight;
    balance_element(p->h, &s, section, load, &end, at, down);
    for (int j = 0; j < 2; j++) {
        law_give(p, section, &s, j, at[j].m, p->k0[j]);
        v3_section(p->cs[j], p->ca[j], s.t[j], at[j].n, p->g0[j]);
    }
}

void wf_beam_rest(struct wf_beam_mesh *m, double weight)
{
    if (!m->standing) return;
    const struct wf_tree *t = m->tree;
    for (size_t i = 0; i < m->n; i++) {
        struct wf_beam_standing *x = &m->standing[i];
        memset(x->n, 0, sizeof x->n);
        memset(x->m, 0, sizeof x->m);
        if (m->mass1) x->n[2] -= weight * m->mass1[i];
    }
    memset(m->root, 0, t->n * sizeof *m->root);
    for (size_t i = m->n; i-- > 0;) {
        struct wf_beam_wrench down;
        rest_of(m, i, weight, &down);
        int32_t below = m->part[i].parent;
        if (below < 0) {
            v3_add(m->root[m->part[i].row], 1, down.m);
            continue;
        }
        v3_add(m->standing[below].n, 1, down.n);
        v3_add(m->standing[below].m, 1, down.m);
    }
}
