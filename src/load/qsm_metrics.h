/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_QSM_METRICS_H
#define WF_LOAD_QSM_METRICS_H
/* Dimensions of a scanned tree (QSM), from its cylinders with their stated lengths, before gaps between them
 * are closed. */
#include "grow/qsm.h"

enum { WF_QSM_ORDERS = 32 };

struct wf_qsm_metrics {
    size_t cylinders, branches, tips, stems;
    int32_t highest_order;
    double height;           /* highest end above the lowest base [m] */
    double dbh;              /* diameter of the stem at 1.3 m, by wf_tree_breast [m]; NAN: it ends below */
    double base_diameter;    /* of the main stem's first row [m] */
    double length;           /* of all axes [m] */
    double volume;           /* wood and bark [m3] */
    double area;             /* lateral surface of all axes [m2] */
    double width_x, width_y; /* extent of all axes [m] */
    double crown_base;       /* lowest end of a cylinder of order 1 or more [m]; NAN without branches */
    double order_length[WF_QSM_ORDERS],
        order_volume[WF_QSM_ORDERS]; /* by branch order; the last entry sums all higher orders */
};

/* Given: a table after wf_qsm_repair, or its rows scaled. Returned: *m. Method: each row is a frustum of its
 * stated length. The main stem is the one whose root cylinder has the largest base radius. */
void wf_qsm_measure(const struct wf_qsm *q, struct wf_qsm_metrics *m);

/* Projected area of all axes normal to a horizontal wind [m2], without mutual shelter: sum over rows of (r0
 * + r1) length sin(angle between wind and axis). Given: azimuth towards which the wind blows, from +x
 * towards +y [rad]. */
double wf_qsm_sail(const struct wf_qsm *q, double azimuth);

/* Drag of all axes of the undeformed tree in a uniform wind, without shelter: the axis drag of load/load.h,
 * normal to each axis (cross-flow principle, Hoerner 1965), applied at its mid-height. Given: dynamic
 * pressure [Pa], drag coefficient [-], azimuth [rad]. Returned: *force, the sum of the magnitudes [N], and
 * *moment about the lowest base [N m]. */
void wf_qsm_drag(const struct wf_qsm *q, double pressure, double drag_coefficient, double azimuth,
                 double *force, double *moment);
#endif
