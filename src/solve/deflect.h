/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_DEFLECT_H
#define WF_SOLVE_DEFLECT_H
/* A tree as straight rods, each rotated about its base by its own deflection, frame by frame. Source: Zhao
 * P., Zhang Z. 2013. Research on fast dynamic simulation of IFS trees swaying. Computer Engineering and
 * Applications 49(14):160-163, eqs 1 to 4.
 *
 * As printed: only the wind force on a row bends it, delta = 4 F L^3/(3 pi E R^3) with F the part across the
 * row, theta = asin(delta/L), rotations composed from root to tip; F(t) = F_1 - k F(t-1) + F_w. F_w = c
 * omega^2 acts along the axis, so it causes no bending. The cube of R has the wrong unit: in SI the
 * deflection is R times too small. Corrected: R^4; force and moment of everything above a row, including its
 * weight, bend it too; the chord rotates by asin(delta/L), the end by the slope of a cantilever; damping -c
 * omega |omega| against the motion; no k, the elastic restoring force is in E. Loads are those on the
 * undeformed tree: small deflection. It agrees with the `chain` solver to first order. */
#include "solve/solve.h"

struct wf_deflect_scheme {
    bool printed;
    double restoring; /* k, share of the last frame's force that is subtracted, 0 <= k < 1 [-] */
    double damping;   /* c [N s2] */
};

struct wf_deflect_row { /* constant from frame to frame */
    int32_t parent;
    double base[3];         /* from the end of the row below to this row's base, undeformed [m] */
    double axis[3], length; /* undeformed */
    double wind[3], speed;  /* at the middle of the row, at the speed of the wind field [m/s] */
    double normal[3], across,
        lifted[3]; /* component of wind across the undeformed row and its size [m/s]; axis x normal */
    double drag, lift, sail; /* force over velocity squared [N s2/m2]; negative drag: times -1 and the
                                coefficient of the axis drag law */
    double weight;           /* [N] */
    double bend, twist;      /* 1/(EI), 1/(GJ) at the middle [1/(N m2)] */
    double printed;          /* 4 L^2/(3 pi E R^3): sine of the angle per force [1/N] */
    double radius;
};

struct wf_deflect {
    struct wf_deflect_scheme scheme;
    const struct wf_loads *loads;
    size_t n;
    struct wf_deflect_row *row;
    double (
        *turn)[9]; /* n: rotation of the row's end from the undeformed tree, row-major; result of a frame */
    double (*end)[3];   /* n: position of its end [m]; result of a frame */
    double (*chord)[3]; /* n: direction of the row */
    double (*force)[3]; /* n: F of the last frame [N] */
    double (*above)[6]; /* n: force and moment on the row's end */
    double *angle;      /* n: rotation of the chord in the last frame [rad] */
    double *spin;       /* n: rate of that rotation in the last frame [rad/s] */
    size_t clamped;     /* rows of the last frame with delta > L, held at 90 degrees */
    int32_t worst;      /* the row with the largest delta/L, and its value */
    double worst_ratio;
};

/* Prepare frames. Given: tree, loads (wind at its speed; dead and point loads are used by the corrected
 * form), scheme; `l` must outlive *d. Returned: *d. Errors: WF_EUSAGE for k outside 0 <= k < 1 or negative
 * damping, with the reason; WF_EINPUT for sections that are not round; WF_ENOMEM. */
enum wf_status wf_deflect_open(const struct wf_tree *t, const struct wf_loads *l,
                               const struct wf_deflect_scheme *scheme, struct wf_arena *a,
                               struct wf_deflect *d, struct wf_err *e);
/* Compute one frame: wind `gust` times the wind field, `step` seconds after the last frame (0: no motion
 * before it). */
void wf_deflect_frame(struct wf_deflect *d, double gust, double step);

/* Solvers: one steady frame with k = c = 0. */
extern const struct wf_solver wf_solver_deflect, wf_solver_deflect_as_printed;
#endif
