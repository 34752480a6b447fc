/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/axes.h"
#include "base/random.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

/* The course of one axis. */

enum { FIRST_WANDER_DRAW = 16 }; /* draws below belong to the branch's own figures */

enum wf_status wf_course_take(struct wf_course *c, size_t segments, struct wf_arena *a, struct wf_err *e)
{
    c->segments = segments;
    c->node = wf_arena_take(a, segments + 1, sizeof *c->node);
    c->side = wf_arena_take(a, segments, sizeof *c->side);
    c->direction = wf_arena_take(a, segments, sizeof *c->direction);
    if (c->node && c->side && c->direction) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "no room for an axis of %zu segments", segments);
}

static void normalise(double v[3])
{
    double size = sqrt(wf_dot(v, v));
    for (int k = 0; k < 3; k++) v[k] /= size;
}

void wf_side_of(const double direction[3], double side[3])
{
    const double up[3] = { 0, 0, 1 }, x[3] = { 1, 0, 0 };
    const double *from = hypot(direction[0], direction[1]) > 1e-6 ? up : x;
    double along = wf_dot(from, direction);
    for (int k = 0; k < 3; k++) side[k] = from[k] - along * direction[k];
    normalise(side);
}

/* Turn v about the unit axis by an angle given by its sine and cosine (Rodrigues). */
static void rotate(double v[3], const double axis[3], double cosine, double sine)
{
    double across[3], along = wf_dot(axis, v) * (1 - cosine);
    wf_cross(axis, v, across);
    for (int k = 0; k < 3; k++) v[k] = cosine * v[k] + sine * across[k] + along * axis[k];
}

/* Towards straight up (angle > 0) or straight down, not beyond; a vertical axis leaves towards its side. */
static void turn_to_vertical(double direction[3], double side[3], double angle)
{
    double target[3] = { 0, 0, angle > 0 ? 1.0 : -1.0 }, axis[3];
    wf_cross(direction, target, axis);
    double sine = sqrt(wf_dot(axis, axis)), left = atan2(sine, wf_dot(direction, target));
    if (left < 1e-9) return;
    if (sine < 1e-9) wf_cross(direction, side, axis);
    normalise(axis);
    double by = fmin(fabs(angle), left);
    rotate(direction, axis, cos(by), sin(by));
    rotate(side, axis, cos(by), sin(by));
}

/* To a random side. */
static void stray(double direction[3], double side[3], double deviation, const double draw[2])
{
    double third[3], axis[3], angle = deviation * hypot(draw[0], draw[1]) / sqrt(2.0);
    double phase = atan2(draw[1], draw[0]);
    if (angle <= 0) return;
    wf_cross(direction, side, third);
    for (int k = 0; k < 3; k++) axis[k] = cos(phase) * side[k] + sin(phase) * third[k];
    rotate(direction, axis, cos(angle), sin(angle));
    rotate(side, axis, cos(angle), sin(angle));
}

void wf_course_run(const struct wf_axis *axis, const struct wf_axis_form *f, uint64_t seed,
                   struct wf_course *c)
{
    size_t n = f->segments, joints = 0;
    double step = axis->length / (double)n, d[3], s[3];
    for (size_t j = 1; j < n; j++) {
        double at = (double)j / (double)n;
        joints += at >= f->curve.from && at <= f->curve.to;
    }
    memcpy(d, axis->direction, sizeof d);
    memcpy(s, axis->side, sizeof s);
    memcpy(c->node[0], axis->base, sizeof d);
    c->segments = n;
    for (size_t j = 0; j < n; j++) {
        double at = (double)j / (double)n;
        if (j && at >= f->curve.from && at <= f->curve.to && f->curve.turn != 0)
            turn_to_vertical(d, s, f->curve.turn / (double)joints);
        if (j && f->curve.wander > 0) {
            double draw[2];
            wf_random_normals(seed, axis->key, FIRST_WANDER_DRAW + 2 * j, 2, draw);
            stray(d, s, f->curve.wander / sqrt((double)(n - 1)), draw);
        }
        if (j) normalise(d);
        memcpy(c->direction[j], d, sizeof d);
        memcpy(c->side[j], s, sizeof s);
        for (int k = 0; k < 3; k++) c->node[j + 1][k] = c->node[j][k] + step * d[k];
    }
}

void wf_course_at(const struct wf_course *c, uint32_t tick, double x[3])
{
    size_t j = tick / WF_AXIS_TICKS, left = tick % WF_AXIS_TICKS;
    double share = (double)left / WF_AXIS_TICKS;
    for (int k = 0; k < 3; k++)
        x[k] = left ? c->node[j][k] + share * (c->node[j + 1][k] - c->node[j][k]) : c->node[j][k];
}

double wf_axis_taper(const struct wf_axis_form *f, double s)
{
    if (f->taper) return wf_model_taper(f->taper, s);
    double left = 1 - s;
    return f->tip_share + (1 - f->tip_share) * (f->taper_power == 1 ? left : pow(left, f->taper_power));
}

uint32_t wf_tick_of(double s, size_t segments)
{
    double ticks = (double)(segments * WF_AXIS_TICKS), t = round(s * ticks);
    return (uint32_t)fmin(fmax(t, 1), ticks);
}

void wf_axis_leafy(const struct wf_model *m, size_t level, struct wf_axis_form *f)
{
    if (!(m->leaf_area > 0) || level + m->foliage.levels < wf_model_levels(m)) return;
    f->leaf_from = m->foliage.from;
    f->leaf_to = m->foliage.to;
}

void wf_axes_stem(const struct wf_model *m, double base_radius, struct wf_axis *stem)
{
    double ca = cos(m->lean_azimuth), sa = sin(m->lean_azimuth), cl = cos(m->lean), sl = sin(m->lean);
    *stem = (struct wf_axis){
        .side = { ca * cl, sa * cl, -sl },
        .direction = { ca * sl, sa * sl, cl },
        .length = m->height,
        .radius = base_radius,
        .key = 1,
        .parent = -1,
        .row = -1,
    };
}

/* From axes to rows. */

/* One axis at a time: where its rows end, and the row that ends at each tick. */
struct cut {
    struct wf_course course;
    uint8_t *ends; /* per tick: does a row end here? */
    int32_t *row;  /* per tick: the row that ends here */
};

static enum wf_status cut_take(struct cut *c, const struct wf_axes *x, struct wf_arena *a, struct wf_err *e)
{
    size_t most = 1;
    for (size_t l = 0; l < x->levels; l++)
        if (x->form[l].segments > most) most = x->form[l].segments;
    c->ends = WF_TAKE(a, most * WF_AXIS_TICKS + 1, uint8_t);
    c->row = WF_TAKE(a, most * WF_AXIS_TICKS + 1, int32_t);
    if (!c->ends || !c->row) return wf_fail(e, WF_ENOMEM, "no room for an axis of %zu segments", most);
    return wf_course_take(&c->course, most, a, e);
}

/* Mark the ends of axis i's rows: joints, knots, and the places of its children, of which *child is the
 * first; moves it behind the last. Returned: rows. */
static size_t cut_axis(struct cut *c, const struct wf_axes *x, size_t level, size_t i, size_t *child)
{
    const struct wf_axis_form *f = &x->form[level];
    size_t ticks = f->segments * WF_AXIS_TICKS, rows = 0;
    memset(c->ends, 0, ticks + 1);
    for (size_t t = WF_AXIS_TICKS; t <= ticks; t += WF_AXIS_TICKS) c->ends[t] = 1;
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; f->knots[w] && k < f->knots[w]->n; k++)
            if (f->knots[w]->s[k] > 0) c->ends[wf_tick_of(f->knots[w]->s[k], f->segments)] = 1;
    if (level + 1 < x->levels)
        for (; *child < x->n[level + 1] && x->axis[level + 1][*child].parent == (int32_t)i; ++*child)
            c->ends[x->axis[level + 1][*child].tick] = 1;
    for (size_t t = 1; t <= ticks; t++) rows += c->ends[t];
    return rows;
}

static enum wf_status count_rows(struct cut *c, const struct wf_axes *x, const char *name, size_t *n,
                                 struct wf_err *e)
{
    *n = 0;
    for (size_t l = 0; l < x->levels; l++) {
        size_t child = 0;
        for (size_t i = 0; i < x->n[l]; i++)
            if ((*n += cut_axis(c, x, l, i, &child)) > WF_AXIS_ROWS_MAX)
                return wf_fail(e, WF_EINPUT, "%s: the tree would have more than %d segments", name,
                               (int)WF_AXIS_ROWS_MAX);
    }
    return WF_OK;
}

/* Share of s0..s1 inside from..to. */
static double overlap(double s0, double s1, double from, double to)
{
    double inside = fmin(s1, to) - fmax(s0, from);
    return inside > 0 ? inside / (s1 - s0) : 0;
}

static void add_row(struct wf_tree *t, size_t r, const double from[3], const double to[3])
{
    t->x0[r] = from[0], t->y0[r] = from[1], t->z0[r] = from[2];
    t->x1[r] = to[0], t->y1[r] = to[1], t->z1[r] = to[2];
}

/* The rows of axis i from row `first`; its children learn which of them they grow from. */
static size_t write_axis(struct cut *c, struct wf_axes *x, size_t level, size_t i, size_t first,
                         size_t *child, struct wf_tree *t)
{
    const struct wf_axis_form *f = &x->form[level];
    struct wf_axis *axis = &x->axis[level][i];
    size_t ticks = f->segments * WF_AXIS_TICKS, r = first, born = *child;
    int32_t below = axis->row;
    uint32_t last = 0;
    double from[3], to[3];
    (void)cut_axis(c, x, level, i, child);
    wf_course_run(axis, f, x->seed, &c->course);
    memcpy(from, axis->base, sizeof from);
    for (uint32_t k = 1; k <= ticks; k++) {
        if (!c->ends[k]) continue;
        double s0 = (double)last / (double)ticks, s1 = (double)k / (double)ticks;
        wf_course_at(&c->course, k, to);
        add_row(t, r, from, to);
        t->parent[r] = below;
        t->level[r] = (int32_t)level;
        t->r0[r] = axis->radius * wf_axis_taper(f, s0);
        t->r1[r] = axis->radius * wf_axis_taper(f, s1);
        t->leaf0[r] = t->leaf1[r] = overlap(s0, s1, f->leaf_from, f->leaf_to);
        c->row[k] = below = (int32_t)r++;
        last = k;
        memcpy(from, to, sizeof from);
    }
    for (size_t b = born; b < *child; b++) {
        struct wf_axis *branch = &x->axis[level + 1][b];
        branch->row = c->row[branch->tick];
    }
    axis->row = (int32_t)first;
    return r;
}

enum wf_status wf_axes_to_tree(struct wf_axes *x, const char *name, struct wf_arena *a, struct wf_tree *out,
                               struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct cut cut;
    size_t n = 0, r = 0;
    enum wf_status s = cut_take(&cut, x, &scratch, e);
    if (!s) s = count_rows(&cut, x, name, &n, e);
    if (!s) s = wf_tree_alloc(out, n, a, e);
    for (size_t l = 0; !s && l < x->levels; l++) {
        size_t child = 0;
        for (size_t i = 0; i < x->n[l]; i++) r = write_axis(&cut, x, l, i, r, &child, out);
    }
    if (!s) out->name = name;
    wf_arena_free(&scratch);
    return s;
}
