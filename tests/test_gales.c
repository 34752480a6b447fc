/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Six stands of GALES (roughness method, Gardiner et al. 2000; values of a re-implementation of its
 * equations, to 4e-12 those of the R package fgr with its loops converged): our stem, bent by --peak gales,
 * breaks at their canopy-top wind within 15 %. */
#include "beam_cases.h"
#include "data/species.h"
#include "solve/beam.h"
#include "study/analysis.h"
#include "study/node.h"
#include "study/peak.h"
#include "study/sway.h"
#include <string.h>

struct stand {
    const char *name;
    double height, spacing, width, depth;  /* stand, crown [m] */
    double diameter, stem, crown, snow;    /* at the base [m]; masses [kg] */
    double youngs, rupture, knots, drag;   /* [Pa], [-], coefficient at the critical wind [-] */
    double edge, gap, displaced, rough;    /* [m] */
    double critical, factor, weight_share; /* canopy-top wind [m/s], edge-gap-gust factor, DLF [-] */
};
static const struct stand stands[] = {
    { "S08",   21.1, 7,        4.65, 9.99, 0.255049, 373.553, 141.377, 0,       6.8e+09,
      4.8e+07, 0.85, 0.330029, 0,    0,    10.3029,  2.18659, 19.5635, 4.43297, 1.27094 },
    { "S20",   15.5, 3.9,      4.26, 8.17, 0.207176, 195.949, 47.3554, 0,       9.9e+09,
      6.3e+07, 1,    0.140167, 0,    0,    7.62537,  1.62821, 38.9672, 4.68905, 1.06583 },
    { "S27",   21.8, 9.2,      4.43, 8.22, 0.319006, 560.157, 105.582, 0,       7.3e+09,
      4.6e+07, 0.85, 0.274589, 0,    5,    7.67544,  1.06422, 38.9208, 4.55248, 1.09799 },
    { "S49",   12.5, 4.1,      3.05,  7.05, 0.188574, 134.241, 42.9237, 0,       5.9e+09,
      3.4e+07, 1,    0.539407, 9e+09, 200,  7.57004,  1.61095, 17.9159, 4.44413, 1.0845 },
    { "S50",   18.4, 2.4,      4.7, 8.46, 0.345909, 616.696, 122.314, 0,       6.3e+09,
      3.6e+07, 0.9,  0.455112, 0,   120,  14.639,   1.22898, 25.7113, 19.6623, 1.05644 },
    { "S58",   12.1, 3,        3.99,  6.59, 0.182452, 155.002, 37.9035, 0,       9.8e+09,
      6.5e+07, 1,    0.160925, 9e+09, 15,   6.64171,  1.51451, 38.1879, 4.70351, 1.05161 },
};
enum { STANDS = sizeof stands / sizeof *stands, ROWS = 60 };

/* The stem of GALES' deflection: diameter by the distance from the top to the power 0.6; its volume is scaled
 * to the mass of the stand's tree by the density. The crown hangs on its depth: a diamond seen from the side.
 */
static void grow(const struct stand *s, struct beam_case *c)
{
    double volume = 0.0, profile = 0.0;
    beam_new(c, ROWS);
    for (int i = 0; i < ROWS; i++) {
        double z0 = s->height * i / ROWS, z1 = s->height * (i + 1) / ROWS, r[2], b[2];
        for (int k = 0; k < 2; k++) {
            double z = k ? z1 : z0, top = fmax(1.0 - z / s->height, 0.004);
            double in = (z - (s->height - s->depth)) / s->depth;
            r[k] = 0.5 * s->diameter * pow(top, 0.6);
            b[k] = in > 0.0 ? 1.0 - fabs(2.0 * in - 1.0) : 0.0;
        }
        beam_row(c, (size_t)i, i - 1, (double[]){ 0, 0, z0 }, (double[]){ 0, 0, z1 }, r[0], r[1]);
        volume += 3.14159265358979 / 3 * (z1 - z0) * (r[0] * r[0] + r[0] * r[1] + r[1] * r[1]);
        profile += 0.5 * (b[0] + b[1]) * (z1 - z0);
        c->tree.sail0[i] = b[0] * s->width * s->drag, c->tree.sail1[i] = b[1] * s->width * s->drag;
        c->tree.burden0[i] = b[0] * (s->crown + s->snow), c->tree.burden1[i] = b[1] * (s->crown + s->snow);
        c->tree.youngs[i] = s->youngs, c->tree.shear[i] = s->youngs / 16;
        c->tree.strength[i] = s->rupture * s->knots, c->tree.drag[i] = 0;
    }
    for (int i = 0; i < ROWS; i++) {
        c->tree.density[i] = s->stem / volume;
        c->tree.burden0[i] /= profile, c->tree.burden1[i] /= profile;
    }
    c->loads.gravity = 9.81;
    c->loads.air_density = 1.2226;
}

static void breaks_as_gales(void **state)
{
    (void)state;
    static struct wf_level level[1] = { { .name = "stem" } };
    static const struct wf_species wood = { .name = "wood", .level = level, .levels = 1 };
    for (size_t k = 0; k < STANDS; k++) {
        const struct stand *s = &stands[k];
        struct beam_case c;
        struct wf_break out[WF_CRITERIA][WF_SCOPES];
        struct wf_at_speed at;
        grow(s, &c);
        struct wf_analysis an = {
            .species = &wood, .solver = &wf_solver_beam, .tree = c.tree, .loads = c.loads
        };
        wf_scenario_default(&an.scenario);
        an.scenario.profile = "canopy", an.scenario.reference_height = s->height;
        an.scenario.canopy_height = s->height, an.scenario.displacement = s->displaced;
        an.scenario.roughness = s->rough;
        an.scenario.peak = (struct wf_peak_request){
            .method = "gales",
            .damping = NAN,
            .stand = { .height = s->height, .spacing = s->spacing, .edge = s->edge, .gap = s->gap }
        };
        wf_search_default(&an.search);
        an.search.speed_max = 80;
        an.tallness = s->height;
        wf_scenario_wind(&an.scenario, &an.wind);
        an.loads.wind = &an.wind;
        assert_int_equal(wf_sway_set_up(&an, &c.options, &s->critical, 1, &c.arena, NULL, &c.err), WF_OK);
        struct wf_nodes *nodes = wf_nodes_open(&an, NULL);
        assert_non_null(nodes);
        if (wf_analysis_breaks(&an, &c.options, nodes, out, &c.err)) fail_msg("%s", c.err.text);
        wf_nodes_close(nodes);
        assert_int_equal(wf_speed_totals(&an, &c.options, s->critical, &at, &c.err), WF_OK);
        const struct wf_critical *found = &out[WF_BREAKAGE][WF_SCOPE_TREE].critical;
        double moment = s->rupture * s->knots * 3.14159265358979 / 32 * pow(s->diameter, 3);
        print_message(
            "%s: wind %.2f m/s, GALES %.2f (%+.1f %%); gust factor %.3f, %.3f; peak base moment over "
            "resistance at its wind %.3f; breaks at %.1f m\n",
            s->name, found->speed, s->critical, 100 * (found->speed / s->critical - 1),
            wf_peak_gusts(an.peak, s->critical), s->factor, at.base_moment / moment,
            out[WF_BREAKAGE][WF_SCOPE_TREE].height);
        assert_close(wf_peak_gusts(an.peak, s->critical), s->factor, 1e-5);
        assert_close(found->speed, s->critical, 0.15);
        assert_close(at.base_moment, moment, 0.15);
        wf_arena_free(&c.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(breaks_as_gales) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
