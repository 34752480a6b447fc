/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/branching.h"
#include "base/num.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Where a branch starts on its parent: places, directions and angles. */

#define T struct wf_branching

static const char *const azimuth_words[] = { "spiral", "whorl", "planar", "random", NULL };

static const struct wf_yaml_row place_rows[] = {
    WF_KEY_NUMBER("from", from, 0, 1, "Lowest place on the parent, 0 = its base.", .initial = "0.1",
                  .example = "0.4"),
    WF_KEY_NUMBER("to", to, 0, 1, "Highest place on the parent, 1 = its tip.", .initial = "1",
                  .example = "0.95"),
    WF_KEY_INTEGER("count", count, 1, 100000,
                   "Places on each parent, evenly from the lowest to the highest. One of count, spacing and "
                   "at is needed.",
                   .absent = "see spacing, at", .example = "12"),
    WF_KEY_LENGTH(
        "spacing", spacing, "m", 1e-3, 100,
        "Distance between neighbouring places, from the lowest up: the interval of whorls, the internode.",
        .absent = "see count, at", .example = "0.4 m"),
    WF_KEY_NUMBERS("at", at, places, 0, 1, "The places themselves, ascending.",
                   .absent = "see count, spacing", .example = "[0.4, 0.6, 0.8]"),
    WF_KEY_INTEGER("per_whorl", per_whorl, 1, 100, "Branches at one place, evenly round the parent.",
                   .initial = "1", .example = "4"),
    WF_KEY_NUMBER("spread", place_spread, 0, 1,
                  "Random shift along the parent: standard deviation as a share of the distance between "
                  "neighbouring places.",
                  .initial = "0", .example = "0.1"),
    { .key = NULL },
};

static void place_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    int ways = wf_yaml_has(y, "count") + wf_yaml_has(y, "spacing") + wf_yaml_has(y, "at");
    if (ways > 1) wf_yaml_error(y, "", "more than one of count, spacing and at; give exactly one of them");
    if (b->from >= b->to && !wf_yaml_has(y, "at") && b->count != 1)
        wf_yaml_error(y, "from", "%g is not below 'to', %g", b->from, b->to);
    if (b->at) wf_yaml_ascending(y, "at", b->places, b->at);
}

static const struct wf_yaml_table place_table = {
    .title = "places", .row = place_rows, .finish = place_finish, .doc = ""
};

static const struct wf_yaml_row azimuth_rows[] = {
    WF_KEY_ENUM("rule", azimuth, azimuth_words,
                "spiral: each place turned by the divergence from the one below (phyllotaxis); whorl: whorls "
                "of per_whorl branches, each turned into the gaps of the one below; planar: alternating "
                "between the two sides; random.",
                .initial = "spiral", .example = "spiral"),
    WF_KEY_ANGLE("divergence", divergence, -1, 1, "Turn from one place to the next.",
                 .absent =
                     "spiral: 137.5 deg; whorl: half the angle between neighbours; not used by the others",
                 .example = "137.5 deg"),
    WF_KEY_ANGLE("start", azimuth_start, -1, 1,
                 "Direction of the first branch, about the parent's axis from its upper side (from the "
                 "direction of its lean, or +x, on a vertical axis).",
                 .absent = "planar: 90 deg; else 0 deg", .example = "0 deg"),
    WF_KEY_ANGLE("spread", azimuth_spread, 0, 0.5, "Standard deviation of each direction.",
                 .initial = "0 deg", .example = "10 deg"),
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
    WF_KEY_ANGLE("angle", insertion, 0, 0.5, "Between the parent's axis and the branch where it starts.",
                 .absent = "see at, angles", .example = "60 deg"),
    WF_KEY_NUMBERS("at", insertion_along.s, insertion_along.n, 0, 1,
                   "Places along the parent, 0 = its base, 1 = its tip, ascending.",
                   .absent = "the same angle everywhere", .example = "[0, 1]"),
    WF_KEY_NUMBERS("angles", insertion_along.v, insertion_along.n, 0, 0.5 * WF_TURN,
                   "Angle at these places, linear between, constant outside.", .dimension = WF_DIM_ANGLE,
                   .unit = "deg", .same_length_as = "at", .absent = "the same angle everywhere",
                   .example = "[90 deg, 40 deg]"),
    WF_KEY_ANGLE("spread", insertion_spread, 0, 0.25, "Standard deviation of each angle.", .initial = "0 deg",
                 .example = "5 deg"),
    { .key = NULL },
};

static void insertion_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    if (wf_yaml_has(y, "angle") && wf_yaml_has(y, "angles"))
        wf_yaml_error(y, "angles", "is not used beside 'angle'");
    if (wf_yaml_has(y, "at") != wf_yaml_has(y, "angles"))
        wf_yaml_error(y, "", "'at' and 'angles' go together");
    if (b->insertion_along.s) wf_yaml_ascending(y, "at", b->insertion_along.n, b->insertion_along.s);
}

static const struct wf_yaml_table insertion_table = {
    .title = "an insertion", .row = insertion_rows, .finish = insertion_finish, .doc = ""
};

/* Length and radius. */

/* A factor that changes along the parent. */
#define ALONG(member)                                                                                        \
    WF_KEY_NUMBERS("at", member.s, member.n, 0, 1,                                                           \
                   "Places along the parent, 0 = its base, 1 = its tip, ascending.",                         \
                   .absent = "the same everywhere", .example = "[0, 0.5, 1]"),                               \
        WF_KEY_NUMBERS("share", member.v, member.n, 0, 10,                                                   \
                       "Further factor at these places, linear between, constant outside.",                  \
                       .same_length_as = "at", .absent = "the same everywhere", .example = "[1, 0.9, 0.2]")
#define SPREAD(member, what) WF_KEY_NUMBER("spread", member, 0, 1, what, .initial = "0", .example = "0.1")

static const char *const length_words[] = { "absolute", "parent", "rest", NULL };
const char *const wf_radius_words[] = { "parent", "species", "absolute", "length", "pipe", NULL };

static void along_finish(struct wf_yaml *y, const struct wf_along *along)
{
    if (wf_yaml_has(y, "at") != wf_yaml_has(y, "share")) wf_yaml_error(y, "", "'at' and 'share' go together");
    if (along->s && along->v) wf_yaml_ascending(y, "at", along->n, along->s);
}

static const struct wf_yaml_row length_rows[] = {
    WF_KEY_ENUM("law", length_law, length_words,
                "absolute: `value`; parent: the parent's length; rest: the parent's length above the branch. "
                "All times factor and share.",
                .required = true, .example = "absolute"),
    WF_KEY_LENGTH("value", length, "m", 1e-3, 100, "Length along the branch.",
                  .absent = "needed by law absolute, refused by the others", .example = "2 m"),
    WF_KEY_NUMBER("factor", length_factor, 1e-3, 10, "Multiplies the law.", .initial = "1", .example = "0.6"),
    ALONG(length_along),
    SPREAD(length_spread, "Standard deviation of the logarithm of the length."),
    WF_KEY_LENGTH("shortest", shortest, "m", 1e-3, 10, "Least length; shorter branches are omitted.",
                  .initial = "10 mm", .example = "50 mm"),
    { .key = NULL },
};

static void length_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    const char *law = wf_yaml_raw(y, "law");
    bool absolute = b->length_law == WF_LENGTH_ABSOLUTE, has = wf_yaml_has(y, "value");
    if (law && absolute && !has) wf_yaml_error(y, "", "law 'absolute' needs the key 'value'");
    if (law && !absolute && has) wf_yaml_error(y, "value", "is not used by law '%s'", law);
    along_finish(y, &b->length_along);
}

static const struct wf_yaml_table length_table = {
    .title = "a length", .row = length_rows, .finish = length_finish, .doc = ""
};

static const struct wf_yaml_row radius_rows[] = {
    WF_KEY_ENUM(
        "law", radius_law, wf_radius_words,
        "Radius at the branch's base. parent: the parent's radius there; species: that of the species' "
        "level; absolute: `value`; length: value (length / 1 m)^exponent; pipe: every radius to the power "
        "`exponent` is the sum of those above, from tips of radius `value` (Shinozaki and others 1964). All "
        "but pipe times factor and share, and not above the parent's radius.",
        .required = true, .example = "parent"),
    WF_KEY_LENGTH("value", radius, "mm", 1e-4, 5, "Radius: of the base; of a branch 1 m long; of the tips.",
                  .absent = "needed by laws absolute, length and pipe, refused by the others",
                  .example = "20 mm"),
    WF_KEY_NUMBER(
        "exponent", radius_exponent, 0.2, 4, "Exponent of laws length and pipe.",
        .absent =
            "length: 1.5 (elastic similarity, McMahon and Kronauer 1976); pipe: 2; refused by the others",
        .example = "2"),
    WF_KEY_NUMBER("factor", radius_factor, 1e-3, 10, "Multiplies the law.", .initial = "1", .example = "0.5"),
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
    along_finish(y, &b->radius_along);
}

static const struct wf_yaml_table radius_table = {
    .title = "a radius", .row = radius_rows, .finish = radius_finish, .doc = ""
};

static const struct wf_yaml_row branch_taper_rows[] = {
    WF_KEY_NUMBER("tip_share", tip_share, 1e-3, 1,
                  "Radius at the tip over that at the base, t in t + (1 - t) (1 - s)^p.", .initial = "0.3",
                  .example = "0.3"),
    WF_KEY_NUMBER("power", taper_power, 0.1, 5, "p: 1 is a cone.", .initial = "1", .example = "1"),
    { .key = NULL },
};

static const struct wf_yaml_table branch_taper_table = { .title = "a taper",
                                                         .row = branch_taper_rows,
                                                         .doc = "" };

#undef T
#define T struct wf_curve

/* Curvature of an axis. */

static const struct wf_yaml_row curve_rows[] = {
    WF_KEY_ANGLE("turn", turn, -0.5, 0.5,
                 "Whole turn towards the vertical, shared evenly by the angles between successive segments: "
                 "positive rises, negative droops; it ends where the axis is vertical.",
                 .initial = "0 deg", .example = "-30 deg"),
    WF_KEY_NUMBER("from", from, 0, 1, "Where on the axis the turn begins.", .initial = "0", .example = "0"),
    WF_KEY_NUMBER("to", to, 0, 1, "Where it ends.", .initial = "1", .example = "0.5"),
    WF_KEY_ANGLE("wander", wander, 0, 0.25, "Standard deviation of the whole random turn to any side.",
                 .initial = "0 deg", .example = "10 deg"),
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

#undef T
#define T struct wf_branching

/* The level as a whole. */

static const struct wf_yaml_row branching_rows[] = {
    WF_KEY_TEXT("name", name, "Readable name.", .absent = "no name", .example = "first order"),
    WF_KEY_PART("place", place_table, "Where on each parent the branches stand.", .required = true),
    WF_KEY_PART("azimuth", azimuth_table, "Direction of the branches about the parent's axis.",
                .absent = "a spiral"),
    WF_KEY_PART("insertion", insertion_table, "Angle between the parent's axis and the branch.",
                .required = true, .example = "{angle: 60 deg}"),
    WF_KEY_PART("length", length_table, "How long they are.", .required = true,
                .example = "{law: parent, factor: 0.5}"),
    WF_KEY_PART("radius", radius_table, "How thick they are.", .required = true,
                .example = "{law: parent, factor: 0.5}"),
    WF_KEY_PART("taper", branch_taper_table, "Taper of the branches.",
                .absent = "a cone to 0.3 of the base radius"),
    WF_KEY_INTEGER("segments", segments, 1, 1000,
                   "Straight pieces of equal length of each branch; a row also ends where a branch of the "
                   "next level stands. Places are rounded to a tenth of a piece.",
                   .initial = "5", .example = "5"),
    WF_KEY_PART("curve", wf_curve_table, "The angle between successive pieces.", .absent = "straight",
                .offset = offsetof(T, curve)),
    { .key = NULL },
};

static void branching_finish(struct wf_yaml *y, void *branching)
{
    const struct wf_branching *b = branching;
    if (wf_yaml_has(y, "place") && !wf_yaml_has(y, "place.count") && !wf_yaml_has(y, "place.spacing") &&
        !wf_yaml_has(y, "place.at"))
        wf_yaml_error(y, "place", "none of count, spacing and at; give exactly one of them");
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
    .finish = branching_finish,
    .doc = "",
};

#undef T
#define T struct wf_foliage

/* Leaves of a branched model. */

static const struct wf_yaml_row foliage_rows[] = {
    WF_KEY_QUANTITY("area", area, WF_DIM_AREA, "m2", 0, 1e5,
                    "One-sided leaf area of the whole tree with its leaves on.", .required = true,
                    .example = "17 m2"),
    WF_KEY_INTEGER("levels", levels, 1, WF_BRANCH_LEVELS_MAX,
                   "Number of levels, counted from the last, that have leaves; leaf area per length is the "
                   "same on all of them.",
                   .initial = "1", .example = "1"),
    WF_KEY_NUMBER("from", from, 0, 1, "Where on these axes the leaves begin.", .initial = "0",
                  .example = "0.2"),
    WF_KEY_NUMBER("to", to, 0, 1, "Where they end.", .initial = "1", .example = "1"),
    WF_KEY_INTEGER("count", count, 1, 10000000,
                   "Leaves, or clusters of leaves, placed one by one; they share the area.",
                   .absent = "no single leaves; the area is spread along the axes", .example = "800"),
    WF_KEY_ANGLE("tilt", tilt, 0, 0.5, "Between the axis and a leaf.", .initial = "45 deg",
                 .example = "45 deg"),
    WF_KEY_ANGLE("scatter", scatter, 0, 0.25, "Standard deviation of the angles of each leaf.",
                 .initial = "0 deg", .example = "15 deg"),
    WF_KEY_NUMBER("size_spread", size_spread, 0, 1,
                  "Standard deviation of the logarithm of the leaves' size; the area is kept.",
                  .initial = "0", .example = "0.2"),
    WF_KEY_ANGLE("swing", swing, 0, 0.5,
                 "Turn of a leaf about its hanging point in a wind of 10 m/s; grows with the wind (Tang and "
                 "others 2012, equation 13).",
                 .initial = "0 deg", .example = "20 deg"),
    WF_KEY_ANGLE("twist", twist, 0, 0.5, "The same about the vertical.", .initial = "0 deg",
                 .example = "10 deg"),
    { .key = NULL },
};

static void foliage_finish(struct wf_yaml *y, void *foliage)
{
    const struct wf_foliage *f = foliage;
    if (f->from >= f->to) wf_yaml_error(y, "from", "%g is not below 'to', %g", f->from, f->to);
}

const struct wf_yaml_table wf_foliage_table = {
    .title = "leaves", .row = foliage_rows, .finish = foliage_finish, .doc = ""
};
