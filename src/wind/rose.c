#include "wind/rose.h"
#include "base/csv.h"
#include "base/num.h"
#include <math.h>

enum { SECTORS_MAX = 16 };

/* The sector a direction is the middle of; SECTORS_MAX when it is none. */
static size_t sector_of(double degrees, size_t sectors)
{
    double place = degrees / 360.0 * (double)sectors;
    return fabs(place - round(place)) < 0.05 ? (size_t)llround(place) % sectors : SECTORS_MAX;
}

enum wf_status wf_rose_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_rose *out,
                            struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    double row[SECTORS_MAX][4];
    size_t errors = d->errors, n = 0, line[SECTORS_MAX];
    *out = (struct wf_rose){ 0 };
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    static const char *const name[4] = { "direction_deg", "frequency", "weibull_scale_ms", "weibull_shape" };
    static const double low[4] = { 0.0, 0.0, 0.1, 1.0 }, high[4] = { 360.0, 1e9, 40.0, 4.0 };
    size_t column[4];
    for (int k = 0; k < 4; k++) column[k] = wf_csv_need(&csv, name[k]);
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a wind rose", path);
    for (; wf_csv_next(&csv); n++) {
        if (n == SECTORS_MAX) return wf_fail(e, WF_EINPUT, "%s: more than %d directions", path, SECTORS_MAX);
        for (int k = 0; k < 4; k++) wf_csv_number(&csv, column[k], low[k], high[k], &row[n][k]);
        line[n] = csv.row_line;
    }
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    if (n != 8 && n != 12 && n != 16)
        return wf_fail(e, WF_EINPUT, "%s: %zu directions; a rose has 8, 12 or 16", path, n);
    double *all = WF_TAKE(a, 4 * n, double);
    if (!all) return wf_fail(e, WF_ENOMEM, "%s: no room", path);
    *out = (struct wf_rose){ n, all, all + n, all + 2 * n, all + 3 * n, 0.0 };
    for (size_t i = 0; i < n; i++) {
        size_t s = sector_of(row[i][0], n);
        if (s == SECTORS_MAX)
            wf_diag_error(d, path, line[i], 0, "direction_deg: %g is not a multiple of %g", row[i][0],
                          360.0 / (double)n);
        else if (out->scale[s] > 0.0)
            wf_diag_error(d, path, line[i], 0, "direction_deg: %g is given twice", row[i][0]);
        else
            out->from[s] = 2.0 * WF_PI * (double)s / (double)n, out->frequency[s] = row[i][1],
            out->scale[s] = row[i][2], out->shape[s] = row[i][3], out->typed_sum += row[i][1];
    }
    if (d->errors == errors && !(out->typed_sum > 0.0))
        wf_diag_error(d, path, 0, 0, "frequency: all are zero");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the wind rose cannot be used", path);
    for (size_t s = 0; s < n; s++) out->frequency[s] /= out->typed_sum;
    return WF_OK;
}

double wf_rose_sector_above(const struct wf_rose *r, size_t sector, double u)
{
    return u > 0.0 ? exp(-pow(u / r->scale[sector], r->shape[sector])) : 1.0;
}

double wf_rose_above(const struct wf_rose *r, double u)
{
    double sum = 0.0;
    for (size_t s = 0; s < r->sectors; s++) sum += r->frequency[s] * wf_rose_sector_above(r, s, u);
    return sum;
}

double wf_rose_mean(const struct wf_rose *r)
{
    double sum = 0.0;
    for (size_t s = 0; s < r->sectors; s++)
        sum += r->frequency[s] * r->scale[s] * tgamma(1.0 + 1.0 / r->shape[s]);
    return sum;
}

double wf_rose_speed(const struct wf_rose *r, double share)
{
    double low = 0.0, high = 1.0;
    while (wf_rose_above(r, high) > share) high *= 2.0;
    while (high - low > 1e-9) {
        double middle = 0.5 * (low + high);
        if (wf_rose_above(r, middle) > share)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}
