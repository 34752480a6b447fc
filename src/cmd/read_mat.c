/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/read_mat.h"
#include "grow/import.h"
#include "grow/import_mat.h"
#include "grow/import_pack.h"
#include <errno.h>
#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define SANITIZED
#endif

extern char **environ;

/* Processor time that a file may take [s]. */
static unsigned cpu_limit(const char *path)
{
    struct stat s;
    off_t mega = stat(path, &s) == 0 ? s.st_size / 1000000 : 0;
    return 20 + (unsigned)(mega < 3600 ? mega : 3600);
}

/* ---- The process that reads ---- */

/* Lower a limit, never raise an inherited one. The hard limit is `more` above the soft one, whose signal
 * tells the reason. */
static bool limit(__rlimit_resource_t what, rlim_t soft, rlim_t more)
{
    struct rlimit l;
    if (getrlimit(what, &l)) return false;
    if (l.rlim_max > soft + more) l.rlim_max = soft + more;
    if (l.rlim_cur > soft) l.rlim_cur = soft;
    return setrlimit(what, &l) == 0;
}

/* RLIMIT_DATA and not RLIMIT_AS: shared libraries map much more than they use. Sanitizers reserve memory
 * beyond any limit. */
static bool limits(const char *path)
{
    bool good =
        limit(RLIMIT_CPU, cpu_limit(path), 1) && limit(RLIMIT_FSIZE, 0, 0) && limit(RLIMIT_CORE, 0, 0);
#ifndef SANITIZED
    good = good && limit(RLIMIT_DATA, (rlim_t)3 << 30, 0);
#endif
    return good;
}

struct answer {
    char *bytes;
    size_t size;
};

/* Read the file. Given: the model of several, "": not chosen; a byte that fresh memory is filled with. */
static bool answer_make(const char *path, const char *model, int fill, struct answer *out)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_qsm q = { .file = path };
    struct wf_import_head h = { .path = path };
    struct wf_import_options o = wf_import_default();
    o.strict = true; /* rows that cannot be read then are errors in `d`, which wf_import_pack writes */
    o.scan_model = *model ? model : NULL;
    (void)mallopt(M_PERTURB, fill);
    (void)wf_import_mat_apart(&h, &o, &a, &q, &d, &e);
    FILE *to = open_memstream(&out->bytes, &out->size);
    bool good = to && !wf_import_pack(&q, &d, &e, to);
    if (to) good = fclose(to) == 0 && good;
    wf_arena_free(&a);
    return good;
}

/* An answer in place of one that depends on uninitialised memory. */
static bool answer_refuse(const char *path, struct answer *out)
{
    struct wf_diag d = { 0 };
    struct wf_qsm q = { 0 };
    struct wf_err e = { 0 };
    (void)wf_fail(&e, WF_EINPUT, "%s: the MATLAB file is damaged: part of its numbers cannot be read", path);
    FILE *to = open_memstream(&out->bytes, &out->size);
    return to && !wf_import_pack(&q, &d, &e, to) && fclose(to) == 0;
}

static bool answer_send(const struct answer *x, int to)
{
    for (size_t at = 0; at < x->size;) {
        ssize_t n = write(to, x->bytes + at, x->size - at);
        if (n < 0 && errno != EINTR) return false;
        if (n > 0) at += (size_t)n;
    }
    return true;
}

/* Read the file twice with different bytes in fresh memory: numbers that libmatio did not read differ then.
 * The process ends without what libraries do at exit, because their state may be damaged. */
int wf_read_mat_apart(int argc, char **argv)
{
    struct answer first = { 0 }, second = { 0 };
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) || argc != 5 || getppid() != (pid_t)strtol(argv[2], NULL, 10))
        return 2;
    const char *path = argv[3], *model = argv[4];
    int to = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    if (to < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0 || !limits(path)) return 1;
    (void)setenv("HDF5_PLUGIN_PRELOAD", "::", 1); /* no code named by a file is loaded */
    bool good = answer_make(path, model, 0x55, &first) && answer_make(path, model, 0xAA, &second);
    if (good && (first.size != second.size || memcmp(first.bytes, second.bytes, first.size) != 0))
        good = answer_refuse(path, &first);
    _exit(good && answer_send(&first, to) ? 0 : 1);
}

/* ---- The process that asks ---- */

static int reader_start(const char *path, const char *model, pid_t *child, int *from)
{
    char parent[32], self[] = "/proc/self/exe", name[] = "windfirm", word[] = WF_READ_MAT_WORD;
    char *copy = strdup(path), *which = strdup(model ? model : ""),
         *argv[] = { name, word, parent, copy, which, NULL };
    int ends[2], failed = copy && which ? 0 : ENOMEM;
    posix_spawn_file_actions_t act;
    (void)snprintf(parent, sizeof parent, "%ld", (long)getpid());
    if (!failed && pipe2(ends, O_CLOEXEC)) failed = errno;
    if (!failed && (failed = posix_spawn_file_actions_init(&act)) == 0) {
        /* first the pipe: its number may be one of those that are opened after it */
        failed = posix_spawn_file_actions_adddup2(&act, ends[1], STDOUT_FILENO);
        if (!failed) failed = posix_spawn_file_actions_addopen(&act, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        if (!failed) failed = posix_spawn_file_actions_addopen(&act, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        if (!failed) failed = posix_spawn_file_actions_addclosefrom_np(&act, STDERR_FILENO + 1);
        if (!failed) failed = posix_spawn(child, self, &act, NULL, argv, environ);
        posix_spawn_file_actions_destroy(&act);
        (void)close(ends[1]);
        *from = ends[0];
        if (failed) (void)close(ends[0]);
    }
    free(copy);
    free(which);
    return failed;
}

static long milliseconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (long)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

/* Read the pipe to its end. Returned: NULL, or why it was given up. */
static const char *reader_listen(int from, long until, struct answer *x)
{
    for (size_t room = 0;;) {
        if (x->size == room) {
            room = room ? 2 * room : 65536;
            char *more = room <= 2 * (size_t)WF_PACK_MAX ? realloc(x->bytes, room) : NULL;
            if (!more) return "its answer is too large";
            x->bytes = more;
        }
        long left = until - milliseconds();
        struct pollfd p = { .fd = from, .events = POLLIN };
        int ready = left > 0 ? poll(&p, 1, (int)left) : 0;
        if (!ready) return "it did not answer in time";
        if (ready < 0 && errno != EINTR) return strerror(errno);
        if (ready < 0) continue;
        ssize_t n = read(from, x->bytes + x->size, room - x->size);
        if (n == 0) return NULL;
        if (n < 0 && errno != EINTR) return strerror(errno);
        if (n > 0) x->size += (size_t)n;
    }
}

/* Wait for the end of the process, which may hang even though it closed the pipe. Returned: its status. */
static int reader_end(pid_t child, long until)
{
    int status = 0;
    for (;;) {
        pid_t got = waitpid(child, &status, WNOHANG);
        if (got == child || (got < 0 && errno != EINTR)) return status;
        if (milliseconds() >= until) (void)kill(child, SIGKILL);
        (void)poll(NULL, 0, 1);
    }
}

enum wf_status wf_read_mat(const struct wf_import_head *h, const struct wf_import_options *o,
                           struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct answer x = { 0 };
    pid_t child = 0;
    int from = -1, failed = reader_start(h->path, o->scan_model, &child, &from);
    if (failed)
        return wf_fail(e, WF_EMISSING, "%s: the process that reads MATLAB files could not be started: %s",
                       h->path, strerror(failed));
    /* a busy machine gives a process a part of its time */
    long until = milliseconds() + 3000L * cpu_limit(h->path);
    const char *why = reader_listen(from, until, &x);
    (void)close(from);
    int status = reader_end(child, why ? 0 : until);
    enum wf_status s;
    if (why)
        s = wf_fail(e, WF_EINPUT, "%s: the MATLAB file could not be read: the reader was stopped (%s)",
                    h->path, why);
    else if (WIFSIGNALED(status))
        s = wf_fail(e, WF_EINPUT, "%s: the MATLAB file could not be read: the reader stopped (signal %d, %s)",
                    h->path, WTERMSIG(status), strsignal(WTERMSIG(status)));
    else if (WEXITSTATUS(status))
        s = wf_fail(e, WF_EINPUT, "%s: the MATLAB file could not be read: the reader stopped (exit code %d)",
                    h->path, WEXITSTATUS(status));
    else
        s = wf_import_unpack(x.bytes, x.size, h->path, o, a, q, d, e);
    free(x.bytes);
    return s;
}
