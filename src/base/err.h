/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_ERR_H
#define WF_BASE_ERR_H
/* Errors. Every function that can fail returns a status code, which its callers pass on, and writes a message
 * to a struct wf_err, where the first message is kept. The library never prints and never exits. */
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
    WF_EUNSTABLE, /* no equilibrium of the tree under its loads was found -> exit 1 */
    WF_EMISSING,  /* an outside program or optional part is not installed -> exit 1 */
    WF_EINTERNAL, /* a fault of this library                              -> exit 1 */
    WF_STATUS_COUNT
};

struct wf_err {
    enum wf_status code; /* WF_OK: no error yet; initialise with { 0 } */
    char text[1024];
};

/* Record an error. Given: e (may be NULL), code, a printf format. Returned: code, so that callers can write
 * `return wf_fail(e, ...)`. When `e` already holds an error it is left unchanged. */
enum wf_status wf_fail(struct wf_err *e, enum wf_status code, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

/* A status code in words; never NULL. */
const char *wf_status_text(enum wf_status code);

#ifdef __cplusplus
}
#endif
#endif
