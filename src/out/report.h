/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_REPORT_H
#define WF_OUT_REPORT_H
/* The page maker: figures and pages of any results folder, made from its results.json, tables/ and plots/
 * alone. */
#include "base/err.h"
#include <stdbool.h>

struct wf_printer;

/* How pages are made. */
struct wf_page_style {
    const char *language;  /* "en" or "zh"; NULL: "en"                                             */
    const char *units;     /* "metric", "imperial" or "cn" (out/page_units.h); NULL: "metric"      */
    const char *templates; /* a folder of the user's (out/template.h); NULL: the shipped ones */
    bool docx;             /* also as PAGE.docx (out/docx.h) */
};

/* Draw FOLDER/plots/ *.svg (gnuplot), and write FOLDER/PAGE.html (XSLT) and, with a printer (out/printer.h;
 * NULL: none), FOLDER/PAGE.pdf (WeasyPrint). The caller closes the printer; one prints the pages of any
 * number of folders. PAGE and its stylesheet follow from schema.name of results.json: report (analyze,
 * compare), calibration (fit), series, explain, wind, rose, shelter, terrain. Given: a folder that one of the
 * writers filled; how (NULL: as { 0 }); list of findings. Returned: WF_OK when every figure and
 * page was made. Otherwise all parts that can be made are made, each missing part is a warning in `d`, and
 * the status of the first is returned: WF_EMISSING where an outside program is not installed (the text names
 * its package), WF_EOUTPUT where it failed; WF_EINPUT when results.json is missing or not such a document,
 * WF_EUSAGE for an unknown language or system of units. Scripts and stylesheets are taken from
 * $WINDFIRM_SHARE/reports, else from where they were installed. */
enum wf_status wf_report_make(const char *folder, const struct wf_page_style *style,
                              struct wf_printer *printer, struct wf_diag *d, struct wf_err *e);
#endif
