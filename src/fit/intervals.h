/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_INTERVALS_H
#define WF_FIT_INTERVALS_H
/* Uncertainty of a fit: scatter, covariance, profiles, resampling, undetermined combinations. */
#include "fit/session.h"

/* One point of a profile: the parameter fixed, the others refitted. */
struct wf_profile_point {
    double value, rise; /* [SI]; -2 ln(likelihood) less its minimum [-] */
};

struct wf_estimate {
    double value, low, high;          /* 95 % by covariance [SI]; NAN where not determined or at a bound */
    double sd;                        /* of the internal value                                           */
    double profile_low, profile_high; /* 95 % by profile; NAN: no limit on that side or not computed     */
    double resampled_low, resampled_high; /* 2.5 and 97.5 % of the bootstrap; NAN: not computed           */
    bool profiled;        /* the profile was computed to its ends                                        */
    bool at_low, at_high; /* on a bound: the true optimum may be beyond                      */
    size_t points;
    struct wf_profile_point *point; /* rising values */
};

/* A combination of parameters that the data do not determine. */
struct wf_loose {
    double sd;  /* of the combination, in internal units; NAN: a parameter on a bound or without a limit */
    bool bound; /* a parameter on its bound                                               */
    const char *text; /* which parameters change together                                       */
};

struct wf_fit_group { /* the readings of one sensor in one test */
    size_t test, sensor, n;
    double sigma;       /* of one reading: given or estimated, mean over the readings [SI]            */
    double correlation; /* of neighbouring residuals [-]                                              */
    double inflation;   /* of sigma, because neighbouring residuals are correlated                    */
    double rms;         /* of the residuals [SI]                                                      */
};

struct wf_fit {
    const struct wf_experiment *x;
    const struct wf_fit_param *param;
    size_t params, free; /* free: those other than nuisance, which come first                      */
    double *internal;
    struct wf_estimate *estimate;
    double *covariance, *correlation; /* params x params, of internal values                       */
    double *reading, *slope;          /* predicted at the optimum [SI]; slope: data x params                */
    double *sigma;      /* per datum, as used in the fit [SI]                                     */
    double *residual;   /* per datum, (measured - predicted) / sigma                              */
    double *band;       /* per datum, half width of the 95 % band of the prediction [SI]          */
    double *influence;  /* per datum, largest change of a free parameter without it, in its sd    */
    size_t *influenced; /* which parameter that is                                                */
    size_t groups;
    struct wf_fit_group *group;
    double quantile;            /* of the 95 % interval, in sd                                            */
    double chi_square, reduced; /* with the given sigmas; reduced: per degree of freedom           */
    size_t freedom;
    bool sigma_estimated; /* of any sensor: then reduced is 1 by construction                      */
    double aicc;
    size_t loose_n;
    struct wf_loose *loose;
    size_t starts, starts_same; /* starting points with a solution, and those of them with the best */
    size_t resampled;           /* bootstrap data sets with a solution                               */
    bool stopped;               /* by progress, during the fit, profiles or bootstrap            */
    struct wf_lsq_result lsq;
};

/* Steps of wf_fit_run; they fill *out from a session at its optimum. */
enum wf_status wf_fit_spread(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
/* The best of several random starts within a factor of 3 of the given one, with the sigmas as they are;
 * sigmas and reduced chi-square are estimated again where it is better. */
enum wf_status wf_fit_restart(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_covariance(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                                 struct wf_err *e);
enum wf_status wf_fit_loose(struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_profiles(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
enum wf_status wf_fit_resample(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
#endif
