/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed of tables of trees on one core: rows a second without an interval, and with one of 256 samples. User
 * and system time of the whole run, the fastest of some; the wall clock of two threads beside it. */
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { CARDS = 40 };
static char folder[300];
static const char *program;

static double seconds(struct timeval t) { return (double)t.tv_sec + 1e-6 * (double)t.tv_usec; }

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Run a command line. Returned: user and system time [s]. */
static double run(const char *command)
{
    struct rusage a, b;
    getrusage(RUSAGE_CHILDREN, &a);
    int code = system(command);
    getrusage(RUSAGE_CHILDREN, &b);
    if (code) {
        fprintf(stderr, "failed: %s\n", command);
        exit(1);
    }
    return seconds(b.ru_utime) - seconds(a.ru_utime) + seconds(b.ru_stime) - seconds(a.ru_stime);
}

/* So many of the example's cards, from the first on and again. */
static void write_table(size_t rows)
{
    char command[1600];
    snprintf(command, sizeof command,
             "f=docs/examples/forty_trees.csv; (head -2 $f; for i in $(seq %zu); do tail -n +3 $f; done | "
             "head -%zu) "
             ">'%s/trees.csv'",
             rows / CARDS + 1, rows, folder);
    (void)run(command);
}

static void measure(size_t rows, int samples, int times, double bar)
{
    char command[1600];
    double best = 1e9, wall = 1e9;
    write_table(rows);
    for (int i = 0; i < times + 1; i++) {
        int threads = i < times ? 1 : 2;
        snprintf(
            command, sizeof command,
            "%s assess '%s/trees.csv' -o '%s/out%d.csv' --wind 'gust:33 m/s' --soil mineral --samples %d "
            "--threads %d -q",
            program, folder, folder, threads, samples, threads);
        double start = now(), t = run(command), took = now() - start;
        if (threads == 1 && t < best) best = t;
        if (threads == 2) wall = took;
    }
    snprintf(command, sizeof command, "cmp '%s/out1.csv' '%s/out2.csv'", folder, folder);
    (void)run(command); /* the bytes are the same */
    printf(
        "tables: %zu rows, %d samples: %.2f s of processor time, %.3g rows/s a core (bar %g); on two threads "
        "%.3g rows/s of the wall clock\n",
        rows, samples, best, (double)rows / best, bar, (double)rows / wall);
}

int main(void)
{
    char command[400];
    program = getenv("WINDFIRM");
    if (!program) program = "build/windfirm";
    snprintf(folder, sizeof folder, "%.150s.%ld.tables", program, (long)getpid());
    snprintf(command, sizeof command, "mkdir -p '%s'", folder);
    (void)run(command);
    measure(1000, 0, 3, 300);
    measure(CARDS, 256, 2, 5);
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    (void)run(command);
    return 0;
}
