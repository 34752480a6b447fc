#ifndef WF_WIND_MEASURED_H
#define WF_WIND_MEASURED_H
/* A mean wind profile as it was measured: speeds at heights, from CSV. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "wind/wind.h"

struct wf_measured_profile {
    size_t n;
    double *z, *u; /* ascending [m], [m/s]; the ground at speed 0 is added below the lowest */
    double *slope; /* of the curve at the heights [1/s] */
};

/* Read columns height_m and speed_ms, at least two heights. Every bad cell is a finding; heights must ascend.
 */
enum wf_status wf_measured_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_measured_profile *out, struct wf_err *e);

wf_wind_sample wf_measured_sample; /* w->field is the profile */
/* Make `w` blow with this shape: w->speed is the speed at w->reference_height. Between heights a monotone
 * cubic (Steffen M. 1990, Astron. Astrophys. 239:443-450) so that nothing overshoots and the gradient is
 * continuous; above the highest the speed there, below the lowest down to 0 at the ground. WF_EINPUT where
 * the profile has no wind at the reference height. The profile must outlive the wind. */
enum wf_status wf_measured_blow(const struct wf_measured_profile *p, struct wf_wind *w, struct wf_err *e);
#endif
