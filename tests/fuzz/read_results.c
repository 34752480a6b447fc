/* SPDX-License-Identifier: GPL-3.0-or-later */
/* results.json and the pages made of it: out/report.h. The outside programs are not started. */
#include "fuzz.h"
#include "out/doc.h"
#include "out/report.h"
#include "out/results.h"
#include <errno.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* The linker puts this in the place of posix_spawnp (--wrap): figures and PDF are as if gnuplot and
 * WeasyPrint were not installed. */
int __wrap_posix_spawnp(pid_t *child, const char *file, const posix_spawn_file_actions_t *act,
                        const posix_spawnattr_t *attributes, char *const argv[], char *const env[]);
int __wrap_posix_spawnp(pid_t *child, const char *file, const posix_spawn_file_actions_t *act,
                        const posix_spawnattr_t *attributes, char *const argv[], char *const env[])
{
    (void)child, (void)file, (void)act, (void)attributes, (void)argv, (void)env;
    return ENOENT;
}

static char folder[128];

static void remove_folder(void)
{
    char command[256];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    if (system(command)) perror(folder);
}

static void write_file(const char *name, const uint8_t *data, size_t size)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    must(f && (!size || fwrite(data, 1, size, f) == size) && fclose(f) == 0, "a scratch file");
}

/* A results folder whose tables are empty. */
static void make_folder(void)
{
    const char *room = getenv("TMPDIR");
    struct wf_err e = { 0 };
    snprintf(folder, sizeof folder, "%s/windfirm-fuzz-XXXXXX", room ? room : "/tmp");
    must(mkdtemp(folder) != NULL && !wf_folder_make(folder, &e), "a scratch folder");
    atexit(remove_folder);
    for (size_t i = 0; wf_tables[i].name; i++) write_file(wf_tables[i].name, NULL, 0);
}

static enum wf_status reading(struct fuzz *f)
{
    static pid_t owner;
    if (owner != getpid()) make_folder(); /* replay runs in child processes */
    owner = getpid();
    write_file("results.json", f->data, f->size);
    return wf_report_make(folder, f->size % 2 ? "en" : "zh", &f->diag, &f->err);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
