#ifndef WF_DATA_MODEL_SCHEMA_H
#define WF_DATA_MODEL_SCHEMA_H
/* The rows of a tree model; the checks between keys are in model.c. */
#include "base/yaml.h"

extern const struct wf_yaml_table wf_model_table;

extern const struct wf_yaml_table wf_stem_section_table; /* struct wf_stem_section */
extern const struct wf_yaml_table wf_stem_mass_table;    /* struct wf_stem_mass    */

struct wf_model;
void wf_stem_finish(struct wf_yaml *y, struct wf_model *m);
void wf_taper_finish(struct wf_yaml *y, void *model);
void wf_shape_finish(struct wf_yaml *y, void *model);
void wf_model_finish(struct wf_yaml *y, void *model);
#endif
