#ifndef WF_CMD_VALIDATE_PRINT_H
#define WF_CMD_VALIDATE_PRINT_H
/* Tables of `windfirm validate`. */
#include "cases/case.h"

struct wf_validate_tally {
    size_t of_kind[WF_CASE_KIND_COUNT][WF_OUTCOME_COUNT], outcome[WF_OUTCOME_COUNT], checks;
};
void wf_validate_count(struct wf_validate_tally *t, const struct wf_verdict *v);

/* Heading of a file: its title and source, from its first case. */
void wf_validate_print_file(const struct wf_case *first);
/* Outcome and one line a wanted value: wanted, got, error, margin (allowed error / error). Of a long list
 * only what failed and the three closest to their tolerance, unless `all`. */
void wf_validate_print_case(const struct wf_verdict *v, bool all);
/* Errors on each mesh and the observed order of convergence between neighbouring meshes. */
void wf_validate_print_order(const struct wf_case *c, const struct wf_verdict *mesh, bool all);
/* Counts by kind, and the last line "N passed, N failed, N skipped". */
void wf_validate_print_tally(const struct wf_validate_tally *t);
#endif
