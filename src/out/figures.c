/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/figures.h"
#include "out/doc.h"
#include "out/xml.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* A program that was found: its file, what messages call it, the Debian package that contains it, its
 * arguments and the folder it runs in. */
struct program {
    char path[WF_PATH_MAX];
    const char *name, *package, *const *argv, *folder;
};

/* The file of a program. Only absolute folders of PATH are searched: a relative one would mean a place below
 * the folder in which the program is run, which may be a stranger's. */
static bool found(const char *name, char path[static WF_PATH_MAX])
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

/* Between fork and exec only calls that are safe there. Written to `why`: errno of the step that failed. */
static _Noreturn void become(const struct program *p, char **surroundings, pid_t parent, int fd, int why)
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
    int empty = open("/dev/null", O_RDONLY);
    if (empty >= 0 && dup2(empty, STDIN_FILENO) >= 0 && dup2(fd, STDOUT_FILENO) >= 0 &&
        dup2(fd, STDERR_FILENO) >= 0 && !chdir(p->folder))
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

/* Start the program in its folder with an empty input, both outputs going to fd, and no other file open.
 * Returned: 0 or an errno. */
static int start(const struct program *p, int fd, pid_t *child)
{
    int why[2], reason = 0;
    pid_t parent = getpid();
    char **surroundings = environment();
    if (!surroundings) return ENOMEM;
    if (pipe2(why, O_CLOEXEC)) return free(surroundings), errno;
    *child = fork();
    if (*child == 0) become(p, surroundings, parent, fd, why[1]);
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

static enum wf_status missing(const struct program *p, struct wf_err *e)
{
    return wf_fail(e, WF_EMISSING, "%s is not installed: install the package %s", p->name, p->package);
}

/* Run a program that was found. What it prints is kept, the first WF_SAID_MAX - 1 bytes of it, in `said`.
 * Errors: WF_EOUTPUT with its output when it failed; WF_EMISSING when it says, by status 127, that a part of
 * it is not there. */
static enum wf_status run(const struct program *p, char said[static WF_SAID_MAX], struct wf_err *e)
{
    int ends[2], result = 0;
    pid_t child = -1;
    said[0] = '\0';
    if (pipe2(ends, O_CLOEXEC))
        return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", p->name, strerror(errno));
    int failed = start(p, ends[1], &child);
    (void)close(ends[1]);
    if (!failed) listen_to(ends[0], said);
    (void)close(ends[0]);
    if (failed) return wf_fail(e, WF_EOUTPUT, "%s: cannot be run: %s", p->name, strerror(failed));
    while (waitpid(child, &result, 0) < 0)
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

/* Path of a file of the report that holds wherever a program is run. */
static enum wf_status asset_from_anywhere(const char *name, char path[static WF_PATH_MAX], struct wf_err *e)
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

/* What gnuplot said although it drew the figure: warnings are passed on, anything else is a failure. */
static enum wf_status judge(const char *folder, const char *name, char *said, struct wf_diag *d,
                            struct wf_err *e)
{
    char *rest = NULL;
    bool warned = false;
    for (char *line = strtok_r(said, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        if (!line[strspn(line, " \t\r")]) continue;
        const char *text = strstr(line, "warning: ");
        if (!text) return wf_fail(e, WF_EOUTPUT, "%s/plots/%s: gnuplot says: %s", folder, name, line);
        if (d && !warned)
            wf_diag_warn(d, "figure-warning", "%s/plots/%s: gnuplot says: %s", folder, name,
                         text + strlen("warning: "));
        warned = true;
    }
    return WF_OK;
}

enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_diag *d, struct wf_err *e)
{
    char script[WF_PATH_MAX], part[64], number[24], said[WF_SAID_MAX];
    struct program p = { .name = "gnuplot", .package = "gnuplot-nox", .folder = folder };
    snprintf(part, sizeof part, "plots/%.40s.gp", g->script);
    snprintf(number, sizeof number, "%zu", g->run);
    enum wf_status code = asset_from_anywhere(part, script, e);
    if (code) return code;
    if (!found(p.name, p.path)) return missing(&p, e);
    /* -d: the user's own ~/.gnuplot is not read */
    p.argv = (const char *const[]){ p.name, "-d", "-c", script, ".", picture, language, number, NULL };
    code = run(&p, said, e);
    return code ? code : judge(folder, g->name, said, d, e);
}

/* The name inside the folder of a file that wf_folder_begin began there. */
static const char *inside(const char *folder, const struct wf_file *f)
{
    return f->temporary + strlen(folder) + 1;
}

enum wf_status wf_figures_draw(const char *folder, const struct wf_figure *g, const char *language,
                               xmlDoc **svg, struct wf_diag *d, struct wf_err *e)
{
    char style[WF_PATH_MAX], part[64];
    struct wf_file f = { 0 };
    xmlDoc *drawn;
    *svg = NULL;
    enum wf_status code = wf_report_asset("svg.xsl", style, sizeof style, e);
    snprintf(part, sizeof part, "plots/%.40s.svg", g->name);
    if (!code) code = wf_folder_begin(&f, folder, part, e);
    if (code) return code;
    code = wf_figures_run(folder, g, inside(folder, &f), language, d, e);
    if (!code && !complete(f.temporary))
        code = wf_fail(e, WF_EOUTPUT, "%s: the figure is not complete (is the disk full?)", f.path);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (code || (code = wf_xml_read(f.path, &drawn, e))) return code;
    code = wf_xml_transform(style, drawn, NULL, svg, e);
    xmlFreeDoc(drawn);
    return code;
}

/* The Python that WeasyPrint is installed for: the one in the first line of its program, written as a path or
 * as "/usr/bin/env python3"; otherwise the python3 of PATH. */
static bool python_of(const char *program, char path[static WF_PATH_MAX])
{
    char line[WF_PATH_MAX] = "", *rest = NULL;
    FILE *f = fopen(program, "rb");
    bool script = f && fgets(line, sizeof line, f) && !strncmp(line, "#!", 2);
    if (f) fclose(f);
    const char *word = script ? strtok_r(line + 2, " \t\r\n", &rest) : NULL;
    const char *last = word ? strrchr(word, '/') : NULL;
    if (last && !strcmp(last, "/env")) {
        word = strtok_r(NULL, " \t\r\n", &rest);
        if (word && !strncmp(word, "python", 6) && !strchr(word, '/')) return found(word, path);
    } else if (last && *word == '/' && !strncmp(last, "/python", 7) && !access(word, X_OK)) {
        snprintf(path, WF_PATH_MAX, "%s", word);
        return true;
    }
    return found("python3", path);
}

/* Is the file a whole PDF? */
static bool whole_pdf(const char *path)
{
    char head[5] = "", tail[8] = "";
    FILE *pdf = fopen(path, "rb");
    if (!pdf) return false;
    size_t n = fread(head, 1, 4, pdf);
    head[n] = '\0';
    n = fseek(pdf, -7, SEEK_END) ? 0 : fread(tail, 1, 7, pdf);
    tail[n] = '\0';
    fclose(pdf);
    return !strcmp(head, "%PDF") && strstr(tail, "%%EOF");
}

enum wf_status wf_page_print(const char *folder, const char *page, struct wf_err *e)
{
    char driver[WF_PATH_MAX], html[64], pdf[64], said[WF_SAID_MAX];
    struct wf_file f = { 0 };
    struct program p = { .name = "weasyprint", .package = "weasyprint", .folder = folder };
    snprintf(html, sizeof html, "%.40s.html", page);
    snprintf(pdf, sizeof pdf, "%.40s.pdf", page);
    enum wf_status code = asset_from_anywhere("pdf.py", driver, e);
    if (code) return code;
    if (!found(p.name, p.path) || !python_of(p.path, p.path)) return missing(&p, e);
    if ((code = wf_folder_begin(&f, folder, pdf, e))) return code;
    /* -E: PYTHONPATH may name the current folder */
    p.argv = (const char *const[]){ "python3", "-E", driver, html, inside(folder, &f), NULL };
    code = run(&p, said, e);
    /* WeasyPrint continues after an error and still ends with status 0 */
    if (!code && strstr(said, "ERROR"))
        code = wf_fail(e, WF_EOUTPUT, "%s: WeasyPrint says: %s", f.path, said);
    if (!code && !whole_pdf(f.temporary))
        code = wf_fail(e, WF_EOUTPUT, "%s: the file is not complete (is the disk full?)", f.path);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return code;
}
