/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Study files: the options of a command as keys (cmd/args.h), for each command that takes one. */
#include "cmd/args.h"
#include "cmd/commands.h"
#include "fuzz.h"
#include <stdalign.h>
#include <stdio.h>

/* Room for the options struct of any command; the structs are known to their commands alone. */
static alignas(64) unsigned char options[1 << 16];

/* Mistakes are printed: not here. Sanitizers write to the descriptor, not to this stream. */
static void hush(void)
{
    static FILE *nowhere;
    if (!nowhere) nowhere = stderr = fopen("/dev/null", "w");
    must(nowhere != NULL, "a stream that keeps nothing");
}

static void take(struct fuzz *f, const char *command, const struct wf_option *rows)
{
    char name[16], path[64];
    char *argv[] = { name, (char[]){ "--study" }, path };
    snprintf(name, sizeof name, "%s", command);
    snprintf(path, sizeof path, "%s", f->path);
    int code = wf_args_read(3, argv, rows, "", 0, 1000, &f->arena, (struct wf_args *)(void *)options);
    must(code == -1 || code == 2, "a study file is taken or refused");
}

static enum wf_status reading(struct fuzz *f)
{
    hush();
    take(f, "analyze", wf_analyze_options);
    take(f, "explain", wf_explain_options);
    take(f, "series", wf_series_options);
    take(f, "shelter", wf_shelter_options);
    take(f, "wind", wf_wind_options);
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
