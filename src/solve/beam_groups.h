/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_GROUPS_H
#define WF_SOLVE_BEAM_GROUPS_H
/* Sweeps over a tree by groups of elements of one state, none of which stands on another of its group. A
 * group is computed side by side, an element in each lane; beam_groups.c is compiled once for every width,
 * and the results have the same bytes at any width. Sections are round. */
#include "solve/beam_mesh.h"

enum { WF_GROUP = 8 }; /* elements of a group */

/* Groups in the order of the way down: what stands on an element comes in an earlier group. Elements that
 * stand on the ground are in none. n: 0 where too few elements can be taken together. */
struct wf_beam_group {
    int32_t n;            /* elements */
    int32_t id[WF_GROUP]; /* the elements, then the first of them again */
};
struct wf_beam_groups {
    size_t n;
    struct wf_beam_group *group;
};

/* Given: mesh. Returned: *out, in the arena. Method: of the elements on which all above is done, those
 * farthest from the ground come first, which gives the fewest groups (Hu 1961, Oper. Res. 9:841). Errors:
 * WF_ENOMEM. */
enum wf_status wf_beam_groups_make(const struct wf_beam_mesh *m, struct wf_arena *a,
                                   struct wf_beam_groups *out, struct wf_err *e);

/* A state and its sweep; the arrays are those of struct wf_beam, as doubles. */
struct wf_groups_sweep {
    const struct wf_beam_mesh *mesh;
    const struct wf_beam_groups *groups;
    const struct wf_loads *loads;
    double *shape, *pose, *stage, *wrench, *load, *node, *answer;
    double *small; /* NULL: not wanted; else filled with the tangent */
    double *side;  /* as `shape`: with the tangent, changes of the strains where the loads grow: */
    bool grows;
    struct wf_beam_growth growth;
    double *off;   /* NULL: not wanted */
    bool *weak;    /* NULL: not wanted */
    bool upwards;  /* by chains: the way up */
    bool tangent;  /* eliminate too */
    bool guard;    /* as in wf_beam_eliminate */
    bool frozen;   /* derivatives of the loads are left out */
    bool counting; /* count unstable directions below -margin */
    double margin;
    /* returned by `down`, sums over the groups: as struct wf_beam_misfit and struct wf_beam_stability */
    double bending, energy, strain, turn, bears;
    size_t negative;
    bool apart; /* by the guard an element was taken by itself */
    bool whole; /* by `chains_down`: as the answer of `down` */
};

struct wf_groups_kernel {
    size_t width;
    /* Place the elements, whose bases on the ground are placed. */
    void (*up)(struct wf_groups_sweep *x);
    /* Forces, residual, tangent; adds to `wrench` and `node` of the elements below. false: a tangent is
     * singular. */
    bool (*down)(struct wf_groups_sweep *x);
    /* The same of up to `width` trees side by side, whose elements stand one on another, by falling numbers
     * of elements; those on the ground are left out. On the way down they are alike in `tangent`, `frozen`,
     * in `small` (wanted or not), in `grows` and in the forms of their winds, and have no `off`, `weak` or
     * ties. */
    void (*chains_up)(struct wf_groups_sweep *const *x, size_t n);
    void (*chains_down)(struct wf_groups_sweep *const *x, size_t n);
};
extern const struct wf_groups_kernel wf_groups_1, wf_groups_4, wf_groups_8;
/* Kernel for so many lanes on this processor; WINDFIRM_LANES as for wf_lanes_kernel. */
const struct wf_groups_kernel *wf_groups_kernel(size_t n);
#endif
