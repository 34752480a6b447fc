/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_NODE_H
#define WF_STUDY_NODE_H
/* The wind speeds at which an analysis solved its tree: searches for critical speeds and curves share them.
 * With a solver that can be tracked, each has slopes by the wind speed. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Totals of which curves are drawn. Safety is interpolated as its inverse. */
enum wf_total {
    WF_TOTAL_DRAG,
    WF_TOTAL_LIFT,
    WF_TOTAL_WEIGHT,
    WF_TOTAL_DEFLECTION,
    WF_TOTAL_ANGLE,
    WF_TOTAL_SHEAR,
    WF_TOTAL_MOMENT,
    WF_TOTAL_STRESS,
    WF_TOTAL_UTILISATION, /* by criterion and scope */
    WF_TOTALS = WF_TOTAL_UTILISATION + WF_CRITERIA * WF_SCOPES
};
void wf_totals_read(const struct wf_at_speed *at, double v[WF_TOTALS]);
/* Sections are then unknown. */
void wf_totals_write(const double v[WF_TOTALS], double tallness, struct wf_at_speed *at);

/* Options for solutions while a crossing is searched and for curves, finer than drawn: the tolerance of the
 * mesh is at least 1e-3. */
struct wf_solve_options wf_nodes_quick(const struct wf_solve_options *o);

/* Columns of a node: utilisation by criterion, then the largest stress of each row [Pa]. */
enum { WF_NODE_STRESS = WF_CRITERIA, WF_NODE_COLUMNS };
/* Values of the rows and d value / d speed; 0: unknown. NULL: the resistance is known of no row. */
struct wf_node_column {
    float *value, *gain;
};

struct wf_node {
    struct wf_at_speed at;
    double tolerance;        /* of the mesh */
    bool used;               /* by a search; others were solved ahead, as many as there are threads */
    bool sloped;             /* what follows is known */
    bool irregular;          /* small parts are not stable or have snapped */
    double slope[WF_TOTALS]; /* d total / d speed */
    struct wf_node_column column[WF_NODE_COLUMNS];
};

struct wf_nodes;
enum { WF_NODES_MAX = 240 };
/* None at first, for an analysis after wf_analysis_set_up. The processor time that solutions may take ends
 * after an->search.seconds from now. `like` (NULL: none), nodes of the same tree in another wind direction,
 * which outlive these and are not used meanwhile: their solutions in still air and their meshes are taken.
 * Errors: NULL, not enough memory. */
struct wf_nodes *wf_nodes_open(const struct wf_analysis *an, const struct wf_nodes *like);
/* The same for a tree whose rows differ from those of `like` in their values alone: the meshes are taken, and
 * solutions start at its last one. */
struct wf_nodes *wf_nodes_open_kin(const struct wf_analysis *an, const struct wf_nodes *like);
void wf_nodes_close(struct wf_nodes *k);                    /* NULL is allowed */
void wf_nodes_deadline(struct wf_nodes *k, double seconds); /* from now */
bool wf_nodes_late(const struct wf_nodes *k); /* the deadline has passed: it stays so once said */

size_t wf_nodes_count(const struct wf_nodes *k);
const struct wf_node *wf_nodes_at(const struct wf_nodes *k, size_t i);
/* Can another be solved? Errors: WF_EINTERRUPTED; WF_EINTERNAL with wf_nodes_late. */
enum wf_status wf_nodes_ready(struct wf_nodes *k, struct wf_err *e);
/* The node at a speed, by a mesh tolerance; NULL: none. */
struct wf_node *wf_nodes_find(struct wf_nodes *k, double speed, double tolerance);
/* Add a solution without slopes; nothing is done where there is no room. */
void wf_nodes_add(struct wf_nodes *k, double tolerance, bool used, const struct wf_at_speed *at);

/* Number of threads that may solve the tree at the same time. */
size_t wf_nodes_threads(const struct wf_analysis *an, const struct wf_solve_options *o);
/* Can nodes have slopes: does the analysis use a solver that can be tracked, on loads that depend on the wind
 * speed alone? */
bool wf_nodes_tracked(const struct wf_analysis *an);
/* The node at a speed with slopes, solved where it is not known, from the last solution of this tolerance.
 * Errors: as wf_speed_totals; WF_EINTERRUPTED; WF_EINTERNAL with wf_nodes_late where the time is used up. */
enum wf_status wf_nodes_solve(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                              const struct wf_node **out, struct wf_err *e);

/* The same for the stem alone: where branches have a peak of their own they are not solved, and the node is
 * not kept; it says nothing about them. */
enum wf_status wf_nodes_solve_stem(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                                   struct wf_node *out, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
