/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_PRINT_MEASURES_H
#define WF_CMD_PRINT_MEASURES_H
/* What is done to a tree, on the terminal: guys, cables and rods, and the tree beside itself. */
#include "study/beside.h"
#include <stdio.h>

/* Forces in what holds the tree; nothing where nothing does. */
void wf_print_holds(FILE *to, const struct wf_analysis *an);
/* The tree as it stands beside itself with something changed; nothing where nothing is. */
void wf_print_beside(FILE *to, const struct wf_analysis *an);
/* The forces of n of them. */
void wf_print_beside_holds(FILE *to, size_t n, const struct wf_beside *x);
/* Why branches of n of them are less safe than those of the first, the tree as it stands, where gusts are
 * why.
 */
void wf_print_beside_gusts(FILE *to, size_t n, const struct wf_beside *x);
/* A name in the first column of a table; a longer one on a line of its own above. */
void wf_print_name(FILE *to, const char *name, int width);
#endif
