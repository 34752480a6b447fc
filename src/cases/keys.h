/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_KEYS_H
#define WF_CASES_KEYS_H
/* The keys of a case file as rows: reader, dimension and range of each key are stated only here. */
#include "cases/case.h"
#include "cases/words.h"

struct wf_case_key {
    const char *name;
    /* Read the line's words into the case; false after reporting a mistake. */
    bool (*read)(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k);
    size_t offset; /* of the field */
    enum wf_dimension dimension;
    size_t count_low, count; /* least and largest number of values; missing ones repeat the first */
    double low, high;        /* allowed range, SI */
    const char *choices;     /* words separated by '|', in the order of the enum */
    bool repeats;            /* may be given on several lines of one case */
};
extern const struct wf_case_key wf_case_keys[]; /* ends at name == NULL; at most WF_CASE_KEYS_MAX */

/* A case with defaults, before any key is read. */
void wf_case_default(struct wf_case *c);

/* Index of a key; the number of keys when there is none of that name. */
size_t wf_case_key_index(const char *name);
#endif
