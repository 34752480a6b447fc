/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_MEASURE_H
#define WF_CASES_MEASURE_H
/* A case made ready to run, and the quantities that can be wanted of it. Inside the validation runner. */
#include "base/units.h"
#include "cases/case.h"
#include "cases/words.h"
#include "wind/wind.h"

/* Tree, loads and options of a case. */
struct wf_setup {
    struct wf_tree tree;
    struct wf_wind wind;
    struct wf_loads loads;
    struct wf_solve_options options;
    size_t rows;   /* rows before splitting                                  */
    int32_t *last; /* rows: the last part of a row after splitting           */
    double *end;   /* rows: share of the length at a row's end (cantilever, arc) */
};

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

/* Row of a place of the case that was built, on the split tree; -1 = the base. */
int32_t wf_setup_row(const struct wf_setup *s, const struct wf_place *p);

/* Build it from a case; every row split into `pieces` equal parts. `s` stays where it is: the loads point
 * into it. Errors: WF_EINPUT naming file and line, WF_EMISSING when the case's tree file is not there,
 * WF_ENOMEM. */
enum wf_status wf_setup_build(const struct wf_case *c, size_t pieces, struct wf_arena *a, struct wf_setup *s,
                              struct wf_err *e);

/* Split every row of a tree, with its loads and the curvature of its axis, into `pieces` equal arcs.
 * Given: tree, line loads (6n or NULL). Returned: the split tree, line loads (or NULL). WF_ENOMEM. */
enum wf_status wf_tree_split(const struct wf_tree *t, const double *line, size_t pieces, struct wf_arena *a,
                             struct wf_tree *out, double **out_line, struct wf_err *e);

/* Tree file: CSV with id, parent, x0..z1, radius0, radius1 and level, metres. E, nu, density are the case's.
 */
enum wf_status wf_case_tree_read(const char *path, struct wf_arena *a, struct wf_tree *t, struct wf_err *e);

/* Running what a validation case asks for. */

/* Static answer of one solver. Errors: the solver's. */
enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e);

/* What can be wanted of a potential flow (wind/potential.h). Inside the validation runner. */

/* Keys a flow needs and a case does not give, in words; NULL when nothing is missing. */
const char *wf_flow_missing(const struct wf_case *c);

/* Reading the places and wanted values of a validation case. */

/* "base", "tip", "node 3", "row 1000", "at 0.5"; false after a report. */
bool wf_place_read(struct wf_words *w, struct wf_place *p);

/* The line "want QUANTITY [PLACE] [x|y|z|norm] VALUES UNIT [within [absolute] TOLERANCE]"; false after a
 * report. */
bool wf_want_read(struct wf_words *w, struct wf_want *want);
#endif
