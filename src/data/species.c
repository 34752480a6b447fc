/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The species table: its rows, the checks between its keys, and functions that look values up. */
#include "data/species.h"
#include "base/num.h"
#include "base/text.h"
#include "base/units.h"
#include "data/bark.h"
#include "data/law_schema.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

const char *wf_species_source(const struct wf_species *sp, const char *key)
{
    for (size_t i = 0; key && i < sp->sources; i++)
        if (!strcmp(sp->source[i].key, key)) return sp->source[i].text;
    return NULL;
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

/* Shear modulus along the grain when it was not measured. E/G of the species in Forest Products Laboratory
 * 2010 (Wood Handbook, FPL-GTR-190, Table 5-1, 12 % moisture) lies between 7 (cherry) and 27 (balsa) for the
 * two planes along the grain; 16 is near the middle. Bending hardly depends on it, torsion does. */
static const double modulus_ratio = 16.0;

/* Shear strength when it was not measured, over the modulus of rupture: ash branches broke in torsion at 11.2
 * MPa and in bending at 75.5 MPa (Arboriculture & Urban Forestry 40(1):36, 2014). */
static const double shear_ratio = 0.15;

/* A value that follows from another one of the table. */
static struct wf_value derived(const struct wf_value *v, double ratio, const char *note)
{
    return (struct wf_value){ .value = v->value * ratio,
                              .low = v->low * ratio,
                              .high = v->high * ratio,
                              .standing = WF_ASSUMED,
                              .note = note };
}

static void level_finish(struct wf_yaml *y, void *level)
{
    struct wf_level *l = level;
    (void)y;
    if (!l->shear_modulus.given)
        l->shear_modulus = derived(&l->youngs_modulus, 1.0 / modulus_ratio, "a sixteenth of Young's modulus");
    if (!l->shear_strength.given && l->modulus_of_rupture.given)
        l->shear_strength = derived(&l->modulus_of_rupture, shear_ratio, "0.15 times the modulus of rupture");
}

static void wall_finish(struct wf_yaml *y, void *level)
{
    const struct wf_level *l = level;
    wf_yaml_ascending(y, "at", l->wall.s ? l->wall.n : 0, l->wall.s);
    wf_value_needs_source(y, l->wall_note.standing);
}

#define WALL(member)                                                                                         \
    .offset = offsetof(struct wf_level, wall.member), .count = offsetof(struct wf_level, wall.n)
#define WALL_NOTE(member) .offset = offsetof(struct wf_level, wall_note.member)
static const struct wf_yaml_row wall_rows[] = {
    { .key = "at",
      .kind = WF_YAML_QUANTITIES,
      .required = true,
      .low = 0,
      .high = 1,
      WALL(s),
      .doc = "Relative positions along the axis, 0 = base, 1 = tip, ascending.",
      .example = "[0, 0.3, 1]" },
    { .key = "share",
      .kind = WF_YAML_QUANTITIES,
      .required = true,
      .low = 1e-3,
      .high = 0.999,
      .same_length_as = "at",
      WALL(v),
      .doc =
          "Wall thickness over the local outer radius at these positions; linear between, constant outside.",
      .example = "[0.2, 0.2, 0.24]" },
    { .key = "status",
      .kind = WF_YAML_ENUM,
      .initial = "assumed",
      .choices = wf_standing_words,
      WALL_NOTE(standing),
      .doc = "As for a value." },
    { .key = "source",
      .kind = WF_YAML_NAME,
      .absent = "allowed for an assumed wall only",
      WALL_NOTE(source),
      .doc = "A key of 'sources'." },
    { .key = "note",
      .kind = WF_YAML_TEXT,
      .absent = "no note",
      WALL_NOTE(note),
      .doc = "Conditions of the measurement, reasons of an assumption." },
    { .key = NULL },
};
static const struct wf_yaml_table wall_table = {
    .title = "a hollow section", .row = wall_rows, .finish = wall_finish, .doc = ""
};

/* A value: its key in the table and the column of a tree it goes to. */
struct property_row {
    struct wf_yaml_row yaml; /* offset: of the struct wf_value in its struct wf_level or wf_species */
    enum wf_acts acts;
    const char *was; /* as in struct wf_property; NULL: the key */
    size_t column;   /* of struct wf_tree; 0: none. Rows with one column follow each other           */
    bool factor;     /* multiplies what the row before put there                                     */
    bool on_links;   /* set on links too; else 0 there                                               */
    bool optional;   /* not given: `absent` goes to the column, as where a value follows from no other */
    double absent;
};

#define LEVEL(k, dim, u, from, to, ...)                                                                      \
    .yaml = { .key = #k,                                                                                     \
              WF_VALUE_ROW(struct wf_level, k),                                                              \
              .dimension = dim,                                                                              \
              .unit = u,                                                                                     \
              .low = from,                                                                                   \
              .high = to,                                                                                    \
              __VA_ARGS__ }
#define COLUMN(member) .column = offsetof(struct wf_tree, member)
#define ABSENT(number) .optional = true, .absent = number
static const struct property_row level_values[] = {
    { LEVEL(youngs_modulus, WF_DIM_PRESSURE, "GPa", 1e6, 200e9, .required = true,
            .doc = "Young's modulus along the grain, green.", .example = "10 GPa"),
      COLUMN(youngs), .on_links = true },
    { LEVEL(shear_modulus, WF_DIM_PRESSURE, "GPa", 1e5, 100e9, .absent = "youngs_modulus / 16, assumed",
            .doc = "Shear modulus in planes along the grain, green.", .example = "0.6 GPa"),
      COLUMN(shear), .on_links = true },
    { LEVEL(density, WF_DIM_DENSITY, "kg/m3", 50, 4000, .required = true,
            .doc = "Mass of the living axis, water included, per volume of its wall.",
            .example = "900 kg/m3"),
      COLUMN(density) },
    { LEVEL(modulus_of_rupture, WF_DIM_PRESSURE, "MPa", 1e5, 2e9, .absent = "no breakage check of this level",
            .doc = "Bending strength along the grain, green, of clear wood.", .example = "60 MPa"),
      .acts = WF_ACTS_GIVEN, COLUMN(strength), ABSENT(0) },
    { LEVEL(compressive_strength, WF_DIM_PRESSURE, "MPa", 1e5, 2e9,
            .absent = "the elastic limit of this level is not assessed",
            .doc = "Strength in compression along the grain, green.", .example = "25 MPa"),
      .acts = WF_ACTS_GIVEN, COLUMN(compressive), ABSENT(0) },
    { LEVEL(shear_strength, WF_DIM_PRESSURE, "MPa", 1e4, 2e9, .absent = "0.15 modulus_of_rupture, assumed",
            .doc = "Strength in shear along the grain, green.", .example = "6 MPa"),
      COLUMN(shearing) },
    { LEVEL(tangential_strength, WF_DIM_PRESSURE, "MPa", 1e4, 2e9,
            .absent = "splitting of hollow sections is not assessed",
            .doc = "Strength in tension across the grain, along the rings, green.", .example = "2.5 MPa"),
      .acts = WF_ACTS_GIVEN, COLUMN(tangential), ABSENT(0) },
    { LEVEL(tangential_modulus, WF_DIM_PRESSURE, "GPa", 1e5, 100e9,
            .absent = "ovalisation of hollow sections is not assessed",
            .doc = "Young's modulus across the grain, along the rings, green.", .example = "0.4 GPa"),
      .acts = WF_ACTS_GIVEN, COLUMN(transverse), ABSENT(0) },
    { LEVEL(poisson_lt, WF_DIM_NONE, NULL, 0, 0.99, .initial = "0", .absent = "0, on the safe side",
            .doc = "Poisson's ratio: strain along the rings by stress along the grain.", .example = "0.4"),
      .acts = WF_ACTS_GIVEN },
    { LEVEL(poisson_tl, WF_DIM_NONE, NULL, 0, 0.99, .initial = "0", .absent = "0, on the safe side",
            .doc = "Poisson's ratio: strain along the grain by stress along the rings.", .example = "0.03"),
      .acts = WF_ACTS_GIVEN },
    { LEVEL(radius, WF_DIM_LENGTH, "mm", 1e-5, 5, .required = true,
            .doc = "Typical outer radius at the base of the axis.", .example = "50 mm"),
      .acts = WF_ACTS_SIZE },
    { LEVEL(damping_ratio, WF_DIM_NONE, NULL, 0, 1, .initial = "0", .absent = "0, undamped",
            .doc = "Internal damping as a share of critical.", .example = "0.03"),
      .acts = WF_ACTS_MOTION, COLUMN(damping), .on_links = true },
    { LEVEL(knot_factor, WF_DIM_NONE, NULL, 0.01, 1, .initial = "1",
            .doc = "Bending strength of the axis over that of clear wood.", .example = "0.85"),
      .acts = WF_ACTS_GIVEN, COLUMN(strength), .factor = true },
    { LEVEL(drag_coefficient, WF_DIM_NONE, NULL, 0, 3, .absent = "a rough cylinder's, by Reynolds number",
            .doc = "Drag coefficient of the bare axis in cross-flow on its diameter.", .example = "1.2"),
      .acts = WF_ACTS_GIVEN, COLUMN(drag), ABSENT(NAN) },
    { LEVEL(lift_coefficient, WF_DIM_NONE, NULL, -3, 3, .initial = "0",
            .doc = "Coefficient of the force across wind and axis, defined as the drag coefficient.",
            .example = "0.1"),
      .acts = WF_ACTS_GIVEN, COLUMN(lift) },
    { .yaml.key = NULL },
};

#define CROWN(k, ...)                                                                                        \
    .yaml = { .key = #k, WF_VALUE_ROW(struct wf_species, crown.k), .required = true, __VA_ARGS__ }
#define LEAF(k, dim, u, from, to, without, ...)                                                              \
    .yaml = { .key = #k,                                                                                     \
              WF_VALUE_ROW(struct wf_species, crown.k),                                                      \
              .dimension = dim,                                                                              \
              .unit = u,                                                                                     \
              .low = from,                                                                                   \
              .high = to,                                                                                    \
              .absent = without,                                                                             \
              __VA_ARGS__ }
static const struct property_row crown_values[] = {
    { CROWN(drag_coefficient, .low = 0, .high = 3,
            .doc = "Drag coefficient of the crown on its frontal area in still air.", .example = "0.5"),
      .was = "crown_drag_coefficient" },
    { CROWN(leaf_mass_per_area, .dimension = WF_DIM_MASS_PER_AREA, .unit = "kg/m2", .low = 1e-3, .high = 5,
            .doc = "Fresh leaf mass per one-sided leaf area.", .example = "0.2 kg/m2") },
    { CROWN(frontal_share, .low = 0, .high = 1,
            .doc = "Frontal area of the crown in still air over its one-sided leaf area.", .example = "0.3"),
      .was = "leaf_frontal_share" },
    { LEAF(leaf_area, WF_DIM_AREA, "cm2", 1e-6, 2, "leaf as long as windfirm rain takes it",
           .doc = "One-sided area of a typical leaf; its mass follows from leaf_mass_per_area.",
           .example = "28 cm2"),
      .acts = WF_ACTS_DROPS },
    { LEAF(leaf_contact_angle, WF_DIM_ANGLE, "deg", 0.01, 3.14, "60 deg, assumed by windfirm rain",
           .doc = "Contact angle of water on the upper side of the leaf.", .example = "100 deg"),
      .acts = WF_ACTS_DROPS },
    { LEAF(petiole_length, WF_DIM_LENGTH, "mm", 5e-4, 1, "3 cm, assumed by windfirm rain",
           .doc = "Length of the petiole.", .example = "40 mm"),
      .acts = WF_ACTS_DROPS },
    { LEAF(petiole_diameter, WF_DIM_LENGTH, "mm", 1e-4, 0.05, "1.6 mm, assumed by windfirm rain",
           .doc = "Mean diameter of the petiole.", .example = "1.6 mm"),
      .acts = WF_ACTS_DROPS },
    { LEAF(petiole_modulus, WF_DIM_PRESSURE, "GPa", 1e6, 2e10, "0.5 GPa, assumed by windfirm rain",
           .doc = "Young's modulus of the petiole along its axis, green.", .example = "0.5 GPa"),
      .acts = WF_ACTS_DROPS },
    { .yaml.key = NULL },
};

static const struct wf_value *value_of(const struct property_row *r, const void *holder)
{
    return (const void *)((const char *)holder + r->yaml.offset);
}

/* The i-th property of the rows. Returned: false after the last. */
static bool property_at(const struct property_row *rows, size_t i, const void *holder,
                        struct wf_property *out)
{
    for (size_t k = 0; k <= i; k++)
        if (!rows[k].yaml.key) return false;
    *out = (struct wf_property){ .key = rows[i].yaml.key,
                                 .dimension = rows[i].yaml.dimension,
                                 .unit = rows[i].yaml.unit ? rows[i].yaml.unit : "",
                                 .acts = rows[i].acts,
                                 .was = rows[i].was ? rows[i].was : rows[i].yaml.key,
                                 .value = value_of(&rows[i], holder) };
    return true;
}

bool wf_level_property(const struct wf_level *l, size_t i, struct wf_property *out)
{
    return property_at(level_values, i, l, out);
}

bool wf_crown_property(const struct wf_species *sp, size_t i, struct wf_property *out)
{
    return property_at(crown_values, i, sp, out);
}

bool wf_law_property(const struct wf_law *law, const struct wf_law_use *use, size_t i,
                     struct wf_property *out)
{
    for (size_t k = 0, seen = 0, n = wf_law_count(law); k < n; k++) {
        const struct wf_law_parameter *p = &law->parameter[k];
        if (p->kind != WF_LAW_VALUE || seen++ != i) continue;
        *out = (struct wf_property){ .key = p->name,
                                     .dimension = p->dimension,
                                     .unit = p->unit ? p->unit : "",
                                     .value = &use->parameter[k],
                                     .was = p->result };
        return true;
    }
    return false;
}

void wf_level_onto(const struct wf_level *l, struct wf_tree *t, size_t i, bool link)
{
    for (const struct property_row *r = level_values; r->yaml.key; r++) {
        if (!r->column) continue;
        const struct wf_value *v = value_of(r, l);
        double *column = *(double **)(void *)((char *)t + r->column);
        if (r->factor)
            column[i] *= v->value > 0 ? v->value : 1;
        else if (link && !r->on_links)
            column[i] = 0;
        else
            column[i] = (r->optional && !v->given) || isnan(v->value) ? r->absent : v->value;
    }
    t->transverse[i] /= 1 - l->poisson_lt.value * l->poisson_tl.value;
}

#define TEXT(k, member) .key = k, .kind = WF_YAML_TEXT, .offset = offsetof(struct wf_species, member)
static const struct wf_yaml_row species_rows[] = {
    { .key = "species",
      .kind = WF_YAML_NAME,
      .required = true,
      .offset = offsetof(struct wf_species, key),
      .doc = "Key of the table, as its file's name.",
      .example = "moso_bamboo" },
    { TEXT("name", name), .required = true, .doc = "English name.", .example = "Moso bamboo" },
    { TEXT("name_zh", name_zh), .absent = "no Chinese name", .doc = "Chinese name.", .example = "毛竹" },
    { TEXT("latin", latin), .absent = "no Latin name", .doc = "Latin name.",
      .example = "Phyllostachys edulis" },
    { .key = "names",
      .kind = WF_YAML_WORDS,
      .offset = offsetof(struct wf_species, alias),
      .count = offsetof(struct wf_species, aliases),
      .absent = "no further names",
      .doc = "Further names of the species in any language: common names, Latin synonyms. Each finds the "
             "table, as do its "
             "key and its other names.",
      .example = "[Mao bamboo, Phyllostachys pubescens, 孟宗竹]" },
    { .key = "preset",
      .kind = WF_YAML_NAME,
      .initial = "corrected",
      .offset = offsetof(struct wf_species, preset),
      .doc = "corrected: physical values; else the paper whose printed values the table keeps.",
      .example = "feng1999" },
    { TEXT("note", note), .absent = "no note", .doc = "What a user of the table should know." },
    { .key = "sources",
      .kind = WF_YAML_TEXTS,
      .absent = "no source; every value is then an assumption",
      .offset = offsetof(struct wf_species, source),
      .count = offsetof(struct wf_species, sources),
      .doc = "Full citations by key; values refer to the keys.",
      .example = "{tang2012: \"Tang L. et al. 2012. Trans. Chin. Soc. Agric. Mach. 43(1):165-168\"}" },
    { .key = "bark",
      .kind = WF_YAML_TABLE,
      .table = &wf_bark_table,
      .offset = offsetof(struct wf_species, bark),
      .given = 1 + offsetof(struct wf_species, bark.given),
      .absent = "not known; the radii of a measured tree are then taken as wood",
      .doc = "Thickness of the bark of the stem." },
    { .key = "levels",
      .kind = WF_YAML_LIST,
      .required = true,
      .offset = offsetof(struct wf_species, level),
      .count = offsetof(struct wf_species, levels),
      .doc = "Material and section by branching level, the stem first." },
    { .key = "crown",
      .kind = WF_YAML_TABLE,
      .absent = "no leaves; a model with leaves is then refused",
      .doc = "Drag and mass of the leaves." },
    { .key = NULL },
};
/* Where there is only one law of axis drag there is nothing to choose, and no key. */
static const struct wf_yaml_row axis_drag_row = { .key = "axis_drag",
                                                  .kind = WF_YAML_TABLE,
                                                  .offset = offsetof(struct wf_species, axis_drag),
                                                  .absent = "the first law",
                                                  .doc = "Drag law of axes without a drag_coefficient." };

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

/* Every source key that the values of a level or the crown name. */
static void sources_of_rows(struct wf_yaml *y, const struct wf_species *sp, const struct property_row *r,
                            const void *holder, const char *path)
{
    char place[160];
    for (; r->yaml.key; r++) {
        (void)snprintf(place, sizeof place, "%s.%s.source", path, r->yaml.key);
        source_exists(y, sp, value_of(r, holder)->source, place);
    }
}

static void sources_of_law(struct wf_yaml *y, const struct wf_species *sp, const struct wf_law_use *u,
                           const char *path)
{
    char place[160];
    const struct wf_law *owner;
    const struct wf_law_parameter *p;
    for (size_t k = 0; (p = wf_law_key(u->from, k, &owner)); k++) {
        (void)snprintf(place, sizeof place, "%s.%s.source", path, p->name);
        source_exists(y, sp, u->parameter[k].source, place);
    }
    (void)snprintf(place, sizeof place, "%s.source", path);
    if (u->source != wf_law_source(u)) source_exists(y, sp, u->source, place);
}

static void species_finish(struct wf_yaml *y, void *species)
{
    struct wf_species *sp = species;
    char path[64], place[96];
    for (size_t i = 0; i < sp->levels; i++) {
        (void)snprintf(path, sizeof path, "levels[%zu]", i);
        sources_of_rows(y, sp, level_values, &sp->level[i], path);
        (void)snprintf(place, sizeof place, "%s.wall.source", path);
        source_exists(y, sp, sp->level[i].wall_note.source, place);
    }
    sources_of_rows(y, sp, crown_values, sp, "crown");
    source_exists(y, sp, sp->bark.share.source, "bark.share.source");
    sources_of_law(y, sp, &sp->streamlining, "crown.streamlining");
    sources_of_law(y, sp, &sp->axis_drag, "axis_drag");
    wf_law_settle(&sp->streamlining);
    wf_law_settle(&sp->axis_drag);
}

static const struct wf_yaml_row level_name = { .key = "name",
                                               .kind = WF_YAML_NAME,
                                               .required = true,
                                               .offset = offsetof(struct wf_level, name),
                                               .doc = "Name of the level.",
                                               .example = "branch" };
static const struct wf_yaml_row level_wall = { .key = "wall",
                                               .kind = WF_YAML_TABLE,
                                               .table = &wall_table,
                                               .given = 1 + offsetof(struct wf_level, wall_note.given),
                                               .absent = "a solid section",
                                               .doc = "Hollow section." };
static const struct wf_yaml_row crown_law = { .key = "streamlining",
                                              .kind = WF_YAML_TABLE,
                                              .offset = offsetof(struct wf_species, streamlining),
                                              .absent = "law none, a rigid crown",
                                              .doc = "How the crown's drag area shrinks in the wind." };

/* The table with the rows of the values and the keys of the laws given. */
struct species_schema {
    struct wf_law_schema streamlining, axis_drag;
    struct wf_yaml_row level[WF_COUNT(level_values) + 2], crown[WF_COUNT(crown_values) + 1];
    struct wf_yaml_row species[WF_COUNT(species_rows) + 1];
    struct wf_yaml_table level_table, crown_table, table;
};

static size_t copy_values(struct wf_yaml_row *to, const struct property_row *from)
{
    size_t n = 0;
    while (from[n].yaml.key) to[n] = from[n].yaml, n++;
    return n;
}

/* The tables of a level and of the crown. */
static void part_schemas(struct species_schema *s)
{
    s->level[0] = level_name;
    size_t n = 1 + copy_values(s->level + 1, level_values);
    s->level[n] = level_wall;
    s->level_table = (struct wf_yaml_table){ .title = "a branching level",
                                             .row = s->level,
                                             .size = sizeof(struct wf_level),
                                             .finish = level_finish,
                                             .doc = "" };
    n = copy_values(s->crown, crown_values);
    s->crown[n] = crown_law;
    s->crown[n].table = &s->streamlining.table;
    s->crown_table = (struct wf_yaml_table){ .title = "a crown", .row = s->crown, .doc = "" };
}

const struct wf_yaml_table *wf_species_table(const struct wf_laws *laws, struct wf_arena *a)
{
    static const struct wf_yaml_row none[] = { { .key = NULL } };
    struct species_schema *s = WF_TAKE(a, 1, struct species_schema);
    if (!s ||
        !wf_law_schema_make(laws->streamlining, "a streamlining law", wf_law_ranges, a, &s->streamlining) ||
        !wf_law_schema_make(laws->axis_drag, "a drag law", none, a, &s->axis_drag))
        return NULL;
    part_schemas(s);
    size_t n = wf_law_copy_rows(s->species, species_rows);
    s->species[n - 2].table = &s->level_table;
    s->species[n - 1].table = &s->crown_table;
    if (wf_law_row(laws->axis_drag, 1)) {
        s->species[n] = axis_drag_row;
        s->species[n].table = &s->axis_drag.table;
    }
    s->table = (struct wf_yaml_table){
        .title = "a species table",
        .row = s->species,
        .size = sizeof(struct wf_species),
        .finish = species_finish,
        .doc = "A species table (YAML): the material and section of every branching level and the drag of "
               "the crown. Quantities carry their units. A complete example: "
               "species/moso_bamboo.yaml.",
    };
    return &s->table;
}

enum wf_status wf_species_read(const char *path, const struct wf_laws *laws, struct wf_arena *a,
                               struct wf_species *out, struct wf_diag *d, struct wf_err *e)
{
    const struct wf_yaml_table *table = wf_species_table(laws, a);
    *out = (struct wf_species){ .file = wf_arena_text(a, path) };
    if (!out->file || !table) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    out->streamlining.from = laws->streamlining;
    out->axis_drag = (struct wf_law_use){ .from = laws->axis_drag, .low = NAN, .high = NAN };
    return wf_yaml_read(path, table, out, a, d, e);
}

/* ---- Leaves in winter ---- */

/* Genera of conifers. */
static const struct {
    const char *name;
    bool sheds; /* its needles in autumn */
} conifers[] = {
    { "Abies ", false },         { "Araucaria ", false },   { "Cedrus ", false },
    { "Chamaecyparis ", false }, { "Cryptomeria ", false }, { "Cupressus ", false },
    { "Cunninghamia ", false },  { "Juniperus ", false },   { "Larix ", true },
    { "Metasequoia ", true },    { "Picea ", false },       { "Pinus ", false },
    { "Pseudotsuga ", false },   { "Sequoia ", false },     { "Sequoiadendron ", false },
    { "Taxodium ", true },       { "Taxus ", false },       { "Thuja ", false },
    { "Tsuga ", false },
};

/* Its place in the list; WF_COUNT(conifers): it is none. */
static size_t conifer_of(const char *latin)
{
    size_t k = 0;
    while (k < WF_COUNT(conifers) &&
           (!latin || strncmp(latin, conifers[k].name, strlen(conifers[k].name)) != 0))
        k++;
    return k;
}

bool wf_species_is_conifer(const char *latin) { return conifer_of(latin) < WF_COUNT(conifers); }

bool wf_species_is_evergreen(const struct wf_species *sp)
{
    size_t k = conifer_of(sp->latin);
    if (k < WF_COUNT(conifers)) return !conifers[k].sheds;
    bool gum = sp->latin && !strncmp(sp->latin, "Eucalyptus ", 11);
    return gum || (sp->levels && sp->level[0].wall.n); /* bamboos */
}
