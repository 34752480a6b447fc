/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_SHELTER_RESULTS_H
#define WF_OUT_SHELTER_RESULTS_H
/* What `windfirm shelter` computes and writes to its folder. */
#include "out/doc.h"
#include "study/sheltered.h"

/* A row that carries no other, in the open and in the tree's own shelter. */
struct wf_tip {
    size_t row;
    double along;            /* place in the depth of the tree, 0 windward .. 1 leeward [-] */
    double wind[2], move[2]; /* at its end, on the bent shape [m/s]; displacement of the end [m] */
    double swing[2];         /* of the end relative to the branch's base [m] */
};
struct wf_shelter_run {
    const char *folder;
    const char *species, *tree_name; /* for the page */
    const struct wf_tree *tree;
    double speed;
    const struct wf_scenario *scenario;
    struct wf_response open, own; /* without and with shelter */
    struct wf_sheltered *sheltered;
    struct wf_shelter still; /* of the unloaded shape: what maps and cuts show */
    bool moved;              /* the tree was bent: open, own and tip are valid */
    struct wf_tip *tip;
    size_t tips;
};
/* Fill tip, tips from the responses. WF_ENOMEM. */
enum wf_status wf_shelter_tips(struct wf_shelter_run *r, const struct wf_loads *open, struct wf_arena *a,
                               struct wf_err *e);
/* Means over the branch ends of the windward, middle and leeward third of the tree's depth: [0] in the open,
 * [1] in its own shelter; NAN where a third has none. */
struct wf_shelter_third {
    size_t n;
    double wind[2], move[2], swing[2]; /* [m/s], [m], [m], as in struct wf_tip */
};
/* Returned: thirds that have branch ends, and all three in third. */
size_t wf_shelter_thirds(const struct wf_shelter_run *r, struct wf_shelter_third third[3]);
/* Write r->folder/tables/{slabs,cells,cut_level,cut_upright,rows,tips}.csv, plots/run.csv and results.json;
 * the folder is made. diag: warnings of the run. Errors: WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_shelter_results_write(const struct wf_shelter_run *r, const struct wf_doc_head *head,
                                        const struct wf_diag *diag, struct wf_err *e);
#endif
