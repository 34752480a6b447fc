#include "wind/measured.h"
#include "base/csv.h"
#include <math.h>

enum { HEIGHTS_MAX = 1000 };

/* Slopes at the points: of the parabola through three neighbours, held to twice the flatter side, so that
 * nothing overshoots (Steffen 1990, eqs 8, 11); of the straight line at the ends. */
static void steffen(struct wf_measured_profile *p)
{
    const double *z = p->z, *u = p->u;
    size_t last = p->n - 1;
    p->slope[0] = (u[1] - u[0]) / (z[1] - z[0]);
    p->slope[last] = (u[last] - u[last - 1]) / (z[last] - z[last - 1]);
    for (size_t i = 1; i < last; i++) {
        double below = z[i] - z[i - 1], above = z[i + 1] - z[i];
        double a = (u[i] - u[i - 1]) / below, b = (u[i + 1] - u[i]) / above;
        double middle = fabs(a * above + b * below) / (below + above);
        p->slope[i] = a * b > 0.0 ? copysign(fmin(2.0 * fmin(fabs(a), fabs(b)), middle), a) : 0.0;
    }
}

enum wf_status wf_measured_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_measured_profile *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors;
    *out = (struct wf_measured_profile){ .z = WF_TAKE(a, HEIGHTS_MAX + 1, double),
                                         .u = WF_TAKE(a, HEIGHTS_MAX + 1, double),
                                         .slope = WF_TAKE(a, HEIGHTS_MAX + 1, double) };
    if (!out->z || !out->u || !out->slope) return wf_fail(e, WF_ENOMEM, "%s: no room for a profile", path);
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
    steffen(out);
    return WF_OK;
}

/* Cubic between neighbours. */
static void at_height(const struct wf_measured_profile *p, double z, double *u, double *slope)
{
    size_t low = 0, high = p->n - 1;
    *u = z > 0.0 ? p->u[high] : 0.0;
    *slope = 0.0;
    if (!(z > 0.0 && z < p->z[high])) return;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(p->z[middle] > z ? &high : &low) = middle;
    }
    double width = p->z[high] - p->z[low], s = p->slope[low], t = z - p->z[low];
    double line = (p->u[high] - p->u[low]) / width;
    double square = (3.0 * line - 2.0 * s - p->slope[high]) / width,
           cube = (s + p->slope[high] - 2.0 * line) / (width * width);
    *u = p->u[low] + t * (s + t * (square + t * cube));
    *slope = s + t * (2.0 * square + 3.0 * t * cube);
}

void wf_measured_sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
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
    w->sample = wf_measured_sample;
    w->field = p;
    return WF_OK;
}
