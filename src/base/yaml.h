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
                    WF_YAML_QUANTITY,   /* double, SI; NAN when the key is absent and has no initial  */
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
    const char *initial;         /* default as it would be written; NULL: none                           */
    const char *absent;          /* what it means to leave the key out, in words; NULL: see initial      */
    const char *const *choices;  /* ends at NULL                                                         */
    const struct wf_yaml_table *table;
    const char *same_length_as; /* key of the sibling list that must be as long; NULL: any length       */
    size_t offset, count;       /* of the members within the struct                                     */
    size_t given;               /* 1 + offset of a bool that becomes true when the key is there; 0: none */
    const char *doc, *example;
};
/* Rows on one line, for files in which the macro T names the struct that the table describes. Given: key,
 * member (of lists also the member that holds the number of items), range [SI; angles in turns], doc; then
 * what else the row says: .required, .initial or .absent, .example. */
#define WF_KEY(k, type, member, text, ...)                                                                   \
    {                                                                                                        \
        .key = k, .kind = type, .offset = offsetof(T, member), .doc = text, __VA_ARGS__                      \
    }
#define WF_KEY_TEXT(k, member, text, ...) WF_KEY(k, WF_YAML_TEXT, member, text, __VA_ARGS__)
#define WF_KEY_NAME(k, member, text, ...) WF_KEY(k, WF_YAML_NAME, member, text, __VA_ARGS__)
#define WF_KEY_ENUM(k, member, words, text, ...)                                                             \
    WF_KEY(k, WF_YAML_ENUM, member, text, .choices = words, __VA_ARGS__)
#define WF_KEY_INTEGER(k, member, from, to, text, ...)                                                       \
    WF_KEY(k, WF_YAML_INTEGER, member, text, .low = from, .high = to, __VA_ARGS__)
#define WF_KEY_QUANTITY(k, member, dim, u, from, to, text, ...)                                              \
    WF_KEY(k, WF_YAML_QUANTITY, member, text, .dimension = dim, .unit = u, .low = from, .high = to,          \
           __VA_ARGS__)
#define WF_KEY_NUMBER(k, member, from, to, text, ...)                                                        \
    WF_KEY_QUANTITY(k, member, WF_DIM_NONE, NULL, from, to, text, __VA_ARGS__)
#define WF_KEY_LENGTH(k, member, u, from, to, text, ...)                                                     \
    WF_KEY_QUANTITY(k, member, WF_DIM_LENGTH, u, from, to, text, __VA_ARGS__)
#define WF_KEY_ANGLE(k, member, from, to, text, ...)                                                         \
    WF_KEY_QUANTITY(k, member, WF_DIM_ANGLE, "deg", (from)*WF_TURN, (to)*WF_TURN, text, __VA_ARGS__)
#define WF_KEY_NUMBERS(k, member, n, from, to, text, ...)                                                    \
    WF_KEY(k, WF_YAML_QUANTITIES, member, text, .count = offsetof(T, n), .low = from, .high = to, __VA_ARGS__)
#define WF_KEY_LIST(k, member, n, of, text, ...)                                                             \
    WF_KEY(k, WF_YAML_LIST, member, text, .count = offsetof(T, n), .table = &(of), __VA_ARGS__)
/* The keys of the part are members of T itself unless the row gives an .offset. */
#define WF_KEY_PART(k, of, text, ...)                                                                        \
    {                                                                                                        \
        .key = k, .kind = WF_YAML_TABLE, .table = &(of), .doc = text, __VA_ARGS__                            \
    }

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
