/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ANALYZE_PRINT_H
#define WF_CMD_ANALYZE_PRINT_H
/* What analyze and compare print on a terminal, in a forester's units, as soon as it is known: what the
 * specified winds do, then the results of the searches. */
#include "study/analysis.h"
#include <stdio.h>

/* Model, wind profile, air and solver of a run. */
void wf_print_head(FILE *to, const struct wf_analysis *first);
/* Where the named winds are measured, their gusts, the ground of the site, and how the wind is carried to it.
 */
void wf_print_site(FILE *to, const struct wf_scenario *s);
/* The table of the specified wind speeds of a species. */
void wf_print_speeds(FILE *to, const struct wf_analysis *an);
/* Below it: critical wind speeds and the segments that fail; directions and hours a year where there are
 * some. */
void wf_print_searched(FILE *to, const struct wf_analysis *an);
/* How sure the critical wind is; nothing where an analysis has no interval. */
void wf_print_interval(FILE *to, const struct wf_analysis *an);
/* The tree with rain, or snow and ice, beside itself without: a line each; nothing where there is none. */
void wf_print_wetted(FILE *to, const struct wf_analysis *an);
#endif
