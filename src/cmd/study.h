#ifndef WF_CMD_STUDY_H
#define WF_CMD_STUDY_H
/* What analyze and compare share: their options, and the way from files to results, table and report. */
#include "cmd/cmd.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/preset.h"
#include <stdio.h>

extern const struct wf_option wf_study_options[]; /* ends at name == NULL */

/* What the options ask for. */
struct wf_study {
    struct wf_scenario scenario;
    struct wf_solve_options solve;
    const struct wf_solver *solver;
    const struct wf_preset *preset;
};
void wf_study_from_args(const struct wf_args *g, struct wf_study *out);

/* The tree asked for by --model or --tree, in the season asked for. Returned: *out; *path, the file it was read
 * from. Every mistake is in `d`, or in `e` alone. */
enum wf_status wf_study_tree(const struct wf_args *g, struct wf_arena *a, struct wf_model *out,
                             const char **path, struct wf_diag *d, struct wf_err *e);

/* A whole run: read, analyse, print, write, draw. Given: the command line as typed, between low and high
 * species. Returned: exit code. */
int wf_study_run(int argc, char **argv, const char *about, size_t low, size_t high);

/* The results in a forester's units, for a terminal. */
void wf_study_print(FILE *to, const struct wf_run *run);
#endif
