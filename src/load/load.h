/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_LOAD_H
#define WF_LOAD_LOAD_H
/* Loads on a tree: wind, weight, point loads, dead line loads, cables that hold it
 * and that join parts of it. Solvers read struct
 * wf_loads and do not change it; beam and rod solvers evaluate it on the deformed shape. */
#include "base/err.h"
#include "data/law.h"
#include "data/tree.h"
#include "wind/wind.h"
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_axis_drag_law;
struct wf_species;
struct wf_streamline_law;

enum wf_point_kind {
    WF_POINT_DEAD,    /* keeps its global direction */
    WF_POINT_FOLLOWER /* turns with the section it acts on */
};
struct wf_point_load {
    int32_t segment; /* acts at this row's end */
    enum wf_point_kind kind;
    double force[3], moment[3]; /* at the undeformed shape [N, N m] */
};

/* A cable from a row's end to a point that does not move: a spring that pulls and never pushes. */
struct wf_tie {
    int32_t segment;  /* holds this row's end */
    double anchor[3]; /* [m] */
    double stiffness; /* force over stretch [N m-1] */
    double length;    /* unstretched [m] */
};
enum { WF_TIES_MAX = 8 };

/* A cable or a rod between the ends of two rows: a spring that pulls them together; a rod also pushes. */
struct wf_link {
    int32_t segment[2];
    double stiffness; /* force over stretch [N m-1] */
    double length;    /* unstretched [m] */
    bool pushes;      /* it is a rod */
};
enum { WF_LINKS_MAX = 8 };

struct wf_loads {
    const struct wf_wind *wind;                   /* NULL = still air */
    double air_density;                           /* [kg m-3] */
    double air_viscosity;                         /* kinematic [m2/s], for the axis' drag law */
    double gravity;                               /* [m s-2]; 0 = weightless */
    double wind_scale, weight_scale, point_scale; /* factors for continuation, normally 1 */
    const struct wf_streamline_law *streamline;   /* streamlining law of the crown; NULL = rigid */
    struct wf_law_values streamline_par;
    const struct wf_axis_drag_law *axis_drag; /* used where a row has no drag coefficient; not NULL */
    struct wf_law_values axis_drag_par;
    const struct wf_point_load *point;
    size_t points;
    const double *line; /* 6n: dead load per unit reference length at a row's base (3) and end (3), linear
                         * between, keeping its global direction [N/m]; NULL = none. Scaled by point_scale. */
    const struct wf_tie *tie; /* not scaled: they resist */
    size_t ties;
    const struct wf_link *link; /* likewise */
    size_t links;
    bool sheared; /* the wind, at this or at another speed, changes with height: rows on the ground are cut
                     for it in still air too */
};
/* Does the wind change with height, at this or at another speed? */
bool wf_loads_sheared(const struct wf_loads *l);
/* Loads of a wind, which must outlive them; of one without speed, of the still air before or after it. */
void wf_loads_blow(struct wf_loads *l, const struct wf_wind *wind);
/* The laws a species may choose from: streamlining and axis drag (load/drag.h). */
extern const struct wf_laws wf_laws;

/* Defaults: still air of 1.225 kg/m3 and 1.4607e-5 m2/s (15 C, sea level), gravity 9.81 m/s2, scale factors
 * 1, rigid crown, axis drag by the law 'bark'. */
void wf_loads_default(struct wf_loads *l);
/* Set the streamlining and axis drag laws named by a species, with its parameters. Given: *l filled by
 * wf_loads_default; the species. Returned: the laws in *l; their lists point into the species, which must
 * outlive *l. Errors: WF_EINPUT for an unknown law. */
enum wf_status wf_loads_laws(struct wf_loads *l, const struct wf_species *sp, struct wf_err *e);
/* Pointer to a numeric parameter of the streamlining law, so that a caller can vary it; NULL when the law
 * has no parameter of that name. */
double *wf_loads_streamline_number(struct wf_loads *l, const char *name);

/* Force in a cable whose end is at a place [m]. Returned: [N], 0: it is slack; *force on the tree [N] and its
 * derivative by the place, row-major [N/m]; by_place may be NULL. */
double wf_tie_pull(const struct wf_tie *t, const double at[3], double force[3], double by_place[9]);
/* Force in a link between two places [m]. Returned: [N], negative: a rod pushes, 0: a cable is slack; *force
 * on the first row's end, that on the second is opposite. */
double wf_link_pull(const struct wf_link *k, const double from[3], const double to[3], double force[3]);
/* The axes of a link between two places: axis[0] along it, from the first to the second. Returned: its length
 * [m]. */
double wf_link_axes(const double from[3], const double to[3], double axis[3][3]);

/* Properties of an axis at one point, per unit reference (unloaded) length. */
struct wf_line_point {
    double diameter; /* outer [m] */
    double drag;     /* cross-flow coefficient; NAN = by the axis' drag law [-] */
    double lift;     /* [-] */
    double sail;     /* still-air crown area times its Cd per length [m] */
    double mass;     /* wood and burden per length [kg/m] */
};
/* Of row i of a tree at s, 0 its base, 1 its end. */
struct wf_line_point wf_line_point_of(const struct wf_tree *t, size_t i, double s);
struct wf_line_load {
    double force[3];    /* total per reference length [N/m] */
    double by_place[9]; /* d force / d position [N/m2], row-major */
    double by_turn[9];  /* d force / d (spin of the axis, rotating tangent t' = spin x t) [N/m] */
};
/* Load at one point of an axis and its exact derivatives: cross-flow drag and lift of the axis, drag of the
 * crown, weight. Given: loads, properties of the point, position x [m], unit tangent t. Returned: *out.
 * Source: Hoerner 1965 (cross-flow principle): 1/2 rho Cd D |Un| Un, Un = U - (U.t)t; lift 1/2 rho Cl D |Un|
 * (t x Un); crown 1/2 rho (Cd A)(|U|) |U| U along the wind. */
void wf_load_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                     const double t[3], struct wf_line_load *out);

/* The force of wf_line_load split into its parts, for reports [N/m]: along-wind drag of axis and of crown,
 * across-wind lift, weight. */
struct wf_line_parts {
    double drag_axis[3], drag_crown[3], lift[3], weight[3];
};
void wf_load_parts_on_line(const struct wf_loads *l, const struct wf_line_point *p, const double x[3],
                           const double t[3], struct wf_line_parts *out);

#ifdef __cplusplus
}
#endif
#endif
