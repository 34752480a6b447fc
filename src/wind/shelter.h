/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SHELTER_H
#define WF_WIND_SHELTER_H
/* The wind inside and behind a tree, reduced by the tree's own branches and leaves.
 *
 * Source of the procedure: Feng, Yan, Chen & Wu (1999, section 3). The tree is divided across the wind into
 * slabs, each slab is projected along the wind on a grid of width x height, and the coverage of the cells and
 * their neighbours determines the effect of the slab on the wind. The slabs are processed from the windward
 * side; within a slab, areas that overlap count once.
 *
 * Coverage of a cell: wood is opaque; its coverage is the exact union of the segments' silhouettes
 * (base/raster.h). Leaves form a cloud around their segment: the frontal area of a piece is distributed
 * evenly over the silhouette of a cylinder of radius `leaf_reach` around it, so that the leaf area is the
 * same on any grid. Clouds add in optical depth tau; the share exp(-tau) of the wind's paths is free (Monsi &
 * Saeki 1953; Nilson 1971, random leaves). Together: coverage = 1 - (1 - wood) exp(-tau).
 *
 * Classes. A cell is open where its coverage is at most `clear`, else covered.
 *   cylinder      covered, in a run of covered cells across (or up) that ends at open cells on both sides and
 *                 is not wider than the thickest segment plus two cells: a single stem or branch. Of the two
 *                 runs (across and up) the narrower one is used; its solid width is the diameter.
 *   hole          open, with covered cells within `gap` cells on all four sides
 *   slit          open, with covered cells within `gap` cells on two opposite sides only
 *   transmitting  any other covered cell; with a coverage of at least `full` it counts as fully covered
 *   none          any other open cell; cells outside the grid are open
 *
 * The laws that compute the wind from the coverage are rows: wf_shelter_laws. Results are ratios to the
 * undisturbed wind at the same place; they are valid for every wind speed as long as the leaves keep their
 * frontal area. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "wind/wind.h"
#include <stdbool.h>
#include <stdint.h>

enum wf_cell_class {
    WF_CELL_NONE,
    WF_CELL_CYLINDER,
    WF_CELL_HOLE,
    WF_CELL_SLIT,
    WF_CELL_TRANSMITTING,
    WF_CELL_CLASSES
};

struct wf_shelter;
struct wf_shelter_law {
    const char *name, *title, *source, *validity;
    bool as_printed; /* true: reproduces a publication; not a valid model of the wind */
    size_t parts;    /* components of the ratio that it changes: 1 along the wind, 3 all */
    /* Compute s->part from coverage and classes. Errors: WF_ENOMEM. */
    enum wf_status (*fill)(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e);
    bool wakes; /* takes wake_growth */
};

enum { WF_SHELTER_CELLS_MAX = 40000000 }; /* slabs x cells x cells: about 2 GB */
struct wf_shelter_request {
    const struct wf_shelter_law *law;
    size_t slabs, cells; /* 1..512 along the wind; 8..1024 across and up      */
    double transmission; /* of a fully covered cell, 0..1 [-]                 */
    bool energy;       /* true: transmission of the wind's energy (of speed: its root); false: of its speed */
    double wood_drag;  /* Cd of wood, on its silhouette [-]                 */
    double crown_drag; /* Cd that is a factor of the tree's sail columns [-] */
    double sail_share; /* share of the sail after streamlining, 0..1 [-]    */
    double leaf_reach; /* of leaves from their segment's axis [m]           */
    double clear, full; /* coverage of open and fully covered cells [-]      */
    size_t gap;         /* widest hole or slit [cells]                       */
    double wake_growth; /* standard deviation of a wake per distance (law wake) [-] */
};
/* Check a request. Errors: WF_EUSAGE with name, value and range of what is wrong. */
enum wf_status wf_shelter_request_check(const struct wf_shelter_request *q, struct wf_err *e);
/* Transmission of speed of a fully covered cell [-]. */
double wf_shelter_speed_share(const struct wf_shelter_request *q);

/* Summary of a slab. */
struct wf_shelter_slab {
    size_t cells[WF_CELL_CLASSES], full; /* number of cells by class; of fully covered cells */
    double wood, leaf;                   /* silhouette of wood, frontal area of leaves [m2] */
    double covered;                      /* of the grid, [m2]                               */
    double speed; /* mean ratio of the wind that arrives at the slab, over the grid [-] */
    double flux;  /* the same weighted by the undisturbed speed: volume flux through the grid over the
                   * undisturbed one [-]; the rest flows around the grid */
};

/* A slab's wake starts WF_SHELTER_LAG slabs downwind: the splines between planes reach 1.5 planes each way
 * and must not act on the slab itself. */
#define WF_SHELTER_LAG 2.0

struct wf_shelter {
    struct wf_shelter_request request;
    struct wf_wind base;    /* undisturbed wind                                        */
    double axis[3][3];      /* along the wind, across (to its left), up; right-handed  */
    double low[3], step[3]; /* corner of the grid in these axes; size of a cell (along: of a slab) [m] */
    size_t slabs, across, up, planes; /* planes: twice the slabs, see `part`               */
    double *wood, *leaf;              /* slabs*up*across: coverage by wood [-], optical depth of leaves [-] */
    uint8_t *class;                   /* slabs*up*across                                          */
    double *width;   /* diameter of a cylinder, width of a slit [m]; negative if it is measured upwards,
                      * across a level branch or slit; 0 for other cells */
    double *part[3]; /* planes*up*across: 1 - ratio along, minus the ratios across and up [-];
                      * NULL: zero. Plane p contains the losses of slabs 0..p and lies at the centre
                      * of slab p + WF_SHELTER_LAG */
    struct wf_shelter_slab *slab; /* slabs + 1: the last one is the wind behind the tree */
};

/* Compute the shelter of a tree. Given: a tree (bent or not), the undisturbed wind (its direction is used,
 * not its speed), a request. Returned: the shelter, in the arena. Errors: WF_EUSAGE for a wrong request,
 * WF_ENOMEM.
 *
 * A segment is sheltered by the slabs windward of its own, so that it is not in its own wake as long as it
 * stays where it was when the shelter was computed; a bent tree needs the shelter of its bent shape. */
enum wf_status wf_shelter_make(const struct wf_tree *t, const struct wf_wind *base,
                               const struct wf_shelter_request *q, struct wf_arena *a, struct wf_shelter *out,
                               struct wf_err *e);

/* Coverage of a cell by wood and leaves together [0..1]. */
double wf_shelter_coverage(const struct wf_shelter *s, size_t cell);

/* Ratio of the wind to the undisturbed wind at a point [m]. Returned: ratio[3] along, across and up [-], and
 * its gradient in global coordinates slope[3*i + j] = d ratio_i / d x_j [1/m]. Method: quadratic B-splines
 * over slabs and cells, continuous with a continuous gradient; beside and above the grid the ratio becomes 1,
 * 0, 0 within a cell, behind the last plane it is constant along the wind. */
void wf_shelter_ratio(const struct wf_shelter *s, const double x[3], double ratio[3], double slope[9]);
/* The sheltered wind as a wind field. Its `speed` may be changed, as for the base wind, so that searches can
 * scale it. *s must outlive it. */
void wf_shelter_field(const struct wf_shelter *s, struct wf_wind *out);

/* Coordinates of a point along, across and up [m]. */
static inline void wf_shelter_turn(const struct wf_shelter *s, const double x[3], double out[3])
{
    for (int i = 0; i < 3; i++) out[i] = s->axis[i][0] * x[0] + s->axis[i][1] * x[1] + s->axis[i][2] * x[2];
}
#endif
