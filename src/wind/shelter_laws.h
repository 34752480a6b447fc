/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_SHELTER_LAWS_H
#define WF_WIND_SHELTER_LAWS_H
/* Laws of shelter, as rows: what the cells of a slab leave of the wind behind it. */
#include "wind/shelter.h"

extern const struct wf_shelter_law wf_shelter_laws[]; /* wake, feng1999; ends at name == NULL */
const struct wf_shelter_law *wf_shelter_law_named(const char *name);
/* Law wake, 32 slabs, 128 cells, 20 % of the energy, Cd 1, crown Cd 1, full sail, 0.25 m, 0.05, 0.95, 1 cell,
 * growth 0.08. */
void wf_shelter_request_default(struct wf_shelter_request *q);
#endif
