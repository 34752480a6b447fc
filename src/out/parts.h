#ifndef WF_OUT_PARTS_H
#define WF_OUT_PARTS_H
/* The parts of results.json. Each returns a new object, to be put into the document. */
#include "out/doc.h"
#include "study/analysis.h"

json_t *wf_part_species(struct wf_doc *d, const struct wf_analysis *a);
json_t *wf_part_model(struct wf_doc *d, const struct wf_model *m);
json_t *wf_part_scenario(struct wf_doc *d, const struct wf_analysis *a);
json_t *wf_part_method(struct wf_doc *d, const struct wf_analysis *a);
/* Totals at one wind speed. */
json_t *wf_part_wind(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at);
/* When and where the tree, or a part of it, fails. */
json_t *wf_part_critical(struct wf_doc *d, const struct wf_analysis *a, const struct wf_break *b);
/* Every criterion in every scope: its critical wind speed and the utilisation at the a->n speeds of `at`. */
json_t *wf_part_criteria(struct wf_doc *d, const struct wf_analysis *a,
                         const struct wf_break (*breaks)[WF_SCOPES], const struct wf_at_speed *at);
/* Winds from all around; null where they were not asked for. */
json_t *wf_part_directions(struct wf_doc *d, const struct wf_analysis *a);
/* Warnings as a list of {code, text}. */
json_t *wf_part_warnings(struct wf_doc *d, const struct wf_diag *diag);

/* Short stable word for the outcome of a solution ("ok", "unstable", ...), used in JSON and in tables. */
const char *wf_part_status(enum wf_status s);
/* The same for the outcome of the search for the critical wind speed ("found", "above", ...). */
const char *wf_part_outcome(enum wf_critical_outcome o);
/* Height above ground of position s (0 base, 1 end) of a row on the unbent tree [m]; NAN for row -1. */
double wf_part_height(const struct wf_tree *t, int32_t row, double s);
#endif
