/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees written and read back, and MATLAB files. */
#include "close.h"
#include "data/species.h"
#include "grow/qsm.h"
#include "imported.h"
#ifdef WF_MATIO
#include <matio.h>
#include <sys/stat.h>
#endif

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
    assert_int_equal(wf_qsm_write(&t.qsm, f.path, &t.err), WF_OK);
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
    }
}

static void vtk_has_every_row(void **state)
{
    (void)state;
    struct imported t;
    struct folder f;
    char text[4096];
    folder_make(&f, "tree.vtk");
    import_path(&t, DATA "plain.csv");
    assert_int_equal(wf_qsm_write(&t.qsm, f.path, &t.err), WF_OK);
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
    assert_int_equal(wf_qsm_write(&t.qsm, "/tmp/tree.obj", &t.err), WF_EUSAGE);
    assert_non_null(strstr(t.err.text, ".vtk"));
    wf_arena_free(&t.arena);
}

#ifdef WF_MATIO
/* The tree of treeqsm_23.txt, column by column. */
static float radius[] = { 0.05F, 0.04F, 0.02F }, length[] = { 1, 0.5F, 0.5F };
static float start[] = { 4, 4, 4, 19, 19, 19, 0.6F, 1.6F, 1.6F },
             axis[] = { 0, 0, 0.6F, 0, 0, 0, 1, 1, 0.8F };
static uint32_t parent[] = { 0, 1, 1 }, extension[] = { 2, 0, 0 };
static uint8_t order[] = { 0, 0, 1 }, added[] = { 0, 0, 1 };

static matvar_t *column(enum matio_classes c, enum matio_types type, size_t width, void *data)
{
    return Mat_VarCreate(NULL, c, type, 2, (size_t[]){ 3, width }, data, 0);
}

static matvar_t *cylinder(const char *name)
{
    static const char *fields[] = { "radius", "length",    "start", "axis",
                                    "parent", "extension", "added", "BranchOrder" };
    matvar_t *s = Mat_VarCreateStruct(name, 2, (size_t[]){ 1, 1 }, fields, 8);
    matvar_t *part[] = {
        column(MAT_C_SINGLE, MAT_T_SINGLE, 1, radius), column(MAT_C_SINGLE, MAT_T_SINGLE, 1, length),
        column(MAT_C_SINGLE, MAT_T_SINGLE, 3, start),  column(MAT_C_SINGLE, MAT_T_SINGLE, 3, axis),
        column(MAT_C_UINT32, MAT_T_UINT32, 1, parent), column(MAT_C_UINT32, MAT_T_UINT32, 1, extension),
        column(MAT_C_UINT8, MAT_T_UINT8, 1, added),    column(MAT_C_UINT8, MAT_T_UINT8, 1, order)
    };
    for (size_t k = 0; k < 8; k++) Mat_VarSetStructFieldByName(s, fields[k], 0, part[k]);
    return s;
}

static void assert_mat_tree(const char *path, size_t models)
{
    struct imported t;
    import_path(&t, path);
    if (t.status) fail_msg("%s", t.err.text);
    assert_sound(&t.qsm);
    assert_int_equal(t.qsm.n, 3);
    assert_string_equal(t.qsm.format, "MATLAB file");
    assert_close(t.metrics.volume, M_PI * (0.05 * 0.05 + 0.04 * 0.04 * 0.5 + 0.02 * 0.02 * 0.5), 1e-6);
    assert_int_equal(t.qsm.order[2], 1);
    assert_int_equal(t.qsm.added[2], 1);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_MODELS], models - 1);
    wf_arena_free(&t.arena);
}

static void matlab_structures(void **state)
{
    (void)state;
    struct folder f;
    folder_make(&f, "tree.mat");
    for (size_t models = 1; models <= 3; models += 2) {
        mat_t *mat = Mat_CreateVer(f.path, NULL, MAT_FT_MAT5);
        matvar_t *qsm =
            Mat_VarCreateStruct("QSM", 2, (size_t[]){ 1, models }, (const char *[]){ "cylinder" }, 1);
        for (size_t k = 0; k < models; k++) Mat_VarSetStructFieldByName(qsm, "cylinder", k, cylinder(NULL));
        double other = 1;
        matvar_t *first =
            Mat_VarCreate("inputs", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, (size_t[]){ 1, 1 }, &other, 0);
        assert_int_equal(Mat_VarWrite(mat, first, MAT_COMPRESSION_NONE), 0);
        assert_int_equal(Mat_VarWrite(mat, qsm, MAT_COMPRESSION_ZLIB), 0);
        Mat_VarFree(first);
        Mat_VarFree(qsm);
        Mat_Close(mat);
        assert_mat_tree(f.path, models);
    }
    /* cut in the middle: libmatio alone would give zeros */
    struct stat size;
    assert_int_equal(stat(f.path, &size), 0);
    assert_int_equal(truncate(f.path, size.st_size / 2), 0);
    struct imported t;
    import_path(&t, f.path);
    assert_int_equal(t.status, WF_EINPUT);
    assert_non_null(strstr(t.err.text, "cut off"));
    wf_arena_free(&t.arena);
    folder_remove(&f);
}

static void matlab_without_a_tree(void **state)
{
    (void)state;
    struct folder f;
    struct imported t;
    double data[6] = { 0 };
    folder_make(&f, "tree.mat");
    mat_t *mat = Mat_CreateVer(f.path, NULL, MAT_FT_MAT5);
    matvar_t *v = Mat_VarCreate("x", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, (size_t[]){ 2, 3 }, data, 0);
    assert_int_equal(Mat_VarWrite(mat, v, MAT_COMPRESSION_NONE), 0);
    Mat_VarFree(v);
    Mat_Close(mat);
    import_path(&t, f.path);
    assert_int_equal(t.status, WF_EINPUT);
    assert_non_null(strstr(t.err.text, "no tree in 1 variables"));
    wf_arena_free(&t.arena);
    folder_remove(&f);
}
#else
static void matlab_structures(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] = "MATLAB 5.0 MAT-file, Platform: GLNXA64";
    import_text(&t, text, sizeof text);
    assert_int_equal(t.status, WF_EMISSING);
    assert_non_null(strstr(t.err.text, "libmatio-dev"));
    wf_arena_free(&t.arena);
}

static void matlab_without_a_tree(void **state)
{
    (void)state;
    skip();
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_reads_back),   cmocka_unit_test(vtk_has_every_row),
        cmocka_unit_test(an_unknown_ending_is_refused), cmocka_unit_test(matlab_structures),
        cmocka_unit_test(matlab_without_a_tree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
