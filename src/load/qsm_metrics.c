/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/qsm_metrics.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/tree.h"
#include "load/load.h"
#include "load/scene.h"
#include <math.h>

static int32_t main_root(const struct wf_qsm *q)
{
    int32_t root = -1;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0 && (root < 0 || q->r0[i] > q->r0[root])) root = (int32_t)i;
    return root;
}

/* By the rule of data/tree.h, along the cylinders as the file has them. */
static double breast_diameter(const struct wf_qsm *q)
{
    const struct wf_tree t = { .n = q->n,
                               .parent = q->parent,
                               .level = q->order,
                               .x0 = q->x0,
                               .y0 = q->y0,
                               .z0 = q->z0,
                               .x1 = q->x1,
                               .y1 = q->y1,
                               .z1 = q->z1,
                               .r0 = q->r0,
                               .r1 = q->r1 };
    return wf_tree_breast(&t).diameter;
}

void wf_qsm_measure(const struct wf_qsm *q, struct wf_qsm_metrics *m)
{
    double low = INFINITY, high = -INFINITY, x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    *m = (struct wf_qsm_metrics){ .cylinders = q->n, .dbh = (double)NAN, .crown_base = (double)NAN };
    for (size_t i = 0; i < q->n; i++) {
        int32_t order = q->order[i];
        size_t o = order < WF_QSM_ORDERS ? (size_t)order : WF_QSM_ORDERS - 1;
        double r0 = q->r0[i], r1 = q->r1[i], l = q->length[i], volume = wf_qsm_volume(q, i);
        if (q->parent[i] < 0) m->stems++, low = fmin(low, q->z0[i]);
        if (q->next[i] < 0) m->tips++;
        if (q->branch[i] > 0 && (size_t)q->branch[i] > m->branches) m->branches = (size_t)q->branch[i];
        if (order > m->highest_order) m->highest_order = order;
        if (order > 0 && !(m->crown_base <= q->z1[i])) m->crown_base = q->z1[i];
        m->length += l, m->order_length[o] += l;
        m->volume += volume, m->order_volume[o] += volume;
        m->area += WF_PI * (r0 + r1) * sqrt(l * l + (r0 - r1) * (r0 - r1));
        high = fmax(high, fmax(q->z0[i], q->z1[i]));
        x0 = fmin(x0, fmin(q->x0[i], q->x1[i])), x1 = fmax(x1, fmax(q->x0[i], q->x1[i]));
        y0 = fmin(y0, fmin(q->y0[i], q->y1[i])), y1 = fmax(y1, fmax(q->y0[i], q->y1[i]));
    }
    int32_t root = main_root(q);
    if (root < 0) return;
    m->height = high - low, m->width_x = x1 - x0, m->width_y = y1 - y0;
    m->crown_base -= low;
    m->base_diameter = 2 * q->r0[root];
    m->dbh = breast_diameter(q);
}

/* Cosine of the angle between row i and the wind. */
static double cosine_to_wind(const struct wf_qsm *q, size_t i, double wx, double wy)
{
    double d = wf_qsm_distance(q, i);
    return d > 0 ? ((q->x1[i] - q->x0[i]) * wx + (q->y1[i] - q->y0[i]) * wy) / d : 1;
}

double wf_qsm_sail(const struct wf_qsm *q, double azimuth)
{
    double area = 0, wx = cos(azimuth), wy = sin(azimuth);
    for (size_t i = 0; i < q->n; i++) {
        double c = cosine_to_wind(q, i, wx, wy);
        area += (q->r0[i] + q->r1[i]) * q->length[i] * sqrt(fmax(1 - c * c, 0));
    }
    return area;
}

void wf_qsm_drag(const struct wf_qsm *q, double pressure, double drag_coefficient, double azimuth,
                 double *force, double *moment)
{
    struct wf_loads l;
    wf_loads_default(&l);
    l.gravity = 0;
    struct wf_scenario scene;
    struct wf_wind wind;
    wf_scenario_default(&scene);
    scene.profile = "uniform", scene.azimuth = azimuth;
    wf_scenario_wind(&scene, &wind);
    wind.speed = sqrt(2 * pressure / l.air_density);
    double low = INFINITY;
    l.wind = &wind;
    for (size_t i = 0; i < q->n; i++)
        if (q->parent[i] < 0) low = fmin(low, q->z0[i]);
    *force = *moment = 0;
    for (size_t i = 0; i < q->n; i++) {
        const struct wf_line_point point = { .diameter = q->r0[i] + q->r1[i], .drag = drag_coefficient };
        const double d = wf_qsm_distance(q, i), x[3] = { q->x0[i], q->y0[i], q->z0[i] };
        if (!(d > 0)) continue;
        const double t[3] = { (q->x1[i] - x[0]) / d, (q->y1[i] - x[1]) / d, (q->z1[i] - x[2]) / d };
        struct wf_line_parts parts;
        wf_load_parts_on_line(&l, &point, x, t, &parts);
        double f = q->length[i] * sqrt(wf_dot(parts.drag_axis, parts.drag_axis));
        *force += f;
        *moment += f * (0.5 * (q->z0[i] + q->z1[i]) - low);
    }
}
