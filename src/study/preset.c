/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/preset.h"
#include "base/yaml.h"
#include "data/species.h"
#include "solve/solve.h"
#include <math.h>
#include <string.h>

/* Zhao & Zhang 2013, below eq 2: C_D, C_L [-]; rho_a = 2.37e-3 g/m3 in kg/m3. */
#define WF_ZHAO_DRAG 0.013
#define WF_ZHAO_LIFT 0.75
#define WF_ZHAO_AIR 2.37e-6

/* Sea-level air at 15 C [kg m-3] and drag of a bare cylinder [-], for comparison. */
static const double air = 1.225, cylinder = 1.2;

/* Departures of each paper's printed formulas and constants from physics, with their size on this tree. */

/* Rows of the stem. */
static size_t stem_rows(const struct wf_tree *t)
{
    size_t n = 0;
    for (size_t i = 0; i < t->n; i++) n += t->level[i] == 0;
    return n;
}

static void departures_tang(const struct wf_analysis *an, struct wf_diag *d)
{
    double n = (double)stem_rows(&an->tree);
    wf_diag_warn(
        d, "no-moment",
        "tang2012: force is handed down, its moment and the rotation below are not; with the stem in "
        "%.0f segments a uniform stem under a uniform load bends to (N + 1)/(2 N^3) = %.3g of beam "
        "theory, so the answer depends on the number of segments",
        n, (n + 1) / (2 * n * n * n));
    wf_diag_warn(
        d, "smeared-force",
        "tang2012: eq 12 spreads the force handed down over the segment; a force at its end bends it "
        "8/3 times as far and turns it 3 times as far");
    wf_diag_warn(
        d, "solid-section",
        "tang2012: segments are solid frustums; a culm whose wall is a fifth of its radius has 0.59 of "
        "the solid stiffness and 0.36 of the weight");
    wf_diag_warn(d, "no-weight",
                 "tang2012: weight does not act; a leaning crown bends further by its weight");
    wf_diag_warn(
        d, "rigid-crown",
        "tang2012: drag grows with the square of the speed; crowns streamline, with a Vogel exponent "
        "of -0.7 the load from 10 to 15 m/s grows 1.69-fold, not 2.25-fold");
    wf_diag_warn(
        d, "small-steps",
        "tang2012: displacements of the segments are added up, so a strongly bent stem grows longer");
}

/* Departures of wind, recursion over frames and leaves in runs in time. */
static void departures_tang_in_time(struct wf_diag *d)
{
    wf_diag_warn(
        d, "unprinted-constants",
        "tang2012: mu_d, mu_l, sigma and omega are not printed; drag is the species', the gust as specified");
    wf_diag_warn(d, "phase-once",
                 "tang2012: eq 4 reads as if the phase were drawn at every call; that is white noise of 0.71 "
                 "sigma U, no "
                 "gust; here it is drawn once a run");
    wf_diag_warn(d, "leaf-look",
                 "tang2012: eq 13 turns leaves in proportion to the wind, without limit; it affects the "
                 "picture only, not the loads");
}

void wf_departures_shelter(struct wf_diag *d)
{
    wf_diag_warn(d, "wake-recovery",
                 "feng1999: the wind counts as recovered 5 to 7 radii behind a stem; that is potential flow "
                 "(0.96 to 0.98 "
                 "on the axis), a real wake takes tens of diameters");
    wf_diag_warn(d, "transmission",
                 "feng1999: 20 %% of the energy pass a covered cell, 0.45 of the speed; were the speed meant "
                 "it would be "
                 "0.2, a drag 5 times smaller");
    wf_diag_warn(d, "superposition",
                 "feng1999: potentials of neighbouring cells are added up without bound: beside many holes "
                 "the speed can exceed that of the wind");
}

static void departures_feng(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_species *sp = an->species;
    bool table = sp->level[0].youngs_modulus.standing == WF_PRINTED;
    if (table)
        wf_diag_warn(
            d, "tuned-values",
            "feng1999: the authors say there were no data; the table was tuned by eye for an animation");
    for (size_t i = 0; i < sp->levels; i++) {
        const struct wf_level *l = &sp->level[i];
        if (l->youngs_modulus.value > 30e9)
            wf_diag_warn(
                d, "modulus-outlier",
                "feng1999: %s: E = %.3g GPa as printed (10.8e10) is that of titanium; neighbours "
                "differ 3.3 and 3.6-fold, this one 30-fold; 10.8e9, a tenth, is the likely intention",
                l->name, l->youngs_modulus.value / 1e9);
        if (l->youngs_modulus.value < 0.7e9)
            wf_diag_warn(d, "modulus-low",
                         "feng1999: %s: E = %.3g GPa is that of soft green shoots; living branches have 0.7 "
                         "to 4.6 GPa, "
                         "so it bends 2 to 15 times too far",
                         l->name, l->youngs_modulus.value / 1e9);
        if (l->density.value > 1500)
            wf_diag_warn(
                d, "density-outlier",
                "feng1999: %s: relative density read as %.0f kg/m3, against 1500 for solid cell wall "
                "and about 850 for green willow",
                l->name, l->density.value);
    }
    if (table)
        wf_diag_warn(
            d, "relative-radius",
            "feng1999: radii are printed without a unit; read as metres they are those of weeping twigs, "
            "far too thin for limbs");
    if (an->solver->as_printed)
        wf_diag_warn(
            d, "dropped-products",
            "feng1999: eq 2 leaves out products of first derivatives of the angles and takes a segment as "
            "uniform; the error falls with the length of the segments");
}

static void departures_zhao(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_tree *t = &an->tree;
    double low = INFINITY, high = 0;
    for (size_t i = 0; i < t->n; i++) {
        double r = 0.5 * (t->r0[i] + t->r1[i]);
        low = fmin(low, r), high = fmax(high, r);
    }
    wf_diag_warn(
        d, "r-cubed",
        "zhao2013: eq 3 divides by R^3 where a round section has R^4; in SI the deflection comes out R "
        "times, here %.2g to %.2g-fold, too small, and the factor changes with the unit of length",
        1 / high, 1 / low);
    wf_diag_warn(d, "air-density",
                 "zhao2013: air of 2.37e-3 g/m3, %.2g of real air; 0.00237 slug/ft3 is sea-level air, so the "
                 "unit was most likely relabelled",
                 WF_ZHAO_AIR / air);
    wf_diag_warn(
        d, "aerofoil-coefficients",
        "zhao2013: C_D = %.3g and C_L = %.3g are those of a wing: the force stands %.0f degrees to the "
        "wind; a bare cylinder has C_D about %.1f, %.0f times as much, and no lift when upright",
        WF_ZHAO_DRAG, WF_ZHAO_LIFT, atan2(WF_ZHAO_LIFT, WF_ZHAO_DRAG) * 57.29577951308232, cylinder,
        cylinder / WF_ZHAO_DRAG);
    wf_diag_warn(
        d, "no-moment",
        "zhao2013: only the wind on a segment bends it; nothing is handed down from above; a uniform "
        "stem in 10 segments bends to 0.015 of beam theory by this alone, in one segment to 2.67");
    wf_diag_warn(
        d, "chord-angle",
        "zhao2013: the segment turns by asin(delta/L), the angle of its chord; the end of a tip-loaded "
        "cantilever turns 1.5 times as far");
    wf_diag_warn(d, "no-weight", "zhao2013: weight does not act");
}

static void departures_zhao_in_time(struct wf_diag *d)
{
    wf_diag_warn(d, "omega-unit",
                 "zhao2013: omega = 3.14/120 has no unit; read per frame at 61 frames a second the sine "
                 "takes 3.9 s, per "
                 "second it would take 240 s");
    wf_diag_warn(
        d, "sine-swing",
        "zhao2013: V_0 (1 + sin) swings from 0 to twice V_0, an intensity of 0.71 against 0.2 to 0.6 in real "
        "wind; noise of 0 to 4 m/s adds 2 m/s to the mean, 20 %% at 10 m/s, 57 %% at 3.5 m/s");
    wf_diag_warn(d, "restoring",
                 "zhao2013: -k F(t-1) takes elasticity, which is in E, a second time: a steady load settles "
                 "at F_1/(1 + k), "
                 "with k = 0.3 at 0.77");
    wf_diag_warn(d, "damping-sign",
                 "zhao2013: k omega^2 never changes its sign, so it would drive half of each swing; along "
                 "the axis, as "
                 "printed, it bends nothing");
    wf_diag_warn(d, "leaf-look",
                 "zhao2013: leaves turn by three noises whatever the wind; it affects the picture only, not "
                 "the loads");
}

const struct wf_preset wf_presets[] = {
    { .name = "corrected",
      .title = "physics and SI units throughout",
      .source = "the sources of the species table and of the solver",
      .drag = NAN,
      .lift = NAN,
      .air_density = NAN },
    { .name = "tang2012",
      .title = "chain of solid cantilevers that hand down force alone",
      .source =
          "Tang L., Zou J., Lin D., Chen C. 2012. Visual simulating virtual tree movement in wind. Trans. "
          "Chin. Soc. Agric. Mach. 43(1):165-168",
      .solver = "chain-as-printed",
      .gust = "cosine",
      .drag = NAN, /* named mu_d, mu_l; no values printed */
      .lift = NAN,
      .air_density = NAN,
      .solid = true,
      .rigid = true,
      .departures = departures_tang,
      .in_time = departures_tang_in_time },
    { .name = "feng1999",
      .title = "inextensible rods in three angles a segment",
      .source =
          "Feng J., Yan T., Chen Y., Wu E. 1999. Research on whole tree's movement and tree's inner wind "
          "field. J. Software",
      .solver = "rod-as-printed",
      .drag = NAN,
      .lift = NAN,
      .air_density = NAN,
      .rigid = true,
      .departures = departures_feng },
    { .name = "zhao2013",
      .title = "rods turned by their own wind force, R cubed",
      .source = "Zhao P., Zhang Z. 2013. Research on fast dynamic simulation of IFS trees swaying. Computer "
                "Engineering and Applications 49(14):160-163",
      .solver = "deflect-as-printed",
      .gust = "sine-perlin-as-printed",
      .leaves = "noise",
      .drag = WF_ZHAO_DRAG,
      .lift = WF_ZHAO_LIFT,
      .air_density = WF_ZHAO_AIR,
      .solid = true,
      .rigid = true,
      .departures = departures_zhao,
      .in_time = departures_zhao_in_time },
    { .name = NULL },
};

const struct wf_preset *wf_preset_named(const char *name)
{
    for (const struct wf_preset *p = wf_presets; p->name; p++)
        if (!strcmp(p->name, name)) return p;
    return NULL;
}

static struct wf_value printed(double value, const char *source)
{
    return (struct wf_value){ value, value, value, WF_PRINTED, source, true, NULL };
}

enum wf_status wf_preset_apply(const struct wf_preset *p, struct wf_arena *a, struct wf_species *sp,
                               struct wf_scenario *sc, const struct wf_solver **solver, struct wf_err *e)
{
    if (!p->departures) return WF_OK;
    struct wf_level *level = WF_TAKE(a, sp->levels, struct wf_level);
    struct wf_yaml_pair *source = WF_TAKE(a, sp->sources + 1, struct wf_yaml_pair);
    if (!level || !source) return wf_fail(e, WF_ENOMEM, "not enough memory for the species");
    memcpy(level, sp->level, sp->levels * sizeof *level);
    if (sp->sources) memcpy(source, sp->source, sp->sources * sizeof *source);
    if (!wf_species_source(sp, p->name)) source[sp->sources++] = (struct wf_yaml_pair){ p->name, p->source };
    sp->level = level;
    sp->source = source;
    sp->preset = p->name;
    for (size_t i = 0; i < sp->levels; i++) {
        if (p->solid) level[i].wall = (struct wf_along){ 0 };
        if (!isnan(p->drag)) level[i].drag_coefficient = printed(p->drag, p->name);
        if (!isnan(p->lift)) level[i].lift_coefficient = printed(p->lift, p->name);
    }
    if (!isnan(p->drag) && sp->crown.drag_coefficient.given)
        sp->crown.drag_coefficient = printed(p->drag, p->name);
    if (p->rigid) sp->streamlining = (struct wf_law_use){ .law = "none" };
    if (!isnan(p->air_density)) sc->air_density = p->air_density;
    if (p->solver) *solver = wf_solver_named(p->solver);
    return *solver ? WF_OK : wf_fail(e, WF_EINTERNAL, "preset '%s' names no solver", p->name);
}

void wf_preset_warn(const struct wf_preset *p, const struct wf_analysis *an, struct wf_diag *d)
{
    if (p->departures) p->departures(an, d);
}
