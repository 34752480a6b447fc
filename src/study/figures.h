/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_FIGURES_H
#define WF_STUDY_FIGURES_H
/* What each row bears at one wind speed, and the whole tree's totals, from a solver's answer. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/solve.h"
#include "study/analysis.h"

struct wf_totals {
    double air[3]; /* force of the wind on the whole tree [N]       */
    double weight; /* of wood, leaves and burdens, rows and tips [N] */
};

/* Given: tree, the loads the solver had, its answer, direction the wind blows towards (unit vector), crown
 * drag coefficient by which the sail columns were multiplied. Returned: columns of n in *out and the totals.
 * Method: horizontal forces of the wind are the solver's own loads (wf_response.load), so that all rows' drag
 * adds up to the base shear; a horizontal dead load would count as wind. The vertical part of lift, weight
 * and area come from five-point Gauss quadrature along each row. A geometrically exact answer is sampled on
 * its bent shape (cubic Hermite curve through the row's ends and end tangents); a small-deflection answer on
 * the unloaded shape, where its loads acted. Projected area of the axis is that of its surface seen along the
 * wind; that of the crown is its still-air frontal area times the streamlining share, which puts the whole
 * loss of drag into area. Deflection and slope are counted from the unloaded shape, so they hold the sag
 * under weight as well. */
enum wf_status wf_figures_fill(const struct wf_tree *t, const struct wf_loads *l, const struct wf_response *r,
                               const double direction[3], double crown_drag, struct wf_arena *a,
                               struct wf_figures *out, struct wf_totals *totals, struct wf_err *e);
#endif
