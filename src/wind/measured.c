#include "wind/measured.h"
#include "base/csv.h"
#include <gsl/gsl_interp.h>
#include <math.h>

enum { HEIGHTS_MAX = 1000 };

enum wf_status wf_measured_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_measured_profile *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors;
    *out = (struct wf_measured_profile){ .z = WF_TAKE(a, HEIGHTS_MAX + 1, double),
                                         .u = WF_TAKE(a, HEIGHTS_MAX + 1, double) };
    if (!out->z || !out->u) return wf_fail(e, WF_ENOMEM, "%s: no room for a profile", path);
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    size_t height = wf_csv_need(&csv, "height_m"), speed = wf_csv_need(&csv, "speed_ms");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a wind profile", path);
    out->n = 1; /* the ground */
    while (wf_csv_next(&csv)) {
        double z, u;
        if (!wf_csv_number(&csv, height, 0.0, 1000.0, &z) || !wf_csv_number(&csv, speed, 0.0, 120.0, &u))
            continue;
        if (out->n > HEIGHTS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d heights", path, HEIGHTS_MAX);
        if (!(z > out->z[out->n - 1]))
            wf_csv_mistake(&csv, height, "%g m is not above %g m, the height before", z, out->z[out->n - 1]);
        out->z[out->n] = z;
        out->u[out->n++] = u;
    }
    if (d->errors == errors && out->n < 3)
        wf_diag_error(d, path, 0, 0, "a profile needs at least two heights above the ground, %zu given",
                      out->n - 1);
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the profile cannot be used", path);
    gsl_interp *curve = gsl_interp_alloc(gsl_interp_steffen, out->n);
    if (!curve) return wf_fail(e, WF_ENOMEM, "%s: no room for a profile", path);
    out->curve = curve;
    return gsl_interp_init(curve, out->z, out->u, out->n) ? wf_fail(e, WF_EINTERNAL, "%s: no curve", path)
                                                          : WF_OK;
}

void wf_measured_close(struct wf_measured_profile *p)
{
    if (p->curve) gsl_interp_free(p->curve);
    p->curve = NULL;
}

static void at_height(const struct wf_measured_profile *p, double z, double *u, double *slope)
{
    *u = z > 0.0 ? p->u[p->n - 1] : 0.0;
    *slope = 0.0;
    if (!(z > 0.0 && z < p->z[p->n - 1])) return;
    gsl_interp_eval_e(p->curve, p->z, p->u, z, NULL, u);
    gsl_interp_eval_deriv_e(p->curve, p->z, p->u, z, NULL, slope);
}

static void sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    const struct wf_measured_profile *p = w->field;
    double reference, unused, here, slope;
    at_height(p, w->reference_height, &reference, &unused);
    at_height(p, x[2], &here, &slope);
    for (int i = 0; i < 3; i++) {
        u[i] = w->speed * here / reference * w->direction[i];
        du[3 * i] = du[3 * i + 1] = 0.0;
        du[3 * i + 2] = w->speed * slope / reference * w->direction[i];
    }
}

enum wf_status wf_measured_blow(const struct wf_measured_profile *p, struct wf_wind *w, struct wf_err *e)
{
    double reference, slope;
    at_height(p, w->reference_height, &reference, &slope);
    if (!(reference > 0.0))
        return wf_fail(e, WF_EINPUT, "the measured profile has no wind at the reference height of %g m",
                       w->reference_height);
    w->sample = sample;
    w->field = p;
    return WF_OK;
}
