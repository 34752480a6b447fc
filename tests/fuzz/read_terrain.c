/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids of heights: wind/terrain.h. */
#include "fuzz.h"
#include "wind/terrain.h"
#include <math.h>

static void use(struct fuzz *f, const struct wf_terrain *t)
{
    struct wf_speedup_request q = { .from = 1, .height = 10, .roughness = 0.1 };
    struct wf_speedup up;
    struct wf_err e = { 0 };
    double seen = NAN, topex = wf_terrain_topex(t, t->columns / 2, t->rows / 2, 1000, &seen);
    must(!isinf(topex), "topex is no infinity");
    must(seen >= 0 && seen <= 1, "seen is a share");
    if (fuzz_done(wf_terrain_speedup(t, &q, &f->arena, &up, &e), &e))
        must_be_finite(up.ds, t->rows * t->columns, "the speed-up is finite");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_terrain t;
    enum wf_status s = wf_terrain_read(f->path, &f->arena, &t, &f->err);
    if (s) return s;
    must(t.columns >= 2 && t.columns <= WF_TERRAIN_MAX && t.rows >= 2 && t.rows <= WF_TERRAIN_MAX, "sizes");
    must(isfinite(t.cell) && t.cell > 0 && isfinite(t.x0) && isfinite(t.y0), "a grid has a place");
    for (size_t i = 0; i < t.rows * t.columns; i++) must(!isinf(t.z[i]), "heights are numbers or no data");
    double z = wf_terrain_height(&t, t.x0, t.y0);
    must(isnan(z) || fabs(z - t.z[0]) <= 1e-9 * fabs(t.z[0]) + 1e-9, "the height at a point is the point's");
    (void)wf_terrain_height(&t, 1e300, -1e300);
    if (t.rows * t.columns <= 4096) use(f, &t);
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
