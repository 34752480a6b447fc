/* What a gust specification must keep to, and making it ready. */
#include "wind/gust_rows.h"
#include <math.h>
#include <string.h>

static void within(struct wf_diag *d, const char *name, double value, double low, double high,
                   const char *unit)
{
    if (!(value >= low && value <= high))
        wf_diag_error(d, NULL, 0, 0, "%s = %g is outside %g..%g%s%s", name, value, low, high,
                      *unit ? " " : "", unit);
}

static void check_record(const struct wf_gust_spec *s, struct wf_diag *d)
{
    const struct wf_record *r = s->record;
    if (!r) {
        wf_diag_error(d, NULL, 0, 0, "record: needs a file");
        return;
    }
    double length = (double)(r->n - 1) * r->step, asked = (double)(s->steps - 1) * s->step;
    if (asked > length * (1.0 + 1e-9))
        wf_diag_error(d, r->file, 0, 0, "the record lasts %g s, %g s are asked for", length, asked);
    if (s->components > 1 && r->components < 3)
        wf_diag_error(d, r->file, 0, 0, "3 components are asked for, %u recorded", r->components);
    if (!(r->mean > 0.0)) wf_diag_error(d, r->file, 0, 0, "the recorded mean wind is %g m/s", r->mean);
}

static void check_places(const struct wf_gust_spec *s, struct wf_diag *d)
{
    if (s->points < 1 || s->points > WF_GUST_POINTS_MAX) {
        wf_diag_error(d, NULL, 0, 0, "points = %zu is outside 1..%d", s->points, WF_GUST_POINTS_MAX);
        return;
    }
    if (s->points > 1 && !s->place) {
        wf_diag_error(d, NULL, 0, 0, "%zu points need places", s->points);
        return;
    }
    for (size_t p = 0; p < s->points; p++) {
        double mean = wf_gust_mean(s, p), z = wf_gust_place(s, p, 2);
        if (!(mean > 0.0 && mean <= 120.0))
            wf_diag_error(d, NULL, 0, 0, "point %zu: mean wind %g m/s is outside 0..120 m/s", p, mean);
        if (!(isfinite(wf_gust_place(s, p, 0)) && isfinite(wf_gust_place(s, p, 1)) && z >= 0.0 &&
              z <= 1000.0))
            wf_diag_error(d, NULL, 0, 0, "point %zu: place is not finite or not 0..1000 m above ground", p);
    }
}

static void warn(const struct wf_gust_spec *s, struct wf_diag *d)
{
    const char *name = s->model->name;
    if (s->model->fill == wf_gust_zhao_fill)
        wf_diag_warn(d, "as-printed",
                     "%s: printed sine and noise give an intensity of about 0.7 and shift the mean by "
                     "half the noise",
                     name);
    if (s->model->spectrum && s->intensity > 0.35)
        wf_diag_warn(d, "gaussian",
                     "%s: at intensity %g a Gaussian wind blows backwards at times; canopy wind is skewed "
                     "instead",
                     name, s->intensity);
    if (strcmp(name, "kaimal") == 0) {
        double lowest = INFINITY, highest = 0.0, displacement = wf_gust_get(s, "displacement");
        for (size_t p = 0; p < s->points; p++) {
            lowest = fmin(lowest, wf_gust_place(s, p, 2) - displacement);
            highest = fmax(highest, wf_gust_place(s, p, 2) - displacement);
        }
        if (lowest < 2.0)
            wf_diag_warn(d, "spectrum-height",
                         "kaimal: points lower than 2 m above the displaced ground take the spectrum of 2 m");
        if (highest > 100.0)
            wf_diag_warn(d, "spectrum-height",
                         "kaimal: points up to %g m are above the surface layer the spectra describe",
                         highest);
    }
}

enum wf_status wf_gust_check(const struct wf_gust_spec *s, struct wf_diag *d, struct wf_err *e)
{
    size_t before = d->errors;
    const struct wf_gust_model *m = s->model;
    bool measured = m->fill == wf_gust_record_fill;
    within(d, "wind speed", s->speed, 0.1, 120.0, "m/s");
    within(d, "height", s->height, 0.1, 1000.0, "m");
    if (!measured)
        within(d, "turbulence intensity", s->intensity, 0.0, 1.0, "(standard deviation / mean wind)");
    within(d, "step", s->step, 1e-4, 60.0, "s");
    if (s->steps < 2 || s->steps > (size_t)1 << 40)
        wf_diag_error(d, NULL, 0, 0, "steps = %zu is outside 2..2^40", s->steps);
    if (s->components != 1 && s->components != 3)
        wf_diag_error(d, NULL, 0, 0, "components = %u: 1 or 3", s->components);
    if (s->components > m->components)
        wf_diag_error(
            d, NULL, 0, 0,
            "%s gives the wind along its mean direction only; 3 components need kaimal, von-karman or record",
            m->name);
    if (s->block && (s->block < 64 || (s->block & (s->block - 1))))
        wf_diag_error(d, NULL, 0, 0, "block = %zu: a power of two of at least 64 steps", s->block);
    for (size_t i = 0; m->par[i].name; i++)
        within(d, m->par[i].name, s->value[i], m->par[i].low, m->par[i].high, m->par[i].unit);
    if (m->spectrum && strcmp(m->spectrum, "one-over-f") == 0 && !(wf_gust_get(s, "low") < 0.5 / s->step))
        wf_diag_error(d, NULL, 0, 0, "low = %g Hz is not below half the sampling frequency, %g Hz",
                      wf_gust_get(s, "low"), 0.5 / s->step);
    check_places(s, d);
    if (measured) check_record(s, d);
    if (d->errors > before) return wf_fail(e, WF_EUSAGE, "the gust model %s cannot be run as asked", m->name);
    warn(s, d);
    return WF_OK;
}

enum wf_status wf_gust_open(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                            struct wf_gust *g, struct wf_err *e)
{
    memset(g, 0, sizeof *g);
    if (wf_gust_check(s, d, e)) return WF_EUSAGE;
    g->spec = *s;
    enum wf_status status = s->model->open(g, a, e);
    if (status) {
        wf_gust_close(g);
        return status;
    }
    g->blocks = (s->steps + g->block - 1) / g->block;
    if (g->joint > 0.05)
        wf_diag_warn(d, "short-window",
                     "%s: eddies longer than the window of %zu steps; neighbouring blocks differ by "
                     "%.1f %% of the standard deviation where they meet",
                     s->model->name, 2 * g->block, 100.0 * g->joint);
    return WF_OK;
}

enum wf_status wf_gust_series(struct wf_gust *g, size_t point, unsigned component, double *block, double *out,
                              struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    if (point >= s->points || component >= s->components)
        return wf_fail(e, WF_EUSAGE, "there is no component %u at point %zu", component, point);
    for (size_t b = 0; b < g->blocks; b++) {
        enum wf_status status = wf_gust_block(g, b, block, e);
        if (status) return status;
        size_t first = b * g->block, steps = s->steps - first < g->block ? s->steps - first : g->block;
        memcpy(out + first, block + (component * s->points + point) * g->block, steps * sizeof *out);
    }
    return WF_OK;
}
