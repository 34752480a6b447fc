/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_USAGE_H
#define WF_CMD_USAGE_H
/* What a command says of itself, made from its option rows: for a terminal, as a manual page, and as the
 * words from which a shell completes a line. */
#include "cmd/option.h"

struct wf_usage_form {
    const char *word; /* as typed: "--help", "--help=man" */
    void (*print)(FILE *to, const char *command, const struct wf_option *rows, const char *about);
};
/* Usage is said in the language that the line names behind --lang, before anything else of it is read. */
void wf_usage_language(int argc, char **argv);
/* The form that an argument names; NULL when it names none. */
const struct wf_usage_form *wf_usage_form(const char *word);
/* Print what the program says of all its commands in the form that `word` names. Returned: false, nothing
 * printed, when it names none. */
bool wf_usage_overview(FILE *to, const char *word);
#endif
