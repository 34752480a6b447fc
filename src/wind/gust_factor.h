/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_FACTOR_H
#define WF_WIND_GUST_FACTOR_H
/* Peak over mean load of an upright structure in a turbulent wind, by the rules of design codes: the
 * background of gusts that do not reach the whole structure at once, and the resonance of one mode of
 * vibration. */
#include "wind/category.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_gust_case {
    const struct wf_category *terrain;
    double height, breadth;    /* of the structure, across the wind [m]; 0: gusts reach the whole of it     */
    double frequency, damping; /* of the mode [Hz], ratio to critical damping in total [-]                  */
    double mean;               /* mean wind at the reference height of the rule [m/s]                       */
    double open;               /* 10-min mean at 10 m over open ground [m/s]                                */
    double exponent;           /* of the load in the wind speed, for gusts about the mean [-]               */
    bool small;                /* a part of it that a gust reaches at once: no reduction by size            */
};

struct wf_gust_parts {
    double turbulence; /* intensity at the reference height [-]                        */
    double background; /* B^2; Q^2 in ASCE 7 [-]                                       */
    double resonance;  /* R^2 [-]                                                      */
    double peak;       /* peak factor; that of the resonance in ASCE 7 [-]             */
    double factor;     /* G: peak over mean load [-]                                   */
    double structural; /* c_s c_d or G_f, which multiplies the load of the gust; NAN: the code has none */
};

struct wf_gust_rule {
    const char *name, *title, *source, *validity;
    /* Reference height for a structure [m]. */
    double (*at)(const struct wf_category *terrain, double height);
    /* All members of the case are positive, but for breadth. */
    void (*parts)(const struct wf_gust_case *c, struct wf_gust_parts *out);
    /* The code's own name of a terrain: category A to D of GB 50009, exposure B to D of ASCE 7. */
    const char *(*called)(const struct wf_category *terrain);
};
extern const struct wf_gust_rule wf_gust_rules[]; /* en1991, gb50009, asce7; ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_gust_rule *wf_gust_rule_named(const char *name);

/* Largest over mean moment at the base of a tree in a stand: factor of edge, gap and gusts, from wind-tunnel
 * models of stands. Given: height of the stand, mean distance between its trees, distance from its upwind
 * edge, length of the gap before the edge [m]. The mean is that well inside the stand whatever the edge.
 * Spacing over height is held within 0.075..0.45, the distance from the edge within 9 heights, the gap
 * within 10. Source: Stacey et al. 1994, Boundary-Layer Meteorol. 69:311; Gardiner et al. 1997, Forestry
 * 70:233; Gardiner, Peltola & Kellomaki 2000, Ecol. Model. 129:1, eqs 4 and 5. */
double wf_stand_gust(double height, double spacing, double edge, double gap);

/* Mean wind moment on a tree well inside a stand, from the momentum that the stand takes from the wind.
 * Given: density of the air [kg m-3], mean wind at the canopy top [m/s], height and spacing of the stand [m],
 * frontal area of a crown in that wind times its drag coefficient [m2]. Returned: the moment at the ground
 * [N m]: the shear stress rho u*^2 on the ground of one tree, spacing^2, acts at the zero-plane displacement
 * d. Source: Raupach 1992, Boundary-Layer Meteorol. 60:375, and 1994, ibid. 71:211 (u*, d); Thom 1971, Q. J.
 * R. Meteorol. Soc. 97:414 (height); as in GALES, Gardiner et al. 2000. Canopy area index twice the drag area
 * over spacing^2; u*^2/u^2 at most that of an index of 0.6. */
double wf_stand_moment(double density, double speed, double height, double spacing, double drag_area);

#ifdef __cplusplus
}
#endif
#endif
