/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SHELTER_LAWS_H
#define WF_WIND_SHELTER_LAWS_H
/* Between the files of the shelter. */
#include "wind/shelter.h"

/* Coordinates along, across, up. */
static inline void wf_shelter_turn(const struct wf_shelter *s, const double x[3], double out[3])
{
    for (int i = 0; i < 3; i++) out[i] = s->axis[i][0] * x[0] + s->axis[i][1] * x[1] + s->axis[i][2] * x[2];
}

/* Fill s->part by the momentum that drag takes out, in wakes that spread. */
enum wf_status wf_shelter_wake(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e);
/* Fill s->part by the potentials of the paper. */
enum wf_status wf_shelter_feng(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e);
#endif
