/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of runs in time: study/series_plan.h. */
#include "fuzz.h"
#include "study/series_plan.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f)
{
    struct wf_series_plan p;
    enum wf_status s = wf_series_plan_read(f->path, &f->arena, &p, &f->diag, &f->err);
    if (s) return s;
    must(p.runs > 0, "a plan has runs");
    for (size_t i = 0; i < p.runs; i++) {
        struct wf_series_spec spec;
        struct wf_err e = { 0 };
        must(p.run[i].name && p.run[i].species && p.run[i].model, "a run has name, species and model");
        if (!fuzz_done(wf_series_plan_spec(&p.run[i], fuzz_species("weeping_willow"), fuzz_culm(), &f->arena,
                                           &spec, &e),
                       &e))
            continue;
        must(isfinite(spec.speed) && spec.speed >= 0 && spec.step > 0 && spec.frames > 0, "a run has frames");
        must(spec.keys > 0, "a run has key frames");
    }
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
