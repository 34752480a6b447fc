/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_LAW_SCHEMA_H
#define WF_DATA_LAW_SCHEMA_H
/* How values and laws are written in a species table: the rows of their schema, and the checks behind them.
 */
#include "base/yaml.h"
#include "data/law.h"

/* A value: {value, low, high, status, source, note}, or a bare quantity, whose standing is assumed. */
extern const struct wf_yaml_table wf_value_table;
/* The words of enum wf_standing in its order; ends at NULL. */
extern const char *const wf_standing_words[];

/* A row for a struct wf_value member. */
#define WF_VALUE_ROW(T, member)                                                                              \
    .kind = WF_YAML_TABLE, .table = &wf_value_table, .offset = offsetof(T, member),                          \
    .given = 1 + offsetof(T, member.given)

/* For `finish`: a table whose standing is not "assumed" needs a source. */
void wf_value_needs_source(struct wf_yaml *y, enum wf_standing s);

enum { WF_LAWS_MAX = 24, WF_LAW_ROWS = 1 + WF_LAW_KEYS + 7 };

/* The schema of a table's keys. */
struct wf_law_schema {
    const char *word[WF_LAWS_MAX];
    struct wf_yaml_row row[WF_LAW_ROWS];
    struct wf_yaml_table table;
};
/* Rows of a streamlining law that say where it holds; end at key NULL. */
extern const struct wf_yaml_row wf_law_ranges[];
/* Given: the laws, rows between their parameters and the origin. Returned: false without memory. */
bool wf_law_schema_make(struct wf_law_table t, const char *title, const struct wf_yaml_row *between,
                        struct wf_arena *a, struct wf_law_schema *out);
/* Copy rows up to the one without a key. Returned: how many. */
size_t wf_law_copy_rows(struct wf_yaml_row *to, const struct wf_yaml_row *from);

/* The k-th key of a table of laws; NULL after the last. *owner: the first law that has it. */
const struct wf_law_parameter *wf_law_key(struct wf_law_table t, size_t k, const struct wf_law **owner);
/* Source of the first parameter that has one. */
const char *wf_law_source(const struct wf_law_use *u);
/* Reorder the parameters from the order of the keys to that of the chosen law's row. */
void wf_law_settle(struct wf_law_use *u);
#endif
