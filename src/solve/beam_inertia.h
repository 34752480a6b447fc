/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_INERTIA_H
#define WF_SOLVE_BEAM_INERTIA_H
/* A tree's response to the inertia of small motions about a solved state (wf_beam_linearise, wind frozen),
 * for natural frequencies: many answers of one state. What of the tangent's factors they need is packed by
 * groups of elements (solve/beam_groups.h), so that memory is read from end to end, half as much as the
 * factors take; a group is computed side by side. beam_inertia.c is compiled once for every width, and the
 * results have the same bytes at any width. */
#include "solve/beam_state.h"

enum { WF_INERTIA_MOST = 4 }; /* vectors that are answered at once */

/* A motion is, per element and for each of its two Gauss points, displacement (3) and twist about the axis;
 * then, where the tree has point masses, the displacement of each element's end. Vectors that are answered
 * together are interleaved: number q of vector v is at q * vectors + v. */
size_t wf_beam_motion_size(const struct wf_beam *b);
/* Mass of each entry of a motion [kg], of twist [kg m2]; rotary inertia in bending is omitted. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);

struct wf_beam_inertia {
    struct wf_beam *beam;
    const double *root; /* square root of the mass of each entry of a motion */
    size_t vectors, lanes, groups, roots;
    bool tied;                 /* cables to the ground hold ends: they resist displacement too */
    size_t numbers;            /* per element of `factor` */
    int32_t *id, *base, *some; /* per group and lane: element, and place in `ends` of what it stands on; per
                                  group: lanes that count */
    int32_t *grounded;         /* per root: its row */
    double *factor;            /* per group, number and lane */
    double *inner; /* per group, vector, number and lane: kept between the way down and the way up */
    double *ends;  /* per element, then per root, and vector: force and moment on the end, then its
                      displacement and spin; eight numbers, of which the last two are spare */
};

/* Given: a linearised beam and the square roots of its masses, both of which outlive *x; how many vectors are
 * answered at once. Returned: *x, in `a`. Errors: WF_ENOMEM. */
enum wf_status wf_beam_inertia_open(struct wf_beam *b, const double *root, size_t vectors, struct wf_arena *a,
                                    struct wf_beam_inertia *x, struct wf_err *e);
/* out = sqrt(mass) flexibility sqrt(mass) in, for motions `in` times sqrt(mass); out may be `in`. */
void wf_beam_inertia_answer(const struct wf_beam_inertia *x, const double *in, double *out);
/* Displacement and spin of an element's end in the last answer. */
static inline const double *wf_beam_inertia_end(const struct wf_beam_inertia *x, size_t element,
                                                size_t vector)
{
    return x->ends + 8 * (element * x->vectors + vector);
}

struct wf_inertia_kernel {
    size_t width;
    void (*down)(const struct wf_beam_inertia *x, const double *in);
    void (*up)(const struct wf_beam_inertia *x, double *out); /* NULL: only the ends are wanted */
};
extern const struct wf_inertia_kernel wf_inertia_1, wf_inertia_4, wf_inertia_8;
#endif
