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

/* The two states of a node: at the peak of the load on the tree, of which stem, root and totals are taken,
 * and at that of branches. They are one where branches have no peak of their own. */
enum wf_node_part { WF_NODE_STEM, WF_NODE_BRANCHES, WF_NODE_PARTS };

/* Is a row one of those that the state of a part is of? */
bool wf_node_part_holds(const struct wf_analysis *an, enum wf_node_part part, size_t row);
struct wf_node_state {
    bool known;
    bool sloped;           /* also the slopes of its totals and of its rows' columns */
    bool irregular;        /* small parts are not stable or have snapped */
    struct wf_at_speed at; /* totals, and worst places of all rows in this state */
};

struct wf_node {
    struct wf_at_speed at;   /* of the whole tree; while not `whole`, of the state that is known */
    double tolerance;        /* of the mesh */
    bool used;               /* by a search; others were solved ahead, as many as there are threads */
    bool whole;              /* both states are known */
    bool sloped;             /* and so are all slopes */
    double slope[WF_TOTALS]; /* d total / d speed; NAN: of a state that is not known */
    double turning[2];       /* d (moment on the ground about x, y) / d speed [N m s/m] */
    struct wf_node_column column[WF_NODE_COLUMNS]; /* rows of a state that is not known: 0 */
    struct wf_node_state state[WF_NODE_PARTS];
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
/* The node at a speed, by a mesh tolerance, whole or not; NULL: none. */
struct wf_node *wf_nodes_find(struct wf_nodes *k, double speed, double tolerance);
/* Add a solution without slopes; nothing is done where there is no room or a node already. */
void wf_nodes_add(struct wf_nodes *k, double tolerance, bool used, const struct wf_at_speed *at);

/* Number of threads that may solve the tree at the same time. */
size_t wf_nodes_threads(const struct wf_analysis *an, const struct wf_solve_options *o);
/* Can nodes have slopes: does the analysis use a solver that can be tracked, on loads that depend on the wind
 * speed alone? */
bool wf_nodes_tracked(const struct wf_analysis *an);
/* The node at a speed with slopes, solved where it is not known, from the nearest solution of this tolerance.
 * Errors: as wf_speed_totals; WF_EINTERRUPTED; WF_EINTERNAL with wf_nodes_late where the time is used up. */
enum wf_status wf_nodes_solve(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                              const struct wf_node **out, struct wf_err *e);

/* The same for one state: the other need not be known. */
enum wf_status wf_nodes_solve_part(struct wf_nodes *k, const struct wf_solve_options *o, double speed,
                                   enum wf_node_part part, const struct wf_node **out, struct wf_err *e);
/* How many times as many elements as on the mesh of one tolerance there are on that of another, in all rows
 * (row -1) or in those that a row carries or is carried by, itself included [-]; 0: a mesh is not known, or is
 * that of other nodes, made for other rows to govern. */
double wf_nodes_finer(const struct wf_nodes *k, enum wf_node_part part, double coarse, double fine,
                      int32_t row);
/* The least safety at a node of the branches that are listed, from an->search.branches_from on [-]; NAN: none
 * are, or not known. */
double wf_node_branch_safety(const struct wf_analysis *an, const struct wf_node *node);

#ifdef __cplusplus
}
#endif
#endif
