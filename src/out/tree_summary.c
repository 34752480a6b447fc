#include "out/tree_summary.h"
#include <math.h>
#include <stdbool.h>

static size_t level_of(const struct wf_tree *t, size_t i)
{
    size_t level = t->level[i] > 0 ? (size_t)t->level[i] : 0;
    return level < WF_SUMMARY_LEVELS ? level : WF_SUMMARY_LEVELS - 1;
}

static bool goes_on(const struct wf_tree *t, size_t i)
{
    return t->parent[i] >= 0 && t->level[t->parent[i]] == t->level[i];
}

static double wood(const struct wf_tree *t, size_t i)
{
    double outer = t->r0[i] * t->r0[i] + t->r0[i] * t->r1[i] + t->r1[i] * t->r1[i];
    double inner = t->i0[i] * t->i0[i] + t->i0[i] * t->i1[i] + t->i1[i] * t->i1[i];
    return M_PI / 3 * (outer - inner) * wf_tree_length(t, i);
}

/* Length of every axis, kept at its first row. */
static void axis_lengths(const struct wf_tree *t, int32_t *first, double *length)
{
    for (size_t i = 0; i < t->n; i++) {
        first[i] = goes_on(t, i) ? first[t->parent[i]] : (int32_t)i;
        length[first[i]] += wf_tree_length(t, i);
    }
}

static void stretch(struct wf_tree_summary *s, double x, double y, double z)
{
    const double p[3] = { x, y, z };
    for (int k = 0; k < 3; k++) {
        s->low[k] = fmin(s->low[k], p[k]);
        s->high[k] = fmax(s->high[k], p[k]);
    }
}

enum wf_status wf_tree_summarise(const struct wf_tree *t, struct wf_tree_summary *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    int32_t *first = WF_TAKE(&scratch, t->n, int32_t);
    double *length = WF_TAKE(&scratch, t->n, double);
    *out = (struct wf_tree_summary){ .low = { INFINITY, INFINITY, INFINITY },
                                     .high = { -INFINITY, -INFINITY, -INFINITY },
                                     .height = wf_tree_height(t) };
    if (!first || !length) {
        wf_arena_free(&scratch);
        return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    }
    axis_lengths(t, first, length);
    for (size_t i = 0; i < t->n; i++) {
        struct wf_level_summary *l = &out->level[level_of(t, i)];
        if (level_of(t, i) + 1 > out->levels) out->levels = level_of(t, i) + 1;
        l->segments++;
        out->wood_volume += wood(t, i);
        out->leaf_area += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
        stretch(out, t->x0[i], t->y0[i], t->z0[i]);
        stretch(out, t->x1[i], t->y1[i], t->z1[i]);
        if (first[i] != (int32_t)i) continue;
        l->length_least = l->axes ? fmin(l->length_least, length[i]) : length[i];
        l->length_most = fmax(l->length_most, length[i]);
        l->length_mean += length[i];
        l->diameter_mean += 2 * t->r0[i];
        l->axes++;
    }
    for (size_t k = 0; k < out->levels; k++) {
        struct wf_level_summary *l = &out->level[k];
        if (!l->axes) continue;
        l->length_mean /= (double)l->axes;
        l->diameter_mean /= (double)l->axes;
    }
    wf_arena_free(&scratch);
    return WF_OK;
}
