/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_LANCZOS_H
#define WF_SOLVE_LANCZOS_H
/* Largest eigenvalues of a symmetric operator. */
#include "base/arena.h"
#include "base/err.h"
#include "base/vec3.h"

/* Vectors that an operator of wf_lanczos is applied to at once: entry i of a block has component i of each.
 */
enum { WF_LANCZOS_BLOCK = 4 };

/* A symmetric eigenvalue problem: the eigenvalues of largest magnitude are wanted. */
struct wf_lanczos {
    size_t size;                                               /* length of a vector */
    void (*apply)(void *ctx, const wf_four *in, wf_four *out); /* out = A in, for a block; A symmetric */
    void *ctx;
    size_t wanted;
    double tolerance; /* on |A x - value x| / |value|; the error of the value itself is about its square */
    size_t most;      /* vectors of the space that is searched; 0: 10 a wanted one and 160 */
};

/* Largest eigenvalues by block Lanczos (Golub & Underwood 1977) with full orthogonalisation, repeated where
 * little of a vector remains, and blocks of WF_LANCZOS_BLOCK vectors, so that eigenvalues of at most that
 * multiplicity (a round stem sways alike in all directions) are all found.
 * Returned: value[wanted] by falling magnitude, NAN where the space has fewer; vector (wanted x size, may be
 * NULL), of unit norm. Errors: WF_ENOCONV with the best values found; WF_ENOMEM. */
enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e);
#endif
