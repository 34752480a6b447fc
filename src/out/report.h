#ifndef WF_OUT_REPORT_H
#define WF_OUT_REPORT_H
/* Figures and pages of a results folder, made from its results.json and tables/ alone. */
#include "base/diag.h"
#include "base/err.h"

/* Draw FOLDER/plots/ *.svg (gnuplot), FOLDER/report.html (XSLT) and FOLDER/report.pdf (WeasyPrint).
 * Given: a folder that wf_results_write filled; language "en" or "zh", NULL = "en"; list of findings.
 * Returned: WF_OK when every figure and page was made. Otherwise whatever can be made is made, each
 * missing part is a warning in `d`, and the status of the first is returned: WF_EMISSING where an
 * outside program is not installed (the text names its package), WF_EOUTPUT where it failed;
 * WF_EINPUT when results.json is missing or not such a document, WF_EUSAGE for an unknown language.
 * Scripts and stylesheets are taken from $WINDFIRM_SHARE/reports, else from where they were installed. */
enum wf_status wf_report_make(const char *folder, const char *language, struct wf_diag *d, struct wf_err *e);
#endif
