#include "solve/rod_step.h"
#include <gsl/gsl_errno.h>
#include <math.h>

enum { STEPS_MOST = 4000 };

static bool keep(struct wf_rod_integrator *g, double length)
{
    struct wf_rod_piece *p = g->piece;
    if (p->steps == p->room) {
        size_t room = p->room ? 2 * p->room : 8;
        double *more = WF_TAKE(g->arena, room, double);
        if (!more) return false;
        if (p->steps) memcpy(more, p->step, p->steps * sizeof *more);
        p->step = more, p->room = room;
    }
    p->step[p->steps++] = length;
    return true;
}

/* To where the wind is smooth, as a share of the piece. */
static double smooth(struct wf_rod_integrator *g, double sigma, const double *y)
{
    const struct wf_wind *w = g->loads->wind;
    double rate[WF_ROD_ANGLES], at[3];
    if (!w || !w->clear || g->state_system.function(sigma, y, rate, g)) return INFINITY;
    for (int k = 0; k < 3; k++) at[k] = g->place[k] + g->piece->h * y[k];
    return w->clear(w, at, rate) / g->piece->h; /* state and rate begin with place and tangent */
}

static bool choose(struct wf_rod_integrator *g, double *y)
{
    gsl_odeiv2_driver *d = g->state;
    struct wf_rod_piece *p = g->piece;
    double sigma = 0, size = p->first_step;
    p->steps = 0;
    if (gsl_odeiv2_driver_reset(d)) return false;
    for (int k = 0; sigma < 1; k++) {
        double from = sigma, to = fmin(1, sigma + smooth(g, sigma, y)), next = size;
        if (k == STEPS_MOST ||
            gsl_odeiv2_evolve_apply(d->e, d->c, d->s, d->sys, &sigma, to, &next, y) != GSL_SUCCESS ||
            !keep(g, sigma - from))
            return false;
        size = sigma < to ? next : fmax(size, next); /* one that was cut short says little about the next */
    }
    p->first_step = fmin(fmax(size, 1e-3), 1);
    return true;
}

static bool again(struct wf_rod_integrator *g, double *y)
{
    gsl_odeiv2_driver *d = g->state;
    const struct wf_rod_piece *p = g->piece;
    double sigma = 0;
    for (size_t k = 0; k < p->steps; sigma += p->step[k++])
        if (gsl_odeiv2_step_apply(d->s, sigma, p->step[k], y, d->e->yerr, NULL, NULL, d->sys) != GSL_SUCCESS)
            return false;
    return true;
}

bool wf_rod_drive(struct wf_rod_integrator *g, double *y) { return g->fixed ? again(g, y) : choose(g, y); }
