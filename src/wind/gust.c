/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/gust.h"
#include "base/num.h"
#include "base/random.h"
#include "base/text.h"
#include "wind/gust_spectral.h"
#include "wind/noise.h"
#include <math.h>
#include <string.h>

/* Models that are a formula in time: the same wind at all points, delayed by x/U along the wind (frozen
 * turbulence, Taylor 1938). */

enum { STREAM_PHASE = 0x32, STREAM_NOISE = 7 };
enum { DIRECT_BLOCK = 4096 };

static enum wf_status direct_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e)
{
    (void)a, (void)e;
    g->block = g->spec.block ? g->spec.block : DIRECT_BLOCK;
    return WF_OK;
}

/* Time of the wind at a point: that of the origin x/U ago [s]. */
static double local_time(const struct wf_gust_spec *s, size_t point, size_t step)
{
    return (double)step * s->step - wf_gust_place(s, point, 0) / s->speed;
}

static double drawn_phase(const struct wf_gust_spec *s)
{
    return WF_TURN * wf_random_uniform(s->seed, wf_random_stream(STREAM_PHASE, 0, 0), 0);
}

/* U(t) = Ua (1 + a cos(omega t + phi)), phi drawn once; a = sqrt(2) times the turbulence intensity. */
static enum wf_status cosine_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                  struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double omega = WF_TURN / wf_gust_get(s, "period"), phase = drawn_phase(s),
           part = sqrt(2.0) * s->intensity;
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

static enum wf_status perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
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
static enum wf_status sine_perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
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
            out[p * g->block + i] = wf_gust_mean(s, p) + wave * sin(WF_TURN * t / period + phase) +
                                    noise * wf_noise_octaves(s->seed, STREAM_NOISE, &o, t / cell);
        }
    return WF_OK;
}

/* As printed: V0 + V0 sin(omega t + alpha) + epsilon N(t), t counted in frames, N value noise in 0..1. The
 * paper gives no octaves: one lattice number for every noise-frames frames. */
static enum wf_status zhao_fill(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e)
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

/* Speed change of the extreme operating gust over its mean, at time t after its start [m/s]. */
static double eog_change(double amplitude, double duration, double t)
{
    if (!(t > 0.0 && t < duration)) return 0.0;
    return -0.37 * amplitude * sin(1.5 * WF_TURN * t / duration) * (1.0 - cos(WF_TURN * t / duration));
}

double wf_gust_eog_amplitude(const struct wf_gust_spec *s)
{
    double length = s->height <= 60.0 ? 0.7 * s->height : 42.0, once = wf_gust_get(s, "annual-extreme");
    double turbulent = 3.3 * s->intensity * s->speed / (1.0 + 0.1 * wf_gust_get(s, "breadth") / length);
    return once > s->speed ? fmin(1.35 * (once - s->speed), turbulent) : turbulent;
}

static enum wf_status eog_fill(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    double amplitude = wf_gust_eog_amplitude(s), start = wf_gust_get(s, "start"),
           t = wf_gust_get(s, "duration");
    (void)e;
    for (size_t p = 0; p < s->points; p++)
        for (size_t i = 0; i < steps; i++)
            out[p * g->block + i] =
                wf_gust_mean(s, p) + eog_change(amplitude, t, local_time(s, p, first + i) - start);
    return WF_OK;
}

/* A measured record as a model: interpolated linearly to the step, the same at all points, delayed along the
 * wind by x/U. */

struct record_play {
    const double *part[3];
    double scale; /* factor of all components: specified / recorded mean wind; 1 without rescaling */
};

static enum wf_status record_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    const struct wf_record *r = s->record;
    struct record_play *w = WF_TAKE(a, 1, struct record_play);
    if (!w) return wf_fail(e, WF_ENOMEM, "not enough memory for a gust model");
    *w = (struct record_play){ { r->u, r->v, r->w },
                               wf_gust_get(s, "rescale") > 0.0 ? s->speed / r->mean : 1.0 };
    g->work = w;
    return direct_open(g, a, e);
}

static double record_at(const double *x, const struct wf_record *r, double t)
{
    double place = fmin(fmax(t / r->step, 0.0), (double)(r->n - 1));
    size_t i = (size_t)place;
    if (i + 1 >= r->n) return x[r->n - 1];
    return x[i] + (x[i + 1] - x[i]) * (place - (double)i);
}

static enum wf_status record_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                  struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    const struct record_play *w = g->work;
    const struct wf_record *r = s->record;
    double carried = w->scale * r->mean;
    (void)e;
    for (unsigned c = 0; c < s->components; c++)
        for (size_t p = 0; p < s->points; p++) {
            double shift = c == 0 && s->mean ? s->mean[p] - carried : 0.0;
            for (size_t i = 0; i < steps; i++) {
                double t = (double)(first + i) * s->step - wf_gust_place(s, p, 0) / carried;
                out[(c * s->points + p) * g->block + i] =
                    w->part[c] ? shift + w->scale * record_at(w->part[c], r, t) : 0.0;
            }
        }
    return WF_OK;
}

enum wf_status wf_gust_record_words(struct wf_gust_spec *s, const char *file,
                                    const struct wf_record_words *how, struct wf_arena *a, struct wf_diag *d,
                                    struct wf_err *e)
{
    struct wf_record_request q;
    struct wf_record *r = WF_TAKE(a, 1, struct wf_record);
    char *rest = wf_arena_text(a, how->columns);
    if (!file) return wf_fail(e, WF_EUSAGE, "the model record needs the file of an anemometer");
    if (!r || !rest) return wf_fail(e, WF_ENOMEM, "not enough memory for a record");
    wf_record_request_default(&q);
    q.missing = how->missing;
    q.step = how->rate > 0.0 ? 1.0 / how->rate : NAN;
    if (!wf_dates_named(how->dates, &q.dates))
        return wf_fail(e, WF_EUSAGE, "dates '%s'; there are: day-first, month-first", how->dates);
    q.time = wf_list_item(&rest);
    bool empty = false;
    for (int k = 0; k < 3; k++) empty |= (q.part[k] = wf_list_item(&rest)) && !*q.part[k];
    if (empty || !q.part[0] || wf_list_item(&rest))
        return wf_fail(
            e, WF_EUSAGE,
            "columns '%s': a time column ('-' or nothing: none) and one to three components are needed, "
            "separated by commas",
            how->columns);
    if (!*q.time || !strcmp(q.time, "-")) q.time = NULL;
    if (q.time && how->rate > 0.0)
        return wf_fail(e, WF_EUSAGE, "a rate is for records without a time column; '%s' is one, '-' is none",
                       q.time);
    s->record = r;
    return wf_record_read(file, &q, a, d, r, e);
}

/* The models as rows. */

#define COHERENCE_PARS                                                                                       \
    { "decay-along", "-", 3.0, 0.0, 100.0, .help = "coherence decay for separation along the wind" },        \
        { "decay-across", "-", 10.0, 0.0, 100.0, .help = "coherence decay for separation across the wind" }, \
        { "decay-up", "-", 10.0, 0.0, 100.0, .help = "coherence decay for separation in height" },           \
    {                                                                                                        \
        "coherence-length", "m", 0.0, 0.0, 5000.0,                                                           \
            .help =                                                                                          \
                "length Lc of the second term of IEC 61400-1; 0: Davenport's form, full coherence at 0 Hz"   \
    }
#define OCTAVE_PARS                                                                                          \
    { "octaves", "-", 6.0, 1.0, 16.0, .help = "number of octaves", .whole = true },                          \
        { "persistence",                                                                                     \
          "-",                                                                                               \
          0.794,                                                                                             \
          0.01,                                                                                              \
          0.999,                                                                                             \
          .help = "amplitude ratio of octaves; 0.794 gives slope -5/3 at lacunarity 2, 0.5 a smooth wind" }, \
    {                                                                                                        \
        "lacunarity", "-", 2.0, 1.2, 4.0, .help = "frequency ratio of octaves"                               \
    }

static const struct wf_gust_par cosine_pars[] = { { "period", "s", 20.0, 0.1, 3600.0, .help = "of the gust" },
                                                  { 0 } };
static const struct wf_gust_par sine_perlin_pars[] = {
    { "period", "s", 60.0, 0.1, 3600.0, .help = "of the sine" },
    { "sine-share", "-", 0.5, 0.0, 1.0, .help = "share of the variance that is in the sine" },
    { "noise-period", "s", 20.0, 0.1, 3600.0, .help = "lattice spacing of the first octave" },
    OCTAVE_PARS,
    { 0 }
};
static const struct wf_gust_par zhao_pars[] = {
    { "omega", "rad/frame", 3.14 / 120.0, 1e-4, 3.14, .help = "angular frequency as printed, 3.14/120" },
    { "alpha", "rad", 0.0, -6.2832, 6.2832, .help = "phase as printed" },
    { "epsilon", "m/s", 4.0, 0.0, 20.0, .help = "size of the noise as printed" },
    { "frame-rate", "1/s", 61.0, 0.1, 1000.0,
      .help = "frames a second; the unit of t is not printed, 61 is the paper's rate" },
    { "noise-frames", "frames", 61.0, 1.0, 1e5,
      .help = "spacing of the noise's lattice numbers; not printed" },
    { 0 }
};
static const struct wf_gust_par perlin_pars[] = {
    { "period", "s", 30.0, 0.1, 3600.0, .help = "lattice spacing of the first octave" }, OCTAVE_PARS, { 0 }
};
static const struct wf_gust_par power_pars[] = {
    { "slope", "-", 5.0 / 3.0, 0.0, 3.0, .help = "beta in S ~ 1/f^beta" },
    { "low", "Hz", 1.0 / 600.0, 1e-5, 1.0, .help = "frequency below which S is flat" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par kaimal_pars[] = {
    { "displacement", "m", 0.0, 0.0, 100.0,
      .help = "zero-plane displacement; the spectrum's height is z - d" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par karman_pars[] = {
    { "length", "m", 65.0, 1.0, 1000.0,
      .help = "along-wind integral length of u; 65 m at 10 m over open country" },
    { "share-across", "-", 0.75, 0.1, 1.5, .help = "standard deviation of v over that of u" },
    { "share-up", "-", 0.5, 0.1, 1.5, .help = "standard deviation of w over that of u" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par davenport_pars[] = { COHERENCE_PARS, { 0 } };
static const struct wf_gust_par record_pars[] = { { "rescale", "-", 0.0, 0.0, 1.0,
                                                    .help = "1: scale the record to the specified mean wind",
                                                    .whole = true },
                                                  { 0 } };
static const struct wf_gust_par eog_pars[] = {
    { "start", "s", 5.0, 0.0, 1e6, .help = "when the gust begins" },
    { "duration", "s", 10.5, 1.0, 120.0, .help = "of the gust; 10.5 s in the standard" },
    { "breadth", "m", 5.0, 0.0, 300.0,
      .help = "of what the gust must cover: crown width (rotor diameter in the standard)" },
    { "annual-extreme", "m/s", 0.0, 0.0, 100.0,
      .help = "3-s wind of one year Ve1, which bounds the gust; 0: no bound" },
    { 0 }
};

#define SPECTRAL wf_gust_spectral_open, wf_gust_spectral_fill, wf_gust_spectral_close, false, false

const struct wf_gust_model wf_gust_models[] = {
    { "kaimal", "turbulence with Kaimal spectra",
      "Kaimal J.C. et al. (1972), Q. J. R. Meteorol. Soc. 98:563-589; coherence: Davenport A.G. (1961), "
      "decays: "
      "Solari G., Piccardo G. (2001), Probab. Eng. Mech. 16:73-86",
      "neutral surface layer, open ground, above canopies; Gaussian: real canopy wind is skewed and gustier",
      NULL, 3, "kaimal", kaimal_pars, SPECTRAL },
    { "von-karman", "turbulence with von Karman spectra",
      "von Karman T. (1948), Proc. Natl. Acad. Sci. 34:530-539; ESDU 85020 (1985); coherence: Davenport "
      "(1961)",
      "away from the ground, length scale given; Gaussian", NULL, 3, "von-karman", karman_pars, SPECTRAL },
    { "davenport", "turbulence with the Davenport spectrum",
      "Davenport A.G. (1961), Q. J. R. Meteorol. Soc. 87:194-211",
      "strong near-neutral wind, along the wind only; Gaussian", NULL, 1, "davenport", davenport_pars,
      SPECTRAL },
    { "one-over-f", "noise with a power-law spectrum 1/f^beta", "Voss R.F. (1985), Random fractal forgeries",
      "a substitute where only slope and intensity matter", NULL, 1, "one-over-f", power_pars, SPECTRAL },
    { "cosine", "one cosine, phase drawn once",
      "Tang L., Zou J., Lin D., Chen C. (2012), Trans. Chin. Soc. Agric. Mach. 43(1):165-168",
      "a single gust period; peak factor sqrt(2), a third of that of real wind",
      "the amplitude is sqrt(2) times the turbulence intensity, so that the specified intensity is reached; "
      "the "
      "phase is "
      "drawn once a run (drawn at each step it would be white noise)",
      1, NULL, cosine_pars, direct_open, cosine_fill, NULL, false, false },
    { "sine-perlin", "a sine and gradient noise",
      "Zhao P., Zhang Z. (2013), Comput. Eng. Appl. 49(14):160-163; noise: Perlin K. (2002), ACM Trans. "
      "Graph. 21(3):681-682",
      "a smooth synthetic wind of given intensity",
      "the printed sine swings from 0 to twice the mean (intensity 0.71) and the printed noise shifts the "
      "mean; here "
      "sine and zero-mean noise share the specified variance",
      1, NULL, sine_perlin_pars, direct_open, sine_perlin_fill, NULL, false, false },
    { "sine-perlin-as-printed", "a sine and value noise, as printed",
      "Zhao P., Zhang Z. (2013), Comput. Eng. Appl. 49(14):160-163",
      "reproduces the paper; intensity about 0.7 and a mean above the specified one: not a physical wind",
      NULL, 1, NULL, zhao_pars, direct_open, zhao_fill, NULL, true, false },
    { "perlin", "octaves of gradient noise", "Perlin K. (2002), ACM Trans. Graph. 21(3):681-682",
      "synthetic wind within a fixed range; slope -(1+2H), H = -ln(persistence)/ln(lacunarity), in the band "
      "of the octaves",
      NULL, 1, NULL, perlin_pars, direct_open, perlin_fill, NULL, false, false },
    { "record", "a measured wind", "the user's anemometer file",
      "one point's record at all points, delayed along the wind at its mean speed", NULL, 3, NULL,
      record_pars, record_open, record_fill, NULL, true, true },
    { "eog", "one extreme operating gust", "IEC 61400-1:2005, 6.3.2.2",
      "a designed single gust: a dip, a rise and a dip; intensity taken as the standard's sigma1/U", NULL, 1,
      NULL, eog_pars, direct_open, eog_fill, NULL, false, true },
    { 0 }
};

const struct wf_gust_model *wf_gust_named(const char *name)
{
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++)
        if (strcmp(m->name, name) == 0) return m;
    return NULL;
}

/* Checks of a specification. */

static void check_range(struct wf_diag *d, const char *name, double value, double low, double high,
                        const char *unit)
{
    if (!(value >= low && value <= high))
        wf_diag_error(d, NULL, 0, 0, "%s = %g is outside %g..%g%s%s", name, value, low, high,
                      *unit ? " " : "", unit);
}

static void gust_check_record(const struct wf_gust_spec *s, struct wf_diag *d)
{
    const struct wf_record *r = s->record;
    if (!r) {
        wf_diag_error(d, NULL, 0, 0, "record: needs a file");
        return;
    }
    double length = (double)(r->n - 1) * r->step, asked = (double)(s->steps - 1) * s->step;
    if (asked > length * (1.0 + 1e-9))
        wf_diag_error(d, r->file, 0, 0, "the record lasts %g s, %g s are specified", length, asked);
    if (s->components > 1 && r->components < 3)
        wf_diag_error(d, r->file, 0, 0, "3 components are specified, %u recorded", r->components);
    if (!(r->mean > 0.0)) wf_diag_error(d, r->file, 0, 0, "the recorded mean wind is %g m/s", r->mean);
}

static void gust_check_places(const struct wf_gust_spec *s, struct wf_diag *d)
{
    if (s->points < 1 || s->points > WF_GUST_POINTS_MAX) {
        wf_diag_error(d, NULL, 0, 0, "points = %zu is outside 1..%d", s->points, WF_GUST_POINTS_MAX);
        return;
    }
    if (s->points > 1 && !s->place) {
        wf_diag_error(d, NULL, 0, 0, "%zu points need places", s->points);
        return;
    }
    for (size_t p = 0; p < s->points; p++) {
        double mean = wf_gust_mean(s, p), z = wf_gust_place(s, p, 2);
        if (!(mean > 0.0 && mean <= 120.0))
            wf_diag_error(d, NULL, 0, 0, "point %zu: mean wind %g m/s is outside 0..120 m/s", p, mean);
        if (!(isfinite(wf_gust_place(s, p, 0)) && isfinite(wf_gust_place(s, p, 1)) && z >= 0.0 &&
              z <= 1000.0))
            wf_diag_error(d, NULL, 0, 0, "point %zu: place is not finite or not 0..1000 m above ground", p);
    }
}

static void gust_warn(const struct wf_gust_spec *s, struct wf_diag *d)
{
    const char *name = s->model->name;
    if (s->model->fill == zhao_fill)
        wf_diag_warn(d, "as-printed",
                     "%s: printed sine and noise give an intensity of about 0.7 and shift the mean by "
                     "half the noise",
                     name);
    if (s->model->spectrum && s->intensity > 0.35)
        wf_diag_warn(d, "gaussian",
                     "%s: at intensity %g a Gaussian wind is negative at times; canopy wind is skewed "
                     "instead",
                     name, s->intensity);
    if (strcmp(name, "kaimal") == 0) {
        double lowest = INFINITY, highest = 0.0, displacement = wf_gust_get(s, "displacement");
        for (size_t p = 0; p < s->points; p++) {
            lowest = fmin(lowest, wf_gust_place(s, p, 2) - displacement);
            highest = fmax(highest, wf_gust_place(s, p, 2) - displacement);
        }
        if (lowest < 2.0)
            wf_diag_warn(d, "spectrum-height",
                         "kaimal: points lower than 2 m above the displaced ground take the spectrum of 2 m");
        if (highest > 100.0)
            wf_diag_warn(d, "spectrum-height",
                         "kaimal: points up to %g m are above the surface layer the spectra describe",
                         highest);
    }
}

/* Report all mistakes of a specification, and warn of use outside a model's range. Returned: WF_EUSAGE if
 * there is any mistake. */
static enum wf_status gust_check(const struct wf_gust_spec *s, struct wf_diag *d, struct wf_err *e)
{
    size_t before = d->errors;
    const struct wf_gust_model *m = s->model;
    bool measured = m->fill == record_fill;
    check_range(d, "wind speed", s->speed, 0.1, 120.0, "m/s");
    check_range(d, "height", s->height, 0.1, 1000.0, "m");
    if (!measured)
        check_range(d, "turbulence intensity", s->intensity, 0.0, 1.0, "(standard deviation / mean wind)");
    check_range(d, "step", s->step, 1e-4, 60.0, "s");
    if (s->steps < 2 || s->steps > (size_t)1 << 40)
        wf_diag_error(d, NULL, 0, 0, "steps = %zu is outside 2..2^40", s->steps);
    if (s->components != 1 && s->components != 3)
        wf_diag_error(d, NULL, 0, 0, "components = %u: 1 or 3", s->components);
    if (s->components > m->components)
        wf_diag_error(
            d, NULL, 0, 0,
            "%s gives the wind along its mean direction only; 3 components need kaimal, von-karman or record",
            m->name);
    if (s->block && (s->block < 64 || (s->block & (s->block - 1))))
        wf_diag_error(d, NULL, 0, 0, "block = %zu: a power of two of at least 64 steps", s->block);
    for (size_t i = 0; m->par[i].name; i++)
        check_range(d, m->par[i].name, s->value[i], m->par[i].low, m->par[i].high, m->par[i].unit);
    if (m->spectrum && strcmp(m->spectrum, "one-over-f") == 0 && !(wf_gust_get(s, "low") < 0.5 / s->step))
        wf_diag_error(d, NULL, 0, 0, "low = %g Hz is not below half the sampling frequency, %g Hz",
                      wf_gust_get(s, "low"), 0.5 / s->step);
    gust_check_places(s, d);
    if (measured) gust_check_record(s, d);
    if (d->errors > before)
        return wf_fail(e, WF_EUSAGE, "the specification of the gust model %s has mistakes", m->name);
    gust_warn(s, d);
    return WF_OK;
}

/* Blocks of time. */

void wf_gust_close(struct wf_gust *g)
{
    if (g->spec.model && g->spec.model->close) g->spec.model->close(g);
}

enum wf_status wf_gust_open(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                            struct wf_gust *g, struct wf_err *e)
{
    memset(g, 0, sizeof *g);
    if (gust_check(s, d, e)) return WF_EUSAGE;
    g->spec = *s;
    enum wf_status status = s->model->open(g, a, e);
    if (status) {
        wf_gust_close(g);
        return status;
    }
    g->blocks = (s->steps + g->block - 1) / g->block;
    if (g->joint > 0.05)
        wf_diag_warn(d, "short-window",
                     "%s: eddies longer than the window of %zu steps; neighbouring blocks differ by "
                     "%.1f %% of the standard deviation where they meet",
                     s->model->name, 2 * g->block, 100.0 * g->joint);
    return WF_OK;
}

enum wf_status wf_gust_block(struct wf_gust *g, size_t index, double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    if (index >= g->blocks) return wf_fail(e, WF_EUSAGE, "block %zu of %zu", index, g->blocks);
    size_t first = index * g->block, steps = s->steps - first < g->block ? s->steps - first : g->block;
    memset(out, 0, s->components * s->points * g->block * sizeof *out);
    return s->model->fill(g, first, steps, out, e);
}

enum wf_status wf_gust_history(struct wf_gust *g, size_t point, unsigned component, double *block,
                               double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    if (point >= s->points || component >= s->components)
        return wf_fail(e, WF_EUSAGE, "there is no component %u at point %zu", component, point);
    for (size_t b = 0; b < g->blocks; b++) {
        enum wf_status status = wf_gust_block(g, b, block, e);
        if (status) return status;
        size_t first = b * g->block, steps = s->steps - first < g->block ? s->steps - first : g->block;
        memcpy(out + first, block + (component * s->points + point) * g->block, steps * sizeof *out);
    }
    return WF_OK;
}

/* Targets. */

double wf_gust_target(const struct wf_gust_spec *s, size_t point, enum wf_component c, double f)
{
    if (!s->model->spectrum) return NAN;
    struct wf_spectrum_par p = wf_gust_spectrum_par(s, point);
    return wf_spectrum_named(s->model->spectrum)->density(&p, c, f);
}

double wf_gust_variance(const struct wf_gust_spec *s, size_t point, enum wf_component c)
{
    const struct wf_gust_model *m = s->model;
    double asked = s->intensity * s->speed;
    if (m->spectrum) {
        struct wf_spectrum_par p = wf_gust_spectrum_par(s, point);
        return wf_spectrum_variance(wf_spectrum_named(m->spectrum), &p, c, 0.0, 0.5 / s->step);
    }
    if (c != WF_ALONG || m->fill == record_fill || m->fill == eog_fill) return NAN;
    if (m->fill != zhao_fill) return asked * asked;
    double epsilon = wf_gust_get(s, "epsilon");
    /* variance of value noise between uniform numbers: 181/2772 of the square of its size */
    return 0.5 * s->speed * s->speed + epsilon * epsilon * 181.0 / 2772.0;
}
