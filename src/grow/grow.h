/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_GROW_H
#define WF_GROW_GROW_H
/* Models of trees, from files or from scans, and the tree that a model and the materials of a species give.
 */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_model;          /* data/model.h */
struct wf_import_options; /* grow/import_file.h */
struct wf_species;

/* A tree model read from its file (models/NAME.yaml). Returned: *out in the arena, in the season of the file.
 * Errors as wf_model_read: WF_EINPUT with every mistake in `d`. */
enum wf_status wf_model_open(const char *path, struct wf_arena *a, struct wf_model **out, struct wf_diag *d,
                             struct wf_err *e);

/* A measured tree as a model: any format that wf_import_read knows, repaired and joined. Given: path, how
 * branches are held ("axis" or NULL: where they leave the parent's axis; "bridge": at its end, see
 * grow/qsm_model.h). Returned: *out in the arena, standing under its weight, without leaves; what was
 * repaired in `d`. MATLAB files are read in this process by libmatio: give it only files from a source that
 * you trust; version 7.3 (HDF5) is refused. Errors: WF_EUSAGE for another joint, those of wf_import_read and
 * wf_qsm_to_tree. */
enum wf_status wf_model_scanned(const char *path, const char *joint, struct wf_arena *a,
                                struct wf_model **out, struct wf_diag *d, struct wf_err *e);

/* The same with options of an import; NULL: none. */
enum wf_status wf_model_imported(const char *path, const char *joint, const struct wf_import_options *o,
                                 struct wf_arena *a, struct wf_model **out, struct wf_diag *d,
                                 struct wf_err *e);

/* Give a model leaves: one-sided area of the whole tree [m2]; 0: none. WF_EUSAGE for a model that does not
 * say where its leaves are. */
enum wf_status wf_model_leaves(struct wf_model *m, double area, struct wf_err *e);

/* Does the model show the tree as it stands, bent by its own weight? Then the forces of the weight in this
 * shape are those at rest, and deflections count from it; else the model is taken as stress-free, and its
 * weight bends it. A measured tree stands, unless this says otherwise. */
void wf_model_stands(struct wf_model *m, bool under_weight);

/* Given: model, species, arena for the tree. Returned: the tree. Its rows are ordered by level from the stem,
 * and the rows of an axis follow each other; each row has the material of its level, or of the species' last
 * level if the tree has more levels; leaves are those of the model's season. Warnings in `d`: thick-branch
 * (the radius of branches was reduced to that of the part they start from, or is larger by the pipe model),
 * below-ground, bark, opening. Errors: WF_EINPUT for a model with leaves and a species without crown, for too
 * many segments, for cavities that do not fit the stem; WF_ENOMEM. */
enum wf_status wf_grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                       struct wf_tree *out, struct wf_diag *d, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
