/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of sections: elastic limit, torsion, splitting and ovalisation against closed forms; safety 1 at
 * the critical wind of each; what branches bear. */
#include "data/section.h"
#include "fail/fail.h"
#include "load/scene.h"
#include "made.h"
#include "solve/chain.h"
#include <string.h>

#define PI 3.14159265358979323846
static const double L = 6, R = 0.04, MOR = 60e6, F_C = 25e6, F_V = 6e6, F_T = 3e6, E_L = 7e9, E_T = 0.4e9;

struct fixture {
    struct wf_arena arena;
    struct wf_tree t;
    struct wf_response r;
    struct wf_breakage b;
    struct wf_worst worst[WF_CRITERIA][WF_SCOPES];
    struct wf_err e;
};

static double safety(const struct fixture *f, enum wf_criterion_id c)
{
    return f->worst[c][WF_SCOPE_STEM].safety;
}

/* A weightless stem of n rows, radii linear to tip times those of the base, loaded at its tip by `scale`
 * times p. The axis stays upright, so that statics are exact; the strengths are then put on. */
static void cantilever(struct fixture *f, size_t n, double tip, double inner, struct wf_point_load p,
                       double scale)
{
    struct wf_loads l;
    struct wf_solve_options o;
    *f = (struct fixture){ 0 };
    wf_loads_default(&l);
    wf_solve_options_default(&o);
    assert_int_equal(wf_tree_alloc(&f->t, n, &f->arena, &f->e), WF_OK);
    for (size_t i = 0; i < n; i++) {
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n;
        f->t.parent[i] = (int32_t)i - 1;
        f->t.z0[i] = s0 * L, f->t.z1[i] = s1 * L;
        f->t.r0[i] = R * (1 - (1 - tip) * s0), f->t.r1[i] = R * (1 - (1 - tip) * s1);
        f->t.i0[i] = inner * f->t.r0[i], f->t.i1[i] = inner * f->t.r1[i];
        f->t.youngs[i] = 1e20, f->t.shear[i] = 1e19, f->t.density[i] = 800;
    }
    for (int k = 0; k < 3; k++) p.force[k] *= scale, p.moment[k] *= scale;
    p.segment = (int32_t)n - 1;
    l.gravity = 0, l.point = &p, l.points = 1;
    assert_int_equal(wf_solver_chain.solve(&f->t, &l, &o, &f->arena, &f->r, NULL, &f->e), WF_OK);
    for (size_t i = 0; i < n; i++) {
        f->t.youngs[i] = E_L, f->t.strength[i] = MOR, f->t.compressive[i] = F_C;
        f->t.shearing[i] = F_V, f->t.tangential[i] = F_T, f->t.transverse[i] = E_T;
    }
}

static void check(struct fixture *f)
{
    assert_int_equal(wf_breakage_check(&f->t, &f->r, NULL, &f->arena, &f->b, &f->e), WF_OK);
    wf_criteria_check(&f->t, &f->r, &f->b, f->worst);
}

/* Where two increasing curves of wall over radius cross. */
static double crossing(double (*apart)(double share))
{
    double low = 1e-3, high = 1;
    for (int k = 0; k < 100; k++) {
        double middle = 0.5 * (low + high);
        if ((apart(middle) > 0) == (apart(high) > 0))
            high = middle;
        else
            low = middle;
    }
    return low;
}

static double flattens_less(double x) { return wf_wall_flattens(E_L, E_T, x) - wf_wall_splits(E_L, F_T, x); }
static double splits_above_bending(double x) { return wf_wall_splits(E_L, F_T, x) - 61e6; }

/* Taiwan red cypress: a wall flattens below the first, splits up to the second, bends above it. */
static void limits_of_walls(void **state)
{
    (void)state;
    assert_true(fabs(crossing(flattens_less) - 0.0506) < 1e-4);
    assert_true(fabs(crossing(splits_above_bending) - 0.2658) < 1e-4);
    assert_close(crossing(flattens_less), 6.75 * F_T / E_T, 1e-12);
}

static const struct wf_point_load push = { .force = { 20, 0, -300 }, .moment = { 0, 0, 9 } };

static void solid_stem(void **state)
{
    (void)state;
    struct fixture f;
    double area = PI * R * R, bent = 4 * 20 * L / (PI * R * R * R), drawn = 300 / area;
    double twist = 2 * 9 / (PI * R * R * R), bending = bent + drawn;
    cantilever(&f, 4, 1, 0, push, 1);
    check(&f);
    assert_close(safety(&f, WF_BREAKAGE), MOR / bending, 1e-9);
    assert_close(safety(&f, WF_ELASTIC_LIMIT), F_C / bending, 1e-9); /* the weight compresses */
    assert_close(safety(&f, WF_TORSION), 1 / hypot(bending / MOR, twist / F_V), 1e-9);
    assert_true(isnan(safety(&f, WF_SPLITTING)) && isnan(safety(&f, WF_OVALISATION)));
    assert_null(f.b.use[WF_SPLITTING]);
    assert_false(wf_criterion_applies(&wf_criteria[WF_SPLITTING], &f.t, WF_SCOPE_TREE));
    wf_arena_free(&f.arena);
    struct wf_point_load pull = { .force = { 20, 0, 300 } };
    cantilever(&f, 4, 1, 0, pull, 1);
    check(&f);
    assert_close(safety(&f, WF_ELASTIC_LIMIT), F_C / (bent - drawn), 1e-9);
    assert_close(safety(&f, WF_BREAKAGE), MOR / bending, 1e-9);
    wf_arena_free(&f.arena);
}

/* The nominal stress M / (pi R^2 t) with the mean radius; t/R = 2 (1 - i) / (1 + i). */
static void thin_ring(void **state)
{
    (void)state;
    struct fixture f;
    const double inner = 0.8, mean = 0.9 * R, wall = 0.2 * R, share = wall / mean;
    cantilever(&f, 4, 1, inner, push, 1);
    check(&f);
    double nominal = 20 * L / (PI * mean * mean * wall), inertia = wf_ring_inertia(R, inner * R),
           bent = 20 * L * R / inertia + 300 / wf_ring_area(R, inner * R), twist = 9 * R / (2 * inertia);
    assert_close(wf_wall_share(&f.t, 0, 0.3), share, 1e-12);
    assert_close(safety(&f, WF_SPLITTING), sqrt(2.0 / 3 * E_L * F_T * share) / nominal, 1e-9);
    assert_close(safety(&f, WF_OVALISATION), 2 * sqrt(2) / 9 * share * sqrt(E_L * E_T) / nominal, 1e-9);
    assert_close(safety(&f, WF_TORSION), 1 / hypot(bent / MOR, twist / F_V), 1e-9);
    const struct wf_worst *w = &f.worst[WF_SPLITTING][WF_SCOPE_STEM];
    assert_close(wf_criterion_resistance(&wf_criteria[WF_SPLITTING], &f.t, w),
                 sqrt(2.0 / 3 * E_L * F_T * share), 1e-12);
    wf_arena_free(&f.arena);
}

/* 0.3 of the mean radius is the end of thin walls; strengths that are missing are not assessed. */
static void what_is_not_assessed(void **state)
{
    (void)state;
    static const struct {
        double share;
        bool thin;
    } wall[] = { { 0.299, true }, { 0.301, false } };
    for (int k = 0; k < 2; k++) {
        struct fixture f;
        cantilever(&f, 2, 1, (2 - wall[k].share) / (2 + wall[k].share), push, 1);
        check(&f);
        assert_true(isnan(safety(&f, WF_SPLITTING)) == !wall[k].thin);
        assert_true(wf_criterion_applies(&wf_criteria[WF_OVALISATION], &f.t, WF_SCOPE_STEM) == wall[k].thin);
        f.t.tangential[0] = 0, f.t.compressive[0] = f.t.compressive[1] = 0, f.t.shearing[1] = 0;
        check(&f);
        assert_true(isnan(safety(&f, WF_ELASTIC_LIMIT)) && !f.b.use[WF_ELASTIC_LIMIT]);
        if (wall[k].thin) assert_int_equal(f.worst[WF_SPLITTING][WF_SCOPE_STEM].row, 1);
        assert_int_equal(f.worst[WF_TORSION][WF_SCOPE_STEM].row, 0);
        assert_true(isnan(f.b.use[WF_TORSION][1]));
        wf_arena_free(&f.arena);
    }
}

/* Stresses that grow together: safety is the factor of the load that brings the interaction to 1. */
static void safety_is_a_load_factor(void **state)
{
    (void)state;
    static const enum wf_criterion_id id[] = { WF_ELASTIC_LIMIT, WF_TORSION, WF_SPLITTING, WF_OVALISATION };
    for (size_t k = 0; k < sizeof id / sizeof *id; k++) {
        struct fixture f;
        cantilever(&f, 5, 0.4, 0.85, push, 1);
        check(&f);
        double factor = safety(&f, id[k]);
        wf_arena_free(&f.arena);
        cantilever(&f, 5, 0.4, 0.85, push, factor);
        check(&f);
        assert_close(safety(&f, id[k]), 1, 1e-9);
        wf_arena_free(&f.arena);
    }
}

/* Torsion along a cone: the largest of 100 001 places against the place found inside a row. Bending alone is
 * largest elsewhere, so that each criterion must have its own place. */
static void place_inside_a_row(void **state)
{
    (void)state;
    const double tip = 0.5;
    struct fixture f;
    double best = 0, at = 0;
    for (int k = 0; k <= 100000; k++) {
        double s = k / 1e5, r = R * (1 - (1 - tip) * s), cube = PI * r * r * r;
        double bent = 4 * 20 * L * (1 - s) / cube + 300 / (PI * r * r), twist = 2 * 9 / cube;
        double use = hypot(bent / MOR, twist / F_V);
        if (use > best) best = use, at = s;
    }
    for (size_t n = 1; n < 6; n++) {
        cantilever(&f, n, tip, 0, push, 1);
        check(&f);
        const struct wf_worst *w = &f.worst[WF_TORSION][WF_SCOPE_STEM];
        assert_close(w->safety, 1 / best, 1e-6);
        assert_true(fabs(((double)w->row + w->place) / (double)n - at) < 1e-3);
        struct wf_breakage again; /* by the places of another answer */
        assert_int_equal(wf_breakage_check(&f.t, &f.r, &f.b, &f.arena, &again, &f.e), WF_OK);
        for (size_t i = 0; i < n; i++) {
            assert_close(again.use[WF_TORSION][i], f.b.use[WF_TORSION][i], 1e-12);
            assert_close(again.use_place[WF_ELASTIC_LIMIT][i], f.b.use_place[WF_ELASTIC_LIMIT][i], 0);
        }
        wf_arena_free(&f.arena);
    }
    assert_true(at > 0.5 + 1e-3); /* breakage: 0.5 */
}

/* ---- Whole trees ---- */

static void analyse(struct made *m) { made_analyse(m, (const double[]){ 12 }, 1); }

static void safety_1_at_the_critical_wind(void **state)
{
    (void)state;
    static const struct {
        const char *species, *model;
        int found;
        double nodes; /* apart */
    } trees[] = { { "species/moso_bamboo.yaml", "models/moso_culm.yaml", 4, 0 },
                  { "species/moso_bamboo.yaml", "models/moso_culm.yaml", 4, 0.2 },
                  { "species/norway_spruce.yaml", "models/culm.yaml", 3, 0 },
                  { "species/weeping_willow.yaml", "tests/data/limbs.yaml", 5, 0 } };
    for (size_t k = 0; k < sizeof trees / sizeof *trees; k++) {
        struct made m;
        int found = 0;
        made_read(&m, trees[k].species, trees[k].model);
        m.scenario.node_spacing = trees[k].nodes;
        analyse(&m);
        for (int c = 0; c < WF_CRITERIA; c++)
            for (int s = 0; s < WF_SCOPE_BRANCHES; s++) {
                const struct wf_break *b = &m.an.breaks[c][s];
                struct wf_at_speed at;
                if (b->critical.outcome != WF_CRITICAL_FOUND) continue;
                if (s == WF_SCOPE_TREE && m.an.breaks[c][WF_SCOPE_STEM].critical.speed == b->critical.speed)
                    continue;
                assert_int_equal(wf_speed_totals(&m.an, &m.options, b->critical.speed, &at, &m.err), WF_OK);
                assert_close(at.worst[c][s].safety, 1, 1e-6);
                assert_close(b->at.worst[c][s].safety, 1, 1e-6);
                found++;
            }
        assert_int_equal(found, trees[k].found);
        wf_arena_free(&m.arena);
    }
}

/* Both stresses use the section, so that the interaction is never later than bending alone. */
static void torsion_comes_before_bending(void **state)
{
    (void)state;
    struct made m;
    made_read(&m, "species/weeping_willow.yaml", "tests/data/limbs.yaml");
    analyse(&m);
    for (int s = 0; s < WF_SCOPES; s++)
        assert_true(m.an.breaks[WF_TORSION][s].critical.speed <=
                    m.an.breaks[WF_BREAKAGE][s].critical.speed * (1 + 1e-6));
    wf_arena_free(&m.arena);
}

/* The lowest of the table's value for a branch and the factor of the stem's clear wood, without its knots. */
static void what_branches_bear(void **state)
{
    (void)state;
    struct made m;
    struct wf_tree t;
    const struct wf_branch_strength *b;
    made_read(&m, "species/norway_spruce.yaml", "models/culm.yaml");
    const struct wf_level *stem = &m.species.level[0], *branch = &m.species.level[1];
    const double clear = stem->modulus_of_rupture.value, own = branch->modulus_of_rupture.value;
    static const struct {
        const char *name;
        double factor;
    } rows[] = { { "full", 1 }, { "inside-bark", 0.72 }, { "over-bark-circle", 0.40 }, { NULL, 0.55 } };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        assert_int_equal(wf_tree_alloc(&t, 3, &m.arena, &m.err), WF_OK);
        wf_level_onto(stem, &t, 0, false);
        wf_level_onto(branch, &t, 1, false);
        wf_level_onto(stem, &t, 2, false); /* a limb as thick as a stem */
        t.level[1] = t.level[2] = 1;
        b = wf_branches_limit(rows[k].name, &m.species, &t);
        assert_close(b->factor, rows[k].factor, 0);
        assert_close(t.strength[0], clear * stem->knot_factor.value, 1e-12);
        assert_close(t.strength[1], fmin(own, rows[k].factor * clear), 1e-12);
        assert_close(t.strength[2], fmin(clear * stem->knot_factor.value, rows[k].factor * clear), 1e-12);
        assert_close(t.compressive[2], rows[k].factor * stem->compressive_strength.value, 1e-12);
        assert_close(t.compressive[0], stem->compressive_strength.value, 0);
    }
    m.species.preset = "feng1999";
    b = wf_branches_limit(NULL, &m.species, &t);
    assert_close(b->factor, 1, 0);
    wf_arena_free(&m.arena);
}

/* Moso: what is not given is assumed, and listed, or not assessed. */
static void values_of_species(void **state)
{
    (void)state;
    struct made m;
    made_read(&m, "species/moso_bamboo.yaml", "models/moso_culm.yaml");
    const struct wf_level *l = m.species.level;
    assert_false(l->shear_strength.given || l->compressive_strength.given);
    assert_close(l->shear_strength.value, 0.15 * l->modulus_of_rupture.value, 1e-12);
    assert_int_equal(l->shear_strength.standing, WF_ASSUMED);
    assert_close(l->tangential_strength.high, 3.24e6, 1e-12);
    assert_close(l->tangential_strength.low, 0.5 * 3.24e6, 1e-12);
    analyse(&m);
    struct wf_break(*b)[WF_SCOPES] = m.an.breaks;
    assert_int_equal(b[WF_ELASTIC_LIMIT][WF_SCOPE_STEM].critical.outcome, WF_CRITICAL_NO_STRENGTH);
    assert_true(b[WF_SPLITTING][WF_SCOPE_STEM].critical.speed < b[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed);
    assert_true(b[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed <
                b[WF_OVALISATION][WF_SCOPE_STEM].critical.speed);
    bool listed = false;
    for (const struct wf_finding *f = m.diag.first; f; f = f->next)
        listed = listed || strstr(f->text, "modulus_of_rupture, shear_strength, tangential_strength");
    assert_true(listed);
    struct wf_tree t;
    struct wf_level green = *l;
    green.poisson_lt.value = 0.4, green.poisson_tl.value = 0.05;
    assert_int_equal(wf_tree_alloc(&t, 1, &m.arena, &m.err), WF_OK);
    wf_level_onto(&green, &t, 0, false);
    assert_close(t.transverse[0], green.tangential_modulus.value / (1 - 0.4 * 0.05), 1e-12);
    wf_arena_free(&m.arena);
    made_read(&m, "species/willow_feng1999.yaml", "models/culm.yaml"); /* no strength at all */
    assert_int_equal(wf_tree_alloc(&t, 1, &m.arena, &m.err), WF_OK);
    wf_level_onto(m.species.level, &t, 0, false);
    assert_close(t.shearing[0], 0, 0);
    assert_close(t.compressive[0] + t.tangential[0] + t.transverse[0], 0, 0);
    wf_arena_free(&m.arena);
}

/* Half way between the nodes the flattening is that of a beam on an elastic foundation, by its Fourier
 * series: (4 / pi) sum of sin(n pi / 2) / (n (1 + (n pi / L)^4 / (4 b^4))) over odd n. */
static double flattened(double spacing, double decay)
{
    double sum = 0;
    for (int n = 1; n < 4001; n += 2)
        sum += (n % 4 == 1 ? 1 : -1) / (n * (1 + pow(n * PI / spacing, 4) / (4 * pow(decay, 4))));
    return 4 / PI * sum;
}

static void diaphragms(void **state)
{
    (void)state;
    const double wall = 0.2 * R, middle = R - wall / 2;
    /* of wood this stiff along the rings the theory's reach is less than three diameters ... */
    const double stiff = 2 * E_L, decay = pow(3 * stiff * wall * wall / (E_L * pow(middle, 6)), 0.25);
    assert_true(decay > PI / (6 * R));
    for (double apart = 0.5; apart < PI / (2 * decay * R); apart += 0.25)
        assert_close(wf_wall_held(2 * R * apart, E_L, stiff, R, wall),
                     1 / sqrt(flattened(2 * R * apart, decay)), 1e-6);
    /* ... of others that of three diameters counts, also where nothing is known */
    for (double apart = 0.5; apart < 3; apart += 0.25) {
        double held = wf_wall_held(2 * R * apart, E_L, E_T / 4, R, wall);
        assert_close(held, 1 / sqrt(flattened(2 * R * apart, PI / (6 * R))), 1e-6);
        assert_close(held, wf_wall_held(2 * R * apart, E_L, 0, R, wall), 0);
    }
    assert_close(wf_wall_held(2 * R * 3, E_L, E_T / 4, R, wall), 1, 0);
    assert_close(wf_wall_held(2 * R * 30, E_L, E_T / 4, R, wall), 1, 0);
}

/* Both limits of the wall of a culm grow by the same factor, bending does not; off, all is as without them.
 */
static void diaphragms_of_a_stem(void **state)
{
    (void)state;
    struct fixture f;
    const double spacing = 3 * R, inner = 0.8;
    double without[WF_CRITERIA];
    cantilever(&f, 1, 1, inner, (struct wf_point_load){ .force = { 40, 0, 0 } }, 1);
    check(&f);
    for (int c = 0; c < WF_CRITERIA; c++) without[c] = safety(&f, (enum wf_criterion_id)c);
    f.t.node_spacing = spacing;
    check(&f);
    double held = wf_wall_held(spacing, E_L, E_T, R, (1 - inner) * R);
    assert_true(held > 1.5);
    assert_close(safety(&f, WF_SPLITTING), held * without[WF_SPLITTING], 1e-12);
    assert_close(safety(&f, WF_OVALISATION), held * without[WF_OVALISATION], 1e-12);
    assert_close(safety(&f, WF_BREAKAGE), without[WF_BREAKAGE], 0);
    wf_arena_free(&f.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_of_walls),
        cmocka_unit_test(solid_stem),
        cmocka_unit_test(thin_ring),
        cmocka_unit_test(what_is_not_assessed),
        cmocka_unit_test(safety_is_a_load_factor),
        cmocka_unit_test(place_inside_a_row),
        cmocka_unit_test(safety_1_at_the_critical_wind),
        cmocka_unit_test(torsion_comes_before_bending),
        cmocka_unit_test(what_branches_bear),
        cmocka_unit_test(values_of_species),
        cmocka_unit_test(diaphragms),
        cmocka_unit_test(diaphragms_of_a_stem),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
