/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/fit_results.h"
#include "base/file.h"
#include "data/species.h"
#include "load/drag.h"
#include "out/doc.h"
#include <math.h>
#include <string.h>

/* results.json, tables and plot data of a calibration. */

static void cell(FILE *f, double x)
{
    if (isfinite(x))
        fprintf(f, ",%.9g", x);
    else
        fputc(',', f);
}

static void parameters(FILE *f, const struct wf_fit_results *of)
{
    fputs("parameter,unit,value,low_95,high_95,profile_low_95,profile_high_95,bootstrap_low_95,bootstrap_"
          "high_95,at_bound,"
          "nuisance\n",
          f);
    for (size_t k = 0; k < of->fit.params; k++) {
        const struct wf_estimate *q = &of->fit.estimate[k];
        double u;
        const char *unit = wf_param_unit(&of->x, &of->param[k], &u);
        fprintf(f, "%s,%s", of->param[k].name, unit);
        cell(f, q->value * u), cell(f, q->low * u), cell(f, q->high * u), cell(f, q->profile_low * u);
        cell(f, q->profile_high * u), cell(f, q->resampled_low * u), cell(f, q->resampled_high * u);
        fprintf(f, ",%s,%d\n",
                q->at_low    ? "low"
                : q->at_high ? "high"
                             : "",
                wf_param_nuisance(&of->param[k]));
    }
}

static size_t group_of(const struct wf_fit *f, const struct wf_fit_datum *d)
{
    size_t g = 0;
    while (f->group[g].test != d->test || f->group[g].sensor != d->sensor) g++;
    return g + 1;
}

static void readings(FILE *f, const struct wf_fit_results *of)
{
    fputs("group,test,sensor,kind,unit,time_s,load,load_unit,line,measured,predicted,band_95,sigma,residual,"
          "influence_sd,"
          "influenced\n",
          f);
    for (size_t n = 0; n < of->fit.groups * of->x.data;
         n++) { /* sensor by sensor, so that a figure can draw lines */
        size_t i = n % of->x.data;
        const struct wf_fit_datum *d = &of->x.datum[i];
        if (group_of(&of->fit, d) != 1 + n / of->x.data) continue;
        const struct wf_fit_test *t = &of->x.test[d->test];
        const struct wf_fit_input *in = &of->input[d->test];
        const struct wf_sensor_row *r = &wf_sensor_rows[t->sensor[d->sensor].kind];
        fprintf(f, "%zu,%s,%s,%s,%s", group_of(&of->fit, d), t->name, t->sensor[d->sensor].name, r->name,
                r->unit);
        cell(f, t->state[d->state].time), cell(f, t->state[d->state].load * in->load_factor);
        fprintf(f, ",%s,%zu", in->load_unit, d->line);
        cell(f, d->value * r->factor), cell(f, of->fit.reading[i] * r->factor),
            cell(f, of->fit.band[i] * r->factor);
        cell(f, of->fit.sigma[i] * r->factor), cell(f, of->fit.residual[i]), cell(f, of->fit.influence[i]);
        fprintf(f, ",%s\n", of->fit.free ? of->param[of->fit.influenced[i]].name : "");
    }
}

static void profiles(FILE *f, const struct wf_fit_results *of)
{
    fputs("parameter,unit,value,rise\n", f);
    for (size_t k = 0; k < of->fit.free; k++)
        for (size_t i = 0; i < of->fit.estimate[k].points; i++) {
            double u;
            const char *unit = wf_param_unit(&of->x, &of->param[k], &u);
            fprintf(f, "%zu,%s", k + 1, unit);
            cell(f, of->fit.estimate[k].point[i].value * u), cell(f, of->fit.estimate[k].point[i].rise);
            fputc('\n', f);
        }
}

/* Rows as measured: load and first reading, and whether they took part; for sway the samples and the fitted
 * curve. */
static void test_data(FILE *f, const struct wf_fit_results *of)
{
    fputs("test,time_s,load,first,used,fitted\n", f);
    for (size_t k = 0; k < of->x.tests; k++) {
        const struct wf_fit_input *in = &of->input[k];
        const struct wf_test_data *r = &in->data;
        double start = NAN;
        for (size_t i = 0; i < r->n; i++) {
            if (isnan(start) && r->used[i]) start = r->time[i];
            fprintf(f, "%zu", k + 1);
            cell(f, r->time[i]), cell(f, r->value[i * r->columns] * in->load_factor);
            cell(f, r->columns > 1 ? r->value[i * r->columns + 1] : (double)NAN);
            fprintf(f, ",%d", r->used[i]);
            cell(f, in->swung && r->used[i] ? wf_ring_down_at(&in->sway, r->time[i] - start) : (double)NAN);
            fputc('\n', f);
        }
    }
}

static size_t tests_with_data(const struct wf_fit_results *of)
{
    size_t n = 0;
    for (size_t k = 0; k < of->x.tests; k++) n += of->input[k].data.n > 0;
    return n;
}

/* "name (unit)", or the name alone. */
static void axis_label(struct wf_plot_data *p, const char *key, size_t k, const char *name, const char *unit)
{
    wf_plot_data_print(p, key, k, *unit ? "%s (%s)" : "%s", name, unit);
}

static void plot_groups(struct wf_plot_data *p, const struct wf_fit_results *of)
{
    for (size_t g = 0; g < of->fit.groups; g++) {
        const struct wf_fit_test *t = &of->x.test[of->fit.group[g].test];
        const struct wf_sensor_row *r = &wf_sensor_rows[t->sensor[of->fit.group[g].sensor].kind];
        const struct wf_fit_input *in = &of->input[of->fit.group[g].test];
        wf_plot_data_print(p, "GROUP", g + 1, "%s: %s", t->name, t->sensor[of->fit.group[g].sensor].name);
        wf_plot_data_text(p, "GROUP_KIND", g + 1, r->name);
        wf_plot_data_text(p, "GROUP_UNIT", g + 1, r->unit);
        wf_plot_data_text(p, "LOAD", g + 1, in->load_name);
        wf_plot_data_text(p, "LOAD_UNIT", g + 1, in->load_unit);
    }
}

static void plot_parameters(struct wf_plot_data *p, const struct wf_fit_results *of)
{
    for (size_t k = 0; k < of->fit.free; k++) {
        double u;
        const char *unit = wf_param_unit(&of->x, &of->param[k], &u);
        const struct wf_estimate *q = &of->fit.estimate[k];
        bool known = !isnan(q->low) && !isnan(q->high);
        axis_label(p, "PARAM", k + 1, of->param[k].name, unit);
        wf_plot_data_number(p, "VALUE", k + 1, q->value * u);
        wf_plot_data_count(p, "LOGGED", k + 1, wf_fit_quantities[of->param[k].quantity].log);
        wf_plot_data_number(p, "LOW", k + 1, known ? q->low * u : NAN);
        wf_plot_data_number(p, "HIGH", k + 1, known ? q->high * u : NAN);
    }
}

static void plot_data(struct wf_plot_data *p, const struct wf_fit_results *of)
{
    size_t profiled = 0;
    for (size_t k = 0; k < of->fit.free; k++) profiled += of->fit.estimate[k].points > 1;
    wf_plot_data_count(p, "GROUPS", 0, of->fit.groups);
    wf_plot_data_count(p, "PARAMS", 0, of->fit.free);
    wf_plot_data_count(p, "PROFILED", 0, profiled);
    wf_plot_data_count(p, "TESTS", 0, of->x.tests);
    wf_plot_data_count(p, "RECORDED", 0, tests_with_data(of));
    wf_plot_data_number(p, "LIMIT", 0, of->fit.quantile * of->fit.quantile);
    plot_groups(p, of);
    plot_parameters(p, of);
    for (size_t k = 0; k < of->x.tests; k++) {
        wf_plot_data_text(p, "TEST", k + 1, of->x.test[k].name);
        wf_plot_data_text(p, "TEST_LOAD", k + 1, of->input[k].swung ? "record" : of->input[k].load_name);
        wf_plot_data_text(p, "TEST_UNIT", k + 1, of->input[k].load_unit);
        wf_plot_data_count(p, "SWAY", k + 1, of->input[k].swung);
    }
}

static json_t *estimate(struct wf_doc *d, const struct wf_fit *f, size_t k)
{
    const struct wf_estimate *q = &f->estimate[k];
    double u;
    const char *unit = wf_param_unit(f->x, &f->param[k], &u);
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "name", f->param[k].name);
    wf_doc_text(d, o, "unit", unit);
    wf_doc_text(d, o, "meaning", wf_fit_quantities[f->param[k].quantity].doc);
    wf_doc_flag(d, o, "nuisance", wf_param_nuisance(&f->param[k]));
    wf_doc_text(d, o, "bound", q->at_low ? "lower" : q->at_high ? "upper" : NULL);
    const struct {
        const char *key;
        double v;
    } number[] = { { "value", q->value },
                   { "low", q->low },
                   { "high", q->high },
                   { "profile_low", q->profile_low },
                   { "profile_high", q->profile_high },
                   { "bootstrap_low", q->resampled_low },
                   { "bootstrap_high", q->resampled_high },
                   { "start", f->param[k].start },
                   { "bound_low", f->param[k].low },
                   { "bound_high", f->param[k].high } };
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        wf_doc_number(d, o, number[i].key, number[i].v * u);
    wf_doc_numbers(d, o, "correlation", f->correlation + k * f->params, f->free);
    return o;
}

static void fit_part(struct wf_doc *d, json_t *o, const struct wf_fit *f)
{
    json_t *list = wf_doc_put(d, o, "parameters", wf_doc_array(d));
    for (size_t k = 0; k < f->params; k++) wf_doc_add(d, list, estimate(d, f, k));
    wf_doc_count(d, o, "readings", f->x->data);
    wf_doc_count(d, o, "freedom", f->freedom);
    wf_doc_number(d, o, "chi_square", f->chi_square);
    wf_doc_number(d, o, "reduced_chi_square", f->reduced);
    wf_doc_flag(d, o, "sigma_estimated", f->sigma_estimated);
    wf_doc_count(d, o, "starts", f->starts);
    wf_doc_count(d, o, "starts_same", f->starts_same);
    wf_doc_count(d, o, "resampled", f->resampled);
    wf_doc_flag(d, o, "converged", f->lsq.converged);
    wf_doc_flag(d, o, "stopped", f->lsq.stopped);
    json_t *loose = wf_doc_put(d, o, "not_determined", wf_doc_array(d));
    for (size_t i = 0; i < f->loose_n; i++) {
        json_t *l = wf_doc_add(d, loose, wf_doc_object(d));
        wf_doc_text(d, l, "text", f->loose[i].text);
        wf_doc_number(d, l, "sd", f->loose[i].sd);
    }
    json_t *groups = wf_doc_put(d, o, "sensors", wf_doc_array(d));
    for (size_t i = 0; i < f->groups; i++) {
        const struct wf_fit_group *g = &f->group[i];
        const struct wf_fit_test *t = &f->x->test[g->test];
        const struct wf_fit_sensor *s = &t->sensor[g->sensor];
        const struct wf_sensor_row *r = &wf_sensor_rows[s->kind];
        json_t *q = wf_doc_add(d, groups, wf_doc_object(d));
        wf_doc_text(d, q, "test", t->name), wf_doc_text(d, q, "tree", f->x->tree[t->tree].name);
        wf_doc_text(d, q, "sensor", s->name), wf_doc_text(d, q, "kind", r->name),
            wf_doc_text(d, q, "unit", r->unit);
        wf_doc_number(d, q, "height", r->placed ? s->height : (double)NAN),
            wf_doc_count(d, q, "readings", g->n);
        wf_doc_number(d, q, "sigma", g->sigma * r->factor), wf_doc_number(d, q, "rms", g->rms * r->factor);
        wf_doc_number(d, q, "correlation", g->correlation), wf_doc_flag(d, q, "estimated", s->estimated);
    }
}

/* What the shape of a tree was taken as. */
static const char *rest_of(const struct wf_fit_tree *t)
{
    if (!(t->loads.gravity > 0)) return "weightless";
    return t->tree.standing ? "as-drawn" : "stress-free";
}

static json_t *document(struct wf_doc *d, const struct wf_fit_results *of)
{
    json_t *o = wf_doc_object(d), *schema = wf_doc_put(d, o, "schema", wf_doc_object(d));
    wf_doc_text(d, schema, "name", "windfirm-fit");
    wf_doc_count(d, schema, "version", 1);
    wf_doc_text(d, o, "title", of->calibration.name), wf_doc_text(d, o, "note", of->calibration.note);
    wf_doc_text(d, o, "source", of->calibration.source),
        wf_doc_text(d, o, "reference", of->calibration.reference);
    wf_doc_text(d, o, "version", WF_VERSION), wf_doc_text(d, o, "date", of->date);
    wf_doc_text(d, o, "command", of->command), wf_doc_text(d, o, "loss", of->loss);
    wf_doc_flag(d, o, "priors", of->priors);
    json_t *files = wf_doc_put(d, o, "files", wf_doc_array(d));
    for (size_t i = 0; i < of->files; i++) {
        json_t *f = wf_doc_add(d, files, wf_doc_object(d));
        wf_doc_text(d, f, "role", of->file[i].role), wf_doc_text(d, f, "path", of->file[i].path);
        wf_doc_text(d, f, "sha256", of->file[i].sha256);
    }
    json_t *trees = wf_doc_put(d, o, "trees", wf_doc_array(d));
    for (size_t k = 0; k < of->x.trees; k++) {
        json_t *t = wf_doc_add(d, trees, wf_doc_object(d));
        wf_doc_text(d, t, "name", of->x.tree[k].name),
            wf_doc_text(d, t, "species", of->x.tree[k].species->name);
        wf_doc_number(d, t, "height", of->x.tree[k].height),
            wf_doc_count(d, t, "segments", of->x.tree[k].tree.n);
        wf_doc_text(d, t, "rest", rest_of(&of->x.tree[k]));
    }
    wf_doc_count(d, o, "records", tests_with_data(of));
    json_t *sways = wf_doc_put(d, o, "sways", wf_doc_array(d));
    for (size_t k = 0; k < of->x.tests; k++) {
        const struct wf_ring_down *s = &of->input[k].sway;
        if (!of->input[k].swung) continue;
        json_t *q = wf_doc_add(d, sways, wf_doc_object(d));
        wf_doc_text(d, q, "test", of->x.test[k].name), wf_doc_number(d, q, "frequency", s->frequency);
        wf_doc_number(d, q, "frequency_sd", s->frequency_sd),
            wf_doc_number(d, q, "damping", 100 * s->damping);
        wf_doc_number(d, q, "damping_sd", 100 * s->damping_sd),
            wf_doc_number(d, q, "explained", 100 * s->explained);
    }
    fit_part(d, wf_doc_put(d, o, "fit", wf_doc_object(d)), &of->fit);
    if (of->rival.made) {
        json_t *r = wf_doc_put(d, o, "rival", wf_doc_object(d));
        wf_doc_text(d, r, "text", of->rival.text);
        wf_doc_number(d, r, "aicc", of->rival.aicc), wf_doc_number(d, r, "own_aicc", of->rival.own);
        fit_part(d, r, &of->rival.fit);
    }
    json_t *w = wf_doc_put(d, o, "warnings", wf_doc_array(d));
    for (const struct wf_finding *f = of->diag.first; f; f = f->next) {
        json_t *q = wf_doc_add(d, w, wf_doc_object(d));
        wf_doc_text(d, q, "code", f->code), wf_doc_text(d, q, "text", f->text);
        wf_doc_said(d, q, f->said);
    }
    return o;
}

static void results(FILE *f, const struct wf_fit_results *of)
{
    struct wf_doc d = { 0 };
    json_t *o = document(&d, of);
    if (!d.failed) json_dumpf(o, f, JSON_INDENT(1) | JSON_REAL_PRECISION(12));
    json_decref(o);
    fputc('\n', f);
}

enum wf_status wf_fit_results_write(const struct wf_fit_results *of, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(FILE *f, const struct wf_fit_results *of);
    } part[] = { { "tables/parameters.csv", parameters },
                 { "tables/readings.csv", readings },
                 { "tables/profiles.csv", profiles },
                 { "tables/records.csv", test_data },
                 { "results.json", results } };
    enum wf_status status = wf_folder_make(folder, e);
    for (size_t i = 0; i < sizeof part / sizeof *part && !status; i++) {
        struct wf_file f = { 0 };
        status = wf_folder_begin(&f, folder, part[i].name, e);
        if (status) break;
        part[i].write(f.stream, of);
        status = wf_file_commit(&f, e);
    }
    struct wf_plot_data p;
    if (!status) status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    plot_data(&p, of);
    return wf_plot_data_end(&p, e);
}
