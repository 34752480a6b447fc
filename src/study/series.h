/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SERIES_H
#define WF_STUDY_SERIES_H
/* A tree in wind that changes with time. Quasi-static: each frame is a static equilibrium without inertia, so
 * gusts must be slow compared with the tree's sway. With the deflect scheme each frame depends on
 * the one before. */
#include "grow/clothe.h"
#include "solve/deflect.h"
#include "study/analysis.h"
#include "study/preset.h"
#include "wind/gust.h"
#include "wind/noise.h"
#include "wind/shelter.h"
#include <stdint.h>

/* How leaves hang on a moving tree. For pictures only: these rotations do not affect the loads.
 *
 * Tang et al. 2012, eq 13: rotation about the hanging point and about the vertical in proportion to the wind
 * speed, phi = lambda_1 U(t), psi = lambda_2 U(t), added to the motion of the branch. Zhao & Zhang 2013:
 * rotations about three axes from three noises, M_x N_x(t), M_y N_y(t), M_z N_z(t) + lambda theta_x. The
 * paper does not number the leaves; here each has its own noises. */
struct wf_leaf_stand { /* a leaf of size 1 on the unbent tree */
    int32_t row;
    double along;                 /* from the row's end back to the hanging point [m] */
    double axis[3];               /* of the row                                       */
    double direction[3], side[3]; /* unit vectors along and across the leaf           */
};
struct wf_leaf_pose {
    double at[3], tip[3], side[3]; /* hanging point; unit vectors along and across the leaf */
};

/* Rotation matrix: about x by angle[0], then y by angle[1], then z by angle[2]; row-major. */
void wf_leaf_matrix(const double angle[3], double R[9]);
/* Given: rotations and ends of the rows, the leaf's own rotation R. Returned: *p. */
void wf_leaf_place(const struct wf_leaf_stand *s, const double (*turn)[9], const double (*end)[3],
                   const double R[9], struct wf_leaf_pose *out);
/* Eq 13: swing phi about the level axis across the leaf (away from the vertical), then psi about the
 * vertical. Given: *p, the pose after the branch's motion. Returned: *p rotated. */
void wf_leaf_swing(double phi, double psi, struct wf_leaf_pose *p);

struct wf_series;
/* Rotations of leaves on their stalks, as rows. For pictures only: they do not affect the loads. */
struct wf_leaf_motion {
    const char *name, *title, *source;
    const char *angles[3]; /* their names; NULL: fewer angles */
    void (*angle)(const struct wf_series *s, size_t leaf, size_t frame, double angle[3]); /* [rad] */
    /* Rotate the leaf after the branch's motion; NULL: the angles are rotations about the tree's x, y, z
     * before the branch's motion. */
    void (*hang)(const double angle[3], struct wf_leaf_pose *p);
};
extern const struct wf_leaf_motion wf_leaf_motions[]; /* eq13, noise; ends at name == NULL */
const struct wf_leaf_motion *wf_leaf_motion_named(const char *name);

struct wf_series_spec {
    const char *name;                 /* of the run                                                   */
    const struct wf_species *species; /* after its preset                                             */
    const struct wf_model *model;
    const struct wf_preset *preset;
    const struct wf_solver *solver;
    struct wf_solve_options solve;
    struct wf_scenario scenario;
    struct wf_profile_words profile; /* written to the scenario when the run begins */
    double speed;                  /* mean wind at the reference height [m/s]                              */
    const char *gust;              /* row of wf_gust_models; NULL: steady                                  */
    double intensity, period;      /* of the gust [-], [s]; NAN: the model's own                           */
    const char *gust_set;          /* its other parameters, "name=number,..."; NULL: the model's own       */
    const char *gust_file;         /* of the model `record` */
    struct wf_record_words record; /* how it is read        */
    unsigned components; /* of the gust used: 1 or 3; 0: 3 where the model has them and the wind direction
                            can change */
    uint64_t seed;
    double step;               /* between frames [s]                                                   */
    size_t frames, keys;       /* frames; number of key frames, evenly spaced from the first            */
    double restoring, damping; /* of the deflect scheme: k [-], c [N s2]                              */
    double youngs;             /* in place of the species' on every level [Pa]; NAN: the species'      */
    const struct wf_shelter_law *shelter; /* wind inside the crown; NULL: free wind everywhere */
    double transmission; /* of a fully covered cell, share of the wind's energy [-]              */
    const struct wf_leaf_motion *leaf_motion;
    struct wf_leaf_flutter flutter; /* amplitudes of the noises, see wf_leaf_amplitude          */
    double leaf_period;             /* of the first octave [s]                                  */
};
/* Set the amplitudes from the largest angle of each of the three noises alone [rad]; f->octaves is given. */
void wf_leaf_amplitude(double angle, struct wf_leaf_flutter *f);

/* 10 m/s, steady, corrected, one frame every 0.1 s for 60 s, 8 key frames. */
void wf_series_default(struct wf_series_spec *s);

/* Motion of the ends of one level's axes. */
struct wf_series_level {
    size_t axes;
    double swing_mean, swing_most; /* half the range of positions along the wind, over axes [m] */
    double own_mean;               /* the same relative to the foot of the axis [m]                         */
    double windward, leeward;      /* swing_mean of axes whose end lies windward or leeward of the stem [m] */
    double own_windward, own_leeward; /* own_mean of these [m]                             */
};

struct wf_series {
    struct wf_series_spec spec;
    struct wf_analysis an; /* tree, wind, loads */
    struct wf_leaves leaves;
    size_t frames, failed;  /* failed: without a result; they repeat the last one */
    double *wind;           /* frames: speed along the mean wind at the reference height [m/s] */
    double *across, *up;    /* frames: to its left, up [m/s]; NULL: along the wind only        */
    const char *gust_words; /* parameters in use; NULL: steady                                 */
    enum wf_status *status; /* frames */
    double *place;          /* frames x 3n: ends of the rows [m]                 */
    double *deflection;     /* frames: of the tip, from the unloaded shape [m]   */
    double *moment;         /* frames: overturning moment at the base [N m]      */
    double *safety; /* frames: least of breakage anywhere and of loss of the tree [-]; NAN: not known, as with
                       the deflect scheme */
    size_t broken;  /* first frame in which it is 1 or less; `frames`: none. From there on the frames are
                       those of a tree that cannot break */
    size_t tip;     /* row                                               */
    size_t *key;    /* spec.keys frames                                  */
    size_t levels;
    struct wf_series_level *level;
    size_t clamped; /* frames in which asin was clamped                  */
    struct wf_diag *diag;
};

/* Run. In a steady wind the quasi-static frames are equal: one is solved, and spec.keys of *s is 1 (warning
 * steady-wind). Further warnings: broken, through-ground, no-equilibrium. Gusts scale the whole profile:
 * speed and direction change at all heights together and are those of the gust's components at the reference
 * height. The deflect scheme and shelter inside the crown are made for one direction and use only the
 * component along the wind (warning along-wind-only). Errors: WF_EUSAGE (frames, k >= 1, unknown gust model),
 * WF_ENOMEM, and where no frame has a result the status of the first. */
enum wf_status wf_series_run(const struct wf_series_spec *spec, struct wf_arena *a, struct wf_diag *d,
                             struct wf_series *out, struct wf_err *e);

/* Own angles of a leaf in a frame [rad]; spec.leaf_motion has their names. */
void wf_series_leaf_angles(const struct wf_series *s, size_t leaf, size_t frame, double angle[3]);
/* Positions of the leaves in a frame: hanging point and end, 3 numbers for each leaf [m]. They rotate with
 * the chord of their row. */
void wf_series_leaves(const struct wf_series *s, size_t frame, double *at, double *tip);
#endif
