/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small files of kinds that people ask about: several trees in one table, missing radii, branches thicker
 * than what they grow on, removed rows. Each is read as it is and varied: other units, other separators and
 * decimal signs, rows in another order. */
#include "close.h"
#include "data/species.h"
#include "imported.h"
#include <ctype.h>

#define PUBLIC "tests/data/public/"

enum variant { AS_IT_IS, CENTIMETRES, SEMICOLONS, REVERSED, VARIANTS };

static bool is_length(const char *name)
{
    static const char *const starts[] = { "x0", "y0",    "z0",  "x1",     "y1",
                                          "z1", "start", "end", "radius", "length" };
    for (size_t k = 0; k < sizeof starts / sizeof *starts; k++)
        if (!strncmp(name, starts[k], strlen(starts[k]))) return true;
    return false;
}

static size_t put_cell(char *to, const char *cell, const char *name, bool header, enum variant v)
{
    char *end;
    double x = strtod(cell, &end);
    bool number = end != cell && !*end, length = is_length(name);
    if (v == CENTIMETRES && length && header) return (size_t)sprintf(to, "%s_cm", cell);
    size_t n = (size_t)(v == CENTIMETRES && length && number ? sprintf(to, "%.12g", 100 * x)
                                                             : sprintf(to, "%s", cell));
    if (v == SEMICOLONS && strchr(to, '.')) *strchr(to, '.') = ',';
    return n;
}

/* A table of the folder in a variant; `from` (NULL: nothing) is replaced by `to` first. */
static void import_variant(struct imported *t, const char *file, enum variant v, const char *from,
                           const char *to, struct wf_import_options o)
{
    char path[128], text[4096] = "", *line[64], *name[32], out[8192];
    snprintf(path, sizeof path, PUBLIC "%s", file);
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    size_t size = fread(text, 1, sizeof text - 256, f), lines = 0, n = 0;
    fclose(f);
    assert_true(size > 0);
    for (char *at = text; from && (at = strstr(at, from)); at += strlen(to)) {
        memmove(at + strlen(to), at + strlen(from), strlen(at + strlen(from)) + 1);
        memcpy(at, to, strlen(to));
    }
    for (char *p = strtok(text, "\n"); p; p = strtok(NULL, "\n")) line[lines++] = p;
    for (size_t k = 0; k < lines; k++) {
        char *row = line[v == REVERSED && k ? lines - k : k];
        for (size_t c = 0; row; c++) {
            char *cell = strsep(&row, ",");
            if (!k) name[c] = cell;
            n += (size_t)sprintf(out + n, "%s", c ? v == SEMICOLONS ? ";" : "," : "");
            n += put_cell(out + n, cell, name[c], !k, v);
        }
        n += (size_t)sprintf(out + n, "\n");
    }
    struct scratch s;
    scratch_write(&s, out, n);
    import_with(t, s.path, o);
    scratch_remove(&s);
}

static void refused(struct imported *t, const char *const *words)
{
    assert_int_equal(t->status, WF_EINPUT);
    for (; *words; words++)
        if (!strstr(t->err.text, *words)) fail_msg("'%s' lacks '%s'", t->err.text, *words);
    wf_arena_free(&t->arena);
}

static const struct wf_finding *finding(const struct imported *t, const char *code)
{
    for (const struct wf_finding *f = t->diag.first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return f;
    return NULL;
}

static size_t row_of(const struct wf_qsm *q, int64_t id)
{
    for (size_t i = 0; i < q->n; i++)
        if (q->id[i] == id) return i;
    fail_msg("no row with id %lld", (long long)id);
    return 0;
}

static void one_of_two_trees_is_chosen(void **state)
{
    (void)state;
    static const double volume[] = { M_PI * (0.11 * 0.11 * 1.5 + 0.09 * 0.09 * 1.5),
                                     M_PI * (0.15 * 0.15 * 1.5 + 0.12 * 0.12 * 1.8) };
    for (int v = 0; v < VARIANTS; v++) {
        struct imported t;
        struct wf_import_options o = wf_import_default();
        import_variant(&t, "two_trees.csv", (enum variant)v, NULL, NULL, o);
        refused(&t, (const char *const[]){ "2 trees in one table", "'1' (2 rows", "'2' (2 rows", "base at",
                                           "--tree-id", NULL });
        for (int k = 0; k < 2; k++) {
            o.tree_id = k ? "2" : "1";
            import_variant(&t, "two_trees.csv", (enum variant)v, NULL, NULL, o);
            assert_int_equal(t.status, WF_OK);
            assert_sound(&t.qsm);
            assert_int_equal(t.qsm.n, 2);
            assert_close(t.metrics.volume, volume[k], 1e-9);
            assert_int_equal(t.metrics.stems, 1);
            wf_arena_free(&t.arena);
        }
        o.tree_id = "3";
        import_variant(&t, "two_trees.csv", (enum variant)v, NULL, NULL, o);
        refused(&t, (const char *const[]){ "no row has '3'", "'1' (2 rows", NULL });
        /* the numbers of a tree begin again: no column is needed to see two trees, and no option takes them
         */
        o = wf_import_default();
        o.force = true;
        import_variant(&t, "two_trees.csv", (enum variant)v, "treeID", "remark", o);
        refused(&t, (const char *const[]){ "several trees", "treeID", NULL });
    }
}

static void one_tree_id_is_one_tree(void **state)
{
    (void)state;
    struct imported t;
    static const char text[] = "id,parent,x0,y0,z0,x1,y1,z1,radius,tree\n1,0,0,0,0,0,0,2,0.1,oak A\n"
                               "2,1,0,0,2,0,0,4,0.1,oak A\n";
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 2);
    wf_arena_free(&t.arena);
    struct wf_import_options o = wf_import_default();
    o.tree_id = "1";
    import_variant(&t, "radius_na.csv", AS_IT_IS, NULL, NULL, o);
    refused(&t, (const char *const[]){ "no column treeID", NULL });
}

/* Two stems with numbers of their own, `apart` metres from each other. */
static void import_stems(struct imported *t, double apart, bool force)
{
    char text[512];
    struct scratch s;
    struct wf_import_options o = wf_import_default();
    o.force = force;
    int n = snprintf(text, sizeof text,
                     "id,parent,x0,y0,z0,x1,y1,z1,radius\n1,0,0,0,0,0,0,2,0.1\n2,1,0,0,2,0,0,4,0.1\n"
                     "3,0,%g,0,0.1,%g,0,2,0.05\n4,3,%g,0,2,%g,0,3,0.05\n",
                     apart, apart, apart, apart);
    scratch_write(&s, text, (size_t)n);
    import_with(t, s.path, o);
    scratch_remove(&s);
}

static void stems_metres_apart_are_trees(void **state)
{
    (void)state;
    struct imported t;
    import_stems(&t, 1.5, false);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.metrics.stems, 2);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_APART], 0);
    wf_arena_free(&t.arena);
    import_stems(&t, 8.2, false);
    refused(&t, (const char *const[]){ "1 stem stands more than 2 m", "id 3 at (8.2, 0), 8.2 m away",
                                       "--force", NULL });
    import_stems(&t, 8.2, true);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.metrics.stems, 2);
    assert_int_equal(t.qsm.repairs.count[WF_NOTE_APART], 1);
    assert_non_null(strstr(finding(&t, "stems-apart")->text, "8.2 m away"));
    wf_arena_free(&t.arena);
}

static void a_missing_radius_keeps_its_row(void **state)
{
    (void)state;
    static const char *const marks[] = { "#N/A", "#DIV/0!", "inf",   "-Inf", "Infinity", "#WERT!",
                                         "NaN",  "",        "#REF!", "NA",   "0" };
    for (int v = 0; v < VARIANTS; v++)
        for (size_t k = 0; k < sizeof marks / sizeof *marks; k++) {
            struct imported t;
            struct wf_qsm_model m;
            import_variant(&t, "radius_na.csv", (enum variant)v, "#N/A", marks[k], wf_import_default());
            assert_int_equal(t.status, WF_OK);
            assert_sound(&t.qsm);
            assert_int_equal(t.qsm.n, 3);
            assert_close(t.metrics.volume, M_PI * 2 * (0.12 * 0.12 + 0.12 * 0.12 + 0.08 * 0.08), 1e-9);
            assert_int_equal(t.qsm.repairs.count[WF_REPAIR_RADIUS], 1);
            assert_int_equal(t.qsm.repairs.first[WF_REPAIR_RADIUS], 2);
            assert_joined(&t, WF_JOINT_AXIS, &m);
            assert_int_equal(m.laterals + m.bridges, 0);
            wf_arena_free(&t.arena);
        }
    /* the same in a table without a header */
    static const char bare[] = "0.1 1 0 0 0 0 0 1 0 2 1 0 1 0\ninf 1 0 0 1 0 0 1 1 3 1 0 2 0\n"
                               "#N/A 1 0 0 2 0 0 1 2 0 1 0 3 0\n";
    struct imported t;
    import_text(&t, bare, sizeof bare - 1);
    assert_int_equal(t.status, WF_OK);
    assert_int_equal(t.qsm.n, 3);
    assert_close(t.metrics.volume, M_PI * 0.03, 1e-9);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_RADIUS], 2);
    wf_arena_free(&t.arena);
}

static void thick_branches_are_named_and_capped(void **state)
{
    (void)state;
    double thin = hypot(0.5, 0.2), thick = hypot(1, 0.7);
    for (int v = 0; v < VARIANTS; v++) {
        struct imported t;
        struct wf_import_options o = wf_import_default();
        import_variant(&t, "thick_child.csv", (enum variant)v, NULL, NULL, o);
        assert_int_equal(t.status, WF_OK);
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_THICKENING], 1);
        assert_int_equal(t.qsm.repairs.first[WF_NOTE_THICKENING], 4);
        assert_non_null(strstr(finding(&t, "thickening")->text, "id 4, 66 mm on 5 mm"));
        double others = M_PI * (4 * 0.12 * 0.12 + 4 * 0.1 * 0.1 + thin * 0.0025 * 0.0025);
        assert_close(t.metrics.volume, others + M_PI * thick * 0.033 * 0.033, 1e-9);
        wf_arena_free(&t.arena);
        o.cap_children = true;
        import_variant(&t, "thick_child.csv", (enum variant)v, NULL, NULL, o);
        assert_int_equal(t.status, WF_OK);
        assert_int_equal(t.qsm.repairs.count[WF_REPAIR_CAPPED], 1);
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_THICKENING], 0);
        assert_non_null(strstr(finding(&t, "children-capped")->text, "id 4, 66 mm on 5 mm"));
        assert_close(t.metrics.volume, others + M_PI * thick * 0.0025 * 0.0025, 1e-9);
        assert_close(t.qsm.r0[row_of(&t.qsm, 4)], 0.0025, 1e-12);
        wf_arena_free(&t.arena);
        /* it starts half-way: a side branch, thicker than its parent */
        import_variant(&t, "thick_child.csv", (enum variant)v, "4,3,0.5,0,6.2", "4,3,0.25,0,6.1",
                       wf_import_default());
        assert_int_equal(t.qsm.repairs.count[WF_NOTE_THICK_CHILD], 1);
        assert_non_null(strstr(finding(&t, "thick-child")->text, "id 4, 66 mm on 5 mm"));
        wf_arena_free(&t.arena);
    }
}

static void a_removed_stem_is_refused(void **state)
{
    (void)state;
    for (int v = 0; v < VARIANTS; v++) {
        struct imported t;
        struct wf_import_options o = wf_import_default();
        import_variant(&t, "stem_removed.csv", (enum variant)v, NULL, NULL, o);
        refused(&t, (const char *const[]){ "0.0118 m3", "82.4 %", "2.53 m", "--force", NULL });
        o.force = true;
        import_variant(&t, "stem_removed.csv", (enum variant)v, NULL, NULL, o);
        assert_int_equal(t.status, WF_OK);
        assert_sound(&t.qsm);
        assert_string_equal(t.diag.first->code, "unseen-wood"); /* before all repairs */
        assert_non_null(strstr(t.diag.first->text, "82.4 %"));
        assert_close(t.metrics.volume, M_PI * 0.03 * 0.03 * (hypot(1.4, 1) + hypot(1.4, 1) + hypot(1.3, 1)),
                     1e-9);
        assert_int_equal(t.qsm.repairs.count[WF_REPAIR_ROOT_ORDER], 1);
        assert_int_equal(t.qsm.order[row_of(&t.qsm, 4)], 0);
        assert_int_equal(t.qsm.order[row_of(&t.qsm, 5)], 1);
        assert_int_equal(t.qsm.order[row_of(&t.qsm, 6)], 1);
        wf_arena_free(&t.arena);
    }
}

#define ORDERED "id,parent,x0,y0,z0,x1,y1,z1,radius,branch_order\n"

/* A row of the stem is missing; a branch ends nearer to the upper stem than the lower stem does. */
static void removed_rows_keep_the_orders_of_the_file(void **state)
{
    (void)state;
    static const char text[] = ORDERED "1,0,0,0,0,0,0,3,0.1,0\n"
                                       "3,2,0,0,4,0,0,8,0.1,0\n"
                                       "4,1,0,0,2,0.3,0,4,0.02,1\n"
                                       "5,3,0,0,6,1,0,7,0.02,1\n";
    struct imported t;
    struct wf_qsm_model m;
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    const struct wf_qsm *q = &t.qsm;
    assert_int_equal(q->parent[row_of(q, 3)], row_of(q, 1));
    assert_int_equal(q->next[row_of(q, 1)], row_of(q, 3));
    for (int64_t id = 1; id <= 5; id++)
        if (id != 2) assert_int_equal(q->order[row_of(q, id)], id > 3);
    assert_joined(&t, WF_JOINT_AXIS, &m);
    assert_int_equal(m.laterals, 2);
    wf_arena_free(&t.arena);
}

/* The stem goes on through a row without length; a side branch of that row comes first in the file. */
static void a_removed_row_hands_its_continuation_on(void **state)
{
    (void)state;
#define LINKED "id,parent,extension,x0,y0,z0,x1,y1,z1,radius\n1,0,2,0,0,0,0,0,1,0.1\n"
    static const char *const texts[] = {
        LINKED "2,1,4,0,0,1,0,0,1,0.1\n3,2,0,0,0,1,1,0,1,0.09\n4,2,0,0,0,1,0,0,2,0.05\n", LINKED
        "2,1,5,0,0,1,0,0,1,0.1\n3,2,0,0,0,1,1,0,1,0.09\n5,2,4,0,0,1,0,0,1,0.1\n4,5,0,0,0,1,0,0,2,0.05\n"
    };
    for (int twice = 0; twice < 2; twice++) {
        struct imported t;
        import_text(&t, texts[twice], strlen(texts[twice]));
        assert_int_equal(t.status, WF_OK);
        assert_sound(&t.qsm);
        const struct wf_qsm *q = &t.qsm;
        assert_int_equal(q->repairs.count[WF_REPAIR_ZERO_LENGTH], 1 + twice);
        assert_int_equal(q->next[row_of(q, 1)], row_of(q, 4)); /* not the thicker side branch */
        assert_int_equal(q->order[row_of(q, 4)], 0);
        assert_int_equal(q->order[row_of(q, 3)], 1);
        wf_arena_free(&t.arena);
    }
}

static void every_root_has_order_0(void **state)
{
    (void)state;
    static const char text[] = ORDERED "1,0,0,0,0,0,0,2,0.1,0\n"
                                       "2,0,0.5,0,0,0.5,0,2,0.08,1\n"
                                       "3,2,0.5,0,2,0.5,0,3,0.07,1\n"
                                       "4,2,0.5,0,1,1,0,1,0.02,2\n";
    struct imported t;
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    const struct wf_qsm *q = &t.qsm;
    static const int want[] = { 0, 0, 0, 1 };
    for (int64_t id = 1; id <= 4; id++) assert_int_equal(q->order[row_of(q, id)], want[id - 1]);
    assert_int_equal(q->repairs.count[WF_REPAIR_ROOT_ORDER], 1);
    assert_int_equal(q->repairs.first[WF_REPAIR_ROOT_ORDER], 2);
    assert_int_equal(q->repairs.count[WF_NOTE_ORDER_FROM], 0);
    wf_arena_free(&t.arena);
    /* a root without length: what grew on it stands now */
    static const char point[] =
        ORDERED "1,0,0,0,0,0,0,0,0.1,0\n2,1,0,0,0,0,0,2,0.1,0\n3,1,0,0,0,1,0,1,0.05,1\n";
    import_text(&t, point, sizeof point - 1);
    assert_int_equal(t.status, WF_OK);
    assert_sound(&t.qsm);
    for (size_t i = 0; i < t.qsm.n; i++) assert_int_equal(t.qsm.order[i], 0);
    assert_int_equal(t.qsm.repairs.count[WF_REPAIR_ROOT_ORDER], 1);
    wf_arena_free(&t.arena);
}

/* A branch that starts beside the stem. */
static void gaps_warn_then_refuse(void **state)
{
    (void)state;
    static const struct {
        double away;
        bool warns, refuses;
    } want[] = { { 0.9, false, false }, { 1.3, true, false }, { 3.05, true, false }, { 3.2, true, true } };
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        char text[256];
        struct imported t;
        int n = snprintf(text, sizeof text, ORDERED "1,0,0,0,0,0,0,8,0.1,0\n2,1,%g,0,4,%g,0,5,0.02,1\n",
                         want[k].away, want[k].away + 1);
        import_text(&t, text, (size_t)n);
        assert_int_equal(t.status, want[k].refuses ? WF_EINPUT : WF_OK);
        assert_int_equal(finding(&t, "unseen-wood") != NULL, want[k].warns && !want[k].refuses);
        wf_arena_free(&t.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_of_two_trees_is_chosen),
        cmocka_unit_test(one_tree_id_is_one_tree),
        cmocka_unit_test(stems_metres_apart_are_trees),
        cmocka_unit_test(a_missing_radius_keeps_its_row),
        cmocka_unit_test(thick_branches_are_named_and_capped),
        cmocka_unit_test(a_removed_stem_is_refused),
        cmocka_unit_test(removed_rows_keep_the_orders_of_the_file),
        cmocka_unit_test(a_removed_row_hands_its_continuation_on),
        cmocka_unit_test(every_root_has_order_0),
        cmocka_unit_test(gaps_warn_then_refuse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
