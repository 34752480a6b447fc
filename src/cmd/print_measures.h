/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_PRINT_MEASURES_H
#define WF_CMD_PRINT_MEASURES_H
/* What is done to a tree, on the terminal: guys, cables and rods, branches that are removed. */
#include "study/analysis.h"
#include <stdio.h>

/* Forces in the cables that hold the tree; nothing where there is none. */
void wf_print_guys(FILE *to, const struct wf_analysis *an);
void wf_print_braces(FILE *to, const struct wf_analysis *an);
/* The tree as it stands beside itself without some branches; nothing where there are none. */
void wf_print_removals(FILE *to, const struct wf_analysis *an);
#endif
