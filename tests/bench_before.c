/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processor time of whole runs of the program, beside the same runs of an earlier version.
 *
 *     bench_before [FOLDER]
 *
 * FOLDER: source folder of the earlier version, built there ("make bench-before"); without it the new times
 * stand alone. The earlier version runs once, on one thread, between the first and the further runs of the
 * new one, of which the fastest of five counts; a row that takes long has fewer, and says so. User and system
 * time of the run and all its children; the wall clock on one and two threads beside it. A run counts that
 * ends with code 0 and with a critical wind speed, found or above the range. Measured trees:
 * WINDFIRM_REFERENCE. All of it ends after 345 s (200 s without the earlier version) of the wall clock; on a
 * busy machine BENCH_SECONDS sets another limit. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { RUNS = 5, WORDS = 24, ALL_SECONDS = 345, ALONE_SECONDS = 200, ROW_SECONDS = 20, PRINT_SECONDS = 12 };
static char scratch[] = "/tmp/windfirm-bench-XXXXXX", new_program[4096], old_program[4096];
static double deadline; /* of all rows, by clock() below */

/* What one run took; cpu NAN: it failed or had no outcome. */
struct took {
    double cpu, wall, critical; /* [s], [s], [m/s]; critical INFINITY: above the range */
};

static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Why a row has no time. */
static const char *failure(void) { return clock_now() > deadline ? "the time was up" : "failed"; }

/* The first critical wind speed that was printed; NAN: none. */
static double critical_of(const char *path)
{
    static const char word[] = "critical wind speed ";
    char line[1024];
    double speed = NAN;
    FILE *f = fopen(path, "r");
    while (f && isnan(speed) && fgets(line, sizeof line, f)) {
        const char *at = strstr(line, word);
        if (at && at[sizeof word - 1] == '>')
            speed = INFINITY;
        else if (at)
            (void)sscanf(at + sizeof word - 1, "%lf", &speed);
    }
    if (f) fclose(f);
    return speed;
}

/* Wait for a process until the deadline. Returned: its status, -1 when it had to be killed. */
static int wait_until_deadline(pid_t child, struct rusage *used)
{
    int status = -1;
    for (;;) {
        pid_t got = wait4(child, &status, WNOHANG, used);
        if (got == child) return status;
        if (got < 0 && errno != EINTR) return -1;
        if (clock_now() > deadline) {
            kill(child, SIGKILL);
            (void)wait4(child, &status, 0, used);
            return -1;
        }
        usleep(2000);
    }
}

/* Run a command line of words without quotes; path: PATH for it, NULL: ours. */
static struct took run(const char *program, const char *line, const char *path)
{
    struct took out = { NAN, NAN, NAN };
    char text[4096], file[256], *word[WORDS + 2], *rest = NULL;
    size_t n = 0;
    struct rusage used;
    snprintf(text, sizeof text, "%s", line);
    snprintf(file, sizeof file, "%s/said", scratch);
    word[n++] = text;
    for (char *w = strtok_r(text, " ", &rest); w && n < WORDS; w = strtok_r(NULL, " ", &rest)) word[n++] = w;
    word[n] = NULL;
    double start = clock_now();
    pid_t child = start < deadline ? fork() : -1;
    if (child == 0) {
        int fd = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (path) setenv("PATH", path, 1);
        if (fd >= 0 && dup2(fd, 1) >= 0 && dup2(fd, 2) >= 0) execv(program, word);
        _exit(127);
    }
    if (child < 0) return out;
    int status = wait_until_deadline(child, &used);
    if (!WIFEXITED(status) || status < 0 || WEXITSTATUS(status)) return out;
    out.wall = clock_now() - start;
    out.cpu = (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
              1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    out.critical = critical_of(file);
    return out;
}

static struct took faster(struct took a, struct took b) { return isnan(a.cpu) || b.cpu < a.cpu ? b : a; }

/* One run of both programs. */
struct both {
    struct took old, new;
    int runs; /* of the new one */
};

static struct both compare(const char *line, const char *path, bool before)
{
    struct both b = { { NAN, NAN, NAN }, { NAN, NAN, NAN }, 0 };
    double spent = 0;
    for (; b.runs < RUNS && (b.runs < 2 || spent < ROW_SECONDS); b.runs++) {
        struct took t = run(new_program, line, path);
        if (b.runs == 0 && before && *old_program) b.old = run(old_program, line, path);
        if (isnan(t.cpu)) break;
        spent += t.wall;
        b.new = faster(b.new, t);
    }
    return b;
}

static void print_ratio(double old, double new, const char *bar)
{
    if (!isnan(old)) printf("   before %8.2f s, ratio %5.1f", old, old / new);
    printf("   (bar %s)\n", bar);
}

/* An analysis of a tree; `what` follows "analyze"; before: by the earlier version too. Returned: what the new
 * program took. */
static double row(const char *name, const char *what, const char *bar, bool before)
{
    char line[2048];
    snprintf(line, sizeof line, "analyze %s --no-report -o %s/out --threads 1", what, scratch);
    struct both b = compare(line, NULL, before);
    if (isnan(b.new.cpu) || isnan(b.new.critical)) {
        printf("%-22s %s: does not count\n", name, isnan(b.new.cpu) ? failure() : "no critical wind speed");
        return NAN;
    }
    if (isnan(b.old.critical)) b.old.cpu = NAN;
    line[strlen(line) - 1] = '2';
    struct took two = run(new_program, line, NULL);
    printf("%-22s %7.2f s (best of %d), wall %6.2f s, on two threads %6.2f s, ", name, b.new.cpu, b.runs,
           b.new.wall, two.wall);
    if (isinf(b.new.critical))
        printf("breaks above the range");
    else
        printf("breaks at %.2f m/s", b.new.critical);
    if (!isnan(b.old.cpu) && fabs(b.old.critical / b.new.critical - 1) > 0.002)
        printf(" (before: %.2f)", b.old.critical);
    print_ratio(b.old.cpu, b.new.cpu, bar);
    return b.new.cpu;
}

static void measured_trees(void)
{
    static const struct {
        const char *name, *file, *bar;
    } rows[] = {
        { "T20, 263 rows", "wytham_T20_leafoff", "7" },
        { "T3, 590 rows", "wytham_T3_leafoff", "10" },
        { "T14, 1364 rows", "wytham_T14", "10" },
        { "T13, 3086 rows", "wytham_T13", "9" },
    };
    const char *reference = getenv("WINDFIRM_REFERENCE");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char what[1400], path[1024];
        snprintf(path, sizeof path, "%.900s/trees/qsm/%s.csv", reference ? reference : "", rows[i].file);
        snprintf(what, sizeof what, "ash --tree %s --wind 10", path);
        if (reference && !access(path, R_OK))
            (void)row(rows[i].name, what, rows[i].bar, true);
        else
            printf("%-22s skipped: WINDFIRM_REFERENCE has no %s.csv\n", rows[i].name, rows[i].file);
    }
}

/* A made-up scan of n segments. Returned: whether it was made, at `path`. */
static bool make_scan(const char *self, int n, char path[static 256])
{
    char command[8192];
    const char *slash = strrchr(self, '/');
    snprintf(path, 256, "%s/scan%d.csv", scratch, n);
    snprintf(command, sizeof command, "'%.*s/make_scan' %d >%s", slash ? (int)(slash - self) : 1,
             slash ? self : ".", n, path);
    return system(command) == 0;
}

/* The scan of 1000 rows in 16 wind directions, and with 200 samples of its inputs. one: time of one wind. */
static void many_states(const char *what, double one)
{
    char line[900];
    snprintf(line, sizeof line, "analyze %s --directions 16 --no-report -o %s/out --threads 1", what,
             scratch);
    struct both b = compare(line, NULL, false);
    if (isnan(b.new.cpu) || isnan(one))
        printf("16 directions          %s: does not count\n", isnan(one) ? "no time of one wind" : failure());
    else
        printf("16 directions of it    %7.2f s (best of %d), %.1f times one wind (bar at most 4)\n",
               b.new.cpu, b.runs, b.new.cpu / one);
    snprintf(line, sizeof line, "analyze %s --samples 200 --no-report -o %s/out --threads 1", what, scratch);
    b = compare(line, NULL, false);
    if (isnan(b.new.cpu))
        printf("200 samples of it      %s: does not count\n", failure());
    else
        printf("200 samples of it      %7.2f s (best of %d), inputs varied, the analysis itself included "
               "(bar at "
               "most 5 s)\n",
               b.new.cpu, b.runs);
}

static void made_trees(const char *self)
{
    char path[256], what[600];
    if (make_scan(self, 12000, path)) {
        snprintf(what, sizeof what, "ash --tree %s --wind 10", path);
        (void)row("scan of 12000 rows", what, "11", true);
    }
    if (!make_scan(self, 1000, path)) return;
    snprintf(what, sizeof what, "ash --tree %s --wind 10", path);
    double one = row("scan of 1000 rows", what, "-", false);
    many_states(what, one);
}

/* Pages of a PDF whose objects are not compressed. */
static int pages_of(const char *path)
{
    static char text[1 << 22];
    FILE *f = fopen(path, "rb");
    size_t n = f ? fread(text, 1, sizeof text - 1, f) : 0;
    int pages = 0;
    if (f) fclose(f);
    for (size_t i = 0; i + 12 < n; i++)
        if (!memcmp(text + i, "/Type /Page", 11) && text[i + 11] != 's') pages++;
    return pages;
}

/* Processor time of the PDFs of so many folders: report with and without them. */
static double pdf_time(const char *language, int folders)
{
    double best[2] = { NAN, NAN }, start = clock_now();
    for (int k = 0; k < 4 || (k < 2 * RUNS && (k % 2 || clock_now() - start < PRINT_SECONDS)); k++) {
        char line[4096];
        int n = snprintf(line, sizeof line, "report%s --lang %s", k % 2 ? " --no-pdf" : "", language);
        for (int i = 0; i < folders; i++)
            n += snprintf(line + n, sizeof line - (size_t)n, " %s/page%d", scratch, i);
        double t = run(new_program, line, NULL).cpu;
        if (!(best[k % 2] <= t)) best[k % 2] = t;
    }
    return best[0] - best[1];
}

static void printed_pages(void)
{
    static const char *const language[] = { "en", "zh" };
    enum { FOLDERS = 3 };
    char line[1024], path[256];
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(line, sizeof line,
                 "compare moso_bamboo weeping_willow --model culm --wind 10,15,25 --no-report -o %s/page%d",
                 scratch, i);
        (void)run(new_program, line, NULL);
    }
    for (int k = 0; k < 2; k++) {
        snprintf(line, sizeof line, "report --lang %s %s/page0", language[k], scratch);
        snprintf(path, sizeof path, "%s/page0/report.pdf", scratch);
        (void)run(new_program, line, NULL);
        int pages = pages_of(path);
        if (!pages) {
            puts("PDF                    skipped: no PDF was made");
            return;
        }
        double one = pdf_time(language[k], 1), all = pdf_time(language[k], FOLDERS),
               page = (all - one) / (FOLDERS - 1) / pages;
        printf("PDF in %s, %d pages     %7.3f s a page of further documents (bar at most 0.2); alone %.2f s: "
               "the "
               "start %.2f s and %.3f s a page\n",
               language[k], pages, page, one, one - page * pages, page);
    }
}

/* The demo with figures and page, but without WeasyPrint on PATH. */
static void figures(void)
{
    char line[1024], bin[256], command[1024];
    snprintf(bin, sizeof bin, "%s/bin", scratch);
    snprintf(command, sizeof command, "mkdir %s && ln -s \"$(command -v gnuplot)\" %s/gnuplot 2>/dev/null",
             bin, bin);
    if (system(command)) {
        puts("figures and page       skipped: gnuplot is not installed");
        return;
    }
    snprintf(line, sizeof line, "compare moso_bamboo weeping_willow --model culm --wind 10,15,25 -o %s/out",
             scratch);
    struct both whole = compare(line, bin, true);
    snprintf(line + strlen(line), sizeof line - strlen(line), " --no-report");
    struct both bare = compare(line, bin, true);
    printf(
        "demo, figures, HTML    %7.3f s (best of %d), of which figures and HTML %.3f s (bar at most 0.35 s)",
        whole.new.cpu, whole.runs, whole.new.cpu - bare.new.cpu);
    print_ratio(whole.old.cpu, whole.new.cpu, "-");
}

int main(int argc, char **argv)
{
    const char *self = argc > 0 ? argv[0] : "", *slash = strrchr(self, '/');
    char command[128];
    snprintf(new_program, sizeof new_program, "%.*s/../windfirm", slash ? (int)(slash - self) : 1,
             slash ? self : ".");
    if (argc > 1) snprintf(old_program, sizeof old_program, "%s/build/windfirm", argv[1]);
    if (!mkdtemp(scratch) || access(new_program, X_OK) || (*old_program && access(old_program, X_OK))) {
        fprintf(stderr, "bench_before: %s: not there\n",
                access(new_program, X_OK) ? new_program : old_program);
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    double start = clock_now();
    const char *limit = getenv("BENCH_SECONDS");
    deadline = start + (limit ? strtod(limit, NULL) : *old_program ? ALL_SECONDS : ALONE_SECONDS);
    puts("whole runs, processor time of the run and its children");
    figures();
    printed_pages();
    measured_trees();
    (void)row("bamboo with branches", "moso_bamboo --model moso_branched --wind 10", "15", true);
    (void)row("README's willow", "weeping_willow --model weeping_willow_tree --wind 10", "26", true);
    made_trees(self);
    printf("all of it took %.0f s\n", clock_now() - start);
    snprintf(command, sizeof command, "rm -rf %s", scratch);
    return system(command) ? 1 : 0;
}
