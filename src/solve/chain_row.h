#ifndef WF_SOLVE_CHAIN_ROW_H
#define WF_SOLVE_CHAIN_ROW_H
/* One row of the chain as a cantilever with a straight axis and a tapered section. */
#include "data/tree.h"
#include "load/load.h"
#include "solve/chain.h"

enum { WF_CHAIN_POINTS = 8 };

/* Eight-point Gauss-Legendre rule on 0..1, and above[k][j]: the moment about point k of a line load through
 * the values f_j at the points, from point k to the end: sum_j above[k][j] f_j, exact to degree 7. */
struct wf_chain_rule {
    double x[WF_CHAIN_POINTS], w[WF_CHAIN_POINTS], above[WF_CHAIN_POINTS][WF_CHAIN_POINTS];
};
void wf_chain_rule_fill(struct wf_chain_rule *g);

struct wf_chain_row {
    double load[3];        /* line load, summed [N]                                     */
    double load_moment[3]; /* its moment about the row's base [N m]                     */
    double bend[3];        /* displacement of the end against the clamped base [m]      */
    double turn[3];        /* rotation of the end against it [rad]                      */
};
/* Given: rule, scheme, tree, row, loads, force [N] and moment [N m] the upper part puts on the row's end.
 * Returned: *out.
 * Method: curvature M/(EI) across and M/(GJ) along the axis, integrated by the rule over panels short enough
 * (radius ratio at most 1.5) for rounding-error accuracy; displacement = integral of (l - s) curvature x
 * tangent. */
void wf_chain_row_bend(const struct wf_chain_rule *g, const struct wf_chain_scheme *c,
                       const struct wf_tree *t, size_t i, const struct wf_loads *l, const double force[3],
                       const double moment[3], struct wf_chain_row *out);
#endif
