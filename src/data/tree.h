#ifndef WF_DATA_TREE_H
#define WF_DATA_TREE_H
/* A tree as columns: one row a segment, base to tip, every parent before its children.
 * All lengths in metres, z up, ground at z = 0, SI throughout. Quantities with 0/1 vary linearly from
 * the segment's base (0) to its end (1). */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct wf_tree {
    const char *name;
    size_t n;             /* segments                                              */
    int32_t *parent;      /* row of the segment below; -1 = clamped to the ground  */
    int32_t *level;       /* branching level, 0 = stem                             */
    int64_t *id;          /* the user's id of the row, for messages                */
    double *x0, *y0, *z0; /* base [m]                                              */
    double *x1, *y1, *z1; /* end [m]                                               */
    double *bend;         /* 3n: initial curvature vector of the axis, global [1/m]; NULL = straight rows */
    double *r0, *r1;      /* outer radius [m]                                      */
    double *i0, *i1;      /* inner radius [m]; 0 = solid                           */
    double *youngs, *shear, *density, *strength; /* E, G [Pa], [kg m-3], MOR*knot factor [Pa] (0: unknown) */
    double *drag;                                /* cross-flow drag coefficient; NAN = Reynolds law [-]   */
    double *lift;                                /* lift coefficient [-]                                  */
    double *damping;                             /* damping ratio [-]                                     */
    double *sail0, *sail1;     /* still-air crown frontal area times crown Cd per axis length [m] */
    double *leaf0, *leaf1;     /* one-sided leaf area per axis length [m]               */
    double *burden0, *burden1; /* added mass per axis length: leaves, twigs not drawn, water, snow [kg/m] */
    double *mass1;             /* n: point mass at the row's end, without rotary inertia [kg]; NULL = none */
    double *stiff; /* 4n: EA, GA [N], EI, GJ [N m2] of a row, constant along it, in place of those of E, G and
                    * the radii (GA as used: any shear factor is in it); NULL = from the section */
    struct wf_tree_sections *section; /* solid sections that are not round; NULL = round rows */
};

/* Columns of sections that are not round. The radii then stand for round sections of the same area. */
struct wf_tree_sections {
    double *width0, *width1, *height0, *height1; /* [m]                                         */
    double *mix0, *mix1;   /* 3n: shares of ellipse, rectangle and triangle in the shape, summing up to 1  */
    double *up;            /* 3n: unit vector across the row along which the height is measured, global    */
    double *side0, *side1; /* first moment of the burden about the axis, positive towards up x axis (left,
                            * seen from the base), per length [kg m/m] */
};

/* Columns for n segments from the arena, zeroed (parent -1, drag NAN). WF_ENOMEM when there is no room. */
enum wf_status wf_tree_alloc(struct wf_tree *t, size_t n, struct wf_arena *a, struct wf_err *e);

/* Refuse what no solver can take: a parent not before its child, two roots where `roots` is 1, a zero-length
 * segment, a radius that is not positive, an inner radius not below the outer, a value that is not finite.
 * Every bad row becomes a line in `d`, named by its id. */
enum wf_status wf_tree_check(const struct wf_tree *t, struct wf_diag *d, struct wf_err *e);

/* Columns of sections for the tree's n rows, zeroed. WF_ENOMEM when there is no room. */
enum wf_status wf_tree_alloc_sections(struct wf_tree *t, struct wf_arena *a, struct wf_err *e);

double wf_tree_height(const struct wf_tree *t);           /* highest point above the lowest base [m] */
double wf_tree_length(const struct wf_tree *t, size_t i); /* arc length of row i [m] */

/* A part of a tree: all of it, the stem (level 0), all but the stem. */
enum wf_scope { WF_SCOPE_TREE, WF_SCOPE_STEM, WF_SCOPE_BRANCHES, WF_SCOPES };
const char *wf_scope_name(enum wf_scope s); /* "tree", "stem", "branches" */
/* Does a row belong to a scope? The stem is level 0. */
bool wf_scope_holds(enum wf_scope s, const struct wf_tree *t, size_t row);
#endif
