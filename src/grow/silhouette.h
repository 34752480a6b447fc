/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_SILHOUETTE_H
#define WF_GROW_SILHOUETTE_H
/* The crown as it is measured from the side (struct wf_silhouette of a model) on the columns of a tree: its
 * frontal area as sail, its mass as burden. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/tree.h"

struct wf_species;

/* A closed polygon seen from the side: x to the side, z above the ground [m]. */
struct wf_outline {
    size_t n;
    double *x, *z;
};
enum { WF_OUTLINE_POINTS = 2000 }; /* most */

/* Area [m2] of an outline between two heights [m], and its first moment about the ground [m3]. */
double wf_outline_strip(const struct wf_outline *o, double from, double to, double *moment);
/* Read an outline from a table with the columns x_m and z_m, one point a row in order around the crown.
 * Returned: points of *s. Errors: WF_EINPUT with mistakes of the file in `d`; those of wf_silhouette_check.
 */
enum wf_status wf_outline_read(const char *path, struct wf_silhouette *s, struct wf_arena *a,
                               struct wf_diag *d, struct wf_err *e);

/* Errors: WF_EINPUT for fewer than 3 points or more than WF_OUTLINE_POINTS, an outline that crosses or
 * touches itself, lies below the ground or has no area, with the points' numbers; for numbers that do not
 * belong together. */
enum wf_status wf_silhouette_check(const struct wf_silhouette *s, struct wf_err *e);
/* Frontal area with leaves [m2]; NAN when it is not given. */
double wf_silhouette_area(const struct wf_silhouette *s);
/* The crown's outline in numbers; NAN: not known. */
struct wf_outline_size {
    double area;    /* [m2] */
    double centre;  /* of the area, above the ground [m] */
    double breadth; /* largest, to the side [m] */
    double height;  /* from its lowest to its highest point [m] */
};
/* Given: a model and the height of its tree [m]. Of an area alone nothing else is known. */
struct wf_outline_size wf_silhouette_size(const struct wf_model *m, double height);
/* Lowest and highest point above the ground, of a tree of this height [m]. Returned: false when it does not say. */
bool wf_silhouette_ends(const struct wf_silhouette *s, double height, double *base, double *top);

/* Put the model's silhouette on its tree, grown and clothed. The sail adds up to frontal area times the
 * crown's drag coefficient (without leaves: times the leaf-off share). It is placed by the outline's breadth
 * over the height, so that its centre is at the outline's: on the stem of a tree without branches; else on
 * the parts with leaves, or on the shoots above which there is a single tip. An area alone keeps the
 * distribution of the leaves. Crown mass takes the place of the mass of the leaves. Warnings in `d`:
 * crown-areas, crown-mass, crown-mass-by, crown-centre, leaf-off-share. Errors: WF_EINPUT, WF_ENOMEM. */
enum wf_status wf_silhouette_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                  struct wf_diag *d, struct wf_err *e);
#endif
