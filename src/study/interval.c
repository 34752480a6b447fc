/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/interval.h"
#include "base/arena.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "fail/crossing.h"
#include "study/node.h"
#include "study/peak.h"
#include "study/sway.h"
#include "study/verdict.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double low_share = 0.05, high_share = 0.95;

/* ---- One sample ---- */

struct sample {
    bool stands;
    double critical; /* [m/s]; 0: lost in still air; INFINITY: not up to the end of the search */
    enum wf_criterion_id by;
    double *safety; /* at the given winds */
    double *wanted; /* the same with the criteria for which practice wants more than 1 */
};

struct work {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    const struct wf_variation *v;
    double near;                 /* critical wind of the tree as given; 0: not found [m/s] */
    const struct wf_nodes *like; /* of the middle sample; NULL: this is it */
    const double *share;         /* n x v->n */
    struct sample *sample;
};

/* A sample while it is solved. */
struct solved {
    struct wf_arena arena;
    struct wf_varied_copy copy;
    struct wf_analysis an;
    struct wf_nodes *nodes;
};

static void close_sample(struct solved *s)
{
    wf_nodes_close(s->nodes);
    wf_arena_free(&s->arena);
}

/* Grow the tree and let it stand and sway, with the factors of the sample. */
static enum wf_status set_up(const struct work *w, const double *share, struct solved *s, struct wf_err *e)
{
    struct wf_diag unsaid = { .arena = &s->arena, .mute = true };
    struct wf_peak *peak;
    enum wf_status status = wf_variation_apply(w->v, w->an, share, &s->arena, &s->copy, e);
    if (status) return status;
    s->an = (struct wf_analysis){ .species = s->copy.species,
                                  .model = s->copy.model,
                                  .misread = &s->copy.misread,
                                  .solver = w->an->solver,
                                  .scenario = w->an->scenario,
                                  .search = { .speed_max = w->an->search.speed_max, .seconds = INFINITY } };
    double about = w->near > 0.0 ? w->near : 0.5 * w->an->search.speed_max;
    status = wf_analysis_set_up(&s->an, w->o, &s->arena, &unsaid, e);
    if (!status) status = wf_sway_alike(&s->an, w->an, about, &s->arena, &peak, e);
    if (status) return status;
    peak->damping *= s->copy.damping;
    peak->branches = false; /* stem and root are of the whole tree's state */
    s->an.loads.wind_scale *= s->copy.load;
    if (wf_interval_rooted(&s->an))
        s->an.tree.anchorage *=
            wf_anchorage_varied(s->an.anchorage, s->copy.anchorage) / s->an.anchorage->moment;
    return WF_OK;
}

/* The criterion that is nearest to its limit, of alike ones the first, and the largest utilisation. Given:
 * the loss of the tree alone, or also what practice wants more than 1 of? */
static enum wf_criterion_id nearest_of(const struct wf_at_speed *at, bool wanted, double *utilisation)
{
    enum wf_criterion_id by = WF_BREAKAGE;
    *utilisation = 0.0;
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *x = &wf_criteria[c];
        double own = 1.0 / at->worst[c][WF_SCOPE_STEM].safety;
        bool counts = x->loses_tree || (wanted && x->required > 0.0);
        if (!counts) continue;
        if (own > (1 + WF_VERDICT_SAME) * *utilisation) by = (enum wf_criterion_id)c;
        *utilisation = fmax(*utilisation, own);
    }
    return by;
}

static enum wf_criterion_id nearest(const struct wf_at_speed *at, double *utilisation)
{
    return nearest_of(at, false, utilisation);
}

/* ---- The critical wind of a sample ---- */

/* What is solved: the lowest wind at which the tree is lost, and the highest below at which it is not. */
struct bracket {
    const struct wf_node *low, *high; /* NULL: none */
};

static bool is_lost(const struct wf_node *node, double *utilisation)
{
    (void)nearest(&node->at, utilisation);
    return node->at.status || !(*utilisation < 1.0);
}

static struct bracket bracket_of(const struct wf_nodes *nodes)
{
    struct bracket b = { 0 };
    double utilisation;
    for (size_t i = 0; i < wf_nodes_count(nodes); i++) {
        const struct wf_node *node = wf_nodes_at(nodes, i);
        if (is_lost(node, &utilisation) && (!b.high || node->at.speed < b.high->at.speed)) b.high = node;
    }
    for (size_t i = 0; i < wf_nodes_count(nodes); i++) {
        const struct wf_node *node = wf_nodes_at(nodes, i);
        if (b.high && node->at.speed >= b.high->at.speed) continue;
        if (!is_lost(node, &utilisation) && (!b.low || node->at.speed > b.low->at.speed)) b.low = node;
    }
    return b;
}

/* Where the utilisation, a power of the speed by its slope at a node, reaches 1; NAN: it has none, or the
 * wind has so small a part in it, beside weight, that the power says nothing of other winds. */
static double by_slope(const struct wf_node *node)
{
    double utilisation;
    if (!node || node->at.status || !(node->at.speed > 0.0)) return NAN;
    int c = (int)nearest(&node->at, &utilisation);
    double slope = node->slope[WF_TOTAL_UTILISATION + c * WF_SCOPES + WF_SCOPE_STEM];
    double power = node->sloped ? node->at.speed * slope / utilisation : (double)NAN;
    if (!(power > 0.4)) return NAN;
    return node->at.speed * pow(utilisation, -1.0 / fmin(power, 4.0));
}

static double size_of_step(const struct wf_node *node)
{
    double at = by_slope(node);
    return isnan(at) ? (double)INFINITY : fabs(log(at / node->at.speed));
}

/* Does the slope of the nearer end lead to a speed in the bracket? Returned: that speed; *step, the logarithm
 * of its ratio to the solved one. */
static double guess(const struct bracket *b, double *step)
{
    double low = size_of_step(b->low), high = size_of_step(b->high);
    *step = fmin(low, high);
    double at = by_slope(low < high ? b->low : b->high);
    if (b->low && !(at > b->low->at.speed)) return NAN;
    return b->high && !(at < b->high->at.speed) ? (double)NAN : at;
}

/* The next speed to be solved. */
static double next_speed(const struct bracket *b, double at, double highest)
{
    const double most = 1.6, margin = 0.02; /* times the last speed; of the bracket's width */
    if (!b->high) {
        double last = b->low->at.speed, step = isnan(at) ? most * last : fmin(at, most * last);
        return fmin(fmax(step, last > 0.0 ? 1.02 * last : 0.1 * highest), highest);
    }
    double from = b->low ? b->low->at.speed : 0.0, to = b->high->at.speed, edge = margin * (to - from);
    return isnan(at) ? 0.5 * (from + to) : fmin(fmax(at, from + edge), to - edge);
}

/* Is the critical wind known? Returned: it, or the best guess. */
static bool settled(const struct bracket *b, double highest, double *critical)
{
    const double near = 0.03, width = 2e-3;
    double step, at = guess(b, &step), low = b->low ? b->low->at.speed : 0.0;
    double high = b->high ? b->high->at.speed : (double)INFINITY;
    *critical = at;
    if (low >= highest || (step <= near && at > highest)) *critical = INFINITY;
    if (b->high && high - low <= width * high)
        *critical = low; /* there is no slope: no equilibrium above it */
    return *critical == at ? step <= near : !isnan(*critical);
}

/* The lowest wind at which the tree is lost, from what is solved and further winds. */
static enum wf_status find_critical(const struct work *w, struct solved *s, struct sample *out,
                                    struct wf_err *e)
{
    /* of a tree that its weight nearly overturns utilisation hardly changes with the wind, and slopes lead to
       small steps: still air is then looked at, and brackets are halved */
    enum { MOST = 40, SLOW = 8, HALVES = 16 };
    const double still = 0.5; /* [m/s] */
    const double highest = s->an.search.speed_max;
    const struct wf_node *node;
    double utilisation;
    for (int k = 0; k < MOST; k++) {
        struct bracket b = bracket_of(s->nodes);
        bool known = settled(&b, highest, &out->critical);
        if (b.high) out->by = nearest(&b.high->at, &utilisation);
        if (known) return WF_OK;
        bool low = b.high && !b.low && (b.high->at.speed < still || k == SLOW);
        double next = next_speed(&b, k < HALVES ? out->critical : (double)NAN, highest);
        enum wf_status status = wf_nodes_solve(s->nodes, w->o, low ? 0.0 : next, &node, e);
        if (status) return status;
    }
    return wf_fail(e, WF_EINTERNAL, "the critical wind of a sample was not found");
}

/* ---- Safety at the given winds ---- */

/* Logarithms of utilisation and speed, and the slope between them. Returned: false where they are not known.
 */
static bool logarithms(const struct wf_node *node, bool wanted, double *x, double *y, double *slope)
{
    double utilisation;
    int c = (int)nearest_of(&node->at, wanted, &utilisation);
    *slope = node->slope[WF_TOTAL_UTILISATION + c * WF_SCOPES + WF_SCOPE_STEM] * node->at.speed / utilisation;
    *x = log(node->at.speed), *y = log(utilisation);
    return !node->at.status && node->sloped && isfinite(*x) && isfinite(*y) && isfinite(*slope);
}

/* Utilisation between two solutions that are not too far apart, by a cubic of the logarithms. */
static bool between(const struct wf_nodes *nodes, double speed, bool wanted, double *utilisation)
{
    const double apart = 4.0; /* ratio of the speeds */
    const struct wf_node *low = NULL, *high = NULL;
    double x[2], y[2], slope[2];
    for (size_t i = 0; i < wf_nodes_count(nodes); i++) {
        const struct wf_node *node = wf_nodes_at(nodes, i);
        if (node->at.speed < speed && (!low || node->at.speed > low->at.speed)) low = node;
        if (node->at.speed > speed && (!high || node->at.speed < high->at.speed)) high = node;
    }
    if (!low || !high || !(high->at.speed <= apart * low->at.speed)) return false;
    if (!logarithms(low, wanted, &x[0], &y[0], &slope[0])) return false;
    if (!logarithms(high, wanted, &x[1], &y[1], &slope[1])) return false;
    *utilisation = exp(wf_crossing_cubic(x[0], x[1], y[0], y[1], slope[0], slope[1], log(speed)));
    return true;
}

static enum wf_status solve_safety(const struct work *w, struct solved *s, size_t wind,
                                   const struct sample *out, struct wf_err *e)
{
    const struct wf_node *node;
    double utilisation;
    enum wf_status status = wf_nodes_solve(s->nodes, w->o, w->an->at[wind].speed, &node, e);
    if (status) return status;
    (void)nearest(&node->at, &utilisation);
    out->safety[wind] = node->at.status ? 0.0 : 1.0 / utilisation;
    (void)nearest_of(&node->at, true, &utilisation);
    out->wanted[wind] = node->at.status ? 0.0 : 1.0 / utilisation;
    return WF_OK;
}

/* Given winds are solved where the solutions so far do not tell the safety. */
static enum wf_status find_safety(const struct work *w, struct solved *s, const struct sample *out,
                                  struct wf_err *e)
{
    enum wf_status status = WF_OK;
    for (size_t k = 0; k < w->an->n && !status; k++) {
        double lost, wanted, speed = w->an->at[k].speed;
        bool known = !wf_nodes_find(s->nodes, speed, w->o->mesh_tolerance) &&
                     between(s->nodes, speed, false, &lost) && between(s->nodes, speed, true, &wanted);
        if (known)
            out->safety[k] = 1.0 / lost, out->wanted[k] = 1.0 / wanted;
        else
            status = solve_safety(w, s, k, out, e);
    }
    return status;
}

/* Solve near the critical wind of the tree and at the lowest given wind, then where it is found. The middle
 * sample ends near it, where the others begin. */
static enum wf_status search(const struct work *w, struct solved *s, struct sample *out, struct wf_err *e)
{
    const struct wf_node *node;
    double first = w->near > 0.0 ? w->near : s->an.search.speed_max;
    enum wf_status status = WF_OK;
    if (w->like) status = wf_nodes_solve(s->nodes, w->o, first, &node, e);
    if (!status && w->an->n) status = solve_safety(w, s, 0, out, e);
    if (!status) status = find_critical(w, s, out, e);
    if (!status) status = find_safety(w, s, out, e);
    return status || w->like ? status : wf_nodes_solve(s->nodes, w->o, first, &node, e);
}

static enum wf_status solve_sample(const struct work *w, const double *share, struct solved *s,
                                   struct sample *out, struct wf_err *e)
{
    struct wf_err why = { 0 };
    *out = (struct sample){ .safety = out->safety, .wanted = out->wanted };
    enum wf_status status = set_up(w, share, s, &why);
    if (status == WF_EUNSTABLE || status == WF_ENOCONV) return WF_OK; /* it does not stand */
    if (status) return wf_fail(e, status, "%s", why.text);
    s->nodes = w->like ? wf_nodes_open_kin(&s->an, w->like) : wf_nodes_open(&s->an, NULL);
    if (!s->nodes) return wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
    out->stands = true;
    return search(w, s, out, e);
}

static enum wf_status one(void *context, size_t k, struct wf_err *e)
{
    const struct work *w = context;
    struct solved s = { .nodes = NULL };
    enum wf_status status = solve_sample(w, w->share + k * w->v->n, &s, &w->sample[k], e);
    close_sample(&s);
    wf_stage_step(1);
    return status;
}

/* ---- All samples ---- */

/* Shares of all solutions: two of each value that varies, alone; then the samples. */
static enum wf_status draw_shares(const struct wf_variation *v, const struct wf_interval_request *q,
                                  struct wf_arena *scratch, double **out, struct wf_err *e)
{
    size_t alone = 2 * v->n;
    double *ranks = WF_TAKE(scratch, v->n * v->n, double);
    *out = WF_TAKE(scratch, (alone + q->samples) * v->n, double);
    if (!ranks || !*out) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu samples", q->samples);
    for (size_t k = 0; k < alone; k++)
        for (size_t i = 0; i < v->n; i++)
            (*out)[k * v->n + i] = k / 2 != i ? 0.5 : k % 2 ? high_share : low_share;
    wf_variation_ranks(v, ranks);
    return wf_latin(q->seed, q->samples, v->n, ranks, *out + alone * v->n, e);
}

static struct sample *take_samples(size_t n, size_t winds, struct wf_arena *a)
{
    struct sample *out = WF_TAKE(a, n, struct sample);
    double *safety = WF_TAKE(a, 2 * n * winds, double);
    for (size_t k = 0; out && safety && k < n; k++) {
        out[k].safety = safety + 2 * k * winds;
        out[k].wanted = out[k].safety + winds;
    }
    return safety ? out : NULL;
}

/* Is the middle sample, on its mesh, the tree as it was analysed? */
static bool same_as_given(const struct work *w, const struct sample *middle)
{
    const double close = 0.01;
    double asked, found, utilisation;
    if (w->near > 0.0) return fabs(middle->critical / w->near - 1.0) <= close;
    if (!w->an->n) return false;
    (void)nearest(&w->an->at[w->an->n - 1], &utilisation);
    asked = w->an->at[w->an->n - 1].status ? 0.0 : 1.0 / utilisation;
    found = middle->safety[w->an->n - 1];
    return asked == found || fabs(found / asked - 1.0) <= close;
}

/* Solve the middle sample: with one element a segment, and where that changes the answer, on the coarse mesh
 * of searches. */
static enum wf_status solve_middle(struct work *w, struct wf_solve_options *o, const double *half,
                                   struct solved *s, struct sample *out, struct wf_err *e)
{
    enum wf_status status;
    const double given = o->mesh_tolerance;
    *o = wf_nodes_quick(o);
    o->tolerance = fmax(o->tolerance, 1e-4); /* its square is left */
    o->mesh_tolerance = 0.0;
    status = solve_sample(w, half, s, out, e);
    if (status || same_as_given(w, out) || given == 0.0) return status;
    close_sample(s);
    *s = (struct solved){ .nodes = NULL };
    o->mesh_tolerance = fmax(given, 1e-3);
    return solve_sample(w, half, s, out, e);
}

/* Solve the middle sample, then all others on its mesh. */
static enum wf_status solve_all(struct work *w, struct wf_solve_options *o, size_t n, size_t threads,
                                struct wf_interval *out, struct wf_err *e)
{
    struct solved middle = { .nodes = NULL };
    struct wf_arena scratch = { 0 };
    double *half = WF_TAKE(&scratch, w->v->n, double);
    struct sample *first = take_samples(1, w->an->n, &scratch);
    enum wf_status s = WF_OK;
    for (size_t i = 0; half && i < w->v->n; i++) half[i] = 0.5;
    if (!half || !first) s = wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
    if (!s) s = solve_middle(w, o, half, &middle, first, e);
    if (!s && !first->stands) s = wf_fail(e, WF_EUNSTABLE, "the tree does not stand");
    if (!s) {
        w->like = middle.nodes;
        out->middle = first->critical;
        s = wf_parallel_abreast(n, threads, one, w, e);
    }
    close_sample(&middle);
    wf_arena_free(&scratch);
    return s;
}

/* ---- What they say ---- */

static double order(double *value, size_t n, double share)
{
    qsort(value, n, sizeof *value, wf_ascending);
    return wf_order_statistic(value, n, share);
}

static enum wf_status take_results(const struct wf_analysis *an, struct wf_interval *out, struct wf_arena *a,
                                   struct wf_err *e)
{
    out->winds = an->n;
    out->critical = WF_TAKE(a, out->request.samples, double);
    out->arm = WF_TAKE(a, out->variation.n, struct wf_interval_arm);
    out->at = WF_TAKE(a, an->n, struct wf_interval_at);
    out->point = WF_TAKE(a, WF_INTERVAL_POINTS, struct wf_interval_point);
    if (out->critical && out->arm && out->point && (out->at || !an->n)) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for %zu samples", out->request.samples);
}

static void read_arms(const struct sample *sample, struct wf_interval *out)
{
    for (size_t i = 0; i < out->variation.n; i++) {
        const struct sample *s = sample + 2 * i;
        out->arm[i] =
            (struct wf_interval_arm){ s[0].stands ? s[0].critical : NAN, s[1].stands ? s[1].critical : NAN };
    }
}

static void read_safety(const struct wf_analysis *an, const struct sample *sample, double *column,
                        struct wf_interval *out)
{
    for (size_t k = 0; k < an->n; k++) {
        size_t n = 0;
        for (size_t i = 0; i < out->request.samples; i++)
            if (sample[i].stands) column[n++] = sample[i].safety[k];
        out->at[k].speed = an->at[k].speed;
        out->at[k].low = order(column, n, low_share);
        out->at[k].high = order(column, n, high_share);
        n = 0;
        for (size_t i = 0; i < out->request.samples; i++)
            if (sample[i].stands) column[n++] = sample[i].wanted[k];
        out->at[k].wanted_low = order(column, n, low_share);
        out->at[k].wanted_high = order(column, n, high_share);
    }
}

/* Critical winds in ascending order, and the law of those above 0. */
static void read_critical(const struct sample *sample, struct wf_interval *out)
{
    for (size_t i = 0; i < out->request.samples; i++) {
        if (!sample[i].stands) continue;
        out->critical[out->n++] = sample[i].critical;
        out->still += !(sample[i].critical > 0.0);
        if (isfinite(sample[i].critical)) out->lost_by[sample[i].by]++;
    }
    out->left_out = out->request.samples - out->n;
    out->low = order(out->critical, out->n, low_share);
    out->high = order(out->critical, out->n, high_share);
    out->fit = wf_lognormal_fit(out->critical + out->still, out->n - out->still, out->searched_to);
}

/* The curve up to the end of the search, or where all samples are lost before, a little further. */
static void read_curve(struct wf_interval *out)
{
    double end = out->searched_to, last = out->critical[out->n - 1];
    if (isfinite(last)) end = fmin(end, 1.1 * last);
    for (size_t k = 0, hits = 0; k < WF_INTERVAL_POINTS; k++) {
        struct wf_interval_point *p = &out->point[k];
        p->speed = end * (double)k / (WF_INTERVAL_POINTS - 1);
        while (hits < out->n && out->critical[hits] <= p->speed) hits++;
        double still = (double)out->still / (double)out->n;
        p->share = (double)hits / (double)out->n;
        wf_binomial_band(hits, out->n, WF_SPREAD_Z, &p->below, &p->above);
        p->fit = isnan(out->fit.median) ? (double)NAN
                                        : still + (1.0 - still) * wf_lognormal_share(&out->fit, p->speed);
    }
}

static enum wf_status read_samples(const struct wf_analysis *an, const struct sample *sample,
                                   struct wf_arena *a, struct wf_interval *out, struct wf_err *e)
{
    enum wf_status s = take_results(an, out, a, e);
    double *column = WF_TAKE(a, out->request.samples, double);
    if (s) return s;
    if (!column) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu samples", out->request.samples);
    read_arms(sample, out);
    sample += 2 * out->variation.n;
    read_critical(sample, out);
    if (2 * out->n < out->request.samples)
        return wf_fail(e, WF_EINPUT,
                       "%zu of %zu samples would not stand under their own weight: the ranges of the species "
                       "table, or the sizes of the tree, are in doubt",
                       out->left_out, out->request.samples);
    read_safety(an, sample, column, out);
    read_curve(out);
    return WF_OK;
}

/* ---- The run ---- */

/* Why intervals cannot be computed; NULL: they can. */
static const char *refused_by(const struct wf_analysis *an)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    if (!wf_nodes_tracked(an))
        return an->scenario.shelter ? "the wind inside the crown is reduced by the crown (--shelter)"
                                    : "the solver gives no slopes; 'beam' does";
    if (v.loss->critical.outcome == WF_CRITICAL_NO_STRENGTH) return "no strength is known";
    return v.loss->critical.outcome == WF_CRITICAL_INTERRUPTED ? "the run was interrupted" : NULL;
}

enum wf_status wf_interval_check(const struct wf_interval_request *q, struct wf_err *e)
{
    if (!q->samples || (q->samples >= WF_INTERVAL_LEAST && q->samples <= WF_INTERVAL_MOST)) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "%zu samples: 0, none, or %d to %d", q->samples, WF_INTERVAL_LEAST,
                   WF_INTERVAL_MOST);
}

/* Is an interval to be computed? A warning says where none is. */
static bool due(const struct wf_analysis *an, const struct wf_interval_request *q, bool specified,
                struct wf_diag *d)
{
    const char *refused = refused_by(an);
    if (!q->samples) return false;
    if (refused && wf_verdict_of(an->breaks).loss->critical.outcome != WF_CRITICAL_NO_STRENGTH)
        wf_diag_warn(d, "no-interval", "%s: how sure the critical wind is was not computed: %s",
                     an->species->name, refused);
    if (refused) return false;
    if (specified || an->tree.n * q->samples <= WF_INTERVAL_UNASKED) return true;
    wf_diag_warn(d, "no-interval",
                 "%s: how sure the critical wind is was not computed, for %zu segments take long; --samples "
                 "%zu computes it, --samples %zu sooner and more roughly",
                 an->species->name, an->tree.n, q->samples, (size_t)WF_INTERVAL_FEW);
    return false;
}

enum wf_status wf_interval_run(const struct wf_analysis *an, const struct wf_solve_options *o,
                               const struct wf_interval_request *q, struct wf_arena *a,
                               struct wf_interval *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_solve_options alone = *o;
    struct wf_analysis whole = *an; /* with the sways of winds in which samples may be lost */
    double *share = NULL, near = wf_verdict_of(an->breaks).loss->critical.speed;
    *out = (struct wf_interval){ .request = *q, .searched_to = an->search.speed_max };
    const char *refused = refused_by(an);
    enum wf_status s = wf_interval_check(q, e);
    if (!s && (refused || !q->samples))
        s = wf_fail(e, WF_EUSAGE, "no interval: %s", refused ? refused : "no samples");
    if (!s) s = wf_variation_of(an, &out->variation, e);
    if (!s) s = wf_sway_complete(&whole, o, &scratch, e);
    if (!s) s = draw_shares(&out->variation, q, &scratch, &share, e);
    size_t n = 2 * out->variation.n + q->samples;
    struct sample *sample = s ? NULL : take_samples(n, an->n, &scratch);
    if (!s && !sample) s = wf_fail(e, WF_ENOMEM, "not enough memory for %zu samples", q->samples);
    alone.threads = 1; /* the parallel loop is over samples */
    struct work w = { .an = &whole,
                      .o = &alone,
                      .v = &out->variation,
                      .near = isfinite(near) ? near : 0.0,
                      .share = share,
                      .sample = sample };
    wf_stage_begin(n, false, "%s: interval", an->species->name);
    if (!s) s = solve_all(&w, &alone, n, q->threads, out, e);
    if (!s) s = read_samples(an, sample, a, out, e);
    wf_arena_free(&scratch);
    return s;
}

/* ---- In words ---- */

static void end_text(const struct wf_interval *i, double wind, int decimals, char *text, size_t size)
{
    if (isnan(wind))
        (void)snprintf(text, size, "not standing");
    else if (isinf(wind))
        (void)snprintf(text, size, "above %.4g", i->searched_to);
    else
        (void)snprintf(text, size, "%.*f", decimals, wind);
}

bool wf_interval_arm_text(const struct wf_interval *i, size_t k, char *text, size_t size)
{
    enum { DECIMALS = 2 };
    const struct wf_interval_arm *arm = &i->arm[k];
    const bool turned = isnan(arm->at_high) || arm->at_high < arm->at_low;
    const double low = turned ? arm->at_high : arm->at_low, high = turned ? arm->at_low : arm->at_high;
    char from[40], to[40];
    for (int decimals = 0; decimals <= DECIMALS; decimals++) {
        end_text(i, low, decimals, from, sizeof from);
        end_text(i, high, decimals, to, sizeof to);
        (void)snprintf(text, size, "%s to %s", from, to);
        if (strcmp(from, to)) return true;
    }
    return false;
}

static bool moved(double from, double to) { return isnan(to) || fabs(to / from - 1.0) > 0.2; }

void wf_interval_warn(const struct wf_analysis *an, const struct wf_interval *i, struct wf_diag *d)
{
    char text[1000] = "", range[80];
    for (size_t k = 0; k < i->variation.n && strlen(text) < sizeof text - 160; k++) {
        const struct wf_varied *v = &i->variation.varied[k];
        const struct wf_interval_arm *arm = &i->arm[k];
        bool doubted = v->standing == WF_ASSUMED || v->standing == WF_BORROWED;
        bool decides = doubted && (moved(i->middle, arm->at_low) || moved(i->middle, arm->at_high));
        size_t used = strlen(text);
        if (decides && wf_interval_arm_text(i, k, range, sizeof range))
            (void)snprintf(text + used, sizeof text - used, "%s%s%s (%s): %s m/s", used ? "; " : "",
                           wf_varied_prefix(v), v->name, wf_standing_text(v->standing), range);
    }
    if (*text)
        wf_diag_warn(d, "value-decides",
                     "%s: values that were not measured on this species move the critical wind by more than "
                     "20 %%, each alone within its range: %s. A measured value narrows the interval",
                     an->species->name, text);
    if (i->left_out)
        wf_diag_warn(d, "samples-left-out",
                     "%s: %zu of %zu samples of the interval would not stand under their own weight and were "
                     "left out, because the tree stands",
                     an->species->name, i->left_out, i->request.samples);
}

bool wf_interval_rooted(const struct wf_analysis *an) { return an->tree.anchorage > 0.0; }

int wf_interval_decimals(double low, double high)
{
    double width = isfinite(high) ? high - low : low;
    return width >= 5.0 ? 0 : width >= 0.5 ? 1 : 2;
}

enum wf_status wf_interval_take(struct wf_analysis *an, const struct wf_solve_options *o,
                                const struct wf_interval_request *q, bool specified, struct wf_arena *a,
                                struct wf_err *e)
{
    struct wf_interval *out = WF_TAKE(a, 1, struct wf_interval);
    struct wf_err why = { 0 };
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for an interval");
    if (wf_interrupted() || !due(an, q, specified, an->diag)) return WF_OK;
    enum wf_status s = wf_interval_run(an, o, q, a, out, &why);
    if (s == WF_EINTERRUPTED) {
        wf_diag_warn(an->diag, "interrupted", "interrupted before the interval was computed");
        return WF_OK;
    }
    if (s) return wf_fail(e, s, "%s", why.text);
    an->interval = out;
    wf_interval_warn(an, out, an->diag);
    return WF_OK;
}
