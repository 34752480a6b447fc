#include "data/model.h"
#include "fit/build.h"
#include "grow/clothe.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include "grow/stem.h"
#include <math.h>
#include <string.h>

/* A file of the study, or the bare name of a shipped one. */
static enum wf_status find(const struct wf_fit_build *b, const char *room, const char *name,
                           struct wf_arena *a, const char **path, struct wf_err *e)
{
    if (strpbrk(name, "/.")) return wf_fit_path(b->study, name, a, path, e);
    *path = wf_arena_print(a, "%s/%s/%s.yaml", b->share, room, name);
    return *path ? WF_OK : wf_fail(e, WF_ENOMEM, "%s: no memory", name);
}

static enum wf_status measured(const struct wf_study_tree *s, const char *path, const struct wf_species *sp,
                               struct wf_arena *a, struct wf_diag *d, struct wf_tree *out, struct wf_err *e)
{
    struct wf_import_options o = wf_import_default();
    struct wf_qsm q;
    struct wf_qsm_model m;
    enum wf_status status = wf_import_read(path, &o, a, &q, d, e);
    enum wf_joint joint = s->joint && !strcmp(s->joint, "bridge") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
    if (!status) status = wf_qsm_to_tree(&q, joint, a, &m, e);
    if (status) return status;
    struct wf_clothing c = { .leaf_area = s->leaf_area, .kind = m.kind };
    status = wf_clothe(&m.tree, sp, &c, a, e);
    *out = m.tree;
    return status;
}

enum wf_status wf_fit_build_tree(const struct wf_fit_build *b, size_t index, struct wf_arena *a,
                                 struct wf_diag *d, struct wf_fit_tree *out, struct wf_err *e)
{
    const struct wf_study_tree *s = &b->study->tree[index];
    struct wf_species *sp = WF_TAKE(a, 1, struct wf_species);
    struct wf_model m;
    const char *path;
    if (!sp) return wf_fail(e, WF_ENOMEM, "no room for a species");
    enum wf_status status = find(b, "species", s->species, a, &path, e);
    if (!status) status = wf_species_read(path, &wf_laws, a, sp, d, e);
    *out = (struct wf_fit_tree){ .name = s->name, .species = sp };
    if (!status) status = find(b, "models", s->qsm ? s->qsm : s->model, a, &path, e);
    if (!status) out->file = path;
    if (!status && s->qsm) status = measured(s, path, sp, a, d, &out->tree, e);
    if (!status && !s->qsm) status = wf_model_read(path, a, &m, d, e);
    if (!status && !s->qsm) status = wf_grow_stem(&m, sp, a, &out->tree, e);
    if (status) return status;
    out->height = wf_tree_height(&out->tree);
    out->size = s->qsm ? out->height : m.height;
    wf_loads_default(&out->loads);
    out->loads.gravity = s->gravity;
    if ((status = wf_loads_laws(&out->loads, sp, e))) return status;
    wf_solve_options_default(&out->options);
    out->options.tolerance = 1e-11; /* else small steps drown in what is left of the last answer */
    if (!isnan(s->root_stiffness))
        out->options.root_stiffness[0] = out->options.root_stiffness[1] = s->root_stiffness;
    return WF_OK;
}
