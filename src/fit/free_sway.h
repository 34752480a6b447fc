/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_FREE_SWAY_H
#define WF_FIT_FREE_SWAY_H
/* Internal to the predictor: natural frequencies and damping of free sway. */
#include "fit/sensor.h"

/* Readings of a test of free sway, with their derivatives (slope may be NULL), from *at on; *at becomes the
 * index of the first datum after them. Errors: WF_EUNSTABLE where the tree has no equilibrium under its
 * weight; WF_ENOMEM. */
enum wf_status wf_free_sway_test(struct wf_predictor *w, size_t index, const double *internal,
                                 double *reading, double *slope, size_t *at, struct wf_err *e);

/* Say of the last predictions where another mode than that taken carries more than half of its share. */
void wf_free_sway_warn(const struct wf_predictor *w, struct wf_diag *d);
#endif
