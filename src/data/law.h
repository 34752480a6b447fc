/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_LAW_H
#define WF_DATA_LAW_H
/* Values with range, source and standing, and laws as rows that own their parameters. The rows are defined
 * beside the code that evaluates the laws (load/drag.h); the species table, its schema and the results take
 * names, parameters and units from the rows they are given. */
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

enum wf_standing {
    WF_ASSUMED,  /* no source: an assumption of this table                  */
    WF_BORROWED, /* measured on another species or part                     */
    WF_HANDBOOK, /* from a handbook or review, not traced to its experiment */
    WF_MEASURED, /* measured on this species and part                       */
    WF_PRINTED   /* as a paper prints it, known or suspected not to be physical */
};

struct wf_value {
    double value, low, high; /* SI; low = high = value when no range is given */
    enum wf_standing standing;
    const char *source; /* NULL only when standing is WF_ASSUMED */
    bool given;         /* false: the file does not name it; value is the documented default, NAN if none */
    const char *note;   /* NULL when there is none */
};

/* Double bark of a species over its diameter. */
struct wf_bark_law {
    bool given;
    size_t terms;          /* of `coefficient`; 3 */
    double *coefficient;   /* a, b, c of a + b d + c d^2 [mm], d the diameter over bark [cm] */
    struct wf_value share; /* thickness over that of the law [-]; 1, with its range */
};

/* A list of numbers. */
struct wf_numbers {
    size_t n;
    double *v;
};
const char *wf_standing_text(enum wf_standing s);

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
    unsigned dimension; /* an enum wf_dimension of base/units.h               */
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
    size_t n;    /* of each list */
    double held; /* upper end of the evidence, above which the law keeps its value there, in the unit of the
                    table of laws; 0: the law is extended */
};

/* What a law says beyond the upper end of its evidence. */
enum wf_beyond {
    WF_BEYOND_HOLD,  /* its value there */
    WF_BEYOND_EXTEND /* its formula     */
};
extern const char *const wf_beyond_words[]; /* in the order of enum wf_beyond; ends at NULL */

/* Rows of any struct that begins with a struct wf_law; they end at name == NULL. */
struct wf_law_table {
    const void *row;
    size_t size; /* of a row */
};

/* A law a species chooses, with its parameters in the order of the law's row. */
struct wf_law_use {
    struct wf_law_table from;               /* it is chosen from; set by the reader                   */
    const char *law;                        /* a row of its table of laws; NULL: not chosen           */
    struct wf_value parameter[WF_LAW_KEYS]; /* numbers [SI]; of plain ones only the value             */
    struct wf_numbers list[WF_LAW_KEYS];    /* [SI]                                                   */
    double low, high;          /* what the source covers, in the unit of the table of laws; NAN: not said */
    enum wf_beyond beyond;     /* `high` */
    const char *source;        /* of the law; that of its first sourced parameter when it names none      */
    enum wf_standing standing; /* of the lists                                                           */
};

/* The tables a species may choose from. */
struct wf_laws {
    struct wf_law_table streamlining; /* share of a crown's drag area; range in wind speed [m/s]         */
    struct wf_law_table axis_drag;    /* drag coefficient of a bare axis; range in Reynolds number [-]   */
};

/* Row i of a table; NULL after the last. */
static inline const struct wf_law *wf_law_row(struct wf_law_table t, size_t i)
{
    const struct wf_law *l = (const struct wf_law *)(const void *)((const char *)t.row + i * t.size);
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

#ifdef __cplusplus
}
#endif
#endif
