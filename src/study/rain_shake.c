/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/rain_shake.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

static const double plate_drag = 1.2;   /* of a flat plate across the wind; a leaf's own is not known */
static const double air = 1.2;          /* [kg m-3] */
static const double drop_time = 2.4e-3; /* 1/(2 pi f), f^2 = 8 gamma/(3 pi m) of a free drop of 14 mg [s] */

enum wf_status wf_shake_make(const struct wf_rain_scene *s, struct wf_arena *a, struct wf_shake *out,
                             struct wf_err *e)
{
    enum { PARTS = 40 };
    size_t vein = s->spec.vein_prisms + 1, all = 9 * s->prism.sections;
    *out = (struct wf_shake){ .sections = s->spec.leaves * vein };
    out->area = WF_TAKE(a, vein, double), out->across = WF_TAKE(a, vein, double);
    out->pull = WF_TAKE(a, out->sections, double);
    out->up = (double(*)[3])wf_arena_take(a, out->sections, sizeof *out->up);
    out->force = WF_TAKE(a, all, double), out->was = WF_TAKE(a, all, double);
    out->velocity = WF_TAKE(a, 3 * out->sections, double), out->felt = WF_TAKE(a, 3 * out->sections, double);
    if (!out->area || !out->across || !out->pull || !out->up || !out->force || !out->was || !out->velocity ||
        !out->felt)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the motion of the leaves");
    double h = s->spec.leaf_length / (double)s->spec.vein_prisms;
    for (size_t i = 0; i < vein; i++) {
        double moment = 0;
        for (int k = 0; k < PARTS; k++) {
            double w = wf_blade_half(&s->blade, ((double)i + (k + 0.5) / PARTS - 0.5) * h);
            out->area[i] += w * h / PARTS, moment += w * w / 2 * h / PARTS;
        }
        out->across[i] = out->area[i] > 0 ? moment / out->area[i] : 0;
    }
    return WF_OK;
}

void wf_shake_wind(struct wf_shake *k, const struct wf_rain_scene *s, const double *x, const double *v,
                   const double wind[2], double *load)
{
    size_t vein = s->spec.vein_prisms + 1, all = 9 * s->prism.sections;
    memset(k->force, 0, all * sizeof *k->force);
    memcpy(k->was, x, all * sizeof *x);
    for (size_t leaf = 0; leaf < s->spec.leaves; leaf++)
        for (size_t half = 0; half < 2 * vein; half++) {
            size_t i = half / 2;
            double along = s->spec.leaf_length * (double)i / (double)(vein - 1);
            const double at[2] = { along, half % 2 ? -k->across[i] : k->across[i] };
            double normal[3], u[3], force[3];
            struct wf_prism_point q;
            wf_scene_blade_point(s, leaf, at, &q);
            wf_scene_normal(s, x, leaf, at, normal);
            wf_prism_at(&q, v, u);
            u[0] = wind[0] - u[0], u[1] = wind[1] - u[1], u[2] = -u[2];
            double across = wf_dot(u, normal),
                   size = 0.5 * air * plate_drag * k->area[i] * fabs(across) * across;
            for (int c = 0; c < 3; c++) force[c] = size * normal[c];
            wf_prism_put(&q, force, k->force);
        }
    for (size_t i = 0; i < all; i++) load[i] += k->force[i];
}

double wf_shake_work(const struct wf_shake *k, const struct wf_rain_scene *s, const double *x)
{
    double work = 0;
    for (size_t i = 0; i < 9 * s->prism.sections; i++) work += k->force[i] * (x[i] - k->was[i]);
    return work;
}

/* Velocity of the centre of section n of the blades. */
static size_t centre_of(const struct wf_rain_scene *s, size_t n, const double *v, double out[3])
{
    size_t vein = s->spec.vein_prisms + 1, section = s->leaf[n / vein].blade + n % vein;
    for (size_t c = 0; c < 3; c++)
        out[c] = (v[9 * section + c] + v[9 * section + 3 + c] + v[9 * section + 6 + c]) / 3;
    return section;
}

void wf_shake_begin(struct wf_shake *k, const struct wf_rain_scene *s, const double *v)
{
    for (size_t n = 0; n < k->sections; n++) centre_of(s, n, v, k->velocity + 3 * n);
}

void wf_shake_move(struct wf_shake *k, const struct wf_rain_scene *s, const double *x, const double *v,
                   double step, double gravity)
{
    double share = 1 - exp(-step / drop_time);
    for (size_t n = 0; n < k->sections; n++) {
        double now[3], centre[3], frame[3][3], up[3] = { 0, 0, 1 }, *felt = k->felt + 3 * n;
        size_t section = centre_of(s, n, v, now);
        for (size_t c = 0; c < 3; c++) {
            felt[c] += share * ((now[c] - k->velocity[3 * n + c]) / step - felt[c]);
            up[c] += felt[c] / gravity;
        }
        wf_prism_frame(&s->prism, x, section, centre, frame[0], frame[1], frame[2]);
        for (int c = 0; c < 3; c++) k->up[n][c] = wf_dot(frame[c], up);
        k->pull[n] = sqrt(wf_dot(up, up));
    }
}

struct wf_leaf_lie wf_shake_lie(const struct wf_shake *k, const struct wf_rain_scene *s, size_t leaf)
{
    size_t vein = s->spec.vein_prisms + 1;
    return (struct wf_leaf_lie){ vein, (const double(*)[3])(k->up + leaf * vein), k->pull + leaf * vein };
}
