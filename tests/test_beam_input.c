/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the structural engine refuses, and that it never does more than refuse: every memory request of every
 * solver is denied once. */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
static size_t takes_left = SIZE_MAX;
static void *refusable(size_t n, size_t size);
#define calloc refusable
#include "base/arena.c"
#undef calloc
#include "beam_cases.h"
#include "solve/modes.h"

/* The arena's blocks come from here, so that memory can be denied. */
static void *refusable(size_t n, size_t size)
{
    if (!takes_left) return NULL;
    takes_left--;
    return calloc(n, size);
}

static void refused(struct beam_case *c, const char *says)
{
    const struct wf_solver *solver[] = { &wf_solver_beam, &wf_solver_linear };
    double number[2];
    for (int k = 0; k < 4; k++) {
        c->diag = (struct wf_diag){ .arena = &c->arena };
        c->err = (struct wf_err){ 0 };
        enum wf_status s = WF_OK;
        if (k < 2) s = beam_try(c, solver[k]);
        if (k == 2) s = wf_modes(&c->tree, &c->loads, &c->options, 2, &c->arena, number, NULL, &c->err);
        if (k == 3) s = wf_buckling(&c->tree, &c->loads, &c->options, &c->arena, number, &c->err);
        if (s != WF_EINPUT) fail_msg("solver %d, '%s' wanted: status %d %s", k, says, s, c->err.text);
        const char *text = k < 2 && c->diag.first ? c->diag.first->text : c->err.text;
        if (k < 2 && !strstr(text, says)) fail_msg("solver %d: '%s' lacks '%s'", k, text, says);
    }
    beam_free(c);
}

static void bad_trees(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    c.tree.x1[3] = NAN;
    refused(&c, "segment 4: a value is not a finite number");
    beam_tree7(&c);
    c.tree.x0[3] += 0.01;
    refused(&c, "segment 4 starts 0.01 m away from the end of its parent 2");
    beam_tree7(&c);
    c.tree.parent[2] = 5;
    refused(&c, "segment 3: the parent is not an earlier row");
    beam_tree7(&c);
    c.tree.r1[6] = 0;
    refused(&c, "segment 7: the outer radius is not positive");
    beam_tree7(&c);
    c.tree.i0[5] = c.tree.r0[5];
    refused(&c, "segment 6: the inner radius is not below the outer");
    beam_tree7(&c);
    c.tree.youngs[1] = 0;
    refused(&c, "segment 2: a modulus is not positive");
    beam_tree7(&c);
    c.tree.x1[4] = c.tree.x0[4], c.tree.y1[4] = c.tree.y0[4], c.tree.z1[4] = c.tree.z0[4];
    refused(&c, "segment 5: the segment has no length");
    beam_tree7(&c);
    c.tree.bend = WF_TAKE(&c.arena, 21, double);
    c.tree.bend[1] = 3;
    refused(&c, "segment 1: the initial curvature is too strong");
    beam_tree7(&c);
    c.tree.n = 0;
    refused(&c, "no segments");
}

static void bad_loads(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    beam_push(&c, 7, WF_POINT_DEAD, 1, 0, 0);
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    assert_non_null(strstr(c.err.text, "point load 1"));
    assert_int_equal(beam_try(&c, &wf_solver_linear), WF_EINPUT);
    c.point[0].segment = -1;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    c.point[0].segment = 6;
    c.point[0].force[1] = NAN;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    c.loads.points = 0;
    beam_blow(&c, 10, 0, 0);
    c.wind.speed = NAN;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    assert_non_null(strstr(c.err.text, "not a finite number"));
    beam_blow(&c, 10, 0, 0);
    c.loads.gravity = INFINITY;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    assert_int_equal(beam_try(&c, &wf_solver_linear), WF_EINPUT);
    c.loads.gravity = 9.81;
    beam_line(&c, 0, NAN, 0);
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_EINPUT);
    c.loads.line = NULL;
    assert_int_equal(beam_try(&c, &wf_solver_beam), WF_OK);
    beam_free(&c);
}

static enum wf_status any(struct beam_case *c, int what)
{
    double number[6];
    switch (what) {
    case 0:
        return beam_try(c, &wf_solver_beam);
    case 1:
        return beam_try(c, &wf_solver_linear);
    case 2:
        return wf_modes(&c->tree, &c->loads, &c->options, 2, &c->arena, number, NULL, &c->err);
    default:
        return wf_buckling(&c->tree, &c->loads, &c->options, &c->arena, number, &c->err);
    }
}

/* A heavy stem that falls over (load steps, creep, finer meshes): deny each block of memory in turn. */
static void no_memory(void **state)
{
    (void)state;
    for (int what = 0; what < 4; what++) {
        bool done = false;
        size_t refusals = 0;
        for (size_t block = 0; !done; block++) {
            struct beam_case c;
            takes_left = SIZE_MAX;
            beam_stem(&c, 200, upright, 33, 0.1, 0.1);
            beam_masses(&c);
            c.loads.gravity = 9.81;
            c.options.mesh_tolerance = 1e-5;
            wf_arena_drop_spare(); /* memory that is kept is not asked for */
            takes_left = block;
            enum wf_status s = any(&c, what);
            done = s == WF_OK;
            if (!done) {
                if (s != WF_ENOMEM) fail_msg("solver %d, block %zu: %d %s", what, block, s, c.err.text);
                assert_true(c.err.text[0]);
                refusals++;
            }
            takes_left = SIZE_MAX;
            beam_free(&c);
        }
        assert_true(refusals > 2);
    }
}

/* The caller's own limit is kept to: every smaller one is refused. */
static void small_arena(void **state)
{
    (void)state;
    struct beam_case c;
    beam_tree7(&c);
    size_t start = c.arena.used, refusals = 0;
    for (size_t more = 1;; more += 64) {
        c.arena.limit = start + more;
        enum wf_status s = beam_try(&c, &wf_solver_beam);
        if (s == WF_OK) break;
        assert_int_equal(s, WF_ENOMEM);
        refusals++;
        start = c.arena.used; /* what the refused run took of it stays taken */
    }
    assert_true(refusals > 3);
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_trees),
        cmocka_unit_test(bad_loads),
        cmocka_unit_test(no_memory),
        cmocka_unit_test(small_arena),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
