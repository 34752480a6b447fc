#ifndef WF_CASES_FLOW_H
#define WF_CASES_FLOW_H
/* What can be wanted of a potential flow (wind/potential.h). Inside the validation runner. */
#include "cases/measure.h"

/* Velocity and pressure coefficient at the point of the want. WF_EINPUT within a cylinder or on a source. */
enum wf_status wf_flow_velocity(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                struct wf_err *e);
enum wf_status wf_flow_cp(const struct wf_measured *m, const struct wf_want *w, double out[3],
                          struct wf_err *e);
/* Keys a flow needs and a case does not give, in words; NULL when nothing is missing. */
const char *wf_flow_missing(const struct wf_case *c);
#endif
