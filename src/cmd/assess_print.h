/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_PRINT_H
#define WF_CMD_ASSESS_PRINT_H
/* What windfirm assess prints of one tree. */
#include "study/assessment.h"
#include <stdio.h>

/* The first page: verdict, safeties, critical wind, what was not assessed. Given: a finished analysis with
 * its assessment. */
void wf_print_assessment(FILE *to, const struct wf_analysis *an);
#endif
