/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/arena.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/commands.h"
#include "cmd/read_mat.h"
#include "cmd/usage.h"
#include <errno.h>
#include <fcntl.h>
#include <malloc.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { COMMANDS_MAX = 64 };

static int unknown(const char *word)
{
    const char *known[COMMANDS_MAX];
    size_t n = 0;
    for (; n < COMMANDS_MAX && wf_commands[n].name; n++) known[n] = wf_commands[n].name;
    struct wf_hint hint = wf_did_you_mean(word, known, n);
    wf_show(stderr, "windfirm: unknown command '%s'%s\n", word,
            *hint.text ? hint.text : "; 'windfirm --help' lists them");
    return 2;
}

/* A descriptor of 0, 1, 2 that is closed would be given to the next file opened: what is printed would go
 * into a results file. Each is therefore occupied by something that cannot be read, or not be written. A
 * folder, because /dev/null could be opened again for writing by the name /dev/stdout. */
static void occupy_closed(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF)
            (void)!open(fd == STDIN_FILENO ? "/dev/null" : "/", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/* Output that could not be written, because of a full disk or a closed descriptor, is a failed run. Returned:
 * the exit code. */
static int finish(int code)
{
    wf_show_in(NULL);
    bool bad = ferror(stdout) || fflush(stdout);
    int reason = bad ? wf_stream_reason(stdout) : 0;
    errno = 0;
    if (fclose(stdout) && !bad) bad = true, reason = errno;
    if (!bad) return code;
    wf_show(stderr, "windfirm: standard output: %s\n",
            reason == EBADF ? "is closed"
            : reason        ? strerror(reason)
                            : "write error");
    return code ? code : 1;
}

static int run(int argc, char **argv)
{
    if (argc < 2) return wf_usage_overview(stderr, "--help"), 2;
    const char *word = argv[1];
    bool detail = strcmp(word, "help") == 0;
    if (detail || !strcmp(word, "--help") || !strcmp(word, "-h")) wf_usage_language(argc, argv);
    if (wf_usage_overview(stdout, detail && argc < 3 ? "--help" : word)) return 0;
    if (strcmp(word, "--version") == 0 || strcmp(word, "version") == 0)
        return wf_show(stdout, "windfirm %s\n", WF_VERSION) < 0;
    if (strcmp(word, WF_READ_MAT_WORD) == 0) return wf_read_mat_apart(argc, argv);
    if (detail) word = argv[2];
    for (const struct wf_command *c = wf_commands; c->name; c++) {
        if (strcmp(word, c->name) != 0) continue;
        char page[] = "--help", *only_help[] = { argv[detail ? 2 : 1], page, NULL };
        int code = detail ? c->run(2, only_help) : c->run(argc - 1, argv + 1);
        wf_progress_clear();
        return wf_interrupted() ? 128 + wf_interrupted() : code;
    }
    return unknown(word);
}

/* Large blocks are given back to the system as soon as they are free; by default the C library keeps up to 64
 * MB of them, between which later ones do not fit. */
static void keep_no_large_blocks(void)
{
    enum { LARGE = 1 << 20 };
    (void)mallopt(M_MMAP_THRESHOLD, LARGE);
}

int main(int argc, char **argv)
{
    keep_no_large_blocks();
    occupy_closed();
    int code = finish(run(argc, argv));
    wf_arena_drop_spare();
    return code;
}
