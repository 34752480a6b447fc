/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_RAIN_RESULTS_H
#define WF_OUT_RAIN_RESULTS_H
/* What `windfirm rain` and `windfirm papers yang2011` write to their folder. */
#include "grow/kmeans.h"
#include "out/doc.h"
#include "study/prism_check.h"
#include "study/rain_run.h"

struct wf_rain_page_run {
    const char *name;
    const struct wf_rain_result *of;
    const struct wf_diag *diag;
};
/* A row of the paper's Table 1 with the steps a second of this run. */
struct wf_rain_speed {
    size_t scene, leaves, vertices, facets, grid, drops;
    size_t paper_vertices, paper_facets;
    double paper; /* frames a second, drawing included */
    double steps; /* steps a second, without drawing   */
};
struct wf_rain_page {
    size_t n;
    const struct wf_rain_page_run *run;
    struct wf_prism_rod rod;
    struct wf_prism_check check[WF_PRISM_CHECKS];
    const struct wf_prism_order *order; /* WF_PRISM_ORDERS; NULL: none */
    size_t speeds;
    const struct wf_rain_speed *speed;
    const struct wf_cloud *points; /* nodes were found from them; NULL: none */
    const struct wf_clusters *clusters;
};
/* Write
 * FOLDER/tables/{series,keys,scene,air,drops,map_RUN_KEY,events,budget,springs,prisms,falls,speeds,clusters,points,order,order_lines}.csv
 * (the last five where there are any), plots/run.csv and results.json. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_rain_results_write(const struct wf_rain_page *p, const struct wf_doc_head *head,
                                     const char *folder, struct wf_err *e);
#endif
