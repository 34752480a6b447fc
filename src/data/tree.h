/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_TREE_H
#define WF_DATA_TREE_H
/* A tree as a table: columns of quantities, one row for each segment; every parent comes before its children.
 * SI units, z up, ground at z = 0. A quantity with columns 0 and 1 varies linearly from the segment's base
 * (0) to its end (1). */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_tree {
    const char *name;
    size_t n;             /* segments                                              */
    int32_t *parent;      /* row of the segment below; -1 = clamped to the ground  */
    int32_t *level;       /* branching level, 0 = stem                             */
    int64_t *id;          /* the user's id of the row, for messages                */
    double *x0, *y0, *z0; /* base [m]                                              */
    double *x1, *y1, *z1; /* end [m]                                               */
    double *bend;         /* 3n: initial curvature vector of the axis, global [1/m]; NULL = straight rows */
    double *r0, *r1;      /* outer radius, over bark [m]                           */
    double *i0, *i1;      /* inner radius [m]; 0 = solid                           */
    double *youngs, *shear, *density, *strength; /* E, G [Pa], [kg m-3], MOR*knot factor [Pa] (0: unknown) */
    double *compressive, *shearing;              /* strengths along the grain, green [Pa] (0: unknown) */
    double *tangential;                          /* strength in tension along the rings [Pa] (0: unknown) */
    double *transverse;        /* E_T / (1 - nu_LT nu_TL), stiffness along the rings [Pa] (0: unknown) */
    double *drag;              /* cross-flow drag coefficient; NAN = Reynolds law [-]   */
    double *lift;              /* lift coefficient [-]                                  */
    double *damping;           /* damping ratio [-]                                     */
    double *sail0, *sail1;     /* still-air crown frontal area times crown Cd per axis length [m] */
    double *leaf0, *leaf1;     /* one-sided leaf area per axis length [m]               */
    double *burden0, *burden1; /* added mass per axis length: leaves, twigs not drawn, water, snow [kg/m] */
    double *mass1;             /* n: point mass at the row's end, without rotary inertia [kg]; NULL = none */
    double *stiff; /* 4n: EA, GA [N], EI, GJ [N m2] of a row, constant along it, instead of those computed
                    * from E, G and the radii (GA includes any shear factor); NULL = from the section */
    double *bark0, *bark1; /* thickness of the bark [m]: mass and surface, without stiffness or strength;
                            * NULL = the radii are of wood */
    struct wf_tree_sections *section;  /* sections that are not rings; NULL = all rows are rings */
    struct wf_tree_standing *standing; /* the tree stands in this shape under its own weight; NULL = the shape
                                        * is free of stress */
    double anchorage;      /* largest moment on the ground that the root carries [N m]; NAN: not known */
    double node_spacing;   /* between the diaphragms of a hollow stem that are counted [m]; 0: none are */
    struct wf_room {       /* how far the tree may move */
        double corridor;   /* distance of a corridor from the base of the stem [m]; 0: none */
        double towards[2]; /* unit vector of the horizontal direction that it lies in */
        double tip_angle;  /* limit of the turn of the stem's tip [rad]; 0: none */
    } room;
    bool *doubtful; /* n: rows that no scope holds, because their own weight would nearly break them
                     * (study/rest.h); NULL = none */
};

/* What a tree that stands in its shape carried when the shape was drawn or measured, beside its wood and the
 * masses at its rows' ends. What is added to the burden later bends it. */
struct wf_tree_standing {
    double *burden0, *burden1; /* as struct wf_tree */
    double *side0, *side1;     /* as struct wf_tree_sections; NULL = round rows */
};

struct wf_hollow; /* data/hollow.h */
/* Columns of sections that are not rings. A row has a width and a height, and its radius columns those of a
 * circle of the same area; or it has a cavity; or neither, and is a ring by its radii. */
struct wf_tree_sections {
    double *width0, *width1, *height0, *height1; /* [m]                                         */
    double *mix0, *mix1; /* 3n: shares of ellipse, rectangle and triangle in the shape; their sum is 1   */
    double *up;          /* 3n: unit vector across the row along which the height is measured, global    */
    const struct wf_hollow **hollow; /* n: its section where it has a cavity, else NULL; NULL = no cavities */
    int32_t *cavity;                 /* n: which of the model's cavities, -1 none; NULL = no cavities */
    double *side0, *side1; /* first moment of the burden about the axis, positive towards up x axis (left,
                            * seen from the base), per length [kg m/m] */
};

/* Allocate columns for n segments in the arena: zeroed, except parent -1, drag NAN and id 1..n. Errors:
 * WF_ENOMEM. */
enum wf_status wf_tree_alloc(struct wf_tree *t, size_t n, struct wf_arena *a, struct wf_err *e);

/* Check a tree for what no solver can handle: no segments, a parent that does not come before its child, a
 * segment without length, a radius that is not positive, an inner radius not below the outer, a value that is
 * not finite or has the wrong sign. Errors: WF_EINPUT; `d` has an error for each wrong row, with its id. */
enum wf_status wf_tree_check(const struct wf_tree *t, struct wf_diag *d, struct wf_err *e);

/* From now on the tree stands in its shape, under its wood and the burden that `worn` has, a tree of the same
 * rows, which may be itself. Errors: WF_ENOMEM. */
enum wf_status wf_tree_stand(struct wf_tree *t, const struct wf_tree *worn, struct wf_arena *a,
                             struct wf_err *e);

/* Copy row i between shares s0 and s1 of its length to row `at` of another tree, which has the same columns;
 * the parent is the caller's. Of a row that is cut, a mass at its end and a curvature are not copied. */
void wf_tree_copy_part(const struct wf_tree *from, size_t i, double s0, double s1, struct wf_tree *to,
                       size_t at);

/* The row on the ground that carries row i. */
size_t wf_tree_base(const struct wf_tree *t, size_t i);
/* The thickest row of the stem at a height above its base, and the place in it (0 = base, 1 = end). Returned:
 * t->n: none. */
size_t wf_tree_stem_at(const struct wf_tree *t, double height, double *place);
/* Cut a row in two at a share of its length, unless that is within 1 mm of its end; `row` is then the lower
 * part, and the rows behind it move by one. Errors: WF_ENOMEM. */
enum wf_status wf_tree_cut(struct wf_tree *t, size_t row, double place, struct wf_arena *a, struct wf_err *e);

/* The same with those columns of bark, sections, cavities and masses that another tree has; its name,
 * anchorage and room. */
enum wf_status wf_tree_alloc_like(const struct wf_tree *like, size_t n, struct wf_arena *a,
                                  struct wf_tree *out, struct wf_err *e);

/* Allocate columns of sections for the tree's n rows, zeroed. Errors: WF_ENOMEM. */
enum wf_status wf_tree_alloc_sections(struct wf_tree *t, struct wf_arena *a, struct wf_err *e);
/* The same for the columns of bark, and for those of cavities. */
enum wf_status wf_tree_alloc_bark(struct wf_tree *t, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_tree_alloc_hollow(struct wf_tree *t, struct wf_arena *a, struct wf_err *e);

/* Lengthen all axes about the origin and thicken them by factors; leaves, sail and burden stay the same in
 * total. */
void wf_tree_scale(struct wf_tree *t, double length, double radius);

double wf_tree_height(const struct wf_tree *t);           /* highest point above the lowest base [m] */
double wf_tree_length(const struct wf_tree *t, size_t i); /* arc length of row i [m] */
/* Diameter of row i at a place between its base (0) and its end (1); at its thicker end where that is NAN
 * [m]. */
double wf_tree_thickness(const struct wf_tree *t, size_t i, double place);

/* A quantity along an axis: value v[i] at relative position s[i] in 0..1, linear between. */
struct wf_along {
    size_t n;
    double *s, *v;
};
/* Value of an along-table at relative position s (clamped to its ends); `fallback` when empty. */
double wf_along_at(const struct wf_along *a, double s, double fallback);

#define WF_BREAST_HEIGHT 1.3 /* along the stem from the ground, where it is measured [m] */
/* Where that is: the row of the stem, the place in it (0 = base, 1 = end), the diameter over bark there [m],
 * NAN: the stem ends below; whether the stem forks below. The rule is that of forest inventories (Forest
 * Measurements, openoregon.pressbooks.pub/forestmeasurements, 3.5): along the stem, across its axis. They
 * measure each limb of a stem that forks below as a tree of its own; here its thickest limb is followed. */
struct wf_breast {
    int32_t row; /* -1: none */
    double place, diameter;
    bool forked;
};
struct wf_breast wf_tree_breast(const struct wf_tree *t);

/* The row that ends highest on level 0. */
size_t wf_tip_row(const struct wf_tree *t);
/* The row that ends highest of all axes: the crown's top. The stem's where none ends above it. */
size_t wf_top_row(const struct wf_tree *t);
/* Are branches drawn? */
bool wf_tree_branched(const struct wf_tree *t);

/* A part of a tree: the whole tree, the stem (level 0), everything but the stem. */
enum wf_scope { WF_SCOPE_TREE, WF_SCOPE_STEM, WF_SCOPE_BRANCHES, WF_SCOPES };
const char *wf_scope_name(enum wf_scope s); /* "tree", "stem", "branches" */
/* Whether a row belongs to a part of the tree. */
bool wf_scope_holds(enum wf_scope s, const struct wf_tree *t, size_t row);

#ifdef __cplusplus
}
#endif
#endif
