#include "data/branching_schema.h"
#include "data/branching.h"
#include "data/value.h"
#include <math.h>
#include <string.h>

#define TURN 6.28318530717958647693
#define AT(member) .offset = offsetof(struct wf_branching, member)
#define ANGLE(l, h)                                                                                          \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_ANGLE, .unit = "deg", .low = (l)*TURN, .high = (h)*TURN
#define NUMBER(l, h) .kind = WF_YAML_QUANTITY, .low = (l), .high = (h)
#define NUMBERS(l, h) .kind = WF_YAML_QUANTITIES, .low = (l), .high = (h)
#define LENGTH(l, h)                                                                                         \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_LENGTH, .unit = "m", .low = (l), .high = (h)
#define SPREAD(member, what)                                                                                 \
    {                                                                                                        \
        .key = "spread", NUMBER(0, 1), .preset = "0", AT(member), .doc = what, .example = "0.1"              \
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

const char *const wf_length_words[] = { "absolute", "parent", "rest", NULL };
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
      .choices = wf_length_words,
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
      .preset = "1",
      AT(length_factor),
      .doc = "Multiplies the law.",
      .example = "0.6" },
    ALONG(length_along),
    SPREAD(length_spread, "Standard deviation of the logarithm of the length."),
    { .key = "shortest",
      LENGTH(1e-3, 10),
      .preset = "10 mm",
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
      .preset = "1",
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
    for (size_t k = 0; pipe && k < sizeof others / sizeof *others; k++)
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
      .preset = "0.3",
      AT(tip_share),
      .doc = "Radius at the tip over that at the base, t in t + (1 - t) (1 - s)^p.",
      .example = "0.3" },
    { .key = "power",
      NUMBER(0.1, 5),
      .preset = "1",
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
      .preset = "0 deg",
      CURVE(turn),
      .doc = "Whole turn towards the vertical, shared evenly by the angles between successive segments: "
             "positive rises, negative droops; it ends where the axis is vertical.",
      .example = "-30 deg" },
    { .key = "from",
      NUMBER(0, 1),
      .preset = "0",
      CURVE(from),
      .doc = "Where on the axis the turn begins.",
      .example = "0" },
    { .key = "to", NUMBER(0, 1), .preset = "1", CURVE(to), .doc = "Where it ends.", .example = "0.5" },
    { .key = "wander",
      ANGLE(0, 0.25),
      .preset = "0 deg",
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
    { PART("place", wf_place_table, "Where on each parent the branches stand."), .required = true },
    { PART("azimuth", wf_azimuth_table, "To which side of the parent they go."), .absent = "a spiral" },
    { PART("insertion", wf_insertion_table, "At which angle they leave it."), .required = true,
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
      .preset = "5",
      AT(segments),
      .doc = "Straight pieces of equal length of each branch; a row also ends where a branch of the next "
             "level stands. Places are rounded to a tenth of a piece.",
      .example = "5" },
    { PART("curve", wf_curve_table, "The angle between successive pieces."), AT(curve),
      .absent = "straight" },
    { .key = NULL },
};

static void finish(struct wf_yaml *y, void *branching)
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
    .finish = finish,
    .doc = "",
};
