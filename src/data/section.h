/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_SECTION_H
#define WF_DATA_SECTION_H
/* Cross-sections: rings, and solid sections that are not round (petioles, rachides, flattened branches). */
#include "base/num.h"
#include "data/tree.h"
#include <math.h>

/* Area of a ring [m2]. Given: radii [m]; inner 0: a solid circle. */
static inline double wf_ring_area(double outer, double inner)
{
    return WF_PI * (outer * outer - inner * inner);
}

/* Second moment of area of a ring about a diameter [m4]; the polar moment is twice as large. Given: radii
 * [m]. */
static inline double wf_ring_inertia(double outer, double inner)
{
    return 0.25 * WF_PI * (outer * outer * outer * outer - inner * inner * inner * inner);
}

enum wf_section_shape { WF_SECTION_ELLIPSE, WF_SECTION_RECTANGLE, WF_SECTION_TRIANGLE, WF_SECTION_SHAPES };
extern const char *const wf_section_words[]; /* words of the shapes, in their order; ends at NULL */

struct wf_section {
    double area;    /* [m2]                                                                        */
    double upright; /* second moment for bending in the plane of the height [m4]                   */
    double lying;   /* second moment for bending in the plane of the width [m4]                    */
    double torsion; /* Saint-Venant's torsion constant [m4]                                        */
};

/* Properties of a section about its centroid. Given: shape, width and height [m]; a triangle is isosceles,
 * with the width as its base, either way up. Torsion: ellipse, exact (Roark 7th ed., table 10.1); rectangle,
 * series summed to rounding (Timoshenko & Goodier 1970, art. 109); triangle, w^3 h^3 / (15 w^2 + 20 h^2)
 * (Roark, same table), exact for equal sides, within 4 % for an angle of 39 to 82 degrees opposite the base,
 * and always too small, because it is the first approximation of Ritz' method. */
void wf_section_of(enum wf_section_shape shape, double width, double height, struct wf_section *out);

/* Section of row i at share s of its length (0 base, 1 end). Width and height vary linearly; where the shape
 * changes along the row, the properties of the shapes are averaged with linear weights. t->section must not
 * be NULL. */
void wf_section_at(const struct wf_tree *t, size_t i, double s, struct wf_section *out);

/* Cross-sectional area of the wood of row i at share s of its length, for rows of any section [m2]. */
double wf_tree_area(const struct wf_tree *t, size_t i, double s);
#endif
