#include "solve/lanczos.h"
#include "base/num.h"
#include "base/vec3.h"
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { BLOCK = 3, PIECE = 2048 };

struct krylov {
    const struct wf_lanczos *l;
    size_t most, used; /* columns: room, orthonormal so far  */
    double *V, *T;     /* most x size; most x most           */
    double *value, *Q; /* of T: eigenvalues, eigenvectors as columns */
};

static double *column(const struct krylov *k, size_t i) { return k->V + i * k->l->size; }

/* Eight running sums, so that the loop runs in vector registers and gives the same digits everywhere. */
WF_INLINE double dot(const double *u, const double *v, size_t n)
{
    double sum[8] = { 0 };
    size_t i = 0;
    for (; i + 8 <= n; i += 8)
        for (size_t c = 0; c < 8; c++) sum[c] += u[i + c] * v[i + c];
    for (; i < n; i++) sum[0] += u[i] * v[i];
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

static double norm(const double *u, size_t n) { return sqrt(dot(u, u, n)); }

/* Parts of the block's vectors w (BLOCK x size) along the first `upto` columns, to part (BLOCK x upto), and
 * their removal. The vectors are worked through in pieces that stay in the cache, so each column is fetched
 * twice a block. */
WF_WIDE static void take_out(const struct krylov *k, double *w, size_t upto, double *part)
{
    const size_t size = k->l->size;
    memset(part, 0, BLOCK * upto * sizeof *part);
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t i = 0; i < upto; i++)
            for (size_t b = 0; b < BLOCK; b++)
                part[b * upto + i] += dot(column(k, i) + from, w + b * size + from, n);
    }
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t i = 0; i < upto; i++)
            for (size_t b = 0; b < BLOCK; b++) {
                const double *v = column(k, i) + from, p = part[b * upto + i];
                double *x = w + b * size + from;
                for (size_t j = 0; j < n; j++) x[j] -= p * v[j];
            }
    }
}

/* Once, and again where little is left of a vector, so that what is left is clean to rounding; parts are
 * added to c (BLOCK rows of `stride`). before[b]: norms at the start. */
static void orthogonalise(const struct krylov *k, double *w, size_t upto, const double *before, double *part,
                          double *c, size_t stride)
{
    bool clean = false;
    for (int pass = 0; pass < 2 && !clean; pass++) {
        take_out(k, w, upto, part);
        clean = true;
        for (size_t b = 0; b < BLOCK; b++) {
            for (size_t i = 0; i < upto; i++) c[b * stride + i] += part[b * upto + i];
            clean = clean && norm(w + b * k->l->size, k->l->size) >= 0.05 * before[b];
        }
    }
}

/* Add w as a column, after taking out its parts along the columns from `first` on (added to c). Returned:
 * what is left of it; nothing is added when that is only rounding of what had norm `before`. */
static double admit(struct krylov *k, double *w, size_t first, double *c, double before)
{
    const size_t size = k->l->size;
    for (int twice = 0; twice < 2; twice++)
        for (size_t i = first; i < k->used; i++) {
            const double *v = column(k, i);
            double part = dot(v, w, size);
            for (size_t j = 0; j < size; j++) w[j] -= part * v[j];
            c[i] += part;
        }
    double left = norm(w, size);
    if (k->used == k->most || !(left > 1e-12 * before)) return left;
    double *v = column(k, k->used);
    for (size_t j = 0; j < size; j++) v[j] = w[j] / left;
    c[k->used++] += left;
    return left;
}

/* A start that has a part along every motion: fixed, so that every run gives the same digits. */
static void scatter(double *w, size_t size, uint64_t seed)
{
    uint64_t s = 0x9E3779B97F4A7C15u * (seed + 1);
    for (size_t j = 0; j < size; j++) {
        s ^= s << 13, s ^= s >> 7, s ^= s << 17;
        w[j] = (double)(s >> 11) * 0x1p-53 - 0.5;
    }
}

static enum wf_status ritz(struct krylov *k, struct wf_err *e)
{
    size_t n = k->used;
    gsl_matrix *M = gsl_matrix_alloc(n, n), *Q = gsl_matrix_alloc(n, n);
    gsl_vector *v = gsl_vector_alloc(n);
    gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(n);
    enum wf_status status = WF_OK;
    if (!M || !Q || !v || !w) status = wf_fail(e, WF_ENOMEM, "no room for %zu modes", n);
    if (!status) {
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                gsl_matrix_set(M, i, j, 0.5 * (k->T[i * k->most + j] + k->T[j * k->most + i]));
        if (gsl_eigen_symmv(M, v, Q, w))
            status = wf_fail(e, WF_ENOCONV, "eigenvalues of the small problem failed");
    }
    if (!status) {
        gsl_eigen_symmv_sort(v, Q, GSL_EIGEN_SORT_ABS_DESC);
        for (size_t i = 0; i < n; i++) {
            k->value[i] = gsl_vector_get(v, i);
            for (size_t j = 0; j < n; j++) k->Q[j * k->most + i] = gsl_matrix_get(Q, j, i);
        }
    }
    gsl_matrix_free(M), gsl_matrix_free(Q), gsl_vector_free(v), gsl_eigen_symmv_free(w);
    return status;
}

/* Extend the space by A of its last block, the columns from `from` on. w: BLOCK x size; rest[j]: norm of what
 * A of column j has outside the space so far. */
static size_t extend(struct krylov *k, size_t from, double *w, double *part, double *rest)
{
    const struct wf_lanczos *l = k->l;
    size_t to = k->used;
    double before[BLOCK] = { 0 };
    memset(w, 0, BLOCK * l->size * sizeof *w);
    for (size_t j = from; j < to; j++) {
        l->apply(l->ctx, column(k, j), w + (j - from) * l->size);
        before[j - from] = norm(w + (j - from) * l->size, l->size);
    }
    orthogonalise(k, w, to, before, part, k->T + from * k->most, k->most);
    for (size_t j = from; j < to; j++)
        rest[j - from] = admit(k, w + (j - from) * l->size, to, k->T + j * k->most, before[j - from]);
    return to;
}

enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e)
{
    struct krylov k = { .l = l, .most = 10 * l->wanted + 60 };
    if (k.most > l->size) k.most = l->size;
    k.V = WF_TAKE(a, k.most * l->size, double);
    k.T = WF_TAKE(a, (k.most + BLOCK) * k.most, double); /* a short last block has rows to spare */
    k.Q = WF_TAKE(a, k.most * k.most, double);
    k.value = WF_TAKE(a, k.most, double);
    double *w = WF_TAKE(a, BLOCK * l->size, double), *start = WF_TAKE(a, k.most, double), rest[BLOCK];
    double *part = WF_TAKE(a, BLOCK * k.most, double);
    if (!k.V || !k.T || !k.Q || !k.value || !w || !start || !part)
        return wf_fail(e, WF_ENOMEM, "no room for %zu modes", l->wanted);
    wf_quiet_begin();

    for (size_t j = 0; j < BLOCK && j < k.most; j++) {
        scatter(w + l->size, l->size, j); /* through the operator once: smooth motions first */
        l->apply(l->ctx, w + l->size, w);
        admit(&k, w, 0, start, norm(w, l->size));
    }
    enum wf_status status = WF_ENOCONV;
    for (size_t from = 0; from < k.used;) {
        size_t block = k.used - from, done = extend(&k, from, w, part, rest), whole = k.used;
        /* T holds the columns applied so far; the newest block's own columns are still to come */
        k.used = done;
        enum wf_status small = ritz(&k, e);
        k.used = whole;
        if (small) {
            status = small;
            break;
        }
        double worst = 0;
        for (size_t i = 0; i < l->wanted && i < done; i++) {
            double off = 0;
            for (size_t j = 0; j < block; j++) off += fabs(rest[j] * k.Q[(done - block + j) * k.most + i]);
            worst = fmax(worst, off / fabs(k.value[i]));
        }
        k.used = whole;
        from = done;
        if (whole > done && !(done >= l->wanted && worst <= l->tolerance)) continue;
        /* settled; or nothing new came: the space holds all there is, unless it is only full */
        if (worst <= l->tolerance || whole < k.most || k.most == l->size) status = WF_OK;
        k.used = done;
        break;
    }
    if (!k.used) status = WF_OK; /* nothing moves at all */
    wf_quiet_end();
    if (status == WF_ENOMEM) return status;
    for (size_t i = 0; i < l->wanted; i++) {
        value[i] = i < k.used ? k.value[i] : NAN;
        if (!vector) continue;
        double *x = vector + i * l->size;
        memset(x, 0, l->size * sizeof *x);
        for (size_t j = 0; j < k.used && i < k.used; j++)
            for (size_t c = 0; c < l->size; c++) x[c] += k.Q[j * k.most + i] * column(&k, j)[c];
    }
    if (status == WF_ENOCONV) return wf_fail(e, status, "natural frequencies did not settle");
    return status;
}
