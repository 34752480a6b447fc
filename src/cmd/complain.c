#include "cmd/cmd.h"
#include <stdio.h>

int wf_exit_code(enum wf_status s)
{
    switch (s) {
    case WF_OK:
        return 0;
    case WF_EUSAGE:
    case WF_EINPUT:
        return 2;
    default:
        return 1;
    }
}

int wf_complain(const struct wf_err *e)
{
    fprintf(stderr, "windfirm: %s\n", e->text[0] ? e->text : wf_status_text(e->code));
    return wf_exit_code(e->code);
}

void wf_print_findings(const struct wf_diag *d, bool quiet)
{
    char line[2048];
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->severity == WF_ERROR || !quiet)
            fprintf(stderr, "%s\n", wf_finding_print(f, line, sizeof line));
}
