/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_LEAF_BLADE_H
#define WF_GROW_LEAF_BLADE_H
/* Outlines of simple leaves and their meshes. A blade lies in the plane (along the main vein, across); its
 * halves may be folded up along the vein. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>
#include <stdint.h>

/* Half width over the vein: half the breadth times s^p (1 - s)^q over its largest value, s in 0..1 from the
 * petiole to the tip. The shapes are drawn by this program after the words of botany, not measured. */
struct wf_leaf_form {
    const char *name, *like; /* "ovate"; trees with such leaves */
    double p, q;
    double breadth; /* over length */
};
extern const struct wf_leaf_form wf_leaf_forms[]; /* ends at name == NULL */
const struct wf_leaf_form *wf_leaf_form_named(const char *name);

struct wf_blade {
    const struct wf_leaf_form *form;
    double length, half; /* of the main vein; largest half width [m] */
};
/* Half width at the distance x from the petiole [m]; 0 outside. */
double wf_blade_half(const struct wf_blade *b, double x);
/* Its slope d half/d x. */
double wf_blade_slope(const struct wf_blade *b, double x);
double wf_blade_area(const struct wf_blade *b); /* one-sided [m2] */

/* Mesh of a blade: points (x along, y across) and triangles. `along` rows of points, `across` points from the
 * vein to the edge. Errors: WF_EINPUT for a blade without area, WF_ENOMEM. */
struct wf_blade_mesh {
    size_t points, triangles;
    double *at;      /* 2 per point [m] */
    int32_t *corner; /* 3 per triangle  */
};
enum wf_status wf_blade_mesh_make(const struct wf_blade *b, size_t along, size_t across, struct wf_arena *a,
                                  struct wf_blade_mesh *out, struct wf_err *e);
#endif
