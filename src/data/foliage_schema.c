/* Leaves of a branched model. */
#include "data/branching.h"
#include "data/branching_schema.h"

#define TURN 6.28318530717958647693
#define AT(member) .offset = offsetof(struct wf_foliage, member)
#define ANGLE(l, h)                                                                                          \
    .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_ANGLE, .unit = "deg", .low = (l)*TURN, .high = (h)*TURN
#define NUMBER(l, h) .kind = WF_YAML_QUANTITY, .low = (l), .high = (h)

static const struct wf_yaml_row foliage_rows[] = {
    { .key = "area",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_AREA,
      .unit = "m2",
      .low = 0,
      .high = 1e5,
      AT(area),
      .doc = "One-sided leaf area of the whole tree with its leaves on.",
      .example = "17 m2" },
    { .key = "levels",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = WF_BRANCH_LEVELS_MAX,
      .preset = "1",
      AT(levels),
      .doc = "How many of the last levels bear leaves, the same area on every length of them.",
      .example = "1" },
    { .key = "from",
      NUMBER(0, 1),
      .preset = "0",
      AT(from),
      .doc = "Where on these axes the leaves begin.",
      .example = "0.2" },
    { .key = "to", NUMBER(0, 1), .preset = "1", AT(to), .doc = "Where they end.", .example = "1" },
    { .key = "count",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 10000000,
      .absent = "leaves only spread out",
      AT(count),
      .doc = "Leaves, or clusters of leaves, placed one by one; they share the area.",
      .example = "800" },
    { .key = "tilt",
      ANGLE(0, 0.5),
      .preset = "45 deg",
      AT(tilt),
      .doc = "Between the axis and a leaf.",
      .example = "45 deg" },
    { .key = "scatter",
      ANGLE(0, 0.25),
      .preset = "0 deg",
      AT(scatter),
      .doc = "Standard deviation of the angles of each leaf.",
      .example = "15 deg" },
    { .key = "size_spread",
      NUMBER(0, 1),
      .preset = "0",
      AT(size_spread),
      .doc = "Standard deviation of the logarithm of the leaves' size; the area is kept.",
      .example = "0.2" },
    { .key = "swing",
      ANGLE(0, 0.5),
      .preset = "0 deg",
      AT(swing),
      .doc =
          "Turn of a leaf about its hanging point in a wind of 10 m/s; grows with the wind (Tang and others "
          "2012, equation 13).",
      .example = "20 deg" },
    { .key = "twist",
      ANGLE(0, 0.5),
      .preset = "0 deg",
      AT(twist),
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
