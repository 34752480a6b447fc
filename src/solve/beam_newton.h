/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_NEWTON_H
#define WF_SOLVE_BEAM_NEWTON_H
/* All elements of a tree together: sweeps up and down the tree, Newton, and the ways on when Newton stalls.
 */
#include "solve/beam_element.h"

struct wf_beam {
    struct wf_beam_mesh mesh;
    struct wf_loads loads; /* a copy: its scales are what continuation changes          */
    const struct wf_solve_options *options;
    double (*tilt)[3];           /* per row, for roots: rotation vector of the root plate     */
    double (*root_step)[3];      /* per row, for roots: its Newton correction                 */
    double (*root_change)[6];    /* per row, for roots: change of the ground under it         */
    double (*root_give)[9];      /* per row, for roots: spin of the ground by moment          */
    double (*root_hold)[6][3];   /* per row, for roots: wrench on the ground by its spin      */
    struct wf_beam_shape *shape; /* per element, as all below                                 */
    struct wf_beam_pose *pose;   /* of the element's end                                      */
    struct wf_beam_stage *stage;
    struct wf_beam_flat *flat;     /* turned with the element; NULL = all sections are round    */
    struct wf_beam_wrench *wrench; /* just below the element's end                              */
    struct wf_beam_reaction *node;
    struct wf_beam_answer *answer;
    double (*change)[6]; /* of the end                                                */
    double (*dv)[2][3];
    double (*k0)[2][3];          /* curvature creep starts from                               */
    double (*tilt0)[3];          /* per row, for roots: tilt creep starts from                */
    struct wf_beam_small *small; /* NULL unless small motions are asked for                   */
    double (*push)[6];           /* wrench on element ends in an answer to small loads        */
    double creep;
    bool frozen;                  /* wind is a dead load: its derivatives are left out         */
    struct wf_beam_wrench base;   /* put on the ground, moment about the first root            */
    struct wf_beam_misfit misfit; /* of the present shape                                      */
    size_t loose;                 /* small parts of the last answer that are balanced but not stable  */
    size_t iterations, steps;
};

/* Take what the mesh needs from the arena and start from the unloaded shape. */
enum wf_status wf_beam_init(struct wf_beam *b, const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, const int32_t *pieces, struct wf_arena *a,
                            struct wf_err *e);

/* Base to tips: place every element from the unknowns. */
void wf_beam_sweep_up(struct wf_beam *b);
/* Tips to base: forces, misfit; with `tangent` also the tangent. count (may be NULL): also unstable
 * directions. false when the tangent is singular. */
bool wf_beam_sweep_down(struct wf_beam *b, bool tangent, struct wf_beam_stability *count);

/* Newton with line search at the present loads, from the present shape. Returned: WF_OK, or WF_ENOCONV with
 * the shape where it stalled. */
enum wf_status wf_beam_newton(struct wf_beam *b);

struct wf_beam_outcome {
    double load_factor; /* share of the load up to which the tree stands on the path from rest */
    bool beyond_limit;  /* the answer lies past a limit point: the tree fell over to it        */
};
/* Equilibrium at the full load, by the first of these that gets there: Newton from the present shape; load
 * steps; past a limit point by creep (each step minimises elastic energy plus a viscous term that fades).
 * Returned: WF_OK; WF_EUNSTABLE with *out telling the last load that stood. Always ends. */
enum wf_status wf_beam_settle(struct wf_beam *b, struct wf_arena *a, struct wf_beam_outcome *out,
                              struct wf_err *e);

/* Does the present, balanced shape stand (after wf_beam_sweep_up)? The one rule for every solver that asks
 * the beam engine: unstable directions bring the tree down unless the parts that have them bear less than a
 * hundredth of what the ground does; such parts are counted in b->loose. */
bool wf_beam_stable(struct wf_beam *b);

/* Where element i starts: the end of the element below, or the ground plate under a root (written to
 * *ground). The answer points to one of the two. */
const struct wf_beam_pose *wf_beam_base(const struct wf_beam *b, size_t i, struct wf_beam_pose *ground);

/* Section of element i that is not round, turned with it; NULL: it is round. */
static inline const struct wf_beam_flat *wf_beam_flat_of(const struct wf_beam *b, size_t i)
{
    return b->flat ? &b->flat[i] : NULL;
}
#endif
