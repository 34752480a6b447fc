#include "grow/ifs.h"
#include <math.h>
#include <string.h>

/* c = a b, row by row */
static void multiply(const double a[9], const double b[9], double c[9])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            c[3 * i + k] = a[3 * i] * b[k] + a[3 * i + 1] * b[3 + k] + a[3 * i + 2] * b[6 + k];
}

/* The linear map that makes an axis of the stem (0, 0, 1). */
static void map_of_stem(const struct wf_axis *stem, double a[9])
{
    const double *x = stem->side, *z = stem->direction;
    const double y[3] = { z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0] };
    for (int i = 0; i < 3; i++) {
        a[3 * i] = stem->length * x[i];
        a[3 * i + 1] = stem->length * y[i];
        a[3 * i + 2] = stem->length * z[i];
    }
}

/* Images of the axes of one level: their linear maps beside them. */
struct images {
    const struct wf_model *m;
    const struct wf_axis_form *form;
    double *map; /* 9 an axis, of the level below */
    double *next;
    size_t capped;
};

static void copy_axis(struct images *g, const struct wf_axis *parent, const double *whole,
                      const struct wf_ifs_map *w, struct wf_axis *out, double *map)
{
    double place, local;
    multiply(whole, w->a, map);
    const double axis[3] = { map[2], map[5], map[8] };
    out->length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    out->tick = wf_tick_of(w->position, g->form->segments);
    place = (double)out->tick / (double)(g->form->segments * WF_AXIS_TICKS);
    for (int k = 0; k < 3; k++) out->direction[k] = axis[k] / out->length;
    wf_side_of(out->direction, out->side);
    local = parent->radius * wf_axis_taper(g->form, place);
    out->radius = w->radius * parent->radius;
    if (out->radius > local) {
        out->radius = local;
        g->capped++;
    }
}

static enum wf_status iterate(struct images *g, struct wf_axes *x, size_t level, struct wf_arena *a,
                              struct wf_err *e)
{
    const struct wf_ifs *f = &g->m->ifs;
    struct wf_course course;
    size_t acting = 0;
    for (size_t k = 0; k < f->maps; k++) acting += level <= f->map[k].until;
    if (acting && x->n[level - 1] > WF_AXIS_ROWS_MAX / acting)
        return wf_fail(e, WF_EINPUT, "%s: level %zu would have more than %d branches", g->m->key, level,
                       (int)WF_AXIS_ROWS_MAX);
    size_t n = acting * x->n[level - 1];
    enum wf_status s = wf_course_take(&course, g->form->segments, a, e);
    if (s) return s;
    x->axis[level] = WF_TAKE(a, n, struct wf_axis);
    g->next = WF_TAKE(a, 9 * n, double);
    if (!x->axis[level] || !g->next) return wf_fail(e, WF_ENOMEM, "no room for %zu branches", n);
    for (size_t i = 0; i < x->n[level - 1]; i++) {
        const struct wf_axis *parent = &x->axis[level - 1][i];
        wf_course_run(parent, g->form, 0, &course);
        for (size_t k = 0; k < f->maps; k++) {
            if (level > f->map[k].until) continue;
            struct wf_axis *out = &x->axis[level][x->n[level]];
            copy_axis(g, parent, g->map + 9 * i, &f->map[k], out, g->next + 9 * x->n[level]);
            out->parent = (int32_t)i;
            wf_course_at(&course, out->tick, out->base);
            x->n[level]++;
        }
    }
    g->map = g->next;
    return WF_OK;
}

enum wf_status wf_ifs_axes(const struct wf_model *m, double base_radius, struct wf_arena *a,
                           struct wf_axes *out, size_t *capped, struct wf_err *e)
{
    double stem_map[9];
    *out = (struct wf_axes){ .levels = m->ifs.levels, .seed = m->seed, .n = { 1 } };
    if (!(out->axis[0] = WF_TAKE(a, 1, struct wf_axis))) return wf_fail(e, WF_ENOMEM, "no room for a stem");
    wf_axes_stem(m, base_radius, out->axis[0]);
    map_of_stem(out->axis[0], stem_map);
    for (size_t l = 0; l < out->levels; l++) {
        out->form[l] = (struct wf_axis_form){
            .segments = m->segments,
            .taper = m,
            .knots = { m->taper == WF_TAPER_TABLE ? &m->profile : NULL, NULL },
        };
        wf_axis_leafy(m, l, &out->form[l]);
    }
    struct images g = { .m = m, .form = &out->form[0], .map = stem_map };
    for (size_t l = 1; l < out->levels; l++) {
        enum wf_status s = iterate(&g, out, l, a, e);
        if (s) return s;
    }
    *capped = g.capped;
    return WF_OK;
}
