/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_GROW_H
#define WF_GROW_GROW_H
/* Grow a tree from a model of any generator and the materials of a species. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "data/model.h"
#include "data/species.h"
#include "data/tree.h"

/* Given: model, species, arena for the tree. Returned: the tree. Its rows are ordered by level from the stem,
 * and the rows of an axis follow each other; each row has the material of its level, or of the species' last
 * level if the tree has more levels; leaves are those of the model's season. Warnings in `d`: thick-branch
 * (the radius of branches was reduced to that of the part they start from, or is larger by the pipe model),
 * below-ground. Errors: WF_EINPUT for a model with leaves and a species without crown, for too many segments,
 * for a stem whose sections are not round; WF_ENOMEM. */
enum wf_status wf_grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                       struct wf_tree *out, struct wf_diag *d, struct wf_err *e);
#endif
