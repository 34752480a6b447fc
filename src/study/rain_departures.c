/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/rain_departures.h"
#include "base/num.h"
#include "data/species.h"
#include "load/drop_shape.h"
#include <math.h>

/* Mass that a push at the middle of the first leaf feels [kg]. */
static double leaf_mass_felt(const struct wf_rain_result *r)
{
    const double at[2] = { r->scene.blade.length / 2, 0 };
    struct wf_prism_point q;
    wf_scene_blade_point(&r->scene, 0, at, &q);
    return 1 / wf_prism_yield(&r->scene.prism, &q);
}

static double leaf_mass(const struct wf_rain_result *r)
{
    return wf_blade_area(&r->scene.blade) * r->spec->scene.species->crown.leaf_mass_per_area.value;
}

static void of_impacts(const struct wf_rain_result *r, struct wf_diag *d)
{
    double size = 3e-3, m = WF_WATER_DENSITY * WF_PI / 6 * size * size * size, felt = leaf_mass_felt(r);
    double kept = 1 - r->spec->loss, share = wf_impact_share(m, felt);
    wf_diag_warn(
        d, "impact-energy",
        "yang2011: eq 2 gives the leaf %.0f %% of a drop's energy; a 3 mm drop that sticks where the leaf "
        "yields as %.2g g gives it %.1f %%, so the leaf gets %.2g times too much energy and %.2g times the "
        "drop's momentum",
        100 * kept, 1000 * felt, 100 * share, kept / share, sqrt(kept * felt / m));
    double fast = sqrt(2 * r->spec->water.gravity * r->spec->fall), true_speed = wf_fall_laws[0].speed(size);
    wf_diag_warn(
        d, "free-fall",
        "yang2011: drops fall without drag; after %.3g m a drop has %.3g m/s, one of 3 mm at its terminal "
        "speed has %.3g m/s: %.2g of its energy",
        r->spec->fall, fast, true_speed, pow(fast / true_speed, 2));
}

static void of_shapes(const struct wf_rain_result *r, struct wf_diag *d)
{
    const struct wf_water_law *w = &r->spec->water;
    double volume = wf_cap_volume_printed(1) / wf_cap_volume(1, w->angle);
    double high = wf_cap_height(1, w->angle, 0, 1, true), true_high = wf_cap_height(1, w->angle, 0, 1, false);
    wf_diag_warn(
        d, "cap-density",
        "yang2011: eq 6 leaves density out; in kg and m its radius is %.3g times too large; it is taken "
        "with grams and centimetres",
        wf_cap_radius_printed(1, w->angle) / wf_cap_radius(1, w->angle));
    wf_diag_warn(
        d, "drop-volume",
        "yang2011: V0 = 3 pi r^3/8 is %.3g times the cap of eq 6 at %.0f degrees; radii of drops and "
        "subdrops come out %.3g times theirs",
        volume, w->angle * 180 / WF_PI, 1 / cbrt(volume));
    wf_diag_warn(
        d, "cap-height",
        "yang2011: eq 18 takes r sin(theta) where the cap has r cos(theta); the middle of a drop stands "
        "%.3g r high, not %.3g r, and the height does not end at the contact circle",
        high, true_high);
}

static void of_forces(const struct wf_rain_result *r, struct wf_diag *d)
{
    const struct wf_water_law *w = &r->spec->water;
    double m = WF_WATER_DENSITY * WF_PI / 6 * 27e-9, base = wf_cap_base(wf_cap_radius(m, w->angle), w->angle);
    double true_pull = WF_WATER_TENSION * 2 * base;
    wf_diag_warn(
        d, "attraction-unit",
        "yang2011: H(d) = -log(d/(R1 + R2)) has no unit; read in newtons it is %.2g times the tension along "
        "the contact of two 3 mm drops, so drops merge as soon as they touch",
        1 / true_pull);
    wf_diag_warn(
        d, "constant-forces",
        "yang2011: adhesion %.2g N and the weight that hangs %.2g N are constants; by the hysteresis of the "
        "contact angle a 3 mm drop is held by %.2g N, and an edge with a contact of %.2g mm holds %.2g N",
        w->adhesion, w->hang, wf_drop_retention(2 * base, w->receding, w->advancing), 1000 * w->apex,
        WF_WATER_TENSION * WF_PI * w->apex);
    wf_diag_warn(
        d, "lever",
        "yang2011: phi = d/L is capped at %.2g, so a drop at the tip turns the leaf by %.2g of its moment; "
        "a running drop's friction on the leaf is left out",
        r->spec->lever, r->spec->lever);
    wf_diag_warn(
        d, "dry-trace",
        "yang2011: a trace takes no water; a film of %.2g mm on what was wetted here would hold %.3g mg of "
        "the first leaf's %.3g mg",
        1000 * w->film,
        1e6 * w->film * WF_WATER_DENSITY * (double)r->leaf[0].wetted * r->leaf[0].cell[0] *
            r->leaf[0].cell[1],
        1e6 * r->leaf[0].received);
    wf_diag_warn(
        d, "cell-distance",
        "yang2011: eq 11 counts the distance c in cells, so the trace fades %.3g-fold per mm on this grid of "
        "%zu cells and differently on another",
        pow(w->eta, 1e-3 / r->leaf[0].cell[1]), r->spec->grid);
    wf_diag_warn(
        d, "look-factors",
        "yang2011: omega = %.2g, lambda = %.3g, zeta = %.2g, eta = %.2g set the look of drops and traces; no "
        "physical value exists for them",
        w->omega, w->lambda, w->zeta, w->eta);
}

static void of_prisms(const struct wf_rain_result *r, struct wf_arena *a, struct wf_diag *d)
{
    double row[WF_PRISM_ROWS], all = 0, *f = WF_TAKE(a, 9 * r->scene.prism.sections, double);
    if (!f) return;
    wf_prism_forces(&r->scene.prism, r->scene.rest, f, row);
    for (int k = 0; k < WF_PRISM_ROWS; k++) all += row[k];
    double thick = r->spec->scene.radius[0], arm = r->scene.prism.arm[0];
    wf_diag_warn(
        d, "restoring-springs",
        "yang2011: springs to the rest place are a foundation that no branch stands on; under the weight of "
        "branch and leaves they hold %.0f %% of the energy that bending should hold",
        100 * row[WF_PRISM_RESTORING] / all);
    wf_diag_warn(
        d, "diagonal-mass",
        "yang2011: a third of the mass on each vertex at %.2g mm from the axis makes the branch's polar "
        "inertia %.2g times that of its wood of %.2g mm, and leaves out that of the blades",
        1000 * arm, 2 * arm * arm / (thick * thick), 1000 * thick);
    wf_diag_warn(d, "explicit-euler",
                 "yang2011: explicit Euler, as printed, is stable here below %.2g s, %.2g steps a second; %s",
                 r->euler_limit, 1 / r->euler_limit,
                 r->spec->method == WF_PRISM_EULER ? "it ran" : "the implicit midpoint step ran instead");
}

void wf_rain_departures(const struct wf_rain_result *r, struct wf_diag *d)
{
    if (r->spec->printed) {
        of_impacts(r, d);
        of_shapes(r, d);
        of_forces(r, d);
        of_prisms(r, d->arena, d);
    }
    wf_diag_warn(
        d, "assumed-values",
        "assumed, with no source: friction mu, %s, beta, number of subdrops, stiffness and size of the "
        "petiole, shape of the leaf, damping ratio %.2g, %s; docs/rain.md lists all",
        r->spec->printed ? "adhesion H, what hangs at an edge"
                         : "hysteresis of the contact angle, apex, film",
        r->spec->damping, r->spec->printed ? "constants of the springs" : "splash share");
    if (r->spec->wind && !r->spec->printed)
        wf_diag_warn(
            d, "leaf-drag",
            "the wind pushes on blades as on flat plates, Cd 1.2 (assumed), and leaves neither curl nor "
            "shelter one another: their motion is that of stiff blades");
    if (r->spec->shaken)
        wf_diag_warn(
            d, "shaking",
            "drops feel the acceleration of blades that do not bend across the vein, smoothed over 2.4 "
            "ms: more of them fall off than from a real leaf, above all after an impact");
    double most = 0;
    for (size_t i = 0; i < r->rows; i++) most = fmax(most, r->row[i].petiole_force / r->spec->water.gravity);
    wf_diag_warn(d, "water-inertia",
                 "water on leaves acts by weight and impact, not by its inertia: with %.3g mg on a leaf of "
                 "%.3g mg its "
                 "frequency would be up to %.1f %% lower",
                 1e6 * most, 1e6 * leaf_mass(r), 100 * (1 - 1 / sqrt(1 + most / leaf_mass(r))));
}
