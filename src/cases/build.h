/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_BUILD_H
#define WF_CASES_BUILD_H
/* A validation case made ready to run: its tree, loads and options. */
#include "base/arena.h"
#include "base/err.h"
#include "cases/case.h"
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
#endif
