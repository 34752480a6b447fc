/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_SCENARIOS_H
#define WF_CMD_SCENARIOS_H
/* Scenarios, "KEY=VALUE+KEY=VALUE,...": the options of a tree with some of them changed, and changes that are
 * options of scenarios alone. The commands that take them have their own structs of options, which begin with
 * that of analyze. */
#include "cmd/analyze_request.h"
#include "data/model.h"

enum { WF_SCENARIOS_MAX = 50, WF_SCENARIO_CHANGES = 12 };

/* One as it was written: cells of options, which are read beside those of the command line. */
struct wf_scenario_words {
    const char *name;
    bool given;   /* it is the changes of the command line, all together, and has no cells */
    bool removal; /* of the option --remove */
    size_t n, option[WF_SCENARIO_CHANGES];
    const char *cell[WF_SCENARIO_CHANGES];
};
struct wf_scenario_list {
    size_t n;
    struct wf_scenario_words item[WF_SCENARIOS_MAX];
};

/* Is this row of the options something that is done to the tree, or happens to it? */
bool wf_scenario_changes(const struct wf_option *row);
/* Is it of a tree, its site, its wind or what is on it, so that each scenario, and each row of a table, may
 * have its own? */
bool wf_scenario_takes(const struct wf_option *row);
/* The scenarios of a command line: the changes given, all together but for those of --remove, of which each
 * is one; then the items of --scenarios. Mistakes are in `d`. Errors: WF_EUSAGE, WF_ENOMEM. */
enum wf_status wf_scenarios_split(const struct wf_analyze_options *o, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_scenario_list *out, struct wf_err *e);
/* Read the options of one. Given: the head of the command's options; units (wf_units_open). Returned: the
 * options of the scenario, of which *out is the head; mistakes are in `d`. Errors: WF_ENOMEM. */
enum wf_status wf_scenario_options(const struct wf_args *line, const char *command,
                                   const struct wf_scenario_words *x, struct wf_units *units,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_args *out,
                                   struct wf_err *e);
/* Does it change the tree that is drawn: an option of --model and those that go with it? */
bool wf_scenario_draws(const struct wf_scenario_words *x, const struct wf_args *line);
/* Onto a request and a model of its own, with its options, what wf_analyze_request_read does not know: a
 * drawn crown reduced or thinned, branches removed, leaves fallen, walls of cavities grown thinner, roots
 * lost. Given: is it the model of a card, whose crown is changed elsewhere; the model of the tree as it
 * stands, whose shape was measured or drawn in its season; the height that the roots, and the stand around
 * it, grew to [m], NAN: not known yet. Errors: WF_EUSAGE, WF_EINPUT, WF_ENOMEM. */
enum wf_status wf_scenario_onto(const struct wf_analyze_options *o, bool card, const struct wf_model *whole,
                                double grown, struct wf_arena *a, struct wf_analyze_request *q,
                                struct wf_model *m, struct wf_err *e);
#endif
