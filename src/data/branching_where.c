/* Where on its parent a branch stands: schema of places, directions and angles. */
#include "data/branching.h"
#include "data/branching_schema.h"
#include "data/value.h"
#include <math.h>
#include <stdbool.h>

#define TURN 6.28318530717958647693
#define AT(member) .offset = offsetof(struct wf_branching, member)
#define ANGLE(l, h)                                                                                          \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_ANGLE, .unit = "deg", .low = (l)*TURN, .high = (h)*TURN
#define NUMBER(l, h) .kind = WF_YAML_QUANTITY, .low = (l), .high = (h)
#define NUMBERS(l, h) .kind = WF_YAML_QUANTITIES, .low = (l), .high = (h)

const char *const wf_azimuth_words[] = { "spiral", "whorl", "planar", "random", NULL };

static const struct wf_yaml_row place_rows[] = {
    { .key = "from",
      NUMBER(0, 1),
      .preset = "0.1",
      AT(from),
      .doc = "Lowest place on the parent, 0 = its base.",
      .example = "0.4" },
    { .key = "to",
      NUMBER(0, 1),
      .preset = "1",
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
      .preset = "1",
      AT(per_whorl),
      .doc = "Branches at one place, evenly round the parent.",
      .example = "4" },
    { .key = "spread",
      NUMBER(0, 1),
      .preset = "0",
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
const struct wf_yaml_table wf_place_table = {
    .title = "places", .row = place_rows, .finish = place_finish, .doc = ""
};

static const struct wf_yaml_row azimuth_rows[] = {
    { .key = "rule",
      .kind = WF_YAML_ENUM,
      .preset = "spiral",
      .choices = wf_azimuth_words,
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
      .preset = "0 deg",
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
        wf_yaml_error(y, "divergence", "is not used by rule '%s'", wf_azimuth_words[b->azimuth]);
    if (isnan(b->azimuth_start)) b->azimuth_start = b->azimuth == WF_AZIMUTH_PLANAR ? TURN / 4 : 0;
    if (isnan(b->divergence) && b->azimuth == WF_AZIMUTH_SPIRAL) b->divergence = 137.5 / 360 * TURN;
}
const struct wf_yaml_table wf_azimuth_table = {
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
      .high = 0.5 * TURN,
      .same_length_as = "at",
      AT(insertion_along.v),
      .count = offsetof(struct wf_branching, insertion_along.n),
      .absent = "the same angle everywhere",
      .doc = "Angle at these places, linear between, constant outside.",
      .example = "[90 deg, 40 deg]" },
    { .key = "spread",
      ANGLE(0, 0.25),
      .preset = "0 deg",
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
const struct wf_yaml_table wf_insertion_table = {
    .title = "an insertion", .row = insertion_rows, .finish = insertion_finish, .doc = ""
};
