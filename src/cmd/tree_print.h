/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_TREE_PRINT_H
#define WF_CMD_TREE_PRINT_H
/* Figures of a measured tree on the terminal. */
#include "out/tree_summary.h"
#include <stdio.h>

/* One tree, one page. */
void wf_tree_print_page(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w);
#endif
