#ifndef WF_SOLVE_BEAM_VIBRATE_H
#define WF_SOLVE_BEAM_VIBRATE_H
/* Small motions about a solved state: the mass at the Gauss points, and the tree's answer to inertia there.
 */
#include "solve/beam_newton.h"

/* A motion: per element, at each of its two Gauss points, displacement (3) and twist about the axis; then,
 * where the tree has point masses, the displacement of each element's end. */
size_t wf_beam_motion_size(const struct wf_beam *b);

/* Prepare: linearise about the present state with wind as a dead load. WF_ENOMEM, WF_EUNSTABLE (singular
 * tangent). */
enum wf_status wf_beam_small_prepare(struct wf_beam *b, struct wf_arena *a, struct wf_err *e);

/* out = flexibility x mass x in: the motion under the inertia of `in`. ends (6 per element, may be NULL):
 * changes of the element ends (place, spin). */
void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*ends)[6]);

/* Mass that goes with each entry of a motion [kg], twist: [kg m2]; rotary inertia in bending is left out. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);
#endif
