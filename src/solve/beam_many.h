/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_MANY_H
#define WF_SOLVE_BEAM_MANY_H
/* Many states of one tree by the beam solver, several at a time side by side (solve/beam_lanes.h):
 * directions, wind speeds, air. */
#include "solve/beam_lanes.h"

/* States solved together: eight in the order given share their meshes. */
enum { WF_BEAM_BLOCK = 8 };

struct wf_beam_state {
    const struct wf_loads *loads; /* given */
    struct wf_response response;  /* returned, as by wf_solver.solve; in the arena of the call */
    enum wf_status status;        /* likewise; `why` where it is not WF_OK */
    struct wf_err why;
    bool alone; /* it was solved by itself: not found side by side within few iterations, or not stable there
                 */
    bool beyond_limit; /* it lies beyond a limit point (struct wf_beam_outcome) */
    size_t loose;      /* small parts that are in equilibrium but not stable */
};

struct wf_beam_few; /* solve/beam.h */
/* Solve n states. Given: tree, loads of each state, options; a mesh that follows from another state of the
 * tree, on which a block is solved where it is good by far for all of its states (NULL: none). Returned: each
 * state's response and status; warnings in *d (may be NULL). Errors: those that concern no single state,
 * WF_ENOMEM and WF_EINTERRUPTED; WF_EINPUT for a tree that does not pass wf_solve_check.
 *
 * The states of a block of WF_BEAM_BLOCK are solved on the same meshes, each of which is refined where one of
 * the states that still need it asks for it. Hence the answer of a state depends, within the mesh tolerance,
 * on the others of its block, but neither on the processor's vector width nor on the number of threads. What
 * lanes do not cover is solved as wf_solver_beam does: a single state, sections that are not round, root
 * springs, point loads, cables, different line loads. */
enum wf_status wf_beam_many(const struct wf_tree *t, struct wf_beam_state *state, size_t n,
                            const struct wf_solve_options *o, const struct wf_beam_few *few,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

/* Memory of x->width lanes on its mesh; what Newton's method alone needs is in `newton`. Errors: WF_ENOMEM.
 */
enum wf_status wf_lanes_take(const struct wf_lanes_kernel *k, struct wf_lanes *x, struct wf_arena *a,
                             struct wf_arena *newton, struct wf_err *e);
enum wf_status wf_lanes_joints_make(const struct wf_beam_mesh *m, struct wf_arena *a,
                                    struct wf_lanes_joints *out, struct wf_err *e);
#endif
