/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/figures.h"
#include "out/doc.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
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
    /* posix_spawn takes char *const[] for historical reasons; it does not change the strings. */
    union {
        const char *const *given;
        char *const *wanted;
    } words = { .given = argv };
    if (!failed) failed = posix_spawnp(child, argv[0], &act, NULL, words.wanted, environ);
    posix_spawn_file_actions_destroy(&act);
    return failed;
}

/* Keep the start of the output and read the rest too, so that a full pipe never blocks the program. */
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
            return wf_fail(e, WF_EOUTPUT, "%s: waiting for its end failed: %s", argv[0], strerror(errno));
    if (WIFSIGNALED(result))
        return wf_fail(e, WF_EOUTPUT, "%s was ended by signal %d: %s", argv[0], WTERMSIG(result), said);
    if (WEXITSTATUS(result) == 127)
        return wf_fail(e, WF_EMISSING, "%s cannot be started (%s): install the package %s", argv[0], said,
                       package);
    if (WEXITSTATUS(result))
        return wf_fail(e, WF_EOUTPUT, "%s failed (status %d): %s", argv[0], WEXITSTATUS(result), said);
    return WF_OK;
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

/* Does the file end in </svg>? gnuplot leaves an empty file after an error and an incomplete one on a full
 * disk. */
static bool complete(const char *path)
{
    static const char tail[] = "</svg>";
    char last[64];
    FILE *f = fopen(path, "rb");
    if (!f) return false;
    long back = (long)sizeof last - 1;
    if (fseek(f, -back, SEEK_END)) rewind(f);
    size_t n = fread(last, 1, sizeof last - 1, f);
    fclose(f);
    last[n] = '\0';
    return strstr(last, tail) != NULL;
}

/* gnuplot takes names that begin with '<' or '|' for commands. */
static const char *plain_name(const char *path, char room[static WF_PATH_MAX])
{
    if (path[0] == '/' || path[0] == '.') return path;
    int n = snprintf(room, WF_PATH_MAX, "./%s", path);
    return n < WF_PATH_MAX ? room : path;
}

enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_err *e)
{
    char script[WF_PATH_MAX], part[64], from[WF_PATH_MAX], to[WF_PATH_MAX], run[24], said[WF_SAID_MAX];
    snprintf(part, sizeof part, "plots/%.40s.gp", g->script);
    snprintf(run, sizeof run, "%zu", g->run);
    enum wf_status code = wf_report_asset(part, script, sizeof script, e);
    if (code) return code;
    const char *const argv[] = { "gnuplot", "-c", script, plain_name(folder, from), plain_name(picture, to),
                                 language,  run,  NULL };
    code = wf_program_run(argv, "gnuplot-nox", said, e);
    if (!code && *said) code = wf_fail(e, WF_EOUTPUT, "%s/plots/%s: gnuplot says: %s", folder, g->name, said);
    return code;
}

enum wf_status wf_figures_draw(const char *folder, const struct wf_figure *g, const char *language,
                               xmlDoc **svg, struct wf_err *e)
{
    char style[WF_PATH_MAX], part[64];
    struct wf_file f = { 0 };
    xmlDoc *drawn;
    *svg = NULL;
    enum wf_status code = wf_report_asset("svg.xsl", style, sizeof style, e);
    snprintf(part, sizeof part, "plots/%.40s.svg", g->name);
    if (!code) code = wf_folder_begin(&f, folder, part, e);
    if (code) return code;
    code = wf_figures_run(folder, g, f.temporary, language, e);
    if (!code && !complete(f.temporary))
        code = wf_fail(e, WF_EOUTPUT, "%s: the figure is not complete (is the disk full?)", f.path);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (code || (code = wf_xml_read(f.path, &drawn, e))) return code;
    code = wf_xml_transform(style, drawn, NULL, NULL, svg, e);
    xmlFreeDoc(drawn);
    return code;
}
