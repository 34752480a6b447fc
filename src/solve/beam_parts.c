/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_parts.h"
#include "base/vec3.h"
#include <math.h>

static double carried(const struct wf_beam *b, size_t i)
{
    return sqrt(wf_dot(b->wrench[i].n, b->wrench[i].n));
}

/* The lowest element of the part that is to be settled with element i: it carries less than a hundredth of
 * the force on the ground or, where i itself carries more, hardly more than i. -1: the part would be a large
 * one. */
static int32_t part_of(const struct wf_beam *b, size_t i, double force)
{
    const double small = 0.01, large = 0.2, hardly = 1.2;
    const double limit = fmax(small * force, hardly * carried(b, i));
    int32_t root = (int32_t)i, below;
    if (!(carried(b, i) <= large * force)) return -1;
    while ((below = b->mesh.part[root].parent) >= 0 && carried(b, (size_t)below) <= limit) root = below;
    return below < 0 ? -1 : root;
}

/* Sort the elements that are not held by the part they belong to. Returned: how many they are. */
static size_t sort_parts(struct wf_beam *b)
{
    struct wf_beam_only *p = &b->part;
    size_t n = 0;
    for (size_t i = 0; i < b->mesh.n; i++) {
        int32_t below = b->mesh.part[i].parent;
        p->place[i] = 0;
        if (p->held[i]) continue;
        p->root[i] = below >= 0 && !p->held[below] ? p->root[below] : (int32_t)i;
        p->place[p->root[i]]++;
    }
    for (size_t i = 0; i < b->mesh.n; i++) {
        if (p->held[i] || p->root[i] != (int32_t)i) continue;
        size_t many = (size_t)p->place[i];
        p->place[i] = (int32_t)n, n += many;
    }
    for (size_t i = 0; i < b->mesh.n; i++)
        if (!p->held[i]) p->id[p->place[p->root[i]]++] = (int32_t)i;
    return n;
}

struct wf_beam_parts wf_beam_find_parts(struct wf_beam *b, double slight)
{
    const double force = sqrt(wf_dot(b->base.n, b->base.n));
    struct wf_beam_parts out = { 0 };
    bool *still = b->part.held;
    double most = 0, all = 0, in = 0;
    for (size_t i = 0; i < b->mesh.n; i++) most = fmax(most, b->off[i]), all += b->off[i], still[i] = true;
    for (size_t i = 0; i < b->mesh.n; i++) {
        if (!(b->off[i] >= slight * most)) continue;
        int32_t root = part_of(b, i, force);
        if (root < 0)
            out.large = true;
        else
            still[root] = false;
    }
    for (size_t i = 0; i < b->mesh.n; i++) { /* and all above them */
        if (b->mesh.part[i].parent >= 0 && !still[b->mesh.part[i].parent]) still[i] = false;
        if (!still[i]) in += b->off[i];
    }
    out.share = all > 0 ? in / all : 0;
    out.n = sort_parts(b);
    return out;
}

bool wf_beam_each_part(struct wf_beam *b, size_t n, double most,
                       bool (*solve)(struct wf_beam *b, void *context), void *context)
{
    const size_t iterations = b->iterations;
    const struct wf_beam_misfit misfit = b->misfit;
    bool all = true;
    for (size_t from = 0, to; from < n && most > 0; from = to) {
        struct wf_beam_only one = b->part;
        int32_t root = b->part.root[b->part.id[from]];
        for (to = from; to < n && b->part.root[b->part.id[to]] == root;) to++;
        one.id += from, one.n = to - from;
        b->only = &one;
        b->iterations = 0;
        all = solve(b, context) && all;
        most -= (double)(b->iterations + 1) * (double)one.n;
    }
    b->only = NULL;
    b->iterations = iterations;
    b->misfit = misfit; /* of which the guard of the next sweep is */
    return all && most > 0;
}

void wf_beam_move_only(struct wf_beam *b)
{
    b->part.n = 0;
    for (size_t i = 0; i < b->mesh.n; i++)
        if (!b->part.held[i]) b->part.id[b->part.n++] = (int32_t)i;
    b->only = &b->part;
}
