/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ARGS_H
#define WF_CMD_ARGS_H
/* Reading a command line, and the study file that it names, into the command's options struct. */
#include "base/err.h"
#include "cmd/option.h"

/* Read a subcommand's command line. Given: argv (argv[0] = subcommand), its option rows (end at name ==
 * NULL), a paragraph for --help, how many operands it takes, an arena for what is kept, and the head of the
 * options struct that the rows were made for. Returned: -1 to go on, with a value or its absence in the
 * member of every row; or the exit code: 0 after --help, 2 after every mistake was printed. --help needs no
 * row. Order: what is typed, then keys of the study file that were not typed, then defaults, then winds. */
int wf_args_read(int argc, char **argv, const struct wf_option *option, const char *about, size_t low,
                 size_t high, struct wf_arena *a, struct wf_args *out);
/* Read a row of a table as options beside those of a command line. Given: the head of the command line's
 * options, as wf_args_read left it; n cells with the rows of the options they hold (blank cells count as not
 * given); units (wf_units_open); an arena; the head of the options struct to fill. A cell takes precedence
 * over the command line. Returned: true with every member set; false with every mistake of the row in *sink.
 */
bool wf_args_read_cells(const struct wf_args *line, const char *command, const size_t *option,
                        const char *const *cell, size_t n, struct wf_units *units, struct wf_arena *a,
                        struct wf_args *out, struct wf_sink *sink);
/* The rows of a study file: every option of the commands that take one as a key. NULL: no memory. */
struct wf_yaml_table;
const struct wf_yaml_table *wf_args_study_table(struct wf_arena *a);
#endif
