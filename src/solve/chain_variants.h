#ifndef WF_SOLVE_CHAIN_VARIANTS_H
#define WF_SOLVE_CHAIN_VARIANTS_H
/* The ways between the printed and the corrected chain, to see which missing piece does what: for validation
 * cases alone.
 *   S1 force handed down, spread over the row (eq 12); S2 force at the row's end; S3, S4 the same with the
 * moment. chain-S1 ... chain-S4: every row on an upright base; ...-turned: it takes over the rotation below.
 * S4-turned is the corrected chain, S1 the printed one but for taper and weight. */
#include "solve/solve.h"

extern const struct wf_solver *const wf_chain_variants[]; /* ends at NULL */
#endif
