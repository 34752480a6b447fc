/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_MODE_LIST_H
#define WF_STUDY_MODE_LIST_H
/* Modes of a tree with and without its leaves in several mean winds, beside frequencies measured in forests.
 */
#include "data/model.h"
#include "study/sway.h"

/* Sway frequency of trees in forests: first + slope D/H2, with D the diameter over bark at 1.3 m and H the
 * height, both in m [Hz]. Regressions of ours on the data of Jackson and others 2021. */
struct wf_sway_line {
    const char *name, *latin; /* of the trees; latin: how the Latin name begins, NULL: all conifers */
    double first, slope;      /* [Hz], [Hz m] */
};
extern const char wf_sway_lines_source[];

struct wf_mode_block { /* one season in one wind */
    enum wf_season season;
    double water;          /* rain on the leaves, per one-sided area [kg m-2]; 0: dry */
    double speed;          /* named mean wind [m/s] */
    enum wf_status status; /* WF_OK, or why there is no state: WF_EUNSTABLE, WF_ENOCONV */
    struct wf_tree tree;
    double direction[2]; /* the wind blows towards */
    double height;       /* [m] */
    struct wf_sway_modes modes;
};
struct wf_mode_list {
    const char *name_zh; /* of the species; NULL: it has none */
    const struct wf_scenario *scenario; /* of the analysis given */
    size_t blocks;
    struct wf_mode_block *block;
    bool conifer;
    const struct wf_sway_line *line; /* of the species, else of all conifers */
    double diameter, height;         /* of the stem at 1.3 m over bark, of the tree; NAN: lower [m] */
    double measured;                 /* the line's frequency [Hz]; NAN: unknown */
};

struct wf_mode_request {
    size_t count; /* modes */
    bool seasons; /* both, where the model has leaves that fall; else the model's */
    size_t winds;
    const double *wind; /* [m/s]; 0: still air */
};
/* Given: an analysis with species, model, scenario and solver, before wf_analysis_set_up; the model's season
 * is set to each one and then back. Returned: *out, blocks by season, then by wind; where the scenario has
 * water, the leaves are dry first, then wet. A block without a state has a warning in `d`. Errors: WF_EINPUT
 * for water on a tree without leaves; WF_EINTERRUPTED; of wf_analysis_set_up and wf_sway_modes. */
enum wf_status wf_mode_list_run(const struct wf_analysis *as, struct wf_model *m,
                                const struct wf_solve_options *o, const struct wf_mode_request *r,
                                struct wf_arena *a, struct wf_diag *d, struct wf_mode_list *out,
                                struct wf_err *e);

/* Where a mode goes: "along" or "across" the wind, "oblique", "up", or "inside": parts of the tree move
 * against each other, the tree as a whole does not. */
const char *wf_mode_direction(const struct wf_sway_mode *m);
#endif
