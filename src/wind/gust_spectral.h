/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_SPECTRAL_H
#define WF_WIND_GUST_SPECTRAL_H
/* Wind with a given spectrum at every point and a given coherence between points (rows kaimal, von-karman,
 * davenport and one-over-f of wf_gust_models), and the correlation between many points that it needs. */
#include "wind/gust_spec.h"

/* The functions of the spectral rows of wf_gust_models; see struct wf_gust_model. */
enum wf_status wf_gust_spectral_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_gust_spectral_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                     struct wf_err *e);
void wf_gust_spectral_close(struct wf_gust *g);

/* Target root-coherence of a spectral model between points p and q at frequency f [Hz]; NAN for other models.
 */
double wf_gust_coherence_target(const struct wf_gust_spec *s, size_t p, size_t q, double f);

/* Largest coherence error of the synthesis over frequency (see wf_coherence_error); NAN for other models. */
double wf_gust_coherence_error(const struct wf_gust *g, struct wf_arena *a);

/* Correlation between many points at every frequency; the cost is proportional to the number of points, not
 * to its cube. Root-coherence of points i, j: exp(-r_ij g), r_ij = |diag(Cx, Cy, Cz)(x_i - x_j)| and g(f) =
 * sqrt((f/U)^2 + q^2), one number for each frequency. Method: sequential simulation. Points are taken in
 * farthest-point order (each next point is the farthest from those taken): y_i = sum_{j in N(i)} b_ij(g) y_j
 * + sqrt(d_i(g)) w_i, N(i) the nearest earlier points, b and d from the conditional normal distribution.
 * Exact when N(i) contains all earlier points (up to WF_COHERENCE_NEAR + 1 points); for more points
 * wf_coherence_error gives the error. b and d are computed for a geometric sequence of g (the rungs) and
 * interpolated linearly. Source: Vecchia A.V. (1988), Estimation and model identification for continuous
 * spatial processes, J. R. Stat. Soc. B 50:297-312; order after Guinness J. (2018), Permutation and grouping
 * methods for sharpening Gaussian process approximations, Technometrics 60:415-429; coherence: Davenport A.G.
 * (1961). */

enum { WF_COHERENCE_NEAR = 32 };

struct wf_coherence {
    size_t n, near;    /* points; most neighbours of one                            */
    size_t *order;     /* n: the point simulated at each turn                       */
    size_t *count;     /* n: number of neighbours at each turn                      */
    size_t *neighbour; /* n * near: turns (not points) of the neighbours            */
    double *stretched; /* 3n: places by turn, multiplied by the decays [m]          */
    double *closest;   /* n: stretched distance to the nearest earlier point [m]    */
    size_t rungs;      /* number of values of g                                     */
    double *rung;      /* these values [1/m], ascending                             */
    double *weight;    /* rungs * n * near                                          */
    double *rest;      /* rungs * n: variance not explained by the neighbours, d    */
};

/* Prepare the simulation. Given: n places (3 numbers each) [m], decays C[3] (0: fully coherent in that
 * direction), the range of g [1/m]. Errors: WF_ENOMEM. */
enum wf_status wf_coherence_make(size_t n, const double *place, const double decay[3], double g_low,
                                 double g_high, struct wf_arena *a, struct wf_coherence *c, struct wf_err *e);
/* Largest difference between the simulated root-coherence at g and exp(-r g), over all pairs of at most 400
 * points; NAN without memory. */
double wf_coherence_error(const struct wf_coherence *c, double g, struct wf_arena *a);
#endif
