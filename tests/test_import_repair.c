/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files as they really are: what is repaired, counted, refused. */
#include "close.h"
#include "data/species.h"
#include "imported.h"
#include <time.h>

#define DATA "tests/data/qsm/"
#define HEADER "id,parent,x0,y0,z0,x1,y1,z1,radius\n"

static size_t row_of(const struct wf_qsm *q, int64_t id)
{
    for (size_t i = 0; i < q->n; i++)
        if (q->id[i] == id) return i;
    fail_msg("no row with id %lld", (long long)id);
    return 0;
}

static void every_wart_is_repaired_and_counted(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "warts.csv");
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    const struct wf_qsm *q = &t.qsm;
    static const struct {
        enum wf_repair what;
        size_t count;
        int64_t first;
    } want[] = {
        { WF_NOTE_SORTED, 2, 2 },        { WF_NOTE_STEMS, 1, -1 },      { WF_REPAIR_BAD_ROW, 2, 21 },
        { WF_REPAIR_ZERO_LENGTH, 1, 5 }, { WF_REPAIR_RADIUS, 1, 10 },   { WF_REPAIR_SAME_ROW, 1, 2 },
        { WF_REPAIR_SAME_ID, 1, 2 },     { WF_REPAIR_NO_PARENT, 1, 7 }, { WF_REPAIR_CYCLE, 1, 9 },
        { WF_REPAIR_LOOSE, 2, 7 },       { WF_REPAIR_TRUNCATED, 0, 0 }, { WF_REPAIR_AXIS, 0, 0 },
    };
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        assert_int_equal(q->repairs.count[want[k].what], want[k].count);
        if (want[k].count) assert_int_equal(q->repairs.first[want[k].what], want[k].first);
    }
    assert_int_equal(q->n, 9);
    /* the child of the row without length hangs on what that hung on */
    assert_int_equal(q->parent[row_of(q, 6)], row_of(q, 2));
    /* no radius: that of the row below */
    assert_close(q->r0[row_of(q, 10)], 0.07, 1e-15);
    /* the loose row starts 0.2 m from the stem at 2.5 m: row 6 */
    assert_int_equal(q->parent[row_of(q, 7)], row_of(q, 6));
    /* the ring is cut at its lowest row, which starts at the end of row 7 */
    assert_int_equal(q->parent[row_of(q, 9)], row_of(q, 7));
    assert_int_equal(q->parent[row_of(q, 8)], row_of(q, 9));
    /* the other stem stays one */
    assert_int_equal(q->parent[row_of(q, 11)], -1);
    struct wf_qsm_model m;
    assert_joined(&t, WF_JOINT_AXIS, &m);
    assert_joined(&t, WF_JOINT_BRIDGE, &m);
    wf_arena_free(&t.arena);
}

static void strict_names_every_kind(void **state)
{
    (void)state;
    struct imported t;
    struct wf_import_options o = wf_import_default();
    o.strict = true;
    import_with(&t, DATA "warts.csv", o);
    assert_int_equal(t.status, WF_EINPUT);
    assert_non_null(strstr(t.err.text, "8 kinds of repair"));
    assert_int_equal(t.diag.errors, 2 + 8);
    assert_int_equal(t.diag.first->line, 21);
    assert_int_equal(t.diag.first->column, 10);
    wf_arena_free(&t.arena);
    /* another way of writing the same is no repair */
    import_with(&t, DATA "simpleforest.csv", o);
    assert_int_equal(t.status, WF_OK);
    wf_arena_free(&t.arena);
}

static void the_cut_off_row_is_named(void **state)
{
    (void)state;
    struct imported t;
    import_path(&t, DATA "truncated.csv");
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 2);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_TRUNCATED], 1);
    assert_int_equal(t.qsm.repairs.first[WF_REPAIR_TRUNCATED], 4);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_BAD_ROW], 0);
    wf_arena_free(&t.arena);
}

static void refuse(const char *text, size_t size, const char *what)
{
    struct imported t;
    import_text(&t, text, size);
    if (t.status != WF_EINPUT || !strstr(t.err.text, what)) fail_msg("got '%s', want '%s'", t.err.text, what);
    wf_arena_free(&t.arena);
}

#define REFUSE(text, what) refuse(text, sizeof(text) - 1, what)

static void what_is_no_tree_is_refused(void **state)
{
    (void)state;
    REFUSE("", "the file is empty");
    REFUSE("\x7f"
           "ELF\0\1\2\3\0\0\0",
           "neither text nor a MATLAB file");
    REFUSE("a,b\n\x81\xfe,2\n", "UTF-8");
    REFUSE("dbh,height\n30,20\n", "lacks a parent column");
    REFUSE("id,parent,x0,y0,z0,radius\n1,0,0,0,0,0.1\n", "lacks the end point");
    REFUSE("id,parent,x0,y0,z0,x1,y1,z1\n1,0,0,0,0,0,0,1\n", "lacks a radius");
    REFUSE(HEADER, "no cylinder");
    REFUSE(HEADER "1,0,0,0,0,0,0,1,\n", "no radius");
    REFUSE(HEADER "1,0,0,0,0,0,0,0,0.1\n", "no row has a length");
    REFUSE("1 2 3 4\n5 6 7 8\n", "14, 15 or 17 columns");
    REFUSE("CODE:\tFORM-A\nCLASSES:\n", "ENTITY-CODE");
    REFUSE("id,parent,length,diameter\n1,2,1,0.1\n2,1,1,0.1\n", "its own ancestor");
    REFUSE("MATLAB 5.0 MAT-file, cut", "cut off");
}

static void a_diameter_in_centimetres_is_suspected(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] = "id,parent,length,diameter\n1,0,2,25\n2,1,1,20\n";
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_EINPUT);
    assert_non_null(t.diag.first);
    assert_non_null(strstr(t.diag.first->text, "diameter_cm"));
    wf_arena_free(&t.arena);
}

static void unconnected_rows_are_not_a_tree(void **state)
{
    (void)state;
    enum { N = 4000 };
    char *text = malloc(N * 64 + 128);
    size_t n = (size_t)sprintf(text, HEADER "1,0,0,0,0,0,0,1,0.1\n");
    for (int i = 2; i <= N; i++)
        n += (size_t)sprintf(text + n, "%d,%d,0,0,%d,0,0,%d,0.1\n", i, i + N, i, i + 1);
    struct imported t;
    import_text(&t, text, n);
    free(text);
    assert_int_equal(t.status, WF_EINPUT);
    assert_non_null(strstr(t.err.text, "parent column does not fit"));
    wf_arena_free(&t.arena);
}

/* A file cut at any byte, or with any byte changed, is read or refused; nothing worse. */
static void survives(const char *path)
{
    struct imported t;
    char whole[8192];
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t size = fread(whole, 1, sizeof whole, f);
    assert_true(size < sizeof whole);
    fclose(f);
    for (size_t cut = 1; cut < size; cut += 7) {
        import_text(&t, whole, cut);
        if (!t.status) assert_sound(&t.qsm);
        wf_arena_free(&t.arena);
    }
    for (size_t at = 0; at < size; at += 5) {
        char was = whole[at];
        static const char put[] = { ',', '\t', '9', '-', '\n', '/', '"', '\0' };
        whole[at] = put[at % sizeof put];
        import_text(&t, whole, size);
        if (!t.status) assert_sound(&t.qsm);
        wf_arena_free(&t.arena);
        whole[at] = was;
    }
}

static void damaged_files_survive(void **state)
{
    (void)state;
    static const char *const files[] = { "archi.csv",         "hand.csv",         "normalised.csv",
                                         "plain.csv",         "simpleforest.csv", "warts.csv",
                                         "treeqsm_archi.txt", "treeqsm_24.txt",   "walnut.mtg" };
    char path[128];
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        snprintf(path, sizeof path, DATA "%s", files[k]);
        survives(path);
    }
}

static void one_bad_row_in_many(void **state)
{
    (void)state;
    enum { N = 100000, BAD = 54321 };
    char *text = malloc(N * 64 + 128);
    size_t n = (size_t)sprintf(text, HEADER);
    for (int i = 1; i <= N; i++)
        n += i == BAD ? (size_t)sprintf(text + n, "%d,%d,0,0,?,0,0,1,0.1\n", i, i - 1)
                      : (size_t)sprintf(text + n, "%d,%d,%d,0,0,%d,0,0,0.1\n", i,
                                        i - 1 == BAD ? i - 2 : i - 1, i, i + 1);
    struct imported t;
    clock_t start = clock();
    import_text(&t, text, n);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    free(text);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, N - 1);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_BAD_ROW], 1);
    assert_int_equal(t.qsm.repairs.first[WF_REPAIR_BAD_ROW], BAD + 1);
    assert_non_null(strstr(t.diag.first->text, ":54322: z0: '?' is not a number"));
    print_message("100k rows read and repaired in %.3f s\n", seconds);
    wf_arena_free(&t.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_wart_is_repaired_and_counted),
        cmocka_unit_test(strict_names_every_kind),
        cmocka_unit_test(the_cut_off_row_is_named),
        cmocka_unit_test(what_is_no_tree_is_refused),
        cmocka_unit_test(a_diameter_in_centimetres_is_suspected),
        cmocka_unit_test(unconnected_rows_are_not_a_tree),
        cmocka_unit_test(damaged_files_survive),
        cmocka_unit_test(one_bad_row_in_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
