/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SERIES_PLAN_H
#define WF_STUDY_SERIES_PLAN_H
/* Runs in time as text: a file of runs (models/papers/ *.yaml), and the conversion of a run to the input of
 * wf_series_run. */
#include "study/series.h"
#include "wind/gust.h"

struct wf_series_plan_run { /* NULL, NAN: the default */
    const char *name, *species, *model, *preset, *solver, *gust, *shelter, *leaf_motion, *explain;
    const char *set, *file;        /* of the gust model */
    struct wf_record_words record; /* how its file is read; columns NULL: the usual ones */
    struct wf_profile_words profile;
    double wind, intensity, period, duration, step, youngs, restoring, damping, transmission, leaf_amplitude,
        leaf_follow, leaf_period;
    size_t keys, seed, components;
};
struct wf_series_plan {
    const char *key, *title, *note, *source, *file;
    size_t runs;
    struct wf_series_plan_run *run;
};

/* Read a file of runs. Errors: WF_EINPUT with every mistake in `d`. */
enum wf_status wf_series_plan_read(const char *path, struct wf_arena *a, struct wf_series_plan *out,
                                   struct wf_diag *d, struct wf_err *e);
/* Whether a value that is given has no effect beside the others of its run. Given: offset of its member in
 * struct wf_series_plan_run; `size` bytes for the words behind "has no effect". */
bool wf_series_plan_unused(const struct wf_series_plan_run *r, size_t member, char *why, size_t size);
/* Its schema as text. NULL: out of memory. */
char *wf_series_plan_schema(struct wf_arena *a, struct wf_err *e);

/* Convert a run's text. Given: the run, its species and model. Returned: *out; its species is a copy with the
 * preset's values. Errors: WF_EUSAGE for an unknown name. */
enum wf_status wf_series_plan_spec(const struct wf_series_plan_run *r, const struct wf_species *sp,
                                   const struct wf_model *m, struct wf_arena *a, struct wf_series_spec *out,
                                   struct wf_err *e);
#endif
