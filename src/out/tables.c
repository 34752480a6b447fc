/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/tables.h"
#include "data/species.h"
#include "study/directions.h"
#include "wind/climate.h"
#include <math.h>

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

#define COUNT(array) (sizeof(array) / sizeof *(array))

static size_t write_summary(const struct wf_run *run, FILE *f)
{
    fputs("tree,species,wind_m_s,status,tip_deflection_m,tip_deflection_percent,tip_angle_deg,drag_N,lift_N,"
          "weight_N,base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety,governing_height_m,"
          "critical_wind_m_s,critical_outcome,critical_height_m,"
          "stem_critical_wind_m_s,stem_critical_outcome,stem_critical_height_m\n",
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
            for (size_t c = 0; c < COUNT(total); c++) cell(f, at->status ? NAN : total[c]);
            const struct wf_break *const breaks[] = { &a->breaks[WF_BREAKAGE][WF_SCOPE_TREE],
                                                      &a->breaks[WF_BREAKAGE][WF_SCOPE_STEM] };
            for (size_t c = 0; c < COUNT(breaks); c++) {
                cell(f, breaks[c]->critical.speed);
                fprintf(f, ",%s", wf_part_outcome(breaks[c]->critical.outcome));
                cell(f, breaks[c]->height);
            }
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
            if (a->at[k].status) continue; /* no answer, no rows; summary.csv tells why */
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
                cells(f, COUNT(row), row);
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
    cells(f, COUNT(row), row);
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
          "base_shear_N,base_moment_Nm,largest_stress_MPa,least_safety\n",
          f);
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i];
        for (size_t k = 0; k < a->sweep_n; k++) {
            const struct wf_at_speed *at = &a->sweep[k];
            const double total[] = { at->tip_deflection,
                                     100 * at->tip_deflection_share,
                                     degrees * at->tip_angle,
                                     at->drag,
                                     at->base_shear,
                                     at->base_moment,
                                     1e-6 * at->breakage.largest_stress,
                                     at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety };
            lead(f, run, i, at->speed);
            fprintf(f, ",%s", wf_part_status(at->status));
            for (size_t c = 0; c < COUNT(total); c++) cell(f, at->status ? NAN : total[c]);
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
    const double total[] = { at->tip_deflection,
                             degrees * at->tip_angle,
                             at->drag,
                             at->base_shear,
                             at->base_moment,
                             1e-6 * at->breakage.largest_stress,
                             at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety };
    lead(f, run, tree, at->speed);
    cell(f, degrees * d->from);
    fprintf(f, ",%s", wf_part_status(at->status));
    for (size_t c = 0; c < sizeof total / sizeof *total; c++) cell(f, at->status ? NAN : total[c]);
    const struct wf_break *const breaks[] = { &d->breaks[WF_BREAKAGE][WF_SCOPE_TREE],
                                              &d->breaks[WF_BREAKAGE][WF_SCOPE_STEM] };
    for (size_t c = 0; c < 2; c++) {
        cell(f, breaks[c]->critical.speed);
        fprintf(f, ",%s", wf_part_outcome(breaks[c]->critical.outcome));
        cell(f, breaks[c]->height);
    }
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
    { "tables/segments.csv", "what each segment bears at each wind speed", write_segments, NULL },
    { "tables/shape.csv", "axis points, unloaded and loaded", write_shape, NULL },
    { "tables/sweep.csv", "totals on a ladder of wind speeds from 0, closer at first, for curves",
      write_sweep, NULL },
    { "tables/directions.csv", "totals, critical wind speeds and hours a year by direction of the wind",
      write_directions, directions_made },
    { NULL, NULL, NULL, NULL },
};
