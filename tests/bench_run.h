/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_BENCH_RUN_H
#define WF_TESTS_BENCH_RUN_H
/* Command lines whose time is taken, in a folder of their own. */
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static char folder[300];
static const char *program; /* WINDFIRM, or that of the build */

struct spent {
    double wall, processor; /* user and system time of children [s] */
};

static double seconds_of_children(void)
{
    struct rusage r;
    getrusage(RUSAGE_CHILDREN, &r);
    return (double)(r.ru_utime.tv_sec + r.ru_stime.tv_sec) +
           1e-6 * (double)(r.ru_utime.tv_usec + r.ru_stime.tv_usec);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Run a command line; one that fails ends the program. */
static struct spent run(const char *command)
{
    double processor = seconds_of_children(), wall = now();
    if (system(command)) {
        fprintf(stderr, "failed: %s\n", command);
        exit(1);
    }
    return (struct spent){ now() - wall, seconds_of_children() - processor };
}

static void open_folder(const char *name)
{
    char command[400];
    program = getenv("WINDFIRM");
    if (!program) program = "build/windfirm";
    snprintf(folder, sizeof folder, "%.150s.%ld.%.40s", program, (long)getpid(), name);
    snprintf(command, sizeof command, "mkdir -p '%s'", folder);
    (void)run(command);
}

static void drop_folder(void)
{
    char command[400];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    (void)run(command);
}
#endif
