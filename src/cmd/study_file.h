#ifndef WF_CMD_STUDY_FILE_H
#define WF_CMD_STUDY_FILE_H
#include "base/arena.h"
#include "base/err.h"

/* Every key a study file may have, as text; NULL when there is no room. */
char *wf_study_file_schema(struct wf_arena *a, struct wf_err *e);
#endif
