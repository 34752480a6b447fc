/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_team.h"
#include "base/abreast.h"
#include "load/load.h"
#include "solve/beam_lanes.h"
#include "wind/wind.h"

/* Can two sweeps be computed side by side? */
static bool alike(const struct wf_groups_sweep *a, const struct wf_groups_sweep *b)
{
    const struct wf_wind *x = a->loads->wind, *y = b->loads->wind;
    if (a->upwards || b->upwards) return a->upwards == b->upwards;
    return a->tangent == b->tangent && a->frozen == b->frozen && !a->small == !b->small &&
           a->grows == b->grows && !x == !y && (!x || wf_wind_form(x) == wf_wind_form(y));
}

/* How many of the n are like one? */
static size_t count_alike(void *const *request, size_t n, const struct wf_groups_sweep *one)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += alike(one, request[i]);
    return count;
}

/* Take up to `most` that are like the first of them out of the list. Returned: how many, by falling numbers
 * of elements. */
static size_t take_alike(void **request, size_t *n, const struct wf_groups_sweep *one, size_t most,
                         struct wf_groups_sweep **out)
{
    size_t taken = 0, left = 0;
    for (size_t i = 0; i < *n; i++) {
        struct wf_groups_sweep *x = request[i];
        if (taken == most || !alike(one, x)) {
            request[left++] = x;
            continue;
        }
        size_t at = taken++;
        for (; at && out[at - 1]->mesh->n < x->mesh->n; at--) out[at] = out[at - 1];
        out[at] = x;
    }
    *n = left;
    return taken;
}

/* The largest number that are alike; all lanes of the kernel are used, or the others have to wait. */
static size_t sweep_together(void **request, size_t n)
{
    struct wf_groups_sweep *some[WF_LANES_MOST];
    const struct wf_groups_sweep *one = request[0];
    const size_t lanes = wf_groups_kernel(WF_LANES_MOST)->width;
    size_t most = 0;
    for (size_t i = 0; i < n && most < lanes; i++) {
        size_t count = count_alike(request, n, request[i]);
        if (count > most) most = count, one = request[i];
    }
    size_t taken = take_alike(request, &n, one, lanes, some);
    const struct wf_groups_kernel *kernel = wf_groups_kernel(taken);
    (one->upwards ? kernel->chains_up : kernel->chains_down)(some, taken);
    return n;
}

bool wf_beam_team_down(struct wf_groups_sweep *x)
{
    wf_abreast_join(sweep_together, x);
    return x->whole;
}

void wf_beam_team_up(struct wf_groups_sweep *x)
{
    x->upwards = true;
    wf_abreast_join(sweep_together, x);
}
