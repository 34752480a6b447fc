/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/directions.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "solve/beam_many.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/sway.h"
#include "study/verdict.h"
#include "wind/climate.h"
#include <math.h>

double wf_direction_azimuth(const struct wf_directions_request *q, double from)
{
    return wf_wind_azimuth(from, q->north);
}

double wf_direction_from(const struct wf_directions_request *q, double azimuth)
{
    return wf_wind_from(azimuth, q->north);
}

/* Data shared by the threads. */
struct work {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    struct wf_directions *out;
    const double *given;         /* speeds */
    struct wf_nodes *like;       /* of the first direction */
    const struct wf_peak **peak; /* of each direction */
    struct wf_arena *arena;      /* of each direction, for them */
};

/* The analysis in the wind of one direction; it must stay where it is. */
static void turn_wind(const struct work *w, size_t at, struct wf_analysis *an)
{
    double azimuth = wf_direction_azimuth(&w->out->request, w->out->direction[at].from);
    const double *exposed = w->out->request.speed_up;
    *an = *w->an;
    an->scenario.azimuth = azimuth;
    if (exposed) an->scenario.speed_up = exposed[at];
    an->wind.direction[0] = cos(azimuth), an->wind.direction[1] = sin(azimuth);
    an->loads.wind = &an->wind;
    an->peak = w->peak[at];
    wf_analysis_turned(an);
}

/* The sways of the tree along the wind of a direction other than the first. */
static enum wf_status sway(void *context, size_t k, struct wf_err *e)
{
    const struct work *w = context;
    struct wf_analysis an;
    turn_wind(w, k + 1, &an);
    enum wf_status s = wf_sway_turned(&an, w->peak[0], w->o, w->given, w->an->n, &w->arena[k + 1], e);
    w->peak[k + 1] = an.peak;
    return s;
}

/* The sways along all directions, which take the mesh of the first. */
static enum wf_status sways(struct work *w, size_t threads, struct wf_err *e)
{
    struct wf_analysis an;
    turn_wind(w, 0, &an);
    enum wf_status s = wf_sway_begin(&an, w->o, w->given, w->an->n, &w->arena[0], NULL, e);
    if (!s) wf_sway_reach(&an, INFINITY);
    w->peak[0] = an.peak;
    if (!s) s = wf_parallel(w->out->request.n - 1, threads, sway, w, e);
    wf_sway_end(&an);
    return s;
}

/* The given speeds in the directions of block `b`, which are solved side by side. */
static enum wf_status solve_speeds(void *context, size_t b, struct wf_err *e)
{
    const struct work *w = context;
    const size_t n = w->out->request.n, from = b * WF_BEAM_BLOCK,
                 some = n - from < WF_BEAM_BLOCK ? n - from : WF_BEAM_BLOCK;
    struct wf_analysis turned[WF_BEAM_BLOCK];
    const struct wf_analysis *an[WF_BEAM_BLOCK];
    double speed[WF_BEAM_BLOCK];
    struct wf_at_speed at[WF_BEAM_BLOCK];
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < some; k++) turn_wind(w, from + k, &turned[k]), an[k] = &turned[k];
    for (size_t i = 0; i < w->an->n && !s; i++) {
        for (size_t k = 0; k < some; k++) speed[k] = w->an->at[i].speed;
        s = wf_speed_totals_many(an, speed, some, w->o, at, e);
        for (size_t k = 0; k < some && !s; k++) {
            w->out->direction[from + k].at[i] = at[k];
            w->out->direction[from + k].gusts[i] = wf_peak_gusts(w->peak[from + k], speed[k]);
        }
    }
    return s;
}

/* Where the tree fails in wind from one direction. Returned: *an, the analysis, and *nodes, its solutions, to
 * be closed before it goes. */
static enum wf_status solve_direction(const struct work *w, size_t at, const struct wf_nodes *like,
                                      struct wf_analysis *an, struct wf_nodes **nodes, struct wf_err *e)
{
    struct wf_direction *d = &w->out->direction[at];
    turn_wind(w, at, an);
    an->at = d->at; /* of this direction: where the tree fails above the range of the search */
    an->search.seconds *= (double)w->out->request.n; /* the process's time is shared by the directions */
    *nodes = wf_nodes_open(an, like);
    return *nodes ? wf_analysis_breaks(an, w->o, *nodes, d->breaks, e)
                  : wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
}

static enum wf_status one(void *context, size_t k, struct wf_err *e)
{
    const struct work *w = context;
    struct wf_analysis an;
    struct wf_nodes *nodes = NULL;
    enum wf_status s = solve_direction(w, k + 1, w->like, &an, &nodes, e);
    wf_nodes_close(nodes);
    return s;
}

/* Share of all hours with wind from this direction whose mean times `gust` exceeds the critical speed [-]. */
static double share(const struct wf_rose *r, size_t sector, const struct wf_critical *c, double gust)
{
    switch (c->outcome) {
    case WF_CRITICAL_FOUND:
        return r->frequency[sector] * wf_rose_sector_above(r, sector, c->speed / gust);
    case WF_CRITICAL_ABOVE:
        return 0.0;
    case WF_CRITICAL_SELF_WEIGHT:
        return r->frequency[sector];
    default:
        return NAN;
    }
}

static void add_climate(struct wf_directions *out)
{
    const struct wf_rose *r = out->request.rose;
    out->hourly = out->strongest = r ? 0.0 : NAN;
    for (size_t k = 0; k < out->request.n; k++) {
        struct wf_direction *d = &out->direction[k];
        const struct wf_direction *found = d;
        const struct wf_critical *c = &wf_verdict_of(found->breaks).loss->critical;
        d->hourly = r ? share(r, k, c, 1.0) : NAN;
        d->strongest = r ? share(r, k, c, out->gust) : NAN;
        out->hourly += d->hourly, out->strongest += d->strongest;
        out->above = out->above || c->outcome == WF_CRITICAL_ABOVE;
    }
}

static enum wf_status check(const struct wf_directions_request *q, double *gust, struct wf_err *e)
{
    *gust = NAN;
    if (!(q->n >= 2 && q->n <= 360)) return wf_fail(e, WF_EUSAGE, "%zu directions are outside 2..360", q->n);
    if (q->rose && q->rose->sectors != q->n)
        return wf_fail(e, WF_EUSAGE,
                       "the climate has %zu directions, %zu are specified; omit them to use the climate's",
                       q->rose->sectors, q->n);
    return q->rose ? wf_wind_average(q->law, NULL, 1.0, 3600.0, WF_MEAN_TIME, gust, e) : WF_OK;
}

enum wf_status wf_directions_run(const struct wf_analysis *an, const struct wf_solve_options *o,
                                 const struct wf_directions_request *q, struct wf_arena *a,
                                 struct wf_directions *out, struct wf_err *e)
{
    *out = (struct wf_directions){ .request = *q };
    enum wf_status s = check(q, &out->gust, e);
    if (s) return s;
    struct wf_solve_options alone = *o;
    alone.threads = 1; /* the parallel loop is over directions */
    double *given = WF_TAKE(a, an->n, double);
    struct work w = { .an = an,
                      .o = &alone,
                      .out = out,
                      .given = given,
                      .peak = WF_TAKE(a, q->n, const struct wf_peak *),
                      .arena = WF_TAKE(a, q->n, struct wf_arena) };
    struct wf_analysis first; /* outlives the nodes that the other directions take */
    struct wf_at_speed *at = WF_TAKE(a, q->n * an->n, struct wf_at_speed);
    double *gusts = WF_TAKE(a, q->n * an->n, double);
    out->direction = WF_TAKE(a, q->n, struct wf_direction);
    if (!out->direction || !at || !gusts || !w.peak || !w.arena || !given)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu directions", q->n);
    for (size_t i = 0; i < an->n; i++) given[i] = an->at[i].speed;
    for (size_t k = 0; k < q->n; k++) {
        out->direction[k].from = WF_TURN * (double)k / (double)q->n;
        out->direction[k].at = at + k * an->n;
        out->direction[k].gusts = gusts + k * an->n;
    }
    wf_stage_begin(q->n * (an->n + WF_SEARCH_SOLUTIONS), true, "%zu directions", q->n);
    s = sways(&w, o->threads, e);
    if (!s) s = wf_parallel((q->n + WF_BEAM_BLOCK - 1) / WF_BEAM_BLOCK, o->threads, solve_speeds, &w, e);
    if (!s) s = solve_direction(&w, 0, NULL, &first, &w.like, e); /* the others take its meshes */
    if (!s) s = wf_parallel(q->n - 1, o->threads, one, &w, e);
    wf_nodes_close(w.like);
    for (size_t k = 0; k < q->n; k++) wf_arena_free(&w.arena[k]);
    if (!s) add_climate(out);
    return s;
}
