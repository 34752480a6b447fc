/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_PRISM_H
#define WF_SOLVE_PRISM_H
/* Axes as chains of triangular prisms held by springs (extended three-prism spring model): Yang M., Wu E.
 * 2011. J. Software 22(8):1934-1947, section 3. Each node of an axis becomes a section of three vertices at
 * the distance `arm`; M x'' + D x' + K x = F over all vertices. The constants of the springs follow from EI,
 * GJ and the length of the segments, so that small bending and twist are those of Euler-Bernoulli and
 * Saint-Venant (docs/rain.md derives them). Steps in time are in solve/prism_step.h. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The four kinds of springs; each owns its constants. */
enum wf_prism_row {
    WF_PRISM_STRUCTURAL,
    WF_PRISM_SHEAR,
    WF_PRISM_BENDING,
    WF_PRISM_RESTORING,
    WF_PRISM_ROWS
};
struct wf_prism_kind {
    const char *name, *joins; /* "shear"; which vertices it joins */
};
extern const struct wf_prism_kind wf_prism_kinds[WF_PRISM_ROWS];

enum { WF_PRISM_SECTIONS_MAX = 4096 };

struct wf_prism_spring {
    int32_t a, b;   /* vertices; b < 0: to the rest place of a */
    double k, rest; /* [N/m], [m] */
    int32_t row;    /* enum wf_prism_row */
};

/* An axis to be made into prisms. */
struct wf_prism_axis {
    size_t segments;
    const double *place;        /* 3(segments + 1): nodes, root first [m]                              */
    double normal[3];           /* across the axis at its root: towards vertex 0                       */
    const double *bending;      /* per segment: EI [N m2]                                              */
    const double *torsion;      /* per segment: GJ [N m2]                                              */
    const double *mass;         /* per node [kg]                                                       */
    const double *polar;        /* per node: polar moment of inertia of its round part [kg m2]         */
    const double *plate, *half; /* per node: mass of a flat plate across `normal` [kg], its half width
                                 * [m]; NULL: none                                                */
    double fold;                /* slope of the plate's halves towards the normal [-]                   */
    double restoring;           /* [N/m] of each vertex to its rest place; 0: none                      */
    int32_t on;                 /* section of an earlier axis that carries the root; -1: clamped        */
    bool diagonal;              /* as printed: a third of the mass on each vertex, inertia is not matched */
};

/* A vertex whose place is an affine combination of four others: the root of an axis on another. */
struct wf_prism_bond {
    int32_t on[4];
    double share[4];
};

struct wf_prism {
    size_t sections, springs; /* vertex j of section s is 3 s + j */
    size_t axes;
    int32_t *first, *count;     /* per axis: its first section, its number of sections          */
    double *arm;                /* per axis [m]                                                  */
    double *rest;               /* 9 sections: rest places [m]                                   */
    double *mass;               /* 9 sections: mass matrix of a section's vertices, row-major [kg] */
    double *inverse;            /* 9 sections: its inverse                                       */
    int32_t *free;              /* per section: its number among the unknown ones; -1: clamped or bonded */
    size_t unknown;             /* sections that move by themselves                             */
    int32_t *order;             /* unknown: section of each, in the order of elimination         */
    struct wf_prism_bond *bond; /* 3 per section; used where bonded[s]                         */
    bool *bonded;
    struct wf_prism_spring *spring;
    double error; /* bound on the share of bending that the section's own give takes [-] */
};

/* Make prisms of n axes, carriers first. Returned: *out in the arena, at rest. Errors: WF_EINPUT for an axis
 * without length or with a stiffness or mass that is not positive, more than WF_PRISM_SECTIONS_MAX sections,
 * or an axis on a section that does not exist; WF_ENOMEM. */
enum wf_status wf_prism_make(const struct wf_prism_axis *axis, size_t n, struct wf_arena *a,
                             struct wf_prism *out, struct wf_err *e);

/* Shares of the three vertices of a section in the place of a point at `across` (to the left of the normal,
 * seen along the axis from the root) and `along_normal` from the axis [m]. */
void wf_prism_shares(double arm, double across, double along_normal, double share[3]);

/* Set the bonded vertices of x from the others; clamped ones are left as they are. x: 9 sections [m]. */
void wf_prism_follow(const struct wf_prism *p, double *x);
/* Forces of the springs on all vertices, added to f [N]; those on bonded vertices are passed on to their
 * carriers. x: places. Returned: potential energy of the springs [J]; by row in `of_row` unless NULL. */
double wf_prism_forces(const struct wf_prism *p, const double *x, double *f, double of_row[WF_PRISM_ROWS]);
/* Pass forces on bonded vertices to their carriers, which lie in earlier axes; the bonded ones become 0. */
void wf_prism_pass(const struct wf_prism *p, double *f);
/* Weight of the sections, added to f [N]. */
void wf_prism_weight(const struct wf_prism *p, double gravity, double *f);

/* Centre of a section, its normal, axis direction and left, orthonormal. */
void wf_prism_frame(const struct wf_prism *p, const double *x, size_t section, double centre[3],
                    double along[3], double left[3], double normal[3]);
#endif
