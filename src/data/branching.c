/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/branching.h"
#include "base/num.h"
#include "data/value.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Where on its parent a branch stands: schema of places, directions and angles. */

#define AT(member) .offset = offsetof(struct wf_branching, member)
#define ANGLE(l, h)                                                                                          \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_ANGLE, .unit = "deg", .low = (l)*WF_TURN,                  \
    .high = (h)*WF_TURN
#define NUMBER(l, h) .kind = WF_YAML_QUANTITY, .low = (l), .high = (h)
#define NUMBERS(l, h) .kind = WF_YAML_QUANTITIES, .low = (l), .high = (h)

static const char *const azimuth_words[] = { "spiral", "whorl", "planar", "random", NULL };

static const struct wf_yaml_row place_rows[] = {
    { .key = "from",
      NUMBER(0, 1),
      .initial = "0.1",
      AT(from),
      .doc = "Lowest place on the parent, 0 = its base.",
      .example = "0.4" },
    { .key = "to",
      NUMBER(0, 1),
      .initial = "1",
      AT(to),
      .doc = "Highest place on the parent, 1 = its tip.",
      .example = "0.95" },
    { .key = "count",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 100000,
      .absent = "see spacing, at",
      AT(count),
      .doc = "Places on each parent, evenly from the lowest to the highest. One of count, spacing and at is "
             "needed.",
      .example = "12" },
    { .key = "spacing",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_LENGTH,
      .unit = "m",
      .low = 1e-3,
      .high = 100,
      .absent = "see count, at",
      AT(spacing),
      .doc =
          "Distance between neighbouring places, from the lowest up: the interval of whorls, the internode.",
      .example = "0.4 m" },
    { .key = "at",
      NUMBERS(0, 1),
      .absent = "see count, spacing",
      AT(at),
      .count = offsetof(struct wf_branching, places),
      .doc = "The places themselves, ascending.",
      .example = "[0.4, 0.6, 0.8]" },
    { .key = "per_whorl",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 100,
      .initial = "1",
      AT(per_whorl),
      .doc = "Branches at one place, evenly round the parent.",
      .example = "4" },
    { .key = "spread",
      NUMBER(0, 1),
      .initial = "0",
      AT(place_spread),
      .doc = "Random shift along the parent: standard deviation as a share of the distance "
             "between neighbouring places.",
      .example = "0.1" },
    { .key = NULL },
};

static void place_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    int ways = wf_yaml_has(y, "count") + wf_yaml_has(y, "spacing") + wf_yaml_has(y, "at");
    if (ways > 1)
        wf_yaml_error(y, "", "more than one of count, spacing and at; exactly one says where branches stand");
    if (b->from >= b->to && !wf_yaml_has(y, "at") && b->count != 1)
        wf_yaml_error(y, "from", "%g is not below 'to', %g", b->from, b->to);
    if (b->at) wf_value_ascending(y, "at", b->places, b->at);
}
static const struct wf_yaml_table place_table = {
    .title = "places", .row = place_rows, .finish = place_finish, .doc = ""
};

static const struct wf_yaml_row azimuth_rows[] = {
    { .key = "rule",
      .kind = WF_YAML_ENUM,
      .initial = "spiral",
      .choices = azimuth_words,
      AT(azimuth),
      .doc = "spiral: each place turned by the divergence from the one below (phyllotaxis); whorl: whorls of "
             "per_whorl branches, the next in the gaps of the last; planar: to both sides in turn; random.",
      .example = "spiral" },
    { .key = "divergence",
      ANGLE(-1, 1),
      .absent = "spiral: 137.5 deg; whorl: half the angle between "
                "neighbours; not used by the others",
      AT(divergence),
      .doc = "Turn from one place to the next.",
      .example = "137.5 deg" },
    { .key = "start",
      ANGLE(-1, 1),
      .absent = "planar: 90 deg; else 0 deg",
      AT(azimuth_start),
      .doc = "Direction of the first branch, about the parent's axis from its upper side (from the direction "
             "of its lean, or +x, on a vertical axis).",
      .example = "0 deg" },
    { .key = "spread",
      ANGLE(0, 0.5),
      .initial = "0 deg",
      AT(azimuth_spread),
      .doc = "Standard deviation of each direction.",
      .example = "10 deg" },
    { .key = NULL },
};

static void azimuth_finish(struct wf_yaml *y, void *branching)
{
    struct wf_branching *b = branching;
    bool turned = b->azimuth == WF_AZIMUTH_SPIRAL || b->azimuth == WF_AZIMUTH_WHORL;
    if (!turned && wf_yaml_has(y, "divergence"))
        wf_yaml_error(y, "divergence", "is not used by rule '%s'", azimuth_words[b->azimuth]);
    if (isnan(b->azimuth_start)) b->azimuth_start = b->azimuth == WF_AZIMUTH_PLANAR ? WF_TURN / 4 : 0;
    if (isnan(b->divergence) && b->azimuth == WF_AZIMUTH_SPIRAL) b->divergence = 137.5 / 360 * WF_TURN;
}
static const struct wf_yaml_table azimuth_table = {
    .title = "directions", .row = azimuth_rows, .finish = azimuth_finish, .doc = ""
};

static const struct wf_yaml_row insertion_rows[] = {
    { .key = "angle",
      ANGLE(0, 0.5),
      .absent = "see at, angles",
      AT(insertion),
      .doc = "Between the parent's axis and the branch where it starts.",
      .example = "60 deg" },
    { .key = "at",
      NUMBERS(0, 1),
      AT(insertion_along.s),
      .count = offsetof(struct wf_branching, insertion_along.n),
      .absent = "the same angle everywhere",
      .doc = "Places along the parent, 0 = its base, 1 = its tip, ascending.",
      .example = "[0, 1]" },
    { .key = "angles",
      .kind = WF_YAML_QUANTITIES,
      .dimension = WF_DIM_ANGLE,
      .unit = "deg",
      .low = 0,
      .high = 0.5 * WF_TURN,
      .same_length_as = "at",
      AT(insertion_along.v),
      .count = offsetof(struct wf_branching, insertion_along.n),
      .absent = "the same angle everywhere",
      .doc = "Angle at these places, linear between, constant outside.",
      .example = "[90 deg, 40 deg]" },
    { .key = "spread",
      ANGLE(0, 0.25),
      .initial = "0 deg",
      AT(insertion_spread),
      .doc = "Standard deviation of each angle.",
      .example = "5 deg" },
    { .key = NULL },
};

static void insertion_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    if (wf_yaml_has(y, "angle") && wf_yaml_has(y, "angles"))
        wf_yaml_error(y, "angles", "is not used beside 'angle'");
    if (wf_yaml_has(y, "at") != wf_yaml_has(y, "angles"))
        wf_yaml_error(y, "", "'at' and 'angles' go together");
    if (b->insertion_along.s) wf_value_ascending(y, "at", b->insertion_along.n, b->insertion_along.s);
}
static const struct wf_yaml_table insertion_table = {
    .title = "an insertion", .row = insertion_rows, .finish = insertion_finish, .doc = ""
};

/* Leaves of a branched model. */

#define FOLIAGE(member) .offset = offsetof(struct wf_foliage, member)

static const struct wf_yaml_row foliage_rows[] = {
    { .key = "area",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_AREA,
      .unit = "m2",
      .low = 0,
      .high = 1e5,
      FOLIAGE(area),
      .doc = "One-sided leaf area of the whole tree with its leaves on.",
      .example = "17 m2" },
    { .key = "levels",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = WF_BRANCH_LEVELS_MAX,
      .initial = "1",
      FOLIAGE(levels),
      .doc = "How many of the last levels bear leaves, the same area on every length of them.",
      .example = "1" },
    { .key = "from",
      NUMBER(0, 1),
      .initial = "0",
      FOLIAGE(from),
      .doc = "Where on these axes the leaves begin.",
      .example = "0.2" },
    { .key = "to", NUMBER(0, 1), .initial = "1", FOLIAGE(to), .doc = "Where they end.", .example = "1" },
    { .key = "count",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 10000000,
      .absent = "leaves only spread out",
      FOLIAGE(count),
      .doc = "Leaves, or clusters of leaves, placed one by one; they share the area.",
      .example = "800" },
    { .key = "tilt",
      ANGLE(0, 0.5),
      .initial = "45 deg",
      FOLIAGE(tilt),
      .doc = "Between the axis and a leaf.",
      .example = "45 deg" },
    { .key = "scatter",
      ANGLE(0, 0.25),
      .initial = "0 deg",
      FOLIAGE(scatter),
      .doc = "Standard deviation of the angles of each leaf.",
      .example = "15 deg" },
    { .key = "size_spread",
      NUMBER(0, 1),
      .initial = "0",
      FOLIAGE(size_spread),
      .doc = "Standard deviation of the logarithm of the leaves' size; the area is kept.",
      .example = "0.2" },
    { .key = "swing",
      ANGLE(0, 0.5),
      .initial = "0 deg",
      FOLIAGE(swing),
      .doc =
          "Turn of a leaf about its hanging point in a wind of 10 m/s; grows with the wind (Tang and others "
          "2012, equation 13).",
      .example = "20 deg" },
    { .key = "twist",
      ANGLE(0, 0.5),
      .initial = "0 deg",
      FOLIAGE(twist),
      .doc = "The same about the vertical.",
      .example = "10 deg" },
    { .key = NULL },
};

static void finish(struct wf_yaml *y, void *foliage)
{
    const struct wf_foliage *f = foliage;
    if (f->from >= f->to) wf_yaml_error(y, "from", "%g is not below 'to', %g", f->from, f->to);
}
const struct wf_yaml_table wf_foliage_table = {
    .title = "leaves", .row = foliage_rows, .finish = finish, .doc = ""
};

#define LENGTH(l, h)                                                                                         \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_LENGTH, .unit = "m", .low = (l), .high = (h)
#define SPREAD(member, what)                                                                                 \
    {                                                                                                        \
        .key = "spread", NUMBER(0, 1), .initial = "0", AT(member), .doc = what, .example = "0.1"             \
    }
/* A factor that changes along the parent. */
#define ALONG(member)                                                                                        \
    { .key = "at",                                                                                           \
      NUMBERS(0, 1),                                                                                         \
      AT(member.s),                                                                                          \
      .count = offsetof(struct wf_branching, member.n),                                                      \
      .absent = "the same everywhere",                                                                       \
      .doc = "Places along the parent, 0 = its base, 1 = its tip, ascending.",                               \
      .example = "[0, 0.5, 1]" },                                                                            \
    {                                                                                                        \
        .key = "share", NUMBERS(0, 10), .same_length_as = "at", AT(member.v),                                \
        .count = offsetof(struct wf_branching, member.n), .absent = "the same everywhere",                   \
        .doc = "Further factor at these places, linear between, constant outside.",                          \
        .example = "[1, 0.9, 0.2]"                                                                           \
    }

static const char *const length_words[] = { "absolute", "parent", "rest", NULL };
const char *const wf_radius_words[] = { "parent", "species", "absolute", "length", "pipe", NULL };

static void course(struct wf_yaml *y, const struct wf_along *along)
{
    if (wf_yaml_has(y, "at") != wf_yaml_has(y, "share")) wf_yaml_error(y, "", "'at' and 'share' go together");
    if (along->s && along->v) wf_value_ascending(y, "at", along->n, along->s);
}

static const struct wf_yaml_row length_rows[] = {
    { .key = "law",
      .kind = WF_YAML_ENUM,
      .required = true,
      .choices = length_words,
      AT(length_law),
      .doc =
          "absolute: `value`; parent: the parent's length; rest: the parent's length above the branch. All "
          "times factor and share.",
      .example = "absolute" },
    { .key = "value",
      LENGTH(1e-3, 100),
      .absent = "needed by law absolute, refused by the others",
      AT(length),
      .doc = "Length along the branch.",
      .example = "2 m" },
    { .key = "factor",
      NUMBER(1e-3, 10),
      .initial = "1",
      AT(length_factor),
      .doc = "Multiplies the law.",
      .example = "0.6" },
    ALONG(length_along),
    SPREAD(length_spread, "Standard deviation of the logarithm of the length."),
    { .key = "shortest",
      LENGTH(1e-3, 10),
      .initial = "10 mm",
      AT(shortest),
      .doc = "Branches that would be shorter do not grow.",
      .example = "50 mm" },
    { .key = NULL },
};

static void length_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    const char *law = wf_yaml_raw(y, "law");
    bool absolute = b->length_law == WF_LENGTH_ABSOLUTE, has = wf_yaml_has(y, "value");
    if (law && absolute && !has) wf_yaml_error(y, "", "law 'absolute' needs the key 'value'");
    if (law && !absolute && has) wf_yaml_error(y, "value", "is not used by law '%s'", law);
    course(y, &b->length_along);
}
static const struct wf_yaml_table length_table = {
    .title = "a length", .row = length_rows, .finish = length_finish, .doc = ""
};

static const struct wf_yaml_row radius_rows[] = {
    { .key = "law",
      .kind = WF_YAML_ENUM,
      .required = true,
      .choices = wf_radius_words,
      AT(radius_law),
      .doc =
          "Radius at the branch's base. parent: the parent's radius there; species: that of the species' "
          "level; absolute: `value`; length: value (length / 1 m)^exponent; pipe: every radius to the power "
          "`exponent` is the sum of those above, from tips of radius `value` (Shinozaki and others 1964). "
          "All "
          "but pipe times factor and share, and not above the parent's radius.",
      .example = "parent" },
    { .key = "value",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_LENGTH,
      .unit = "mm",
      .low = 1e-4,
      .high = 5,
      .absent = "needed by laws absolute, length and pipe, refused by the others",
      AT(radius),
      .doc = "Radius: of the base; of a branch 1 m long; of the tips.",
      .example = "20 mm" },
    { .key = "exponent",
      NUMBER(0.2, 4),
      .absent = "length: 1.5 (elastic similarity, McMahon and Kronauer 1976); "
                "pipe: 2; refused by the others",
      AT(radius_exponent),
      .doc = "Exponent of laws length and pipe.",
      .example = "2" },
    { .key = "factor",
      NUMBER(1e-3, 10),
      .initial = "1",
      AT(radius_factor),
      .doc = "Multiplies the law.",
      .example = "0.5" },
    ALONG(radius_along),
    SPREAD(radius_spread, "Standard deviation of the logarithm of the radius."),
    { .key = NULL },
};

static void radius_finish(struct wf_yaml *y, void *branching)
{
    struct wf_branching *b = branching;
    const char *law = wf_yaml_raw(y, "law");
    bool pipe = b->radius_law == WF_RADIUS_PIPE, power = pipe || b->radius_law == WF_RADIUS_LENGTH,
         valued = power || b->radius_law == WF_RADIUS_ABSOLUTE, has = wf_yaml_has(y, "value");
    static const char *const others[] = { "factor", "at", "share", "spread" };
    if (law && valued && !has) wf_yaml_error(y, "", "law '%s' needs the key 'value'", law);
    if (law && !valued && has) wf_yaml_error(y, "value", "is not used by law '%s'", law);
    if (law && !power && wf_yaml_has(y, "exponent"))
        wf_yaml_error(y, "exponent", "is not used by law '%s'", law);
    for (size_t k = 0; pipe && k < WF_COUNT(others); k++)
        if (wf_yaml_has(y, others[k])) wf_yaml_error(y, others[k], "is not used by law 'pipe'");
    if (power && !wf_yaml_has(y, "exponent")) b->radius_exponent = pipe ? 2 : 1.5;
    course(y, &b->radius_along);
}
static const struct wf_yaml_table radius_table = {
    .title = "a radius", .row = radius_rows, .finish = radius_finish, .doc = ""
};

static const struct wf_yaml_row taper_rows[] = {
    { .key = "tip_share",
      NUMBER(1e-3, 1),
      .initial = "0.3",
      AT(tip_share),
      .doc = "Radius at the tip over that at the base, t in t + (1 - t) (1 - s)^p.",
      .example = "0.3" },
    { .key = "power",
      NUMBER(0.1, 5),
      .initial = "1",
      AT(taper_power),
      .doc = "p: 1 is a cone.",
      .example = "1" },
    { .key = NULL },
};
static const struct wf_yaml_table taper_table = { .title = "a taper", .row = taper_rows, .doc = "" };

#define CURVE(member) .offset = offsetof(struct wf_curve, member)
static const struct wf_yaml_row curve_rows[] = {
    { .key = "turn",
      ANGLE(-0.5, 0.5),
      .initial = "0 deg",
      CURVE(turn),
      .doc = "Whole turn towards the vertical, shared evenly by the angles between successive segments: "
             "positive rises, negative droops; it ends where the axis is vertical.",
      .example = "-30 deg" },
    { .key = "from",
      NUMBER(0, 1),
      .initial = "0",
      CURVE(from),
      .doc = "Where on the axis the turn begins.",
      .example = "0" },
    { .key = "to", NUMBER(0, 1), .initial = "1", CURVE(to), .doc = "Where it ends.", .example = "0.5" },
    { .key = "wander",
      ANGLE(0, 0.25),
      .initial = "0 deg",
      CURVE(wander),
      .doc = "Standard deviation of the whole random turn to any side.",
      .example = "10 deg" },
    { .key = NULL },
};

static void curve_finish(struct wf_yaml *y, void *curve)
{
    const struct wf_curve *c = curve;
    if (c->from >= c->to) wf_yaml_error(y, "from", "%g is not below 'to', %g", c->from, c->to);
}
const struct wf_yaml_table wf_curve_table = {
    .title = "a curve", .row = curve_rows, .finish = curve_finish, .doc = ""
};

#define PART(k, t, what) .key = k, .kind = WF_YAML_TABLE, .table = &(t), .doc = what
static const struct wf_yaml_row branching_rows[] = {
    { .key = "name",
      .kind = WF_YAML_TEXT,
      AT(name),
      .absent = "no name",
      .doc = "Name for people.",
      .example = "first order" },
    { PART("place", place_table, "Where on each parent the branches stand."), .required = true },
    { PART("azimuth", azimuth_table, "To which side of the parent they go."), .absent = "a spiral" },
    { PART("insertion", insertion_table, "At which angle they leave it."), .required = true,
      .example = "{angle: 60 deg}" },
    { PART("length", length_table, "How long they are."), .required = true,
      .example = "{law: parent, factor: 0.5}" },
    { PART("radius", radius_table, "How thick they are."), .required = true,
      .example = "{law: parent, factor: 0.5}" },
    { PART("taper", taper_table, "How they get thinner."), .absent = "a cone to 0.3 of the base radius" },
    { .key = "segments",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 1000,
      .initial = "5",
      AT(segments),
      .doc = "Straight pieces of equal length of each branch; a row also ends where a branch of the next "
             "level stands. Places are rounded to a tenth of a piece.",
      .example = "5" },
    { PART("curve", wf_curve_table, "The angle between successive pieces."), AT(curve),
      .absent = "straight" },
    { .key = NULL },
};

static void schema_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    if (wf_yaml_has(y, "place") && !wf_yaml_has(y, "place.count") && !wf_yaml_has(y, "place.spacing") &&
        !wf_yaml_has(y, "place.at"))
        wf_yaml_error(y, "place", "none of count, spacing and at; exactly one says where branches stand");
    if (wf_yaml_has(y, "insertion") && !wf_yaml_has(y, "insertion.angle") &&
        !wf_yaml_has(y, "insertion.at") && !wf_yaml_has(y, "insertion.angles"))
        wf_yaml_error(y, "insertion", "either 'angle', or 'at' with 'angles' is needed");
    if (b->radius_law == WF_RADIUS_PIPE && wf_yaml_has(y, "taper"))
        wf_yaml_error(y, "taper", "is not used by radius law 'pipe'");
}
const struct wf_yaml_table wf_branching_table = {
    .title = "a branching level",
    .row = branching_rows,
    .size = sizeof(struct wf_branching),
    .finish = schema_finish,
    .doc = "",
};
