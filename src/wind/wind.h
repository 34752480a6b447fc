/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_WIND_H
#define WF_WIND_WIND_H
/* The mean wind as a field (velocity and gradient at any point), with profiles as rows, each with source and
 * range; properties of air; measured profiles. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_category;
/* Where a wind was measured. */
struct wf_wind_place {
    const struct wf_category *terrain;
    double height; /* above the ground [m] */
};

/* A design wind (wind/design.h) as the user specifies it. NULL, NAN: not given. */
struct wf_design_words {
    const char *code;    /* row of wf_designs */
    const char *terrain; /* the code's name of it, or the category of EN 1991-1-4 with the same ground */
    const char *region;  /* of AS/NZS 1170.2 */
    double basic;        /* basic wind [m/s] */
    double pressure;     /* in its place: basic wind pressure [Pa] */
    double years;        /* return period */
};

struct wf_wind;
/* Velocity u [m/s] and gradient du[3*i+j] = d u_i / d x_j [1/s] at point x [m]. */
typedef void wf_wind_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9]);

struct wf_wind {
    wf_wind_sample *sample;
    double speed;            /* at reference_height [m/s]; searches change it          */
    double direction[3];     /* unit vector towards which the wind blows               */
    double reference_height; /* [m]                                                    */
    double roughness;        /* z0 [m] (log)                                           */
    double displacement;     /* d [m] (log)                                            */
    double exponent;         /* alpha (power) [-]                                      */
    double least;            /* height below which the speed is constant [m] (terrain, code) */
    double canopy_height;    /* h [m] (canopy); 0: displacement / 0.7                  */
    double attenuation;      /* a [-] (canopy); 0: the value that makes the gradient continuous at the top */
    const void *field;       /* data of a sampler (measured, shelter)                  */
    /* Distance from x along the unit vector t to the next discontinuity of a derivative of the field [m];
     * NULL: the field is smooth. */
    double (*clear)(const struct wf_wind *w, const double x[3], const double t[3]);
};

/* How a field is computed for many states at once: by a formula of wind/wind_kernel.h, or sampled for one
 * state after the other. A profile is a function of height. */
enum wf_profile_form {
    WF_PROFILE_OTHER, /* any field */
    WF_PROFILE_BY_CALL,
    WF_PROFILE_UNIFORM,
    WF_PROFILE_LOG,
    WF_PROFILE_POWER,
    WF_PROFILE_TERRAIN,
    WF_PROFILE_FLOOR
};

struct wf_profile {
    const char *name, *source, *validity;
    wf_wind_sample *sample;
    const char
        *takes; /* its numbers beside the reference height, members of struct wf_wind, with blanks between */
    enum wf_profile_form form; /* the same by lanes */
};
enum wf_profile_form wf_wind_form(const struct wf_wind *w);
/* Canopy profile: height of the canopy top [m] and attenuation [-], as given or derived (see struct wf_wind).
 */
void wf_canopy_shape(const struct wf_wind *w, double *top, double *attenuation);
extern const struct wf_profile
    wf_profiles[]; /* uniform, log, power, terrain, code, canopy, measured; ends at name == NULL */
extern const char *const wf_profile_names[]; /* their names, for a list of choices; ends at NULL */
/* The canopy profile: exponential within a stand, U = U(h) exp(-a (1 - z/h)) up to the canopy top h;
 * logarithmic above. */
wf_wind_sample wf_canopy_sample;
/* The row of that name; NULL when there is none. */
const struct wf_profile *wf_profile_named(const char *name);

/* Where a wind that blows towards `azimuth` (from +x towards +y) comes from, clockwise from north, 0..2 pi,
 * when north is `north` clockwise from +y; and the reverse [rad]. */
double wf_wind_from(double azimuth, double north);
double wf_wind_azimuth(double from, double north);

/* Check a wind, as the samplers do not: speed not negative, direction a unit vector, reference height above
 * the calm layer of the log law, exponent within 0..1, and so on. Errors: WF_EINPUT. */
enum wf_status wf_wind_check(const struct wf_wind *w, struct wf_err *e);

/* Density of dry air [kg m-3] at a temperature [K] and (geopotential) altitude [m], up to 11 km (NAN above).
 * Method: pressure of the International Standard Atmosphere (ISO 2533:1975), ideal gas. */
double wf_air_density(double temperature, double altitude);
/* Kinematic viscosity [m2/s] of air at a temperature [K] and density [kg m-3]: Sutherland's law with the
 * constants of ISO 2533:1975; 100..1900 K. */
double wf_air_viscosity(double temperature, double density);

/* A measured mean wind profile: speeds at heights, from CSV. */
struct wf_measured_profile {
    size_t n;
    double *z, *u; /* ascending [m], [m/s]; the ground at speed 0 is added below the lowest */
    double *slope; /* of the curve at the heights [1/s] */
};

/* Read a profile: columns height_m and speed_ms, at least two heights, ascending. Errors: WF_EINPUT with all
 * mistakes in `d`, WF_ENOMEM. */
enum wf_status wf_measured_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_measured_profile *out, struct wf_err *e);

wf_wind_sample wf_measured_sample; /* w->field is the profile */
/* Give the wind `w` this profile, scaled to w->speed at w->reference_height. Method: between heights a
 * monotone cubic (Steffen M. 1990, Astron. Astrophys. 239:443-450), which has a continuous gradient and no
 * overshoot; above the highest point the speed is constant, below the lowest it decreases to 0 at the ground.
 * The profile must outlive the wind. Errors: WF_EINPUT if the profile's speed at the reference height is 0.
 */
enum wf_status wf_measured_blow(const struct wf_measured_profile *p, struct wf_wind *w, struct wf_err *e);

/* Points for which a wind is computed, from CSV. */
struct wf_points {
    size_t n;
    double *place; /* 3 a point: along the mean wind, across it to the left, above ground [m] */
    double *mean;  /* mean wind there [m/s]; NULL: not in the file                            */
};

/* Read points: columns x_m, y_m, z_m and optionally mean_ms; at most `most` points. Errors: WF_EINPUT with
 * all mistakes in `d`, WF_ENOMEM. */
enum wf_status wf_points_read(const char *path, size_t most, struct wf_arena *a, struct wf_diag *d,
                              struct wf_points *out, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
