#ifndef WF_SOLVE_LANCZOS_H
#define WF_SOLVE_LANCZOS_H
/* Largest eigenvalues of a symmetric operator. */
#include "base/arena.h"
#include "base/err.h"

struct wf_lanczos {
    size_t size;                                             /* length of a vector                       */
    void (*apply)(void *ctx, const double *in, double *out); /* out = A in; A symmetric                  */
    void *ctx;
    size_t wanted;
    double tolerance; /* on |A x - value x| / |value|; the value itself is good to about its square */
};

/* Block Lanczos (Golub & Underwood 1977) with full, twice repeated orthogonalisation and blocks of three, so
 * that equal eigenvalues (a round stem sways alike in all directions) are all found. Returned: value[wanted]
 * by falling magnitude, NAN where the space has fewer; vector (wanted x size, may be NULL), of unit norm.
 * WF_ENOCONV with *out the best so far; WF_ENOMEM. */
enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e);
#endif
