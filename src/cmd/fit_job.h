/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_FIT_JOB_H
#define WF_CMD_FIT_JOB_H
/* One calibration on its way from files to results, pages and a species table. */
#include "cmd/cmd.h"
#include "out/fit_results.h"
#include <stdio.h>

struct wf_fit_job {
    struct wf_arena arena;
    struct wf_args args;
    const char *folder;
    struct wf_fit_results r;
};

/* Print a calibration on a terminal: estimates, correlations, sensors, what is not determined, the rival. */
void wf_fit_print(FILE *to, const struct wf_fit_results *of);
#endif
