/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_LANES_H
#define WF_SOLVE_BEAM_LANES_H
/* Newton's method for several states of one mesh at once ("lanes"): the states differ in wind and air, and do
 * not influence each other. beam_lanes.c is compiled once for every width; a lane has the same bytes at any
 * width. */
#include "solve/beam_mesh.h"

enum { WF_LANES_MOST = 8 }; /* lanes of the widest kernel */

/* Numbers in the arrays of struct wf_lanes: per element, slot or row, and lane. */
enum {
    WF_LANES_SHAPE = 12,  /* struct wf_beam_shape */
    WF_LANES_POSE = 12,   /* struct wf_beam_pose of the element's end */
    WF_LANES_ANSWER = 42, /* at most: answers of the element to a change of its base */
    WF_LANES_STEP = 6,    /* rotation vectors before the last step */
    WF_LANES_SLOT = 54,   /* what is passed between neighbouring elements */
    WF_LANES_ROW = 15, /* of a row: force and moment at its base (6), at its end (6), distributed load (3) */
    WF_LANES_SUMS = 12 /* force and moment on the ground (6), sums of the loads and of their moments (6) */
};

/* How the elements of a mesh are joined, for passing results from one to the next without an array of all. */
struct wf_lanes_joints {
    int32_t
        *slot;   /* per element: where what comes from above its end is collected; -1: nothing is above it */
    bool *opens; /* per element: the first above the end of its parent, in the order from the tips down */
    size_t slots;
};

/* What became of a lane. */
enum wf_lane_end {
    WF_LANE_LEFT, /* not found within few iterations, or not stable: to be solved by itself */
    WF_LANE_RESTS /* in equilibrium, which is stable */
};

/* Number q of item i in lane k of an array with Q numbers is at ((i * Q) + q) * width + k. */
struct wf_lanes {
    const struct wf_beam_mesh *mesh; /* of round sections; the roots are clamped */
    const struct wf_lanes_joints *joints;
    const struct wf_solve_options *options;
    const struct wf_loads *loads[WF_LANES_MOST]; /* of each lane, without point loads; the line load is that
                                                    of the mesh */
    bool wanted[WF_LANES_MOST];                  /* lanes whose states are computed */
    double *shape, *pose, *answer, *step;        /* of all elements */
    double *slot;                                /* of all slots */
    double *row, *sums;                          /* of all rows; of the tree */
    /* returned by `newton`, per lane: */
    enum wf_lane_end end[WF_LANES_MOST];
    size_t iterations[WF_LANES_MOST];
    size_t loose[WF_LANES_MOST]; /* directions in which small parts are not stable */
};

/* A point of an axis in one state. */
struct wf_lanes_point {
    const double *x, *t, *dead; /* position, unit tangent, dead load per length [N/m] */
    const struct wf_line_point *line;
};

struct wf_lanes_kernel {
    size_t width;
    /* Loads at n points of one state, at least 1, as wf_beam_load gives them; growth (NULL: none): and their
     * change by it [N/m]. */
    void (*loads)(const struct wf_loads *l, const struct wf_beam_growth *growth, size_t n,
                  const struct wf_lanes_point *p, struct wf_line_load *out, double (*change)[3]);
    /* Newton's method from the present shape. */
    void (*newton)(struct wf_lanes *x);
    /* One iteration from the present shape, for measurements. */
    void (*iterate)(struct wf_lanes *x);
    /* Place the present shape, and compute `row` and `sums`. */
    void (*read)(struct wf_lanes *x);
    /* Start shape of `fine` from the shape and pose of `coarse`, the same states on another mesh. */
    void (*carry)(const struct wf_lanes *coarse, struct wf_lanes *fine);
};
extern const struct wf_lanes_kernel wf_lanes_1, wf_lanes_4, wf_lanes_8;
/* Kernel for n states on this processor; where the environment's WINDFIRM_LANES is 1, 4 or 8, that width if
 * the processor has it. */
const struct wf_lanes_kernel *wf_lanes_kernel(size_t n);
#endif
