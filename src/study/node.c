/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/node.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "solve/track.h"
#include "study/peak.h"
#include "study/sway.h"
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
    at->top_deflection = NAN;
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

enum { TRACKS = 3 };

/* Solutions by one mesh tolerance, each from a near one. */
struct sequence {
    double tolerance;
    struct wf_solve_options options;
    struct wf_track *track[WF_NODE_PARTS]; /* of branches NULL: the same */
};

struct wf_nodes {
    const struct wf_analysis *an;
    const struct wf_nodes *like; /* of the same tree in another wind direction; NULL: none */
    bool kin;                    /* `like` is of a tree with other values */
    struct wf_arena arena;
    double deadline; /* of the process's time [s] */
    bool late;
    size_t n;
    struct sequence sequence[TRACKS];
    struct wf_node node[WF_NODES_MAX]; /* the last: those beyond n are not set */
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
        if (k->like->node[i].at.speed == 0.0 && k->like->node[i].whole) k->node[k->n++] = k->like->node[i];
}

struct wf_nodes *wf_nodes_open(const struct wf_analysis *an, const struct wf_nodes *like)
{
    struct wf_nodes *k = malloc(sizeof *k);
    if (!k) return NULL;
    memset(k, 0, offsetof(struct wf_nodes, node));
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
    for (int part = 0; part < WF_NODE_PARTS; part++) wf_track_close(q->track[part]);
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
    const struct wf_node_state state = { .known = true, .at = *at };
    if (k->n == WF_NODES_MAX || wf_nodes_find(k, at->speed, tolerance)) return;
    k->node[k->n++] = (struct wf_node){
        .at = *at, .tolerance = tolerance, .used = used, .whole = true, .state = { state, state }
    };
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

/* That of a tolerance; NULL: there is none. */
static const struct sequence *sequence_of(const struct wf_nodes *k, double tolerance)
{
    for (int i = 0; i < TRACKS; i++)
        if (k->sequence[i].track[0] && k->sequence[i].tolerance == tolerance) return &k->sequence[i];
    return NULL;
}

static enum wf_status open_sequence(const struct wf_nodes *k, const struct wf_solve_options *o,
                                    struct sequence *out, struct wf_err *e)
{
    const struct sequence *like = k->like ? sequence_of(k->like, o->mesh_tolerance) : NULL;
    enum wf_status s = WF_OK;
    const struct wf_beam_few *few = k->kin ? NULL : wf_given_few(k->an->given);
    for (int part = 0; part < (wf_peak_branches(k->an->peak) ? WF_NODE_PARTS : 1) && !s; part++) {
        /* in still air both parts have one state, and one mesh is good for both */
        const struct wf_track *first = like ? like->track[part] : part ? out->track[WF_NODE_STEM] : NULL;
        s = wf_track_open(&k->an->tree, &out->options, first, &out->track[part], e);
        if (!s) wf_track_few(out->track[part], few);
    }
    if (!s && k->kin) wf_track_begin_at_last(out->track[0]);
    return s;
}

static enum wf_status sequence_for(struct wf_nodes *k, const struct wf_solve_options *o,
                                   struct sequence **out, struct wf_err *e)
{
    struct sequence *free_one = NULL;
    for (int i = TRACKS; i-- > 0;) {
        *out = &k->sequence[i];
        if ((*out)->track[0] && (*out)->tolerance == o->mesh_tolerance) return WF_OK;
        if (!(*out)->track[0]) free_one = *out;
    }
    if (!(*out = free_one)) { /* a further tolerance takes the place of the first */
        *out = &k->sequence[0];
        close_tracks(*out);
    }
    **out = (struct sequence){ .tolerance = o->mesh_tolerance, .options = *o };
    return open_sequence(k, o, *out, e);
}

static float single(double x) { return isfinite(x) ? (float)x : 0.0F; }

/* Utilisation or stress of a row. */
static double read_row(const struct wf_tree *t, const struct wf_at_speed *at, int column, size_t i)
{
    double place;
    return column == WF_NODE_STRESS
               ? at->breakage.peak[i]
               : 1.0 / wf_criterion_safety(&wf_criteria[column], t, &at->response, &at->breakage, i, &place);
}

bool wf_node_part_holds(const struct wf_analysis *an, enum wf_node_part part, size_t row)
{
    return !wf_peak_branches(an->peak) || (an->tree.level[row] > 0) == (part == WF_NODE_BRANCHES);
}

static enum wf_status take_columns(const struct wf_tree *t, struct wf_arena *a, struct wf_node *node,
                                   struct wf_err *e)
{
    for (int c = 0; c < WF_NODE_COLUMNS; c++) {
        struct wf_node_column *to = &node->column[c];
        bool known = c == WF_NODE_STRESS || wf_criterion_known(&wf_criteria[c], t, WF_SCOPE_TREE);
        if (!known || to->value) continue;
        to->value = WF_TAKE(a, t->n, float);
        to->gain = WF_TAKE(a, t->n, float);
        if (!to->value || !to->gain)
            return wf_fail(e, WF_ENOMEM, "not enough memory for the slopes of %zu segments", t->n);
    }
    return WF_OK;
}

/* The rows of a state in a column, from the answers at the speed and at one a little higher. */
static void read_rows(const struct wf_analysis *an, enum wf_node_part part, const struct wf_speed_answers *r,
                      int column, struct wf_node_column *to)
{
    const struct wf_tree *t = &an->tree;
    for (size_t i = 0; i < t->n; i++) {
        if (!wf_node_part_holds(an, part, i)) continue;
        const double at = read_row(t, &r->at, column, i);
        to->value[i] = single(at);
        to->gain[i] = r->step > 0.0 ? single((read_row(t, &r->side, column, i) - at) / r->step) : 0.0F;
    }
}

/* Slopes of totals that are those of a governing row, as far as its state is known. */
static void slopes_of_worst(const struct wf_tree *t, struct wf_node *node)
{
    for (int c = 0; c < WF_NODE_COLUMNS; c++)
        for (int s = 0; s < (c == WF_NODE_STRESS ? 1 : WF_SCOPES); s++) {
            int total = c == WF_NODE_STRESS ? (int)WF_TOTAL_STRESS : WF_TOTAL_UTILISATION + c * WF_SCOPES + s;
            int32_t row =
                c == WF_NODE_STRESS ? node->at.breakage.largest_stress_row : node->at.worst[c][s].row;
            node->slope[total] = NAN;
            if (row < 0 || !node->column[c].gain) continue;
            if (node->state[t->level[row] > 0 ? WF_NODE_BRANCHES : WF_NODE_STEM].sloped)
                node->slope[total] = (double)node->column[c].gain[row];
        }
}

/* The largest stress of a state is that of its own rows. */
static void own_stress(const struct wf_analysis *an, enum wf_node_part part, struct wf_breakage *b)
{
    b->largest_stress = 0.0;
    b->largest_stress_row = -1;
    for (size_t i = 0; i < an->tree.n; i++)
        if (wf_node_part_holds(an, part, i) && (b->largest_stress_row < 0 || b->peak[i] > b->largest_stress))
            b->largest_stress = b->peak[i], b->largest_stress_row = (int32_t)i;
}

/* The node of what is known now. */
static void join(const struct wf_analysis *an, struct wf_node *node)
{
    const struct wf_node_state *stem = &node->state[WF_NODE_STEM], *branches = &node->state[WF_NODE_BRANCHES];
    node->whole = stem->known && branches->known;
    node->sloped = stem->sloped && branches->sloped;
    node->at = stem->known ? stem->at : branches->at;
    if (node->whole && wf_peak_branches(an->peak)) wf_speed_take_branches(an, &branches->at, &node->at);
    slopes_of_worst(&an->tree, node);
}

/* Values and slopes of a state, from the answers at the speed and at one a little higher. */
static enum wf_status read_state(struct wf_nodes *k, enum wf_node_part part, struct wf_speed_answers *r,
                                 struct wf_node *node, struct wf_err *e)
{
    double v[2][WF_TOTALS];
    enum wf_status s = take_columns(&k->an->tree, &k->arena, node, e);
    for (int c = 0; c < WF_NODE_COLUMNS && !s; c++)
        if (node->column[c].value) read_rows(k->an, part, r, c, &node->column[c]);
    if (s) return s;
    if (part == WF_NODE_STEM && r->step > 0.0) {
        wf_totals_read(&r->at, v[0]);
        wf_totals_read(&r->side, v[1]);
        for (int q = 0; q < WF_TOTAL_STRESS; q++) node->slope[q] = (v[1][q] - v[0][q]) / r->step;
        const double *at = r->at.response.base_moment, *side = r->side.response.base_moment;
        for (int q = 0; q < 2; q++) node->turning[q] = (side[q] - at[q]) / r->step;
    }
    own_stress(k->an, part, &r->at.breakage);
    return WF_OK;
}

/* The track of the coarsest other sequence, which has solutions at most speeds; NULL: none. */
static struct wf_track *other_track(const struct wf_nodes *k, const struct sequence *q,
                                    enum wf_node_part part)
{
    const struct sequence *out = NULL;
    for (int i = 0; i < TRACKS; i++) {
        const struct sequence *other = &k->sequence[i];
        if (other != q && other->track[part] && (!out || other->tolerance > out->tolerance)) out = other;
    }
    return out ? out->track[part] : NULL;
}

static enum wf_status solve_state(struct wf_nodes *k, struct sequence *q, enum wf_node_part part,
                                  double speed, struct wf_node *node, struct wf_err *e)
{
    static const enum wf_part load[] = { WF_PART_STEM, WF_PART_BRANCHES };
    struct wf_arena scratch = { 0 };
    struct wf_speed_answers r;
    struct wf_node_state *to = &node->state[part];
    const struct wf_track_start near = { .other = other_track(k, q, part) };
    enum wf_status s = wf_speed_track(k->an, load[part], q->track[part], speed, &near, &scratch, &r, e);
    wf_stage_step(1);
    if (!s && !r.at.status) s = read_state(k, part, &r, node, e);
    if (!s) {
        wf_speed_drop_columns(&r.at);
        *to = (struct wf_node_state){
            .known = true, .sloped = r.step > 0.0 || speed == 0.0, .irregular = r.irregular, .at = r.at
        };
        to->sloped = to->sloped && !r.at.status;
        if (!q->track[WF_NODE_BRANCHES]) node->state[WF_NODE_BRANCHES] = *to;
        join(k->an, node);
    }
    wf_arena_free(&scratch);
    return s;
}

/* The track of a tolerance; NULL: there is none. */
static const struct wf_track *track_of(const struct wf_nodes *k, double tolerance, enum wf_node_part part)
{
    const struct sequence *q = sequence_of(k, tolerance);
    if (!q) return NULL;
    return q->track[part] ? q->track[part] : q->track[0];
}

/* Is a row, or does it carry, or is it carried by another? The rows of a branch are not in sequence. */
static bool on_way(const struct wf_tree *t, int32_t row, int32_t other)
{
    int32_t up = row > other ? row : other;
    const int32_t down = row > other ? other : row;
    while (up > down) up = t->parent[up];
    return up == down;
}

double wf_nodes_finer(const struct wf_nodes *k, enum wf_node_part part, double coarse, double fine,
                      int32_t row)
{
    const struct wf_track *track[2] = { track_of(k, coarse, part), track_of(k, fine, part) };
    double n[2] = { 0, 0 };
    if (!track[0] || !track[1] || k->like) return 0;
    for (size_t i = 0; i < k->an->tree.n; i++)
        if (row < 0 || on_way(&k->an->tree, row, (int32_t)i))
            for (int m = 0; m < 2; m++) n[m] += wf_track_pieces(track[m], i);
    return n[0] > 0 ? n[1] / n[0] : 0;
}

enum wf_status wf_nodes_ready(struct wf_nodes *k, struct wf_err *e)
{
    if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
    k->late = wf_nodes_late(k);
    /* any status that is no answer about the tree ends the search; its caller then looks at wf_nodes_late */
    return k->late ? wf_fail(e, WF_EINTERNAL, "the time of the search is used up") : WF_OK;
}

static bool lacks(const struct wf_node_state *s) { return !s->known || !(s->sloped || s->at.status); }

/* The node at a speed, one without states where there is none yet. */
static enum wf_status place_node(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                                 struct wf_node **out, struct wf_err *e)
{
    *out = wf_nodes_find(k, speed, o->mesh_tolerance);
    if (*out) return WF_OK;
    if (k->n == WF_NODES_MAX) return wf_fail(e, WF_EINTERNAL, "too many wind speeds were solved");
    *out = &k->node[k->n];
    **out = (struct wf_node){ .at.speed = speed, .tolerance = o->mesh_tolerance };
    return WF_OK;
}

enum wf_status wf_nodes_solve_part(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                                   enum wf_node_part part, const struct wf_node **out, struct wf_err *e)
{
    const double faster = 1.001; /* slopes look at a little more wind */
    struct sequence *q = NULL;
    struct wf_node *node;
    enum wf_status s = place_node(k, o, speed, &node, e);
    if (!wf_peak_branches(k->an->peak)) part = WF_NODE_STEM;
    if (!s && lacks(&node->state[part])) {
        s = wf_nodes_ready(k, e);
        wf_sway_reach(k->an, faster * speed);
        if (!s) s = sequence_for(k, o, &q, e);
        if (!s) s = solve_state(k, q, part, speed, node, e);
    }
    if (s) return s;
    if (node == &k->node[k->n]) k->n++;
    node->used = true;
    *out = node;
    return WF_OK;
}

enum wf_status wf_nodes_solve(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                              const struct wf_node **out, struct wf_err *e)
{
    enum wf_status s = wf_nodes_solve_part(k, o, speed, WF_NODE_STEM, out, e);
    /* the tree has no state: that of its branches says no more */
    if (s || (*out)->state[WF_NODE_STEM].at.status) return s;
    return wf_nodes_solve_part(k, o, speed, WF_NODE_BRANCHES, out, e);
}

double wf_node_branch_safety(const struct wf_analysis *an, const struct wf_node *node)
{
    const struct wf_tree *t = &an->tree;
    double most = 0;
    for (int c = 0; c < WF_CRITERIA && !node->at.status; c++) {
        const float *utilisation = node->column[c].value;
        if (!wf_criteria[c].loses_tree || !utilisation) continue;
        for (size_t i = 0; i < t->n; i++)
            if (wf_tree_thickness(t, i, NAN) >= an->search.branches_from &&
                wf_scope_holds(WF_SCOPE_BRANCHES, t, i))
                most = fmax(most, (double)utilisation[i]);
    }
    return most > 0 ? 1 / most : (double)NAN;
}
