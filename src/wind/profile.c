/* Mean wind profiles: one row each. All blow in one direction everywhere; the speed depends on height alone.
 */
#include "wind/measured.h"
#include <math.h>
#include <string.h>

/* Velocity and gradient from speed and d speed / dz at a height. */
static void blow(const struct wf_wind *w, double speed, double slope, double u[3], double du[9])
{
    for (int i = 0; i < 3; i++) {
        u[i] = speed * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0;
        du[3 * i + 2] = slope * w->direction[i];
    }
}

static void uniform(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    (void)x;
    blow(w, w->speed, 0, u, du);
}

/* The gradient jumps at z = d + z0, where the speed is zero: forces go with the square of the speed and
 * keep a continuous derivative there. */
static void logarithmic(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double z = x[2] - w->displacement, speed = 0, slope = 0;
    if (z > w->roughness) {
        double scale = w->speed / log((w->reference_height - w->displacement) / w->roughness);
        speed = scale * log(z / w->roughness);
        slope = scale / z;
    }
    blow(w, speed, slope, u, du);
}

/* (z/h)^a has an infinite gradient at the ground. Below a ten-thousandth of the reference height (1 mm at
 * 10 m) the parabola with the same value and slope there and zero at the ground takes its place. */
static void power(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double a = w->exponent, low = 1e-4 * w->reference_height, z = x[2], speed = 0, slope = 0;
    if (z >= low) {
        speed = w->speed * pow(z / w->reference_height, a);
        slope = a * speed / z;
    } else if (z > 0) {
        double s = z / low, top = w->speed * pow(1e-4, a);
        speed = top * s * (2 - a - (1 - a) * s);
        slope = top * (2 - a - 2 * (1 - a) * s) / low;
    }
    blow(w, speed, slope, u, du);
}

const struct wf_profile wf_profiles[] = {
    { "uniform", "the same speed at every height", "wind tunnels, comparisons; not the wind over ground",
      uniform },
    { "log",
      "Tennekes H. 1973. The logarithmic wind profile. J. Atmos. Sci. 30:234-238; zero-plane displacement: "
      "Thom A.S. "
      "1971. Momentum absorption by vegetation. Q. J. R. Meteorol. Soc. 97:414-428",
      "neutral or strong wind over level ground, from about d + 20 z0 up to 100 m; calm below d + z0",
      logarithmic },
    { "power",
      "Davenport A.G. 1960. Rationale for determining design wind velocities. J. Struct. Div. ASCE "
      "86(5):39-68",
      "strong wind over level ground, 1 m to 300 m; exponent 0.10 (water) to 0.40 (town), 0.16 open country",
      power },
    { "canopy",
      "Cionco R.M. 1965. A mathematical model for air flow in a vegetative canopy. J. Appl. Meteorol. "
      "4:517-522; above: "
      "Thom A.S. 1971. Q. J. R. Meteorol. Soc. 97:414-428",
      "closed level stands of even height, neutral or strong wind; attenuation 0.3 (open) to 4 (dense); not "
      "the "
      "second maximum among bare trunks below about 0.3 of the height",
      wf_canopy_sample },
    { "measured",
      "the heights and speeds of the file named; between them a monotone cubic: Steffen M. 1990. Astron. "
      "Astrophys. "
      "239:443-450",
      "between the lowest and the highest height measured; below them the speed goes to 0 at the ground, "
      "above it "
      "stays",
      wf_measured_sample },
    { NULL, NULL, NULL, NULL }
};

const struct wf_profile *wf_profile_named(const char *name)
{
    for (const struct wf_profile *p = wf_profiles; name && p->name; p++)
        if (strcmp(p->name, name) == 0) return p;
    return NULL;
}

enum wf_status wf_wind_check(const struct wf_wind *w, struct wf_err *e)
{
    const double *n = w->direction, size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(w->speed >= 0 && isfinite(w->speed)))
        return wf_fail(e, WF_EINPUT, "wind speed %g m/s: must be finite and not negative", w->speed);
    if (!(fabs(size - 1) <= 1e-9))
        return wf_fail(e, WF_EINPUT, "wind direction of length %.12g: must be a unit vector", size);
    if (w->sample == logarithmic) {
        if (!(w->roughness > 0))
            return wf_fail(e, WF_EINPUT, "roughness length %g m: must be positive", w->roughness);
        if (!(w->displacement >= 0))
            return wf_fail(e, WF_EINPUT, "zero-plane displacement %g m: must not be negative",
                           w->displacement);
        if (!(w->reference_height > w->displacement + w->roughness))
            return wf_fail(
                e, WF_EINPUT,
                "reference height %g m lies within the calm layer of the log profile: must be above "
                "displacement + roughness = %g m",
                w->reference_height, w->displacement + w->roughness);
    }
    if (w->sample == wf_canopy_sample) {
        double h = w->canopy_height > 0 ? w->canopy_height : w->displacement / 0.7;
        if (!(w->roughness > 0 && w->displacement >= 0 && (h == 0 || h > w->displacement + w->roughness)))
            return wf_fail(
                e, WF_EINPUT,
                "canopy of %g m with displacement %g m and roughness length %g m: the roughness must be "
                "positive and displacement + roughness lie below the canopy top",
                h, w->displacement, w->roughness);
        if (!(w->attenuation >= 0 && w->attenuation <= 10 && w->reference_height > 0))
            return wf_fail(e, WF_EINPUT, "canopy attenuation %g, reference height %g m: 0..10, above 0 m",
                           w->attenuation, w->reference_height);
    }
    if (w->sample == wf_measured_sample && !w->field)
        return wf_fail(e, WF_EINPUT, "the measured profile needs a file of heights and speeds");
    if (w->sample == power) {
        if (!(w->reference_height > 0))
            return wf_fail(e, WF_EINPUT, "reference height %g m: must be positive", w->reference_height);
        if (!(w->exponent >= 0 && w->exponent <= 1))
            return wf_fail(e, WF_EINPUT, "power-law exponent %g: must be within 0..1", w->exponent);
    }
    return WF_OK;
}
