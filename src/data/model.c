/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/model.h"
#include "base/num.h"
#include "base/yaml.h"
#include "data/branching.h"
#include "data/crown_mass.h"
#include "data/species.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Stems whose section is not round, and what hangs on them, piece by piece. */

#define T struct wf_stem_section

static const struct wf_yaml_row stem_section_rows[] = {
    WF_KEY_LENGTH("at", at, "m", 0, 150,
                  "Distance from the base along the stem; the first is 0, the last the stem's height.",
                  .required = true, .example = "1.34 m"),
    WF_KEY_ENUM(
        "shape", shape, wf_section_words,
        "Of the solid section: ellipse, rectangle, isosceles triangle either way up. Between two places "
        "width and height are linear, and the properties of two shapes are mixed in proportion.",
        .required = true, .example = "rectangle"),
    WF_KEY_LENGTH("width", width, "mm", 1e-5, 10, "Horizontal where the stem leans and is not turned.",
                  .required = true, .example = "32.9 mm"),
    WF_KEY_LENGTH("height", height, "mm", 1e-5, 10, "Across the width.", .required = true,
                  .example = "30.3 mm"),
    { .key = NULL },
};

static const struct wf_yaml_table stem_section_table = {
    .title = "a section", .row = stem_section_rows, .size = sizeof(struct wf_stem_section), .doc = ""
};

#undef T
#define T struct wf_stem_mass

static const struct wf_yaml_row stem_mass_rows[] = {
    WF_KEY_LENGTH("to", to, "m", 1e-3, 150,
                  "Where the piece ends, from the base along the stem; it begins at the base or where the "
                  "one before ends. The last ends at the stem's height.",
                  .required = true, .example = "1.34 m"),
    WF_KEY_QUANTITY("own", own, WF_DIM_MASS, "kg", 0, 1e5,
                    "Of the stem itself over the piece, spread as its section's area.",
                    .absent = "by the species' density", .example = "1.3 kg"),
    WF_KEY_QUANTITY("left", left, WF_DIM_MASS, "kg", 0, 1e5,
                    "Of what hangs on its left, seen from the base; spread evenly.", .initial = "0 kg",
                    .example = "0.165 kg"),
    WF_KEY_QUANTITY("right", right, WF_DIM_MASS, "kg", 0, 1e5, "The same on its right.", .initial = "0 kg",
                    .example = "0.134 kg"),
    WF_KEY_LENGTH(
        "lever", lever, "mm", 0, 10,
        "Distance along the width at which left and right hang from the axis; it turns with the section.",
        .initial = "0 mm", .example = "60 mm"),
    { .key = NULL },
};

static const struct wf_yaml_table stem_mass_table = {
    .title = "a piece's masses", .row = stem_mass_rows, .size = sizeof(struct wf_stem_mass), .doc = ""
};

#undef T
#define T struct wf_model

/* The stem. */

static const char *const tapers[] = { "table", "linear", "power", NULL }; /* in the order of enum wf_taper */

static const struct wf_yaml_row stem_taper_rows[] = {
    WF_KEY_ENUM("law", taper, tapers,
                "Outer radius over base radius at relative height s: linear: 1 - (1 - t) s; power: t + (1 - "
                "t) (1 - s)^p; table: linear between the heights given; t = tip_share, p = power.",
                .required = true, .example = "linear"),
    WF_KEY_NUMBER("tip_share", tip_ratio, 1e-3, 1.5, "Radius at the tip over that at the base.",
                  .absent = "needed by laws linear and power, refused by table", .example = "0.2"),
    WF_KEY_NUMBER("power", power, 0.1, 5, "Exponent: 1 is a cone, 0.5 a paraboloid, 1.5 a neiloid.",
                  .absent = "needed by law power, refused by the others", .example = "0.7"),
    WF_KEY_NUMBERS("at", profile.s, profile.n, 0, 1, "Relative heights, ascending from 0 to 1.",
                   .absent = "needed by law table, refused by the others", .example = "[0, 0.1, 1]"),
    WF_KEY_NUMBERS("share", profile.v, profile.n, 1e-3, 1.5,
                   "Radius over base radius at these heights, 1 at the base.", .same_length_as = "at",
                   .absent = "needed by law table, refused by the others", .example = "[1, 0.95, 0.19]"),
    { .key = NULL },
};

/* Check a key that some taper laws use: those laws need it, the others refuse it. */
static void check_taper_key(struct wf_yaml *y, const char *key, bool used, const char *law)
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
    check_taper_key(y, "tip_share", !table, law);
    check_taper_key(y, "power", power, law);
    check_taper_key(y, "at", table, law);
    check_taper_key(y, "share", table, law);
    const struct wf_along *p = &m->profile;
    if (!table || !p->s || !p->n) return;
    wf_yaml_ascending(y, "at", p->n, p->s);
    if (p->s[0] > 0 || p->s[p->n - 1] < 1)
        wf_yaml_error(y, "at", "runs from %g to %g; it must cover the stem from 0 to 1", p->s[0],
                      p->s[p->n - 1]);
    if (p->v && fabs(p->v[0] - 1) > 1e-9)
        wf_yaml_error(y, "share[0]", "is %g; shares are of the base radius, so the first is 1", p->v[0]);
}

static const struct wf_yaml_table stem_taper_table = {
    .title = "a taper", .row = stem_taper_rows, .finish = taper_finish, .doc = ""
};

static const struct wf_yaml_row model_stem_rows[] = {
    WF_KEY_LENGTH("height", height, "m", 0.01, 150, "Length of the stem from ground to tip.",
                  .required = true, .example = "14 m"),
    WF_KEY_LENGTH("base_radius", radius, "mm", 1e-4, 10, "Outer radius at the ground.",
                  .absent = "radius of the species' first level", .example = "52.5 mm"),
    WF_KEY_PART("taper", stem_taper_table, "Outer radius along the stem.",
                .absent = "needed unless 'sections' are given", .example = "{law: linear, tip_share: 0.19}"),
    WF_KEY_LIST("sections", section, sections, stem_section_table,
                "Solid sections that are not round, from base to tip; generator stem, for calibration.",
                .absent = "round, by base_radius and taper"),
    WF_KEY_ANGLE("turn", turn, -1, 1,
                 "Turn of the sections about the axis, right-handed from base to tip. Without it the height "
                 "is measured in the plane of the lean, towards the stem's upper side.",
                 .initial = "0 deg", .example = "4 deg"),
    WF_KEY_LIST("masses", mass, masses, stem_mass_table,
                "Masses of the stem and of what hangs to its sides, piece by piece; with sections.",
                .absent = "by the species' density, no hanging masses"),
    WF_KEY_INTEGER(
        "segments", segments, 1, 20000,
        "Equal rows the stem is cut into; a row also ends at every kink of shape, wall and crown. An "
        "analysis needs about 5 kB each.",
        .initial = "40", .example = "40"),
    WF_KEY_ANGLE("lean", lean, 0, 0.25, "Angle of the straight stem from the vertical.", .initial = "0 deg",
                 .example = "10 deg"),
    WF_KEY_ANGLE("lean_azimuth", lean_azimuth, -1, 1,
                 "Direction of the lean in the ground plane, from +x towards +y. By default the wind blows "
                 "towards +x.",
                 .initial = "0 deg", .example = "90 deg"),
    WF_KEY_PART("curve", wf_curve_table,
                "The angle between successive segments of the stem; generator levels. An upright stem droops "
                "towards the lean's azimuth.",
                .absent = "straight", .offset = offsetof(T, curve)),
    { .key = NULL },
};

static const struct wf_yaml_table model_stem_table = { .title = "a stem", .row = model_stem_rows, .doc = "" };

/* The crown of a stem without branches. */

static const struct wf_yaml_row crown_shape_rows[] = {
    WF_KEY_NUMBERS("at", crown_shape.s, crown_shape.n, 0, 1,
                   "Relative heights in the crown, 0 = its base, 1 = its top, ascending.", .required = true,
                   .example = "[0, 0.4, 1]"),
    WF_KEY_NUMBERS("share", crown_shape.v, crown_shape.n, 0, 1e6,
                   "Leaf area per length at these heights, in any measure: only the proportions count; "
                   "linear between, constant outside.",
                   .same_length_as = "at", .required = true, .example = "[0.2, 1, 0.3]"),
    { .key = NULL },
};

static void crown_shape_finish(struct wf_yaml *y, void *model)
{
    const struct wf_along *s = &((struct wf_model *)model)->crown_shape;
    wf_yaml_ascending(y, "at", s->s ? s->n : 0, s->s);
    double sum = 0;
    for (size_t i = 0; s->v && i < s->n; i++) sum += s->v[i];
    if (s->v && sum <= 0) wf_yaml_error(y, "share", "is 0 everywhere; the leaves must be somewhere");
}

static const struct wf_yaml_table crown_shape_table = {
    .title = "a crown shape", .row = crown_shape_rows, .finish = crown_shape_finish, .doc = ""
};

static const struct wf_yaml_row model_crown_rows[] = {
    WF_KEY_LENGTH("base", crown_base, "m", 0, 150, "Where the crown begins, along the stem.",
                  .required = true, .example = "5.5 m"),
    WF_KEY_LENGTH("top", crown_top, "m", 0, 150, "Where the crown ends, along the stem.",
                  .absent = "the height of the stem", .example = "14 m"),
    WF_KEY_QUANTITY("leaf_area", leaf_area, WF_DIM_AREA, "m2", 0, 1e4,
                    "One-sided leaf area of the whole crown; 0 without leaves.",
                    .absent = "needed unless the model's frontal area is given", .example = "17 m2"),
    WF_KEY_PART("shape", crown_shape_table, "How the leaf area is spread over the crown.",
                .absent = "the same leaf area at every height",
                .example = "{at: [0, 0.4, 1], share: [0.2, 1, 0.3]}"),
    { .key = NULL },
};

static const struct wf_yaml_table model_crown_table = { .title = "a crown",
                                                        .row = model_crown_rows,
                                                        .doc = "" };

/* The crown as it is measured from the side. */

const char *const wf_crown_form_words[] = {
    "ellipse", "triangle", "diamond", "paraboloid", "rectangle", NULL
};

const char *wf_silhouette_wrong(const struct wf_silhouette *s, const char **why)
{
    bool area = s->area > 0, wide = s->width > 0, deep = s->depth > 0;
    *why = "is not used beside crown_outline; give one of frontal_area, crown_width with crown_depth, and "
           "crown_outline";
    if (s->points && (area || wide || deep))
        return area ? "frontal_area" : wide ? "crown_width" : "crown_depth";
    *why = "is not used beside frontal_area; give one of frontal_area and crown_width with crown_depth";
    if (area && (wide || deep)) return wide ? "crown_width" : "crown_depth";
    *why = wide ? "needs crown_depth: the frontal area follows from both"
                : "needs crown_width: the frontal area follows from both";
    if (wide != deep) return wide ? "crown_width" : "crown_depth";
    *why = "is not used beside crown_mass";
    if (s->mass > 0 && s->density > 0) return "crown_density";
    *why = "is not used beside crown_mass or crown_density";
    if (s->by && (s->mass > 0 || s->density > 0)) return "crown_mass_by";
    *why = "needs crown_width and crown_depth or an outline: it is of their cone";
    return s->density > 0 && !wide && !s->points ? "crown_density" : NULL;
}

#define OUTLINE(k, member, from, text)                                                                       \
    WF_KEY(k, WF_YAML_QUANTITIES, silhouette.member, text, .count = offsetof(T, silhouette.points),          \
           .dimension = WF_DIM_LENGTH, .unit = "m", .low = from, .high = 1000, .required = true)
static const struct wf_yaml_row outline_rows[] = {
    OUTLINE("x", x, -1000, "Sideways positions of the points in order around the crown."),
    WF_KEY("z", WF_YAML_QUANTITIES, silhouette.z, "Their heights above the ground.",
           .count = offsetof(T, silhouette.points), .dimension = WF_DIM_LENGTH, .unit = "m", .low = 0,
           .high = 1000, .same_length_as = "x", .required = true),
    { .key = NULL },
};
static const struct wf_yaml_table outline_table = { .title = "an outline", .row = outline_rows, .doc = "" };

/* The model as a whole: its keys, and the checks between them. */

const char *const wf_generator_words[] = { "stem", "levels", "ifs", NULL, "measured" };
static const char *const shapes[] = { "stress_free", "under_weight", NULL };
static const char *const scanned_words[] = { "as_season", "leaf_on", "leaf_off", NULL };
static const char *const seasons[] = { "leaf_on", "leaf_off", NULL };

static const struct wf_yaml_row model_rows[] = {
    WF_KEY_NAME("model", key, "Key of the model, as its file's name.", .required = true,
                .example = "moso_culm"),
    WF_KEY_TEXT("name", name, "Readable name.", .required = true, .example = "Moso bamboo culm, 14 m"),
    WF_KEY_TEXT("note", note, "What a user of the model should know.", .absent = "no note"),
    WF_KEY_TEXT("source", source, "Where the dimensions come from.", .absent = "no source"),
    WF_KEY_ENUM("generator", generator, wf_generator_words,
                "stem: a stem with a crown spread along it; levels: a stem and its branches, level by level; "
                "ifs: an iterated function system, copies of the stem on the stem and so on.",
                .initial = "stem", .example = "levels"),
    WF_KEY_INTEGER("seed", seed, 0, 999999999999999,
                   "Of all random spread: the same seed gives the same tree.", .initial = "1",
                   .example = "1"),
    WF_KEY_ENUM("season", season, seasons,
                "leaf_off: the leaves have fallen; neither their drag nor their mass acts.",
                .initial = "leaf_on", .example = "leaf_off"),
    WF_KEY_ENUM(
        "shape", shape, shapes,
        "Which state the model describes. under_weight: the shape in still air under its own weight, whose "
        "internal forces are those of the weight in this shape: without wind the tree has the shape given.",
        .initial = "stress_free", .example = "under_weight"),
    WF_KEY_ENUM(
        "scanned", scanned, scanned_words,
        "With shape under_weight: whether the tree had its leaves when its shape was drawn or measured. "
        "as_season: as it has them now.",
        .initial = "as_season", .example = "leaf_off"),
    WF_KEY_PART("stem", model_stem_table, "The stem.", .required = true),
    WF_KEY_PART("crown", model_crown_table, "The leaves along the stem; generator stem.",
                .absent = "no leaves"),
    WF_KEY_QUANTITY("frontal_area", silhouette.area, WF_DIM_AREA, "m2", 1e-3, 1e4,
                    "Area of the crown in leaf, seen from the side in still air; the wind's load is on it.",
                    .absent = "by the leaf area and the species' frontal share", .example = "24 m2"),
    WF_KEY_LENGTH("crown_width", silhouette.width, "m", 0.01, 100,
                  "Width of the crown; with its depth and form in place of frontal_area.",
                  .absent = "not given", .example = "6 m"),
    WF_KEY_LENGTH("crown_depth", silhouette.depth, "m", 0.01, 150,
                  "Height of the crown from its base to the top of the tree.", .absent = "not given",
                  .example = "8 m"),
    WF_KEY_ENUM("crown_form", silhouette.form, wf_crown_form_words,
                "Share of the rectangle of width and depth: ellipse 0.785; triangle, widest at the base, and "
                "diamond 0.5; paraboloid 0.667; rectangle 1.",
                .initial = "ellipse", .example = "triangle"),
    WF_KEY_PART("crown_outline", outline_table,
                "The crown's outline as points of a photograph, in place of frontal_area. It must not cross "
                "itself.",
                .absent = "not given", .example = "{x: [-2 m, 2 m, 0 m], z: [4 m, 4 m, 12 m]}"),
    WF_KEY_QUANTITY("crown_mass", silhouette.mass, WF_DIM_MASS, "kg", 1e-6, 1e6,
                    "Fresh mass of branches and leaves of a stem without branches, in place of the leaves'.",
                    .absent = "of the leaves alone", .example = "120 kg"),
    WF_KEY_QUANTITY("crown_density", silhouette.density, WF_DIM_DENSITY, "kg/m3", 1e-3, 100,
                    "The same per volume of the cone of crown_width and crown_depth. ForestGALES: 2.5 most "
                    "conifers, 1.22 birch, 1.38 beech and oak.",
                    .absent = "not given", .example = "2.5 kg/m3"),
    WF_KEY_TEXT(
        "crown_mass_by", silhouette.by,
        "The same by a rule: forestgales, mass per volume of the cone, or wcc, by the diameter at 1.3 m; "
        "with the kind of the species, or as RULE:KIND.",
        .absent = "not given", .example = "forestgales"),
    WF_KEY_NUMBER("leaf_off_share", silhouette.leafless, 0, 1,
                  "Share of the crown's load that is left in the season leaf_off.",
                  .absent = "0.5 without branches, else 0: the axes drawn have their own drag",
                  .example = "0.4"),
    WF_KEY_TEXT(
        "bark", bark_said,
        "Bark on the stem, whose radii are over bark: a thickness at 1.3 m, or 'species' for the law of the "
        "species. It is mass and surface, without stiffness or strength.",
        .absent = "none: the radii are of wood", .example = "15 mm"),
    WF_KEY_LIST("cavities", cavity, cavities, wf_cavity_table, "Cavities of the stem.",
                .absent = "a sound stem"),
    WF_KEY_LIST("branches", branching, branchings, wf_branching_table,
                "The branching levels above the stem: first the branches on the stem, then those on them.",
                .absent = "needed by generator levels, refused by the others"),
    WF_KEY_PART("ifs", wf_ifs_table, "The iterated function system.",
                .absent = "needed by generator ifs, refused by the others", .offset = offsetof(T, ifs)),
    WF_KEY_PART("leaves", wf_foliage_table, "The leaves of a branched tree; generators levels and ifs.",
                .absent = "no leaves", .offset = offsetof(T, foliage)),
    { .key = NULL },
};

/* Check the end of item i of a list along the stem: the places ascend, and the last is the stem's tip. */
static void check_piece(struct wf_yaml *y, const char *list, const char *key, size_t i, size_t n,
                        double before, double here, double height)
{
    char place[64];
    (void)snprintf(place, sizeof place, "stem.%s[%zu].%s", list, i, key);
    if (here <= before) wf_yaml_error(y, place, "%g m does not lie beyond the %g m before", here, before);
    if (i + 1 == n && fabs(here - height) > 1e-6 * height)
        wf_yaml_error(y, place, "the last ends at %g m, the stem at %g m", here, height);
}

static void check_stem(struct wf_yaml *y, struct wf_model *m)
{
    bool flat = wf_yaml_has(y, "stem.sections");
    static const char *const round[] = { "stem.taper", "stem.base_radius", "crown", "bark", "cavities" };
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
            check_piece(y, "sections", "at", i, m->sections, m->section[i - 1].at, m->section[i].at,
                        m->height);
        else if (m->section[0].at > 0)
            wf_yaml_error(y, "stem.sections[0].at", "%g m; the first section is at 0", m->section[0].at);
    }
    for (size_t i = 0; m->mass && i < m->masses; i++)
        check_piece(y, "masses", "to", i, m->masses, i ? m->mass[i - 1].to : 0, m->mass[i].to, m->height);
}

/* Check the crown of generator stem and set its defaults. */
static void check_crown(struct wf_yaml *y, struct wf_model *m)
{
    if (!wf_yaml_has(y, "crown")) {
        m->leaf_area = 0;
        return;
    }
    if (m->crown_top > m->height)
        wf_yaml_error(y, "crown.top", "%g m is above the stem's height %g m", m->crown_top, m->height);
    if (isnan(m->crown_top)) m->crown_top = m->height;
    if (isnan(m->leaf_area)) {
        bool seen = wf_yaml_has(y, "frontal_area") || wf_yaml_has(y, "crown_width") ||
                    wf_yaml_has(y, "crown_outline");
        if (!seen && !wf_yaml_has(y, "crown.leaf_area"))
            wf_yaml_error(y, "crown", "needs the key 'leaf_area', or the model 'frontal_area'");
        m->leaf_area = 0;
    }
    if (m->crown_base >= m->crown_top)
        wf_yaml_error(y, "crown.base", "%g m is not below the crown's top %g m", m->crown_base, m->crown_top);
}

/* Check that keys are given which the generator needs, and none that it does not use. */
static void check_generator_keys(struct wf_yaml *y, const struct wf_model *m)
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

/* Check levels that follow the pipe model: their radii are computed from the tips down, after all branches
 * have grown, so the radius law of a branch on them cannot refer to the parent's radius. */
static void check_pipes(struct wf_yaml *y, const struct wf_model *m)
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

void wf_model_set_season(struct wf_model *m, enum wf_season season)
{
    m->season = season;
    m->leaf_area = season == WF_LEAF_ON ? m->leaf_area_on : 0;
}

static void model_finish(struct wf_yaml *y, void *model)
{
    struct wf_model *m = model;
    check_generator_keys(y, m);
    check_stem(y, m);
    check_pipes(y, m);
    if (m->generator == WF_GENERATOR_STEM)
        check_crown(y, m);
    else
        m->leaf_area = wf_yaml_has(y, "leaves") ? m->foliage.area : 0;
    m->leaf_area_on = m->leaf_area;
    wf_model_set_season(m, m->season);
    struct wf_err bad = { 0 };
    if (m->bark_said && !wf_bark_read(m->bark_said, &m->bark, &bad)) wf_yaml_error(y, "bark", "%s", bad.text);
    const char *why, *wrong = wf_silhouette_wrong(&m->silhouette, &why);
    if (wrong) wf_yaml_error(y, wrong, "%s", why);
    struct wf_err e = { WF_OK, "" };
    if (m->silhouette.by && wf_crown_rule_check(m->silhouette.by, &e))
        wf_yaml_error(y, "crown_mass_by", "%s", e.text);
}

const struct wf_yaml_table wf_model_table = {
    .title = "a tree model",
    .row = model_rows,
    .size = sizeof(struct wf_model),
    .finish = model_finish,
    .doc = "A tree model (YAML): the outer shape and the leaves of a tree, to be combined with the materials "
           "of a species table. Quantities carry their units. A complete example: models/moso_culm.yaml.",
};

/* Properties of a model. */

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

double wf_model_rise(const struct wf_model *m) { return m->height * cos(m->lean); }

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
    enum wf_status s = wf_yaml_read(path, &wf_model_table, out, a, d, e);
    return s ? s : wf_cavities_settle(path, out->cavity, out->cavities, a, d, e);
}
