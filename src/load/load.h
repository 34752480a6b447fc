/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_LOAD_H
#define WF_LOAD_LOAD_H
/* What acts on a tree. A case is read-only while a solver runs; the solver samples it on the bent shape. */
#include "base/err.h"
#include "data/law.h"
#include "data/tree.h"
#include "wind/wind.h"
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_axis_drag_law;
struct wf_species;
struct wf_streamline_law;

enum wf_point_kind {
    WF_POINT_DEAD,    /* keeps its global direction                    */
    WF_POINT_FOLLOWER /* turns with the section it acts on             */
};
struct wf_point_load {
    int32_t segment; /* acts at this row's end                        */
    enum wf_point_kind kind;
    double force[3], moment[3]; /* at the undeformed shape [N, N m]    */
};

struct wf_loads {
    const struct wf_wind *wind;                   /* NULL = still air                               */
    double air_density;                           /* [kg m-3]                                       */
    double air_viscosity;                         /* kinematic [m2/s], for the axis' drag law       */
    double gravity;                               /* [m s-2]; 0 = weightless                        */
    double wind_scale, weight_scale, point_scale; /* factors for continuation, normally 1 */
    const struct wf_streamline_law *streamline;   /* crown's law; NULL = rigid crown  */
    struct wf_law_values streamline_par;
    const struct wf_axis_drag_law *axis_drag; /* where a row gives no coefficient; not NULL */
    struct wf_law_values axis_drag_par;
    const struct wf_point_load *point;
    size_t points;
    const double *line; /* 6n: dead load per unit reference length at a row's base (3) and end (3), linear
                         * between, keeping its global direction [N/m]; NULL = none. Scaled by point_scale. */
};
/* The laws a species may choose from: streamlining and axis drag (load/drag.h). */
extern const struct wf_laws wf_laws;

/* Still air of 1.225 kg/m3 and 1.4607e-5 m2/s (15 C, sea level), 9.81 m/s2, scales 1, rigid crown, axes with
 * bark.
 */
void wf_loads_default(struct wf_loads *l);
/* The laws a species chooses, with its values. Given: defaults of a species that was read, or made by hand.
 * Returned: the laws of *l; WF_EINPUT for a law that does not exist. Lists stay the species'. */
enum wf_status wf_loads_laws(struct wf_loads *l, const struct wf_species *sp, struct wf_err *e);
/* The number of a parameter of the streamlining law, to be varied; NULL when the law has none of that name.
 */
double *wf_loads_streamline_number(struct wf_loads *l, const char *name);

/* One point of an axis, per unit reference length. */
struct wf_line_point {
    double diameter; /* outer [m]                                              */
    double drag;     /* cross-flow coefficient; NAN = by the axis' drag law [-] */
    double lift;     /* [-]                                                    */
    double sail;     /* still-air crown area times its Cd per length [m]       */
    double mass;     /* wood and burden per length [kg/m]                      */
};
struct wf_line_load {
    double force[3];    /* total per reference length [N/m]                                  */
    double by_place[9]; /* d force / d position [N/m2], row-major                            */
    double by_turn[9];  /* d force / d (spin of the axis, rotating tangent t' = spin x t) [N/m] */
};
/* Cross-flow drag and lift of the axis, drag of the crown, weight, at position x with unit tangent t.
 * Source: Hoerner 1965 (cross-flow principle): 1/2 rho Cd D |Un| Un, Un = U - (U.t)t; lift 1/2 rho Cl D
 * |Un| (t x Un); crown 1/2 rho (Cd A)(|U|) |U| U along the wind. Derivatives are exact. */
void wf_load_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                     const double t[3], struct wf_line_load *out);

/* The same split into its parts, for reports [N/m]: along-wind drag of axis, of crown, across-wind lift,
 * weight. */
struct wf_line_parts {
    double drag_axis[3], drag_crown[3], lift[3], weight[3];
};
void wf_load_parts_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                           const double t[3], struct wf_line_parts *out);

#ifdef __cplusplus
}
#endif
#endif
