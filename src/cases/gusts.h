/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_GUSTS_H
#define WF_CASES_GUSTS_H
/* Validation cases about gusts: the gust factor of a design code for a structure of given size, frequency and
 * damping (WF_SHAPE_GUST, no tree), and a stem in a stand at the peak of its load (--peak gales). Quantities
 * are named as in wf_quantities. */
#include "cases/build.h"

/* Name of a key that a quantity needs and the case does not give; NULL when complete. */
const char *wf_gust_missing(const struct wf_case *c, const char *quantity);

/* A quantity of a code's gust factor. Given: a case in which nothing is missing. Returned: *out [-]. */
void wf_gust_answer(const struct wf_case *c, const char *quantity, double *out);

/* A quantity of a stem in a stand, bent by the beam solver, in the wind of the case. Returned: *out [SI].
 * Errors: WF_EINPUT without wind; those of the peak method and the search. */
enum wf_status wf_stand_answer(const struct wf_case *c, const struct wf_setup *s, const char *quantity,
                               struct wf_arena *a, double *out, struct wf_err *e);
#endif
