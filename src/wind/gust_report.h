#ifndef WF_WIND_GUST_REPORT_H
#define WF_WIND_GUST_REPORT_H
/* A gust model run once and looked at: does it do what it was asked to? */
#include "wind/gust.h"
#include "wind/gust_stats.h"
#include "wind/spectrum_estimate.h"

enum { WF_REPORT_BANDS = 96, WF_REPORT_BINS = 40 };

/* One property that was asked for and what came out. */
struct wf_gust_finding {
    const char *name, *unit;
    double asked, got;
    double scatter; /* one standard error of `got` in a series of this length; NAN: none given */
    bool within;    /* |got - asked| <= 4 scatter plus a slack for spectra                       */
};
enum { WF_GUST_FINDINGS = 12 };

struct wf_gust_report {
    struct wf_gust_spec spec;
    double *x; /* [(c * points + p) * steps + i] velocity [m/s]               */
    struct wf_gust_stats stats[WF_COMPONENTS];
    double joint, coherence_error; /* of the synthesis; NAN where they do not apply              */
    size_t bands;
    struct wf_band band[WF_REPORT_BANDS];
    /* first point, by component and band [m2/s]; target NAN without one */
    double density[WF_COMPONENTS][WF_REPORT_BANDS], target[WF_COMPONENTS][WF_REPORT_BANDS];
    double scatter[WF_REPORT_BANDS]; /* relative standard error of a band's density: sqrt(1.94 / bins), Hann
                                        taper */
    double bin_low, bin_width;       /* histogram of the first point's along-wind speed [m/s]     */
    size_t bin[WF_REPORT_BINS];
    size_t pairs; /* points but the first, against the first                      */
    size_t pair_bands;
    struct wf_band pair_band[WF_REPORT_BANDS];
    double *coherence;        /* pairs * pair_bands: real root-coherence [-]                  */
    double *coherence_target; /* exp(-r g(f)), NAN for models without one                     */
    double *apart;            /* pairs: distance from the first point [m]                     */
    size_t findings;
    struct wf_gust_finding finding[WF_GUST_FINDINGS];
};

/* Run the model over all its steps, holding the series (points * components * steps numbers), and measure it.
 */
enum wf_status wf_gust_report_make(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_gust_report *out, struct wf_err *e);
/* Root-coherence a spectral model aims at between two points at frequency f [Hz]; NAN for other models. */
double wf_gust_coherence_target(const struct wf_gust_spec *s, size_t p, size_t q, double f);
/* Coherence error of the synthesis at its worst frequency: see wf_coherence_error; NAN for other models. */
double wf_gust_coherence_error(const struct wf_gust *g, struct wf_arena *a);
#endif
