/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/explain.h"
#include "data/species.h"
#include "out/doc.h"
#include "out/inputs.h"
#include <math.h>

static void row(FILE *f, const struct wf_explained *x, size_t b)
{
    const struct wf_explain_axis *o = &x->of->axis[b];
    fprintf(f, "%zu,%zu,%d,%lld,%.6g,%.6g,%.6g,%.6g", x->run, b + 1, (int)o->level,
            (long long)x->tree->id[o->first], o->height, o->length, o->radius, o->beam);
    for (size_t m = 0; m < x->of->methods; m++)
        isfinite(o->ratio[m]) ? fprintf(f, ",%.6g", o->ratio[m]) : fputc(',', f);
    fputc('\n', f);
}

static void table(FILE *f, const struct wf_explained *x, size_t n)
{
    fputs("run,branch,level,segment,base_height_m,length_m,base_radius_m,beam_m", f);
    for (size_t m = 0; n && m < x->of->methods; m++) fprintf(f, ",%s", x->of->method[m]->name);
    fputc('\n', f);
    for (size_t i = 0; i < n; i++)
        for (size_t b = 0; b < x[i].of->axes; b++) row(f, &x[i], b);
}

/* Does a method have a ratio that a logarithmic scale can show? */
static bool answers(const struct wf_explain *x, size_t method)
{
    for (size_t b = 0; b < x->axes; b++)
        if (x->axis[b].ratio[method] > 0 && isfinite(x->axis[b].ratio[method])) return true;
    return false;
}

void wf_explain_plot_data(const struct wf_explained *x, size_t n, struct wf_plot_data *p)
{
    double low = 0.5, high = 2;
    int32_t top = 0;
    char key[32];
    for (size_t i = 0; i < n; i++)
        for (size_t b = 0; b < x[i].of->axes; b++)
            for (size_t m = 0; m < x[i].of->methods; m++) {
                const struct wf_explain_axis *o = &x[i].of->axis[b];
                top = o->level > top ? o->level : top;
                if (o->ratio[m] > 0 && isfinite(o->ratio[m]))
                    low = fmin(low, o->ratio[m]), high = fmax(high, o->ratio[m]);
            }
    wf_plot_data_count(p, "METHODS", 0, x->of->methods);
    wf_plot_data_count(p, "FIRST", 0, 8); /* columns before those of the methods */
    wf_plot_data_count(p, "EXPLAIN_LEVELS", 0, (size_t)top + 1);
    wf_plot_data_number(p, "LOW", 0, pow(10, floor(log10(low))));
    wf_plot_data_number(p, "HIGH", 0, pow(10, ceil(log10(high))));
    for (size_t m = 0; m < x->of->methods; m++) wf_plot_data_text(p, "METHOD", m + 1, x->of->method[m]->name);
    for (size_t i = 0; i < n; i++) {
        size_t k = 0;
        snprintf(key, sizeof key, "ANSWERS_%zu", x[i].run);
        for (size_t m = 0; m < x[i].of->methods; m++)
            if (answers(x[i].of, m)) wf_plot_data_count(p, key, ++k, m + 1);
    }
}

enum wf_status wf_explain_tables(const struct wf_explained *x, size_t n, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_make(folder, e);
    if (!s) s = wf_folder_begin(&f, folder, "tables/explain.csv", e);
    if (!s) table(f.stream, x, n), s = wf_file_commit(&f, e);
    return s;
}

static json_t *level_part(struct wf_doc *d, const struct wf_explain *x, int32_t level)
{
    json_t *o = wf_doc_object(d), *list = wf_doc_put(d, o, "methods", wf_doc_array(d));
    struct wf_explain_spread s = { 0 };
    for (size_t m = 0; m < x->methods; m++) {
        wf_explain_spread(x, m, level, &s);
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "answers", s.answers);
        wf_doc_number(d, q, "middle", s.middle);
        wf_doc_number(d, q, "low", s.low);
        wf_doc_number(d, q, "high", s.high);
    }
    wf_doc_count(d, o, "branches", s.branches);
    return o;
}

static json_t *branch_part(struct wf_doc *d, const struct wf_explain *x, size_t b)
{
    const struct wf_explain_axis *a = &x->axis[b];
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "number", b + 1);
    wf_doc_count(d, o, "level", a->level > 0 ? (size_t)a->level : 0);
    wf_doc_number(d, o, "height", a->height);
    wf_doc_number(d, o, "length", a->length);
    wf_doc_number(d, o, "beam", a->beam);
    wf_doc_numbers(d, o, "ratios", a->ratio, x->methods);
    return o;
}

json_t *wf_explain_part(struct wf_doc *d, const struct wf_explained *x)
{
    enum { SHOWN = 24 }; /* branches on the page; all are in the table */
    const struct wf_explain *of = x->of;
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "run", x->run);
    wf_doc_text(d, o, "name", x->name);
    wf_doc_text(d, o, "species", x->species->key);
    wf_doc_text(d, o, "species_name", x->species->name);
    wf_doc_text(d, o, "species_zh", x->species->name_zh);
    if (x->model) wf_doc_text(d, o, "model_name", x->model);
    wf_doc_number(d, o, "speed", x->speed);
    json_t *methods = wf_doc_put(d, o, "methods", wf_doc_array(d));
    for (size_t m = 0; m < of->methods; m++) {
        json_t *q = wf_doc_add(d, methods, wf_doc_object(d));
        wf_doc_text(d, q, "name", of->method[m]->name);
        wf_doc_number(d, q, "tip", of->tip[m]);
        wf_doc_number(d, q, "within_5_percent", wf_explain_share(of, m, 0.05));
    }
    json_t *levels = wf_doc_put(d, o, "levels", wf_doc_array(d));
    for (int32_t l = 0; l <= wf_explain_top(of); l++) wf_doc_add(d, levels, level_part(d, of, l));
    wf_doc_count(d, o, "branch_count", of->axes);
    json_t *branches = wf_doc_put(d, o, "branches", wf_doc_array(d));
    for (size_t b = 0; b < of->axes && b < SHOWN; b++) wf_doc_add(d, branches, branch_part(d, of, b));
    return o;
}

void wf_explain_figure(struct wf_doc *d, json_t *list, const struct wf_explained *x)
{
    char name[32];
    snprintf(name, sizeof name, "explain_%zu", x->run);
    wf_doc_figure(d, list, name, "explain", x->run);
}

static enum wf_status document(const struct wf_explained *x, const struct wf_doc_head *head,
                               const char *folder, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-explain", head);
    wf_doc_put(&d, o, "scenario", wf_part_site(&d, x->scenario));
    json_t *list = wf_doc_put(&d, o, "explained", wf_doc_array(&d));
    wf_doc_add(&d, list, wf_explain_part(&d, x));
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), x->findings);
    wf_explain_figure(&d, wf_doc_put(&d, o, "figures", wf_doc_array(&d)), x);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_explain_write(const struct wf_explained *x, const struct wf_doc_head *head,
                                const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_explain_tables(x, 1, folder, e);
    if (!s) s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    wf_explain_plot_data(x, 1, &p);
    s = wf_plot_data_end(&p, e);
    return s ? s : document(x, head, folder, e);
}
