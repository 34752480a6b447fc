/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_WALLS_H
#define WF_STUDY_WALLS_H
/* What cavities take from a stem: strength, stiffness, safety with and without them, and the wall that would
 * be enough. */
#include "study/analysis.h"

/* Safety for which a least wall is given. */
enum wf_wall_limit_id {
    WF_WALL_BREAKS,  /* 1.0 by the modulus of rupture    */
    WF_WALL_BREAKS2, /* 1.5 by the modulus of rupture    */
    WF_WALL_YIELDS,  /* 1.5 by the compressive strength  */
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
    double basic;                 /* of the same section without the cavity, under the same load [-] */
    double present;               /* with it [-]                                                      */
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

/* Least wall over the radius of the wood at which a ring carries moment and axial force (tension positive)
 * with that safety. Given: radius [m], strength [Pa], whether the compressed side alone counts. INFINITY: not
 * even solid. */
double wf_wall_needed(double moment, double axial, double radius, double strength, bool compressed);
#endif
