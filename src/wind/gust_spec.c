/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/gust_spec.h"
#include "base/num.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void wf_gust_spec_default(const struct wf_gust_model *m, struct wf_gust_spec *s)
{
    *s = (struct wf_gust_spec){ .model = m,
                                .speed = 10.0,
                                .height = 10.0,
                                .intensity = 0.2,
                                .step = 0.1,
                                .steps = 6000,
                                .points = 1,
                                .components = 1,
                                .seed = 1 };
    for (size_t i = 0; m->par[i].name; i++) s->value[i] = m->par[i].fallback;
}

double wf_gust_get(const struct wf_gust_spec *s, const char *name)
{
    for (size_t i = 0; s->model->par[i].name; i++)
        if (strcmp(s->model->par[i].name, name) == 0) return s->value[i];
    return NAN;
}

enum wf_status wf_gust_set(struct wf_gust_spec *s, const char *name, double value, struct wf_err *e)
{
    const struct wf_gust_par *par = s->model->par;
    const char *known[WF_GUST_PARS];
    size_t n = 0;
    for (; par[n].name; n++) {
        known[n] = par[n].name;
        if (strcmp(par[n].name, name) != 0) continue;
        if (!(value >= par[n].low && value <= par[n].high))
            return wf_fail(e, WF_EUSAGE, "%s: %s = %g is outside %g..%g %s (%s)", s->model->name, name, value,
                           par[n].low, par[n].high, par[n].unit, par[n].help);
        if (par[n].whole && value != floor(value))
            return wf_fail(e, WF_EUSAGE, "%s: %s = %g is not a whole number (%s)", s->model->name, name,
                           value, par[n].help);
        s->value[n] = value;
        return WF_OK;
    }
    return wf_fail(e, WF_EUSAGE, "%s: unknown parameter '%s'%s", s->model->name, name,
                   wf_did_you_mean_or(name, known, n, "it has ").text);
}

double wf_gust_place(const struct wf_gust_spec *s, size_t point, int axis)
{
    if (s->place) return s->place[3 * point + (size_t)axis];
    return axis == 2 ? s->height : 0.0;
}

double wf_gust_mean(const struct wf_gust_spec *s, size_t point)
{
    return s->mean ? s->mean[point] : s->speed;
}

/* The spectrum's height counts from the displaced ground; points lower than 2 m get the spectrum of 2 m. */
struct wf_spectrum_par wf_gust_spectrum_par(const struct wf_gust_spec *s, size_t point)
{
    double displacement = wf_gust_get(s, "displacement"), d = isnan(displacement) ? 0.0 : displacement;
    return (struct wf_spectrum_par){ .speed = wf_gust_mean(s, point),
                                     .height = fmax(wf_gust_place(s, point, 2) - d, 2.0),
                                     .deviation = s->intensity * s->speed,
                                     .length = wf_gust_get(s, "length"),
                                     .share = { wf_gust_get(s, "share-across"), wf_gust_get(s, "share-up") },
                                     .slope = wf_gust_get(s, "slope"),
                                     .low = wf_gust_get(s, "low"),
                                     .high = 0.5 / s->step };
}

enum wf_status wf_gust_set_words(struct wf_gust_spec *s, const char *words, struct wf_arena *a,
                                 struct wf_err *e)
{
    char *rest = words ? wf_arena_text(a, words) : NULL;
    bool set[WF_GUST_PARS] = { false };
    if (words && !rest) return wf_fail(e, WF_ENOMEM, "not enough memory for the parameters of a gust model");
    for (char *item; (item = wf_list_item(&rest));) {
        char *equals = strchr(item, '=');
        double value;
        const char *number = equals ? equals + 1 : "",
                   *end = wf_number_read(number, number + strlen(number), '.', &value);
        if (!end || *end)
            return wf_fail(e, WF_EUSAGE, "parameters of %s: '%s': expected name=number", s->model->name,
                           item);
        *equals = '\0';
        enum wf_status status = wf_gust_set(s, item, value, e);
        if (status) return status;
        size_t k = 0;
        while (strcmp(s->model->par[k].name, item) != 0) k++;
        if (set[k]) return wf_fail(e, WF_EUSAGE, "parameters of %s: %s is given twice", s->model->name, item);
        set[k] = true;
    }
    return WF_OK;
}

bool wf_gust_takes_speed(const struct wf_gust_model *m, const char *words)
{
    struct wf_arena a = { 0 };
    struct wf_gust_spec s;
    struct wf_err e = { 0 };
    if (strcmp(m->name, "record") != 0) return true;
    wf_gust_spec_default(m, &s);
    enum wf_status status = wf_gust_set_words(&s, words, &a, &e);
    wf_arena_free(&a);
    return status || wf_gust_get(&s, "rescale") > 0.0;
}

char *wf_gust_words(const struct wf_gust_spec *s, struct wf_arena *a)
{
    char *text = wf_arena_print(a, "intensity=%.6g", s->intensity);
    for (size_t i = 0; text && s->model->par[i].name; i++)
        text = wf_arena_print(a, "%s;%s=%.6g", text, s->model->par[i].name, s->value[i]);
    return text;
}
