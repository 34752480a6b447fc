#ifndef WF_CMD_ARGS_H
#define WF_CMD_ARGS_H
/* The parts of reading a command line; commands use cmd/cmd.h. */
#include "cmd/cmd.h"
#include <stdio.h>

/* One command line being read. Every mistake is printed where it is found, and counted. */
struct wf_reading {
    struct wf_args *out;
    struct wf_arena *arena;
    struct wf_units *units;
    const char *command;
    size_t options, mistakes;
    bool complete;
    struct wf_yaml *yaml; /* a study file being read, and its key in hand; NULL: the command line */
    const char *key;
};

/* Print a mistake about an option (or operand "") and count it. */
void wf_args_mistake(struct wf_reading *r, const char *name, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Take options and operands that were not typed from the study file of --study, or from the only operand when
 * that is a study file. Mistakes are printed and counted. */
void wf_args_study(struct wf_reading *r);
/* Defaults of what was not given, then the winds, which depend on other options. Once. */
void wf_args_complete(struct wf_reading *r);
/* Check the text given for row k and set number as its kind asks. */
void wf_args_value(struct wf_reading *r, size_t k, const char *text);
/* Behind the number at the start of `text`, blanks skipped: its unit, "" for none. NULL: no number there. */
const char *wf_args_unit(const char *text);
/* Read one number, a plain one in `unit`, and hold it against the row's bounds, which are in the row's own
 * unit. Returned: *si, and whether it is allowed. */
bool wf_args_quantity(struct wf_reading *r, const struct wf_option *o, const char *text, const char *unit,
                      double *si);
enum { WF_CHOICES_MAX = 32 };
/* The words a choice may be, returned: how many; `list` holds them where they come from `choices`. */
size_t wf_args_choices(const struct wf_option *o, const char *word[static WF_CHOICES_MAX], char *list,
                       size_t size);
/* Help, allowed values and default of an option as one paragraph. */
void wf_option_text(const struct wf_option *o, FILE *to);
/* The page shown by --help, made from the rows. */
void wf_usage_print(FILE *to, const char *command, const struct wf_option *option, const char *about);
#endif
