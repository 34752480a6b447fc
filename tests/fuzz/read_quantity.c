/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities ("10 GPa", base/units.h), and the other short texts of a command line: winds by a scale, places,
 * parameters of a gust model. */
#include "base/units.h"
#include "fuzz.h"
#include "wind/climate.h"
#include "wind/gust.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void one_dimension(struct wf_units *u, const char *text, enum wf_dimension d)
{
    struct wf_err e = { 0 };
    double si = NAN, again = NAN;
    char buf[128];
    const char *unit = d == WF_DIM_NONE ? "" : wf_dimension_row(d)->si;
    (void)wf_quantity_in(u, 2, d, text);
    (void)wf_quantity_print(u, 2, d, text, buf, sizeof buf);
    if (!fuzz_done(wf_quantity_read(u, text, d, &si, &e), &e)) return;
    must(isfinite(si), "a quantity is finite");
    wf_quantity_print(u, si, d, unit, buf, sizeof buf);
    must(!wf_quantity_read(u, buf, d, &again, &e), "what was printed can be read");
    must(fabs(again - si) <= 1e-5 * fabs(si), "what was printed is the quantity");
}

static void words(const char *text, struct wf_arena *a)
{
    struct wf_err e = { 0 }, other = { 0 };
    struct wf_scale_wind wind;
    double x = NAN, y = NAN;
    (void)wf_wind_scale_is(text);
    if (fuzz_done(wf_wind_scale_parse(text, &wind, &e), &e))
        must(isfinite(wind.speed) && wind.speed >= 0, "a grade has a speed");
    if (wf_site_place(text, &x, &y)) must(isfinite(x) && isfinite(y), "a place is finite");
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++) {
        struct wf_gust_spec s;
        other = (struct wf_err){ 0 };
        wf_gust_spec_default(m, &s);
        if (fuzz_done(wf_gust_set_words(&s, text, a, &other), &other))
            must_be_finite(s.value, WF_GUST_PARS, "parameters of a gust are finite");
    }
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_units *u;
    char *text = malloc(f->size + 1);
    must(text && !wf_units_open(&u, &f->err), "units");
    memcpy(text, f->data, f->size);
    text[f->size] = '\0';
    for (int d = 0; d < WF_DIM_COUNT; d++) one_dimension(u, text, (enum wf_dimension)d);
    words(text, &f->arena);
    wf_units_close(u);
    free(text);
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    return size > 4096 ? 0 : fuzz_read(data, size, reading);
}
