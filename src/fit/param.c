/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/param.h"
#include "base/num.h"
#include "base/text.h"
#include "data/species.h"
#include "load/drag.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct wf_fit_quantity_row wf_fit_quantities[WF_FIT_QUANTITIES] = {
    [WF_FIT_YOUNGS] = { "levelN.youngs_modulus", WF_DIM_PRESSURE, "GPa", 1e-9, true, 1e8, 1e11,
                        "modulus of elasticity along the grain of a level; 'wood' for levelN: one factor on "
                        "all levels, given as the value of level 0" },
    [WF_FIT_YOUNGS_TIP] = { "youngs_modulus_tip_share", WF_DIM_NONE, "", 1, true, 0.05, 20,
                            "modulus at the top of the tree over that at its base, linear with height" },
    [WF_FIT_SHEAR] = { "levelN.shear_modulus", WF_DIM_PRESSURE, "GPa", 1e-9, true, 1e6, 1e10,
                       "shear modulus of a level" },
    [WF_FIT_DENSITY] = { "levelN.density", WF_DIM_DENSITY, "kg/m3", 1, true, 100, 2000,
                         "density of a level as it stands" },
    [WF_FIT_RADIUS] = { "levelN.radius_factor", WF_DIM_NONE, "", 1, true, 0.5, 2,
                        "factor on all radii of a level" },
    [WF_FIT_AXIS_DRAG] = { "levelN.drag_coefficient", WF_DIM_NONE, "", 1, true, 0.05, 5,
                           "cross-flow drag coefficient of a level's axes" },
    [WF_FIT_CROWN_DRAG] = { "crown.drag_coefficient", WF_DIM_NONE, "", 1, true, 0.02, 5,
                            "drag coefficient of the crown on its still-air frontal area" },
    [WF_FIT_VOGEL] = { "crown.streamlining.exponent", WF_DIM_NONE, "", 1, false, -1.9, 0,
                       "Vogel exponent of the crown" },
    [WF_FIT_ROOT] = { "root.stiffness", WF_DIM_ROTATIONAL_STIFFNESS, "kN m/rad", 1e-3, true, 1e2, 1e10,
                      "rotational stiffness of the root plate" },
    [WF_FIT_DAMPING] = { "damping_ratio", WF_DIM_NONE, "%", 100, true, 1e-4, 0.9,
                         "damping ratio of free sway, all causes together" },
    [WF_FIT_FRAME] = { "frame.azimuth", WF_DIM_ANGLE, "deg", 180 / WF_PI, false, -WF_PI, WF_PI,
                       "direction, in the model, of azimuth 0 of measured coordinates (deflection, reach)" },
    [WF_FIT_OFFSET] = { NULL, WF_DIM_NONE, "", 1, false, -1e3, 1e3, "zero of a sensor" },
    [WF_FIT_DRIFT] = { NULL, WF_DIM_NONE, "", 1, false, -1e3, 1e3, "drift of a sensor's zero" },
};

enum wf_fit_quantity wf_fit_quantity_of(const char *table, const char *key)
{
    size_t n = strlen(table);
    for (int q = 0; q < WF_FIT_QUANTITIES; q++) {
        const char *name = wf_fit_quantities[q].name;
        if (name && !strncmp(name, table, n) && !strcmp(name + n, key)) return (enum wf_fit_quantity)q;
    }
    return WF_FIT_QUANTITIES;
}

double wf_param_value(const struct wf_fit_param *p, double x)
{
    return wf_fit_quantities[p->quantity].log ? exp(x) : x * p->unit;
}

double wf_param_internal(const struct wf_fit_param *p, double v)
{
    return wf_fit_quantities[p->quantity].log ? log(v) : v / p->unit;
}

bool wf_param_nuisance(const struct wf_fit_param *p)
{
    return p->quantity == WF_FIT_OFFSET || p->quantity == WF_FIT_DRIFT;
}

const char *wf_param_unit(const struct wf_experiment *x, const struct wf_fit_param *p, double *factor)
{
    if (wf_param_nuisance(p)) {
        const struct wf_sensor_row *r = &wf_sensor_rows[x->test[p->test].sensor[p->sensor].kind];
        *factor = r->factor;
        return r->unit;
    }
    *factor = wf_fit_quantities[p->quantity].factor;
    return wf_fit_quantities[p->quantity].unit;
}

/* Does a parameter act on a row of a tree? */
static bool acts(const struct wf_fit_param *p, const struct wf_fit_tree *t, size_t row)
{
    size_t level = (size_t)t->tree.level[row], most = t->species->levels;
    if (level >= most) level = most - 1;
    return p->level < 0 || (size_t)p->level == level;
}

static void scale_rows(const struct wf_fit_param *p, const struct wf_fit_tree *t, struct wf_tree *into,
                       double v)
{
    for (size_t i = 0; i < into->n; i++) {
        if (!acts(p, t, i)) continue;
        size_t level =
            (size_t)t->tree.level[i] < t->species->levels ? (size_t)t->tree.level[i] : t->species->levels - 1;
        const struct wf_level *l = &t->species->level[level];
        double factor = v / t->species->level[0].youngs_modulus.value;
        switch (p->quantity) {
        case WF_FIT_YOUNGS:
            if (p->level >= 0) factor = v / l->youngs_modulus.value;
            into->youngs[i] *= factor;
            if (!l->shear_modulus.given) into->shear[i] *= factor;
            break;
        case WF_FIT_YOUNGS_TIP: {
            double s = 0.5 * (t->tree.z0[i] + t->tree.z1[i] - 2 * t->tree.z0[0]) / t->height;
            into->youngs[i] *= 1 + (v - 1) * s;
            if (!l->shear_modulus.given) into->shear[i] *= 1 + (v - 1) * s;
            break;
        }
        case WF_FIT_SHEAR:
            into->shear[i] *= v / l->shear_modulus.value;
            break;
        case WF_FIT_DENSITY:
            if (into->density[i] > 0) into->density[i] = v;
            break;
        case WF_FIT_RADIUS:
            into->r0[i] *= v, into->r1[i] *= v, into->i0[i] *= v, into->i1[i] *= v;
            break;
        case WF_FIT_AXIS_DRAG:
            if (into->drag[i] != 0) into->drag[i] = v;
            break;
        default:
            into->sail0[i] *= v / t->species->crown.drag_coefficient.value;
            into->sail1[i] *= v / t->species->crown.drag_coefficient.value;
        }
    }
}

void wf_param_apply(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                    const double *internal, size_t tree, struct wf_tree *into, struct wf_loads *loads,
                    struct wf_solve_options *options)
{
    const struct wf_fit_tree *t = &x->tree[tree];
    const size_t bytes = t->tree.n * sizeof(double);
    double *const column[][2] = {
        { into->youngs, t->tree.youngs }, { into->shear, t->tree.shear }, { into->density, t->tree.density },
        { into->r0, t->tree.r0 },         { into->r1, t->tree.r1 },       { into->i0, t->tree.i0 },
        { into->i1, t->tree.i1 },         { into->drag, t->tree.drag },   { into->sail0, t->tree.sail0 },
        { into->sail1, t->tree.sail1 },
    };
    for (size_t k = 0; k < WF_COUNT(column); k++) memcpy(column[k][0], column[k][1], bytes);
    *loads = t->loads;
    *options = t->options;
    for (size_t k = 0; k < n; k++) {
        if (wf_param_nuisance(&p[k]) || (p[k].tree >= 0 && (size_t)p[k].tree != tree)) continue;
        double v = wf_param_value(&p[k], internal[k]), *number;
        if (p[k].quantity == WF_FIT_ROOT)
            options->root_stiffness[0] = options->root_stiffness[1] = v;
        else if (p[k].quantity == WF_FIT_VOGEL &&
                 (number = wf_loads_streamline_number(loads, WF_FIT_CROWN_LAW)))
            *number = v;
        else if (p[k].quantity != WF_FIT_VOGEL && p[k].quantity != WF_FIT_DAMPING &&
                 p[k].quantity != WF_FIT_FRAME)
            scale_rows(&p[k], t, into, v);
    }
    for (size_t i = 0; i < t->tree.n && t->props; i++)
        into->youngs[i] *= t->props->raise[i], into->shear[i] *= t->props->raise[i];
}

/* Parameters from their names. */

static double ratio(const struct wf_value *v)
{
    return v->high > v->low && v->low > 0 ? log(v->high / v->low) : 0;
}

/* The value of the species table for a quantity; NULL: there is none. */
static const struct wf_value *in_table(const struct wf_species *sp, const struct wf_level *l,
                                       enum wf_fit_quantity q)
{
    const struct wf_law *law = wf_law_named(wf_laws.streamlining, sp->streamlining.law);
    struct wf_property p;
    for (size_t i = 0; wf_level_property(l, i, &p); i++)
        if (wf_fit_quantity_of("levelN.", p.key) == q) return p.value;
    for (size_t i = 0; wf_crown_property(sp, i, &p); i++)
        if (wf_fit_quantity_of("crown.", p.key) == q) return p.value;
    for (size_t i = 0; wf_law_property(law, &sp->streamlining, i, &p); i++)
        if (wf_fit_quantity_of("crown.streamlining.", p.key) == q) return p.value;
    return NULL;
}

/* Start value and range of the species table: the range is taken as a 95 % interval. */
static enum wf_status from_species(const struct wf_experiment *x, struct wf_fit_param *p, struct wf_err *e)
{
    const struct wf_fit_tree *t = &x->tree[p->tree >= 0 ? p->tree : 0];
    const struct wf_species *sp = t->species;
    if (p->level >= 0 && (size_t)p->level >= sp->levels)
        return wf_fail(e, WF_EUSAGE, "%s: the species table %s has %zu level%s, counted from 0", p->name,
                       sp->key, sp->levels, sp->levels == 1 ? "" : "s");
    const struct wf_level *l = &sp->level[p->level >= 0 ? p->level : 0];
    const struct wf_value *v = in_table(sp, l, p->quantity);
    double radius = t->tree.r0[0], height = t->height;
    p->unit = 1;
    p->start = 1;
    if (v) p->start = v->value;
    if (p->quantity == WF_FIT_AXIS_DRAG && isnan(p->start)) p->start = 1;
    if (p->quantity == WF_FIT_DAMPING) p->start = 0.05;
    if (p->quantity == WF_FIT_FRAME) p->start = 0;
    if (t->tree.section && (p->quantity == WF_FIT_RADIUS || p->quantity == WF_FIT_DENSITY))
        return wf_fail(e, WF_EUSAGE, "%s: not for a stem with 'sections'", p->name);
    /* a root plate that rotates as much as a stem of that size bends */
    if (p->quantity == WF_FIT_ROOT)
        p->start = t->options.root_stiffness[0] > 0
                       ? t->options.root_stiffness[0]
                       : 10 * l->youngs_modulus.value * 0.785 * pow(radius, 4) / height;
    if (p->quantity == WF_FIT_VOGEL && !v) p->start = NAN;
    if ((v || isnan(p->start)) &&
        (isnan(p->start) || (wf_fit_quantities[p->quantity].log && !(p->start > 0))))
        return wf_fail(e, WF_EUSAGE, "%s: the species table %s has no value to start from", p->name, sp->key);
    if (v && wf_fit_quantities[p->quantity].log && ratio(v) > 0) {
        p->prior_mean = log(v->value);
        p->prior_sd = ratio(v) / (2 * 1.96);
    } else if (v && p->quantity == WF_FIT_VOGEL && v->high > v->low) {
        p->prior_mean = v->value;
        p->prior_sd = (v->high - v->low) / (2 * 1.96);
    }
    return WF_OK;
}

static enum wf_status unknown(const char *name, struct wf_err *e)
{
    const char *known[WF_FIT_QUANTITIES + 2];
    size_t n = 0;
    for (int k = 0; k < WF_FIT_QUANTITIES; k++)
        if (wf_fit_quantities[k].name) known[n++] = wf_fit_quantities[k].name;
    known[n++] = "wood.youngs_modulus";
    const char *near = wf_nearest(name, known, n);
    int level = 0;
    (void)sscanf(name, "level%d", &level);
    if (near && !strncmp(near, "levelN", 6))
        return wf_fail(e, WF_EUSAGE, "unknown parameter '%s'; did you mean 'level%d%s'?", name, level,
                       near + 6);
    if (near) return wf_fail(e, WF_EUSAGE, "unknown parameter '%s'; did you mean '%s'?", name, near);
    return wf_fail(e, WF_EUSAGE,
                   "unknown parameter '%s'; known are levelN.youngs_modulus, wood.youngs_modulus, "
                   "youngs_modulus_tip_share, levelN.shear_modulus, levelN.density, levelN.radius_factor, "
                   "levelN.drag_coefficient, crown.drag_coefficient, crown.streamlining.exponent, "
                   "root.stiffness, damping_ratio, frame.azimuth",
                   name);
}

/* Quantity and level of a name without its tree. */
static bool find(const char *name, enum wf_fit_quantity *q, int32_t *level)
{
    int used = 0;
    const char *rest = name;
    long number = -1;
    *level = -1;
    if (sscanf(name, "level%ld%n", &number, &used) == 1 && used > 0 && name[used] == '.' && number >= 0 &&
        number < 1000)
        rest = name + used, *level = (int32_t)number;
    for (int k = 0; k < WF_FIT_QUANTITIES; k++) {
        const char *full = wf_fit_quantities[k].name;
        if (!full) continue;
        bool leveled = !strncmp(full, "levelN", 6);
        if (leveled ? *level >= 0 && !strcmp(full + 6, rest) : !strcmp(full, name)) {
            *q = (enum wf_fit_quantity)k;
            return true;
        }
    }
    *q = WF_FIT_YOUNGS;
    return !strcmp(name, "wood.youngs_modulus");
}

static enum wf_status tree_named(const struct wf_experiment *x, const char *name, size_t length, size_t *from,
                                 size_t *to, struct wf_err *e)
{
    const char *known[64];
    size_t n = x->trees < 64 ? x->trees : 64;
    *from = 0, *to = x->trees;
    if (length == 4 && !strncmp(name, "each", 4)) return WF_OK;
    for (size_t i = 0; i < n; i++) {
        known[i] = x->tree[i].name;
        if (strlen(known[i]) == length && !strncmp(known[i], name, length)) {
            *from = i, *to = i + 1;
            return WF_OK;
        }
    }
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)length, name);
    const char *near = wf_nearest(word, known, n);
    return wf_fail(e, WF_EUSAGE, "the study has no tree '%s'; %s%s%s", word,
                   near ? "did you mean '" : "the first is '", near ? near : known[0], near ? "'?" : "'");
}

enum wf_status wf_param_add(const struct wf_experiment *x, const char *name, struct wf_arena *a,
                            struct wf_fit_param *out, size_t *n, struct wf_err *e)
{
    const char *colon = strchr(name, ':'), *plain = colon ? colon + 1 : name;
    struct wf_fit_param p = { .tree = -1 };
    if (!find(plain, &p.quantity, &p.level)) return unknown(plain, e);
    size_t from = 0, to = 1;
    enum wf_status status = colon ? tree_named(x, name, (size_t)(colon - name), &from, &to, e) : WF_OK;
    if (status) return status;
    for (size_t i = from; i < to; i++) {
        p.tree = colon && x->trees > 1 ? (ptrdiff_t)i : -1;
        p.name = p.tree >= 0 ? wf_arena_print(a, "%s:%s", x->tree[i].name, plain) : wf_arena_text(a, plain);
        if (!p.name) return wf_fail(e, WF_ENOMEM, "not enough memory for parameters");
        p.low = wf_fit_quantities[p.quantity].low;
        p.high = wf_fit_quantities[p.quantity].high;
        if ((status = from_species(x, &p, e))) return status;
        for (size_t k = 0; k < *n; k++)
            if (!strcmp(out[k].name, p.name))
                return wf_fail(e, WF_EUSAGE, "parameter '%s' is named twice", p.name);
        out[(*n)++] = p;
    }
    return WF_OK;
}

size_t wf_param_nuisances(const struct wf_experiment *x)
{
    size_t n = 0;
    for (size_t t = 0; t < x->tests; t++)
        for (size_t s = 0; s < x->test[t].sensors; s++)
            n += x->test[t].sensor[s].offset, n += x->test[t].sensor[s].drift;
    return n;
}

enum wf_status wf_param_add_nuisance(const struct wf_experiment *x, struct wf_arena *a,
                                     struct wf_fit_param *out, size_t *n, struct wf_err *e)
{
    for (size_t t = 0; t < x->tests; t++)
        for (size_t s = 0; s < x->test[t].sensors; s++) {
            const struct wf_fit_sensor *sensor = &x->test[t].sensor[s];
            double low = INFINITY, high = -INFINITY, late = 1;
            for (size_t i = 0; i < x->data; i++) {
                const struct wf_fit_datum *d = &x->datum[i];
                if (d->test != t || d->sensor != s) continue;
                low = fmin(low, d->value), high = fmax(high, d->value);
                late = fmax(late, x->test[t].state[d->state].time);
            }
            double spread = high > low ? high - low : 1;
            for (int k = 0; k < 2; k++) {
                if (!(k ? sensor->drift : sensor->offset)) continue;
                const char *test = x->tests > 1 ? x->test[t].name : "", *dot = x->tests > 1 ? ":" : "";
                struct wf_fit_param p = { .quantity = k ? WF_FIT_DRIFT : WF_FIT_OFFSET,
                                          .tree = -1,
                                          .level = -1,
                                          .test = t,
                                          .sensor = s,
                                          .unit = k ? spread / late : spread };
                p.name = wf_arena_print(a, "%s%s%s.%s", test, dot, sensor->name, k ? "drift" : "offset");
                if (!p.name) return wf_fail(e, WF_ENOMEM, "not enough memory for parameters");
                p.low = -1e3 * p.unit, p.high = 1e3 * p.unit;
                out[(*n)++] = p;
            }
        }
    return WF_OK;
}
