/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/tree_summary.h"
#include "data/species.h"
#include <math.h>
#include <stdbool.h>

static size_t level_of(const struct wf_tree *t, size_t i)
{
    size_t level = t->level[i] > 0 ? (size_t)t->level[i] : 0;
    return level < WF_SUMMARY_LEVELS ? level : WF_SUMMARY_LEVELS - 1;
}

static bool goes_on(const struct wf_tree *t, size_t i)
{
    return t->parent[i] >= 0 && t->level[t->parent[i]] == t->level[i];
}

static double wood(const struct wf_tree *t, size_t i)
{
    double outer = t->r0[i] * t->r0[i] + t->r0[i] * t->r1[i] + t->r1[i] * t->r1[i];
    double inner = t->i0[i] * t->i0[i] + t->i0[i] * t->i1[i] + t->i1[i] * t->i1[i];
    return M_PI / 3 * (outer - inner) * wf_tree_length(t, i);
}

/* Length of every axis, kept at its first row. */
static void axis_lengths(const struct wf_tree *t, int32_t *first, double *length)
{
    for (size_t i = 0; i < t->n; i++) {
        first[i] = goes_on(t, i) ? first[t->parent[i]] : (int32_t)i;
        length[first[i]] += wf_tree_length(t, i);
    }
}

static void stretch(struct wf_tree_summary *s, double x, double y, double z)
{
    const double p[3] = { x, y, z };
    for (int k = 0; k < 3; k++) {
        s->low[k] = fmin(s->low[k], p[k]);
        s->high[k] = fmax(s->high[k], p[k]);
    }
}

enum wf_status wf_tree_summarise(const struct wf_tree *t, struct wf_tree_summary *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    int32_t *first = WF_TAKE(&scratch, t->n, int32_t);
    double *length = WF_TAKE(&scratch, t->n, double);
    *out = (struct wf_tree_summary){ .low = { INFINITY, INFINITY, INFINITY },
                                     .high = { -INFINITY, -INFINITY, -INFINITY },
                                     .height = wf_tree_height(t) };
    if (!first || !length) {
        wf_arena_free(&scratch);
        return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    }
    axis_lengths(t, first, length);
    for (size_t i = 0; i < t->n; i++) {
        struct wf_level_summary *l = &out->level[level_of(t, i)];
        if (level_of(t, i) + 1 > out->levels) out->levels = level_of(t, i) + 1;
        l->segments++;
        out->wood_volume += wood(t, i);
        out->leaf_area += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
        stretch(out, t->x0[i], t->y0[i], t->z0[i]);
        stretch(out, t->x1[i], t->y1[i], t->z1[i]);
        if (first[i] != (int32_t)i) continue;
        l->length_least = l->axes ? fmin(l->length_least, length[i]) : length[i];
        l->length_most = fmax(l->length_most, length[i]);
        l->length_mean += length[i];
        l->diameter_mean += 2 * t->r0[i];
        l->axes++;
    }
    for (size_t k = 0; k < out->levels; k++) {
        struct wf_level_summary *l = &out->level[k];
        if (!l->axes) continue;
        l->length_mean /= (double)l->axes;
        l->diameter_mean /= (double)l->axes;
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

double wf_tree_wear_mass(const struct wf_qsm_metrics *g, const struct wf_tree_wear *w)
{
    double mass = 0;
    for (size_t k = 0; k < WF_QSM_ORDERS; k++) {
        double density = w->density;
        if (isnan(density) && w->species && w->species->levels) {
            size_t level = k < w->species->levels ? k : w->species->levels - 1;
            density = w->species->level[level].density.value;
        }
        mass += density * g->order_volume[k];
    }
    return mass;
}

double wf_tree_wear_sail(const struct wf_tree_wear *w)
{
    return w->species ? w->leaf_area * w->species->crown.frontal_share.value : (double)NAN;
}

void wf_tree_table_head(FILE *to)
{
    fprintf(
        to,
        "file,format,cylinders,branches,tips,stems,highest_order,height_m,dbh_m,base_diameter_m,width_x_m,"
        "width_y_m,"
        "crown_base_m,length_m,volume_m3,mass_kg,area_m2,leaf_area_m2,sail_0_m2,sail_45_m2,sail_90_m2,"
        "sail_135_m2,leaf_sail_m2,segments,model_volume_m3,links,bridges,bridge_volume_m3,gaps,widest_gap_m");
    for (int k = 0; k < WF_REPAIR_COUNT; k++) fprintf(to, ",%s", wf_repair_rows[k].code);
    fputc('\n', to);
}

/* A number cell; empty when unknown. */
static void cell(FILE *to, double v)
{
    if (isnan(v))
        fputc(',', to);
    else
        fprintf(to, ",%.8g", v);
}

void wf_tree_table_line(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w)
{
    struct wf_qsm_metrics g;
    wf_qsm_measure(q, &g);
    fputc('"', to);
    for (const char *p = path; *p; p++) fprintf(to, "%s%c", *p == '"' ? "\"" : "", *p);
    fprintf(to, "\",%s,%zu,%zu,%zu,%zu,%d", q->format, g.cylinders, g.branches, g.tips, g.stems,
            g.highest_order);
    const double v[] = { g.height, g.dbh,    g.base_diameter,          g.width_x, g.width_y,   g.crown_base,
                         g.length, g.volume, wf_tree_wear_mass(&g, w), g.area,    w->leaf_area };
    for (size_t k = 0; k < sizeof v / sizeof *v; k++) cell(to, v[k]);
    for (int deg = 0; deg < 180; deg += 45) cell(to, wf_qsm_sail(q, deg * M_PI / 180));
    cell(to, wf_tree_wear_sail(w));
    fprintf(to, ",%zu,%.8g,%zu,%zu,%.8g,%zu,%.6g", m->tree.n, m->volume, m->links, m->bridges,
            m->bridge_volume, m->gaps, m->widest_gap);
    for (int k = 0; k < WF_REPAIR_COUNT; k++) fprintf(to, ",%zu", q->repairs.count[k]);
    fputc('\n', to);
}
