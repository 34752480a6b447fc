/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/prism_check.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/prism.h"
#include "solve/prism_rest.h"
#include "solve/prism_step.h"
#include <math.h>
#include <string.h>

/* A rod of n prisms, at rest, with room for forces. */
struct cut {
    struct wf_prism p;
    double *x, *f, inertia;
};

static enum wf_status make_as(const struct wf_prism_rod *r, size_t n, double restoring, bool diagonal,
                              struct wf_arena *a, struct cut *out, struct wf_err *e)
{
    double *place = WF_TAKE(a, 3 * (n + 1), double), *ei = WF_TAKE(a, n, double), *gj = WF_TAKE(a, n, double);
    double *mass = WF_TAKE(a, n + 1, double), *polar = WF_TAKE(a, n + 1, double), h = r->length / (double)n;
    out->x = WF_TAKE(a, 9 * (n + 1), double), out->f = WF_TAKE(a, 9 * (n + 1), double);
    if (!place || !ei || !gj || !mass || !polar || !out->x || !out->f)
        return wf_fail(e, WF_ENOMEM, "no memory");
    out->inertia = WF_PI / 4 * pow(r->radius, 4);
    for (size_t i = 0; i <= n; i++) {
        double share = i && i < n ? h : h / 2;
        place[3 * i] = (double)i * h;
        mass[i] = r->density * WF_PI * r->radius * r->radius * share;
        polar[i] = 2 * r->density * out->inertia * share;
        if (i < n) ei[i] = r->youngs * out->inertia, gj[i] = 2 * r->shear * out->inertia;
    }
    const struct wf_prism_axis axis = { .segments = n,
                                        .place = place,
                                        .normal = { 0, 0, 1 },
                                        .bending = ei,
                                        .torsion = gj,
                                        .mass = mass,
                                        .polar = polar,
                                        .restoring = restoring,
                                        .diagonal = diagonal,
                                        .on = -1 };
    enum wf_status s = wf_prism_make(&axis, 1, a, &out->p, e);
    if (!s) memcpy(out->x, out->p.rest, 9 * (n + 1) * sizeof *out->x);
    return s;
}

static enum wf_status make(const struct wf_prism_rod *r, size_t n, double restoring, struct wf_arena *a,
                           struct cut *out, struct wf_err *e)
{
    return make_as(r, n, restoring, false, a, out, e);
}

/* Tip deflection by a force across [m]. */
static enum wf_status deflect(const struct wf_prism_rod *r, size_t n, double restoring, double force,
                              struct wf_arena *a, double *tip, struct wf_err *e)
{
    struct cut c;
    enum wf_status s = make(r, n, restoring, a, &c, e);
    if (s) return s;
    for (size_t j = 0; j < 3; j++) c.f[9 * n + 3 * j + 2] = force / 3;
    if ((s = wf_prism_settle(&c.p, c.f, c.x, a, e))) return s;
    const double *v = c.x + 9 * n;
    *tip = (v[2] + v[5] + v[8]) / 3;
    return WF_OK;
}

/* Twist of the tip by a moment about the axis [rad]. */
static enum wf_status twist(const struct wf_prism_rod *r, size_t n, double restoring, double moment,
                            struct wf_arena *a, double *turn, struct wf_err *e)
{
    struct cut c;
    enum wf_status s = make(r, n, restoring, a, &c, e);
    if (s) return s;
    double arm = c.p.arm[0], force = moment / (3 * arm);
    for (size_t j = 0; j < 3; j++) {
        const double *at = c.p.rest + 9 * n + 3 * j;
        c.f[9 * n + 3 * j + 1] = -at[2] / arm * force, c.f[9 * n + 3 * j + 2] = at[1] / arm * force;
    }
    if ((s = wf_prism_settle(&c.p, c.f, c.x, a, e))) return s;
    *turn = atan2(-c.x[9 * n + 1], c.x[9 * n + 2]);
    return WF_OK;
}

enum wf_status wf_prism_cantilever(const struct wf_prism_rod *r, size_t n, double force, double moment,
                                   struct wf_arena *a, struct wf_prism_answer *out, struct wf_err *e)
{
    struct cut c;
    enum wf_status s = make(r, n, r->restoring, a, &c, e);
    if (!s) s = wf_prism_frequency(&c.p, c.x, NULL, a, &out->frequency, e);
    if (!s) s = deflect(r, n, r->restoring, force, a, &out->tip, e);
    if (!s) s = twist(r, n, r->restoring, moment, a, &out->turn, e);
    return s;
}

/* Ratios to Euler-Bernoulli and Saint-Venant, by small loads. */
static enum wf_status ratios(const struct wf_prism_rod *r, size_t n, struct wf_arena *a,
                             struct wf_prism_answer *out, struct wf_err *e)
{
    static const double root = 1.875104068711961; /* cos x cosh x = -1 */
    double inertia = WF_PI / 4 * pow(r->radius, 4), line = r->density * WF_PI * r->radius * r->radius;
    double small = 1e-4 * r->length, turn = 1e-3;
    enum wf_status s = wf_prism_cantilever(r, n, 3 * small * r->youngs * inertia / pow(r->length, 3),
                                           turn * 2 * r->shear * inertia / r->length, a, out, e);
    out->tip /= small, out->turn /= turn;
    out->frequency *= WF_TURN * r->length * r->length / (root * root * sqrt(r->youngs * inertia / line));
    return s;
}

enum wf_status wf_prism_compare(const struct wf_prism_rod *rod, struct wf_arena *a,
                                struct wf_prism_check out[WF_PRISM_CHECKS], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    struct wf_prism_rod free = *rod;
    free.restoring = 0;
    for (size_t k = 0; k < WF_PRISM_CHECKS && !s; k++) {
        struct wf_prism_check *c = &out[k];
        struct wf_prism_answer alone = { 0 }, held = { 0 };
        c->prisms = (size_t)4 << k;
        s = ratios(&free, c->prisms, a, &alone, e);
        if (!s) s = ratios(rod, c->prisms, a, &held, e);
        c->bend = alone.tip - 1, c->twist = alone.turn - 1, c->frequency = alone.frequency - 1;
        c->held = held.tip, c->quick = held.frequency;
    }
    return s;
}

/* ---- Springs without a law ---- */

static const double order_constant = 200; /* assumed: soft enough for branches that bend visibly */
static const double order_times[2] = { 1.5, 4.0 };
static const double order_step = 2e-3, order_damping = 8; /* [s], c [1/s] */
static const double order_push = 1e-4;                    /* of a 3 mm drop at its terminal speed [N s] */

static double tip_moved(const struct cut *c, const double *x)
{
    const double *v = x + 9 * (c->p.sections - 1), *o = c->p.rest + 9 * (c->p.sections - 1);
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double d = (v[k] + v[3 + k] + v[6 + k] - o[k] - o[3 + k] - o[6 + k]) / 3;
        sum += d * d;
    }
    return sqrt(sum);
}

static double largest_fold(const struct cut *c, const double *x)
{
    double least = 1, at[3], was[3], now[3], left[3], normal[3];
    wf_prism_frame(&c->p, x, 0, at, was, left, normal);
    for (size_t s = 1; s < c->p.sections; s++) {
        wf_prism_frame(&c->p, x, s, at, now, left, normal);
        least = fmin(least, wf_dot(was, now));
        memcpy(was, now, sizeof was);
    }
    return acos(fmax(-1, least));
}

static double largest_strain(const struct cut *c, const double *x)
{
    double most = 0;
    for (size_t i = 0; i < c->p.springs; i++) {
        const struct wf_prism_spring *s = &c->p.spring[i];
        double d[3];
        if (s->b < 0) continue;
        for (int k = 0; k < 3; k++) d[k] = x[3 * s->a + k] - x[3 * s->b + k];
        most = fmax(most, fabs(sqrt(wf_dot(d, d)) / s->rest - 1));
    }
    return most;
}

static void keep_line(const struct cut *c, const double *x, double *line)
{
    double along[3], left[3], normal[3];
    for (size_t s = 0; s < c->p.sections; s++) wf_prism_frame(&c->p, x, s, line + 3 * s, along, left, normal);
}

/* Run a phase. Returned: in *back the last time at which the tip was further than `near` from its rest. */
static enum wf_status swing(const struct cut *c, struct wf_prism_motion *m, double time, double near,
                            double *back, struct wf_err *e)
{
    *back = 0;
    for (size_t i = 0, n = (size_t)(time / order_step + 0.5); i < n; i++) {
        if (i % 64 == 0 && wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
        enum wf_status s = wf_prism_advance(m, e);
        if (s) return s;
        if (tip_moved(c, m->x) > near) *back = m->time;
    }
    return WF_OK;
}

static enum wf_status load_and_let_go(const struct wf_prism_rod *rod, size_t n, double restoring,
                                      struct wf_arena *a, struct wf_prism_order *o, struct wf_err *e)
{
    struct cut c;
    struct wf_prism_rod r = *rod;
    r.length = rod->length / 16 * (double)n;
    *o = (struct wf_prism_order){ .prisms = n, .constant = order_constant, .restoring = restoring };
    enum wf_status s = make_as(&r, n, restoring, true, a, &c, e);
    if (s) return s;
    if (!(o->line = WF_TAKE(a, 6 * (n + 1), double))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < c.p.springs; i++)
        if (c.p.spring[i].row != WF_PRISM_RESTORING) c.p.spring[i].k = order_constant;
    struct wf_prism_motion m = { .p = &c.p, .step = order_step, .damping = order_damping, .gravity = 9.8 };
    m.tolerance = 1e-10;
    struct wf_prism_motion free = m;
    free.gravity = 0;
    struct wf_prism_point tip = { .n = 3, .share = { 1.0 / 3, 1.0 / 3, 1.0 / 3 } };
    for (int j = 0; j < 3; j++) tip.vertex[j] = (int32_t)(3 * n) + j;
    if ((s = wf_prism_begin(&m, NULL, a, e))) return s;
    wf_prism_push(&m, &tip, (const double[]){ 0, 0, -order_push });
    if ((s = swing(&c, &m, order_times[0], INFINITY, &o->back, e))) return s;
    double sag = tip_moved(&c, m.x);
    o->sag = sag / r.length, o->fold = largest_fold(&c, m.x), o->strain = largest_strain(&c, m.x);
    keep_line(&c, m.x, o->line);
    if ((s = wf_prism_begin(&free, m.x, a, e))) return s;
    if ((s = swing(&c, &free, order_times[1], 0.05 * sag, &o->back, e))) return s;
    keep_line(&c, free.x, o->line + 3 * (n + 1));
    o->left = tip_moved(&c, free.x) / r.length;
    if (o->back > order_times[1] - 1.5 * order_step) o->back = NAN;
    return WF_OK;
}

enum wf_status wf_prism_disorder(const struct wf_prism_rod *rod, struct wf_arena *a,
                                 struct wf_prism_order out[WF_PRISM_ORDERS], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < WF_PRISM_ORDERS && !s; k++)
        s = load_and_let_go(rod, (size_t)4 << k % WF_PRISM_CHECKS, k < WF_PRISM_CHECKS ? 0 : rod->restoring,
                            a, &out[k], e);
    return s;
}
