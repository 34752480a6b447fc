/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_HOLLOWED_H
#define WF_GROW_HOLLOWED_H
/* The bark of a tree's stem and the cavities in it. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/tree.h"

struct wf_species;

/* Bark on the stem and cavities in it, as the model says. Given: a tree with its materials. Returned: bark:
 * on the rows of level 0, by the species' law at their diameter, or as measured at 1.3 m, in proportion to
 * the diameter; a measured tree whose species has a law gets it by default. Cavities: rows of the stem are
 * cut where a cavity ends, and those within it have its section in t->section. Mass stays as it was. Warnings
 * in `d`: bark (how thick, what is left of the section), opening. Errors: WF_EINPUT for a cavity that does
 * not fit the stem, bark without a law or without wood within, with every mistake in `d`; WF_ENOMEM. */
enum wf_status wf_hollow_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_tree *t, struct wf_diag *d, struct wf_err *e);
#endif
