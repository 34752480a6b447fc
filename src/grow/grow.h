/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_GROW_H
#define WF_GROW_GROW_H
/* A tree from any model and a species' materials. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "data/model.h"
#include "data/species.h"
#include "data/tree.h"

/* Given: model, species, arena for the tree. Returned: the tree; parents before their children, levels one
 * after the other from the stem, the rows of an axis one after the other; materials by level, the species'
 * last level for those above it; leaves by the model's season. Warnings in `d`: thick-branch (branches
 * thinned to the part they grow from, or thicker than it by the pipe model), below-ground. Errors: WF_EINPUT
 * for a model with leaves and a species without crown, for too many segments; WF_ENOMEM. */
enum wf_status wf_grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                       struct wf_tree *out, struct wf_diag *d, struct wf_err *e);
#endif
