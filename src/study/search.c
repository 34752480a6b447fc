/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The searches of an analysis: critical wind speeds, by criterion and part of the tree, and the curves;
 * declared in analysis.h. */
#include "base/interrupt.h"
#include "base/num.h"
#include "base/parallel.h"
#include "data/species.h"
#include "study/analysis.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Large trees are solved one at a time: answers do not depend on the number of threads. */
enum { SOLUTIONS_BYTES = 1 << 30 };

static size_t threads_for(const struct wf_analysis *an, const struct wf_solve_options *o)
{
    size_t threads = wf_parallel_threads(o->threads), most = SOLUTIONS_BYTES / WF_SOLUTION_BYTES / an->tree.n;
    return threads < most ? threads : most ? most : 1;
}

/* ---- The critical wind speeds, by criterion and part of the tree ---- */

/* Results at speeds already solved: all searches use the same speeds at first, and the curves pass through
 * them. */
enum { KNOWN_MAX = 240 };
struct wf_known {
    double deadline; /* of the process's time [s] */
    bool over;       /* the deadline ended a search */
    int n;
    double tolerance[KNOWN_MAX]; /* of the mesh */
    bool used[KNOWN_MAX];        /* by a search; others were solved ahead, as many as there are threads */
    struct wf_at_speed at[KNOWN_MAX];
};

struct search {
    const struct wf_analysis *an;
    const struct wf_solve_options *o;
    enum wf_criterion_id criterion;
    enum wf_scope scope;
    struct wf_known *known;
    double speed_max; /* [m/s] */
};

static double processor_seconds(void)
{
    struct timespec t;
    return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) ? 0.0 : (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int recall(const struct search *q, double speed)
{
    const struct wf_known *k = q->known;
    for (int i = 0; i < k->n; i++)
        if (k->at[i].speed == speed && k->tolerance[i] == q->o->mesh_tolerance) return i;
    return -1;
}

static void keep(struct wf_known *k, double tolerance, bool used, const struct wf_at_speed *at)
{
    if (k->n == KNOWN_MAX) return;
    k->tolerance[k->n] = tolerance;
    k->used[k->n] = used;
    k->at[k->n++] = *at;
}

static enum wf_status search_totals(const struct search *q, double speed, struct wf_at_speed *at,
                                    struct wf_err *e)
{
    int known = recall(q, speed);
    if (known >= 0) {
        q->known->used[known] = true;
        *at = q->known->at[known];
        return WF_OK;
    }
    if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
    q->known->over = q->known->over || processor_seconds() > q->known->deadline;
    /* any status that is no answer about the tree ends the search; find_break then looks at `over` */
    if (q->known->over) return wf_fail(e, WF_EINTERNAL, "the time of the search is used up");
    enum wf_status s = wf_speed_totals(q->an, q->o, speed, at, e);
    if (!s) keep(q->known, q->o->mesh_tolerance, true, at);
    return s;
}

static double safety(const struct search *q, const struct wf_at_speed *at)
{
    return at->worst[q->criterion][q->scope].safety;
}

static bool falls(const struct search *q, const struct wf_at_speed *at)
{
    return at->status || !(safety(q, at) > 1.0);
}

/* Load over resistance at the worst section. */
static enum wf_status utilisation(void *ctx, double speed, double *value, struct wf_err *e)
{
    const struct search *s = ctx;
    struct wf_at_speed at;
    enum wf_status status = search_totals(s, speed, &at, e);
    if (status) return status;
    if (at.status) return wf_fail(e, at.status, "no equilibrium at %.6g m/s", speed);
    *value = 1.0 / safety(s, &at);
    return WF_OK;
}

/* Refine the critical speed found on a coarse mesh to the mesh tolerance of the options, by secant steps with
 * the coarse mesh's slope, which differs little. Returned: c->speed, and *at, the totals at it. */
static enum wf_status polish(const struct search *search, struct wf_critical *c, struct wf_at_speed *at,
                             struct wf_err *e)
{
    const double near = 3e-6; /* of the resistance */
    for (int k = 0;; k++) {
        enum wf_status s = search_totals(search, c->speed, at, e);
        c->evaluations++;
        if (s || at->status) return s;
        double excess = 1.0 / safety(search, at) - 1.0;
        double step = excess / c->gradient;
        if (fabs(excess) <= near || k == 4 || !(fabs(step) < 0.02 * c->speed)) return WF_OK;
        c->speed -= step;
    }
}

/* A batch of speeds solved in parallel. */
struct batch {
    const struct search *search;
    double speed[WF_CRITICAL_RUNGS_MAX + 1];
    struct wf_at_speed at[WF_CRITICAL_RUNGS_MAX + 1];
    bool kept[WF_CRITICAL_RUNGS_MAX + 1];
};

static enum wf_status rung(void *context, size_t k, struct wf_err *e)
{
    struct batch *b = context;
    b->kept[k] = false;
    if (processor_seconds() > b->search->known->deadline) return WF_OK;
    b->kept[k] = !wf_speed_totals(b->search->an, b->search->o, b->speed[k], &b->at[k], e);
    return WF_OK;
}

/* Solve the speeds that wf_critical_search will step through, as many at a time as there are threads, until
 * the tree fails at one, and store the results. Errors are ignored: wf_critical_search solves that speed
 * again and reports them. */
static enum wf_status climb(const struct search *q, struct wf_err *e)
{
    struct wf_known *known = q->known;
    size_t threads = threads_for(q->an, q->o);
    struct wf_arena scratch = { 0 };
    struct batch *b = WF_TAKE(&scratch, 1, struct batch);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for the search of the critical speed");
    b->search = q;
    bool fell = threads < 2;
    for (int k = 0, rungs = wf_critical_rungs(q->speed_max); k <= rungs && !fell;) {
        size_t n = 0;
        for (; k <= rungs && n < threads; k++) {
            double speed = wf_critical_rung(q->speed_max, k);
            int at = recall(q, speed);
            if (at >= 0)
                fell = fell || falls(q, &known->at[at]);
            else
                b->speed[n++] = speed;
        }
        enum wf_status s = wf_parallel(n, threads, rung, b, e);
        if (s) {
            wf_arena_free(&scratch);
            return s;
        }
        for (size_t i = 0; i < n; i++) {
            fell = fell || !b->kept[i] || falls(q, &b->at[i]);
            if (b->kept[i]) keep(known, q->o->mesh_tolerance, false, &b->at[i]);
        }
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

static void place_at(const struct wf_tree *t, const struct wf_worst *w, struct wf_break *out)
{
    out->row = w->row;
    out->height = t->z0[w->row] + w->place * (t->z1[w->row] - t->z0[w->row]);
}

/* The highest speed to be searched: the range given, or the lowest given speed above it at which this part of
 * the tree failed. */
static double search_top(const struct search *q)
{
    double top = INFINITY;
    for (size_t k = 0; q->an->at && k < q->an->n; k++) {
        const struct wf_at_speed *at = &q->an->at[k];
        if (at->speed <= q->an->search.speed_max && falls(q, at)) return q->an->search.speed_max;
        if (falls(q, at)) top = fmin(top, at->speed);
    }
    return isfinite(top) ? top : q->an->search.speed_max;
}

/* What is known of a search that was ended: between which speeds the tree fails. */
static void bracket(const struct search *q, struct wf_critical *c)
{
    *c = (struct wf_critical){ WF_CRITICAL_UNSEARCHED, NAN, 0.0, q->speed_max, NAN, 0 };
    for (int i = 0; i < q->known->n; i++)
        if (falls(q, &q->known->at[i])) c->speed_high = fmin(c->speed_high, q->known->at[i].speed);
    for (int i = 0; i < q->known->n; i++) {
        double speed = q->known->at[i].speed;
        if (speed < c->speed_high && !falls(q, &q->known->at[i])) c->speed_low = fmax(c->speed_low, speed);
    }
}

/* The search itself, and the result at its end. */
static enum wf_status search_break(struct search *search, const struct wf_solve_options *quick,
                                   const struct wf_solve_options *fine, struct wf_break *out,
                                   struct wf_err *e)
{
    struct wf_critical *c = &out->critical;
    struct wf_at_speed at;
    search->o = quick;
    enum wf_status s = climb(search, e);
    if (!s) s = wf_critical_search(utilisation, search, search->speed_max, 1e-4, c, e);
    if (s || (c->outcome != WF_CRITICAL_FOUND && c->outcome != WF_CRITICAL_SELF_WEIGHT)) return s;
    search->o = fine;
    s = c->outcome == WF_CRITICAL_FOUND ? polish(search, c, &at, e) : search_totals(search, 0.0, &at, e);
    const struct wf_worst *worst = &at.worst[search->criterion][search->scope];
    if (s || at.status || worst->row < 0) return s;
    if (c->outcome == WF_CRITICAL_FOUND) out->at = at;
    place_at(&search->an->tree, worst, out);
    return WF_OK;
}

static enum wf_status find_break(struct search search, struct wf_break *out, struct wf_err *e)
{
    const struct wf_solve_options *fine = search.o;
    struct wf_solve_options quick = *fine;
    struct wf_err why = { 0 };
    if (fine->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(fine->mesh_tolerance, 1e-4);
    const struct wf_break nothing = { .at = { .speed = NAN }, .row = -1, .height = NAN };
    *out = nothing;
    if (!wf_criterion_known(&wf_criteria[search.criterion], &search.an->tree, search.scope)) {
        out->critical =
            (struct wf_critical){ .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .gradient = NAN };
        return WF_OK;
    }
    search.speed_max = search_top(&search);
    enum wf_status s = search_break(&search, &quick, fine, out, &why);
    if (!s) return WF_OK;
    if (!search.known->over) return wf_fail(e, s, "%s", why.text);
    *out = nothing;
    bracket(&search, &out->critical);
    return WF_OK;
}

/* Result of the branches as far as it follows from that of the whole tree. */
static void branches(const struct wf_analysis *an, const struct wf_criterion *c, const struct wf_break *tree,
                     struct wf_break *out)
{
    bool known = wf_criterion_known(c, &an->tree, WF_SCOPE_BRANCHES);
    *out = *tree;
    if (known && (tree->row < 0 || an->tree.level[tree->row] > 0)) return;
    *out = (struct wf_break){ .at = { .speed = NAN }, .row = -1, .height = NAN };
    out->critical = (struct wf_critical){ .outcome = known ? WF_CRITICAL_UNSEARCHED : WF_CRITICAL_NO_STRENGTH,
                                          .speed = NAN,
                                          .gradient = NAN };
    if (!known) return;
    out->critical.speed_low = tree->critical.outcome == WF_CRITICAL_FOUND ? tree->critical.speed_low : 0.0;
    out->critical.speed_high = an->search.speed_max;
}

struct wf_known *wf_known_take(struct wf_arena *a) { return WF_TAKE(a, 1, struct wf_known); }

enum wf_status wf_analysis_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                                  struct wf_known *known, struct wf_break (*out)[WF_SCOPES], struct wf_err *e)
{
    enum wf_status s = WF_OK;
    known->deadline = processor_seconds() + an->search.seconds;
    for (int c = 0; c < WF_CRITERIA && !s; c++) {
        struct search search = { an, o, (enum wf_criterion_id)c, WF_SCOPE_TREE, known, NAN };
        s = find_break(search, &out[c][WF_SCOPE_TREE], e);
        if (s) break;
        out[c][WF_SCOPE_STEM] = out[c][WF_SCOPE_TREE];
        branches(an, &wf_criteria[c], &out[c][WF_SCOPE_TREE], &out[c][WF_SCOPE_BRANCHES]);
        search.scope = WF_SCOPE_STEM;
        if (wf_criterion_known(&wf_criteria[c], &an->tree, WF_SCOPE_BRANCHES))
            s = find_break(search, &out[c][WF_SCOPE_STEM], e);
    }
    return s;
}

/* ---- The curves ---- */

/* Totals of which curves are drawn. Safety is interpolated as its inverse. */
enum {
    DRAG,
    LIFT,
    WEIGHT,
    DEFLECTION,
    ANGLE,
    SHEAR,
    MOMENT,
    STRESS,
    UTILISATION,
    QUANTITIES = UTILISATION + WF_CRITERIA * WF_SCOPES
};

struct node {
    struct wf_at_speed at;
    bool row; /* its speed is that of a row */
};

struct curve {
    const struct wf_analysis *an;
    struct wf_solve_options o;
    size_t threads;
    int n; /* nodes, in the order of their speeds */
    struct node *node;
    double size[QUANTITIES]; /* largest value at the nodes */
    int picked;
    struct wf_at_speed *pick; /* rows to be solved next */
    double deadline;          /* of the process's time [s] */
    bool *skipped;            /* the deadline came before this row of them */
    bool late;                /* and before one of all rows */
};

/* Two nodes closer than this share of their speed would amplify their mesh errors. */
static const double node_gap = 0.02;

static void read_totals(const struct wf_at_speed *at, double v[QUANTITIES])
{
    const double totals[UTILISATION] = {
        [DRAG] = at->drag,          [LIFT] = at->lift,
        [WEIGHT] = at->weight,      [DEFLECTION] = at->tip_deflection,
        [ANGLE] = at->tip_angle,    [SHEAR] = at->base_shear,
        [MOMENT] = at->base_moment, [STRESS] = at->breakage.largest_stress,
    };
    memcpy(v, totals, sizeof totals);
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) v[UTILISATION + c * WF_SCOPES + s] = 1.0 / at->worst[c][s].safety;
}

static void write_totals(const double v[QUANTITIES], double tallness, struct wf_at_speed *at)
{
    at->drag = v[DRAG];
    at->lift = v[LIFT];
    at->weight = v[WEIGHT];
    at->tip_deflection = v[DEFLECTION];
    at->tip_deflection_share = v[DEFLECTION] / tallness;
    at->tip_angle = v[ANGLE];
    at->base_shear = v[SHEAR];
    at->base_moment = v[MOMENT];
    at->breakage.largest_stress = v[STRESS];
    at->breakage.largest_stress_row = -1;
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++)
            at->worst[c][s] =
                (struct wf_worst){ .safety = 1.0 / v[UTILISATION + c * WF_SCOPES + s], .row = -1 };
}

/* Add a node, unless it lies within node_gap of another; a row then replaces a node that is none. */
static void add_node(struct curve *c, const struct wf_at_speed *at, bool row)
{
    int k = 0;
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        if (!row && fabs(other - at->speed) <= node_gap * fmax(other, at->speed)) return;
    }
    for (int i = 0; i < c->n; i++) {
        double other = c->node[i].at.speed;
        bool near = fabs(other - at->speed) <= node_gap * fmax(other, at->speed);
        if (c->node[i].row || !near) c->node[k++] = c->node[i];
    }
    c->n = k;
    for (; k > 0 && c->node[k - 1].at.speed > at->speed; k--) c->node[k] = c->node[k - 1];
    c->node[k] = (struct node){ *at, row };
    c->n++;
    double v[QUANTITIES];
    read_totals(at, v);
    for (int q = 0; q < QUANTITIES && !at->status; q++)
        if (isfinite(v[q])) c->size[q] = fmax(c->size[q], fabs(v[q]));
    c->size[LIFT] = fmax(c->size[LIFT], c->size[DRAG]);
}

static bool usable(const struct curve *c, int i)
{
    return i >= 0 && i < c->n && !c->node[i].at.status && c->node[i].at.speed > 0.0;
}

/* The nodes nearest to a speed, two on each side where there are, without a gap; node `skip` does not count.
 */
static int nearest(const struct curve *c, double speed, int skip, int out[4])
{
    int high = 0, n = 0, below = 0;
    while (high < c->n && (high == skip || c->node[high].at.speed <= speed)) high++;
    for (int low = high - 1; n < 4; n++) {
        low -= low == skip, high += high == skip;
        bool left = usable(c, low), right = usable(c, high);
        if (!left && !right) break;
        if (left && (!right || 2 * below <= n))
            out[n] = low--, below++;
        else
            out[n] = high++;
    }
    return n;
}

/* Lagrange's polynomial through the nearest nodes, of the logarithms where all values are positive: at low
 * speeds the totals are powers of the speed. false: there are fewer than four nodes. */
static bool predict(const struct curve *c, double speed, int skip, double out[QUANTITIES])
{
    int at[4], n = nearest(c, speed, skip, at);
    double weight[4], v[4][QUANTITIES];
    for (int i = 0; i < n; i++) {
        read_totals(&c->node[at[i]].at, v[i]);
        weight[i] = 1.0;
        for (int j = 0; j < n; j++)
            if (j != i)
                weight[i] *= log(speed / c->node[at[j]].at.speed) /
                             log(c->node[at[i]].at.speed / c->node[at[j]].at.speed);
    }
    for (int q = 0; q < QUANTITIES; q++) {
        bool positive = true;
        out[q] = 0.0;
        for (int i = 0; i < n; i++) positive = positive && v[i][q] > 0.0;
        for (int i = 0; i < n; i++) out[q] += weight[i] * (positive ? log(v[i][q]) : v[i][q]);
        if (positive) out[q] = exp(out[q]);
    }
    return n == 4;
}

/* How well the other nodes predict node i: largest relative error of a total; values below 1e-4 of the
 * largest are not judged as precisely. Returned: INFINITY where they cannot, -1 at both ends, where nothing
 * is bracketed. */
static double misfit(const struct curve *c, int i)
{
    double v[QUANTITIES], by[QUANTITIES], worst = 0.0;
    const struct wf_at_speed *at = &c->node[i].at;
    if (i == 0 || i == c->n - 1) return -1.0;
    if (at->status) return c->node[i - 1].at.status && c->node[i + 1].at.status ? 0.0 : INFINITY;
    if (c->node[i - 1].at.speed == 0.0) return -1.0;
    if (!predict(c, at->speed, i, by)) return INFINITY;
    read_totals(at, v);
    for (int q = 0; q < QUANTITIES; q++) {
        double off = fabs(by[q] - v[q]) / fmax(fabs(v[q]), 1e-4 * c->size[q]);
        if (isfinite(v[q]) && c->size[q] > 0.0) worst = fmax(worst, isfinite(off) ? off : INFINITY);
    }
    return worst;
}

/* Estimated error between two nodes `wide` apart, from the misfit of one of them. A node with another close
 * by is easily predicted, which says less about the wider gap beside it. */
static double error_beside(const struct curve *c, int i, double wide)
{
    double off = misfit(c, i);
    if (!(off > 0.0) || isinf(off)) return off;
    double near = fmin(log(c->node[i].at.speed / c->node[i - 1].at.speed),
                       log(c->node[i + 1].at.speed / c->node[i].at.speed));
    return off * fmax(1.0, wide / near);
}

/* Does the worst place jump to another part of the tree? The curve has a kink there. */
static bool jumps(const struct wf_tree *t, int32_t a, int32_t b)
{
    if (a < 0 || b < 0) return a != b;
    return a != b && t->parent[a] != b && t->parent[b] != a;
}

static bool kinked(const struct curve *c, const struct wf_at_speed *a, const struct wf_at_speed *b)
{
    const struct wf_tree *t = &c->an->tree;
    if (jumps(t, a->breakage.largest_stress_row, b->breakage.largest_stress_row)) return true;
    for (int k = 0; k < WF_CRITERIA; k++)
        if (jumps(t, a->worst[k][WF_SCOPE_TREE].row, b->worst[k][WF_SCOPE_TREE].row)) return true;
    return false;
}

/* Is the curve between node i and the next known? The error falls with the fourth power of the distance of
 * the nodes, at a kink with the distance, and a misfit is that of at least twice the distance. */
static bool known_between(const struct curve *c, int i)
{
    const double enough = 0.015;
    const struct wf_at_speed *low = &c->node[i].at, *high = &c->node[i + 1].at;
    if (!low->status != !high->status || kinked(c, low, high)) return false;
    double wide = log(high->speed / low->speed);
    double off = fmax(error_beside(c, i, wide), error_beside(c, i + 1, wide));
    return off >= 0.0 && off <= enough;
}

/* The row nearest to the middle between two nodes; -1: none between them. */
static int middle_row(const struct wf_analysis *an, double low, double high)
{
    double best = INFINITY, middle = low > 0.0 ? sqrt(low * high) : 0.5 * high;
    int row = -1;
    for (size_t k = 0; k < an->sweep_n; k++) {
        double speed = an->sweep[k].speed;
        if (speed > low && speed < high && fabs(speed - middle) < best)
            best = fabs(speed - middle), row = (int)k;
    }
    return row;
}

static enum wf_status solve_row(void *context, size_t k, struct wf_err *e)
{
    const struct curve *c = context;
    c->skipped[k] = processor_seconds() > c->deadline;
    if (c->skipped[k]) return WF_OK;
    return wf_speed_totals(c->an, &c->o, c->pick[k].speed, &c->pick[k], e);
}

static enum wf_status solve_picked(struct curve *c, struct wf_err *e)
{
    enum wf_status s = wf_parallel((size_t)c->picked, c->threads, solve_row, c, e);
    for (int k = 0; k < c->picked && !s; k++) c->late = c->late || c->skipped[k];
    for (int k = 0; k < c->picked && !s && !c->late; k++) add_node(c, &c->pick[k], true);
    c->picked = 0;
    return s;
}

/* Solve further rows until every part of the curve is known. The rows of a round do not depend on each other,
 * so the curve does not depend on the number of threads. */
static enum wf_status refine(struct curve *c, struct wf_err *e)
{
    while (!c->late) {
        for (int i = 0; i + 1 < c->n; i++) {
            int row = middle_row(c->an, c->node[i].at.speed, c->node[i + 1].at.speed);
            if (row >= 0 && !known_between(c, i)) c->pick[c->picked++].speed = c->an->sweep[row].speed;
        }
        if (c->picked == 0) return WF_OK;
        enum wf_status s = solve_picked(c, e);
        if (s) return s;
    }
    return WF_OK;
}

/* A solution that may become a node. */
struct candidate {
    const struct wf_at_speed *at;
    double tolerance;
    bool row;
};

static int compare_candidates(const void *a, const void *b)
{
    const struct candidate *x = a, *y = b;
    if (x->row != y->row) return x->row ? -1 : 1;
    if (x->tolerance != y->tolerance) return x->tolerance < y->tolerance ? -1 : 1;
    return (x->at->speed > y->at->speed) - (x->at->speed < y->at->speed);
}

static const struct wf_at_speed *row_at(const struct wf_analysis *an, double speed)
{
    for (size_t k = 0; k < an->sweep_n; k++)
        if (an->sweep[k].speed == speed) return &an->sweep[k];
    return NULL;
}

/* Nodes from the solutions at hand, and the first, second and last row. */
static enum wf_status first_nodes(struct curve *c, const struct wf_known *known, struct candidate *all,
                                  struct wf_err *e)
{
    const struct wf_analysis *an = c->an;
    const size_t ends[] = { 0, 1, an->sweep_n - 1 };
    size_t n = 0;
    for (size_t k = 0; k < an->n; k++) all[n++] = (struct candidate){ &an->at[k], 0.0, false };
    for (int k = 0; k < known->n; k++)
        if (known->used[k]) all[n++] = (struct candidate){ &known->at[k], known->tolerance[k], false };
    for (size_t k = 0; k < n; k++) all[k].row = row_at(an, all[k].at->speed);
    qsort(all, n, sizeof *all, compare_candidates);
    for (size_t k = 0; k < n; k++) add_node(c, all[k].at, all[k].row);
    for (size_t k = 0; k < WF_COUNT(ends); k++) {
        bool solved = false;
        for (int i = 0; i < c->n; i++) solved = solved || c->node[i].at.speed == an->sweep[ends[k]].speed;
        if (!solved) c->pick[c->picked++].speed = an->sweep[ends[k]].speed;
    }
    return solve_picked(c, e);
}

/* A row from the nodes around it. */
static void fill_row(const struct curve *c, struct wf_at_speed *row)
{
    int i = 0;
    double speed = row->speed, v[QUANTITIES];
    while (i + 1 < c->n && c->node[i + 1].at.speed <= speed) i++;
    *row = c->node[i].at;
    if (row->speed == speed) return;
    row->speed = speed;
    row->interpolated = true;
    if (row->status) return;
    predict(c, speed, -1, v);
    write_totals(v, c->an->tallness, row);
}

/* Rows from 0 beyond the given and the critical speeds, at a round step; a quarter of it for the first steps,
 * where the deflection of a slender tree grows fastest. */
static enum wf_status take_rows(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    enum { QUARTERED = 5, STEPS = 40 };
    static const double steps[] = { 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0 };
    double top = 1.0, step = 0.0;
    for (size_t k = 0; k < an->n; k++) top = fmax(top, an->at[k].speed);
    const struct wf_critical *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    if (first->outcome == WF_CRITICAL_FOUND) top = fmax(top, fmin(1.1 * first->speed, an->search.speed_max));
    for (size_t k = 0; k < WF_COUNT(steps); k++)
        if ((step = steps[k]) * STEPS >= top) break;
    an->sweep_n = (size_t)ceil(top / step - 1e-9) + 3 * QUARTERED + 1;
    if (!(an->sweep = WF_TAKE(a, an->sweep_n, struct wf_at_speed)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", an->sweep_n);
    for (size_t k = 0; k < an->sweep_n; k++)
        an->sweep[k].speed = step * (k < 4 * QUARTERED ? 0.25 * (double)k : (double)k - 3 * QUARTERED);
    return WF_OK;
}

/* The nodes, then the rows. */
static enum wf_status draw(struct curve *c, struct wf_analysis *an, const struct wf_known *known,
                           struct wf_arena *scratch, struct wf_err *e)
{
    size_t most = an->n + (size_t)known->n + an->sweep_n;
    c->node = WF_TAKE(scratch, most, struct node);
    c->pick = WF_TAKE(scratch, most, struct wf_at_speed);
    c->skipped = WF_TAKE(scratch, most, bool);
    struct candidate *all = WF_TAKE(scratch, most, struct candidate);
    if (!c->node || !c->pick || !c->skipped || !all)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sweep of %zu speeds", most);
    enum wf_status s = first_nodes(c, known, all, e);
    if (!s) s = refine(c, e);
    for (size_t k = 0; k < an->sweep_n && !s && !c->late; k++) fill_row(c, &an->sweep[k]);
    return s;
}

enum wf_status wf_analysis_sweep(struct wf_analysis *an, const struct wf_solve_options *o,
                                 const struct wf_known *known, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct curve c = { .an = an, .o = *o, .threads = threads_for(an, o) };
    enum wf_status s = take_rows(an, a, e);
    if (s) return s;
    if (o->mesh_tolerance > 0.0) c.o.mesh_tolerance = fmax(o->mesh_tolerance, 1e-4); /* finer than drawn */
    c.deadline = processor_seconds() + an->search.seconds;
    c.late = an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_UNSEARCHED;
    if (!c.late) s = draw(&c, an, known, &scratch, e);
    wf_arena_free(&scratch);
    if (s || !c.late) return s;
    an->sweep_n = an->n, an->sweep = an->at; /* no more than the speeds given */
    wf_diag_warn(d, "search-ended",
                 "%s: the time for the curves (%.4g s) is used up: curves join the given wind speeds alone",
                 an->species->name, an->search.seconds);
    return WF_OK;
}

void wf_search_default(struct wf_search *s)
{
    *s = (struct wf_search){ .speed_max = 60.0, .beyond = 1.2, .seconds = INFINITY };
}
