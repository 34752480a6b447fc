/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_LAW_H
#define WF_DATA_LAW_H
/* A law as a row that owns its parameters. The rows stand where the laws are worked out (load/drag.h); the
 * species table, its schema and the results take names, parameters and units from the rows they are given. */
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum {
    WF_LAW_PARAMETERS = 4, /* most of one law                      */
    WF_LAW_KEYS = 12       /* most of all laws of a table together */
};

enum wf_law_kind {
    WF_LAW_NUMBER, /* a plain number                                                              */
    WF_LAW_VALUE,  /* a number with range, standing and source                                    */
    WF_LAW_LIST    /* numbers; the lists of a law are equally long and its first one must ascend  */
};

struct wf_law_parameter {
    const char *name; /* key in a species table                              */
    enum wf_law_kind kind;
    enum wf_dimension dimension;
    const char *unit;   /* for messages and the schema; NULL: dimensionless    */
    double low, high;   /* allowed [SI]                                        */
    const char *preset; /* default as it would be written; NULL: needed        */
    const char *result; /* key in results.json; of a value its `quantity` there, see wf_property */
    const char *doc, *example;
};

struct wf_law {
    const char *name;
    const char *summary; /* one line for the schema                             */
    const char *source, *validity;
    double low, high; /* range of its evidence, in the unit its table of laws names */
    const struct wf_law_parameter
        *parameter; /* in the order of wf_law_values; ends at name NULL; NULL: none */
};

/* Parameters of a law in the order of its row: number[k] or list[k] is that of parameter[k]. */
struct wf_law_values {
    double number[WF_LAW_PARAMETERS]; /* [SI] */
    const double *list[WF_LAW_PARAMETERS];
    size_t n; /* of each list */
};

/* Rows of any struct that begins with a struct wf_law; they end at name == NULL. */
struct wf_law_table {
    const void *row;
    size_t size; /* of a row */
};

/* The tables a species may choose from. */
struct wf_laws {
    struct wf_law_table streamlining; /* share of a crown's drag area; range in wind speed [m/s]         */
    struct wf_law_table axis_drag;    /* drag coefficient of a bare axis; range in Reynolds number [-]   */
};

/* Row i of a table; NULL behind the last. */
static inline const struct wf_law *wf_law_row(struct wf_law_table t, size_t i)
{
    const struct wf_law *l = (const void *)((const char *)t.row + i * t.size);
    return l->name ? l : NULL;
}

/* The row of that name; NULL when there is none. */
static inline const struct wf_law *wf_law_named(struct wf_law_table t, const char *name)
{
    const struct wf_law *l;
    for (size_t i = 0; name && (l = wf_law_row(t, i)); i++)
        if (strcmp(l->name, name) == 0) return l;
    return NULL;
}

/* Number of parameters of a law; 0 for NULL. */
static inline size_t wf_law_count(const struct wf_law *l)
{
    size_t n = 0;
    while (l && l->parameter && l->parameter[n].name) n++;
    return n;
}

/* Index of a law's parameter; -1 when it has none of that name. */
static inline int wf_law_find(const struct wf_law *l, const char *name)
{
    size_t n = wf_law_count(l);
    for (size_t k = 0; k < n; k++)
        if (strcmp(l->parameter[k].name, name) == 0) return (int)k;
    return -1;
}

/* First law of a table that has a parameter of that name; NULL when none has. */
static inline const struct wf_law *wf_law_owner(struct wf_law_table t, const char *name)
{
    const struct wf_law *l;
    for (size_t i = 0; (l = wf_law_row(t, i)); i++)
        if (wf_law_find(l, name) >= 0) return l;
    return NULL;
}
#endif
