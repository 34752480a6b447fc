#ifndef WF_CMD_CMD_H
#define WF_CMD_CMD_H
/* Subcommands and their options are rows; usage text is printed from them and what is typed is checked
 * against them. Only this room and main.c print, read argv or choose an exit code. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_command {
    const char *name, *operands, *summary;
    int (*run)(int argc, char **argv); /* argv[0] is the subcommand's own name; returned: exit code */
};
extern const struct wf_command wf_commands[]; /* ends at name == NULL */

int wf_cmd_analyze(int argc, char **argv);
int wf_cmd_compare(int argc, char **argv);
int wf_cmd_report(int argc, char **argv);
int wf_cmd_schema(int argc, char **argv);
int wf_cmd_species(int argc, char **argv);
int wf_cmd_validate(int argc, char **argv);

enum wf_option_kind {
    WF_OPTION_FLAG,   /* takes no value                                     */
    WF_OPTION_TEXT,   /* any text                                           */
    WF_OPTION_CHOICE, /* one of `choices`                                   */
    WF_OPTION_NUMBER, /* a number, with or without a unit, within low..high */
    WF_OPTION_SPEEDS  /* "10,15,25", "5:40:1", "36km/h"; each within low..high */
};
struct wf_option {
    const char *name;   /* "--solver"                                              */
    const char *letter; /* "-s" or NULL                                            */
    enum wf_option_kind kind;
    const char *value;   /* word for the value in the usage text, e.g. "FILE"      */
    const char *initial; /* default as it would be typed; NULL: none               */
    const char *unit;    /* of a plain number, and of what is handed on; NULL: text or [-] */
    double low, high;    /* allowed, in `unit`                                     */
    const char *choices; /* words separated by '|'                                 */
    const char *help;
};

enum { WF_OPTIONS_MAX = 32 };
struct wf_args {
    const struct wf_option *option;
    size_t n; /* operands */
    const char **operand;
    bool given[WF_OPTIONS_MAX];       /* by row of `option`                            */
    const char *text[WF_OPTIONS_MAX]; /* as typed, else the default, else NULL         */
    double number[WF_OPTIONS_MAX];    /* in SI; NAN when there is neither              */
    size_t speeds;                    /* of the row of kind WF_OPTION_SPEEDS, ascending */
    double *speed;                    /* [m/s]                                         */
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
/* Print findings to stderr: errors always, warnings unless quiet. */
void wf_print_findings(const struct wf_diag *d, bool quiet);
#endif
