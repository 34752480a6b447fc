/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/stem.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/species.h"
#include "grow/silhouette.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* A stem whose section is not round. */

/* Width, height and shares of the shapes at a place of the stem [m]. */
static void section_at(const struct wf_model *m, double at, double *width, double *height, double mix[3])
{
    size_t k = 1;
    while (k + 1 < m->sections && m->section[k].at < at) k++;
    const struct wf_stem_section *a = &m->section[k - 1], *b = &m->section[k];
    double s = fmin(fmax((at - a->at) / (b->at - a->at), 0), 1);
    *width = a->width + s * (b->width - a->width);
    *height = a->height + s * (b->height - a->height);
    for (int i = 0; i < 3; i++) mix[i] = 0;
    mix[a->shape] += 1 - s;
    mix[b->shape] += s;
}

/* The height's direction: in the plane of the lean, turned about the axis. */
static void upward(const struct wf_model *m, double up[3])
{
    double axis[3] = { sin(m->lean) * cos(m->lean_azimuth), sin(m->lean) * sin(m->lean_azimuth),
                       cos(m->lean) };
    double plain[3] = { -cos(m->lean) * cos(m->lean_azimuth), -cos(m->lean) * sin(m->lean_azimuth),
                        sin(m->lean) };
    double side[3];
    wf_cross(axis, plain, side);
    for (int k = 0; k < 3; k++) up[k] = cos(m->turn) * plain[k] + sin(m->turn) * side[k];
}

/* Volume of a row: the area is a cubic of the length, which Simpson's rule takes exactly. */
static double volume(const struct wf_tree *t, size_t i)
{
    return wf_tree_length(t, i) / 6 *
           (wf_tree_area(t, i, 0) + 4 * wf_tree_area(t, i, 0.5) + wf_tree_area(t, i, 1));
}

/* Add the masses of one piece to its rows, first..end - 1. */
static void load_piece(const struct wf_stem_mass *p, double from, size_t first, size_t end, struct wf_tree *t)
{
    double sum = 0, length = p->to - from, side = (p->left - p->right) * p->lever / length;
    for (size_t i = first; i < end; i++) sum += volume(t, i);
    for (size_t i = first; i < end; i++) {
        if (!isnan(p->own)) t->density[i] = p->own / sum;
        t->burden0[i] = t->burden1[i] = (p->left + p->right) / length;
        t->section->side0[i] = t->section->side1[i] = side;
    }
}

/* Set sections that are not round, radii of the same area, and masses on the rows of a stem that has its
 * places and materials. s: row ends as shares of its height. */
static enum wf_status stem_sections(const struct wf_model *m, const double *s, struct wf_tree *t,
                                    struct wf_arena *a, struct wf_err *e)
{
    enum wf_status status = wf_tree_alloc_sections(t, a, e);
    if (status) return status;
    struct wf_tree_sections *c = t->section;
    for (size_t i = 0; i < t->n; i++) {
        upward(m, c->up + 3 * i);
        section_at(m, s[i] * m->height, &c->width0[i], &c->height0[i], c->mix0 + 3 * i);
        section_at(m, s[i + 1] * m->height, &c->width1[i], &c->height1[i], c->mix1 + 3 * i);
        t->r0[i] = sqrt(wf_tree_area(t, i, 0) / WF_PI);
        t->r1[i] = sqrt(wf_tree_area(t, i, 1) / WF_PI);
    }
    for (size_t k = 0, i = 0; k < m->masses; k++) {
        size_t first = i;
        while (i < t->n && (s[i] + s[i + 1]) * m->height < 2 * m->mass[k].to) i++;
        load_piece(&m->mass[k], k ? m->mass[k - 1].to : 0, first, i, t);
    }
    return WF_OK;
}

/* Row ends along the stem as relative heights, ascending. */
struct ends {
    size_t n;
    double *s;
};

static size_t sort_unique(double *s, size_t n, double apart)
{
    size_t kept = 0;
    qsort(s, n, sizeof *s, wf_ascending);
    for (size_t i = 0; i < n; i++)
        if (!kept || s[i] - s[kept - 1] > apart) s[kept++] = s[i];
    return kept;
}

static void add(struct ends *k, const struct wf_along *along, double from, double to)
{
    for (size_t i = 0; i < along->n; i++) k->s[k->n++] = from + (to - from) * along->s[i];
}

/* Where a property has a kink or a jump a row must end, so that linear rows follow it exactly; equal steps
 * fill the rest, leaving out those within a tenth of a step of a kink. */
static bool place_ends(const struct wf_model *m, const struct wf_along *wall, struct wf_arena *a,
                       struct ends *out)
{
    const struct wf_along *profile = &m->profile, *shape = &m->crown_shape;
    size_t most = 6 + wall->n + profile->n + shape->n + m->sections + m->masses;
    struct ends k = { .s = WF_TAKE(a, most, double) };
    out->s = WF_TAKE(a, most + m->segments, double);
    if (!k.s || !out->s) return false;
    k.s[k.n++] = 0;
    k.s[k.n++] = 1;
    if (m->taper == WF_TAPER_TABLE) add(&k, profile, 0, 1);
    add(&k, wall, 0, 1);
    for (size_t i = 0; i < m->sections; i++) k.s[k.n++] = m->section[i].at / m->height;
    for (size_t i = 0; i < m->masses; i++) k.s[k.n++] = m->mass[i].to / m->height;
    if (m->leaf_area > 0) {
        k.s[k.n++] = m->crown_base / m->height;
        k.s[k.n++] = m->crown_top / m->height;
        add(&k, shape, m->crown_base / m->height, m->crown_top / m->height);
    }
    double low, high, rise = wf_model_rise(m);
    if (wf_silhouette_ends(&m->silhouette, rise, &low, &high)) {
        if (low > 0) k.s[k.n++] = fmin(low / rise, 1);
        k.s[k.n++] = fmin(high / rise, 1);
    }
    k.n = sort_unique(k.s, k.n, 1e-9);
    k.s[k.n - 1] = 1;
    out->n = 0;
    for (size_t i = 0; i < k.n; i++) out->s[out->n++] = k.s[i];
    double step = 1.0 / (double)m->segments;
    for (size_t i = 1, j = 0; i < m->segments; i++) {
        double s = (double)i * step;
        while (k.s[j + 1] < s) j++;
        if (s - k.s[j] > 0.1 * step && k.s[j + 1] - s > 0.1 * step) out->s[out->n++] = s;
    }
    qsort(out->s, out->n, sizeof *out->s, wf_ascending);
    return true;
}

static void wood(struct wf_tree *t, const struct wf_model *m, const struct wf_level *l, const double *s)
{
    double base = isnan(m->radius) ? l->radius.value : m->radius;
    double axis[3] = { sin(m->lean) * cos(m->lean_azimuth), sin(m->lean) * sin(m->lean_azimuth),
                       cos(m->lean) };
    double *start[3] = { t->x0, t->y0, t->z0 }, *end[3] = { t->x1, t->y1, t->z1 };
    for (size_t i = 0; i < t->n; i++) {
        t->parent[i] = (int32_t)i - 1;
        for (int k = 0; k < 3; k++) {
            start[k][i] = s[i] * m->height * axis[k];
            end[k][i] = s[i + 1] * m->height * axis[k];
        }
        t->r0[i] = m->sections ? 0 : base * wf_model_taper(m, s[i]);
        t->r1[i] = m->sections ? 0 : base * wf_model_taper(m, s[i + 1]);
        t->i0[i] = t->r0[i] * (1 - wf_along_at(&l->wall, s[i], 1));
        t->i1[i] = t->r1[i] * (1 - wf_along_at(&l->wall, s[i + 1], 1));
        wf_level_onto(l, t, i, false);
        if (m->judged_to > 0 && s[i] * m->height >= m->judged_to)
            t->strength[i] = t->compressive[i] = t->shearing[i] = t->tangential[i] = 0;
    }
}

/* Leaf area per length at both ends of every row in the crown, scaled so that the rows add up to the model's.
 */
static void leaves(struct wf_tree *t, const struct wf_model *m, const struct wf_species *sp, const double *s)
{
    double from = m->crown_base / m->height, to = m->crown_top / m->height, sum = 0;
    for (size_t i = 0; i < t->n; i++) {
        double middle = 0.5 * (s[i] + s[i + 1]);
        if (middle < from || middle > to) continue;
        t->leaf0[i] = wf_along_at(&m->crown_shape, (s[i] - from) / (to - from), 1);
        t->leaf1[i] = wf_along_at(&m->crown_shape, (s[i + 1] - from) / (to - from), 1);
        sum += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
    }
    double scale = m->leaf_area / sum,
           sail = sp->crown.frontal_share.value * sp->crown.drag_coefficient.value;
    for (size_t i = 0; i < t->n; i++) {
        t->leaf0[i] *= scale;
        t->leaf1[i] *= scale;
        t->sail0[i] = t->leaf0[i] * sail;
        t->sail1[i] = t->leaf1[i] * sail;
        t->burden0[i] = t->leaf0[i] * sp->crown.leaf_mass_per_area.value;
        t->burden1[i] = t->leaf1[i] * sp->crown.leaf_mass_per_area.value;
    }
}

enum wf_status wf_grow_stem(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                            struct wf_tree *out, struct wf_err *e)
{
    if (!sp->levels) return wf_fail(e, WF_EINPUT, "%s: the species has no levels", sp->key);
    if (m->leaf_area > 0 && !sp->crown.drag_coefficient.given)
        return wf_fail(e, WF_EINPUT, "%s: the model has leaves, but the species table %s has no 'crown'",
                       m->key, sp->key);
    const struct wf_level *stem = &sp->level[0];
    if (m->sections && stem->wall.n)
        return wf_fail(e, WF_EINPUT, "%s: 'sections' are solid, but the stem of %s has a wall", m->key,
                       sp->key);
    struct ends ends;
    if (!place_ends(m, &stem->wall, a, &ends))
        return wf_fail(e, WF_ENOMEM, "%s: no memory for the stem", m->key);
    enum wf_status code = wf_tree_alloc(out, ends.n - 1, a, e);
    if (code) return code;
    out->name = m->name;
    wood(out, m, stem, ends.s);
    if (m->sections) return stem_sections(m, ends.s, out, a, e);
    if (m->leaf_area > 0) leaves(out, m, sp, ends.s);
    return WF_OK;
}
