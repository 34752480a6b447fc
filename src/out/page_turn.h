/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PAGE_TURN_H
#define WF_OUT_PAGE_TURN_H
/* A page in other units than the metric ones that the stylesheets are written in (out/page_units.h). A column
 * of a table is turned as a whole, with its head, where all its cells are numbers; so is a row that names its
 * unit. Nothing in pictures, scripts and styles is turned. */
#include "base/err.h"
#include <libxml/tree.h>
#include <stdio.h>

/* Before the stylesheet: texts of the job (title, client, ...) are marked as typed, and private characters of
 * users are replaced, so that they are no marks. Errors: WF_ENOMEM. */
enum wf_status wf_page_guard(xmlNode *results, struct wf_err *e);
/* Turn a page that a stylesheet made, and write it as HTML. Errors: WF_ENOMEM, WF_EOUTPUT. */
enum wf_status wf_page_turn(const char *system, xmlDoc *page, FILE *f, struct wf_err *e);
#endif
