/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_often.h"
#include "base/num.h"
#include "out/folder.h"
#include "out/reader.h"
#include "wind/annual.h"
#include "wind/extreme.h"
#include <math.h>
#include <string.h>
#include <sys/stat.h>

static double number_of(const json_t *o, const char *key)
{
    const json_t *v = json_object_get(o, key);
    return json_is_number(v) ? json_number_value(v) : (double)NAN;
}

/* The band of a fit; a document whose return periods or bounds do not ascend has none. */
static enum wf_status take_band(const json_t *fit, struct wf_arena *a, struct wf_assess_often *out,
                                struct wf_err *e)
{
    static const char *const keys[] = { "years", "low_m_s", "high_m_s" };
    const json_t *levels = json_object_get(fit, "levels");
    size_t n = json_array_size(levels);
    double *column[3];
    for (size_t c = 0; c < 3; c++)
        if (!(column[c] = WF_TAKE(a, n, double)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for extremes");
    bool ascends = n > 0;
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 3; c++) {
            column[c][i] = number_of(json_array_get(levels, i), keys[c]);
            ascends = ascends && column[c][i] > (i ? column[c][i - 1] : 0);
        }
    if (ascends) out->levels = n, out->years = column[0], out->low = column[1], out->high = column[2];
    return WF_OK;
}

static enum wf_status take_fit(const char *folder, const json_t *o, struct wf_arena *a, struct wf_extreme *x,
                               struct wf_assess_often *out, struct wf_err *e)
{
    const json_t *fit = json_object_get(o, "fit");
    const char *name = json_string_value(json_object_get(json_object_get(o, "schema"), "name"));
    if (!name || strcmp(name, "windfirm-extremes"))
        return wf_fail(e, WF_EINPUT, "--extremes: %s: is no results folder of windfirm wind extremes",
                       folder);
    *x = (struct wf_extreme){ .mode = number_of(fit, "mode"),
                              .scale = number_of(fit, "scale"),
                              .shape = number_of(fit, "shape"),
                              .squared = json_is_true(json_object_get(fit, "squared")) };
    if (!(x->mode > 0 && x->scale > 0 && fabs(x->shape) < 1))
        return wf_fail(e, WF_EINPUT, "--extremes: %s: its fit is no distribution of winds", folder);
    out->extreme = x, out->source = folder;
    return take_band(fit, a, out, e);
}

static enum wf_status read_folder(const char *folder, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_extreme *x, struct wf_assess_often *out, struct wf_err *e)
{
    json_t *o = NULL;
    char *path = wf_arena_print(a, "%s/%s", folder, WF_DOCUMENT);
    if (!path) return wf_fail(e, WF_ENOMEM, "not enough memory for extremes");
    enum wf_status s = wf_document_read(path, &o, d, e);
    if (!s) s = take_fit(folder, o, a, x, out, e);
    json_decref(o);
    return s;
}

static enum wf_status read_maxima(const char *file, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_extreme *x, struct wf_assess_often *out, struct wf_err *e)
{
    static const double years[] = { 1.1, 1.5, 2, 5, 10, 20, 50, 100, 200, 500, 1000 };
    const struct wf_annual_request q = { .begins = 1, .least = 0.9 };
    struct wf_annual sample;
    enum wf_status s = wf_annual_read(file, &q, a, d, &sample, e);
    struct wf_extreme_levels l = { .method = WF_MOMENTS, .count = WF_COUNT(years), .years = years };
    if (!s) s = wf_extreme_fit(WF_MOMENTS, true, sample.speed, sample.used, &l.x, e);
    if (s) return s;
    l.n = sample.used;
    if ((s = wf_extreme_levels_make(&l, a, e))) return s;
    if (sample.used < 20)
        wf_diag_warn(d, "few-years",
                     "%zu annual maxima; with fewer than 20 the band is wide and one storm decides",
                     sample.used);
    *x = l.x;
    out->extreme = x, out->source = file;
    out->levels = l.count, out->years = years, out->low = l.low, out->high = l.high;
    return WF_OK;
}

enum wf_status wf_assess_often_note(const char *path, struct wf_inputs *in, struct wf_err *e)
{
    struct stat is;
    bool folder = !stat(path, &is) && S_ISDIR(is.st_mode);
    const char *file = folder ? wf_arena_print(in->arena, "%s/%s", path, WF_DOCUMENT) : path;
    return file ? wf_inputs_note(in, "extremes", file, e)
                : wf_fail(e, WF_ENOMEM, "not enough memory for extremes");
}

enum wf_status wf_assess_often_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                    struct wf_assess_often *out, struct wf_err *e)
{
    struct stat is;
    struct wf_extreme *x = WF_TAKE(a, 1, struct wf_extreme);
    *out = (struct wf_assess_often){ .extreme = NULL };
    if (!x) return wf_fail(e, WF_ENOMEM, "not enough memory for extremes");
    if (stat(path, &is)) return wf_fail(e, WF_EINPUT, "--extremes: %s: cannot be read", path);
    return S_ISDIR(is.st_mode) ? read_folder(path, a, d, x, out, e) : read_maxima(path, a, d, x, out, e);
}
