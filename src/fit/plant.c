/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/plant.h"
#include "base/file.h"
#include "data/model.h"
#include "data/species.h"
#include "data/species_names.h"
#include "grow/clothe.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include "grow/stem.h"
#include "load/drag.h"
#include "study/rest.h"
#include <math.h>
#include <string.h>

/* Path of a file named in the calibration, or of a shipped file given by its name alone. */
static enum wf_status find(const struct wf_calibration *c, const char *share, const char *room,
                           const char *name, struct wf_arena *a, const char **path, struct wf_err *e)
{
    if (strpbrk(name, "/.")) return wf_calibration_path(c, name, a, path, e);
    if (!strcmp(room, "species")) return wf_species_path(share, name, &wf_laws, a, path, e);
    return wf_shipped_path(share, room, name, a, path, e);
}

/* A tree of the calibration while it is made. */
struct job {
    const char *file; /* of the calibration */
    const struct wf_calibration_tree *from;
    wf_import_reader *mat;
    const struct wf_species *species;
    const char *path; /* of its model or scan */
    struct wf_tree *tree;
    double size; /* length of a stem model's axis; NAN: measured */
};

/* Does the tree stand in its shape? Given: what its model says. */
static bool stands(const struct job *j, bool drawn)
{
    return j->from->gravity > 0 && (j->from->rest ? strcmp(j->from->rest, "stress-free") != 0 : drawn);
}

static enum wf_status read_scan(const struct job *j, struct wf_arena *a, struct wf_diag *d,
                                struct wf_qsm_model *m, struct wf_err *e)
{
    const struct wf_calibration_tree *s = j->from;
    struct wf_import_options o = wf_import_default();
    o.mat = j->mat;
    o.tree_id = s->tree_id;
    o.force = s->force == 1;
    o.cap_children = s->cap_children == 1;
    struct wf_qsm q;
    enum wf_status status = wf_import_read(j->path, &o, a, &q, d, e);
    enum wf_joint joint = s->joint && !strcmp(s->joint, "bridge") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
    return status ? status : wf_qsm_to_tree(&q, joint, a, m, e);
}

static enum wf_status build_measured(struct job *j, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_qsm_model m;
    enum wf_status s = read_scan(j, a, d, &m, e);
    if (s) return s;
    struct wf_clothing now = { .leaf_area = j->from->leaf_area, .kind = m.kind }, then = now;
    if (!isnan(j->from->scanned_leaf_area)) then.leaf_area = j->from->scanned_leaf_area;
    if (stands(j, true)) { /* with the leaves of the day of the scan */
        s = wf_clothe(&m.tree, j->species, &then, a, e);
        if (!s) s = wf_tree_stand(&m.tree, &m.tree, a, e);
    }
    if (!s) s = wf_clothe(&m.tree, j->species, &now, a, e);
    *j->tree = m.tree;
    return s;
}

/* Let a stem stand with the leaves of the season in which it was drawn. */
static enum wf_status stand_model(const struct job *j, const struct wf_model *m, struct wf_arena *a,
                                  struct wf_err *e)
{
    struct wf_model then = *m;
    struct wf_arena scratch = { 0 };
    struct wf_tree worn;
    if (m->scanned == WF_SCANNED_AS_SEASON) return wf_tree_stand(j->tree, j->tree, a, e);
    wf_model_set_season(&then, m->scanned == WF_SCANNED_LEAF_ON ? WF_LEAF_ON : WF_LEAF_OFF);
    enum wf_status s = wf_grow_stem(&then, j->species, &scratch, &worn, e);
    if (!s) s = wf_tree_stand(j->tree, &worn, a, e);
    wf_arena_free(&scratch);
    return s;
}

static enum wf_status build_model(struct job *j, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_model m;
    enum wf_status s = wf_model_read(j->path, a, &m, d, e);
    if (!s && (m.cavities || m.bark.kind > WF_BARK_NONE))
        s = wf_fail(e, WF_EINPUT,
                    "%s: tree %s: %s has '%s', which a fit does not take: it finds the stiffness of the stem "
                    "over bark, as if sound",
                    j->file, j->from->name, j->path, m.cavities ? "cavities" : "bark");
    if (!s) s = wf_grow_stem(&m, j->species, a, j->tree, e);
    j->size = m.height;
    return s || !stands(j, m.shape == WF_SHAPE_UNDER_WEIGHT) ? s : stand_model(j, &m, a, e);
}

enum wf_status wf_fit_tree_build(const struct wf_calibration *c, size_t index, const char *share,
                                 wf_import_reader *mat, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_fit_tree *out, struct wf_err *e)
{
    const struct wf_calibration_tree *s = &c->tree[index];
    struct wf_species *sp = WF_TAKE(a, 1, struct wf_species);
    struct job j = { .file = c->file, .from = s, .mat = mat, .species = sp, .tree = &out->tree, .size = NAN };
    if (!sp) return wf_fail(e, WF_ENOMEM, "not enough memory for a species");
    enum wf_status status = find(c, share, "species", s->species, a, &j.path, e);
    if (!status) status = wf_species_read(j.path, &wf_laws, a, sp, d, e);
    *out = (struct wf_fit_tree){ .name = s->name, .species = sp };
    if (!status && s->qsm) status = wf_calibration_path(c, s->qsm, a, &j.path, e);
    if (!status && !s->qsm) status = find(c, share, "models", s->model, a, &j.path, e);
    if (!status) status = (s->qsm ? build_measured : build_model)(&j, a, d, e);
    if (status) return status;
    out->file = j.path;
    out->height = wf_tree_height(&out->tree);
    out->size = s->qsm ? out->height : j.size;
    if ((status = wf_scenario_still(sp, s->gravity, &out->loads, e))) return status;
    wf_solve_options_default(&out->options);
    out->options.tolerance = 1e-11; /* finite differences are taken of solutions: small residual */
    if (!isnan(s->root_stiffness))
        out->options.root_stiffness[0] = out->options.root_stiffness[1] = s->root_stiffness;
    return WF_OK;
}

/* A standing tree stands firm. */

enum wf_status wf_fit_tree_prop(struct wf_fit_tree *t, struct wf_arena *a, struct wf_err *e)
{
    size_t n = t->tree.n;
    if (!t->tree.standing) return WF_OK;
    struct wf_fit_props *p = t->props = WF_TAKE(a, 1, struct wf_fit_props);
    if (!p || !(p->raise = WF_TAKE(a, n, double)) || !(p->all.part = WF_TAKE(a, n, struct wf_firm_part)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", n);
    for (size_t i = 0; i < n; i++) p->raise[i] = 1;
    return WF_OK;
}

bool wf_fit_tree_unchanged(const struct wf_fit_tree *t)
{
    const struct wf_tree *now = &t->tree;
    const struct wf_tree_standing *then = now->standing;
    const size_t bytes = now->n * sizeof(double);
    bool same = !memcmp(now->burden0, then->burden0, bytes) && !memcmp(now->burden1, then->burden1, bytes);
    if (!now->section) return same;
    return same && !memcmp(now->section->side0, then->side0, bytes) &&
           !memcmp(now->section->side1, then->side1, bytes);
}

/* Add parts that were stiffened to those of before. */
static void note_parts(struct wf_fit_props *p, const struct wf_firm *f)
{
    for (size_t i = 0; i < f->n; i++) {
        size_t at = 0;
        while (at < p->all.n && p->all.part[at].row != f->part[i].row) at++;
        if (at == p->all.n)
            p->all.part[p->all.n++] = f->part[i];
        else
            p->all.part[at].raise *= f->part[i].raise;
    }
    p->times += f->n > 0;
}

enum wf_status wf_fit_tree_firm(const struct wf_fit_tree *t, struct wf_tree *now, const struct wf_loads *l,
                                const struct wf_solve_options *o, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_firm f;
    struct wf_tree firm = *now;
    if (!t->props) return WF_OK;
    enum wf_status s = wf_firm(&firm, l, o, WF_REST_SMALL, WF_REST_FIRM, &work, &f, e);
    if (!s && f.gave_up) {
        const char *who = wf_arena_print(&work, "tree %s", t->name);
        s = wf_rest_refuse(who ? who : "the tree",
                           "it may stand with another 'start' in 'free', and 'rest: stress-free' takes the "
                           "shape as free of stress",
                           now, &f, e);
    }
    for (size_t i = 0; i < now->n && !s && f.n; i++) {
        t->props->raise[i] *= firm.youngs[i] / now->youngs[i];
        now->youngs[i] = firm.youngs[i], now->shear[i] = firm.shear[i];
    }
    if (!s) note_parts(t->props, &f);
    wf_arena_free(&work);
    return s;
}

void wf_fit_tree_warn(const struct wf_fit_tree *t, struct wf_diag *d)
{
    if (!t->props || !t->props->all.n) return;
    const char *who = wf_arena_print(d->arena, "tree %s", t->name);
    wf_rest_warn_of_parts(who ? who : "the tree", &t->tree, &t->props->all, d);
}
