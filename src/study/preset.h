/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_PRESET_H
#define WF_STUDY_PRESET_H
/* Presets: published methods by name, with formulas and constants as printed. `corrected` changes nothing. */
#include "base/err.h"
#include "study/analysis.h"

struct wf_preset {
    const char *name, *title, *source;
    const char *solver; /* row of wf_solvers; NULL: the user's            */
    const char *gust;   /* row of wf_gust_models, for time series         */
    const char *leaves; /* row of wf_leaf_motions, for time series; NULL: the first */
    double drag, lift;  /* coefficients of wood and crown; NAN: the species' [-] */
    double air_density; /* [kg m-3]; NAN: the scenario's                  */
    bool solid;         /* solid sections, no cavity                      */
    bool rigid;         /* crowns that do not streamline                  */
    /* One warning for each departure from physics, with its reason and its size in this analysis. */
    void (*departures)(const struct wf_analysis *an, struct wf_diag *d);
    void (*in_time)(struct wf_diag *d); /* those of its wind, recursion over frames and leaves; NULL: none */
};
extern const struct wf_preset wf_presets[]; /* corrected first; ends at name == NULL */
const struct wf_preset *wf_preset_named(const char *name);

/* Write the preset's constants. Given and returned: a species and a scenario of the caller's own, and the
 * chosen solver. The species' preset becomes the preset's name; changed values get the status as printed. */
enum wf_status wf_preset_apply(const struct wf_preset *p, struct wf_arena *a, struct wf_species *sp,
                               struct wf_scenario *sc, const struct wf_solver **solver, struct wf_err *e);
/* The departures as findings: codes r-cubed, air-density, aerofoil-coefficients, modulus-outlier, ... */
void wf_preset_warn(const struct wf_preset *p, const struct wf_analysis *an, struct wf_diag *d);

/* Departures of the printed shelter law of Feng et al. from physics. */
void wf_departures_shelter(struct wf_diag *d);
#endif
