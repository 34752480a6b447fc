/* The mean wind in and above a stand: exponential below the canopy top, logarithmic above.
 * Sources: Inoue E. 1963, On the turbulent structure of airflow within crop canopies, J. Meteorol. Soc. Jpn
 * 41:317-326; Cionco R.M. 1965, A mathematical model for air flow in a vegetative canopy, J. Appl. Meteorol.
 * 4:517-522; Thom A.S. 1971 for the log law above. */
#include "wind/wind.h"
#include <math.h>

void wf_canopy_shape(const struct wf_wind *w, double *top, double *attenuation)
{
    double d = w->displacement, h = w->canopy_height > 0.0 ? w->canopy_height : d / 0.7;
    *top = h;
    *attenuation = w->attenuation > 0.0 ? w->attenuation : h / ((h - d) * log((h - d) / w->roughness));
}

/* Speed over friction speed times kappa, and its slope, at height z above the ground. */
static double shape(const struct wf_wind *w, double z, double *slope)
{
    double d = w->displacement, z0 = w->roughness, h, a;
    wf_canopy_shape(w, &h, &a);
    if (z > h) {
        if (z - d <= z0) return *slope = 0.0; /* the calm layer, where there is no stand */
        *slope = 1.0 / (z - d);
        return log((z - d) / z0);
    }
    /* below the ground: that of the ground, without slope */
    double inside = log((h - d) / z0) * exp(-a * (1.0 - fmax(z, 0.0) / h));
    *slope = z >= 0.0 ? inside * a / h : 0.0;
    return inside;
}

void wf_canopy_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    double unused, slope, scale = w->speed / shape(w, w->reference_height, &unused),
                          here = scale * shape(w, x[2], &slope);
    for (int i = 0; i < 3; i++) {
        u[i] = here * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0.0;
        du[3 * i + 2] = scale * slope * w->direction[i];
    }
}
