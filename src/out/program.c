/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/program.h"
#include "base/progress.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

bool wf_program_found(const char *name, char path[static WF_PATH_MAX])
{
    const char *list = getenv("PATH");
    for (size_t n; list && *list; list += n + (list[n] == ':')) {
        struct stat s;
        n = strcspn(list, ":");
        if (*list != '/') continue;
        int wide = snprintf(path, WF_PATH_MAX, "%.*s/%s", (int)n, list, name);
        if (wide < WF_PATH_MAX && !access(path, X_OK) && !stat(path, &s) && S_ISREG(s.st_mode)) return true;
    }
    return false;
}

/* Between fork and exec only calls that are safe there. in: what it reads, -1: nothing; out: both outputs.
 * Written to `why`: errno of the step that failed. */
static _Noreturn void become(const struct wf_program *p, char **surroundings, pid_t parent, int in, int out,
                             int why)
{
    /* execve takes char *const[] for historical reasons; it does not change the strings. */
    union {
        const char *const *given;
        char *const *wanted;
    } words = { .given = p->argv };
    sigset_t none;
    sigemptyset(&none);
    (void)sigprocmask(SIG_SETMASK, &none, NULL);
#ifdef __linux__
    /* A parent that is killed takes it along; one that died before this call is noticed. */
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) || getppid() != parent) _exit(1);
    (void)close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
#else
    (void)parent;
#endif
    /* what a stranger's numbers can make it do has an end */
    const struct rlimit seconds = { 600, 600 }, bytes = { (rlim_t)8 << 30, (rlim_t)8 << 30 };
    (void)setrlimit(RLIMIT_CPU, &seconds);
    (void)setrlimit(RLIMIT_AS, &bytes);
    int from = in < 0 ? open("/dev/null", O_RDONLY) : in;
    if (from >= 0 && dup2(from, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
        dup2(out, STDERR_FILENO) >= 0 && (!p->folder || !chdir(p->folder)))
        (void)execve(p->path, words.wanted, surroundings);
    int reason = errno;
    (void)!write(why, &reason, sizeof reason);
    _exit(1);
}

/* The environment of a program: ours, with a locale whose encoding is UTF-8. In another one gnuplot cannot
 * convert its degree sign. Returned: an array to be freed, NULL without memory. */
static char **environment(void)
{
    static char locale[] = "LC_ALL=C.UTF-8";
    size_t n = 0, kept = 0;
    while (environ[n]) n++;
    char **all = calloc(n + 2, sizeof *all);
    if (!all) return NULL;
    for (size_t i = 0; i < n; i++)
        if (strncmp(environ[i], "LC_ALL=", 7) != 0) all[kept++] = environ[i];
    all[kept] = locale;
    return all;
}

/* Start the program. Returned: 0 or an errno. */
static int start(const struct wf_program *p, int in, int out, pid_t *child)
{
    int why[2], reason = 0;
    pid_t parent = getpid();
    char **surroundings = environment();
    if (!surroundings) return ENOMEM;
    if (pipe2(why, O_CLOEXEC)) return free(surroundings), errno;
    *child = fork();
    if (*child == 0) become(p, surroundings, parent, in, out, why[1]);
    if (*child < 0) reason = errno;
    (void)close(why[1]);
    free(surroundings);
    ssize_t got;
    while (!reason && (got = read(why[0], &reason, sizeof reason)) < 0 && errno == EINTR) {
    }
    (void)close(why[0]);
    if (reason && *child > 0)
        while (waitpid(*child, NULL, 0) < 0 && errno == EINTR) {
        }
    return reason;
}

enum wf_status wf_program_start(const struct wf_program *p, bool talks, struct wf_running *r,
                                struct wf_err *e)
{
    int in[2] = { -1, -1 }, out[2];
    if (pipe2(out, O_CLOEXEC))
        return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", p->name, strerror(errno));
    /* a socket: writing to a program that ended is an error there, and no signal */
    int failed = talks && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in) ? errno : 0;
    if (!failed) failed = start(p, in[1], out[1], &r->child);
    (void)close(out[1]);
    if (in[1] >= 0) (void)close(in[1]);
    r->in = in[0], r->out = out[0];
    if (!failed) return WF_OK;
    (void)close(out[0]);
    if (in[0] >= 0) (void)close(in[0]);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", p->name, strerror(failed));
}

bool wf_program_tell(const struct wf_running *r, const void *bytes, size_t n)
{
    for (const char *at = bytes; n;) {
        ssize_t put = send(r->in, at, n, MSG_NOSIGNAL);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        at += put, n -= (size_t)put;
    }
    return true;
}

/* Until there is something to read, or the end. Progress is shown meanwhile. */
static void wait_for(int fd)
{
    struct pollfd p = { .fd = fd, .events = POLLIN };
    while (poll(&p, 1, 250) == 0) wf_stage_step(0);
}

bool wf_program_hear(const struct wf_running *r, char said[static WF_SAID_MAX])
{
    char piece[512];
    size_t kept = strlen(said);
    bool whole = false;
    while (!whole) {
        wait_for(r->out);
        ssize_t got = read(r->out, piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        whole = r->in >= 0 && piece[got - 1] == '\0';
        size_t n = (size_t)got - whole, room = WF_SAID_MAX - 1 - kept;
        if (n > room) n = room;
        memcpy(said + kept, piece, n);
        kept += n;
    }
    while (kept > 0 && (said[kept - 1] == '\n' || said[kept - 1] == ' ')) kept--;
    said[kept] = '\0';
    return whole;
}

enum wf_status wf_program_end(const struct wf_program *p, struct wf_running *r, char said[static WF_SAID_MAX],
                              struct wf_err *e)
{
    int result = 0;
    if (r->in >= 0) (void)close(r->in), r->in = -1;
    (void)wf_program_hear(r, said);
    (void)close(r->out);
    while (waitpid(r->child, &result, 0) < 0)
        if (errno != EINTR)
            return wf_fail(e, WF_EOUTPUT, "%s: waiting for its end failed: %s", p->name, strerror(errno));
    if (WIFSIGNALED(result))
        return wf_fail(e, WF_EOUTPUT, "%s was ended by signal %d: %s", p->name, WTERMSIG(result), said);
    if (WEXITSTATUS(result) == 127)
        return wf_fail(e, WF_EMISSING, "%s cannot be started (%s): install the package %s", p->name, said,
                       p->package);
    if (WEXITSTATUS(result))
        return wf_fail(e, WF_EOUTPUT, "%s failed (status %d): %s", p->name, WEXITSTATUS(result), said);
    return WF_OK;
}

enum wf_status wf_program_run(const struct wf_program *p, char said[static WF_SAID_MAX], struct wf_err *e)
{
    struct wf_running r;
    said[0] = '\0';
    enum wf_status s = wf_program_start(p, false, &r, e);
    return s ? s : wf_program_end(p, &r, said, e);
}

enum wf_status wf_program_missing(const struct wf_program *p, struct wf_err *e)
{
    return wf_fail(e, WF_EMISSING, "%s is not installed: install the package %s", p->name, p->package);
}

enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e)
{
    const char *share = getenv("WINDFIRM_SHARE");
    int n = snprintf(path, size, "%s/reports/%s", share && *share ? share : WF_SHARE, name);
    if (n < 0 || (size_t)n >= size) return wf_fail(e, WF_EINPUT, "WINDFIRM_SHARE: the name is too long");
    if (!access(path, R_OK)) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: cannot be read; set WINDFIRM_SHARE to the folder that holds windfirm's reports/",
                   path);
}

enum wf_status wf_report_asset_anywhere(const char *name, char path[static WF_PATH_MAX], struct wf_err *e)
{
    char given[WF_PATH_MAX], here[WF_PATH_MAX];
    enum wf_status code = wf_report_asset(name, given, sizeof given, e);
    if (code) return code;
    bool whole = given[0] == '/';
    if (!whole && !getcwd(here, sizeof here))
        return wf_fail(e, WF_EINPUT, "%s: the current folder has no name: %s", given, strerror(errno));
    int n = snprintf(path, WF_PATH_MAX, "%s%s%s", whole ? "" : here, whole ? "" : "/", given);
    return n < WF_PATH_MAX ? WF_OK : wf_fail(e, WF_EINPUT, "WINDFIRM_SHARE: the name is too long");
}
