/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/model.h"
#include "base/num.h"
#include "base/yaml.h"
#include "data/branching.h"
#include "data/value.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void taper_finish(struct wf_yaml *y, void *model);

static void shape_finish(struct wf_yaml *y, void *model);

static void model_finish(struct wf_yaml *y, void *model);

/* The rows of a tree model; the checks between keys are in model.c. */

/* Stems whose section is not round, and what hangs on them, piece by piece. */

#define LENGTH(T, k, member, u, from, to)                                                                    \
    .key = k, .kind = WF_YAML_QUANTITY, .required = true, .offset = offsetof(T, member),                     \
    .dimension = WF_DIM_LENGTH, .unit = u, .low = from, .high = to
#define MASS(k, member)                                                                                      \
    .key = k, .kind = WF_YAML_QUANTITY, .offset = offsetof(struct wf_stem_mass, member),                     \
    .dimension = WF_DIM_MASS, .unit = "kg", .low = 0, .high = 1e5

static const struct wf_yaml_row section_rows[] = {
    { LENGTH(struct wf_stem_section, "at", at, "m", 0, 150),
      .doc = "Distance from the base along the stem; the first is 0, the last the stem's height.",
      .example = "1.34 m" },
    { .key = "shape",
      .kind = WF_YAML_ENUM,
      .required = true,
      .choices = wf_section_words,
      .offset = offsetof(struct wf_stem_section, shape),
      .doc = "Of the solid section: ellipse, rectangle, isosceles triangle either way up. Between two places "
             "width and height are linear, and the properties of two shapes are mixed in proportion.",
      .example = "rectangle" },
    { LENGTH(struct wf_stem_section, "width", width, "mm", 1e-5, 10),
      .doc = "Level where the stem leans and is not turned.", .example = "32.9 mm" },
    { LENGTH(struct wf_stem_section, "height", height, "mm", 1e-5, 10), .doc = "Across the width.",
      .example = "30.3 mm" },
    { .key = NULL },
};
static const struct wf_yaml_table stem_section_table = {
    .title = "a section", .row = section_rows, .size = sizeof(struct wf_stem_section), .doc = ""
};

static const struct wf_yaml_row mass_rows[] = {
    { LENGTH(struct wf_stem_mass, "to", to, "m", 1e-3, 150),
      .doc =
          "Where the piece ends, from the base along the stem; it begins at the base or where the one before "
          "ends. The last ends at the stem's height.",
      .example = "1.34 m" },
    { MASS("own", own), .absent = "by the species' density",
      .doc = "Of the stem itself over the piece, spread as its section's area.", .example = "1.3 kg" },
    { MASS("left", left), .initial = "0 kg",
      .doc = "Of what hangs on its left, seen from the base; spread evenly.", .example = "0.165 kg" },
    { MASS("right", right), .initial = "0 kg", .doc = "The same on its right.", .example = "0.134 kg" },
    { .key = "lever",
      .kind = WF_YAML_QUANTITY,
      .offset = offsetof(struct wf_stem_mass, lever),
      .dimension = WF_DIM_LENGTH,
      .unit = "mm",
      .low = 0,
      .high = 10,
      .initial = "0 mm",
      .doc =
          "Distance along the width at which left and right hang from the axis; it turns with the section.",
      .example = "60 mm" },
    { .key = NULL },
};
static const struct wf_yaml_table stem_mass_table = {
    .title = "a piece's masses", .row = mass_rows, .size = sizeof(struct wf_stem_mass), .doc = ""
};

/* Places ascend and the last is the stem's end. */
static void reaches(struct wf_yaml *y, const char *list, const char *key, size_t i, size_t n, double before,
                    double here, double height)
{
    char place[64];
    (void)snprintf(place, sizeof place, "stem.%s[%zu].%s", list, i, key);
    if (here <= before) wf_yaml_error(y, place, "%g m does not lie beyond the %g m before", here, before);
    if (i + 1 == n && fabs(here - height) > 1e-6 * height)
        wf_yaml_error(y, place, "the last ends at %g m, the stem at %g m", here, height);
}

static void stem_finish(struct wf_yaml *y, struct wf_model *m)
{
    bool flat = wf_yaml_has(y, "stem.sections");
    static const char *const round[] = { "stem.taper", "stem.base_radius", "crown" };
    static const char *const own[] = { "stem.turn", "stem.masses" };
    if (!flat && wf_yaml_has(y, "stem") && !wf_yaml_has(y, "stem.taper"))
        wf_yaml_error(
            y, "stem",
            "needs the key 'taper', for example 'taper: {law: linear, tip_share: 0.19}', or 'sections'");
    for (size_t k = 0; k < 2; k++)
        if (!flat && wf_yaml_has(y, own[k])) wf_yaml_error(y, own[k], "needs 'sections'");
    if (!flat) return;
    for (size_t k = 0; k < WF_COUNT(round); k++)
        if (wf_yaml_has(y, round[k])) wf_yaml_error(y, round[k], "is not used where 'sections' are given");
    if (m->generator != WF_GENERATOR_STEM) wf_yaml_error(y, "stem.sections", "needs 'generator: stem'");
    if (m->shape != WF_SHAPE_STRESS_FREE) wf_yaml_error(y, "shape", "sections need 'stress_free'");
    if (m->sections == 1) wf_yaml_error(y, "stem.sections", "needs the base and the tip at least");
    for (size_t i = 0; m->section && i < m->sections; i++) {
        if (i)
            reaches(y, "sections", "at", i, m->sections, m->section[i - 1].at, m->section[i].at, m->height);
        else if (m->section[0].at > 0)
            wf_yaml_error(y, "stem.sections[0].at", "%g m; the first section is at 0", m->section[0].at);
    }
    for (size_t i = 0; m->mass && i < m->masses; i++)
        reaches(y, "masses", "to", i, m->masses, i ? m->mass[i - 1].to : 0, m->mass[i].to, m->height);
}

#define AT(member) .offset = offsetof(struct wf_model, member)

const char *const wf_generator_words[] = { "stem", "levels", "ifs", NULL, "measured" };
static const char *const shapes[] = { "stress_free", "under_weight", NULL };
static const char *const seasons[] = { "leaf_on", "leaf_off", NULL };
static const char *const tapers[] = { "table", "linear", "power", NULL }; /* in the order of enum wf_taper */
static const struct wf_yaml_row taper_rows[] = {
    { .key = "law",
      .kind = WF_YAML_ENUM,
      .required = true,
      .choices = tapers,
      AT(taper),
      .doc = "Outer radius over base radius at relative height s: linear: 1 - (1 - t) s; power: t + (1 - t) "
             "(1 - s)^p; "
             "table: linear between the heights given; t = tip_share, p = power.",
      .example = "linear" },
    { .key = "tip_share",
      .kind = WF_YAML_QUANTITY,
      .low = 1e-3,
      .high = 1.5,
      AT(tip_ratio),
      .absent = "needed by laws linear and power, refused by table",
      .doc = "Radius at the tip over that at the base.",
      .example = "0.2" },
    { .key = "power",
      .kind = WF_YAML_QUANTITY,
      .low = 0.1,
      .high = 5,
      AT(power),
      .absent = "needed by law power, refused by the others",
      .doc = "Exponent: 1 is a cone, 0.5 a paraboloid, 1.5 a neiloid.",
      .example = "0.7" },
    { .key = "at",
      .kind = WF_YAML_QUANTITIES,
      .low = 0,
      .high = 1,
      AT(profile.s),
      .count = offsetof(struct wf_model, profile.n),
      .absent = "needed by law table, refused by the others",
      .doc = "Relative heights, ascending from 0 to 1.",
      .example = "[0, 0.1, 1]" },
    { .key = "share",
      .kind = WF_YAML_QUANTITIES,
      .low = 1e-3,
      .high = 1.5,
      .same_length_as = "at",
      AT(profile.v),
      .count = offsetof(struct wf_model, profile.n),
      .absent = "needed by law table, refused by the others",
      .doc = "Radius over base radius at these heights, 1 at the base.",
      .example = "[1, 0.95, 0.19]" },
    { .key = NULL },
};
static const struct wf_yaml_table taper_table = {
    .title = "a taper", .row = taper_rows, .finish = taper_finish, .doc = ""
};

static const struct wf_yaml_row stem_rows[] = {
    { .key = "height",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0.01,
      .high = 150,
      AT(height),
      .doc = "Length of the stem from ground to tip.",
      .example = "14 m" },
    { .key = "base_radius",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_LENGTH,
      .unit = "mm",
      .low = 1e-4,
      .high = 10,
      .absent = "radius of the species' first level",
      AT(radius),
      .doc = "Outer radius at the ground.",
      .example = "52.5 mm" },
    { .key = "taper",
      .kind = WF_YAML_TABLE,
      .table = &taper_table,
      .absent = "needed unless 'sections' are given",
      .doc = "Outer radius along the stem.",
      .example = "{law: linear, tip_share: 0.19}" },
    { .key = "sections",
      .kind = WF_YAML_LIST,
      .table = &stem_section_table,
      AT(section),
      .count = offsetof(struct wf_model, sections),
      .absent = "round, by base_radius and taper",
      .doc = "Solid sections that are not round, from base to tip; generator stem, for calibration." },
    { .key = "turn",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = -WF_TURN,
      .high = WF_TURN,
      .initial = "0 deg",
      AT(turn),
      .doc = "Turn of the sections about the axis, right-handed from base to tip. Without it the height is "
             "measured in the plane of the lean, towards the stem's upper side.",
      .example = "4 deg" },
    { .key = "masses",
      .kind = WF_YAML_LIST,
      .table = &stem_mass_table,
      AT(mass),
      .count = offsetof(struct wf_model, masses),
      .absent = "by the species' density, nothing hangs on it",
      .doc = "Masses of the stem and of what hangs to its sides, piece by piece; with sections." },
    { .key = "segments",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 100000,
      .initial = "40",
      AT(segments),
      .doc = "Equal rows the stem is cut into; a row also ends at every kink of shape, wall and crown.",
      .example = "40" },
    { .key = "lean",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = 0,
      .high = WF_TURN / 4,
      .initial = "0 deg",
      AT(lean),
      .doc = "Angle of the straight stem from the vertical.",
      .example = "10 deg" },
    { .key = "lean_azimuth",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = -WF_TURN,
      .high = WF_TURN,
      .initial = "0 deg",
      AT(lean_azimuth),
      .doc =
          "Direction of the lean in the ground plane, from +x towards +y. Wind blows towards +x unless told "
          "otherwise.",
      .example = "90 deg" },
    { .key = "curve",
      .kind = WF_YAML_TABLE,
      .table = &wf_curve_table,
      AT(curve),
      .absent = "straight",
      .doc = "The angle between successive segments of the stem; generator levels. An upright stem droops "
             "towards the lean's azimuth." },
    { .key = NULL },
};
static const struct wf_yaml_table stem_table = { .title = "a stem", .row = stem_rows, .doc = "" };

static const struct wf_yaml_row shape_rows[] = {
    { .key = "at",
      .kind = WF_YAML_QUANTITIES,
      .required = true,
      .low = 0,
      .high = 1,
      AT(crown_shape.s),
      .count = offsetof(struct wf_model, crown_shape.n),
      .doc = "Relative heights in the crown, 0 = its base, 1 = its top, ascending.",
      .example = "[0, 0.4, 1]" },
    { .key = "share",
      .kind = WF_YAML_QUANTITIES,
      .required = true,
      .low = 0,
      .high = 1e6,
      .same_length_as = "at",
      AT(crown_shape.v),
      .count = offsetof(struct wf_model, crown_shape.n),
      .doc = "Leaf area per length at these heights, in any measure: only the proportions count; linear "
             "between, "
             "constant outside.",
      .example = "[0.2, 1, 0.3]" },
    { .key = NULL },
};
static const struct wf_yaml_table shape_table = {
    .title = "a crown shape", .row = shape_rows, .finish = shape_finish, .doc = ""
};

static const struct wf_yaml_row crown_rows[] = {
    { .key = "base",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 150,
      AT(crown_base),
      .doc = "Where the crown begins, along the stem.",
      .example = "5.5 m" },
    { .key = "top",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 150,
      .absent = "the height of the stem",
      AT(crown_top),
      .doc = "Where the crown ends, along the stem.",
      .example = "14 m" },
    { .key = "leaf_area",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_AREA,
      .unit = "m2",
      .low = 0,
      .high = 1e4,
      AT(leaf_area),
      .doc = "One-sided leaf area of the whole crown; 0 without leaves.",
      .example = "17 m2" },
    { .key = "shape",
      .kind = WF_YAML_TABLE,
      .table = &shape_table,
      .absent = "the same leaf area at every height",
      .doc = "How the leaf area is spread over the crown.",
      .example = "{at: [0, 0.4, 1], share: [0.2, 1, 0.3]}" },
    { .key = NULL },
};
static const struct wf_yaml_table crown_table = { .title = "a crown", .row = crown_rows, .doc = "" };

#define TEXT(k, member) .key = k, .kind = WF_YAML_TEXT, AT(member)
static const struct wf_yaml_row model_rows[] = {
    { .key = "model",
      .kind = WF_YAML_NAME,
      .required = true,
      AT(key),
      .doc = "Key of the model, as its file's name.",
      .example = "moso_culm" },
    { TEXT("name", name), .required = true, .doc = "Name for people.", .example = "Moso bamboo culm, 14 m" },
    { TEXT("note", note), .absent = "no note", .doc = "What a user of the model should know." },
    { TEXT("source", source), .absent = "no source", .doc = "Where the dimensions come from." },
    { .key = "generator",
      .kind = WF_YAML_ENUM,
      .initial = "stem",
      .choices = wf_generator_words,
      AT(generator),
      .doc =
          "stem: a stem with a crown spread along it; levels: a stem and its branches, level by level; ifs: "
          "an iterated function system, copies of the stem on the stem and so on.",
      .example = "levels" },
    { .key = "seed",
      .kind = WF_YAML_INTEGER,
      .low = 0,
      .high = 999999999999999,
      .initial = "1",
      AT(seed),
      .doc = "Of all random spread: the same seed gives the same tree.",
      .example = "1" },
    { .key = "season",
      .kind = WF_YAML_ENUM,
      .initial = "leaf_on",
      .choices = seasons,
      AT(season),
      .doc = "leaf_off: the leaves have fallen; neither their sail nor their mass is there.",
      .example = "leaf_off" },
    { .key = "shape",
      .kind = WF_YAML_ENUM,
      .initial = "stress_free",
      .choices = shapes,
      AT(shape),
      .doc =
          "What the model draws. under_weight: the tree as it stands or hangs in still air; the stress-free "
          "shape from which its weight bends it there is computed, so that without wind it is as drawn.",
      .example = "under_weight" },
    { .key = "stem", .kind = WF_YAML_TABLE, .required = true, .table = &stem_table, .doc = "The stem." },
    { .key = "crown",
      .kind = WF_YAML_TABLE,
      .table = &crown_table,
      .absent = "no leaves",
      .doc = "The leaves along the stem; generator stem." },
    { .key = "branches",
      .kind = WF_YAML_LIST,
      .table = &wf_branching_table,
      AT(branching),
      .count = offsetof(struct wf_model, branchings),
      .absent = "needed by generator levels, refused by the others",
      .doc = "The branching levels above the stem: first the branches on the stem, then those on them." },
    { .key = "ifs",
      .kind = WF_YAML_TABLE,
      .table = &wf_ifs_table,
      AT(ifs),
      .absent = "needed by generator ifs, refused by the others",
      .doc = "The iterated function system." },
    { .key = "leaves",
      .kind = WF_YAML_TABLE,
      .table = &wf_foliage_table,
      AT(foliage),
      .absent = "no leaves",
      .doc = "The leaves of a branched tree; generators levels and ifs." },
    { .key = NULL },
};
const struct wf_yaml_table wf_model_table = {
    .title = "a tree model",
    .row = model_rows,
    .size = sizeof(struct wf_model),
    .finish = model_finish,
    .doc = "A tree model (YAML): the outer shape and the leaves of a tree, to be clothed with the materials "
           "of a "
           "species table. Quantities carry their units. A whole model to start from: models/moso_culm.yaml.",
};

/* Keys of one taper law: needed by it, refused by a law that does not use them. */
static void key_of_taper(struct wf_yaml *y, const char *key, bool used, const char *law)
{
    bool has = wf_yaml_has(y, key);
    if (used && !has) wf_yaml_error(y, "", "law '%s' needs the key '%s'", law, key);
    if (!used && has) wf_yaml_error(y, key, "is not used by law '%s'", law);
}

static void taper_finish(struct wf_yaml *y, void *model)
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

static void shape_finish(struct wf_yaml *y, void *model)
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
    for (size_t i = 0; i < WF_COUNT(rows); i++) {
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

static void model_finish(struct wf_yaml *y, void *model)
{
    struct wf_model *m = model;
    keys_of_generator(y, m);
    stem_finish(y, m);
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
