/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm wind: generate a gusty wind, analyse it, draw it. */
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "cmd/wind_speed.h"
#include "out/wind_results.h"
#include "wind/category.h"
#include "wind/climate.h"
#include "wind/design.h"
#include "wind/gust_factor.h"
#include "wind/rose_record.h"
#include "wind/wind.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_MAX = 200 }; /* points that are analysed; a wind with more is only written to a file */

struct wind_options {
    struct wf_args args;
    double wind; /* [m/s] */
    struct wf_averaging averaging;
    double height, intensity, duration, step, spacing; /* [m], [-], [s], [s], [m] */
    size_t seed, points;
    const char *components;           /* "1" or "3"      */
    const char *points_file, *stream; /* NULL: not given */
    struct {
        const char *set, *file;
        struct wf_record_words record;
    } gust;
    const char *record, *sectors; /* of the rose; NULL: not given */
    const char *output;
    struct wf_pages pages;
};

static bool model_unused(const struct wind_options *o, const struct wf_gust_model *m, const void *at,
                         char *why)
{
    bool record = !strcmp(m->name, "record"), unused = false;
    if (at == &o->intensity) unused = m->own_intensity;
    if (at == &o->seed) unused = m->fixed;
    if (at == &o->gust.file || at == &o->gust.record.columns || at == &o->gust.record.rate ||
        at == &o->gust.record.missing || at == &o->gust.record.dates)
        unused = !record;
    if (at == &o->wind) unused = !wf_gust_takes_speed(m, o->gust.set);
    return wf_option_unused(unused, why, "with the gust model '%s'%s", m->name,
                            at == &o->wind ? ", which has its own (--set rescale=1 brings it to --wind)"
                                           : "");
}

static bool wind_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wind_options *o = options;
    const void *at = (const char *)options + row->member;
    const char *what = o->args.n ? o->args.operand[0] : "";
    bool of_record = at == &o->record || at == &o->sectors;
    bool of_rose =
        of_record || (at == &o->gust.record.columns && o->record) || at == &o->gust.file || at == &o->output;
    if (!strcmp(what, "list")) return wf_option_unused(true, why, "with 'list'");
    if (!strcmp(what, "rose")) return wf_option_unused(!of_rose, why, "with 'rose'");
    if (wf_option_unused(of_record, why, "with a gust model; it is for 'rose'")) return true;
    if (at == &o->height || at == &o->spacing)
        if (wf_option_unused(o->points_file, why, "with --points-file")) return true;
    if (at == &o->spacing && wf_option_unused(o->points < 2, why, "with one point")) return true;
    if (at == &o->output && wf_option_unused(o->stream, why, "with --stream")) return true;
    const struct wf_gust_model *m = wf_gust_named(what);
    return m && model_unused(o, m, at, why);
}

#define OPTIONS struct wind_options
const struct wf_option wf_wind_options[] = {
    STUDY,
    WF_WIND_ROWS(wind, averaging, 0.01, 120, "mean wind", .unused = wind_unused),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0.1, 1000, "10", "of the point above the ground",
           .unused = wind_unused),
    NUMBER("--intensity", intensity, "NUMBER", NONE, NULL, 0, 1, "0.2",
           "turbulence intensity: standard deviation along the wind / mean wind", .unused = wind_unused),
    NUMBER("--duration", duration, "TIME", TIME, "s", 1, 1e6, "3600",
           "length of the series; a record is at most as long as it is, one gust (eog) as long as it takes",
           .unused = wind_unused),
    NUMBER("--step", step, "TIME", TIME, "s", 1e-4, 60, "0.1", "between two values", .unused = wind_unused),
    WHOLE("--seed", seed, 0, 9007199254740992.0, "1", "whole number; the same seed gives the same wind",
          .unused = wind_unused),
    CHOICE("--components", components, "1|3", "1|3", "1", "along the wind only, or along, across and up",
           .unused = wind_unused),
    WHOLE("--points", points, 1, WF_GUST_POINTS_MAX, "1",
          "points in a row across the wind; more than 200 with --stream", .unused = wind_unused),
    NUMBER("--spacing", spacing, "LENGTH", LENGTH, "m", 0.01, 1000, "2", "between neighbouring points",
           .unused = wind_unused),
    PATH("--points-file", points_file, "FILE", NULL,
         "points in place of a row, a CSV with columns x_m (along the wind), y_m (across, to the left), z_m "
         "(above ground) and, where they differ, mean_ms",
         .unused = wind_unused),
    PATH("--stream", stream, "FILE", NULL,
         "write the wind to FILE block by block, for any number of points and steps, and nothing else: "
         "NAME.csv as a table, NAME.npy as 32-bit numbers, steps x points x components",
         .unused = wind_unused),
    WF_GUST_ROWS(gust, wind_unused),
    PATH("--record", record, "FILE", NULL,
         "of `windfirm wind rose`: make the rose from a station's record, a CSV with hourly mean speeds and "
         "directions; --columns names the two [speed_ms,direction_deg]",
         .unused = wind_unused),
    CHOICE("--sectors", sectors, "8|12|16", "8|12|16", NULL,
           "of the rose made from --record [16 where directions are names or steps of 22.5 deg, else 12]",
           .unused = wind_unused),
    TEXT("--output", output, "FOLDER", "out/wind", "where tables and plots go", .letter = "-o",
         .unused = wind_unused),
    WF_PAGE_ROWS("--no-plots", pages, "write the tables only"),
    WF_QUIET_ROW,
    { 0 },
};

static const char about[] =
    "Make a wind that changes with time, compare it with what was specified, write and draw it. "
    "MODEL is a name from `windfirm wind list`; `windfirm wind rose` reads a wind climate (direction_deg, "
    "frequency, weibull_scale_ms, weibull_shape for 8, 12 or 16 directions) or makes it from a station's "
    "record, "
    "and draws it; `windfirm wind extremes` says how often a wind is exceeded (`windfirm wind extremes "
    "--help`).\n"
    "\n"
    "  windfirm wind kaimal --wind beaufort:8 --components 3 --points 5 --spacing 2 -o out/gale\n"
    "  windfirm wind record --file sonic.csv --columns t_s,u_ms,v_ms,w_ms\n"
    "  windfirm wind rose --record station.csv --columns wind_kmh,wind_from\n"
    "  windfirm wind kaimal --points-file crown.csv --duration 3600 --stream crown.npy";

enum { LISTED_MEAN = 25 }; /* over open country, for comparing codes [m/s] */

/* Peak over mean load of a tree 20 m high and 6 m wide, of 0.25 Hz and damping 0.08, by a rule. */
static double tree_factor(const struct wf_gust_rule *r, const struct wf_category *c)
{
    struct wf_gust_case tree = {
        .terrain = c, .height = 20, .breadth = 6, .frequency = 0.25, .damping = 0.08
    };
    struct wf_gust_parts parts;
    tree.exponent = 2, tree.open = LISTED_MEAN;
    tree.mean = tree.open * wf_category_factor(c, r->at(c, tree.height));
    r->parts(&tree, &parts);
    return parts.factor;
}

/* What a code makes of one mean wind over open country in a terrain, beside EN 1991-1-4 in like terrain. */
static void list_terrain(const struct wf_design *d, const struct wf_design_terrain *t)
{
    double open = d->mean(wf_design_terrain_named(d, wf_category_open()->name));
    const struct wf_design_words words = { .code = d->name,
                                           .terrain = d->terrain[1].name ? t->name : NULL,
                                           .basic = LISTED_MEAN / open,
                                           .pressure = NAN,
                                           .years = NAN };
    struct wf_design_wind at;
    struct wf_err e = { 0 };
    if (wf_design_find(&words, &at, &e)) return;
    wf_show(stdout, "%-11s%-13s%-6s%9.2f%9.2f%9.2f", d->name, t->name, at.category->name, at.mean, at.gust,
            pow(at.gust / at.mean, 2.0));
    const struct wf_gust_rule *own = wf_gust_rule_named(d->peak);
    double en = tree_factor(wf_gust_rule_named("en1991"), at.category);
    if (own)
        wf_show(stdout, "%9.2f%+8.0f%%\n", tree_factor(own, at.category),
                100.0 * (tree_factor(own, at.category) / en - 1.0));
    else
        wf_show(stdout, "%9s%9s\n", "-", "-");
}

static void list_designs(void)
{
    wf_show(stdout, "Design winds, --design CODE:\n\n");
    for (const struct wf_design *d = wf_designs; d->name; d++)
        wf_show(stdout,
                "%s: %s\n  source: %s\n  valid:  %s\n  basic wind: %s\n  gust: %s; peak load: --peak %s\n\n",
                d->name, d->title, d->source, d->validity, d->basic, d->gust, d->peak);
    wf_show(
        stdout,
        "How they differ, for a 10-min mean of %d m/s at 10 m over open country: at 10 m over each terrain "
        "the mean\nwind, the gust and the pressure of the gust over that of the mean; the peak load over "
        "that of the mean wind\nof a tree 20 m high and 6 m wide, of 0.25 Hz and damping 0.08, and its "
        "difference to EN 1991-1-4 in like terrain.\n\n%-11s%-13s%-6s%9s%9s%9s%9s%9s\n%-30s%9s%9s%9s%9s%9s\n",
        (int)LISTED_MEAN, "code", "terrain", "like", "mean", "gust", "pressure", "load", "to EN", "", "m/s",
        "m/s", "ratio", "factor", "load");
    for (const struct wf_design *d = wf_designs; d->name; d++)
        for (const struct wf_design_terrain *t = d->terrain; t->name; t++) list_terrain(d, t);
    wf_show(stdout, "\n");
}

static int list_models(void)
{
    for (const struct wf_gust_model *m = wf_gust_models; m->name; m++) {
        wf_show(stdout, "%s: %s\n  source: %s\n  valid:  %s\n", m->name, m->title, m->source, m->validity);
        if (m->corrected) wf_show(stdout, "  differs from the paper: %s\n", m->corrected);
        for (const struct wf_gust_par *p = m->par; p->name; p++)
            wf_show(stdout, "  --set %s=%.6g  (%.6g..%.6g%s%s) %s\n", p->name, p->fallback, p->low, p->high,
                    p->unit[0] == '-' ? "" : " ", p->unit[0] == '-' ? "" : p->unit, p->help);
        wf_show(stdout, "\n");
    }
    list_designs();
    return 0;
}

static enum wf_status read_record(const struct wind_options *o, struct wf_gust_spec *s, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_err *e)
{
    const char *file = o->gust.file;
    if (!file) return wf_fail(e, WF_EUSAGE, "the model record needs --file");
    struct wf_record_words how = o->gust.record;
    bool timeless = how.columns[0] == ',' || !strncmp(how.columns, "-,", 2);
    if (timeless && isnan(how.rate) && WF_GIVEN(o, step)) how.rate = 1.0 / o->step;
    enum wf_status status = wf_gust_record_words(s, file, &how, a, d, e);
    if (status) return status;
    const struct wf_record *r = s->record;
    double length = (double)(r->n - 1) * r->step;
    if (!WF_GIVEN(o, step)) s->step = r->step;
    if (!WF_GIVEN(o, duration))
        s->steps = (size_t)(length / s->step + 1e-6) + 1;
    else
        s->steps = (size_t)llround(fmin(o->duration / s->step, 1e12));
    if (!WF_GIVEN(o, components) && r->components == 3) s->components = 3;
    if (!WF_GIVEN(o, wind)) s->speed = r->mean;
    if (!o->args.quiet)
        wf_show(stdout,
                "%s: %zu rows, %zu steps of %g s; %zu rows with unreadable cells, %zu steps interpolated in "
                "%zu gaps (longest %zu)\n"
                "  mean %.3f m/s towards %.1f deg (first axis towards second), tilt %.1f deg\n",
                file, r->rows, r->n, r->step, r->unreadable, r->missing, r->gaps, r->longest, r->mean,
                r->azimuth * 180 / M_PI, r->tilt * 180 / M_PI);
    return WF_OK;
}

/* Points of a file, else in a row. */
static enum wf_status place_points(const struct wind_options *o, struct wf_gust_spec *s, struct wf_arena *a,
                                   struct wf_diag *d, struct wf_err *e)
{
    const char *file = o->points_file;
    if (file && WF_GIVEN(o, points))
        return wf_fail(e, WF_EUSAGE, "give one of --points and --points-file, not both");
    if (file) {
        struct wf_points p;
        enum wf_status status = wf_points_read(file, WF_GUST_POINTS_MAX, a, d, &p, e);
        s->points = p.n, s->place = p.place, s->mean = p.mean;
        return status;
    }
    double *place = WF_TAKE(a, 3 * s->points, double);
    if (!place) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu points", s->points);
    for (size_t p = 0; p < s->points; p++)
        place[3 * p + 1] = (double)p * o->spacing, place[3 * p + 2] = s->height;
    s->place = place;
    return WF_OK;
}

static enum wf_status make_spec(const struct wind_options *o, struct wf_gust_spec *s, struct wf_arena *a,
                                struct wf_diag *d, struct wf_err *e)
{
    const char *name = o->args.operand[0], *known[24];
    size_t n = 0;
    for (; n < 22 && wf_gust_models[n].name; n++) known[n] = wf_gust_models[n].name;
    known[n++] = "list", known[n++] = "rose";
    const struct wf_gust_model *m = wf_gust_named(name);
    if (!m) {
        struct wf_hint hint = wf_did_you_mean(name, known, n);
        return wf_fail(e, WF_EUSAGE, "unknown gust model '%s'%s", name,
                       *hint.text ? hint.text : "; `windfirm wind list` shows them");
    }
    wf_gust_spec_default(m, s);
    s->height = o->height;
    s->intensity = o->intensity;
    s->step = o->step;
    s->steps = (size_t)llround(fmin(o->duration / s->step, 1e12));
    s->components = strcmp(o->components, "3") == 0 ? 3 : 1;
    s->points = o->points;
    s->seed = o->seed;
    s->speed = o->wind;
    enum wf_status status = wf_gust_set_words(s, o->gust.set, a, e);
    if (!status && strcmp(m->name, "record") == 0) status = read_record(o, s, a, d, e);
    if (!status && strcmp(m->name, "eog") == 0 && !WF_GIVEN(o, duration)) { /* as much before as after it */
        double length = 2.0 * wf_gust_get(s, "start") + wf_gust_get(s, "duration");
        s->steps = (size_t)llround(fmin(length / s->step, 1e12));
    }
    if (!status) status = place_points(o, s, a, d, e);
    if (status || o->stream) return status;
    if (s->points > SHOWN_MAX || (double)s->points * s->components * (double)s->steps > 3e8)
        return wf_fail(
            e, WF_EUSAGE,
            "%zu points, %u components and %zu steps are more than can be analysed here (%d points, 3e8 "
            "numbers); --stream writes any number",
            s->points, s->components, s->steps, SHOWN_MAX);
    return WF_OK;
}

/* In per cent; "-" where it is a share of nothing. */
static void print_share(int width, double share)
{
    if (isfinite(share))
        wf_show(stdout, "%*.2f%%", width, 100.0 * share);
    else
        wf_show(stdout, "%*s", width, "-");
}

static void print_wind(const struct wf_gust_report *r)
{
    const struct wf_gust_spec *s = &r->spec;
    const struct wf_gust_stats *t = &r->stats[0];
    wf_show(stdout, "%s: %s\n", s->model->name, s->model->title);
    wf_show(stdout, "%zu steps of %g s at %g m, seed %llu\n\n", s->steps, s->step, s->height,
            (unsigned long long)s->seed);
    wf_show(stdout, "mean wind             %8.3f m/s  (Beaufort %s, %s, as a 10-min mean)\n", t->mean,
            wf_wind_scale_grade(&wf_wind_scales[0], t->mean)->name,
            wf_wind_scale_grade(&wf_wind_scales[0], t->mean)->text);
    wf_show(stdout, "turbulence intensity  %8.3f\n", t->intensity);
    wf_show(stdout, "lowest, highest       %8.3f, %.3f m/s\n", t->low, t->high);
    wf_show(stdout, "skewness, kurtosis    %8.3f, %.3f\n", t->skewness, t->kurtosis);
    wf_show(stdout, "integral scale        %8.3f s, %.1f m\n", t->time_scale, t->length_scale);
    wf_show(stdout, "gust factor           %8.3f  (largest %g-s mean over %g s, mean of %zu)\n",
            t->gust_factor, t->gust_window, t->period, t->periods);
    wf_show(stdout, "peak factor           %8.3f  (codes take 2.5 to 3.5)\n", t->peak_factor);
    if (isfinite(r->joint))
        wf_show(stdout, "blocks meet within    %8.3f %% of the standard deviation\n", 100.0 * r->joint);
    if (!isnan(r->coherence_error))
        wf_show(stdout, "coherence within      %8.4f of the specified one\n", r->coherence_error);
    if (r->findings)
        wf_show(stdout, "\n%-36s %12s %12s %10s  scatter\n", "property", "specified", "obtained", "off");
    for (size_t i = 0; i < r->findings; i++) {
        const struct wf_gust_finding *f = &r->finding[i];
        wf_show(stdout, "%-36s %12.5g %12.5g ", f->name, f->asked, f->got);
        print_share(9, f->got / f->asked - 1.0);
        wf_show(stdout, "  ");
        print_share(0, f->scatter / fabs(f->asked));
        wf_show(stdout, "  %s\n", f->within ? "as expected" : "NOT as expected");
    }
}

/* Analyse a wind: tables, plots and a printed summary. */
static enum wf_status show_wind(const struct wind_options *o, const struct wf_gust_spec *spec,
                                const struct wf_doc_head *head, struct wf_arena *a, struct wf_diag *d,
                                struct wf_err *e)
{
    struct wf_gust_report *r = WF_TAKE(a, 1, struct wf_gust_report);
    struct wf_run_folder f;
    const char *folder = o->output;
    bool quiet = o->args.quiet;
    if (!r) return wf_fail(e, WF_ENOMEM, "not enough memory for a report");
    enum wf_status s = wf_results_begin(&f, folder, o->pages.none ? NULL : "wind", e);
    if (s) return s;
    s = wf_gust_report_make(spec, a, d, r, e);
    wf_progress_clear();
    if (!s && !quiet) print_wind(r);
    if (!s) s = wf_wind_results_write(r, head, d, f.stage, e);
    bool plots = !o->pages.none && !s && r->stats[0].high > r->stats[0].low;
    if (!s && !o->pages.none && !plots)
        wf_diag_warn(d, "wind-constant", "the wind does not change: no spectrum and no gust to draw");
    struct wf_pages pages = o->pages;
    pages.none = !plots;
    if (!s) s = wf_results_end(&f, &pages, a, NULL, e);
    wf_run_abandon(&f);
    if (!s && !quiet) wf_show(stdout, "\nTables%s: %s\n", plots ? ", plots and page" : "", folder);
    return s;
}

static void show_progress(size_t block, size_t blocks)
{
    if (block == 1) wf_stage_begin(blocks, false, "blocks of wind");
    wf_stage_step(block > 1);
}

static void print_streamed(const struct wf_gust_spec *s, const struct wf_wind_streamed *w, const char *path)
{
    static const char *const name[WF_COMPONENTS] = { "along the wind", "across", "up" };
    wf_show(stdout, "%s: %zu points, %zu steps of %g s, %u component%s, seed %llu: %s\n", s->model->name,
            s->points, w->steps, s->step, s->components, s->components == 1 ? "" : "s",
            (unsigned long long)s->seed, path);
    wf_show(stdout, "%zu blocks of %zu steps, made and written in %.1f s of processor time\n", w->blocks,
            w->block, w->seconds);
    for (unsigned c = 0; c < s->components; c++) {
        wf_show(stdout, "first point, %-15s mean %8.3f m/s, standard deviation %7.3f m/s", name[c],
                w->mean[c], w->deviation[c]);
        if (isnan(w->asked[c]))
            wf_show(stdout, "\n");
        else
            wf_show(stdout, " (specified %.3f)\n", w->asked[c]);
    }
    if (s->model->spectrum && isfinite(w->joint))
        wf_show(stdout, "blocks meet within %.3f %% of the standard deviation\n", 100.0 * w->joint);
    else if (s->model->spectrum)
        wf_show(stdout, "blocks meet within - of the standard deviation, which is 0\n");
    if (!isnan(w->coherence)) wf_show(stdout, "coherence within %.4f of the specified one\n", w->coherence);
}

static enum wf_status write_stream(const struct wind_options *o, const struct wf_gust_spec *spec,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_wind_streamed w;
    const char *path = o->stream;
    wf_interrupt_catch();
    enum wf_status s = wf_wind_stream(spec, path, show_progress, a, d, &w, e);
    wf_progress_clear();
    if (!s && !o->args.quiet) print_streamed(spec, &w, path);
    return s;
}

static enum wf_status make_wind(const struct wind_options *o, struct wf_doc_head *head, struct wf_arena *a,
                                struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_gust_spec spec;
    bool quiet = o->args.quiet;
    enum wf_status s = make_spec(o, &spec, a, &d, e);
    wf_doc_head_file(head, "data", o->gust.file);
    if (!s) s = o->stream ? write_stream(o, &spec, a, &d, e) : show_wind(o, &spec, head, a, &d, e);
    fflush(stdout);
    wf_print_findings(&d, quiet);
    return s;
}

/* ---- windfirm wind rose ---- */

static double degrees(double rad) { return rad * 57.295779513082321; }

static void print_number(int width, int digits, double x)
{
    if (isfinite(x))
        wf_show(stdout, " %*.*f", width, digits, x);
    else
        wf_show(stdout, " %*s", width, "-");
}

static void print_hours(const struct wf_rose *r, size_t sector)
{
    for (int k = 0; k < WF_ROSE_CLASSES; k++) {
        double u = wf_rose_classes[k];
        bool all = sector == r->sectors;
        wf_show(stdout, " %6.1f",
                8766.0 *
                    (all ? wf_rose_above(r, u) : r->frequency[sector] * wf_rose_sector_above(r, sector, u)));
    }
    wf_show(stdout, "\n");
}

static void print_rose(const char *file, const struct wf_rose *r, const struct wf_rose_record *record)
{
    if (record)
        wf_show(stdout, "%s: %zu directions from %zu rows\n\n", file, r->sectors, record->rows);
    else
        wf_show(stdout, "%s: %zu directions, frequencies sum to %g in the file\n\n", file, r->sectors,
                r->typed_sum);
    wf_show(stdout, "%-8s %10s %10s %7s  above", "from", "frequency", "mean m/s", "shape");
    for (int k = 0; k < WF_ROSE_CLASSES; k++) wf_show(stdout, " %6.0f", wf_rose_classes[k]);
    wf_show(stdout, " m/s (hours a year)\n");
    for (size_t s = 0; s < r->sectors; s++) {
        wf_show(stdout, "%5.1f    %10.4f", degrees(r->from[s]), r->frequency[s]);
        print_number(10, 3, wf_rose_sector_mean(r, s));
        print_number(7, 3, r->shape[s]);
        wf_show(stdout, "       ");
        print_hours(r, s);
    }
    wf_show(stdout, "%-8s %10.4f %10.3f %7s       ", "all", 1.0, wf_rose_mean(r), "");
    print_hours(r, r->sectors);
    wf_show(stdout, "\nhourly mean exceeded 1 %% of the time: %.2f m/s; 0.1 %%: %.2f m/s\n",
            wf_rose_speed(r, 0.01), wf_rose_speed(r, 0.001));
}

/* What was fitted to the record, and how well it counts the hours of the record. */
static void print_fits(const struct wf_rose_record *r)
{
    size_t sectors = r->rose.sectors;
    wf_show(stdout, "\nWeibull fits by maximum likelihood, with standard errors for independent hours\n");
    wf_show(stdout, "%-8s %8s %10s %10s %8s %8s\n", "from", "hours", "A m/s", "+-", "k", "+-");
    for (size_t s = 0; s <= sectors; s++) {
        const struct wf_rose_fit *f = &r->fit[s];
        if (s < sectors)
            wf_show(stdout, "%5.1f    %8zu", 360.0 * (double)s / (double)sectors, f->hours);
        else
            wf_show(stdout, "%-8s %8zu", "all", f->hours);
        print_number(10, 3, f->scale), print_number(10, 3, f->scale_error);
        print_number(8, 3, f->shape), print_number(8, 3, f->shape_error);
        wf_show(stdout, "\n");
    }
    wf_show(stdout, "\nhours a year above %14s %12s\n", "in the record", "by the fits");
    for (int k = 0; k < WF_ROSE_CLASSES; k++)
        wf_show(stdout, "%10.0f m/s %19.1f %12.1f\n", wf_rose_classes[k],
                8766.0 * wf_rose_record_above(r, wf_rose_classes[k]),
                8766.0 * wf_rose_above(&r->rose, wf_rose_classes[k]));
}

/* The rose of the options: read, or made from a record. Returned: *record is NULL for one that was read. */
static enum wf_status take_rose(const struct wind_options *o, struct wf_arena *a, struct wf_diag *d,
                                struct wf_rose *rose, struct wf_rose_record **record, struct wf_err *e)
{
    const char *file = o->gust.file;
    *record = NULL;
    if (!file == !o->record)
        return wf_fail(e, WF_EUSAGE,
                       "the wind rose needs --file, a wind climate, or --record, a station's record%s",
                       file ? "; not both" : "");
    if (file && o->sectors)
        return wf_fail(e, WF_EUSAGE, "--sectors is for --record; the rose of --file has those of the file");
    if (file) return wf_rose_read(file, a, d, rose, e);
    const struct wf_rose_request q = { .columns =
                                           WF_GIVEN(o, gust.record.columns) ? o->gust.record.columns : NULL,
                                       .sectors = o->sectors ? (size_t)atoi(o->sectors) : 0 };
    if (!(*record = WF_TAKE(a, 1, struct wf_rose_record))) return wf_fail(e, WF_ENOMEM, "not enough memory");
    enum wf_status s = wf_rose_from_record(o->record, &q, a, d, *record, e);
    *rose = (*record)->rose;
    return s;
}

/* A wind climate: read or made, printed unless quiet, written to FOLDER/tables/rose.csv, drawn. */
static enum wf_status show_rose(const struct wind_options *o, struct wf_doc_head *head, struct wf_arena *a,
                                struct wf_diag *d, struct wf_err *e)
{
    const char *file = o->record ? o->record : o->gust.file, *folder = o->output;
    struct wf_rose_record *record;
    struct wf_run_folder f;
    struct wf_rose r;
    enum wf_status status = take_rose(o, a, d, &r, &record, e);
    if (status) return status;
    if (!o->args.quiet) print_rose(file, &r, record);
    if (!o->args.quiet && record) print_fits(record);
    fflush(stdout);
    status = wf_results_begin(&f, folder, o->pages.none ? NULL : "rose", e);
    if (status) return status;
    wf_doc_head_file(head, "data", file);
    status = wf_rose_results_write(&r, file, record, head, d, f.stage, e);
    if (!status) status = wf_results_end(&f, &o->pages, a, NULL, e);
    wf_run_abandon(&f);
    return status;
}

int wf_cmd_wind(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wind_options o = { 0 };
    struct wf_err e = { 0 };
    if (argc > 1 && !strcmp(argv[1], "extremes")) return wf_wind_extremes(argc, argv);
    int code = wf_args_read(argc, argv, wf_wind_options, about, 1, 1, &arena, &o.args);
    if (code < 0 && strcmp(o.args.operand[0], "list") == 0) code = list_models();
    struct wf_doc_head head;
    if (code < 0 && wf_pages_head(argc, argv, &arena, &head, &e)) code = wf_complain(&e);
    if (code < 0 && strcmp(o.args.operand[0], "rose") == 0) {
        struct wf_diag d = { .arena = &arena };
        enum wf_status s = show_rose(&o, &head, &arena, &d, &e);
        wf_print_findings(&d, o.args.quiet);
        code = s ? wf_complain(&e) : 0;
    }
    if (code < 0) code = make_wind(&o, &head, &arena, &e) ? wf_complain(&e) : 0;
    wf_arena_free(&arena);
    return code;
}
