/* Mappings under their schema rows. */
#include "base/near.h"
#include "base/yaml_parts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS_MAX = 160 };

static const struct wf_yaml_row *row_of(const struct wf_yaml_table *t, const char *key)
{
    for (const struct wf_yaml_row *r = t->row; r->key; r++)
        if (!strcmp(r->key, key)) return r;
    return NULL;
}

static void unknown(struct wf_yaml *y, const yaml_node_t *k, const struct wf_yaml_table *t)
{
    const char *word = wf_yaml_scalar(k), *known[ROWS_MAX];
    char all[512] = "";
    size_t n = 0, used = 0;
    for (const struct wf_yaml_row *r = t->row; r->key && n < ROWS_MAX; r++) {
        known[n++] = r->key;
        if (used < sizeof all)
            used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", used ? ", " : "", r->key);
    }
    const char *near = wf_nearest(word, known, n);
    if (near)
        wf_yaml_at(y, k, "unknown key '%.60s'; did you mean '%s'?", word, near);
    else
        wf_yaml_at(y, k, "unknown key '%.60s'; keys here are: %s", word, all);
}

static void one(struct wf_yaml *y, const yaml_node_t *v, const struct wf_yaml_row *r,
                const struct wf_yaml_row *outer, unsigned char *out)
{
    size_t length = wf_yaml_push(y, r->key);
    if (r->given) out[r->given - 1] = true;
    const char *text = wf_yaml_scalar(v);
    if (r->kind == WF_YAML_TABLE)
        wf_yaml_fill(y, v, r->table, r, out + r->offset);
    else if (r->kind == WF_YAML_LIST)
        wf_yaml_list(y, v, r, out);
    else if (r->kind == WF_YAML_TEXTS)
        wf_yaml_texts(y, v, r, out);
    else if (r->kind == WF_YAML_QUANTITIES)
        wf_yaml_quantities(y, v, r, out);
    else if (r->kind == WF_YAML_JOINED)
        wf_yaml_joined(y, v, r, out);
    else if (text)
        wf_yaml_put(y, v, text, r, outer, out);
    else
        wf_yaml_at(y, v, "a single value is expected, not %s", wf_yaml_type(v));
    wf_yaml_pop(y, length);
}

/* What a row's member holds before its key is met. */
static void initial(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r,
                    const struct wf_yaml_row *outer, unsigned char *out)
{
    const double none = NAN;
    if (r->kind == WF_YAML_QUANTITY) memcpy(out + r->offset, &none, sizeof none);
    if (r->preset && r->kind != WF_YAML_TABLE) wf_yaml_put(y, n, r->preset, r, outer, out);
}

static void missing(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_row *r)
{
    if (r->example)
        wf_yaml_at(y, n, "missing key '%s' (%s); for example '%s: %s'", r->key, r->doc, r->key, r->example);
    else
        wf_yaml_at(y, n, "missing key '%s' (%s)", r->key, r->doc);
}

static void keys(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                 const struct wf_yaml_row *outer, unsigned char *out, bool seen[static ROWS_MAX])
{
    for (yaml_node_pair_t *q = n->data.mapping.pairs.start; q < n->data.mapping.pairs.top; q++) {
        const yaml_node_t *k = wf_yaml_node(y, q->key);
        const char *key = wf_yaml_scalar(k);
        const struct wf_yaml_row *r = key ? row_of(t, key) : NULL;
        if (!key)
            wf_yaml_at(y, k, "a key is expected, not %s", wf_yaml_type(k));
        else if (!r)
            unknown(y, k, t);
        else if (seen[r - t->row])
            wf_yaml_at(y, k, "key '%s' is given twice", key);
        else
            one(y, wf_yaml_node(y, q->value), r, outer, out);
        if (r) seen[r - t->row] = true;
    }
}

void wf_yaml_fill(struct wf_yaml *y, const yaml_node_t *n, const struct wf_yaml_table *t,
                  const struct wf_yaml_row *outer, unsigned char *out)
{
    bool seen[ROWS_MAX] = { false };
    const yaml_node_t *above = y->node, *above_place = y->place, *place = n ? n : above_place;
    bool mapping = n && n->type == YAML_MAPPING_NODE;
    const char *bare = n ? wf_yaml_scalar(n) : outer ? outer->preset : NULL;
    y->node = n;
    y->place = place;
    for (const struct wf_yaml_row *r = t->row; r->key; r++) initial(y, place, r, outer, out);
    if (mapping)
        keys(y, n, t, outer, out, seen);
    else if (t->bare && bare)
        wf_yaml_put(y, place, bare, row_of(t, t->bare), outer, out);
    else if (n)
        wf_yaml_at(y, n, "a mapping (keys with values) is expected, not %s", wf_yaml_type(n));
    for (const struct wf_yaml_row *r = t->row; r->key; r++) {
        if (seen[r - t->row]) continue;
        if (mapping && r->required) missing(y, n, r);
        if (r->kind == WF_YAML_TABLE) wf_yaml_fill(y, NULL, r->table, r, out + r->offset);
    }
    if (t->finish) t->finish(y, out);
    y->node = above;
    y->place = above_place;
}
