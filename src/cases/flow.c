#include "cases/flow.h"
#include "wind/potential.h"
#include <math.h>
#include <string.h>

static double or_zero(double v) { return isnan(v) ? 0.0 : v; }

const char *wf_flow_missing(const struct wf_case *c)
{
    if (strcmp(c->flow, "cylinder") == 0)
        return isnan(c->flow_speed) ? "speed" : isnan(c->flow_radius) ? "cylinder_radius" : NULL;
    if (isnan(c->flow_strength)) return "strength";
    return strcmp(c->flow, "finite-line-source") == 0 && isnan(c->flow_segment[0]) ? "segment" : NULL;
}

enum wf_status wf_flow_velocity(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                struct wf_err *e)
{
    const struct wf_case *c = m->of;
    const double *x = w->at.point;
    out[2] = 0.0;
    if (strcmp(c->flow, "cylinder") == 0) {
        if (hypot(x[0], x[1]) < c->flow_radius)
            return wf_fail(e, WF_EINPUT, "%s:%zu: the point lies inside the cylinder", c->file, w->line);
        wf_flow_cylinder(c->flow_speed, c->flow_radius, or_zero(c->flow_circulation), x, out);
    } else if (strcmp(c->flow, "line-source") == 0) {
        wf_flow_line_source(c->flow_strength, x, out);
    } else if (strcmp(c->flow, "point-source") == 0) {
        wf_flow_point_source(c->flow_strength, x, out);
    } else {
        wf_flow_segment_source(c->flow_strength, c->flow_segment[0], c->flow_segment[1], x, out);
    }
    if (!isfinite(out[0] + out[1] + out[2]))
        return wf_fail(e, WF_EINPUT, "%s:%zu: the point lies on the source", c->file, w->line);
    return WF_OK;
}

enum wf_status wf_flow_cp(const struct wf_measured *m, const struct wf_want *w, double out[3],
                          struct wf_err *e)
{
    double u[3];
    if (strcmp(m->of->flow, "cylinder") != 0 || m->of->flow_speed == 0.0)
        return wf_fail(e, WF_EINPUT, "%s:%zu: a pressure coefficient needs a stream: flow cylinder, speed",
                       m->of->file, w->line);
    if (wf_flow_velocity(m, w, u, e)) return e->code;
    out[0] = wf_flow_pressure(m->of->flow_speed, u);
    return WF_OK;
}
