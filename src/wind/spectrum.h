#ifndef WF_WIND_SPECTRUM_H
#define WF_WIND_SPECTRUM_H
/* One-sided power spectra of the fluctuating wind, S(f) [m2/s] with f in [Hz] and the integral of S over
 * f = 0..infinity equal to the variance of the component. Rows with source and range. */
#include <stddef.h>

enum wf_component { WF_ALONG, WF_ACROSS, WF_UP, WF_COMPONENTS };

struct wf_spectrum_par {
    double speed;      /* mean wind at the point [m/s]                                    */
    double height;     /* above the displaced ground [m]                                  */
    double deviation;  /* standard deviation of the along-wind component [m/s]            */
    double length;     /* along-wind integral length of u [m] (von-karman)                */
    double share[2];   /* standard deviation of v and of w over that of u (von-karman)    */
    double slope, low; /* S ~ f^-slope above `low` [Hz], flat below, none above `high`    */
    double high;       /* [Hz] (one-over-f)                                               */
};

struct wf_spectrum {
    const char *name, *title, *source, *validity;
    unsigned components; /* 1: along the wind only; 3 */
    /* S at frequency f >= 0 [m2/s]; finite at f = 0 */
    double (*density)(const struct wf_spectrum_par *p, enum wf_component c, double f);
    /* standard deviation of a component over that of u [-] */
    double (*ratio)(const struct wf_spectrum_par *p, enum wf_component c);
    /* co-spectrum of u and w [m2/s], one-sided, NULL: none given by the source */
    double (*shear)(const struct wf_spectrum_par *p, double f);
};
extern const struct wf_spectrum
    wf_spectra[]; /* kaimal, von-karman, davenport, one-over-f; ends at name == NULL */
const struct wf_spectrum *wf_spectrum_named(const char *name);

/* Variance between two frequencies [m2/s2], adaptive integration in log f (GSL qag); relative error 1e-8. */
double wf_spectrum_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p, enum wf_component c,
                            double from, double to);
/* Variance of the mean over `window` seconds [m2/s2]: each frequency weighted by sinc^2(f window). */
double wf_spectrum_averaged_variance(const struct wf_spectrum *s, const struct wf_spectrum_par *p,
                                     double window, double to);
#endif
