#ifndef WF_SOLVE_ROD_STEP_H
#define WF_SOLVE_ROD_STEP_H
/* The steps by which one piece is integrated.
 *
 * They are chosen by GSL's error control and end where the wind is not smooth: in the middle of a step a jump
 * of a derivative costs an eighth-order formula its order, and the control many rejected steps. The steps
 * taken are kept with the piece. Taken again, they make the end of a piece a smooth function of its base,
 * which steps chosen anew each time do not: their choice scatters the end by the error allowed, and Newton
 * cannot end below the scatter (Bock 1981, internal numerical differentiation, in: Modelling of Chemical
 * Reaction Systems, Springer, 102-125). */
#include "solve/rod_integrate.h"

/* From base to end. Given: the state y at the base; g->piece is the piece under way. Returned: y at the end;
 * false when a step could not be taken. */
bool wf_rod_drive(struct wf_rod_integrator *g, double *y);
#endif
