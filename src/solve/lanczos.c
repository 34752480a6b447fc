/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/lanczos.h"
#include "base/num.h"
#include "base/vec3.h"
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Block Lanczos: the largest eigenvalues of a symmetric operator. The vectors of a block are interleaved, so
 * that each is a lane of a vector register; a column that is not admitted to the space is a lane of zeros. */

enum { BLOCK = WF_LANCZOS_BLOCK, PIECE = 1024 };
struct krylov {
    const struct wf_lanczos *l;
    struct wf_arena *arena;
    size_t most, used, blocks; /* columns: room, orthonormal so far; blocks that hold them */
    wf_four **V;               /* per block: size x BLOCK */
    size_t *lane;              /* per column: its lane, counted through all blocks */
    double *T, *value, *Q;     /* most x most; of T: eigenvalues, eigenvectors as columns */
    wf_four *spare;            /* NULL or room for one more block */
    bool skew;                 /* A is not symmetric to rounding: all columns count at every block */
    bool due;                  /* the next block is to be orthogonalised to all columns */
    double drift;              /* bound of the largest component of the newest block along other columns */
    double drift_most; /* to be kept: eigenvalues then err by its square, eigenvectors by as much as it is */
    double *C;         /* BLOCK x most: components of the newest products along the columns */
    wf_four *part;     /* BLOCK for each lane: components of a new block's vectors */
};

/* G += V' W over n rows. Even and odd rows are summed apart, which makes the sums independent of each other.
 */
WF_INLINE void add_products(const wf_four *v, const wf_four *w, size_t n, wf_four G[BLOCK])
{
    wf_four even[BLOCK] = { 0 }, odd[BLOCK] = { 0 };
    size_t j = 0;
    for (; j + 2 <= n; j += 2)
        for (int a = 0; a < BLOCK; a++) even[a] += v[j][a] * w[j], odd[a] += v[j + 1][a] * w[j + 1];
    for (int a = 0; a < BLOCK && j < n; a++) even[a] += v[j][a] * w[j];
    for (int a = 0; a < BLOCK; a++) G[a] += even[a] + odd[a];
}

/* W -= V P over n rows */
WF_INLINE void take_products(const wf_four *v, const wf_four P[BLOCK], size_t n, wf_four *w)
{
    const wf_four p[BLOCK] = { P[0], P[1], P[2], P[3] };
    for (size_t j = 0; j < n; j++)
        w[j] = w[j] - v[j][0] * p[0] - v[j][1] * p[1] - v[j][2] * p[2] - v[j][3] * p[3];
}

/* Components of the block w along the columns of the blocks from `first` on, written to k->part and
 * subtracted. The rows are processed in pieces that fit in the cache, so each column is fetched twice per
 * block. *square: of each column of w before; *product: of the first column with all, after. */
WF_WIDE static void take_out_parts(struct krylov *k, size_t first, wf_four *w, wf_four *square,
                                   wf_four *product)
{
    const size_t size = k->l->size;
    wf_four before = { 0 }, after = { 0 };
    memset(k->part, 0, BLOCK * k->blocks * sizeof *k->part);
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t j = from; j < from + n; j++) before += w[j] * w[j];
        for (size_t i = first; i < k->blocks; i++)
            add_products(k->V[i] + from, w + from, n, k->part + BLOCK * i);
    }
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t i = first; i < k->blocks; i++)
            take_products(k->V[i] + from, k->part + BLOCK * i, n, w + from);
        for (size_t j = from; j < from + n; j++) after += w[j][0] * w[j];
    }
    *square = before, *product = after;
}

/* Multiply each column b of the block by scale[b] and subtract column c times part[b]; in the same pass,
 * products of column `next` with all. */
WF_WIDE static void take_out_column(wf_four *w, size_t size, size_t c, const wf_four *scale,
                                    const wf_four *part, size_t next, wf_four *product)
{
    const wf_four f = *scale, p = *part;
    wf_four even = { 0 }, odd = { 0 };
    size_t j = 0;
    for (; j + 2 <= size; j += 2) {
        w[j] = w[j] * f - w[j][c] * p, w[j + 1] = w[j + 1] * f - w[j + 1][c] * p;
        even += w[j][next] * w[j], odd += w[j + 1][next] * w[j + 1];
    }
    if (j < size) {
        w[j] = w[j] * f - w[j][c] * p;
        even += w[j][next] * w[j];
    }
    *product = even + odd;
}

/* Gram-Schmidt within a block: w = q R, q in place of w. A column whose rest is not above least[c] is zero in
 * q and its row of R is zero. Returned: smallest ratio of the rest of a column to its norm before. */
static double orthonormalise(wf_four *w, size_t size, wf_four *product, const double *before,
                             const double *least, double R[BLOCK][BLOCK])
{
    double smallest = 1;
    wf_four scale = { 1, 1, 1, 1 };
    memset(R, 0, BLOCK * sizeof *R);
    for (size_t c = 0; c < BLOCK; c++) {
        double left = sqrt((*product)[c]);
        wf_four part = { 0 };
        bool keep = left > least[c];
        for (size_t b = c; b < BLOCK && keep; b++) R[c][b] = (*product)[b] / left;
        for (size_t b = c + 1; b < BLOCK && keep; b++) part[b] = R[c][b] / left;
        if (keep) smallest = fmin(smallest, left / before[c]);
        scale[c] = keep ? 1 / left : 0;
        take_out_column(w, size, c, &scale, &part, c + 1 < BLOCK ? c + 1 : c, product);
        scale[c] = 1;
    }
    return smallest;
}

/* B = A B */
static void multiply_block(double A[BLOCK][BLOCK], double B[BLOCK][BLOCK])
{
    double C[BLOCK][BLOCK] = { 0 };
    for (size_t i = 0; i < BLOCK; i++)
        for (size_t j = 0; j < BLOCK; j++)
            for (size_t m = 0; m < BLOCK; m++) C[i][j] += A[i][m] * B[m][j];
    memcpy(B, C, sizeof C);
}

/* w R = (columns from block `first` on) C + q S with q orthonormal and orthogonal to them; q in place of w, S
 * in place of R. Repeated where little of a vector remains, so that the rest is orthogonal to rounding. C is
 * added to k->C. A column is zero in q when its rest is only rounding error. */
static void take_out_space(struct krylov *k, size_t first, wf_four *w, double R[BLOCK][BLOCK])
{
    const size_t size = k->l->size;
    double before[BLOCK], least[BLOCK], again[BLOCK][BLOCK], smallest = 0;
    wf_four square, product;
    for (int pass = 0; pass < 4 && smallest < 0.05; pass++) {
        take_out_parts(k, first, w, &square, &product);
        for (size_t b = 0; b < BLOCK && !pass; b++) before[b] = sqrt(square[b]), least[b] = 1e-12 * before[b];
        for (size_t b = 0; b < BLOCK; b++)
            for (size_t i = 0; i < k->used; i++)
                for (size_t m = 0; m < BLOCK; m++) k->C[b * k->most + i] += k->part[k->lane[i]][m] * R[m][b];
        smallest = orthonormalise(w, size, &product, before, least, again);
        multiply_block(again, R);
        for (size_t b = 0; b < BLOCK; b++) { /* the next pass begins with unit vectors */
            least[b] = R[b][b] > 0 ? least[b] / again[b][b] : INFINITY;
            before[b] = 1;
        }
    }
}

/* Bound of the factor by which a block's components along old columns grow when it is multiplied by A and
 * divided by R without subtracting them: the largest eigenvalue over the smallest rest. */
static double drift_growth(const struct krylov *k, double R[BLOCK][BLOCK])
{
    double least = INFINITY;
    for (size_t b = 0; b < BLOCK; b++) least = fmin(least, R[b][b]);
    return least > 0 && k->value[0] != 0 ? 2 * fabs(k->value[0]) / least + 1 : INFINITY;
}

/* w = (columns so far) k->C + q R with q orthonormal and orthogonal to them, q in place of w. In exact
 * arithmetic a product of a symmetric A with the last block has no component along older blocks than the last
 * two. Rounding errors along them grow from block to block; two blocks in succession are orthogonalised to
 * all before they reach drift_most (Simon 1984, Linear Algebra Appl. 61:101), so the space stays orthogonal
 * to that bound. That comes second: along columns that are themselves orthogonal only to that bound, the
 * error left is the product of the component that is subtracted and the bound. */
static void orthogonalise(struct krylov *k, wf_four *w, double R[BLOCK][BLOCK])
{
    const double rounding = 1e-15;
    memset(k->C, 0, BLOCK * k->most * sizeof *k->C);
    for (size_t a = 0; a < BLOCK; a++)
        for (size_t b = 0; b < BLOCK; b++) R[a][b] = a == b;
    take_out_space(k, k->skew || k->blocks < 2 ? 0 : k->blocks - 2, w, R);
    if (k->skew) return;
    double drift = k->drift * drift_growth(k, R);
    bool second = k->due;
    k->due = !second && !(drift <= k->drift_most);
    if (k->due || second) take_out_space(k, 0, w, R);
    k->drift = second ? rounding : drift;
}

/* Is T, of the columns up to `to`, not symmetric by more than rounding? The tangent of a loaded tree is
 * symmetric only nearly. Looked at from the first product on; along the last two blocks, because the other
 * components are rounding errors of the space. */
static bool is_skew(const struct krylov *k, size_t from, size_t to)
{
    double most = 0, off = 0;
    for (size_t j = from; j < to; j++)
        for (size_t i = 0; i < to; i++) {
            if (k->lane[i] / BLOCK + 1 < k->lane[j] / BLOCK) continue;
            double a = k->T[j * k->most + i], b = k->T[i * k->most + j];
            most = fmax(most, fmax(fabs(a), fabs(b)));
            off = fmax(off, fabs(a - b));
        }
    return off > 1e-12 * fmax(most, fabs(k->value[0]));
}

/* Room for a block that is to be added to the space. */
static wf_four *spare_block(struct krylov *k)
{
    if (!k->spare) k->spare = wf_arena_take_unset(k->arena, k->l->size, sizeof *k->spare);
    return k->spare;
}

/* Add the spare block to the space: those of its columns that are not zero, as far as there is room. */
static void admit_block(struct krylov *k, double R[BLOCK][BLOCK])
{
    const size_t before = k->used;
    for (size_t b = 0; b < BLOCK; b++)
        if (R[b][b] > 0 && k->used < k->most)
            k->lane[k->used++] = BLOCK * k->blocks + b;
        else
            for (size_t j = 0; j < k->l->size; j++) k->spare[j][b] = 0;
    if (k->used == before) return;
    k->V[k->blocks++] = k->spare;
    k->spare = NULL;
}

/* Pseudo-random start block with a component along every motion; fixed, so that every run gives the same
 * result. */
static void scatter(wf_four *w, size_t size)
{
    for (uint64_t b = 0; b < BLOCK; b++) {
        uint64_t s = 0x9E3779B97F4A7C15u * (b + 1);
        for (size_t j = 0; j < size; j++) {
            s ^= s << 13, s ^= s >> 7, s ^= s << 17;
            w[j][b] = (double)(s >> 11) * 0x1p-53 - 0.5;
        }
    }
}

static enum wf_status ritz_values(struct krylov *k, struct wf_err *e)
{
    size_t n = k->used;
    gsl_matrix *M = gsl_matrix_alloc(n, n), *Q = gsl_matrix_alloc(n, n);
    gsl_vector *v = gsl_vector_alloc(n);
    gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(n);
    enum wf_status status = WF_OK;
    if (!M || !Q || !v || !w) status = wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", n);
    if (!status) {
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                gsl_matrix_set(M, i, j, 0.5 * (k->T[i * k->most + j] + k->T[j * k->most + i]));
        if (gsl_eigen_symmv(M, v, Q, w))
            status = wf_fail(e, WF_ENOCONV, "the eigenvalue solver failed on the projected (Lanczos) matrix");
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

/* Take the memory of the space and fill its first block. */
static enum wf_status open_space(struct krylov *k, struct wf_err *e)
{
    const struct wf_lanczos *l = k->l;
    const size_t most = k->most;
    wf_four *w = wf_arena_take_unset(k->arena, l->size, sizeof *w);
    double R[BLOCK][BLOCK];
    k->V = WF_TAKE(k->arena, most, wf_four *), k->lane = WF_TAKE(k->arena, most, size_t);
    k->T = WF_TAKE(k->arena, most * most, double), k->Q = WF_TAKE(k->arena, most * most, double);
    k->value = WF_TAKE(k->arena, most, double), k->C = WF_TAKE(k->arena, BLOCK * most, double);
    k->part = WF_TAKE(k->arena, BLOCK * most, wf_four);
    if (!w || !k->V || !k->lane || !k->T || !k->Q || !k->value || !k->C || !k->part || !spare_block(k))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", l->wanted);
    scatter(w, l->size); /* apply the operator once: favours smooth motions */
    l->apply(l->ctx, w, k->spare);
    orthogonalise(k, k->spare, R);
    admit_block(k, R);
    if (!k->spare) k->spare = w;
    return WF_OK;
}

/* Extend the space by A times its last block, the columns from `from` on. R: the part of the products outside
 * the space so far, as orthogonalise returns it. */
static enum wf_status extend_space(struct krylov *k, size_t from, double R[BLOCK][BLOCK], struct wf_err *e)
{
    const size_t to = k->used, last = k->blocks - 1;
    if (!spare_block(k)) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", k->l->wanted);
    k->l->apply(k->l->ctx, k->V[last], k->spare);
    orthogonalise(k, k->spare, R);
    admit_block(k, R);
    for (size_t j = from; j < to; j++) {
        size_t b = k->lane[j] % BLOCK;
        double *row = k->T + j * k->most;
        memcpy(row, k->C + b * k->most, to * sizeof *row);
        for (size_t i = to; i < k->used; i++) row[i] = R[k->lane[i] % BLOCK][b];
    }
    k->skew = k->skew || is_skew(k, from, to);
    return WF_OK;
}

/* Largest |A x - value x| / |value| of the wanted Ritz pairs of the first `to` columns. Their A x leaves the
 * space only by the newest block, the columns from `from` on. */
static double worst_residual(const struct krylov *k, size_t from, size_t to, double R[BLOCK][BLOCK])
{
    double worst = 0;
    for (size_t i = 0; i < k->l->wanted && i < to; i++) {
        double off = 0;
        for (size_t a = 0; a < BLOCK; a++) {
            double sum = 0;
            for (size_t j = from; j < to; j++) sum += R[a][k->lane[j] % BLOCK] * k->Q[j * k->most + i];
            off += sum * sum;
        }
        worst = fmax(worst, sqrt(off) / fabs(k->value[i]));
    }
    return worst;
}

/* Extend the space until the wanted Ritz pairs converge. Returned: WF_ENOCONV where its room does not
 * suffice. */
static enum wf_status search_space(struct krylov *k, struct wf_err *e)
{
    const struct wf_lanczos *l = k->l;
    for (size_t from = 0; from < k->used;) {
        double R[BLOCK][BLOCK];
        size_t done = k->used, whole;
        enum wf_status status = extend_space(k, from, R, e);
        if (status) return status;
        /* T holds the columns that A was applied to; the newest block is not among them yet */
        whole = k->used, k->used = done;
        if ((status = ritz_values(k, e))) return status;
        double worst = worst_residual(k, from, done, R);
        from = done;
        if (whole > done && !(done >= l->wanted && worst <= l->tolerance)) {
            k->used = whole;
            continue;
        }
        /* converged; or no new column was found: the space is complete, unless it only reached its limit */
        return worst <= l->tolerance || whole < k->most || k->most == l->size ? WF_OK : WF_ENOCONV;
    }
    return WF_OK; /* no motion at all */
}

/* x += combination of the columns of block i for a Ritz pair */
WF_WIDE static void add_block(const wf_four *v, const wf_four *part, size_t size, double *x)
{
    const wf_four p = *part;
    for (size_t j = 0; j < size; j++) {
        wf_four y = v[j] * p;
        x[j] += (y[0] + y[1]) + (y[2] + y[3]);
    }
}

/* Ritz vectors of the first `count` pairs, each block being fetched once. */
static void ritz_vectors(const struct krylov *k, size_t count, double *vector)
{
    const size_t size = k->l->size;
    memset(vector, 0, count * size * sizeof *vector);
    for (size_t b = 0, j = 0; b < k->blocks; b++) {
        const size_t first = j;
        while (j < k->used && k->lane[j] / BLOCK == b) j++;
        for (size_t from = 0; from < size; from += PIECE)
            for (size_t i = 0; i < count; i++) {
                size_t n = size - from < PIECE ? size - from : PIECE;
                wf_four part = { 0 };
                for (size_t c = first; c < j; c++) part[k->lane[c] % BLOCK] = k->Q[c * k->most + i];
                add_block(k->V[b] + from, &part, n, vector + i * size + from);
            }
    }
}

enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e)
{
    struct krylov k = { .l = l,
                        .arena = a,
                        .most = l->most ? l->most : 10 * l->wanted + 160,
                        .due = true,
                        .drift_most = vector ? 1e-12 : 1e-9 };
    if (k.most > l->size) k.most = l->size;
    wf_quiet_begin();
    enum wf_status status = open_space(&k, e);
    if (!status) status = search_space(&k, e);
    wf_quiet_end();
    if (status == WF_ENOMEM) return status;
    for (size_t i = 0; i < l->wanted; i++) value[i] = i < k.used ? k.value[i] : NAN;
    if (vector) {
        const size_t some = k.used < l->wanted ? k.used : l->wanted;
        ritz_vectors(&k, some, vector);
        memset(vector + some * l->size, 0, (l->wanted - some) * l->size * sizeof *vector);
    }
    if (status == WF_ENOCONV) return wf_fail(e, status, "natural frequencies did not converge");
    return status;
}
