/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_SERIES_CASES_H
#define WF_TESTS_SERIES_CASES_H
/* Runs in time for tests: a species and a model, words as in a file of runs. */
#include "base/file.h"
#include "load/drag.h"
#include "close.h"
#include "study/series_plan.h"
#include <math.h>
#include <stdio.h>

struct made {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_species species;
    struct wf_model model;
    struct wf_series_plan_run run;
    struct wf_series_spec spec;
    struct wf_series series;
};

static inline void start(struct made *m, const char *species, const char *model)
{
    *m = (struct made){ 0 };
    m->diag.arena = &m->arena;
    m->run = (struct wf_series_plan_run){ .name = "run",
                                          .wind = 10,
                                          .intensity = NAN,
                                          .period = NAN,
                                          .duration = NAN,
                                          .step = 0.5,
                                          .youngs = NAN,
                                          .restoring = NAN,
                                          .damping = NAN,
                                          .transmission = NAN,
                                          .profile = WF_PROFILE_UNSAID,
                                          .leaf_amplitude = NAN,
                                          .leaf_follow = NAN,
                                          .leaf_period = NAN,
                                          .keys = 1,
                                          .seed = 1 };
    if (wf_species_read(species, &wf_laws, &m->arena, &m->species, &m->diag, &m->err)) fail_msg("%s", m->err.text);
    if (wf_model_read(model, &m->arena, &m->model, &m->diag, &m->err)) fail_msg("%s", m->err.text);
}

static inline enum wf_status try(struct made *m)
{
    m->err = (struct wf_err){ 0 };
    enum wf_status s = wf_series_plan_spec(&m->run, &m->species, &m->model, &m->arena, &m->spec, &m->err);
    return s ? s : wf_series_run(&m->spec, &m->arena, &m->diag, &m->series, &m->err);
}

/* Lines of a file of a results folder. */
static inline size_t lines(const char *folder, const char *name, struct wf_arena *a)
{
    char path[400];
    struct wf_bytes b;
    struct wf_err e = { 0 };
    size_t n = 0;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (wf_file_read(path, a, &b, &e)) fail_msg("%s", e.text);
    for (size_t i = 0; i < b.size; i++) n += b.data[i] == '\n';
    return n;
}
#endif
