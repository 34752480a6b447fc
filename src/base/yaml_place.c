/* Where a mistake is: marks, paths, nodes. */
#include "base/yaml_parts.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add(struct wf_yaml *y, yaml_mark_t m, const char *key, const char *fmt, va_list args)
{
    char text[1536];
    if (++y->mistakes > WF_YAML_LISTED) {
        if (y->mistakes == WF_YAML_LISTED + 1)
            wf_diag_error(y->diag, y->file, 0, 0, "more than %d mistakes; the rest is counted but not listed",
                          (int)WF_YAML_LISTED);
        else
            y->diag->errors++;
        return;
    }
    int n = snprintf(text, sizeof text, "%s%s%s%s", y->path, *y->path && *key && *key != '[' ? "." : "", key,
                     *y->path || *key ? ": " : "");
    if (n >= 0 && (size_t)n < sizeof text) (void)vsnprintf(text + n, sizeof text - (size_t)n, fmt, args);
    wf_diag_error(y->diag, y->file, m.line + 1, m.column + 1, "%s", text);
}

void wf_yaml_mark(struct wf_yaml *y, yaml_mark_t m, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add(y, m, "", fmt, args);
    va_end(args);
}

void wf_yaml_at(struct wf_yaml *y, const yaml_node_t *n, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    add(y, n->start_mark, "", fmt, args);
    va_end(args);
}

/* Follow "levels[1].density.low" from the table in hand as far as the file goes. */
static const yaml_node_t *follow(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = y->node, *next = n;
    while (next && *key) {
        n = next;
        if (*key == '[') {
            char *end;
            size_t i = strtoul(key + 1, &end, 10);
            size_t have = n->type == YAML_SEQUENCE_NODE
                              ? (size_t)(n->data.sequence.items.top - n->data.sequence.items.start)
                              : 0;
            next = i < have ? wf_yaml_node(y, n->data.sequence.items.start[i]) : NULL;
            key = *end == ']' ? end + 1 : end;
        } else {
            size_t length = strcspn(key, ".[");
            next = wf_yaml_find(y, n, key, length);
            key += length;
        }
        if (*key == '.') key++;
    }
    return next ? next : n;
}

void wf_yaml_error(struct wf_yaml *y, const char *key, const char *fmt, ...)
{
    const yaml_node_t *found = follow(y, key), *n = found ? found : y->place;
    va_list args;
    va_start(args, fmt);
    add(y, n ? n->start_mark : (yaml_mark_t){ 0 }, key, fmt, args);
    va_end(args);
}

void *wf_yaml_take(struct wf_yaml *y, size_t n, size_t size)
{
    void *p = wf_arena_take(y->arena, n, size);
    if (!p) y->no_memory = true;
    return p;
}

size_t wf_yaml_push(struct wf_yaml *y, const char *key)
{
    size_t n = strlen(y->path);
    (void)snprintf(y->path + n, sizeof y->path - n, "%s%s", n ? "." : "", key);
    return n;
}

size_t wf_yaml_push_index(struct wf_yaml *y, size_t index)
{
    size_t n = strlen(y->path);
    (void)snprintf(y->path + n, sizeof y->path - n, "[%zu]", index);
    return n;
}

void wf_yaml_pop(struct wf_yaml *y, size_t length) { y->path[length] = '\0'; }

const yaml_node_t *wf_yaml_node(struct wf_yaml *y, int id)
{
    return yaml_document_get_node(&y->document, id);
}

const char *wf_yaml_scalar(const yaml_node_t *n)
{
    return n->type == YAML_SCALAR_NODE ? (const char *)n->data.scalar.value : NULL;
}

const char *wf_yaml_type(const yaml_node_t *n)
{
    if (n->type == YAML_MAPPING_NODE) return "a mapping (keys with values)";
    if (n->type == YAML_SEQUENCE_NODE) return "a list";
    return n->data.scalar.length ? "a single value" : "nothing";
}

const yaml_node_t *wf_yaml_find(struct wf_yaml *y, const yaml_node_t *map, const char *key, size_t length)
{
    if (!map || map->type != YAML_MAPPING_NODE) return NULL;
    for (yaml_node_pair_t *q = map->data.mapping.pairs.start; q < map->data.mapping.pairs.top; q++) {
        const char *k = wf_yaml_scalar(wf_yaml_node(y, q->key));
        if (k && strlen(k) == length && !memcmp(k, key, length)) return wf_yaml_node(y, q->value);
    }
    return NULL;
}

const char *wf_yaml_raw(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = wf_yaml_find(y, y->node, key, strlen(key));
    return n ? wf_yaml_scalar(n) : NULL;
}

bool wf_yaml_has(struct wf_yaml *y, const char *key)
{
    const yaml_node_t *n = y->node;
    while (n && *key) {
        size_t length = strcspn(key, ".");
        n = wf_yaml_find(y, n, key, length);
        key += length + (key[length] == '.');
    }
    return n != NULL;
}
