/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_WINDS_H
#define WF_STUDY_WINDS_H
/* What an analysis computes over a range of winds: critical wind speeds, and the curves of its totals. They
 * share their solutions. */
#include "study/analysis.h"

/* Measured: memory of one solution for a row of the tree (two meshes of the beam solver, the finer of about
 * two elements a row) [bytes]. */
enum { WF_SOLUTION_BYTES = 4500 };

/* Solutions at single speeds. */
enum { WF_KNOWN_MAX = 240 };
struct wf_known {
    int n;
    double tolerance[WF_KNOWN_MAX]; /* of the mesh */
    bool used[WF_KNOWN_MAX];        /* by a search; others were solved ahead, as many as there are threads */
    struct wf_at_speed at[WF_KNOWN_MAX];
};

/* As wf_analysis_breaks; *known gains the solutions of the searches. */
enum wf_status wf_known_breaks(const struct wf_analysis *an, const struct wf_solve_options *o,
                               struct wf_known *known, struct wf_break (*out)[WF_SCOPES], struct wf_err *e);

/* The curves of an analysis whose speeds are solved and whose critical speeds are found with *known.
 * Returned: an->sweep. Method: the solutions at hand are nodes; further rows are solved until the nodes
 * predict each other; the other rows are interpolated by cubics of logarithms. Errors: WF_ENOMEM, or that of
 * a solution. */
enum wf_status wf_known_curve(struct wf_analysis *an, const struct wf_solve_options *o,
                              const struct wf_known *known, struct wf_arena *a, struct wf_err *e);
#endif
