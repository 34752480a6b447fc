/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_WINTER_H
#define WF_LOAD_WINTER_H
/* Snow and ice on a tree: loads that came after it was drawn. */
#include "base/err.h"
#include "data/tree.h"

/* Area of the crown seen from above: the circle whose width is that of the branches which carry sail, the
 * mean over all directions, and at least `width` [m] (0: not known). For a crown that is longer than broad
 * this is more than its area. Returned: [m2]; 0 for a tree without sail, and for a stem whose width is not
 * known. */
double wf_crown_projection(const struct wf_tree *t, double width);

/* Put a mass of snow on the crown as burden, spread as the sail is. Given: a tree with sail; mass [kg]. */
void wf_snow_onto(struct wf_tree *t, double mass);

/* Ice of a radial thickness b [m] on all axes and on both sides of the leaves. On an axis of diameter d the
 * mass per length is 917 pi b (d + b), and the wind finds the diameter d + 2b; where the drag follows the
 * Reynolds law, the coefficient of an iced axis is taken as 1.2, its value from Re 1e4 to 1e5. Returned: mass
 * of the ice [kg]. */
double wf_ice_onto(struct wf_tree *t, double thickness);
#endif
