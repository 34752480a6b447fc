/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_BREAKAGE_H
#define WF_FAIL_BREAKAGE_H
/* Stem breakage: outer-fibre stress against the modulus of rupture, at both ends of every row and, where the
 * stress is largest in between (a slender top does not break at its base), there too. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "solve/solve.h"
#include <stdbool.h>

/* The place nearest to failure. Utilisation is 1 / safety. */
struct wf_worst {
    double safety; /* resistance over load [-]; INFINITY unloaded, NAN when no resistance is known */
    int32_t row;   /* -1 when none                                                                */
    double place;  /* 0 = at the row's base, 1 = at its end                                       */
};

struct wf_breakage {
    size_t n;
    double *shear0, *shear1;     /* force across the axis [N]                                    */
    double *axial0, *axial1;     /* along the axis, tension positive [N]                          */
    double *bending0, *bending1; /* bending moment (across the axis) [N m]                         */
    double *torsion0, *torsion1; /* moment about the axis [N m]                                   */
    double *stress0, *stress1;   /* |M| r / I + |N| / A, thin or thick ring [Pa]                   */
    double *safety0, *safety1;   /* strength / stress [-]; INFINITY unstressed, NAN strength unknown */
    double *peak, *peak_place;   /* largest stress in the row [Pa]; 0 = at its base, 1 = at its end  */
    double largest_stress;       /* [Pa]                                                            */
    int32_t largest_stress_row;
};
/* Given: tree and its answer. Returned: *out with arrays of n in the arena; the peaks and the largest
 * stress take the inside of each row into account. A row's safety0/1 are those of its two ends. Method:
 * inside a row the moment is the cubic that fits moments and forces at both ends (dM/ds = -t x F), the force
 * is linear, the radii are linear; where the stress rises from both ends inwards its maximum is searched.
 * Source: elementary bending, Timoshenko 1955, Strength of Materials I. Valid for sound, round stems; shear
 * stress and torsion are reported but do not enter the stress. Errors: WF_ENOMEM, WF_EINTERNAL (answer of
 * another tree). */
enum wf_status wf_breakage_check(const struct wf_tree *t, const struct wf_response *r, struct wf_arena *a,
                                 struct wf_breakage *out, struct wf_err *e);

/* The row of wf_criteria: largest stress in a row against its modulus of rupture. */
bool wf_breakage_known(const struct wf_tree *t, size_t row);
void wf_breakage_utilisation(const struct wf_tree *t, const struct wf_response *r,
                             const struct wf_breakage *b, enum wf_scope scope, struct wf_worst *out);
#endif
