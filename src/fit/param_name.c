/* From the names users give to parameters. */
#include "base/near.h"
#include "fit/param.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double ratio(const struct wf_value *v)
{
    return v->high > v->low && v->low > 0 ? log(v->high / v->low) : 0;
}

/* The parameter of the crown's law that can be fitted; NULL when the law has none. */
static const struct wf_value *crown_law(const struct wf_species *sp)
{
    int k = wf_law_find(wf_law_named(wf_laws.streamlining, sp->streamlining.law), WF_FIT_CROWN_LAW);
    return k < 0 ? NULL : &sp->streamlining.parameter[k];
}

/* Start value and range of the species table: the range is taken to hold 95 % of the plausible values. */
static enum wf_status from_species(const struct wf_experiment *x, struct wf_fit_param *p, struct wf_err *e)
{
    const struct wf_fit_tree *t = &x->tree[p->tree >= 0 ? p->tree : 0];
    const struct wf_species *sp = t->species;
    if (p->level >= 0 && (size_t)p->level >= sp->levels)
        return wf_fail(e, WF_EUSAGE, "%s: the species table %s has %zu level%s, counted from 0", p->name,
                       sp->key, sp->levels, sp->levels == 1 ? "" : "s");
    const struct wf_level *l = &sp->level[p->level >= 0 ? p->level : 0];
    const struct wf_value *const of[WF_FIT_QUANTITIES] = {
        [WF_FIT_YOUNGS] = &l->youngs_modulus,  [WF_FIT_SHEAR] = &l->shear_modulus,
        [WF_FIT_DENSITY] = &l->density,        [WF_FIT_AXIS_DRAG] = &l->drag_coefficient,
        [WF_FIT_CROWN_DRAG] = &sp->crown_drag, [WF_FIT_VOGEL] = crown_law(sp),
    };
    const struct wf_value *v = of[p->quantity];
    double radius = t->tree.r0[0], height = t->height;
    p->unit = 1;
    p->start = 1;
    if (v) p->start = v->value;
    if (p->quantity == WF_FIT_AXIS_DRAG && isnan(p->start)) p->start = 1;
    if (p->quantity == WF_FIT_DAMPING) p->start = 0.05;
    if (p->quantity == WF_FIT_FRAME) p->start = 0;
    if (t->tree.section && (p->quantity == WF_FIT_RADIUS || p->quantity == WF_FIT_DENSITY))
        return wf_fail(e, WF_EUSAGE, "%s: not for a stem with 'sections'", p->name);
    /* a root plate that adds as much rotation as a stem of that size bends */
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
        return wf_fail(e, WF_EUSAGE, "no parameter is called '%s'; did you mean 'level%d%s'?", name, level,
                       near + 6);
    if (near) return wf_fail(e, WF_EUSAGE, "no parameter is called '%s'; did you mean '%s'?", name, near);
    return wf_fail(e, WF_EUSAGE,
                   "no parameter is called '%s'; known are levelN.youngs_modulus, wood.youngs_modulus, "
                   "youngs_modulus_tip_share, levelN.shear_modulus, levelN.density, levelN.radius_factor, "
                   "levelN.drag_coefficient, crown.drag_coefficient, crown.streamlining.exponent, "
                   "root.stiffness, damping_ratio, frame.azimuth",
                   name);
}

/* Which quantity a name without its tree means. */
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
    return wf_fail(e, WF_EUSAGE, "no tree of the study is called '%s'; %s%s%s", word,
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
        if (!p.name) return wf_fail(e, WF_ENOMEM, "no room for parameters");
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
                if (!p.name) return wf_fail(e, WF_ENOMEM, "no room for parameters");
                p.low = -1e3 * p.unit, p.high = 1e3 * p.unit;
                out[(*n)++] = p;
            }
        }
    return WF_OK;
}
