/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_WALLS_H
#define WF_STUDY_WALLS_H
/* What cavities take from a stem: strength, stiffness, safety with and without them, and the wall that would
 * be enough. */
#include "study/analysis.h"

/* Safety for which a least wall is given. */
enum wf_wall_limit_id {
    WF_WALL_BREAKS,  /* 1.0 by the modulus of rupture   */
    WF_WALL_BREAKS2, /* 1.5 by the modulus of rupture   */
    WF_WALL_YIELDS,  /* 1.5 by the compressive strength */
    WF_WALL_LIMITS
};
struct wf_wall_limit {
    const char *criterion; /* name of its row in wf_criteria */
    double required;
};
extern const struct wf_wall_limit wf_wall_limits[WF_WALL_LIMITS];

/* One cavity at one wind speed, at the place within it where that is least. NAN: no equilibrium, or no
 * strength. */
struct wf_wall_safety {
    double basic;                 /* by bending, of the section without the cavity, under the same load [-] */
    double present;               /* with it: least of bending and, of a closed thin wall, splitting and flattening */
    double share[WF_WALL_LIMITS]; /* least wall over the radius of the wood [-]; INFINITY: not even a solid
                                     stem */
};

struct wf_walls {
    const struct wf_cavity *cavity;
    const struct wf_hollow *hollow;
    double radius;             /* of the wood where it was measured [m]                          */
    double wall;               /* thinnest sound wall there [m]                                   */
    double strength_loss;      /* of the section modulus, in the direction where it is most [-]   */
    double worst;              /* that direction of bending [rad], within half a turn             */
    double with_wind;          /* the same in the direction of the wind [-]                       */
    double stiffness_loss;     /* of the least second moment of area [-]                          */
    struct wf_wall_safety *at; /* by the given winds                                          */
};

/* Given: an analysis with its results. Returned: *out, n structs, one a cavity of the tree; n 0: none. The
 * load of a section is that of the tree with its cavities; basic safety and least walls are closed forms
 * under this load: a round stem, and a closed concentric ring, whose safety under the same moment and axial
 * force is the one required. The moment itself hardly depends on the wall. Errors: WF_ENOMEM. */
enum wf_status wf_walls_assess(const struct wf_analysis *an, struct wf_arena *a, struct wf_walls **out,
                               size_t *n, struct wf_err *e);

/* Wood of a ring, and the safety that is required. */
struct wf_ring_wood {
    double strength;   /* in bending [Pa]                                              */
    bool compressed;   /* the strength is of the compressed side alone                 */
    double youngs, tangential, transverse; /* for splitting and flattening, as struct wf_tree [Pa]; 0: not known */
    double required;   /* [-] */
};
/* Least wall over the outer radius at which a closed ring carries moment and axial force (tension positive) with
 * the required safety against bending and, where its wall is thin (t below 0.3 of the mean radius) and the wood's
 * values are known, splitting and flattening (fail/strength.c). Given: radius [m]. INFINITY: not even solid; NAN:
 * strength not known. */
double wf_wall_needed(double moment, double axial, double radius, const struct wf_ring_wood *w);
#endif
