/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_CROSSING_H
#define WF_FAIL_CROSSING_H
/* The lowest wind speed at which any of many utilisations reaches 1, from their values and slopes at few
 * speeds. The caller solves the tree at the speed that wf_crossing_step names, adds a node, and calls again.
 */
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_crossing_node {
    double speed;       /* [m/s] */
    bool solved;        /* an equilibrium was found; else values and slopes are not read */
    double trusted;     /* between this node and its neighbours, a curve below this value is trusted to stay
                           below 1: 1 where the tree moves smoothly, less where parts of it may snap */
    const float *value; /* utilisation per item [-] */
    const float *slope; /* its derivative by the speed [s/m] */
};

enum wf_crossing_next {
    WF_CROSSING_SOLVE, /* solve the tree at `speed` */
    WF_CROSSING_FOUND, /* it is at `speed`, with `gradient` */
    WF_CROSSING_ABOVE, /* no utilisation reaches 1 up to the highest speed */
    WF_CROSSING_LOST   /* no equilibrium at the lowest speed without a known crossing below it, failure at
                          speed 0, or curves that are not smooth: wf_critical_search is to be used */
};
struct wf_crossing {
    double speed;     /* [m/s] */
    double low, high; /* the bracket, or range searched [m/s] */
    double gradient;  /* slope of the governing utilisation at `speed` [s/m] */
};

/* The next step. Given: n nodes in ascending order of speed, none twice; `items` indices of the values that
 * count; the highest speed [m/s]; relative tolerance on the speed. Returned: what to do, and *out. Method:
 * each utilisation is a cubic of the speed by its values and slopes at both ends of an interval (Hermite). An
 * interval has no crossing where this cubic and a second curve with the same values and slopes (a cubic of
 * the speed's square; from speed 0, a power of the speed) stay below 1 by three times their difference, and
 * where the slopes at the ends do not differ from the mean slope by more than a factor 5 or are small, and
 * where it is no wider than 12.5 m/s or no utilisation is above 0.4; else the middle one
 * of the steps of wf_critical_rung inside the interval is solved. An interval without such a step inside is
 * accepted, so that the search sees at least what wf_critical_search sees where the curves are not smooth. */
enum wf_crossing_next wf_crossing_step(const struct wf_crossing_node *node, size_t n, const size_t *item,
                                       size_t items, double speed_max, double tolerance,
                                       struct wf_crossing *out);

/* A cubic over the interval [a, b] from values and slopes at its ends, at x. */
double wf_crossing_cubic(double a, double b, double ya, double yb, double da, double db, double x);

#ifdef __cplusplus
}
#endif
#endif
