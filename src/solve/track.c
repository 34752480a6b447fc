/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/track.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_small.h"
#include "solve/modes.h"
#include "solve/stations.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHECKED = 4 };

static double wind_of(const struct wf_loads *l) { return l->wind ? l->wind->speed : 0; }

struct wf_track {
    const struct wf_tree *tree;
    const struct wf_track *like;   /* its mesh is taken; NULL: none */
    const struct wf_beam_few *few; /* a mesh that is begun with where it is good; NULL: none */
    struct wf_solve_options options,
        follow; /* follow: Newton from a neighbour converges soon or not at all */
    struct wf_arena work;
    struct wf_arena newton; /* what Newton's method works with: only while it is used, so that tracks that
                               are used in turn have it in common */
    struct wf_beam beam;
    struct wf_beam_outcome outcome;
    struct wf_wind wind; /* of the beam's loads after a solution: the caller's does not outlive it */
    double speed;        /* of the wind of the last solution [m/s] */
    size_t solutions;    /* on this mesh */
    bool at_last;        /* begin at the last form of `like` */
    bool solved, rested; /* there is a last form, a form at rest */
    struct wf_form last, lead, rest, before; /* before: the last one while the next is tried */
    struct wf_stations stations;
};

enum wf_status wf_track_open(const struct wf_tree *t, const struct wf_solve_options *o,
                             const struct wf_track *like, struct wf_track **out, struct wf_err *e)
{
    enum { FOLLOW_ITERATIONS = 32 };
    struct wf_track *k = calloc(1, sizeof *k);
    if (!k) return wf_fail(e, WF_ENOMEM, "not enough memory for a sequence of solutions");
    k->tree = t;
    k->like = like;
    k->options = k->follow = *o;
    k->follow.iterations_max = FOLLOW_ITERATIONS;
    *out = k;
    return WF_OK;
}

void wf_track_begin_at_last(struct wf_track *k) { k->at_last = true; }

void wf_track_few(struct wf_track *k, const struct wf_beam_few *few) { k->few = few; }

/* Memory for Newton's method on the present mesh. With links it is part of their state. */
static bool take_newton(struct wf_track *k)
{
    return !k->beam.mesh.n || k->beam.links || wf_beam_take_newton(&k->beam, &k->newton);
}

static struct wf_arena *newton_of(struct wf_track *k, const struct wf_loads *l)
{
    return l->links ? &k->work : &k->newton;
}

int32_t wf_track_pieces(const struct wf_track *k, size_t row)
{
    return k->solved ? wf_beam_pieces(&k->beam.mesh, row) : 0;
}

void wf_track_close(struct wf_track *k)
{
    if (k) wf_arena_free(&k->work);
    free(k);
}

/* Is one mesh kept, without a tolerance? */
static bool one_mesh(const struct wf_track *k) { return !(k->options.mesh_tolerance > 0); }

/* Is the tolerance mostly met by the first mesh? */
static bool coarse(const struct wf_track *k) { return one_mesh(k) || k->options.mesh_tolerance >= 1e-4; }

static void keep(const struct wf_track *k, struct wf_form to)
{
    wf_form_copy(&k->beam, to, wf_form_of(&k->beam));
}
static void put_back(const struct wf_track *k, struct wf_form from)
{
    wf_form_copy(&k->beam, wf_form_of(&k->beam), from);
}

/* Room for the forms of a new mesh: of the stations there are none. */
static enum wf_status take_forms(struct wf_track *k, struct wf_err *e)
{
    k->stations = (struct wf_stations){ .n = 0 };
    if (wf_form_take(&k->beam, &k->work, &k->last) && wf_form_take(&k->beam, &k->work, &k->lead) &&
        wf_form_take(&k->beam, &k->work, &k->rest) && wf_form_take(&k->beam, &k->work, &k->before))
        return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for a sequence of solutions of %zu elements",
                   k->beam.mesh.n);
}

/* Keep the last solution. A fine mesh is made anew for a speed that is not near: there it is the only one. */
static void keep_station(struct wf_track *k, bool led, double share)
{
    if (!(k->speed > 0)) return;
    struct wf_station *s = !coarse(k) && k->stations.n
                               ? &k->stations.at[0]
                               : wf_stations_place(&k->stations, &k->beam, &k->work, k->speed);
    if (!s) return; /* solutions will start elsewhere */
    s->speed = k->speed;
    s->led = led, s->share = share;
    wf_form_copy(&k->beam, s->at, k->last);
    if (led) wf_form_copy(&k->beam, s->lead, k->lead);
}

/* Ratios of wind speeds, and of paces of different loads, up to which one solution is near another. */
static const double beside = 1.2, alike = 1.05;

/* The wind speed at which the loads of a track are as on a stiff tree at these. */
static double pace_on(const struct wf_track *k, const struct wf_loads *l)
{
    return wf_beam_pace(l) / sqrt(k->beam.loads.wind_scale);
}

/* Let the last form of a track that is not solving be that of the solution nearest to a speed, moved there
 * along its derivative: where it is within a ratio of speeds, and much nearer than another that is `apart`
 * (INFINITY: there is no other). false: none is. */
static bool recall(struct wf_track *k, double speed, double ratio, double apart)
{
    const double much = 4;
    const struct wf_station *s = wf_stations_near(&k->stations, speed, ratio);
    if (!s || !(much * wf_speeds_apart(s->speed, speed) < apart)) return false;
    if (!take_newton(k)) return false;
    wf_form_copy(&k->beam, k->last, s->at);
    wf_form_lead(&k->beam, k->last, s, speed);
    k->speed = s->led ? speed : s->speed;
    put_back(k, k->last);
    wf_beam_sweep_up(&k->beam);
    wf_arena_free(&k->newton);
    return true;
}

const struct wf_beam *wf_track_near(struct wf_track *k, double speed)
{
    return recall(k, speed, beside, INFINITY) ? &k->beam : NULL;
}

/* ---- Meshes ---- */

/* The beam, unloaded, on the mesh of another, or with that many pieces a row (NULL: the first mesh of the
 * beam solver). */
static enum wf_status take_beam(struct wf_track *k, const struct wf_loads *l, const struct wf_beam_mesh *mesh,
                                const int32_t *given, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    int32_t *pieces = WF_TAKE(&scratch, k->tree->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", k->tree->n);
    wf_beam_first_pieces(k->tree, &k->options, pieces);
    for (size_t i = 0; i < k->tree->n && (mesh || given); i++)
        pieces[i] = given ? given[i] : wf_beam_pieces(mesh, i);
    wf_arena_free(&k->work), wf_arena_free(&k->newton);
    k->rested = false;
    k->solutions = 1;
    enum wf_status s = wf_beam_init(&k->beam, k->tree, l, &k->options, pieces, &k->work, newton_of(k, l), e);
    wf_arena_free(&scratch);
    return s ? s : take_forms(k, e);
}

/* Begin on the mesh of another track of the same tree, from its form at rest. */
static enum wf_status adopt(struct wf_track *k, const struct wf_loads *l, struct wf_err *e)
{
    enum wf_status s = take_beam(k, l, &k->like->beam.mesh, NULL, e);
    if (s) return s;
    const struct wf_form *from = k->at_last ? &k->like->last : k->like->rested ? &k->like->rest : NULL;
    if (from) put_back(k, *from);
    keep(k, k->last);
    k->beam.mesh.goods = k->like->beam.mesh.goods;
    k->rested = k->like->rested && !k->at_last;
    if (k->rested) keep(k, k->rest);
    k->speed = k->at_last ? k->like->speed : 0;
    k->solved = true;
    keep_station(k, false, 0);
    return WF_OK;
}

/* A form on the mesh of `own`, for the present mesh. */
static void carry_form(struct wf_track *k, struct wf_beam *own, struct wf_form from, struct wf_form to)
{
    memcpy(own->shape, from.shape, own->mesh.n * sizeof *own->shape);
    memcpy(own->tilt, from.tilt, k->beam.feet * sizeof *own->tilt);
    own->links = NULL; /* the present forces of links are those of the solution */
    wf_beam_sweep_up(own);
    wf_beam_carry(own, &k->beam);
    keep(k, to);
}

/* The form at rest and the stations of the mesh before, for the present mesh, whose solution is left as it
 * is. */
static void carry_forms(struct wf_track *k, struct wf_track *before)
{
    keep(k, k->last);
    if (before->rested) carry_form(k, &before->beam, before->rest, k->rest);
    k->rested = before->rested;
    for (size_t i = 0; i < before->stations.n && coarse(k); i++) {
        struct wf_station *s =
            wf_stations_place(&k->stations, &k->beam, &k->work, before->stations.at[i].speed);
        if (!s) break;
        s->speed = before->stations.at[i].speed;
        s->led = before->stations.at[i].led, s->share = before->stations.at[i].share;
        carry_form(k, &before->beam, before->stations.at[i].at, s->at);
        if (s->led) {
            wf_form_add(&before->beam, before->stations.at[i].lead, 1, before->stations.at[i].at);
            carry_form(k, &before->beam, before->stations.at[i].lead, s->lead);
            wf_form_add(&k->beam, s->lead, -1, s->at);
        }
    }
    put_back(k, k->last);
}

/* A solution at the loads `l` on a mesh of the tolerance, from the shape of `from` (NULL: unloaded). */
static enum wf_status remesh(struct wf_track *k, const struct wf_loads *l, const struct wf_beam *from,
                             struct wf_err *e)
{
    struct wf_track before = *k;
    k->work = k->newton = (struct wf_arena){ 0 };
    k->rested = k->solved = false;
    k->stations.n = 0;
    k->solutions = 1;
    if (from == &k->beam) from = &before.beam;
    const struct wf_beam_known known = { .from = from,
                                         .near = from,
                                         .good = before.solved ? &before.beam.mesh : NULL };
    enum wf_status s =
        wf_beam_solve(k->tree, l, &k->options, &known, &k->work, newton_of(k, l), &k->beam, &k->outcome, e);
    if (!s) s = take_forms(k, e);
    if (s) { /* what was known is not lost */
        before.outcome = k->outcome;
        wf_arena_free(&k->work), wf_arena_free(&k->newton);
        *k = before;
        return s;
    }
    carry_forms(k, &before);
    wf_arena_free(&before.work), wf_arena_free(&before.newton);
    return WF_OK;
}

static bool comes_to_rest(struct wf_track *k, const struct wf_loads *l, struct wf_arena *scratch);

/* The present solution on a mesh with that many pieces a row; on one that is made anew where that finds none.
 */
static enum wf_status refine(struct wf_track *k, const struct wf_loads *l, const int32_t *pieces,
                             struct wf_err *e)
{
    struct wf_track before = *k;
    struct wf_arena scratch = { 0 };
    k->work = k->newton = (struct wf_arena){ 0 };
    k->rested = false;
    enum wf_status s = wf_beam_init(&k->beam, k->tree, l, &k->options, pieces, &k->work, newton_of(k, l), e);
    if (!s) {
        k->beam.other = before.beam.other;
        wf_beam_carry(&before.beam, &k->beam);
        k->beam.iterations = before.beam.iterations, k->beam.steps = before.beam.steps;
        if (!comes_to_rest(k, l, &scratch)) {
            wf_arena_free(&scratch), wf_arena_free(&k->work), wf_arena_free(&k->newton);
            *k = before;
            return remesh(k, l, &k->beam, e);
        }
        k->solutions = 1;
        k->beam.k0 = NULL, k->beam.options = &k->options, k->beam.loads = *l;
        s = take_forms(k, e);
    }
    if (!s) carry_forms(k, &before);
    wf_arena_free(&scratch), wf_arena_free(&before.work), wf_arena_free(&before.newton);
    return s;
}

/* The mesh is looked at a step of Newton's method further: what the method has left of the weight's
 * equilibrium is not small beside what a light wind moves. A mesh that meets the tolerance gets the shape
 * back, of which it has the tangent. */
static enum wf_status check_mesh(struct wf_track *k, const struct wf_loads *l, struct wf_err *e)
{
    struct wf_beam_good found;
    if (one_mesh(k)) return WF_OK;
    struct wf_arena scratch = { 0 };
    struct wf_beam *b = &k->beam;
    int32_t *pieces = WF_TAKE(&scratch, k->tree->n, int32_t);
    enum wf_status s =
        pieces ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", k->tree->n);
    keep(k, k->before);
    bool further = !s && wf_beam_finish(b);
    if (!s) s = wf_beam_mesh_off(b, k->options.mesh_tolerance, &found, pieces, e);
    const bool meets = !s && fmax(found.place, found.loads) <= k->options.mesh_tolerance && found.turn <= 1;
    if (!s && !meets) s = coarse(k) ? refine(k, l, pieces, e) : remesh(k, l, b, e);
    if (meets) wf_beam_note_good(&b->mesh.goods, &found);
    if (meets && further) put_back(k, k->before), wf_beam_sweep_up(b);
    wf_arena_free(&scratch);
    return s;
}

/* Is it worth trying whether the mesh meets the tolerance of the track? */
static bool may_be_good(const struct wf_track *k, const struct wf_beam_mesh *m, const struct wf_loads *l)
{
    return wf_beam_expected_error(&m->goods, l, k->options.mesh_tolerance, 1) <= 1;
}

/* Is the present mesh to be kept at loads that are not near? A look at one that is much finer than that of
 * another track would take longer than to make one anew. */
static bool stays_good(const struct wf_track *k, const struct wf_loads *l, const struct wf_track *other)
{
    const double much = 1.25;
    if (wf_beam_good_by_far(&k->beam.mesh.goods, l, k->options.mesh_tolerance)) return true;
    return other && (double)k->beam.mesh.n <= much * (double)other->beam.mesh.n &&
           may_be_good(k, &k->beam.mesh, l);
}

/* Is the mesh of few elements good at these loads? */
static bool few_are_good(const struct wf_track *k, const struct wf_loads *l)
{
    return wf_beam_few_good(k->few, l, k->options.mesh_tolerance);
}

/* A solution on that mesh, or on the mesh of another track, whose shape is near, if it meets the tolerance;
 * else on one that is made from it. */
static enum wf_status begin_beside(struct wf_track *k, const struct wf_loads *l, struct wf_track *other,
                                   struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    const bool few = few_are_good(k, l);
    const struct wf_beam_goods *goods = few ? &k->few->goods : &other->beam.mesh.goods;
    k->solved = false;
    enum wf_status s = take_beam(k, l, &other->beam.mesh, few ? k->few->pieces : NULL, e);
    if (s) return s;
    k->beam.mesh.goods = *goods;
    wf_beam_carry(&other->beam, &k->beam);
    bool rests = comes_to_rest(k, l, &scratch);
    k->beam.k0 = NULL, k->beam.options = &k->options;
    wf_arena_free(&scratch);
    if (!rests) return remesh(k, l, &other->beam, e);
    return wf_beam_good_by_far(goods, l, k->options.mesh_tolerance) ? WF_OK : check_mesh(k, l, e);
}

/* The first solution, or with a fine mesh one far from the last. */
static enum wf_status begin(struct wf_track *k, const struct wf_loads *l, struct wf_track *other,
                            struct wf_err *e)
{
    if (!coarse(k)) {
        const bool near = other && recall(other, wind_of(l), beside, INFINITY);
        k->outcome = (struct wf_beam_outcome){ .load_factor = 1 };
        if (near && (few_are_good(k, l) || may_be_good(k, &other->beam.mesh, l)))
            return begin_beside(k, l, other, e);
        return remesh(k, l, near ? &other->beam : NULL, e);
    }
    enum wf_status s = take_beam(k, l, NULL, NULL, e);
    if (k->few) k->beam.mesh.goods = k->few->first;
    if (!s) s = wf_beam_settle(&k->beam, newton_of(k, l), &k->outcome, e);
    if (s || !wf_beam_unmoved(&k->beam)) return s ? s : check_mesh(k, l, e);
    k->solutions = CHECKED - 1; /* the next one is looked at */
    return WF_OK;
}

static void take_loads(struct wf_track *k, const struct wf_loads *l)
{
    k->beam.loads = *l;
    k->beam.options = &k->follow;
}

/* Newton's method at the loads from the present unknowns, which are lost where it fails; or after it what
 * settles a few twigs. */
static bool comes_to_rest(struct wf_track *k, const struct wf_loads *l, struct wf_arena *scratch)
{
    take_loads(k, l);
    return wf_beam_rests_soon(&k->beam, scratch);
}

/* As the beam solver begins. */
static bool start_anew(struct wf_track *k, const struct wf_loads *l)
{
    wf_beam_unbend(&k->beam);
    take_loads(k, l);
    return wf_beam_rests(&k->beam);
}

/* From the last form at the wind speed `from` by smaller steps of the speed. */
static bool approach(struct wf_track *k, const struct wf_loads *l, double from, struct wf_arena *scratch)
{
    put_back(k, k->last);
    take_loads(k, l);
    return wf_beam_approach(&k->beam, from, l->wind_scale, scratch);
}

/* The form at a wind speed clearly below that of a solution, the nearest; *at: its speed. NULL: none. */
static const struct wf_form *form_below(const struct wf_track *k, double speed, double *at)
{
    const double clearly = 0.9;
    const struct wf_form *out = k->rested ? &k->rest : NULL;
    *at = 0;
    for (size_t i = 0; i < k->stations.n; i++) {
        const struct wf_station *s = &k->stations.at[i];
        if (s->speed < clearly * speed && (!out || s->speed > *at)) out = &s->at, *at = s->speed;
    }
    return out;
}

/* Move the unknowns from a solution on, by as much as they changed to it from that below. */
static void move_on(struct wf_track *k, const struct wf_station *s, double to)
{
    const double most = 2;
    double low;
    const struct wf_form *below = form_below(k, s->speed, &low);
    if (!below || to > most * s->speed) return;
    const double growth = WF_FORM_GROWTH, from = pow(s->speed, growth),
                 part = (pow(to, growth) - from) / (from - pow(low, growth));
    wf_form_add(&k->beam, wf_form_of(&k->beam), part, s->at);
    wf_form_add(&k->beam, wf_form_of(&k->beam), -part, *below);
}

/* The solution from which the speed is approached where Newton's method fails from the present unknowns: the
 * nearest, if there is one, else these. Returned: its wind speed. */
static double leave_last(struct wf_track *k, const struct wf_station *nearest, double to)
{
    if (!nearest) {
        keep(k, k->last);
        return to;
    }
    wf_form_copy(&k->beam, k->last, nearest->at);
    return nearest->speed;
}

/* Put the unknowns where Newton's method is to start: between solutions on both sides, or at the nearest
 * solution, moved along its derivative where it is near. The shape moves with the power 1.5 of the speed,
 * between stiff trees (2) and streamlined ones. Returned: the wind speed of k->last, which it starts from. */
static double put_start(struct wf_track *k, const struct wf_loads *l, const struct wf_track_start *start,
                        bool between)
{
    const double to = wind_of(l);
    const struct wf_station *s = wf_stations_nearest(&k->stations, to), *around[2];
    bool close = wf_stations_near(&k->stations, to, WF_TRACK_NEAR);
    if (start->from && between) {
        wf_beam_carry(start->from, &k->beam);
        return leave_last(k, s, to);
    }
    const double apart = s && to > 0 ? wf_speeds_apart(s->speed, to) : (double)INFINITY;
    if (start->other && recall(start->other, to, beside, close ? apart : (double)INFINITY)) {
        wf_beam_carry(&start->other->beam, &k->beam);
        keep(k, k->last);
        return start->other->speed;
    }
    if (start->paced && between && recall(start->paced, pace_on(start->paced, l), alike, apart)) {
        wf_beam_carry(&start->paced->beam, &k->beam);
        return leave_last(k, s, to);
    }
    wf_stations_beside(&k->stations, to, around);
    k->beam.close = (around[0] && around[1]) || (wf_stations_near(&k->stations, to, 1.05) && s->led);
    if (between && to > 0 && around[0] && around[1]) {
        wf_form_copy(&k->beam, k->last, s->at);
        wf_form_between(&k->beam, wf_form_of(&k->beam), around[0], around[1], to);
        return s->speed;
    }
    if (k->rested && (!s || to < 0.5 * s->speed)) {
        put_back(k, k->rest);
        keep(k, k->last);
        return 0;
    }
    if (s) wf_form_copy(&k->beam, k->last, s->at);
    put_back(k, k->last);
    if (close && s->led)
        wf_form_lead(&k->beam, wf_form_of(&k->beam), s, to);
    else if (between && s && to > s->speed)
        move_on(k, s, to);
    return s ? s->speed : k->speed;
}

static bool keeps_mesh(const struct wf_track *k) { return k->at_last || one_mesh(k); }

/* Is the next solution to be compared with one on a finer mesh? Every fourth is, with a fine mesh every one,
 * unless the mesh was found good by far, or in nearly this wind, or in winds below and above it and neither
 * far. */
static bool check_is_due(const struct wf_track *k, const struct wf_loads *l)
{
    const double far = 3, same = 1 - 1e-6, pace = wf_beam_pace(l);
    bool below = false, above = false;
    if (keeps_mesh(k) || (coarse(k) && (k->solutions + 1) % CHECKED)) return false;
    const struct wf_beam_goods *goods = &k->beam.mesh.goods;
    if (wf_beam_good_by_far(goods, l, k->options.mesh_tolerance)) return false;
    for (size_t i = 0; i < goods->n && i < WF_BEAM_GOOD && pace > 0; i++) {
        const struct wf_beam_good *g = &goods->at[i];
        if (!(wf_dot(g->along, l->wind->direction) > same)) continue;
        if (wf_speeds_apart(g->pace, pace) <= log(WF_TRACK_NEAR)) return false;
        below = below || (g->pace < pace && pace <= far * g->pace);
        above = above || (g->pace > pace && g->pace <= far * pace);
    }
    return !(below && above);
}

/* Where Newton's method fails from solutions beside this one: all that the beam solver does, with a fine mesh
 * from coarser ones, on which load steps and creep are cheap. */
static enum wf_status fall_back(struct wf_track *k, const struct wf_loads *l, struct wf_track *other,
                                struct wf_arena *scratch, bool *made, struct wf_err *e)
{
    *made = !coarse(k) && !keeps_mesh(k);
    if (*made)
        return remesh(k, l, other && recall(other, wind_of(l), beside, INFINITY) ? &other->beam : NULL, e);
    if (start_anew(k, l)) return WF_OK;
    wf_beam_unbend(&k->beam);
    k->beam.options = &k->options;
    k->beam.loads = *l;
    return wf_beam_settle(&k->beam, scratch, &k->outcome, e);
}

/* From solutions beside this one, unless that was tried: Newton's method, then all the beam solver does. */
static enum wf_status go_on(struct wf_track *k, const struct wf_loads *l, const struct wf_track_start *start,
                            bool tried, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    struct wf_arena scratch = { 0 };
    enum wf_status s = WF_OK;
    const bool due = check_is_due(k, l);
    bool made = false; /* on a new mesh, which meets the tolerance */
    double from = put_start(k, l, start, !tried);
    b->iterations = b->steps = 0;
    k->outcome = (struct wf_beam_outcome){ .load_factor = 1 };
    if (!comes_to_rest(k, l, &scratch) && !approach(k, l, from, &scratch))
        s = fall_back(k, l, start->other, &scratch, &made, e);
    b->k0 = NULL;
    wf_arena_free(&scratch);
    b->loads = *l;
    if (made) return s;
    k->solutions++;
    return s || !due ? s : check_mesh(k, l, e);
}

/* The answer, one Newton step further, which takes away what Newton's method has left, and that at the other
 * loads: by the same tangent, or by another step. *stable (NULL: known): is the equilibrium? */
static enum wf_status read_both(struct wf_track *k, const struct wf_loads *side, bool alone, bool *stable,
                                struct wf_arena *a, struct wf_tracked *out, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    enum wf_status s = alone ? WF_OK : wf_response_alloc(&out->side, k->tree->n, a, e);
    if (s) return s;
    const bool landed = b->finished; /* there is no tangent of the shape, and nothing left */
    b->other = alone ? NULL : side;
    bool known = !alone && !landed && wf_beam_side_find(b, stable);
    if (!wf_beam_finish(b)) return WF_OK;
    wf_beam_read(b, &out->at);
    out->finished = true;
    if (alone) { /* sways are about it */
        keep(k, k->last);
        b->loads = *side;
        return WF_OK;
    }
    keep(k, k->lead);
    if (landed) known = wf_beam_side_find(b, stable);
    if (!known || landed) put_back(k, k->last);
    if (!(known ? wf_beam_side_take(b) : wf_beam_side_step(b, stable))) return WF_OK;
    wf_beam_read(b, &out->side);
    const struct wf_form at = k->lead; /* the last form is now that which was read; lead = side - at */
    k->lead = k->last;
    k->last = at;
    keep(k, k->lead);
    wf_form_add(&k->beam, k->lead, -1, k->last);
    out->sided = true;
    return WF_OK;
}

/* Solve and read where Newton's method alone leads to an equilibrium: that it is stable shows in the sweep
 * that gives the derivative. Returned: *done; where it is false, the last form is as before. */
static enum wf_status solve_soon(struct wf_track *k, const struct wf_loads *l, const struct wf_loads *side,
                                 const struct wf_track_start *start, struct wf_arena *a,
                                 struct wf_tracked *out, bool *done, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    bool stable = false;
    wf_form_copy(&k->beam, k->before, k->last);
    (void)put_start(k, l, start, true);
    b->iterations = b->steps = 0;
    b->loads = *l;
    b->options = &k->follow;
    if (wf_beam_newton(b) || b->apart) return WF_OK;
    keep(k, k->last);
    enum wf_status s = read_both(k, side, false, &stable, a, out, e);
    *done = !s && stable && out->sided;
    if (!*done) {
        wf_form_copy(&k->beam, k->last, k->before);
        out->finished = out->sided = false;
        return s;
    }
    k->outcome = (struct wf_beam_outcome){ .load_factor = 1 };
    k->solutions++;
    return WF_OK;
}

static enum wf_status solve(struct wf_track *k, const struct wf_loads *l, const struct wf_loads *side,
                            const struct wf_track_start *start, struct wf_arena *a, struct wf_tracked *out,
                            struct wf_err *e)
{
    *out = (struct wf_tracked){ 0 };
    enum wf_status s = wf_response_alloc(&out->at, k->tree->n, a, e);
    if (s) return s;
    bool like = k->like && k->like->solved;
    if (like && !k->solved && (s = adopt(k, l, e))) return s;
    bool on = k->solved && (like || coarse(k) || wf_stations_near(&k->stations, wind_of(l), WF_TRACK_NEAR) ||
                            stays_good(k, l, start->other)),
         done = false;
    k->beam.other = !start->alone && k->options.tolerance > WF_BEAM_TIGHT ? side : NULL;
    bool soon = on && side && !start->alone && !check_is_due(k, l);
    if (soon) s = solve_soon(k, l, side, start, a, out, &done, e);
    if (s) return s;
    if (!done) s = on ? go_on(k, l, start, soon, e) : begin(k, l, start->other, e);
    out->at.load_factor = k->outcome.load_factor;
    if (s) return s;
    out->irregular = k->beam.loose > 0 || k->outcome.beyond_limit;
    if (!side && !done) out->finished = wf_beam_finish(&k->beam);
    if (!done) keep(k, k->last);
    k->solved = true;
    k->speed = wind_of(l);
    if (!l->wind) keep(k, k->rest);
    k->rested = k->rested || !l->wind;
    if (side && !done) s = read_both(k, side, start->alone, NULL, a, out, e);
    if (!out->sided && !(side && start->alone && out->finished)) wf_beam_read(&k->beam, &out->at);
    out->at.load_factor = k->outcome.load_factor;
    keep_station(k, out->sided, start->share);
    put_back(k, k->last);
    return s;
}

static void own_wind(struct wf_track *k)
{
    struct wf_loads *l = &k->beam.loads;
    if (!l->wind) return;
    k->wind = *l->wind;
    l->wind = &k->wind;
}

static enum wf_status no_newton(struct wf_track *k, struct wf_err *e)
{
    wf_arena_free(&k->newton);
    return wf_fail(e, WF_ENOMEM, "not enough memory for a solution of %zu elements", k->beam.mesh.n);
}

enum wf_status wf_track_solve(struct wf_track *k, const struct wf_loads *l, const struct wf_loads *side,
                              const struct wf_track_start *start, struct wf_arena *a, struct wf_tracked *out,
                              struct wf_err *e)
{
    if (!take_newton(k)) return no_newton(k, e);
    enum wf_status s = solve(k, l, side, start, a, out, e);
    k->beam.other = NULL;
    own_wind(k);
    wf_arena_free(&k->newton);
    return s;
}

enum wf_status wf_track_sway(struct wf_track *k, const double to[3], const double *width, size_t bands,
                             struct wf_modes_sway *out, double *shape, struct wf_err *e)
{
    if (!k->solved) return wf_fail(e, WF_EINTERNAL, "there is no solution to sway about");
    if (!take_newton(k)) return no_newton(k, e);
    enum wf_status s = wf_modes_sway(&k->beam, to, width, bands, out, shape, e);
    wf_arena_free(&k->newton);
    return s;
}
