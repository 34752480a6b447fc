/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_SECTION_H
#define WF_DATA_SECTION_H
/* Cross-sections: rings, solid sections that are not round (petioles, rachides, flattened branches), stems
 * with cavities. */
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

/* Outer radius of the wood of row i at share s of its length, within the bark [m]. */
static inline double wf_wood_radius(const struct wf_tree *t, size_t i, double s)
{
    double outer = wf_between(t->r0[i], t->r1[i], s);
    return t->bark0 ? outer - wf_between(t->bark0[i], t->bark1[i], s) : outer;
}

/* The same at its base (0) or its end (1), exactly. */
static inline double wf_wood_end(const struct wf_tree *t, size_t i, int end)
{
    double outer = end ? t->r1[i] : t->r0[i];
    return t->bark0 ? outer - (end ? t->bark1[i] : t->bark0[i]) : outer;
}

/* Is the section of row i a ring, or a circle? */
static inline bool wf_section_is_ring(const struct wf_tree *t, size_t i)
{
    const struct wf_tree_sections *c = t->section;
    return !c || (c->width0[i] == 0 && c->width1[i] == 0 && !(c->hollow && c->hollow[i]));
}

/* The sound wall of a hollow row, without bark. */
struct wf_wall {
    double thickness; /* thinnest [m]; of a solid row its radius       */
    double radius;    /* outer, of the wood [m]                        */
    bool open; /* it has an opening: criteria of closed rings do not hold; the thickness is that beside it */
};
/* Given: row i, share s of its length. Returned: its wall; a row with a width and a height is solid. */
struct wf_wall wf_section_wall(const struct wf_tree *t, size_t i, double s);

/* Directions across a row from which the angles of its cavity count: `first` is that of +x, or of +y on a row
 * along x, projected across the row; `second` is a quarter turn on, anticlockwise seen from its end. */
void wf_section_axes(const double axis[3], double first[3], double second[3]);

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

/* Section of row i at share s of its length (0 base, 1 end); of a row with a cavity `upright` and `lying` are
 * about its principal axes, the height's direction is `up`. Width and height vary linearly; where the shape
 * changes along the row, the properties of the shapes are averaged with linear weights. t->section must not
 * be NULL. */
void wf_section_at(const struct wf_tree *t, size_t i, double s, struct wf_section *out);

/* Cross-sectional area of row i at share s of its length that has mass, for rows of any section [m2]. Bark
 * and what a cavity holds count as wood: decayed and wet wood may be there, and weight is on the safe side.
 */
double wf_tree_area(const struct wf_tree *t, size_t i, double s);
#endif
