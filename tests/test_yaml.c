/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The YAML reader under a small schema that has every kind of row. */
#include "base/yaml.h"
#include "close.h"
#include "edited.h"

struct part {
    const char *name;
    double mass;
    bool has_mass;
};
struct thing {
    const char *name, *title, *law;
    unsigned colour;
    double height, share, angle;
    size_t count, notes, parts, sizes, ratios;
    struct wf_yaml_pair *note;
    struct part *part;
    double *size, *ratio;
    struct part main;
    int finished;
};

static const char *const colours[] = { "red", "green", "blue", NULL }, *const laws[] = { "linear", "power",
                                                                                         NULL };
static const struct wf_yaml_row part_rows[] = {
    { .key = "name",
      .kind = WF_YAML_NAME,
      .required = true,
      .offset = offsetof(struct part, name),
      .doc = "Name.",
      .example = "lid" },
    { .key = "mass",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_MASS,
      .unit = "g",
      .low = 0,
      .high = 1,
      .offset = offsetof(struct part, mass),
      .given = 1 + offsetof(struct part, has_mass),
      .doc = "Mass." },
    { .key = NULL },
};
static const struct wf_yaml_table part_table = {
    .title = "a part", .row = part_rows, .size = sizeof(struct part), .doc = ""
};

static void finish(struct wf_yaml *y, void *out)
{
    struct thing *t = out;
    t->finished++;
    if (t->height < t->share) wf_yaml_error(y, "height", "%s is too low", wf_yaml_raw(y, "height"));
    if (t->parts && t->part[t->parts - 1].name && !strcmp(t->part[t->parts - 1].name, "odd")) {
        char key[40];
        snprintf(key, sizeof key, "parts[%zu].mass", t->parts - 1);
        wf_yaml_error(y, key, "odd part");
    }
}

#define AT(m) .offset = offsetof(struct thing, m)
static const struct wf_yaml_row rows[] = {
    { .key = "name", .kind = WF_YAML_NAME, .required = true, AT(name), .doc = "Name.", .example = "box" },
    { .key = "title", .kind = WF_YAML_TEXT, AT(title), .doc = "Title." },
    { .key = "remark", .kind = WF_YAML_TEXT, .offset = WF_YAML_DROP, .doc = "Not kept." },
    { .key = "law", .kind = WF_YAML_CHOICE, .choices = laws, .initial = "linear", AT(law), .doc = "Law." },
    { .key = "colour", .kind = WF_YAML_ENUM, .choices = colours, AT(colour), .doc = "Colour." },
    { .key = "height",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_LENGTH,
      .unit = "mm",
      .low = 0.001,
      .high = 2,
      AT(height),
      .doc = "Height.",
      .example = "9 mm" },
    { .key = "share",
      .kind = WF_YAML_QUANTITY,
      .low = 0,
      .high = 1,
      .initial = "0.25",
      AT(share),
      .doc = "Share." },
    { .key = "angle",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = -7,
      .high = 7,
      AT(angle),
      .doc = "Angle." },
    { .key = "count",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 9,
      .initial = "4",
      AT(count),
      .doc = "Count.",
      .example = "3" },
    { .key = "notes",
      .kind = WF_YAML_TEXTS,
      AT(note),
      .count = offsetof(struct thing, notes),
      .doc = "Notes." },
    { .key = "parts",
      .kind = WF_YAML_LIST,
      .table = &part_table,
      AT(part),
      .count = offsetof(struct thing, parts),
      .doc = "Parts." },
    { .key = "main", .kind = WF_YAML_TABLE, .table = &part_table, AT(main), .doc = "Main part." },
    { .key = "sizes",
      .kind = WF_YAML_QUANTITIES,
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 0,
      .high = 9,
      AT(size),
      .count = offsetof(struct thing, sizes),
      .doc = "Sizes." },
    { .key = "ratios",
      .kind = WF_YAML_QUANTITIES,
      .low = 0,
      .high = 1,
      .same_length_as = "sizes",
      AT(ratio),
      .count = offsetof(struct thing, ratios),
      .doc = "Ratios." },
    { .key = NULL },
};
static const struct wf_yaml_table table = {
    .title = "a thing", .row = rows, .size = sizeof(struct thing), .doc = "A thing.", .finish = finish
};

static const char good[] = "name: box_1\n"
                           "title: A box\n"
                           "colour: blue\n"
                           "height: 90 mm\n"
                           "share: 5 %\n"
                           "notes: {a: first, b: second}\n"
                           "parts:\n"
                           "  - name: lid\n"
                           "    mass: 20 g\n"
                           "  - {name: base}\n"
                           "main: {name: body, mass: 0.5 kg}\n"
                           "sizes: [1 m, 20 cm]\n"
                           "ratios: [0.5, 50 %]\n";

struct reading {
    struct thing thing;
    struct wf_diag diag;
    struct wf_err err;
    enum wf_status status;
    char findings[2048];
};

static void read_bytes(const char *text, size_t size, struct wf_arena *a, struct reading *r)
{
    struct scratch s;
    memset(r, 0, sizeof *r);
    r->diag.arena = a;
    scratch_write(&s, text, size);
    r->status = wf_yaml_read(s.path, &table, &r->thing, a, &r->diag, &r->err);
    findings_print(&r->diag, r->findings, sizeof r->findings);
    scratch_remove(&s);
}

static void a_good_file_is_read(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_bytes(good, strlen(good), &a, &r);
    assert_string_equal(r.findings, "");
    assert_int_equal(r.status, WF_OK);
    const struct thing *t = &r.thing;
    assert_string_equal(t->name, "box_1");
    assert_string_equal(t->title, "A box");
    assert_string_equal(t->law, "linear");
    assert_int_equal(t->colour, 2);
    assert_close(t->height, 0.09, 0);
    assert_close(t->share, 0.05, 0);
    assert_true(isnan(t->angle));
    assert_int_equal(t->count, 4);
    assert_int_equal(t->notes, 2);
    assert_string_equal(t->note[1].key, "b");
    assert_string_equal(t->note[1].text, "second");
    assert_int_equal(t->parts, 2);
    assert_string_equal(t->part[0].name, "lid");
    assert_true(t->part[0].has_mass && !t->part[1].has_mass);
    assert_close(t->part[0].mass, 0.02, 0);
    assert_true(isnan(t->part[1].mass));
    assert_close(t->main.mass, 0.5, 0);
    assert_int_equal(t->sizes, 2);
    assert_close(t->size[1], 0.2, 1e-15);
    assert_close(t->ratio[1], 0.5, 0);
    assert_int_equal(t->finished, 1);
    wf_arena_free(&a);
}

static void line_ends_and_marks_do_not_matter(void **state)
{
    (void)state;
    static const char *const same[] = { "\xEF\xBB\xBFname: a\nheight: 1 m\n",
                                        "name: a\r\nheight: 1 m\r\n",
                                        "---\nname: a\nheight: 1 m\n...\n",
                                        "%YAML 1.1\n---\nname: a\nheight: 1 m\n",
                                        "{name: a, height: 1 m}",
                                        "# remark\nname: \"a\" # remark\nheight: '1 m'\n",
                                        "{\"name\": \"a\", \"height\": \"1 m\"}" };
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        struct wf_arena a = { 0 };
        struct reading r;
        read_bytes(same[i], strlen(same[i]), &a, &r);
        if (r.status) fail_msg("%zu: %s %s", i, r.err.text, r.findings);
        assert_close(r.thing.height, 1, 0);
        assert_string_equal(r.thing.name, "a");
        wf_arena_free(&a);
    }
}

static const struct edit mistakes[] = {
    { NULL, "", "1:1: the file is empty; a thing is expected" },
    { NULL, "# only a remark\n", "1:1: the file is empty; a thing is expected" },
    { NULL, "---\n", "1:1: the file is empty; a thing is expected" },
    { NULL, "just text\n", "1:1: a mapping (keys with values) is expected, not a single value" },
    { NULL, "- a\n- b\n", "1:1: a mapping (keys with values) is expected, not a list" },
    { NULL, "{}",
      "1:1: missing key 'name' (Name.); for example 'name: box'\n"
      "1:1: missing key 'height' (Height.); for example 'height: 9 mm'" },
    { NULL, "name: a\nheight: 1 m\n---\nname: b\n",
      "3:1: a second document starts here; a file must have exactly one" },
    { NULL, "a: &x 1\nb: *x\n",
      "1:4: the anchor '&x' is not understood here; write the value out\n"
      "2:4: the alias '*x' is not understood here; write the value out" },
    { NULL, "&a [*a, *a]\n",
      "1:1: the anchor '&a' is not understood here; write the value out\n"
      "1:5: the alias '*a' is not understood here; write the value out\n"
      "1:9: the alias '*a' is not understood here; write the value out" },
    { NULL, "name: !!str a\n", "1:7: the tag 'tag:yaml.org,2002:str' is not understood here" },
    { NULL, "[[[[[[[[[[[[[[[[[[[[[[[[[[[[", "1:17: nesting deeper than 16 levels" },
    { NULL, "name: a\n\theight: 1 m\n", "2:1: a tab cannot indent; use spaces" },
    { NULL, "name: [a\nheight: 1 m\n",
      "2:7: not YAML: did not find expected ',' or ']' (while parsing a flow sequence that starts on line "
      "1)" },
    { NULL, "name: a: b\n", "1:8: not YAML: mapping values are not allowed in this context" },
    { NULL, "name: \"a\n",
      "2:1: not YAML: found unexpected end of stream (while scanning a quoted scalar that starts on line "
      "1)" },
    { "title:", "titel:", "2:1: unknown key 'titel'; did you mean 'title'?" },
    { "title:", "x:",
      "2:1: unknown key 'x'; keys here are: name, title, remark, law, colour, height, share, angle, count, "
      "notes, parts, main, sizes, ratios" },
    { "title: A box", "name: again", "2:1: key 'name' is given twice" },
    { "title: A box", "[a, b]: x", "2:1: a key is expected, not a list" },
    { "name: box_1", "name: -box", "1:7: name: '-box': a name does not begin with '-'" },
    { "name: box_1", "name: box 1", "1:7: name: 'box 1': a name has only letters a-z, digits, '_' and '-'" },
    { "name: box_1", "name:", "1:6: name: a text is expected, not nothing" },
    { "name: box_1", "name: \" \"", "1:7: name: a text is expected, not a single value" },
    { "name: box_1", "name: {a: b}",
      "1:7: name: a single value is expected, not a mapping (keys with values)" },
    { "name: box_1\n", "", "1:1: missing key 'name' (Name.); for example 'name: box'" },
    { "colour: blue", "colour: bleu",
      "3:9: colour: 'bleu' is not one of: red, green, blue; did you mean 'blue'?" },
    { "colour: blue", "colour: ultraviolet", "3:9: colour: 'ultraviolet' is not one of: red, green, blue" },
    { "colour: blue", "law: power2",
      "3:6: law: 'power2' is not one of: linear, power; did you mean 'power'?" },
    { "90 mm", "90", "4:9: height: '90' has no unit; write for example '90 mm'" },
    { "90 mm", "90 kg", "4:9: height: '90 kg': 'kg' is not a unit of a length; use one of: m, cm, mm" },
    { "90 mm", "90 m", "4:9: height: 90 m is outside 1 mm to 2000 mm" },
    { "90 mm", "0.9 mm", "4:9: height: 0.9 mm is outside 1 mm to 2000 mm" },
    { "90 mm", ".nan", "4:9: height: '.nan' is not a length; write for example '1.5 mm'" },
    { "90 mm", "10 mm", "4:9: height: 10 mm is too low" },
    { "90 mm", "", "4:8: height: the value is empty; a length is expected" },
    { "90 mm", "[1 m]", "4:9: height: a single value is expected, not a list" },
    { "5 %", "120 %", "5:8: share: 120 % is outside 0 to 1" },
    { "5 %", "-0.1", "5:8: share: -0.1 is outside 0 to 1" },
    { "5 %", "5 %\ncount: 10", "6:8: count: 10 is outside 1 to 9" },
    { "5 %", "5 %\ncount: 0", "6:8: count: 0 is outside 1 to 9" },
    { "5 %", "5 %\ncount: 3.5", "6:8: count: '3.5' is not a whole number; write for example '3'" },
    { "5 %", "5 %\ncount: -3", "6:8: count: '-3' is not a whole number; write for example '3'" },
    { "5 %", "5 %\ncount: 99999999999999999999", "6:8: count: 99999999999999999999 is outside 1 to 9" },
    { "5 %", "5 %\nangle: 9 rad", "6:8: angle: 9 rad is outside -401.07 deg to 401.07 deg" },
    { "{a: first, b: second}", "[a, b]", "6:8: notes: a mapping of names to texts is expected, not a list" },
    { "{a: first, b: second}", "{a: first, a: second}", "6:19: notes.a: is given twice" },
    { "{a: first, b: second}", "{a: [1]}", "6:12: notes.a: a text is expected, not a list" },
    { "{a: first, b: second}", "{a: ''}", "6:12: notes.a: a text is expected, not nothing" },
    { "{a: first, b: second}", "{[a]: b}", "6:9: notes: a name is expected, not a list" },
    { "{a: first, b: second}", "{a b: c}",
      "6:9: notes: 'a b': a name has only letters a-z, digits, '_' and '-'" },
    { "  - name: lid\n    mass: 20 g\n  - {name: base}\n", "  name: lid\n",
      "8:3: parts: a list of mappings is expected, not a mapping (keys with values)" },
    { "  - name: lid\n    mass: 20 g\n  - {name: base}\n", "  []\n",
      "8:3: parts: the list is empty; mappings are expected" },
    { "- {name: base}", "- base",
      "10:5: parts[1]: a mapping (keys with values) is expected, not a single value" },
    { "- {name: base}", "- {}", "10:5: parts[1]: missing key 'name' (Name.); for example 'name: lid'" },
    { "- {name: base}", "- {name: odd}", "10:5: parts[1].mass: odd part" },
    { "- {name: base}", "- {name: odd, mass: 1 g}", "10:23: parts[1].mass: odd part" },
    { "mass: 20 g", "mas: 20 g", "9:5: parts[0]: unknown key 'mas'; did you mean 'mass'?" },
    { "{name: body, mass: 0.5 kg}", "body",
      "11:7: main: a mapping (keys with values) is expected, not a single value" },
    { "0.5 kg", "5 kg", "11:26: main.mass: 5 kg is outside 0 g to 1000 g" },
    { "[1 m, 20 cm]", "1 m", "12:8: sizes: a list of values is expected, not a single value" },
    { "[1 m, 20 cm]", "[1 m, [2]]", "12:14: sizes[1]: a single value is expected, not a list" },
    { "[1 m, 20 cm]", "[1 m, 20]", "12:14: sizes[1]: '20' has no unit; write for example '20 m'" },
    { "[1 m, 20 cm]", "[1 m]", "13:9: ratios: 2 values, but 'sizes' has 1" },
    { "ratios: [0.5, 50 %]", "ratios: []", "13:9: ratios: the list is empty; values are expected" },
    { "name: box_1\ntitle: A box", "titel: A\ntitle: A box\ncount: x",
      "1:1: unknown key 'titel'; did you mean 'title'?\n1:1: missing key 'name' (Name.); for example 'name: "
      "box'\n3:8: count: 'x' is not a whole number; write for example '3'" },
};

static void findings_of(const char *text, char *buf, size_t size)
{
    struct wf_arena a = { 0 };
    struct reading r;
    read_bytes(text, strlen(text), &a, &r);
    assert_int_equal(r.status, WF_EINPUT);
    assert_non_null(strstr(r.err.text, r.diag.errors == 1 ? ": 1 mistake" : " mistakes"));
    snprintf(buf, size, "%s", r.findings);
    wf_arena_free(&a);
}

static void every_mistake_is_named(void **state)
{
    (void)state;
    assert_mistakes_are_named(good, mistakes, sizeof mistakes / sizeof *mistakes, findings_of);
}

static void files_that_are_no_text(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_bytes("name: \xB0\xB1\n", 9, &a, &r);
    assert_int_equal(r.status, WF_EINPUT);
    assert_non_null(strstr(r.err.text, ":1:7: byte 0xB0 is not UTF-8 text; save the file as UTF-8"));
    char *large = malloc((1 << 20) + 1);
    memset(large, '#', (1 << 20) + 1);
    read_bytes(large, (1 << 20) + 1, &a, &r);
    free(large);
    assert_non_null(strstr(r.err.text, ": is larger than 1 MB; a thing is smaller"));
    struct thing t = { 0 };
    struct wf_err e = { 0 };
    assert_int_equal(wf_yaml_read("/tmp", &table, &t, &a, &r.diag, &e), WF_EINPUT);
    assert_string_equal(e.text, "/tmp: is a folder, a file was expected");
    wf_arena_free(&a);
}

/* A file of junk is answered shortly, however many mistakes it has. */
static void many_mistakes_are_counted_not_listed(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    enum { LINES = 10000 };
    char *text = malloc(24 * LINES), *end = text;
    for (int i = 0; i < LINES; i++) end += sprintf(end, "key%d: 1\n", i);
    read_bytes(text, (size_t)(end - text), &a, &r);
    assert_int_equal(r.status, WF_EINPUT);
    assert_int_equal(r.diag.errors, LINES + 2);
    assert_string_equal(r.diag.last->text, "more than 100 mistakes; the rest is counted but not listed");
    wf_arena_free(&a);
    end = text + sprintf(text, "name: a\nheight: 1 m\nnotes:\n");
    for (int i = 0; i < LINES; i++) end += sprintf(end, "  key%d: 1\n", i);
    read_bytes(text, (size_t)(end - text), &a, &r);
    assert_string_equal(r.findings, "4:3: notes: 10000 entries; at most 1000 are read");
    wf_arena_free(&a);
    free(text);
}

static void memory_is_refused_at_every_smaller_capacity(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct reading r;
    read_bytes(good, strlen(good), &a, &r);
    size_t need = a.used;
    wf_arena_free(&a);
    for (size_t limit = 1; limit <= need; limit += limit + 64 < need ? 13 : 1) {
        struct wf_arena small = { .limit = limit };
        read_bytes(good, strlen(good), &small, &r);
        assert_int_equal(r.status, limit < need ? WF_ENOMEM : WF_OK);
        wf_arena_free(&small);
    }
}

static void the_schema_names_every_key(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    const char *text = wf_yaml_schema(&table, &a, &e);
    assert_non_null(text);
    for (const struct wf_yaml_row *r = rows; r->key; r++) {
        char line[80];
        snprintf(line, sizeof line, "\n  %s", r->key);
        assert_non_null(strstr(text, line));
    }
    assert_non_null(strstr(text, "\n  height  (required)\n      Height.\n      a length, 1 mm to 2000 mm\n   "
                                 "   example: height: 9 mm\n"));
    assert_non_null(
        strstr(text, "\n  share\n      Share.\n      a plain number, 0 to 1\n      default: 0.25\n"));
    assert_non_null(strstr(text, "\n  parts[].mass\n"));
    assert_non_null(strstr(text, "\n      red | green | blue\n"));
    assert_non_null(strstr(text, "a whole number, 1 to 9"));
    struct wf_arena small = { .limit = 100 };
    assert_null(wf_yaml_schema(&table, &small, &e));
    assert_int_equal(e.code, WF_ENOMEM);
    wf_arena_free(&a);
    wf_arena_free(&small);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_good_file_is_read),
        cmocka_unit_test(line_ends_and_marks_do_not_matter),
        cmocka_unit_test(every_mistake_is_named),
        cmocka_unit_test(files_that_are_no_text),
        cmocka_unit_test(many_mistakes_are_counted_not_listed),
        cmocka_unit_test(memory_is_refused_at_every_smaller_capacity),
        cmocka_unit_test(the_schema_names_every_key),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
