/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_WETTED_H
#define WF_STUDY_WETTED_H
/* A tree with rain on its leaves, or with snow and ice, beside the same tree without. */
#include "study/analysis.h"

enum { WF_DRY, WF_WET };
enum wf_burden { WF_BURDEN_RAIN, WF_BURDEN_WINTER };
struct wf_wetted {
    double film, mass, leaf_area;             /* [kg m-2], of what came onto the tree [kg], one-sided [m2] */
    double frequency[2];                      /* lowest, in still air [Hz]; NAN: not found                */
    double speed;                             /* highest of the given winds that has a result [m/s]       */
    double drag[2], moment[2], deflection[2]; /* of the whole tree [N], at the base [N m] and of the tip [m]
                                                 at that speed; NAN: no equilibrium */
    struct wf_critical critical[2];           /* of the loss of the tree                                  */
};
/* Compare an analysis whose scenario has water, or snow or ice, with the same tree without it. Errors:
 * WF_EINPUT for rain on a tree without leaves; those of wf_analysis_set_up and wf_analysis_breaks;
 * WF_EINTERRUPTED. */
enum wf_status wf_wetted_compare(const struct wf_analysis *wet, enum wf_burden burden,
                                 const struct wf_solve_options *o, struct wf_arena *a, struct wf_wetted *out,
                                 struct wf_err *e);
#endif
