#ifndef WF_WIND_WIND_H
#define WF_WIND_WIND_H
/* The mean wind as a field: velocity and its gradient anywhere. Rows, each with source and range. */
#include "base/err.h"
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
    double canopy_height;    /* h [m] (canopy); 0: displacement / 0.7                  */
    double attenuation;      /* a [-] (canopy); 0: the one that joins the log law smoothly */
    const void *field;       /* other fields' own data                                 */
    /* Distance from x along the unit vector t to the next place where a derivative of the field jumps [m];
     * NULL: it is smooth everywhere. */
    double (*clear)(const struct wf_wind *w, const double x[3], const double t[3]);
};

struct wf_profile {
    const char *name, *source, *validity;
    wf_wind_sample *sample;
};
/* Canopy profile: height of the canopy top [m] and attenuation [-] in use, given or derived (see struct
 * wf_wind). */
void wf_canopy_shape(const struct wf_wind *w, double *top, double *attenuation);
extern const struct wf_profile
    wf_profiles[]; /* uniform, log, power, canopy, measured; ends at name == NULL */
/* Exponential within a stand, logarithmic above: U = U(h) exp(-a (1 - z/h)) up to the canopy top h. */
wf_wind_sample wf_canopy_sample;
/* The row of that name; NULL when there is none. */
const struct wf_profile *wf_profile_named(const char *name);

/* Refuse what a profile cannot sample: speed negative, direction not a unit vector, reference height within
 * the calm layer of the log law, exponent outside 0..1. The samplers themselves check nothing. */
enum wf_status wf_wind_check(const struct wf_wind *w, struct wf_err *e);

/* Air density [kg m-3] of dry air at a temperature [K] and (geopotential) altitude [m], up to 11 km (NAN
 * above): pressure of the International Standard Atmosphere (ISO 2533:1975), ideal gas. */
double wf_air_density(double temperature, double altitude);
/* Kinematic viscosity [m2/s] of air at a temperature [K] and density [kg m-3]: Sutherland's law with the
 * constants of ISO 2533:1975; 100..1900 K. */
double wf_air_viscosity(double temperature, double density);
#endif
