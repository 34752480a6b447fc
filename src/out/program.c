/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/program.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Start the program with an empty input and both its outputs going to fd. Returned: 0 or an errno. */
static int start(const char *const *argv, int fd, pid_t *child)
{
    posix_spawn_file_actions_t act;
    int failed = posix_spawn_file_actions_init(&act);
    if (failed) return failed;
    failed = posix_spawn_file_actions_addopen(&act, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!failed) failed = posix_spawn_file_actions_adddup2(&act, fd, STDOUT_FILENO);
    if (!failed) failed = posix_spawn_file_actions_adddup2(&act, fd, STDERR_FILENO);
    /* posix_spawn takes char *const[] for the sake of old callers and changes nothing. */
    union {
        const char *const *given;
        char *const *wanted;
    } words = { .given = argv };
    if (!failed) failed = posix_spawnp(child, argv[0], &act, NULL, words.wanted, environ);
    posix_spawn_file_actions_destroy(&act);
    return failed;
}

/* Keep the first words and read on to the end, so that the program is never blocked by a full pipe. */
static void listen_to(int fd, char said[static WF_SAID_MAX])
{
    char piece[512];
    size_t kept = 0;
    for (;;) {
        ssize_t got = read(fd, piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        size_t room = WF_SAID_MAX - 1 - kept, n = (size_t)got < room ? (size_t)got : room;
        memcpy(said + kept, piece, n);
        kept += n;
    }
    while (kept > 0 && (said[kept - 1] == '\n' || said[kept - 1] == ' ')) kept--;
    said[kept] = '\0';
}

enum wf_status wf_program_run(const char *const *argv, const char *package, char said[static WF_SAID_MAX],
                              struct wf_err *e)
{
    int ends[2], result = 0;
    pid_t child;
    said[0] = '\0';
    if (pipe2(ends, O_CLOEXEC))
        return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", argv[0], strerror(errno));
    int failed = start(argv, ends[1], &child);
    (void)close(ends[1]);
    if (!failed) listen_to(ends[0], said);
    (void)close(ends[0]);
    if (failed == ENOENT)
        return wf_fail(e, WF_EMISSING, "%s is not installed: install the package %s", argv[0], package);
    if (failed) return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", argv[0], strerror(failed));
    while (waitpid(child, &result, 0) < 0)
        if (errno != EINTR)
            return wf_fail(e, WF_EOUTPUT, "%s: its end was missed: %s", argv[0], strerror(errno));
    if (WIFSIGNALED(result))
        return wf_fail(e, WF_EOUTPUT, "%s was ended by signal %d: %s", argv[0], WTERMSIG(result), said);
    if (WEXITSTATUS(result) == 127)
        return wf_fail(e, WF_EMISSING, "%s cannot be started (%s): install the package %s", argv[0], said,
                       package);
    if (WEXITSTATUS(result))
        return wf_fail(e, WF_EOUTPUT, "%s failed (status %d): %s", argv[0], WEXITSTATUS(result), said);
    return WF_OK;
}
