/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/track.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_small.h"
#include "solve/modes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Unknowns of all elements and root plates. */
struct form {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
};

/* A solution that others may start from. */
struct station {
    double speed; /* of its wind [m/s] */
    bool led;     /* `lead` is known: by how much the form changes to that of the other loads, */
    double share; /* of a wind that is faster by this share */
    struct form at, lead;
};
enum { STATIONS = 6, GOOD = 8, CHECKED = 4 };

/* What is known of a mesh: winds in which it met the tolerance, the last of them. */
struct good {
    double pace;     /* wind speed, see pace_of [m/s]; 0: still air */
    double along[3]; /* its direction */
    double error;    /* of the mesh, of what the tolerance allows [-] */
};

struct wf_track {
    const struct wf_tree *tree;
    const struct wf_track *like; /* its mesh is taken; NULL: none */
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
    size_t goods;        /* so many winds in which it met the tolerance */
    struct good good[GOOD];
    bool at_last;                         /* begin at the last form of `like` */
    bool solved, rested;                  /* there is a last form, a form at rest */
    struct form last, lead, rest, before; /* before: the last one while the next is tried */
    size_t stations;
    struct station station[STATIONS];
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

/* Memory for Newton's method on the present mesh. With links it is part of their state. */
static bool take_newton(struct wf_track *k)
{
    return !k->beam.mesh.n || k->beam.links || wf_beam_take_newton(&k->beam, &k->newton);
}

static struct wf_arena *newton_of(struct wf_track *k, const struct wf_loads *l)
{
    return l->links ? &k->work : &k->newton;
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

/* The unknowns of the beam itself. */
static struct form form_of(const struct wf_beam *b) { return (struct form){ b->shape, b->tilt }; }

static void copy_form(const struct wf_track *k, struct form to, struct form from)
{
    memcpy(to.shape, from.shape, k->beam.mesh.n * sizeof *to.shape);
    memcpy(to.tilt, from.tilt, k->beam.feet * sizeof *to.tilt);
}

static void keep(const struct wf_track *k, struct form to) { copy_form(k, to, form_of(&k->beam)); }
static void put_back(const struct wf_track *k, struct form from) { copy_form(k, form_of(&k->beam), from); }

/* to += share times from */
static void add_form(const struct wf_track *k, struct form to, double share, struct form from)
{
    for (size_t i = 0; i < k->beam.mesh.n; i++)
        for (int j = 0; j < 2; j++) v3_add(to.shape[i].v[j], share, from.shape[i].v[j]);
    for (size_t i = 0; i < k->beam.feet; i++) v3_add(to.tilt[i], share, from.tilt[i]);
}

static bool take_form(struct wf_track *k, struct form *f)
{
    f->shape = wf_arena_take_unset(&k->work, k->beam.mesh.n, sizeof *f->shape);
    f->tilt = wf_arena_take_unset(&k->work, k->beam.feet, sizeof *f->tilt);
    return f->shape && f->tilt;
}

/* Room for the forms of a new mesh: of the stations there are none. */
static enum wf_status take_forms(struct wf_track *k, struct wf_err *e)
{
    k->stations = 0;
    for (size_t i = 0; i < STATIONS; i++) k->station[i] = (struct station){ .speed = 0 };
    if (take_form(k, &k->last) && take_form(k, &k->lead) && take_form(k, &k->rest) &&
        take_form(k, &k->before))
        return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for a sequence of solutions of %zu elements",
                   k->beam.mesh.n);
}

/* ---- Stations ---- */

/* Logarithm of the ratio of two wind speeds, without sign. */
static double apart(double a, double b) { return fabs(log(a / b)); }

static double wind_of(const struct wf_loads *l) { return l->wind ? l->wind->speed : 0; }

static struct station *nearest_station(struct wf_track *k, double speed)
{
    struct station *best = NULL;
    for (size_t i = 0; i < k->stations && speed > 0; i++)
        if (!best || apart(k->station[i].speed, speed) < apart(best->speed, speed)) best = &k->station[i];
    return best;
}

/* Room for another station: the place of one of nearly this speed, a new one, or that of the station which
 * has another closest to it. NULL: not enough memory. */
static struct station *free_station(struct wf_track *k, double speed)
{
    const double same = 0.02;
    struct station *nearest = nearest_station(k, speed), *out = &k->station[0];
    double closest = INFINITY;
    if (nearest && apart(nearest->speed, speed) < same) return nearest;
    if (k->stations < STATIONS) {
        out = &k->station[k->stations];
        if (!take_form(k, &out->at) || !take_form(k, &out->lead)) return NULL;
        k->stations++;
        return out;
    }
    for (size_t i = 0; i < STATIONS; i++)
        for (size_t j = 0; j < STATIONS; j++) {
            if (i == j || !(apart(k->station[i].speed, k->station[j].speed) < closest)) continue;
            closest = apart(k->station[i].speed, k->station[j].speed);
            out = &k->station[i];
        }
    return out;
}

/* Keep the last solution. A fine mesh is made anew for a speed that is not near: there it is the only one. */
static void keep_station(struct wf_track *k, bool led, double share)
{
    if (!(k->speed > 0)) return;
    struct station *s = !coarse(k) && k->stations ? &k->station[0] : free_station(k, k->speed);
    if (!s) return; /* solutions will start elsewhere */
    s->speed = k->speed;
    s->led = led, s->share = share;
    copy_form(k, s->at, k->last);
    if (led) copy_form(k, s->lead, k->lead);
}

static struct station *near_station(struct wf_track *k, double speed, double near)
{
    struct station *s = nearest_station(k, speed);
    return s && apart(s->speed, speed) <= log(near) ? s : NULL;
}

/* How the shape grows with the wind speed: between stiff trees (2) and streamlined ones. */
static const double growth = 1.5;

/* to: the form at a wind speed near that of a solution, along its derivative. */
static void lead_on(const struct wf_track *k, struct form to, const struct station *s, double speed)
{
    if (s->led) add_form(k, to, (pow(speed / s->speed, growth) - 1) / (s->share * growth), s->lead);
}

/* Let the last form of a track that is not solving be that of the solution nearest to a speed, moved there
 * along its derivative: where it is nearer than `own` (NULL: any near one). false: none is. */
static bool recall(struct wf_track *k, double speed, const struct station *own)
{
    const double nearer = 1.2, much = 4;
    const struct station *s = near_station(k, speed, nearer);
    if (!s || (own && !(much * apart(s->speed, speed) < apart(own->speed, speed)))) return false;
    if (!take_newton(k)) return false;
    copy_form(k, k->last, s->at);
    lead_on(k, k->last, s, speed);
    k->speed = s->led ? speed : s->speed;
    put_back(k, k->last);
    wf_beam_sweep_up(&k->beam);
    wf_arena_free(&k->newton);
    return true;
}

/* ---- Meshes ---- */

/* The beam, unloaded, on the mesh of another (NULL: the first mesh of the beam solver). */
static enum wf_status take_beam(struct wf_track *k, const struct wf_loads *l, const struct wf_beam_mesh *mesh,
                                struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    int32_t *pieces = WF_TAKE(&scratch, k->tree->n, int32_t);
    int32_t first = wf_beam_first_pieces(k->tree, &k->options);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", k->tree->n);
    for (size_t i = 0; i < k->tree->n; i++) pieces[i] = mesh ? wf_beam_pieces(mesh, i) : first;
    wf_arena_free(&k->work), wf_arena_free(&k->newton);
    k->rested = false;
    k->solutions = 1, k->goods = 0;
    enum wf_status s = wf_beam_init(&k->beam, k->tree, l, &k->options, pieces, &k->work, newton_of(k, l), e);
    wf_arena_free(&scratch);
    return s ? s : take_forms(k, e);
}

/* The speed of a wind with the same load on a stiff tree [m/s]. */
static double pace_of(const struct wf_loads *l) { return wind_of(l) * sqrt(l->wind_scale); }

/* The mesh meets the tolerance at these loads. */
static void note_good(struct wf_track *k, const struct wf_loads *l, double error)
{
    struct good *to = &k->good[k->goods++ % GOOD];
    *to = (struct good){ .pace = pace_of(l), .error = error };
    if (l->wind) memcpy(to->along, l->wind->direction, sizeof to->along);
}

/* Begin on the mesh of another track of the same tree, from its form at rest. */
static enum wf_status adopt(struct wf_track *k, const struct wf_loads *l, struct wf_err *e)
{
    enum wf_status s = take_beam(k, l, &k->like->beam.mesh, e);
    if (s) return s;
    const struct form *from = k->at_last ? &k->like->last : k->like->rested ? &k->like->rest : NULL;
    if (from) put_back(k, *from);
    keep(k, k->last);
    k->goods = k->like->goods;
    memcpy(k->good, k->like->good, sizeof k->good);
    k->rested = k->like->rested && !k->at_last;
    if (k->rested) keep(k, k->rest);
    k->speed = k->at_last ? k->like->speed : 0;
    k->solved = true;
    keep_station(k, false, 0);
    return WF_OK;
}

/* A form on the mesh of `own`, for the present mesh. */
static void carry_form(struct wf_track *k, struct wf_beam *own, struct form from, struct form to)
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
    for (size_t i = 0; i < before->stations && coarse(k); i++) {
        struct station *s = free_station(k, before->station[i].speed);
        if (!s) break;
        s->speed = before->station[i].speed;
        s->led = before->station[i].led, s->share = before->station[i].share;
        carry_form(k, &before->beam, before->station[i].at, s->at);
        if (s->led) {
            add_form(before, before->station[i].lead, 1, before->station[i].at);
            carry_form(k, &before->beam, before->station[i].lead, s->lead);
            add_form(k, s->lead, -1, s->at);
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
    k->stations = 0;
    k->solutions = 1, k->goods = 0;
    if (from == &k->beam) from = &before.beam;
    const struct wf_beam_known known = { from, from, before.solved ? &before.beam.mesh : NULL };
    enum wf_status s =
        wf_beam_solve(k->tree, l, &k->options, &known, &k->work, newton_of(k, l), &k->beam, &k->outcome, e);
    if (!s) s = take_forms(k, e);
    if (!s) carry_forms(k, &before);
    wf_arena_free(&before.work), wf_arena_free(&before.newton);
    return s;
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
        k->solutions = 1, k->goods = 0;
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
    double error = INFINITY;
    if (one_mesh(k)) return WF_OK;
    struct wf_arena scratch = { 0 };
    struct wf_beam *b = &k->beam;
    int32_t *pieces = WF_TAKE(&scratch, k->tree->n, int32_t);
    enum wf_status s =
        pieces ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", k->tree->n);
    keep(k, k->before);
    bool further = !s && wf_beam_finish(b);
    if (!s) s = wf_beam_mesh_off(b, k->options.mesh_tolerance, &error, pieces, e);
    const bool meets = error <= 1;
    if (!s && !meets) s = refine(k, l, pieces, e);
    if (!s && meets) note_good(k, l, error);
    if (!s && meets && further) put_back(k, k->before), wf_beam_sweep_up(b);
    wf_arena_free(&scratch);
    return s;
}

/* The first solution, or with a fine mesh one far from the last. */
static enum wf_status begin(struct wf_track *k, const struct wf_loads *l, struct wf_track *other,
                            struct wf_err *e)
{
    if (!coarse(k)) return remesh(k, l, other && recall(other, wind_of(l), NULL) ? &other->beam : NULL, e);
    enum wf_status s = take_beam(k, l, NULL, e);
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

static void forget_shape(struct wf_track *k)
{
    memset(k->beam.shape, 0, k->beam.mesh.n * sizeof *k->beam.shape);
    memset(k->beam.tilt, 0, k->beam.feet * sizeof *k->beam.tilt);
}

/* As the beam solver begins. */
static bool start_anew(struct wf_track *k, const struct wf_loads *l)
{
    forget_shape(k);
    take_loads(k, l);
    return wf_beam_rests(&k->beam);
}

/* From the last form at the wind speed `from` by smaller steps of the speed, each from the one before. */
static bool approach(struct wf_track *k, const struct wf_loads *l, double from, struct wf_arena *scratch)
{
    enum { TRIES = 16 };
    const double to = wind_of(l);
    double step = 0.5 * (to - from), now = from;
    struct wf_wind wind;
    struct wf_loads loads = *l;
    if (!l->wind || !(fabs(step) > 0)) return false;
    wind = *l->wind;
    loads.wind = &wind;
    for (int tries = 0; tries < TRIES && fabs(step) > fabs(to - from) / 40; tries++) {
        bool last = fabs(to - now) <= 1.2 * fabs(step);
        wind.speed = last ? to : now + step;
        put_back(k, k->last);
        if (!comes_to_rest(k, last ? l : &loads, scratch)) {
            step *= 0.5;
            continue;
        }
        if (last) return true;
        keep(k, k->last);
        now = wind.speed;
        step *= 1.5;
    }
    return false;
}

/* The solutions with derivatives that are next below and above a wind speed; NULL: none. */
static void stations_beside(const struct wf_track *k, double speed, const struct station *beside[2])
{
    beside[0] = beside[1] = NULL;
    for (size_t i = 0; i < k->stations; i++) {
        const struct station *s = &k->station[i], **at = &beside[s->speed > speed];
        if (s->led && (!*at || apart(s->speed, speed) < apart((*at)->speed, speed))) *at = s;
    }
}

/* The unknowns at a wind speed between those of two solutions, by their values and derivatives: cubic in the
 * square of the speed, with which the shape of a stiff tree grows. */
static void put_between(struct wf_track *k, const struct station *low, const struct station *high,
                        double speed)
{
    const double a = low->speed * low->speed, b = high->speed * high->speed,
                 s = (speed * speed - a) / (b - a), rest = 1 - s;
    /* lead / (2 share a): the derivative by the square of the speed */
    put_back(k, low->at);
    add_form(k, form_of(&k->beam), -s * s * (3 - 2 * s), low->at);
    add_form(k, form_of(&k->beam), s * s * (3 - 2 * s), high->at);
    add_form(k, form_of(&k->beam), s * rest * rest * (b - a) / (2 * low->share * a), low->lead);
    add_form(k, form_of(&k->beam), -s * s * rest * (b - a) / (2 * high->share * b), high->lead);
}

/* The form at a wind speed clearly below that of a solution, the nearest; *at: its speed. NULL: none. */
static const struct form *form_below(const struct wf_track *k, double speed, double *at)
{
    const double clearly = 0.9;
    const struct form *out = k->rested ? &k->rest : NULL;
    *at = 0;
    for (size_t i = 0; i < k->stations; i++) {
        const struct station *s = &k->station[i];
        if (s->speed < clearly * speed && (!out || s->speed > *at)) out = &s->at, *at = s->speed;
    }
    return out;
}

/* Move the unknowns from a solution on, by as much as they changed to it from that below. */
static void move_on(struct wf_track *k, const struct station *s, double to)
{
    const double most = 2;
    double low;
    const struct form *below = form_below(k, s->speed, &low);
    if (!below || to > most * s->speed) return;
    double from = pow(s->speed, growth), part = (pow(to, growth) - from) / (from - pow(low, growth));
    add_form(k, form_of(&k->beam), part, s->at);
    add_form(k, form_of(&k->beam), -part, *below);
}

/* Put the unknowns where Newton's method is to start: between solutions on both sides, or at the nearest
 * solution, moved along its derivative where it is near. The shape moves with the power 1.5 of the speed,
 * between stiff trees (2) and streamlined ones. Returned: the wind speed of k->last, which it starts from. */
static double put_start(struct wf_track *k, const struct wf_loads *l, const struct wf_track_start *start,
                        bool between)
{
    const double to = wind_of(l);
    const struct station *s = nearest_station(k, to), *beside[2];
    bool close = near_station(k, to, WF_TRACK_NEAR);
    if (start->other && recall(start->other, to, close ? s : NULL)) {
        wf_beam_carry(&start->other->beam, &k->beam);
        keep(k, k->last);
        return start->other->speed;
    }
    stations_beside(k, to, beside);
    k->beam.close = (beside[0] && beside[1]) || (near_station(k, to, 1.05) && s->led);
    if (between && to > 0 && beside[0] && beside[1]) {
        copy_form(k, k->last, s->at);
        put_between(k, beside[0], beside[1], to);
        return s->speed;
    }
    if (k->rested && (!s || to < 0.5 * s->speed)) {
        put_back(k, k->rest);
        keep(k, k->last);
        return 0;
    }
    if (s) copy_form(k, k->last, s->at);
    put_back(k, k->last);
    if (close && s->led)
        lead_on(k, form_of(&k->beam), s, to);
    else if (between && s && to > s->speed)
        move_on(k, s, to);
    return s ? s->speed : k->speed;
}

static bool keeps_mesh(const struct wf_track *k) { return k->at_last || one_mesh(k); }

/* Was the mesh so much better than the tolerance in one wind that it meets it in this one, from any
 * direction? Its error grows at most as the load of a stronger wind; in a weaker one, of whose smaller
 * displacements it is a share, it grows slowly. */
static bool good_by_far(const struct good *g, double pace)
{
    const double most = 0.4, ratio = pace / g->pace;
    return g->pace > 0 && g->error * fmax(ratio * ratio, sqrt(1 / ratio)) <= most;
}

/* Is the next solution to be compared with one on a finer mesh? Every fourth is, unless the mesh was found
 * good by far, or in nearly this wind, or in winds below and above it and neither far. */
static bool check_is_due(const struct wf_track *k, const struct wf_loads *l)
{
    const double far = 3, same = 1 - 1e-6, pace = pace_of(l);
    bool below = false, above = false;
    if (keeps_mesh(k) || (k->solutions + 1) % CHECKED) return false;
    for (size_t i = 0; i < k->goods && i < GOOD && pace > 0; i++) {
        const struct good *g = &k->good[i];
        if (good_by_far(g, pace)) return false;
        if (!(wf_dot(g->along, l->wind->direction) > same)) continue;
        if (apart(g->pace, pace) <= log(WF_TRACK_NEAR)) return false;
        below = below || (g->pace < pace && pace <= far * g->pace);
        above = above || (g->pace > pace && g->pace <= far * pace);
    }
    return !(below && above);
}

/* From solutions beside this one, unless that was tried: Newton's method, then all the beam solver does. */
static enum wf_status go_on(struct wf_track *k, const struct wf_loads *l, const struct wf_track_start *start,
                            bool tried, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    struct wf_arena scratch = { 0 };
    enum wf_status s = WF_OK;
    const bool due = check_is_due(k, l);
    double from = put_start(k, l, start, !tried);
    b->iterations = b->steps = 0;
    k->outcome = (struct wf_beam_outcome){ .load_factor = 1 };
    if (!comes_to_rest(k, l, &scratch) && !approach(k, l, from, &scratch) && !start_anew(k, l)) {
        forget_shape(k);
        b->options = &k->options;
        b->loads = *l;
        s = wf_beam_settle(b, &scratch, &k->outcome, e);
    }
    b->k0 = NULL;
    wf_arena_free(&scratch);
    b->loads = *l;
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
    const struct form at = k->lead; /* the last form is now that which was read; lead = side - at */
    k->lead = k->last;
    k->last = at;
    keep(k, k->lead);
    add_form(k, k->lead, -1, k->last);
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
    copy_form(k, k->before, k->last);
    (void)put_start(k, l, start, true);
    b->iterations = b->steps = 0;
    b->loads = *l;
    b->options = &k->follow;
    if (wf_beam_newton(b) || b->apart) return WF_OK;
    keep(k, k->last);
    enum wf_status s = read_both(k, side, false, &stable, a, out, e);
    *done = !s && stable && out->sided;
    if (!*done) {
        copy_form(k, k->last, k->before);
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
    bool on = k->solved && (like || coarse(k) || near_station(k, wind_of(l), WF_TRACK_NEAR)), done = false;
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
