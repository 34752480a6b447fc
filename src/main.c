/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/num.h"
#include "base/text.h"
#include "cmd/commands.h"
#include "cmd/read_mat.h"
#include <stdio.h>
#include <string.h>

enum { COMMANDS_MAX = 64 };

static int help(FILE *to)
{
    fprintf(to,
            "windfirm %s: what wind does to a tree\n\nUsage: windfirm COMMAND [argument...]\n\nCommands:\n",
            WF_VERSION);
    for (const struct wf_command *c = wf_commands; c->name; c++)
        fprintf(to, "  %-10s %s\n", c->name, c->summary);
    fprintf(to, "\n'windfirm COMMAND --help' lists a command's arguments, options, units and defaults.\n"
                "'windfirm --version' prints the version.\n");
    return to == stdout ? 0 : 2;
}

static int unknown(const char *word)
{
    const char *known[COMMANDS_MAX];
    size_t n = 0;
    for (; n < COMMANDS_MAX && wf_commands[n].name; n++) known[n] = wf_commands[n].name;
    struct wf_hint hint = wf_did_you_mean(word, known, n);
    fprintf(stderr, "windfirm: unknown command '%s'%s\n", word,
            *hint.text ? hint.text : "; 'windfirm --help' lists them");
    return 2;
}

int main(int argc, char **argv)
{
    if (argc < 2) return help(stderr);
    const char *word = argv[1];
    bool detail = strcmp(word, "help") == 0;
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || (detail && argc < 3)) return help(stdout);
    if (strcmp(word, "--version") == 0 || strcmp(word, "version") == 0)
        return printf("windfirm %s\n", WF_VERSION) < 0;
    if (strcmp(word, WF_READ_MAT_WORD) == 0) return wf_read_mat_apart(argc, argv);
    if (detail) word = argv[2];
    for (const struct wf_command *c = wf_commands; c->name; c++) {
        if (strcmp(word, c->name) != 0) continue;
        char page[] = "--help", *only_help[] = { argv[detail ? 2 : 1], page, NULL };
        int code = detail ? c->run(2, only_help) : c->run(argc - 1, argv + 1);
        /* output that could not be written, because of a full disk or a closed pipe, is a failed run */
        return fflush(stdout) || ferror(stdout) ? (code ? code : 1) : code;
    }
    return unknown(word);
}
