/* From axes to rows. */
#include "grow/axes.h"
#include <math.h>
#include <string.h>

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
