/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/fragility.h"
#include "wind/category.h"
#include <math.h>

static double gust(const struct wf_analysis *a, double speed)
{
    return wf_scenario_gust(&a->scenario, speed);
}

/* ---- results.json ---- */

/* The standing of a value; of what is no value of the species, "rule". */
static const char *status_word(const struct wf_varied *v)
{
    return v->factor ? "rule" : wf_standing_text(v->standing);
}

static json_t *varied_part(struct wf_doc *d, const struct wf_interval *i, size_t k)
{
    const struct wf_varied *v = &i->variation.varied[k];
    char key[80];
    json_t *o = wf_doc_object(d);
    (void)snprintf(key, sizeof key, "%s%s", wf_varied_prefix(v), v->name);
    wf_doc_text(d, o, "quantity", key);
    wf_doc_text(d, o, "kind", v->factor ? "factor" : "species");
    wf_doc_text(d, o, "status", status_word(v));
    wf_doc_text(d, o, "source", v->ranged ? "range of the species table" : v->row->source);
    wf_doc_number(d, o, "value", v->value);
    wf_doc_number(d, o, "low", v->low);
    wf_doc_number(d, o, "high", v->high);
    wf_doc_number(d, o, "critical_at_low_m_s", i->arm[k].at_low);
    wf_doc_number(d, o, "critical_at_high_m_s", i->arm[k].at_high);
    wf_doc_flag(d, o, "stands_at_low", !isnan(i->arm[k].at_low));
    wf_doc_flag(d, o, "stands_at_high", !isnan(i->arm[k].at_high));
    return o;
}

static json_t *fit_part(struct wf_doc *d, const struct wf_interval *i)
{
    json_t *o = wf_doc_object(d);
    wf_doc_number(d, o, "median_m_s", i->fit.median);
    wf_doc_number(d, o, "beta", i->fit.beta);
    wf_doc_count(d, o, "censored", i->fit.above);
    return o;
}

static void add_speeds(struct wf_doc *d, json_t *o, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    wf_doc_number(d, o, "middle_m_s", i->middle);
    wf_doc_number(d, o, "low_m_s", i->low);
    wf_doc_number(d, o, "high_m_s", i->high);
    wf_doc_number(d, o, "middle_gust_m_s", gust(a, i->middle));
    wf_doc_number(d, o, "low_gust_m_s", gust(a, i->low));
    wf_doc_number(d, o, "high_gust_m_s", gust(a, i->high));
    wf_doc_number(d, o, "searched_to_m_s", i->searched_to);
    wf_doc_number(d, o, "searched_to_gust_m_s", gust(a, i->searched_to));
    wf_doc_count(d, o, "decimals", (size_t)wf_interval_decimals(i->low, i->high));
}

json_t *wf_part_interval(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    if (!i) return json_null();
    json_t *o = wf_doc_object(d), *list;
    wf_doc_text(d, o, "scope", wf_interval_rooted(a) ? "tree" : "stem");
    wf_doc_count(d, o, "samples", i->request.samples);
    wf_doc_count(d, o, "left_out", i->left_out);
    wf_doc_count(d, o, "lost_in_still_air", i->still);
    wf_doc_count(d, o, "seed", (size_t)i->request.seed);
    add_speeds(d, o, a);
    wf_doc_put(d, o, "lognormal", fit_part(d, i));
    list = wf_doc_put(d, o, "lost_by", wf_doc_array(d));
    for (int c = 0; c < WF_CRITERIA; c++) {
        if (!wf_criteria[c].loses_tree) continue;
        json_t *by = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, by, "criterion", wf_criteria[c].name);
        wf_doc_count(d, by, "samples", i->lost_by[c]);
    }
    list = wf_doc_put(d, o, "safeties", wf_doc_array(d));
    for (size_t k = 0; k < i->winds; k++) {
        json_t *at = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_number(d, at, "speed", i->at[k].speed);
        wf_doc_number(d, at, "low", i->at[k].low);
        wf_doc_number(d, at, "high", i->at[k].high);
    }
    list = wf_doc_put(d, o, "varied", wf_doc_array(d));
    for (size_t k = 0; k < i->variation.n; k++) wf_doc_add(d, list, varied_part(d, i, k));
    return o;
}

/* ---- Tables ---- */

static void cell(FILE *f, double x) { wf_folder_cell(f, x, 6); }

static void curve_table(FILE *f, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    fputs("wind_m_s,gust_m_s,share_lost,share_low,share_high,lognormal\n", f);
    for (size_t k = 0; k < WF_INTERVAL_POINTS; k++) {
        const struct wf_interval_point *p = &i->point[k];
        fprintf(f, "%.6g", p->speed);
        cell(f, gust(a, p->speed)), cell(f, p->share), cell(f, p->below), cell(f, p->above), cell(f, p->fit);
        fputc('\n', f);
    }
}

static void tornado_table(FILE *f, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    fputs("value,kind,status,median,low,high,critical_at_low_m_s,critical_at_high_m_s,stands_at_low,"
          "stands_at_high\n",
          f);
    for (size_t k = 0; k < i->variation.n; k++) {
        const struct wf_varied *v = &i->variation.varied[k];
        fprintf(f, "%s%s,%s,%s", wf_varied_prefix(v), v->name, v->factor ? "factor" : "species",
                status_word(v));
        cell(f, v->value), cell(f, v->low), cell(f, v->high);
        cell(f, i->arm[k].at_low), cell(f, i->arm[k].at_high);
        fprintf(f, ",%d,%d\n", !isnan(i->arm[k].at_low), !isnan(i->arm[k].at_high));
    }
}

static void samples_table(FILE *f, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    fputs("rank,critical_wind_m_s,critical_gust_m_s\n", f);
    for (size_t k = 0; k < i->n; k++) {
        fprintf(f, "%zu", k + 1);
        cell(f, i->critical[k]), cell(f, gust(a, i->critical[k]));
        fputc('\n', f);
    }
}

static enum wf_status table(const struct wf_analysis *a, const char *folder, const char *name,
                            void (*write)(FILE *f, const struct wf_analysis *a), struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_begin(&f, folder, name, e);
    if (s) return s;
    write(f.stream, a);
    return wf_file_commit(&f, e);
}

/* ---- The whole ---- */

static void plot_data(struct wf_plot_data *p, const struct wf_analysis *a)
{
    const struct wf_interval *i = a->interval;
    wf_plot_data_number(p, "LOW", 0, i->low);
    wf_plot_data_number(p, "HIGH", 0, i->high);
    wf_plot_data_number(p, "MIDDLE", 0, i->middle);
    wf_plot_data_number(p, "FIT", 0, i->fit.median);
    wf_plot_data_number(p, "END", 0, i->point[WF_INTERVAL_POINTS - 1].speed);
    wf_plot_data_number(p, "REFERENCE", 0, wf_scenario_place(&a->scenario).height);
    wf_plot_data_count(p, "WINDS", 0, a->n);
    for (size_t k = 0; k < a->n; k++) wf_plot_data_number(p, "WIND", k + 1, a->at[k].speed);
}

static enum wf_status document(const struct wf_analysis *a, const char *name, const char *name_zh,
                               const struct wf_diag *findings, const struct wf_doc_head *head,
                               const char *folder, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    const struct wf_wind_place place = wf_scenario_place(&a->scenario);
    json_t *o = wf_doc_begin(&d, "windfirm-fragility", head);
    wf_doc_text(&d, o, "name", name);
    wf_doc_text(&d, o, "name_zh", name_zh);
    wf_doc_text(&d, o, "wind_terrain", place.terrain->name);
    wf_doc_number(&d, o, "reference_height_m", place.height);
    wf_doc_put(&d, o, "interval", wf_part_interval(&d, a));
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), findings);
    json_t *figures = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    wf_doc_figure(&d, figures, "fragility", "fragility", 1);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_fragility_write(const struct wf_analysis *a, const char *name, const char *name_zh,
                                  const struct wf_diag *findings, const struct wf_doc_head *head,
                                  const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_folder_make(folder, e);
    if (!s) s = table(a, folder, "tables/fragility.csv", curve_table, e);
    if (!s) s = table(a, folder, "tables/tornado.csv", tornado_table, e);
    if (!s) s = table(a, folder, "tables/samples.csv", samples_table, e);
    if (!s) s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    plot_data(&p, a);
    s = wf_plot_data_end(&p, e);
    return s ? s : document(a, name, name_zh, findings, head, folder, e);
}
