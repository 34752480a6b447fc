/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_BUILD_H
#define WF_CASES_BUILD_H
/* From a validation case to what a solver needs: its tree, loads and options. */
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
    size_t rows;   /* number of rows before splitting */
    int32_t *last; /* per row: its last part after splitting */
    double *end;   /* per row: share of the length at its end (cantilever, arc) */
};

/* Row on the split tree of a place of the case that *s was built from; -1 = the base. */
int32_t wf_setup_row(const struct wf_setup *s, const struct wf_place *p);

/* Build tree, loads and options of a case, with every row split into `pieces` equal parts. *s must not move,
 * because its loads point into it. Errors: WF_EINPUT naming file and line, WF_EMISSING when the case's tree
 * file does not exist, WF_ENOMEM. */
enum wf_status wf_setup_build(const struct wf_case *c, size_t pieces, struct wf_arena *a, struct wf_setup *s,
                              struct wf_err *e);

/* Split every row of a tree, with its loads and the curvature of its axis, into `pieces` equal arcs. Given:
 * tree, line loads (6n or NULL). Returned: *out, the split tree; *out_line, its line loads (or NULL).
 * Errors: WF_EINPUT (too many rows), WF_ENOMEM. */
enum wf_status wf_tree_split(const struct wf_tree *t, const double *line, size_t pieces, struct wf_arena *a,
                             struct wf_tree *out, double **out_line, struct wf_err *e);

/* Read a tree file: CSV with columns id, parent, x0..z1, radius0, radius1 [m] and level. Material properties
 * are not in the file; the case gives them. Errors: WF_EINPUT naming file and line, WF_ENOMEM, and those of
 * opening the file. */
enum wf_status wf_case_tree_read(const char *path, struct wf_arena *a, struct wf_tree *t, struct wf_err *e);
#endif
