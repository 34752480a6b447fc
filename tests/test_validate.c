/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Validation cases: the format and its mistakes, what passes and what must fail, the shipped files. */
#include "base/file.h"
#include "cases/build.h"
#include "cases/keys.h"
#include "cases/measure.h"
#include "cases/read.h"
#include "cases/run.h"
#include "close.h"
#include <fts.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct reading {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_case *list;
    size_t n;
    enum wf_status status;
};

static void read_path(struct reading *r, const char *path)
{
    *r = (struct reading){ .arena = { 0 } };
    r->diag.arena = &r->arena;
    r->status = wf_case_read(path, &r->arena, &r->diag, &r->list, &r->n, &r->err);
}

static void read_text(struct reading *r, const char *text)
{
    char path[] = "/tmp/windfirm_case_XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    read_path(r, path);
    unlink(path);
}

static void done(struct reading *r) { wf_arena_free(&r->arena); }

#define HEAD "kind closed-form\nsource a textbook\n"
#define MAST HEAD "cantilever 2 m\nradius 10 cm\nyoungs_modulus 1 GPa\npoisson 0.3\nsolver linear\n"
#define ROD HEAD "units none\ncantilever 1\nEI 1\nsolver linear\n"

static struct wf_verdict run(struct reading *r, size_t i)
{
    struct wf_verdict v;
    assert_int_equal(wf_case_run(&r->list[i], 0, 1, &r->arena, &v, &r->err), WF_OK);
    return v;
}

/* Each bad text, the line and column blamed, and words of the message. */
static const struct {
    const char *text;
    size_t line, column;
    const char *words;
} mistakes[] = {
    { MAST "wnat moment base y 1 N m\n", 8, 1, "did you mean 'want'" },
    { HEAD "fit x.yaml\nwant moment base y 1 N m\n", 4, 1, "cannot be wanted of a fit" },
    { HEAD "fit x.yaml\nwant fitted_modulus\n", 4, 20, "name of a fitted parameter" },
    { HEAD "fit\nwant fitted_modulus E 1 GPa\n", 3, 4, "calibration study" },
    { MAST "fit x.yaml\n", 8, 1, "uses that of its study" },
    { MAST "want fitted_modulus E 1 GPa\n", 8, 1, "cannot be wanted of a structure" },
    { HEAD "fit x.yaml\nfree\nwant fitted_modulus E 1 GPa\n", 4, 5, "names of parameters" },
    { HEAD "gust_rule en19\n", 3, 11, "did you mean 'en1991'" },
    { HEAD "gust_rule asce7\nterrain V\n", 4, 9, "unknown terrain" },
    { HEAD "gust_rule asce7\nterrain II\nheight 9 m\nwant gust_resonance 1\n", 6, 1, "breadth is missing" },
    { HEAD "gust_rule asce7\nterrain II\nwant pressure_ratio 1\n", 5, 1, "height is missing" },
    { HEAD "gust_rule asce7\nwant moment base y 1 N m\n", 4, 1, "cannot be wanted of a gust rule" },
    { MAST "gust_rule asce7\n", 8, 1, "another structure" },
    { MAST "want pressure_ratio 1\n", 8, 1, "cannot be wanted of a structure" },
    { MAST "want critical_wind 1 m/s\n", 8, 1, "bending_strength is missing" },
    { HEAD "node 0 0 0 0 m\nnode 1 0 0 1 m\nbranch 0 1 1 1 cm\nyoungs_modulus 1 Pa\npoisson 0\n"
           "want critical_wind 1 m/s\n",
      8, 1, "anything but a cantilever" },
    { MAST "taper 0.5\ntaper_power 0.5\nwant moment base y 1 N m\n", 9, 1, "exclude each other" },
    { MAST "crown_depth 1 m\nwant moment base y 1 N m\n", 1, 1, "crown_width, crown_drag and crown_mass" },
    { MAST "crown_depth 3 m\ncrown_width 1 m\ncrown_drag 1\ncrown_mass 1 kg\nwant moment base y 1 N m\n", 8,
      1, "longer than the stem" },
    { MAST "forse tip 1 0 0 N\n", 8, 1, "did you mean 'force'" },
    { MAST "force tipp 1 0 0 N\n", 8, 7, "did you mean 'tip'" },
    { MAST "force tip 1 0 0 kg\n", 8, 11, "not a unit of a force" },
    { MAST "force tip 1 0 0\n", 8, 11, "force" },
    { MAST "force tip 1 zero 0 N\n", 8, 13, "'zero' is not a number" },
    { MAST "force tip 1 0\n", 8, 14, "3 numbers expected, 2 found" },
    { MAST "force base 1 0 0 N\n", 8, 7, "the base is fixed" },
    { MAST "force node 3 1 0 0 N\nwant moment base y 1 N m\n", 8, 1, "nodes and rows belong to trees" },
    { MAST "want displcement tip x 1 m\n", 8, 6, "did you mean 'displacement'" },
    { MAST "want displacement tip q 1 m\n", 8, 23, "a vector needs three values, or x, y, z or norm" },
    { MAST "want displacement tip x nan m\n", 8, 25, "'nan' is not a number" },
    { MAST "want displacement tip x 0 m\n", 8, 28, "within absolute" },
    { MAST "want displacement tip x 1 m within -2\n", 8, 36, "positive" },
    { MAST "want displacement tip x 1 m within 0.9\n", 8, 29, "must not exceed 0.5" },
    { MAST "want displacement tip - - - m\n", 8, 23, "no value is wanted" },
    { MAST "want displacement at 1.5 x 1 m\n", 8, 22, "0..1" },
    { MAST "want frequency 0 1 Hz\n", 8, 16, "whole number in 1.." },
    { MAST "want frequency 1 1 Hz\n", 8, 1, "density" },
    { MAST "radius 5 cm\nwant moment base y 1 N m\n", 8, 1, "given twice; first on line 4" },
    { MAST "arc 1 m angle 45 deg from 0 0 1 towards 1 0 0\n", 8, 1, "another structure" },
    { MAST "wind 10 0 0 m/s\nwant moment base y 1 N m\n", 1, 1, "drag_coefficient" },
    { MAST "model SR\nwant moment base y 1 N m\n", 1, 1, "shear_factor" },
    { HEAD "solver baem\n", 3, 8, "did you mean 'beam'" },
    { MAST "mesh tolerance 2\n", 8, 16, "between 0 and 1" },
    { MAST "order 4 2\n", 8, 9, "whole number in 5.." },
    { MAST "inner_radius 11 cm\nwant moment base y 1 N m\n", 1, 1, "smaller than radius" },
    { MAST "case one two\nwant moment base y 1 N m\n", 8, 10, "one word" },
    { MAST "case a\nwant moment base y 1 N m\ncase a\nwant moment base y 1 N m\n", 10, 6,
      "defined on line 8" },
    { MAST, 1, 1, "a wanted value" },
    { ROD "force tip 1 0 0 N\n", 7, 17, "without units" },
    { ROD "taper 1.5\n", 7, 7, "outside the allowed range" },
    { ROD "EA 5\nwant moment base y 1\n", 1, 1, "all four" },
    { HEAD "arc 1 m angle 45 deg from 0 0 1 towards 0 0.1 1\n", 3, 5, "perpendicular" },
    { HEAD "node 0 0 0 0 m\nnode 1 0 0 1 m\nbranch 0 2 1 1 cm\n", 5, 10, "no node 2" },
    { HEAD "node 0 0 0 0 m\nnode 1 0 0 1 m\nnode 2 0 0 2 m\nbranch 0 1 1 1 cm\nbranch 2 1 1 1 cm\n", 7, 10,
      "already reached" },
    { "source x\ncantilever 1 m\n", 1, 1, "kind is missing" },
    { "", 1, 1, "kind is missing" },
};

static void test_mistakes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        struct reading r;
        read_text(&r, mistakes[i].text);
        const struct wf_finding *f = r.diag.first;
        if (r.status != WF_EINPUT || !f) fail_msg("case %zu was accepted:\n%s", i, mistakes[i].text);
        bool found = false;
        for (; f && !found; f = f->next)
            found = f->line == mistakes[i].line && f->column == mistakes[i].column &&
                    strstr(f->text, mistakes[i].words);
        if (!found)
            fail_msg("case %zu: wanted %zu:%zu '%s', got %zu:%zu '%s'", i, mistakes[i].line,
                     mistakes[i].column, mistakes[i].words, r.diag.first->line, r.diag.first->column,
                     r.diag.first->text);
        done(&r);
    }
}

static void test_all_mistakes_at_once(void **state)
{
    (void)state;
    struct reading r;
    read_text(&r, HEAD "cantilever 2 kg\nradius -1 cm\nyung 3\nforce tip a 0 0 N\nwant stuff 3\n");
    assert_int_equal(r.diag.errors, 5);
    done(&r);
}

static void test_pass_and_fail(void **state)
{
    (void)state;
    struct reading r;
    /* tip force on EI = L = 1: deflection 1/3, rotation 1/2, base moment 1 */
    read_text(&r, ROD "force tip 1 0 0\n"
                      "case right\nwant moment base y 1\nwant rotation tip y 0.5\n"
                      "case wrong\nwant moment base y 1\nwant rotation tip y 0.500001\n"
                      "case wide\nwant rotation tip y 0.500001 within 1e-5\n"
                      "case narrow\ntolerance 1e-7\nwant moment base y 1.0000005\n"
                      "case sign\nwant moment base y -1\n"
                      "case zero\nwant moment base 0 1 0\nwant moment base x 0 within absolute 1e-12\n"
                      "case vector\nwant moment base 0.0000005 1 -\n"
                      "case norm\nwant moment base norm 1\n");
    assert_int_equal(r.status, WF_OK);
    assert_int_equal(r.n, 8);
    const enum wf_outcome wanted[8] = { WF_PASSED, WF_FAILED, WF_PASSED, WF_FAILED,
                                        WF_FAILED, WF_PASSED, WF_PASSED, WF_PASSED };
    for (size_t i = 0; i < 8; i++)
        if (run(&r, i).outcome != wanted[i])
            fail_msg("case %s: outcome %d", r.list[i].name, (int)run(&r, i).outcome);
    struct wf_verdict v = run(&r, 1);
    assert_int_equal(v.n, 2);
    assert_int_equal(v.failed, 1);
    assert_true(v.check[0].passed && !v.check[1].passed);
    assert_close(v.check[1].error, 1e-6, 1e-3);
    assert_close(v.worst, 1e-6 / 0.500001 / 1e-6, 1e-3);
    assert_int_equal(run(&r, 6).n, 2); /* '-' is not compared */
    done(&r);
}

/* What a case adds is its own: neither the header's nor its neighbour's. */
static void test_cases_are_apart(void **state)
{
    (void)state;
    struct reading r;
    read_text(&r, ROD "want moment base y 1\n"
                      "case a\nforce tip 1 0 0\n"
                      "case b\nforce tip 0.5 0 0\nforce tip 0.25 0 0\nforce at 0.5 0.5 0 0\n"
                      "case c\ntolerance 1e-2\nforce tip 1.005 0 0\n"
                      "case d\nforce tip 1.005 0 0\n");
    assert_int_equal(r.status, WF_OK);
    assert_int_equal(run(&r, 0).outcome, WF_PASSED);
    assert_int_equal(run(&r, 1).outcome, WF_PASSED);
    assert_int_equal(run(&r, 2).outcome, WF_PASSED);
    assert_int_equal(run(&r, 3).outcome, WF_FAILED);
    done(&r);
}

/* A solver that reports an error makes a failed case with a reason, not a passed one. */
static void test_solver_error_fails(void **state)
{
    (void)state;
    struct reading r;
    read_text(&r, HEAD "units none\ncantilever 1\nEI 1\nmodel K\nsolver beam\nweight_parameter 9\n"
                       "force tip 1e-3 0 0\nwant moment base y 1\n");
    assert_int_equal(r.status, WF_OK);
    struct wf_verdict v = run(&r, 0);
    assert_int_equal(v.outcome, WF_FAILED);
    done(&r);
}

static void test_missing_tree_is_skipped(void **state)
{
    (void)state;
    struct reading r;
    read_text(&r,
              HEAD "tree nowhere.csv\nyoungs_modulus 1 GPa\npoisson 0.3\nsolver linear\nforce row 1 1 0 0 N\n"
                   "want displacement row 1 x 1 m\n");
    assert_int_equal(r.status, WF_OK);
    struct wf_verdict v = run(&r, 0);
    assert_int_equal(v.outcome, WF_SKIPPED);
    assert_non_null(strstr(v.why, "nowhere.csv"));
    done(&r);
}

static void test_unknown_row(void **state)
{
    (void)state;
    struct reading r;
    read_text(&r,
              HEAD "node 0 0 0 0 m\nnode 1 0 0 1 m\nbranch 0 1 1 1 cm\nyoungs_modulus 1 GPa\npoisson 0.3\n"
                   "solver linear\nwant displacement node 7 x 1 m\n");
    struct wf_verdict v = run(&r, 0);
    assert_int_equal(v.outcome, WF_FAILED);
    assert_non_null(strstr(v.why, ":9: there is no node or row 7"));
    done(&r);
}

/* Cauchy number and weight parameter become air density and gravity. */
static void test_parameters(void **state)
{
    (void)state;
    struct reading r;
    struct wf_setup s;
    read_text(&r, ROD
              "cauchy 100\ndrag_coefficient 2\nweight_parameter 5\nmass_per_length 3\nwant force base x 1\n");
    assert_int_equal(wf_setup_build(&r.list[0], 4, &r.arena, &s, &r.err), WF_OK);
    assert_int_equal(s.tree.n, 4);
    double d = 2 * s.tree.r0[0], area = 3.14159265358979323846 * d * d / 4;
    assert_close(0.5 * s.loads.air_density * 2 * d, 100, 1e-14);
    assert_close(s.tree.density[0] * area, 3, 1e-14);
    assert_close(3 * s.loads.gravity, 5, 1e-14);
    assert_close(s.tree.youngs[0] * area * d * d / 16, 1, 1e-14);
    done(&r);
}

/* Splitting an arc keeps every point on its circle, and the parts equal. */
static void test_split_arc(void **state)
{
    (void)state;
    struct reading r;
    struct wf_setup s;
    struct wf_tree fine;
    double *line;
    read_text(&r,
              HEAD "units none\narc 100 angle 0.7853981633974483 from 0 1 0 towards 1 0 0\nEI 1\nmodel K\n"
                   "line_load 0 0 1\nwant position tip 29.2893218813 70.7106781187 0\n");
    assert_int_equal(wf_setup_build(&r.list[0], 1, &r.arena, &s, &r.err), WF_OK);
    assert_int_equal(s.tree.n, 1);
    assert_close(s.tree.x1[0], 29.289321881345254, 1e-14);
    assert_close(s.tree.bend[2], -0.01, 1e-14); /* from +y towards +x turns about -z */
    assert_int_equal(wf_tree_split(&s.tree, s.loads.line, 5, &r.arena, &fine, &line, &r.err), WF_OK);
    for (size_t i = 0; i < 5; i++) {
        assert_close(hypot(fine.x1[i] - 100, fine.y1[i]), 100, 1e-13);
        assert_close(hypot(fine.x1[i] - fine.x0[i], fine.y1[i] - fine.y0[i]),
                     200 * sin(0.7853981633974483 / 10), 1e-12);
        assert_int_equal(fine.parent[i], (int)i - 1);
        assert_close(line[6 * i + 5], 1, 1e-15);
    }
    done(&r);
}

static void run_all(struct reading *r, const char *path, size_t *values)
{
    if (r->status) fail_msg("%s: %s %s", path, r->err.text, r->diag.first ? r->diag.first->text : "");
    for (size_t i = 0; i < r->n; i++)
        for (size_t k = 0; k < (r->list[i].solvers ? r->list[i].solvers : 1); k++) {
            struct wf_verdict v;
            assert_int_equal(wf_case_run(&r->list[i], k, 1, &r->arena, &v, &r->err), WF_OK);
            if (v.outcome == WF_FAILED)
                fail_msg("%s: %s [%s]: %s (%g)", path, r->list[i].name, v.solver, v.why ? v.why : "",
                         v.worst);
            *values += v.n;
        }
}

static void test_every_shipped_case_reads(void **state)
{
    (void)state;
    char folder[] = "validation", *const roots[] = { folder, NULL };
    size_t files = 0, cases = 0;
    FTS *walk = fts_open(roots, FTS_LOGICAL | FTS_NOCHDIR, NULL);
    assert_non_null(walk);
    for (FTSENT *f; (f = fts_read(walk));) {
        struct reading r;
        if (f->fts_info != FTS_F || f->fts_namelen < 5 ||
            strcmp(f->fts_name + f->fts_namelen - 5, ".case") != 0)
            continue;
        read_path(&r, f->fts_path);
        if (r.status) fail_msg("%s: %s", f->fts_path, r.diag.first ? r.diag.first->text : r.err.text);
        files++;
        cases += r.n;
        for (size_t i = 0; i < r.n; i++)
            assert_true(r.list[i].source && r.list[i].kind != WF_CASE_REGRESSION);
        done(&r);
    }
    fts_close(walk);
    assert_true(files >= 40 && cases >= 150);
}

static void test_quick_cases_hold(void **state)
{
    (void)state;
    static const char *const path[] = { "validation/closed_form/chain_uniform.case",
                                        "validation/closed_form/prism_cantilever.case",
                                        "validation/closed_form/uniform_cantilever_r0.05.case",
                                        "validation/closed_form/uniform_cantilever_r0.12.case",
                                        "validation/closed_form/tapered_cantilever_t0.5.case",
                                        "validation/closed_form/tapered_cantilever_t1.case",
                                        "validation/gusts/codes.case",
                                        "validation/gusts/gales.case" };
    for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
        struct reading r;
        size_t values = 0;
        read_path(&r, path[i]);
        run_all(&r, path[i], &values);
        assert_true(values > 10);
        done(&r);
    }
}

/* A chain of prisms is a uniform cantilever with a force across and a moment about the axis at its tip. */
static void test_prisms_of_what(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "moment tip 0 1 0 N m\n", "a force across and a moment about the axis" },
        { "force at 0.5 1 0 0 N\n", "at the tip" },
        { "taper 0.5\n", "uniform solid cantilever" },
        { "inner_radius 36 mm\n", "uniform solid cantilever" },
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct reading r;
        struct wf_verdict v;
        char text[800];
        snprintf(text, sizeof text,
                 HEAD "cantilever 6 m\nradius 40 mm\nyoungs_modulus 70 GPa\npoisson 0.33\ndensity 900 "
                      "kg/m3\n%swant prism_deflection 8 1 m\n",
                 wrong[i][0]);
        read_text(&r, text);
        if (r.status) fail_msg("%s", r.diag.first ? r.diag.first->text : r.err.text);
        assert_int_equal(wf_case_run(&r.list[0], 0, 1, &r.arena, &v, &r.err), WF_OK);
        assert_int_equal(v.outcome, WF_FAILED);
        assert_non_null(strstr(v.why, wrong[i][1]));
        done(&r);
    }
}

/* The observed order of a fourth-order element is four. */
static void test_order(void **state)
{
    (void)state;
    struct reading r;
    struct wf_verdict v[2];
    read_text(&r,
              HEAD "units none\ncantilever 1\nEI 1\ntaper 0.5\nsolver linear\nforce tip 1 0 0\norder 8 16\n"
                   "want displacement tip x 0.66666666666666667\n");
    assert_int_equal(wf_case_order(&r.list[0], 0, &r.arena, v, &r.err), WF_OK);
    assert_close(log2(v[0].check[0].error / v[1].check[0].error), 4, 0.05);
    done(&r);
}

/* Every key and quantity is described, and every example of the description holds. */
static void test_documentation(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_bytes doc;
    struct wf_err e = { WF_OK, "" };
    char quoted[64];
    size_t examples = 0;
    assert_int_equal(wf_file_read_text("docs/validation-cases.md", &a, &doc, &e), WF_OK);
    for (const struct wf_case_key *k = wf_case_keys; k->name; k++) {
        snprintf(quoted, sizeof quoted, "`%s`", k->name);
        if (!strstr(doc.data, quoted)) fail_msg("key %s is not described", k->name);
    }
    for (const struct wf_quantity *q = wf_quantities; q->name; q++)
        if (!strstr(doc.data, q->name)) fail_msg("quantity %s is not described", q->name);
    for (char *s = doc.data; (s = strstr(s, "```\ntitle"));) {
        struct reading r;
        size_t values = 0;
        char *end = strstr(s + 4, "```");
        assert_non_null(end);
        *end = '\0';
        read_text(&r, s + 4);
        run_all(&r, s + 4, &values);
        assert_true(values > 0); /* not skipped */
        done(&r);
        examples++;
        s = end + 1;
    }
    assert_true(examples >= 3);
    wf_arena_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mistakes),           cmocka_unit_test(test_all_mistakes_at_once),
        cmocka_unit_test(test_pass_and_fail),      cmocka_unit_test(test_cases_are_apart),
        cmocka_unit_test(test_solver_error_fails), cmocka_unit_test(test_missing_tree_is_skipped),
        cmocka_unit_test(test_unknown_row),        cmocka_unit_test(test_parameters),
        cmocka_unit_test(test_split_arc),          cmocka_unit_test(test_every_shipped_case_reads),
        cmocka_unit_test(test_quick_cases_hold),   cmocka_unit_test(test_order),
        cmocka_unit_test(test_prisms_of_what),     cmocka_unit_test(test_documentation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
