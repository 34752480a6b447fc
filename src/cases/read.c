/* A validation file to cases. Lines above the first `case` belong to every case of the file. */
#include "base/file.h"
#include "base/near.h"
#include "cases/check.h"
#include "cases/keys.h"
#include "cases/measure.h"
#include <math.h>
#include <string.h>

static const char *const kind_names[WF_CASE_KIND_COUNT] = {
    [WF_CASE_CLOSED_FORM] = "closed-form",
    [WF_CASE_PUBLISHED] = "published",
    [WF_CASE_COMPUTED_REFERENCE] = "computed-reference",
    [WF_CASE_FIELD] = "field",
    [WF_CASE_REGRESSION] = "regression",
};

const char *wf_case_kind_name(enum wf_case_kind k)
{
    return (unsigned)k < WF_CASE_KIND_COUNT ? kind_names[k] : "unknown";
}

struct reader {
    struct wf_words w;
    struct wf_case common, now;
    bool in_case;
    struct wf_list cases;
};

static bool copy_list(struct wf_list *l, size_t size, struct wf_arena *a)
{
    void *data = wf_arena_take(a, l->n, size);
    if (data && l->n) memcpy(data, l->data, l->n * size);
    l->data = data;
    l->room = l->n;
    return data != NULL;
}

/* A copy that shares nothing which is written to. */
static bool copy_case(const struct wf_case *c, struct wf_case *out, struct wf_arena *a)
{
    *out = *c;
    return copy_list(&out->nodes, sizeof(struct wf_case_node), a) &&
           copy_list(&out->branches, sizeof(struct wf_case_branch), a) &&
           copy_list(&out->loads, sizeof(struct wf_case_load), a) &&
           copy_list(&out->masses, sizeof(struct wf_case_mass), a) &&
           copy_list(&out->wants, sizeof(struct wf_want), a);
}

static bool close_case(struct reader *r)
{
    wf_case_check(&r->now, r->w.diag);
    return wf_list_add(&r->cases, &r->now, sizeof r->now, r->w.arena) ||
           wf_words_wrong(&r->w, 0, "no memory");
}

static void begin_case(struct reader *r)
{
    if (r->in_case) (void)close_case(r);
    if (!copy_case(&r->common, &r->now, r->w.arena)) (void)wf_words_wrong(&r->w, 0, "no memory");
    r->now.line = r->w.line;
    r->in_case = true;
    r->now.name = r->w.n > 1 ? r->w.word[1] : "";
    if (r->w.n < 2) (void)wf_words_wrong(&r->w, r->w.n, "the name of the case is missing");
    if (r->w.n > 2) (void)wf_words_wrong(&r->w, 2, "a name is one word; say more in 'title' or 'note'");
    const struct wf_case *other = r->cases.data;
    for (size_t i = 0; i < r->cases.n; i++)
        if (!strcmp(other[i].name, r->now.name))
            (void)wf_words_wrong(&r->w, 1, "case '%s' was begun on line %zu", r->now.name, other[i].line);
}

static void unknown_key(struct wf_words *w)
{
    const char *names[WF_CASE_KEYS_MAX + 1];
    size_t n = 0;
    for (; wf_case_keys[n].name; n++) names[n] = wf_case_keys[n].name;
    names[n++] = "case";
    const char *near = wf_nearest(w->key, names, n);
    wf_diag_error(w->diag, w->file, w->line, w->column[0],
                  near ? "unknown key '%s'; did you mean '%s'?" : "unknown key '%s'", w->key, near);
}

static void read_line(struct reader *r, const char *text, size_t length)
{
    struct wf_words *w = &r->w;
    struct wf_case *c = r->in_case ? &r->now : &r->common;
    if (!wf_words_split(w, text, length) || !w->n) return;
    if (!strcmp(w->key, "case")) {
        begin_case(r);
        return;
    }
    size_t k = wf_case_key_index(w->key);
    const struct wf_case_key *key = &wf_case_keys[k];
    if (!key->name) {
        unknown_key(w);
        return;
    }
    if (!key->repeats && c->given[k] >= c->line && c->given[k]) {
        (void)wf_words_wrong(w, 0, "given twice; first on line %zu", c->given[k]);
        return;
    }
    if (!key->read(w, c, key)) c->faulty = true;
    c->given[k] = w->line;
    if (!strcmp(w->key, "units")) w->plain = c->nondimensional != 0;
    if (!strcmp(w->key, "units") && (r->in_case || c->wants.n))
        (void)wf_words_wrong(
            w, 0, "stands above the first case and the first wanted value: it holds for the whole file");
}

static const char *stem_of(const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/');
    char *name = wf_arena_text(a, slash ? slash + 1 : path);
    char *dot = name ? strrchr(name, '.') : NULL;
    if (dot) *dot = '\0';
    return name;
}

static enum wf_status read_lines(struct reader *r, const struct wf_bytes *text)
{
    const char *s = text->data, *end = s + text->size;
    while (s < end) {
        const char *newline = memchr(s, '\n', (size_t)(end - s)), *stop = newline ? newline : end;
        r->w.line++;
        read_line(r, s, (size_t)(stop - s));
        s = stop + 1;
    }
    if (!r->in_case) { /* a file without `case` lines is one case */
        r->now = r->common;
        r->now.name = stem_of(r->w.file, r->w.arena);
        if (!r->now.name) return WF_ENOMEM;
    }
    return close_case(r) ? WF_OK : WF_ENOMEM;
}

enum wf_status wf_case_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_case **list,
                            size_t *n, struct wf_err *e)
{
    struct wf_bytes text;
    struct reader r = { .w = { .file = path, .arena = a, .diag = d } };
    size_t errors = d->errors;
    *list = NULL;
    *n = 0;
    if (wf_file_read_text(path, a, &text, e)) return e->code;
    if (text.size > 16 * 1024 * 1024)
        return wf_fail(e, WF_EINPUT, "%s: too long for a validation case", path);
    wf_case_default(&r.common);
    r.common.file = path;
    r.common.line = 1;
    if (wf_units_open(&r.w.units, e)) return e->code;
    enum wf_status status = read_lines(&r, &text);
    wf_units_close(r.w.units);
    if (status) return wf_fail(e, status, "%s: no memory", path);
    *list = r.cases.data;
    *n = r.cases.n;
    if (d->errors > errors)
        return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, d->errors - errors,
                       d->errors - errors == 1 ? "" : "s");
    return WF_OK;
}
