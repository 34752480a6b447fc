/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_PRINT_WALLS_H
#define WF_CMD_PRINT_WALLS_H
/* Cavities of the stem on the terminal. */
#include "study/analysis.h"
#include <stdio.h>

/* What each cavity takes from the stem, and the least wall by wind; nothing where there are none. */
void wf_print_walls(FILE *to, const struct wf_analysis *an);
#endif
