/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Annual maxima from tables and records: wind/annual.h. */
#include "fuzz.h"
#include "wind/annual.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f)
{
    const struct wf_annual_request q = { NULL, NULL, WF_DATES_UNSAID, 7, 0.5 };
    struct wf_annual x;
    bool record = f->size && f->data[0] == 't'; /* "time,..." */
    enum wf_status s = record ? wf_annual_from_record(f->path, &q, &f->arena, &f->diag, &x, &f->err)
                              : wf_annual_read(f->path, &q, &f->arena, &f->diag, &x, &f->err);
    if (s) return s;
    size_t used = 0;
    for (size_t i = 0; i < x.n; i++) {
        must(i == 0 || x.year[i].year > x.year[i - 1].year, "years ascend");
        used += x.year[i].used;
    }
    must(used == x.used, "used years are counted");
    for (size_t i = 0; i < x.used; i++) must(x.speed[i] > 0 && isfinite(x.speed[i]), "a wind is above 0");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
