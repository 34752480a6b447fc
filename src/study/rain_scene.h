/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_RAIN_SCENE_H
#define WF_STUDY_RAIN_SCENE_H
/* A branch with leaves on petioles as prisms, with blades that drops hit: the scene of Yang & Wu 2011. */
struct wf_species;
struct wf_level;
struct wf_tree;
#include "grow/leaf_blade.h"
#include "load/hits.h"
#include "load/leaf_water.h"
#include "solve/prism_step.h"

struct wf_scene_spec {
    const struct wf_species *species; /* its wood; its leaf mass per area                                */
    const struct wf_leaf_form *form;
    size_t leaves;
    double leaf_length, petiole; /* of the main vein; of the petiole [m]                            */
    double branch, radius[2];    /* its length; radius at base and tip [m]                          */
    double height, rise;         /* of its base above the ground [m]; slope of the branch [rad]     */
    double droop;                /* slope of the leaves below the level [rad]                       */
    double fold;                 /* of the blades' halves [rad]                                     */
    double petiole_radius, petiole_youngs, petiole_density; /* [m], [Pa], [kg m-3]                       */
    double bend_over_twist; /* EI/GJ of petioles [-]                                           */
    size_t prisms, petiole_prisms, vein_prisms;
    size_t mesh[2];      /* rows along, points from the vein to the edge                    */
    double restoring;    /* [N/m]                                                           */
    bool diagonal;       /* mass as printed                                                 */
    const double *nodes; /* of the branch, 3 each, root first; NULL: straight               */
    const double *thick; /* its radius at each of them [m]; NULL: linear by `radius`        */
    size_t node_count;
    const struct wf_level *wood; /* of the branch; NULL: the species' last level            */
};
/* Defaults: five ovate leaves of 8 cm on a branch of 40 cm; the assumed values are listed in docs/rain.md. */
void wf_scene_spec_default(struct wf_scene_spec *s);

/* Leaf and petiole of s->species, in place of the defaults where its table gives them; the vein is that of a
 * leaf of s->form with the area. */
void wf_scene_spec_leaf(struct wf_scene_spec *s);

/* Take an axis of a tree as the branch: its segments become prisms, cut so that there are at least eight;
 * their radii, and the height of its base. id: of a segment on it; 0: the longest axis of the highest level.
 * Given: s->species. Returned: nodes, thick, node_count, wood, radius, height, branch of *s. Errors:
 * WF_EINPUT for an id that is not there and an axis of more than 256 prisms, WF_ENOMEM. */
enum wf_status wf_scene_axis(const struct wf_tree *t, int64_t id, struct wf_scene_spec *s, struct wf_arena *a,
                             struct wf_err *e);

struct wf_scene_leaf {
    size_t first;       /* its root's section       */
    size_t blade;       /* section where the blade begins */
    size_t vein;        /* prisms of the blade      */
    size_t mesh;        /* first of its places      */
    double length, arm; /* of the vein; of its prisms [m] */
};
struct wf_rain_scene {
    struct wf_scene_spec spec; /* its wood is set */
    struct wf_prism prism;
    struct wf_blade blade;
    struct wf_blade_mesh mesh;
    struct wf_scene_leaf *leaf;
    size_t sections;              /* of the branch                                            */
    size_t places;                /* of blades, then of axes                                  */
    double *place;                /* 3 each [m]                                               */
    struct wf_prism_point *point; /* of each place                                            */
    struct wf_hits hits;          /* parts: leaf k; leaves + 1 + section: wood above a section */
    size_t vertices, facets;
    double *rest; /* 9 sections: at rest under its weight [m]                 */
};

/* Build the scene and let it sag under its weight. Errors: WF_EINPUT for sizes that make no scene, those of
 * wf_prism_make, wf_prism_settle, wf_blade_mesh_make, wf_hits_build. */
enum wf_status wf_scene_make(const struct wf_scene_spec *s, double gravity, struct wf_arena *a,
                             struct wf_rain_scene *out, struct wf_err *e);
/* Move places and boxes with the prisms. */
void wf_scene_follow(struct wf_rain_scene *s, const double *x);
/* A point of the blade of leaf k, (along the vein, across). */
void wf_scene_blade_point(const struct wf_rain_scene *s, size_t k, const double at[2],
                          struct wf_prism_point *out);
/* A point of the axis of wood between a section and the next one. */
void wf_scene_wood_point(size_t section, double share, struct wf_prism_point *out);
/* How leaf k lies: vein prisms + 1 rows into `up`. */
void wf_scene_lie(const struct wf_rain_scene *s, const double *x, size_t k, double (*up)[3]);
/* Unit normal of the blade of leaf k at a place. */
void wf_scene_normal(const struct wf_rain_scene *s, const double *x, size_t k, const double at[2],
                     double out[3]);
#endif
