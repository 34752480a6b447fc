#include "data/model.h"
#include "data/model_schema.h"
#include "data/value.h"
#include <math.h>
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

void wf_model_finish(struct wf_yaml *y, void *model)
{
    struct wf_model *m = model;
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
