#ifndef WF_SOLVE_BEAM_VIBRATE_H
#define WF_SOLVE_BEAM_VIBRATE_H
/* Small motions about a solved state (wf_beam_linearise, wind frozen): the mass at the Gauss points, and the
 * tree's answer to inertia there. */
#include "solve/beam_newton.h"

/* A motion: per element, at each of its two Gauss points, displacement (3) and twist about the axis; then,
 * where the tree has point masses, the displacement of each element's end. */
size_t wf_beam_motion_size(const struct wf_beam *b);

/* out = flexibility x mass x in: the motion under the inertia of `in`. node: room for 6 per element; ends (6
 * per element): changes of the element ends (place, spin). */
void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*node)[6],
                            double (*ends)[6]);

/* Mass that goes with each entry of a motion [kg], twist: [kg m2]; rotary inertia in bending is left out. */
void wf_beam_motion_mass(const struct wf_beam *b, double *mass);
#endif
