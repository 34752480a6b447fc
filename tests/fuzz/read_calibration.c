/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calibrations: fit/calibration.h. */
#include "fit/calibration.h"
#include "fuzz.h"
#include <math.h>

static void check_test(const struct wf_calibration_test *t)
{
    struct wf_scenario scene;
    struct wf_err e = { 0 };
    must(t->name && t->name[0], "a test has a name");
    must_be_finite(t->pull.load, t->pull.loads, "loads are finite");
    must_be_finite(t->wind.speed, t->wind.speeds, "speeds are finite");
    for (size_t i = 0; i < t->sensors; i++) must(t->sensor[i].name != NULL, "a sensor has a name");
    if (t->wind.given && fuzz_done(wf_calibration_wind_scene(&t->wind, &scene, &e), &e))
        must(isfinite(scene.reference_height) && isfinite(scene.speed_up), "a scene is finite");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_calibration c;
    enum wf_status s = wf_calibration_read(f->path, &f->arena, &c, &f->diag, &f->err);
    if (s) return s;
    must(c.key && c.trees > 0 && c.tests > 0, "a calibration has key, trees and tests");
    for (size_t i = 0; i < c.tests; i++) check_test(&c.test[i]);
    for (size_t i = 0; i < c.frees; i++) must(c.free[i].parameter != NULL, "what is free has a name");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
