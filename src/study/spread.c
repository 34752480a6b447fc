/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/spread.h"
#include "base/arena.h"
#include "base/latin.h"
#include "data/model.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "grow/silhouette.h"
#include "study/peak.h"
#include <math.h>
#include <string.h>

/* ---- The rows ---- */

#define HANDBOOK "Forest Products Laboratory 2021, Wood Handbook, table 5-6"
#define RULE "rule"
#define LOG WF_SPREAD_LOGNORMAL
#define LINEAR WF_SPREAD_NORMAL
#define STIFFNESSES "shear_modulus tangential_modulus"
#define STRENGTHS "compressive_strength shear_strength tangential_strength"

/* The coefficients of variation of the handbook are those of small clear pieces of one species. */
const struct wf_spread wf_spreads[] = {
    { "density", WF_SPREAD_LEVEL, LOG, 0.10, 0, 0, INFINITY, true, NULL, HANDBOOK },
    { "youngs_modulus", WF_SPREAD_LEVEL, LOG, 0.22, 0, 0, INFINITY, true, STIFFNESSES, HANDBOOK },
    { "modulus_of_rupture", WF_SPREAD_LEVEL, LOG, 0.16, 0, 0, INFINITY, true, STRENGTHS, HANDBOOK },
    { "knot_factor", WF_SPREAD_LEVEL, LINEAR, 0, 0, 0.01, 1, false, NULL, RULE },
    { "drag_coefficient", WF_SPREAD_LEVEL, LOG, 0.15, 0, 0, INFINITY, false, NULL, RULE },
    { "lift_coefficient", WF_SPREAD_LEVEL, LINEAR, 0, 0, -3, 3, false, NULL, RULE },
    { "wall", WF_SPREAD_WALL, LOG, 0.10, 0, 0, INFINITY, false, NULL, RULE },
    { "drag_coefficient", WF_SPREAD_CROWN, LOG, 0.25, 0, 0, INFINITY, false, NULL, RULE },
    { "frontal_share", WF_SPREAD_CROWN, LOG, 0.25, 0, 0, 1, false, NULL, RULE },
    { "leaf_mass_per_area", WF_SPREAD_CROWN, LOG, 0.20, 0, 0, INFINITY, false, NULL, RULE },
    { "streamlining", WF_SPREAD_LAWS, LINEAR, 0.15, 0, -INFINITY, INFINITY, false, NULL, RULE },
    { "bare_drag", WF_SPREAD_BARE_DRAG, LOG, 0.15, 0, 0, INFINITY, false, NULL, RULE },
    { "gusts", WF_SPREAD_GUSTS, LOG, 0.15, 0, 0, INFINITY, false, NULL, RULE },
    { "damping", WF_SPREAD_DAMPING, LOG, 0.30, 0, 0, INFINITY, false, NULL, RULE },
    { "radius", WF_SPREAD_RADIUS, LOG, 0.02, 0.05, 0, INFINITY, false, NULL, RULE },
    { "height", WF_SPREAD_HEIGHT, LOG, 0.03, 0.01, 0, INFINITY, false, NULL, RULE },
    { "leaf_area", WF_SPREAD_LEAVES, LOG, 0.20, 0, 0, INFINITY, false, NULL, RULE },
    { "frontal_area", WF_SPREAD_AREA, LOG, 0.15, 0, 0, INFINITY, false, NULL, RULE },
    { "stem_form", WF_SPREAD_FORM, LOG, 0, 0, 0, INFINITY, false, NULL, RULE },
    { "anchorage", WF_SPREAD_ANCHORAGE, LOG, 0.33, 0, 0, INFINITY, false, NULL, RULE },
    { 0 },
};

/* ---- One value ---- */

double wf_varied_at(const struct wf_varied *v, double share)
{
    double z = wf_normal_quantile(share) / WF_SPREAD_Z, end = z < 0.0 ? v->low : v->high, x;
    if (v->row->law == WF_SPREAD_LOGNORMAL && v->value > 0.0 && end > 0.0)
        x = v->value * pow(end / v->value, fabs(z));
    else
        x = v->value + (end - v->value) * fabs(z);
    return fmin(fmax(x, v->row->least), v->row->most);
}

const char *wf_varied_prefix(const struct wf_varied *v)
{
    if (v->row->place == WF_SPREAD_CROWN) return "crown.";
    return v->row->place == WF_SPREAD_LAWS ? "crown.streamlining." : "";
}

/* low and high where a row's standard deviation gives them. */
static void by_row(struct wf_varied *v, bool scanned)
{
    const struct wf_spread *r = v->row;
    double sd = scanned && r->sd_scanned > 0.0 ? r->sd_scanned : r->sd, wide = WF_SPREAD_Z * sd;
    v->low = r->law == LOG ? v->value * exp(-wide) : v->value - wide * fabs(v->value);
    v->high = r->law == LOG ? v->value * exp(wide) : v->value + wide * fabs(v->value);
    v->low = fmax(v->low, r->least), v->high = fmin(v->high, r->most);
}

static bool varies(const struct wf_varied *v) { return v->low < v->value || v->high > v->value; }

static enum wf_status add(struct wf_variation *out, const struct wf_varied *v, struct wf_err *e)
{
    if (!varies(v)) return WF_OK;
    if (out->n == WF_VARIED_MAX) return wf_fail(e, WF_EINTERNAL, "more than %d values vary", WF_VARIED_MAX);
    out->varied[out->n++] = *v;
    return WF_OK;
}

static enum wf_status add_factor(struct wf_variation *out, const struct wf_spread *row, bool scanned,
                                 struct wf_err *e)
{
    struct wf_varied v = {
        .row = row, .name = row->name, .unit = "", .value = 1.0, .factor = true, .standing = WF_MEASURED
    };
    by_row(&v, scanned);
    return add(out, &v, e);
}

/* A value of the species; `holder`: the species or its first level, in which it is. */
static enum wf_status add_value(struct wf_variation *out, const struct wf_spread *row,
                                const struct wf_property *p, const void *holder, struct wf_err *e)
{
    const struct wf_value *value = p->value;
    struct wf_varied v = { .row = row,
                           .name = p->key,
                           .unit = p->unit,
                           .value = value->value,
                           .low = value->low,
                           .high = value->high,
                           .ranged = true,
                           .standing = value->standing,
                           .offset = (size_t)((const char *)value - (const char *)holder) };
    if (!isfinite(v.value) || (v.value == 0.0 && !value->given)) return WF_OK;
    if (v.low > v.value || v.high < v.value)
        return wf_fail(e, WF_EINPUT, "%s: the range %.6g to %.6g does not hold the value %.6g", v.name, v.low,
                       v.high, v.value);
    if (!varies(&v)) v.ranged = false, by_row(&v, false);
    return add(out, &v, e);
}

/* ---- What varies in an analysis ---- */

static bool level_value(const struct wf_level *l, const char *key, struct wf_property *out)
{
    for (size_t i = 0; wf_level_property(l, i, out); i++)
        if (!strcmp(out->key, key)) return true;
    return false;
}

static bool crown_value(const struct wf_species *sp, const char *key, struct wf_property *out)
{
    for (size_t i = 0; wf_crown_property(sp, i, out); i++)
        if (!strcmp(out->key, key)) return true;
    return false;
}

static bool has_leaves(const struct wf_analysis *an)
{
    for (size_t i = 0; i < an->tree.n; i++)
        if (an->tree.sail0[i] > 0.0 || an->tree.sail1[i] > 0.0) return true;
    return false;
}

static bool is_hollow(const struct wf_species *sp)
{
    for (size_t j = 0; j < sp->levels; j++)
        if (sp->level[j].wall.n) return true;
    return false;
}

static enum wf_status add_laws(struct wf_variation *out, const struct wf_spread *row,
                               const struct wf_species *sp, struct wf_err *e)
{
    const struct wf_law *law = wf_law_named(wf_laws.streamlining, sp->streamlining.law);
    struct wf_property p;
    enum wf_status s = WF_OK;
    for (size_t i = 0; law && !s && wf_law_property(law, &sp->streamlining, i, &p); i++)
        s = add_value(out, row, &p, sp, e);
    return s;
}

/* Damping of the species with its range, as a factor. */
static enum wf_status add_damping(struct wf_variation *out, const struct wf_spread *row,
                                  const struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_value *own = &an->species->level[0].damping_ratio;
    struct wf_varied v = {
        .row = row, .name = row->name, .unit = "", .value = 1.0, .factor = true, .standing = WF_ASSUMED
    };
    by_row(&v, false);
    if (isnan(an->scenario.peak.damping) && own->given && own->value > 0.0) {
        v.standing = own->standing;
        v.ranged = own->low < own->value || own->high > own->value;
        if (v.ranged) v.low = own->low / own->value, v.high = own->high / own->value;
    }
    return add(out, &v, e);
}

/* Form of a stem that was not measured: its radii to a power. */
static enum wf_status add_form(struct wf_variation *out, const struct wf_spread *row,
                               const struct wf_model *m, struct wf_err *e)
{
    struct wf_varied v = { .row = row,
                           .name = row->name,
                           .unit = "",
                           .value = 1.0,
                           .low = m->form_low,
                           .high = m->form_high,
                           .factor = true,
                           .ranged = true,
                           .standing = WF_ASSUMED };
    return m->form_low > 0.0 ? add(out, &v, e) : WF_OK;
}

/* Anchorage by the scatter of its method; by the row where that is not known. */
static enum wf_status add_anchorage(struct wf_variation *out, const struct wf_spread *row,
                                    const struct wf_analysis *an, struct wf_err *e)
{
    struct wf_varied v = {
        .row = row, .name = row->name, .unit = "", .value = 1.0, .factor = true, .standing = WF_MEASURED
    };
    double scatter = an->anchorage ? an->anchorage->scatter : (double)NAN;
    if (!(an->tree.anchorage > 0.0)) return WF_OK;
    by_row(&v, false);
    if (scatter > 0.0) v.low = exp(-WF_SPREAD_Z * scatter), v.high = exp(WF_SPREAD_Z * scatter);
    return add(out, &v, e);
}

static enum wf_status add_species_row(struct wf_variation *out, const struct wf_spread *row,
                                      const struct wf_analysis *an, struct wf_err *e)
{
    const struct wf_species *sp = an->species;
    struct wf_property p;
    if (row->place == WF_SPREAD_LEVEL)
        return level_value(sp->level, row->name, &p) ? add_value(out, row, &p, sp->level, e) : WF_OK;
    if (row->place == WF_SPREAD_CROWN)
        return has_leaves(an) && crown_value(sp, row->name, &p) ? add_value(out, row, &p, sp, e) : WF_OK;
    if (row->place == WF_SPREAD_LAWS) return has_leaves(an) ? add_laws(out, row, sp, e) : WF_OK;
    return is_hollow(sp) ? add_factor(out, row, false, e) : WF_OK;
}

/* Does a row that is a factor act on this analysis? */
static bool acts(const struct wf_spread *row, const struct wf_analysis *an)
{
    bool area = !isnan(wf_silhouette_area(&an->model->silhouette));
    switch (row->place) {
    case WF_SPREAD_GUSTS:
        return wf_peak_differs(an->peak);
    case WF_SPREAD_RADIUS:
        return !an->tree.section; /* sections with cavities stay as they were measured */
    case WF_SPREAD_LEAVES:
        return an->model->leaf_area > 0.0 && !area;
    case WF_SPREAD_AREA:
        return area && has_leaves(an);
    case WF_SPREAD_BARE_DRAG:
        return !has_leaves(an) && !an->species->level[0].drag_coefficient.given;
    default:
        return true;
    }
}

enum wf_status wf_variation_of(const struct wf_analysis *an, struct wf_variation *out, struct wf_err *e)
{
    bool scanned = an->model->generator == WF_GENERATOR_MEASURED;
    enum wf_status s = WF_OK;
    *out = (struct wf_variation){ 0 };
    for (const struct wf_spread *row = wf_spreads; row->name && !s; row++) {
        if (row->place <= WF_SPREAD_WALL)
            s = add_species_row(out, row, an, e);
        else if (row->place == WF_SPREAD_DAMPING)
            s = an->peak && an->peak->method->sways ? add_damping(out, row, an, e) : WF_OK;
        else if (row->place == WF_SPREAD_ANCHORAGE)
            s = add_anchorage(out, row, an, e);
        else if (row->place == WF_SPREAD_FORM)
            s = add_form(out, row, an->model, e);
        else if (acts(row, an))
            s = add_factor(out, row, scanned, e);
    }
    return s;
}

void wf_variation_ranks(const struct wf_variation *v, double *out)
{
    for (size_t i = 0; i < v->n; i++)
        for (size_t j = 0; j < v->n; j++) {
            bool both = v->varied[i].row->wood && v->varied[j].row->wood;
            out[i * v->n + j] = i == j ? 1.0 : both ? WF_SPREAD_WOOD : 0.0;
        }
}

/* ---- A sample ---- */

static struct wf_value *value_in(void *holder, size_t offset) { return (void *)((char *)holder + offset); }

/* The value of a holder at the share of a row's law, by its own range. */
static void put(const struct wf_varied *v, double share, struct wf_value *x)
{
    struct wf_varied own = *v;
    if (!isfinite(x->value)) return;
    own.value = x->value, own.low = x->low, own.high = x->high;
    if (!varies(&own)) by_row(&own, false);
    x->value = wf_varied_at(&own, share);
}

/* Values that change with another: by their own range at the same share, else by the same factor. */
static void put_followers(const struct wf_varied *v, double share, double factor, struct wf_level *l)
{
    struct wf_property p;
    for (size_t i = 0; v->row->follower && wf_level_property(l, i, &p); i++) {
        const char *at = strstr(v->row->follower, p.key);
        struct wf_value *x = value_in(l, (size_t)((const char *)p.value - (const char *)l));
        if (!at || !isfinite(x->value)) continue;
        if (x->low < x->value || x->high > x->value)
            put(v, share, x);
        else
            x->value *= factor;
    }
}

static void put_levels(const struct wf_varied *v, double share, struct wf_species *sp, struct wf_level *level)
{
    for (size_t j = 0; j < sp->levels; j++) {
        struct wf_value *x = value_in(&level[j], v->offset);
        double before = x->value;
        put(v, share, x);
        put_followers(v, share, x->value / before, &level[j]);
    }
}

static enum wf_status put_wall(double factor, struct wf_species *sp, struct wf_level *level,
                               struct wf_arena *a, struct wf_err *e)
{
    const double most = 0.999;
    for (size_t j = 0; j < sp->levels; j++) {
        struct wf_along *w = &level[j].wall;
        double *share = WF_TAKE(a, w->n, double);
        if (w->n && !share) return wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
        for (size_t i = 0; i < w->n; i++) share[i] = fmin(w->v[i] * factor, most);
        w->v = share;
    }
    return WF_OK;
}

static enum wf_status put_area(double factor, struct wf_silhouette *s, struct wf_arena *a, struct wf_err *e)
{
    double *x = WF_TAKE(a, s->points, double);
    if (s->points && !x) return wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
    for (size_t i = 0; i < s->points; i++) x[i] = factor * s->x[i];
    s->x = x;
    s->area *= factor;
    s->width *= factor;
    return WF_OK;
}

static enum wf_status put_form(double power, struct wf_along *profile, struct wf_arena *a, struct wf_err *e)
{
    double *share = WF_TAKE(a, profile->n, double);
    if (!share) return wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
    for (size_t i = 0; i < profile->n; i++) share[i] = pow(profile->v[i], power);
    profile->v = share;
    return WF_OK;
}

static enum wf_status put_one(const struct wf_varied *v, double share, struct wf_level *level,
                              struct wf_arena *a, struct wf_varied_copy *out, struct wf_err *e)
{
    double x = wf_varied_at(v, share);
    switch (v->row->place) {
    case WF_SPREAD_LEVEL:
        put_levels(v, share, out->species, level);
        return WF_OK;
    case WF_SPREAD_CROWN:
    case WF_SPREAD_LAWS:
        value_in(out->species, v->offset)->value = x;
        return WF_OK;
    case WF_SPREAD_WALL:
        return put_wall(x, out->species, level, a, e);
    case WF_SPREAD_RADIUS:
        out->misread.radius = x;
        return WF_OK;
    case WF_SPREAD_HEIGHT:
        out->misread.height = x;
        return WF_OK;
    case WF_SPREAD_LEAVES:
        out->model->leaf_area *= x, out->model->leaf_area_on *= x;
        return WF_OK;
    case WF_SPREAD_AREA:
        return put_area(x, &out->model->silhouette, a, e);
    case WF_SPREAD_FORM:
        return put_form(x, &out->model->profile, a, e);
    case WF_SPREAD_GUSTS:
    case WF_SPREAD_BARE_DRAG:
        out->load *= x;
        return WF_OK;
    case WF_SPREAD_DAMPING:
        out->damping *= x;
        return WF_OK;
    case WF_SPREAD_ANCHORAGE:
        out->anchorage *= x;
        return WF_OK;
    }
    return WF_OK;
}

enum wf_status wf_variation_apply(const struct wf_variation *v, const struct wf_analysis *an,
                                  const double *share, struct wf_arena *a, struct wf_varied_copy *out,
                                  struct wf_err *e)
{
    enum wf_status s = WF_OK;
    struct wf_level *level = WF_TAKE(a, an->species->levels, struct wf_level);
    *out = (struct wf_varied_copy){ .species = WF_TAKE(a, 1, struct wf_species),
                                    .model = WF_TAKE(a, 1, struct wf_model),
                                    .misread = { 1.0, 1.0, an->tree.doubtful },
                                    .load = 1.0,
                                    .damping = 1.0,
                                    .anchorage = 1.0 };
    if (!level || !out->species || !out->model)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a sample");
    *out->species = *an->species;
    *out->model = *an->model;
    memcpy(level, an->species->level, an->species->levels * sizeof *level);
    out->species->level = level;
    for (size_t k = 0; k < v->n && !s; k++) s = put_one(&v->varied[k], share[k], level, a, out, e);
    return s;
}
