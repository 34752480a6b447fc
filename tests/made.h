/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_MADE_H
#define WF_TESTS_MADE_H
/* A species table and a tree model from files, and their analysis. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "load/drag.h"
#include "study/analysis.h"

struct made {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_species species;
    struct wf_model model;
    struct wf_search search;
    struct wf_scenario scenario;
    struct wf_solve_options options;
    struct wf_analysis an;
};

/* Read both; defaults for the rest. */
static inline void made_read(struct made *m, const char *species, const char *model)
{
    *m = (struct made){ .an.species = NULL };
    m->diag.arena = &m->arena;
    if (wf_species_read(species, &wf_laws, &m->arena, &m->species, &m->diag, &m->err) ||
        wf_model_read(model, &m->arena, &m->model, &m->diag, &m->err))
        fail_msg("%s", m->err.text);
    wf_scenario_default(&m->scenario);
    wf_search_default(&m->search);
    wf_solve_options_default(&m->options);
}

static inline enum wf_status made_try(struct made *m, const double *winds, size_t n)
{
    return wf_analyze(&m->species, &m->model, &m->scenario, &m->search, wf_solvers[0], &m->options, winds, n,
                      &m->arena, &m->diag, &m->an, &m->err);
}

static inline void made_analyse(struct made *m, const double *winds, size_t n)
{
    if (made_try(m, winds, n)) fail_msg("%s", m->err.text);
}
#endif
