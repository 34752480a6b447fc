/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_SPECIES_H
#define WF_DATA_SPECIES_H
/* A species table: material and section per branching level, and the drag of the crown. SI throughout; every
 * value carries its range, source and standing. */
#include "base/arena.h"
#include "base/err.h"
#include "data/law.h"
#include "data/tree.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_yaml_pair;

struct wf_level {
    const char *name;                     /* "culm", "branch", ... */
    struct wf_value youngs_modulus;       /* longitudinal, green [Pa]             */
    struct wf_value shear_modulus;        /* longitudinal-transverse; not given: E/16 [Pa] */
    struct wf_value density;              /* green, as it stands [kg m-3]         */
    struct wf_value modulus_of_rupture;   /* green, bending [Pa]; not given: no breakage check */
    struct wf_value compressive_strength; /* green, along the grain [Pa]; not given: not assessed */
    struct wf_value shear_strength; /* green, along the grain [Pa]; not given: 0.15 x modulus of rupture */
    struct wf_value
        tangential_strength;            /* green, in tension across the grain [Pa]; not given: not assessed */
    struct wf_value tangential_modulus; /* Young's modulus across the grain [Pa]; not given: not assessed */
    struct wf_value poisson_lt, poisson_tl; /* Poisson's ratios, default 0, on the safe side [-] */
    struct wf_value radius;                 /* typical outer radius at the axis' base [m] */
    struct wf_value damping_ratio;          /* of critical, internal [-]            */
    struct wf_value knot_factor;            /* strength of the stem / clear wood, 0..1 [-] */
    struct wf_value drag_coefficient;       /* of the bare axis, cross-flow; not given: by its law [-] */
    struct wf_value lift_coefficient;       /* across wind and axis, default 0 [-]  */
    struct wf_along wall;                   /* wall thickness / local outer radius, along the axis [-];
                                               n == 0: solid                        */
    struct wf_value wall_note;              /* source and standing of `wall`        */
};

/* The leaves in the wind; none of it given: a species without leaves. */
struct wf_crown {
    struct wf_value drag_coefficient;   /* on the frontal area in still air [-]                */
    struct wf_value leaf_mass_per_area; /* fresh leaf mass per one-sided leaf area [kg m-2]    */
    struct wf_value frontal_share;      /* still-air frontal area per one-sided leaf area [-]  */
    /* of one leaf, for drops on it; not given where the table has none */
    struct wf_value leaf_area, leaf_contact_angle;                     /* [m2], [rad]          */
    struct wf_value petiole_length, petiole_diameter, petiole_modulus; /* [m], [m], [Pa]       */
};

struct wf_species {
    const char *key, *name, *latin, *name_zh, *note, *file;
    size_t aliases;
    const char **alias; /* further names in any language */
    const char *preset; /* "corrected" or the paper whose numbers are printed */
    size_t levels;
    struct wf_level *level;
    struct wf_bark_law bark;
    struct wf_crown crown;
    struct wf_law_use streamlining; /* frontal area times drag coefficient over its still-air value */
    struct wf_law_use axis_drag;    /* of axes without a drag_coefficient */
    size_t sources;
    struct wf_yaml_pair *source; /* citations by key */
};

/* Which results a value affects. */
enum wf_acts {
    WF_ACTS_ALWAYS, /* all, also by its default where the table does not give it                    */
    WF_ACTS_GIVEN,  /* all, where the table gives it; its default has no effect                     */
    WF_ACTS_SIZE,   /* all, where the model gives no size                                           */
    WF_ACTS_MOTION, /* those of a tree in motion, not those of a steady wind                        */
    WF_ACTS_DROPS   /* those of drops on single leaves, not those of a whole tree                   */
};

/* One value of a species with its name, the same in files, results and messages. The rows of species.c are
 * the one list of them: a value that has a row is read, shown, written, reported, and put on a tree. */
struct wf_property {
    const char *key;    /* in the table of its level, the crown or its law: "density" */
    unsigned dimension; /* an enum wf_dimension of base/units.h */
    const char *unit;   /* to show it in; "" for a plain number */
    enum wf_acts acts;
    const struct wf_value *value; /* [SI] */
    const char *was;              /* `quantity` of results.json, which goes with its schema.version 2 */
};

/* The i-th property of a level, in the order of the schema. Returned: false after the last. */
bool wf_level_property(const struct wf_level *l, size_t i, struct wf_property *out);

/* The same for the crown, without its law. */
bool wf_crown_property(const struct wf_species *sp, size_t i, struct wf_property *out);

/* The i-th sourced parameter of a law that a species uses. Given: the law's row (NULL: it has none). */
bool wf_law_property(const struct wf_law *law, const struct wf_law_use *use, size_t i,
                     struct wf_property *out);

/* Put a level's values on row i of a tree: the columns youngs, shear, density, strength (modulus of rupture
 * times knot factor; 0 when not given), compressive, shearing, tangential, transverse (0 when not given),
 * drag (NAN when not given: by the law of bare axes), lift and damping. link: the row only joins two parts,
 * with stiffness and damping, without mass, strength, drag and lift. A factor that is 0, as in a level that
 * was not read from a table, counts as 1. */
void wf_level_onto(const struct wf_level *l, struct wf_tree *t, size_t i, bool link);

/* Full citation of a source key of the table; NULL when there is none. */
const char *wf_species_source(const struct wf_species *sp, const char *key);

/* The species' level of a branching level: its last one for those above it. */
const struct wf_level *wf_species_level(const struct wf_species *sp, int32_t level);

/* The level whose wood a part of a measured tree is taken to be of: the one of its branch order, or, where
 * the part is thicker than that level grows (the upper end of the table's range of radius), the next below
 * that is as thick. Branch orders of a scan say how often an axis forked, not what it is: a limb of order 2
 * is no twig. Given: order, radius [m]. */
const struct wf_level *wf_species_wood(const struct wf_species *sp, int32_t order, double radius);

/* Read a species table. Given: path, the laws it may choose from (wf_laws of load/drag.h), arena for all it
 * keeps, findings list. Returned: WF_OK and *out, or WF_EINPUT with every mistake in `d`. */
enum wf_status wf_species_read(const char *path, const struct wf_laws *laws, struct wf_arena *a,
                               struct wf_species *out, struct wf_diag *d, struct wf_err *e);

/* The rows of a species table, with the laws given and their parameters: every key with dimension, range,
 * default, meaning (wf_yaml_schema). NULL: no memory. */
struct wf_yaml_table;
const struct wf_yaml_table *wf_species_table(const struct wf_laws *laws, struct wf_arena *a);

/* By the genus of a Latin name (NULL: not known): is it a conifer? */
bool wf_species_is_conifer(const char *latin);
/* Does it keep its leaves in winter: conifers but larches and their like, eucalypts, bamboos? */
bool wf_species_is_evergreen(const struct wf_species *sp);

#ifdef __cplusplus
}
#endif
#endif
