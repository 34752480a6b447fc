/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ERR_H
#define WF_BASE_ERR_H
/* One error path for the whole library: a status code travels up, the first message is kept.
 * The library never prints and never exits. */
#ifdef __cplusplus
extern "C" {
#endif

enum wf_status {
    WF_OK = 0,
    WF_EUSAGE,    /* a wrong call or command line                         -> exit 2 */
    WF_EINPUT,    /* an input file or value is missing, unreadable, wrong -> exit 2 */
    WF_EOUTPUT,   /* a result could not be written                        -> exit 1 */
    WF_ENOMEM,    /* no memory, or an arena's limit reached               -> exit 1 */
    WF_ENOCONV,   /* an iteration did not converge                        -> exit 1 */
    WF_EUNSTABLE, /* the tree cannot stand: no equilibrium was found      -> exit 1 */
    WF_EMISSING,  /* an outside program or optional part is not installed -> exit 1 */
    WF_EINTERNAL, /* a fault of ours                                      -> exit 1 */
    WF_STATUS_COUNT
};

struct wf_err {
    enum wf_status code;
    char text[1024];
};

/* Fill `e` once and return `code`, so callers write `return wf_fail(e, ...)`.
 * Given: e (may be NULL), code, a printf format. Returned: code. The first message wins. */
enum wf_status wf_fail(struct wf_err *e, enum wf_status code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

/* Words for a status code, never NULL. */
const char *wf_status_text(enum wf_status code);

#ifdef __cplusplus
}
#endif
#endif
