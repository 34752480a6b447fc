/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/tables.h"
#include "base/num.h"
#include "data/species.h"
#include "out/beside_part.h"
#include "out/folder.h"
#include "study/directions.h"
#include "study/peak.h"
#include "study/unions.h"
#include "study/verdict.h"
#include "wind/climate.h"
#include <math.h>

static const double degrees = 57.295779513082320877; /* 180 / pi */

/* Adding zero turns -0 into 0. */
static void cell(FILE *f, double x) { wf_folder_cell(f, x, 10); }

static void cells(FILE *f, size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++) cell(f, x[i]);
}

static void lead_tree(FILE *f, const struct wf_run *run, size_t tree)
{
    fprintf(f, "%zu,", tree + 1);
    const char *key = run->analysis[tree].species->key;
    putc('"', f);
    for (const char *c = key ? key : ""; *c; c++) {
        if (*c == '"') putc('"', f);
        putc(*c, f);
    }
    putc('"', f);
}

static void lead(FILE *f, const struct wf_run *run, size_t tree, double speed)
{
    lead_tree(f, run, tree);
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

/* Heads and cells of the loss of the tree: safety against it in a wind, then at which wind, or why that is
 * not known, and by which criterion. */
#define LOSS_HEADS "tree_safety,lost_wind_m_s,lost_outcome,lost_criterion"
static void loss_cells(FILE *f, const struct wf_at_speed *at,
                       const struct wf_break breaks[WF_CRITERIA][WF_SCOPES])
{
    struct wf_verdict v = wf_verdict_of(breaks);
    cell(f, wf_verdict_safety(at, NULL));
    cell(f, v.loss ? v.loss->critical.speed : (double)NAN);
    fprintf(f, ",%s,%s", v.loss ? wf_part_outcome(v.loss->critical.outcome) : "",
            v.loss ? wf_criteria[v.criterion].name : "");
}

/* The same of the part that fails first, by whichever criterion. */
#define FIRST_HEADS "first_wind_m_s,first_criterion,first_height_m"
static void first_cells(FILE *f, const struct wf_break breaks[WF_CRITERIA][WF_SCOPES])
{
    enum wf_criterion_id by;
    const struct wf_break *b = wf_verdict_first(breaks, &by);
    cell(f, b->critical.speed);
    fprintf(f, ",%s", isnan(b->critical.speed) ? "" : wf_criteria[by].name);
    cell(f, b->height);
}

static size_t write_summary(const struct wf_run *run, FILE *f)
{
    fputs("tree,species,wind_m_s,status,tip_deflection_m,tip_deflection_percent,tip_angle_deg,drag_N,lift_N,"
          "weight_N,base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety,governing_height_m,"
          "critical_wind_m_s,critical_outcome,critical_height_m,"
          "stem_critical_wind_m_s,stem_critical_outcome,stem_critical_height_m,"
          "mean_tip_deflection_m,mean_tip_angle_deg,mean_base_moment_Nm,gust_load_factor," LOSS_HEADS
          ",top_height_m,top_deflection_m,mean_top_deflection_m," FIRST_HEADS "\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        double top = a->tree.z1[wf_top_row(&a->tree)];
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
            loss_cells(f, at, a->breaks);
            const double tops[] = { top, at->status ? NAN : at->top_deflection, at->steady.top_deflection };
            cells(f, WF_COUNT(tops), tops);
            first_cells(f, a->breaks);
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
          "axial0_N,axial1_N,stress0_MPa,stress1_MPa,safety0,safety1,deflection_m,slope_deg,weight_stress_"
          "MPa\n",
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
                                       degrees * g->slope[r],
                                       a->still ? 1e-6 * a->still->breakage.peak[r] : NAN };
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
          "base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety,source,gust_load_factor,tree_safety\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        for (size_t k = 0; k < a->sweep_n; k++) {
            const struct wf_at_speed *at = &a->sweep[k];
            lead(f, run, i, at->speed);
            total_cells(f, at, true);
            fputs(at->interpolated ? ",interpolated" : ",solved", f);
            cell(f, wf_peak_gusts(a->peak, at->speed));
            cell(f, wf_verdict_safety(at, NULL));
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
    cell(f, d->gusts[wind]);
    loss_cells(f, at, d->breaks);
    first_cells(f, d->breaks);
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
          "weibull_shape,hours_a_year,hours_a_year_10_min,speed_up,gust_load_factor," LOSS_HEADS
          "," FIRST_HEADS "\n",
          f);
    for (size_t i = 0; i < run->n; i++)
        for (size_t wind = 0; wind < run->analysis[i].n; wind++)
            for (size_t k = 0; k < run->analysis[i].directions->request.n; k++, rows++)
                direction_row(run, i, k, wind, f);
    return rows;
}

static bool unions_made(const struct wf_run *run) { return run->analysis[0].unions != NULL; }

static size_t write_unions(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,segment,segment_above,segment_below,level,height_m,branch_diameter_mm,above_diameter_"
          "mm,"
          "below_diameter_mm,aspect_ratio,class\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        for (size_t k = 0; k < a->unions->n; k++, rows++) {
            const struct wf_union *u = &a->unions->item[k];
            const double row[] = { u->height, 1e3 * u->branch_diameter, 1e3 * u->above_diameter,
                                   1e3 * u->below_diameter, u->ratio };
            lead_tree(f, run, i);
            fprintf(f, ",%ld,%ld,%ld,%ld", u->branch + 1L, u->above + 1L, u->below + 1L,
                    (long)a->tree.level[u->branch]);
            cells(f, WF_COUNT(row), row);
            fprintf(f, ",%s\n", u->in->name);
        }
    }
    return rows;
}

static size_t write_besides(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs(WF_BESIDES_HEAD, f);
    for (size_t i = 0; i < run->n; i++)
        if (run->analysis[i].beside)
            rows += wf_besides_rows(f, i + 1, run->analysis[i].species->key, run->analysis[i].beside);
    return rows;
}

static bool besides_made(const struct wf_run *run)
{
    bool any = false;
    for (size_t i = 0; i < run->n; i++) any = any || run->analysis[i].beside;
    return any;
}

/* Rows of what holds trees; f NULL: counted alone. */
static size_t hold_rows(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    for (size_t i = 0; i < run->n; i++)
        if (run->analysis[i].beside)
            rows += wf_holds_rows(f, i + 1, run->analysis[i].species->key, run->analysis[i].beside);
    return rows;
}

static size_t write_holds(const struct wf_run *run, FILE *f)
{
    fputs(WF_HOLDS_HEAD, f);
    return hold_rows(run, f);
}

static bool holds_made(const struct wf_run *run) { return hold_rows(run, NULL) > 0; }

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
    { "tables/unions.csv", "unions of branches and forks, the largest aspect ratio first", write_unions,
      unions_made },
    { "tables/scenarios.csv", "the tree as it stands and with something changed, in the strongest given wind",
      write_besides, besides_made },
    { "tables/scenario_forces.csv", "forces of cables, rods and guys in the scenarios", write_holds,
      holds_made },
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
