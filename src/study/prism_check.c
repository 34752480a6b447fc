/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/prism_check.h"
#include "base/num.h"
#include "solve/prism.h"
#include "solve/prism_rest.h"
#include <math.h>
#include <string.h>

/* A rod of n prisms, at rest, with room for forces. */
struct cut {
    struct wf_prism p;
    double *x, *f, inertia;
};

static enum wf_status make(const struct wf_prism_rod *r, size_t n, double restoring, struct wf_arena *a,
                           struct cut *out, struct wf_err *e)
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
        if (i < n) ei[i] = r->youngs * out->inertia, gj[i] = r->youngs / 8 * out->inertia;
    }
    const struct wf_prism_axis axis = { .segments = n,
                                        .place = place,
                                        .normal = { 0, 0, 1 },
                                        .bending = ei,
                                        .torsion = gj,
                                        .mass = mass,
                                        .polar = polar,
                                        .restoring = restoring,
                                        .on = -1 };
    enum wf_status s = wf_prism_make(&axis, 1, a, &out->p, e);
    if (!s) memcpy(out->x, out->p.rest, 9 * (n + 1) * sizeof *out->x);
    return s;
}

/* Tip deflection over F L^3/(3 E I). */
static enum wf_status deflect(const struct wf_prism_rod *r, size_t n, double restoring, struct wf_arena *a,
                              double *ratio, struct wf_err *e)
{
    struct cut c;
    enum wf_status s = make(r, n, restoring, a, &c, e);
    double small = 1e-4 * r->length, *tip;
    if (s) return s;
    for (size_t j = 0; j < 3; j++)
        c.f[9 * n + 3 * j + 2] =
            small * r->youngs * c.inertia / pow(r->length, 3); /* a third of 3 E I w/L^3 */
    if ((s = wf_prism_settle(&c.p, c.f, c.x, a, e))) return s;
    tip = c.x + 9 * n;
    *ratio = (tip[2] + tip[5] + tip[8]) / 3 / small;
    return WF_OK;
}

static enum wf_status twist(const struct wf_prism_rod *r, size_t n, struct wf_arena *a, double *ratio,
                            struct wf_err *e)
{
    struct cut c;
    enum wf_status s = make(r, n, 0, a, &c, e);
    double small = 1e-3;
    if (s) return s;
    double arm = c.p.arm[0], force = small * r->youngs / 8 * c.inertia / r->length / (3 * arm);
    for (size_t j = 0; j < 3; j++) {
        const double *at = c.p.rest + 9 * n + 3 * j;
        c.f[9 * n + 3 * j + 1] = -at[2] / arm * force, c.f[9 * n + 3 * j + 2] = at[1] / arm * force;
    }
    if ((s = wf_prism_settle(&c.p, c.f, c.x, a, e))) return s;
    *ratio = atan2(-c.x[9 * n + 1], c.x[9 * n + 2]) / small;
    return WF_OK;
}

static enum wf_status sway(const struct wf_prism_rod *r, size_t n, double restoring, struct wf_arena *a,
                           double *ratio, struct wf_err *e)
{
    static const double root = 1.875104068711961; /* cos x cosh x = -1 */
    struct cut c;
    double f;
    enum wf_status s = make(r, n, restoring, a, &c, e);
    if (s || (s = wf_prism_frequency(&c.p, c.x, NULL, a, &f, e))) return s;
    double line = r->density * WF_PI * r->radius * r->radius;
    *ratio = f * WF_TURN * r->length * r->length / (root * root * sqrt(r->youngs * c.inertia / line));
    return WF_OK;
}

enum wf_status wf_prism_compare(const struct wf_prism_rod *rod, struct wf_arena *a,
                                struct wf_prism_check out[WF_PRISM_CHECKS], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < WF_PRISM_CHECKS && !s; k++) {
        struct wf_prism_check *c = &out[k];
        c->prisms = (size_t)4 << k;
        s = deflect(rod, c->prisms, 0, a, &c->bend, e);
        if (!s) s = twist(rod, c->prisms, a, &c->twist, e);
        if (!s) s = sway(rod, c->prisms, 0, a, &c->frequency, e);
        if (!s) s = sway(rod, c->prisms, rod->restoring, a, &c->quick, e);
        if (!s) s = deflect(rod, c->prisms, rod->restoring, a, &c->held, e);
        c->bend -= 1, c->twist -= 1, c->frequency -= 1;
    }
    return s;
}
