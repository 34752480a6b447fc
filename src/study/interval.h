/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_INTERVAL_H
#define WF_STUDY_INTERVAL_H
/* How sure a critical wind speed and a safety are: the tree is solved again with samples of all that varies
 * (study/spread.h). Each sample is grown, stands, sways and is searched on its own. */
#include "base/latin.h"
#include "study/analysis.h"
#include "study/spread.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    WF_INTERVAL_SAMPLES = 256, /* where nothing is said */
    WF_INTERVAL_LEAST = 20,    /* samples; 5 % of fewer are no sample */
    WF_INTERVAL_MOST = 4096,
    WF_INTERVAL_FEW = 64,          /* for a rough one */
    WF_INTERVAL_UNASKED = 1 << 16, /* segments times samples that are computed where nothing is said */
    WF_INTERVAL_POINTS = 101       /* of the curve */
};

struct wf_interval_request {
    size_t samples;
    uint64_t seed;
    size_t threads; /* 0: one per processor; the results are the same */
};

/* What one value does alone: critical winds with it at its 5 and 95 % points, all others at their medians
 * [m/s]; INFINITY: above the range of the search; NAN: the tree would not stand under its own weight. */
struct wf_interval_arm {
    double at_low, at_high;
};

/* Safety of the stem and the root at a given wind [-]; 0: no equilibrium. */
struct wf_interval_at {
    double speed, low, high;        /* [m/s]; 5 and 95 % */
    double wanted_low, wanted_high; /* the same with the criteria for which practice wants more than 1 */
};

/* P(the tree is lost | mean wind). */
struct wf_interval_point {
    double speed;               /* [m/s] */
    double share, below, above; /* of the samples; its 90 % band by their number */
    double fit;                 /* by the lognormal law; NAN: there is none */
};

struct wf_interval {
    struct wf_interval_request request;
    struct wf_variation variation;
    double searched_to; /* [m/s] */
    double middle;      /* critical wind with all values at their medians, on the coarse mesh [m/s] */
    double low, high;   /* 5 and 95 % of the samples [m/s]; INFINITY: above searched_to */
    size_t n;           /* samples that stand */
    double *critical;   /* of them, ascending [m/s]; 0: lost in still air; INFINITY as above */
    size_t left_out;    /* would not stand under their own weight, as the tree does */
    size_t still;       /* samples lost in still air */
    size_t lost_by[WF_CRITERIA]; /* samples by the criterion that governs */
    struct wf_lognormal fit;     /* of those that are not lost in still air */
    struct wf_interval_arm *arm; /* one for each value that varies */
    size_t winds;
    struct wf_interval_at *at;
    struct wf_interval_point *point; /* WF_INTERVAL_POINTS, evenly spaced from 0 */
};

/* Is the number of samples 0, or in range? Errors: WF_EUSAGE. */
enum wf_status wf_interval_check(const struct wf_interval_request *q, struct wf_err *e);
/* Intervals are of a solver whose solutions have slopes, without shelter in the crown, where a strength of
 * the stem or the root is known. Given: an analysis with its critical winds; its options. Returned: *out, in
 * `a`. The same for any number of threads. Errors: WF_EUSAGE (number of samples; where there is no interval);
 * WF_EINTERRUPTED; WF_ENOMEM; WF_EINPUT where fewer than half of the samples stand. */
enum wf_status wf_interval_run(const struct wf_analysis *an, const struct wf_solve_options *o,
                               const struct wf_interval_request *q, struct wf_arena *a,
                               struct wf_interval *out, struct wf_err *e);

/* Warnings: assumed and borrowed values that move the critical wind by more than 20 %; samples left out. */
void wf_interval_warn(const struct wf_analysis *an, const struct wf_interval *i, struct wf_diag *d);

/* The same into an analysis, with its warnings. Given: whether the number of samples was specified. A warning
 * says where none is computed and how to get it; after an interrupt there is none. */
enum wf_status wf_interval_take(struct wf_analysis *an, const struct wf_solve_options *o,
                                const struct wf_interval_request *q, bool specified, struct wf_arena *a,
                                struct wf_err *e);

/* What the k-th value does alone in words, with as many decimals as tell the ends apart, up to two: "9 to
 * 14", "9.1 to 9.4", "not standing to 9", "14 to above 60". Returned: false where they do not tell them
 * apart. */
bool wf_interval_arm_text(const struct wf_interval *i, size_t k, char *text, size_t size);

/* Is the root assessed, or the stem alone? */
bool wf_interval_rooted(const struct wf_analysis *an);

/* The last digit that an interval deserves, as a number of decimals: 0 or more. */
int wf_interval_decimals(double low, double high);

#ifdef __cplusplus
}
#endif
#endif
