/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/node.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "solve/track.h"
#include "study/peak.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void wf_totals_read(const struct wf_at_speed *at, double v[WF_TOTALS])
{
    const double totals[WF_TOTAL_UTILISATION] = {
        [WF_TOTAL_DRAG] = at->drag,          [WF_TOTAL_LIFT] = at->lift,
        [WF_TOTAL_WEIGHT] = at->weight,      [WF_TOTAL_DEFLECTION] = at->tip_deflection,
        [WF_TOTAL_ANGLE] = at->tip_angle,    [WF_TOTAL_SHEAR] = at->base_shear,
        [WF_TOTAL_MOMENT] = at->base_moment, [WF_TOTAL_STRESS] = at->breakage.largest_stress,
    };
    memcpy(v, totals, sizeof totals);
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++)
            v[WF_TOTAL_UTILISATION + c * WF_SCOPES + s] = 1.0 / at->worst[c][s].safety;
}

void wf_totals_write(const double v[WF_TOTALS], double tallness, struct wf_at_speed *at)
{
    at->drag = v[WF_TOTAL_DRAG];
    at->lift = v[WF_TOTAL_LIFT];
    at->weight = v[WF_TOTAL_WEIGHT];
    at->tip_deflection = v[WF_TOTAL_DEFLECTION];
    at->tip_deflection_share = v[WF_TOTAL_DEFLECTION] / tallness;
    at->tip_angle = v[WF_TOTAL_ANGLE];
    at->base_shear = v[WF_TOTAL_SHEAR];
    at->base_moment = v[WF_TOTAL_MOMENT];
    at->breakage.largest_stress = v[WF_TOTAL_STRESS];
    at->breakage.largest_stress_row = -1;
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++)
            at->worst[c][s] =
                (struct wf_worst){ .safety = 1.0 / v[WF_TOTAL_UTILISATION + c * WF_SCOPES + s], .row = -1 };
}

/* Large trees are solved one at a time: answers do not depend on the number of threads. */
enum { SOLUTIONS_BYTES = 1 << 30 };

size_t wf_nodes_threads(const struct wf_analysis *an, const struct wf_solve_options *o)
{
    size_t threads = wf_parallel_threads(o->threads), most = SOLUTIONS_BYTES / WF_SOLUTION_BYTES / an->tree.n;
    return threads < most ? threads : most ? most : 1;
}

/* ---- The list ---- */

enum { TRACKS = 2 };

/* Solutions by one mesh tolerance, each from the last. */
struct sequence {
    double tolerance, speed, branches_speed; /* of the last solutions; NAN: none */
    struct wf_solve_options options;
    struct wf_track *track;    /* at the peak of the load on the tree */
    struct wf_track *branches; /* and on branches; NULL: the same */
};

struct wf_nodes {
    const struct wf_analysis *an;
    const struct wf_nodes *like; /* of the same tree in another wind direction; NULL: none */
    bool kin;                    /* `like` is of a tree with other values */
    struct wf_arena arena;
    double deadline; /* of the process's time [s] */
    bool late;
    size_t n;
    struct wf_node node[WF_NODES_MAX];
    struct sequence sequence[TRACKS];
};

static double processor_seconds(void)
{
    struct timespec t;
    return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) ? 0.0 : (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Solutions in still air do not depend on the direction. */
static void take_still(struct wf_nodes *k)
{
    for (size_t i = 0; i < k->like->n; i++)
        if (k->like->node[i].at.speed == 0.0) k->node[k->n++] = k->like->node[i];
}

struct wf_nodes *wf_nodes_open(const struct wf_analysis *an, const struct wf_nodes *like)
{
    struct wf_nodes *k = calloc(1, sizeof *k);
    if (!k) return NULL;
    k->an = an;
    k->like = like;
    if (like) take_still(k);
    wf_nodes_deadline(k, an->search.seconds);
    return k;
}

struct wf_nodes *wf_nodes_open_kin(const struct wf_analysis *an, const struct wf_nodes *like)
{
    struct wf_nodes *k = wf_nodes_open(an, NULL);
    if (k) k->like = like, k->kin = true;
    return k;
}

static void close_tracks(struct sequence *q)
{
    wf_track_close(q->track);
    wf_track_close(q->branches);
}

void wf_nodes_close(struct wf_nodes *k)
{
    if (!k) return;
    for (int i = 0; i < TRACKS; i++) close_tracks(&k->sequence[i]);
    wf_arena_free(&k->arena);
    free(k);
}

void wf_nodes_deadline(struct wf_nodes *k, double seconds)
{
    k->deadline = processor_seconds() + seconds;
    k->late = false;
}

bool wf_nodes_late(const struct wf_nodes *k) { return k->late || processor_seconds() > k->deadline; }

size_t wf_nodes_count(const struct wf_nodes *k) { return k->n; }
const struct wf_node *wf_nodes_at(const struct wf_nodes *k, size_t i) { return &k->node[i]; }

struct wf_node *wf_nodes_find(struct wf_nodes *k, double speed, double tolerance)
{
    for (size_t i = 0; i < k->n; i++)
        if (k->node[i].at.speed == speed && k->node[i].tolerance == tolerance) return &k->node[i];
    return NULL;
}

void wf_nodes_add(struct wf_nodes *k, double tolerance, bool used, const struct wf_at_speed *at)
{
    if (k->n < WF_NODES_MAX)
        k->node[k->n++] = (struct wf_node){ .at = *at, .tolerance = tolerance, .used = used };
}

/* ---- Solutions with slopes ---- */

struct wf_solve_options wf_nodes_quick(const struct wf_solve_options *o)
{
    struct wf_solve_options quick = *o;
    if (o->mesh_tolerance > 0.0) quick.mesh_tolerance = fmax(o->mesh_tolerance, 1e-3);
    /* what Newton's method leaves is squared by the step that gives the slopes */
    quick.tolerance = fmax(o->tolerance, 3e-4);
    return quick;
}

bool wf_nodes_tracked(const struct wf_analysis *an) { return an->solver->tracked && !an->scenario.shelter; }

static enum wf_status sequence_for(struct wf_nodes *k, const struct wf_solve_options *o,
                                   struct sequence **out, struct wf_err *e)
{
    struct sequence *free_one = NULL;
    for (int i = TRACKS; i-- > 0;) {
        *out = &k->sequence[i];
        if ((*out)->track && (*out)->tolerance == o->mesh_tolerance) return WF_OK;
        if (!(*out)->track) free_one = *out;
    }
    if (!(*out = free_one)) { /* a third tolerance takes the place of the first */
        *out = &k->sequence[0];
        close_tracks(*out);
    }
    **out = (struct sequence){
        .tolerance = o->mesh_tolerance, .speed = NAN, .branches_speed = NAN, .options = *o
    };
    const struct sequence *like = NULL;
    for (int i = 0; k->like && i < TRACKS; i++)
        if (k->like->sequence[i].track && k->like->sequence[i].tolerance == o->mesh_tolerance)
            like = &k->like->sequence[i];
    if (like) (*out)->speed = k->kin ? like->speed : 0.0;
    if (like) (*out)->branches_speed = 0.0;
    enum wf_status s =
        wf_track_open(&k->an->tree, &(*out)->options, like ? like->track : NULL, &(*out)->track, e);
    if (!s && k->kin) wf_track_begin_at_last((*out)->track);
    if (s || !wf_peak_branches(k->an->peak)) return s;
    return wf_track_open(&k->an->tree, &(*out)->options, like ? like->branches : NULL, &(*out)->branches, e);
}

static float single(double x) { return isfinite(x) ? (float)x : 0.0F; }

/* Utilisation or stress of all rows. */
static void read_column(const struct wf_tree *t, const struct wf_at_speed *at, int column, double *out)
{
    double place;
    for (size_t i = 0; i < t->n; i++)
        out[i] = column == WF_NODE_STRESS ? at->breakage.peak[i]
                                          : 1.0 / wf_criterion_safety(&wf_criteria[column], t, &at->response,
                                                                      &at->breakage, i, &place);
}

/* Slopes of totals that are those of a governing row. */
static void slopes_of_worst(int column, const double *gain, struct wf_node *out)
{
    int32_t row = out->at.breakage.largest_stress_row;
    if (column == WF_NODE_STRESS) {
        out->slope[WF_TOTAL_STRESS] = row < 0 ? NAN : gain[row];
        return;
    }
    for (int s = 0; s < WF_SCOPES; s++) {
        row = out->at.worst[column][s].row;
        out->slope[WF_TOTAL_UTILISATION + column * WF_SCOPES + s] = row < 0 ? NAN : gain[row];
    }
}

/* A column, from the answers at the speed and at one a little higher. */
static enum wf_status read_slope(const struct wf_tree *t, const struct wf_speed_answers *r, int column,
                                 struct wf_arena *a, struct wf_arena *scratch, struct wf_node *out,
                                 struct wf_err *e)
{
    struct wf_node_column *to = &out->column[column];
    double *at = WF_TAKE(scratch, t->n, double), *side = WF_TAKE(scratch, t->n, double);
    to->value = WF_TAKE(a, t->n, float);
    to->gain = WF_TAKE(a, t->n, float);
    if (!at || !side || !to->value || !to->gain)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the slopes of %zu segments", t->n);
    read_column(t, &r->at, column, at);
    for (size_t i = 0; i < t->n; i++) to->value[i] = single(at[i]);
    if (!(r->step > 0.0)) return WF_OK;
    read_column(t, &r->side, column, side);
    for (size_t i = 0; i < t->n; i++) {
        side[i] = (side[i] - at[i]) / r->step;
        to->gain[i] = single(side[i]);
    }
    slopes_of_worst(column, side, out);
    return WF_OK;
}

/* Values and slopes, from the answers at the speed and at one a little higher. */
static enum wf_status read_slopes(const struct wf_tree *t, const struct wf_speed_answers *r,
                                  struct wf_arena *a, struct wf_arena *scratch, struct wf_node *out,
                                  struct wf_err *e)
{
    double v[2][WF_TOTALS];
    enum wf_status s = WF_OK;
    out->sloped = r->step > 0.0 || r->at.speed == 0.0;
    if (r->step > 0.0) {
        wf_totals_read(&r->at, v[0]);
        wf_totals_read(&r->side, v[1]);
        for (int q = 0; q < WF_TOTALS; q++) out->slope[q] = (v[1][q] - v[0][q]) / r->step;
    }
    for (int c = 0; c < WF_NODE_COLUMNS && !s; c++)
        if (c == WF_NODE_STRESS || wf_criterion_known(&wf_criteria[c], t, WF_SCOPE_TREE))
            s = read_slope(t, r, c, a, scratch, out, e);
    return s;
}

/* The track of another sequence, of stem or branches, whose last speed is near; NULL: none. */
static const struct wf_track *other_near(const struct wf_nodes *k, const struct sequence *q, double speed,
                                         bool branches)
{
    const double near = 0.2;
    for (int i = 0; i < TRACKS; i++) {
        const struct sequence *other = &k->sequence[i];
        double last = branches ? other->branches_speed : other->speed;
        if (other != q && other->track && fabs(last - speed) <= near * speed)
            return branches ? other->branches : other->track;
    }
    return NULL;
}

static enum wf_status solve_state(const struct wf_nodes *k, struct sequence *q, enum wf_part part,
                                  double speed, struct wf_arena *a, struct wf_speed_answers *out,
                                  struct wf_err *e)
{
    bool branches = part == WF_PART_BRANCHES;
    double *last = branches ? &q->branches_speed : &q->speed;
    enum wf_status s = wf_speed_track(k->an, part, branches ? q->branches : q->track, *last, speed,
                                      other_near(k, q, speed, branches), a, out, e);
    if (!s) *last = out->at.status ? NAN : speed;
    return s;
}

/* Stem and branches at a speed, each at the peak of its load; or the stem alone. */
static enum wf_status solve_states(const struct wf_nodes *k, struct sequence *q, double speed, bool stem,
                                   struct wf_arena *a, struct wf_speed_answers *out, struct wf_err *e)
{
    struct wf_speed_answers branches;
    enum wf_status s = solve_state(k, q, WF_PART_STEM, speed, a, out, e);
    if (s || stem || !q->branches || out->at.status) return s;
    s = solve_state(k, q, WF_PART_BRANCHES, speed, a, &branches, e);
    if (s) return s;
    out->irregular = out->irregular || branches.irregular;
    if (!(branches.step > 0.0)) out->step = 0.0;
    wf_speed_take_branches(k->an, &branches.at, &out->at);
    if (out->step > 0.0) wf_speed_take_branches(k->an, &branches.side, &out->side);
    return WF_OK;
}

static enum wf_status solve_node(struct wf_nodes *k, struct sequence *q, double speed, bool stem,
                                 struct wf_node *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_speed_answers r;
    *out = (struct wf_node){ .tolerance = q->tolerance, .used = true };
    enum wf_status s = solve_states(k, q, speed, stem, &scratch, &r, e);
    wf_stage_step(1);
    if (!s) {
        out->at = r.at;
        out->irregular = r.irregular;
        if (!r.at.status) s = read_slopes(&k->an->tree, &r, &k->arena, &scratch, out, e);
        wf_speed_drop_columns(&out->at);
    }
    wf_arena_free(&scratch);
    return s;
}

enum wf_status wf_nodes_ready(struct wf_nodes *k, struct wf_err *e)
{
    if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
    k->late = wf_nodes_late(k);
    /* any status that is no answer about the tree ends the search; its caller then looks at wf_nodes_late */
    return k->late ? wf_fail(e, WF_EINTERNAL, "the time of the search is used up") : WF_OK;
}

enum wf_status wf_nodes_solve(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                              const struct wf_node **out, struct wf_err *e)
{
    struct sequence *q = NULL;
    struct wf_node node, *found = wf_nodes_find(k, speed, o->mesh_tolerance);
    if (found && (found->sloped || found->at.status)) {
        found->used = true;
        *out = found;
        return WF_OK;
    }
    enum wf_status s = wf_nodes_ready(k, e);
    if (!s && !found && k->n == WF_NODES_MAX)
        s = wf_fail(e, WF_EINTERNAL, "too many wind speeds were solved");
    if (!s) s = sequence_for(k, o, &q, e);
    if (!s) s = solve_node(k, q, speed, false, &node, e);
    if (s) return s;
    if (!found) found = &k->node[k->n++];
    *found = node;
    *out = found;
    return WF_OK;
}

enum wf_status wf_nodes_solve_stem(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                                   struct wf_node *out, struct wf_err *e)
{
    struct sequence *q = NULL;
    const struct wf_node *found = wf_nodes_find(k, speed, o->mesh_tolerance);
    if (!found && wf_peak_branches(k->an->peak)) {
        enum wf_status s = wf_nodes_ready(k, e);
        if (!s) s = sequence_for(k, o, &q, e);
        return s ? s : solve_node(k, q, speed, true, out, e);
    }
    enum wf_status s = wf_nodes_solve(k, o, speed, &found, e);
    if (!s) *out = *found;
    return s;
}
