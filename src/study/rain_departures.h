/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_RAIN_DEPARTURES_H
#define WF_STUDY_RAIN_DEPARTURES_H
/* What of a run of rain is not physics, each with its size in this run, and what is assumed. */
#include "study/rain_run.h"

/* Warnings: with the printed formulas impact-energy, free-fall, cap-density, drop-volume, cap-height,
 * attraction-unit, constant-forces, lever, restoring-springs, diagonal-mass, explicit-euler, dry-trace,
 * cell-distance, look-factors; always assumed-values and water-inertia. */
void wf_rain_departures(const struct wf_rain_result *r, struct wf_diag *d);
#endif
