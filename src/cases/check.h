#ifndef WF_CASES_CHECK_H
#define WF_CASES_CHECK_H
/* What a validation case must say, checked when it is complete. */
#include "base/diag.h"
#include "cases/case.h"

/* Fill defaults that depend on other keys (tolerance of each want, solver) and report what is missing or does
 * not fit together, at the case's line. */
void wf_case_check(struct wf_case *c, struct wf_diag *d);
#endif
