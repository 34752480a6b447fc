/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_SHELTER_PRINT_H
#define WF_CMD_SHELTER_PRINT_H
#include "out/shelter_results.h"
#include <stdio.h>

/* Slabs and the windward and leeward thirds, for a terminal. */
void wf_shelter_print(FILE *to, const struct wf_shelter_run *r);
#endif
