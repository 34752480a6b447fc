#ifndef WF_OUT_PAGE_H
#define WF_OUT_PAGE_H
/* Printed pages. */
#include "base/err.h"

/* Print an HTML page to `path` as PDF with WeasyPrint. The file appears only when it is whole. Errors:
 * WF_EMISSING without WeasyPrint; WF_EOUTPUT with its own words, also where it ends with status 0 after a
 * fault. */
enum wf_status wf_page_print(const char *html, const char *path, struct wf_err *e);
#endif
