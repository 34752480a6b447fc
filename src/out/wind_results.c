/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/wind_results.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "out/doc.h"
#include "wind/climate.h"
#include "wind/gust_spectral.h"
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

struct keyed {
    const char *key;
    double x;
};

/* A cell; empty where there is no number. */
static void cell(FILE *f, double value, const char *format)
{
    fputc(',', f);
    if (isfinite(value)) fprintf(f, format, value);
}

static void histories(FILE *f, const struct wf_gust_report *r)
{
    const struct wf_gust_spec *s = &r->spec;
    static const char *const name[WF_COMPONENTS] = { "u", "v", "w" };
    fputs("t_s", f);
    for (size_t p = 0; p < s->points; p++)
        for (unsigned c = 0; c < s->components; c++) fprintf(f, ",%s%zu_m_s", name[c], p + 1);
    fputc('\n', f);
    for (size_t i = 0; i < s->steps; i++) {
        fprintf(f, "%.7g", (double)i * s->step);
        for (size_t p = 0; p < s->points; p++)
            for (unsigned c = 0; c < s->components; c++)
                cell(f, r->x[(c * s->points + p) * s->steps + i], "%.6g");
        fputc('\n', f);
    }
}

static void spectrum(FILE *f, const struct wf_gust_report *r)
{
    static const char *const name[WF_COMPONENTS] = { "along", "across", "up" };
    fputs("component,frequency_hz,low_hz,high_hz,density_m2_s,target_m2_s,relative_scatter\n", f);
    for (unsigned c = 0; c < r->spec.components; c++)
        for (size_t b = 0; b < r->bands; b++) {
            fprintf(f, "%s,%.7g,%.7g,%.7g", name[c], r->band[b].centre, r->band[b].low, r->band[b].high);
            cell(f, r->density[c][b], "%.7g");
            cell(f, r->target[c][b], "%.7g");
            cell(f, r->scatter[b], "%.4g");
            fputc('\n', f);
        }
}

/* Density per m/s, beside that of a normal distribution of the same mean and deviation. */
static void histogram(FILE *f, const struct wf_gust_report *r)
{
    const struct wf_gust_stats *s = &r->stats[0];
    fputs("speed_m_s,density_s_m,normal_s_m\n", f);
    for (size_t b = 0; b < WF_REPORT_BINS; b++) {
        double u = r->bin_low + ((double)b + 0.5) * r->bin_width, z = (u - s->mean) / s->deviation;
        fprintf(f, "%.6g,%.6g", u, (double)r->bin[b] / ((double)r->spec.steps * r->bin_width));
        cell(f, 0.39894228040143268 * exp(-0.5 * z * z) / s->deviation, "%.6g");
        fputc('\n', f);
    }
}

static void coherence(FILE *f, const struct wf_gust_report *r)
{
    fputs("point,distance_m,frequency_hz,coherence,target\n", f);
    for (size_t p = 0; p < r->pairs && r->coherence; p++)
        for (size_t b = 0; b < r->pair_bands; b++) {
            fprintf(f, "%zu,%.6g,%.6g", p + 2, r->apart[p], r->pair_band[b].centre);
            cell(f, r->coherence[p * r->pair_bands + b], "%.5g");
            cell(f, r->coherence_target[p * r->pair_bands + b], "%.5g");
            fputc('\n', f);
        }
}

static void plot_data(struct wf_plot_data *p, const struct wf_gust_report *r)
{
    const struct wf_gust_spec *s = &r->spec;
    wf_plot_data_text(p, "MODEL", 0, s->model->name);
    wf_plot_data_number(p, "MEAN", 0, r->stats[0].mean);
    wf_plot_data_number(p, "DURATION", 0, (double)s->steps * s->step);
    wf_plot_data_number(p, "STEP", 0, s->step);
    wf_plot_data_count(p, "COMPONENTS", 0, s->components);
    wf_plot_data_count(p, "POINTS", 0, s->points);
    wf_plot_data_count(p, "PAIRS", 0, r->coherence ? r->pairs : 0);
    wf_plot_data_count(p, "TARGET", 0, s->model->spectrum != NULL);
    wf_plot_data_number(p, "SPEED", 0, s->speed);
}

static void put_numbers(struct wf_doc *d, json_t *o, const struct keyed *x, size_t n)
{
    for (size_t i = 0; i < n; i++) wf_doc_number(d, o, x[i].key, x[i].x);
}
#define PUT(d, o, list) put_numbers(d, o, list, sizeof list / sizeof *list)

static json_t *statistics_part(struct wf_doc *d, const struct wf_gust_stats *t)
{
    const struct keyed x[] = { { "mean_m_s", t->mean },
                               { "deviation_m_s", t->deviation },
                               { "intensity", t->intensity },
                               { "lowest_m_s", t->low },
                               { "highest_m_s", t->high },
                               { "skewness", t->skewness },
                               { "kurtosis", t->kurtosis },
                               { "time_scale_s", t->time_scale },
                               { "length_scale_m", t->length_scale },
                               { "gust_factor", t->gust_factor },
                               { "gust_window_s", t->gust_window },
                               { "gust_period_s", t->period },
                               { "gust_periods", (double)t->periods },
                               { "peak_factor", t->peak_factor } };
    json_t *o = wf_doc_object(d);
    PUT(d, o, x);
    return o;
}

static json_t *model_part(struct wf_doc *d, const struct wf_gust_spec *s)
{
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "name", s->model->name);
    wf_doc_text(d, o, "title", s->model->title);
    wf_doc_text(d, o, "source", s->model->source);
    wf_doc_text(d, o, "validity", s->model->validity);
    wf_doc_text(d, o, "differs", s->model->corrected);
    wf_doc_flag(d, o, "spectral", s->model->spectrum != NULL);
    json_t *list = wf_doc_put(d, o, "parameters", wf_doc_array(d));
    for (size_t i = 0; s->model->par[i].name; i++) {
        json_t *p = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, p, "name", s->model->par[i].name);
        wf_doc_text(d, p, "unit", s->model->par[i].unit);
        wf_doc_text(d, p, "meaning", s->model->par[i].help);
        wf_doc_number(d, p, "value", s->value[i]);
    }
    return o;
}

static enum wf_status wind_document(const struct wf_gust_report *r, const struct wf_doc_head *head,
                                    const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    const struct wf_gust_spec *s = &r->spec;
    const struct wf_wind_grade *grade = wf_wind_scale_grade(&wf_wind_scales[0], r->stats[0].mean);
    const struct keyed x[] = { { "speed_m_s", s->speed },       { "height_m", s->height },
                               { "step_s", s->step },           { "steps", (double)s->steps },
                               { "points", (double)s->points }, { "components", (double)s->components },
                               { "joint", r->joint },           { "coherence_error", r->coherence_error } };
    char seed[24];
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-wind", head);
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)s->seed);
    wf_doc_text(&d, o, "seed", seed);
    wf_doc_put(&d, o, "model", model_part(&d, s));
    PUT(&d, o, x);
    wf_doc_text(&d, o, "beaufort", grade->name);
    wf_doc_text(&d, o, "beaufort_text", grade->text);
    json_t *list = wf_doc_put(&d, o, "statistics", wf_doc_array(&d));
    for (unsigned c = 0; c < s->components; c++) wf_doc_add(&d, list, statistics_part(&d, &r->stats[c]));
    list = wf_doc_put(&d, o, "findings", wf_doc_array(&d));
    for (size_t i = 0; i < r->findings; i++) {
        const struct wf_gust_finding *f = &r->finding[i];
        json_t *q = wf_doc_add(&d, list, wf_doc_object(&d));
        const struct keyed y[] = { { "asked", f->asked }, { "got", f->got }, { "scatter", f->scatter } };
        wf_doc_text(&d, q, "name", f->name), wf_doc_text(&d, q, "unit", f->unit);
        PUT(&d, q, y);
        wf_doc_flag(&d, q, "within", f->within);
    }
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), diag);
    list = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    wf_doc_figure(&d, list, "wind", "wind", 0);
    if (r->coherence) wf_doc_figure(&d, list, "wind_coherence", "wind_coherence", 0);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_wind_results_write(const struct wf_gust_report *r, const struct wf_doc_head *head,
                                     const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(FILE *f, const struct wf_gust_report *r);
    } table[] = { { "tables/series.csv", histories },
                  { "tables/spectrum.csv", spectrum },
                  { "tables/histogram.csv", histogram },
                  { "tables/coherence.csv", coherence } };
    enum wf_status status = wf_folder_make(folder, e);
    for (size_t i = 0; i < sizeof table / sizeof table[0] && !status; i++) {
        struct wf_file f = { 0 };
        status = wf_folder_begin(&f, folder, table[i].name, e);
        if (status) break;
        table[i].write(f.stream, r);
        status = wf_file_commit(&f, e);
    }
    struct wf_plot_data p;
    if (!status) status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    plot_data(&p, r);
    status = wf_plot_data_end(&p, e);
    return status ? status : wind_document(r, head, diag, folder, e);
}

const double wf_rose_classes[WF_ROSE_CLASSES] = { 5.0, 10.0, 15.0, 20.0 };

static json_t *rose_row(struct wf_doc *d, const struct wf_rose *r, size_t s)
{
    bool all = s == r->sectors;
    const struct keyed x[] = { { "from_deg", all ? NAN : 57.295779513082321 * r->from[s] },
                               { "frequency", all ? 1.0 : r->frequency[s] },
                               { "mean_m_s", all ? wf_rose_mean(r) : wf_rose_sector_mean(r, s) },
                               { "shape", all ? NAN : r->shape[s] } };
    double hours[WF_ROSE_CLASSES];
    for (int k = 0; k < WF_ROSE_CLASSES; k++)
        hours[k] = 8766.0 * (all ? wf_rose_above(r, wf_rose_classes[k])
                                 : r->frequency[s] * wf_rose_sector_above(r, s, wf_rose_classes[k]));
    json_t *o = wf_doc_object(d);
    PUT(d, o, x);
    wf_doc_numbers(d, o, "hours_a_year_above", hours, WF_ROSE_CLASSES);
    return o;
}

/* What a record has, and what was fitted to it; the last fit is that of all directions. */
static void record_part(struct wf_doc *d, json_t *to, const struct wf_rose_record *r)
{
    const double valid = (double)(r->n + r->calm);
    const struct keyed x[] = { { "calm_share", (double)r->calm / valid },
                               { "undirected_share", (double)r->undirected / valid },
                               { "undirected_most_m_s", r->undirected_most },
                               { "largest_m_s", r->speed[r->n - 1] },
                               { "direction_step_deg", r->step } };
    json_t *o = wf_doc_put(d, to, "record", wf_doc_object(d));
    wf_doc_count(d, o, "rows", r->rows);
    wf_doc_count(d, o, "directed", r->directed);
    wf_doc_count(d, o, "calm", r->calm);
    wf_doc_count(d, o, "undirected", r->undirected);
    wf_doc_count(d, o, "without_speed", r->missing + r->unreadable);
    PUT(d, o, x);
    double counted[WF_ROSE_CLASSES];
    for (int k = 0; k < WF_ROSE_CLASSES; k++)
        counted[k] = 8766.0 * wf_rose_record_above(r, wf_rose_classes[k]);
    wf_doc_numbers(d, o, "hours_a_year_above", counted, WF_ROSE_CLASSES);
    json_t *list = wf_doc_put(d, o, "fits", wf_doc_array(d));
    for (size_t s = 0; s <= r->rose.sectors; s++) {
        const struct wf_rose_fit *f = &r->fit[s];
        const struct keyed y[] = { { "from_deg",
                                     s < r->rose.sectors ? 57.295779513082321 * r->rose.from[s] : NAN },
                                   { "scale_m_s", f->scale },
                                   { "scale_error_m_s", f->scale_error },
                                   { "shape", f->shape },
                                   { "shape_error", f->shape_error } };
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "hours", f->hours);
        PUT(d, q, y);
    }
}

static enum wf_status rose_document(const struct wf_rose *r, const char *file,
                                    const struct wf_rose_record *record, const struct wf_doc_head *head,
                                    const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    const struct keyed x[] = { { "typed_sum", r->typed_sum },
                               { "speed_exceeded_1_percent_m_s", wf_rose_speed(r, 0.01) },
                               { "speed_exceeded_0_1_percent_m_s", wf_rose_speed(r, 0.001) } };
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-rose", head);
    wf_doc_text(&d, o, "file", file);
    PUT(&d, o, x);
    wf_doc_numbers(&d, o, "classes_m_s", wf_rose_classes, WF_ROSE_CLASSES);
    json_t *list = wf_doc_put(&d, o, "sectors", wf_doc_array(&d));
    for (size_t s = 0; s < r->sectors; s++) wf_doc_add(&d, list, rose_row(&d, r, s));
    wf_doc_put(&d, o, "all", rose_row(&d, r, r->sectors));
    if (record) record_part(&d, o, record);
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), diag);
    json_t *figures = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    wf_doc_figure(&d, figures, "wind_rose", "wind_rose", 0);
    if (record) wf_doc_figure(&d, figures, "rose_record", "rose_record", 0);
    return wf_doc_end(&d, o, folder, e);
}

/* It can be read as a rose again. */
static void rose_table(FILE *f, const struct wf_rose *r)
{
    fputs("from_deg,frequency,weibull_scale_m_s,weibull_shape", f);
    for (int k = 0; k < WF_ROSE_CLASSES; k++) fprintf(f, ",share_above_%g_m_s", wf_rose_classes[k]);
    fputs(",calm", f);
    for (size_t s = 0; s < r->sectors; s++) {
        fprintf(f, "\n%.6g,%.6g", 57.295779513082321 * r->from[s], r->frequency[s]);
        cell(f, r->scale[s], "%.6g");
        cell(f, r->shape[s], "%.6g");
        for (int k = 0; k < WF_ROSE_CLASSES; k++)
            fprintf(f, ",%.6g", r->frequency[s] * wf_rose_sector_above(r, s, wf_rose_classes[k]));
        fprintf(f, ",%.6g", r->calm ? r->calm[s] : 0.0);
    }
    fputc('\n', f);
}

/* Share of hours above a speed, counted and by the fits, up to the highest speed of the record. */
static void exceedance_table(FILE *f, const struct wf_rose_record *r)
{
    enum { STEPS = 120 };
    fputs("speed_m_s,share_counted,share_fitted", f);
    for (int k = 0; k <= STEPS; k++) {
        double u = 1.05 * r->speed[r->n - 1] * k / STEPS, counted = wf_rose_record_above(r, u);
        fprintf(f, "\n%.6g", u);
        cell(f, counted > 0.0 ? counted : NAN, "%.6g");
        cell(f, wf_rose_above(&r->rose, u > 0.0 ? u : 1e-9), "%.6g");
    }
    fputc('\n', f);
}

enum wf_status wf_rose_results_write(const struct wf_rose *r, const char *file,
                                     const struct wf_rose_record *record, const struct wf_doc_head *head,
                                     const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status status = wf_folder_make(folder, e);
    if (!status) status = wf_folder_begin(&f, folder, "tables/rose.csv", e);
    if (status) return status;
    rose_table(f.stream, r);
    status = wf_file_commit(&f, e);
    if (!status && record) {
        status = wf_folder_begin(&f, folder, "tables/exceedance.csv", e);
        if (status) return status;
        exceedance_table(f.stream, record);
        status = wf_file_commit(&f, e);
    }
    struct wf_plot_data p;
    if (!status) status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    wf_plot_data_count(&p, "SECTORS", 0, r->sectors);
    status = wf_plot_data_end(&p, e);
    return status ? status : rose_document(r, file, record, head, diag, folder, e);
}

enum { TILE = 32 };

struct stream {
    const struct wf_gust_spec *spec;
    FILE *to;
    bool text;
    float *row;                                       /* TILE * points * components             */
    size_t done;                                      /* steps written                          */
    double sum[WF_COMPONENTS], square[WF_COMPONENTS]; /* of the first point, about its specified mean */
};

static void stream_head(const struct stream *w, size_t steps)
{
    static const char *const name[WF_COMPONENTS] = { "u", "v", "w" };
    const struct wf_gust_spec *s = w->spec;
    if (w->text) {
        fputs("t_s", w->to);
        for (size_t p = 0; p < s->points; p++)
            for (unsigned c = 0; c < s->components; c++) fprintf(w->to, ",%s%zu_m_s", name[c], p + 1);
        fputc('\n', w->to);
        return;
    }
    const uint16_t one = 1;
    char words[118]; /* with the ten bytes before it a multiple of 64 */
    int n =
        snprintf(words, sizeof words, "{'descr': '%cf4', 'fortran_order': False, 'shape': (%zu, %zu, %u), }",
                 *(const char *)&one ? '<' : '>', steps, s->points, s->components);
    memset(words + n, ' ', sizeof words - (size_t)n);
    words[sizeof words - 1] = '\n';
    fwrite("\x93NUMPY\x01\x00\x76\x00", 1, 10, w->to); /* 0x76: length of the words */
    fwrite(words, 1, sizeof words, w->to);
}

/* Steps of a block from `i` on, at most TILE: steps are the slowest in the file and the fastest in the block,
 * so that a tile of steps keeps both in the processor's cache. */
static void stream_tile(struct stream *w, const double *block, size_t stride, size_t i, size_t steps,
                        size_t at)
{
    const struct wf_gust_spec *s = w->spec;
    size_t rows = s->points * s->components;
    for (size_t p = 0; p < s->points; p++)
        for (unsigned c = 0; c < s->components; c++)
            for (size_t k = 0; k < steps; k++)
                w->row[k * rows + p * s->components + c] = (float)block[(c * s->points + p) * stride + i + k];
    if (!w->text) fwrite(w->row, sizeof *w->row, steps * rows, w->to);
    for (size_t k = 0; k < steps && w->text; k++) {
        fprintf(w->to, "%.7g", (double)(at + k) * s->step);
        for (size_t r = 0; r < rows; r++) fprintf(w->to, ",%.6g", (double)w->row[k * rows + r]);
        fputc('\n', w->to);
    }
}

static enum wf_status stream_blocks(struct stream *w, struct wf_gust *g, double *block,
                                    void (*progress)(size_t block, size_t blocks), struct wf_err *e)
{
    const struct wf_gust_spec *s = w->spec;
    double mean = s->mean ? s->mean[0] : s->speed;
    for (size_t b = 0; b < g->blocks && !wf_interrupted(); b++) {
        if (progress) progress(b + 1, g->blocks);
        enum wf_status status = wf_gust_block(g, b, block, e);
        if (status) return status;
        size_t first = b * g->block, n = s->steps - first < g->block ? s->steps - first : g->block;
        for (size_t i = 0; i < n && !wf_interrupted(); i += TILE) {
            stream_tile(w, block, g->block, i, n - i < TILE ? n - i : TILE, first + i);
            w->done = first + (n - i < TILE ? n : i + TILE);
        }
        n = w->done - first;
        for (unsigned c = 0; c < s->components; c++)
            for (size_t i = 0; i < n; i++) {
                double x = block[c * s->points * g->block + i] - (c ? 0.0 : mean);
                w->sum[c] += x, w->square[c] += x * x;
            }
        if (ferror(w->to)) break; /* wf_file_commit reports the error */
    }
    return WF_OK;
}

/* After an interrupt: the steps that were written become the file; a NumPy array says in its head how many.
 */
static enum wf_status stream_ends(struct stream *w, struct wf_diag *d, struct wf_err *e)
{
    if (w->done == w->spec->steps || ferror(w->to)) return WF_OK;
    if (!w->done || (!w->text && fseek(w->to, 0, SEEK_SET)))
        return wf_fail(e, WF_EINTERRUPTED, "interrupted; no wind was written");
    if (!w->text) stream_head(w, w->done);
    wf_diag_warn(d, "interrupted", "interrupted: %zu of %zu steps are written", w->done, w->spec->steps);
    return WF_OK;
}

static struct wf_wind_streamed streamed(const struct stream *w, const struct wf_gust *g, double seconds,
                                        struct wf_arena *a)
{
    const struct wf_gust_spec *s = w->spec;
    double n = (double)w->done;
    struct wf_wind_streamed out = { .steps = w->done,
                                    .blocks = g->blocks,
                                    .block = g->block,
                                    .seconds = seconds,
                                    .joint = g->joint,
                                    .coherence = s->points > 1 ? wf_gust_coherence_error(g, a) : NAN };
    for (unsigned c = 0; c < s->components; c++) {
        double off = w->sum[c] / n;
        out.mean[c] = off + (c ? 0.0 : s->mean ? s->mean[0] : s->speed);
        out.deviation[c] = sqrt(fmax(w->square[c] / n - off * off, 0.0));
        out.asked[c] = sqrt(wf_gust_variance(s, 0, (enum wf_component)c));
    }
    return out;
}

enum wf_status wf_wind_stream(const struct wf_gust_spec *s, const char *path,
                              void (*progress)(size_t block, size_t blocks), struct wf_arena *a,
                              struct wf_diag *d, struct wf_wind_streamed *out, struct wf_err *e)
{
    struct wf_gust g;
    struct wf_file f = { 0 };
    size_t length = strlen(path), rows = s->points * s->components;
    clock_t start = clock();
    enum wf_status status = wf_gust_open(s, a, d, &g, e);
    if (status) return status;
    struct stream w = { .spec = s,
                        .text = length > 4 && strcmp(path + length - 4, ".csv") == 0,
                        .row = WF_TAKE(a, TILE * rows, float) };
    double *block = WF_TAKE(a, rows * g.block, double);
    if (!w.row || !block)
        status = wf_fail(e, WF_ENOMEM, "not enough memory for a block of %zu points", s->points);
    else if (!(status = wf_file_begin(&f, path, e))) {
        w.to = f.stream;
        stream_head(&w, s->steps);
        status = stream_blocks(&w, &g, block, progress, e);
        if (!status) status = stream_ends(&w, d, e);
    }
    if (!status) status = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (!status) *out = streamed(&w, &g, (double)(clock() - start) / CLOCKS_PER_SEC, a);
    wf_gust_close(&g);
    return status;
}

/* Every point of the map, blank line after each row as gnuplot's maps want it. */
static enum wf_status write_points(const struct wf_terrain_site *s, const char *folder, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_file f = { 0 };
    enum wf_status status = wf_folder_begin(&f, folder, "tables/terrain.csv", e);
    if (status) return status;
    fprintf(f.stream, "x_m,y_m,height_m,topex_deg,wind_factor\n");
    for (size_t r = 0; r < t->rows; r++) {
        for (size_t c = 0; c < t->columns; c++) {
            size_t i = r * t->columns + c;
            fprintf(f.stream, "%.9g,%.9g,%.6g,%.5g,%.5g\n", t->x0 + (double)c * t->cell,
                    t->y0 + (double)r * t->cell, t->z[i], s->topex[i], s->factor[i]);
        }
        fputc('\n', f.stream);
    }
    return wf_file_commit(&f, e);
}

static enum wf_status write_grids(const struct wf_terrain_site *s, const char *folder, struct wf_err *e)
{
    static const char *const name[] = { "tables/height.asc", "tables/topex_deg.asc",
                                        "tables/wind_factor.asc" };
    const double *const value[] = { s->ground.z, s->topex, s->factor };
    for (int i = 0; i < 3; i++) {
        char path[WF_PATH_MAX];
        enum wf_status status = wf_folder_path(folder, name[i], path, e);
        if (!status) status = wf_terrain_write(path, &s->ground, value[i], e);
        if (status) return status;
    }
    struct wf_plot_data p;
    enum wf_status status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    wf_plot_data_number(&p, "FROM", 0, s->from * 180 / M_PI);
    wf_plot_data_number(&p, "CELL", 0, s->ground.cell);
    return wf_plot_data_end(&p, e);
}

/* The grid point nearest to each place of the file; the height is interpolated. */
enum wf_status wf_terrain_positions_write(const struct wf_terrain_site *s, const char *file,
                                          const char *folder, struct wf_arena *a, struct wf_diag *d,
                                          struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    struct wf_csv csv = { 0 };
    struct wf_file f = { 0 };
    size_t errors = d->errors;
    enum wf_status status = wf_csv_open(&csv, file, a, d, e);
    if (status) return status;
    struct wf_units *units;
    double fx, fy;
    if ((status = wf_units_open(&units, e))) return status;
    size_t cx = wf_column_need(&csv, units, "x_m", WF_DIM_LENGTH, &fx, e);
    size_t cy = wf_column_need(&csv, units, "y_m", WF_DIM_LENGTH, &fy, e);
    wf_units_close(units);
    if (e && e->code) return e->code;
    if (d->errors > errors) return wf_fail(e, WF_EINPUT, "%s: not a list of positions", file);
    status = wf_folder_begin(&f, folder, "tables/positions.csv", e);
    if (status) return status;
    fprintf(f.stream, "x_m,y_m,height_m,topex_deg,wind_factor\n");
    while (wf_csv_next(&csv)) {
        double x, y;
        if (!wf_column_number(&csv, cx, fx, -1e9, 1e9, &x) || !wf_column_number(&csv, cy, fy, -1e9, 1e9, &y))
            continue;
        double z = wf_terrain_height(t, x, y);
        if (isnan(z)) {
            wf_csv_mistake(&csv, cx, "%.9g, %.9g lies outside the map or where it has no data", x, y);
            continue;
        }
        size_t i =
            (size_t)llround((y - t->y0) / t->cell) * t->columns + (size_t)llround((x - t->x0) / t->cell);
        fprintf(f.stream, "%.9g,%.9g,%.6g,%.5g,%.5g\n", x, y, z, s->topex[i], s->factor[i]);
    }
    if (d->errors > errors) {
        wf_file_abandon(&f);
        return wf_fail(e, WF_EINPUT, "%s: positions that cannot be used", file);
    }
    return wf_file_commit(&f, e);
}

void wf_terrain_range(const double *v, size_t n, double *low, double *mean, double *high)
{
    double sum = 0.0, count = 0.0;
    *low = INFINITY, *high = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        if (isnan(v[i])) continue;
        *low = fmin(*low, v[i]);
        *high = fmax(*high, v[i]);
        sum += v[i], count += 1.0;
    }
    *mean = sum / count;
}

static void range_part(struct wf_doc *d, json_t *o, const char *key, const double *v, size_t n)
{
    double low, mean, high;
    wf_terrain_range(v, n, &low, &mean, &high);
    json_t *q = wf_doc_put(d, o, key, wf_doc_object(d));
    wf_doc_number(d, q, "low", low);
    wf_doc_number(d, q, "mean", mean);
    wf_doc_number(d, q, "high", high);
}

static enum wf_status document(const struct wf_terrain_site *s, const struct wf_doc_head *head,
                               const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    const struct wf_terrain *t = &s->ground;
    const size_t n = t->rows * t->columns;
    const struct {
        const char *key;
        double x;
    } x[] = { { "cell_m", t->cell },
              { "from_deg", s->from * 180 / M_PI },
              { "height_above_ground_m", s->height },
              { "roughness_m", s->roughness },
              { "topex_distance_m", s->distance },
              { "hill_half_width_m", s->speedup.length },
              { "inner_layer_m", s->speedup.inner },
              { "gain", s->speedup.gain },
              { "steepest_slope", s->speedup.steepest } };
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-terrain", head);
    wf_doc_text(&d, o, "file", s->file);
    wf_doc_count(&d, o, "columns", t->columns), wf_doc_count(&d, o, "rows", t->rows);
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) wf_doc_number(&d, o, x[i].key, x[i].x);
    range_part(&d, o, "height_m", t->z, n);
    range_part(&d, o, "topex_deg", s->topex, n);
    range_part(&d, o, "wind_factor", s->factor, n);
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), diag);
    wf_doc_figure(&d, wf_doc_put(&d, o, "figures", wf_doc_array(&d)), "terrain", "terrain", 0);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_terrain_results_write(const struct wf_terrain_site *s, const struct wf_doc_head *head,
                                        const struct wf_diag *diag, const char *folder, struct wf_err *e)
{
    enum wf_status status = wf_folder_make(folder, e);
    if (!status) status = write_points(s, folder, e);
    if (!status) status = write_grids(s, folder, e);
    return status ? status : document(s, head, diag, folder, e);
}
