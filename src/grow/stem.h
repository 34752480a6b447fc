#ifndef WF_GROW_STEM_H
#define WF_GROW_STEM_H
/* A tree from a stem model and a species' materials. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/species.h"
#include "data/tree.h"

/* Rows of equal length up the stem; radius by the model's taper, wall, E, G, density, strength, drag of the species'
 * level 0; crown sail = leaf area density x leaf_frontal_share x crown_drag; burden = leaf area x leaf mass. */
enum wf_status wf_grow_stem(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                            struct wf_tree *out, struct wf_err *e);
#endif
