/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/err.h"
#include <stdarg.h>
#include <stdio.h>

enum wf_status wf_fail(struct wf_err *e, enum wf_status code, const char *fmt, ...)
{
    if (!e || e->code != WF_OK) return code;
    va_list args;
    va_start(args, fmt);
    e->code = code;
    (void)vsnprintf(e->text, sizeof e->text, fmt, args);
    va_end(args);
    return code;
}

const char *wf_status_text(enum wf_status code)
{
    static const char *const words[WF_STATUS_COUNT] = {
        [WF_OK] = "ok",
        [WF_EUSAGE] = "wrong usage",
        [WF_EINPUT] = "wrong input",
        [WF_EOUTPUT] = "could not write a result",
        [WF_ENOMEM] = "out of memory",
        [WF_ENOCONV] = "no convergence",
        [WF_EUNSTABLE] = "no equilibrium",
        [WF_EMISSING] = "a program or part is not installed",
        [WF_EINTERNAL] = "internal fault",
    };
    return (unsigned)code < WF_STATUS_COUNT ? words[code] : "unknown status";
}
