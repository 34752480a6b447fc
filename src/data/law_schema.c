/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/law_schema.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- Values ---- */

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

static void value_finish(struct wf_yaml *y, void *out)
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
    .finish = value_finish,
};

void wf_value_needs_source(struct wf_yaml *y, enum wf_standing s)
{
    if (s != WF_ASSUMED && !wf_yaml_has(y, "source"))
        wf_yaml_error(y, "status", "a table that is '%s' needs a source: a key of 'sources'",
                      wf_standing_text(s));
}

/* ---- Laws ---- */

/* Keys of a law: the choice, then the parameters of all laws of the table, each key once. While a file is
 * read the parameters stand in the order of the keys; at the end those of the law chosen move to the front.
 */
#define USE(member) offsetof(struct wf_law_use, member)
#define SPEED(k, member, words)                                                                              \
    .key = k, .kind = WF_YAML_QUANTITY, .dimension = WF_DIM_SPEED, .unit = "m/s", .low = 0, .high = 150,     \
    .absent = "not stated", .offset = USE(member), .doc = words
const char *const wf_beyond_words[] = { "hold", "extend", NULL };

const struct wf_yaml_row wf_law_ranges[] = {
    /* of streamlining laws */
    { SPEED("valid_from", low, "Lowest wind speed the source covers; a run outside them warns."),
      .example = "4 m/s" },
    { SPEED("valid_to", high, "Highest wind speed the source covers."), .example = "20 m/s" },
    { .key = "beyond",
      .kind = WF_YAML_ENUM,
      .initial = "hold",
      .choices = wf_beyond_words,
      .offset = USE(beyond),
      .doc = "Above valid_to. hold: the crown keeps the share it has there, so that its drag grows as the "
             "square of the wind speed; extend: the law goes on, which gives lower loads." },
    { .key = NULL },
};
static const struct wf_yaml_row origin_rows[] = {
    { .key = "status",
      .kind = WF_YAML_ENUM,
      .initial = "assumed",
      .choices = wf_standing_words,
      .offset = USE(standing),
      .doc = "Status of the table, as for a value." },
    { .key = "source", .kind = WF_YAML_NAME, .offset = USE(source), .doc = "A key of 'sources'." },
    { .key = "note",
      .kind = WF_YAML_TEXT,
      .absent = "no note",
      .offset = WF_YAML_DROP,
      .doc = "Conditions of the measurement, reasons of an assumption." },
    { .key = NULL },
};

const struct wf_law_parameter *wf_law_key(struct wf_law_table t, size_t k, const struct wf_law **owner)
{
    const struct wf_law *l;
    for (size_t i = 0, found = 0; (l = wf_law_row(t, i)); i++)
        for (size_t p = 0, n = wf_law_count(l); p < n; p++) {
            if (wf_law_owner(t, l->parameter[p].name) != l) continue;
            *owner = l;
            if (found++ == k) return &l->parameter[p];
        }
    return NULL;
}

/* "vogel", or "vogel, other": the laws that have a parameter of that name. */
static void law_names(struct wf_law_table t, const char *name, char *buf, size_t size)
{
    const struct wf_law *l;
    size_t used = 0;
    for (size_t i = 0; (l = wf_law_row(t, i)) && used < size; i++)
        if (wf_law_find(l, name) >= 0)
            used += (size_t)snprintf(buf + used, size - used, "%s%s", used ? ", " : "", l->name);
}

/* "none: a rigid crown; vogel: ... ." */
static char *law_summary(struct wf_law_table t, struct wf_arena *a)
{
    const struct wf_law *l;
    char *text = wf_arena_text(a, "");
    for (size_t i = 0; text && (l = wf_law_row(t, i)); i++)
        text = wf_arena_print(a, "%s%s%s: %s", text, i ? "; " : "", l->name, l->summary);
    return text ? wf_arena_print(a, "%s.", text) : NULL;
}

/* The list of a law that must ascend; the law's other lists must be equally long. */
static const struct wf_law_parameter *first_list(const struct wf_law *l)
{
    for (size_t k = 0, n = wf_law_count(l); k < n; k++)
        if (l->parameter[k].kind == WF_LAW_LIST) return &l->parameter[k];
    return NULL;
}

/* The row of the k-th key. Returned: false without memory. */
static bool law_row(struct wf_law_table t, size_t k, struct wf_arena *a, struct wf_yaml_row *out)
{
    char names[200] = "";
    const struct wf_law *owner;
    const struct wf_law_parameter *p = wf_law_key(t, k, &owner), *first = first_list(owner);
    const size_t value = USE(parameter) + k * sizeof(struct wf_value);
    const size_t list = USE(list) + k * sizeof(struct wf_numbers);
    law_names(t, p->name, names, sizeof names);
    *out = (struct wf_yaml_row){ .key = p->name,
                                 .dimension = p->dimension,
                                 .unit = p->unit,
                                 .low = p->low,
                                 .high = p->high,
                                 .initial = p->preset,
                                 .doc = p->doc,
                                 .example = p->example };
    out->absent = p->preset ? wf_arena_print(a, "%s by law %s, refused by the others", p->preset, names)
                            : wf_arena_print(a, "needed by law %s, refused by the others", names);
    switch (p->kind) {
    case WF_LAW_NUMBER:
        out->kind = WF_YAML_QUANTITY, out->offset = value + offsetof(struct wf_value, value);
        break;
    case WF_LAW_VALUE:
        out->kind = WF_YAML_TABLE, out->table = &wf_value_table, out->offset = value;
        out->given = 1 + value + offsetof(struct wf_value, given);
        break;
    case WF_LAW_LIST:
        out->kind = WF_YAML_QUANTITIES, out->offset = list + offsetof(struct wf_numbers, v);
        out->count = list + offsetof(struct wf_numbers, n);
        out->same_length_as = first == p ? NULL : first->name;
    }
    return out->absent != NULL;
}

/* Keys that belong to some laws: required with these, refused with the others. */
static void law_keys_fit(struct wf_yaml *y, const struct wf_law_use *u)
{
    const struct wf_law *chosen = wf_law_named(u->from, u->law), *owner;
    const struct wf_law_parameter *p;
    for (size_t k = 0; (p = wf_law_key(u->from, k, &owner)); k++) {
        bool mine = wf_law_find(chosen, p->name) >= 0, has = wf_yaml_has(y, p->name);
        if (mine && !has && !p->preset)
            wf_yaml_error(y, "", "law '%s' needs the key '%s'", chosen->name, p->name);
        if (!mine && has)
            wf_yaml_error(y, p->name, "is for law '%s'; the law here is '%s'", owner->name, chosen->name);
    }
}

const char *wf_law_source(const struct wf_law_use *u)
{
    const struct wf_law *owner;
    for (size_t k = 0; wf_law_key(u->from, k, &owner); k++)
        if (u->parameter[k].source) return u->parameter[k].source;
    return NULL;
}

static void law_finish(struct wf_yaml *y, void *use)
{
    struct wf_law_use *u = use;
    const char *law = wf_yaml_raw(y, "law");
    const struct wf_law *owner;
    const struct wf_law_parameter *p;
    if (law && !strcmp(law, u->law)) law_keys_fit(y, u); /* an unknown law was already reported */
    for (size_t k = 0; (p = wf_law_key(u->from, k, &owner)); k++)
        if (p == first_list(owner))
            wf_yaml_ascending(y, p->name, u->list[k].v ? u->list[k].n : 0, u->list[k].v);
    wf_value_needs_source(y, u->standing);
    if (u->low >= u->high)
        wf_yaml_error(y, "valid_to", "%s is not above valid_from %s", wf_yaml_raw(y, "valid_to"),
                      wf_yaml_raw(y, "valid_from"));
    if (!u->source) u->source = wf_law_source(u);
}

void wf_law_settle(struct wf_law_use *u)
{
    const struct wf_law *chosen = wf_law_named(u->from, u->law), *owner;
    const struct wf_law_use read = *u;
    const struct wf_law_parameter *p;
    memset(u->parameter, 0, sizeof u->parameter);
    memset(u->list, 0, sizeof u->list);
    for (size_t k = 0; (p = wf_law_key(u->from, k, &owner)); k++) {
        int at = wf_law_find(chosen, p->name);
        if (at >= 0) u->parameter[at] = read.parameter[k], u->list[at] = read.list[k];
    }
}

size_t wf_law_copy_rows(struct wf_yaml_row *to, const struct wf_yaml_row *from)
{
    size_t n = 0;
    while (from[n].key) to[n] = from[n], n++;
    return n;
}

bool wf_law_schema_make(struct wf_law_table t, const char *title, const struct wf_yaml_row *between,
                        struct wf_arena *a, struct wf_law_schema *out)
{
    const struct wf_law *l, *owner, *example = NULL;
    const struct wf_law_parameter *p, *sourced = NULL;
    struct wf_yaml_row *r = out->row;
    for (size_t i = 0; i + 1 < WF_LAWS_MAX && (l = wf_law_row(t, i)); i++) {
        out->word[i] = l->name;
        if (!example && l->parameter) example = l;
    }
    *r++ = (struct wf_yaml_row){ .key = "law",
                                 .kind = WF_YAML_CHOICE,
                                 .required = true,
                                 .initial = out->word[0],
                                 .choices = out->word,
                                 .offset = USE(law),
                                 .doc = law_summary(t, a),
                                 .example = example ? example->name : out->word[0] };
    if (!out->row[0].doc) return false;
    for (size_t k = 0; k < WF_LAW_KEYS && (p = wf_law_key(t, k, &owner)); k++, r++) {
        if (!law_row(t, k, a, r)) return false;
        if (!sourced && p->kind == WF_LAW_VALUE) sourced = p;
    }
    r += wf_law_copy_rows(r, between);
    size_t last = wf_law_copy_rows(r, origin_rows);
    for (size_t i = 0; i < last; i++)
        if (!strcmp(r[i].key, "source"))
            r[i].absent = sourced ? wf_arena_print(a, "that of the %s", sourced->name) : "none";
    out->table = (struct wf_yaml_table){ .title = title, .row = out->row, .finish = law_finish, .doc = "" };
    return true;
}
