/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_SPECTRAL_H
#define WF_WIND_GUST_SPECTRAL_H
/* Wind with a given spectrum at every point and a given coherence between points. */
#include "wind/gust_spec.h"

enum wf_status wf_gust_spectral_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_gust_spectral_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                     struct wf_err *e);
void wf_gust_spectral_close(struct wf_gust *g);

/* Root-coherence a spectral model aims at between two points at frequency f [Hz]; NAN for other models. */
double wf_gust_coherence_target(const struct wf_gust_spec *s, size_t p, size_t q, double f);

/* Coherence error of the synthesis at its worst frequency: see wf_coherence_error; NAN for other models. */
double wf_gust_coherence_error(const struct wf_gust *g, struct wf_arena *a);

/* Correlation between many points at every frequency, at a cost that grows with the number of points and not
 * with its cube. Root-coherence of points i, j: exp(-r_ij g), r_ij = |diag(Cx, Cy, Cz)(x_i - x_j)| and
 * g(f) = sqrt((f/U)^2 + q^2) one number a frequency.
 * Method: sequential simulation. In an order that spreads out (each next point farthest from those taken),
 * y_i = sum_{j in N(i)} b_ij(g) y_j + sqrt(d_i(g)) w_i, N(i) the nearest points already made, b and d from
 * the conditional normal distribution. Exact when N(i) holds all earlier points (up to WF_COHERENCE_NEAR + 1
 * points); beyond, the error is measured by wf_coherence_error. b and d are made at a ladder of g and
 * interpolated linearly.
 * Source: Vecchia A.V. (1988), Estimation and model identification for continuous spatial processes, J. R.
 * Stat. Soc. B 50:297-312; order after Guinness J. (2018), Permutation and grouping methods for sharpening
 * Gaussian process approximations, Technometrics 60:415-429; coherence: Davenport A.G. (1961). */

enum { WF_COHERENCE_NEAR = 32 };

struct wf_coherence {
    size_t n, near;    /* points; most neighbours of one                            */
    size_t *order;     /* n: the point made at each turn                            */
    size_t *count;     /* n: neighbours at each turn                                */
    size_t *neighbour; /* n * near: turns (not points) of the neighbours            */
    double *stretched; /* 3n: places by turn, stretched by the decays [m]           */
    double *closest;   /* n: stretched distance to the nearest earlier point [m]    */
    size_t rungs;      /* ladder of g                                               */
    double *rung;      /* [1/m], ascending                                          */
    double *weight;    /* rungs * n * near                                          */
    double *rest;      /* rungs * n: variance not explained by the neighbours, d    */
};

/* Given: n places (3 each) [m], decays C[3] (0: fully coherent in that direction), the range of g [1/m]. */
enum wf_status wf_coherence_make(size_t n, const double *place, const double decay[3], double g_low,
                                 double g_high, struct wf_arena *a, struct wf_coherence *c, struct wf_err *e);
/* Largest difference, over all pairs of at most 400 points, between the root-coherence made at g and
 * exp(-r g); NAN when there is no room for the check. */
double wf_coherence_error(const struct wf_coherence *c, double g, struct wf_arena *a);
#endif
