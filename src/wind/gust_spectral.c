/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/gust_spectral.h"
#include "base/arena.h"
#include "base/err.h"
#include "base/num.h"
#include "base/random.h"
#include "base/vec3.h"
#include "wind/fourier.h"
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Coherence between many points. */

/* Ratio of successive rungs. For few points the linear interpolation between rungs is the only error; the
 * tests measure it. */
static const double RUNG_RATIO = 1.12;
/* Added to the diagonal of the correlation matrix, so that it stays regular when points coincide. */
static const double NUGGET = 1e-11;

static double stretched_distance(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* Put the points in farthest-point order; the first is the point nearest to the middle. */
static enum wf_status order_points(struct wf_coherence *c, const double *at, struct wf_arena *a,
                                   struct wf_err *e)
{
    double middle[3] = { 0 }, best = INFINITY;
    double *gap = WF_TAKE(a, c->n, double);
    if (!gap) return wf_fail(e, WF_ENOMEM, "not enough memory to order %zu points", c->n);
    for (size_t i = 0; i < c->n; i++)
        for (int k = 0; k < 3; k++) middle[k] += at[3 * i + (size_t)k] / (double)c->n;
    size_t next = 0;
    for (size_t i = 0; i < c->n; i++) {
        double r = stretched_distance(at + 3 * i, middle);
        if (r < best) best = r, next = i;
        gap[i] = INFINITY;
    }
    for (size_t turn = 0; turn < c->n; turn++) {
        c->order[turn] = next;
        c->closest[turn] = gap[next];
        memcpy(c->stretched + 3 * turn, at + 3 * next, 3 * sizeof(double));
        size_t taken = next;
        gap[taken] = -1.0;
        for (size_t i = 0; i < c->n; i++) {
            if (gap[i] < 0.0) continue;
            double r = stretched_distance(at + 3 * i, at + 3 * taken);
            if (r < gap[i]) gap[i] = r;
            if (gap[next] < 0.0 || gap[i] > gap[next]) next = i;
        }
    }
    return WF_OK;
}

/* Find the `near` closest earlier points of a turn, by insertion. */
static void find_neighbours(struct wf_coherence *c, size_t turn)
{
    double r[WF_COHERENCE_NEAR];
    size_t *list = c->neighbour + turn * c->near, held = 0;
    for (size_t j = 0; j < turn; j++) {
        double d = stretched_distance(c->stretched + 3 * turn, c->stretched + 3 * j);
        if (held == c->near && d >= r[held - 1]) continue;
        size_t at = held < c->near ? held++ : held - 1;
        for (; at > 0 && r[at - 1] > d; at--) r[at] = r[at - 1], list[at] = list[at - 1];
        r[at] = d, list[at] = j;
    }
    c->count[turn] = held;
}

/* Vector registers have no exp of their own. */
static inline void exp_each(const wf_four *g, double r, wf_four *out)
{
    for (int lane = 0; lane < 4; lane++) (*out)[lane] = exp(-(*g)[lane] * r);
}

static inline void raise_sqrt_each(wf_four *x)
{
    for (int lane = 0; lane < 4; lane++) (*x)[lane] = sqrt(fmax((*x)[lane], NUGGET));
}

/* Weights b and remaining variance d of one turn at four values g: solve K b = k by Cholesky, d = 1 - k.b. */
WF_WIDE static void find_weights(const struct wf_coherence *c, size_t turn, const wf_four *g,
                                 wf_four weight[WF_COHERENCE_NEAR], wf_four *rest)
{
    wf_four l[WF_COHERENCE_NEAR][WF_COHERENCE_NEAR], k[WF_COHERENCE_NEAR], y[WF_COHERENCE_NEAR],
        explained = { 0 };
    size_t m = c->count[turn];
    const size_t *list = c->neighbour + turn * c->near;
    for (size_t i = 0; i < m; i++) {
        const double *at = c->stretched + 3 * list[i];
        exp_each(g, stretched_distance(at, c->stretched + 3 * turn), &k[i]);
        for (size_t j = 0; j <= i; j++) {
            wf_four s = { 1.0 + NUGGET, 1.0 + NUGGET, 1.0 + NUGGET, 1.0 + NUGGET };
            if (i != j) exp_each(g, stretched_distance(at, c->stretched + 3 * list[j]), &s);
            for (size_t q = 0; q < j; q++) s -= l[i][q] * l[j][q];
            if (i == j)
                raise_sqrt_each(&s);
            else
                s /= l[j][j];
            l[i][j] = s;
        }
    }
    for (size_t i = 0; i < m; i++) {
        y[i] = k[i];
        for (size_t q = 0; q < i; q++) y[i] -= l[i][q] * y[q];
        y[i] /= l[i][i];
        explained += y[i] * y[i];
    }
    for (size_t i = m; i-- > 0;) {
        weight[i] = y[i];
        for (size_t q = i + 1; q < m; q++) weight[i] -= l[q][i] * weight[q];
        weight[i] /= l[i][i];
    }
    for (int lane = 0; lane < 4; lane++) (*rest)[lane] = fmax(1.0 - explained[lane], 0.0);
}

/* The weights of one turn at all rungs. */
static void set_weights(const struct wf_coherence *c, size_t turn)
{
    for (size_t q = 0; q < c->rungs; q += 4) {
        wf_four g, weight[WF_COHERENCE_NEAR], rest;
        for (size_t lane = 0; lane < 4; lane++) g[lane] = c->rung[q + lane < c->rungs ? q + lane : q];
        find_weights(c, turn, &g, weight, &rest);
        for (size_t lane = 0; lane < 4 && q + lane < c->rungs; lane++) {
            size_t row = (q + lane) * c->n + turn;
            for (size_t i = 0; i < c->count[turn]; i++) c->weight[row * c->near + i] = weight[i][lane];
            c->rest[row] = rest[lane];
        }
    }
}

enum wf_status wf_coherence_make(size_t n, const double *place, const double decay[3], double g_low,
                                 double g_high, struct wf_arena *a, struct wf_coherence *c, struct wf_err *e)
{
    memset(c, 0, sizeof *c);
    c->n = n;
    c->near = n > WF_COHERENCE_NEAR ? WF_COHERENCE_NEAR : (n > 1 ? n - 1 : 1);
    c->rungs = 2 + (size_t)ceil(log(g_high / g_low) / log(RUNG_RATIO));
    double *at = WF_TAKE(a, 3 * n, double);
    c->order = WF_TAKE(a, n, size_t);
    c->count = WF_TAKE(a, n, size_t);
    c->neighbour = WF_TAKE(a, n * c->near, size_t);
    c->stretched = WF_TAKE(a, 3 * n, double);
    c->closest = WF_TAKE(a, n, double);
    c->rung = WF_TAKE(a, c->rungs, double);
    c->weight = WF_TAKE(a, c->rungs * n * c->near, double);
    c->rest = WF_TAKE(a, c->rungs * n, double);
    if (!at || !c->order || !c->count || !c->neighbour || !c->stretched || !c->closest || !c->rung ||
        !c->weight || !c->rest)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the coherence of %zu points", n);
    for (size_t i = 0; i < 3 * n; i++) at[i] = place[i] * decay[i % 3];
    if (order_points(c, at, a, e)) return e ? e->code : WF_ENOMEM;
    for (size_t turn = 0; turn < n; turn++) find_neighbours(c, turn);
    for (size_t q = 0; q < c->rungs; q++) c->rung[q] = g_low * pow(RUNG_RATIO, (double)q);
    for (size_t turn = 0; turn < n; turn++) set_weights(c, turn);
    return WF_OK;
}

/* The rung below g and the share of the way to the next one, both limited to the range of rungs. */
static void find_rung(const struct wf_coherence *c, double g, size_t *rung, double *share)
{
    if (!(g > c->rung[0])) {
        *rung = 0, *share = 0.0;
        return;
    }
    size_t q = (size_t)(log(g / c->rung[0]) / log(RUNG_RATIO));
    if (q > c->rungs - 2) q = c->rungs - 2;
    *rung = q;
    *share = fmin((g - c->rung[q]) / (c->rung[q + 1] - c->rung[q]), 1.0);
}

/* The covariance of the simulated field follows from the recursion: row by row, each new point with all
 * earlier ones. */
double wf_coherence_error(const struct wf_coherence *c, double g, struct wf_arena *a)
{
    size_t n = c->n < 400 ? c->n : 400, q;
    double share, worst = 0.0;
    double *made = WF_TAKE(a, n * n, double);
    if (!made) return NAN;
    find_rung(c, g, &q, &share);
    for (size_t i = 0; i < n; i++) {
        const double *w0 = c->weight + (q * c->n + i) * c->near, *w1 = w0 + c->n * c->near;
        double rest = (1.0 - share) * c->rest[q * c->n + i] + share * c->rest[(q + 1) * c->n + i];
        for (size_t j = 0; j <= i; j++) {
            double s = i == j ? rest : 0.0;
            for (size_t k = 0; k < c->count[i]; k++) {
                size_t from = c->neighbour[i * c->near + k];
                double b = (1.0 - share) * w0[k] + share * w1[k];
                s += b * (j == i ? made[i * n + from] : made[from > j ? from * n + j : j * n + from]);
            }
            made[i * n + j] = s;
            double want = exp(-g * stretched_distance(c->stretched + 3 * i, c->stretched + 3 * j));
            worst = fmax(worst, fabs(s - want));
        }
    }
    return worst;
}

/* Synthesis of the wind in blocks of time. White noise w_p(t), one number for each (seed, component, point,
 * step), is filtered:
 *
 *     x_p = inverse FFT of  sqrt(S_p(f) / (2 dt)) exp(-2 pi i f x_p/U) sum_q H_pq(f) W_q(f)
 *
 * with H the sequential factor of the coherence. Of a window of L steps the inner half is used; windows are
 * L/2 apart, so adjacent blocks share the noise around their boundary and are continuous except for the part
 * of the filter's impulse response that is longer than L/4 steps. That part is computed (`joint`), and L is
 * doubled until it is small. Source: Shinozuka M., Jan C.-M. (1972), Digital simulation of random processes
 * and its applications, J. Sound Vib. 25:111-128 (spectral representation); Oppenheim A., Schafer R. (1975),
 * overlap-save. */

enum { STREAM_TURBULENCE = 0x31, WINDOW_MIN = 2048, WINDOW_MAX = 1 << 17 };
static const double WINDOW_SECONDS = 800.0; /* first window: longer than the 10 min of a mean wind [s] */
static const double JOINT_WANTED = 0.02;    /* largest discontinuity between blocks / standard deviation */
static const double ROOM_WANTED = 160e6;    /* memory for the spectra of all points [bytes] */
static const double APART = 7.0; /* stretched distance times g beyond which points are independent: e^-7 */

struct spectral {
    size_t window;     /* L [steps] */
    size_t classes;    /* distinct (height, mean wind) */
    size_t *class_of;  /* of each point */
    double *amplitude; /* classes * components * (L/2 + 1) */
    double *shear;     /* classes * (L/2 + 1): correlation of u and w by frequency; NULL: none */
    struct wf_coherence coherence;
    double speed;                         /* convection speed of the eddies [m/s] */
    size_t segments;                      /* ranges of frequency between the same two rungs */
    size_t *segment_first, *segment_rung; /* segments (+1): first place in a halfcomplex spectrum, rung */
    double *share;                        /* L: share of the way to the next rung */
    double *wavenumber;                   /* L: g at each halfcomplex place [1/m] */
    double *along, *other;                /* points * L: halfcomplex spectra, by turn */
    double *noise;         /* components * points * L/2: later half of the last window's noise, by
                              turn */
    uint64_t *noise_first; /* per component: step that it begins with, where known */
    bool *noise_known;
    struct wf_fourier *fourier; /* NULL where the window is not a power of two */
    gsl_fft_real_wavetable *forward;
    gsl_fft_halfcomplex_wavetable *back;
    gsl_fft_real_workspace *space;
};

/* Number of the frequency at a place of GSL's halfcomplex order r0 r1 i1 r2 i2 ... r(L/2). */
static size_t frequency_of(size_t place) { return (place + 1) / 2; }

/* The target spectrum at one height and mean wind. */
struct target {
    const struct wf_spectrum *row;
    struct wf_spectrum_par par;
    double step;
};
static struct target target_of(const struct wf_gust_spec *s, size_t point)
{
    return (struct target){ wf_spectrum_named(s->model->spectrum), wf_gust_spectrum_par(s, point), s->step };
}
static double amplitude_at(const struct target *t, enum wf_component c, double f)
{
    return sqrt(t->row->density(&t->par, c, f) / (2.0 * t->step));
}

/* Share of the energy of the filter's impulse response that lies more than a quarter window from its middle.
 */
static double tail_energy(const struct wf_gust_spec *s, double *h, size_t window, struct spectral *w)
{
    const struct target target = target_of(s, 0);
    double far = 0.0, all = 0.0;
    for (size_t k = 0; k <= window / 2; k++) {
        double value = amplitude_at(&target, WF_ALONG, (double)k / ((double)window * s->step));
        if (k == 0)
            h[0] = value;
        else if (k == window / 2)
            h[window - 1] = value;
        else
            h[2 * k - 1] = value, h[2 * k] = 0.0;
    }
    gsl_fft_halfcomplex_inverse(h, 1, window, w->back, w->space);
    for (size_t i = 0; i < window; i++) {
        all += h[i] * h[i];
        if (i > window / 4 && i < window - window / 4) far += h[i] * h[i];
    }
    return far / all;
}

static void free_tables(struct spectral *w)
{
    if (w->forward) gsl_fft_real_wavetable_free(w->forward);
    if (w->back) gsl_fft_halfcomplex_wavetable_free(w->back);
    if (w->space) gsl_fft_real_workspace_free(w->space);
    w->forward = NULL, w->back = NULL, w->space = NULL;
}

static enum wf_status make_tables(struct spectral *w, struct wf_err *e)
{
    free_tables(w);
    wf_quiet_begin();
    w->forward = gsl_fft_real_wavetable_alloc(w->window);
    w->back = gsl_fft_halfcomplex_wavetable_alloc(w->window);
    w->space = gsl_fft_real_workspace_alloc(w->window);
    wf_quiet_end();
    if (w->forward && w->back && w->space) return WF_OK;
    free_tables(w);
    return wf_fail(e, WF_ENOMEM, "not enough memory for a Fourier transform of %zu steps", w->window);
}

static enum wf_status choose_window(struct wf_gust *g, struct spectral *w, struct wf_arena *a,
                                    struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double per_step = 8.0 * (double)s->points * (s->components > 1 ? 2.0 : 1.0);
    w->window = WINDOW_MIN;
    while (w->window < WINDOW_MAX && (double)w->window * s->step < WINDOW_SECONDS) w->window *= 2;
    while (w->window > WINDOW_MIN && (double)w->window * per_step > ROOM_WANTED) w->window /= 2;
    if (s->block) w->window = 2 * s->block;
    double *h = WF_TAKE(a, s->block ? w->window : WINDOW_MAX, double);
    if (!h) return wf_fail(e, WF_ENOMEM, "not enough memory for a window of %d steps", WINDOW_MAX);
    for (;; w->window *= 2) {
        if (make_tables(w, e)) return WF_ENOMEM;
        g->joint = sqrt(2.0 * tail_energy(s, h, w->window, w));
        if (s->block || g->joint <= JOINT_WANTED || w->window >= WINDOW_MAX) return WF_OK;
        if (2.0 * (double)w->window * per_step > ROOM_WANTED) return WF_OK;
    }
}

static enum wf_status sort_into_classes(struct wf_gust *g, struct spectral *w, struct wf_arena *a,
                                        struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    size_t n = s->points, half = w->window / 2 + 1, *first = WF_TAKE(a, n, size_t);
    w->class_of = WF_TAKE(a, n, size_t);
    if (!first || !w->class_of) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu points", n);
    for (size_t p = 0; p < n; p++) {
        size_t c = 0;
        while (c < w->classes && (wf_gust_place(s, first[c], 2) != wf_gust_place(s, p, 2) ||
                                  wf_gust_mean(s, first[c]) != wf_gust_mean(s, p)))
            c++;
        if (c == w->classes) first[w->classes++] = p;
        w->class_of[p] = c;
    }
    const struct wf_spectrum *row = wf_spectrum_named(s->model->spectrum);
    w->amplitude = WF_TAKE(a, w->classes * s->components * half, double);
    if (row->shear && s->components > 1) w->shear = WF_TAKE(a, w->classes * half, double);
    if (!w->amplitude || (row->shear && s->components > 1 && !w->shear))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the spectra of %zu heights", w->classes);
    for (size_t c = 0; c < w->classes; c++) {
        const struct target target = target_of(s, first[c]);
        for (size_t k = 0; k < half; k++) {
            double f = (double)k / ((double)w->window * s->step);
            for (unsigned i = 0; i < s->components; i++)
                w->amplitude[(c * s->components + i) * half + k] =
                    amplitude_at(&target, (enum wf_component)i, f);
            if (!w->shear) continue;
            double su = row->density(&target.par, WF_ALONG, f), sw = row->density(&target.par, WF_UP, f);
            w->shear[c * half + k] = fmax(fmin(row->shear(&target.par, f) / sqrt(su * sw), 1.0), -1.0);
        }
    }
    return WF_OK;
}

/* Compute g at each place of a halfcomplex spectrum, and the ranges of places that lie between the same two
 * rungs. */
static enum wf_status lay_ladder(const struct wf_gust_spec *s, struct spectral *w, struct wf_arena *a,
                                 struct wf_err *e)
{
    size_t n = w->window, rung = (size_t)-1;
    double length = wf_gust_get(s, "coherence-length"), q = length > 0.0 ? 0.12 / length : 0.0;
    w->share = WF_TAKE(a, n, double);
    w->wavenumber = WF_TAKE(a, n, double);
    w->segment_first = WF_TAKE(a, w->coherence.rungs + 2, size_t);
    w->segment_rung = WF_TAKE(a, w->coherence.rungs + 2, size_t);
    if (!w->share || !w->wavenumber || !w->segment_first || !w->segment_rung)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a window of %zu steps", n);
    for (size_t i = 0; i < n; i++) {
        size_t at;
        double f = (double)frequency_of(i) / ((double)n * s->step);
        w->wavenumber[i] = hypot(f / w->speed, q);
        find_rung(&w->coherence, w->wavenumber[i], &at, &w->share[i]);
        if (at == rung) continue;
        w->segment_first[w->segments] = i;
        w->segment_rung[w->segments++] = rung = at;
    }
    w->segment_first[w->segments] = n;
    return WF_OK;
}

enum wf_status wf_gust_spectral_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e)
{
    struct wf_gust_spec *s = &g->spec;
    struct spectral *w = WF_TAKE(a, 1, struct spectral);
    if (!w) return wf_fail(e, WF_ENOMEM, "not enough memory for a gust model");
    g->work = w;
    if (choose_window(g, w, a, e)) return WF_ENOMEM;
    if (!(w->window & (w->window - 1)) && wf_fourier_open(w->window, a, &w->fourier, e)) return WF_ENOMEM;
    g->block = w->window / 2;
    if (sort_into_classes(g, w, a, e)) return WF_ENOMEM;
    for (size_t p = 0; p < s->points; p++) w->speed += wf_gust_mean(s, p) / (double)s->points;
    double lowest = 0.02 / ((double)w->window * s->step * w->speed), highest = 0.5 / (s->step * w->speed);
    double length = wf_gust_get(s, "coherence-length"), q = length > 0.0 ? 0.12 / length : 0.0;
    const double decay[3] = { wf_gust_get(s, "decay-along"), wf_gust_get(s, "decay-across"),
                              wf_gust_get(s, "decay-up") };
    const double alone[3] = { 0.0, 0.0, s->height };
    if (wf_coherence_make(s->points, s->place ? s->place : alone, decay, fmax(lowest, q), hypot(highest, q),
                          a, &w->coherence, e) ||
        lay_ladder(s, w, a, e))
        return WF_ENOMEM;
    w->along = WF_TAKE(a, s->points * w->window, double);
    w->other = s->components > 1 ? WF_TAKE(a, s->points * w->window, double) : w->along;
    w->noise = WF_TAKE(a, s->components * s->points * (w->window / 2), double);
    w->noise_first = WF_TAKE(a, s->components, uint64_t);
    w->noise_known = WF_TAKE(a, s->components, bool);
    if (!w->along || !w->other || !w->noise || !w->noise_first || !w->noise_known)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the spectra of %zu points and %zu steps",
                       s->points, w->window);
    return WF_OK;
}

void wf_gust_spectral_close(struct wf_gust *g)
{
    if (g->work) free_tables(g->work);
}

enum { TOGETHER = 4 };

/* y += sum of four neighbours, each with a weight that is linear between two rungs: one pass over y for four
 * neighbours. */
WF_WIDE static void add_four(double *restrict y, const double *const z[TOGETHER], const double b[TOGETHER],
                             const double db[TOGETHER], const double *restrict share, size_t first,
                             size_t last)
{
    const double *restrict z0 = z[0], *restrict z1 = z[1], *restrict z2 = z[2], *restrict z3 = z[3];
    for (size_t i = first; i < last; i++)
        y[i] += (b[0] + share[i] * db[0]) * z0[i] + (b[1] + share[i] * db[1]) * z1[i] +
                (b[2] + share[i] * db[2]) * z2[i] + (b[3] + share[i] * db[3]) * z3[i];
}

/* y_i <- sqrt(d_i) w_i + sum_j b_ij y_j at every frequency at which the closest neighbour is correlated with
 * the point. */
static void join_neighbours(const struct spectral *w, double *all, size_t turn)
{
    const struct wf_coherence *c = &w->coherence;
    size_t n = w->window, count = c->count[turn];
    double *restrict y = all + turn * n;
    for (size_t q = 0; q < w->segments && count > 0; q++) {
        size_t first = w->segment_first[q], last = w->segment_first[q + 1];
        if (w->wavenumber[first] * c->closest[turn] > APART) return;
        size_t row = w->segment_rung[q] * c->n + turn, above = row + c->n;
        double d0 = c->rest[row], d1 = c->rest[above] - d0;
        for (size_t i = first; i < last; i++) y[i] *= sqrt(d0 + w->share[i] * d1);
        for (size_t k = 0; k < count; k += TOGETHER) {
            const double *z[TOGETHER];
            double b[TOGETHER], db[TOGETHER];
            for (size_t j = 0; j < TOGETHER; j++) {
                bool there = k + j < count; /* weight 0 beyond the last */
                z[j] = all + c->neighbour[turn * c->near + (there ? k + j : k)] * n;
                b[j] = there ? c->weight[row * c->near + k + j] : 0.0;
                db[j] = there ? c->weight[above * c->near + k + j] - b[j] : 0.0;
            }
            add_four(y, z, b, db, w->share, first, last);
        }
    }
}

/* White noise of a turn from step `start` on, one window long. Windows are half of their length apart: the
 * first half of a window is the second half of the one before. */
static void make_noise(const struct wf_gust *g, struct spectral *w, unsigned component, uint64_t start,
                       size_t turn, double *y)
{
    const size_t half = w->window / 2;
    const struct wf_gust_spec *s = &g->spec;
    double *kept = w->noise + (component * s->points + turn) * half;
    uint64_t stream = wf_random_stream(STREAM_TURBULENCE, component, w->coherence.order[turn]);
    if (w->noise_known[component] && w->noise_first[component] == start) {
        memcpy(y, kept, half * sizeof *y);
        wf_random_normals(s->seed, stream, start + half, w->window - half, y + half);
    } else
        wf_random_normals(s->seed, stream, start, w->window, y);
    memcpy(kept, y + half, half * sizeof *kept);
}

enum { SERIES = WF_FOURIER_SERIES };

/* Transform the series of `many` turns from `turn` on, in place. */
static void transform_turns(const struct spectral *w, bool forward, double *all, size_t turn, size_t many)
{
    double *series[SERIES];
    for (size_t k = 0; k < SERIES; k++) series[k] = all + (turn + (k < many ? k : 0)) * w->window;
    if (w->fourier && forward) wf_fourier_forward(w->fourier, series);
    if (w->fourier && !forward) wf_fourier_inverse(w->fourier, series);
    for (size_t k = 0; k < many && !w->fourier; k++)
        if (forward)
            gsl_fft_real_transform(series[k], 1, w->window, w->forward, w->space);
        else
            gsl_fft_halfcomplex_inverse(series[k], 1, w->window, w->back, w->space);
}

static size_t turns_left(const struct wf_gust *g, size_t turn)
{
    return g->spec.points - turn < SERIES ? g->spec.points - turn : SERIES;
}

static void make_field(const struct wf_gust *g, struct spectral *w, unsigned component, size_t first,
                       double *all)
{
    uint64_t start = (uint64_t)first - w->window / 4; /* wraps: times before the series have addresses too */
    for (size_t turn = 0; turn < g->spec.points; turn += SERIES) {
        size_t many = turns_left(g, turn);
        for (size_t k = turn; k < turn + many; k++)
            make_noise(g, w, component, start, k, all + k * w->window);
        transform_turns(w, true, all, turn, many);
        for (size_t k = turn; k < turn + many; k++) join_neighbours(w, all, k);
    }
    w->noise_first[component] = start + w->window / 2, w->noise_known[component] = true;
}

/* Multiply a spectrum by the amplitude and by the phase of the delay along the wind (frozen turbulence,
 * Taylor). */
static void shape_spectrum(double *y, const double *amplitude, size_t window, double turn_per_step)
{
    double c = 1.0, s = 0.0, dc = cos(turn_per_step), ds = sin(turn_per_step);
    y[0] *= amplitude[0];
    for (size_t k = 1; k < window / 2; k++) {
        double next = c * dc - s * ds, re = y[2 * k - 1], im = y[2 * k];
        s = s * dc + c * ds;
        c = next;
        y[2 * k - 1] = amplitude[k] * (re * c + im * s);
        y[2 * k] = amplitude[k] * (im * c - re * s);
    }
    y[window - 1] *= amplitude[window / 2];
}

/* Spectrum y of one component at a turn, from its white one. */
static void shape_turn(const struct wf_gust *g, const struct spectral *w, unsigned component, size_t turn,
                       double *y)
{
    const struct wf_gust_spec *s = &g->spec;
    size_t half = w->window / 2 + 1, p = w->coherence.order[turn], class = w->class_of[p];
    if (component == WF_UP && w->shear) {
        const double *u = w->along + turn * w->window, *rho = w->shear + class * half;
        for (size_t i = 0; i < w->window; i++) {
            double r = rho[frequency_of(i)];
            y[i] = r * u[i] + sqrt(1.0 - r * r) * y[i];
        }
    }
    double delay = wf_gust_place(s, p, 0) / w->speed;
    shape_spectrum(y, w->amplitude + (class * s->components + component) * half, w->window,
                   WF_TURN * delay / ((double)w->window * s->step));
}

enum wf_status wf_gust_spectral_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                     struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    struct spectral *w = g->work;
    (void)e;
    /* the white spectrum of u is kept, because that of w is correlated with it; the series of u is made from
     * a copy in the place of w, which is not in use yet */
    for (unsigned component = 0; component < s->components; component++) {
        double *all = component == 0 ? w->along : w->other, *made = s->components > 1 ? w->other : all;
        make_field(g, w, component, first, all);
        for (size_t turn = 0; turn < s->points; turn += SERIES) {
            size_t many = turns_left(g, turn);
            for (size_t k = turn; k < turn + many; k++) {
                double *y = made + k * w->window;
                if (made != all) memcpy(y, all + k * w->window, w->window * sizeof *y);
                shape_turn(g, w, component, k, y);
            }
            transform_turns(w, false, made, turn, many);
            for (size_t k = turn; k < turn + many; k++) {
                size_t p = w->coherence.order[k];
                const double *y = made + k * w->window + w->window / 4;
                double *to = out + (component * s->points + p) * g->block;
                double mean = component == WF_ALONG ? wf_gust_mean(s, p) : 0.0;
                for (size_t i = 0; i < steps; i++) to[i] = mean + y[i];
            }
        }
    }
    return WF_OK;
}

double wf_gust_coherence_target(const struct wf_gust_spec *s, size_t p, size_t q, double f)
{
    static const char *const decay[3] = { "decay-along", "decay-across", "decay-up" };
    double r2 = 0.0, speed = 0.0, length = wf_gust_get(s, "coherence-length");
    if (!s->model->spectrum) return NAN;
    for (size_t i = 0; i < s->points; i++) speed += wf_gust_mean(s, i) / (double)s->points;
    for (int axis = 0; axis < 3; axis++) {
        double d = wf_gust_get(s, decay[axis]) * (wf_gust_place(s, p, axis) - wf_gust_place(s, q, axis));
        r2 += d * d;
    }
    return exp(-sqrt(r2) * hypot(f / speed, length > 0.0 ? 0.12 / length : 0.0));
}

double wf_gust_coherence_error(const struct wf_gust *g, struct wf_arena *a)
{
    const struct spectral *w = g->work;
    double worst = 0.0;
    if (!g->spec.model->spectrum) return NAN;
    /* every seventh rung, half way to the next, where the error of the interpolation is largest */
    for (size_t q = 0; q + 1 < w->coherence.rungs; q += 7)
        worst = fmax(worst, wf_coherence_error(&w->coherence,
                                               0.5 * (w->coherence.rung[q] + w->coherence.rung[q + 1]), a));
    return worst;
}
