/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees written and read back. */
#include "close.h"
#include "data/species.h"
#include "grow/qsm_write.h"
#include "imported.h"
#include "shell.h"

#define DATA "tests/data/qsm/"

struct folder {
    char name[64], path[96];
};

static void folder_make(struct folder *f, const char *file)
{
    snprintf(f->name, sizeof f->name, "/tmp/windfirm-test-XXXXXX");
    assert_non_null(mkdtemp(f->name));
    snprintf(f->path, sizeof f->path, "%s/%s", f->name, file);
}

static void folder_remove(struct folder *f)
{
    unlink(f->path);
    assert_int_equal(rmdir(f->name), 0);
}

static void assert_same(const struct wf_qsm *a, const struct wf_qsm *b, double tolerance)
{
    assert_int_equal(a->n, b->n);
    for (size_t i = 0; i < a->n; i++) {
        assert_int_equal(a->parent[i], b->parent[i]);
        assert_int_equal(a->next[i], b->next[i]);
        assert_int_equal(a->order[i], b->order[i]);
        assert_int_equal(a->branch[i], b->branch[i]);
        assert_true(fabs(a->x0[i] - b->x0[i]) < tolerance && fabs(a->y0[i] - b->y0[i]) < tolerance);
        assert_true(fabs(a->z0[i] - b->z0[i]) < tolerance && fabs(a->x1[i] - b->x1[i]) < tolerance);
        assert_true(fabs(a->y1[i] - b->y1[i]) < tolerance && fabs(a->z1[i] - b->z1[i]) < tolerance);
        assert_close(wf_qsm_volume(b, i), wf_qsm_volume(a, i), 1e-8);
    }
}

static void round_trip(const char *from, const char *name)
{
    struct imported t, back;
    struct folder f;
    folder_make(&f, name);
    import_path(&t, from);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(wf_qsm_write(&t.qsm, f.path, NULL, &t.err), WF_OK);
    struct wf_import_options strict = wf_import_default();
    strict.strict = true;
    import_with(&back, f.path, strict);
    if (back.status) fail_msg("%s", back.err.text);
    assert_same(&t.qsm, &back.qsm, 1e-9);
    wf_arena_free(&t.arena);
    wf_arena_free(&back.arena);
    folder_remove(&f);
}

static void what_is_written_reads_back(void **state)
{
    (void)state;
    static const char *const files[] = { "archi.csv", "hand.csv",          "normalised.csv",
                                         "rtwig.csv", "simpleforest.csv",  "warts.csv",
                                         "plain.csv", "treeqsm_archi.txt", "walnut.mtg" };
    char path[128];
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        snprintf(path, sizeof path, DATA "%s", files[k]);
        round_trip(path, "tree.csv");
        round_trip(path, "tree.txt");
        round_trip(path, "tree.mat");
    }
}

/* Rows of a tree graph are written branch by branch, so rows are found again by their ends. */
static void same_in_another_order(const struct wf_qsm *a, const struct wf_qsm *b, const char *from)
{
    assert_int_equal(a->n, b->n);
    for (size_t i = 0; i < a->n; i++) {
        size_t k = 0;
        while (k < b->n && !(fabs(a->x1[i] - b->x1[k]) < 1e-9 && fabs(a->y1[i] - b->y1[k]) < 1e-9 &&
                             fabs(a->z1[i] - b->z1[k]) < 1e-9 && fabs(a->x0[i] - b->x0[k]) < 1e-9 &&
                             fabs(a->z0[i] - b->z0[k]) < 1e-9))
            k++;
        if (k == b->n) fail_msg("%s: row %zu is not there", from, i);
        assert_close(b->r0[k], a->r0[i], 1e-12);
        assert_close(b->r1[k], a->r1[i], 1e-12);
        assert_close(b->length[k], a->length[i], 1e-12);
        assert_int_equal(b->order[k], a->order[i]);
        assert_int_equal(b->place[k], a->place[i]);
        assert_int_equal(b->parent[k] < 0, a->parent[i] < 0);
        if (a->parent[i] < 0) continue;
        assert_true(fabs(a->z1[a->parent[i]] - b->z1[b->parent[k]]) < 1e-9);
        assert_int_equal(b->next[b->parent[k]] == (int32_t)k, a->next[a->parent[i]] == (int32_t)i);
    }
}

static void tree_graphs_keep_tapers_and_gaps(void **state)
{
    (void)state;
    static const char *const files[] = { "archi.csv", "hand.csv",          "normalised.csv",
                                         "rtwig.csv", "simpleforest.csv",  "warts.csv",
                                         "plain.csv", "treeqsm_archi.txt", "walnut.mtg" };
    struct wf_import_options strict = wf_import_default();
    strict.strict = true;
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        struct imported t, back;
        struct folder f;
        char path[128];
        snprintf(path, sizeof path, DATA "%s", files[k]);
        folder_make(&f, "tree.mtg");
        import_path(&t, path);
        assert_int_equal(wf_qsm_write(&t.qsm, f.path, NULL, &t.err), WF_OK);
        import_with(&back, f.path, strict);
        if (back.status) fail_msg("%s: %s", path, back.err.text);
        assert_int_equal(back.qsm.repairs.count[WF_NOTE_UNITS], 0); /* its own files are in metres */
        same_in_another_order(&t.qsm, &back.qsm, files[k]);
        wf_arena_free(&t.arena);
        wf_arena_free(&back.arena);
        folder_remove(&f);
    }
}

/* A branch that forks at each row, 300 times: more columns than a tree graph takes. */
static void a_graph_that_is_too_deep_is_refused(void **state)
{
    (void)state;
    enum { ROWS = 300 };
    static char text[ROWS * 64];
    size_t n = (size_t)snprintf(text, sizeof text, "id,parent,x0,y0,z0,x1,y1,z1,radius0,radius1,order\n");
    for (int i = 1; i <= ROWS; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "%d,%d,0,0,%d,0,0,%d,0.1,0.1,%d\n", i, i - 1, i - 1,
                              i, i - 1);
    struct imported t;
    struct folder f;
    folder_make(&f, "tree.mtg");
    import_text(&t, text, n);
    assert_int_equal(t.status, WF_OK);
    t.qsm.file = t.qsm.name = "deep"; /* the name that import_text read from is gone */
    assert_int_equal(wf_qsm_write(&t.qsm, f.path, NULL, &t.err), WF_EOUTPUT);
    assert_non_null(strstr(t.err.text, "299 times"));
    wf_arena_free(&t.arena);
    folder_remove(&f);
}

static void a_form_may_be_named(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W import $D/plain.csv -o $T/t.dat --to mtg -q && head -1 $T/t.dat && $W import $T/t.dat",
          0,
          { "CODE:\tFORM-A", "OpenAlea MTG, 3 cylinders" } },
        { "$W import $D/plain.csv $D/archi.csv -o $T/all/ --to mat -q && ls $T/all && $W import $T/all/*.mat",
          0,
          { "archi.mat\nplain.mat", "MATLAB file, 3 cylinders" } },
        { "$W import $D/plain.csv --to mtg", 2, { "--output" } },
        { "$W import $D/plain.csv -o $T/t --to obj", 2, { "csv" } },
    };
    CHECK(rows);
}

static void vtk_has_every_row(void **state)
{
    (void)state;
    struct imported t;
    struct folder f;
    char text[4096];
    folder_make(&f, "tree.vtk");
    import_path(&t, DATA "plain.csv");
    assert_int_equal(wf_qsm_write(&t.qsm, f.path, NULL, &t.err), WF_OK);
    FILE *in = fopen(f.path, "rb");
    text[fread(text, 1, sizeof text - 1, in)] = '\0';
    fclose(in);
    assert_ptr_equal(strstr(text, "# vtk DataFile Version 3.0\n"), text);
    assert_non_null(strstr(text, "DATASET POLYDATA\nPOINTS 6 double\n0 0 0\n0 0 1\n0 0 1\n0 0 2\n"));
    assert_non_null(strstr(text, "LINES 3 9\n2 0 1\n2 2 3\n2 4 5\n"));
    assert_non_null(
        strstr(text, "POINT_DATA 6\nSCALARS radius double 1\nLOOKUP_TABLE default\n0.05\n0.04\n0.04\n"));
    assert_non_null(strstr(text, "CELL_DATA 3\nSCALARS level int 1\nLOOKUP_TABLE default\n0\n0\n1\n"));
    wf_arena_free(&t.arena);
    folder_remove(&f);
}

static void an_unknown_ending_is_refused(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "plain.csv");
    assert_int_equal(wf_qsm_write(&t.qsm, "/tmp/tree.obj", NULL, &t.err), WF_EUSAGE);
    assert_non_null(strstr(t.err.text, ".vtk"));
    wf_arena_free(&t.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_reads_back),
        cmocka_unit_test(tree_graphs_keep_tapers_and_gaps),
        cmocka_unit_test(a_graph_that_is_too_deep_is_refused),
        cmocka_unit_test(a_form_may_be_named),
        cmocka_unit_test(vtk_has_every_row),
        cmocka_unit_test(an_unknown_ending_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
