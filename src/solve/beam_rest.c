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

/* Internal forces of element i in the given shape, at its Gauss points and below its base, from those at its
 * end. Given: mass per length at the Gauss points; flat NULL: the weight acts on the axis. */
static void forces_of(const struct wf_beam_part *p, const double mass[2], const struct wf_beam_flat *flat,
                      double weight, const struct wf_beam_wrench *end, struct wf_beam_wrench at[2],
                      struct wf_beam_wrench *down)
{
    struct wf_beam_stage s;
    struct wf_line_load load[2] = { { { 0 }, { 0 }, { 0 } }, { { 0 }, { 0 }, { 0 } } };
    stage_at_rest(p, &s);
    for (int j = 0; j < 2; j++) load[j].force[2] -= mass[j] * weight;
    balance_element(p->h, &s, flat, load, end, at, down);
}

/* Internal forces of element i under the weight, and what they make of its section. */
static void rest_of(struct wf_beam_mesh *m, size_t i, double weight, struct wf_beam_wrench *down)
{
    struct wf_beam_part *p = &m->part[i];
    const struct wf_beam_standing *x = &m->standing[i];
    struct wf_beam_stage s;
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
    forces_of(p, x->mass, section, weight, &end, at, down);
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

enum wf_status wf_beam_rest_of(const struct wf_beam_mesh *m, double (*mass)[2], double weight,
                               struct wf_arena *a, struct wf_beam_rest_part **part, double (**root)[3],
                               struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_beam_wrench *end = WF_TAKE(&scratch, m->n, struct wf_beam_wrench);
    *part = WF_TAKE(a, m->n, struct wf_beam_rest_part);
    *root = wf_arena_take(a, m->tree->n, sizeof **root);
    bool room = end && *part && *root;
    for (size_t i = m->n; room && i-- > 0;) {
        struct wf_beam_wrench at[2], down;
        const struct wf_beam_part *p = &m->part[i];
        forces_of(p, mass[i], NULL, weight, &end[i], at, &down);
        for (int j = 0; j < 2; j++) {
            memcpy((*part)[i].moment[j], at[j].m, sizeof at[j].m);
            v3_section(p->cs[j], p->ca[j], p->t[j], at[j].n, (*part)[i].strain[j]);
        }
        if (p->parent < 0) {
            v3_add((*root)[p->row], 1, down.m);
            continue;
        }
        v3_add(end[p->parent].n, 1, down.n);
        v3_add(end[p->parent].m, 1, down.m);
    }
    wf_arena_free(&scratch);
    return room ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the state at rest");
}
