/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_TABLE_H
#define WF_CMD_ASSESS_TABLE_H
/* windfirm assess TABLE: a table of trees, the same table with an assessment of each row out. */
#include "cmd/assess_card.h"

/* Given: the file; options of the command line, whose --output names the table to be written; the command as
 * typed. Memory does not depend on the number of rows. The table grows under the name OUTPUT.partial beside
 * OUTPUT.partial.run, which says what it is of; the same command goes on where it ended. Returned: exit code:
 * 0 when every row was assessed, 2 when cells of rows cannot be, 1 when a computation or the run failed. */
int wf_assess_table(const char *file, struct wf_assess_options *line, const char *command);
#endif
