/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_settle.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/beam_eliminate.h"
#include "solve/beam_parts.h"
#include "solve/beam_rest.h"
#include <math.h>
#include <string.h>

/* Fallbacks that reach equilibrium at full load, or report that there is none; they always terminate. */

enum { EFFORT = 300 }; /* Newton iterations allowed for load steps, and again for creep, before giving up */

struct saved_shape {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
};

static void copy_shape(const struct wf_beam *b, struct wf_beam_shape *to, double (*tilt)[3],
                       const struct wf_beam_shape *from, double (*from_tilt)[3])
{
    for (size_t k = 0; k < wf_beam_moving(b); k++) to[wf_beam_moved(b, k)] = from[wf_beam_moved(b, k)];
    if (!b->only) memcpy(tilt, from_tilt, b->mesh.tree->n * sizeof *tilt);
}

static void save_shape(const struct wf_beam *b, struct saved_shape *s)
{
    copy_shape(b, s->shape, s->tilt, b->shape, b->tilt);
}

static void restore_shape(struct wf_beam *b, const struct saved_shape *s)
{
    copy_shape(b, b->shape, b->tilt, s->shape, s->tilt);
}

static void scale_loads(struct wf_beam *b, const struct wf_loads *full, double share)
{
    b->loads.wind_scale = share * full->wind_scale;
    b->loads.weight_scale = share * full->weight_scale;
    b->loads.point_scale = share * full->point_scale;
    wf_beam_rest(&b->mesh, b->loads.gravity * b->loads.weight_scale);
}

/* Load steps from the unloaded tree, halved where Newton stalls or the state is unstable. Returned: share of
 * the load reached. */
static double load_steps(struct wf_beam *b, const struct wf_loads *full, struct saved_shape *last)
{
    double share = 0, size = 0.25;
    for (size_t k = 0; k < wf_beam_moving(b); k++)
        b->shape[wf_beam_moved(b, k)] = (struct wf_beam_shape){ 0 };
    if (!b->only) memset(b->tilt, 0, b->mesh.tree->n * sizeof *b->tilt);
    save_shape(b, last);
    size_t most = b->iterations + EFFORT;
    while (share < 1 && size > 2e-4 && b->iterations < most) {
        double next = fmin(1, share + size);
        scale_loads(b, full, next);
        if (wf_beam_rests(b)) {
            share = next;
            size *= 2;
            b->steps++;
            save_shape(b, last);
        } else {
            restore_shape(b, last);
            size *= 0.5;
        }
    }
    return share;
}

/* Perturb the shape by a small sideways bow, so that it can leave an unstable equilibrium. */
static void perturb_shape(struct wf_beam *b)
{
    for (size_t i = 0; i < b->mesh.tree->n && !b->only; i++)
        for (int j = 0; j < 2; j++)
            if (b->options->root_stiffness[j] > 0) b->tilt[i][j] += j ? 2e-4 : 6e-5;
    for (size_t k = 0; k < wf_beam_moving(b); k++)
        for (int j = 0; j < 2; j++) {
            double *v = b->shape[wf_beam_moved(b, k)].v[j];
            v[1] += 1e-4 * (j + 1), v[0] += 3e-5 * (j + 1);
        }
}

/* A step of the creep from the shape that was saved, by Newton's method to a tight tolerance: within a loose
 * one the shape near an unstable equilibrium, which is to be left, would rest as it is. */
static bool creep(struct wf_beam *b, double rate)
{
    const double tight = 1e-8;
    const struct wf_solve_options *own = b->options;
    struct wf_solve_options o = *own;
    o.tolerance = fmin(own->tolerance, tight);
    for (size_t m = 0; m < wf_beam_moving(b); m++) {
        size_t i = wf_beam_moved(b, m);
        wf_beam_curvature(&b->mesh.part[i], &b->shape[i], b->k0[i]);
    }
    b->options = &o;
    b->creep = rate;
    bool moved = wf_beam_rests(b);
    b->creep = 0;
    b->options = own;
    b->steps++;
    return moved;
}

/* Kelvin-Voigt creep under the full load: each step solves the tree with a section moment G^-1 (k + rate (k
 * - k_old)), an implicit Euler step of viscous motion of length 1/rate. If the step is short enough it has a
 * stable solution, however far away the elastic one is. (An unstable equilibrium of a longer step would lead
 * back to the shape that is to be left, and is refused.) The rate falls while the steps succeed; at rate 0
 * the elastic equilibrium remains. */
static bool creep_to_rest(struct wf_beam *b, struct saved_shape *last)
{
    double rate = 64;
    size_t most = b->iterations + EFFORT;
    b->tilt0 = last->tilt;
    for (int k = 0; k < 400 && b->iterations < most; k++) {
        save_shape(b, last);
        if (!creep(b, rate)) {
            restore_shape(b, last);
            rate *= 4;
            if (rate > 1e9) return false;
            continue;
        }
        rate *= 0.6;
        if (rate > 0.02) continue;
        save_shape(b, last);
        if (wf_beam_rests(b)) return true;
        restore_shape(b, last);
        if (rate < 1e-8)
            rate = 1; /* ever slower creep has not left an unstable shape: start again with a fast step */
    }
    return false;
}

static bool take_fallback(struct wf_beam *b, struct wf_arena *a, struct saved_shape *last)
{
    last->shape = WF_TAKE(a, b->mesh.n, struct wf_beam_shape);
    last->tilt = wf_arena_take(a, b->mesh.tree->n, sizeof *last->tilt);
    b->k0 = wf_arena_take(a, b->mesh.n, sizeof *b->k0);
    return last->shape && last->tilt && b->k0;
}

/* Load steps, then creep. */
static bool step_then_creep(struct wf_beam *b, const struct wf_loads *full, struct saved_shape *last,
                            struct wf_beam_outcome *out)
{
    out->load_factor = load_steps(b, full, last);
    if (out->load_factor >= 1) return true;
    restore_shape(b, last);
    scale_loads(b, full, 1);
    perturb_shape(b);
    out->beyond_limit = true;
    return creep_to_rest(b, last);
}

/* The same, without small parts by themselves: each step would solve them again, beside its effort. */
static bool step_and_creep(struct wf_beam *b, const struct wf_loads *full, struct saved_shape *last,
                           struct wf_beam_outcome *out)
{
    b->by_steps = true;
    bool settled = step_then_creep(b, full, last, out);
    b->by_steps = false;
    return settled;
}

/* A small part by itself, the motion of its base given: Newton's method, load steps; where it has no
 * continuous path to the full load, it falls to the shape that creep leads to. */
static bool settle_part(struct wf_beam *b, void *context)
{
    struct saved_shape *last = context;
    const struct wf_loads now = b->loads;
    struct wf_beam_outcome out;
    if (wf_beam_rests(b)) return true;
    bool settled = step_and_creep(b, &now, last, &out);
    b->loads = now;
    return settled;
}

/* The small parts in which the residual is, or at least the largest of it: what is elsewhere may be of what
 * these do to the rest. */
static struct wf_beam_parts worst_parts(struct wf_beam *b)
{
    const double slight = 1e-3, coarser = 10, most = 0.5;
    struct wf_beam_parts out = wf_beam_find_parts(b, slight);
    for (double share = coarser * slight; out.large && share < most; share *= coarser)
        out = wf_beam_find_parts(b, share);
    return out;
}

bool wf_beam_settle_parts(struct wf_beam *b, struct wf_arena *a)
{
    enum { ROUNDS = 4 };
    struct saved_shape last;
    if (!b->off || b->links || !take_fallback(b, a, &last)) return false;
    for (int round = 0; round < ROUNDS; round++) {
        wf_beam_sweep_up(b);
        if (!wf_beam_sweep_down(b, true, NULL) || b->misfit.bending > 1e-3 * b->misfit.energy) return false;
        struct wf_beam_parts parts = worst_parts(b);
        if (parts.large || !wf_beam_each_part(b, parts.n, INFINITY, settle_part, &last)) return false;
        if (wf_beam_rests(b)) return true;
    }
    return false;
}

bool wf_beam_rests_soon(struct wf_beam *b, struct wf_arena *a)
{
    b->hasty = true;
    bool rests = wf_beam_rests(b);
    b->hasty = false;
    return rests || (a && wf_beam_settle_parts(b, a));
}

bool wf_beam_approach(struct wf_beam *b, double speed, double scale, struct wf_arena *a)
{
    enum { TRIES = 16 };
    const double least = 1.0 / 40;
    const struct wf_loads full = b->loads;
    struct wf_wind wind;
    struct saved_shape last;
    bool rests = false;
    if (!full.wind || (speed == full.wind->speed && scale == full.wind_scale) || !take_fallback(b, a, &last))
        return false;
    double done = 0, step = 0.5;
    save_shape(b, &last);
    for (int tries = 0; tries < TRIES && step > least && !rests; tries++) {
        const double share = 1 - done <= 1.2 * step ? 1 : done + step;
        restore_shape(b, &last);
        wind = *full.wind;
        wind.speed = wf_between(speed, full.wind->speed, share);
        b->loads.wind = share < 1 ? &wind : full.wind;
        b->loads.wind_scale = wf_between(scale, full.wind_scale, share);
        if (!wf_beam_rests_soon(b, a)) {
            step *= 0.5;
            continue;
        }
        save_shape(b, &last);
        done = share, step *= 1.5, rests = share == 1;
    }
    b->loads = full;
    b->k0 = NULL; /* it is of this arena */
    return rests;
}

enum wf_status wf_beam_step_to_rest(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                                    struct wf_err *e)
{
    const struct wf_loads full = b->loads;
    struct saved_shape last;
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    if (!take_fallback(b, a, &last)) return wf_fail(e, WF_ENOMEM, "not enough memory for load steps");
    if (step_and_creep(b, &full, &last, out)) return WF_OK;
    return wf_fail(e, WF_EUNSTABLE,
                   "no stable equilibrium found at full load; the last one is at %.4g of the load",
                   out->load_factor);
}

enum wf_status wf_beam_settle(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                              struct wf_err *e)
{
    *out = (struct wf_beam_outcome){ .load_factor = 1 };
    return wf_beam_rests(b) ? WF_OK : wf_beam_step_to_rest(b, a, out, e);
}
