#ifndef WF_CMD_VALIDATE_FIT_H
#define WF_CMD_VALIDATE_FIT_H
/* Validation cases that are calibrations. The room that reads cases knows nothing of fits; the program has
 * both. */
#include "study/validate.h"

/* Fit the study of a case (WF_SHAPE_FIT), to its data or to made-up ones, and hold the answers against what
 * is wanted. Returned: as wf_case_run; a study whose data are not there is skipped. */
enum wf_status wf_validate_fit(const struct wf_case *c, struct wf_arena *a, struct wf_verdict *v,
                               struct wf_err *e);
#endif
