/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_BRANCHES_H
#define WF_GROW_BRANCHES_H
/* The axes of a branched tree, level by level, and the rows they become: shared by the generators. */
#include "base/arena.h"
#include "base/err.h"
#include "data/branching.h"
#include "data/model.h"
#include "data/species.h"
#include "data/tree.h"

/* Places on an axis are counted in ticks, a tenth of a segment: so no row is shorter than that. */
enum { WF_AXIS_TICKS = 10, WF_AXIS_ROWS_MAX = 20000000 };

struct wf_axis {
    double base[3];
    double side[3], direction[3]; /* unit; `side` is where azimuths about the axis begin */
    double length, radius;        /* [m], radius at the base                              */
    uint64_t key;                 /* address of its random numbers                        */
    uint32_t tick;                /* its place on the parent; 0 for the stem              */
    int32_t parent;               /* axis of the level below; -1 for the stem             */
    int32_t row;                  /* segment it grows from, then its own first segment    */
};

/* How all axes of a level are cut and shaped. */
struct wf_axis_form {
    size_t segments;
    struct wf_curve curve;
    double tip_share, taper_power;   /* of the levels above the stem, when `taper` is NULL */
    const struct wf_model *taper;    /* the model's own taper; NULL: tip_share, taper_power */
    const struct wf_along *knots[2]; /* places where a row must end as well; NULL: none     */
    double leaf_from, leaf_to;       /* part that bears leaves; empty: none                 */
};

struct wf_axes {
    size_t levels;
    size_t n[WF_BRANCH_LEVELS_MAX];
    struct wf_axis *axis[WF_BRANCH_LEVELS_MAX]; /* children of one parent follow each other, in the order of
                                                   their parents                             */
    struct wf_axis_form form[WF_BRANCH_LEVELS_MAX];
    uint64_t seed;
};

/* The course of one axis: ends of its segments and the frames along it. */
struct wf_course {
    size_t segments;
    double (*node)[3];      /* segments + 1 places [m]      */
    double (*side)[3];      /* per segment, unit            */
    double (*direction)[3]; /* per segment, unit            */
};
enum wf_status wf_course_take(struct wf_course *c, size_t segments, struct wf_arena *a, struct wf_err *e);
/* Given: axis and form. Returned: *c filled. Method: at every joint the direction turns towards the vertical
 * by the curve's share of its turn and to a random side by its wander; `side` is carried along without twist.
 */
void wf_course_run(const struct wf_axis *axis, const struct wf_axis_form *f, uint64_t seed,
                   struct wf_course *c);
/* Place at a tick of the course. */
void wf_course_at(const struct wf_course *c, uint32_t tick, double x[3]);

/* Radius over base radius at place s of an axis of this form. */
double wf_axis_taper(const struct wf_axis_form *f, double s);
/* A unit vector across `direction`: the upper side, or +x across a vertical one. */
void wf_side_of(const double direction[3], double side[3]);
/* The tick next to place s, at least 1, at most the tip. */
uint32_t wf_tick_of(double s, size_t segments);

/* Which part of the axes of a level bears leaves in the model's season. */
void wf_axis_leafy(const struct wf_model *m, size_t level, struct wf_axis_form *f);

/* The stem of a model as level 0. */
void wf_axes_stem(const struct wf_model *m, double base_radius, struct wf_axis *stem);

/* Rows of all axes, parents first, each level behind the one below: geometry, radius, level, and in leaf0 =
 * leaf1 the share of each row that bears leaves. Errors: WF_EINPUT for more than WF_AXIS_ROWS_MAX rows. */
enum wf_status wf_axes_to_tree(struct wf_axes *x, const char *name, struct wf_arena *a, struct wf_tree *out,
                               struct wf_err *e);

/* Trees of levels: a stem, the branches on it, those on them, each level by its own parameters (Tang and
 * others 2012: chains of frustum segments with an angle between neighbours, each branch at a relative
 * position of its parent with a start angle). */

/* Given: a model of generator levels, the species' radii, an arena for scratch. Returned: *out, the axes
 * level by level; *capped, how many branches were thinned to the radius of their parent. Every random figure
 * of a branch has the address (seed, path of the branch), so it depends neither on the order of growing nor
 * on how many other branches there are. Errors: WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_levels_axes(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_axes *out, size_t *capped, struct wf_err *e);

/* Radii by the pipe model on the levels that ask for it (Shinozaki, Yoda, Hozumi and Kira 1964, A
 * quantitative analysis of plant form: the pipe model theory): the rows of a tree grown from the axes.
 * Returned: *thick, how many branches came out thicker than the part they grow from. */
enum wf_status wf_levels_pipes(const struct wf_model *m, struct wf_tree *t, size_t *thick, struct wf_err *e);

/* Trees by an iterated function system (Zhao and Zhang 2013; Barnsley 1988, Fractals Everywhere): every map
 * of the system puts a smaller copy of the whole tree onto its axis, so the axes of level k are the images of
 * the stem under all products of k maps. */

/* Given: a model of generator ifs, the radius of the stem's base, an arena for scratch. Returned: *out, the
 * axes level by level, all cut and tapered as the stem; *capped, how many were thinned to the radius of the
 * part they grow from. A copy stands on the place of its axis that is next on a grid of tenths of a segment.
 * Errors: WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_ifs_axes(const struct wf_model *m, double base_radius, struct wf_arena *a,
                           struct wf_axes *out, size_t *capped, struct wf_err *e);
#endif
