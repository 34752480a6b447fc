#include "wind/gust.h"
#include "base/near.h"
#include "wind/gust_rows.h"
#include "wind/noise.h"
#include <math.h>
#include <string.h>

#define COHERENCE_PARS                                                                                       \
    { "decay-along", "-", 3.0, 0.0, 100.0, "coherence decay for separation along the wind" },                \
        { "decay-across", "-", 10.0, 0.0, 100.0, "coherence decay for separation across the wind" },         \
        { "decay-up", "-", 10.0, 0.0, 100.0, "coherence decay for separation in height" },                   \
    {                                                                                                        \
        "coherence-length", "m", 0.0, 0.0, 5000.0,                                                           \
            "length Lc of the second term of IEC 61400-1; 0: Davenport's form, full coherence at 0 Hz"       \
    }
#define OCTAVE_PARS                                                                                          \
    { "octaves", "-", 6.0, 1.0, 16.0, "number of octaves" },                                                 \
        { "persistence",                                                                                     \
          "-",                                                                                               \
          0.794,                                                                                             \
          0.01,                                                                                              \
          0.999,                                                                                             \
          "amplitude ratio of octaves; 0.794 gives slope -5/3 at lacunarity 2, 0.5 a smooth wind" },         \
    {                                                                                                        \
        "lacunarity", "-", 2.0, 1.2, 4.0, "frequency ratio of octaves"                                       \
    }

static const struct wf_gust_par cosine_pars[] = { { "period", "s", 20.0, 0.1, 3600.0, "of the gust" },
                                                  { 0 } };
static const struct wf_gust_par sine_perlin_pars[] = {
    { "period", "s", 60.0, 0.1, 3600.0, "of the sine" },
    { "sine-share", "-", 0.5, 0.0, 1.0, "share of the variance that is in the sine" },
    { "noise-period", "s", 20.0, 0.1, 3600.0, "lattice spacing of the first octave" },
    OCTAVE_PARS,
    { 0 }
};
static const struct wf_gust_par zhao_pars[] = {
    { "omega", "rad/frame", 3.14 / 120.0, 1e-4, 3.14, "angular frequency as printed, 3.14/120" },
    { "alpha", "rad", 0.0, -6.2832, 6.2832, "phase as printed" },
    { "epsilon", "m/s", 4.0, 0.0, 20.0, "size of the noise as printed" },
    { "frame-rate", "1/s", 61.0, 0.1, 1000.0,
      "frames a second; the unit of t is not printed, 61 is the paper's rate" },
    { "noise-frames", "frames", 61.0, 1.0, 1e5, "spacing of the noise's lattice numbers; not printed" },
    { 0 }
};
static const struct wf_gust_par perlin_pars[] = {
    { "period", "s", 30.0, 0.1, 3600.0, "lattice spacing of the first octave" }, OCTAVE_PARS, { 0 }
};
static const struct wf_gust_par power_pars[] = {
    { "slope", "-", 5.0 / 3.0, 0.0, 3.0, "beta in S ~ 1/f^beta" },
    { "low", "Hz", 1.0 / 600.0, 1e-5, 1.0, "frequency below which S is flat" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par kaimal_pars[] = {
    { "displacement", "m", 0.0, 0.0, 100.0, "zero-plane displacement; the spectrum's height is z - d" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par karman_pars[] = {
    { "length", "m", 65.0, 1.0, 1000.0, "along-wind integral length of u; 65 m at 10 m over open country" },
    { "share-across", "-", 0.75, 0.1, 1.5, "standard deviation of v over that of u" },
    { "share-up", "-", 0.5, 0.1, 1.5, "standard deviation of w over that of u" },
    COHERENCE_PARS,
    { 0 }
};
static const struct wf_gust_par davenport_pars[] = { COHERENCE_PARS, { 0 } };
static const struct wf_gust_par record_pars[] = {
    { "rescale", "-", 0.0, 0.0, 1.0, "1: scale the record to the mean wind asked for" }, { 0 }
};
static const struct wf_gust_par eog_pars[] = {
    { "start", "s", 5.0, 0.0, 1e6, "when the gust begins" },
    { "duration", "s", 10.5, 1.0, 120.0, "of the gust; 10.5 s in the standard" },
    { "breadth", "m", 5.0, 0.0, 300.0,
      "of what the gust must cover: crown width (rotor diameter in the standard)" },
    { "annual-extreme", "m/s", 0.0, 0.0, 100.0,
      "3-s wind of one year Ve1, which bounds the gust; 0: no bound" },
    { 0 }
};

#define SPECTRAL wf_gust_spectral_open, wf_gust_spectral_fill, wf_gust_spectral_close

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
      "a stand-in where only slope and intensity matter", NULL, 1, "one-over-f", power_pars, SPECTRAL },
    { "cosine", "one cosine, phase drawn once",
      "Tang L., Zou J., Lin D., Chen C. (2012), Trans. Chin. Soc. Agric. Mach. 43(1):165-168",
      "a single gust period; peak factor sqrt(2), a third of the wind's own",
      "the amplitude is sqrt(2) times the turbulence intensity, so that the intensity asked for is met; the "
      "phase is "
      "drawn once a run (drawn at each step it would be white noise)",
      1, NULL, cosine_pars, wf_gust_direct_open, wf_gust_cosine_fill, NULL },
    { "sine-perlin", "a sine and gradient noise",
      "Zhao P., Zhang Z. (2013), Comput. Eng. Appl. 49(14):160-163; noise: Perlin K. (2002), ACM Trans. "
      "Graph. 21(3):681-682",
      "a smooth synthetic wind of given intensity",
      "the printed sine swings from 0 to twice the mean (intensity 0.71) and the printed noise shifts the "
      "mean; here "
      "sine and zero-mean noise share the variance asked for",
      1, NULL, sine_perlin_pars, wf_gust_direct_open, wf_gust_sine_perlin_fill, NULL },
    { "sine-perlin-as-printed", "a sine and value noise, as printed",
      "Zhao P., Zhang Z. (2013), Comput. Eng. Appl. 49(14):160-163",
      "reproduces the paper; intensity about 0.7 and a mean above the one asked for: not a physical wind",
      NULL, 1, NULL, zhao_pars, wf_gust_direct_open, wf_gust_zhao_fill, NULL },
    { "perlin", "octaves of gradient noise", "Perlin K. (2002), ACM Trans. Graph. 21(3):681-682",
      "synthetic wind within a fixed range; slope -(1+2H), H = -ln(persistence)/ln(lacunarity), in the band "
      "of the octaves",
      NULL, 1, NULL, perlin_pars, wf_gust_direct_open, wf_gust_perlin_fill, NULL },
    { "record", "a measured wind", "the user's anemometer file",
      "one point's record at all points, carried along at its mean speed", NULL, 3, NULL, record_pars,
      wf_gust_record_open, wf_gust_record_fill, NULL },
    { "eog", "one extreme operating gust", "IEC 61400-1:2005, 6.3.2.2",
      "a designed single gust: a dip, a rise and a dip; intensity taken as the standard's sigma1/U", NULL, 1,
      NULL, eog_pars, wf_gust_direct_open, wf_gust_eog_fill, NULL },
    { 0 }
};

const struct wf_gust_model *wf_gust_named(const char *name)
{
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++)
        if (strcmp(m->name, name) == 0) return m;
    return NULL;
}

void wf_gust_spec_default(const struct wf_gust_model *m, struct wf_gust_spec *s)
{
    *s = (struct wf_gust_spec){ .model = m,
                                .speed = 10.0,
                                .height = 10.0,
                                .intensity = 0.2,
                                .step = 0.1,
                                .steps = 6000,
                                .points = 1,
                                .components = 1,
                                .seed = 1 };
    for (size_t i = 0; m->par[i].name; i++) s->value[i] = m->par[i].fallback;
}

double wf_gust_get(const struct wf_gust_spec *s, const char *name)
{
    for (size_t i = 0; s->model->par[i].name; i++)
        if (strcmp(s->model->par[i].name, name) == 0) return s->value[i];
    return NAN;
}

enum wf_status wf_gust_set(struct wf_gust_spec *s, const char *name, double value, struct wf_err *e)
{
    const struct wf_gust_par *par = s->model->par;
    const char *known[WF_GUST_PARS];
    char list[512] = "";
    size_t n = 0;
    for (; par[n].name; n++) {
        known[n] = par[n].name;
        if (n) strncat(list, ", ", sizeof list - strlen(list) - 1);
        strncat(list, par[n].name, sizeof list - strlen(list) - 1);
        if (strcmp(par[n].name, name) != 0) continue;
        if (!(value >= par[n].low && value <= par[n].high))
            return wf_fail(e, WF_EUSAGE, "%s: %s = %g is outside %g..%g %s (%s)", s->model->name, name, value,
                           par[n].low, par[n].high, par[n].unit, par[n].help);
        s->value[n] = value;
        return WF_OK;
    }
    const char *near = wf_nearest(name, known, n);
    if (near)
        return wf_fail(e, WF_EUSAGE, "%s: unknown parameter '%s'; did you mean '%s'?", s->model->name, name,
                       near);
    return wf_fail(e, WF_EUSAGE, "%s: unknown parameter '%s'; it has %s", s->model->name, name, list);
}

/* The spectrum's height is above the displaced ground; close to it and below, that of 2 m. */
struct wf_spectrum_par wf_gust_spectrum_par(const struct wf_gust_spec *s, size_t point)
{
    double displacement = wf_gust_get(s, "displacement"), d = isnan(displacement) ? 0.0 : displacement;
    return (struct wf_spectrum_par){ .speed = wf_gust_mean(s, point),
                                     .height = fmax(wf_gust_place(s, point, 2) - d, 2.0),
                                     .deviation = s->intensity * s->speed,
                                     .length = wf_gust_get(s, "length"),
                                     .share = { wf_gust_get(s, "share-across"), wf_gust_get(s, "share-up") },
                                     .slope = wf_gust_get(s, "slope"),
                                     .low = wf_gust_get(s, "low"),
                                     .high = 0.5 / s->step };
}

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
    if (c != WF_ALONG || m->fill == wf_gust_record_fill || m->fill == wf_gust_eog_fill) return NAN;
    if (m->fill != wf_gust_zhao_fill) return asked * asked;
    double epsilon = wf_gust_get(s, "epsilon");
    /* value noise between uniform numbers: variance 181/2772 of its size squared */
    return 0.5 * s->speed * s->speed + epsilon * epsilon * 181.0 / 2772.0;
}

enum wf_status wf_gust_block(struct wf_gust *g, size_t index, double *out, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    if (index >= g->blocks) return wf_fail(e, WF_EUSAGE, "block %zu of %zu", index, g->blocks);
    size_t first = index * g->block, steps = s->steps - first < g->block ? s->steps - first : g->block;
    memset(out, 0, s->components * s->points * g->block * sizeof *out);
    return s->model->fill(g, first, steps, out, e);
}

void wf_gust_close(struct wf_gust *g)
{
    if (g->spec.model && g->spec.model->close) g->spec.model->close(g);
}
