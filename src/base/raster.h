/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_RASTER_H
#define WF_BASE_RASTER_H
/* Area coverage of a grid by convex outlines, exact to rounding (no sample points).
 *
 * Outlines are given in cell units: cell (i, k) is the square i..i+1, k..k+1 and an area is a share of a
 * cell. Outlines are combined in two ways:
 *   union  for opaque bodies: where outlines overlap the area counts once. The area is the integral
 *          1/2 (x dy - y dx) along the border of the union within the cell: each edge without its parts
 *          inside other outlines, and the parts of the cell's own border that lie inside any outline. For
 *          convex outlines each such part is one interval (Cyrus & Beck 1978): nothing is approximated.
 *   sum    for porous bodies: weights add. Each edge adds to the cells it crosses the area to its right;
 *          summing along a row then gives the areas of all outlines at once. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Most corners of an outline; edges of half an ellipse. */
enum { WF_OUTLINE_MAX = 16, WF_OUTLINE_ROUND = 6 };
/* A convex polygon, counter-clockwise. */
struct wf_outline {
    size_t n;
    double x[WF_OUTLINE_MAX][2];
};

/* Silhouette of a frustum seen along a direction. Given: the ends p0, p1 of its axis, projected on the plane
 * across the view [m]; radii r0, r1 [m]; |cosine| of the angle between axis and view; disc0, disc1: whether
 * the disc at that end is included (otherwise the end is a chord). Returned: the outline; false when its area
 * is zero (an axis along the view without discs). The area is (r0 + r1) |p1 - p0| plus 1/2 pi r^2 cosine for
 * each disc: exact for cylinders, and for cones seen from the side. The half ellipse of a disc is a polygon
 * of WF_OUTLINE_ROUND edges with the area of the half ellipse. */
bool wf_outline_frustum(const double p0[2], const double p1[2], double r0, double r1, double cosine,
                        bool disc0, bool disc1, struct wf_outline *out);
/* Area of an outline [square of its unit]. */
double wf_outline_area(const struct wf_outline *o);

enum { WF_UNION_MAX = 64 }; /* outlines in a cell that are united exactly */

/* A grid to combine outlines on: for each cell the chain of outlines that may touch it. */
struct wf_raster {
    size_t nx, ny;
    int32_t *head;             /* nx * ny: first link of each cell's chain, -1 = none        */
    int32_t *item, *next;      /* per link: outline, next link                               */
    int32_t *touched;          /* cells that have a chain, in the order they were first met  */
    size_t links, room, cells; /* links in use, links allocated, cells in `touched`          */
    double *edge;              /* of the sum: nx + 2 numbers a row                           */
    struct wf_arena *arena;
};
/* Allocate a grid of nx by ny cells. Errors: WF_ENOMEM. */
enum wf_status wf_raster_make(struct wf_raster *r, size_t nx, size_t ny, struct wf_arena *a,
                              struct wf_err *e);
/* Coverage [0..1] of every cell by the union of n outlines. Returned: out[k*nx + i]. Parts outside the grid
 * are ignored. Where more than WF_UNION_MAX outlines meet in a cell, groups of that many are united exactly
 * and the groups are combined as if they were placed at random. Errors: WF_ENOMEM. */
enum wf_status wf_raster_union(struct wf_raster *r, const struct wf_outline *o, size_t n, double *out,
                               struct wf_err *e);
/* Add an outline with a weight to the running sum. */
void wf_raster_add(struct wf_raster *r, const struct wf_outline *o, double weight);
/* The running sum per cell: weight x area of all outlines added since the last call. Returned: out[k*nx + i];
 * the running sum is then cleared. */
void wf_raster_sum(struct wf_raster *r, double *out);
#endif
