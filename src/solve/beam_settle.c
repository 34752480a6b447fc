/* Ways to an equilibrium at the full load that always end. */
#include "solve/beam_newton.h"
#include "solve/vec.h"

enum { EFFORT = 300 }; /* Newton iterations spent on load steps, and on creep, before giving up */

struct saved {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
};

static void keep(const struct wf_beam *b, struct saved *s)
{
    memcpy(s->shape, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(s->tilt, b->tilt, b->mesh.tree->n * sizeof *b->tilt);
}

static void restore(struct wf_beam *b, const struct saved *s)
{
    memcpy(b->shape, s->shape, b->mesh.n * sizeof *b->shape);
    memcpy(b->tilt, s->tilt, b->mesh.tree->n * sizeof *b->tilt);
}

static void scale(struct wf_beam *b, const struct wf_loads *full, double share)
{
    b->loads.wind_scale = share * full->wind_scale;
    b->loads.weight_scale = share * full->weight_scale;
    b->loads.point_scale = share * full->point_scale;
}

/* A fallen stem may turn about the vertical at no cost, and the tangent is symmetric only to second order in
 * an element's own turn: allow for that much. A twig that may snap to another shape does not bring down the
 * tree: parts that bear less than a hundredth of what the ground does are counted (loose), not refused. */
bool wf_beam_stable(struct wf_beam *b)
{
    const double small = 0.01;
    double turn = 0;
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) turn = fmax(turn, wf_dot(b->shape[i].v[j], b->shape[i].v[j]));
    struct wf_beam_stability count = { .margin = 1e-6 + 0.5 * turn };
    if (!wf_beam_sweep_down(b, true, &count)) return false;
    b->loose = count.negative;
    return count.bears <= small * sqrt(wf_dot(b->base.n, b->base.n));
}

/* Load steps from the unloaded tree, halved where Newton stalls or the state is unstable. Returned: share
 * reached. */
static double load_steps(struct wf_beam *b, const struct wf_loads *full, struct saved *last)
{
    double share = 0, size = 0.25;
    memset(b->shape, 0, b->mesh.n * sizeof *b->shape);
    memset(b->tilt, 0, b->mesh.tree->n * sizeof *b->tilt);
    keep(b, last);
    size_t most = b->iterations + EFFORT;
    while (share < 1 && size > 2e-4 && b->iterations < most) {
        double next = fmin(1, share + size);
        scale(b, full, next);
        if (wf_beam_newton(b) == WF_OK && wf_beam_stable(b)) {
            share = next;
            size *= 2;
            b->steps++;
            keep(b, last);
        } else {
            restore(b, last);
            size *= 0.5;
        }
    }
    return share;
}

/* A small sideways bow, so that a shape that is only balanced on its edge can leave it. */
static void nudge(struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.tree->n; i++)
        for (int j = 0; j < 2; j++)
            if (b->options->root_stiffness[j] > 0) b->tilt[i][j] += j ? 2e-4 : 6e-5;
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++)
            b->shape[i].v[j][1] += 1e-4 * (j + 1), b->shape[i].v[j][0] += 3e-5 * (j + 1);
}

/* Kelvin-Voigt creep under the full load: each step solves the tree with a section moment G^-1 (k + rate (k -
 * k_old)), an implicit Euler step of viscous motion of length 1/rate, which has a stable answer however far
 * the elastic one is when the step is short enough. (A balanced but unstable answer of a longer step leads
 * back to the shape the tree is to leave, and is refused.) The rate falls while the steps succeed; at rate 0
 * the elastic equilibrium is left. */
static bool creep(struct wf_beam *b, struct saved *last)
{
    double rate = 64;
    size_t most = b->iterations + EFFORT;
    b->tilt0 = last->tilt;
    for (int k = 0; k < 400 && b->iterations < most; k++) {
        keep(b, last);
        for (size_t i = 0; i < b->mesh.n; i++) wf_beam_curvature(&b->mesh.part[i], &b->shape[i], b->k0[i]);
        b->creep = rate;
        bool moved = wf_beam_newton(b) == WF_OK && wf_beam_stable(b);
        b->creep = 0;
        b->steps++;
        if (!moved) {
            restore(b, last);
            rate *= 4;
            if (rate > 1e9) return false;
            continue;
        }
        rate *= 0.6;
        if (rate > 0.02) continue;
        keep(b, last);
        if (wf_beam_newton(b) == WF_OK && wf_beam_stable(b)) return true;
        restore(b, last);
        if (rate < 1e-8) rate = 1; /* slower and slower creep has not left an unstable shape: begin again */
    }
    return false;
}

enum wf_status wf_beam_settle(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                              struct wf_err *e)
{
    const struct wf_loads full = b->loads;
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (wf_beam_newton(b) == WF_OK && wf_beam_stable(b)) return WF_OK;

    struct saved last = { WF_TAKE(a, b->mesh.n, struct wf_beam_shape),
                          wf_arena_take(a, b->mesh.tree->n, sizeof *last.tilt) };
    b->k0 = wf_arena_take(a, b->mesh.n, sizeof *b->k0);
    if (!last.shape || !last.tilt || !b->k0) return wf_fail(e, WF_ENOMEM, "no room for load steps");
    out->load_factor = load_steps(b, &full, &last);
    if (out->load_factor >= 1) return WF_OK;

    restore(b, &last);
    scale(b, &full, 1);
    nudge(b);
    out->beyond_limit = true;
    if (creep(b, &last)) return WF_OK;
    return wf_fail(e, WF_EUNSTABLE, "no equilibrium found: the tree stands up to %.4g of the load",
                   out->load_factor);
}
