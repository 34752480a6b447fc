/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/stations.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

/* ---- Forms ---- */

struct wf_form wf_form_of(const struct wf_beam *b) { return (struct wf_form){ b->shape, b->tilt }; }

bool wf_form_take(const struct wf_beam *b, struct wf_arena *a, struct wf_form *out)
{
    out->shape = wf_arena_take_unset(a, b->mesh.n, sizeof *out->shape);
    out->tilt = wf_arena_take_unset(a, b->feet, sizeof *out->tilt);
    return out->shape && out->tilt;
}

void wf_form_copy(const struct wf_beam *b, struct wf_form to, struct wf_form from)
{
    memcpy(to.shape, from.shape, b->mesh.n * sizeof *to.shape);
    memcpy(to.tilt, from.tilt, b->feet * sizeof *to.tilt);
}

void wf_form_add(const struct wf_beam *b, struct wf_form to, double share, struct wf_form from)
{
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) v3_add(to.shape[i].v[j], share, from.shape[i].v[j]);
    for (size_t i = 0; i < b->feet; i++) v3_add(to.tilt[i], share, from.tilt[i]);
}

void wf_form_lead(const struct wf_beam *b, struct wf_form to, const struct wf_station *s, double speed)
{
    if (s->led)
        wf_form_add(b, to, (pow(speed / s->speed, WF_FORM_GROWTH) - 1) / (s->share * WF_FORM_GROWTH),
                    s->lead);
}

/* Cubic in the square of the speed, with which the shape of a stiff tree grows. */
void wf_form_between(const struct wf_beam *b, struct wf_form to, const struct wf_station *low,
                     const struct wf_station *high, double speed)
{
    const double from = low->speed * low->speed, end = high->speed * high->speed,
                 s = (speed * speed - from) / (end - from), rest = 1 - s;
    wf_form_copy(b, to, low->at);
    wf_form_add(b, to, -s * s * (3 - 2 * s), low->at);
    wf_form_add(b, to, s * s * (3 - 2 * s), high->at);
    /* lead / (2 share from): the derivative by the square of the speed */
    wf_form_add(b, to, s * rest * rest * (end - from) / (2 * low->share * from), low->lead);
    wf_form_add(b, to, -s * s * rest * (end - from) / (2 * high->share * end), high->lead);
}

/* ---- Stations ---- */

double wf_speeds_apart(double a, double b) { return fabs(log(a / b)); }

struct wf_station *wf_stations_nearest(struct wf_stations *s, double speed)
{
    struct wf_station *best = NULL;
    for (size_t i = 0; i < s->n && speed > 0; i++)
        if (!best || wf_speeds_apart(s->at[i].speed, speed) < wf_speeds_apart(best->speed, speed))
            best = &s->at[i];
    return best;
}

struct wf_station *wf_stations_near(struct wf_stations *s, double speed, double ratio)
{
    struct wf_station *out = wf_stations_nearest(s, speed);
    return out && wf_speeds_apart(out->speed, speed) <= log(ratio) ? out : NULL;
}

void wf_stations_beside(const struct wf_stations *s, double speed, const struct wf_station *beside[2])
{
    beside[0] = beside[1] = NULL;
    for (size_t i = 0; i < s->n; i++) {
        const struct wf_station *own = &s->at[i], **to = &beside[own->speed > speed];
        if (own->led && (!*to || wf_speeds_apart(own->speed, speed) < wf_speeds_apart((*to)->speed, speed)))
            *to = own;
    }
}

struct wf_station *wf_stations_place(struct wf_stations *s, const struct wf_beam *b, struct wf_arena *a,
                                     double speed)
{
    const double same = 0.02;
    struct wf_station *nearest = wf_stations_nearest(s, speed), *out = &s->at[0];
    double closest = INFINITY;
    if (nearest && wf_speeds_apart(nearest->speed, speed) < same) return nearest;
    if (s->n < WF_STATIONS) {
        out = &s->at[s->n];
        if (!wf_form_take(b, a, &out->at) || !wf_form_take(b, a, &out->lead)) return NULL;
        s->n++;
        return out;
    }
    for (size_t i = 0; i < WF_STATIONS; i++)
        for (size_t j = 0; j < WF_STATIONS; j++) {
            const double off = wf_speeds_apart(s->at[i].speed, s->at[j].speed);
            if (i != j && off < closest) closest = off, out = &s->at[i];
        }
    return out;
}
