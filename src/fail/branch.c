/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strength of branches over that of clear wood; declared in fail.h. */
#include "data/species.h"
#include "fail/fail.h"
#include <math.h>
#include <string.h>

#define KANE "Kane B. 2007. Branch strength of Bradford pear. Arboric. Urban For. 33(4), table 3: 26 branches"

enum { FULL, INSIDE_BARK, OVER_BARK, OVER_BARK_CIRCLE };

const struct wf_branch_strength wf_branch_strengths[] = {
    [FULL] = { "full", "as in the species table", NULL, 1 },
    [INSIDE_BARK] = { "inside-bark", "thickness inside bark, as an ellipse", KANE, 0.72 },
    [OVER_BARK] = { "over-bark", "thickness over bark, as an ellipse", KANE, 0.55 },
    [OVER_BARK_CIRCLE] = { "over-bark-circle", "thickness over bark, as a circle of one diameter", KANE,
                           0.40 },
    { .name = NULL },
};

/* Does the species repeat a publication? */
static bool printed(const struct wf_species *sp)
{
    return sp->preset && strcmp(sp->preset, "corrected") != 0;
}

static const struct wf_branch_strength *strength_named(const char *name, const struct wf_species *sp,
                                                       const struct wf_tree *t)
{
    for (const struct wf_branch_strength *b = wf_branch_strengths; name && b->name; b++)
        if (!strcmp(b->name, name)) return b;
    return &wf_branch_strengths[printed(sp) ? FULL : t->bark0 ? INSIDE_BARK : OVER_BARK];
}

/* The lower of what is known. */
static void limit(double *strength, const struct wf_value *clear, double factor)
{
    if (clear->value > 0) *strength = fmin(*strength, factor * clear->value);
}

const struct wf_branch_strength *wf_branches_limit(const char *name, const struct wf_species *sp,
                                                   struct wf_tree *t)
{
    const struct wf_branch_strength *b = strength_named(name, sp, t);
    const struct wf_level *clear = sp->level;
    for (size_t i = 0; i < t->n && b->factor < 1; i++) {
        if (t->level[i] == 0) continue;
        limit(&t->strength[i], &clear->modulus_of_rupture, b->factor);
        limit(&t->compressive[i], &clear->compressive_strength, b->factor);
        limit(&t->shearing[i], &clear->shear_strength, b->factor);
    }
    return b;
}
