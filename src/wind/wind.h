#ifndef WF_WIND_WIND_H
#define WF_WIND_WIND_H
/* The mean wind as a field: velocity and its gradient anywhere. Rows, each with source and range. */
#include <stddef.h>

struct wf_wind;
/* Velocity u [m/s] and gradient du[3*i+j] = d u_i / d x_j [1/s] at point x [m]. */
typedef void wf_wind_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9]);

struct wf_wind {
    wf_wind_sample *sample;
    double speed;            /* at reference_height [m/s]; scaled by searches          */
    double direction[3];     /* unit vector the wind blows towards                     */
    double reference_height; /* [m]                                                    */
    double roughness;        /* z0 [m] (log)                                           */
    double displacement;     /* d [m] (log)                                            */
    double exponent;         /* alpha (power) [-]                                      */
    const void *field;       /* other fields' own data                                 */
};

struct wf_profile {
    const char *name, *source, *validity;
    wf_wind_sample *sample;
};
extern const struct wf_profile wf_profiles[];  /* uniform, log, power; ends at name == NULL */
const struct wf_profile *wf_profile_named(const char *name);

/* Air density [kg m-3] of dry air at a temperature [K] and altitude [m]: International Standard
 * Atmosphere pressure, ideal gas. */
double wf_air_density(double temperature, double altitude);
#endif
