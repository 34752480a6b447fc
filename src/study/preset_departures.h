#ifndef WF_STUDY_PRESET_DEPARTURES_H
#define WF_STUDY_PRESET_DEPARTURES_H
/* Where each paper's printed formula or constant leaves physics, by how much on the tree in hand. */
#include "base/diag.h"
#include "study/analysis.h"

/* Zhao & Zhang 2013, below eq 2: C_D, C_L [-]; rho_a = 2.37e-3 g/m3 in kg/m3. */
#define WF_ZHAO_DRAG 0.013
#define WF_ZHAO_LIFT 0.75
#define WF_ZHAO_AIR 2.37e-6

void wf_departures_tang(const struct wf_analysis *an, struct wf_diag *d);
void wf_departures_feng(const struct wf_analysis *an, struct wf_diag *d);
void wf_departures_zhao(const struct wf_analysis *an, struct wf_diag *d);
/* Of their winds, memories and leaves, in series. */
void wf_departures_tang_in_time(struct wf_diag *d);
void wf_departures_zhao_in_time(struct wf_diag *d);
/* Of the printed shelter of Feng et al. */
void wf_departures_shelter(struct wf_diag *d);
#endif
