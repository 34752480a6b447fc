/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/sensor.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/species.h"
#include "solve/beam_mesh.h"
#include "solve/beam_small.h"

/* Sensors on a bent stem. */

/* A point of the stem: bent pose, and position and axis of the unloaded stem. */
struct place {
    struct wf_beam_pose pose;
    double at[3], axis[3], radius;
};

static void place_of(const struct wf_beam *b, int32_t row, struct place *p)
{
    const struct wf_tree *t = b->mesh.tree;
    size_t i = row < 0 ? 0 : (size_t)row;
    wf_row_axis(t, i, row < 0 ? 0 : 1, p->at, p->axis);
    p->radius = row < 0 ? t->r0[i] : t->r1[i];
    struct wf_beam_pose ground;
    p->pose = row < 0 ? *wf_beam_base(b, 0, &ground) : b->pose[b->mesh.last[i]];
}

/* Change of a point: displacement, rotation. */
static const double *change_of(const struct wf_beam *b, int32_t row, const double (*ends)[6])
{
    return row < 0 ? b->root_change[0] : ends[b->mesh.last[row]];
}

static void azimuth_of(const struct wf_fit_sensor *s, double d[3])
{
    d[0] = cos(s->azimuth), d[1] = sin(s->azimuth), d[2] = 0;
}

/* Vector from the axis to the fibre under a gauge, perpendicular to the axis. */
static void fibre(const struct wf_fit_sensor *s, const struct place *p, double out[3])
{
    double d[3], size;
    azimuth_of(s, d);
    v3_add(d, -wf_dot(d, p->axis), p->axis);
    size = sqrt(wf_dot(d, d));
    for (int i = 0; i < 3; i++) out[i] = size > 0 ? p->radius * d[i] / size : 0;
}

/* A gauge: vector from its lower to its upper end, bent and unloaded, and its lever arms when bent. */
struct gauge {
    double bent[3], rest[3], arm[2][3], lever[2][3], bent_length, rest_length;
};
static void gauge_of(const struct wf_fit_sensor *s, const struct wf_beam *b, struct gauge *g)
{
    struct place p[2];
    place_of(b, s->low_row, &p[0]);
    place_of(b, s->row, &p[1]);
    for (int k = 0; k < 2; k++) {
        fibre(s, &p[k], g->lever[k]);
        m3_apply(p[k].pose.L, g->lever[k], g->arm[k]);
    }
    for (int i = 0; i < 3; i++) {
        g->bent[i] = p[1].pose.r[i] + g->arm[1][i] - p[0].pose.r[i] - g->arm[0][i];
        g->rest[i] = p[1].at[i] + g->lever[1][i] - p[0].at[i] - g->lever[0][i];
    }
    g->bent_length = sqrt(wf_dot(g->bent, g->bent));
    g->rest_length = sqrt(wf_dot(g->rest, g->rest));
}

bool wf_sensor_framed(const struct wf_fit_sensor *s)
{
    return s->kind == WF_SENSOR_DEFLECTION || s->kind == WF_SENSOR_REACH;
}

double wf_sensor_read(const struct wf_fit_sensor *s, const struct wf_beam *b)
{
    struct place p;
    double d[3], a[3], moved[3];
    azimuth_of(s, d);
    if (s->kind == WF_SENSOR_MOMENT) return b->base.m[1] * d[0] - b->base.m[0] * d[1];
    if (s->kind == WF_SENSOR_STRAIN || s->kind == WF_SENSOR_EXTENSION) {
        struct gauge g;
        gauge_of(s, b, &g);
        double more = g.bent_length - g.rest_length;
        return s->kind == WF_SENSOR_STRAIN ? more / g.rest_length : more;
    }
    place_of(b, s->row, &p);
    const struct wf_tree *t = b->mesh.tree;
    const double base[3] = { t->x0[0], t->y0[0], t->z0[0] };
    bool absolute = s->kind == WF_SENSOR_REACH || s->kind == WF_SENSOR_RISE;
    for (int i = 0; i < 3; i++) moved[i] = p.pose.r[i] - (absolute ? base[i] : p.at[i]);
    m3_apply(p.pose.L, p.axis, a);
    switch (s->kind) {
    case WF_SENSOR_HORIZONTAL:
        return hypot(moved[0], moved[1]);
    case WF_SENSOR_RISE:
    case WF_SENSOR_VERTICAL:
        return moved[2];
    case WF_SENSOR_TILT:
        return atan2(wf_dot(a, d), a[2]) - atan2(wf_dot(p.axis, d), p.axis[2]);
    default:
        return wf_dot(moved, d);
    }
}

static double gauge_change(const struct wf_fit_sensor *s, const struct wf_beam *b, const double (*ends)[6])
{
    struct gauge g;
    double by[3] = { 0, 0, 0 }, turned[3];
    gauge_of(s, b, &g);
    const double *low = change_of(b, s->low_row, ends), *high = change_of(b, s->row, ends);
    wf_cross(high + 3, g.arm[1], turned);
    v3_add(by, 1, high), v3_add(by, 1, turned);
    wf_cross(low + 3, g.arm[0], turned);
    v3_add(by, -1, low), v3_add(by, -1, turned);
    double longer = wf_dot(g.bent, by) / g.bent_length;
    return s->kind == WF_SENSOR_STRAIN ? longer / g.rest_length : longer;
}

double wf_sensor_change(const struct wf_fit_sensor *s, const struct wf_beam *b, const double (*ends)[6],
                        const double ground[6])
{
    struct place p;
    double d[3], a[3], turned[3], along, up;
    azimuth_of(s, d);
    if (s->kind == WF_SENSOR_MOMENT) return ground[4] * d[0] - ground[3] * d[1];
    if (s->kind == WF_SENSOR_STRAIN || s->kind == WF_SENSOR_EXTENSION) return gauge_change(s, b, ends);
    place_of(b, s->row, &p);
    const double *c = change_of(b, s->row, ends);
    double x = p.pose.r[0] - p.at[0], y = p.pose.r[1] - p.at[1], far = hypot(x, y);
    switch (s->kind) {
    case WF_SENSOR_HORIZONTAL:
        return far > 0 ? (x * c[0] + y * c[1]) / far : hypot(c[0], c[1]);
    case WF_SENSOR_RISE:
    case WF_SENSOR_VERTICAL:
        return c[2];
    case WF_SENSOR_TILT:
        m3_apply(p.pose.L, p.axis, a);
        wf_cross(c + 3, a, turned);
        along = wf_dot(a, d), up = a[2];
        return (up * wf_dot(turned, d) - along * turned[2]) / (along * along + up * up);
    default:
        return wf_dot(c, d);
    }
}

double wf_sensor_by_azimuth(const struct wf_fit_sensor *s, const struct wf_beam *b)
{
    if (!wf_sensor_framed(s)) return 0;
    struct wf_fit_sensor across = *s;
    across.azimuth += WF_PI / 2;
    return wf_sensor_read(&across, b);
}

/* Is a row of that level, of a table with `levels`? */
static bool row_on(const struct wf_beam *b, int32_t row, int32_t level, size_t levels)
{
    size_t own = (size_t)b->mesh.tree->level[row < 0 ? 0 : row];
    return level < 0 || (own < levels ? own : levels - 1) == (size_t)level;
}

double wf_sensor_by_radius(const struct wf_fit_sensor *s, const struct wf_beam *b, int32_t level,
                           size_t levels)
{
    if (s->kind != WF_SENSOR_STRAIN && s->kind != WF_SENSOR_EXTENSION) return 0;
    struct gauge g;
    double by[3], rest[3], acts[2];
    gauge_of(s, b, &g);
    acts[0] = row_on(b, s->low_row, level, levels), acts[1] = row_on(b, s->row, level, levels);
    for (int i = 0; i < 3; i++) {
        by[i] = acts[1] * g.arm[1][i] - acts[0] * g.arm[0][i];
        rest[i] = acts[1] * g.lever[1][i] - acts[0] * g.lever[0][i];
    }
    double longer = wf_dot(g.bent, by) / g.bent_length, longer_rest = wf_dot(g.rest, rest) / g.rest_length;
    if (s->kind == WF_SENSOR_EXTENSION) return longer - longer_rest;
    return (longer - longer_rest * g.bent_length / g.rest_length) / g.rest_length;
}

/* Change of a solved tree's equilibrium by a parameter, for each element at a fixed shape. */

bool wf_disturbs(const struct wf_fit_param *p, size_t tree)
{
    if (wf_param_nuisance(p) || p->quantity == WF_FIT_DAMPING || p->quantity == WF_FIT_FRAME) return false;
    return p->tree < 0 || (size_t)p->tree == tree;
}

/* Derivative of the section moment by ln E (bending, and torsion where G is proportional to E) or ln G. */
static void by_modulus(const struct wf_beam *b, size_t i, bool bending, bool torsion, double factor,
                       size_t side, struct wf_beam_disturbance *out)
{
    double m[2][3];
    wf_beam_law_moment(b, i, m);
    for (int j = 0; j < 2; j++) {
        const double *t = b->stage[i].t[j];
        double along = wf_dot(t, m[j]);
        for (int c = 0; c < 3; c++) {
            double twist = along * t[c], bend = m[j][c] - twist;
            out->law[j][c][side] += factor * ((bending ? bend : 0) + (torsion ? twist : 0));
        }
    }
}

/* Derivative of the axis' strain by ln E, times `factor`; that of the state at rest moves with it, so that
 * only the strain counted from there is changed. */
static void by_stretch(const struct wf_beam *b, size_t i, double factor, size_t side,
                       struct wf_beam_disturbance *out)
{
    const struct wf_beam_stage *g = &b->stage[i];
    for (int j = 0; j < 2; j++)
        for (int c = 0; c < 3; c++) out->stretch[j][c][side] -= factor * (g->rp[j][c] - g->t[j][c]);
}

/* Wood's mass per length at Gauss point j of an element [kg/m]. */
static double wood_at(const struct wf_beam *b, size_t i, int j)
{
    const struct wf_tree *t = b->mesh.tree;
    size_t row = (size_t)b->mesh.part[i].row;
    double outer = t->r0[row] + (t->r1[row] - t->r0[row]) * gauss_place[j],
           inner = t->i0[row] + (t->i1[row] - t->i0[row]) * gauss_place[j];
    return t->density[row] * WF_PI * (outer * outer - inner * inner);
}

/* Wind and weight per length at Gauss point j of element i. */
static void load_at(const struct wf_loads *l, const struct wf_line_point *q, const struct wf_beam *b,
                    size_t i, int j, double force[3])
{
    struct wf_line_load f;
    wf_load_on_line(l, q, b->stage[i].r[j], b->stage[i].t[j], &f);
    memcpy(force, f.force, sizeof f.force);
}

/* Derivative of the load at the Gauss points, by central differences of scalar inputs only (mass, diameter,
 * coefficients, exponent); relative error below 1e-9. */
static void by_load(const struct wf_disturber *x, const struct wf_beam *b, size_t i, size_t side,
                    struct wf_beam_disturbance *out)
{
    const double step = 1e-4;
    const struct wf_beam_part *part = &b->mesh.part[i];
    for (int j = 0; j < 2; j++) {
        double load[2][3], wood = wood_at(b, i, j);
        for (int k = 0; k < 2; k++) {
            double up = k ? step : -step, factor = exp(up), *number;
            struct wf_loads l = b->loads;
            struct wf_line_point q = part->line[j];
            switch (x->param->quantity) {
            case WF_FIT_DENSITY:
                q.mass += wood * (factor - 1);
                break;
            case WF_FIT_RADIUS:
                q.diameter *= factor, q.mass += wood * (factor * factor - 1);
                break;
            case WF_FIT_AXIS_DRAG:
                q.drag *= factor;
                break;
            case WF_FIT_CROWN_DRAG:
                q.sail *= factor;
                break;
            default: /* Vogel exponent; its internal value is the exponent itself over `unit` */
                if ((number = wf_loads_streamline_number(&l, WF_FIT_CROWN_LAW)))
                    *number += up * x->param->unit;
            }
            load_at(&l, &q, b, i, j, load[k]);
        }
        for (int c = 0; c < 3; c++) out->force[j][c][side] = (load[1][c] - load[0][c]) / (2 * step);
    }
}

/* Does the parameter act on the element's level? Returned: *level. */
static bool on_level(const struct wf_disturber *x, const struct wf_beam *b, size_t i, size_t *level)
{
    const struct wf_fit_tree *t = x->tree;
    *level = (size_t)t->tree.level[b->mesh.part[i].row];
    if (*level >= t->species->levels) *level = t->species->levels - 1;
    return x->param->level < 0 || (size_t)x->param->level == *level;
}

/* Derivative of the mass per length at Gauss point j. */
static double by_mass(const struct wf_disturber *x, const struct wf_beam *b, size_t i, int j)
{
    size_t level;
    if (!on_level(x, b, i, &level)) return 0;
    return (x->param->quantity == WF_FIT_RADIUS ? 2 : 1) * wood_at(b, i, j);
}

enum wf_status wf_disturb_rest(struct wf_disturber *x, const struct wf_beam *b, struct wf_arena *a,
                               struct wf_err *e)
{
    bool heavier = x->param->quantity == WF_FIT_DENSITY || x->param->quantity == WF_FIT_RADIUS;
    if (!b->mesh.standing || !heavier) return WF_OK;
    struct wf_arena scratch = { 0 };
    struct wf_beam_rest_part *part;
    double(*root)[3], (*mass)[2] = wf_arena_take(&scratch, b->mesh.n, sizeof *mass);
    if (!mass) return wf_fail(e, WF_ENOMEM, "not enough memory for the state at rest");
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) mass[i][j] = by_mass(x, b, i, j);
    enum wf_status s =
        wf_beam_rest_of(&b->mesh, mass, b->loads.gravity * b->loads.weight_scale, a, &part, &root, e);
    wf_arena_free(&scratch);
    if (s) return s;
    x->rest = part, x->rest_root = (const double(*)[3])root;
    return WF_OK;
}

/* Derivative by the state at rest: its moments and strains turn with the sections. */
static void by_rest(const struct wf_disturber *x, const struct wf_beam *b, size_t i, size_t side,
                    struct wf_beam_disturbance *out)
{
    double moment[2][3], strain[2][3];
    if (!x->rest) return;
    wf_beam_turn_along(b, i, x->rest[i].moment, moment);
    wf_beam_turn_along(b, i, x->rest[i].strain, strain);
    for (int j = 0; j < 2; j++)
        for (int c = 0; c < 3; c++) {
            out->law[j][c][side] += moment[j][c];
            out->stretch[j][c][side] -= strain[j][c];
        }
}

static void disturb_side(const struct wf_disturber *x, const struct wf_beam *b, size_t i, size_t side,
                         struct wf_beam_disturbance *out)
{
    const struct wf_fit_tree *t = x->tree;
    size_t row = (size_t)b->mesh.part[i].row, level;
    by_rest(x, b, i, side, out); /* of what is above, whatever its level */
    if (!on_level(x, b, i, &level)) return;
    bool follows = !t->species->level[level].shear_modulus.given;
    switch (x->param->quantity) {
    case WF_FIT_YOUNGS:
        by_modulus(b, i, true, follows, 1, side, out);
        by_stretch(b, i, 1, side, out);
        return;
    case WF_FIT_YOUNGS_TIP: {
        double s = 0.5 * (t->tree.z0[row] + t->tree.z1[row] - 2 * t->tree.z0[0]) / t->height;
        double q = exp(x->internal);
        by_modulus(b, i, true, follows, q * s / (1 + (q - 1) * s), side, out);
        by_stretch(b, i, q * s / (1 + (q - 1) * s), side, out);
        return;
    }
    case WF_FIT_SHEAR:
        by_modulus(b, i, false, true, 1, side, out);
        return;
    case WF_FIT_ROOT:
        return;
    case WF_FIT_RADIUS:
        by_modulus(b, i, true, true, 4, side, out);
        by_stretch(b, i, 2, side, out);
        by_load(x, b, i, side, out);
        return;
    default:
        by_load(x, b, i, side, out);
    }
}

void wf_disturb(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out)
{
    const struct wf_disturbers *x = ctx;
    for (size_t side = 0; side < x->count; side++) disturb_side(&x->side[side], b, i, side, out);
}
