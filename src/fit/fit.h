#ifndef WF_FIT_FIT_H
#define WF_FIT_FIT_H
/* Calibration: the parameters that make the engine read what the sensors read, and how well they are known.
 */
#include "base/diag.h"
#include "fit/lsq.h"
#include "fit/param.h"

struct wf_fit_options {
    enum wf_loss loss;
    double loss_scale; /* in robust standard deviations; NAN: 1.345 Huber, 2.385 Cauchy, 4.685 Tukey (95 %
                        * efficient for normal errors; Holland and Welsch 1977)                          */
    bool priors;       /* the species table's ranges take part as normal distributions                   */
    bool profile;      /* intervals by profile likelihood as well                                        */
    size_t starts, resamples; /* starting points tried (1: the given one); bootstrap data sets (0: none)  */
    uint64_t seed;
    wf_lsq_progress *progress; /* may be NULL; ctx is progress_ctx */
    void *progress_ctx;
};
void wf_fit_options_default(struct wf_fit_options *o);

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

/* Akaike's criterion with the correction for few data (Hurvich and Tsai 1989), variance unknown: n ln(S/m) +
 * 2 k + 2 k (k+1)/(n-k-1), S = squared residuals over the sigmas of `like`, m = readings, k = parameters + 1,
 * n = readings that do not repeat their neighbours (each sensor's over its inflation squared, of `like`). To
 * compare two fits of the same data give both the same `like`. NAN where there are too few data. */
double wf_fit_aicc(const struct wf_fit *f, const struct wf_fit *like);

/* Fit. Given: experiment, parameters (free ones first, then nuisance) with start and bounds, options.
 * Returned: WF_OK and *out, all from `a`; warnings in d. Errors: WF_EUSAGE, WF_EINPUT as wf_lsq_solve.
 * Method: least squares of readings over their sigma. Sigmas not given are found from the residuals, sensor
 * by sensor, until they agree. Where neighbouring residuals of a sensor are correlated (r of lag 1), sigma is
 * enlarged by sqrt((1+r)/(1-r)), the loss of independent readings in a first-order autoregressive series
 * (Bartlett 1946). A reduced chi-square above 1 enlarges all sigmas by its root. Covariance: inverse of J'J;
 * with a robust loss the sandwich of Huber 1967. */
enum wf_status wf_fit_run(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                          const struct wf_fit_options *o, struct wf_arena *a, struct wf_diag *d,
                          struct wf_fit *out, struct wf_err *e);
#endif
