/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_MEASURE_H
#define WF_CASES_MEASURE_H
/* The quantities that a case can want, as rows; reading and printing of wanted values. */
#include "base/units.h"
#include "cases/build.h"
#include "cases/case.h"
#include "cases/words.h"

enum wf_need { WF_NEED_NOTHING, WF_NEED_PLACE, WF_NEED_NUMBER, WF_NEED_POINT, WF_NEED_NAME };
enum wf_answer {
    WF_BY_SOLVER,
    WF_BY_MODES,
    WF_BY_BUCKLING,
    WF_BY_FLOW,
    WF_BY_SETUP,
    WF_BY_FIT,
    WF_BY_GUST,
    WF_BY_STAND
};

struct wf_measured {
    const struct wf_case *of;
    const struct wf_setup *setup;
    const struct wf_solver *solver;     /* of the response */
    const struct wf_response *response; /* NULL where no static solution is needed */
    const double *frequency;            /* [Hz], `modes` of them; negative: a growing motion */
    size_t modes;
    double buckling_factor;
    struct wf_arena *arena;
};

struct wf_quantity {
    const char *name;
    enum wf_dimension dimension;
    bool vector;
    enum wf_need need;
    enum wf_answer by;
    /* out: 3 numbers of a vector, else out[0] [SI]; NULL for WF_BY_FIT */
    enum wf_status (*measure)(const struct wf_measured *m, const struct wf_want *w, double out[3],
                              struct wf_err *e);
};
extern const struct wf_quantity wf_quantities[]; /* ends at name == NULL */

/* Run one static solver. Returned: *r. Errors: the solver's; WF_EUNSTABLE when it reached only part of the
 * load. */
enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e);

/* Name of a key that the case's flow needs and the case does not give; NULL when complete. */
const char *wf_flow_missing(const struct wf_case *c);

/* Read a place: "base", "tip", "node 3", "row 1000", "at 0.5". Returned: *p; false after reporting a
 * mistake. */
bool wf_place_read(struct wf_words *w, struct wf_place *p);

/* Read the words after 'want': QUANTITY [PLACE] [x|y|z|norm] VALUES UNIT [within [absolute] TOLERANCE].
 * Returned: *want; false after reporting a mistake. */
bool wf_want_read(struct wf_words *w, struct wf_want *want);

/* Print the quantity's name and place, as "displacement node 2 x", into buf[size]. */
void wf_want_print(const struct wf_want *w, int component, char *buf, size_t size);
#endif
