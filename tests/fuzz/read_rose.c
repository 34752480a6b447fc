/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wind roses: wind/climate.h. */
#include "fuzz.h"
#include "wind/climate.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f)
{
    struct wf_rose r;
    double sum = 0;
    enum wf_status s = wf_rose_read(f->path, &f->arena, &f->diag, &r, &f->err);
    if (s) return s;
    must(r.sectors == 8 || r.sectors == 12 || r.sectors == 16, "8, 12 or 16 sectors");
    for (size_t i = 0; i < r.sectors; i++) {
        must(fabs(r.from[i] - 2 * M_PI * (double)i / (double)r.sectors) < 1e-3,
             "sectors go round from north");
        must(r.frequency[i] >= 0, "a share is not negative");
        must(r.calm[i] >= 0 && r.calm[i] <= 1, "a share of calms");
        if (r.frequency[i] > 0)
            must(r.scale[i] >= 0.1 && r.scale[i] <= 40 && r.shape[i] >= 1 && r.shape[i] <= 4,
                 "A and k in range");
        sum += r.frequency[i];
    }
    must(fabs(sum - 1) < 1e-9, "the shares add up to 1");
    double mean = wf_rose_mean(&r), u = wf_rose_speed(&r, 0.01);
    must(isfinite(mean) && mean >= 0 && isfinite(u) && u >= 0, "its speeds are finite");
    must(wf_rose_above(&r, 1e-3) < 0.01 || fabs(wf_rose_above(&r, u) - 0.01) < 1e-6,
         "the speed is exceeded as often as was said");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
