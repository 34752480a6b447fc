/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/results.h"
#include "base/file.h"
#include "base/num.h"
#include "out/beside_part.h"
#include "out/fragility.h"
#include "out/inputs.h"
#include "out/job.h"
#include "out/modes.h"
#include "out/tree_picture.h"
#include "out/verdict_part.h"
#include "out/walls.h"
#include "study/directions.h"
#include "study/limits.h"
#include "study/peak.h"
#include "study/verdict.h"
#include "study/wetted.h"
#include "wind/climate.h"
#include <errno.h>
#include <inttypes.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static json_t *worst_section(struct wf_doc *d, const struct wf_analysis *a, const struct wf_worst *w)
{
    if (!w) return json_null();
    return wf_part_section(d, a, w->row, w->place, wf_part_height(&a->tree, w->row, w->place));
}

static json_t *wind_part(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at)
{
    static const char *const none = "no equilibrium was found at this wind speed";
    const struct wf_worst *worst = &at->worst[WF_BREAKAGE][WF_SCOPE_TREE];
    bool solved = at->status == WF_OK;
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "speed", at->speed, "m/s", NULL);
    wf_doc_text(d, o, "status", wf_part_status(at->status));
    wf_doc_text(d, o, "status_text", wf_status_text(at->status));
    wf_doc_quantity(d, o, "load_factor", at->response.load_factor, "1", none);
    const struct {
        const char *key;
        double value;
        const char *unit;
    } total[] = {
        { "drag", at->drag, "N" },
        { "lift", at->lift, "N" },
        { "weight", at->weight, "N" },
        { "tip_deflection", at->tip_deflection, "m" },
        { "tip_deflection_share", at->tip_deflection_share, "1" },
        { "top_deflection", at->top_deflection, "m" },
        { "tip_angle", at->tip_angle, "rad" },
        { "base_shear", at->base_shear, "N" },
        { "base_moment", at->base_moment, "N m" },
        { "largest_stress", at->breakage.largest_stress, "Pa" },
        { "imbalance", at->response.imbalance, "1" },
    };
    for (size_t i = 0; i < sizeof total / sizeof *total; i++)
        wf_doc_quantity(d, o, total[i].key, solved ? total[i].value : NAN, total[i].unit, none);
    const char *reason = !solved                ? none
                         : isnan(worst->safety) ? "no modulus of rupture is given"
                                                : "no section is stressed";
    wf_doc_quantity(d, o, "least_safety", solved ? worst->safety : NAN, "1", reason);
    wf_doc_put(d, o, "governing_section", worst_section(d, a, solved ? worst : NULL));
    wf_doc_quantity(d, o, "loss_safety", wf_verdict_safety(at, NULL), "1", reason);
    if (at >= a->at && at < a->at + a->n) { /* of the main wind direction */
        struct wf_verdict v = wf_verdict_of(a->breaks);
        wf_doc_flag(d, o, "beyond_loss", wf_verdict_lost(&v, at));
        wf_doc_put(d, o, "mean_state", wf_part_steady(d, a, at));
        wf_doc_put(d, o, "peak", wf_part_peak(d, a, at));
    }
    wf_doc_flag(d, o, "small_deflection", at->response.small_deflection);
    wf_doc_flag(d, o, "within_limits", !wf_limits_small_passed(at));
    wf_doc_count(d, o, "iterations", at->response.iterations);
    wf_doc_count(d, o, "steps", at->response.steps);
    return o;
}

static json_t *critical_part(struct wf_doc *d, const struct wf_analysis *a, const struct wf_break *b)
{
    const struct wf_critical *c = &b->critical;
    const char *text = wf_critical_text(c->outcome);
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "outcome", wf_part_outcome(c->outcome));
    wf_doc_text(d, o, "outcome_text", text);
    wf_doc_quantity(d, o, "speed", c->speed, "m/s", text);
    wf_doc_quantity(d, o, "speed_low", c->speed_low, "m/s", text);
    wf_doc_quantity(d, o, "speed_high", c->speed_high, "m/s", text);
    wf_doc_quantity(d, o, "gradient", c->gradient, "s/m", text);
    bool found = c->outcome == WF_CRITICAL_FOUND;
    const struct wf_at_speed *at = &b->at;
    wf_doc_quantity(d, o, "tip_deflection", found ? at->tip_deflection : NAN, "m", text);
    wf_doc_quantity(d, o, "tip_deflection_share", found ? at->tip_deflection_share : NAN, "1", text);
    wf_doc_quantity(d, o, "tip_angle", found ? at->tip_angle : NAN, "rad", text);
    wf_doc_flag(d, o, "within_limits", !(found && wf_limits_small_passed(at)));
    wf_doc_count(d, o, "evaluations", c->evaluations);
    wf_doc_put(d, o, "governing_section", wf_part_section(d, a, b->row, b->place, b->height));
    return o;
}

/* The part that fails first. */
static json_t *first_part(struct wf_doc *d, const struct wf_analysis *a,
                          const struct wf_break (*breaks)[WF_SCOPES])
{
    enum wf_criterion_id by;
    const struct wf_break *b = wf_verdict_first(breaks, &by);
    json_t *o = critical_part(d, a, b);
    wf_doc_text(d, o, "criterion", wf_criteria[by].name);
    wf_doc_flag(d, o, "twig", wf_verdict_twig(a, b->row));
    return o;
}

/* How near a part of the tree is to failing by a criterion at a wind speed. */
static json_t *utilisation(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at,
                           const struct wf_criterion *c, const struct wf_worst *w)
{
    bool solved = at->status == WF_OK;
    double safety = solved ? w->safety : NAN;
    const char *why = !solved         ? "no equilibrium was found at this wind speed"
                      : isnan(safety) ? "no resistance is known"
                                      : "nothing is loaded";
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "speed", at->speed, "m/s", NULL);
    wf_doc_quantity(d, o, "safety", safety, "1", why);
    wf_doc_quantity(d, o, "utilisation", 1 / safety, "1", why);
    double resistance = isnan(safety) ? NAN : wf_criterion_resistance(c, &a->tree, w);
    wf_doc_quantity(d, o, "resistance", resistance, "Pa", why);
    wf_doc_quantity(d, o, "stress", resistance / safety, "Pa", why);
    wf_doc_put(d, o, "governing_section", worst_section(d, a, solved ? w : NULL));
    return o;
}

/* Every criterion in every scope: its critical wind speed and the utilisation at the a->n speeds of `at`. */
static json_t *criteria_part(struct wf_doc *d, const struct wf_analysis *a,
                             const struct wf_break (*breaks)[WF_SCOPES], const struct wf_at_speed *at)
{
    json_t *list = wf_doc_array(d);
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < (wf_criteria[c].whole ? 1 : WF_SCOPES); s++) {
            const struct wf_break *b = &breaks[c][s];
            const char *text = wf_critical_text(b->critical.outcome);
            json_t *o = wf_doc_add(d, list, wf_doc_object(d));
            wf_doc_text(d, o, "criterion", wf_criteria[c].name);
            if (breaks == a->breaks) { /* said once, not by direction */
                wf_doc_text(d, o, "source", wf_criteria[c].source);
                wf_doc_text(d, o, "validity", wf_criteria[c].validity);
            }
            wf_doc_flag(d, o, "applies", wf_criterion_applies(&wf_criteria[c], &a->tree, (enum wf_scope)s));
            wf_doc_text(d, o, "wants", wf_criteria[c].wants);
            wf_doc_flag(d, o, "loses_tree", wf_criteria[c].loses_tree);
            wf_doc_quantity(d, o, "required_safety", fmax(1, wf_criteria[c].required), "1", NULL);
            wf_doc_text(d, o, "scope", wf_scope_name((enum wf_scope)s));
            wf_doc_text(d, o, "outcome", wf_part_outcome(b->critical.outcome));
            wf_doc_text(d, o, "outcome_text", text);
            wf_doc_quantity(d, o, "critical_speed", b->critical.speed, "m/s", text);
            wf_doc_put(d, o, "governing_section", wf_part_section(d, a, b->row, b->place, b->height));
            json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
            for (size_t k = 0; k < a->n; k++)
                wf_doc_add(d, winds, utilisation(d, a, &at[k], &wf_criteria[c], &at[k].worst[c][s]));
        }
    return list;
}

static json_t *warnings_part(struct wf_doc *d, const struct wf_diag *diag)
{
    json_t *list = wf_doc_array(d);
    for (const struct wf_finding *f = diag ? diag->first : NULL; f; f = f->next) {
        if (f->severity != WF_WARNING) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "code", f->code);
        wf_doc_text(d, o, "text", f->text);
        wf_doc_said(d, o, f->said);
        wf_doc_text(d, o, "file", f->file);
    }
    return list;
}

static const char no_hours[] = "no climate, or no critical wind speed";

static json_t *direction_part(struct wf_doc *d, const struct wf_analysis *a, const struct wf_direction *x)
{
    json_t *o = wf_doc_object(d), *winds;
    const double *exposed = a->directions->request.speed_up;
    wf_doc_quantity(d, o, "from", x->from, "rad", NULL);
    wf_doc_quantity(d, o, "speed_up", exposed ? exposed[x - a->directions->direction] : a->scenario.speed_up,
                    "1", NULL);
    winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    for (size_t k = 0; k < a->n; k++) {
        json_t *wind = wf_doc_add(d, winds, wind_part(d, a, &x->at[k]));
        wf_doc_quantity(d, wind, "gust_load_factor", x->gusts[k], "1", NULL);
    }
    wf_doc_put(d, o, "critical", critical_part(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", critical_part(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
    wf_doc_put(d, o, "first", first_part(d, a, x->breaks));
    wf_doc_put(d, o, "loss", wf_part_loss(d, a, x->breaks));
    wf_doc_put(d, o, "criteria", criteria_part(d, a, x->breaks, x->at));
    wf_doc_quantity(d, o, "hours_a_year", WF_HOURS_A_YEAR * x->hourly, "h", no_hours);
    wf_doc_quantity(d, o, "hours_a_year_10_min", WF_HOURS_A_YEAR * x->strongest, "h", no_hours);
    return o;
}

static json_t *directions_part(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_directions *x = a->directions;
    if (!x) return json_null();
    const struct wf_directions_request *q = &x->request;
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "number", q->n);
    wf_doc_quantity(d, o, "north", q->north, "rad", NULL);
    wf_doc_quantity(d, o, "main_from", wf_direction_from(q, a->scenario.azimuth), "rad", NULL);
    wf_doc_text(d, o, "climate_file", q->climate_file);
    wf_doc_text(d, o, "averaging_law", q->rose ? q->law : NULL);
    wf_doc_quantity(d, o, "strongest_10_min_over_hourly", x->gust, "1", no_hours);
    wf_doc_quantity(d, o, "hours_a_year", WF_HOURS_A_YEAR * x->hourly, "h", no_hours);
    wf_doc_quantity(d, o, "hours_a_year_10_min", WF_HOURS_A_YEAR * x->strongest, "h", no_hours);
    wf_doc_flag(d, o, "searched_to_the_end", x->above);
    wf_doc_quantity(d, o, "searched_to", a->search.speed_max, "m/s", NULL);
    json_t *list = wf_doc_put(d, o, "directions", wf_doc_array(d));
    for (size_t k = 0; k < q->n; k++) wf_doc_add(d, list, direction_part(d, a, &x->direction[k]));
    return o;
}

enum wf_status wf_input_file_note(const char *role, const char *path, struct wf_arena *a,
                                  struct wf_input_file *out, struct wf_err *e)
{
    out->role = wf_arena_text(a, role);
    out->path = wf_arena_text(a, path);
    if (!out->role || !out->path) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its name", path);
    return wf_sha256_file(path, a, out->sha256, e);
}

const char *wf_run_date(struct wf_arena *a)
{
    char text[32], *end;
    time_t now = time(NULL);
    const char *given = getenv("SOURCE_DATE_EPOCH");
    long long epoch = given ? strtoll(given, &end, 10) : 0;
    if (given && *given && !*end) now = (time_t)epoch;
    struct tm utc;
    if (!gmtime_r(&now, &utc) || !strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)) return NULL;
    return wf_arena_text(a, text);
}

static json_t *provenance(struct wf_doc *d, const struct wf_run *run)
{
    char seed[24];
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "program", "windfirm");
    wf_doc_text(d, o, "version", run->version);
    wf_doc_text(d, o, "date", run->date);
    wf_doc_text(d, o, "command", run->command);
    /* Text, because a 64-bit number does not survive readers that keep numbers as doubles. */
    snprintf(seed, sizeof seed, "%" PRIu64, run->seed);
    wf_doc_text(d, o, "seed", run->random ? seed : NULL);
    json_t *files = wf_doc_put(d, o, "files", wf_doc_array(d));
    for (size_t i = 0; i < run->inputs; i++) {
        json_t *file = wf_doc_add(d, files, wf_doc_object(d));
        wf_doc_text(d, file, "role", run->input[i].role);
        wf_doc_text(d, file, "path", run->input[i].path);
        wf_doc_text(d, file, "sha256", run->input[i].sha256);
    }
    return o;
}

/* A list of findings that several trees share belongs to the run, not to one tree. */
static bool shared(const struct wf_run *run, size_t tree)
{
    for (size_t i = 0; i < run->n; i++)
        if (i != tree && run->analysis[i].diag == run->analysis[tree].diag) return true;
    return false;
}

static json_t *tree_part(struct wf_doc *d, const struct wf_run *run, size_t index)
{
    const struct wf_analysis *a = &run->analysis[index];
    json_t *o = wf_doc_object(d);
    wf_doc_put(d, o, "species", wf_part_species(d, a));
    wf_doc_put(d, o, "model", wf_part_model(d, a->model));
    wf_doc_put(d, o, "scenario", wf_part_scenario(d, a));
    wf_doc_put(d, o, "method", wf_part_method(d, a));
    wf_doc_quantity(d, o, "height", a->tallness, "m", NULL);
    wf_doc_count(d, o, "segments", a->tree.n);
    size_t top = wf_top_row(&a->tree);
    wf_doc_put(d, o, "top", wf_part_section(d, a, (int32_t)top, 1, a->tree.z1[top]));
    json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    for (size_t k = 0; k < a->n; k++) wf_doc_add(d, winds, wind_part(d, a, &a->at[k]));
    wf_doc_put(d, o, "critical", critical_part(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", critical_part(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
    wf_doc_put(d, o, "first", first_part(d, a, a->breaks));
    wf_doc_put(d, o, "verdict", wf_part_verdict(d, a));
    wf_doc_put(d, o, "criteria", criteria_part(d, a, a->breaks, a->at));
    if (a->assessment) wf_doc_put(d, o, "assessment", wf_part_assessment(d, a->assessment));
    if (a->modes) wf_doc_put(d, o, "modes", wf_part_modes(d, a->modes));
    double last = a->sweep_n ? a->sweep[a->sweep_n - 1].speed : NAN;
    wf_doc_put(d, o, "directions", directions_part(d, a));
    if (a->interval) wf_doc_put(d, o, "interval", wf_part_interval(d, a));
    if (a->tree.section && a->tree.section->cavity) wf_doc_put(d, o, "cavities", wf_part_walls(d, a));
    if (a->unions) wf_doc_put(d, o, "unions", wf_part_unions(d, a));
    if (a->scenario.guys) wf_doc_put(d, o, "guys", wf_part_guys(d, a));
    if (a->scenario.braces) wf_doc_put(d, o, "braces", wf_part_braces(d, a));
    if (a->beside) wf_doc_put(d, o, "scenarios", wf_part_beside(d, a->beside->n, a->beside->item));
    json_t *removals = a->beside ? wf_part_removals(d, a->beside) : NULL;
    if (removals) wf_doc_put(d, o, "removals", removals);
    if (a->wetted) wf_doc_put(d, o, "wetted", wf_part_wetted(d, a->wetted));
    if (a->winter) wf_doc_put(d, o, "winter", wf_part_wetted(d, a->winter));
    wf_doc_quantity(d, o, "sweep_speed_high", last, "m/s", "no sweep was made");
    wf_doc_put(d, o, "warnings", shared(run, index) ? wf_doc_array(d) : warnings_part(d, a->diag));
    return o;
}

static bool has(const struct wf_run *run, size_t table)
{
    return !wf_tables[table].made || wf_tables[table].made(run);
}

static json_t *document(struct wf_doc *d, const struct wf_run *run, const size_t rows[WF_TABLES])
{
    json_t *o = wf_doc_object(d);
    json_t *schema = wf_doc_put(d, o, "schema", wf_doc_object(d));
    wf_doc_text(d, schema, "name", WF_RESULTS_SCHEMA);
    wf_doc_count(d, schema, "version", WF_RESULTS_VERSION);
    wf_doc_text(d, o, "title", run->title);
    json_t *job = run->job ? wf_part_job(d, run->job) : NULL;
    if (job) wf_doc_put(d, o, "job", job);
    wf_doc_put(d, o, "provenance", provenance(d, run));
    json_t *trees = wf_doc_put(d, o, "trees", wf_doc_array(d));
    for (size_t i = 0; i < run->n; i++) wf_doc_add(d, trees, tree_part(d, run, i));
    wf_doc_put(d, o, "warnings", shared(run, 0) ? warnings_part(d, run->analysis[0].diag) : wf_doc_array(d));
    json_t *tables = wf_doc_put(d, o, "tables", wf_doc_array(d));
    for (size_t i = 0; i < WF_TABLES; i++) {
        if (!has(run, i)) continue;
        json_t *table = wf_doc_add(d, tables, wf_doc_object(d));
        wf_doc_text(d, table, "file", wf_tables[i].name);
        wf_doc_text(d, table, "meaning", wf_tables[i].meaning);
        wf_doc_count(d, table, "rows", rows[i]);
    }
    return o;
}

static enum wf_status check(const struct wf_run *run, struct wf_err *e)
{
    if (run->n == 0) return wf_fail(e, WF_EUSAGE, "a run without analyses has no results");
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i], *first = run->analysis;
        bool same = a->n == first->n && a->n > 0;
        for (size_t k = 0; same && k < a->n; k++) same = a->at[k].speed == first->at[k].speed;
        if (!same) return wf_fail(e, WF_EUSAGE, "the trees of a run must share one list of wind speeds");
    }
    return WF_OK;
}

static enum wf_status write_document(const struct wf_run *run, const size_t rows[WF_TABLES],
                                     struct wf_file *f, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    json_t *o = document(&d, run, rows);
    enum wf_status code = WF_OK;
    bool dumped = !d.failed && !json_dumpf(o, f->stream, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    if (dumped)
        putc('\n', f->stream);
    else if (!ferror(f->stream)) /* the caller reports failed writes, for all files */
        code = wf_fail(e, WF_ENOMEM, "%s: no memory for the document", f->path);
    json_decref(o);
    return code;
}

enum { DOCUMENT = WF_TABLES, FILES }; /* the document comes last: it names the tables */

static enum wf_status write_all(const struct wf_run *run, const char *folder, struct wf_file f[FILES],
                                struct wf_err *e)
{
    size_t rows[WF_TABLES];
    char path[WF_PATH_MAX];
    enum wf_status code;
    for (size_t i = 0; i < FILES; i++) {
        const char *name = i == DOCUMENT ? "results.json" : wf_tables[i].name;
        if ((code = wf_folder_path(folder, name, path, e))) return code;
        if (i < WF_TABLES && !has(run, i)) {
            memcpy(f[i].path, path, sizeof path);
            continue;
        }
        if ((code = wf_file_begin(&f[i], path, e))) return code;
        errno = 0;
        if (i < WF_TABLES)
            rows[i] = wf_tables[i].write(run, f[i].stream);
        else if ((code = write_document(run, rows, &f[i], e)))
            return code;
        if (fflush(f[i].stream) || ferror(f[i].stream)) /* detects a full disk before any file is replaced */
            return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", path,
                           errno ? strerror(errno) : "write error");
    }
    for (size_t i = 0; i < FILES; i++)
        if (!f[i].stream)
            unlink(f[i].path); /* a table of an earlier run would be mistaken for one of this run */
        else if ((code = wf_file_commit(&f[i], e)))
            return code;
    return WF_OK;
}

/* Only a branched tree gets a picture; the other figures show a bare stem completely. */
static enum wf_status picture(const struct wf_run *run, const char *folder, struct wf_err *e)
{
    const struct wf_analysis *a = &run->analysis[0];
    const struct wf_tree_picture p = { &a->tree, a->model, a->species, false };
    char plots[WF_PATH_MAX];
    if (a->model->generator == WF_GENERATOR_STEM) {
        wf_tree_picture_remove(folder);
        return WF_OK;
    }
    enum wf_status code = wf_folder_path(folder, "plots", plots, e);
    if (!code) code = wf_mkdirs(plots, e);
    return code ? code : wf_tree_picture_write(&p, folder, e);
}

enum wf_status wf_results_write(const struct wf_run *run, const char *folder, struct wf_err *e)
{
    char tables[WF_PATH_MAX];
    enum wf_status code = check(run, e);
    if (code) return code;
    code = wf_folder_path(folder, "tables", tables, e);
    if (!code) code = wf_mkdirs(tables, e);
    if (code) return code;
    /* The caller may have set a locale with a decimal comma; tables use a point. */
    locale_t plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (!plain) return wf_fail(e, WF_ENOMEM, "no memory for the locale of the tables");
    locale_t before = uselocale(plain);
    struct wf_file f[FILES] = { 0 };
    code = write_all(run, folder, f, e);
    if (!code) code = picture(run, folder, e);
    for (size_t i = 0; i < FILES; i++) wf_file_abandon(&f[i]);
    uselocale(before);
    freelocale(plain);
    return code;
}
