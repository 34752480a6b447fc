#ifndef WF_STUDY_SCENARIO_H
#define WF_STUDY_SCENARIO_H
/* From the scenario a user names to the wind field and the air. */
#include "base/err.h"
#include "study/analysis.h"

/* Refuse a scenario that no field can be made of. Returned: WF_OK or WF_EUSAGE. */
enum wf_status wf_scenario_check(const struct wf_scenario *s, struct wf_err *e);
/* The field of a checked scenario, at speed 0. */
void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out);
/* Density of the air, given or from temperature and altitude [kg m-3]. */
double wf_scenario_air_density(const struct wf_scenario *s);
#endif
