#include "base/yaml.h"
#include "base/file.h"
#include "base/yaml_parts.h"
#include <string.h>

static void syntax(struct wf_yaml *y, const yaml_parser_t *p, const char *text, size_t size)
{
    bool tab = p->problem_mark.index < size && text[p->problem_mark.index] == '\t';
    bool open = p->context && p->context_mark.line != p->problem_mark.line;
    if (p->error == YAML_MEMORY_ERROR)
        y->no_memory = true;
    else if (tab)
        wf_yaml_mark(y, p->problem_mark, "a tab cannot indent; use spaces");
    else if (open)
        wf_yaml_mark(y, p->problem_mark, "not YAML: %s (%s that starts on line %zu)", p->problem, p->context,
                     p->context_mark.line + 1);
    else
        wf_yaml_mark(y, p->problem_mark, "not YAML: %s", p->problem ? p->problem : "unreadable");
}

static void screen_event(struct wf_yaml *y, const yaml_event_t *v, size_t *depth, size_t *documents)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    switch (v->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (++*documents == 2)
            wf_yaml_mark(y, v->start_mark, "a second document starts here; one a file is expected");
        break;
    case YAML_ALIAS_EVENT:
        wf_yaml_mark(y, v->start_mark, "the alias '*%s' is not understood here; write the value out",
                     (const char *)v->data.alias.anchor);
        break;
    case YAML_SCALAR_EVENT:
        anchor = v->data.scalar.anchor;
        tag = v->data.scalar.tag;
        break;
    case YAML_SEQUENCE_START_EVENT:
        anchor = v->data.sequence_start.anchor;
        tag = v->data.sequence_start.tag;
        ++*depth;
        break;
    case YAML_MAPPING_START_EVENT:
        anchor = v->data.mapping_start.anchor;
        tag = v->data.mapping_start.tag;
        ++*depth;
        break;
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        --*depth;
        break;
    default:
        break;
    }
    if (anchor)
        wf_yaml_mark(y, v->start_mark, "the anchor '&%s' is not understood here; write the value out",
                     (const char *)anchor);
    if (tag) wf_yaml_mark(y, v->start_mark, "the tag '%s' is not understood here", (const char *)tag);
    if (*depth > WF_YAML_DEPTH)
        wf_yaml_mark(y, v->start_mark, "nested more than %d deep", (int)WF_YAML_DEPTH);
}

bool wf_yaml_screen(struct wf_yaml *y, const char *text, size_t size)
{
    yaml_parser_t p;
    if (!yaml_parser_initialize(&p)) return y->no_memory = true, false;
    yaml_parser_set_encoding(&p, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&p, (const unsigned char *)text, size);
    size_t depth = 0, documents = 0;
    for (bool end = false; !end && depth <= WF_YAML_DEPTH && documents < 2;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&p, &event)) {
            syntax(y, &p, text, size);
            break;
        }
        screen_event(y, &event, &depth, &documents);
        end = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&p);
    return !y->mistakes && !y->no_memory;
}

/* Build the document, read it under the schema, and let it go. */
static void read_document(struct wf_yaml *y, const struct wf_bytes *b, const struct wf_yaml_table *t,
                          void *out)
{
    yaml_parser_t p;
    if (!wf_yaml_screen(y, b->data, b->size)) return;
    if (!yaml_parser_initialize(&p)) {
        y->no_memory = true;
        return;
    }
    yaml_parser_set_encoding(&p, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&p, (const unsigned char *)b->data, b->size);
    if (yaml_parser_load(&p, &y->document)) {
        const yaml_node_t *root = yaml_document_get_root_node(&y->document);
        const char *text = root ? wf_yaml_scalar(root) : "";
        if (text && !*text)
            wf_yaml_mark(y, (yaml_mark_t){ 0 }, "the file is empty; %s is expected", t->title);
        else
            wf_yaml_fill(y, root, t, NULL, out);
        yaml_document_delete(&y->document);
    } else {
        syntax(y, &p, b->data, b->size);
    }
    yaml_parser_delete(&p);
}

enum wf_status wf_yaml_read(const char *path, const struct wf_yaml_table *table, void *out,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_yaml y = { .file = path, .arena = a, .diag = d };
    struct wf_finding *before = d->last;
    struct wf_bytes b;
    enum wf_status code = wf_file_read_text(path, a, &b, e);
    if (code) return code;
    if (b.size > WF_YAML_SIZE)
        return wf_fail(e, WF_EINPUT, "%s: is larger than 1 MB; %s is smaller", path, table->title);
    code = wf_units_open(&y.units, e);
    if (code) return code;
    read_document(&y, &b, table, out);
    wf_units_close(y.units);
    wf_diag_sort(d, before);
    if (y.no_memory) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (!y.mistakes) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, y.mistakes, y.mistakes == 1 ? "" : "s");
}
