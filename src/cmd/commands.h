/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_COMMANDS_H
#define WF_CMD_COMMANDS_H
/* The subcommands, and what all of them need: files that are shipped, messages, exit codes. Only this room
 * and main.c print, read argv or choose an exit code. */
#include "base/arena.h"
#include "base/err.h"
#include "cmd/option.h"
#include "out/doc.h"
#include "out/run_folder.h"

struct wf_model;
struct wf_printer;
struct wf_species;

struct wf_command {
    const char *name, *operands, *summary;
    int (*run)(int argc, char **argv); /* argv[0] is the subcommand's own name; returned: exit code */
};
extern const struct wf_command wf_commands[]; /* ends at name == NULL */

int wf_cmd_analyze(int argc, char **argv);
int wf_cmd_assess(int argc, char **argv);
int wf_cmd_compare(int argc, char **argv);
int wf_cmd_fit(int argc, char **argv);
int wf_cmd_explain(int argc, char **argv);
int wf_cmd_fragility(int argc, char **argv);
int wf_cmd_import(int argc, char **argv);
int wf_cmd_init(int argc, char **argv);
int wf_cmd_modes(int argc, char **argv);
int wf_cmd_papers(int argc, char **argv);
int wf_cmd_rain(int argc, char **argv);
int wf_cmd_report(int argc, char **argv);
int wf_cmd_schema(int argc, char **argv);
int wf_cmd_series(int argc, char **argv);
int wf_cmd_shelter(int argc, char **argv);
int wf_cmd_simulate_test(int argc, char **argv);
int wf_cmd_species(int argc, char **argv);
int wf_cmd_tree(int argc, char **argv);
int wf_cmd_terrain(int argc, char **argv);
int wf_cmd_validate(int argc, char **argv);
int wf_cmd_wind(int argc, char **argv);
int wf_wind_extremes(int argc, char **argv); /* windfirm wind extremes */
/* `windfirm papers yang2011`, whose runs are no trees in wind. */
int wf_paper_yang2011(int argc, char **argv);

/* Rows of the commands that take a study file; they end at name == NULL. */
extern const struct wf_option wf_analyze_options[], wf_explain_options[], wf_modes_options[],
    wf_series_options[], wf_shelter_options[], wf_wind_options[];

/* The exit code for a status: 0, 1 (a run failed) or 2 (usage or input). */
int wf_exit_code(enum wf_status s);
/* Print the error to stderr as "windfirm: ..." and return its exit code. */
int wf_complain(const struct wf_err *e);
/* Folder with the shipped species/, models/ and validation/: $WINDFIRM_SHARE, else where it was installed. */
const char *wf_share(void);
/* The file a user means: the path itself when it is a file or looks like a path, else the shipped
 * SHARE/room/NAME.yaml; a species table also by any of its names. A folder of that name is no such file; a
 * warning in `d` says that it was passed over. Returned: *path in the arena. Errors: those of wf_shipped_path
 * and wf_species_path. */
enum wf_status wf_shipped(const char *room, const char *name, struct wf_arena *a, const char **path,
                          struct wf_diag *d, struct wf_err *e);
/* Read the species table or the tree model that a user means, as wf_shipped finds it. Errors: its errors, and
 * those of wf_species_read and wf_model_read. */
enum wf_status wf_species_named(const char *name, struct wf_arena *a, struct wf_species *out,
                                struct wf_diag *d, struct wf_err *e);
enum wf_status wf_model_named(const char *name, struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                              struct wf_err *e);
/* Whether the first line of a YAML file that is not a comment begins with `key`, colon included. */
bool wf_begins_with_key(const char *path, const char *key, struct wf_arena *a);
/* A file that `file` names: beside it when it is there, else relative to the current folder. Returned: text
 * in the arena, or `name`. */
const char *wf_beside(const char *file, const char *name, struct wf_arena *a);
/* Show on stderr how far a run is (base/progress.h), from 2 s on: one line, written over, when it is a
 * terminal and the command is not quiet. */
void wf_progress_start(bool quiet);
/* Clear the line, before something else is printed. */
void wf_progress_clear(void);
/* Print findings to stderr: errors always, warnings unless quiet. */
void wf_print_findings(const struct wf_diag *d, bool quiet);

/* Pages of a results folder, and what a document says about its command. */

/* Figures and pages of a results folder. */
struct wf_pages {
    const char *lang;      /* "en" or "zh"                                                  */
    const char *units;     /* "metric", "imperial" or "cn"                                  */
    const char *templates; /* folder of templates of the page; NULL: the shipped ones    */
    bool none;             /* neither is made                                               */
    bool xlsx;             /* tables also as a workbook                                     */
    bool docx;             /* the page also for a word processor                            */
    bool no_pdf;           /* the page is made for the screen alone; it can be printed later */
};

/* Take the folder for the results of a run, before anything is computed; signals are caught from now on
 * (base/interrupt.h). page: the page that is to be drawn, NULL: none. Errors: those of wf_run_begin. */
enum wf_status wf_results_begin(struct wf_run_folder *r, const char *folder, const char *page,
                                struct wf_err *e);
/* The results are written into the stage: draw figures and pages, print what is missing, put all of it into
 * the folder. pages: which; NULL: none. A run that was interrupted before this is
 * marked so. A drawing program that is not installed is no error, another part that cannot be drawn is, after
 * the rest is in place. *whole, unless NULL: whether everything was drawn. Errors: those of wf_report_make
 * and wf_run_commit. */
enum wf_status wf_results_end(struct wf_run_folder *r, const struct wf_pages *pages, struct wf_arena *a,
                              bool *whole, struct wf_err *e);
/* Draw the pages of the stage, the PDF by this printer. Findings and error name the folder's files, not the
 * stage's. Returned: as wf_report_make. */
enum wf_status wf_results_draw(const struct wf_run_folder *r, const struct wf_pages *pages,
                               struct wf_printer *printer, struct wf_diag *d, struct wf_err *e);
/* The command line as typed, "windfirm ...", with quotes where a shell needs them: it can be pasted and run
 * again. Every command records this text. NULL: no memory. */
char *wf_command_line(int argc, char **argv, struct wf_arena *a);
/* Command line, program and date of this run; title and note stay empty. Errors: WF_ENOMEM. */
enum wf_status wf_pages_head(int argc, char **argv, struct wf_arena *a, struct wf_doc_head *out,
                             struct wf_err *e);

/* What a command does once its options are read. Given: its options, and all that it fills: head of its
 * pages, run folder, findings. */
typedef enum wf_status wf_perform(void *work, struct wf_doc_head *head, struct wf_run_folder *f,
                                  struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
/* Perform it, leave the run folder if it was not put in place, and print findings and error. Returned: exit
 * code. */
int wf_command_perform(int argc, char **argv, wf_perform *perform, void *work, bool quiet,
                       struct wf_arena *a);
#endif
