/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_MODEL_H
#define WF_DATA_MODEL_H
/* A tree model (models/ *.yaml): the architecture of a tree; wf_grow combines it with the materials of a
 * species. */
#include "base/arena.h"
#include "base/err.h"
#include "base/yaml.h"
#include "data/bark.h"
#include "data/branching.h"
#include "data/cavity.h"
#include "data/ifs.h"
#include "data/section.h"
#include "data/tree.h"

struct wf_level;
struct wf_species;

enum wf_taper {
    WF_TAPER_TABLE,  /* radius at relative heights              */
    WF_TAPER_LINEAR, /* r(s) = r0 (1 - (1-t) s), t = top / base */
    WF_TAPER_POWER   /* r(s) = r0 (t + (1-t) (1-s)^p)           */
};

enum wf_season { WF_LEAF_ON, WF_LEAF_OFF };
enum wf_standing_shape {
    WF_SHAPE_STRESS_FREE,
    WF_SHAPE_UNDER_WEIGHT, /* it stands so: its internal forces are those of its weight in this shape */
    WF_SHAPE_UNLOADED      /* it stands so, but its stress-free shape is to be found and taken */
};
/* The day on which the shape was drawn or measured. */
enum wf_scanned { WF_SCANNED_AS_SEASON, WF_SCANNED_LEAF_ON, WF_SCANNED_LEAF_OFF };

/* A solid section at distance `at` from the stem's base. */
struct wf_stem_section {
    double at, width, height; /* [m] */
    enum wf_section_shape shape;
};
/* Masses of a piece of the stem; it begins where the piece before ends. */
struct wf_stem_mass {
    double to;               /* distance of its end from the base [m]                                   */
    double own, left, right; /* of the stem; of what hangs on its sides [kg]; own NAN: from the density */
    double lever;            /* distance of left and right from the axis, along the width [m]           */
};

/* Forms of a crown that is given by width and depth; its share of their rectangle. */
enum wf_crown_form {
    WF_FORM_ELLIPSE,    /* 0.785 */
    WF_FORM_TRIANGLE,   /* 0.5, widest at its base */
    WF_FORM_DIAMOND,    /* 0.5, widest at half its depth */
    WF_FORM_PARABOLOID, /* 0.667, widest at its base */
    WF_FORM_RECTANGLE   /* 1 */
};
extern const char *const wf_crown_form_words[]; /* in the order of the enum; ends at NULL */

/* The crown as it is seen from the side in leaf, and its mass. What is not above 0 is not given; one of area,
 * width and depth, outline (grow/silhouette.h). */
struct wf_silhouette {
    double area;         /* [m2] */
    double width, depth; /* of a crown of that form, which ends at the tree's top [m] */
    enum wf_crown_form form;
    size_t points;   /* outline: points in order around the crown */
    double *x, *z;   /* to the side and above the ground [m] */
    double mass;     /* of branches and leaves that are not drawn, in place of the leaves' [kg] */
    double density;  /* the same per volume of the cone of width and depth [kg m-3] */
    const char *by;  /* the same by a rule of data/crown_mass.h; NULL: none */
    double leafless; /* share of the load that is left without leaves [-]; NAN: by the tree's kind */
    double thinned;  /* share of the crown's load and mass that was taken out [-]; 0: none */
};

struct wf_model {
    const char *key, *name, *note, *source, *file;
    enum wf_generator generator; /* stem: the stem alone; levels: its branches; ifs: copies of the stem */
    size_t seed;                 /* of all random spread                               */
    enum wf_season season;
    enum wf_standing_shape shape; /* what the model or the measurement shows */
    enum wf_scanned scanned;      /* with its leaves or without; under_weight alone */
    bool stands_strictly;         /* refused where parts of it would not stand, instead of stiffening them */
    double leaf_area_on;          /* one-sided, with the leaves on [m2]                 */
    double height;                /* stem height [m]                                    */
    double lean;                  /* from the vertical, towards lean_azimuth [rad]      */
    double lean_azimuth;          /* from +x towards +y [rad]                           */
    double radius;                /* outer radius at the base [m]; NAN: the species' level 0 */
    enum wf_taper taper;
    double tip_ratio, power;    /* for linear and power taper [-]                     */
    struct wf_along profile;    /* for table taper: s, r/radius                       */
    double form_low, form_high; /* of a profile that is a law's: powers of it that 5 and 95 % of stems follow
                                   [-]; 0: it was measured */
    double judged_to; /* distance along the stem from which on its strength is not known, because limbs carry
                         the load there [m]; 0: known all along */
    size_t segments;  /* rows of the tree                                   */
    double crown_base, crown_top;    /* heights of the crown's limits along the stem [m]; NAN: no crown */
    double leaf_area;                /* one-sided, whole crown, 0 in the leafless season [m2] */
    struct wf_silhouette silhouette; /* in place of the sail of the leaves */
    struct wf_along crown_shape;     /* relative leaf area density over the crown, s from crown base to top */
    struct wf_curve curve;           /* of the stem; generator levels                      */
    size_t branchings;               /* levels above the stem; generator levels            */
    struct wf_branching *branching;
    struct wf_ifs ifs;              /* generator ifs                                      */
    struct wf_foliage foliage;      /* generators levels and ifs                          */
    const struct wf_tree *measured; /* generator measured: segments and levels, without materials     */
    size_t measured_models;         /* models of the tree in its file; 0: not a file of several         */
    const uint8_t *measured_kind;   /* of its segments, see grow/clothe.h; NULL: all wood              */
    size_t sections, masses;        /* generator stem; sections 0: round, by radius and taper             */
    struct wf_stem_section *section;
    struct wf_stem_mass *mass;
    double turn;           /* of the sections about the axis, right-handed [rad] */
    const char *bark_said; /* as written; NULL: not given */
    struct wf_bark_said bark;
    size_t cavities;
    struct wf_cavity *cavity;
};

/* Read a tree model. Given: path, arena for all that is kept. Returned: *out. Errors: WF_EINPUT with all
 * mistakes in `d`; WF_ENOMEM; WF_EMISSING without the units database. */
enum wf_status wf_model_read(const char *path, struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                             struct wf_err *e);

/* The first key of a silhouette that does not go with the others, and why; NULL when all do. */
const char *wf_silhouette_wrong(const struct wf_silhouette *s, const char **why);

/* Set the season: leaf_area becomes leaf_area_on, or 0 in the leafless season. */
void wf_model_set_season(struct wf_model *m, enum wf_season season);

/* Number of levels of the tree that the model describes, the stem included. */
size_t wf_model_levels(const struct wf_model *m);

/* Which level of the species table gives the material of row i of a tree grown from the model: the one of the
 * row's level; in a measured tree the thickness counts too (wf_species_wood). */
const struct wf_level *wf_model_wood(const struct wf_model *m, const struct wf_species *sp,
                                     const struct wf_tree *t, size_t i);

/* Name of a level of the tree: the model's; if it has none, the species'; otherwise "branch". In a measured
 * tree "branch of order 1" and so on. */
const char *wf_model_level_name(const struct wf_model *m, const struct wf_species *sp, int32_t level);

/* Height of the stem's top above the ground: the stem is longer where it leans [m]. */
double wf_model_rise(const struct wf_model *m);
/* Outer radius of the stem over its base radius, at relative height s in 0..1 [-]. */
double wf_model_taper(const struct wf_model *m, double s);

extern const struct wf_yaml_table wf_model_table; /* struct wf_model */
#endif
