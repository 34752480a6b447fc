/* Gusts that are a formula in time: one wind for all points, carried along at the mean speed (Taylor 1938).
 */
#include "base/random.h"
#include "wind/gust_rows.h"
#include "wind/noise.h"
#include <math.h>

enum { STREAM_PHASE = 0x32, STREAM_NOISE = 7 };
#define TAU 6.28318530717958647692
enum { DIRECT_BLOCK = 4096 };

double wf_gust_place(const struct wf_gust_spec *s, size_t point, int axis)
{
    if (s->place) return s->place[3 * point + (size_t)axis];
    return axis == 2 ? s->height : 0.0;
}

double wf_gust_mean(const struct wf_gust_spec *s, size_t point)
{
    return s->mean ? s->mean[point] : s->speed;
}

enum wf_status wf_gust_direct_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e)
{
    (void)a, (void)e;
    g->block = g->spec.block ? g->spec.block : DIRECT_BLOCK;
    return WF_OK;
}

/* Time at the point: what passed the origin x/U ago. */
static double local_time(const struct wf_gust_spec *s, size_t point, size_t step)
{
    return (double)step * s->step - wf_gust_place(s, point, 0) / s->speed;
}

static double drawn_phase(const struct wf_gust_spec *s)
{
    return TAU * wf_random_uniform(s->seed, wf_random_stream(STREAM_PHASE, 0, 0), 0);
}

/* U(t) = Ua (1 + a cos(omega t + phi)), phi drawn once; a = sqrt(2) times the turbulence intensity. */
enum wf_status wf_gust_cosine_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double omega = TAU / wf_gust_get(s, "period"), phase = drawn_phase(s), part = sqrt(2.0) * s->intensity;
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++)
            out[p * g->block + i] =
                wf_gust_mean(s, p) + s->speed * part * cos(omega * local_time(s, p, first + i) + phase);
    return WF_OK;
}

void wf_gust_octaves(const struct wf_gust_spec *s, struct wf_octaves *o)
{
    *o = (struct wf_octaves){ (unsigned)wf_gust_get(s, "octaves"), wf_gust_get(s, "persistence"),
                              wf_gust_get(s, "lacunarity"), 1 };
}

enum wf_status wf_gust_perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    struct wf_octaves o;
    wf_gust_octaves(s, &o);
    double period = wf_gust_get(s, "period"), scale = s->intensity * s->speed / sqrt(wf_noise_variance(&o));
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++)
            out[p * g->block + i] =
                wf_gust_mean(s, p) +
                scale * wf_noise_octaves(s->seed, STREAM_NOISE, &o, local_time(s, p, first + i) / period);
    return WF_OK;
}

/* V0 + A sin + B N with N of zero mean and unit variance; A^2/2 + B^2 = (Iu V0)^2. */
enum wf_status wf_gust_sine_perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                        struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    struct wf_octaves o;
    wf_gust_octaves(s, &o);
    double period = wf_gust_get(s, "period"), share = wf_gust_get(s, "sine-share"), phase = drawn_phase(s);
    double deviation = s->intensity * s->speed, wave = deviation * sqrt(2.0 * share);
    double noise = deviation * sqrt((1.0 - share) / wf_noise_variance(&o)),
           cell = wf_gust_get(s, "noise-period");
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++) {
            double t = local_time(s, p, first + i);
            out[p * g->block + i] = wf_gust_mean(s, p) + wave * sin(TAU * t / period + phase) +
                                    noise * wf_noise_octaves(s->seed, STREAM_NOISE, &o, t / cell);
        }
    return WF_OK;
}

/* As printed: V0 + V0 sin(omega t + alpha) + epsilon N(t), t counted in frames, N value noise in 0..1 with
 * one lattice number a frame-second as octaves are not given. */
enum wf_status wf_gust_zhao_fill(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double omega = wf_gust_get(s, "omega"), alpha = wf_gust_get(s, "alpha"),
           rate = wf_gust_get(s, "frame-rate");
    double epsilon = wf_gust_get(s, "epsilon"), cell = wf_gust_get(s, "noise-frames");
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++) {
            double frame = (double)(first + i) * s->step * rate;
            out[p * g->block + i] = wf_gust_mean(s, p) + s->speed * sin(omega * frame + alpha) +
                                    epsilon * wf_noise_value(s->seed, STREAM_NOISE, frame / cell);
        }
    return WF_OK;
}

double wf_gust_eog(double amplitude, double duration, double t)
{
    if (!(t > 0.0 && t < duration)) return 0.0;
    return -0.37 * amplitude * sin(1.5 * TAU * t / duration) * (1.0 - cos(TAU * t / duration));
}

/* IEC 61400-1: min(1.35 (Ve1 - U), 3.3 sigma / (1 + 0.1 D / Lambda)), Lambda = 0.7 z up to 60 m, then 42 m.
 */
double wf_gust_eog_amplitude(const struct wf_gust_spec *s)
{
    double length = s->height <= 60.0 ? 0.7 * s->height : 42.0, once = wf_gust_get(s, "annual-extreme");
    double turbulent = 3.3 * s->intensity * s->speed / (1.0 + 0.1 * wf_gust_get(s, "breadth") / length);
    return once > s->speed ? fmin(1.35 * (once - s->speed), turbulent) : turbulent;
}

enum wf_status wf_gust_eog_fill(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double amplitude = wf_gust_eog_amplitude(s), start = wf_gust_get(s, "start"),
           t = wf_gust_get(s, "duration");
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++)
            out[p * g->block + i] =
                wf_gust_mean(s, p) + wf_gust_eog(amplitude, t, local_time(s, p, first + i) - start);
    return WF_OK;
}
