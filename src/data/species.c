#include "data/species.h"
#include "base/num.h"
#include "base/text.h"
#include "data/species_schema.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

double wf_along_at(const struct wf_along *a, double s, double fallback)
{
    if (!a->n) return fallback;
    if (!(s > a->s[0])) return a->v[0];
    for (size_t i = 1; i < a->n; i++)
        if (s <= a->s[i]) {
            double w = (s - a->s[i - 1]) / (a->s[i] - a->s[i - 1]);
            return a->v[i - 1] + w * (a->v[i] - a->v[i - 1]);
        }
    return a->v[a->n - 1];
}

const char *wf_species_source(const struct wf_species *sp, const char *key)
{
    for (size_t i = 0; key && i < sp->sources; i++)
        if (!strcmp(sp->source[i].key, key)) return sp->source[i].text;
    return NULL;
}

/* Shear modulus along the grain when nobody measured it. E/G of the species in Forest Products Laboratory
 * 2010 (Wood Handbook, FPL-GTR-190, Table 5-1, 12 % moisture) lies between 7 (cherry) and 27 (balsa) for the
 * two planes along the grain; 16 is near the middle. Bending hardly depends on it, torsion does. */
static const double modulus_ratio = 16.0;

void wf_level_finish(struct wf_yaml *y, void *level)
{
    struct wf_level *l = level;
    (void)y;
    if (l->shear_modulus.given) return;
    l->shear_modulus = (struct wf_value){ .value = l->youngs_modulus.value / modulus_ratio,
                                          .low = l->youngs_modulus.low / modulus_ratio,
                                          .high = l->youngs_modulus.high / modulus_ratio,
                                          .standing = WF_ASSUMED,
                                          .note = "youngs_modulus / 16" };
}

static void need_source(struct wf_yaml *y, enum wf_standing s)
{
    if (s != WF_ASSUMED && !wf_yaml_has(y, "source"))
        wf_yaml_error(y, "status", "a table that is '%s' needs a source: a key of 'sources'",
                      wf_standing_text(s));
}

void wf_wall_finish(struct wf_yaml *y, void *level)
{
    const struct wf_level *l = level;
    wf_value_ascending(y, "at", l->wall.s ? l->wall.n : 0, l->wall.s);
    need_source(y, l->wall_note.standing);
}

/* Keys that belong to one law: needed by it, refused by the others. */
static void keys_of_law(struct wf_yaml *y, const char *law, const char *chosen, const char *const key[2])
{
    bool mine = !strcmp(law, chosen);
    for (int i = 0; i < 2; i++) {
        bool has = wf_yaml_has(y, key[i]);
        if (mine && !has) wf_yaml_error(y, "", "law '%s' needs the key '%s'", law, key[i]);
        if (!mine && has) wf_yaml_error(y, key[i], "is for law '%s'; the law here is '%s'", law, chosen);
    }
}

void wf_streamlining_finish(struct wf_yaml *y, void *species)
{
    struct wf_streamlining *s = &((struct wf_species *)species)->streamlining;
    const char *law = wf_yaml_raw(y, "law");
    bool chosen = law && !strcmp(law, s->law); /* a law that is not known was refused already */
    if (chosen) keys_of_law(y, "vogel", s->law, (const char *const[]){ "exponent", "reference_speed" });
    if (chosen) keys_of_law(y, "table", s->law, (const char *const[]){ "speed", "share" });
    wf_value_ascending(y, "speed", s->table.s ? s->table.n : 0, s->table.s);
    need_source(y, s->standing);
    if (s->speed_low >= s->speed_high)
        wf_yaml_error(y, "valid_to", "%s is not above valid_from %s", wf_yaml_raw(y, "valid_to"),
                      wf_yaml_raw(y, "valid_from"));
    if (!s->source) s->source = s->exponent.source;
}

static void source_exists(struct wf_yaml *y, const struct wf_species *sp, const char *key, const char *place)
{
    const char *known[64], *near;
    size_t n = 0;
    for (size_t i = 0; key && i < sp->sources; i++) {
        if (!strcmp(sp->source[i].key, key)) return;
        if (n < sizeof known / sizeof *known) known[n++] = sp->source[i].key;
    }
    if (!key) return;
    near = wf_nearest(key, known, n);
    if (near)
        wf_yaml_error(y, place, "'%.60s' is not in 'sources'; did you mean '%s'?", key, near);
    else
        wf_yaml_error(y, place, "'%.60s' is not in 'sources'", key);
}

/* Every source key that the values of a struct name. */
static void sources_of_rows(struct wf_yaml *y, const struct wf_species *sp, const struct wf_yaml_row *r,
                            const void *base, const char *path)
{
    char place[160];
    for (; r->key; r++) {
        if (r->table != &wf_value_table) continue;
        const struct wf_value *v = (const void *)((const char *)base + r->offset);
        (void)snprintf(place, sizeof place, "%s.%s.source", path, r->key);
        source_exists(y, sp, v->source, place);
    }
}

void wf_species_finish(struct wf_yaml *y, void *species)
{
    const struct wf_species *sp = species;
    char path[64], place[96];
    for (size_t i = 0; i < sp->levels; i++) {
        (void)snprintf(path, sizeof path, "levels[%zu]", i);
        sources_of_rows(y, sp, wf_level_rows, &sp->level[i], path);
        (void)snprintf(place, sizeof place, "%s.wall.source", path);
        source_exists(y, sp, sp->level[i].wall_note.source, place);
    }
    sources_of_rows(y, sp, wf_crown_rows, sp, "crown");
    const struct wf_streamlining *s = &sp->streamlining;
    source_exists(y, sp, s->exponent.source, "crown.streamlining.exponent.source");
    if (s->source != s->exponent.source) source_exists(y, sp, s->source, "crown.streamlining.source");
}

enum wf_status wf_species_read(const char *path, struct wf_arena *a, struct wf_species *out,
                               struct wf_diag *d, struct wf_err *e)
{
    *out = (struct wf_species){ .file = wf_arena_text(a, path) };
    if (!out->file) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    return wf_yaml_read(path, &wf_species_table, out, a, d, e);
}

char *wf_species_schema(struct wf_arena *a, struct wf_err *e)
{
    return wf_yaml_schema(&wf_species_table, a, e);
}

const struct wf_level *wf_species_level(const struct wf_species *sp, int32_t level)
{
    size_t k = level < 0 ? 0 : (size_t)level;
    return &sp->level[k < sp->levels ? k : sp->levels - 1];
}

const struct wf_level *wf_species_wood(const struct wf_species *sp, int32_t order, double radius)
{
    const struct wf_level *v = wf_species_level(sp, order);
    while (v > sp->level && v->radius.given && radius > v->radius.high) v--;
    return v;
}
