/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_RUN_H
#define WF_CASES_RUN_H
/* Running validation cases and comparing the results with the wanted values. */
#include "base/arena.h"
#include "base/err.h"
#include "cases/case.h"
#include "grow/import_file.h"

enum wf_outcome { WF_PASSED, WF_FAILED, WF_SKIPPED, WF_OUTCOME_COUNT };
struct wf_check {
    const struct wf_want *want;
    int component;         /* component of a vector; as in wf_want for a scalar */
    double got, wanted;    /* SI */
    double error, allowed; /* |got - wanted| and its limit [SI] */
    double relative;       /* error relative to the size of the wanted value */
    bool passed;
};
struct wf_verdict {
    const struct wf_case *of;
    const char
        *solver; /* name; "modes", "buckling", "section", "flow" or "fit" where no static solver is used */
    enum wf_outcome outcome;
    const char *why; /* reason of a failed or skipped run without checks; else NULL */
    struct wf_check *check;
    size_t n, failed;
    double worst; /* largest error / allowed */
};

/* Run a case with its k-th solver, every row split into `pieces` parts (1 = as written). Returned: WF_OK and
 * *v (a run that fails gives a failed verdict, a missing file a skipped one); WF_ENOMEM. */
enum wf_status wf_case_run(const struct wf_case *c, size_t k, size_t pieces, struct wf_arena *a,
                           struct wf_verdict *v, struct wf_err *e);

/* Order of convergence: one verdict per mesh, with one element per row and rows split by c->piece[].
 * Returned: verdicts[c->pieces]. The observed order between meshes i-1 and i of check j is
 * ln(error[i-1]/error[i]) / ln(piece[i]/piece[i-1]). Errors: WF_ENOMEM. */
enum wf_status wf_case_order(const struct wf_case *c, size_t k, struct wf_arena *a,
                             struct wf_verdict *verdicts, struct wf_err *e);

/* Fit the calibration of a case (WF_SHAPE_FIT) to its data or to synthetic data, and compare the estimates
 * with the wanted values. Given: the case; share: folder of the shipped species and models; the reader of
 * MATLAB files, as in struct wf_import_options. Returned: as wf_case_run; a calibration whose data are
 * missing is skipped. */
enum wf_status wf_case_fit(const struct wf_case *c, const char *share, wf_import_reader *mat,
                           struct wf_arena *a, struct wf_verdict *v, struct wf_err *e);
#endif
