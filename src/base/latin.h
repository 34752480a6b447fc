/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_LATIN_H
#define WF_BASE_LATIN_H
/* Latin hypercube samples with rank correlations, and what is read from samples: order statistics and a
 * lognormal law. Draws are functions of their address (base/random.h): the samples depend on seed and sizes
 * alone. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* n samples of k variables, each uniform on (0, 1) with one draw in each n-th of it. Given: seed; rank (k x
 * k, symmetric, 1 on the diagonal), correlations of the ranks to be reached. Returned: out[i * k + v] of
 * sample i and variable v. Method: each variable's scores are those of normal quantiles in random order;
 * their own correlations are taken out and those wanted put in by Cholesky factors; the draws take the order
 * of the scores. With n <= k the samples' own correlations are left in. Sources: McKay M.D., Beckman R.J.,
 * Conover W.J. 1979, Technometrics 21:239-245; Iman R.L., Conover W.J. 1982, Commun. Stat. B 11:311-334.
 * Errors: WF_ENOMEM; WF_EINTERNAL where `rank` is not positive definite. */
enum wf_status wf_latin(uint64_t seed, size_t n, size_t k, const double *rank, double *out, struct wf_err *e);

/* Quantile of the standard normal distribution; share in (0, 1). */
double wf_normal_quantile(double share);

/* Value below which a share of a population lies, by a sample of it in ascending order: linear between order
 * statistics, of which the i-th is at the share i / (n + 1), so that the next draw lies below the i-th with
 * that probability; the ends beyond them. Values may be infinite. */
double wf_order_statistic(const double *ascending, size_t n, double share);

/* Band of a probability of which `hits` of n trials are seen, by the score interval. Given: the quantile of
 * the standard normal distribution of its upper end (1.645: 90 %). Source: Wilson E.B. 1927, J. Am. Stat.
 * Assoc. 22:209-212. */
void wf_binomial_band(size_t hits, size_t n, double z, double *low, double *high);

/* A lognormal law of values of which some are known only to be above a bound. */
struct wf_lognormal {
    double median, beta; /* beta: standard deviation of the logarithm [-]; NAN: too few values */
    size_t seen, above;  /* values, and those known to be above `bound` */
};
/* Greatest likelihood. Given: n values > 0; those that are infinite lie above `bound` > 0. Method: the
 * expected logarithms of the latter by the law, and the law by them, in turn (Dempster A.P., Laird N.M.,
 * Rubin D.B. 1977, J. R. Stat. Soc. B 39:1-38). Without 5 finite values, or where they are all the same,
 * median and beta are NAN. */
struct wf_lognormal wf_lognormal_fit(const double *value, size_t n, double bound);
/* Share of the law below x [-]. */
double wf_lognormal_share(const struct wf_lognormal *l, double x);
#endif
