/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_POST_H
#define WF_TESTS_POST_H
/* A uniform solid post without leaves and weight, in an even steady wind; everything has a source. */
#include "close.h"
#include "data/model.h"
#include "data/species.h"
#include "solve/solve.h"
#include "study/analysis.h"
#include <string.h>

#define POST_STRENGTH 40e6
#define POST_YOUNGS 8e9
#define POST_AIR 1.2

static inline struct wf_value measured(double v)
{
    return (struct wf_value){
        .value = v, .low = v, .high = v, .standing = WF_MEASURED, .source = "here", .given = true
    };
}

struct post {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_level level;
    struct wf_species species;
    struct wf_model model;
    struct wf_scenario scenario;
    struct wf_search search;
    struct wf_solve_options options;
    struct wf_analysis an;
    struct wf_err err;
};

/* Its crown, the upper half, is bare until a leaf area is set. */
static inline void post_begin(struct post *p, double height, double radius)
{
    memset(p, 0, sizeof *p);
    p->diag.arena = &p->arena;
    p->level = (struct wf_level){ .name = "stem",
                                  .youngs_modulus = measured(POST_YOUNGS),
                                  .shear_modulus = measured(POST_YOUNGS / 16),
                                  .density = measured(900),
                                  .modulus_of_rupture = measured(POST_STRENGTH),
                                  .radius = measured(radius),
                                  .knot_factor = measured(1),
                                  .damping_ratio = measured(0.05),
                                  .drag_coefficient = measured(1),
                                  .lift_coefficient = measured(0) };
    p->species = (struct wf_species){ .key = "post",
                                      .name = "Post",
                                      .preset = "corrected",
                                      .levels = 1,
                                      .level = &p->level,
                                      .crown.drag_coefficient = measured(0.5),
                                      .crown.leaf_mass_per_area = measured(0.2),
                                      .crown.frontal_share = measured(0.4),
                                      .streamlining = { .law = "none", .parameter = { measured(0) } } };
    p->model = (struct wf_model){ .key = "post",
                                  .name = "Post",
                                  .height = height,
                                  .radius = radius,
                                  .taper = WF_TAPER_LINEAR,
                                  .tip_ratio = 1,
                                  .segments = 20,
                                  .crown_base = 0.5 * height,
                                  .crown_top = height,
                                  .silhouette = { .area = NAN, .leafless = NAN } };
    wf_scenario_default(&p->scenario);
    p->scenario.peak.method = "mean";
    p->scenario.profile = "uniform";
    p->scenario.air_density = POST_AIR;
    p->scenario.gravity = 0;
    wf_search_default(&p->search);
    p->search.speed_max = 100, p->search.beyond = 0; /* it stands in any wind that occurs */
    wf_solve_options_default(&p->options);
}

/* Text of the first finding with a code; NULL: none. */
static inline const char *post_warning(const struct post *p, const char *code)
{
    for (const struct wf_finding *f = p->diag.first; f; f = f->next)
        if (f->code && strcmp(f->code, code) == 0) return f->text;
    return NULL;
}
#endif
