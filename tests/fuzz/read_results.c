/* SPDX-License-Identifier: GPL-3.0-or-later */
/* results.json and the pages made of it: out/report.h. The outside programs are not started. */
#include "fuzz.h"
#include "out/doc.h"
#include "out/report.h"
#include "out/results.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

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

/* A results folder whose tables are empty. Without PATH, figures are as if gnuplot were not installed. */
static void make_folder(void)
{
    const char *room = getenv("TMPDIR");
    struct wf_err e = { 0 };
    snprintf(folder, sizeof folder, "%s/windfirm-fuzz-XXXXXX", room ? room : "/tmp");
    must(mkdtemp(folder) != NULL && !wf_folder_make(folder, &e), "a scratch folder");
    atexit(remove_folder);
    must(!unsetenv("PATH"), "no programs");
    for (size_t i = 0; wf_tables[i].name; i++) write_file(wf_tables[i].name, NULL, 0);
}

static enum wf_status reading(struct fuzz *f)
{
    static pid_t owner;
    if (owner != getpid()) make_folder(); /* replay runs in child processes */
    owner = getpid();
    write_file("results.json", f->data, f->size);
    return wf_report_make(folder, &(struct wf_page_style){ .language = f->size % 2 ? "en" : "zh" }, NULL, &f->diag, &f->err);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
