/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_PRINT_H
#define WF_CMD_ANALYZE_PRINT_H
/* What analyze and compare print on a terminal. */
#include "out/results.h"
#include <stdio.h>

/* Print the results of a run in a forester's units: a table of the wind speeds, the critical wind speeds and
 * the segments that fail, for each species; directions and hours a year where there are some. */
void wf_analysis_print(FILE *to, const struct wf_run *run);
#endif
