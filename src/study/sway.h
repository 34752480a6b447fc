/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SWAY_H
#define WF_STUDY_SWAY_H
/* How a tree sways about its state in a mean wind, for its peak load. */
#include "study/peak.h"
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Complete an->peak for the scenario's method: size of the tree across the wind, terrain, damping, and sways
 * at some wind speeds, among them the given ones (of many some). Given: an analysis after wf_analysis_set_up.
 * Returned: an->peak, in `a`; an->wind, where the method has a wind of its own; warnings in `d` (NULL: none)
 * where a method is used beyond its validity. Errors: WF_EUSAGE for an unknown method or a request that does
 * not go together; WF_EINTERRUPTED. */
enum wf_status wf_sway_set_up(struct wf_analysis *an, const struct wf_solve_options *o, const double *speeds,
                              size_t n, struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

/* The same in wind from another direction than that of `first`, the peak load of the same tree between
 * wf_sway_begin and wf_sway_end, whose mesh is taken. Several threads may call it for one `first`. */
enum wf_status wf_sway_turned(struct wf_analysis *an, const struct wf_peak *first,
                              const struct wf_solve_options *o, const double *speeds, size_t n,
                              struct wf_arena *a, struct wf_err *e);

/* As wf_sway_set_up, with the sways that the given speeds need. Those that higher speeds need are found by
 * wf_sway_reach, before the peak load at a speed [m/s] is asked for, and are the same as if all had been
 * found at once; nothing is done where they are known. Until wf_sway_end, which is called on success and
 * failure alike and leaves `partial` in an->peak where sways were not asked for; the analysis stays where it
 * is, and no two threads ask. */
enum wf_status wf_sway_begin(struct wf_analysis *an, const struct wf_solve_options *o, const double *speeds,
                             size_t n, struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
void wf_sway_reach(const struct wf_analysis *an, double speed);
void wf_sway_end(const struct wf_analysis *an);
/* All sways of an analysis after wf_analyze, which finds those that it needs: a new an->peak in `a` where
 * some are not known. Errors: as wf_sway_set_up. */
enum wf_status wf_sway_complete(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_arena *a,
                                struct wf_err *e);

/* As wf_sway_set_up without a solution, for a tree that differs from another, `like`, in the values of its
 * rows: the other's sways with frequency, modal mass and damping of the air by the ratios of the stem's
 * compliance at its top, of the mass and of the drag area in the crown's wind `speed` [m/s], for a shape that
 * grows with the square of the height. Exact where all rows change by one factor and weight does not bend the
 * tree. Returned: also *out, which is an->peak. */
enum wf_status wf_sway_alike(struct wf_analysis *an, const struct wf_analysis *like, double speed,
                             struct wf_arena *a, struct wf_peak **out, struct wf_err *e);

/* A mode of a tree about its state in a mean wind. */
struct wf_sway_mode {
    double frequency; /* [Hz]; -f: the state is unstable, this motion grows (solve/modes.h) */
    double mass;      /* modal, where the stem's tip moves by 1; NAN: it hardly moves [kg] */
    double share[3];  /* effective modal mass over the tree's mass: along the wind, across it, vertical [-] */
    double turn[2];   /* share of the overturning by inertia about the base: along the wind, across it [-] */
    double structural, air,
        damping;         /* of critical: of the wood, of the air without limit, total limited [-] */
    const double *shape; /* 3n: displacement of each row's end, largest component 1 */
};
struct wf_sway_modes {
    size_t count;
    const struct wf_sway_mode *mode;
    bool damping_known;  /* the structural damping is given, not assumed */
    struct wf_sway sway; /* of the tree as a whole along the wind, as for the peak load (study/peak.h) */
    double damping;      /* of the sway, total, limited; of critical [-] */
    const double *shape; /* of the sway, as of a mode */
};
/* The `count` lowest modes about the tree's state in a mean wind of a named speed [m/s]; 0: still air. Modes
 * of almost one frequency, such as those of a round stem, are turned so that one moves along the wind.
 * Structural damping: the request's, else the species' by mass, else assumed. Given: an analysis after
 * wf_analysis_set_up; where it is known from wf_sway_set_up on a mesh of that tolerance, the sway in still
 * air is not found again. `most`: as of wf_modes_parts. Errors: of the beam solver and of wf_modes_parts. */
enum wf_status wf_sway_modes(const struct wf_analysis *an, const struct wf_solve_options *o, double speed,
                             size_t most, size_t count, struct wf_arena *a, struct wf_sway_modes *out,
                             struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
