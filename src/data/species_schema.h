#ifndef WF_DATA_SPECIES_SCHEMA_H
#define WF_DATA_SPECIES_SCHEMA_H
/* The rows of a species table; the checks between keys are in species.c. */
#include "data/value.h"

extern const struct wf_yaml_table wf_species_table;
extern const struct wf_yaml_row wf_level_rows[], wf_crown_rows[]; /* end at key == NULL */

void wf_level_finish(struct wf_yaml *y, void *level);
void wf_wall_finish(struct wf_yaml *y, void *level);
void wf_streamlining_finish(struct wf_yaml *y, void *species);
void wf_species_finish(struct wf_yaml *y, void *species);
#endif
