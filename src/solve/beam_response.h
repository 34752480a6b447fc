#ifndef WF_SOLVE_BEAM_RESPONSE_H
#define WF_SOLVE_BEAM_RESPONSE_H
/* Reading a solved beam row by row. */
#include "base/arena.h"
#include "solve/beam_newton.h"

/* Fill the response's columns from a solved beam. The response is allocated for the tree's rows. */
void wf_beam_read(const struct wf_beam *b, struct wf_response *r);

/* Rotation at row fraction s of a row (0..1), from the unloaded to the loaded state. */
void wf_beam_rotation_at(const struct wf_beam *b, size_t row, double s, double L[9]);

/* Start `fine` (same tree, another mesh) from the shape of `coarse`. */
void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine);
#endif
