/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/doc.h"
#include "base/said.h"
#include "base/text.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static json_t *made(struct wf_doc *d, json_t *value)
{
    if (!value) d->failed = true;
    return value;
}

json_t *wf_doc_object(struct wf_doc *d) { return made(d, json_object()); }
json_t *wf_doc_array(struct wf_doc *d) { return made(d, json_array()); }

json_t *wf_doc_put(struct wf_doc *d, json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value)) d->failed = true;
    return value;
}

json_t *wf_doc_add(struct wf_doc *d, json_t *array, json_t *value)
{
    if (json_array_append_new(array, value)) d->failed = true;
    return value;
}

/* A path or a command line may hold any bytes; what is not UTF-8 is shown as '?'. */
static json_t *readable(const char *text)
{
    struct wf_utf8_fault fault;
    size_t n = strlen(text);
    if (wf_utf8_valid(text, n, &fault)) return json_string(text);
    char *copy = strdup(text);
    if (!copy) return NULL;
    for (char *c = copy; *c; c++)
        if ((unsigned char)*c >= 0x80) *c = '?';
    json_t *value = json_string(copy);
    free(copy);
    return value;
}

void wf_doc_text(struct wf_doc *d, json_t *object, const char *key, const char *text)
{
    wf_doc_put(d, object, key, text ? readable(text) : json_null());
}

void wf_doc_count(struct wf_doc *d, json_t *object, const char *key, size_t n)
{
    wf_doc_put(d, object, key, json_integer((json_int_t)n));
}

void wf_doc_flag(struct wf_doc *d, json_t *object, const char *key, bool flag)
{
    wf_doc_put(d, object, key, json_boolean(flag));
}

/* json_real refuses NaN and infinity, which JSON cannot represent. */
static json_t *number(double x) { return isfinite(x) ? json_real(x) : json_null(); }

void wf_doc_number(struct wf_doc *d, json_t *object, const char *key, double x)
{
    wf_doc_put(d, object, key, number(x));
}

json_t *wf_doc_quantity(struct wf_doc *d, json_t *object, const char *key, double x, const char *unit,
                        const char *reason)
{
    json_t *q = wf_doc_put(d, object, key, wf_doc_object(d));
    wf_doc_number(d, q, "value", x);
    wf_doc_text(d, q, "unit", unit);
    if (!isfinite(x)) wf_doc_text(d, q, "reason", reason ? reason : "not a finite number");
    return q;
}

void wf_doc_numbers(struct wf_doc *d, json_t *object, const char *key, const double *x, size_t n)
{
    json_t *list = wf_doc_put(d, object, key, wf_doc_array(d));
    for (size_t i = 0; i < n; i++) wf_doc_add(d, list, number(x[i]));
}

void wf_doc_head_file(struct wf_doc_head *h, const char *role, const char *path)
{
    for (size_t i = 0; path && i < h->files; i++)
        if (!strcmp(h->file[i].path, path)) return;
    if (path && h->files < WF_DOC_FILES) h->file[h->files++] = (struct wf_doc_file){ role, path };
}

/* A file that can no longer be read has no digest. */
static void files_part(struct wf_doc *d, json_t *provenance, const struct wf_doc_head *h)
{
    struct wf_arena a = { 0 };
    json_t *list = wf_doc_put(d, provenance, "files", wf_doc_array(d));
    for (size_t i = 0; i < h->files; i++) {
        char digest[WF_SHA256_TEXT];
        struct wf_err unread = { 0 };
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "role", h->file[i].role);
        wf_doc_text(d, o, "path", h->file[i].path);
        if (!wf_sha256_file(h->file[i].path, &a, digest, &unread)) wf_doc_text(d, o, "sha256", digest);
    }
    wf_arena_free(&a);
}

json_t *wf_doc_begin(struct wf_doc *d, const char *schema, const struct wf_doc_head *h)
{
    json_t *o = wf_doc_object(d), *s = wf_doc_put(d, o, "schema", wf_doc_object(d));
    wf_doc_text(d, s, "name", schema);
    wf_doc_count(d, s, "version", 1);
    wf_doc_text(d, o, "title", h->title);
    wf_doc_text(d, o, "note", h->note);
    json_t *p = wf_doc_put(d, o, "provenance", wf_doc_object(d));
    wf_doc_text(d, p, "program", "windfirm");
    wf_doc_text(d, p, "version", h->version);
    wf_doc_text(d, p, "date", h->date);
    wf_doc_text(d, p, "command", h->command);
    if (h->files) files_part(d, p, h);
    return o;
}

void wf_doc_figure(struct wf_doc *d, json_t *list, const char *name, const char *script, size_t run)
{
    json_t *o = wf_doc_add(d, list, wf_doc_object(d));
    wf_doc_text(d, o, "name", name);
    wf_doc_text(d, o, "script", script);
    wf_doc_count(d, o, "run", run);
}

void wf_doc_said(struct wf_doc *d, json_t *o, const struct wf_said *said)
{
    if (!said) return;
    wf_doc_text(d, o, "message", said->message);
    json_t *list = wf_doc_put(d, o, "args", wf_doc_array(d));
    for (size_t k = 0; k < said->n; k++)
        wf_doc_text(d, wf_doc_add(d, list, wf_doc_object(d)), "text", said->arg[k]);
}

static bool said(const json_t *list, const char *text)
{
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *t = json_string_value(json_object_get(json_array_get(list, i), "text"));
        if (t && !strcmp(t, text)) return true;
    }
    return false;
}

void wf_doc_warnings(struct wf_doc *d, json_t *list, const struct wf_diag *diag)
{
    for (const struct wf_finding *w = diag ? diag->first : NULL; w; w = w->next) {
        if (said(list, w->text)) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "code", w->code);
        wf_doc_text(d, o, "text", w->text);
        wf_doc_said(d, o, w->said);
    }
}

enum wf_status wf_doc_end(struct wf_doc *d, json_t *document, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_begin(&f, folder, "results.json", e);
    if (!s && (d->failed || json_dumpf(document, f.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(12))) &&
        !ferror(f.stream))
        s = wf_fail(e, WF_ENOMEM, "%s: no memory for the document", folder);
    if (!s) {
        putc('\n', f.stream);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    json_decref(document);
    return s;
}

/* A title or a label; what is longer is cut. gnuplot reads lines of some thousand bytes at most. */
enum { TEXT_COLUMNS = 160, TEXT_MAX = 1024 };

enum wf_status wf_plot_data_begin(struct wf_plot_data *p, const char *folder, const char *name,
                                  struct wf_err *e)
{
    char file[64];
    snprintf(file, sizeof file, "plots/%.40s.csv", name);
    *p = (struct wf_plot_data){ 0 };
    enum wf_status s = wf_folder_begin(&p->f, folder, file, e);
    if (!s) fputs("key,index,value\n", p->f.stream);
    return s;
}

void wf_plot_data_number(struct wf_plot_data *p, const char *key, size_t index, double x)
{
    char text[40];
    snprintf(text, sizeof text, "%.15g", x);
    char *e = strchr(text, 'e');
    if (!isfinite(x))
        fprintf(p->f.stream, "%s,%zu,NaN\n", key, index);
    else if (e && !strchr(text, '.')) /* in a text, gnuplot reads 1e-5 as the whole number 1 */
        fprintf(p->f.stream, "%s,%zu,%.*s.0%s\n", key, index, (int)(e - text), text, e);
    else
        fprintf(p->f.stream, "%s,%zu,%s\n", key, index, text);
}

void wf_plot_data_count(struct wf_plot_data *p, const char *key, size_t index, size_t n)
{
    fprintf(p->f.stream, "%s,%zu,%zu\n", key, index, n);
}

/* A quoted cell. gnuplot's reader ends a text at quotes, also single ones, commas and backslashes: they are
 * written as an octal escape. Its SVG keeps "&#" and "]]>" as they are: a word joiner, which takes no room,
 * goes between. */
static void quoted(struct wf_plot_data *p, const char *key, size_t index, const char *text)
{
    static const char joiner[] = "\xE2\x81\xA0";
    FILE *f = p->f.stream;
    fprintf(f, "%s,%zu,\"", key, index);
    for (const char *c = text; *c; c++) {
        if (strchr("\"',\\", *c))
            fprintf(f, "\\%03o", (unsigned)*c);
        else
            fputc((unsigned char)*c < 0x20 ? ' ' : *c, f);
        if (!strncmp(c, "&#", 2) || !strncmp(c, "]>", 2)) fputs(joiner, f);
    }
    fputs("\"\n", f);
}

void wf_plot_data_text(struct wf_plot_data *p, const char *key, size_t index, const char *text)
{
    struct wf_arena a = { 0 };
    const char *bare = wf_text_without_folders(text ? text : "", &a);
    const char *allowed = bare ? wf_text_for_xml(bare, &a) : NULL;
    const char *cut = allowed ? wf_text_shortened(allowed, TEXT_COLUMNS, &a) : NULL;
    p->failed = p->failed || !cut;
    quoted(p, key, index, cut ? cut : "");
    wf_arena_free(&a);
}

void wf_plot_data_words(struct wf_plot_data *p, const char *key, size_t index, const char *words)
{
    quoted(p, key, index, words);
}

void wf_plot_data_print(struct wf_plot_data *p, const char *key, size_t index, const char *fmt, ...)
{
    char text[TEXT_MAX];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    wf_plot_data_text(p, key, index, text);
}

enum wf_status wf_plot_data_parse(struct wf_plot_data *p, const char *key, size_t index, const char *text,
                                  struct wf_err *e)
{
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end) return wf_fail(e, WF_EINPUT, "%s: '%.100s' is not a number", key, text);
    wf_plot_data_number(p, key, index, x);
    return WF_OK;
}

enum wf_status wf_plot_data_end(struct wf_plot_data *p, struct wf_err *e)
{
    if (!p->failed) return wf_file_commit(&p->f, e);
    wf_file_abandon(&p->f);
    return wf_fail(e, WF_ENOMEM, "%s: not enough memory", p->f.path);
}
