/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_DOCX_H
#define WF_OUT_DOCX_H
/* A page as a document of a word processor (Office Open XML), by pandoc. Figures are pictures of points in
 * it, drawn anew by gnuplot; what answers on the screen is left out. */
#include "base/err.h"
#include "out/figures.h"
#include <libxml/tree.h>

/* Whether pandoc is there. Errors: WF_EMISSING, with the package to install. */
enum wf_status wf_docx_possible(struct wf_err *e);
/* Write FOLDER/PAGE.docx. Given: the whole page, n figures that were drawn for it, the language of their
 * labels. pandoc reads the page in its sandbox; before it writes the document, which it cannot do there, its
 * reading is checked to hold no address but pictures of the page itself, and nothing that is written as it
 * is. Errors: WF_EMISSING without pandoc, WF_EOUTPUT with its words, WF_ENOMEM. */
enum wf_status wf_docx_make(const char *folder, const char *page, const xmlDoc *html,
                            const struct wf_figure *g, size_t n, const char *language, struct wf_err *e);
#endif
