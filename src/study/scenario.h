#ifndef WF_STUDY_SCENARIO_H
#define WF_STUDY_SCENARIO_H
/* From the scenario a user names to the wind field and the air. */
#include "base/diag.h"
#include "base/err.h"
#include "study/analysis.h"
#include <math.h>

/* Refuse a scenario that no field can be made of. Returned: WF_OK or WF_EUSAGE. */
enum wf_status wf_scenario_check(const struct wf_scenario *s, struct wf_err *e);
/* A wind profile as asked for. NULL, NAN: not said. */
struct wf_profile_words {
    const char *name, *file; /* row of wf_profiles; heights and speeds of the measured one */
    double reference_height, exponent, roughness, displacement, canopy_height, attenuation;
};
#define WF_PROFILE_UNSAID                                                                                    \
    {                                                                                                        \
        NULL, NULL, NAN, NAN, NAN, NAN, NAN, NAN                                                             \
    }
/* Set the scenario's profile, and read the measured one from its file. What is not said: the power law,
 * "measured" where there is a file; for a stand what follows from its height, d
 * = 0.7 h, z0 = 0.1 h (Garratt 1992, The Atmospheric Boundary Layer, Cambridge University Press, sec. 4.3).
 * Errors: WF_EUSAGE where name and file do not go together, WF_EINPUT with every mistake of the file in `d`.
 */
enum wf_status wf_scenario_profile(struct wf_scenario *s, const struct wf_profile_words *w,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
/* The field of a checked scenario, at speed 0. */
void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out);
/* Speed at the reference height at the tree when the wind named is `named` [m/s]: on an exposed site more. */
double wf_scenario_speed(const struct wf_scenario *s, double named);
struct wf_species;
struct wf_loads;
/* What a checked scenario does to a tree of this species: wind field (at speed 0), air, gravity,
 * streamlining. Returned: *wind, and *loads pointing at it. WF_EINPUT for a streamlining law that does not
 * exist. */
enum wf_status wf_scenario_loads(const struct wf_scenario *s, const struct wf_species *sp,
                                 struct wf_wind *wind, struct wf_loads *loads, struct wf_err *e);
/* Density of the air, given or from temperature and altitude [kg m-3]. */
double wf_scenario_air_density(const struct wf_scenario *s);
#endif
