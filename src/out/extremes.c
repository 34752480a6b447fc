/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/extremes.h"
#include "base/num.h"
#include "wind/climate.h"
#include <math.h>
#include <stdlib.h>

const char *wf_extremes_share(double p, char text[static 32])
{
    /* two figures, without a power of ten; a chance that is not certain is no 1 */
    const char *form = p < 1e-6      ? "< 1e-6"
                       : p > 0.999   ? "> 0.999"
                       : p < 9.95e-6 ? "%.7f"
                       : p < 1e-4    ? "%.6f"
                       : p < 0.995   ? "%.2g"
                                     : "%.3f";
    (void)snprintf(text, 32, form, p);
    return text;
}

double wf_extremes_gust(double mean)
{
    double gust = NAN;
    (void)wf_wind_average(wf_averaging_usual(WF_GUST_TIME), NULL, mean, WF_MEAN_TIME, WF_GUST_TIME, &gust,
                          NULL);
    return gust;
}

/* ---- results.json ---- */

static json_t *fit_part(struct wf_doc *d, const struct wf_extremes *x, const struct wf_extreme_levels *l)
{
    json_t *o = wf_doc_object(d), *list = wf_doc_put(d, o, "levels", wf_doc_array(d));
    if (l->n) {
        wf_doc_text(d, o, "fitted_by", wf_extreme_rows[l->method].name);
        wf_doc_text(d, o, "title", wf_extreme_rows[l->method].title);
        wf_doc_text(d, o, "source", wf_extreme_rows[l->method].source);
    }
    wf_doc_flag(d, o, "squared", l->x.squared);
    wf_doc_flag(d, o, "used", l == x->level || (x->level->n && l->method == x->level->method));
    wf_doc_number(d, o, "mode", l->x.mode);
    wf_doc_number(d, o, "scale", l->x.scale);
    wf_doc_number(d, o, "shape", l->x.shape);
    for (size_t i = 0; i < l->count; i++) {
        json_t *row = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_number(d, row, "years", l->years[i]);
        wf_doc_number(d, row, "exceedance_a_year", 1 / l->years[i]);
        wf_doc_number(d, row, "speed_m_s", l->speed[i]);
        wf_doc_number(d, row, "gust_m_s", wf_extremes_gust(l->speed[i]));
        wf_doc_number(d, row, "low_m_s", l->low[i]);
        wf_doc_number(d, row, "high_m_s", l->high[i]);
    }
    return o;
}

static json_t *asked_part(struct wf_doc *d, const struct wf_extremes *x, double speed)
{
    json_t *o = wf_doc_object(d);
    char text[32];
    double p = wf_extreme_exceedance(&x->level->x, speed);
    wf_doc_number(d, o, "speed_m_s", speed);
    wf_doc_number(d, o, "gust_m_s", wf_extremes_gust(speed));
    wf_doc_number(d, o, "exceedance_a_year", p);
    wf_doc_text(d, o, "exceedance_a_year_text", wf_extremes_share(p, text));
    wf_doc_number(d, o, "return_period_years", p < 1e-6 ? NAN : 1 / p);
    p = wf_extreme_over_years(p, x->life);
    wf_doc_number(d, o, "exceedance_over_life", p);
    wf_doc_text(d, o, "exceedance_over_life_text", wf_extremes_share(p, text));
    return o;
}

static json_t *annual_part(struct wf_doc *d, const struct wf_annual *s)
{
    json_t *list = wf_doc_array(d);
    for (size_t i = 0; i < s->n; i++) {
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_number(d, o, "year", s->year[i].year);
        wf_doc_number(d, o, "largest_m_s", s->year[i].largest);
        wf_doc_count(d, o, "rows", s->year[i].rows);
        wf_doc_flag(d, o, "used", s->year[i].used);
    }
    return list;
}

static enum wf_status document(const struct wf_extremes *x, const struct wf_diag *findings,
                               const struct wf_doc_head *head, const char *folder, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-extremes", head);
    wf_doc_text(&d, o, "source", x->source);
    wf_doc_number(&d, o, "averaging_factor", x->factor);
    wf_doc_number(&d, o, "life_years", x->life);
    wf_doc_count(&d, o, "years", x->level->n);
    wf_doc_put(&d, o, "fit", fit_part(&d, x, x->level));
    json_t *list = wf_doc_put(&d, o, "methods", wf_doc_array(&d));
    for (size_t k = 0; k < x->methods; k++) wf_doc_add(&d, list, fit_part(&d, x, &x->by[k]));
    list = wf_doc_put(&d, o, "winds", wf_doc_array(&d));
    for (size_t k = 0; k < x->winds; k++) wf_doc_add(&d, list, asked_part(&d, x, x->wind[k]));
    if (x->annual) wf_doc_put(&d, o, "annual", annual_part(&d, x->annual));
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), findings);
    list = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    wf_doc_figure(&d, list, "extremes", "extremes", 0);
    return wf_doc_end(&d, o, folder, e);
}

/* ---- Tables ---- */

static void cell(FILE *f, double x) { wf_folder_cell(f, x, 6); }

static void level_table(FILE *f, const struct wf_extremes *x)
{
    const struct wf_extreme_levels *l = x->level;
    fputs("return_period_years,exceedance_a_year,speed_m_s,gust_m_s,low_m_s,high_m_s", f);
    for (size_t k = 0; k < x->methods; k++) fprintf(f, ",%s_m_s", wf_extreme_rows[x->by[k].method].name);
    for (size_t i = 0; i < l->count; i++) {
        fprintf(f, "\n%.6g", l->years[i]);
        cell(f, 1 / l->years[i]), cell(f, l->speed[i]), cell(f, wf_extremes_gust(l->speed[i])),
            cell(f, l->low[i]), cell(f, l->high[i]);
        for (size_t k = 0; k < x->methods; k++) cell(f, x->by[k].speed[i]);
    }
    fputc('\n', f);
}

/* The distribution between its return periods, for the figure. */
static void curve_table(FILE *f, const struct wf_extremes *x)
{
    enum { STEPS = 100 };
    const struct wf_extreme_levels *l = x->level;
    double last = log(l->years[l->count - 1]), first = log(1.02);
    fputs("return_period_years,speed_m_s\n", f);
    for (int k = 0; k <= STEPS; k++) {
        double years = exp(first + (last - first) * k / STEPS);
        fprintf(f, "%.6g,%.6g\n", years, wf_extreme_speed(&l->x, years));
    }
}

/* Annual maxima by rank; the plotting position is (rank - 0.44) / (n + 0.12) (Gringorten 1963). */
static bool annual_table(FILE *f, const struct wf_extremes *x)
{
    const struct wf_annual *s = x->annual;
    double *sorted = malloc((s->used + 1) * sizeof *sorted);
    if (!sorted) return false;
    for (size_t i = 0; i < s->used; i++) sorted[i] = s->speed[i];
    qsort(sorted, s->used, sizeof *sorted, wf_ascending);
    fputs("rank,speed_m_s,share_below,return_period_years\n", f);
    for (size_t i = 0; i < s->used; i++) {
        double share = ((double)i + 0.56) / ((double)s->used + 0.12);
        fprintf(f, "%zu,%.6g,%.6g,%.6g\n", i + 1, sorted[i], share, 1 / (1 - share));
    }
    free(sorted);
    return true;
}

static enum wf_status tables(const struct wf_extremes *x, const char *folder, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_begin(&f, folder, "tables/extremes.csv", e);
    if (!s) level_table(f.stream, x), s = wf_file_commit(&f, e);
    if (!s) s = wf_folder_begin(&f, folder, "plots/extremes_curve.csv", e);
    if (!s) curve_table(f.stream, x), s = wf_file_commit(&f, e);
    if (s || !x->annual) return s;
    if ((s = wf_folder_begin(&f, folder, "tables/annual.csv", e))) return s;
    if (annual_table(f.stream, x)) return wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return wf_fail(e, WF_ENOMEM, "not enough memory for the table of years");
}

enum wf_status wf_extremes_write(const struct wf_extremes *x, const struct wf_diag *findings,
                                 const struct wf_doc_head *head, const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_folder_make(folder, e);
    if (!s) s = tables(x, folder, e);
    if (!s) s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    wf_plot_data_number(&p, "END", 0, x->level->years[x->level->count - 1]);
    wf_plot_data_count(&p, "SAMPLE", 0, x->annual ? 1 : 0);
    wf_plot_data_count(&p, "WINDS", 0, x->winds);
    for (size_t k = 0; k < x->winds; k++) wf_plot_data_number(&p, "WIND", k + 1, x->wind[k]);
    s = wf_plot_data_end(&p, e);
    return s ? s : document(x, findings, head, folder, e);
}
