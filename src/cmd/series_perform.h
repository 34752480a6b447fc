#ifndef WF_CMD_SERIES_PERFORM_H
#define WF_CMD_SERIES_PERFORM_H
/* What series and papers share: from a plan of runs to tables, frames and a page. */
#include "cmd/cmd.h"
#include "study/series_plan.h"

struct wf_series_job {
    const struct wf_series_plan *plan;
    const char *folder, *command, *language;
    bool quiet, page, vtk;
};
/* Returned: exit code. */
int wf_series_perform(const struct wf_series_job *j, struct wf_arena *a);
/* The command line as typed. NULL: no room. */
char *wf_series_typed(int argc, char **argv, struct wf_arena *a);
#endif
