#include "data/model.h"
#include "data/branching_schema.h"
#include "data/model_schema.h"
#include "data/value.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Keys of one taper law: needed by it, refused by a law that does not use them. */
static void key_of_taper(struct wf_yaml *y, const char *key, bool used, const char *law)
{
    bool has = wf_yaml_has(y, key);
    if (used && !has) wf_yaml_error(y, "", "law '%s' needs the key '%s'", law, key);
    if (!used && has) wf_yaml_error(y, key, "is not used by law '%s'", law);
}

void wf_taper_finish(struct wf_yaml *y, void *model)
{
    const struct wf_model *m = model;
    const char *law = wf_yaml_raw(y, "law");
    bool known = law && (!strcmp(law, "table") || !strcmp(law, "linear") || !strcmp(law, "power"));
    if (!known) return;
    bool table = m->taper == WF_TAPER_TABLE, power = m->taper == WF_TAPER_POWER;
    key_of_taper(y, "tip_share", !table, law);
    key_of_taper(y, "power", power, law);
    key_of_taper(y, "at", table, law);
    key_of_taper(y, "share", table, law);
    const struct wf_along *p = &m->profile;
    if (!table || !p->s || !p->n) return;
    wf_value_ascending(y, "at", p->n, p->s);
    if (p->s[0] > 0 || p->s[p->n - 1] < 1)
        wf_yaml_error(y, "at", "runs from %g to %g; it must cover the stem from 0 to 1", p->s[0],
                      p->s[p->n - 1]);
    if (p->v && fabs(p->v[0] - 1) > 1e-9)
        wf_yaml_error(y, "share[0]", "is %g; shares are of the base radius, so the first is 1", p->v[0]);
}

void wf_shape_finish(struct wf_yaml *y, void *model)
{
    const struct wf_along *s = &((struct wf_model *)model)->crown_shape;
    wf_value_ascending(y, "at", s->s ? s->n : 0, s->s);
    double sum = 0;
    for (size_t i = 0; s->v && i < s->n; i++) sum += s->v[i];
    if (s->v && sum <= 0) wf_yaml_error(y, "share", "is 0 everywhere; the leaves must be somewhere");
}

/* Crown of a stem. */
static void crown_finish(struct wf_yaml *y, struct wf_model *m)
{
    if (!wf_yaml_has(y, "crown")) {
        m->leaf_area = 0;
        return;
    }
    if (m->crown_top > m->height)
        wf_yaml_error(y, "crown.top", "%g m is above the stem's height %g m", m->crown_top, m->height);
    if (isnan(m->crown_top)) m->crown_top = m->height;
    if (m->crown_base >= m->crown_top)
        wf_yaml_error(y, "crown.base", "%g m is not below the crown's top %g m", m->crown_base, m->crown_top);
}

/* Each generator has its own keys. */
static void keys_of_generator(struct wf_yaml *y, const struct wf_model *m)
{
    static const struct {
        const char *key;
        enum wf_generator own, also;
        bool needed;
    } rows[] = {
        { "crown", WF_GENERATOR_STEM, WF_GENERATOR_STEM, false },
        { "stem.curve", WF_GENERATOR_LEVELS, WF_GENERATOR_LEVELS, false },
        { "branches", WF_GENERATOR_LEVELS, WF_GENERATOR_LEVELS, true },
        { "ifs", WF_GENERATOR_IFS, WF_GENERATOR_IFS, true },
        { "leaves", WF_GENERATOR_LEVELS, WF_GENERATOR_IFS, false },
    };
    const char *name = wf_generator_words[m->generator];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bool has = wf_yaml_has(y, rows[i].key),
             mine = m->generator == rows[i].own || m->generator == rows[i].also;
        if (has && !mine) {
            if (wf_yaml_has(y, "generator"))
                wf_yaml_error(y, rows[i].key, "is not used by generator '%s'", name);
            else
                wf_yaml_error(y, rows[i].key, "needs 'generator: %s'", wf_generator_words[rows[i].own]);
        }
        if (!has && mine && rows[i].needed)
            wf_yaml_error(y, "", "generator '%s' needs the key '%s'", name, rows[i].key);
    }
}

/* The radius of a pipe is known last, so a branch on it cannot take a share of it. */
static void pipes(struct wf_yaml *y, const struct wf_model *m)
{
    char key[64];
    for (size_t i = 1; i < m->branchings; i++) {
        enum wf_radius_law own = m->branching[i].radius_law, below = m->branching[i - 1].radius_law;
        if (below != WF_RADIUS_PIPE || own == WF_RADIUS_PIPE) continue;
        (void)snprintf(key, sizeof key, "branches[%zu].radius.law", i);
        wf_yaml_error(y, key, "is '%s' on a level that follows the pipe model; it must be 'pipe' too",
                      wf_radius_words[own]);
    }
    if (m->branchings + 1 > WF_BRANCH_LEVELS_MAX)
        wf_yaml_error(y, "branches", "%zu levels; with the stem at most %d are grown", m->branchings,
                      (int)WF_BRANCH_LEVELS_MAX);
}

void wf_model_finish(struct wf_yaml *y, void *model)
{
    struct wf_model *m = model;
    keys_of_generator(y, m);
    wf_stem_finish(y, m);
    pipes(y, m);
    if (m->generator == WF_GENERATOR_STEM)
        crown_finish(y, m);
    else
        m->leaf_area = wf_yaml_has(y, "leaves") ? m->foliage.area : 0;
    m->leaf_area_on = m->leaf_area;
    wf_model_set_season(m, m->season);
}

void wf_model_set_season(struct wf_model *m, enum wf_season season)
{
    m->season = season;
    m->leaf_area = season == WF_LEAF_ON ? m->leaf_area_on : 0;
}

size_t wf_model_levels(const struct wf_model *m)
{
    if (m->generator == WF_GENERATOR_LEVELS) return 1 + m->branchings;
    if (m->generator == WF_GENERATOR_MEASURED) {
        int32_t last = 0;
        for (size_t i = 0; i < m->measured->n; i++)
            if (m->measured->level[i] > last) last = m->measured->level[i];
        return (size_t)last + 1;
    }
    return m->generator == WF_GENERATOR_IFS ? m->ifs.levels : 1;
}

const char *wf_model_level_name(const struct wf_model *m, const struct wf_species *sp, int32_t level)
{
    size_t l = level > 0 ? (size_t)level : 0;
    static const char *const order[] = { "branch of order 1", "branch of order 2", "branch of order 3",
                                         "branch of order 4", "branch of order 5", "finer branch" };
    if (l && m->generator == WF_GENERATOR_MEASURED) return order[l < 6 ? l - 1 : 5];
    if (l && m->generator == WF_GENERATOR_LEVELS && l <= m->branchings && m->branching[l - 1].name)
        return m->branching[l - 1].name;
    return l < sp->levels ? sp->level[l].name : "branch";
}

const struct wf_level *wf_model_wood(const struct wf_model *m, const struct wf_species *sp,
                                     const struct wf_tree *t, size_t i)
{
    return m->generator == WF_GENERATOR_MEASURED
               ? wf_species_wood(sp, t->level[i], 0.5 * (t->r0[i] + t->r1[i]))
               : wf_species_level(sp, t->level[i]);
}

double wf_model_taper(const struct wf_model *m, double s)
{
    switch (m->taper) {
    case WF_TAPER_LINEAR:
        return 1 - (1 - m->tip_ratio) * s;
    case WF_TAPER_POWER:
        return m->tip_ratio + (1 - m->tip_ratio) * pow(1 - s, m->power);
    default:
        return wf_along_at(&m->profile, s, 1);
    }
}

enum wf_status wf_model_read(const char *path, struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                             struct wf_err *e)
{
    *out = (struct wf_model){ .file = wf_arena_text(a, path) };
    if (!out->file) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    return wf_yaml_read(path, &wf_model_table, out, a, d, e);
}

char *wf_model_schema(struct wf_arena *a, struct wf_err *e) { return wf_yaml_schema(&wf_model_table, a, e); }
