#ifndef WF_CMD_STUDY_H
#define WF_CMD_STUDY_H
/* What analyze and compare share: their options, and the way from files to results, table and report. */
#include "cmd/cmd.h"
#include "out/results.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include "study/directions.h"
#include "study/preset.h"
#include <stdio.h>

/* What the options ask for. */
struct wf_study {
    struct wf_scenario scenario;
    struct wf_solve_options solve;
    const struct wf_solver *solver;
    const struct wf_preset *preset;
    struct wf_directions_request directions; /* n = 0: none */
};
/* A measured profile and a climate are read; their mistakes are in `d`. */
enum wf_status wf_study_from_args(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_study *out, struct wf_err *e);

/* What says which tree is meant. */
#define WF_TREE_OPTIONS                                                                                      \
    { .name = "--model",                                                                                     \
      .letter = "-m",                                                                                        \
      .kind = WF_OPTION_TEXT,                                                                                \
      .value = "MODEL",                                                                                      \
      .help = "tree model: a file, or the name of a shipped one (culm, moso_culm)" },                        \
        { .name = "--tree",                                                                                  \
          .letter = "-t",                                                                                    \
          .kind = WF_OPTION_TEXT,                                                                            \
          .value = "FILE",                                                                                   \
          .help = "a measured tree in place of a model, any format of 'windfirm import'" },                  \
        { .name = "--joint",                                                                                 \
          .kind = WF_OPTION_CHOICE,                                                                          \
          .value = "HOW",                                                                                    \
          .initial = "axis",                                                                                 \
          .choices = "axis|bridge",                                                                          \
          .help = "how branches of a measured tree are held: where they leave the parent's axis, or at its " \
                  "end" },                                                                                   \
        { .name = "--leaf-area",                                                                             \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "AREA",                                                                                   \
          .dimension = WF_DIM_AREA,                                                                          \
          .unit = "m2",                                                                                      \
          .low = 0,                                                                                          \
          .high = 1e5,                                                                                       \
          .help =                                                                                            \
              "one-sided leaf area of the whole tree, in place of the model's; a measured tree has none" },  \
        { .name = "--season",                                                                                \
          .kind = WF_OPTION_CHOICE,                                                                          \
          .value = "SEASON",                                                                                 \
          .choices = "leaf_on|leaf_off",                                                                     \
          .help = "in place of the model's: with its leaves, or when they have fallen" },                    \
    {                                                                                                        \
        .name = "--unload", .kind = WF_OPTION_FLAG,                                                          \
        .help =                                                                                              \
            "the tree was measured or drawn standing under its own weight: find its stress-free shape first" \
    }
/* Is one tree asked for, by --model or as a file? Returned: -1 to go on, 2 after saying what is missing.
 * `file`: a tree file given otherwise than by --tree; NULL: none. */
int wf_study_tree_asked(const struct wf_args *g, const char *command, const char *file);
/* The tree asked for by --model, --tree or `file`, in the season asked for. Returned: *out; *path, the file
 * it was read from. Every mistake is in `d`, or in `e` alone. */
enum wf_status wf_study_tree(const struct wf_args *g, const char *file, struct wf_arena *a,
                             struct wf_model *out, const char **path, struct wf_diag *d, struct wf_err *e);

/* A whole run: read, analyse, print, write, draw. Given: the command line as typed, between low and high
 * species. Returned: exit code. */
int wf_study_run(int argc, char **argv, const char *about, size_t low, size_t high);

/* The results in a forester's units, for a terminal. */
void wf_study_print(FILE *to, const struct wf_run *run);
#endif
