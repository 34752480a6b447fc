/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_LIMITS_H
#define WF_STUDY_LIMITS_H
/* Validity of a finished analysis: each limit that is exceeded becomes a warning that states by how much.
 * Stable codes: small-deflection, reynolds-range, streamline-range, profile-range, steep, map-edge,
 * assumed-values, as-printed, no-strength, no-equilibrium, critical-above-range, searched-further,
 * search-ended, self-weight, through-ground, unverified-safety, unverified-wind, size-effect,
 * anchorage-soil, diaphragms, twig-leaves, few-leaves, beyond-elastic, root-linear. */
#include "base/err.h"
#include <stdbool.h>

struct wf_analysis; /* study/analysis.h */
struct wf_at_speed;
struct wf_scenario; /* load/scene.h */
struct wf_tree;     /* data/tree.h */
struct wf_site;     /* wind/terrain.h */

/* Limits of a small-deflection answer: share of tree height [-] and angle of the axis [rad] (15 deg). */
#define WF_SMALL_DEFLECTION_SHARE 0.10
#define WF_SMALL_DEFLECTION_TURN 0.26179938779914943

/* Is this a small-deflection answer beyond those limits? Slopes of all rows are compared where they are kept,
 * else the tip's. */
bool wf_limits_small_passed(const struct wf_at_speed *at);

/* The through-ground warning alone. Given: 3 numbers for each row, its bent end, or (moved) how far it moved
 * [m]; for the message who and when, "at 20 m/s"; d NULL: no warning. Only rows that stand above the ground
 * without load are looked at. Returned: height of the lowest end [m]; 0 where none is below the ground. */
double wf_limits_ground(const struct wf_tree *t, const double *end, bool moved, const char *who,
                        const char *when, struct wf_diag *d);
/* The profile-range warnings alone, for a tree of that height [m]. */
void wf_limits_profile(const struct wf_scenario *s, double tallness, const char *tree, struct wf_diag *d);
/* The warnings of the terrain alone: steep, map-edge. NULL: none. */
void wf_limits_site(const struct wf_site *s, struct wf_diag *d);

#endif
