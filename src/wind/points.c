#include "wind/points.h"
#include "base/csv.h"
#include <string.h>

enum wf_status wf_points_read(const char *path, size_t most, struct wf_arena *a, struct wf_diag *d,
                              struct wf_points *out, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    size_t errors = d->errors, n = 0;
    *out = (struct wf_points){ .place = WF_TAKE(a, 3 * most, double), .mean = WF_TAKE(a, most, double) };
    if (!out->place || !out->mean) return wf_fail(e, WF_ENOMEM, "%s: no room for points", path);
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    const size_t column[3] = { wf_csv_need(&csv, "x_m"), wf_csv_need(&csv, "y_m"), wf_csv_need(&csv, "z_m") };
    size_t mean = wf_csv_column(&csv, "mean_ms");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a list of points", path);
    for (; wf_csv_next(&csv); n++) {
        if (n == most) return wf_fail(e, WF_EINPUT, "%s: more than %zu points", path, most);
        for (size_t k = 0; k < 3; k++)
            wf_csv_number(&csv, column[k], k == 2 ? 0.0 : -1e5, k == 2 ? 1000.0 : 1e5,
                          &out->place[3 * n + k]);
        if (mean != WF_CSV_NONE) wf_csv_number(&csv, mean, 0.01, 120.0, &out->mean[n]);
    }
    if (d->errors == errors && !n) wf_diag_error(d, path, 0, 0, "no points");
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: the points cannot be used", path);
    out->n = n;
    if (mean == WF_CSV_NONE) out->mean = NULL;
    return WF_OK;
}
