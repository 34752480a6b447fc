/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_YAML_H
#define WF_BASE_YAML_H
/* YAML files under a schema. One row a key says what it holds, its dimension, range, default and meaning; the
 * reader and the printed schema both follow the rows, so they cannot disagree. Every mistake of a file is
 * found at once, with its line, column and path. Anchors, tags and several documents in a file are refused.
 */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>

enum wf_yaml_kind { /* what the row's member of the struct is:                                  */
                    WF_YAML_TEXT,       /* const char *       */
                    WF_YAML_NAME,       /* const char *: letters, digits, '_' and '-'       */
                    WF_YAML_CHOICE,     /* const char *: one of `choices`     */
                    WF_YAML_ENUM,       /* an enum: the index in `choices`       */
                    WF_YAML_QUANTITY,   /* double, SI; NAN when the key is absent and has no preset   */
                    WF_YAML_INTEGER,    /* size_t    */
                    WF_YAML_QUANTITIES, /* double *, SI; how many: size_t at `count` */
                    WF_YAML_JOINED, /* const char *: a value, a list "a,b" or a mapping "k=v,k=v" of values */
                    WF_YAML_TEXTS,  /* struct wf_yaml_pair *: a mapping of free names to texts; how many:
                                       `count` */
                    WF_YAML_TABLE,  /* a struct that `table` describes, in place      */
                    WF_YAML_LIST /* a pointer to structs that `table` describes; how many: `count`        */
};

struct wf_yaml_pair {
    const char *key, *text;
};

struct wf_yaml_table;
struct wf_yaml_row {
    const char *key;
    enum wf_yaml_kind kind;
    bool required;
    enum wf_dimension dimension; /* WF_DIM_COUNT: as the row that holds this table, with its range       */
    const char *unit;            /* for messages and the printed schema; NULL: dimensionless             */
    double low, high;            /* allowed [SI]                                                         */
    const char *preset;          /* default as it would be written; NULL: none                           */
    const char *absent;          /* what it means to leave the key out, in words; NULL: see preset       */
    const char *const *choices;  /* ends at NULL                                                         */
    const struct wf_yaml_table *table;
    const char *same_length_as; /* key of the sibling list that must be as long; NULL: any length       */
    size_t offset, count;       /* of the members within the struct                                     */
    size_t given;               /* 1 + offset of a bool that becomes true when the key is there; 0: none */
    const char *doc, *example;
};
/* Offset of a row whose text is checked and not kept. */
#define WF_YAML_DROP ((size_t)-1)

struct wf_yaml;
struct wf_yaml_table {
    const char *title;
    const struct wf_yaml_row *row; /* ends at key == NULL                                                 */
    size_t size;                   /* of the struct, for lists                                            */
    const char *bare;              /* key that a bare value stands for ("density: 900 kg/m3"); NULL: none */
    const char *doc;
    /* Checks between keys and derived defaults, after the keys were read. A number that was wrong is NAN
     * here. */
    void (*finish)(struct wf_yaml *y, void *out);
};

/* Read `path` into `out`, a struct that `table` describes; texts and lists are kept in the arena.
 * Returned: WF_OK; WF_EINPUT with every mistake in `d` (an unreadable file is only in `e`); WF_ENOMEM;
 * WF_EMISSING without the units database. */
enum wf_status wf_yaml_read(const char *path, const struct wf_yaml_table *table, void *out,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

/* For `finish`: add a mistake at a key of the table in hand, e.g. "levels[1].density.low" or "" for the table
 * itself. What is not in the file is placed at the nearest thing above it that is. */
void wf_yaml_error(struct wf_yaml *y, const char *key, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* For `finish`: where a key of the table in hand stands, for mistakes that are found when the file is shut.
 * As in wf_yaml_error, a key that is not in the file is placed at the nearest thing above it that is. */
struct wf_yaml_mark {
    size_t line, column; /* from 1 */
};
struct wf_yaml_mark wf_yaml_where(struct wf_yaml *y, const char *key);
/* For `finish`: the scalar at a key of the table in hand as it is written, NULL when the key is not there or
 * is no scalar; and whether the key, or a key of a table in it ("place.count"), is there. */
const char *wf_yaml_raw(struct wf_yaml *y, const char *key);
bool wf_yaml_has(struct wf_yaml *y, const char *key);
/* For `finish`: memory from the reader's arena; NULL makes the whole reading fail with WF_ENOMEM. */
void *wf_yaml_take(struct wf_yaml *y, size_t n, size_t size);

/* The schema as text: every key with dimension, range, default, meaning, example. NULL when there is no room.
 */
char *wf_yaml_schema(const struct wf_yaml_table *table, struct wf_arena *a, struct wf_err *e);
#endif
