/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_BRANCHING_H
#define WF_DATA_BRANCHING_H
/* Parameters of a branching level (where branches start on their parents, their directions, lengths, radii
 * and curvature) and of the leaves, with their schema. Angles in radians, lengths in metres; a place is a
 * relative position along an axis, 0 = base, 1 = tip. */
#include "base/yaml.h"
#include "data/tree.h"
#include <stddef.h>

enum { WF_BRANCH_LEVELS_MAX = 8 }; /* levels of a tree, the stem included */

enum wf_generator { WF_GENERATOR_STEM, WF_GENERATOR_LEVELS, WF_GENERATOR_IFS, WF_GENERATOR_MEASURED };
/* Words of enum wf_generator in its order. NULL stands before "measured", which a model file cannot ask for.
 */
extern const char *const wf_generator_words[];

/* Curvature of an axis, as angles between its successive segments. */
struct wf_curve {
    double turn;     /* total turn towards the vertical: > 0 up, < 0 down; stops at the vertical [rad] */
    double from, to; /* part of the axis over which it turns [-]                                       */
    double wander;   /* standard deviation of the total random turn, to any side [rad]                 */
};

enum wf_azimuth_rule {
    WF_AZIMUTH_SPIRAL, /* each place turned by `divergence` from the one below     */
    WF_AZIMUTH_WHORL,  /* the same; divergence: half the angle between neighbours  */
    WF_AZIMUTH_PLANAR, /* alternating between the two sides                        */
    WF_AZIMUTH_RANDOM  /* any direction                                            */
};
enum wf_length_law { WF_LENGTH_ABSOLUTE, WF_LENGTH_PARENT, WF_LENGTH_REST };
enum wf_radius_law {
    WF_RADIUS_PARENT,   /* share of the parent's radius where the branch starts */
    WF_RADIUS_SPECIES,  /* radius of the species' level                         */
    WF_RADIUS_ABSOLUTE, /* a radius                                             */
    WF_RADIUS_LENGTH,   /* value (length / 1 m)^exponent                        */
    WF_RADIUS_PIPE      /* r^exponent = sum of those above, from tips of `value` */
};

/* The branches of one level. Spreads are standard deviations of normal draws, which are limited to 2.5
 * standard deviations. */
struct wf_branching {
    const char *name;
    /* places on the parent: those of `at`, or `count` places from..to, or one every `spacing` */
    double from, to, spacing;
    size_t count, places;
    double *at;
    size_t per_whorl;    /* branches at one place                                     */
    double place_spread; /* of the distance between neighbours [-]                    */
    enum wf_azimuth_rule azimuth;
    double azimuth_start, divergence, azimuth_spread; /* about the parent's axis; 0: its upper side [rad] */
    double insertion, insertion_spread;               /* between the parent's axis and the branch [rad]   */
    struct wf_along insertion_along;                  /* in place of `insertion`, along the parent        */
    enum wf_length_law length_law;
    double length, length_factor, length_spread; /* [m], [-], of the logarithm [-] */
    struct wf_along length_along;                /* further factor along the parent */
    double shortest;                             /* shorter branches do not grow [m] */
    enum wf_radius_law radius_law;
    double radius, radius_factor, radius_exponent, radius_spread; /* [m], [-], [-], of the logarithm [-] */
    struct wf_along radius_along;
    double tip_share, taper_power; /* radius over base radius: t + (1-t)(1-s)^p */
    size_t segments;
    struct wf_curve curve;
};

/* Leaves on the last levels. */
struct wf_foliage {
    double area;          /* one-sided, whole tree [m2]                               */
    double from, to;      /* part of the axes that has leaves [-]                     */
    size_t levels;        /* how many of the last levels have leaves                  */
    size_t count;         /* single leaves or clusters; 0: leaf area per length only  */
    double tilt, scatter; /* from the axis, and its spread [rad]                      */
    double size_spread;   /* of the logarithm of the size [-]                         */
    double swing, twist;  /* rotation about the hanging point and about the vertical at 10 m/s [rad] */
};

/* Schema tables of the parts of a branched model. */
extern const struct wf_yaml_table wf_branching_table; /* struct wf_branching */
extern const struct wf_yaml_table wf_curve_table;     /* struct wf_curve     */
extern const struct wf_yaml_table wf_foliage_table;   /* struct wf_foliage   */
/* Words of enum wf_radius_law, in its order; end at NULL. */
extern const char *const wf_radius_words[];
#endif
