/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/grow.h"
#include "base/num.h"
#include "data/species.h"
#include "grow/branches.h"
#include "grow/clothe.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include "grow/stem.h"
#include <math.h>
#include <string.h>

/* ---- Models ---- */

enum wf_status wf_model_open(const char *path, struct wf_arena *a, struct wf_model **out, struct wf_diag *d,
                             struct wf_err *e)
{
    struct wf_model *m = WF_TAKE(a, 1, struct wf_model);
    if (!m) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    *out = m;
    return wf_model_read(path, a, m, d, e);
}

/* File name without folder and ending, as a key. */
static const char *file_key(const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(a, slash ? slash + 1 : path), *dot = key ? strrchr(key, '.') : NULL;
    if (dot && dot != key) *dot = '\0';
    return key;
}

enum wf_status wf_model_scanned(const char *path, const char *joint, struct wf_arena *a,
                                struct wf_model **out, struct wf_diag *d, struct wf_err *e)
{
    return wf_model_imported(path, joint, NULL, a, out, d, e);
}

enum wf_status wf_model_imported(const char *path, const char *joint, const struct wf_import_options *options,
                                 struct wf_arena *a, struct wf_model **out, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_import_options o = options ? *options : wf_import_default();
    struct wf_qsm *q = WF_TAKE(a, 1, struct wf_qsm);
    struct wf_qsm_model *m = WF_TAKE(a, 1, struct wf_qsm_model);
    struct wf_model *made = *out = WF_TAKE(a, 1, struct wf_model);
    bool bridge = joint && strcmp(joint, "bridge") == 0;
    if (!q || !m || !made) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (joint && !bridge && strcmp(joint, "axis") != 0)
        return wf_fail(e, WF_EUSAGE, "joint \"%s\": \"axis\" or \"bridge\"", joint);
    enum wf_status s = wf_import_read(path, &o, a, q, d, e);
    if (s || (s = wf_qsm_to_tree(q, bridge ? WF_JOINT_BRIDGE : WF_JOINT_AXIS, a, m, e))) return s;
    *made = (struct wf_model){
        .key = file_key(path, a),
        .file = wf_arena_text(a, path),
        .source = wf_arena_print(a, "measured tree, %s, %zu cylinders", q->format, q->n),
        .generator = WF_GENERATOR_MEASURED,
        .height = wf_tree_height(&m->tree),
        .radius = m->tree.r0[0],
        .crown_base = NAN,
        .crown_top = NAN,
        .segments = m->tree.n,
        .measured = &m->tree,
        .measured_models = q->models,
        .measured_kind = m->kind,
    };
    made->name = made->key;
    if (!made->key || !made->file || !made->source) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    return WF_OK;
}

enum wf_status wf_model_leaves(struct wf_model *m, double area, struct wf_err *e)
{
    if (!(area >= 0 && isfinite(area))) return wf_fail(e, WF_EUSAGE, "leaf area %g m2", area);
    if (area > 0 && m->generator != WF_GENERATOR_MEASURED && !(m->leaf_area_on > 0))
        return wf_fail(e, WF_EUSAGE, "leaf area: the model %s does not say where its leaves are", m->key);
    m->leaf_area_on = area;
    wf_model_set_season(m, area > 0 ? WF_LEAF_ON : WF_LEAF_OFF);
    return WF_OK;
}

void wf_model_stands(struct wf_model *m, bool under_weight)
{
    m->shape = under_weight ? WF_SHAPE_UNDER_WEIGHT : WF_SHAPE_STRESS_FREE;
}

/* ---- Growth ---- */

static void warn_of_growth(const struct wf_model *m, const struct wf_tree *t, size_t capped, size_t thick,
                           struct wf_diag *d)
{
    size_t buried = 0;
    for (size_t i = 0; i < t->n; i++) buried += t->z1[i] < 0;
    if (capped)
        wf_diag_warn(d, "thick-branch", "%s: branches thinned to the radius of the part they grow from: %zu",
                     m->name, capped);
    if (thick)
        wf_diag_warn(d, "thick-branch",
                     "%s: by the pipe model %zu branches are thicker than the part they grow "
                     "from",
                     m->name, thick);
    if (buried)
        wf_diag_warn(d, "below-ground",
                     "%s: %zu of %zu segments end below the ground, where the wind speed is 0", m->name,
                     buried, t->n);
}

static enum wf_status grow_branched(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                                    struct wf_tree *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_axes axes;
    size_t capped = 0, thick = 0;
    bool ifs = m->generator == WF_GENERATOR_IFS;
    double radius = isnan(m->radius) ? sp->level[0].radius.value : m->radius;
    enum wf_status s = ifs ? wf_ifs_axes(m, radius, &scratch, &axes, &capped, e)
                           : wf_levels_axes(m, sp, &scratch, &axes, &capped, e);
    if (!s) s = wf_axes_to_tree(&axes, m->name, a, out, e);
    wf_arena_free(&scratch);
    if (!s && !ifs) s = wf_levels_pipes(m, out, &thick, e);
    if (!s) s = wf_clothe_wood(out, sp, NULL, e);
    if (!s) s = wf_leaves_spread(m, sp, out, e);
    if (!s) warn_of_growth(m, out, capped, thick, d);
    return s;
}

/* A measured tree: copy its segments to a new tree and add the materials. */
static enum wf_status grow_measured(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                                    struct wf_tree *out, struct wf_err *e)
{
    const struct wf_tree *t = m->measured;
    const struct wf_clothing wear = { .leaf_area = m->leaf_area, .kind = m->measured_kind };
    if (m->leaf_area > 0 && !sp->crown.drag_coefficient.given)
        return wf_fail(e, WF_EINPUT, "%s: leaves are specified, but the species table %s has no 'crown'",
                       m->name, sp->key);
    enum wf_status s = wf_tree_alloc(out, t->n, a, e);
    if (s) return s;
    double *const to[] = { out->x0, out->y0, out->z0, out->x1, out->y1, out->z1, out->r0, out->r1 };
    const double *const from[] = { t->x0, t->y0, t->z0, t->x1, t->y1, t->z1, t->r0, t->r1 };
    for (size_t k = 0; k < WF_COUNT(to); k++) memcpy(to[k], from[k], t->n * sizeof(double));
    memcpy(out->parent, t->parent, t->n * sizeof *t->parent);
    memcpy(out->level, t->level, t->n * sizeof *t->level);
    memcpy(out->id, t->id, t->n * sizeof *t->id);
    out->name = m->name;
    return wf_clothe(out, sp, &wear, a, e);
}

enum wf_status wf_grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                       struct wf_tree *out, struct wf_diag *d, struct wf_err *e)
{
    if (m->sections)
        return wf_fail(e, WF_EINPUT,
                       "%s: stress in sections that are not round is not computed; 'windfirm fit' and "
                       "'windfirm simulate-test' take a stem with 'sections'",
                       m->key);
    if (m->generator == WF_GENERATOR_STEM) return wf_grow_stem(m, sp, a, out, e);
    if (!sp->levels) return wf_fail(e, WF_EINPUT, "%s: the species has no levels", sp->key);
    if (m->generator == WF_GENERATOR_MEASURED) return grow_measured(m, sp, a, out, e);
    return grow_branched(m, sp, a, out, d, e);
}
