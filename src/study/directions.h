/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_DIRECTIONS_H
#define WF_STUDY_DIRECTIONS_H
/* The same tree in wind from evenly spaced directions, and how often a wind climate exceeds its critical wind
 * speeds. */
#include "study/analysis.h"

#ifdef __cplusplus
extern "C" {
#endif

struct wf_rose; /* wind/climate.h */

/* Directions and climate. North of the model is +y and east +x, unless `north` says otherwise. */
struct wf_directions_request {
    size_t n;     /* directions, evenly spaced from north                        */
    double north; /* of the model, from +y clockwise as seen from above [rad]    */
    const struct wf_rose
        *rose; /* climate with n directions, hourly means at the reference height; NULL: none */
    const char *climate_file;
    const double
        *speed_up;   /* n: exposure of the site by direction, in place of the scenario's; NULL: the same */
    const char *law; /* row of wf_averaging_laws: gives the strongest 10-min mean within an hour */
};

struct wf_direction {
    double from;            /* where the wind comes from, clockwise from north [rad] */
    struct wf_at_speed *at; /* totals at the wind speeds of the analysis             */
    double *gusts;          /* peak over mean load G at these speeds [-]             */
    struct wf_break breaks[WF_CRITERIA][WF_SCOPES];
    double hourly,
        strongest; /* share of all hours with wind from here whose mean, or whose strongest 10-min
                      mean, exceeds the wind at which the tree is lost [-]; 0 where there is none up to
                      the highest speed searched; NAN: without a climate or a critical speed */
};
struct wf_directions {
    struct wf_directions_request request;
    double gust;                    /* strongest 10-min mean within an hour over the mean of the hour [-] */
    struct wf_direction *direction; /* request.n */
    double hourly, strongest;       /* over all directions */
    bool above; /* in some direction there is no failure up to the highest speed searched */
};

#define WF_HOURS_A_YEAR 8766.0

/* Direction the wind blows towards, from +x towards +y [rad], when it comes from `from`. */
double wf_direction_azimuth(const struct wf_directions_request *q, double from);
/* The reverse: where a wind towards `azimuth` comes from, 0..2 pi. */
double wf_direction_from(const struct wf_directions_request *q, double azimuth);

/* Given: a finished analysis (its own direction does not matter), options with the number of threads.
 * Returned: *out, each direction with the totals at every speed of the analysis, and the critical wind
 * speeds. Directions are independent of each other: the result does not depend on the number of threads.
 * Errors: WF_EUSAGE for a number of directions outside 2..360 or other than the climate's; those of
 * wf_analyze. Climate: the share of a direction's hours with an hourly mean above U is exp(-(U/A)^k). The
 * critical wind speed is a 10-min mean: `hourly` compares the mean of the hour with it, `strongest` the
 * strongest 10-min mean within the hour by the averaging law, which is the wind that acts on the tree. */
enum wf_status wf_directions_run(const struct wf_analysis *an, const struct wf_solve_options *o,
                                 const struct wf_directions_request *q, struct wf_arena *a,
                                 struct wf_directions *out, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
