/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_INTERVALS_H
#define WF_FIT_INTERVALS_H
/* How well a fit knows its parameters: scatter, covariance, profiles, resampling, what the data leave open.
 */
#include "fit/session.h"

/* One point of a profile: the parameter held, the others refitted. */
struct wf_profile_point {
    double value, rise; /* [SI]; rise of -2 ln(likelihood) above its least [-] */
};

struct wf_estimate {
    double value, low, high;          /* 95 % by covariance [SI]; NAN where not determined or at a bound */
    double sd;                        /* of the internal value                                           */
    double profile_low, profile_high; /* 95 % by profile; NAN: open on that side or not asked for        */
    double resampled_low, resampled_high; /* 2.5 and 97.5 % of the bootstrap; NAN: not asked for          */
    bool profiled;        /* a profile was walked to its ends                                            */
    bool at_low, at_high; /* ended on a bound: the true optimum may lie beyond               */
    size_t points;
    struct wf_profile_point *point; /* rising values */
};

/* A direction of the parameters that the data leave open. */
struct wf_loose {
    double sd;        /* of the combination, in internal units; NAN: of one that has a bound or no limit */
    bool bound;       /* a parameter on its bound                                               */
    const char *text; /* which parameters change together                                       */
};

struct wf_fit_group { /* the readings of one sensor in one test */
    size_t test, sensor, n;
    double sigma;       /* of one reading: given or estimated, mean over the readings [SI]            */
    double correlation; /* of neighbouring residuals [-]                                              */
    double inflation;   /* of sigma, because neighbours repeat each other                             */
    double rms;         /* of the residuals [SI]                                                      */
};

struct wf_fit {
    const struct wf_experiment *x;
    const struct wf_fit_param *param;
    size_t params, free; /* free: those that are not nuisance come first                          */
    double *internal;
    struct wf_estimate *estimate;
    double *covariance, *correlation; /* params x params, of internal values                       */
    double *reading, *slope;          /* predicted at the optimum [SI]; slope: data x params                */
    double *sigma;      /* per datum, as it took part [SI]                                        */
    double *residual;   /* per datum, (measured - predicted) / sigma                              */
    double *band;       /* per datum, half width of the 95 % band of the prediction [SI]          */
    double *influence;  /* per datum, largest change of a free parameter in its sd when left out  */
    size_t *influenced; /* which parameter that is                                                */
    size_t groups;
    struct wf_fit_group *group;
    double quantile;            /* of the 95 % interval, in sd                                            */
    double chi_square, reduced; /* with the sigmas given; reduced: per degree of freedom           */
    size_t freedom;
    bool sigma_estimated; /* any: then reduced is 1 by construction                                */
    double aicc;
    size_t loose_n;
    struct wf_loose *loose;
    size_t starts, starts_same; /* starting points that gave an answer, and those that gave the best */
    size_t resampled;           /* bootstrap data sets that gave an answer                           */
    bool stopped;               /* by progress, at the latest in profiles or bootstrap           */
    struct wf_lsq_result lsq;
};

/* Parts of wf_fit_run; they fill *out from a session at its optimum. */
enum wf_status wf_fit_spread(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
/* The best of several random starts within a factor of 3 of the given one, with the sigmas as they are;
 * sigmas and misfit are found again where it is a better one. */
enum wf_status wf_fit_restart(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_covariance(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                                 struct wf_err *e);
enum wf_status wf_fit_loose(struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_profiles(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
enum wf_status wf_fit_resample(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
#endif
