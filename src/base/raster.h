/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_RASTER_H
#define WF_BASE_RASTER_H
/* Area coverage of a grid by convex outlines, exact to rounding: no sample points, no display.
 *
 * Outlines are given in cell units: cell (i, k) is the square i..i+1, k..k+1 and an area is a share of a
 * cell. Two ways to add outlines up:
 *   union  what is opaque: overlapping outlines cover once. The area is the integral 1/2 (x dy - y dx) along
 *          the border of the union within the cell: each edge without its parts inside other outlines, and
 *          the parts of the cell's own border that lie inside any. For convex outlines such a part is one
 *          interval (Cyrus & Beck 1978), so nothing is approximated.
 *   sum    what is porous: weights add. Each edge enters the cells it crosses with the area to its right;
 *          summing along a row gives the areas of all outlines at once. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { WF_OUTLINE_MAX = 16, WF_OUTLINE_ROUND = 6 };
/* Convex, counter-clockwise. */
struct wf_outline {
    size_t n;
    double x[WF_OUTLINE_MAX][2];
};

/* Silhouette of a frustum seen along a direction. Given: the ends of its axis across the view p0, p1 [m],
 * radii [m], |cosine| between axis and view, which ends are closed by their disc (else by a chord).
 * Returned: false when its area is zero (an axis along the view without discs). The area is
 * (r0 + r1) |p1 - p0| plus 1/2 pi r^2 cosine for each disc: exact for cylinders, and for cones seen from
 * the side. A disc's half ellipse has WF_OUTLINE_ROUND edges and the right area. */
bool wf_outline_frustum(const double p0[2], const double p1[2], double r0, double r1, double cosine,
                        bool disc0, bool disc1, struct wf_outline *out);
double wf_outline_area(const struct wf_outline *o);
enum { WF_UNION_MAX = 64 }; /* outlines in a cell that are united exactly */

struct wf_raster {
    size_t nx, ny;
    int32_t *head; /* of each cell's chain                  */
    int32_t *item, *next;
    int32_t *touched; /* cells that have a chain, in the order of meeting */
    size_t links, room, cells;
    double *edge; /* of the sum: nx + 2 a row */
    struct wf_arena *arena;
};
/* Scratch for grids of nx by ny cells. WF_ENOMEM. */
enum wf_status wf_raster_make(struct wf_raster *r, size_t nx, size_t ny, struct wf_arena *a,
                              struct wf_err *e);
/* Coverage [0..1] of every cell by the union of n outlines: out[k*nx + i], overwritten. Parts outside the
 * grid are left out. Where more than WF_UNION_MAX outlines meet in a cell, groups of that many are united
 * exactly and the groups combined as if they lay at random. WF_ENOMEM. */
enum wf_status wf_raster_union(struct wf_raster *r, const struct wf_outline *o, size_t n, double *out,
                               struct wf_err *e);
/* Add an outline with a weight to the running sum. */
void wf_raster_add(struct wf_raster *r, const struct wf_outline *o, double weight);
/* Sum of weight x area of what was added since the last call, per cell; the running sum is cleared. */
void wf_raster_sum(struct wf_raster *r, double *out);
#endif
