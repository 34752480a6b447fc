/* The tree of a study: a model, or a measured tree standing in for one. */
#include "cmd/study.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include <math.h>
#include <string.h>

/* File name without folder and ending, as a key. */
static const char *key_of(const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(a, slash ? slash + 1 : path), *dot = key ? strrchr(key, '.') : NULL;
    if (dot && dot != key) *dot = '\0';
    return key;
}

static enum wf_status measured(const struct wf_args *g, const char *path, struct wf_arena *a,
                               struct wf_model *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_import_options o = wf_import_default();
    struct wf_qsm *q = WF_TAKE(a, 1, struct wf_qsm);
    struct wf_qsm_model *m = WF_TAKE(a, 1, struct wf_qsm_model);
    if (!q || !m) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    enum wf_joint joint = strcmp(wf_args_text(g, "--joint"), "axis") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
    enum wf_status s = wf_import_read(path, &o, a, q, d, e);
    if (s || (s = wf_qsm_to_tree(q, joint, a, m, e))) return s;
    *out = (struct wf_model){
        .key = key_of(path, a),
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

int wf_study_tree_asked(const struct wf_args *g, const char *command, const char *file)
{
    const char *model = wf_args_text(g, "--model"), *tree = wf_args_text(g, "--tree"), *wrong = NULL;
    int given = (model != NULL) + (tree != NULL) + (file != NULL);
    if (!given) wrong = "--model is needed, for example --model models/culm.yaml";
    if (given > 1) wrong = "more than one tree is given (--model, --tree); one is taken";
    if (wrong) fprintf(stderr, "windfirm %s: %s\n", command, wrong);
    return wrong ? 2 : -1;
}

enum wf_status wf_study_tree(const struct wf_args *g, const char *file, struct wf_arena *a,
                             struct wf_model *out, const char **path, struct wf_diag *d, struct wf_err *e)
{
    const char *tree = file ? file : wf_args_text(g, "--tree"), *season = wf_args_text(g, "--season");
    enum wf_status s;
    if (tree) {
        *path = tree;
        s = measured(g, tree, a, out, d, e);
    } else {
        *path = wf_shipped("models", wf_args_text(g, "--model"), a);
        s = wf_model_read(*path, a, out, d, e);
    }
    if (s) return s;
    double area = wf_args_number(g, "--leaf-area");
    if (!isnan(area)) {
        if (!tree && !(out->leaf_area_on > 0) && area > 0)
            return wf_fail(e, WF_EUSAGE, "--leaf-area: the model %s does not say where its leaves are",
                           out->key);
        out->leaf_area_on = area;
    }
    bool off = season ? !strcmp(season, "leaf_off") : out->season == WF_LEAF_OFF;
    wf_model_set_season(out, off ? WF_LEAF_OFF : WF_LEAF_ON);
    if (wf_args_given(g, "--unload")) out->shape = WF_SHAPE_UNDER_WEIGHT;
    return WF_OK;
}
