/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tree models: data/model.h. */
#include "data/model.h"
#include "fuzz.h"
#include <math.h>

static void check_along(const struct wf_along *a)
{
    must_be_finite(a->v, a->n, "a table along an axis is finite");
    for (size_t i = 0; i < a->n; i++)
        must(a->s[i] >= 0 && a->s[i] <= 1 && (!i || a->s[i] > a->s[i - 1]), "places along an axis ascend");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_model m;
    enum wf_status s = wf_model_read(f->path, &f->arena, &m, &f->diag, &f->err);
    if (s) return s;
    must(m.key && m.name, "a model has key and name");
    must(wf_model_levels(&m) >= 1, "a model has levels");
    must(isfinite(m.lean) && isfinite(m.leaf_area) && m.leaf_area >= 0, "numbers of a model are finite");
    must(isnan(m.crown_base) || m.crown_base < m.crown_top, "a crown has a height");
    check_along(&m.profile);
    check_along(&m.crown_shape);
    if (m.generator == WF_GENERATOR_STEM && !m.sections) {
        must(m.height > 0 && isfinite(m.height) && m.segments > 0, "a stem has a height");
        for (int i = 0; i <= 8; i++) must(wf_model_taper(&m, i / 8.0) > 0, "a stem is thick everywhere");
    }
    wf_model_set_season(&m, WF_LEAF_OFF);
    must(m.leaf_area == 0, "no leaves in winter");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
