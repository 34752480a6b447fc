/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wind records: wind/record.h, as a sonic with a time column, a cup without one, and with wide tolerances. */
#include "fuzz.h"
#include "wind/record.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f, const struct wf_record_request *q)
{
    struct wf_record r;
    enum wf_status s = wf_record_read(f->path, q, &f->arena, &f->diag, &r, &f->err);
    if (s) return s;
    must(r.n > 0 && r.step > 0 && isfinite(r.step), "a record has steps");
    must(isfinite(r.mean) && r.mean >= 0 && isfinite(r.azimuth) && isfinite(r.tilt), "its mean is finite");
    must_be_finite(r.u, r.n, "u is finite");
    must_be_finite(r.v, r.v ? r.n : 0, "v is finite");
    must_be_finite(r.w, r.w ? r.n : 0, "w is finite");
    must(r.unreadable <= r.rows && r.missing <= r.n && r.longest <= r.missing, "gaps are counted");
    return WF_OK;
}

static enum wf_status sonic(struct fuzz *f)
{
    struct wf_record_request q;
    wf_record_request_default(&q);
    return reading(f, &q);
}

static enum wf_status cup(struct fuzz *f)
{
    struct wf_record_request q;
    wf_record_request_default(&q);
    q.time = NULL;
    q.step = 0.1;
    q.part[1] = q.part[2] = NULL;
    return reading(f, &q);
}

static enum wf_status gaps(struct fuzz *f)
{
    struct wf_record_request q;
    wf_record_request_default(&q);
    q.part[2] = NULL;
    q.bad_share = 0.5;
    q.gap = 1000;
    return reading(f, &q);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_read(data, size, sonic);
    fuzz_read(data, size, cup);
    return fuzz_read(data, size, gaps);
}
