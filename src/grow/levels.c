#include "grow/levels.h"
#include "base/num.h"
#include "base/random.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

/* Draws of a branch, by purpose. */
enum { DRAW_PLACE, DRAW_AZIMUTH, DRAW_INSERTION, DRAW_LENGTH, DRAW_RADIUS };

/* A normal draw, cut so that no branch is a freak. */
static double draw(uint64_t seed, uint64_t key, uint64_t purpose, double deviation)
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

/* Number of places on a parent of this length, and the distance between neighbours as a share of it. */
static size_t places(const struct wf_branching *b, double length, double *gap)
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

static double place(const struct wf_branching *b, size_t group, double gap)
{
    return b->places ? b->at[group] : b->from + (double)group * gap;
}

static double azimuth(const struct wf_branching *b, uint64_t seed, uint64_t key, size_t group, size_t of)
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

static double length_of(const struct wf_branching *b, const struct wf_axis *parent, double s)
{
    double law = b->length_law == WF_LENGTH_ABSOLUTE ? b->length
                 : b->length_law == WF_LENGTH_PARENT ? parent->length
                                                     : parent->length * (1 - s);
    return law * b->length_factor * wf_along_at(&b->length_along, s, 1);
}

static double radius_of(const struct wf_branching *b, const struct wf_level *material, double local, double s,
                        double length)
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
    case WF_RADIUS_PIPE: /* the tips' radius, until wf_levels_pipes knows better */
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

/* One branch; false when it would be too short. */
static bool grow_one(struct nursery *g, const struct wf_axis *parent, const struct wf_course *course,
                     size_t group, size_t of, double gap, struct wf_axis *out)
{
    const struct wf_branching *b = g->b;
    size_t segments = g->parent_form->segments;
    uint64_t key = key_of_child(g->seed, parent->key, group * b->per_whorl + of);
    double s = place(b, group, gap) + draw(g->seed, key, DRAW_PLACE, b->place_spread * gap);
    uint32_t tick = wf_tick_of(s, segments);
    s = (double)tick / (double)(segments * WF_AXIS_TICKS);
    double length = length_of(b, parent, s) * exp(draw(g->seed, key, DRAW_LENGTH, b->length_spread));
    if (!(length >= b->shortest)) return false;
    double local = parent->radius * wf_axis_taper(g->parent_form, s);
    double radius =
        radius_of(b, g->material, local, s, length) * exp(draw(g->seed, key, DRAW_RADIUS, b->radius_spread));
    if (b->radius_law != WF_RADIUS_PIPE && radius > local) {
        radius = local;
        g->capped++;
    }
    double lean = b->insertion_along.n ? wf_along_at(&b->insertion_along, s, 0) : b->insertion;
    lean += draw(g->seed, key, DRAW_INSERTION, b->insertion_spread);
    double to = azimuth(b, g->seed, key, group, of);
    if (b->azimuth != WF_AZIMUTH_RANDOM) to += draw(g->seed, key, DRAW_AZIMUTH, b->azimuth_spread);
    *out = (struct wf_axis){ .length = length, .radius = radius, .key = key, .tick = tick };
    size_t j = (tick - 1) / WF_AXIS_TICKS;
    double third[3];
    wf_cross(course->direction[j], course->side[j], third);
    for (int k = 0; k < 3; k++)
        out->direction[k] = cos(lean) * course->direction[j][k] +
                            sin(lean) * (cos(to) * course->side[j][k] + sin(to) * third[k]);
    wf_side_of(out->direction, out->side);
    wf_course_at(course, tick, out->base);
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
        most += places(g->b, x->axis[level - 1][i].length, &gap) * g->b->per_whorl;
        if (most > WF_AXIS_ROWS_MAX)
            return wf_fail(e, WF_EINPUT, "level %zu would have more than %d branches", level,
                           (int)WF_AXIS_ROWS_MAX);
    }
    enum wf_status s = wf_course_take(&course, form->segments, a, e);
    if (s) return s;
    struct wf_axis *born = x->axis[level] = WF_TAKE(a, most, struct wf_axis);
    if (!born) return wf_fail(e, WF_ENOMEM, "no room for %zu branches", most);
    for (size_t i = 0; i < x->n[level - 1]; i++) {
        const struct wf_axis *parent = &x->axis[level - 1][i];
        size_t groups = places(g->b, parent->length, &gap);
        wf_course_run(parent, form, x->seed, &course);
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
    if (!(out->axis[0] = WF_TAKE(a, 1, struct wf_axis))) return wf_fail(e, WF_ENOMEM, "no room for a stem");
    wf_axes_stem(m, isnan(m->radius) ? sp->level[0].radius.value : m->radius, out->axis[0]);
    out->form[0] = (struct wf_axis_form){
        .segments = m->segments,
        .curve = m->curve,
        .taper = m,
        .knots = { m->taper == WF_TAPER_TABLE ? &m->profile : NULL, &sp->level[0].wall },
    };
    wf_axis_leafy(m, 0, &out->form[0]);
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
        wf_axis_leafy(m, l, &out->form[l]);
        enum wf_status s = grow_level(&g, out, l, a, e);
        if (s) return s;
        *capped += g.capped;
    }
    return WF_OK;
}

static bool piped(const struct wf_model *m, const struct wf_tree *t, size_t row)
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
    double *above = WF_TAKE(&scratch, t->n, double); /* sum of r^exponent of what grows from a row's end */
    if (!above) return wf_fail(e, WF_ENOMEM, "no room for the pipes of %zu segments", t->n);
    for (size_t i = t->n; i-- > 0;) {
        if (!piped(m, t, i)) continue;
        const struct wf_branching *b = &m->branching[t->level[i] - 1];
        t->r0[i] = t->r1[i] = above[i] > 0 ? pow(above[i], 1 / b->radius_exponent) : b->radius;
        size_t below = (size_t)t->parent[i]; /* a branch has one */
        if (piped(m, t, below))
            above[below] += pow(t->r0[i], m->branching[t->level[below] - 1].radius_exponent);
        else
            *thick += t->r0[i] > t->r1[below];
    }
    wf_arena_free(&scratch);
    return WF_OK;
}
