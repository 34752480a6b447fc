#include "data/value.h"
#include <math.h>

const char *const wf_standing_words[] = { "assumed", "borrowed", "handbook", "measured", "printed", NULL };

const char *wf_standing_text(enum wf_standing s)
{
    return (unsigned)s <= WF_PRINTED ? wf_standing_words[s] : "unknown";
}

static const struct wf_yaml_row value_rows[] = {
    { .key = "value",
      .kind = WF_YAML_QUANTITY,
      .required = true,
      .dimension = WF_DIM_COUNT,
      .offset = offsetof(struct wf_value, value),
      .doc = "The value that is used." },
    { .key = "low",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_COUNT,
      .absent = "the value",
      .offset = offsetof(struct wf_value, low),
      .doc = "Lower end of the plausible range; not above the value." },
    { .key = "high",
      .kind = WF_YAML_QUANTITY,
      .dimension = WF_DIM_COUNT,
      .absent = "the value",
      .offset = offsetof(struct wf_value, high),
      .doc = "Upper end of the plausible range; not below the value." },
    { .key = "status",
      .kind = WF_YAML_ENUM,
      .initial = "assumed",
      .choices = wf_standing_words,
      .offset = offsetof(struct wf_value, standing),
      .doc =
          "measured: on this species and part; handbook: from a handbook or review; borrowed: measured on "
          "another "
          "species or part; assumed: no source; printed: as a paper prints it, known or suspected not to be "
          "physical." },
    { .key = "source",
      .kind = WF_YAML_NAME,
      .absent = "allowed for assumed values only",
      .offset = offsetof(struct wf_value, source),
      .doc = "A key of 'sources'." },
    { .key = "note",
      .kind = WF_YAML_TEXT,
      .absent = "no note",
      .offset = offsetof(struct wf_value, note),
      .doc = "Conditions of the measurement, reasons of an assumption." },
    { .key = NULL },
};

static void finish(struct wf_yaml *y, void *out)
{
    struct wf_value *v = out;
    if (v->low > v->value)
        wf_yaml_error(y, "low", "%s is above the value %s", wf_yaml_raw(y, "low"), wf_yaml_raw(y, "value"));
    if (v->high < v->value)
        wf_yaml_error(y, "high", "%s is below the value %s", wf_yaml_raw(y, "high"), wf_yaml_raw(y, "value"));
    if (isnan(v->low)) v->low = v->value;
    if (isnan(v->high)) v->high = v->value;
    if (v->standing != WF_ASSUMED && !wf_yaml_has(y, "source"))
        wf_yaml_error(y, "status", "a value that is '%s' needs a source: a key of 'sources'",
                      wf_standing_text(v->standing));
}

const struct wf_yaml_table wf_value_table = {
    .title = "value",
    .row = value_rows,
    .size = sizeof(struct wf_value),
    .bare = "value",
    .doc =
        "Wherever a value is taken, a bare quantity (900 kg/m3) is an assumption without a range; a mapping "
        "says "
        "where it comes from: {value: 10 GPa, low: 8 GPa, high: 14 GPa, status: measured, source: tang2012}",
    .finish = finish,
};

void wf_value_ascending(struct wf_yaml *y, const char *key, size_t n, const double *s)
{
    for (size_t i = 1; i < n; i++)
        if (s[i] <= s[i - 1]) {
            wf_yaml_error(y, key, "%g follows %g; the values must ascend", s[i], s[i - 1]);
            return;
        }
}
