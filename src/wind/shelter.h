/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SHELTER_H
#define WF_WIND_SHELTER_H
/* The wind inside and behind a tree: what its own branches and leaves leave of it.
 *
 * Source of the plan: Feng, Yan, Chen & Wu (1999, section 3). The tree is cut across the wind into slabs,
 * each slab is projected along the wind on a grid of width x height, and how far cells and their neighbours
 * are covered decides what the slab does to the wind. The slabs are taken from the windward side; that is the
 * depth order, and within a slab what overlaps covers once.
 *
 * Coverage of a cell: opaque wood is the exact union of the segments' silhouettes (wind/raster.h). Leaves are
 * a cloud along their segment: the frontal area of a piece is spread evenly over the silhouette of a cylinder
 * of radius `leaf_reach` around it, so leaf area is neither lost nor made on any grid; clouds add up in
 * optical depth tau, and let exp(-tau) of the wind's paths pass (Monsi & Saeki 1953; Nilson 1971, random
 * leaves). Together: coverage = 1 - (1 - wood) exp(-tau).
 *
 * Classes. A cell is open where its coverage is at most `clear`, else covered.
 *   cylinder      covered, in a run of covered cells across (or up) that ends at open cells on both sides and
 *                 is no wider than the thickest segment and two cells: a single stem or branch. The narrower
 *                 of the two runs counts, its solid width is the diameter.
 *   hole          open, with covered cells within `gap` cells on all four sides
 *   slit          open, with covered cells within `gap` cells on two opposite sides only
 *   transmitting  any other covered cell; `full` and more counts as fully covered in the statement
 *   none          any other open cell; beyond the grid all is open
 *
 * Laws turn coverage into wind and are rows: wf_shelter_laws. Results are ratios to the undisturbed wind at
 * the same place and so hold for every wind speed, as long as the leaves keep their frontal area. */
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
    bool as_printed; /* reproduces a paper's picture, not physics */
    size_t parts;    /* components of the ratio it changes: 1 along the wind, 3 all */
    /* Fill s->part from coverage and classes. */
    enum wf_status (*fill)(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e);
};

enum { WF_SHELTER_CELLS_MAX = 40000000 }; /* slabs x cells x cells: about 2 GB */
struct wf_shelter_request {
    const struct wf_shelter_law *law;
    size_t slabs, cells; /* 1..512 along the wind; 8..1024 across and up      */
    double transmission; /* of a fully covered cell, 0..1: share of ...       */
    bool energy;         /* ... the wind's energy (speed: its root), else of its speed */
    double wood_drag;    /* Cd of wood, on its silhouette [-]                 */
    double crown_drag;   /* Cd by which the tree's sail columns were multiplied [-] */
    double sail_share;   /* of the sail left in the wind (streamlining), 0..1 [-] */
    double leaf_reach;   /* of leaves from their segment's axis [m]           */
    double clear, full;  /* coverage of open and fully covered cells [-]      */
    size_t gap;          /* widest hole or slit [cells]                       */
    double wake_growth;  /* standard deviation of a wake per distance (law wake) [-] */
};
/* Refuse what no shelter can be made with: WF_EUSAGE with name, value and range. */
enum wf_status wf_shelter_request_check(const struct wf_shelter_request *q, struct wf_err *e);
/* Share of the speed that a fully covered cell lets through [-]. */
double wf_shelter_speed_share(const struct wf_shelter_request *q);

struct wf_shelter_slab {
    size_t cells[WF_CELL_CLASSES], full; /* by class; of the transmitting those fully covered */
    double wood, leaf;                   /* silhouette of wood, frontal area of leaves [m2] */
    double covered;                      /* of the grid, [m2]                               */
    double speed; /* mean ratio of the wind that arrives at the slab, over the grid [-] */
    double flux;  /* the same weighted by the undisturbed speed: volume flux through the grid over the
                   * undisturbed one [-]; what is missing passes beside the grid or above it */
};

/* So many slabs behind a slab begins its wake on the planes: the splines between planes reach one and a half
 * to each side, and none of it may reach back into the slab itself. */
#define WF_SHELTER_LAG 2.0

struct wf_shelter {
    struct wf_shelter_request request;
    struct wf_wind base;              /* undisturbed wind                                        */
    double axis[3][3];                /* along the wind, across (to its left), up; right-handed  */
    double low[3], step[3];           /* grid's corner in that frame, size of a cell; along: of a slab [m] */
    size_t slabs, across, up, planes; /* planes: slabs and as many again behind, see below */
    double *wood, *leaf;              /* slabs*up*across: coverage by wood [-], optical depth of leaves [-] */
    uint8_t *class;                   /* slabs*up*across                                          */
    double *width;                /* diameter of a cylinder, width of a slit [m]; negative when it is measured
                                   * upwards, so that branch or slit lies level; 0 for others */
    double *part[3];              /* planes*up*across: 1 - ratio along, minus the ratios across and up [-];
                                   * NULL: zero. Plane p holds the losses of slabs 0..p and stands at the centre
                                   * of slab p + WF_SHELTER_LAG */
    struct wf_shelter_slab *slab; /* slabs + 1: the last is the wind that leaves the tree */
};

/* Given: a tree (bent or not), the undisturbed wind (its direction counts, not its speed), a request.
 * Returned: the shelter, in the arena. Errors: WF_EUSAGE for a bad request, WF_ENOMEM.
 *
 * What a segment meets is the shelter of the slabs windward of its own: nothing stands in its own wake while
 * it stays where it was when the grid was made; bent trees need the shelter of their bent shape. */
enum wf_status wf_shelter_make(const struct wf_tree *t, const struct wf_wind *base,
                               const struct wf_shelter_request *q, struct wf_arena *a, struct wf_shelter *out,
                               struct wf_err *e);

/* Coverage of a cell by wood and leaves together [0..1]. */
double wf_shelter_coverage(const struct wf_shelter *s, size_t cell);

/* Ratio of the wind to the undisturbed one at a point [m]: along, across, up; its gradient in global
 * coordinates slope[3*i + j] = d ratio_i / d x_j [1/m]. Quadratic B-splines over slabs and cells: continuous
 * with a continuous gradient; beside and above the grid 1, 0, 0 within a cell, behind the last plane
 * constant.
 */
void wf_shelter_ratio(const struct wf_shelter *s, const double x[3], double ratio[3], double slope[9]);
/* The sheltered wind as a field: base with wind->speed kept live, so searches may scale it. *s must outlive
 * it. */
void wf_shelter_field(const struct wf_shelter *s, struct wf_wind *out);

/* Coordinates along, across, up. */
static inline void wf_shelter_turn(const struct wf_shelter *s, const double x[3], double out[3])
{
    for (int i = 0; i < 3; i++) out[i] = s->axis[i][0] * x[0] + s->axis[i][1] * x[1] + s->axis[i][2] * x[2];
}
#endif
