/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_RUN_H
#define WF_CASES_RUN_H
/* Running validation cases and holding what comes out against what is wanted. */
#include "base/arena.h"
#include "base/err.h"
#include "cases/case.h"

enum wf_outcome { WF_PASSED, WF_FAILED, WF_SKIPPED, WF_OUTCOME_COUNT };
struct wf_check {
    const struct wf_want *want;
    int component;         /* which number of the want */
    double got, wanted;    /* SI */
    double error, allowed; /* |got - wanted| and the most accepted [SI] */
    double relative;       /* error over what the tolerance refers to */
    bool passed;
};
struct wf_verdict {
    const struct wf_case *of;
    const char *solver; /* name; "modes" or "buckling" where no static solver is asked */
    enum wf_outcome outcome;
    const char *why; /* for failed and skipped without checks; else NULL */
    struct wf_check *check;
    size_t n, failed;
    double worst; /* largest error / allowed */
};

/* Run a case with its k-th solver, every row split into `pieces` parts (1 = as written).
 * Returned: WF_OK and a verdict (a run that fails is a failed verdict); WF_ENOMEM. */
enum wf_status wf_case_run(const struct wf_case *c, size_t k, size_t pieces, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e);

/* Order of convergence: one verdict a mesh, each with one element a row and rows split by c->piece[].
 * Returned: verdicts[c->pieces]. The observed order between meshes i-1 and i of check j is
 * ln(error[i-1]/error[i]) / ln(piece[i]/piece[i-1]). */
enum wf_status wf_case_order(const struct wf_case *c, size_t k, struct wf_arena *a,
                             struct wf_verdict *verdicts, struct wf_err *e);

/* Fit the study of a case (WF_SHAPE_FIT), to its data or to made-up ones, and hold the answers against what
 * is wanted. Given: the case; share: folder of the shipped species and models. Returned: as wf_case_run; a
 * study whose data are not there is skipped. */
enum wf_status wf_case_fit(const struct wf_case *c, const char *share, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e);
#endif
