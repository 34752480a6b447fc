#ifndef WF_BASE_YAML_PARTS_H
#define WF_BASE_YAML_PARTS_H
/* Shared by the reader's own files. */
#include "base/yaml.h"
#include <yaml.h>

struct wf_yaml {
    const char *file;
    yaml_document_t document;
    struct wf_units *units;
    struct wf_arena *arena;
    struct wf_diag *diag;
    bool no_memory;
    size_t mistakes;
    char path[512];           /* of the place in hand                         */
    const yaml_node_t *node;  /* table in hand; NULL when its key is absent           */
    const yaml_node_t *place; /* it, or the nearest thing above it that is in the file */
};

/* Limits of a file: nesting, bytes, mistakes listed, entries of a free mapping. */
enum { WF_YAML_DEPTH = 16, WF_YAML_SIZE = 1 << 20, WF_YAML_LISTED = 100, WF_YAML_ENTRIES = 1000 };

/* Refuse what is not one plain document: syntax errors, anchors, aliases, tags, several documents, depth.
 * Returned: false after findings. */
bool wf_yaml_screen(struct wf_yaml *y, const char *text, size_t size);
/* A finding at a node, prefixed with the path in hand. */
void wf_yaml_at(struct wf_yaml *y, const yaml_node_t *n, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* A finding at a mark of the parser. */
void wf_yaml_mark(struct wf_yaml *y, yaml_mark_t m, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Extend the path by a key or index; the returned length gives it back with wf_yaml_pop. */
size_t wf_yaml_push(struct wf_yaml *y, const char *key);
size_t wf_yaml_push_index(struct wf_yaml *y, size_t index);
void wf_yaml_pop(struct wf_yaml *y, size_t length);

const yaml_node_t *wf_yaml_node(struct wf_yaml *y, int id);
const char *wf_yaml_scalar(const yaml_node_t *n); /* its text, NULL when it is not a scalar */
const char *wf_yaml_type(const yaml_node_t *n);   /* "a list", ...                          */
/* Value of a key of a mapping, NULL when there is none. */
const yaml_node_t *wf_yaml_find(struct wf_yaml *y, const yaml_node_t *map, const char *key, size_t length);

/* Read a scalar into the row's member. `outer`: the row that holds the table, for inherited dimensions. */
void wf_yaml_put(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                 const struct wf_yaml_row *outer, unsigned char *out);
/* Read a quantity. Returned: NAN after a finding. */
double wf_yaml_quantity(struct wf_yaml *y, const yaml_node_t *n, const char *text,
                        const struct wf_yaml_row *r);
/* Read a table from a mapping or a bare value; n == NULL: the key is absent, defaults only. */
void wf_yaml_fill(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                  const struct wf_yaml_row *outer, unsigned char *out);
/* Read the collections of a row. */
void wf_yaml_quantities(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                        unsigned char *out);
void wf_yaml_texts(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out);
void wf_yaml_joined(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out);
void wf_yaml_list(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out);
#endif
