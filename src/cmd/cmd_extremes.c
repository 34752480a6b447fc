/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm wind extremes: how often a wind is exceeded, from annual maxima or from the distribution of all
 * hours. */
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "out/extremes.h"
#include "wind/climate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct extremes_options {
    struct wf_args args;
    const char *annual, *record, *column, *time, *dates, *method, *on, *periods, *output;
    double weibull_scale, weibull_shape, dams, life, least;
    size_t begins;
    struct wf_speeds wind;
    struct wf_averaging averaging;
    struct wf_pages pages;
};

static const char *method_word(size_t i) { return i < WF_EXTREME_METHODS ? wf_extreme_rows[i].name : NULL; }

static bool of_file_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct extremes_options *o = options;
    (void)row;
    return wf_option_unused(!o->annual && !o->record, why, "without --annual or --record");
}

static bool of_record_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct extremes_options *o = options;
    (void)row;
    return wf_option_unused(!o->record, why, "without --record");
}

static bool shape_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct extremes_options *o = options;
    (void)row;
    return wf_option_unused(isnan(o->weibull_scale) && isnan(o->dams), why,
                            "without --weibull-scale or --dams");
}

#define OPTIONS struct extremes_options
static const struct wf_option options[] = {
    PATH("--annual", annual, "FILE", NULL,
         "table with the largest wind of each year: speed_ms, and year if it is there"),
    PATH("--record", record, "FILE", NULL,
         "record of a station with dates, hour after hour; the largest wind of each year is taken"),
    TEXT("--column", column, "NAME", NULL, "of the speeds; its unit is in its name [speed_ms]",
         .unused = of_file_unused),
    TEXT("--time", time, "NAME", NULL, "column of the record's dates [time]", .unused = of_record_unused),
    CHOICE("--dates", dates, "day-first|month-first", "day-first|month-first", NULL,
           "which is first in the record's dates", .unused = of_record_unused),
    WHOLE("--year-begins", begins, 1, 12, "1",
          "month with which a year begins; 7 keeps a northern winter together", .unused = of_record_unused),
    NUMBER("--least", least, "SHARE", NONE, NULL, 0, 1, "0.9",
           "share of the rows of the fullest year that a year needs to be used", .unused = of_record_unused),
    NUMBER("--weibull-scale", weibull_scale, "SPEED", SPEED, "m/s", 0.1, 40, NULL,
           "scale of the Weibull distribution of hourly means, in place of a file"),
    NUMBER("--dams", dams, "SCORE", NONE, NULL, 3, 40, NULL,
           "exposure of a British forest site, in place of a Weibull scale: A = 0.4279 DAMS - 0.9626 m/s"),
    NUMBER("--weibull-shape", weibull_shape, "NUMBER", NONE, NULL, 1.2, 3.5, "1.85",
           "shape of the Weibull distribution of hourly means", .unused = shape_unused),
    WORD("--method", method, "NAME", method_word, "moments",
         "fit to the annual maxima that is used; the others are beside it", .unused = of_file_unused),
    CHOICE("--on", on, "pressure|speed", "pressure|speed", "pressure",
           "what Gumbel's distribution is fitted to: the square of the speed, or the speed (safer for few "
           "years)",
           .unused = of_file_unused),
    TEXT("--periods", periods, "YEARS", "2,5,10,20,50,100,200", "return periods, separated by commas"),
    NUMBER("--life", life, "YEARS", NONE, NULL, 1, 1000, "10",
           "time over which the chance of a wind is also given"),
    SPEEDS("--wind", wind, averaging, 0.1, 120, "winds whose chance is wanted, for example a critical wind",
           .letter = "-w"),
    NUMBER("--averaging-time", averaging.time, "TIME", TIME, "s", 1, 3600, "600",
           "time that the speeds of the file and of --wind are averaged over: 3 s for gusts, 1 h for hourly "
           "means",
           .group = offsetof(OPTIONS, averaging)),
    WORD("--averaging", averaging.law, "LAW", wf_averaging_word, NULL,
         "law that brings them to 10 min [gusts of 3 s: en1991; else durst]",
         .group = offsetof(OPTIONS, averaging)),
    TEXT("--output", output, "FOLDER", "out/extremes", "where tables, figure and page go", .letter = "-o"),
    WF_PAGE_ROWS("--no-plots", pages, "write the tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "How often is a wind exceeded? A table of annual maxima, a station's record or a Weibull distribution of "
    "hourly means in; "
    "winds by return period and the chance of a wind in a year and over some years out. Speeds of the file "
    "are means over "
    "--averaging-time, as those of --wind; results are 10-min means.\n"
    "\n"
    "  windfirm wind extremes --annual docs/examples/annual.csv --wind 20,25\n"
    "  windfirm wind extremes --record station.csv --column wind_kmh --averaging-time 1h --year-begins 7\n"
    "  windfirm wind extremes --weibull-scale 5 --averaging-time 1h --wind 'gust:34 m/s'";

/* ---- What is read ---- */

/* Return periods from a list; ascending, each above 1. */
static enum wf_status read_periods(const char *list, struct wf_arena *a, struct wf_extreme_levels *l,
                                   struct wf_err *e)
{
    char *rest = wf_arena_text(a, list);
    double *years = WF_TAKE(a, strlen(list) + 1, double);
    if (!rest || !years) return wf_fail(e, WF_ENOMEM, "no memory");
    for (char *w; (w = wf_list_item(&rest));) {
        char *end;
        double y = strtod(w, &end);
        if (end == w || *end || !(y > 1 && y <= 1e5) || (l->count && y <= years[l->count - 1]))
            return wf_fail(e, WF_EUSAGE,
                           "--periods: '%s': return periods are above 1 and at most 100000 years, and ascend",
                           w);
        years[l->count++] = y;
    }
    l->years = years;
    return l->count ? WF_OK : wf_fail(e, WF_EUSAGE, "--periods: no return period");
}

/* Exactly one of the sources. */
static enum wf_status check_sources(const struct extremes_options *o, struct wf_err *e)
{
    int n = !!o->annual + !!o->record + !isnan(o->weibull_scale) + !isnan(o->dams);
    if (n == 1) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "%s of --annual, --record, --weibull-scale and --dams is needed",
                   n ? "only one" : "one");
}

static enum wf_status from_weibull(const struct extremes_options *o, struct wf_arena *a,
                                   struct wf_extremes *x, struct wf_extreme_levels *l, struct wf_diag *d,
                                   struct wf_err *e)
{
    bool dams = !isnan(o->dams);
    double scale = dams ? wf_extreme_dams_scale(o->dams) : o->weibull_scale;
    enum wf_status s = wf_extreme_of_weibull(scale * x->factor, o->weibull_shape, &l->x, e);
    x->source = dams ? wf_arena_print(a, "DAMS %g: hourly means by Weibull A %.4g m/s, k %g", o->dams, scale,
                                      o->weibull_shape)
                     : wf_arena_print(a, "hourly means by Weibull A %.4g m/s, k %g", scale, o->weibull_shape);
    if (!s && (o->weibull_shape < 1.5 || o->weibull_shape > 2.2))
        wf_diag_warn(d, "weibull-shape",
                     "the law from the distribution of all hours holds for a shape of 1.5 to 2.2, not %g",
                     o->weibull_shape);
    return s ? s : x->source ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}

static enum wf_status read_file(const struct extremes_options *o, struct wf_annual *out, struct wf_arena *a,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_annual_request q = { o->column, o->time, WF_DATES_UNSAID, o->begins, o->least };
    (void)wf_dates_named(o->dates, &q.dates);
    return o->annual ? wf_annual_read(o->annual, &q, a, d, out, e)
                     : wf_annual_from_record(o->record, &q, a, d, out, e);
}

/* What a sample cannot say, in warnings. */
static void warn_of_sample(const struct extremes_options *o, const struct wf_annual *s,
                           const struct wf_extreme_levels *l, struct wf_diag *d)
{
    double last = l->years[l->count - 1];
    if (s->used < 20)
        wf_diag_warn(d, "few-years",
                     "%zu annual maxima; with fewer than 20 the band is wide and one storm decides", s->used);
    if (last > 4 * (double)s->used)
        wf_diag_warn(d, "far-beyond-years",
                     "the winds of %g years are carried far beyond %zu years of record; one kind of storm is "
                     "taken to make them",
                     last, s->used);
    if (s->step > 2000 && s->step < 5000 && fabs(o->averaging.time - 3600) > 1 && !o->averaging.climate)
        wf_diag_warn(
            d, "hourly-record",
            "%s: its rows are %.0f s apart; if they are means over that time say --averaging-time %.0f s",
            s->file, s->step, s->step);
}

/* Fit by every method; the one of the options is used. A GEV that cannot be fitted is left out. */
static enum wf_status fit_all(const struct extremes_options *o, const struct wf_annual *s,
                              struct wf_extremes *x, struct wf_extreme_levels *used, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e)
{
    struct wf_extreme_levels *by = WF_TAKE(a, WF_EXTREME_METHODS, struct wf_extreme_levels);
    bool squared = !strcmp(o->on, "pressure");
    enum wf_status status = by ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
    for (int m = 0; m < WF_EXTREME_METHODS && !status; m++) {
        struct wf_extreme_levels l = {
            .method = (enum wf_extreme_method)m, .n = s->used, .count = used->count, .years = used->years
        };
        struct wf_err why = { 0 };
        bool wanted = !strcmp(o->method, wf_extreme_rows[m].name);
        enum wf_status f = wf_extreme_fit(l.method, squared, s->speed, s->used, &l.x, &why);
        if (!f) f = wf_extreme_levels_make(&l, a, &why);
        if (f && (wanted || m == 0))
            status = wf_fail(e, f, "%s", why.text);
        else if (f)
            wf_diag_warn(d, "extreme-not-fitted", "%s: %s", wf_extreme_rows[m].title, why.text);
        else
            by[x->methods++] = l;
        if (!f && wanted) *used = l;
    }
    x->by = by;
    if (!status) warn_of_sample(o, s, used, d);
    return status;
}

/* The factor from means over the averaging time to 10-min means. */
static enum wf_status find_factor(const struct extremes_options *o, bool weibull, double *out,
                                  struct wf_err *e)
{
    double time = weibull ? 3600 : o->averaging.time;
    const char *law = o->averaging.law ? o->averaging.law : wf_averaging_usual(time);
    *out = 1;
    return fabs(time - WF_MEAN_TIME) < 1e-9 ? WF_OK
                                            : wf_wind_average(law, NULL, 1, time, WF_MEAN_TIME, out, e);
}

static enum wf_status make(const struct extremes_options *o, struct wf_annual *s, struct wf_extreme_levels *l,
                           struct wf_extremes *x, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    bool file = o->annual || o->record;
    enum wf_status status = check_sources(o, e);
    if (!status) status = read_periods(o->periods, a, l, e);
    if (!status) status = find_factor(o, !file, &x->factor, e);
    if (!status && !file) {
        status = from_weibull(o, a, x, l, d, e);
        return status ? status : wf_extreme_levels_make(l, a, e);
    }
    if (!status) status = read_file(o, s, a, d, e);
    if (status) return status;
    for (size_t i = 0; i < s->n; i++) s->year[i].largest *= x->factor;
    for (size_t i = 0; i < s->used; i++) s->speed[i] *= x->factor;
    x->annual = s;
    x->source = s->file;
    return fit_all(o, s, x, l, a, d, e);
}

/* ---- What is printed ---- */

static void print_levels(const struct wf_extremes *x)
{
    const struct wf_extreme_levels *l = x->level;
    wf_show(stdout, "%s", x->source);
    if (!x->annual) wf_show(stdout, "\n");
    if (x->annual) wf_show(stdout, ": %zu years, %s\n", l->n, wf_extreme_rows[l->method].title);
    if (x->factor != 1) wf_show(stdout, "speeds times %.4g are 10-min means\n", x->factor);
    wf_show(stdout, "\n%14s%14s%12s%18s", "return period", "10-min mean", "3-s gust",
            l->n ? "90 % band" : "");
    for (size_t k = 0; k < x->methods; k++) wf_show(stdout, "%13s", wf_extreme_rows[x->by[k].method].name);
    wf_show(stdout, "\n%14s%14s%12s%18s\n", "years", "m/s", "m/s", l->n ? "m/s (mean)" : "");
    for (size_t i = 0; i < l->count; i++) {
        wf_show(stdout, "%14g%14.2f%12.1f", l->years[i], l->speed[i], wf_extremes_gust(l->speed[i]));
        if (l->n)
            wf_show(stdout, "%8.1f to %6.1f", l->low[i], l->high[i]);
        else
            wf_show(stdout, "%18s", "");
        for (size_t k = 0; k < x->methods; k++) wf_show(stdout, "%13.2f", x->by[k].speed[i]);
        wf_show(stdout, "\n");
    }
}

static void print_winds(const struct wf_extremes *x)
{
    char year[32], life[32], head[40];
    (void)snprintf(head, sizeof head, "within %g years", x->life);
    if (x->winds)
        wf_show(stdout, "\n%14s%20s%18s%20s\n", "10-min mean", "chance in a year", "return period", head);
    for (size_t k = 0; k < x->winds; k++) {
        double p = wf_extreme_exceedance(&x->level->x, x->wind[k]);
        wf_show(stdout, "%10.4g m/s%20s", x->wind[k], wf_extremes_share(p, year));
        if (p < 1e-6)
            wf_show(stdout, "%18s", "> 1e6 years");
        else
            wf_show(stdout, "%12.4g years", 1 / p);
        wf_show(stdout, "%20s\n", wf_extremes_share(wf_extreme_over_years(p, x->life), life));
    }
}

static enum wf_status extremes(void *work, struct wf_doc_head *head, struct wf_run_folder *f,
                               struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct extremes_options *o = work;
    struct wf_annual sample = { 0 };
    struct wf_extreme_levels level = { 0 };
    struct wf_extremes x = { .level = &level, .life = o->life, .winds = o->wind.n, .wind = o->wind.speed };
    enum wf_status s = make(o, &sample, &level, &x, a, d, e);
    if (!s) s = wf_results_begin(f, o->output, o->pages.none ? NULL : "extremes", e);
    if (s) return s;
    if (!o->args.quiet) print_levels(&x), print_winds(&x);
    wf_doc_head_file(head, "data", o->annual);
    wf_doc_head_file(head, "data", o->record);
    s = wf_extremes_write(&x, d, head, f->stage, e);
    if (!s) s = wf_results_end(f, &o->pages, a, NULL, e);
    if (!s && !o->args.quiet)
        wf_show(stdout, "\nTables%s: %s\n", o->pages.none ? "" : ", figure, page", o->output);
    return s;
}

int wf_wind_extremes(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct extremes_options o = { 0 };
    int code = wf_args_read(argc, argv, options, about, 1, 1, &arena, &o.args);
    if (code < 0) code = wf_command_perform(argc, argv, extremes, &o, o.args.quiet, &arena);
    wf_arena_free(&arena);
    return code;
}
