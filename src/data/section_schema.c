/* Stems whose section is not round, and what hangs on them, piece by piece. */
#include "data/model.h"
#include "data/model_schema.h"
#include "data/value.h"
#include <math.h>
#include <stdio.h>

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
const struct wf_yaml_table wf_stem_section_table = {
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
    { MASS("left", left), .preset = "0 kg",
      .doc = "Of what hangs on its left, seen from the base; spread evenly.", .example = "0.165 kg" },
    { MASS("right", right), .preset = "0 kg", .doc = "The same on its right.", .example = "0.134 kg" },
    { .key = "lever",
      .kind = WF_YAML_QUANTITY,
      .offset = offsetof(struct wf_stem_mass, lever),
      .dimension = WF_DIM_LENGTH,
      .unit = "mm",
      .low = 0,
      .high = 10,
      .preset = "0 mm",
      .doc =
          "Distance along the width at which left and right hang from the axis; it turns with the section.",
      .example = "60 mm" },
    { .key = NULL },
};
const struct wf_yaml_table wf_stem_mass_table = {
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

void wf_stem_finish(struct wf_yaml *y, struct wf_model *m)
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
    for (size_t k = 0; k < sizeof round / sizeof *round; k++)
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
