/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Species tables: what is read, and every mistake by name. */
#include "close.h"
#include "base/yaml.h"
#include "data/species.h"
#include "edited.h"
#include "load/drag.h"
#include "load/load.h"

static const char good[] =
    "species: moso\n"
    "name: Moso bamboo\n"
    "latin: Phyllostachys edulis\n"
    "sources:\n"
    "  tang2012: \"Tang L. et al. 2012\"\n"
    "  wang: Wang 2010\n"
    "levels:\n"
    "  - name: culm\n"
    "    youngs_modulus: {value: 10 GPa, low: 8 GPa, high: 14 GPa, status: measured, source: tang2012}\n"
    "    density: 900 kg/m3\n"
    "    modulus_of_rupture: {value: 60 MPa, status: handbook, source: wang, note: wet}\n"
    "    radius: 5 cm\n"
    "    knot_factor: 85 %\n"
    "    wall: {at: [0, 0.5, 1], share: [0.2, 0.2, 0.3], status: measured, source: wang}\n"
    "  - name: branch\n"
    "    youngs_modulus: 4 GPa\n"
    "    shear_modulus: 0.3 GPa\n"
    "    density: 800 kg/m3\n"
    "    radius: 8 mm\n"
    "    drag_coefficient: 1.1\n"
    "crown:\n"
    "  drag_coefficient: 0.5\n"
    "  leaf_mass_per_area: {value: 0.2 kg/m2, low: 150 g/m2}\n"
    "  frontal_share: 0.3\n"
    "  streamlining: {law: vogel, exponent: {value: -0.7, status: borrowed, source: wang},\n"
    "    reference_speed: 18 km/h, valid_from: 4 m/s, valid_to: 20 m/s}\n";

struct reading {
    struct wf_species species;
    struct wf_diag diag;
    struct wf_err err;
    enum wf_status status;
    char findings[2048];
};

static void read_text(const char *text, struct wf_arena *a, struct reading *r)
{
    struct scratch s;
    memset(r, 0, sizeof *r);
    r->diag.arena = a;
    scratch_write(&s, text, strlen(text));
    r->status = wf_species_read(s.path, &wf_laws, a, &r->species, &r->diag, &r->err);
    findings_print(&r->diag, r->findings, sizeof r->findings);
    scratch_remove(&s);
}

static void assert_value(const struct wf_value *v, double value, double low, double high, enum wf_standing s,
                         bool given)
{
    assert_close(v->value, value, 1e-15);
    assert_close(v->low, low, 1e-15);
    assert_close(v->high, high, 1e-15);
    assert_int_equal(v->standing, s);
    assert_int_equal(v->given, given);
}

static void a_table_is_read_in_si(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(good, &a, &r);
    assert_string_equal(r.findings, "");
    assert_int_equal(r.status, WF_OK);
    const struct wf_species *s = &r.species;
    assert_string_equal(s->key, "moso");
    assert_string_equal(s->preset, "corrected");
    assert_null(s->name_zh);
    assert_non_null(s->file);
    assert_int_equal(s->sources, 2);
    assert_string_equal(wf_species_source(s, "tang2012"), "Tang L. et al. 2012");
    assert_null(wf_species_source(s, "nobody"));
    assert_null(wf_species_source(s, NULL));
    assert_int_equal(s->levels, 2);
    const struct wf_level *l = s->level;
    assert_value(&l->youngs_modulus, 10e9, 8e9, 14e9, WF_MEASURED, true);
    assert_string_equal(l->youngs_modulus.source, "tang2012");
    assert_value(&l->shear_modulus, 10e9 / 16, 8e9 / 16, 14e9 / 16, WF_ASSUMED, false);
    assert_value(&l->density, 900, 900, 900, WF_ASSUMED, true);
    assert_null(l->density.source);
    assert_value(&l->modulus_of_rupture, 60e6, 60e6, 60e6, WF_HANDBOOK, true);
    assert_string_equal(l->modulus_of_rupture.note, "wet");
    assert_value(&l->radius, 0.05, 0.05, 0.05, WF_ASSUMED, true);
    assert_value(&l->knot_factor, 0.85, 0.85, 0.85, WF_ASSUMED, true);
    assert_value(&l->damping_ratio, 0, 0, 0, WF_ASSUMED, false);
    assert_value(&l->lift_coefficient, 0, 0, 0, WF_ASSUMED, false);
    assert_true(isnan(l->drag_coefficient.value) && !l->drag_coefficient.given);
    assert_int_equal(l->wall.n, 3);
    assert_close(wf_along_at(&l->wall, 0.75, 1), 0.25, 1e-15);
    assert_int_equal(l->wall_note.standing, WF_MEASURED);
    assert_true(l->wall_note.given);
    assert_int_equal(l[1].wall.n, 0);
    assert_true(!l[1].wall_note.given);
    assert_value(&l[1].shear_modulus, 0.3e9, 0.3e9, 0.3e9, WF_ASSUMED, true);
    assert_value(&l[1].knot_factor, 1, 1, 1, WF_ASSUMED, false);
    assert_true(isnan(l[1].modulus_of_rupture.value) && !l[1].modulus_of_rupture.given);
    assert_close(l[1].drag_coefficient.value, 1.1, 0);
    assert_value(&s->crown.leaf_mass_per_area, 0.2, 0.15, 0.2, WF_ASSUMED, true);
    assert_close(s->crown.frontal_share.value, 0.3, 0);
    const struct wf_law_use *m = &s->streamlining;
    assert_string_equal(m->law, "vogel");
    assert_value(&m->parameter[0], -0.7, -0.7, -0.7, WF_BORROWED, true);
    assert_string_equal(m->source, "wang");
    assert_close(m->parameter[1].value, 5, 1e-15);
    assert_close(m->high, 20, 0);
    wf_arena_free(&a);
}

static void a_table_law_and_no_crown_are_read(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    const struct edit table = {
        "{law: vogel, exponent: {value: -0.7, status: borrowed, source: wang},\n    reference_speed: 18 "
        "km/h,",
        "{law: table, speed: [4 m/s, 72 km/h], share: [1, 28 %], status: measured, source: wang,\n   ", ""
    };
    char *text = edited(good, &table);
    read_text(text, &a, &r);
    free(text);
    assert_string_equal(r.findings, "");
    const struct wf_law_use *m = &r.species.streamlining;
    assert_string_equal(m->law, "table");
    assert_int_equal(r.species.streamlining.standing, WF_MEASURED);
    assert_close(wf_along_at(&(struct wf_along){ m->list[0].n, m->list[0].v, m->list[1].v }, 12, 1), 0.64,
                 1e-15);
    wf_arena_free(&a);

    char *bare = strdup(good);
    *strstr(bare, "crown:") = '\0';
    read_text(bare, &a, &r);
    free(bare);
    assert_int_equal(r.status, WF_OK);
    assert_string_equal(r.species.streamlining.law, "none");
    assert_true(!r.species.crown.drag_coefficient.given && isnan(r.species.crown.drag_coefficient.value));
    assert_true(isnan(r.species.streamlining.low));
    wf_arena_free(&a);
}

static const struct edit mistakes[] = {
    { "species: moso\n", "",
      "1:1: missing key 'species' (Key of the table, as its file's name.); for example 'species: "
      "moso_bamboo'" },
    { "name: Moso bamboo\n", "", "1:1: missing key 'name' (English name.); for example 'name: Moso bamboo'" },
    { "levels:", "lvels:",
      "1:1: missing key 'levels' (Material and section by branching level, the stem first.)\n7:1: unknown "
      "key 'lvels'; did you mean 'levels'?" },
    { "    density: 900 kg/m3\n", "",
      "8:5: levels[0]: missing key 'density' (Mass of the living axis, water included, per volume of its "
      "wall.); for example 'density: 900 kg/m3'" },
    { "    youngs_modulus: 4 GPa\n", "",
      "15:5: levels[1]: missing key 'youngs_modulus' (Young's modulus along the grain, green.); for example "
      "'youngs_modulus: 10 GPa'" },
    { "    radius: 8 mm\n", "",
      "15:5: levels[1]: missing key 'radius' (Typical outer radius at the base of the axis.); for example "
      "'radius: 50 mm'" },
    { "- name: culm\n    youngs", "- youngs",
      "8:5: levels[0]: missing key 'name' (Name of the level.); for example 'name: branch'" },
    { "density: 900 kg/m3", "densty: 900 kg/m3",
      "8:5: levels[0]: missing key 'density' (Mass of the living axis, water included, per volume of its "
      "wall.); for example 'density: 900 kg/m3'\n10:5: levels[0]: unknown key 'densty'; did you mean "
      "'density'?" },
    { "900 kg/m3", "9000 kg/m3", "10:14: levels[0].density: 9000 kg/m3 is outside 50 kg/m3 to 4000 kg/m3" },
    { "900 kg/m3", "0.9", "10:14: levels[0].density: '0.9' has no unit; write for example '0.9 kg/m3'" },
    { "900 kg/m3", "[900 kg/m3]",
      "10:14: levels[0].density: a mapping (keys with values) is expected, not a list" },
    { "900 kg/m3", "{low: 800 kg/m3}",
      "10:14: levels[0].density: missing key 'value' (The value that is used.)" },
    { "900 kg/m3", "{value: 900 kg/m3, low: 30 kg/m3}",
      "10:38: levels[0].density.low: 30 kg/m3 is outside 50 kg/m3 to 4000 kg/m3" },
    { "youngs_modulus: 4 GPa", "youngs_modulus: 400 GPa",
      "16:21: levels[1].youngs_modulus: 400 GPa is outside 0.001 GPa to 200 GPa" },
    { "youngs_modulus: 4 GPa", "youngs_modulus: 4 Gpa",
      "16:21: levels[1].youngs_modulus: '4 Gpa': 'Gpa' is not a known unit for a pressure (stress, modulus); "
      "use one of: GPa, MPa, Pa, N/mm2" },
    { "low: 8 GPa", "low: 12 GPa", "9:42: levels[0].youngs_modulus.low: 12 GPa is above the value 10 GPa" },
    { "high: 14 GPa", "high: 9 GPa", "9:55: levels[0].youngs_modulus.high: 9 GPa is below the value 10 GPa" },
    { "status: measured, source: tang2012}", "status: measured}",
      "9:71: levels[0].youngs_modulus.status: a value that is 'measured' needs a source: a key of "
      "'sources'" },
    { "status: measured, source: tang2012}", "status: measure, source: tang2012}",
      "9:71: levels[0].youngs_modulus.status: 'measure' is not one of: assumed, borrowed, handbook, "
      "measured, printed; did you mean 'measured'?" },
    { "source: tang2012}", "source: tang2010}",
      "9:89: levels[0].youngs_modulus.source: 'tang2010' is not in 'sources'; did you mean 'tang2012'?" },
    { "source: wang, note", "source: feng1999, note",
      "11:67: levels[0].modulus_of_rupture.source: 'feng1999' is not in 'sources'" },
    { "handbook, source: wang, note: wet", "handbook, note: wet",
      "11:49: levels[0].modulus_of_rupture.status: a value that is 'handbook' needs a source: a key of "
      "'sources'" },
    { "60 MPa", "60 GPa",
      "11:33: levels[0].modulus_of_rupture.value: 60 GPa is outside 0.1 MPa to 2000 MPa" },
    { "5 cm", "50", "12:13: levels[0].radius: '50' has no unit; write for example '50 mm'" },
    { "5 cm", "50 m", "12:13: levels[0].radius: 50 m is outside 0.01 mm to 5000 mm" },
    { "85 %", "1.2", "13:18: levels[0].knot_factor: 1.2 is outside 0.01 to 1" },
    { "85 %", "85 %\n    tangential_strength: {value: 2 MPa, low: 3 MPa}",
      "14:46: levels[0].tangential_strength.low: 3 MPa is above the value 2 MPa" },
    { "85 %", "85 %\n    tangential_strength: {value: 2 MPa, high: 1 MPa}",
      "14:47: levels[0].tangential_strength.high: 1 MPa is below the value 2 MPa" },
    { "85 %", "85 %\n    compressive_strength: -20 MPa",
      "14:27: levels[0].compressive_strength: -20 MPa is outside 0.1 MPa to 2000 MPa" },
    { "85 %", "85 %\n    shear_strength: 0 MPa",
      "14:21: levels[0].shear_strength: 0 MPa is outside 0.01 MPa to 2000 MPa" },
    { "85 %", "85 %\n    poisson_lt: 1.5", "14:17: levels[0].poisson_lt: 1.5 is outside 0 to 0.99" },
    { "85 %", "85 %\n    damping_ratio: 2", "14:20: levels[0].damping_ratio: 2 is outside 0 to 1" },
    { "85 %", "85 %\n    lift_coefficient: 5", "14:23: levels[0].lift_coefficient: 5 is outside -3 to 3" },
    { "0.3 GPa", "0.3 m",
      "17:20: levels[1].shear_modulus: '0.3 m': 'm' is not a unit of a pressure (stress, modulus); use one "
      "of: GPa, MPa, Pa, N/mm2" },
    { "drag_coefficient: 1.1", "drag_coefficient: 11",
      "20:23: levels[1].drag_coefficient: 11 is outside 0 to 3" },
    { "[0, 0.5, 1]", "[0, 0.5]", "14:33: levels[0].wall.share: 3 values, but 'at' has 2" },
    { "[0, 0.5, 1]", "[0, 0.5, 0.5]", "14:16: levels[0].wall.at: 0.5 follows 0.5; the values must ascend" },
    { "[0, 0.5, 1]", "[0, 0.5, 1.5]", "14:25: levels[0].wall.at[2]: 1.5 is outside 0 to 1" },
    { "[0.2, 0.2, 0.3]", "[0.2, 0, 0.3]", "14:42: levels[0].wall.share[1]: 0 is outside 0.001 to 0.999" },
    { "[0.2, 0.2, 0.3]", "[0.2, 1, 0.3]", "14:42: levels[0].wall.share[1]: 1 is outside 0.001 to 0.999" },
    { "at: [0, 0.5, 1], ", "",
      "14:11: levels[0].wall: missing key 'at' (Relative positions along the axis, 0 = base, 1 = tip, "
      "ascending.); for example 'at: [0, 0.3, 1]'" },
    { "share: [0.2, 0.2, 0.3], ", "",
      "14:11: levels[0].wall: missing key 'share' (Wall thickness over the local outer radius at these "
      "positions; linear between, constant outside.); for example 'share: [0.2, 0.2, 0.24]'" },
    { "0.3], status: measured, source: wang}", "0.3], status: measured}",
      "14:61: levels[0].wall.status: a table that is 'measured' needs a source: a key of 'sources'" },
    { "0.3], status: measured, source: wang}", "0.3], status: measured, source: wong}",
      "14:79: levels[0].wall.source: 'wong' is not in 'sources'; did you mean 'wang'?" },
    { "wall: {at", "wall: 9 mm # {at",
      "14:11: levels[0].wall: a mapping (keys with values) is expected, not a single value" },
    { "  drag_coefficient: 0.5\n", "",
      "22:3: crown: missing key 'drag_coefficient' (Drag coefficient of the crown on its frontal area in "
      "still air.); for example 'drag_coefficient: 0.5'" },
    { "  leaf_mass_per_area: {value: 0.2 kg/m2, low: 150 g/m2}\n", "",
      "22:3: crown: missing key 'leaf_mass_per_area' (Fresh leaf mass per one-sided leaf area.); for example "
      "'leaf_mass_per_area: 0.2 kg/m2'" },
    { "  frontal_share: 0.3\n", "",
      "22:3: crown: missing key 'frontal_share' (Frontal area of the crown in still air over its one-sided "
      "leaf area.); for example 'frontal_share: 0.3'" },
    { "frontal_share: 0.3", "frontal_share: 130 %", "24:18: crown.frontal_share: 130 % is outside 0 to 1" },
    { "drag_coefficient: 0.5", "drag_coefficient: {value: 0.5, source: feng}",
      "22:42: crown.drag_coefficient.source: 'feng' is not in 'sources'" },
    { "law: vogel", "law: vogle",
      "25:23: crown.streamlining.law: 'vogle' is not one of: none, vogel, table; did you mean 'vogel'?" },
    { "law: vogel, ", "",
      "25:17: crown.streamlining: missing key 'law' (none: a rigid crown; vogel: share = (U / "
      "reference_speed)^exponent above the reference speed, 1 below; table: a monotone cubic "
      "curve through the shares at the speeds given.); for example 'law: vogel'" },
    { "law: vogel", "law: none",
      "25:39: crown.streamlining.exponent: is for law 'vogel'; the law here is 'none'\n"
      "26:22: crown.streamlining.reference_speed: is for law 'vogel'; the law here is 'none'" },
    { "law: vogel", "law: table",
      "25:17: crown.streamlining: law 'table' needs the key 'speed'\n25:17: crown.streamlining: law 'table' "
      "needs the key 'share'\n25:40: crown.streamlining.exponent: is for law 'vogel'; the law here is "
      "'table'\n26:22: crown.streamlining.reference_speed: is for law 'vogel'; the law here is 'table'" },
    { "reference_speed: 18 km/h, ", "",
      "25:17: crown.streamlining: law 'vogel' needs the key 'reference_speed'" },
    { "reference_speed: 18 km/h", "reference_speed: 18",
      "26:22: crown.streamlining.reference_speed: '18' has no unit; write for example '18 m/s'" },
    { "valid_to: 20 m/s", "valid_to: 3 m/s",
      "26:60: crown.streamlining.valid_to: 3 m/s is not above valid_from 4 m/s" },
    { "valid_to: 20 m/s", "valid_to: 20 m/s, beyond: held",
      "26:76: crown.streamlining.beyond: 'held' is not one of: hold, extend; did you mean 'hold'?" },
    { "value: -0.7,", "value: 0.7,", "25:48: crown.streamlining.exponent.value: 0.7 is outside -2 to 0" },
    { "value: -0.7, status: borrowed, source: wang", "value: -0.7, status: borrowed",
      "25:62: crown.streamlining.exponent.status: a value that is 'borrowed' needs a source: a key of "
      "'sources'" },
    { "value: -0.7, status: borrowed, source: wang", "value: -0.7, status: borrowed, source: x",
      "25:80: crown.streamlining.exponent.source: 'x' is not in 'sources'" },
    { "valid_from: 4 m/s", "source: feng", "26:39: crown.streamlining.source: 'feng' is not in 'sources'" },
    { "  wang: Wang 2010\n", "  wang:\n", "6:8: sources.wang: a text is expected, not nothing" },
};

static void findings_of(const char *text, char *buf, size_t size)
{
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(text, &a, &r);
    assert_int_equal(r.status, WF_EINPUT);
    snprintf(buf, size, "%s", r.findings);
    wf_arena_free(&a);
}

static void every_mistake_is_named(void **state)
{
    (void)state;
    assert_mistakes_are_named(good, mistakes, sizeof mistakes / sizeof *mistakes, findings_of);
}

static void all_mistakes_of_a_file_come_at_once(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_species s;
    char text[4096];
    assert_int_equal(wf_species_read("tests/data/bad/species.yaml", &wf_laws, &a, &s, &d, &e), WF_EINPUT);
    findings_print(&d, text, sizeof text);
    assert_string_equal(
        text,
        "1:1: missing key 'name' (English name.); for example 'name: Moso bamboo'\n"
        "1:10: species: 'moso bamboo': a name has only letters a-z, digits, '_' and '-'\n"
        "2:1: unknown key 'nmae'; did you mean 'name'?\n"
        "5:5: levels[0]: missing key 'density' (Mass of the living axis, water included, per volume of its "
        "wall.); for example 'density: 900 kg/m3'\n"
        "6:29: levels[0].youngs_modulus.value: '10' has no unit; write for example '10 GPa'\n"
        "6:53: levels[0].youngs_modulus.status: a value that is 'measured' needs a source: a key of "
        "'sources'\n"
        "7:5: levels[0]: unknown key 'densty'; did you mean 'density'?\n"
        "8:13: levels[0].radius: '52.5' has no unit; write for example '52.5 mm'\n"
        "9:16: levels[0].wall.at: 0.5 follows 1; the values must ascend\n"
        "9:36: levels[0].wall.share: 2 values, but 'at' has 3\n"
        "11:60: crown.drag_coefficient.source: 'tang2021' is not in 'sources'; did you mean 'tang2012'?\n"
        "12:23: crown.leaf_mass_per_area: '0.2 kg/m3': 'kg/m3' is not a unit of a mass per area; use one of: "
        "kg/m2, g/m2\n"
        "13:18: crown.frontal_share: '.nan' is not a number; write for example '0.5'\n"
        "14:23: crown.streamlining.law: 'vogle' is not one of: none, vogel, table; did you mean 'vogel'?");
    assert_string_equal(e.text, "tests/data/bad/species.yaml: 14 mistakes");
    wf_arena_free(&a);
}

static void along_is_linear_between_and_constant_outside(void **state)
{
    (void)state;
    double s[] = { 0.2, 0.4, 0.8 }, v[] = { 1, 3, 2 };
    struct wf_along a = { 3, s, v }, none = { 0 };
    assert_close(wf_along_at(&a, 0, 9), 1, 0);
    assert_close(wf_along_at(&a, 0.2, 9), 1, 0);
    assert_close(wf_along_at(&a, 0.3, 9), 2, 1e-15);
    assert_close(wf_along_at(&a, 0.4, 9), 3, 0);
    assert_close(wf_along_at(&a, 0.7, 9), 2.25, 1e-15);
    assert_close(wf_along_at(&a, 5, 9), 2, 0);
    assert_close(wf_along_at(&none, 0.5, 9), 9, 0);
}

static void memory_is_refused_at_every_smaller_capacity(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_text(good, &a, &r);
    size_t need = a.used;
    wf_arena_free(&a);
    for (size_t limit = 1; limit <= need; limit += limit + 32 < need ? 31 : 1) {
        struct wf_arena small = { .limit = limit };
        read_text(good, &small, &r);
        assert_int_equal(r.status, limit < need ? WF_ENOMEM : WF_OK);
        wf_arena_free(&small);
    }
}

static void the_schema_is_printed(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    const char *text = wf_yaml_schema(wf_species_table(&wf_laws, &a), &a, &e);
    assert_non_null(text);
    static const char *const lines[] = { "  levels[].youngs_modulus  (required)\n",
                                         "  crown.streamlining.exponent\n",
                                         "0.001 GPa to 200 GPa",
                                         "if absent: youngs_modulus / 16, assumed",
                                         "\nvalue:\n",
                                         "  low\n" };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) assert_non_null(strstr(text, lines[i]));
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_is_read_in_si),
        cmocka_unit_test(a_table_law_and_no_crown_are_read),
        cmocka_unit_test(every_mistake_is_named),
        cmocka_unit_test(all_mistakes_of_a_file_come_at_once),
        cmocka_unit_test(along_is_linear_between_and_constant_outside),
        cmocka_unit_test(memory_is_refused_at_every_smaller_capacity),
        cmocka_unit_test(the_schema_is_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
