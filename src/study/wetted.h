/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_WETTED_H
#define WF_STUDY_WETTED_H
/* A tree with rain on its leaves beside the same tree dry. */
#include "study/analysis.h"

enum { WF_DRY, WF_WET };
struct wf_wetted {
    double film, mass, leaf_area; /* [kg m-2], [kg], one-sided [m2]                          */
    double frequency[2];          /* lowest, in still air [Hz]; NAN: not found                */
    double speed;                 /* highest of the given winds that has a result [m/s]       */
    double moment[2],
        deflection[2]; /* at the base [N m] and of the tip [m] at that speed; NAN: no equilibrium */
    struct wf_critical critical[2]; /* of breakage of the whole tree                            */
};
/* Compare an analysis whose scenario has water with the same tree dry. Errors: WF_EINPUT for a tree without
 * leaves; those of wf_analysis_set_up and wf_analysis_breaks; WF_EINTERRUPTED. */
enum wf_status wf_wetted_compare(const struct wf_analysis *wet, const struct wf_solve_options *o,
                                 struct wf_arena *a, struct wf_wetted *out, struct wf_err *e);
#endif
