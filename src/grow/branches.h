/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_BRANCHES_H
#define WF_GROW_BRANCHES_H
/* Generators of branched trees: the axes of a tree, level by level, grown by branching levels or by an
 * iterated function system, and the conversion of the axes to the rows of a tree. */
#include "base/arena.h"
#include "base/err.h"
#include "data/branching.h"
#include "data/model.h"
#include "data/tree.h"

struct wf_species;

/* Places on an axis are counted in ticks of a tenth of a segment, so that no row is shorter than that. */
enum { WF_AXIS_TICKS = 10, WF_AXIS_ROWS_MAX = 20000000 };

struct wf_axis {
    double base[3];
    double side[3], direction[3]; /* unit vectors; azimuths about the axis start at `side` */
    double length, radius;        /* [m], radius at the base                              */
    uint64_t key;                 /* stream of its random numbers (base/random.h)         */
    uint32_t tick;                /* its place on the parent; 0 for the stem              */
    int32_t parent;               /* axis of the level below; -1 for the stem             */
    int32_t row;                  /* row it starts from; later its own first row          */
};

/* How the axes of a level are divided and shaped. */
struct wf_axis_form {
    size_t segments;
    struct wf_curve curve;
    double tip_share, taper_power;   /* taper when `taper` is NULL                         */
    const struct wf_model *taper;    /* the model's own taper; NULL: tip_share, taper_power */
    const struct wf_along *knots[2]; /* places where a row must end as well; NULL: none     */
    double leaf_from, leaf_to;       /* part that has leaves; both 0: none                  */
};

struct wf_axes {
    size_t levels;
    size_t n[WF_BRANCH_LEVELS_MAX];
    struct wf_axis *axis[WF_BRANCH_LEVELS_MAX]; /* sorted by parent */
    struct wf_axis_form form[WF_BRANCH_LEVELS_MAX];
    uint64_t seed;
};

/* The centre line of one axis: ends of its segments and the frames along it. */
struct wf_course {
    size_t segments;
    double (*node)[3];      /* segments + 1 places [m]      */
    double (*side)[3];      /* per segment, unit            */
    double (*direction)[3]; /* per segment, unit            */
};

/* A unit vector perpendicular to `direction`: towards the upper side; for a vertical direction +x. */
void wf_side_of(const double direction[3], double side[3]);

/* Convert axes to the rows of a tree: level by level from the stem, so that parents come first. Returned:
 * geometry, radii and levels, and in leaf0 = leaf1 the share of each row that has leaves. Errors: WF_EINPUT
 * for more than WF_AXIS_ROWS_MAX rows, WF_ENOMEM. */
enum wf_status wf_axes_to_tree(struct wf_axes *x, const char *name, struct wf_arena *a, struct wf_tree *out,
                               struct wf_err *e);

/* Axes of a tree of levels: a stem, the branches on it, the branches on those, each level with its own
 * parameters (Tang and others 2012: chains of frustum segments with an angle between neighbours, each branch
 * at a relative position of its parent with a start angle). Given: a model of generator levels, the species
 * (for radii), an arena for the axes. Returned: *out; *capped, the number of branches whose radius was
 * reduced to that of their parent. Every random number of a branch has the address (seed, path of the
 * branch), so it depends neither on the order in which branches grow nor on the other branches. Errors:
 * WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_levels_axes(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_axes *out, size_t *capped, struct wf_err *e);

/* Radii by the pipe model, on the levels whose radius law asks for it. Given: the tree made from the axes.
 * Returned: its radii; *thick, the number of branches that are thicker than the row they start from. Source:
 * Shinozaki, Yoda, Hozumi and Kira (1964), A quantitative analysis of plant form: the pipe model theory.
 * Errors: WF_ENOMEM. */
enum wf_status wf_levels_pipes(const struct wf_model *m, struct wf_tree *t, size_t *thick, struct wf_err *e);

/* Axes of a tree by an iterated function system (Zhao and Zhang 2013; Barnsley 1988, Fractals Everywhere):
 * every map of the system puts a smaller copy of the whole tree onto its axis, so the axes of level k are the
 * images of the stem under all products of k maps. Given: a model of generator ifs, the base radius of the
 * stem [m], an arena for the axes. Returned: *out, the axes, all divided and tapered like the stem; *capped,
 * the number of axes whose radius was reduced to that of the part they start from. The place of a copy on its
 * axis is rounded to a tick. Errors: WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_ifs_axes(const struct wf_model *m, double base_radius, struct wf_arena *a,
                           struct wf_axes *out, size_t *capped, struct wf_err *e);
#endif
