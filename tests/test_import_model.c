/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From cylinders to connected segments, and materials on them. */
#include "close.h"
#include "data/species.h"
#include "imported.h"

#define DATA "tests/data/qsm/"

/* Segments of one kind that came from the row with this id, counted. */
static size_t count(const struct imported *t, const struct wf_qsm_model *m, int64_t id,
                    enum wf_segment_kind kind)
{
    size_t n = 0;
    for (size_t i = 0; i < m->tree.n; i++) n += t->qsm.id[m->row[i]] == id && m->kind[i] == kind;
    return n;
}

static size_t find(const struct imported *t, const struct wf_qsm_model *m, int64_t id,
                   enum wf_segment_kind kind)
{
    for (size_t i = 0; i < m->tree.n; i++)
        if (t->qsm.id[m->row[i]] == id && m->kind[i] == kind) return i;
    fail_msg("no such segment");
    return 0;
}

/* The stem is 0.1, 0.08, 0.06 thick; branch 4 starts on its surface at 1.5 m, branch 5 0.2 m beyond it at 2.5
 * m. */
static void branches_are_held_where_they_grow(void **state)
{
    (void)state;
    struct imported t;
    struct wf_qsm_model m;
    import_path(&t, DATA "normalised.csv");
    assert_joined(&t, WF_JOINT_AXIS, &m);
    assert_int_equal(m.laterals, 2);
    assert_int_equal(m.links, 2);
    assert_int_equal(m.bridges, 1);
    assert_int_equal(m.gaps, 0);
    assert_int_equal(count(&t, &m, 2, WF_SEGMENT_WOOD), 2);
    assert_int_equal(count(&t, &m, 3, WF_SEGMENT_WOOD), 2);
    size_t link = find(&t, &m, 4, WF_SEGMENT_LINK);
    assert_close(m.tree.z0[link], 1.5, 1e-12);
    assert_close(m.tree.x0[link], 0.0, 1e-12);
    assert_close(m.tree.x1[link], 0.08, 1e-12);
    assert_close(m.tree.r0[link], 0.06, 1e-12); /* three times the branch's own, below the parent's 0.08 */
    size_t bridge = find(&t, &m, 5, WF_SEGMENT_BRIDGE);
    assert_close(m.tree.y0[bridge], 0.06, 1e-12);
    assert_close(m.tree.y1[bridge], 0.26, 1e-12);
    assert_close(m.tree.r0[bridge], 0.02, 1e-12);
    assert_close(m.widest_gap, 0.2, 1e-9);
    assert_close(m.bridge_volume, M_PI * 0.02 * 0.02 * 0.2, 1e-9);
    assert_close(m.volume, t.metrics.volume + m.bridge_volume, 1e-12);
    assert_close(segment_volume(&m), m.volume, 1e-12);
    wf_arena_free(&t.arena);
}

static void bridging_is_one_segment_a_cylinder(void **state)
{
    (void)state;
    struct imported t;
    struct wf_qsm_model m;
    import_path(&t, DATA "normalised.csv");
    assert_joined(&t, WF_JOINT_BRIDGE, &m);
    assert_int_equal(m.tree.n, 5);
    assert_int_equal(m.links + m.bridges, 0);
    assert_int_equal(m.gaps, 2);
    /* branch 4 now leaves the stem at 2 m and ends where it did: (1.08, 0, 1.5) */
    assert_close(m.tree.z0[3], 2.0, 1e-12);
    assert_close(wf_tree_length(&m.tree, 3), hypot(1.08, 0.5), 1e-12);
    assert_close(m.tree.r1[3], 0.02, 1e-15);
    wf_arena_free(&t.arena);
}

static void tables_without_gaps_stay_as_they_are(void **state)
{
    (void)state;
    struct imported t;
    struct wf_qsm_model m;
    import_path(&t, DATA "plain.csv");
    for (int joint = 0; joint < 2; joint++) {
        assert_joined(&t, (enum wf_joint)joint, &m);
        assert_int_equal(m.tree.n, 3);
        assert_close(m.volume, t.metrics.volume, 1e-12);
        assert_close(m.tree.r1[2], 0.01, 1e-15);
        assert_int_equal(m.tree.level[2], 1);
    }
    wf_arena_free(&t.arena);
}

/* Branches nearer than a tenth of the radius share a point; a branch from the very base does not hang on the
 * ground; a row of 0.1 mm is drawn together with its neighbour. */
static void close_branches_and_tiny_rows(void **state)
{
    (void)state;
    static const char text[] =
        "id,parent,extension,start_x,start_y,start_z,axis_x,axis_y,axis_z,length,radius,branch_order\n"
        "1,0,2,0,0,0,0,0,1,1,0.1,0\n"
        "2,1,3,0,0,1,0,0,1,0.0001,0.1,0\n"
        "3,2,0,0,0,1.0001,0,0,1,1,0.1,0\n"
        "4,1,0,0.1,0,0.5,1,0,0,1,0.01,1\n"
        "5,1,0,0,0.1,0.505,0,1,0,1,0.01,1\n"
        "6,1,0,0,-0.1,0,0,-1,0,1,0.01,1\n"
        "7,3,0,0.05,0,1.5,0,0,1,1,0.01,1\n";
    struct imported t;
    struct wf_qsm_model m;
    import_text(&t, text, sizeof text - 1);
    assert_int_equal(t.status, WF_OK);
    assert_joined(&t, WF_JOINT_AXIS, &m);
    assert_int_equal(m.short_rows, 1);
    assert_int_equal(count(&t, &m, 2, WF_SEGMENT_WOOD), 0);
    assert_int_equal(count(&t, &m, 1, WF_SEGMENT_WOOD), 3); /* divided at 0.01 and 0.5 m */
    size_t roots = 0;
    for (size_t i = 0; i < m.tree.n; i++) roots += m.tree.parent[i] < 0;
    assert_int_equal(roots, 1);
    size_t four = find(&t, &m, 4, WF_SEGMENT_LINK), five = find(&t, &m, 5, WF_SEGMENT_LINK);
    assert_int_equal(m.tree.parent[four], m.tree.parent[five]);
    /* a start inside the parent: the link ends there and no bridge is needed */
    assert_int_equal(count(&t, &m, 7, WF_SEGMENT_BRIDGE), 0);
    assert_close(wf_tree_length(&m.tree, find(&t, &m, 7, WF_SEGMENT_LINK)), 0.05, 1e-5);
    wf_arena_free(&t.arena);
}

static void materials_follow_levels(void **state)
{
    (void)state;
    struct imported t;
    struct wf_qsm_model m;
    import_path(&t, DATA "normalised.csv");
    assert_int_equal(wf_qsm_to_tree(&t.qsm, WF_JOINT_AXIS, &t.arena, &m, &t.err), WF_OK);
    double s[] = { 0, 1 }, share[] = { 0.2, 0.4 };
    struct wf_level level[2] = {
        { .youngs_modulus.value = 9e9,
          .shear_modulus.value = 6e8,
          .density.value = 900,
          .knot_factor.value = 0.8,
          .modulus_of_rupture = { .value = 5e7, .given = true },
          .damping_ratio.value = 0.01,
          .wall = { 2, s, share } },
        { .youngs_modulus.value = 7e9,
          .shear_modulus.value = 5e8,
          .density.value = 800,
          .knot_factor.value = 1,
          .drag_coefficient = { .value = 0.9, .given = true } },
    };
    struct wf_species sp = { .key = "test", .levels = 1, .level = level };
    sp.crown.drag_coefficient.value = 0.5, sp.crown.frontal_share.value = 0.3,
    sp.crown.leaf_mass_per_area.value = 0.2;
    struct wf_clothing c = { .leaf_area = 10, .kind = m.kind };
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_OK);
    size_t branch = find(&t, &m, 4, WF_SEGMENT_WOOD), top = find(&t, &m, 3, WF_SEGMENT_WOOD);
    assert_close(m.tree.youngs[branch], 9e9, 1e-15); /* one level only: it is the last one too */
    sp.levels = 2;
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_OK);
    assert_close(m.tree.youngs[branch], 7e9, 1e-15);
    level[1].radius = (struct wf_value){ .high = 0.99 * m.tree.r0[branch], .given = true };
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_OK);
    assert_close(m.tree.youngs[branch], 9e9, 1e-15); /* too thick for its order: wood of the level below */
    level[1].radius.high = m.tree.r0[branch];
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_OK);
    assert_close(m.tree.youngs[branch], 7e9, 1e-15);
    assert_close(m.tree.strength[0], 4e7, 1e-12);
    assert_close(m.tree.strength[branch], 0, 0);
    assert_true(isnan(m.tree.drag[0]));
    assert_close(m.tree.drag[branch], 0.9, 1e-15);
    /* wall: 0.2 of the radius at the stem's foot, 0.4 at its top, half way at 2 m */
    assert_close(m.tree.i0[0], 0.1 * 0.8, 1e-12);
    assert_close(m.tree.i0[top], 0.06 * (1 - 0.3), 1e-12);
    assert_close(m.tree.i0[branch], 0, 0);
    size_t link = find(&t, &m, 4, WF_SEGMENT_LINK);
    assert_close(m.tree.density[link], 0, 0);
    assert_close(m.tree.drag[link], 0, 0);
    assert_true(m.tree.youngs[link] > 0);
    double leaf = 0, sail = 0, mass = 0;
    for (size_t i = 0; i < m.tree.n; i++) {
        double l = wf_tree_length(&m.tree, i);
        leaf += m.tree.leaf0[i] * l, sail += m.tree.sail1[i] * l, mass += m.tree.burden0[i] * l;
        if (m.tree.parent[i] < 0) assert_close(m.tree.leaf0[i], 0, 0);
    }
    assert_close(leaf, 10, 1e-12);
    assert_close(sail, 10 * 0.3 * 0.5, 1e-12);
    assert_close(mass, 2, 1e-12);
    c.leaf_area = 0;
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_OK);
    assert_close(m.tree.leaf0[branch], 0, 0);
    c.leaf_area = -1;
    assert_int_equal(wf_clothe(&m.tree, &sp, &c, &t.arena, &t.err), WF_EINPUT);
    wf_arena_free(&t.arena);
}

static void sail_and_drag_of_one_cylinder(void **state)
{
    (void)state;
    static const char text[] = "id,parent,x0,y0,z0,x1,y1,z1,radius\n1,0,0,0,0,3,0,4,0.1\n";
    struct imported t;
    double force, moment;
    import_text(&t, text, sizeof text - 1);
    assert_close(wf_qsm_sail(&t.qsm, 0), 0.2 * 5 * 0.8, 1e-12); /* sin of the angle to +x = 4/5 */
    assert_close(wf_qsm_sail(&t.qsm, M_PI / 2), 0.2 * 5, 1e-12);
    wf_qsm_drag(&t.qsm, 100, 1.2, 0, &force, &moment);
    assert_close(force, 100 * 1.2 * 0.2 * 5 * 0.64, 1e-12);
    assert_close(moment, force * 2, 1e-12);
    wf_arena_free(&t.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_are_held_where_they_grow),
        cmocka_unit_test(bridging_is_one_segment_a_cylinder),
        cmocka_unit_test(tables_without_gaps_stay_as_they_are),
        cmocka_unit_test(close_branches_and_tiny_rows),
        cmocka_unit_test(materials_follow_levels),
        cmocka_unit_test(sail_and_drag_of_one_cylinder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
