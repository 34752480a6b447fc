/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/modes.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_inertia.h"
#include "solve/beam_rest.h"
#include "solve/beam_small.h"
#include "solve/lanczos.h"
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Natural frequencies. */

enum { BLOCK = WF_LANCZOS_BLOCK };
_Static_assert((int)WF_LANCZOS_BLOCK <= (int)WF_INERTIA_MOST,
               "the beam answers to a block of vectors at once");

/* Flexibility x mass in symmetric form: with x = sqrt(mass) u, A = sqrt(mass) flexibility sqrt(mass). */
struct sway {
    const struct wf_beam *beam;
    struct wf_beam_inertia answer;
    size_t size;
    double *root; /* square root of the mass */
};

static void sway(void *ctx, const wf_four *in, wf_four *out)
{
    const struct sway *s = ctx;
    wf_beam_inertia_answer(&s->answer, (const double *)in, (double *)out);
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
    kept->turn = WF_TAKE(a, count * 2, double);
    if (!kept->pieces || !kept->shape || !kept->tilt || !kept->motion || !kept->turn)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", count);
    memcpy(kept->pieces, pieces, rows * sizeof *pieces);
    memcpy(kept->shape, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(kept->tilt, b->tilt, rows * sizeof *b->tilt);
    return WF_OK;
}

/* Linearise a solved beam; `many` vectors are answered at once. */
static enum wf_status open_sway(struct sway *s, struct wf_beam *b, size_t many, struct wf_arena *work,
                                struct wf_err *e)
{
    struct wf_arena factors = { 0 }; /* of the whole tangent, until what is needed of them is packed */
    size_t size = wf_beam_motion_size(b);
    *s = (struct sway){ .beam = b, .size = size, .root = wf_arena_take_unset(work, size, sizeof *s->root) };
    if (!s->root)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the motions of %zu elements", b->mesh.n);
    wf_beam_motion_mass(b, s->root);
    for (size_t i = 0; i < size; i++) s->root[i] = sqrt(s->root[i]);
    enum wf_status status = wf_beam_linearise(b, true, &factors, e);
    if (!status) status = wf_beam_inertia_open(b, s->root, many, work, &s->answer, e);
    if (b->links) { /* they answer beside the tree */
        wf_arena_join(work, &factors);
        return status;
    }
    wf_arena_free(&factors);
    b->small = NULL, b->sides = NULL, b->root_moved = NULL;
    return status;
}

enum { FOURS = 4 }; /* vectors whose products with another are summed at once */

/* Products of w with v[0], v[1], ... v[FOURS - 1], in four partial sums each. */
WF_WIDE static void dots(const double *w, const double *const v[FOURS], size_t n, double out[FOURS])
{
    wf_four sum[FOURS] = { { 0 } };
    size_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < FOURS; k++) sum[k] += *(const wf_four *)(w + i) * *(const wf_four *)(v[k] + i);
    for (int k = 0; k < FOURS; k++) {
        out[k] = (sum[k][0] + sum[k][1]) + (sum[k][2] + sum[k][3]);
        for (size_t r = i; r < n; r++) out[k] += w[r] * v[k][r];
    }
}

static double dot(const double *a, const double *b, size_t n)
{
    const double *const v[FOURS] = { b, b, b, b };
    double out[FOURS];
    dots(a, v, n, out);
    return out[0];
}

/* w -= part[k] v[k] */
WF_WIDE static void take_out(double *w, const double *const v[FOURS], const double part[FOURS], size_t n)
{
    for (size_t i = 0; i < n; i++)
        w[i] -= (part[0] * v[0][i] + part[1] * v[1][i]) + (part[2] * v[2][i] + part[3] * v[3][i]);
}

/* Take the parts along v[0] .. v[n - 1], of unit norm and at right angles, out of w; they are added to column
 * `column` of T, whose rows are `width` long. */
static void take_out_all(double *w, double *const *v, size_t n, size_t size, double *T, size_t width,
                         size_t column)
{
    for (size_t from = 0; from < n; from += FOURS) {
        const double *four[FOURS];
        double part[FOURS];
        for (size_t k = 0; k < FOURS; k++) four[k] = v[from + k < n ? from + k : from];
        dots(w, four, size, part);
        for (size_t k = 0; k < FOURS; k++)
            if (from + k < n)
                T[(from + k) * width + column] += part[k];
            else
                part[k] = 0;
        take_out(w, four, part, size);
    }
}

/* Motion along `to` by 1, or where `turning` by the height above the ground, as in turning about the base by
 * 1; times the square root of the mass; of unit norm. Returned: its square, the mass [kg] or the moment of
 * inertia [kg m2]. */
static double rigid_motion(const struct sway *s, const double to[3], bool turning, double *v)
{
    static const double gauss[2] = { 0.21132486540518712, 0.78867513459481288 };
    const struct wf_beam_mesh *m = &s->beam->mesh;
    const struct wf_tree *t = m->tree;
    const size_t ends = 8 * m->n;
    memset(v, 0, s->size * sizeof *v);
    for (size_t row = 0; row < t->n; row++) {
        const int32_t pieces = wf_beam_pieces(m, row);
        double low = t->z0[0], arm = 1;
        for (int32_t e = m->first[row]; e <= m->last[row]; e++) {
            const double from = wf_beam_cut(m, row, e - m->first[row], pieces),
                         to_end = wf_beam_cut(m, row, e - m->first[row] + 1, pieces);
            for (int k = 0; k < 3; k++) {
                size_t at = 8 * (size_t)e + (size_t)k, end = ends + 3 * (size_t)e + (size_t)k;
                for (size_t j = 0; j < 2; j++) {
                    if (turning)
                        arm = wf_between(t->z0[row], t->z1[row], wf_between(from, to_end, gauss[j])) - low;
                    v[at + 4 * j] = s->root[at + 4 * j] * to[k] * arm;
                }
                if (turning) arm = wf_between(t->z0[row], t->z1[row], to_end) - low;
                if (end < s->size) v[end] = s->root[end] * to[k] * arm;
            }
        }
    }
    double square = dot(v, v, s->size);
    for (size_t i = 0; i < s->size && square > 0; i++) v[i] /= sqrt(square);
    return square;
}

/* How well the motions are found, and what is wanted of them. */
struct search {
    double tolerance;
    size_t most; /* vectors; 0: as many as it takes */
    /* beside the frequencies; each may be NULL: */
    double *shape; /* of the rows' ends: of modal mass 1 where `part` is wanted, else largest component 1 */
    struct wf_modes_kept *kept;
    struct wf_modes_part *part;
    const double *to; /* for `part` */
};

/* What was found: motions of unit norm, times the square root of the mass; `order`: by rising frequency. */
struct found {
    size_t count;
    double *value, *vector;
    size_t *order;
};

/* Motion i of unit norm. */
static const double *motion_of(const struct sway *s, const struct found *f, size_t i)
{
    return f->vector + f->order[i] * s->size;
}

/* The motions, and their overturning by inertia. */
static enum wf_status keep_motions(const struct sway *s, const struct found *f, struct wf_arena *work,
                                   struct wf_modes_kept *kept, struct wf_err *e)
{
    double *rigid = WF_TAKE(work, s->size, double);
    if (!rigid) return wf_fail(e, WF_ENOMEM, "not enough memory for the overturning of the modes");
    for (size_t d = 0; d < 2; d++) {
        const double to[3] = { d == 0, d == 1, 0 };
        (void)rigid_motion(s, to, true, rigid);
        for (size_t i = 0; i < f->count; i++) {
            const double *x = motion_of(s, f, i);
            kept->turn[2 * i + d] = dot(x, rigid, s->size) / sqrt(dot(x, x, s->size));
        }
    }
    for (size_t i = 0; i < f->count; i++)
        for (size_t k = 0; k < s->size; k++)
            kept->motion[i * s->size + k] = s->root[k] > 0 ? motion_of(s, f, i)[k] / s->root[k] : 0;
    return WF_OK;
}

/* Displacements of the rows' ends: the response to the inertia of the motions. */
static enum wf_status read_shapes(const struct sway *s, const struct found *f, const struct search *q,
                                  struct wf_arena *work, struct wf_err *e)
{
    const struct wf_beam_mesh *m = &s->beam->mesh;
    const size_t size = 3 * m->tree->n;
    wf_four *x = WF_TAKE(work, s->size, wf_four);
    if (!x) return wf_fail(e, WF_ENOMEM, "not enough memory for the shapes of the modes");
    for (size_t i = 0; i < f->count; i++) {
        const size_t lane = i % BLOCK;
        const double *in = motion_of(s, f, i);
        for (size_t k = 0; k < s->size; k++) x[k][lane] = in[k];
        if (lane + 1 < BLOCK && i + 1 < f->count) continue;
        wf_beam_inertia_answer(&s->answer, (double *)x, (double *)x);
        for (size_t j = i - lane; j <= i; j++) {
            double most = 0, *shape = q->shape + size * j, value = f->value[f->order[j]];
            for (size_t r = 0; r < size; r++) {
                size_t end = (size_t)m->last[r / 3];
                shape[r] = wf_beam_inertia_end(&s->answer, end, j % BLOCK)[r % 3];
                if (fabs(shape[r]) > fabs(most)) most = shape[r];
            }
            for (size_t r = 0; r < size && most != 0; r++) shape[r] /= q->part ? value : most;
        }
    }
    return WF_OK;
}

/* The shares of the modes, whose modal mass is 1. */
static enum wf_status read_parts(const struct sway *s, const struct found *f, const struct search *q,
                                 struct wf_arena *work, struct wf_err *e)
{
    const double axis[3][3] = { { q->to[0], q->to[1], 0 }, { -q->to[1], q->to[0], 0 }, { 0, 0, 1 } };
    double *rigid = WF_TAKE(work, s->size, double);
    if (!rigid) return wf_fail(e, WF_ENOMEM, "not enough memory for what the modes move");
    for (size_t d = 0; d < 5; d++) {
        (void)rigid_motion(s, axis[d % 3], d >= 3, rigid);
        for (size_t i = 0; i < f->count; i++) {
            double part = dot(motion_of(s, f, i), rigid, s->size);
            if (d < 3)
                q->part[i].mass[d] = part;
            else
                q->part[i].turn[d - 3] = part;
        }
    }
    return WF_OK;
}

/* Frequencies on the beam's mesh, and what is wanted of their motions. */
static enum wf_status modes_on(struct wf_beam *b, size_t count, const struct search *q, struct wf_arena *work,
                               double *frequency, struct wf_err *e)
{
    struct sway s;
    const bool motions = q->shape || q->kept;
    enum wf_status status = open_sway(&s, b, BLOCK, work, e);
    if (status) return status;
    struct found f = { .count = count,
                       .value = WF_TAKE(work, count, double),
                       .vector = motions ? WF_TAKE(work, count * s.size, double) : NULL,
                       .order = WF_TAKE(work, count, size_t) };
    if (!f.value || (motions && !f.vector) || !f.order)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu modes", count);
    struct wf_lanczos l = {
        .size = s.size, .apply = sway, .ctx = &s, .wanted = count, .tolerance = q->tolerance, .most = q->most
    };
    if ((status = wf_lanczos(&l, f.value, f.vector, work, e))) return status;
    order_by_frequency(f.value, f.order, count);
    for (size_t i = 0; i < count; i++) frequency[i] = hertz(f.value[f.order[i]]);
    if (q->kept) status = keep_motions(&s, &f, work, q->kept, e);
    if (!status && q->part) status = read_parts(&s, &f, q, work, e);
    return !status && q->shape ? read_shapes(&s, &f, q, work, e) : status;
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

static enum wf_status modes_within(const struct search *q, const struct wf_tree *t, const struct wf_loads *l,
                                   const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                                   double *frequency, struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_arena work = { 0 };
    struct wf_beam b, last;
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    double *before = WF_TAKE(a, count, double);
    if (!pieces || !before) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    wf_beam_first_pieces(t, o, pieces);
    for (int mesh = 0; mesh < MESHES && !status; mesh++) {
        status = wf_beam_init(&b, t, l, o, pieces, &work, &work, e);
        if (!status && mesh > 0) wf_beam_carry(&last, &b);
        if (!status) status = find_equilibrium(&b, &work, e);
        if (!status && q->kept) status = keep_equilibrium(&b, pieces, count, a, q->kept, e);
        if (!status) status = modes_on(&b, count, q, &work, frequency, e);
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

/* Residual of a motion; its frequency errs by the square. */
static const double rough = 1e-5, sharp = 1e-8;

enum wf_status wf_modes_keep(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                             double *frequency, double *shape, struct wf_modes_kept *kept, struct wf_err *e)
{
    const struct search q = { .tolerance = sharp, .shape = shape, .kept = kept };
    return modes_within(&q, t, l, o, count, a, frequency, e);
}

enum wf_status wf_modes(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                        size_t count, struct wf_arena *a, double *frequency, double *shape, struct wf_err *e)
{
    const struct search q = { .tolerance = rough, .shape = shape };
    return modes_within(&q, t, l, o, count, a, frequency, e);
}

enum wf_status wf_modes_parts(const struct wf_tree *t, const struct wf_loads *l,
                              const struct wf_solve_options *o, size_t most, size_t *count,
                              const double to[2], struct wf_arena *a, double *frequency,
                              struct wf_modes_part *out, double *shape, struct wf_err *e)
{
    const struct search q = { .tolerance = rough, .most = most, .shape = shape, .part = out, .to = to };
    enum wf_status s = modes_within(&q, t, l, o, *count, a, frequency, e);
    while (!s && *count && isnan(frequency[*count - 1])) --*count; /* the mesh has no more motions */
    return s;
}

/* A beam in the equilibrium that was kept. */
static enum wf_status open_kept(struct wf_beam *b, struct sway *s, const struct wf_tree *t,
                                const struct wf_loads *l, const struct wf_solve_options *o,
                                const struct wf_modes_kept *kept, struct wf_arena *work, struct wf_err *e)
{
    enum wf_status status = wf_beam_init(b, t, l, o, kept->pieces, work, work, e);
    if (status) return status;
    memcpy(b->shape, kept->shape, b->mesh.n * sizeof *b->shape);
    memcpy(b->tilt, kept->tilt, t->n * sizeof *b->tilt);
    status = find_equilibrium(b, work, e);
    return status ? status : open_sway(s, b, 1, work, e);
}

enum wf_status wf_modes_held(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_modes_kept *kept, size_t k,
                             double *frequency, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    struct sway s;
    double up = 0, down = 0, *x = NULL;
    enum wf_status status = open_kept(&b, &s, t, l, o, kept, &work, e);
    if (!status && !(x = WF_TAKE(&work, s.size, double)))
        status = wf_fail(e, WF_ENOMEM, "not enough memory for a mode");
    if (!status) {
        const double *u = kept->motion + k * kept->size;
        for (size_t i = 0; i < s.size; i++) {
            x[i] = s.root[i] * u[i];
            down += x[i] * x[i];
        }
        wf_beam_inertia_answer(&s.answer, x, x);
        for (size_t i = 0; i < s.size; i++) up += s.root[i] * u[i] * x[i];
        *frequency = hertz(up / down);
    }
    wf_arena_free(&work);
    return status;
}

/* The sway along a direction. */

enum { RITZ_MAX = 20 };
struct ritz {
    struct sway s;
    double *v[RITZ_MAX + 1];
    double T[RITZ_MAX * RITZ_MAX]; /* the operator in the space of v: diagonal and above */
    double value[RITZ_MAX], Q[RITZ_MAX * RITZ_MAX];
    double share[2]; /* of the widest band, in smaller spaces */
    size_t n;
};

/* Eigenvalues and eigenvectors (columns of Q) of the projected operator. */
static enum wf_status ritz_pairs(struct ritz *r, struct wf_err *e)
{
    gsl_eigen_symmv_workspace *space = gsl_eigen_symmv_alloc(r->n);
    double copy[RITZ_MAX * RITZ_MAX];
    /* the space is that of powers of a symmetric operator: what is left beyond the neighbours is rounding */
    for (size_t i = 0; i < r->n; i++)
        for (size_t j = 0; j < r->n; j++) {
            size_t low = i < j ? i : j, high = i < j ? j : i;
            copy[i * r->n + j] = high - low > 1 ? 0 : r->T[low * RITZ_MAX + high];
        }
    gsl_matrix_view m = gsl_matrix_view_array(copy, r->n, r->n), q = gsl_matrix_view_array(r->Q, r->n, r->n);
    gsl_vector_view value = gsl_vector_view_array(r->value, r->n);
    int failed = !space || gsl_eigen_symmv(&m.matrix, &value.vector, &q.matrix, space);
    gsl_eigen_symmv_free(space);
    return failed ? wf_fail(e, WF_ENOCONV, "the sway of the tree was not found") : WF_OK;
}

static double ritz_share(const struct ritz *r, size_t i) { return r->Q[i] * r->Q[i]; }

/* Is Ritz value j of the band about i? */
static bool in_band(const struct ritz *r, size_t i, size_t j, double width)
{
    if (!(r->value[i] > 0 && r->value[j] > 0)) return false;
    double ratio = sqrt(r->value[i] / r->value[j]);
    return fabs(ratio - 1) <= width;
}

/* The band with the largest share. Returned: its middle; -1: none. */
static int widest_band(const struct ritz *r, double width, struct wf_modes_sway *out)
{
    int best = -1;
    out->share = 0;
    for (size_t i = 0; i < r->n; i++) {
        double sum = 0, flexibility = 0;
        for (size_t j = 0; j < r->n; j++)
            if (in_band(r, i, j, width))
                sum += ritz_share(r, j), flexibility += ritz_share(r, j) * r->value[j];
        if (!(sum > out->share)) continue;
        best = (int)i, out->share = sum, out->frequency = hertz(flexibility / sum);
    }
    return best;
}

/* Is Ritz vector i one of the whole tree? Its residual is `left` times its last number (Parlett 1998, The
 * Symmetric Eigenvalue Problem, section 13.2). */
static bool vector_settled(const struct ritz *r, double left, size_t i)
{
    const double enough = 1e-5; /* values and shares err by its square */
    return left * fabs(r->Q[(r->n - 1) * r->n + i]) <= enough * r->value[i];
}

/* Are the vectors of the widest band those of the whole tree, and does it stay the widest? Another has at
 * most its own settled vectors and all that are not settled. Where that does not decide, its share has not
 * changed while the space grew by four vectors. */
static bool band_settled(struct ritz *r, double left, double width)
{
    const double alike = 1e-7;
    struct wf_modes_sway band;
    int middle = widest_band(r, width, &band);
    double open = 0, other = 0, change = fmax(fabs(band.share - r->share[0]), fabs(band.share - r->share[1]));
    r->share[0] = r->share[1], r->share[1] = band.share;
    for (size_t i = 0; i < r->n && middle >= 0; i++) {
        bool inside = in_band(r, (size_t)middle, i, width);
        if (vector_settled(r, left, i)) continue;
        if (inside) return false;
        open += ritz_share(r, i);
    }
    for (size_t i = 0; i < r->n && middle >= 0; i++) {
        double sum = 0;
        if (in_band(r, (size_t)middle, i, width)) continue;
        for (size_t j = 0; j < r->n; j++)
            if (in_band(r, i, j, width) && vector_settled(r, left, j)) sum += ritz_share(r, j);
        other = fmax(other, sum);
    }
    return middle >= 0 && (band.share > other + open || change <= alike);
}

/* Extend the space until its widest band is settled, or it is invariant or full. */
static enum wf_status ritz_space(struct ritz *r, double width, struct wf_arena *work, struct wf_err *e)
{
    const size_t size = r->s.size;
    for (size_t j = 0; j < RITZ_MAX; j++) {
        double *w = r->v[j + 1] = wf_arena_take_unset(work, size, sizeof *w);
        if (!w) return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
        wf_beam_inertia_answer(&r->s.answer, r->v[j], w);
        double before = sqrt(dot(w, w, size));
        /* a symmetric operator leads back to the last two alone; what rounding leaves of the others is small
         * and is taken out second */
        const size_t two = j > 0 ? j - 1 : 0;
        take_out_all(w, r->v + two, j + 1 - two, size, r->T + two * RITZ_MAX, RITZ_MAX, j);
        take_out_all(w, r->v, j + 1, size, r->T, RITZ_MAX, j);
        r->n = j + 1;
        double left = sqrt(dot(w, w, size));
        bool done = !(left > 1e-12 * before) || r->n == RITZ_MAX;
        if (done || r->n % 2 == 0) {
            enum wf_status s = ritz_pairs(r, e);
            if (s || done || band_settled(r, left, width)) return s;
        }
        for (size_t i = 0; i < size; i++) w[i] /= left;
    }
    return WF_OK;
}

/* Displacements of the rows' ends in the band's part of the rigid turn: the response to its inertia, of
 * which the Ritz value is the ratio to it. */
static void band_shape(struct ritz *r, size_t middle, double width, double inertia, double *motion,
                       double *shape)
{
    const struct wf_beam_mesh *m = &r->s.beam->mesh;
    double part[RITZ_MAX] = { 0 };
    for (size_t i = 0; i < r->n; i++)
        for (size_t j = 0; j < r->n && in_band(r, middle, i, width); j++)
            part[j] += r->Q[i] * r->Q[j * r->n + i] * sqrt(inertia) / r->value[i];
    memset(motion, 0, r->s.size * sizeof *motion);
    for (size_t j = 0; j < r->n; j++)
        for (size_t k = 0; k < r->s.size; k++) motion[k] += part[j] * r->v[j][k];
    wf_beam_inertia_answer(&r->s.answer, motion, motion);
    for (size_t k = 0; k < 3 * m->tree->n; k++)
        shape[k] = wf_beam_inertia_end(&r->s.answer, (size_t)m->last[k / 3], 0)[k % 3];
}

static enum wf_status find_sways(struct ritz *r, const double to[3], const double *width, size_t bands,
                                 struct wf_arena *work, struct wf_modes_sway *out, double *shape,
                                 struct wf_err *e)
{
    if (!(r->v[0] = WF_TAKE(work, r->s.size, double)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    const double inertia = rigid_motion(&r->s, to, true, r->v[0]);
    enum wf_status s = ritz_space(r, width[0], work, e);
    for (size_t k = 0; k < bands && !s; k++) {
        int middle = widest_band(r, width[k], &out[k]);
        if (middle < 0) return wf_fail(e, WF_EUNSTABLE, "no stable sway of the tree");
        out[k].inertia = inertia;
        band_shape(r, (size_t)middle, width[k], inertia, r->v[r->n], shape + 3 * r->s.beam->mesh.tree->n * k);
    }
    return s;
}

enum wf_status wf_modes_sway(struct wf_beam *b, const double to[3], const double *width, size_t bands,
                             struct wf_modes_sway *out, double *shape, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    const struct wf_beam before = *b;
    struct ritz *r = WF_TAKE(&work, 1, struct ritz);
    enum wf_status s =
        r ? open_sway(&r->s, b, 1, &work, e) : wf_fail(e, WF_ENOMEM, "not enough memory for the sway");
    if (!s) s = find_sways(r, to, width, bands, &work, out, shape, e);
    wf_arena_free(&work);
    *b = before;
    wf_beam_sweep_up(b);
    return s;
}

/* Self-buckling. */

/* Does the unloaded shape under `factor` times the weight have an unstable direction? */
static bool gives_way(struct wf_beam *b, double factor)
{
    struct wf_beam_stability count = { .margin = 0 };
    b->loads.weight_scale = factor;
    wf_beam_rest(&b->mesh, factor * b->loads.gravity);
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
    weight.wind = NULL, weight.points = weight.ties = weight.links = 0, weight.line = NULL;
    wf_beam_first_pieces(t, o, pieces);
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
