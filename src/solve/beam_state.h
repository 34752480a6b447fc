/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_STATE_H
#define WF_SOLVE_BEAM_STATE_H
/* All elements of a tree together. */
#include "solve/beam_element.h"
#include "solve/beam_groups.h"

/* Elements that move while the others keep their place: with each all that stand on it. */
struct wf_beam_only {
    size_t n;
    int32_t *id;           /* from the ground up */
    bool *held;            /* per element of the mesh: it keeps its place */
    int32_t *root, *place; /* work space, per element */
    double (*saved)[2][6]; /* v and its last correction */
};

struct wf_beam_links;
struct wf_beam {
    struct wf_beam_mesh mesh;
    struct wf_beam_groups groups; /* of elements that are computed side by side */
    bool chain;                   /* several elements, round, each on the one before: no branches */
    struct wf_loads loads;        /* a copy: load steps change its scale factors */
    const struct wf_solve_options *options;
    size_t feet;                 /* rows that may stand on the ground, the first, mostly one */
    double (*tilt)[3];           /* per row, for roots: rotation vector of the root plate */
    double (*root_step)[3];      /* per row of `feet`, for roots, as those below: Newton correction of tilt */
    double (*root_change)[6];    /* change of the base pose by that correction */
    double (*root_give)[9];      /* spin of the plate by moment */
    double (*root_hold)[6][3];   /* wrench on the ground by spin of the plate */
    struct wf_beam_shape *shape; /* per element, as all below */
    struct wf_beam_pose *pose;   /* of the element's end */
    struct wf_beam_stage *stage;
    struct wf_beam_flat *flat;     /* rotated with the element; NULL = all sections are round */
    struct wf_beam_wrench *wrench; /* internal force and moment just below the element's end */
    double (*load)[2][3];          /* at the Gauss points per length, of the last sweep down [N/m] */
    struct wf_beam_reaction *node;
    struct wf_beam_answer *answer;
    double (*change)[6]; /* of the end */
    double (*dv)[2][3];
    double (*k0)[2][3];           /* curvature at the start of a creep step */
    double (*tilt0)[3];           /* per row, for roots: tilt at the start of a creep step */
    struct wf_beam_small *small;  /* NULL unless wf_beam_linearise allocated it, or there are links */
    struct wf_beam_sides *sides;  /* as `small`: work space of solutions for small loads */
    wf_four (*root_moved)[6];     /* as `small`, per row, for roots: change of the base pose by small loads */
    struct wf_beam_links *links;  /* NULL: there are none (solve/beam_ends.h) */
    const struct wf_loads *other; /* loads to which the change is wanted with the last tangent of Newton's
                                     method (solve/beam_small.h); NULL: not wanted */
    bool apart;                 /* the last tangent took an element by itself (guard of wf_beam_eliminate): it
                                   is not exact */
    bool sided;                 /* it came with the change: */
    struct wf_beam_shape *side; /* of the unknowns */
    bool close;                 /* the start of Newton's method is likely to be within the tolerance */
    double (*root_side)[6];     /* per row, for roots: of the wrench on the ground, at a root that keeps its
                                   place; then of tilt and spin of the plate */
    double creep;
    bool frozen;                        /* wind acts as a dead load: its derivatives are omitted */
    struct wf_beam_wrench base;         /* exerted on the ground, moment about the first root */
    struct wf_beam_misfit misfit;       /* of the present shape */
    struct wf_beam_stability stability; /* of the present shape, where `counted` */
    bool counted;
    bool finished; /* the last step of Newton's method was wf_beam_finish: there is no tangent of the shape */
    const struct wf_beam_only *only; /* the elements that move; NULL: all */
    struct wf_beam_only part;        /* room for such a list */
    bool *weak;   /* per element: set where it is unstable with all above it, when that is counted; NULL: not
                     wanted */
    double *off;  /* per element: its part of misfit.bending; NULL: a tree without branches */
    size_t loose; /* small parts of the last solution that are in equilibrium but not stable */
    size_t iterations, steps;
    bool by_steps; /* load steps and creep: the small parts wait for the tree */
    bool hasty;    /* what follows where Newton's method stalls takes less time than to wait for it */
    int tries;     /* of small parts by themselves, left in this call of Newton's method */
};

/* The elements that move, from the ground up: how many, and which is the k-th; and does one keep its place?
 */
static inline size_t wf_beam_moving(const struct wf_beam *b) { return b->only ? b->only->n : b->mesh.n; }
static inline size_t wf_beam_moved(const struct wf_beam *b, size_t k)
{
    return b->only ? (size_t)b->only->id[k] : k;
}
static inline bool wf_beam_held(const struct wf_beam *b, size_t i) { return b->only && b->only->held[i]; }

/* Section of element i in the deformed state; NULL: it is round. */
static inline const struct wf_beam_flat *wf_beam_flat_of(const struct wf_beam *b, size_t i)
{
    return b->flat ? &b->flat[i] : NULL;
}
#endif
