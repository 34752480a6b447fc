/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_SENSOR_H
#define WF_FIT_SENSOR_H
/* Inside the predictor: reading sensors off a solved beam, and what a parameter disturbs. */
#include "fit/param.h"
#include "solve/beam_newton.h"
#include <stdbool.h>

/* Reading of a sensor on the present shape, from the unloaded one [SI]. pull: azimuth of the load [rad]. */
double wf_sensor_read(const struct wf_fit_sensor *s, const struct wf_beam *b);
/* Change of that reading for changes of the element ends and of the ground force. */
double wf_sensor_change(const struct wf_fit_sensor *s, const struct wf_beam *b, const double (*ends)[6],
                        const double ground[6]);
/* Its direct change with the logarithm of the radius, at a fixed axis. */
double wf_sensor_by_radius(const struct wf_fit_sensor *s, const struct wf_beam *b);

/* A horizontal coordinate, which the parameter frame.azimuth turns; and its change with the azimuth [/rad].
 */
bool wf_sensor_framed(const struct wf_fit_sensor *s);
double wf_sensor_by_azimuth(const struct wf_fit_sensor *s, const struct wf_beam *b);

/* What a unit change of an internal value disturbs at fixed shape. */
struct wf_disturber {
    const struct wf_fit_tree *tree;
    const struct wf_fit_param *param;
    double internal;
};
struct wf_beam_disturbance;
/* For wf_beam_answer_small; ctx is a struct wf_disturber. */
void wf_disturb(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out);
/* Does the parameter act on this tree's statics at all, and by its elements (not only by its root)? */
bool wf_disturbs(const struct wf_fit_param *p, size_t tree);

/* Where a state stood last time, to start from. */
struct wf_warm {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
    double pull[3]; /* force of the rope [N]             */
    bool known;
};

struct wf_predictor {
    const struct wf_experiment *x;
    const struct wf_fit_param *p;
    size_t params;
    struct wf_tree *tree; /* per tree: with columns of its own                    */
    struct wf_warm *warm; /* per test and state, rest states behind them          */
    size_t *first_state;  /* per test: its first warm state                       */
    size_t most_sensors;
    double *rest, *rest_slope;   /* readings at rest, of the test in hand           */
    double *other, *other_slope; /* of the state in hand                            */
    double *solved;              /* internal values for which all shapes are solutions */
    bool same;                   /* those in hand are these                         */
    double *told, *told_slope;   /* readings at them, and if sloped their slopes: asked for more than once */
    bool sloped;
    struct wf_arena scratch; /* of one test                                          */
};

#endif
