/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/results.h"
#include "base/file.h"
#include "base/num.h"
#include "data/species.h"
#include "out/doc.h"
#include "out/inputs.h"
#include "out/tree_picture.h"
#include "out/walls.h"
#include "study/directions.h"
#include "study/limits.h"
#include "study/peak.h"
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

static const double degrees = 57.295779513082320877; /* 180 / pi */

/* Adding zero turns -0 into 0. */
static void cell(FILE *f, double x)
{
    if (isfinite(x))
        fprintf(f, ",%.10g", x + 0.0);
    else
        putc(',', f);
}

static void cells(FILE *f, size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++) cell(f, x[i]);
}

static void lead(FILE *f, const struct wf_run *run, size_t tree, double speed)
{
    fprintf(f, "%zu,", tree + 1);
    const char *key = run->analysis[tree].species->key;
    putc('"', f);
    for (const char *c = key ? key : ""; *c; c++) {
        if (*c == '"') putc('"', f);
        putc(*c, f);
    }
    putc('"', f);
    cell(f, speed);
}

/* Outcome and totals of a solution in tables of many winds; empty cells without a solution. percent: whether
 * the deflection in percent of the height is among them. */
static void total_cells(FILE *f, const struct wf_at_speed *at, bool percent)
{
    enum { PERCENT = 1 };
    const double total[] = { at->tip_deflection,
                             100 * at->tip_deflection_share,
                             degrees * at->tip_angle,
                             at->drag,
                             at->base_shear,
                             at->base_moment,
                             1e-6 * at->breakage.largest_stress,
                             at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety };
    fprintf(f, ",%s", wf_part_status(at->status));
    for (size_t c = 0; c < WF_COUNT(total); c++)
        if (percent || c != PERCENT) cell(f, at->status ? NAN : total[c]);
}

/* Speed, outcome and height of breakage of the tree, then of its stem. */
static void break_cells(FILE *f, const struct wf_break breaks[WF_CRITERIA][WF_SCOPES])
{
    const struct wf_break *const part[] = { &breaks[WF_BREAKAGE][WF_SCOPE_TREE],
                                            &breaks[WF_BREAKAGE][WF_SCOPE_STEM] };
    for (size_t c = 0; c < WF_COUNT(part); c++) {
        cell(f, part[c]->critical.speed);
        fprintf(f, ",%s", wf_part_outcome(part[c]->critical.outcome));
        cell(f, part[c]->height);
    }
}

static size_t write_summary(const struct wf_run *run, FILE *f)
{
    fputs("tree,species,wind_m_s,status,tip_deflection_m,tip_deflection_percent,tip_angle_deg,drag_N,lift_N,"
          "weight_N,base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety,governing_height_m,"
          "critical_wind_m_s,critical_outcome,critical_height_m,"
          "stem_critical_wind_m_s,stem_critical_outcome,stem_critical_height_m,"
          "mean_tip_deflection_m,mean_tip_angle_deg,mean_base_moment_Nm,gust_load_factor\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        for (size_t k = 0; k < a->n; k++) {
            const struct wf_at_speed *at = &a->at[k];
            const struct wf_worst *worst = &at->worst[WF_BREAKAGE][WF_SCOPE_TREE];
            double height = wf_part_height(&a->tree, worst->row, worst->place);
            const double total[] = { at->tip_deflection,
                                     100 * at->tip_deflection_share,
                                     degrees * at->tip_angle,
                                     at->drag,
                                     at->lift,
                                     at->weight,
                                     at->base_shear,
                                     at->base_moment,
                                     1e-6 * at->breakage.largest_stress,
                                     worst->safety,
                                     height };
            lead(f, run, i, at->speed);
            fprintf(f, ",%s", wf_part_status(at->status));
            for (size_t c = 0; c < WF_COUNT(total); c++) cell(f, at->status ? NAN : total[c]);
            break_cells(f, a->breaks);
            const double gusts[] = { at->steady.tip_deflection, degrees * at->steady.tip_angle,
                                     at->steady.base_moment, wf_peak_gusts(a->peak, at->speed) };
            cells(f, WF_COUNT(gusts), gusts);
            putc('\n', f);
        }
    }
    return run->n * run->analysis->n;
}

static size_t write_segments(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,wind_m_s,segment,parent,level,height0_m,height1_m,diameter0_mm,diameter1_mm,"
          "projected_area_m2,drag_N,lift_N,shear0_N,shear1_N,bending0_Nm,bending1_Nm,torsion0_Nm,torsion1_Nm,"
          "axial0_N,axial1_N,stress0_MPa,stress1_MPa,safety0,safety1,deflection_m,slope_deg\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        const struct wf_tree *t = &a->tree;
        for (size_t k = 0; k < a->n; k++) {
            const struct wf_breakage *b = &a->at[k].breakage;
            const struct wf_figures *g = &a->at[k].figures;
            if (a->at[k].status) continue; /* no rows without a solution; summary.csv has its status */
            for (size_t r = 0; r < t->n; r++) {
                const double row[] = { t->z0[r],
                                       t->z1[r],
                                       2e3 * t->r0[r],
                                       2e3 * t->r1[r],
                                       g->projected_area[r],
                                       g->drag[r],
                                       g->lift[r],
                                       b->shear0[r],
                                       b->shear1[r],
                                       b->bending0[r],
                                       b->bending1[r],
                                       b->torsion0[r],
                                       b->torsion1[r],
                                       b->axial0[r],
                                       b->axial1[r],
                                       1e-6 * b->stress0[r],
                                       1e-6 * b->stress1[r],
                                       b->safety0[r],
                                       b->safety1[r],
                                       g->deflection[r],
                                       degrees * g->slope[r] };
                lead(f, run, i, a->at[k].speed);
                fprintf(f, ",%zu,%ld,%ld", r + 1, (long)t->parent[r] + 1, (long)t->level[r]);
                cells(f, WF_COUNT(row), row);
                putc('\n', f);
            }
            rows += t->n;
        }
    }
    return rows;
}

/* One point of an axis, unloaded and loaded; u is its displacement. */
static void shape_point(FILE *f, const struct wf_run *run, size_t tree, double speed, size_t axis,
                        size_t segment, const double x[3], const double u[3])
{
    const double row[] = { x[0], x[1], x[2], x[0] + u[0], x[1] + u[1], x[2] + u[2] };
    lead(f, run, tree, speed);
    fprintf(f, ",%zu,%zu", axis, segment);
    cells(f, WF_COUNT(row), row);
    putc('\n', f);
}

/* An axis is a chain of rows each grown from the one before; a row grown from elsewhere starts a new one. */
static size_t write_axes(const struct wf_run *run, size_t tree, const struct wf_at_speed *at, FILE *f)
{
    static const double nowhere[3] = { 0 };
    const struct wf_tree *t = &run->analysis[tree].tree;
    const double *u = at->response.end;
    size_t axis = 0, rows = 0;
    for (size_t r = 0; r < t->n; r++) {
        int32_t parent = t->parent[r];
        if (r == 0 || parent != (int32_t)r - 1) {
            axis++, rows++;
            shape_point(f, run, tree, at->speed, axis, 0, (double[]){ t->x0[r], t->y0[r], t->z0[r] },
                        parent < 0 ? nowhere : u + 3 * parent);
        }
        shape_point(f, run, tree, at->speed, axis, r + 1, (double[]){ t->x1[r], t->y1[r], t->z1[r] },
                    u + 3 * r);
        rows++;
    }
    return rows;
}

static size_t write_shape(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,wind_m_s,axis,segment,x_m,y_m,z_m,loaded_x_m,loaded_y_m,loaded_z_m\n", f);
    for (size_t i = 0; i < run->n; i++)
        for (size_t k = 0; k < run->analysis[i].n; k++)
            if (!run->analysis[i].at[k].status) rows += write_axes(run, i, &run->analysis[i].at[k], f);
    return rows;
}

static size_t write_sweep(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,wind_m_s,status,tip_deflection_m,tip_deflection_percent,tip_angle_deg,drag_N,"
          "base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety,source,gust_load_factor\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        for (size_t k = 0; k < a->sweep_n; k++) {
            const struct wf_at_speed *at = &a->sweep[k];
            lead(f, run, i, at->speed);
            total_cells(f, at, true);
            fputs(at->interpolated ? ",interpolated" : ",solved", f);
            cell(f, wf_peak_gusts(a->peak, at->speed));
            putc('\n', f);
        }
        rows += a->sweep_n;
    }
    return rows;
}

static void direction_row(const struct wf_run *run, size_t tree, size_t k, size_t wind, FILE *f)
{
    const struct wf_analysis *a = &run->analysis[tree];
    const struct wf_directions *x = a->directions;
    const struct wf_direction *d = &x->direction[k];
    const struct wf_at_speed *at = &d->at[wind];
    lead(f, run, tree, at->speed);
    cell(f, degrees * d->from);
    total_cells(f, at, false);
    break_cells(f, d->breaks);
    const struct wf_rose *r = x->request.rose;
    cell(f, r ? r->frequency[k] : NAN);
    cell(f, r ? r->scale[k] : NAN);
    cell(f, r ? r->shape[k] : NAN);
    cell(f, WF_HOURS_A_YEAR * d->hourly);
    cell(f, WF_HOURS_A_YEAR * d->strongest);
    cell(f, x->request.speed_up ? x->request.speed_up[k] : a->scenario.speed_up);
    putc('\n', f);
}

static bool directions_made(const struct wf_run *run) { return run->analysis[0].directions != NULL; }

static size_t write_directions(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,wind_m_s,from_deg,status,tip_deflection_m,tip_angle_deg,drag_N,base_shear_N,base_"
          "moment_Nm,"
          "largest_stress_MPa,least_safety,critical_wind_m_s,critical_outcome,critical_height_m,"
          "stem_critical_wind_m_s,stem_critical_outcome,stem_critical_height_m,frequency,weibull_scale_m_s,"
          "weibull_shape,hours_a_year,hours_a_year_10_min,speed_up\n",
          f);
    for (size_t i = 0; i < run->n; i++)
        for (size_t wind = 0; wind < run->analysis[i].n; wind++)
            for (size_t k = 0; k < run->analysis[i].directions->request.n; k++, rows++)
                direction_row(run, i, k, wind, f);
    return rows;
}

const struct wf_table wf_tables[] = {
    { "tables/summary.csv", "totals of each tree at each wind speed", write_summary, NULL },
    { "tables/segments.csv",
      "loads, section forces, stresses and movement of each segment at each wind speed", write_segments,
      NULL },
    { "tables/shape.csv", "axis points, unloaded and loaded", write_shape, NULL },
    { "tables/sweep.csv",
      "totals at wind speeds from 0, evenly spaced, four times finer at the start, for curves", write_sweep,
      NULL },
    { "tables/directions.csv", "totals, critical wind speeds and hours a year by direction of the wind",
      write_directions, directions_made },
    { NULL, NULL, NULL, NULL },
};

_Static_assert(WF_COUNT(wf_tables) == WF_TABLES + 1, "WF_TABLES is the number of rows of wf_tables");

const char *wf_part_status(enum wf_status s)
{
    switch (s) {
    case WF_OK:
        return "ok";
    case WF_ENOCONV:
        return "not-converged";
    case WF_EUNSTABLE:
        return "unstable";
    default:
        return "failed";
    }
}

const char *wf_part_outcome(enum wf_critical_outcome o)
{
    static const char *const names[] = { [WF_CRITICAL_FOUND] = "found",
                                         [WF_CRITICAL_ABOVE] = "above",
                                         [WF_CRITICAL_SELF_WEIGHT] = "self-weight",
                                         [WF_CRITICAL_NO_STRENGTH] = "no-strength",
                                         [WF_CRITICAL_UNSOLVED] = "unsolved",
                                         [WF_CRITICAL_UNSEARCHED] = "unsearched",
                                         [WF_CRITICAL_INTERRUPTED] = "interrupted" };
    return names[o];
}

double wf_part_height(const struct wf_tree *t, int32_t row, double s)
{
    if (row < 0 || (size_t)row >= t->n) return NAN;
    return t->z0[row] + s * (t->z1[row] - t->z0[row]);
}

/* A section of the tree: its segment's number as in segments.csv, that of the row in the tree's file (a
 * model: the same), its thickness at its thicker end, and its place. */
static json_t *section(struct wf_doc *d, const struct wf_analysis *a, int32_t row, double s, double height)
{
    const struct wf_tree *t = &a->tree;
    if (row < 0 || (size_t)row >= t->n) return json_null();
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "segment", (size_t)row + 1);
    wf_doc_count(d, o, "level", t->level[row] > 0 ? (size_t)t->level[row] : 0);
    wf_doc_text(d, o, "part", wf_model_level_name(a->model, a->species, t->level[row]));
    wf_doc_count(d, o, "id", t->id[row] > 0 ? (size_t)t->id[row] : 0);
    wf_doc_quantity(d, o, "diameter", 2 * fmax(t->r0[row], t->r1[row]), "m", NULL);
    wf_doc_quantity(d, o, "position", s, "1", "the segment as a whole is named");
    wf_doc_quantity(d, o, "height", height, "m", NULL);
    return o;
}

static json_t *worst_section(struct wf_doc *d, const struct wf_analysis *a, const struct wf_worst *w)
{
    if (!w) return json_null();
    return section(d, a, w->row, w->place, wf_part_height(&a->tree, w->row, w->place));
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
    if (at >= a->at && at < a->at + a->n) { /* of the main wind direction */
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
    wf_doc_put(d, o, "governing_section", section(d, a, b->row, NAN, b->height));
    return o;
}

/* How near a part of the tree is to failing by a criterion at a wind speed. */
static json_t *utilisation(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at,
                           const struct wf_worst *w)
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
    wf_doc_put(d, o, "governing_section", worst_section(d, a, solved ? w : NULL));
    return o;
}

/* Every criterion in every scope: its critical wind speed and the utilisation at the a->n speeds of `at`. */
static json_t *criteria_part(struct wf_doc *d, const struct wf_analysis *a,
                             const struct wf_break (*breaks)[WF_SCOPES], const struct wf_at_speed *at)
{
    json_t *list = wf_doc_array(d);
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) {
            const struct wf_break *b = &breaks[c][s];
            const char *text = wf_critical_text(b->critical.outcome);
            json_t *o = wf_doc_add(d, list, wf_doc_object(d));
            wf_doc_text(d, o, "criterion", wf_criteria[c].name);
            wf_doc_text(d, o, "scope", wf_scope_name((enum wf_scope)s));
            wf_doc_text(d, o, "outcome", wf_part_outcome(b->critical.outcome));
            wf_doc_text(d, o, "outcome_text", text);
            wf_doc_quantity(d, o, "critical_speed", b->critical.speed, "m/s", text);
            wf_doc_put(d, o, "governing_section", section(d, a, b->row, NAN, b->height));
            json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
            for (size_t k = 0; k < a->n; k++)
                wf_doc_add(d, winds, utilisation(d, a, &at[k], &at[k].worst[c][s]));
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
    for (size_t k = 0; k < a->n; k++) wf_doc_add(d, winds, wind_part(d, a, &x->at[k]));
    wf_doc_put(d, o, "critical", critical_part(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", critical_part(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
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
    json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    for (size_t k = 0; k < a->n; k++) wf_doc_add(d, winds, wind_part(d, a, &a->at[k]));
    wf_doc_put(d, o, "critical", critical_part(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", critical_part(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
    wf_doc_put(d, o, "criteria", criteria_part(d, a, a->breaks, a->at));
    double last = a->sweep_n ? a->sweep[a->sweep_n - 1].speed : NAN;
    wf_doc_put(d, o, "directions", directions_part(d, a));
    if (a->tree.section && a->tree.section->cavity) wf_doc_put(d, o, "cavities", wf_part_walls(d, a));
    if (a->wetted) wf_doc_put(d, o, "wetted", wf_part_wetted(d, a->wetted));
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
