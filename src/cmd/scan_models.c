/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/scan_models.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "cmd/commands.h"
#include "study/verdict.h"
#include <math.h>
#include <stdio.h>

struct models_range {
    size_t weak, first_weak;    /* models that fail without wind, and the first of them      */
    size_t n, found, lowest;    /* models; with a critical speed; the model with the lowest, from 1 */
    double speed[2], height[2]; /* least and most [m/s], [m] */
};

/* The critical wind is that of the headline: the tree is lost. */
static void range_add(struct models_range *r, size_t number, const struct wf_analysis *an)
{
    struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_critical *c = &v.loss->critical;
    double height = an->tallness;
    r->height[0] = r->n ? fmin(r->height[0], height) : height;
    r->height[1] = r->n ? fmax(r->height[1], height) : height;
    r->n++;
    if (c->outcome == WF_CRITICAL_SELF_WEIGHT && !r->weak++) r->first_weak = number;
    if (c->outcome != WF_CRITICAL_FOUND) return;
    if (!r->found || c->speed < r->speed[0]) r->speed[0] = c->speed, r->lowest = number;
    r->speed[1] = r->found ? fmax(r->speed[1], c->speed) : c->speed;
    r->found++;
}

/* Analyse model `number` with each species; model 1 has been. */
static enum wf_status analyse_model(const struct wf_scan_models *w, size_t number, struct models_range *range,
                                    struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_tree_asked asked = *w->tree;
    struct wf_model model;
    const char *path;
    asked.scan.scan_model = wf_arena_print(&a, "%zu", number);
    enum wf_status s = asked.scan.scan_model ? wf_tree_asked_read(&asked, NULL, &a, &model, &path, &d, e)
                                             : wf_fail(e, WF_ENOMEM, "no memory for model %zu", number);
    for (size_t k = 0; !s && k < w->n; k++) {
        struct wf_analysis an;
        wf_stage_item(number, w->models);
        s = wf_analyze(&w->species[k], &model, w->scenario, w->search, w->solver, w->solve, w->wind->speed,
                       w->wind->n, &a, &d, &an, e);
        if (!s && !wf_interrupted()) range_add(&range[k], number, &an);
    }
    wf_progress_clear();
    wf_arena_free(&a);
    return s;
}

/* The range becomes a warning of each species, so that terminal, results and pages have it. */
static void warn_of_range(const struct models_range *r, size_t models, const char *species, struct wf_diag *d)
{
    char speeds[256], weak[96] = "", others[96] = "";
    size_t none = r->n - r->found - r->weak;
    if (r->weak)
        (void)snprintf(weak, sizeof weak, "; %zu of them fail under their own weight, first model %zu",
                       r->weak, r->first_weak);
    if (none) (void)snprintf(others, sizeof others, "; for %zu of them none was found", none);
    if (r->found)
        (void)snprintf(speeds, sizeof speeds,
                       "critical wind speed %.2f to %.2f m/s, lowest of model %zu (--scan-model %zu)",
                       r->speed[0], r->speed[1], r->lowest, r->lowest);
    else
        (void)snprintf(speeds, sizeof speeds, "no critical wind speed found");
    wf_diag_warn(
        d, "scan-models",
        "%s: over %zu of %zu models of the scan: %s%s%s, height %.2f to %.2f m; all other results are "
        "those of model 1",
        species, r->n, models, speeds, weak, others, r->height[0], r->height[1]);
}

enum wf_status wf_scan_models_analyse(const struct wf_scan_models *w, struct wf_arena *a, struct wf_err *e)
{
    struct models_range *range = WF_TAKE(a, w->n, struct models_range);
    if (!range) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu species", w->n);
    for (size_t k = 0; k < w->n; k++) range_add(&range[k], 1, &w->first[k]);
    for (size_t m = 2; m <= w->models && !wf_interrupted(); m++) {
        enum wf_status s = analyse_model(w, m, range, e);
        if (s) return s;
    }
    for (size_t k = 0; k < w->n; k++) warn_of_range(&range[k], w->models, w->species[k].name, &w->diag[k]);
    return WF_OK;
}
