/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/branches.h"
#include "base/num.h"
#include "base/random.h"
#include "base/vec3.h"
#include "data/species.h"
#include <math.h>
#include <string.h>

/* The centre line of one axis. */

enum { FIRST_WANDER_DRAW = 16 }; /* draws below this index are those of DRAW_PLACE and so on */

/* Allocate a centre line of at most `segments` segments. Errors: WF_ENOMEM. */
static enum wf_status course_take(struct wf_course *c, size_t segments, struct wf_arena *a, struct wf_err *e)
{
    c->segments = segments;
    c->node = wf_arena_take(a, segments + 1, sizeof *c->node);
    c->side = wf_arena_take(a, segments, sizeof *c->side);
    c->direction = wf_arena_take(a, segments, sizeof *c->direction);
    if (c->node && c->side && c->direction) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for an axis of %zu segments", segments);
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

/* Rotate v about a unit axis by an angle given by its cosine and sine (Rodrigues' formula). */
static void rotate(double v[3], const double axis[3], double cosine, double sine)
{
    double across[3], along = wf_dot(axis, v) * (1 - cosine);
    wf_cross(axis, v, across);
    for (int k = 0; k < 3; k++) v[k] = cosine * v[k] + sine * across[k] + along * axis[k];
}

/* Turn a direction and its side towards straight up (angle > 0) or straight down, not beyond it. A direction
 * that points exactly the other way turns towards its side. */
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

/* Turn a direction by a random angle to a random side. Given: standard deviation [rad], two normal draws. */
static void turn_to_side(double direction[3], double side[3], double deviation, const double draw[2])
{
    double third[3], axis[3], angle = deviation * hypot(draw[0], draw[1]) / sqrt(2.0);
    double phase = atan2(draw[1], draw[0]);
    if (angle <= 0) return;
    wf_cross(direction, side, third);
    for (int k = 0; k < 3; k++) axis[k] = cos(phase) * side[k] + sin(phase) * third[k];
    rotate(direction, axis, cos(angle), sin(angle));
    rotate(side, axis, cos(angle), sin(angle));
}

/* Compute the centre line of an axis. Given: axis, form of its level, seed. Returned: *c. Method: at every
 * joint the direction turns towards the vertical by an equal part of the curve's turn, and to a random side
 * by its wander; `side` is transported along the axis without twist. */
static void course_run(const struct wf_axis *axis, const struct wf_axis_form *f, uint64_t seed,
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
            turn_to_side(d, s, f->curve.wander / sqrt((double)(n - 1)), draw);
        }
        if (j) normalise(d);
        memcpy(c->direction[j], d, sizeof d);
        memcpy(c->side[j], s, sizeof s);
        for (int k = 0; k < 3; k++) c->node[j + 1][k] = c->node[j][k] + step * d[k];
    }
}

/* Point of the centre line at a tick [m]. */
static void course_at(const struct wf_course *c, uint32_t tick, double x[3])
{
    size_t j = tick / WF_AXIS_TICKS, left = tick % WF_AXIS_TICKS;
    double share = (double)left / WF_AXIS_TICKS;
    for (int k = 0; k < 3; k++)
        x[k] = left ? c->node[j][k] + share * (c->node[j + 1][k] - c->node[j][k]) : c->node[j][k];
}

/* Radius over base radius at place s of an axis [-]. */
static double axis_taper(const struct wf_axis_form *f, double s)
{
    if (f->taper) return wf_model_taper(f->taper, s);
    double left = 1 - s;
    return f->tip_share + (1 - f->tip_share) * (f->taper_power == 1 ? left : pow(left, f->taper_power));
}

/* The tick nearest to place s; at least 1, at most the tip. */
static uint32_t tick_of(double s, size_t segments)
{
    double ticks = (double)(segments * WF_AXIS_TICKS), t = round(s * ticks);
    return (uint32_t)fmin(fmax(t, 1), ticks);
}

/* Set leaf_from and leaf_to of a level's form: the part of its axes that has leaves in the model's season. */
static void axis_leafy(const struct wf_model *m, size_t level, struct wf_axis_form *f)
{
    if (!(m->leaf_area > 0) || level + m->foliage.levels < wf_model_levels(m)) return;
    f->leaf_from = m->foliage.from;
    f->leaf_to = m->foliage.to;
}

/* The stem of a model as an axis of level 0. Given: base radius [m]. */
static void axes_stem(const struct wf_model *m, double base_radius, struct wf_axis *stem)
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

/* Scratch for one axis: where its rows end, and the row that ends at each tick. */
struct axis_cut {
    struct wf_course course;
    uint8_t *ends; /* per tick: does a row end here? */
    int32_t *row;  /* per tick: the row that ends here */
};

static enum wf_status take_axis_cut(struct axis_cut *c, const struct wf_axes *x, struct wf_arena *a,
                                    struct wf_err *e)
{
    size_t most = 1;
    for (size_t l = 0; l < x->levels; l++)
        if (x->form[l].segments > most) most = x->form[l].segments;
    c->ends = WF_TAKE(a, most * WF_AXIS_TICKS + 1, uint8_t);
    c->row = WF_TAKE(a, most * WF_AXIS_TICKS + 1, int32_t);
    if (!c->ends || !c->row)
        return wf_fail(e, WF_ENOMEM, "not enough memory for an axis of %zu segments", most);
    return course_take(&c->course, most, a, e);
}

/* Mark where the rows of axis i end: at its joints, at knots, and at the places of its children. *child is
 * the first of these on entry and one past the last on return. Returned: number of rows. */
static size_t cut_axis(struct axis_cut *c, const struct wf_axes *x, size_t level, size_t i, size_t *child)
{
    const struct wf_axis_form *f = &x->form[level];
    size_t ticks = f->segments * WF_AXIS_TICKS, rows = 0;
    memset(c->ends, 0, ticks + 1);
    for (size_t t = WF_AXIS_TICKS; t <= ticks; t += WF_AXIS_TICKS) c->ends[t] = 1;
    for (size_t w = 0; w < 2; w++)
        for (size_t k = 0; f->knots[w] && k < f->knots[w]->n; k++)
            if (f->knots[w]->s[k] > 0) c->ends[tick_of(f->knots[w]->s[k], f->segments)] = 1;
    if (level + 1 < x->levels)
        for (; *child < x->n[level + 1] && x->axis[level + 1][*child].parent == (int32_t)i; ++*child)
            c->ends[x->axis[level + 1][*child].tick] = 1;
    for (size_t t = 1; t <= ticks; t++) rows += c->ends[t];
    return rows;
}

static enum wf_status count_rows(struct axis_cut *c, const struct wf_axes *x, const char *name, size_t *n,
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

/* Share of s0..s1 that lies inside from..to. */
static double overlap_share(double s0, double s1, double from, double to)
{
    double inside = fmin(s1, to) - fmax(s0, from);
    return inside > 0 ? inside / (s1 - s0) : 0;
}

static void set_row_ends(struct wf_tree *t, size_t r, const double from[3], const double to[3])
{
    t->x0[r] = from[0], t->y0[r] = from[1], t->z0[r] = from[2];
    t->x1[r] = to[0], t->y1[r] = to[1], t->z1[r] = to[2];
}

/* Write the rows of axis i, starting at row `first`, and tell its children which row they start from.
 * Returned: one past its last row. */
static size_t write_axis(struct axis_cut *c, struct wf_axes *x, size_t level, size_t i, size_t first,
                         size_t *child, struct wf_tree *t)
{
    const struct wf_axis_form *f = &x->form[level];
    struct wf_axis *axis = &x->axis[level][i];
    size_t ticks = f->segments * WF_AXIS_TICKS, r = first, born = *child;
    int32_t below = axis->row;
    uint32_t last = 0;
    double from[3], to[3];
    (void)cut_axis(c, x, level, i, child);
    course_run(axis, f, x->seed, &c->course);
    memcpy(from, axis->base, sizeof from);
    for (uint32_t k = 1; k <= ticks; k++) {
        if (!c->ends[k]) continue;
        double s0 = (double)last / (double)ticks, s1 = (double)k / (double)ticks;
        course_at(&c->course, k, to);
        set_row_ends(t, r, from, to);
        t->parent[r] = below;
        t->level[r] = (int32_t)level;
        t->r0[r] = axis->radius * axis_taper(f, s0);
        t->r1[r] = axis->radius * axis_taper(f, s1);
        t->leaf0[r] = t->leaf1[r] = overlap_share(s0, s1, f->leaf_from, f->leaf_to);
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
    struct axis_cut cut;
    size_t n = 0, r = 0;
    enum wf_status s = take_axis_cut(&cut, x, &scratch, e);
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

/* Trees of levels. */

/* Index of a branch's random draws, by purpose. */
enum { DRAW_PLACE, DRAW_AZIMUTH, DRAW_INSERTION, DRAW_LENGTH, DRAW_RADIUS };

/* A normal draw limited to 2.5 standard deviations, so that no branch has an extreme value. */
static double cut_normal_draw(uint64_t seed, uint64_t key, uint64_t purpose, double deviation)
{
    const double most = 2.5;
    if (!(deviation > 0)) return 0;
    return deviation * fmin(fmax(wf_random_normal(seed, key, purpose), -most), most);
}

static uint64_t key_of_child(uint64_t seed, uint64_t parent, size_t child)
{
    uint32_t w[4];
    wf_random_words(seed, parent, child, w);
    return (uint64_t)w[0] << 32 | w[1];
}

/* Number of places on a parent of this length. Returned too: *gap, the distance between neighbours as a share
 * of the length. */
static size_t count_places(const struct wf_branching *b, double length, double *gap)
{
    size_t n = b->places ? b->places : b->count;
    if (b->spacing > 0) {
        n = (size_t)floor((b->to - b->from) * length / b->spacing + 1e-9) + 1;
        *gap = b->spacing / length;
    } else {
        *gap = n > 1 ? (b->to - b->from) / (double)(n - 1) : 0;
    }
    return n;
}

static double place_of_group(const struct wf_branching *b, size_t group, double gap)
{
    return b->places ? b->at[group] : b->from + (double)group * gap;
}

static double branch_azimuth(const struct wf_branching *b, uint64_t seed, uint64_t key, size_t group,
                             size_t of)
{
    double around = (double)of / (double)b->per_whorl * WF_TURN, g = (double)group;
    switch (b->azimuth) {
    case WF_AZIMUTH_RANDOM:
        return WF_TURN * wf_random_uniform(seed, key, DRAW_AZIMUTH);
    case WF_AZIMUTH_PLANAR:
        return b->azimuth_start + WF_TURN / 2 * (g * (double)b->per_whorl + (double)of);
    case WF_AZIMUTH_WHORL:
        if (isnan(b->divergence)) return b->azimuth_start + around + g * WF_TURN / 2 / (double)b->per_whorl;
        break;
    default:
        break;
    }
    return b->azimuth_start + around + g * b->divergence;
}

static double branch_length(const struct wf_branching *b, const struct wf_axis *parent, double s)
{
    double law = b->length_law == WF_LENGTH_ABSOLUTE ? b->length
                 : b->length_law == WF_LENGTH_PARENT ? parent->length
                                                     : parent->length * (1 - s);
    return law * b->length_factor * wf_along_at(&b->length_along, s, 1);
}

static double branch_radius(const struct wf_branching *b, const struct wf_level *material, double local,
                            double s, double length)
{
    double law = 0;
    switch (b->radius_law) {
    case WF_RADIUS_PARENT:
        law = local;
        break;
    case WF_RADIUS_SPECIES:
        law = material->radius.value;
        break;
    case WF_RADIUS_LENGTH:
        law = b->radius * pow(length, b->radius_exponent);
        break;
    case WF_RADIUS_ABSOLUTE:
    case WF_RADIUS_PIPE: /* the radius of the tips; wf_levels_pipes computes the others later */
        return b->radius * b->radius_factor * wf_along_at(&b->radius_along, s, 1);
    }
    return law * b->radius_factor * wf_along_at(&b->radius_along, s, 1);
}

struct nursery {
    const struct wf_branching *b;
    const struct wf_level *material;
    const struct wf_axis_form *parent_form;
    uint64_t seed;
    size_t capped;
};

/* Grow one branch. Returned: false when it would be shorter than the model allows. */
static bool grow_one(struct nursery *g, const struct wf_axis *parent, const struct wf_course *course,
                     size_t group, size_t of, double gap, struct wf_axis *out)
{
    const struct wf_branching *b = g->b;
    size_t segments = g->parent_form->segments;
    uint64_t key = key_of_child(g->seed, parent->key, group * b->per_whorl + of);
    double s =
        place_of_group(b, group, gap) + cut_normal_draw(g->seed, key, DRAW_PLACE, b->place_spread * gap);
    uint32_t tick = tick_of(s, segments);
    s = (double)tick / (double)(segments * WF_AXIS_TICKS);
    double length =
        branch_length(b, parent, s) * exp(cut_normal_draw(g->seed, key, DRAW_LENGTH, b->length_spread));
    if (!(length >= b->shortest)) return false;
    double local = parent->radius * axis_taper(g->parent_form, s);
    double radius = branch_radius(b, g->material, local, s, length) *
                    exp(cut_normal_draw(g->seed, key, DRAW_RADIUS, b->radius_spread));
    if (b->radius_law != WF_RADIUS_PIPE && radius > local) {
        radius = local;
        g->capped++;
    }
    double lean = b->insertion_along.n ? wf_along_at(&b->insertion_along, s, 0) : b->insertion;
    lean += cut_normal_draw(g->seed, key, DRAW_INSERTION, b->insertion_spread);
    double to = branch_azimuth(b, g->seed, key, group, of);
    if (b->azimuth != WF_AZIMUTH_RANDOM) to += cut_normal_draw(g->seed, key, DRAW_AZIMUTH, b->azimuth_spread);
    *out = (struct wf_axis){ .length = length, .radius = radius, .key = key, .tick = tick };
    size_t j = (tick - 1) / WF_AXIS_TICKS;
    double third[3];
    wf_cross(course->direction[j], course->side[j], third);
    for (int k = 0; k < 3; k++)
        out->direction[k] = cos(lean) * course->direction[j][k] +
                            sin(lean) * (cos(to) * course->side[j][k] + sin(to) * third[k]);
    wf_side_of(out->direction, out->side);
    course_at(course, tick, out->base);
    return true;
}

static enum wf_status grow_level(struct nursery *g, struct wf_axes *x, size_t level, struct wf_arena *a,
                                 struct wf_err *e)
{
    const struct wf_axis_form *form = &x->form[level - 1];
    struct wf_course course;
    double gap;
    size_t most = 0;
    for (size_t i = 0; i < x->n[level - 1]; i++) {
        most += count_places(g->b, x->axis[level - 1][i].length, &gap) * g->b->per_whorl;
        if (most > WF_AXIS_ROWS_MAX)
            return wf_fail(e, WF_EINPUT, "level %zu would have more than %d branches", level,
                           (int)WF_AXIS_ROWS_MAX);
    }
    enum wf_status s = course_take(&course, form->segments, a, e);
    if (s) return s;
    struct wf_axis *born = x->axis[level] = WF_TAKE(a, most, struct wf_axis);
    if (!born) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu branches", most);
    for (size_t i = 0; i < x->n[level - 1]; i++) {
        const struct wf_axis *parent = &x->axis[level - 1][i];
        size_t groups = count_places(g->b, parent->length, &gap);
        course_run(parent, form, x->seed, &course);
        for (size_t k = 0; k < groups * g->b->per_whorl; k++) {
            struct wf_axis *one = &born[x->n[level]];
            if (!grow_one(g, parent, &course, k / g->b->per_whorl, k % g->b->per_whorl, gap, one)) continue;
            one->parent = (int32_t)i;
            x->n[level]++;
        }
    }
    return WF_OK;
}

enum wf_status wf_levels_axes(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_axes *out, size_t *capped, struct wf_err *e)
{
    *out = (struct wf_axes){ .levels = wf_model_levels(m), .seed = m->seed, .n = { 1 } };
    if (!(out->axis[0] = WF_TAKE(a, 1, struct wf_axis)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a stem");
    axes_stem(m, isnan(m->radius) ? sp->level[0].radius.value : m->radius, out->axis[0]);
    out->form[0] = (struct wf_axis_form){
        .segments = m->segments,
        .curve = m->curve,
        .taper = m,
        .knots = { m->taper == WF_TAPER_TABLE ? &m->profile : NULL, &sp->level[0].wall },
    };
    axis_leafy(m, 0, &out->form[0]);
    *capped = 0;
    for (size_t l = 1; l < out->levels; l++) {
        const struct wf_branching *b = &m->branching[l - 1];
        struct nursery g = {
            .b = b,
            .material = wf_species_level(sp, (int32_t)l),
            .parent_form = &out->form[l - 1],
            .seed = m->seed,
        };
        out->form[l] = (struct wf_axis_form){
            .segments = b->segments,
            .curve = b->curve,
            .tip_share = b->radius_law == WF_RADIUS_PIPE ? 1 : b->tip_share,
            .taper_power = b->taper_power,
        };
        axis_leafy(m, l, &out->form[l]);
        enum wf_status s = grow_level(&g, out, l, a, e);
        if (s) return s;
        *capped += g.capped;
    }
    return WF_OK;
}

static bool is_piped(const struct wf_model *m, const struct wf_tree *t, size_t row)
{
    return t->level[row] > 0 && m->branching[t->level[row] - 1].radius_law == WF_RADIUS_PIPE;
}

enum wf_status wf_levels_pipes(const struct wf_model *m, struct wf_tree *t, size_t *thick, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    bool any = false;
    *thick = 0;
    for (size_t l = 0; l < m->branchings; l++) any = any || m->branching[l].radius_law == WF_RADIUS_PIPE;
    if (!any) return WF_OK;
    double *above =
        WF_TAKE(&scratch, t->n, double); /* per row: sum of r^exponent of the rows that start at its end */
    if (!above) return wf_fail(e, WF_ENOMEM, "not enough memory for the pipes of %zu segments", t->n);
    for (size_t i = t->n; i-- > 0;) {
        if (!is_piped(m, t, i)) continue;
        const struct wf_branching *b = &m->branching[t->level[i] - 1];
        t->r0[i] = t->r1[i] = above[i] > 0 ? pow(above[i], 1 / b->radius_exponent) : b->radius;
        size_t below = (size_t)t->parent[i]; /* every row of a branch has a parent */
        if (is_piped(m, t, below))
            above[below] += pow(t->r0[i], m->branching[t->level[below] - 1].radius_exponent);
        else
            *thick += t->r0[i] > t->r1[below];
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

/* Trees by an iterated function system. */

/* The linear map that takes (0, 0, 1) to the stem's axis. */
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

/* State while the images of one level's axes are computed. */
struct images {
    const struct wf_model *m;
    const struct wf_axis_form *form;
    double *map;  /* 9 per axis of the level below: its linear map */
    double *next; /* the same of the level being grown             */
    size_t capped;
};

static void copy_axis(struct images *g, const struct wf_axis *parent, const double *whole,
                      const struct wf_ifs_map *w, struct wf_axis *out, double *map)
{
    double place, local;
    m3_mul(whole, w->a, map);
    const double axis[3] = { map[2], map[5], map[8] };
    out->length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    out->tick = tick_of(w->position, g->form->segments);
    place = (double)out->tick / (double)(g->form->segments * WF_AXIS_TICKS);
    for (int k = 0; k < 3; k++) out->direction[k] = axis[k] / out->length;
    wf_side_of(out->direction, out->side);
    local = parent->radius * axis_taper(g->form, place);
    out->radius = w->radius * parent->radius;
    if (out->radius > local) {
        out->radius = local;
        g->capped++;
    }
}

static enum wf_status grow_images(struct images *g, struct wf_axes *x, size_t level, struct wf_arena *a,
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
    enum wf_status s = course_take(&course, g->form->segments, a, e);
    if (s) return s;
    x->axis[level] = WF_TAKE(a, n, struct wf_axis);
    g->next = WF_TAKE(a, 9 * n, double);
    if (!x->axis[level] || !g->next) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu branches", n);
    for (size_t i = 0; i < x->n[level - 1]; i++) {
        const struct wf_axis *parent = &x->axis[level - 1][i];
        course_run(parent, g->form, 0, &course);
        for (size_t k = 0; k < f->maps; k++) {
            if (level > f->map[k].until) continue;
            struct wf_axis *out = &x->axis[level][x->n[level]];
            copy_axis(g, parent, g->map + 9 * i, &f->map[k], out, g->next + 9 * x->n[level]);
            out->parent = (int32_t)i;
            course_at(&course, out->tick, out->base);
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
    if (!(out->axis[0] = WF_TAKE(a, 1, struct wf_axis)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a stem");
    axes_stem(m, base_radius, out->axis[0]);
    map_of_stem(out->axis[0], stem_map);
    for (size_t l = 0; l < out->levels; l++) {
        out->form[l] = (struct wf_axis_form){
            .segments = m->segments,
            .taper = m,
            .knots = { m->taper == WF_TAPER_TABLE ? &m->profile : NULL, NULL },
        };
        axis_leafy(m, l, &out->form[l]);
    }
    struct images g = { .m = m, .form = &out->form[0], .map = stem_map };
    for (size_t l = 1; l < out->levels; l++) {
        enum wf_status s = grow_images(&g, out, l, a, e);
        if (s) return s;
    }
    *capped = g.capped;
    return WF_OK;
}
