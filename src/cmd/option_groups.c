/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/option_groups.h"
#include "cmd/cmd.h"
#include "solve/solve.h"
#include "solve/solvers.h"
#include "study/preset.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>

const char *wf_solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
const char *wf_preset_word(size_t i) { return wf_presets[i].name; }
const char *wf_shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }
const char *wf_profile_word(size_t i) { return wf_profiles[i].name; }
const char *wf_import_word(size_t i) { return wf_import_formats[i].name; }

static double metres(const char *unit)
{
    if (!unit) return (double)NAN;
    return unit[0] == 'c' ? 0.01 : unit[1] == 'm' ? 0.001 : 1;
}

struct wf_import_options wf_import_asked_options(const struct wf_import_asked *asked)
{
    struct wf_import_options o = wf_import_default();
    o.format = asked->format;
    o.strict = asked->strict;
    o.length_unit = metres(asked->length_unit);
    o.diameter_unit = metres(asked->diameter_unit);
    return o;
}

enum wf_joint wf_joint_named(const char *word)
{
    return strcmp(word, "axis") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
}

/* File name without folder and ending, as a key. */
static const char *file_key(const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(a, slash ? slash + 1 : path), *dot = key ? strrchr(key, '.') : NULL;
    if (dot && dot != key) *dot = '\0';
    return key;
}

static enum wf_status read_measured(const struct wf_tree_asked *t, const char *path, struct wf_arena *a,
                                    struct wf_model *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_import_options o = wf_import_default();
    struct wf_qsm *q = WF_TAKE(a, 1, struct wf_qsm);
    struct wf_qsm_model *m = WF_TAKE(a, 1, struct wf_qsm_model);
    if (!q || !m) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    enum wf_status s = wf_import_read(path, &o, a, q, d, e);
    if (s || (s = wf_qsm_to_tree(q, wf_joint_named(t->joint), a, m, e))) return s;
    *out = (struct wf_model){
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
        .measured_kind = m->kind,
    };
    out->name = out->key;
    if (!out->key || !out->file || !out->source) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    return WF_OK;
}

int wf_tree_asked_check(const struct wf_tree_asked *t, const char *command, const char *file)
{
    const char *wrong = NULL;
    int given = (t->model != NULL) + (t->file != NULL) + (file != NULL);
    if (!given) wrong = "--model is needed, for example --model models/culm.yaml";
    if (given > 1) wrong = "more than one tree is given (--model, --tree); one is taken";
    if (wrong) fprintf(stderr, "windfirm %s: %s\n", command, wrong);
    return wrong ? 2 : -1;
}

enum wf_status wf_tree_asked_read(const struct wf_tree_asked *t, const char *file, struct wf_arena *a,
                                  struct wf_model *out, const char **path, struct wf_diag *d,
                                  struct wf_err *e)
{
    const char *tree = file ? file : t->file;
    enum wf_status s;
    if (tree) {
        *path = tree;
        s = read_measured(t, tree, a, out, d, e);
    } else {
        *path = wf_shipped("models", t->model, a);
        s = wf_model_read(*path, a, out, d, e);
    }
    if (s) return s;
    double area = t->leaf_area;
    if (!isnan(area)) {
        if (!tree && !(out->leaf_area_on > 0) && area > 0)
            return wf_fail(e, WF_EUSAGE, "--leaf-area: the model %s does not say where its leaves are",
                           out->key);
        out->leaf_area_on = area;
    }
    bool off = t->season ? !strcmp(t->season, "leaf_off") : out->season == WF_LEAF_OFF;
    wf_model_set_season(out, off ? WF_LEAF_OFF : WF_LEAF_ON);
    if (t->unload) out->shape = WF_SHAPE_UNDER_WEIGHT;
    return WF_OK;
}
