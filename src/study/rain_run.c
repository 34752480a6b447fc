/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/rain_run.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "load/drop_shape.h"
#include "solve/prism_rest.h"
#include "study/rain_shake.h"
#include <math.h>
#include <string.h>
#include <time.h>

enum { AIR_MOST = 20000, EVENTS_MOST = 5000 };

/* Share of the damping ratio at the lowest frequency that is internal: it grows with frequency and quiets
 * what an impact excites within a section. The rest is the air's. */
static const double internal_share = 0.2;

/* A drop in the air. */
struct falling {
    double place[3], v[3], mass, diameter;
    bool drip; /* from a leaf */
};

struct run {
    const struct wf_rain_spec *s;
    struct wf_rain_result *out;
    struct wf_prism_motion m;
    struct wf_water_law law;
    struct falling *air;
    size_t airs;
    double floor, top; /* heights at which drops end and start [m] */
    double (*up)[3];   /* how a leaf lies */
    double wind[2];
    bool seen[8];   /* kinds of events that have a key */
    double rebound; /* time of the key after the first fall; INFINITY: not yet */
    struct wf_shake shake;
    struct wf_arena *a;
};

void wf_rain_spec_default(struct wf_rain_spec *s, bool printed)
{
    *s = (struct wf_rain_spec){ .printed = printed,
                                .drops = 20,
                                .grid = 256,
                                .fall = 2,
                                .loss = 0.1,
                                .splash = printed ? 0 : 0.2,
                                .lever = 0.8,
                                .duration = 3,
                                .step = 1e-3,
                                .frame = 0.01,
                                .damping = 0.05 };
    wf_scene_spec_default(&s->scene);
    wf_water_law_default(&s->water, printed);
    s->scene.diagonal = printed;
    s->scene.restoring = printed ? 1 : 0;
    s->rain = (struct wf_rain){ .law = &wf_fall_laws[0],
                                .diameter = 3e-3,
                                .least = 0.5e-3,
                                .largest = 6e-3,
                                .jitter = 0.2,
                                .slot = 0.1,
                                .seed = 1 };
}

/* ---- Start ---- */

static enum wf_status check(const struct wf_rain_spec *s, struct wf_err *e)
{
    enum wf_status status = wf_water_law_check(&s->water, e);
    if (status) return status;
    if (!(s->loss >= 0 && s->loss <= 1))
        return wf_fail(e, WF_EUSAGE, "the share of energy lost on impact, epsilon, is 0 to 1, not %g",
                       s->loss);
    if (!(s->splash >= 0 && s->splash <= 1) || !(s->lever >= 0 && s->lever <= 1))
        return wf_fail(e, WF_EUSAGE, "the splash share and the cap of the lever are 0 to 1");
    if (!(s->step > 0) || !(s->duration >= s->step) || s->duration / s->step > 1e8 || !(s->frame >= s->step))
        return wf_fail(e, WF_EUSAGE,
                       "a run needs a step above 0, a duration of one step or more, and frames no "
                       "shorter than a step");
    if (!(s->damping >= 0 && s->damping < 1))
        return wf_fail(e, WF_EUSAGE, "a damping ratio is 0 or more and below 1, not %g", s->damping);
    if (!(s->fall > 0)) return wf_fail(e, WF_EUSAGE, "drops start above the scene");
    return WF_OK;
}

/* Speed of fall at the start of a drop and, for its drift, at the leaves. */
static double start_speed(const struct wf_rain_spec *s, double diameter)
{
    return s->printed ? 0 : s->rain.law->speed(diameter);
}

/* Area over the scene that drops start from: widened against the wind by the drift of the slowest drops. */
static enum wf_status place_rain(struct run *r, struct wf_rain *rain, struct wf_err *e)
{
    const struct wf_rain_scene *sc = &r->out->scene;
    double low[3] = { INFINITY, INFINITY, INFINITY }, high[3] = { -INFINITY, -INFINITY, -INFINITY };
    double most[2] = { 0 }, least[2] = { 0 };
    size_t steps = (size_t)(r->s->duration / r->s->step);
    for (size_t i = 0; i < sc->places; i++)
        for (int c = 0; c < 3; c++)
            low[c] = fmin(low[c], sc->place[3 * i + (size_t)c]),
            high[c] = fmax(high[c], sc->place[3 * i + (size_t)c]);
    for (size_t i = 0; i < steps && r->s->wind; i++)
        for (size_t c = 0; c < 2; c++)
            most[c] = fmax(most[c], r->s->wind[2 * i + c]), least[c] = fmin(least[c], r->s->wind[2 * i + c]);
    r->top = high[2] + r->s->fall, r->floor = low[2] - 0.05;
    double slow =
        r->s->printed ? 0 : r->s->rain.law->speed(rain->intensity > 0 ? rain->least : rain->diameter);
    double lasts =
        r->s->printed ? sqrt(2 * (r->top - r->floor) / r->law.gravity) : (r->top - r->floor) / slow;
    if (!(lasts > 0) || !isfinite(lasts))
        return wf_fail(e, WF_EUSAGE, "drops of %g mm do not fall by the law '%s'",
                       1000 * (rain->intensity > 0 ? rain->least : rain->diameter), rain->law->name);
    for (int c = 0; c < 2; c++) {
        rain->low[c] = low[c] - 0.01 - most[c] * lasts;
        rain->high[c] = high[c] + 0.01 - least[c] * lasts;
    }
    if (r->s->drops) rain->intensity = 0, rain->rate = (double)r->s->drops / lasts;
    return wf_rain_make(rain, e);
}

/* Does the wind push the leaves? As printed it slants the fall alone. */
static bool pushed(const struct wf_rain_spec *s) { return s->wind && !s->printed; }

static enum wf_status start(struct run *r, struct wf_rain *rain, struct wf_err *e)
{
    const struct wf_rain_spec *s = r->s;
    struct wf_rain_result *out = r->out;
    struct wf_rain_scene *sc = &out->scene;
    double omega;
    enum wf_status status = wf_scene_make(&s->scene, r->law.gravity, r->a, sc, e);
    if (status || (status = place_rain(r, rain, e))) return status;
    out->leaf = WF_TAKE(r->a, s->scene.leaves, struct wf_leaf_water);
    r->air = WF_TAKE(r->a, AIR_MOST, struct falling);
    r->up = (double(*)[3])wf_arena_take(r->a, s->scene.vein_prisms + 1, sizeof *r->up);
    out->row = WF_TAKE(r->a, (size_t)(s->duration / s->frame) + 3, struct wf_rain_row);
    out->event = WF_TAKE(r->a, EVENTS_MOST, struct wf_rain_event);
    if (!out->leaf || !r->air || !r->up || !out->row || !out->event)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the rain");
    if ((status = wf_prism_frequency(&sc->prism, sc->rest, NULL, r->a, &out->frequency, e)) ||
        (status = wf_prism_fastest(&sc->prism, sc->rest, r->a, &omega, e)))
        return status;
    double inner = s->method == WF_PRISM_EULER ? 0 : internal_share;
    out->damping = 2 * s->damping * (1 - inner) * WF_TURN * out->frequency;
    out->euler_limit = wf_prism_euler_limit(out->damping, omega);
    r->m = (struct wf_prism_motion){ .p = &sc->prism,
                                     .method = s->method,
                                     .step = s->step,
                                     .damping = out->damping,
                                     .tolerance = 1e-12,
                                     .internal = 2 * s->damping * inner / (WF_TURN * out->frequency),
                                     .gravity = r->law.gravity };
    if ((status = wf_prism_begin(&r->m, sc->rest, r->a, e))) return status;
    out->energy.start = r->m.spring;
    return s->shaken || pushed(s) ? wf_shake_make(sc, r->a, &r->shake, e) : WF_OK;
}

/* ---- Events and keys ---- */

static void note(struct run *r, const char *what, size_t leaf, double mass)
{
    struct wf_rain_result *o = r->out;
    o->events_all++;
    if (o->events < EVENTS_MOST)
        o->event[o->events++] =
            (struct wf_rain_event){ .time = r->m.time, .mass = mass, .leaf = leaf, .what = what };
}

/* Maps of wetness and depth of a leaf. */
static void map_leaf(const struct run *r, size_t leaf, struct wf_rain_key *k)
{
    const struct wf_leaf_water *w = &r->out->leaf[leaf];
    wf_scene_lie(&r->out->scene, r->m.x, leaf, r->up);
    const struct wf_leaf_lie lie = { r->s->scene.vein_prisms + 1, (const double(*)[3])r->up, NULL };
    for (size_t i = 0; i < WF_RAIN_MAP; i++)
        for (size_t j = 0; j < WF_RAIN_MAP; j++) {
            const double at[2] = { ((double)i + 0.5) / WF_RAIN_MAP * w->blade.length,
                                   (((double)j + 0.5) / WF_RAIN_MAP * 2 - 1) * w->blade.half };
            size_t gi = i * w->grid / WF_RAIN_MAP, gj = j * w->grid / WF_RAIN_MAP;
            bool in = fabs(at[1]) < wf_blade_half(&w->blade, at[0]);
            k->wetness[i * WF_RAIN_MAP + j] =
                in ? (float)wf_leaf_wetness(w, &r->law, gi, gj, r->m.time) : NAN;
            k->height[i * WF_RAIN_MAP + j] = in ? (float)wf_leaf_height(w, &r->law, &lie, at) : NAN;
        }
}

static enum wf_status keep_key(struct run *r, const char *event, size_t leaf, struct wf_err *e)
{
    struct wf_rain_result *o = r->out;
    if (o->keys == WF_RAIN_KEYS) return WF_OK;
    struct wf_rain_key *k = &o->key[o->keys];
    size_t cells = (size_t)WF_RAIN_MAP * WF_RAIN_MAP,
           shown = r->airs < WF_RAIN_AIR_SHOWN ? r->airs : WF_RAIN_AIR_SHOWN;
    *k = (struct wf_rain_key){ .event = event, .time = r->m.time, .leaf = leaf, .air = shown };
    k->place = WF_TAKE(r->a, 3 * o->scene.places, double);
    k->water = WF_TAKE(r->a, 1, struct wf_leaf_water);
    k->wetness = WF_TAKE(r->a, cells, float), k->height = WF_TAKE(r->a, cells, float);
    k->drop = WF_TAKE(r->a, 6 * shown, double);
    if (!k->place || !k->water || !k->wetness || !k->height || !k->drop)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the key frames");
    wf_scene_follow(&o->scene, r->m.x);
    memcpy(k->place, o->scene.place, 3 * o->scene.places * sizeof *k->place);
    *k->water = o->leaf[leaf];
    k->water->wet = NULL;
    for (size_t i = 0; i < shown; i++)
        for (size_t c = 0; c < 3; c++)
            k->drop[6 * i + c] = r->air[i].place[c], k->drop[6 * i + 3 + c] = r->air[i].v[c];
    map_leaf(r, leaf, k);
    o->keys++;
    return WF_OK;
}

static enum wf_status key_once(struct run *r, size_t kind, const char *event, size_t leaf, struct wf_err *e)
{
    if (r->seen[kind]) return WF_OK;
    r->seen[kind] = true;
    return keep_key(r, event, leaf, e);
}

/* ---- Rain and impacts ---- */

static void put_in_air(struct run *r, struct falling d)
{
    if (r->airs < AIR_MOST)
        r->air[r->airs++] = d;
    else
        r->out->water.ground += d.mass, r->out->uncounted++; /* not followed */
}

static void emit(struct run *r, const struct wf_rain *rain, uint64_t step)
{
    size_t n = wf_rain_count(rain, step, r->m.time, r->s->step);
    for (size_t k = 0; k < n; k++) {
        struct wf_raindrop q;
        wf_rain_drop(rain, step, k, &q);
        struct falling d = { .place = { q.x, q.y, r->top },
                             .v = { r->wind[0], r->wind[1], -start_speed(r->s, q.diameter) },
                             .diameter = q.diameter,
                             .mass = WF_WATER_DENSITY * WF_PI / 6 * pow(q.diameter, 3) };
        for (int c = 0; c < 3; c++) d.place[c] += q.when * r->s->step * d.v[c];
        r->out->water.rain += d.mass;
        put_in_air(r, d);
    }
}

/* The staged drops: on the left half, on the same place, further in, and near the tip until one hangs and
 * falls. */
static void emit_staged(struct run *r, uint64_t step)
{
    static const double at[][3] = { { 0.05, 0.45, 0.5 },
                                    { 0.25, 0.45, 0.42 },
                                    { 0.45, 0.5, -0.4 },
                                    { 0.65, 0.5, -0.36 },
                                    { 0.85, 0.7, 0.2 } };
    for (size_t k = 0; k < WF_COUNT(at); k++) {
        if (step != (uint64_t)(at[k][0] / r->s->step + 0.5)) continue;
        const struct wf_blade *b = &r->out->scene.blade;
        double x = at[k][1] * b->length, place[2] = { x, at[k][2] * wf_blade_half(b, x) }, d = 3.2e-3;
        struct wf_prism_point q;
        struct falling f = { .diameter = d, .mass = WF_WATER_DENSITY * WF_PI / 6 * d * d * d };
        wf_scene_blade_point(&r->out->scene, 0, place, &q);
        wf_prism_at(&q, r->m.x, f.place);
        f.place[2] += 0.05;
        f.v[2] = r->s->printed ? -sqrt(2 * r->law.gravity * r->s->fall) : -r->s->rain.law->speed(d);
        r->out->water.rain += f.mass;
        put_in_air(r, f);
    }
}

/* Push that an impact gives: sticking keeps momentum; as printed a share of the energy goes over (2). */
static void strike(struct run *r, const struct wf_prism_point *q, const struct falling *d)
{
    double there[3], go[3], yield = wf_prism_yield(r->m.p, q), impulse[3], speed2 = 0, along = 0;
    wf_prism_at(q, r->m.v, there);
    for (int c = 0; c < 3; c++) go[c] = d->v[c] - there[c], speed2 += go[c] * go[c];
    r->out->energy.drops += 0.5 * d->mass * speed2;
    double speed = sqrt(wf_dot(d->v, d->v));
    if (!r->s->printed) {
        for (int c = 0; c < 3; c++) impulse[c] = go[c] / (1 / d->mass + yield);
    } else if (speed > 0) {
        double energy = 0.5 * d->mass * speed * speed * (1 - r->s->loss);
        for (int c = 0; c < 3; c++) along += there[c] * d->v[c] / speed;
        double size = (-along + sqrt(along * along + 2 * yield * energy)) / yield;
        for (int c = 0; c < 3; c++) impulse[c] = size * d->v[c] / speed;
    } else
        return;
    wf_prism_push(&r->m, q, impulse);
}

/* A drop has met leaf or wood. */
static enum wf_status meet(struct run *r, const struct falling *d, const struct wf_hit *hit, struct wf_err *e)
{
    struct wf_rain_scene *sc = &r->out->scene;
    struct wf_prism_point q;
    size_t leaves = r->s->scene.leaves, part = (size_t)hit->part;
    if (part > leaves) {
        wf_scene_wood_point(part - leaves - 1, hit->weight[0], &q);
        strike(r, &q, d);
        r->out->wood_hits++;
        r->out->water.wood += d->mass;
        note(r, "wood", 0, d->mass);
        return WF_OK;
    }
    double at[2] = { 0 }, still[2] = { 0 };
    for (int c = 0; c < 3; c++) {
        size_t corner = (size_t)sc->hits.body[hit->body].at[c] - sc->leaf[part].mesh;
        for (size_t i = 0; i < 2; i++) at[i] += hit->weight[c] * sc->mesh.at[2 * corner + i];
    }
    wf_scene_blade_point(sc, part, at, &q);
    strike(r, &q, d);
    double splash = d->drip ? 0 : r->s->splash * d->mass;
    r->out->water.splash += splash;
    r->out->hits++;
    wf_leaf_water_add(&r->out->leaf[part], &r->law, d->mass - splash, at, still, r->m.time);
    note(r, "hit", part, d->mass);
    r->out->struck_at = r->m.time;
    return key_once(r, 0, "hit", part, e);
}

/* Fall for a step: by Newton and Euler as printed and for drips, else at the terminal speed. */
static enum wf_status fall(struct run *r, struct wf_err *e)
{
    struct wf_rain_scene *sc = &r->out->scene;
    double h = r->s->step;
    size_t left = 0, was = r->airs;
    enum wf_status status = WF_OK;
    for (size_t i = 0; i < was; i++) {
        struct falling d = r->air[i];
        double from[3], to[3];
        struct wf_hit hit;
        memcpy(from, d.place, sizeof from);
        for (int c = 0; c < 3; c++) to[c] = d.place[c] + h * d.v[c];
        r->out->ways++;
        if (!status && wf_hits_first(&sc->hits, sc->place, from, to, d.diameter / 2, &hit, &r->out->tests)) {
            status = meet(r, &d, &hit, e);
            continue;
        }
        memcpy(d.place, to, sizeof to);
        if (r->s->printed || d.drip) d.v[2] -= h * r->law.gravity;
        if (d.place[2] < r->floor) {
            r->out->water.ground += d.mass;
            r->out->missed += !d.drip;
            continue;
        }
        r->air[left++] = d;
    }
    r->airs = left;
    return status;
}

/* ---- Water on the leaves ---- */

static enum wf_status leaf_events(struct run *r, size_t k, const size_t before[WF_WATER_EVENTS],
                                  struct wf_err *e)
{
    struct wf_leaf_water *w = &r->out->leaf[k];
    enum wf_status status = WF_OK;
    for (size_t i = 0; i < WF_WATER_EVENTS && !status; i++) {
        if (w->count[i] == before[i]) continue;
        note(r, wf_water_events[i], k, 0);
        if (i != WF_WATER_FELL) status = key_once(r, 1 + i, wf_water_events[i], k, e);
    }
    for (size_t i = 0; i < w->falls && !status; i++) {
        struct wf_prism_point q;
        struct falling d = { .drip = true, .mass = w->fall[i].mass };
        wf_scene_blade_point(&r->out->scene, k, w->fall[i].at, &q);
        wf_prism_at(&q, r->m.x, d.place);
        wf_prism_at(&q, r->m.v, d.v);
        d.diameter = cbrt(6 * d.mass / (WF_PI * WF_WATER_DENSITY));
        d.place[2] -= d.diameter;
        put_in_air(r, d);
        if (isnan(r->out->fallen_at)) r->rebound = r->m.time + 0.08;
        r->out->fallen_at = r->m.time;
        status = key_once(r, 1 + WF_WATER_FELL, "fell", k, e);
    }
    return status;
}

/* Force of a drop on the leaf: its weight; while it runs, what presses and rubs. As printed the pressure G2
 * with the lever phi at the vein's tip (14, 15). */
static void load_by(struct run *r, size_t k, const struct wf_leaf_drop *d, const struct wf_leaf_lie *lie)
{
    double g = r->law.gravity, force[3] = { 0, 0, -d->mass * g }, along[2], press, normal[3], at[2];
    struct wf_prism_point q;
    memcpy(at, d->at, sizeof at);
    wf_leaf_gravity(&r->out->leaf[k], lie, g, d->at, along, &press);
    bool hangs = d->state == WF_DROP_HANG;
    if (r->s->printed) {
        double phi = fmin(d->at[0] / r->out->leaf[k].blade.length, r->s->lever);
        wf_scene_normal(&r->out->scene, r->m.x, k, d->at, normal);
        for (int c = 0; c < 3; c++) force[c] = phi * (hangs ? force[c] : -d->mass * press * normal[c]);
        at[0] = r->out->leaf[k].blade.length;
    } else if (d->state == WF_DROP_RUN) { /* the part of the weight along the leaf moves the drop */
        double share =
            fmin(1, wf_leaf_friction(&r->law, d, press) / (d->mass * fmax(hypot(along[0], along[1]), 1e-9)));
        wf_scene_normal(&r->out->scene, r->m.x, k, d->at, normal);
        for (int c = 0; c < 3; c++) {
            double down = -d->mass * press * normal[c];
            force[c] = down + share * (force[c] - down);
        }
    }
    wf_scene_blade_point(&r->out->scene, k, at, &q);
    wf_prism_put(&q, force, r->m.load);
}

static enum wf_status wet(struct run *r, struct wf_err *e)
{
    enum wf_status status = WF_OK;
    if (r->s->shaken) wf_shake_move(&r->shake, &r->out->scene, r->m.x, r->m.v, r->s->step, r->law.gravity);
    memset(r->m.load, 0, 9 * r->m.p->sections * sizeof *r->m.load);
    for (size_t k = 0; k < r->s->scene.leaves && !status; k++) {
        struct wf_leaf_water *w = &r->out->leaf[k];
        size_t before[WF_WATER_EVENTS];
        if (!w->drops) continue;
        memcpy(before, w->count, sizeof before);
        wf_scene_lie(&r->out->scene, r->m.x, k, r->up);
        const struct wf_leaf_lie lie = { r->s->scene.vein_prisms + 1, (const double(*)[3])r->up, NULL };
        const struct wf_leaf_lie moving = r->s->shaken ? wf_shake_lie(&r->shake, &r->out->scene, k) : lie;
        wf_leaf_water_step(w, &r->law, &moving, r->m.time, r->s->step);
        for (size_t i = 0; i < w->drops; i++) load_by(r, k, &w->drop[i], &lie);
        status = leaf_events(r, k, before, e);
    }
    if (pushed(r->s)) wf_shake_wind(&r->shake, &r->out->scene, r->m.x, r->m.v, r->wind, r->m.load);
    wf_prism_pass(r->m.p, r->m.load);
    return status;
}

/* ---- Rows ---- */

static void displacement(const struct run *r, size_t section, double out[3])
{
    for (size_t c = 0; c < 3; c++) {
        const double *v = r->m.x + 9 * section + c, *o = r->out->scene.rest + 9 * section + c;
        out[c] = (v[0] + v[3] + v[6] - o[0] - o[3] - o[6]) / 3;
    }
}

static void centre_of(const double *x, size_t section, double out[3])
{
    for (size_t c = 0; c < 3; c++)
        out[c] = (x[9 * section + c] + x[9 * section + 3 + c] + x[9 * section + 6 + c]) / 3;
}

/* Force and moment of the water about the root of the first leaf, and its moment about that of the branch. */
static void by_water(const struct run *r, struct wf_rain_row *o)
{
    double root[2][3], moment[2][3] = { { 0 } };
    centre_of(r->m.x, r->out->scene.leaf[0].first, root[0]);
    centre_of(r->m.x, 0, root[1]);
    for (size_t k = 0; k < r->s->scene.leaves; k++)
        for (size_t i = 0; i < r->out->leaf[k].drops; i++) {
            const struct wf_leaf_drop *d = &r->out->leaf[k].drop[i];
            double at[3], force[3] = { 0, 0, -d->mass * r->law.gravity }, arm[3], turn[3];
            struct wf_prism_point q;
            wf_scene_blade_point(&r->out->scene, k, d->at, &q);
            wf_prism_at(&q, r->m.x, at);
            for (int j = k ? 1 : 0; j < 2; j++) {
                for (int c = 0; c < 3; c++) arm[c] = at[c] - root[j][c];
                wf_cross(arm, force, turn);
                v3_add(moment[j], 1, turn);
            }
            if (!k) o->petiole_force += -force[2];
        }
    o->petiole_moment = sqrt(wf_dot(moment[0], moment[0]));
    o->branch_moment = sqrt(wf_dot(moment[1], moment[1]));
}

static double twist_of(const struct run *r)
{
    double centre[3], along[3], left[3], normal[3], was[3];
    size_t tip = r->out->scene.leaf[0].blade + r->s->scene.vein_prisms / 2;
    wf_prism_frame(r->m.p, r->out->scene.rest, tip, centre, along, was, normal);
    wf_prism_frame(r->m.p, r->m.x, tip, centre, along, left, normal);
    return atan2(-wf_dot(was, normal), wf_dot(was, left));
}

static void keep_row(struct run *r)
{
    struct wf_rain_result *o = r->out;
    struct wf_rain_row *w = &o->row[o->rows++];
    *w = (struct wf_rain_row){ .time = r->m.time, .air = r->airs, .ground = o->water.ground };
    for (size_t k = 0; k < r->s->scene.leaves; k++) {
        w->held += wf_leaf_water_held(&o->leaf[k]), w->film += o->leaf[k].film, w->fell += o->leaf[k].fell;
        for (size_t i = 0; i < o->leaf[k].drops; i++) w->state[o->leaf[k].drop[i].state]++;
    }
    w->wetted = (double)o->leaf[0].wetted / (double)o->leaf[0].cells;
    displacement(r, o->scene.leaf[0].blade + r->s->scene.vein_prisms, w->tip);
    displacement(r, o->scene.sections - 1, w->branch_tip);
    w->twist = twist_of(r);
    by_water(r, w);
    w->energy = r->m.kinetic + r->m.spring;
}

/* ---- Ringing ---- */

void wf_ring_of(const double *x, size_t n, double step, double *frequency, double *decrement)
{
    double mean = 0, top = 0, first = NAN, last = NAN, peak[2] = { NAN, NAN };
    size_t crossings = 0, swings = 0;
    *frequency = *decrement = NAN;
    for (size_t i = n / 2; i < n; i++) mean += x[i] / (double)(n - n / 2);
    for (size_t i = 0; i + 1 < n; i++) {
        double a = x[i] - mean, b = x[i + 1] - mean;
        if (a > 0) top = fmax(top, a);
        if (!(a < 0 && b >= 0)) continue;
        double at = ((double)i + a / (a - b)) * step;
        if (crossings++ == 0) first = at;
        if (crossings > 1 && top > 0) { /* the highest place of the swing before */
            if (isnan(peak[0])) peak[0] = top, swings = 0;
            peak[1] = top, last = at, swings++;
        }
        top = 0;
        if (swings >= 8) break;
    }
    if (swings < 4) return;
    *frequency = (double)(crossings - 1) / (last - first);
    *decrement = log(peak[0] / peak[1]) / (double)(swings - 1);
}

static enum wf_status ring_down(struct wf_rain_result *o, struct wf_arena *a, struct wf_err *e)
{
    double *z = WF_TAKE(a, o->rows, double);
    size_t n = 0;
    if (!z) return wf_fail(e, WF_ENOMEM, "not enough memory for the series");
    for (size_t i = 0; i < o->rows; i++)
        if (o->row[i].time > fmax(o->fallen_at, o->struck_at)) z[n++] = o->row[i].tip[2];
    o->ring_frequency = o->ring_decrement = NAN;
    if (n > 8) wf_ring_of(z, n, o->row[1].time - o->row[0].time, &o->ring_frequency, &o->ring_decrement);
    return WF_OK;
}

/* ---- The run ---- */

static void close_budgets(struct run *r)
{
    struct wf_water_budget *w = &r->out->water;
    struct wf_energy_budget *b = &r->out->energy;
    for (size_t i = 0; i < r->airs; i++) w->air += r->air[i].mass;
    for (size_t k = 0; k < r->s->scene.leaves; k++)
        w->held += wf_leaf_water_held(&r->out->leaf[k]), w->film += r->out->leaf[k].film;
    double out = w->air + w->ground + w->splash + w->wood + w->held + w->film;
    w->off = w->rain > 0 ? fabs(w->rain - out) / w->rain : 0;
    b->end = r->m.kinetic + r->m.spring;
    b->weight = r->m.work.weight, b->load = r->m.work.load - b->wind, b->push = r->m.work.push;
    b->damping = r->m.work.damping, b->solver = r->m.work.solver;
    double most = fmax(fmax(fabs(b->weight), fabs(b->load)), fmax(fmax(b->push, b->damping), b->start));
    most = fmax(most, fabs(b->wind));
    b->off = fabs(b->end - b->start - b->weight - b->load - b->wind - b->push + b->damping) / most;
}

/* What would make the answer wrong without being seen. */
static void say_limits(const struct wf_rain_result *o, struct wf_diag *d)
{
    const double water = 1e-12, energy = 1e-7;
    if (o->uncounted)
        wf_diag_warn(
            d, "drops-not-followed",
            "%zu drops were not followed and are counted as fallen on the ground: more than %d in the "
            "air at once; less rain, a smaller area or a shorter fall (--fall) keeps all",
            o->uncounted, AIR_MOST);
    if (o->events_all > o->events)
        wf_diag_warn(d, "events-left-out", "tables/events.csv has the first %zu of %zu events", o->events,
                     o->events_all);
    bool kept = o->spec->method == WF_PRISM_EULER || o->energy.off <= energy; /* Euler's own is listed */
    if (!(o->water.off <= water) || !kept)
        wf_diag_warn(
            d, "budget-open",
            "the budgets do not close: %.2g of the water (at most %.0e), %.2g of the energy (at most "
            "%.0e); a shorter --step may help",
            o->water.off, water, o->energy.off, energy);
}

static enum wf_status one_step(struct run *r, const struct wf_rain *rain, uint64_t step, struct wf_err *e)
{
    for (size_t c = 0; c < 2 && r->s->wind; c++) r->wind[c] = r->s->wind[2 * step + c];
    if (r->s->staged)
        emit_staged(r, step);
    else
        emit(r, rain, step);
    if (r->airs) wf_scene_follow(&r->out->scene, r->m.x);
    if (r->s->shaken) wf_shake_move(&r->shake, &r->out->scene, r->m.x, r->m.v, r->s->step, r->law.gravity);
    enum wf_status s = fall(r, e);
    if (r->s->shaken) wf_shake_begin(&r->shake, &r->out->scene, r->m.v);
    if (!s) s = wet(r, e);
    if (!s) s = wf_prism_advance(&r->m, e);
    if (pushed(r->s)) r->out->energy.wind += wf_shake_work(&r->shake, &r->out->scene, r->m.x);
    if (!s && r->m.time >= r->rebound) r->rebound = INFINITY, s = keep_key(r, "rebound", 0, e);
    return s;
}

enum wf_status wf_rain_run(const struct wf_rain_spec *s, struct wf_arena *a, struct wf_diag *d,
                           struct wf_rain_result *out, struct wf_err *e)
{
    struct wf_rain rain = s->rain;
    struct run r = { .s = s, .out = out, .law = s->water, .rebound = INFINITY, .a = a };
    *out = (struct wf_rain_result){ .spec = s, .fallen_at = NAN };
    enum wf_status status = check(s, e);
    if (!status) status = start(&r, &rain, e);
    for (size_t k = 0; k < s->scene.leaves && !status; k++)
        status = wf_leaf_water_make(&out->scene.blade, s->scene.fold, s->grid, a, &out->leaf[k], e);
    if (status) return status;
    size_t steps = (size_t)(s->duration / s->step + 0.5), every = (size_t)(s->frame / s->step + 0.5);
    clock_t begun = clock();
    wf_stage_begin(steps, false, "rain on %zu leaves", s->scene.leaves);
    keep_row(&r);
    for (uint64_t i = 0; i < steps && !status; i++) {
        if (i % 64 == 0 && wf_interrupted()) {
            wf_diag_warn(d, "interrupted", "interrupted after %.4g of %.4g s", r.m.time, s->duration);
            break;
        }
        status = one_step(&r, &rain, i, e);
        out->steps++;
        if (i % 64 == 63) wf_stage_step(64);
        if ((i + 1) % every == 0) keep_row(&r);
    }
    if (status || (status = keep_key(&r, "end", 0, e))) return status;
    out->seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
    out->iterations = r.m.iterations, out->factors = r.m.factors;
    close_budgets(&r);
    say_limits(out, d);
    return ring_down(out, a, e);
}
