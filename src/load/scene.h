/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_SCENE_H
#define WF_LOAD_SCENE_H
/* From a user's scenario and a species to wind field, air properties and loads. Studies, fits and validation
 * cases all use these functions, so that the same input gives the same loads. */
#include "base/err.h"
#include "load/load.h"
#include "wind/wind.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_species;

struct wf_site;              /* wind/terrain.h */
struct wf_category;          /* wind/category.h */
struct wf_design;            /* wind/design.h */
struct wf_anchorage_request; /* fail/anchorage.h */
struct wf_guy;               /* study/guy.h */
struct wf_removed;           /* study/removal.h */

/* States of a tree in a wind: in the mean wind; at the peak of the load on the whole tree; at the peak of the
 * load on one branch, which a gust reaches at once. */
enum wf_part { WF_PART_MEAN, WF_PART_STEM, WF_PART_BRANCHES, WF_PARTS };

/* How peak loads are specified. */
struct wf_stand {
    double height, spacing; /* of the stand, mean distance between its trees [m]; spacing 0: unknown */
    double edge, gap;       /* distance from the upwind edge; length of the gap before it [m] */
};
struct wf_peak_table {
    size_t n;
    const double *speed, *factor; /* ascending [m/s]; peak over mean load [-] */
};
struct wf_peak_request {
    const char *method;                /* name in wf_peak_methods (study/peak.h) */
    double damping;                    /* structural, of critical [-]; NAN: of the species */
    bool exponent_by_law;              /* load of a gust by the crown's streamlining law, not by the square */
    const struct wf_peak_table *table; /* of the method 'table' */
    struct wf_stand stand;             /* of the method 'gales' */
};
/* How a wind was named, by parts, so that pages say it in their language: a kind of `ws.KIND` of
 * reports/strings.xml, and its parts in that order. */
enum { WF_WIND_PARTS = 8 };
struct wf_wind_note {
    const char *kind;
    const char *part[WF_WIND_PARTS]; /* NULL after the last */
    const struct wf_wind_note *next; /* NULL: the last */
};
struct wf_scenario {
    const char *profile;                        /* row of wf_profiles */
    const struct wf_measured_profile *measured; /* data of the profile "measured" */
    const char *profile_file;                   /* file that `measured` was read from */
    double reference_height;                    /* height of the named wind speeds [m] */
    double speed_up; /* ratio of the wind at the tree to the named wind, at every height: exposure of the site
                        [-] */
    const struct wf_site *site; /* terrain from which speed_up was computed; NULL: speed_up was given */
    double roughness, displacement,
        exponent; /* [m], [m], [-]: of the log and canopy, log and canopy, power profile */
    double canopy_height, attenuation; /* [m], [-]: of the canopy profile; 0: derived, see wind/wind.h */
    double azimuth;                    /* direction the wind blows towards, from +x towards +y [rad] */
    double temperature, altitude;      /* [K], [m] */
    double air_density;                /* [kg m-3]; NAN: from temperature and altitude */
    double gravity;
    const char *branch_strength; /* name in wf_branch_strengths (fail/fail.h); NULL: by the bark */
    double snow;                 /* on the crown, per area seen from above [kg m-2]; 0: none */
    double ice;                  /* radial thickness on axes and leaves [m]; 0: none */
    bool weight_unstressed; /* stresses are those of the change from the state at rest: the weight's are left
                               out, which is unsafe for leaning trees and limbs */
    double water;           /* rain on the leaves, per one-sided leaf area [kg m-2]; 0: dry */
    const char *shelter;    /* name in wf_shelter_laws by which the tree shelters itself; NULL: no shelter */
    const struct wf_category *category; /* terrain of the site, for gusts */
    bool category_said;                 /* else open country is assumed */
    const char *site_kind;              /* row of wf_site_kinds; NULL: not given */
    const struct wf_design *design;     /* whose wind is taken; NULL: none */
    struct wf_wind_place named; /* where the named winds are measured; height 0: the reference height */
    double carried;     /* mean wind of the site's terrain over the named wind, at the reference height;
                           the exposure comes on top [-] */
    double winter;      /* share of the named wind that blows while snow or ice is on the tree; in `carried`
                           [-] */
    double gust_factor; /* 3-s gust over 10-min mean of the named winds; 0: by EN 1991-1-4 [-] */
    double squall;      /* the same of the design wind at the site at 10 m; 0: no design wind [-] */
    double least;       /* of the profile "code": height below which the wind is constant [m] */
    const struct wf_guy *guy; /* cables from the stem to the ground (study/guy.h) */
    size_t guys;
    const struct wf_brace *brace; /* cables and rods between two points of the tree (study/brace.h) */
    size_t braces;
    const struct wf_removed *removed; /* branches that are taken off; NULL: none */
    struct wf_reduced {
        double share, length; /* off a drawn crown all round (study/reduction.h) [-], [m]; 0: nothing */
        double thin; /* share of the leaves that was taken out of the model, for the share that is gone */
    } reduced;
    const struct wf_anchorage_request *anchorage; /* of the root (fail/anchorage.h); NULL: nothing is said */
    double corridor;             /* distance of a corridor from the base of the stem [m]; 0: none */
    double corridor_towards;     /* where it lies, from +x towards +y [rad]; NAN: where the wind blows */
    double tip_angle;            /* limit of the turn of the stem's tip [rad]; 0: none */
    double node_spacing;         /* longest distance between nodes of a culm whose diaphragms count [m]; 0 */
    struct wf_peak_request peak; /* how the peak load follows from the mean wind */
    const struct wf_wind_note *wind_notes; /* the same by parts; NULL: none */
    const char *winds_said; /* in words, how the given wind speeds were converted to 10-min means; NULL: no
                               conversion */
};
/* Defaults: power law 0.16 at 10 m, wind towards +x, 15 C, sea level, 9.81 m/s2. */
void wf_scenario_default(struct wf_scenario *s);

/* Check that a wind field can be made of a scenario. Errors: WF_EUSAGE naming the value and its allowed
 * range. */
enum wf_status wf_scenario_check(const struct wf_scenario *s, struct wf_err *e);
/* A wind profile as the user specifies it. NULL, NAN: not given. */
struct wf_profile_words {
    const char *name, *file; /* row of wf_profiles; heights and speeds of the measured one */
    double reference_height, exponent, roughness, displacement, canopy_height, attenuation;
    const char *ground; /* map of the ground, whose speed-up takes the roughness too; NULL: none */
    const char *site;   /* row of wf_site_kinds */
    const char *at;     /* "open": the winds are of open country, carried to the site's terrain; "site" */
    double winter;      /* share of the named wind that blows while snow or ice is on the tree; in `carried`
                           [-] */
    double gust_factor; /* 3-s gust over 10-min mean where the winds are measured */
    struct wf_design_words design; /* also the terrain of the site */
};
/* Numbers that belong to some profiles only. */
struct wf_profile_number {
    const char *key;
    size_t said, value; /* offsets in struct wf_profile_words and struct wf_scenario */
};
extern const struct wf_profile_number wf_profile_numbers[]; /* end at key == NULL */
#define WF_PROFILE_UNSAID                                                                                    \
    {                                                                                                        \
        .reference_height = NAN, .exponent = NAN, .roughness = NAN, .displacement = NAN,                     \
        .canopy_height = NAN, .attenuation = NAN, .gust_factor = NAN, .design = {                            \
            .basic = NAN,                                                                                    \
            .pressure = NAN,                                                                                 \
            .years = NAN                                                                                     \
        }                                                                                                    \
    }
/* Numbers of a struct wf_profile_words as keys of a YAML table of a struct T, which has it as member `in`. */
#define WF_PROFILE_KEY(T, k, in, dim, u, from, to, text, ...)                                                \
    {                                                                                                        \
        .key = #k, .kind = WF_YAML_QUANTITY, .dimension = dim, .unit = u, .low = from, .high = to,           \
        .offset = offsetof(T, in.k), .doc = text, __VA_ARGS__                                                \
    }
#define WF_PROFILE_KEYS(T, in)                                                                               \
    WF_PROFILE_KEY(T, exponent, in, WF_DIM_NONE, NULL, 0, 1, "Of the power profile.", .absent = "0.16",      \
                   .example = "0.16"),                                                                       \
        WF_PROFILE_KEY(T, roughness, in, WF_DIM_LENGTH, "m", 1e-6, 10, "Of the log and canopy profiles.",    \
                       .absent = "0.03 m; canopy: 0.1 of its height", .example = "3 cm"),                    \
        WF_PROFILE_KEY(T, displacement, in, WF_DIM_LENGTH, "m", 0, 100, "Of the log and canopy profiles.",   \
                       .absent = "0 m; canopy: 0.7 of its height", .example = "0 m"),                        \
        WF_PROFILE_KEY(T, canopy_height, in, WF_DIM_LENGTH, "m", 0, 100,                                     \
                       "Of the stand around the tree, for the canopy profile.",                              \
                       .absent = "displacement / 0.7", .example = "12 m"),                                   \
        WF_PROFILE_KEY(T, attenuation, in, WF_DIM_NONE, NULL, 0, 10, "Of the wind inside the canopy.",       \
                       .absent = "joins the log law smoothly", .example = "2.5"),                            \
        { .key = "terrain",                                                                                  \
          .kind = WF_YAML_TEXT,                                                                              \
          .offset = offsetof(T, in.design.terrain),                                                          \
          .doc = "Ground the wind comes over, category 0, I, II, III or IV of EN 1991-1-4.",                 \
          .absent = "II, assumed; the wind is taken as it is named",                                         \
          .example = "III" },                                                                                \
        { .key = "site",                                                                                     \
          .kind = WF_YAML_TEXT,                                                                              \
          .offset = offsetof(T, in.site),                                                                    \
          .doc = "The same by what stands there: open, suburb, town, forest-edge, in-stand.",                \
          .absent = "not given",                                                                             \
          .example = "suburb" },                                                                             \
    {                                                                                                        \
        .key = "wind_at", .kind = WF_YAML_TEXT, .offset = offsetof(T, in.at),                                \
        .doc = "Where the winds are measured: open (10 m above open country) or site.",                      \
        .absent = "open, where terrain or site is given", .example = "site"                                  \
    }
/* Whether a number is given but the profile does not take it. Given: its member's offset in struct
 * wf_profile_words; `size` bytes for the reason in words, "with the profile 'log', which takes ...". */
bool wf_profile_unused(const struct wf_profile_words *w, size_t member, char *why, size_t size);
/* Set the scenario's profile, without reading a file. Errors: WF_EUSAGE where name and file do not go
 * together, or a number is given that the profile does not take. */
enum wf_status wf_scenario_words(struct wf_scenario *s, const struct wf_profile_words *w, struct wf_err *e);
/* Set the scenario's profile and, for a measured profile, read its file. Defaults of what is not given: the
 * power law, or "measured" where a file is given; for the canopy profile, d = 0.7 h and z0 = 0.1 h from the
 * canopy height h (Garratt 1992, The Atmospheric Boundary Layer, Cambridge University Press, sec. 4.3).
 * Errors: those of wf_scenario_words; WF_EINPUT with every mistake of the file in `d`;
 * WF_ENOMEM. */
enum wf_status wf_scenario_profile(struct wf_scenario *s, const struct wf_profile_words *w,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
/* Put the tree on ground whose heights are known: read the map, and find the exposure for the scenario's
 * azimuth, reference height and roughness. Given: file, x, y of *site; where north of the map is in the
 * model, clockwise from +y [rad]. Returned: site and speed_up of *s. Errors: those of wf_site_read and
 * wf_site_speed_up. */
enum wf_status wf_scenario_site(struct wf_scenario *s, struct wf_site *site, double north, struct wf_arena *a,
                                struct wf_err *e);
/* Turn the wind towards an azimuth [rad], with the exposure of the site in it. `north` as above. Errors:
 * those of wf_site_speed_up. */
enum wf_status wf_scenario_turn(struct wf_scenario *s, double azimuth, double north, struct wf_err *e);
/* Wind field of a checked scenario, with speed 0. */
void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out);
/* Wind speed at the tree at the reference height, given the named speed [m/s]: the named speed times
 * carried and speed_up. */
double wf_scenario_speed(const struct wf_scenario *s, double named);
/* The 3-s gust of a named 10-min mean, in the place where it is measured [m/s]. */
double wf_scenario_gust(const struct wf_scenario *s, double named);
/* 3-s gust over 10-min mean at the site at a height [m]: that of the named winds, changed as EN 1991-1-4
 * changes it with terrain and height; of a design wind the code's [-]. */
double wf_scenario_squall(const struct wf_scenario *s, double height);
/* Where the named winds are measured; by words, and of a scenario. The words are right. */
struct wf_wind_place wf_profile_place(const struct wf_profile_words *w);
struct wf_wind_place wf_scenario_place(const struct wf_scenario *s);
/* Loads on a tree of this species in still standard air (see wf_loads_default): its weight. Given: gravity
 * [m s-2]. Errors: WF_EINPUT for an unknown law. */
enum wf_status wf_scenario_still(const struct wf_species *sp, double gravity, struct wf_loads *loads,
                                 struct wf_err *e);
/* Loads of a checked scenario on a tree of this species: wind field (speed 0), air, gravity, drag laws.
 * Returned: *wind, and *loads, which points to *wind. Errors: as wf_scenario_still. */
enum wf_status wf_scenario_loads(const struct wf_scenario *s, const struct wf_species *sp,
                                 struct wf_wind *wind, struct wf_loads *loads, struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
