#ifndef WF_DATA_VALUE_H
#define WF_DATA_VALUE_H
/* Schema rows of values with range, standing and source, shared by the tables of this room. */
#include "base/yaml.h"
#include "data/species.h"

/* A value: {value, low, high, status, source, note}, or a bare quantity, which stands as assumed. */
extern const struct wf_yaml_table wf_value_table;
/* The words of enum wf_standing in its order; ends at NULL. */
extern const char *const wf_standing_words[];

/* A row for a struct wf_value member. */
#define WF_VALUE_ROW(T, member)                                                                              \
    .kind = WF_YAML_TABLE, .table = &wf_value_table, .offset = offsetof(T, member),                          \
    .given = 1 + offsetof(T, member.given)

/* For `finish`: the numbers of a list must ascend strictly. Given: the list's key and values. */
void wf_value_ascending(struct wf_yaml *y, const char *key, size_t n, const double *s);
#endif
