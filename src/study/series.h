/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SERIES_H
#define WF_STUDY_SERIES_H
/* A tree in a wind that changes: the balance of every moment for itself (quasi-static: no inertia, so gusts
 * are to be slow against the tree's own sway), or, with the deflect scheme, frame after frame with its memory
 * of the last one. */
#include "grow/clothe.h"
#include "solve/deflect.h"
#include "study/analysis.h"
#include "study/preset.h"
#include "wind/gust.h"
#include "wind/noise.h"
#include "wind/shelter.h"
#include <stdint.h>

/* How leaves hang on a moving tree. A look, not a load: these turns enter no force.
 *
 * Tang et al. 2012, eq 13: turn about the hanging point and about the vertical in proportion to the wind's
 * speed, phi = lambda_1 U(t), psi = lambda_2 U(t), on top of what the branch does. Zhao & Zhang 2013: turns
 * about three axes from three noises, M_x N_x(t), M_y N_y(t), M_z N_z(t) + lambda theta_x. The paper prints
 * no number of a leaf; here each has noises of its own. */
struct wf_leaf_stand { /* a leaf of size 1 on the unbent tree */
    int32_t row;
    double along;                 /* from the row's end back to the hanging point [m] */
    double axis[3];               /* of the row                                       */
    double direction[3], side[3]; /* unit vectors along and across the leaf           */
};
struct wf_leaf_pose {
    double at[3], tip[3], side[3]; /* hanging point; unit vectors along and across */
};

/* Turn about x by angle[0], then y by angle[1], then z by angle[2]; row-major. */
void wf_leaf_matrix(const double angle[3], double R[9]);
/* Given: turns and ends of the rows, the leaves' own turn R. */
void wf_leaf_place(const struct wf_leaf_stand *s, const double (*turn)[9], const double (*end)[3],
                   const double R[9], struct wf_leaf_pose *out);
/* Eq 13: swing phi about the level axis across the leaf (away from the vertical), then psi about the
 * vertical. Given: leaf as the branch carries it. Returned: *p turned. */
void wf_leaf_swing(double phi, double psi, struct wf_leaf_pose *p);

struct wf_series;
/* How leaves turn on their stalks: rows. A look: they enter no load. */
struct wf_leaf_motion {
    const char *name, *title, *source;
    const char *angles[3]; /* what they are called; NULL: fewer */
    void (*angle)(const struct wf_series *s, size_t leaf, size_t frame, double angle[3]); /* [rad] */
    /* Turn the leaf the branch carries; NULL: the angles are turns about the tree's x, y, z before the branch
     * moves it. */
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
    struct wf_profile_words profile; /* into the scenario when the run begins */
    double speed;             /* mean wind at the reference height [m/s]                              */
    const char *gust;         /* row of wf_gust_models; NULL: steady                                  */
    double intensity, period; /* of the gust [-], [s]; NAN: the model's own                           */
    const char *gust_set;     /* its other parameters, "name=number,..."; NULL: the model's own       */
    const char *gust_file, *gust_columns; /* of the model `record`, see wind/gust_words.h              */
    unsigned components; /* of the gust used: 1 or 3; 0: 3 where the model has them and the run can turn the
                            wind */
    uint64_t seed;
    double step;               /* between frames [s]                                                   */
    size_t frames, keys;       /* frames; of them key frames, evenly spaced from the first              */
    double restoring, damping; /* of the deflect scheme: k [-], c [N s2]                              */
    double youngs;             /* in place of the species' on every level [Pa]; NAN: the species'      */
    const struct wf_shelter_law *shelter; /* wind inside the crown; NULL: every part meets the free wind */
    double transmission; /* of a fully covered cell, share of the wind's energy [-]              */
    const struct wf_leaf_motion *leaf_motion;
    struct wf_leaf_flutter flutter; /* by noise: see wf_leaf_amplitude                          */
    double leaf_period;             /* of the first octave [s]                                  */
};
/* Largest angle any of the three noises alone can give [rad]; the octaves are to be set. */
void wf_leaf_amplitude(double angle, struct wf_leaf_flutter *f);

/* 10 m/s, steady, corrected, one frame a tenth of a second for 60 s, 8 key frames. */
void wf_series_default(struct wf_series_spec *s);

/* How far the ends of one level's axes move. */
struct wf_series_level {
    size_t axes;
    double swing_mean,
        swing_most;           /* half of the way between the extreme places along the wind, over axes [m] */
    double own_mean;          /* the same against the foot of the axis [m]                           */
    double windward, leeward; /* swing_mean of axes whose end lies windward or leeward of the stem [m] */
};

struct wf_series {
    struct wf_series_spec spec;
    struct wf_analysis an; /* tree, wind, loads */
    struct wf_leaves leaves;
    size_t frames, failed;  /* failed: without an answer; they keep the last one */
    double *wind;           /* frames: speed along the mean wind at the reference height [m/s] */
    double *across, *up;    /* frames: to its left, up [m/s]; NULL: along the wind only        */
    const char *gust_words; /* parameters in use; NULL: steady                                 */
    enum wf_status *status; /* frames */
    double *place;          /* frames x 3n: ends of the rows [m]                 */
    double *deflection;     /* frames: of the tip, from the unloaded shape [m]   */
    double *moment;         /* frames: overturning moment at the base [N m]      */
    size_t tip;             /* row                                               */
    size_t *key;            /* spec.keys frames                                  */
    size_t levels;
    struct wf_series_level *level;
    size_t clamped; /* frames in which asin was clamped                  */
    struct wf_diag *diag;
};

/* Run it. Gusts scale the whole profile: the wind turns and changes at all heights together; direction and
 * strength come from the gust's components at the reference height. The deflect scheme and winds inside the
 * crown are made for one direction and take the part along the wind alone (warning along-wind-only). Errors:
 * WF_EUSAGE (frames, k >= 1, unknown gust model), WF_ENOMEM, and where no frame at all has an answer the
 * status of the first. */
enum wf_status wf_series_run(const struct wf_series_spec *spec, struct wf_arena *a, struct wf_diag *d,
                             struct wf_series *out, struct wf_err *e);

/* Own angles of a leaf in a frame [rad], as spec.leaf_motion names them. */
void wf_series_leaf_angles(const struct wf_series *s, size_t leaf, size_t frame, double angle[3]);
/* Where the leaves are in a frame: 3 numbers a leaf each, hanging point and end of a leaf. Rows carry them by
 * the turn of their chord. */
void wf_series_leaves(const struct wf_series *s, size_t frame, double *at, double *tip);
#endif
