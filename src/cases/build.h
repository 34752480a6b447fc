/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_BUILD_H
#define WF_CASES_BUILD_H
/* From the words of a validation case to rows. Inside wf_setup_build. */
#include "cases/measure.h"

double wf_case_length(const struct wf_case *c); /* along the axis of a cantilever or arc [m] */

/* Outer and inner radius at base and tip [m]. Where EI is given and no radius, length/1000 at the base: a
 * slender rod whose bending stiffness is EI, so that only EI matters. */
void wf_case_radius(const struct wf_case *c, double outer[2], double inner[2]);

/* Parents, coordinates, radii and ids of the case's structure; s->end for a single axis. WF_EINPUT,
 * WF_ENOMEM; WF_EMISSING when a tree file is not there. */
enum wf_status wf_case_shape_build(const struct wf_case *c, struct wf_arena *a, struct wf_setup *s,
                                   struct wf_tree *t, struct wf_err *e);
#endif
