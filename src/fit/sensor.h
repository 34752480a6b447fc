/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_SENSOR_H
#define WF_FIT_SENSOR_H
/* Internal to the predictor: sensor readings from a solved beam, and the disturbance by a parameter. */
#include "fit/param.h"
#include "solve/beam_rest.h"
#include "solve/beam_small.h"
#include <stdbool.h>

/* Reading of a sensor on the present shape, relative to the unloaded one [SI]. */
double wf_sensor_read(const struct wf_fit_sensor *s, const struct wf_beam *b);
/* Change of that reading for changes of the element ends and of the ground force. */
double wf_sensor_change(const struct wf_fit_sensor *s, const struct wf_beam *b, const double (*ends)[6],
                        const double ground[6]);
/* Its derivative by the logarithm of the radius of level `level` (-1: all) of a tree with `levels`, at a
 * fixed shape of the axis. */
double wf_sensor_by_radius(const struct wf_fit_sensor *s, const struct wf_beam *b, int32_t level,
                           size_t levels);

/* Is the reading a horizontal coordinate, which depends on the parameter frame.azimuth? And its derivative by
 * that azimuth [/rad]. */
bool wf_sensor_framed(const struct wf_fit_sensor *s);
double wf_sensor_by_azimuth(const struct wf_fit_sensor *s, const struct wf_beam *b);

/* Parameter whose unit change of internal value disturbs the equilibrium at a fixed shape. */
struct wf_disturber {
    const struct wf_fit_tree *tree;
    const struct wf_fit_param *param;
    double internal;
    const struct wf_beam_rest_part
        *rest;                    /* of a standing tree: how its state at rest changes with its mass; */
    const double (*rest_root)[3]; /* likewise the moment on the ground; NULL: not */
};
/* Fill `rest` and `rest_root` of a parameter that changes the mass of a standing tree. Given: a beam with the
 * parameters' values; memory from `a`. Errors: WF_ENOMEM. */
enum wf_status wf_disturb_rest(struct wf_disturber *x, const struct wf_beam *b, struct wf_arena *a,
                               struct wf_err *e);
/* Parameters whose disturbances are solved together, one a side. */
struct wf_disturbers {
    struct wf_disturber side[WF_BEAM_SIDES];
    size_t count;
};
/* Callback of wf_beam_answer_small; ctx is a struct wf_disturbers. */
void wf_disturb(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out);
/* Does the parameter affect this tree's static equilibrium? */
bool wf_disturbs(const struct wf_fit_param *p, size_t tree);

/* Last solution of a state, the start of the next. */
struct wf_warm {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
    double pull[3]; /* force of the rope [N]             */
    bool known;
};

/* The mode that was taken for a sensor, and the largest of others. */
struct wf_sway_found {
    double frequency, other;   /* [Hz] */
    double share, other_share; /* of the overturning by inertia [-] */
};

struct wf_predictor {
    const struct wf_experiment *x;
    const struct wf_fit_param *p;
    size_t params;
    struct wf_tree *tree;       /* per tree: with columns of its own                    */
    struct wf_warm *warm;       /* per test and state, then the rest state              */
    struct wf_sway_found *sway; /* per test: of its last frequency */
    size_t *first_state;        /* per test: its first warm state                       */
    size_t most_sensors;
    double *rest, *rest_slope;   /* readings at rest, of the current test           */
    double *other, *other_slope; /* of the current state                            */
    double *solved;              /* internal values of the shapes in `warm`            */
    bool same;                   /* the current values are `solved`, offsets and drifts aside */
    double *told, *told_slope;   /* last prediction, returned again for the same values */
    bool sloped;
    struct wf_arena scratch; /* of one test                                          */
};

#endif
