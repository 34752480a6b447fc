/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_TRACK_H
#define WF_SOLVE_TRACK_H
/* One tree under one load after another by the beam solver: each solution starts from the shape
 * and, near it, on the mesh of the last one, and gives its derivative by the load. */
#include "solve/solve.h"

struct wf_track;

/* Given: tree, options (mesh_tolerance as for one solution); `like`, a track of the same tree and tolerance
 * whose mesh is taken, and its form in still air (NULL: none). All must outlive the track; tracks with the
 * same `like` may be used at the same time, but not that one. Returned: *out. Errors: WF_ENOMEM. */
enum wf_status wf_track_open(const struct wf_tree *t, const struct wf_solve_options *o,
                             const struct wf_track *like, struct wf_track **out, struct wf_err *e);
/* The rows of `like` are those of another tree that differs in their values: begin at the form of its last
 * solution instead of that in still air, and
 * keep to its mesh. Before the first solution. */
void wf_track_begin_at_last(struct wf_track *k);
struct wf_beam;
struct wf_beam_few; /* solve/beam.h */
/* A mesh that the track takes at loads where it is good by far. It must outlive the track. NULL: none. */
void wf_track_few(struct wf_track *k, const struct wf_beam_few *few);
/* The solution nearest to a wind speed [m/s], if one is near, for another to begin with its shape, until the
 * next call; NULL: none. */
const struct wf_beam *wf_track_near(struct wf_track *k, double speed);
/* Elements of a row on the mesh of the last solution; 0: there is none. */
int32_t wf_track_pieces(const struct wf_track *k, size_t row);
/* NULL is allowed. */
void wf_track_close(struct wf_track *k);

struct wf_tracked {
    struct wf_response at;   /* at the loads */
    struct wf_response side; /* at the other loads, where `sided` */
    bool sided, finished;    /* `at` is a step of Newton's method further than it needs to be */
    bool irregular; /* small parts are not stable, or a limit point lies on the way to the full load */
};

/* Ratio of two wind speeds up to which the derivative of one solution leads to the other. */
#define WF_TRACK_NEAR 1.4

/* Where Newton's method starts: from the solution whose wind speed is nearest, of this track or, where none
 * is near, of another. */
struct wf_track_start {
    double share;               /* `side` are the loads of a wind that is faster by this share [-] */
    struct wf_track *other;     /* a track of the same tree, whose last solution may become another of its own
                                   (NULL: none) */
    struct wf_track *paced;     /* a track of the same tree under other loads of the wind, from whose solution
                                   at the same pace (wf_beam_pace) it starts too (NULL: none) */
    const struct wf_beam *from; /* a solution at these loads on another mesh (NULL: none) */
    bool alone; /* the answer to `side` is not wanted, and no solution near this one follows on this track */
};

/* Equilibrium at the loads `l`. Given: `side` (NULL: not wanted), loads that differ from l by a small d, in
 * the wind's speed and wind_scale alone; the response to them is first-order: its difference to the answer,
 * over d, is the derivative of the answer to an error of order d and of what the tolerance leaves. Returned:
 * as the solver 'beam'. Method: Newton's method on the mesh of the last solution, from a shape between those
 * of the solutions beside this one, by their values and derivatives, or from the nearest moved along its
 * derivative where it is near; and what the beam solver does where that fails. The mesh is compared with one
 * twice as fine at the first and every fourth solution, unless it was found good by far, near its wind speed
 * or on both sides of it, and refined where it does not meet the tolerance. */
enum wf_status wf_track_solve(struct wf_track *k, const struct wf_loads *l, const struct wf_loads *side,
                              const struct wf_track_start *start, struct wf_arena *a, struct wf_tracked *out,
                              struct wf_err *e);

struct wf_modes_sway; /* solve/modes.h */
/* The sway of the tree about its last solution; as wf_modes_sway. Errors: also WF_EINTERNAL where there is
 * none.
 */
enum wf_status wf_track_sway(struct wf_track *k, const double to[3], const double *width, size_t bands,
                             struct wf_modes_sway *out, double *shape, struct wf_err *e);
#endif
