#ifndef WF_OUT_DOC_H
#define WF_OUT_DOC_H
/* Building a JSON document without a check after every line: a failure (no memory) is noted in the
 * builder, later calls do nothing harmful, and the writer asks once at the end. */
#include <jansson.h>
#include <stdbool.h>

struct wf_doc {
    bool failed;
};

/* A new object or array; NULL, and failed, without memory. */
json_t *wf_doc_object(struct wf_doc *d);
json_t *wf_doc_array(struct wf_doc *d);
/* Put `value` (its reference is taken over) under a key, or at an array's end. Returned: value. */
json_t *wf_doc_put(struct wf_doc *d, json_t *object, const char *key, json_t *value);
json_t *wf_doc_add(struct wf_doc *d, json_t *array, json_t *value);

/* Text; NULL becomes null. Bytes that are not UTF-8 become '?'. */
void wf_doc_text(struct wf_doc *d, json_t *object, const char *key, const char *text);
void wf_doc_count(struct wf_doc *d, json_t *object, const char *key, size_t n);
void wf_doc_flag(struct wf_doc *d, json_t *object, const char *key, bool flag);
/* {"value": x, "unit": "..."}; a number that is not finite becomes null with "reason". */
json_t *wf_doc_quantity(struct wf_doc *d, json_t *object, const char *key, double x, const char *unit,
                        const char *reason);
/* A bare number, null when not finite. */
void wf_doc_number(struct wf_doc *d, json_t *object, const char *key, double x);
/* An array of n bare numbers. */
void wf_doc_numbers(struct wf_doc *d, json_t *object, const char *key, const double *x, size_t n);
#endif
