/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_PRISM_CHECK_H
#define WF_STUDY_PRISM_CHECK_H
/* A cantilever of prisms against Euler-Bernoulli and Saint-Venant, by number of prisms. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>

enum { WF_PRISM_CHECKS = 5 };
struct wf_prism_check {
    size_t prisms;
    double bend, twist, frequency; /* relative errors: tip deflection, twist, first frequency [-] */
    double held;                   /* tip deflection with the restoring springs, over theory [-]  */
    double quick; /* first frequency with them, over theory: how much sooner it returns [-] */
};
struct wf_prism_rod {
    double length, radius, youngs, shear, density; /* [m], [m], [Pa], [Pa], [kg m-3] */
    double restoring;                              /* of every vertex to its rest place [N/m] */
};
/* A cantilever of n prisms: tip deflection by a force across at its tip [N], twist by a moment about its axis
 * [N m], first frequency. Errors: those of wf_prism_make, wf_prism_settle and wf_prism_frequency. */
struct wf_prism_answer {
    double tip, turn, frequency; /* [m], [rad], [Hz] */
};
enum wf_status wf_prism_cantilever(const struct wf_prism_rod *rod, size_t n, double force, double moment,
                                   struct wf_arena *a, struct wf_prism_answer *out, struct wf_err *e);
/* Errors for 4, 8, 16, 32 and 64 prisms. Errors: those of wf_prism_make and wf_prism_settle. */
enum wf_status wf_prism_compare(const struct wf_prism_rod *rod, struct wf_arena *a,
                                struct wf_prism_check out[WF_PRISM_CHECKS], struct wf_err *e);

/* The four kinds of springs as the paper prints them, without a law for their constants: one constant for
 * structural, shear and bending springs, a third of the mass on each vertex. A branch of n segments, level,
 * gets its weight and a drop's push at its tip; after 1.5 s the weight is taken away, and 4 s later it ends.
 * What the paper says of them shows: long branches return slowly or stay folded unless restoring springs pull
 * every vertex to its rest place. */
struct wf_prism_order {
    size_t prisms;
    double constant, restoring; /* [N/m]                                                          */
    double sag;                 /* of the tip at the end of the load, over the branch's length [-]     */
    double fold;                /* largest turn between neighbouring sections then [rad]               */
    double strain;              /* largest change of a spring's length then, over its length [-]       */
    double back;                /* time after which the tip stays within 5 % of the sag [s]; NAN: never */
    double left;                /* distance of the tip from its rest place at the end, over the length [-] */
    double *line;               /* 6(prisms + 1): axis at the end of the load, then at the end [m]       */
};
enum { WF_PRISM_ORDERS = 2 * WF_PRISM_CHECKS };
/* Given: the rod, of whose length a sixteenth is one segment. Returned: 4, 8, 16, 32 and 64 segments without
 * restoring springs, then with rod->restoring. Errors: those of the prisms; WF_EINTERRUPTED. */
enum wf_status wf_prism_disorder(const struct wf_prism_rod *rod, struct wf_arena *a,
                                 struct wf_prism_order out[WF_PRISM_ORDERS], struct wf_err *e);
#endif
