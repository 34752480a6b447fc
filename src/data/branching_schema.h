#ifndef WF_DATA_BRANCHING_SCHEMA_H
#define WF_DATA_BRANCHING_SCHEMA_H
/* Schema tables of the parts of a branched model, and the words of their choices. */
#include "base/yaml.h"

extern const struct wf_yaml_table wf_branching_table; /* struct wf_branching */
extern const struct wf_yaml_table wf_place_table, wf_azimuth_table, wf_insertion_table; /* parts of it */
extern const struct wf_yaml_table wf_curve_table;   /* struct wf_curve     */
extern const struct wf_yaml_table wf_ifs_table;     /* struct wf_ifs       */
extern const struct wf_yaml_table wf_foliage_table; /* struct wf_foliage   */
/* Words of the choices in the order of their enums; end at NULL. */
extern const char *const wf_azimuth_words[], *const wf_length_words[], *const wf_radius_words[],
                                                                           *const wf_ifs_words[];
#endif
