/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_TERRAIN_H
#define WF_WIND_TERRAIN_H
/* Heights of the ground on a square grid, generated or read from a file, and their effect on the wind at each
 * point. x to the east, y to the north; directions are those from which the wind comes, clockwise from north.
 */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { WF_TERRAIN_MAX = 4097 }; /* most rows or columns */

struct wf_terrain {
    size_t columns, rows;
    double cell;   /* spacing [m]                                   */
    double x0, y0; /* place of the south-western grid point [m]     */
    double *z;     /* rows * columns, southern row first [m]; NAN = no data */
};

/* Allocate a map. Given: numbers of columns and rows (2..WF_TERRAIN_MAX), spacing 0.01..1e5 [m]. Returned:
 * heights 0. Errors: WF_EINPUT, WF_ENOMEM. */
enum wf_status wf_terrain_alloc(struct wf_terrain *t, size_t columns, size_t rows, double cell,
                                struct wf_arena *a, struct wf_err *e);

/* Generate a random fractal terrain of (2^n + 1)^2 points. Given: n 1..12, cell [m], roughness exponent H in
 * 0..1 (1 smooth, 0 rough), relief [m], seed. Returned: heights with standard deviation `relief`, the lowest
 * point at 0. Method: the middle of each square, then of each edge, is the mean of its neighbours plus a
 * normal draw whose size decreases by 2^(-H/2) in each half step. The address of a draw is its place, so that
 * the same seed gives the same map. Source: Fournier A., Fussell D., Carpenter L. (1982), Computer rendering
 * of stochastic models, Commun. ACM 25:371-384. For use where the terrain is unknown: it has no valleys and
 * no drainage. */
enum wf_status wf_terrain_make(unsigned n, double cell, double h, double relief, uint64_t seed,
                               struct wf_arena *a, struct wf_terrain *t, struct wf_err *e);

/* Read an ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize,
 * nodata_value, then the rows from north to south. Errors: WF_EINPUT with line and column, WF_ENOMEM. */
enum wf_status wf_terrain_read(const char *path, struct wf_arena *a, struct wf_terrain *t, struct wf_err *e);
/* Write an ESRI ASCII grid of numbers on the terrain's grid (NAN as -9999); values NULL: the heights. Errors:
 * WF_EOUTPUT. */
enum wf_status wf_terrain_write(const char *path, const struct wf_terrain *t, const double *values,
                                struct wf_err *e);

/* Height at a point [m], bilinear between grid points; NAN outside the map or next to a point without data.
 */
double wf_terrain_height(const struct wf_terrain *t, double x, double y);

/* Topex-to-distance, a measure of shelter by the terrain: the sum over the eight compass directions of the
 * largest elevation angle of the ground within `distance` [m] (usually 1000 m); angles below the horizontal
 * are negative. High = sheltered, negative = exposed. Returned: the sum [rad], NAN at a point without data;
 * *seen (may be NULL) = share of the eight sight lines that stay on the map; the others are evaluated as far
 * as the map reaches. Source: Hannah P., Palutikof J.P., Quine C.P. (1995), Predicting windspeeds for forest
 * areas in complex terrain, in Wind and Trees (Coutts & Grace), 113-129; topex: Pyatt D.G. (1969). */
double wf_terrain_topex(const struct wf_terrain *t, size_t column, size_t row, double distance, double *seen);
/* The largest elevation angle in one viewing direction `towards` (clockwise from north) [rad]; *seen: whether
 * the sight line stays on the map. */
double wf_terrain_horizon(const struct wf_terrain *t, size_t column, size_t row, double towards,
                          double distance, bool *seen);

/* Fractional speed-up dS = (U - U0)/U0 at a height above the ground, at all points of the map, for wind from
 * `from`. Method: linear outer-layer response of a neutral log-law wind, dS = [U0(L)/U0(max(z, l))]^2 F^-1{
 * (k.e)^2/|k| exp(-|k| z) F{ground} }, l ln(l/z0) = 0.32 L. Source: Jackson P.S., Hunt J.C.R. (1975),
 * Turbulent wind flow over a low hill, Q. J. R. Meteorol. Soc. 101:929-955; three dimensions: Mason P.J.,
 * Sykes R.I. (1979), ibid. 105:383-395. Range: neutral, slopes up to about 0.3 without separation, uniform
 * roughness, hills much smaller than the boundary layer. The result is too high in the lee of steep slopes.
 * Summit of a low ridge: about 2 h/L as in the guidelines of Taylor P.A., Lee R.J. (1984), Climatol. Bull.
 * 18(2):3-32. Beyond its edges the terrain is assumed to be the mirror image of the map; results near an edge
 * depend on this assumption. */
struct wf_speedup_request {
    double from;      /* direction the wind comes from, clockwise from north [rad]        */
    double height;    /* above the ground [m]                                             */
    double roughness; /* z0 [m]                                                           */
    double length;    /* L, half-width of the hills at half height [m]; 0: from the map   */
};
struct wf_speedup {
    double *ds;      /* rows * columns [-] */
    double length;   /* L used [m]: given, or the height-variance weighted mean of 1/|k|  */
    double inner;    /* l [m]                                                             */
    double gain;     /* [U0(L)/U0(max(z, l))]^2                                           */
    double steepest; /* slope of the map [-]                                              */
};
/* Is a wind factor, 1 + dS, within what the linear law can mean? */
static inline bool wf_speedup_holds(double factor) { return factor >= 0.1 && factor <= 5.0; }
/* Errors: WF_EUSAGE for a height or roughness out of range, WF_EINPUT for a map with points without data,
 * WF_ENOMEM. */
enum wf_status wf_terrain_speedup(const struct wf_terrain *t, const struct wf_speedup_request *q,
                                  struct wf_arena *a, struct wf_speedup *out, struct wf_err *e);

/* The site of a tree on a map. */
struct wf_site {
    const char *file; /* ESRI ASCII grid                             */
    double x, y;      /* of the tree, in the map's coordinates [m]   */
    double steepest;  /* slope of the map [-]                        */
    double edge;      /* distance of the tree from the map's edge [m] */
    struct wf_terrain ground;
};

/* "x,y" [m]: a place on a map. False where the text is no such. */
bool wf_site_place(const char *text, double *x, double *y);
/* Read the map of a site. Given: file, x, y of *site. Returned: its other members. Errors: those of
 * wf_terrain_read, WF_EUSAGE for a place outside the map or without data. */
enum wf_status wf_site_read(struct wf_site *site, struct wf_arena *a, struct wf_err *e);
/* Ratio of the wind speed at the tree to that over level ground. Given: direction from which the wind comes,
 * clockwise from the map's north [rad], height above the ground [m], roughness length [m]. Method:
 * wf_terrain_speedup, bilinear between the points of the map. Errors: WF_EINPUT for a ratio below 0.1 or
 * above 5, which is beyond the range of the linear method. */
enum wf_status wf_site_speed_up(const struct wf_site *site, double from, double height, double roughness,
                                double *factor, struct wf_err *e);
#endif
