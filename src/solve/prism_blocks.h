/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_PRISM_BLOCKS_H
#define WF_SOLVE_PRISM_BLOCKS_H
/* Symmetric positive definite systems of the prisms in blocks of a section (9 x 9): pattern, factor, answer.
 * Sections are eliminated in the order of struct wf_prism, tips first, so that little fills in. */
#include "solve/prism.h"

enum { WF_PRISM_BLOCK = 81 };

struct wf_prism_blocks {
    size_t n;             /* block rows                                                 */
    int32_t *begin, *row; /* columns: entries begin[k]..begin[k+1], rows rising, diagonal first */
    double *value;        /* 81 per entry, row-major                                    */
    double *flip;         /* of a factor: the same transposed */
    int32_t *target;      /* place of the update of each pair of a column, in its order */
    size_t *pairs;        /* per column: its first pair in `target`                     */
};

/* The pattern of a system of prisms, with what fills in. Errors: WF_ENOMEM. */
enum wf_status wf_prism_blocks_make(const struct wf_prism *p, struct wf_arena *a, struct wf_prism_blocks *out,
                                    struct wf_err *e);
/* Write mass_share M + stiffness_share K into the blocks: K of the mean forces between the places x and y
 * (prism_step.c), which for y = x is the stiffness at x; of the springs' geometric stiffness only what is
 * positive, unless `whole`. dash_share: of k along the springs alone, for their dashpots. */
void wf_prism_blocks_fill(const struct wf_prism *p, const double *x, const double *y, double mass_share,
                          double stiffness_share, double dash_share, bool whole, struct wf_prism_blocks *b);
/* Cholesky factor in place. Returned: false when a pivot is not positive. */
bool wf_prism_blocks_factor(struct wf_prism_blocks *b);
/* Solve in place: v, 9 n numbers in the order of elimination. */
void wf_prism_blocks_solve(const struct wf_prism_blocks *b, double *v);
#endif
