/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_YAML_H
#define WF_BASE_YAML_H
/* YAML files under a schema. Each key has a row with its kind, dimension, range, default and description. The
 * reader and the printed schema both use the rows, so they cannot disagree. A reading reports all mistakes of
 * a file, each with line, column and path. Anchors, tags and files of several documents are refused. */
#include "base/arena.h"
#include "base/err.h"
#include "base/units.h"
#include <stdbool.h>
#include <stddef.h>

/* Kind of a key's value, and the type of the struct's member that holds it. */
enum wf_yaml_kind {
    WF_YAML_TEXT,       /* const char *                                                              */
    WF_YAML_NAME,       /* const char *: letters, digits, '_' and '-', no '-' at its begin           */
    WF_YAML_CHOICE,     /* const char *: one of `choices`                                            */
    WF_YAML_ENUM,       /* an enum: the index in `choices`                                           */
    WF_YAML_QUANTITY,   /* double [SI]; NAN when the key is absent and has no initial value          */
    WF_YAML_INTEGER,    /* size_t                                                                    */
    WF_YAML_QUANTITIES, /* double * [SI]; size_t at `count`: how many                                */
    WF_YAML_JOINED,     /* const char *: a value, a list "a,b" or a mapping "k=v,k=v" of values      */
    WF_YAML_TEXTS,      /* struct wf_yaml_pair *: mapping of free names to texts; size_t at `count`  */
    WF_YAML_WORDS,      /* const char **: a list of texts; size_t at `count`: how many               */
    WF_YAML_TABLE,      /* a struct that `table` describes, in place                                 */
    WF_YAML_LIST        /* pointer to structs that `table` describes; size_t at `count`: how many    */
};

/* An entry of a mapping of free names to texts. */
struct wf_yaml_pair {
    const char *key, *text;
};

struct wf_yaml_table;
struct wf_yaml_row {
    const char *key;
    enum wf_yaml_kind kind;
    bool required;
    enum wf_dimension dimension; /* WF_DIM_COUNT: dimension, unit and range of the row that holds the table */
    const char *unit;            /* for messages and the printed schema; NULL: dimensionless             */
    double low, high;            /* allowed [SI]                                                         */
    const char *initial;         /* default as it would be written; NULL: none                           */
    const char *absent;          /* what happens when the key is absent, in words; NULL: see initial     */
    const char *const *choices;  /* ends at NULL                                                         */
    const struct wf_yaml_table *table;
    const char *same_length_as; /* key of the sibling list that must be as long; NULL: any length       */
    size_t offset, count;       /* of the members within the struct                                     */
    size_t given;               /* 1 + offset of a bool that becomes true when the key is there; 0: none */
    const char *doc, *example;
};
/* Rows on one line, for files in which the macro T names the struct that the table describes. Given: key,
 * member (for lists also the member that holds the number of items), range [SI; angles in turns],
 * description; then further members of the row: .required, .initial or .absent, .example. */
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
/* A mapping; its keys are members of T itself unless the row gives an .offset. */
#define WF_KEY_PART(k, of, text, ...)                                                                        \
    {                                                                                                        \
        .key = k, .kind = WF_YAML_TABLE, .table = &(of), .doc = text, __VA_ARGS__                            \
    }

/* Offset of a row whose text is checked but not stored. */
#define WF_YAML_DROP ((size_t)-1)

struct wf_yaml;
struct wf_yaml_table {
    const char *title;
    const struct wf_yaml_row *row; /* ends at key == NULL                                                 */
    size_t size;                   /* of the struct, for lists                                            */
    const char *bare;              /* key that a bare value is read as ("density: 900 kg/m3"); NULL: none */
    const char *doc;
    /* Called when all keys of the table have been read: checks between keys, derived defaults. A number that
     * could not be read is NAN. NULL: none. */
    void (*finish)(struct wf_yaml *y, void *out);
};

/* Read `path` into `out`, a struct that `table` describes; texts and lists are allocated in the arena.
 * Errors: WF_EINPUT with all mistakes in `d` (when the file cannot be read, only in `e`); WF_ENOMEM;
 * WF_EMISSING without the units database. */
enum wf_status wf_yaml_read(const char *path, const struct wf_yaml_table *table, void *out,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e);

/* For `finish`: add a mistake at a key of the current table, e.g. "levels[1].density.low", or "" for the
 * table itself. If the key is absent, the mistake is placed at the innermost enclosing key that is in the
 * file. */
void wf_yaml_error(struct wf_yaml *y, const char *key, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* For `finish`: where a key of the table in hand stands, for mistakes that are found when the file is shut.
 * As in wf_yaml_error, a key that is not in the file is placed at the nearest thing above it that is. */
struct wf_yaml_mark {
    size_t line, column; /* from 1 */
};
struct wf_yaml_mark wf_yaml_where(struct wf_yaml *y, const char *key);
/* For `finish`: the scalar at a key of the current table as it is written in the file; NULL when the key is
 * absent or its value is not a scalar. */
const char *wf_yaml_raw(struct wf_yaml *y, const char *key);
/* For `finish`: whether a key of the current table, or of a table in it ("place.count"), is in the file. */
bool wf_yaml_has(struct wf_yaml *y, const char *key);
/* For `finish`: the numbers of a list must ascend strictly. Given: the list's key and values. */
void wf_yaml_ascending(struct wf_yaml *y, const char *key, size_t n, const double *s);
/* For `finish`: zeroed memory from the reader's arena. After NULL the reading fails with WF_ENOMEM. */
void *wf_yaml_take(struct wf_yaml *y, size_t n, size_t size);

/* The schema as text: every key with dimension, range, default, description and example. Returned: the text,
 * in the arena; NULL with an error in `e` (WF_ENOMEM, also where the table is NULL for want of memory;
 * WF_EMISSING). */
char *wf_yaml_schema(const struct wf_yaml_table *table, struct wf_arena *a, struct wf_err *e);
/* The same as a JSON Schema (draft-07), for editors: kinds, words, ranges of plain numbers, descriptions,
 * defaults. It allows every file that the reader takes, and more: checks between keys are the reader's alone.
 */
char *wf_yaml_json_schema(const struct wf_yaml_table *table, struct wf_arena *a, struct wf_err *e);
#endif
