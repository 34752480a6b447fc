#ifndef WF_CMD_WIND_SPEED_H
#define WF_CMD_WIND_SPEED_H
/* A mean wind as typed: a speed with a unit, a plain number of m/s, or a grade of a scale. */
#include "base/err.h"
#include <stdio.h>

/* Given: "12", "43 km/h", "beaufort:8", "cma:typhoon"; the averaging law that brings a grade to a 10-min
 * mean; a stream for a line saying what a grade was taken as, or NULL. Returned: *speed, the 10-min mean
 * [m/s]. */
enum wf_status wf_wind_speed_read(const char *text, const char *law, FILE *to, double *speed,
                                  struct wf_err *e);
#endif
