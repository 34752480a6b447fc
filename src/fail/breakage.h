#ifndef WF_FAIL_BREAKAGE_H
#define WF_FAIL_BREAKAGE_H
/* Stem breakage: outer-fibre stress against the modulus of rupture, at both ends of every row and, where the
 * stress is largest in between (a slender top does not break at its base), there too. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "solve/solve.h"

struct wf_breakage {
    size_t n;
    double *shear0, *shear1;     /* force across the axis [N]                                    */
    double *axial0, *axial1;     /* along the axis, tension positive [N]                          */
    double *bending0, *bending1; /* bending moment (across the axis) [N m]                         */
    double *torsion0, *torsion1; /* moment about the axis [N m]                                   */
    double *stress0, *stress1;   /* |M| r / I + |N| / A, thin or thick ring [Pa]                   */
    double *safety0, *safety1;   /* strength / stress [-]; INFINITY unstressed, NAN strength unknown */
    double least_safety;         /* smallest safety factor [-]; NAN when no row has a strength    */
    int32_t governing;           /* its row; -1 when none                                         */
    double governing_s;          /* 0 = at the row's base, 1 = at its end                         */
    double stem_safety;          /* the same for the rows of level 0 alone: the stem               */
    int32_t stem_governing;
    double stem_governing_s;
    double largest_stress; /* [Pa]                                                          */
    int32_t largest_stress_row;
};
/* Given: tree and its answer. Returned: *out with arrays of n in the arena; least_safety, largest_stress and
 * their places take the inside of each row into account. A row's safety0/1 are those of its two ends. Method:
 * inside a row the moment is the cubic that fits moments and forces at both ends (dM/ds = -t x F), the force
 * is linear, the radii are linear; where the stress rises from both ends inwards its maximum is searched.
 * Source: elementary bending, Timoshenko 1955, Strength of Materials I. Valid for sound, round stems; shear
 * stress and torsion are reported but do not enter the stress. Errors: WF_ENOMEM, WF_EINTERNAL (answer of
 * another tree). */
enum wf_status wf_breakage_check(const struct wf_tree *t, const struct wf_response *r, struct wf_arena *a,
                                 struct wf_breakage *out, struct wf_err *e);
#endif
