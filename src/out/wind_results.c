/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/wind_results.h"
#include "out/figures.h"
#include "out/folder.h"
#include "out/plot_data.h"
#include <math.h>
#include <string.h>

/* A cell; empty where there is no number. */
static void cell(FILE *f, double value, const char *format)
{
    fputc(',', f);
    if (isfinite(value)) fprintf(f, format, value);
}

static void series(FILE *f, const struct wf_gust_report *r)
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

enum wf_status wf_wind_tables(const char *folder, const struct wf_gust_report *r, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(FILE *f, const struct wf_gust_report *r);
    } table[] = { { "tables/series.csv", series },
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
    return wf_plot_data_end(&p, e);
}

const double wf_rose_classes[WF_ROSE_CLASSES] = { 5.0, 10.0, 15.0, 20.0 };

enum wf_status wf_wind_rose_write(const char *folder, const struct wf_rose *r, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status status = wf_folder_make(folder, e);
    if (!status) status = wf_folder_begin(&f, folder, "tables/rose.csv", e);
    if (status) return status;
    fprintf(f.stream, "from_deg,frequency,weibull_scale_m_s,weibull_shape");
    for (int k = 0; k < WF_ROSE_CLASSES; k++) fprintf(f.stream, ",share_above_%g_m_s", wf_rose_classes[k]);
    for (size_t s = 0; s < r->sectors; s++) {
        fprintf(f.stream, "\n%.6g,%.6g,%.6g,%.6g", 57.295779513082321 * r->from[s], r->frequency[s],
                r->scale[s], r->shape[s]);
        for (int k = 0; k < WF_ROSE_CLASSES; k++)
            fprintf(f.stream, ",%.6g", r->frequency[s] * wf_rose_sector_above(r, s, wf_rose_classes[k]));
    }
    fputc('\n', f.stream);
    status = wf_file_commit(&f, e);
    struct wf_plot_data p;
    if (!status) status = wf_plot_data_begin(&p, folder, "run", e);
    if (status) return status;
    wf_plot_data_count(&p, "SECTORS", 0, r->sectors);
    return wf_plot_data_end(&p, e);
}

enum wf_status wf_wind_figures(const char *folder, const char *const *name, struct wf_err *e)
{
    enum wf_status status = WF_OK;
    for (size_t i = 0; name[i] && !status; i++) {
        xmlDoc *svg = NULL;
        status = wf_figures_draw(folder, &(struct wf_figure){ name[i], name[i], 0 }, "en", &svg, e);
        if (svg) xmlFreeDoc(svg);
    }
    return status;
}
