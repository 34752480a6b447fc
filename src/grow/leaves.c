/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/leaves.h"
#include "base/random.h"
#include "base/vec3.h"
#include "data/species.h"
#include "grow/branches.h"
#include <math.h>

#define GOLDEN_ANGLE 2.39996322972865332 /* 137.5 degrees */

enum { LEAF_STREAM = 0x4C /* purpose of the leaves' random streams */ };

enum wf_status wf_leaves_spread(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                struct wf_err *e)
{
    if (!(m->leaf_area > 0)) return WF_OK;
    if (!sp->crown.drag_coefficient.given)
        return wf_fail(e, WF_EINPUT, "%s: the model has leaves, but the species table %s has no 'crown'",
                       m->key, sp->key);
    double length = 0;
    for (size_t i = 0; i < t->n; i++) length += t->leaf0[i] * wf_tree_length(t, i);
    if (!(length > 0)) return wf_fail(e, WF_EINPUT, "%s: no axis grew that could bear its leaves", m->key);
    double sail = sp->crown.frontal_share.value * sp->crown.drag_coefficient.value;
    for (size_t i = 0; i < t->n; i++) {
        double leaf = t->leaf0[i] * m->leaf_area / length;
        t->leaf0[i] = t->leaf1[i] = leaf;
        t->sail0[i] = t->sail1[i] = leaf * sail;
        t->burden0[i] = t->burden1[i] = leaf * sp->crown.leaf_mass_per_area.value;
    }
    return WF_OK;
}

static enum wf_status take_leaves(struct wf_leaves *out, size_t n, struct wf_arena *a, struct wf_err *e)
{
    *out = (struct wf_leaves){ .row = WF_TAKE(a, n, int32_t),
                               .place = WF_TAKE(a, n, double),
                               .area = WF_TAKE(a, n, double),
                               .size = WF_TAKE(a, n, double),
                               .direction = WF_TAKE(a, 3 * n, double),
                               .side = WF_TAKE(a, 3 * n, double) };
    if (out->row && out->place && out->area && out->size && out->direction && out->side) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "no room for %zu leaves", n);
}

/* Directions and size of leaf j on row i: tilted from the axis, rotated about it by the golden angle from the
 * leaf before. */
static void turn_leaf(const struct wf_model *m, const struct wf_tree *t, size_t i, size_t j,
                      struct wf_leaves *out)
{
    double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] }, across[3], third[3];
    double length = sqrt(wf_dot(axis, axis)), z[4] = { 0 };
    for (int k = 0; k < 3; k++) axis[k] /= length;
    wf_random_normals(m->seed, wf_random_stream(LEAF_STREAM, 0, 0), 4 * j, 4, z);
    double tilt = m->foliage.tilt + m->foliage.scatter * z[0];
    double round = GOLDEN_ANGLE * (double)j + m->foliage.scatter * z[1], roll = m->foliage.scatter * z[2];
    wf_side_of(axis, across);
    wf_cross(axis, across, third);
    double *d = out->direction + 3 * j, *s = out->side + 3 * j, flat[3], upright[3];
    for (int k = 0; k < 3; k++) {
        double outward = cos(round) * across[k] + sin(round) * third[k];
        d[k] = cos(tilt) * axis[k] + sin(tilt) * outward;
        flat[k] = cos(round) * third[k] - sin(round) * across[k];
    }
    wf_cross(d, flat, upright);
    for (int k = 0; k < 3; k++) s[k] = cos(roll) * flat[k] + sin(roll) * upright[k];
    out->size[j] = exp(m->foliage.size_spread * z[3]);
}

enum wf_status wf_leaves_place(const struct wf_model *m, const struct wf_tree *t, struct wf_arena *a,
                               struct wf_leaves *out, struct wf_err *e)
{
    const double reference_wind = 10; /* [m/s], of the model's swing and twist */
    size_t n = m->leaf_area > 0 ? m->foliage.count : 0, j = 0;
    double squares = 0, passed = 0, total = 0;
    enum wf_status s = take_leaves(out, n, a, e);
    if (s) return s;
    out->swing = m->foliage.swing / reference_wind;
    out->twist = m->foliage.twist / reference_wind;
    for (size_t i = 0; i < t->n; i++) total += t->leaf0[i] * wf_tree_length(t, i);
    for (size_t i = 0; i < t->n && j < n; i++) {
        double here = t->leaf0[i] * wf_tree_length(t, i), next;
        for (; j < n && (next = total * ((double)j + 0.5) / (double)n) < passed + here; j++) {
            out->row[j] = (int32_t)i;
            out->place[j] = (next - passed) / here;
            turn_leaf(m, t, i, j, out);
            squares += out->size[j] * out->size[j];
        }
        passed += here;
    }
    out->n = j;
    for (size_t k = 0; k < j; k++) {
        out->area[k] = m->leaf_area * out->size[k] * out->size[k] / squares;
        out->size[k] /= sqrt(squares / (double)j);
    }
    return WF_OK;
}
