/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/grow.h"
#include "base/num.h"
#include "data/species.h"
#include "grow/branches.h"
#include "grow/clothe.h"
#include "grow/hollowed.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include "grow/silhouette.h"
#include "grow/stem.h"
#include <math.h>
#include <string.h>
#include <sys/stat.h>

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

/* Copy the shape of a tree: geometry, levels and ids. Given: columns to copy to, or an arena to take them
 * from. Returned: whether there was memory. */
static bool copy_shape(const struct wf_tree *from, struct wf_arena *a, struct wf_tree *to)
{
    const double *const source[] = { from->x0, from->y0, from->z0, from->x1,
                                     from->y1, from->z1, from->r0, from->r1 };
    double **const target[] = { &to->x0, &to->y0, &to->z0, &to->x1, &to->y1, &to->z1, &to->r0, &to->r1 };
    size_t n = to->n = from->n;
    for (size_t k = 0; k < WF_COUNT(target); k++) {
        if (a) *target[k] = WF_TAKE(a, n, double);
        if (!*target[k]) return false;
        memcpy(*target[k], source[k], n * sizeof(double));
    }
    if (a)
        to->parent = WF_TAKE(a, n, int32_t), to->level = WF_TAKE(a, n, int32_t),
        to->id = WF_TAKE(a, n, int64_t);
    if (!to->parent || !to->level || !to->id) return false;
    memcpy(to->parent, from->parent, n * sizeof *to->parent);
    memcpy(to->level, from->level, n * sizeof *to->level);
    memcpy(to->id, from->id, n * sizeof *to->id);
    return true;
}

/* What a model keeps of a measured tree: the shape and kind of its segments. */
static enum wf_status keep_measured(const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                                    struct wf_arena *a, struct wf_model *made, struct wf_err *e)
{
    size_t n = m->tree.n;
    struct wf_tree *shape = WF_TAKE(a, 1, struct wf_tree);
    uint8_t *kind = WF_TAKE(a, n, uint8_t);
    if (!shape || !kind || !copy_shape(&m->tree, a, shape))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for %zu segments", path, n);
    memcpy(kind, m->kind, n);
    *made = (struct wf_model){
        .key = file_key(path, a),
        .file = wf_arena_text(a, path),
        .source = wf_arena_print(a, "measured tree, %s, %zu cylinders", q->format, q->n),
        .generator = WF_GENERATOR_MEASURED,
        .shape = WF_SHAPE_UNDER_WEIGHT,
        .height = wf_tree_height(shape),
        .radius = shape->r0[0],
        .crown_base = NAN,
        .crown_top = NAN,
        .silhouette = { .leafless = NAN },
        .segments = n,
        .measured = shape,
        .measured_models = q->models,
        .measured_kind = kind,
    };
    shape->name = made->name = made->key;
    return made->key && made->file && made->source ? WF_OK : wf_fail(e, WF_ENOMEM, "%s: no memory", path);
}

enum wf_status wf_model_imported(const char *path, const char *joint, const struct wf_import_options *options,
                                 struct wf_arena *a, struct wf_model **out, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_import_options o = options ? *options : wf_import_default();
    struct wf_qsm q;
    struct wf_qsm_model m;
    struct stat there;
    struct wf_arena scratch = { 0 }, *table = &scratch;
    bool bridge = joint && strcmp(joint, "bridge") == 0;
    if (!(*out = WF_TAKE(a, 1, struct wf_model))) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (joint && !bridge && strcmp(joint, "axis") != 0)
        return wf_fail(e, WF_EUSAGE, "joint \"%s\": \"axis\" or \"bridge\"", joint);
    /* the bytes of a pipe are kept, for its fingerprint; text and table of a file are not */
    if (stat(path, &there) || !S_ISREG(there.st_mode)) table = a;
    enum wf_status s = wf_import_read(path, &o, table, &q, d, e);
    if (!s) s = wf_qsm_to_tree(&q, bridge ? WF_JOINT_BRIDGE : WF_JOINT_AXIS, table, &m, e);
    if (!s) s = keep_measured(path, &q, &m, a, *out, e);
    wf_arena_free(&scratch);
    return s;
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
    (void)copy_shape(t, NULL, out);
    out->name = m->name;
    return wf_clothe(out, sp, &wear, a, e);
}

enum wf_status wf_grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                       struct wf_tree *out, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s;
    if (!sp->levels) return wf_fail(e, WF_EINPUT, "%s: the species has no levels", sp->key);
    if (m->generator == WF_GENERATOR_STEM)
        s = wf_grow_stem(m, sp, a, out, e);
    else if (m->generator == WF_GENERATOR_MEASURED)
        s = grow_measured(m, sp, a, out, e);
    else
        s = grow_branched(m, sp, a, out, d, e);
    if (!s) s = wf_silhouette_onto(m, sp, out, d, e);
    return s ? s : wf_hollow_onto(m, sp, a, out, d, e);
}
