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

#endif
