/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured data of tests: fit/test_data.h, with a column of times, without one, and with declared marks. */
#include "fit/test_data.h"
#include "fuzz.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f, const struct wf_column *column, size_t columns,
                              const struct wf_test_rows *how)
{
    struct wf_test_data r;
    enum wf_status s = wf_test_data_read(f->path, column, columns, how, &f->arena, &r, &f->diag, &f->err);
    if (s) return s;
    must(r.n > 0 && r.columns == columns, "measured data have rows");
    must_be_finite(r.time, r.n, "times are finite");
    must_be_finite(r.value, r.n * columns, "readings are finite");
    for (size_t i = 1; i < r.n; i++)
        must(r.time[i] >= r.time[i - 1] && r.line[i] > r.line[i - 1], "time goes on");
    return WF_OK;
}

static enum wf_status pull(struct fuzz *f)
{
    static const struct wf_column column[] = { { "force_kN", NULL, WF_DIM_FORCE },
                                               { "tilt", "deg", WF_DIM_ANGLE } };
    const struct wf_test_rows how = { .time = "time", .rate = NAN };
    return reading(f, column, 2, &how);
}

static enum wf_status wind(struct fuzz *f)
{
    static const struct wf_column column[] = { { "u_ms", NULL, WF_DIM_SPEED },
                                               { "strain_um_m", NULL, WF_DIM_NONE } };
    const struct wf_test_rows how = { .time = "time", .rate = NAN, .dates = WF_DATES_MONTH_FIRST };
    return reading(f, column, 2, &how);
}

static enum wf_status sway(struct fuzz *f)
{
    static const struct wf_column column[] = { { "tilt", NULL, WF_DIM_NONE } };
    const struct wf_test_rows how = { .rate = 20, .missing = "-99.9,7" };
    return reading(f, column, 1, &how);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_read(data, size, pull);
    fuzz_read(data, size, wind);
    return fuzz_read(data, size, sway);
}
