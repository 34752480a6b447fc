/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "close.h"
#include "data/out/folder.h"
#include "data/out/mock.h"
#include <jansson.h>
#include <locale.h>
#include <signal.h>
#include <sys/resource.h>

static const double winds[] = { 10, 15, 25 };

struct fixture {
    struct wf_arena arena;
    struct folder folder;
    struct wf_run run;
    struct wf_err e;
};

static int setup(void **state)
{
    struct fixture *f = calloc(1, sizeof *f);
    if (!f || !folder_make(&f->folder)) return -1;
    f->run = mock_run(2, winds, 3, &f->arena);
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    folder_remove(&f->folder);
    wf_arena_free(&f->arena);
    free(f);
    return 0;
}

static struct wf_analysis *analysis(struct fixture *f, size_t i)
{
    return (struct wf_analysis *)(uintptr_t)&f->run.analysis[i];
}

static json_t *written(struct fixture *f)
{
    json_error_t why;
    assert_int_equal(wf_results_write(&f->run, f->folder.path, &f->e), WF_OK);
    json_t *o = json_load_file(folder_file(&f->folder, "results.json"), JSON_REJECT_DUPLICATES, &why);
    if (!o) fail_msg("%s", why.text);
    return o;
}

/* Follow "a/b/2/c" through objects and arrays. */
static json_t *at(json_t *o, const char *path)
{
    char copy[128], *rest = NULL;
    snprintf(copy, sizeof copy, "%s", path);
    for (char *word = strtok_r(copy, "/", &rest); word; word = strtok_r(NULL, "/", &rest)) {
        o = json_is_array(o) ? json_array_get(o, strtoul(word, NULL, 10)) : json_object_get(o, word);
        if (!o) fail_msg("results.json has no %s (at %s)", path, word);
    }
    return o;
}

static double number(json_t *o, const char *path) { return json_number_value(at(o, path)); }
static const char *text(json_t *o, const char *path) { return json_string_value(at(o, path)); }

static void document(void **state)
{
    struct fixture *f = *state;
    json_t *o = written(f);
    assert_string_equal(text(o, "schema/name"), WF_RESULTS_SCHEMA);
    assert_int_equal(json_integer_value(at(o, "schema/version")), WF_RESULTS_VERSION);
    assert_string_equal(text(o, "provenance/version"), "0.1.0");
    assert_string_equal(text(o, "provenance/files/0/sha256"), f->run.input[0].sha256);
    assert_true(json_is_null(at(o, "provenance/seed")));
    assert_int_equal(json_array_size(at(o, "trees")), 2);
    assert_string_equal(text(o, "trees/0/species/key"), "moso_bamboo");
    assert_string_equal(text(o, "trees/0/species/name_zh"), "毛竹");
    assert_string_equal(text(o, "trees/0/species/values/0/quantity"), "youngs_modulus");
    assert_string_equal(text(o, "trees/0/species/values/0/unit"), "Pa");
    assert_string_equal(text(o, "trees/0/species/values/0/status"), "handbook");
    assert_close(number(o, "trees/0/species/values/0/high"), 12e9, 1e-15);
    assert_close(number(o, "trees/0/species/walls/0/share/2"), 0.24, 0);
    assert_string_equal(text(o, "trees/1/method/solver/name"), "beam");
    assert_string_equal(text(o, "trees/1/method/streamlining/name"), "vogel");
    assert_string_equal(text(o, "trees/1/scenario/air_density_from"), "temperature and altitude");
    assert_string_equal(text(o, "trees/1/warnings/0/code"), "streamlining-range");
    assert_string_equal(text(o, "tables/1/file"), "tables/segments.csv");
    assert_int_equal(json_integer_value(at(o, "tables/1/rows")), 2 * 3 * MOCK_SEGMENTS);
    json_decref(o);
}

/* Numbers come back to the last bit. */
static void exact(void **state)
{
    struct fixture *f = *state;
    json_t *o = written(f);
    for (size_t k = 0; k < 3; k++) {
        const struct wf_at_speed *want = &f->run.analysis[1].at[k];
        char path[64];
        snprintf(path, sizeof path, "trees/1/winds/%zu/tip_deflection/value", k);
        assert_close(number(o, path), want->tip_deflection, 0);
        snprintf(path, sizeof path, "trees/1/winds/%zu/base_moment/value", k);
        assert_close(number(o, path), want->base_moment, 0);
        snprintf(path, sizeof path, "trees/1/winds/%zu/least_safety/value", k);
        assert_close(number(o, path), want->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety, 0);
    }
    assert_close(number(o, "trees/1/critical/speed/value"), f->run.analysis[1].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed, 0);
    json_decref(o);
}

/* Every quantity is a number with a unit, or null with a unit and a reason. */
static void complete(const json_t *o, const char *path)
{
    const char *key;
    json_t *value;
    size_t i;
    if (json_is_object(o) && json_object_get(o, "value")) {
        const json_t *x = json_object_get(o, "value");
        if (!json_is_string(json_object_get(o, "unit"))) fail_msg("%s has no unit", path);
        if (json_is_null(x) && !json_is_string(json_object_get(o, "reason")))
            fail_msg("%s is null without a reason", path);
    }
    json_object_foreach((json_t *)(uintptr_t)o, key, value) complete(value, key);
    json_array_foreach(o, i, value) complete(value, path);
}

static void units_and_reasons(void **state)
{
    struct fixture *f = *state;
    struct wf_analysis *a = analysis(f, 0);
    a->at[1].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety = NAN;
    a->at[1].lift = INFINITY;
    json_t *o = written(f);
    complete(o, "results.json");
    assert_true(json_is_null(at(o, "trees/0/winds/1/least_safety/value")));
    assert_string_equal(text(o, "trees/0/winds/1/least_safety/reason"), "no modulus of rupture is given");
    assert_true(json_is_null(at(o, "trees/0/winds/1/lift/value")));
    assert_true(json_is_null(at(o, "trees/0/critical/speed/value")));
    json_decref(o);
}

/* A wind speed without an answer keeps its row and its status, and gives no figures. */
static void unsolved(void **state)
{
    struct fixture *f = *state;
    struct wf_analysis *a = analysis(f, 1);
    a->at[2] = (struct wf_at_speed){ .speed = 25, .status = WF_EUNSTABLE };
    a->at[2].response.load_factor = 0.7;
    json_t *o = written(f);
    assert_string_equal(text(o, "trees/1/winds/2/status"), "unstable");
    assert_close(number(o, "trees/1/winds/2/load_factor/value"), 0.7, 0);
    assert_true(json_is_null(at(o, "trees/1/winds/2/drag/value")));
    assert_true(json_is_null(at(o, "trees/1/winds/2/governing_section")));
    assert_int_equal(json_integer_value(at(o, "tables/1/rows")), 5 * MOCK_SEGMENTS);
    json_decref(o);
    char *summary = folder_read(&f->folder, "tables/summary.csv");
    assert_non_null(summary);
    assert_int_equal(lines_of(summary), 1 + 2 * 3);
    assert_non_null(strstr(summary, "2,\"weeping_willow\",25,unstable,,,,,,,,,,,,"));
    free(summary);
}

static void tables(void **state)
{
    struct fixture *f = *state;
    static const struct {
        const char *name, *head;
        size_t rows;
    } want[] = {
        { "tables/summary.csv", "tree,species,wind_m_s,status,tip_deflection_m,tip_deflection_percent,",
          2 * 3 },
        { "tables/segments.csv", "tree,species,wind_m_s,segment,parent,level,height0_m,",
          2 * 3 * MOCK_SEGMENTS },
        { "tables/shape.csv", "tree,species,wind_m_s,axis,segment,x_m,y_m,z_m,loaded_x_m,",
          2 * 3 * (MOCK_SEGMENTS + 1) },
        { "tables/sweep.csv", "tree,species,wind_m_s,status,tip_deflection_m,", 2 * MOCK_SWEEP },
    };
    json_decref(written(f));
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        char *table = folder_read(&f->folder, want[i].name);
        assert_non_null(table);
        assert_int_equal(lines_of(table), want[i].rows + 1);
        assert_memory_equal(table, want[i].head, strlen(want[i].head));
        assert_null(strstr(table, "nan"));
        assert_null(strstr(table, "inf"));
        size_t commas = 0, first = 0; /* every row has as many cells as the header */
        for (const char *c = table; *c; c++) {
            commas += *c == ',';
            if (*c != '\n') continue;
            if (!first) first = commas;
            assert_int_equal(commas, first);
            commas = 0;
        }
        free(table);
    }
}

/* Values of a table are those of the run, in the unit of the column's name. */
static void table_values(void **state)
{
    struct fixture *f = *state;
    json_decref(written(f));
    char *table = folder_read(&f->folder, "tables/segments.csv"), *row = table, *rest = NULL;
    double cell[32];
    for (int i = 0; i < 2 * MOCK_SEGMENTS; i++) row = strchr(row, '\n') + 1; /* 15 m/s, last row */
    size_t n = 0;
    strtok_r(row, "\n", &rest);
    for (char *c = row, *comma; c && n < 32; c = comma ? comma + 1 : NULL) {
        comma = strchr(c, ',');
        cell[n++] = strtod(c, NULL);
    }
    const struct wf_analysis *a = &f->run.analysis[0];
    const struct wf_at_speed *speed = &a->at[1];
    size_t r = MOCK_SEGMENTS - 1;
    assert_int_equal(n, 28);
    assert_close(cell[2], 15, 0);
    assert_close(cell[3], MOCK_SEGMENTS, 0);
    assert_close(cell[9], 2e3 * a->tree.r1[r], 1e-9);
    assert_close(cell[15], speed->breakage.bending0[r], 1e-9);
    assert_close(cell[21], speed->breakage.stress0[r] / 1e6, 1e-9);
    assert_close(cell[25], speed->figures.deflection[r], 1e-9);
    assert_close(cell[26], speed->figures.slope[r] * 180 / M_PI, 1e-9);
    free(table);
}

/* A branch starts an axis of its own at its parent's end, where that end has moved to. */
static void axes(void **state)
{
    struct fixture *f = *state;
    struct wf_analysis *a = analysis(f, 0);
    a->tree.parent[30] = 9;
    json_decref(written(f));
    char *shape = folder_read(&f->folder, "tables/shape.csv"), want[160];
    const double *u = a->at[0].response.end + 27;
    snprintf(want, sizeof want, "1,\"moso_bamboo\",10,2,0,0,0,%.10g,%.10g,0,%.10g\n", a->tree.z0[30], u[0],
             a->tree.z0[30] + u[2]);
    assert_non_null(shape);
    assert_non_null(strstr(shape, want));
    free(shape);
}

/* A quote in a key is doubled; bytes that are not text become question marks. */
static void cells(void **state)
{
    struct fixture *f = *state;
    struct wf_species *sp = (struct wf_species *)(uintptr_t)f->run.analysis[0].species;
    sp->key = "a \"b\"";
    sp->name = "bad \xff byte";
    json_t *o = written(f);
    assert_string_equal(text(o, "trees/0/species/name"), "bad ? byte");
    json_decref(o);
    char *summary = folder_read(&f->folder, "tables/summary.csv");
    assert_non_null(strstr(summary, "\n1,\"a \"\"b\"\"\",10,ok,"));
    free(summary);
}

/* A caller's decimal comma does not reach the tables or the document, and is his again afterwards. */
static void decimal_comma(void **state)
{
    struct fixture *f = *state;
    char command[400];
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 >/dev/null 2>&1",
             f->folder.path);
    if (system(command)) skip(); /* no sources of locales here */
    assert_int_equal(setenv("LOCPATH", f->folder.path, 1), 0);
    assert_non_null(setlocale(LC_NUMERIC, "de_DE.UTF-8"));
    char half[8], after[8];
    snprintf(half, sizeof half, "%.1f", 0.5);
    double deflection = analysis(f, 0)->at[0].tip_deflection;
    enum wf_status status = wf_results_write(&f->run, f->folder.path, &f->e);
    snprintf(after, sizeof after, "%.1f", 0.5);
    setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");
    assert_string_equal(half, "0,5");
    assert_string_equal(after, "0,5");
    assert_int_equal(status, WF_OK);
    char want[64], *summary = folder_read(&f->folder, "tables/summary.csv");
    snprintf(want, sizeof want, "\n1,\"moso_bamboo\",10,ok,%.10g,", deflection);
    assert_non_null(strstr(summary, want));
    free(summary);
    json_t *o = json_load_file(folder_file(&f->folder, "results.json"), 0, NULL);
    assert_close(json_real_value(at(o, "trees/0/winds/0/tip_deflection/value")), deflection, 1e-15);
    json_decref(o);
}

/* Findings that all trees share are written once, for the run. */
static void shared_warnings(void **state)
{
    struct fixture *f = *state;
    analysis(f, 1)->diag = analysis(f, 0)->diag;
    json_t *o = written(f);
    assert_int_equal(json_array_size(at(o, "warnings")), 1);
    assert_int_equal(json_array_size(at(o, "trees/0/warnings")), 0);
    json_decref(o);
}

static void wrong_calls(void **state)
{
    struct fixture *f = *state;
    struct wf_run none = { 0 };
    assert_int_equal(wf_results_write(&none, f->folder.path, &f->e), WF_EUSAGE);
    f->e = (struct wf_err){ 0 };
    analysis(f, 1)->at[1].speed = 16;
    assert_int_equal(wf_results_write(&f->run, f->folder.path, &f->e), WF_EUSAGE);
    assert_false(folder_has(&f->folder, "results.json"));
}

/* The folder's name is a file's; a folder stands where a table should be: nothing is left behind. */
static void unwritable(void **state)
{
    struct fixture *f = *state;
    char below[256];
    FILE *file = fopen(folder_file(&f->folder, "file"), "w");
    assert_non_null(file);
    fclose(file);
    snprintf(below, sizeof below, "%s/mine", f->folder.file);
    assert_int_equal(wf_results_write(&f->run, below, &f->e), WF_EOUTPUT);
    assert_non_null(strstr(f->e.text, f->folder.file));
    f->e = (struct wf_err){ 0 };
    assert_int_equal(mkdir(folder_file(&f->folder, "tables"), 0700), 0);
    assert_int_equal(mkdir(folder_file(&f->folder, "tables/sweep.csv"), 0700), 0);
    assert_int_equal(wf_results_write(&f->run, f->folder.path, &f->e), WF_EOUTPUT);
    assert_non_null(strstr(f->e.text, "sweep.csv"));
    assert_false(folder_has(&f->folder, "results.json"));
    assert_false(folder_has(&f->folder, "tables/summary.csv"));
    assert_false(folder_has_leftovers(&f->folder));
}

/* A disk that fills up half-way leaves the results of the run before. */
static void full_disk(void **state)
{
    struct fixture *f = *state;
    struct rlimit before, small;
    json_decref(written(f));
    char *old = folder_read(&f->folder, "tables/summary.csv");
    analysis(f, 0)->at[0].tip_deflection = 123;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 8192; /* the summary fits, the segments do not */
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    enum wf_status code = wf_results_write(&f->run, f->folder.path, &f->e);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(code, WF_EOUTPUT);
    if (!strstr(f->e.text, "segments.csv: cannot be written: ")) fail_msg("%s", f->e.text);
    char *now = folder_read(&f->folder, "tables/summary.csv");
    assert_string_equal(now, old);
    assert_false(folder_has_leftovers(&f->folder));
    free(old), free(now);
}

static void input_notes(void **state)
{
    struct fixture *f = *state;
    struct wf_input_file note;
    assert_int_equal(wf_input_file_note("model", "no/such/file", &f->arena, &note, &f->e), WF_EINPUT);
    f->e = (struct wf_err){ 0 };
    assert_int_equal(wf_input_file_note("model", "LICENSE", &f->arena, &note, &f->e), WF_OK);
    assert_string_equal(note.path, "LICENSE");
    assert_int_equal(strlen(note.sha256), 64);
    setenv("SOURCE_DATE_EPOCH", "0", 1);
    assert_string_equal(wf_run_date(&f->arena), "1970-01-01T00:00:00Z");
    setenv("SOURCE_DATE_EPOCH", "soon", 1);
    assert_string_not_equal(wf_run_date(&f->arena), "1970-01-01T00:00:00Z");
    unsetenv("SOURCE_DATE_EPOCH");
}

#define T(name) cmocka_unit_test_setup_teardown(name, setup, teardown)

int main(void)
{
    const struct CMUnitTest tests[] = { T(document),
                                        T(exact),
                                        T(units_and_reasons),
                                        T(unsolved),
                                        T(tables),
                                        T(table_values),
                                        T(axes),
                                        T(cells),
                                        T(decimal_comma),
                                        T(shared_warnings),
                                        T(wrong_calls),
                                        T(unwritable),
                                        T(full_disk),
                                        T(input_notes) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
