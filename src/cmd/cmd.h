#ifndef WF_CMD_CMD_H
#define WF_CMD_CMD_H
/* Subcommands and their options are rows; usage text is printed from them and what is typed is checked
 * against them. Only this room and main.c print, read argv or choose an exit code. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_command {
    const char *name, *operands, *summary;
    int (*run)(int argc, char **argv); /* argv[0] is the subcommand's own name; returned: exit code */
};
extern const struct wf_command wf_commands[]; /* ends at name == NULL */

int wf_cmd_analyze(int argc, char **argv);
int wf_cmd_compare(int argc, char **argv);
int wf_cmd_fit(int argc, char **argv);
int wf_cmd_explain(int argc, char **argv);
int wf_cmd_import(int argc, char **argv);
int wf_cmd_papers(int argc, char **argv);
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

enum wf_option_kind {
    WF_OPTION_FLAG,   /* takes no value                                     */
    WF_OPTION_TEXT,   /* any text                                           */
    WF_OPTION_TEXTS,  /* texts separated by commas; given again, it adds    */
    WF_OPTION_CHOICE, /* one of `choices` or of the words `word` names        */
    WF_OPTION_NUMBER, /* a number, with or without a unit, within low..high */
    WF_OPTION_WHOLE,  /* a whole number within low..high                    */
    WF_OPTION_SPEED,  /* one mean wind: a number like the above, or "beaufort:8"; goes with
                         WF_AVERAGING_OPTIONS */
    WF_OPTION_SPEEDS  /* several: "10,15,25", "5:40:1", "36km/h", "cma:typhoon,30"; likewise */
};
struct wf_option {
    const char *name;   /* "--solver"                                              */
    const char *letter; /* "-s" or NULL                                            */
    enum wf_option_kind kind;
    const char *value;             /* word for the value in the usage text, e.g. "FILE"      */
    const char *initial;           /* default as it would be typed; NULL: none               */
    enum wf_dimension dimension;   /* of a number or speed                           */
    const char *unit;              /* of a plain number and of low and high; NULL: none      */
    double low, high;              /* allowed                                                */
    const char *choices;           /* words separated by '|'                                 */
    const char *(*word)(size_t i); /* or the i-th word of a list of rows, NULL behind the last */
    const char *help;
};

/* Row of a command that takes a study file (cmd/args_study.c). */
#define WF_STUDY_FILE_OPTION                                                                                 \
    {                                                                                                        \
        .name = "--study", .kind = WF_OPTION_TEXT, .value = "FILE",                                          \
        .help =                                                                                              \
            "options from a file, one key an option ('windfirm schema study'); what is typed comes first"    \
    }
extern const struct wf_option wf_explain_options[], wf_series_options[], wf_shelter_options[],
    wf_study_options[], wf_wind_options[]; /* end at name == NULL */

enum { WF_OPTIONS_MAX = 64 };
struct wf_args {
    const struct wf_option *option;
    size_t n; /* operands */
    const char **operand;
    bool given[WF_OPTIONS_MAX];       /* by row of `option`                            */
    const char *text[WF_OPTIONS_MAX]; /* as typed, else the default, else NULL         */
    double number[WF_OPTIONS_MAX];    /* in SI; NAN when there is neither              */
    size_t speeds;                    /* of the row of kind WF_OPTION_SPEEDS, ascending */
    double *speed;                    /* [m/s]                                         */
    const char *winds_said;           /* how winds came to 10-min means; NULL: they were typed so */
};

/* Read a subcommand's command line. Given: argv (argv[0] = subcommand), its option rows (ends at name ==
 * NULL), a paragraph for --help, how many operands it takes, an arena for what is kept. Returned: -1 to go
 * on, or the exit code: 0 after --help, 2 after every mistake was printed. --help and --quiet need no row. */
int wf_args_read(int argc, char **argv, const struct wf_option *option, const char *about, size_t low,
                 size_t high, struct wf_arena *a, struct wf_args *out);
/* By option name; the name must be one of the rows. */
const char *wf_args_text(const struct wf_args *g, const char *name);
double wf_args_number(const struct wf_args *g, const char *name);
bool wf_args_given(const struct wf_args *g, const char *name);

/* The exit code for a status: 0, 1 (a run failed) or 2 (usage or input). */
int wf_exit_code(enum wf_status s);
/* Print the error to stderr as "windfirm: ..." and return its exit code. */
int wf_complain(const struct wf_err *e);
/* Folder with the shipped species/, models/ and validation/: $WINDFIRM_SHARE, else where it was installed. */
const char *wf_share(void);
/* The file a user means: the path itself when it is there or looks like one, else the shipped
 * SHARE/room/NAME.yaml. Returned: text in the arena, or `name` without room. */
const char *wf_shipped(const char *room, const char *name, struct wf_arena *a);
/* A file that `file` names: beside it when it is there, else as the name leads from the present folder.
 * Returned: text in the arena, or `name`. */
const char *wf_beside(const char *file, const char *name, struct wf_arena *a);
/* One line of progress on stderr when it is a terminal, in place of the last; NULL clears it. */
void wf_progress(const char *fmt, ...) __attribute__((format(printf, 1, 2)));
/* Print findings to stderr: errors always, warnings unless quiet. */
void wf_print_findings(const struct wf_diag *d, bool quiet);
#endif
