/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_WIND_ROSE_H
#define WF_CMD_WIND_ROSE_H
/* `windfirm wind rose`: a wind climate read, summed up, drawn. */
#include "cmd/pages.h"

/* Read the rose of --file, print what it says to stdout unless quiet, and leave table, figure and page in the
 * folder of --output. */
enum wf_status wf_wind_rose(const struct wf_args *g, const struct wf_doc_head *head, struct wf_arena *a,
                            struct wf_err *e);
#endif
