#ifndef WF_CASES_WANT_H
#define WF_CASES_WANT_H
/* Reading the places and wanted values of a validation case. */
#include "cases/case.h"
#include "cases/words.h"

/* "base", "tip", "node 3", "row 1000", "at 0.5"; false after a report. */
bool wf_place_read(struct wf_words *w, struct wf_place *p);

/* The line "want QUANTITY [PLACE] [x|y|z|norm] VALUES UNIT [within [absolute] TOLERANCE]"; false after a
 * report. */
bool wf_want_read(struct wf_words *w, struct wf_want *want);
#endif
