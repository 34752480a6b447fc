/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_SCENE_H
#define WF_LOAD_SCENE_H
/* From a user's scenario and a species to wind field, air properties and loads. Studies, fits and validation
 * cases all use these functions, so that the same input gives the same loads. */
#include "base/diag.h"
#include "base/err.h"
#include "data/species.h"
#include "load/load.h"
#include "wind/wind.h"
#include <math.h>

struct wf_site; /* wind/terrain.h */
struct wf_scenario {
    const char *profile;                        /* row of wf_profiles */
    const struct wf_measured_profile *measured; /* data of the profile "measured" */
    const char *profile_file;                   /* file that `measured` was read from */
    double reference_height;                    /* height of the named wind speeds [m] */
    double speed_up; /* ratio of the wind at the tree to the named wind, at every height: exposure of the site
                        [-] */
    const struct wf_site *site; /* terrain from which speed_up was computed; NULL: speed_up was given */
    double roughness, displacement,
        exponent; /* [m], [m], [-]: of the log and canopy, log and canopy, power profile */
    double canopy_height, attenuation; /* [m], [-]: of the canopy profile; 0: derived, see wind/wind.h */
    double azimuth;                    /* direction the wind blows towards, from +x towards +y [rad] */
    double temperature, altitude;      /* [K], [m] */
    double air_density;                /* [kg m-3]; NAN: from temperature and altitude */
    double gravity;
    double speed_max;       /* highest speed of the search for the critical wind speed [m/s] */
    const char *shelter;    /* name in wf_shelter_laws by which the tree shelters itself; NULL: no shelter */
    const char *winds_said; /* in words, how the given wind speeds were converted to 10-min means; NULL: no
                               conversion */
};
/* Defaults: power law 0.16 at 10 m, wind towards +x, 15 C, sea level, 9.81 m/s2, search up to 100 m/s. */
void wf_scenario_default(struct wf_scenario *s);

/* Check that a wind field can be made of a scenario. Errors: WF_EUSAGE naming the value and its allowed
 * range. */
enum wf_status wf_scenario_check(const struct wf_scenario *s, struct wf_err *e);
/* A wind profile as the user specifies it. NULL, NAN: not given. */
struct wf_profile_words {
    const char *name, *file; /* row of wf_profiles; heights and speeds of the measured one */
    double reference_height, exponent, roughness, displacement, canopy_height, attenuation;
};
#define WF_PROFILE_UNSAID                                                                                    \
    {                                                                                                        \
        NULL, NULL, NAN, NAN, NAN, NAN, NAN, NAN                                                             \
    }
/* Set the scenario's profile and, for a measured profile, read its file. Defaults of what is not given: the
 * power law, or "measured" where a file is given; for the canopy profile, d = 0.7 h and z0 = 0.1 h from the
 * canopy height h (Garratt 1992, The Atmospheric Boundary Layer, Cambridge University Press, sec. 4.3).
 * Errors: WF_EUSAGE where name and file do not agree; WF_EINPUT with every mistake of the file in `d`;
 * WF_ENOMEM. */
enum wf_status wf_scenario_profile(struct wf_scenario *s, const struct wf_profile_words *w,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
/* Wind field of a checked scenario, with speed 0. */
void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out);
/* Wind speed at the tree at the reference height, given the named speed [m/s]: the named speed times
 * speed_up. */
double wf_scenario_speed(const struct wf_scenario *s, double named);
/* Loads of a checked scenario on a tree of this species: wind field (speed 0), air, gravity, drag laws.
 * Returned: *wind, and *loads, which points to *wind. Errors: WF_EINPUT for an unknown law. */
enum wf_status wf_scenario_loads(const struct wf_scenario *s, const struct wf_species *sp,
                                 struct wf_wind *wind, struct wf_loads *loads, struct wf_err *e);
/* Air density [kg m-3]: as given, else from temperature and altitude. */
double wf_scenario_air_density(const struct wf_scenario *s);
#endif
