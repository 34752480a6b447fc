/* Wind over low hills: the linear response of a neutral wind, by Fourier transform of the map. */
#include "wind/terrain.h"
#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <string.h>

#define TAU 6.28318530717958647692

struct plane {
    size_t nx, ny;
    double *h; /* complex, ny rows of nx */
    gsl_fft_complex_wavetable *wx, *wy;
    gsl_fft_complex_workspace *sx, *sy;
};

/* The next size at least n with no other prime factors than 2, 3, 5. */
static size_t smooth(size_t n)
{
    for (;; n++) {
        size_t rest = n;
        while (rest % 2 == 0) rest /= 2;
        while (rest % 3 == 0) rest /= 3;
        while (rest % 5 == 0) rest /= 5;
        if (rest == 1) return n;
    }
}

static void drop(struct plane *p)
{
    if (p->wx) gsl_fft_complex_wavetable_free(p->wx);
    if (p->wy) gsl_fft_complex_wavetable_free(p->wy);
    if (p->sx) gsl_fft_complex_workspace_free(p->sx);
    if (p->sy) gsl_fft_complex_workspace_free(p->sy);
}

static enum wf_status lay_out(struct plane *p, const struct wf_terrain *t, struct wf_arena *a,
                              struct wf_err *e)
{
    p->nx = smooth(2 * t->columns - 2);
    p->ny = smooth(2 * t->rows - 2);
    p->h = WF_TAKE(a, 2 * p->nx * p->ny, double);
    p->wx = gsl_fft_complex_wavetable_alloc(p->nx);
    p->wy = gsl_fft_complex_wavetable_alloc(p->ny);
    p->sx = gsl_fft_complex_workspace_alloc(p->nx);
    p->sy = gsl_fft_complex_workspace_alloc(p->ny);
    if (p->h && p->wx && p->wy && p->sx && p->sy) return WF_OK;
    drop(p);
    return wf_fail(e, WF_ENOMEM, "no room for the transform of a map of %zu x %zu", t->columns, t->rows);
}

static void transform(struct plane *p, gsl_fft_direction way)
{
    for (size_t r = 0; r < p->ny; r++)
        gsl_fft_complex_transform(p->h + 2 * r * p->nx, 1, p->nx, p->wx, p->sx, way);
    for (size_t c = 0; c < p->nx; c++)
        gsl_fft_complex_transform(p->h + 2 * c, p->nx, p->ny, p->wy, p->sy, way);
}

/* Which grid point stands at place i of the doubled map: there and back, then the first again up to a size
 * that transforms well. */
static size_t mirrored(size_t i, size_t n) { return i < n ? i : i < 2 * n - 2 ? 2 * n - 2 - i : 0; }

static double wavenumber(size_t i, size_t n, double cell)
{
    double k = i <= n / 2 ? (double)i : (double)i - (double)n;
    return TAU * k / ((double)n * cell);
}

/* Mean of 1/|k|, each wave with its share of the height variance per |k|: for one wave of number k it is 1/k.
 */
static double mean_length(const struct plane *p, double cell)
{
    double energy = 0.0, weighted = 0.0;
    for (size_t r = 0; r < p->ny; r++)
        for (size_t c = 0; c < p->nx; c++) {
            const double *h = p->h + 2 * (r * p->nx + c);
            double k = hypot(wavenumber(c, p->nx, cell), wavenumber(r, p->ny, cell)),
                   e2 = h[0] * h[0] + h[1] * h[1];
            energy += k > 0.0 ? e2 : 0.0;
            weighted += k * e2;
        }
    return weighted > 0.0 ? energy / weighted : 0.0;
}

/* l ln(l/z0) = 2 kappa^2 L with kappa = 0.4, by Newton from above (the left side is convex there). */
static double inner_height(double length, double z0)
{
    double l = fmax(length, 3.0 * z0);
    for (int i = 0; i < 60; i++) l -= (l * log(l / z0) - 0.32 * length) / (log(l / z0) + 1.0);
    return l;
}

static enum wf_status respond(const struct wf_terrain *t, const struct wf_speedup_request *q, struct plane *p,
                              struct wf_speedup *out, struct wf_err *e)
{
    double ex = -sin(q->from), ey = -cos(q->from);
    out->length = q->length > 0.0 ? q->length : mean_length(p, t->cell);
    if (!(out->length > 4.0 * q->roughness) && out->length > 0.0)
        return wf_fail(e, WF_EUSAGE, "hills %g m long over a roughness of %g m", out->length, q->roughness);
    out->inner = out->length > 0.0 ? inner_height(out->length, q->roughness) : 0.0;
    double z = fmin(fmax(q->height, out->inner), fmax(out->length, out->inner));
    double ratio = out->length > 0.0 ? log(out->length / q->roughness) / log(z / q->roughness) : 1.0;
    out->gain = ratio * ratio;
    for (size_t r = 0; r < p->ny; r++)
        for (size_t c = 0; c < p->nx; c++) {
            double kx = wavenumber(c, p->nx, t->cell), ky = wavenumber(r, p->ny, t->cell), k = hypot(kx, ky);
            double along = kx * ex + ky * ey;
            double response = k > 0.0 ? out->gain * along * along / k * exp(-k * q->height) : 0.0;
            p->h[2 * (r * p->nx + c)] *= response;
            p->h[2 * (r * p->nx + c) + 1] *= response;
        }
    return WF_OK;
}

enum wf_status wf_terrain_speedup(const struct wf_terrain *t, const struct wf_speedup_request *q,
                                  struct wf_arena *a, struct wf_speedup *out, struct wf_err *e)
{
    struct plane p = { 0 };
    double mean = 0.0;
    memset(out, 0, sizeof *out);
    if (!(q->roughness > 0.0 && q->roughness <= 10.0 && q->height > q->roughness && q->height <= 500.0 &&
          q->length >= 0.0))
        return wf_fail(e, WF_EUSAGE,
                       "speed-up at %g m over a roughness of %g m: 0 < z0 <= 10 m, z0 < z <= 500 m",
                       q->height, q->roughness);
    for (size_t i = 0; i < t->rows * t->columns; i++) {
        if (isnan(t->z[i]))
            return wf_fail(
                e, WF_EINPUT,
                "the map has points without data (first at %.9g, %.9g); the speed-up needs a whole map: "
                "fill them, or cut out a part without gaps",
                t->x0 + (double)(i % t->columns) * t->cell, t->y0 + (double)(i / t->columns) * t->cell);
        mean += t->z[i] / (double)(t->rows * t->columns);
    }
    out->ds = WF_TAKE(a, t->rows * t->columns, double);
    if (!out->ds || lay_out(&p, t, a, e)) return wf_fail(e, WF_ENOMEM, "no room for the speed-up of a map");
    for (size_t r = 0; r < p.ny; r++)
        for (size_t c = 0; c < p.nx; c++)
            p.h[2 * (r * p.nx + c)] =
                t->z[mirrored(r, t->rows) * t->columns + mirrored(c, t->columns)] - mean;
    transform(&p, gsl_fft_forward);
    enum wf_status s = respond(t, q, &p, out, e);
    if (!s) {
        transform(&p, gsl_fft_backward);
        for (size_t r = 0; r < t->rows; r++)
            for (size_t c = 0; c < t->columns; c++)
                out->ds[r * t->columns + c] = p.h[2 * (r * p.nx + c)] / (double)(p.nx * p.ny);
    }
    out->steepest = wf_terrain_steepest(t);
    drop(&p);
    return s;
}
