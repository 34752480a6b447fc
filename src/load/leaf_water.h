/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_LEAF_WATER_H
#define WF_LOAD_LEAF_WATER_H
/* Drops on a leaf: they rest, run, trail subdrops, merge, hang at the edge, fall, and leave a wet trace. Yang
 * M., Wu E. 2011, section 4; equations in brackets are theirs. Places on a leaf are (along the vein, across)
 * [m]. */
#include "base/arena.h"
#include "base/err.h"
#include "grow/leaf_blade.h"
#include <stdbool.h>
#include <stddef.h>

/* Constants of water on leaves. */
struct wf_water_law {
    bool printed;               /* formulas as printed                                     */
    double angle;               /* contact angle [rad]                                     */
    double receding, advancing; /* its hysteresis, of the corrected adhesion [rad]        */
    double friction;            /* mu [-]                                                  */
    double adhesion;            /* H as printed [N]                                        */
    double hang;                /* as printed: largest weight that hangs [N]               */
    double apex;                /* corrected: diameter of the contact circle at the edge [m] */
    double beta;                /* of subdrops [-]                                         */
    size_t tail;                /* N, most subdrops                                        */
    double tail_step;           /* time for one subdrop to form [s]                        */
    double omega, lambda;       /* height of drops (19): omega; 0: lambda^kappa            */
    double zeta, eta;           /* wet trace (11): per second; per cell as printed, per mm corrected */
    double film;                /* corrected: depth of water that a trace keeps [m]        */
    double gravity;             /* [m s-2]                                                 */
};
/* Defaults of the paper's Table 2 and, where it has none, assumed ones (docs/rain.md); corrected or printed.
 */
void wf_water_law_default(struct wf_water_law *w, bool printed);
/* Errors: WF_EUSAGE with the value and its range. */
enum wf_status wf_water_law_check(const struct wf_water_law *w, struct wf_err *e);

enum wf_drop_state { WF_DROP_REST, WF_DROP_RUN, WF_DROP_HANG, WF_DROP_STATES };
extern const char *const wf_drop_states[WF_DROP_STATES];
enum { WF_TAIL_MOST = 32, WF_LEAF_DROPS = 1024 };

struct wf_leaf_drop {
    double mass, at[2], v[2]; /* [kg], [m], [m/s]                                  */
    enum wf_drop_state state;
    bool edge;           /* on the edge of the blade                         */
    double ran;          /* time for which it has been running [s]           */
    double radius, base; /* of its cap; of its contact circle [m]            */
    double stamped[2];   /* where its trace was last drawn */
    size_t trail;        /* places behind it that are kept, newest first     */
    double behind[WF_TAIL_MOST][2];
};

/* How a leaf lies: directions of gravity in the frames of sections along its vein, evenly spaced: components
 * of the upward unit vector along the vein, to the left and along the normal. */
struct wf_leaf_lie {
    size_t n;
    const double (*up)[3]; /* of a leaf in motion: of gravity less its acceleration, over gravity */
    const double *pull;    /* size of that at each section; NULL: 1, a leaf at rest                 */
};

enum wf_water_event { WF_WATER_MERGED, WF_WATER_HUNG, WF_WATER_FELL, WF_WATER_RAN, WF_WATER_EVENTS };
extern const char *const wf_water_events[WF_WATER_EVENTS];

struct wf_leaf_water {
    struct wf_blade blade;
    double fold;    /* each half of the blade rises from the vein by this angle [rad] */
    size_t grid;    /* cells along and across                                        */
    float *wet;     /* grid x grid: ln gamma at time 0; -INFINITY: never wet          */
    double cell[2]; /* size of a cell [m]                                            */
    size_t cells;   /* that lie on the blade                                         */
    size_t wetted;  /* of these, that were ever wet                                  */
    size_t drops;
    struct wf_leaf_drop drop[WF_LEAF_DROPS];
    double received, film, fell; /* mass since the start [kg]; received = drops + film + fell */
    size_t count[WF_WATER_EVENTS];
    /* what fell in the last step; more than there is room for falls in the next one */
    size_t falls;
    struct wf_leaf_drop fall[16];
};

/* An empty leaf. Errors: WF_EUSAGE for a grid of 0 or above 4096, WF_EINPUT for a leaf without area,
 * WF_ENOMEM. */
enum wf_status wf_leaf_water_make(const struct wf_blade *b, double fold, size_t grid, struct wf_arena *a,
                                  struct wf_leaf_water *out, struct wf_err *e);
/* A drop arrives, with a velocity along the blade. When the leaf has no room left it merges with the nearest.
 */
void wf_leaf_water_add(struct wf_leaf_water *w, const struct wf_water_law *law, double mass,
                       const double at[2], const double v[2], double time);
/* One step: forces, places, traces, merging, hanging, falling. */
void wf_leaf_water_step(struct wf_leaf_water *w, const struct wf_water_law *law,
                        const struct wf_leaf_lie *lie, double time, double dt);

/* Directions of gravity at a place: in-plane acceleration [m s-2], and the part that presses on the leaf. */
void wf_leaf_gravity(const struct wf_leaf_water *w, const struct wf_leaf_lie *lie, double g,
                     const double at[2], double along[2], double *press);
/* Forces that hold a drop pressed on by `press` [m s-2]: friction and adhesion [N]. */
double wf_leaf_friction(const struct wf_water_law *law, const struct wf_leaf_drop *d, double press);
/* Most mass that hangs at an edge [kg]. */
double wf_leaf_hanging(const struct wf_water_law *law);
/* Mass of the drops [kg]. */
double wf_leaf_water_held(const struct wf_leaf_water *w);
/* Wetness gamma of a cell at a time; 0 where it never was wet. */
double wf_leaf_wetness(const struct wf_leaf_water *w, const struct wf_water_law *law, size_t i, size_t j,
                       double time);
/* Height of water above the leaf at a place: drops and subdrops [m]. */
double wf_leaf_height(const struct wf_leaf_water *w, const struct wf_water_law *law,
                      const struct wf_leaf_lie *lie, const double at[2]);
/* Radii of the subdrops that a running drop trails now, largest first. Returned: how many; their cubes sum to
 * that of the drop. */
size_t wf_leaf_tail(const struct wf_water_law *law, const struct wf_leaf_drop *d,
                    double radius[WF_TAIL_MOST]);
#endif
