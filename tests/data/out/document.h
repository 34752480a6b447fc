/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_DOCUMENT_H
#define WF_TESTS_DOCUMENT_H
/* results.json of one analysis, written and read again. */
#include "folder.h"
#include "out/results.h"
#include <jansson.h>
#include <math.h>

static inline double number(const json_t *o, const char *key)
{
    const json_t *v = json_object_get(json_object_get(o, key), "value");
    return json_is_number(v) ? json_number_value(v) : (double)NAN;
}

static inline const char *text(const json_t *o, const char *key)
{
    return json_string_value(json_object_get(o, key));
}

static inline json_t *document(const struct wf_analysis *an)
{
    struct folder folder;
    json_error_t why;
    struct wf_err err = { 0 };
    struct wf_run run = { .command = "test", .version = "0", .date = "x", .n = 1, .analysis = an };
    assert_true(folder_make(&folder));
    assert_int_equal(wf_results_write(&run, folder.path, &err), WF_OK);
    json_t *o = json_load_file(folder_file(&folder, "results.json"), JSON_REJECT_DUPLICATES, &why);
    assert_non_null(o);
    folder_remove(&folder);
    return o;
}
#endif
