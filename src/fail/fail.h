/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_FAIL_H
#define WF_FAIL_FAIL_H
/* When a tree fails: forces and stresses in its sections, criteria of failure as rows, and the search for the
 * wind speed at which one is reached. */
#include "base/err.h"
#include "data/tree.h"
#include "solve/solve.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Index in wf_criteria; the first is reported as `critical`. */
enum wf_criterion_id {
    WF_BREAKAGE,
    WF_ELASTIC_LIMIT,
    WF_TORSION,
    WF_SPLITTING,
    WF_OVALISATION,
    WF_OVERTURNING,         /* with the anchorage as tested */
    WF_OVERTURNING_WET,     /* in saturated soil, with the higher */
    WF_OVERTURNING_WETTEST, /* and with the lower share of it */
    WF_CORRIDOR,            /* a part reaches a corridor beside the tree */
    WF_TIP_ANGLE,           /* the tip turns by more than a limit */
    WF_CRITERIA
};

/* ---- Forces and stresses in sections ---- */

/* Breakage: outer-fibre stress against the modulus of rupture, at both ends of every row and, where the
 * stress has its maximum inside a row (a slender top does not break at its base), there too. */

/* Forces and moments on a section, split along and across its axis, and its stresses. */
struct wf_section_load {
    double shear, axial, bending, torsion; /* [N], tension positive [N], [N m], [N m] */
    double stress;                         /* |M| r / I + |N| / A [Pa] */
    double compression;                    /* of the compressed side: |M| r / I - N / A [Pa] */
    double twist; /* shear stress of torsion at the outer fibre, |T| r / (2 I) [Pa] */
};

struct wf_breakage {
    size_t n;
    double *shear0, *shear1;     /* force across the axis [N] */
    double *axial0, *axial1;     /* along the axis, tension positive [N] */
    double *bending0, *bending1; /* bending moment (across the axis) [N m] */
    double *torsion0, *torsion1; /* moment about the axis [N m] */
    double *stress0, *stress1;   /* |M| r / I + |N| / A, thin or thick ring [Pa] */
    double *safety0, *safety1;   /* strength / stress [-]; INFINITY unstressed, NAN strength unknown */
    double *peak, *peak_place;   /* largest stress in the row [Pa]; 0 = at its base, 1 = at its end */
    double largest_stress;       /* [Pa] */
    int32_t largest_stress_row;
    /* By criterion of sections, stress over resistance at the place of each row where it is largest, and that
     * place: NAN where the resistance is not known; NULL where it is known of no row. */
    double *use[WF_CRITERIA], *use_place[WF_CRITERIA];
};
/* Section forces, stresses and safety factors of a solved tree. Given: tree and its response; `like` (NULL:
 * searched), whose places in each row are taken: those of a neighbouring response give its derivative without
 * the steps of a search, and the columns of the ends are left out (NULL). Returned: *out
 * with arrays of n in the arena. peak, peak_place and largest_stress include the inside of each row;
 * safety0/1 are those of its two ends. Method: inside a row the moment is the cubic that fits moments and
 * forces at both ends (dM/ds = -t x F), force and radii are linear; where the stress rises inwards from both
 * ends its maximum is searched. Source: elementary bending, Timoshenko 1955, Strength of Materials I. Valid
 * for sound, round stems; the stress is that of bending and axial force. The place of each criterion's
 * largest use is searched in the same way. Errors: WF_ENOMEM, WF_EINTERNAL (response of another tree). */
enum wf_status wf_breakage_check(const struct wf_tree *t, const struct wf_response *r,
                                 const struct wf_breakage *like, struct wf_arena *a, struct wf_breakage *out,
                                 struct wf_err *e);

/* Forces and moments of a response less those of the same tree at rest, turned with each section. Given: the
 * response and the state at rest. Returned: *out, in the arena; all but forces and moments of sections are
 * those of `r`. Use: stresses as strain gauges show them that were set to zero in place. Method: a section's
 * turn from the state at rest is that of the row's end it is on; at the ground, that of the axis. Errors:
 * WF_ENOMEM, WF_EINTERNAL (responses of different trees). */
enum wf_status wf_response_change(const struct wf_tree *t, const struct wf_response *rest,
                                  const struct wf_response *r, struct wf_arena *a, struct wf_response *out,
                                  struct wf_err *e);

/* Strength over stress [-]; INFINITY unstressed, NAN where the strength is not known. */
double wf_safety_factor(double strength, double stress);

/* Stresses at share s of row i, which is not a ring: lowest and highest of bending and axial force, tension
 * positive, and the largest shear stress of torsion [Pa]. Given: force and moment that the upper part exerts
 * on the section about the axis [N, N m], direction of the axis on the bent tree. Method: sigma = N/A + g.(p
 * - c) at every fibre p of the outline, with g by the tensor of second moments about the centroid c;
 * ellipses, rectangles and triangles by their principal axes, a triangle either way up; between two shapes
 * that are mixed the larger stress. Torsion of these at most T shorter side / J. The section turns as its
 * row's end. */
struct wf_fibre {
    double low, high, twist;
};
struct wf_fibre wf_fibre_stress(const struct wf_tree *t, const struct wf_response *r, size_t i, double s,
                                const double force[3], const double moment[3], const double axis[3]);

/* ---- Criteria ---- */

/* The place nearest to failure. Utilisation is 1 / safety. */
struct wf_worst {
    double safety; /* resistance over load [-]; INFINITY unloaded, NAN when no resistance is known */
    int32_t row;   /* -1 when none */
    double place;  /* 0 = at the row's base, 1 = at its end */
};

/* Failure criteria, one row each: load over resistance of a solved tree, in the whole tree, the stem alone
 * and the branches alone. A new criterion is a value of enum wf_criterion_id, a row in criterion.c and its
 * functions in a file of its own; search and results iterate over the rows. */

/* A criterion of a section: at place s of a row (0 = base, 1 = end) a stress is compared with a resistance.
 */
struct wf_section_rule {
    bool (*applies)(const struct wf_tree *t, size_t row); /* NULL: to every row */
    bool (*known)(const struct wf_tree *t, size_t row);   /* does it apply, with a known resistance? */
    double (*stress)(const struct wf_tree *t, size_t row, double s, const struct wf_section_load *l);
    double (*resistance)(const struct wf_tree *t, size_t row, double s);
};
enum wf_section_rule_id {
    WF_RULE_BENDING,     /* stress against modulus of rupture */
    WF_RULE_ELASTIC,     /* compression against compressive strength */
    WF_RULE_TORSION,     /* equivalent bending stress of bending and torsion against modulus of rupture */
    WF_RULE_SPLITTING,   /* nominal stress M / (pi R^2 t) of a thin wall against that which splits it */
    WF_RULE_OVALISATION, /* the same against that which flattens it */
    WF_SECTION_RULES
};
extern const struct wf_section_rule wf_section_rules[WF_SECTION_RULES];

/* A wall of this share of its mean radius, or thicker, bends as a whole. */
#define WF_THICK_WALL 0.3
/* Wall over mean radius of a hollow row at place s [-]. */
double wf_wall_share(const struct wf_tree *t, size_t row, double s);
/* Nominal bending stress at which a thin wall splits, sqrt(2/3 E_L f_T t/R), and at which it flattens
 * (Brazier), (2 sqrt 2 / 9) t/R sqrt(E_L E_T / (1 - nu_LT nu_TL)) [Pa]. Given: E_L, strength along the rings,
 * stiffness along the rings E_T / (1 - nu_LT nu_TL) [Pa]; wall over mean radius [-]. Derivation:
 * docs/failure.md. */
double wf_wall_splits(double youngs, double tangential, double share);
double wf_wall_flattens(double youngs, double transverse, double share);
/* From this distance between nodes on, over the outer diameter, the diaphragms of a culm count as nothing
 * [-]: judgement, not a measurement. */
#define WF_NODES_APART 3.0
/* How many times the stress splits or flattens the wall of a culm whose diaphragms hold the ring round [-].
 * Given: distance between nodes; E_L, E_T / (1 - nu_LT nu_TL), 0: not known [Pa]; outer radius and wall [m].
 * Method: a tube on the elastic foundation of its ring, held at both nodes and free to warp there; its reach
 * is shortened to that of WF_NODES_APART where it is longer. Never below 1. docs/failure.md. */
double wf_wall_held(double spacing, double youngs, double transverse, double radius, double thickness);

struct wf_criterion {
    const char *name, *source, *validity;
    const char *event; /* what a part does that fails by it: "breaks" */
    const char *wants; /* key of the species table by which the resistance is known; NULL: none */
    bool loses_tree;   /* the tree is lost where the stem fails by it, so that it can make the headline */
    double required;   /* safety that practice wants [-]; 0: 1 */
    bool whole;        /* of the whole tree: it belongs to the row of its root */
    bool shape;        /* of positions or turns, whose error is not that of sums of loads */
    const struct wf_section_rule *section; /* criterion of sections; NULL: of the whole tree */
    /* Where `section` is NULL: is the resistance of a row known? Ask wf_criterion_knows. */
    bool (*known)(const struct wf_tree *t, size_t row);
    /* The same for safety; ask wf_criterion_safety.
     * Given: tree, its response, its section forces and stresses, a row. Returned: resistance over load at
     * the place of the row nearest to failure, and that place (0 = the row's base, 1 = its end); NAN: no
     * resistance is known. A criterion of the whole tree belongs to the row of its root. */
    double (*safety)(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                     size_t row, double *place);
};
extern const struct wf_criterion wf_criteria[WF_CRITERIA];

/* The part of the tree whose result stands for a criterion: the stem; the whole tree where any part counts.
 */
enum wf_scope wf_criterion_scope(const struct wf_criterion *c);

/* Is the resistance of a row known? */
bool wf_criterion_knows(const struct wf_criterion *c, const struct wf_tree *t, size_t row);

/* Resistance over load of a row, and the place in it, as in struct wf_criterion. */
double wf_criterion_safety(const struct wf_criterion *c, const struct wf_tree *t, const struct wf_response *r,
                           const struct wf_breakage *b, size_t row, double *place);

/* Resistance at a place of a row: the stress that it bears [Pa]. NAN: of the whole tree, or no place. */
double wf_criterion_resistance(const struct wf_criterion *c, const struct wf_tree *t,
                               const struct wf_worst *at);

/* Does it apply to a row of a scope? Splitting and ovalisation are of thin walls alone. */
bool wf_criterion_applies(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope);

/* Is the resistance of at least one row of a scope known? */
bool wf_criterion_known(const struct wf_criterion *c, const struct wf_tree *t, enum wf_scope scope);

/* Evaluate every criterion in every scope. Given: tree, its response and section forces; response NULL where
 * no equilibrium was found. Returned: worst[criterion][scope]; without a response safety NAN and row -1. */
void wf_criteria_check(const struct wf_tree *t, const struct wf_response *r, const struct wf_breakage *b,
                       struct wf_worst (*worst)[WF_SCOPES]);

/* Functions of 'overturning', in fail/anchorage.c: is the anchorage known; the moment that the root carries
 * over that on the ground, as tested, and with what is left of it in saturated soil. */
bool wf_overturning_known(const struct wf_tree *t, size_t row);
double wf_overturning_safety(const struct wf_tree *t, const struct wf_response *r,
                             const struct wf_breakage *b, size_t row, double *place);
double wf_overturning_safety_wet(const struct wf_tree *t, const struct wf_response *r,
                                 const struct wf_breakage *b, size_t row, double *place);
double wf_overturning_safety_wettest(const struct wf_tree *t, const struct wf_response *r,
                                     const struct wf_breakage *b, size_t row, double *place);

/* ---- Anchorage of the root: fail/anchorage.c ---- */

struct wf_anchorage_method;
struct wf_tipping_curve; /* base moment by the inclination of the root plate, read from a file */
struct wf_anchorage_table;

/* What is said of soil and root; NULL, NAN: not given. */
struct wf_anchorage_request {
    const char *method;  /* row of wf_anchorage_methods; NULL: by size where the soil is known */
    const char *soil;    /* row of wf_soils */
    const char *rooting; /* "shallow", "medium" or "deep"; of a table */
    double pull_moment;  /* moment on the ground at 0.25 deg of the root plate [N m] */
    double secant;       /* that moment over that angle [N m rad-1] */
    const struct wf_tipping_curve *curve;
    const struct wf_anchorage_table *table;
    double carried; /* largest moment on the ground that a test put on the root, which stood it or failed by
                       it; 0: there was none [N m] */
    double grown;   /* height that the roots grew with, before the top was cut [m]; 0: the tree's */
    double lost;    /* share of the roots of a sector that is lost since [-] */
    double lost_middle, lost_half; /* the sector: where its middle lies, from +x towards +y, and half its
                                      width; pi: all around [rad] */
};

/* The reason where nothing is said of soil and root. */
#define WF_ANCHORAGE_UNSAID "soil and anchorage unknown"

/* The anchorage of one tree. */
struct wf_said;
struct wf_soil;
struct wf_anchorage {
    const struct wf_anchorage_method *method; /* NULL: overturning is not assessed */
    double moment; /* largest moment on the ground that the root carries, as tested or by size, before any of
                      it is lost [N m]; NAN */
    double by_method, carried;  /* the moment is the larger of the method's and of what a test put on the
                                   root, 0: nothing [N m] */
    double scatter;             /* standard deviation of its logarithm; NAN: not known */
    const char *text;           /* what it was computed from; or why overturning is not assessed */
    const struct wf_said *said; /* the same by parts (base/said.h); NULL: none */
    const struct wf_soil *soil; /* the kind of soil, where the moment is of trees whose soil is not known;
                                   NULL: the moment is of the soil that the tree stands in */
};

/* ---- Strength of branches ---- */

/* What branches bear over the clear wood of their stem: all strengths along the grain of a branch are at most
 * `factor` times those of clear stem wood. The modulus of rupture of the table stays where it is less, which
 * holds for thin branches; the knot factor of the stem does not enter. */
struct wf_branch_strength {
    const char *name, *text, *source;
    double factor; /* [-]; 1: as in the species table */
};
extern const struct wf_branch_strength wf_branch_strengths[]; /* end at name == NULL */

struct wf_species;
/* Limit the strength of the branches of a tree. Given: name of a row, NULL: over-bark, inside-bark
 * where the tree's bark is taken off; full for a table or a
 * preset that repeats a publication. Returned: the row used. */
const struct wf_branch_strength *wf_branches_limit(const char *name, const struct wf_species *sp,
                                                   struct wf_tree *t);

/* ---- Critical wind speed ---- */

/* Critical wind speed: the lowest speed at which a criterion (load / resistance) reaches 1. */

enum wf_critical_outcome {
    WF_CRITICAL_FOUND,
    WF_CRITICAL_ABOVE,       /* criterion stays below 1 up to the highest speed searched */
    WF_CRITICAL_SELF_WEIGHT, /* fails without wind */
    WF_CRITICAL_NO_STRENGTH, /* no row has a modulus of rupture */
    WF_CRITICAL_UNSOLVED,    /* no equilibrium was found above `speed_low`: the bracket is reported */
    WF_CRITICAL_UNSEARCHED,  /* not searched for; it is not below `speed_low` */
    WF_CRITICAL_INTERRUPTED  /* not searched for, or not to the end: the run was interrupted */
};
struct wf_critical {
    enum wf_critical_outcome outcome;
    double speed;                 /* [m/s]; NAN unless found */
    double speed_low, speed_high; /* bracket at the end, or range searched [m/s] */
    double gradient;              /* d criterion / d speed at `speed` [s/m] */
    size_t evaluations;
};
/* Search for the critical wind speed. Given: criterion(ctx, speed [m/s], &value) returning WF_OK, WF_ENOCONV
 * or WF_EUNSTABLE where no equilibrium exists, or another error, which ends the search and is returned;
 * highest speed [m/s]; relative tolerance on the speed. A value that is not a number at speed 0 means that
 * no strength is known. Returned: WF_OK and *out, whatever the outcome; WF_EUSAGE, WF_ENOMEM, WF_EINTERNAL
 * (not a number in wind). Method: steps of 3.125 m/s from 0 to speed_max (longer above 250 m/s) until the
 * criterion reaches 1 or no equilibrium is found, so that the lowest crossing is found where crossings are
 * more than a step apart; then Brent's method (GSL) until evaluations on both sides confirm a bracket within
 * the tolerance. Where no equilibrium is found, bisection towards the highest speed that has one; a crossing
 * found on the way takes precedence. */
enum wf_status
wf_critical_search(enum wf_status (*criterion)(void *ctx, double speed, double *value, struct wf_err *e),
                   void *ctx, double speed_max, double tolerance, struct wf_critical *out, struct wf_err *e);
/* Number of these steps, at most WF_CRITICAL_RUNGS_MAX, and speed of the k-th, k = 0 .. the number [m/s]. A
 * caller with several processors may evaluate some of them in parallel before the search. */
enum { WF_CRITICAL_RUNGS_MAX = 80 };
int wf_critical_rungs(double speed_max);
double wf_critical_rung(double speed_max, int k);
/* The outcome in words, for reports. */
const char *wf_critical_text(enum wf_critical_outcome o);

#ifdef __cplusplus
}
#endif
#endif
