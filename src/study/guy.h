/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_GUY_H
#define WF_STUDY_GUY_H
/* Guys: cables from the stem to anchors in the ground, as springs that pull and never push. Their own
 * strength, and that of the anchors, is not assessed. */
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

struct wf_guy {
    double height;     /* on the stem, above its base [m] */
    double distance;   /* of the anchor from the base of the stem, at its height [m] */
    double towards;    /* where the anchor lies, clockwise from north [rad] */
    double azimuth;    /* the same from +x towards +y [rad] */
    double stiffness;  /* force over stretch, EA over the length [N m-1] */
    double pretension; /* in the shape drawn [N] */
};
/* Read "HEIGHT:DISTANCE:TOWARDS:STIFFNESS[:PRETENSION]", several apart by ',' or ';'. Given: where north is
 * in the model, see study/directions.h [rad]. Returned: *out[*n] in the arena. Errors: WF_EUSAGE, WF_ENOMEM.
 */
enum wf_status wf_guys_read(const char *text, double north, struct wf_arena *a, const struct wf_guy **out,
                            size_t *n, struct wf_err *e);

/* Put the scenario's guys among the loads, unstretched but for the pretension in the shape drawn. The stem's
 * rows are cut where guys hold it. Given: an analysis with its loads, whose tree is grown. Errors: WF_EINPUT
 * for a guy above the stem, or stretched by more than half its length; WF_ENOMEM. */
enum wf_status wf_guys_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
