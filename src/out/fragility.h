/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FRAGILITY_H
#define WF_OUT_FRAGILITY_H
/* How sure a critical wind is: as a part of results.json, and the document, tables and figure of `windfirm
 * fragility`. */
#include "out/doc.h"
#include "study/interval.h"

/* The interval of an analysis; null where it has none. */
json_t *wf_part_interval(struct wf_doc *d, const struct wf_analysis *a);

/* Write tables/fragility.csv, tables/tornado.csv, plots/run.csv and results.json. Given: an analysis with its
 * interval; a name for the page; the name of the species in Chinese, NULL: none; warnings. Errors:
 * WF_EOUTPUT, WF_ENOMEM. */
enum wf_status wf_fragility_write(const struct wf_analysis *a, const char *name, const char *name_zh,
                                  const struct wf_diag *findings, const struct wf_doc_head *head,
                                  const char *folder, struct wf_err *e);
#endif
