/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_EXTREMES_H
#define WF_OUT_EXTREMES_H
/* The document, tables and figure of `windfirm wind extremes`: how often a wind is exceeded. */
#include "out/doc.h"
#include "wind/annual.h"
#include "wind/extreme.h"

struct wf_extremes {
    const char *source;             /* where it comes from, in words                                       */
    const struct wf_annual *annual; /* NULL: no sample                                                     */
    double factor;                  /* from the file's averaging time to 10-min means; 1: none             */
    const struct wf_extreme_levels *level; /* the one that is used */
    size_t methods; /* and all fits to compare; 0 without a sample                         */
    const struct wf_extreme_levels *by;
    double life; /* [years]                                                                                 */
    size_t winds;       /* that were asked for       */
    const double *wind; /* 10-min means [m/s] */
};

/* A probability in words that are true where it is small: "0.021", "< 1e-6". Returned: text. */
const char *wf_extremes_share(double p, char text[static 32]);

/* 3-s gust of a 10-min mean, both at 10 m over open country [m/s] (EN 1991-1-4). */
double wf_extremes_gust(double mean);

/* Write tables/extremes.csv, tables/annual.csv where there is a sample, plots/run.csv and results.json.
 * Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_extremes_write(const struct wf_extremes *x, const struct wf_diag *findings,
                                 const struct wf_doc_head *head, const char *folder, struct wf_err *e);
#endif
