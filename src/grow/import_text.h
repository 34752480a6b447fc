/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_TEXT_H
#define WF_GROW_IMPORT_TEXT_H
/* Readers of tree tables in text files. */
#include "grow/import_file.h"

wf_import_reader wf_import_table; /* text with a header row */
wf_import_reader wf_import_bare;  /* TreeQSM text: numbers in columns, with or without its header */

/* Whether a text is for wf_import_bare: it begins with TreeQSM's header or with a number. */
bool wf_import_is_bare(const struct wf_import_head *h);
#endif
