/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_MEASURE_H
#define WF_CASES_MEASURE_H
/* The quantities that can be wanted of a case, as rows. */
#include "base/units.h"
#include "cases/build.h"
#include "cases/case.h"
#include "cases/words.h"

enum wf_need { WF_NEED_NOTHING, WF_NEED_PLACE, WF_NEED_NUMBER, WF_NEED_POINT, WF_NEED_NAME };
enum wf_answer { WF_BY_SOLVER, WF_BY_MODES, WF_BY_BUCKLING, WF_BY_FLOW, WF_BY_SETUP, WF_BY_FIT };

struct wf_measured {
    const struct wf_case *of;
    const struct wf_setup *setup;
    const struct wf_solver *solver;     /* of the response                           */
    const struct wf_response *response; /* NULL where no static answer was asked     */
    const double *frequency;            /* [Hz], `modes` of them, negative: growing  */
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
    /* out: 3 numbers of a vector, or out[0] [SI]; NULL of WF_BY_FIT */
    enum wf_status (*measure)(const struct wf_measured *m, const struct wf_want *w, double out[3],
                              struct wf_err *e);
};
extern const struct wf_quantity wf_quantities[]; /* ends at name == NULL */

/* Static answer of one solver. Errors: the solver's. */
enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e);

/* Keys a flow needs and a case does not give, in words; NULL when nothing is missing. */
const char *wf_flow_missing(const struct wf_case *c);

/* Reading the places and wanted values of a validation case. */

/* "base", "tip", "node 3", "row 1000", "at 0.5"; false after a report. */
bool wf_place_read(struct wf_words *w, struct wf_place *p);

/* The line "want QUANTITY [PLACE] [x|y|z|norm] VALUES UNIT [within [absolute] TOLERANCE]"; false after a
 * report. */
bool wf_want_read(struct wf_words *w, struct wf_want *want);

/* The quantity's name and the words of its place: "displacement node 2 x". */
void wf_want_print(const struct wf_want *w, int component, char *buf, size_t size);
#endif
