/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/modes.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_small.h"
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Block Lanczos: the largest eigenvalues of a symmetric operator. */

enum { BLOCK = 3, PIECE = 2048 };

struct krylov {
    const struct wf_lanczos *l;
    size_t most, used; /* columns: room, orthonormal so far */
    double *V, *T;     /* most x size; most x most */
    double *value, *Q; /* of T: eigenvalues, eigenvectors as columns */
};

static double *krylov_column(const struct krylov *k, size_t i) { return k->V + i * k->l->size; }

/* Eight partial sums, so that the loop uses vector registers and the result does not depend on the
 * compiler. */
WF_INLINE double dot_product(const double *u, const double *v, size_t n)
{
    double sum[8] = { 0 };
    size_t i = 0;
    for (; i + 8 <= n; i += 8)
        for (size_t c = 0; c < 8; c++) sum[c] += u[i + c] * v[i + c];
    for (; i < n; i++) sum[0] += u[i] * v[i];
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

static double vector_norm(const double *u, size_t n) { return sqrt(dot_product(u, u, n)); }

/* Components of the block's vectors w (BLOCK x size) along the first `upto` columns, written to part (BLOCK
 * x upto) and subtracted. The vectors are processed in pieces that fit in the cache, so each column is
 * fetched twice per block. */
WF_WIDE static void take_out_parts(const struct krylov *k, double *w, size_t upto, double *part)
{
    const size_t size = k->l->size;
    memset(part, 0, BLOCK * upto * sizeof *part);
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t i = 0; i < upto; i++)
            for (size_t b = 0; b < BLOCK; b++)
                part[b * upto + i] += dot_product(krylov_column(k, i) + from, w + b * size + from, n);
    }
    for (size_t from = 0; from < size; from += PIECE) {
        size_t n = size - from < PIECE ? size - from : PIECE;
        for (size_t i = 0; i < upto; i++)
            for (size_t b = 0; b < BLOCK; b++) {
                const double *v = krylov_column(k, i) + from, p = part[b * upto + i];
                double *x = w + b * size + from;
                for (size_t j = 0; j < n; j++) x[j] -= p * v[j];
            }
    }
}

/* Orthogonalise a block; a second time where little of a vector remains, so that the rest is orthogonal to
 * rounding. Components are added to c (BLOCK rows of `stride`). before[b]: norms on entry. */
static void orthogonalise(const struct krylov *k, double *w, size_t upto, const double *before, double *part,
                          double *c, size_t stride)
{
    bool clean = false;
    for (int pass = 0; pass < 2 && !clean; pass++) {
        take_out_parts(k, w, upto, part);
        clean = true;
        for (size_t b = 0; b < BLOCK; b++) {
            for (size_t i = 0; i < upto; i++) c[b * stride + i] += part[b * upto + i];
            clean = clean && vector_norm(w + b * k->l->size, k->l->size) >= 0.05 * before[b];
        }
    }
}

/* Add w as a column after subtracting its components along the columns from `first` on (added to c).
 * Returned: norm of the rest; no column is added when the rest is only rounding error of a vector of norm
 * `before`. */
static double admit_column(struct krylov *k, double *w, size_t first, double *c, double before)
{
    const size_t size = k->l->size;
    for (int twice = 0; twice < 2; twice++)
        for (size_t i = first; i < k->used; i++) {
            const double *v = krylov_column(k, i);
            double part = dot_product(v, w, size);
            for (size_t j = 0; j < size; j++) w[j] -= part * v[j];
            c[i] += part;
        }
    double left = vector_norm(w, size);
    if (k->used == k->most || !(left > 1e-12 * before)) return left;
    double *v = krylov_column(k, k->used);
    for (size_t j = 0; j < size; j++) v[j] = w[j] / left;
    c[k->used++] += left;
    return left;
}

/* Pseudo-random start vector with a component along every motion; fixed, so that every run gives the same
 * result. */
static void scatter(double *w, size_t size, uint64_t seed)
{
    uint64_t s = 0x9E3779B97F4A7C15u * (seed + 1);
    for (size_t j = 0; j < size; j++) {
        s ^= s << 13, s ^= s >> 7, s ^= s << 17;
        w[j] = (double)(s >> 11) * 0x1p-53 - 0.5;
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

/* Extend the space by A times its last block, the columns from `from` on. w: BLOCK x size; rest[j]: norm of
 * the part of A times column j outside the space so far. */
static size_t extend_space(struct krylov *k, size_t from, double *w, double *part, double *rest)
{
    const struct wf_lanczos *l = k->l;
    size_t to = k->used;
    double before[BLOCK] = { 0 };
    memset(w, 0, BLOCK * l->size * sizeof *w);
    for (size_t j = from; j < to; j++) {
        l->apply(l->ctx, krylov_column(k, j), w + (j - from) * l->size);
        before[j - from] = vector_norm(w + (j - from) * l->size, l->size);
    }
    orthogonalise(k, w, to, before, part, k->T + from * k->most, k->most);
    for (size_t j = from; j < to; j++)
        rest[j - from] = admit_column(k, w + (j - from) * l->size, to, k->T + j * k->most, before[j - from]);
    return to;
}

enum wf_status wf_lanczos(const struct wf_lanczos *l, double *value, double *vector, struct wf_arena *a,
                          struct wf_err *e)
{
    struct krylov k = { .l = l, .most = 10 * l->wanted + 60 };
    if (k.most > l->size) k.most = l->size;
    k.V = WF_TAKE(a, k.most * l->size, double);
    k.T = WF_TAKE(a, (k.most + BLOCK) * k.most, double); /* the last block may be short */
    k.Q = WF_TAKE(a, k.most * k.most, double);
    k.value = WF_TAKE(a, k.most, double);
    double *w = WF_TAKE(a, BLOCK * l->size, double), *start = WF_TAKE(a, k.most, double), rest[BLOCK];
    double *part = WF_TAKE(a, BLOCK * k.most, double);
    if (!k.V || !k.T || !k.Q || !k.value || !w || !start || !part)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", l->wanted);
    wf_quiet_begin();

    for (size_t j = 0; j < BLOCK && j < k.most; j++) {
        scatter(w + l->size, l->size, j); /* apply the operator once: favours smooth motions */
        l->apply(l->ctx, w + l->size, w);
        admit_column(&k, w, 0, start, vector_norm(w, l->size));
    }
    enum wf_status status = WF_ENOCONV;
    for (size_t from = 0; from < k.used;) {
        size_t block = k.used - from, done = extend_space(&k, from, w, part, rest), whole = k.used;
        /* T holds the columns that A was applied to; the newest block is not among them yet */
        k.used = done;
        enum wf_status small = ritz_values(&k, e);
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
        /* converged; or no new column was found: the space is complete, unless it only reached its limit */
        if (worst <= l->tolerance || whole < k.most || k.most == l->size) status = WF_OK;
        k.used = done;
        break;
    }
    if (!k.used) status = WF_OK; /* no motion at all */
    wf_quiet_end();
    if (status == WF_ENOMEM) return status;
    for (size_t i = 0; i < l->wanted; i++) {
        value[i] = i < k.used ? k.value[i] : NAN;
        if (!vector) continue;
        double *x = vector + i * l->size;
        memset(x, 0, l->size * sizeof *x);
        for (size_t j = 0; j < k.used && i < k.used; j++)
            for (size_t c = 0; c < l->size; c++) x[c] += k.Q[j * k.most + i] * krylov_column(&k, j)[c];
    }
    if (status == WF_ENOCONV) return wf_fail(e, status, "natural frequencies did not converge");
    return status;
}

/* Natural frequencies. */

/* Flexibility x mass in symmetric form: with x = sqrt(mass) u, A = sqrt(mass) flexibility sqrt(mass). */
struct sway {
    struct wf_beam *beam;
    size_t size;
    double *root, *u; /* square root of the mass; a motion */
    double (*node)[6], (*ends)[6];
};

static void sway(void *ctx, const double *in, double *out)
{
    struct sway *s = ctx;
    for (size_t i = 0; i < s->size; i++) s->u[i] = s->root[i] > 0 ? in[i] / s->root[i] : 0;
    wf_beam_inertia_answer(s->beam, s->u, out, s->node, s->ends);
    for (size_t i = 0; i < s->size; i++) out[i] *= s->root[i];
}

/* Equilibrium of the motions: Newton from the beam's present shape; only if that fails, wf_beam_settle. An
 * unstable equilibrium is kept: its modes show it. */
static enum wf_status find_equilibrium(struct wf_beam *b, struct wf_arena *work, struct wf_err *e)
{
    struct wf_beam_outcome out;
    return wf_beam_newton(b) == WF_OK ? WF_OK : wf_beam_settle(b, work, &out, e);
}

/* Sort by rising omega^2 = 1 / value, negative first. */
static void order_by_frequency(double *value, size_t *order, size_t n)
{
    for (size_t i = 0; i < n; i++) order[i] = i;
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0 && 1 / value[order[j]] < 1 / value[order[j - 1]]; j--) {
            size_t hold = order[j];
            order[j] = order[j - 1], order[j - 1] = hold;
        }
}

static double hertz(double value)
{
    return value > 0 ? 1 / (WF_TURN * sqrt(value)) : -1 / (WF_TURN * sqrt(-value));
}

/* Allocate and fill what is kept of a beam. */
static enum wf_status keep_equilibrium(const struct wf_beam *b, const int32_t *pieces, size_t count,
                                       struct wf_arena *a, struct wf_modes_kept *kept, struct wf_err *e)
{
    size_t rows = b->mesh.tree->n;
    kept->size = wf_beam_motion_size(b);
    kept->pieces = WF_TAKE(a, rows, int32_t);
    kept->shape = WF_TAKE(a, b->mesh.n, struct wf_beam_shape);
    kept->tilt = wf_arena_take(a, rows, sizeof *kept->tilt);
    kept->motion = WF_TAKE(a, count * kept->size, double);
    if (!kept->pieces || !kept->shape || !kept->tilt || !kept->motion)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", count);
    memcpy(kept->pieces, pieces, rows * sizeof *pieces);
    memcpy(kept->shape, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(kept->tilt, b->tilt, rows * sizeof *b->tilt);
    return WF_OK;
}

/* Frequencies on the beam's mesh; displacements of the ends by one more response to the mode's inertia. */
static enum wf_status modes_on(struct wf_beam *b, size_t count, struct wf_arena *work, double *frequency,
                               double *shape, struct wf_modes_kept *kept, struct wf_err *e)
{
    size_t size = wf_beam_motion_size(b), n = b->mesh.tree->n;
    enum wf_status status = wf_beam_linearise(b, true, work, e);
    double *value = WF_TAKE(work, count, double),
           *vector = shape || kept ? WF_TAKE(work, count * size, double) : NULL;
    double *answer = WF_TAKE(work, size, double);
    size_t *order = WF_TAKE(work, count, size_t);
    struct sway s = { .beam = b,
                      .size = size,
                      .root = WF_TAKE(work, size, double),
                      .u = WF_TAKE(work, size, double),
                      .node = wf_arena_take(work, b->mesh.n, sizeof *s.node),
                      .ends = wf_arena_take(work, b->mesh.n, sizeof *s.ends) };
    if (!value || ((shape || kept) && !vector) || !answer || !order || !s.root || !s.u || !s.node || !s.ends)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", count);
    wf_beam_motion_mass(b, s.root);
    for (size_t i = 0; i < size; i++) s.root[i] = sqrt(s.root[i]);
    struct wf_lanczos l = {
        .size = size, .apply = sway, .ctx = &s, .wanted = count, .tolerance = kept ? 1e-8 : 1e-5
    };
    if (!status) status = wf_lanczos(&l, value, vector, work, e);
    if (status) return status;
    order_by_frequency(value, order, count);
    for (size_t i = 0; i < count; i++) {
        double most = 0;
        frequency[i] = hertz(value[order[i]]);
        for (size_t k = 0; vector && k < size; k++)
            s.u[k] = s.root[k] > 0 ? vector[order[i] * size + k] / s.root[k] : 0;
        if (kept) memcpy(kept->motion + i * size, s.u, size * sizeof *s.u);
        if (!shape) continue;
        wf_beam_inertia_answer(b, s.u, answer, s.node, s.ends);
        for (size_t r = 0; r < n; r++)
            for (size_t c = 0; c < 3; c++) {
                double x = s.ends[b->mesh.last[r]][c];
                shape[3 * n * i + 3 * r + c] = x;
                if (fabs(x) > fabs(most)) most = x;
            }
        for (size_t r = 0; r < 3 * n && most != 0; r++) shape[3 * n * i + r] /= most;
    }
    return WF_OK;
}

/* Pieces for the next mesh; false when the error is within tolerance. The error of a frequency falls with
 * the fourth power of the piece length. */
static bool choose_finer_mesh(const double *coarse, const double *fine, size_t count, double tolerance,
                              double ratio, int32_t *pieces, size_t n)
{
    double worst = 0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(fine[i])) worst = fmax(worst, fabs(fine[i] / coarse[i] - 1) / (pow(ratio, 4) - 1));
    if (worst <= 0.25 * tolerance) return false;
    double grow = fmin(4, fmax(1.3, 1.1 * pow(4 * worst / tolerance, 0.25)));
    for (size_t i = 0; i < n; i++) pieces[i] = (int32_t)ceil(grow * pieces[i]);
    return true;
}

enum wf_status wf_modes_keep(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                             double *frequency, double *shape, struct wf_modes_kept *kept, struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_arena work = { 0 };
    struct wf_beam b, last;
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    double *before = WF_TAKE(a, count, double);
    if (!pieces || !before) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;
    for (int mesh = 0; mesh < MESHES && !status; mesh++) {
        status = wf_beam_init(&b, t, l, o, pieces, &work, &work, e);
        if (!status && mesh > 0) wf_beam_carry(&last, &b);
        if (!status) status = find_equilibrium(&b, &work, e);
        if (!status && kept) status = keep_equilibrium(&b, pieces, count, a, kept, e);
        if (!status) status = modes_on(&b, count, &work, frequency, shape, kept, e);
        if (status || !(o->mesh_tolerance > 0)) break;
        if (mesh == 0)
            for (size_t i = 0; i < t->n; i++) pieces[i] *= 2;
        else {
            double ratio = (double)b.mesh.n / (double)last.mesh.n;
            if (!choose_finer_mesh(before, frequency, count, o->mesh_tolerance, ratio, pieces, t->n)) break;
        }
        memcpy(before, frequency, count * sizeof *before);
        last = b;
    }
    wf_arena_free(&work);
    return status;
}

enum wf_status wf_modes(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                        size_t count, struct wf_arena *a, double *frequency, double *shape, struct wf_err *e)
{
    return wf_modes_keep(t, l, o, count, a, frequency, shape, NULL, e);
}

enum wf_status wf_modes_held(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_modes_kept *kept, size_t k,
                             double *frequency, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    const double *u = kept->motion + k * kept->size;
    double *mass = WF_TAKE(&work, kept->size, double), *answer = WF_TAKE(&work, kept->size, double), up = 0,
           down = 0;
    enum wf_status status = wf_beam_init(&b, t, l, o, kept->pieces, &work, &work, e);
    double(*node)[6] = status ? NULL : wf_arena_take(&work, b.mesh.n, sizeof *node);
    double(*ends)[6] = status ? NULL : wf_arena_take(&work, b.mesh.n, sizeof *ends);
    if (!status && (!mass || !answer || !node || !ends))
        status = wf_fail(e, WF_ENOMEM, "not enough memory for a motion of %zu segments", t->n);
    if (!status) {
        memcpy(b.shape, kept->shape, b.mesh.n * sizeof *b.shape);
        memcpy(b.tilt, kept->tilt, t->n * sizeof *b.tilt);
        status = find_equilibrium(&b, &work, e);
    }
    if (!status) status = wf_beam_linearise(&b, true, &work, e);
    if (!status) {
        wf_beam_motion_mass(&b, mass);
        wf_beam_inertia_answer(&b, u, answer, node, ends);
        for (size_t i = 0; i < kept->size; i++) {
            up += mass[i] * u[i] * answer[i];
            down += mass[i] * u[i] * u[i];
        }
        *frequency = hertz(up / down);
    }
    wf_arena_free(&work);
    return status;
}

/* Self-buckling. */

/* Does the unloaded shape under `factor` times the weight have an unstable direction? */
static bool gives_way(struct wf_beam *b, double factor)
{
    struct wf_beam_stability count = { .margin = 0 };
    b->loads.weight_scale = factor;
    b->misfit = (struct wf_beam_misfit){ 0 };
    return !wf_beam_sweep_down(b, true, &count) || count.negative > 0;
}

static double smallest_factor(struct wf_beam *b)
{
    double low = 0, high = 1;
    while (!gives_way(b, high)) {
        low = high, high *= 2;
        if (high > 1e6) return INFINITY;
    }
    for (int i = 0; i < 200 && high - low > 1e-13 * high; i++) {
        double middle = 0.5 * (low + high);
        if (gives_way(b, middle))
            high = middle;
        else
            low = middle;
    }
    return 0.5 * (low + high);
}

enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_loads weight = *l;
    struct wf_arena work = { 0 };
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    weight.wind = NULL, weight.points = 0, weight.line = NULL;
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;
    double before = NAN;
    for (int mesh = 0; mesh < MESHES; mesh++) {
        struct wf_beam b;
        status = wf_beam_init(&b, t, &weight, o, pieces, &work, &work, e);
        if (status) break;
        wf_beam_sweep_up(&b);
        *factor = smallest_factor(&b);
        /* error of the finer of two meshes of ratio 2: a fifteenth of their difference */
        if (!(o->mesh_tolerance > 0) || isinf(*factor) ||
            fabs(before / *factor - 1) <= 15 * 0.25 * o->mesh_tolerance)
            break;
        before = *factor;
        for (size_t i = 0; i < t->n; i++) pieces[i] *= 2;
    }
    wf_arena_free(&work);
    return status;
}
