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
    double length, radius, youngs, density; /* [m], [m], [Pa], [kg m-3]; G = E/16 */
    double restoring;                       /* [N/m] */
};
/* Errors for 4, 8, 16, 32 and 64 prisms. Errors: those of wf_prism_make and wf_prism_settle. */
enum wf_status wf_prism_compare(const struct wf_prism_rod *rod, struct wf_arena *a,
                                struct wf_prism_check out[WF_PRISM_CHECKS], struct wf_err *e);
#endif
