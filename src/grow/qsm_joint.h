#ifndef WF_GROW_QSM_JOINT_H
#define WF_GROW_QSM_JOINT_H
/* Where each row of a table of cylinders is held by its parent. */
#include "grow/qsm_model.h"

enum wf_hold {
    WF_HOLD_GROUND,
    WF_HOLD_END,  /* at the end of the parent                */
    WF_HOLD_BASE, /* at the parent's base                    */
    WF_HOLD_AXIS  /* at a share of the parent's length       */
};

struct wf_hold_row {
    enum wf_hold at;
    double share;   /* of the parent's modelled axis, for WF_HOLD_AXIS */
    double gap;     /* from the holding point to the row's start [m]   */
    double radius;  /* of the parent there [m]                         */
    bool straight;  /* the row starts at the holding point itself      */
    double base[3]; /* where the row's own wood starts [m]             */
};

/* Rows nearer than this to each other, or shorter, are one point: 1 mm or a tenth of the radius there. */
double wf_joint_tolerance(double radius);

/* Given: a sorted table and how it is joined. Returned: hold[n]. */
void wf_joint_find(const struct wf_qsm *q, enum wf_joint joint, struct wf_hold_row *hold);
#endif
