/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points on a branch's surface and the nodes found from them: grow/kmeans.h. */
#include "fuzz.h"
#include "grow/kmeans.h"
#include <math.h>

static enum wf_status reading(struct fuzz *f)
{
    struct wf_cloud p;
    struct wf_clusters c;
    const double base[3] = { 0 };
    enum wf_status s = wf_cloud_read(f->path, &f->arena, &p, &f->diag, &f->err);
    if (s) return s;
    must(p.n > 0, "a file without points is refused");
    must_be_finite(p.at, 3 * p.n, "places");
    for (size_t i = 0; i < 3 * p.n; i++) must(fabs(p.at[i]) <= 1e4, "places within 10 km");
    if (p.n > 2000 || !fuzz_done(wf_kmeans(&p, 4, 1, base, &f->arena, &c, &f->err), &f->err)) return f->err.code;
    size_t all = 0;
    must_be_finite(c.centre, 12, "centres");
    for (size_t k = 0; k < 4; k++) {
        must(c.count[k] > 0, "no cluster is empty");
        all += c.count[k];
    }
    must(all == p.n, "every point is in a cluster");
    for (size_t i = 0; i < p.n; i++) must(c.of[i] >= 0 && c.of[i] < 4, "of the clusters there are");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
