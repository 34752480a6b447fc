/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured wind profiles and lists of points: wind/wind.h. */
#include "fuzz.h"
#include "wind/gust.h"
#include "wind/wind.h"
#include <math.h>

static enum wf_status profile(struct fuzz *f)
{
    struct wf_measured_profile p;
    struct wf_wind w = { .speed = 10, .reference_height = 10 };
    struct wf_err e = { 0 };
    enum wf_status s = wf_measured_read(f->path, &f->arena, &f->diag, &p, &f->err);
    if (s) return s;
    must(p.n >= 2, "a profile has two heights");
    must_be_finite(p.slope, p.n, "slopes are finite");
    for (size_t i = 0; i < p.n; i++)
        must(isfinite(p.z[i]) && isfinite(p.u[i]) && p.u[i] >= 0 && (!i || p.z[i] > p.z[i - 1]),
             "heights ascend");
    if (!fuzz_done(wf_measured_blow(&p, &w, &e), &e)) return WF_OK;
    for (int i = 0; i <= 20; i++) {
        double x[3] = { 0, 0, 2.0 * i }, u[3], du[9];
        wf_measured_sample(&w, x, u, du);
        must_be_finite(u, 3, "the wind is finite");
        must_be_finite(du, 9, "its gradient is finite");
    }
    return WF_OK;
}

static enum wf_status points(struct fuzz *f)
{
    struct wf_points p;
    enum wf_status s = wf_points_read(f->path, WF_GUST_POINTS_MAX, &f->arena, &f->diag, &p, &f->err);
    if (s) return s;
    must(p.n > 0 && p.n <= WF_GUST_POINTS_MAX, "points are counted");
    must_be_finite(p.place, 3 * p.n, "places are finite");
    must_be_finite(p.mean, p.n, "means are finite");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_read(data, size, profile);
    return fuzz_read(data, size, points);
}
