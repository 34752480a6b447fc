/* Lists and free mappings. */
#include "base/yaml_parts.h"
#include <string.h>

static void keep(const struct wf_yaml_row *r, unsigned char *out, const void *items, size_t n)
{
    memcpy(out + r->offset, &items, sizeof items);
    memcpy(out + r->count, &n, sizeof n);
}

/* Length of a list node; 0 after a finding about its type or when it is empty. */
static size_t length_of(struct wf_yaml *y, const yaml_node_t *n, const char *of)
{
    if (n->type != YAML_SEQUENCE_NODE) {
        wf_yaml_at(y, n, "a list of %s is expected, not %s", of, wf_yaml_type(n));
        return 0;
    }
    size_t count = (size_t)(n->data.sequence.items.top - n->data.sequence.items.start);
    if (!count) wf_yaml_at(y, n, "the list is empty; %s are expected", of);
    return count;
}

/* Lists that belong together must be equally long. Returned: false after a finding. */
static bool same_length(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, size_t count)
{
    const yaml_node_t *other =
        r->same_length_as ? wf_yaml_find(y, y->node, r->same_length_as, strlen(r->same_length_as)) : NULL;
    if (!other || other->type != YAML_SEQUENCE_NODE) return true;
    size_t want = (size_t)(other->data.sequence.items.top - other->data.sequence.items.start);
    if (want == count) return true;
    wf_yaml_at(y, n, "%zu value%s, but '%s' has %zu", count, count == 1 ? "" : "s", r->same_length_as, want);
    return false;
}

void wf_yaml_quantities(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                        unsigned char *out)
{
    size_t count = length_of(y, n, "values");
    if (!count) return;
    double *v = wf_yaml_take(y, count, sizeof *v);
    if (!v) return;
    for (size_t i = 0; i < count; i++) {
        const yaml_node_t *item = wf_yaml_node(y, n->data.sequence.items.start[i]);
        size_t length = wf_yaml_push_index(y, i);
        const char *text = wf_yaml_scalar(item);
        if (text)
            v[i] = wf_yaml_quantity(y, item, text, r);
        else
            wf_yaml_at(y, item, "a single value is expected, not %s", wf_yaml_type(item));
        wf_yaml_pop(y, length);
    }
    if (same_length(y, n, r, count)) keep(r, out, v, count);
}

void wf_yaml_texts(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out)
{
    if (n->type != YAML_MAPPING_NODE) {
        wf_yaml_at(y, n, "a mapping of names to texts is expected, not %s", wf_yaml_type(n));
        return;
    }
    const yaml_node_pair_t *first = n->data.mapping.pairs.start;
    size_t count = (size_t)(n->data.mapping.pairs.top - first), kept = 0;
    if (count > WF_YAML_ENTRIES) {
        wf_yaml_at(y, n, "%zu entries; at most %d are read", count, (int)WF_YAML_ENTRIES);
        return;
    }
    struct wf_yaml_pair *pair = wf_yaml_take(y, count, sizeof *pair);
    struct wf_yaml_row key = { .kind = WF_YAML_NAME, .offset = offsetof(struct wf_yaml_pair, key) };
    struct wf_yaml_row text = { .kind = WF_YAML_TEXT, .offset = offsetof(struct wf_yaml_pair, text) };
    for (size_t i = 0; pair && i < count; i++) {
        const yaml_node_t *k = wf_yaml_node(y, first[i].key), *v = wf_yaml_node(y, first[i].value);
        const char *name = wf_yaml_scalar(k), *words = wf_yaml_scalar(v);
        if (!name) {
            wf_yaml_at(y, k, "a name is expected, not %s", wf_yaml_type(k));
            continue;
        }
        wf_yaml_put(y, k, name, &key, NULL, (unsigned char *)&pair[kept]);
        size_t length = wf_yaml_push(y, name);
        bool twice = false;
        for (size_t j = 0; j < kept; j++) twice |= !strcmp(pair[j].key, name);
        if (twice)
            wf_yaml_at(y, k, "is given twice");
        else if (words)
            wf_yaml_put(y, v, words, &text, NULL, (unsigned char *)&pair[kept]);
        else
            wf_yaml_at(y, v, "a text is expected, not %s", wf_yaml_type(v));
        wf_yaml_pop(y, length);
        kept += !twice && pair[kept].key != NULL;
    }
    keep(r, out, pair, pair ? kept : 0);
}

/* Append one value, after a comma where it is not the first. */
static const char *append(struct wf_yaml *y, const char *all, const char *key, const yaml_node_t *v)
{
    const char *text = wf_yaml_scalar(v);
    if (!text) wf_yaml_at(y, v, "a single value is expected, not %s", wf_yaml_type(v));
    if (!text || !all) return all;
    all = wf_arena_print(y->arena, "%s%s%s%s%s", all, *all ? "," : "", key, *key ? "=" : "", text);
    if (!all) y->no_memory = true;
    return all;
}

void wf_yaml_joined(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out)
{
    const char *all = "";
    if (n->type == YAML_SEQUENCE_NODE)
        for (yaml_node_item_t *i = n->data.sequence.items.start; i < n->data.sequence.items.top; i++)
            all = append(y, all, "", wf_yaml_node(y, *i));
    else if (n->type == YAML_MAPPING_NODE)
        for (yaml_node_pair_t *q = n->data.mapping.pairs.start; q < n->data.mapping.pairs.top; q++) {
            const char *key = wf_yaml_scalar(wf_yaml_node(y, q->key));
            all = append(y, all, key ? key : "", wf_yaml_node(y, q->value));
        }
    else
        all = append(y, all, "", n);
    if (all && !*all) wf_yaml_at(y, n, "a value is expected, not %s", wf_yaml_type(n));
    memcpy(out + r->offset, &all, sizeof all);
}

void wf_yaml_list(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r, unsigned char *out)
{
    size_t count = length_of(y, n, "mappings");
    if (!count) return;
    unsigned char *items = wf_yaml_take(y, count, r->table->size);
    if (!items) return;
    for (size_t i = 0; i < count; i++) {
        size_t length = wf_yaml_push_index(y, i);
        wf_yaml_fill(y, wf_yaml_node(y, n->data.sequence.items.start[i]), r->table, r,
                     items + i * r->table->size);
        wf_yaml_pop(y, length);
    }
    keep(r, out, items, count);
}
