/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_TERRAIN_H
#define WF_WIND_TERRAIN_H
/* Heights of the ground on a square grid, made or read, and what they do to the wind at each position.
 * x to the east, y to the north; directions are those the wind comes from, clockwise from north. */
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

enum wf_status wf_terrain_alloc(struct wf_terrain *t, size_t columns, size_t rows, double cell,
                                struct wf_arena *a, struct wf_err *e);

/* Random heights of fractal character: (2^n + 1)^2 points, the middle of each square and then of each edge
 * set to the mean of its neighbours plus a normal draw whose size falls by 2^(-H/2) a half step. Scaled so
 * that the standard deviation of all heights is `relief`, lowest point at 0. Each draw is addressed by its
 * place: the same seed gives the same map, whatever the order. Given: n 1..12, cell [m], roughness exponent H
 * in 0..1 (1 smooth, 0 rough), relief [m], seed. Source: Fournier A., Fussell D., Carpenter L. (1982),
 * Computer rendering of stochastic models, Commun. ACM 25:371-384. A stand-in for ground that is not known:
 * no valleys, no drainage. */
enum wf_status wf_terrain_make(unsigned n, double cell, double h, double relief, uint64_t seed,
                               struct wf_arena *a, struct wf_terrain *t, struct wf_err *e);

/* ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, nodata_value, then
 * the rows from north to south. Every mistake is WF_EINPUT with line and column. */
enum wf_status wf_terrain_read(const char *path, struct wf_arena *a, struct wf_terrain *t, struct wf_err *e);
/* Write numbers on the terrain's grid in the same form (NAN as -9999). values NULL: the heights. */
enum wf_status wf_terrain_write(const char *path, const struct wf_terrain *t, const double *values,
                                struct wf_err *e);

/* Height between grid points, bilinear; NAN outside the map or beside no data. */
double wf_terrain_height(const struct wf_terrain *t, double x, double y);
/* Steepest slope |dz/ds| of the map, central differences [-]. */
double wf_terrain_steepest(const struct wf_terrain *t);

/* Topex-to-distance: the sum over the eight compass directions of the largest angle to the ground within
 * `distance` [m]; angles below the horizontal count as negative. High = sheltered, negative = exposed.
 * Returned: the sum [rad]; *seen (may be NULL) = share of the eight sight lines that stay on the map, as the
 * angles of the others are taken on what there is. NAN where there is no height. Source: Hannah P., Palutikof
 * J.P., Quine C.P. (1995), Predicting windspeeds for forest areas in complex terrain, in Wind and Trees
 * (Coutts & Grace), 113-129; topex: Pyatt D.G. (1969). Usual distance: 1000 m. */
double wf_terrain_topex(const struct wf_terrain *t, size_t column, size_t row, double distance, double *seen);
/* The largest angle in one direction (towards which one looks, clockwise from north) [rad]. */
double wf_terrain_horizon(const struct wf_terrain *t, size_t column, size_t row, double towards,
                          double distance, bool *seen);

/* Fractional speed-up dS = (U - U0)/U0 at a height above the ground, over the whole map, for wind from
 * `from`. Method: linear outer-layer response of a neutral log-law wind, dS = [U0(L)/U0(max(z, l))]^2 F^-1{
 * (k.e)^2/|k| exp(-|k| z) F{ground} }, l ln(l/z0) = 0.32 L. Source: Jackson P.S., Hunt J.C.R. (1975),
 * Turbulent wind flow over a low hill, Q. J. R. Meteorol. Soc. 101:929-955; three dimensions: Mason P.J.,
 * Sykes R.I. (1979), ibid. 105:383-395. Range: neutral, slopes up to about 0.3 without separation, uniform
 * roughness, hills much smaller than the boundary layer. Errs: high in the lee of steep slopes. Summit of a
 * low ridge: about 2 h/L as in the guidelines of Taylor P.A., Lee R.J. (1984), Climatol. Bull. 18(2):3-32.
 * Beyond its edges the ground is taken as its mirror image; what is near an edge is worth as much as that
 * guess. */
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
enum wf_status wf_terrain_speedup(const struct wf_terrain *t, const struct wf_speedup_request *q,
                                  struct wf_arena *a, struct wf_speedup *out, struct wf_err *e);

/* A tree on the ground of a map: what the ground does to the wind it meets. */
struct wf_site {
    const char *file; /* ESRI ASCII grid                             */
    double x, y;      /* of the tree, in the map's coordinates [m]   */
    double steepest;  /* slope of the map [-]                        */
    double edge;      /* distance of the tree from the map's edge [m] */
    struct wf_terrain ground;
};

/* "x,y" [m]: a place on a map. False where the text is no such. */
bool wf_site_place(const char *text, double *x, double *y);
/* Read the map and find the tree on it. Given: file, x, y of *site. Errors: those of wf_terrain_read,
 * WF_EUSAGE for a place outside the map or without data. */
enum wf_status wf_site_read(struct wf_site *site, struct wf_arena *a, struct wf_err *e);
/* Wind at the tree over that over level ground, at a height above the ground [m], roughness length [m], for a
 * wind that comes from `from` clockwise from the map's north [rad]: wf_terrain_speedup, bilinear between its
 * points. WF_EINPUT where the method gives less than a tenth of the wind or more than five times, which it
 * cannot know. */
enum wf_status wf_site_speed_up(const struct wf_site *site, double from, double height, double roughness,
                                double *factor, struct wf_err *e);
#endif
