/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_SHELTER_RESULTS_H
#define WF_OUT_SHELTER_RESULTS_H
/* What `windfirm shelter` computes and leaves in its folder. */
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
    const struct wf_tree *tree;
    double speed;
    struct wf_response open, own; /* without and with shelter */
    struct wf_sheltered *sheltered;
    struct wf_shelter still; /* of the unloaded shape: what maps and cuts show */
    bool moved;              /* responses are there */
    struct wf_tip *tip;
    size_t tips;
};
/* Fill tip, tips from the responses. WF_ENOMEM. */
enum wf_status wf_shelter_tips(struct wf_shelter_run *r, const struct wf_loads *open, struct wf_arena *a,
                               struct wf_err *e);
/* FOLDER/tables/{slabs,cells,cut_level,cut_upright,rows,tips}.csv and FOLDER/plots/run.csv. */
enum wf_status wf_shelter_tables(const struct wf_shelter_run *r, struct wf_err *e);
#endif
