/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_H
#define WF_GROW_QSM_H
/* A measured tree as a table of cylinders, the form into which all file formats are read, before any
 * modelling. A quantitative structure model (QSM) describes a scanned tree by cylinders that need not touch
 * each other: a cylinder has its own start and end, a parent, and a branch. Lengths in metres, z up. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Everything in which the table differs from what the file says. A note does not change the tree (the file
 * writes the same in another way); a repair changes or adds something, and a strict import refuses it. */
enum wf_repair {
    /* notes */
    WF_NOTE_BOM,           /* a byte order mark before the text                                 */
    WF_NOTE_CRLF,          /* Windows line ends                                                 */
    WF_NOTE_DECIMAL_COMMA, /* decimal commas                                                    */
    WF_NOTE_HEADER,        /* column names with spaces or in another case                       */
    WF_NOTE_ROOT_MARK,     /* the root's parent is written as -1 or left empty                  */
    WF_NOTE_FROM_ZERO,     /* ids counted from 0                                                */
    WF_NOTE_ORDER_FROM,    /* branch orders not counted from 0 at the stem                      */
    WF_NOTE_ORDER_MADE,    /* no branch order in the file: made from the way the rows are joined */
    WF_NOTE_SORTED,        /* rows that come before their parent: reordered                     */
    WF_NOTE_OFFSET,        /* plot or map coordinates: moved so that the base is the origin     */
    WF_NOTE_STEMS,         /* further stems that start at the ground                            */
    WF_NOTE_THICKENING,    /* radius more than a tenth larger than the row below in its branch  */
    WF_NOTE_UNITS,         /* a unit that the file does not state was taken from the sizes      */
    WF_NOTE_MODELS,        /* further tree models of the same file were ignored                 */
    WF_NOTE_APART,         /* further stems whose bases are metres from the main one's          */
    WF_NOTE_THICK_CHILD,   /* a branch that is thicker by a tenth than what it grows on         */
    /* repairs */
    WF_REPAIR_BAD_ROW,     /* rows that cannot be read: left out                                */
    WF_REPAIR_TRUNCATED,   /* the last row is cut off: left out                                 */
    WF_REPAIR_AXIS,        /* axis vectors that are not of unit length: normalised              */
    WF_REPAIR_LENGTH,      /* stated length and distance start to end differ by more than 1 % and 1 mm */
    WF_REPAIR_ZERO_LENGTH, /* rows without length: removed, their children joined to their parent */
    WF_REPAIR_RADIUS,      /* radii that are missing or not positive: taken from the row below  */
    WF_REPAIR_SAME_ROW,    /* the same row twice: one removed                                   */
    WF_REPAIR_SAME_ID,     /* different rows with one id: the later got a new id                */
    WF_REPAIR_NO_PARENT,   /* the named parent is not in the file                               */
    WF_REPAIR_CYCLE,       /* rows that are their own ancestor: cut at the lowest               */
    WF_REPAIR_LOOSE,       /* parts that hang in the air: joined to the nearest axis            */
    WF_REPAIR_ROOT_ORDER,  /* stems with a branch's order in the file: taken as order 0         */
    WF_REPAIR_CAPPED,      /* rows thinned, as specified, to the thickness of what they grow on */
    WF_REPAIR_AZIMUTH, /* azimuths that were not measured: taken at 137.5 degrees after the branch before */
    WF_REPAIR_COUNT
};

enum { WF_QSM_NO_PARENT = -1 }; /* parent_id of a row whose parent cell is empty */

struct wf_repair_row {
    const char *code; /* stable short name, e.g. "axis-not-unit" */
    const char *text; /* message; the count is printed before it  */
    bool note;        /* true: a note, allowed in a strict import */
    bool once;        /* concerns the whole file: no count        */
};
extern const struct wf_repair_row wf_repair_rows[WF_REPAIR_COUNT];

struct wf_repairs {
    size_t count[WF_REPAIR_COUNT];
    int64_t first[WF_REPAIR_COUNT]; /* id (or line, for unreadable rows) of the first case */
};

struct wf_qsm {
    const char *name, *file, *format;
    size_t n;
    int64_t *id, *parent_id; /* as the file numbers them; a root's parent is its file's mark */
    int32_t *parent;         /* row; -1 = a root; set by wf_qsm_repair                       */
    int32_t *order;          /* branch order, 0 = stem; -1 = the file does not say           */
    int32_t *branch;         /* running number of the branch, from 1                         */
    int32_t *place;          /* position in the branch, from 1                               */
    int64_t *next_id;        /* id of the row that continues the branch, as in the file; 0 = none */
    int32_t *next;           /* its row; -1 = none; set by wf_qsm_repair                     */
    double *x0, *y0, *z0;    /* start [m]                                                    */
    double *x1, *y1, *z1;    /* end [m]                                                      */
    double *r0, *r1;         /* radius at start and end [m]; NAN = the file does not say     */
    double *length;          /* length the file states [m]; NAN = distance start to end      */
    uint8_t *added;          /* 1: a gap filler of the program that made the model           */
    size_t *line;            /* line of the file, 0 = not a text file                        */
    double base[3];          /* subtracted from the file's coordinates [m]                   */
    size_t trees;            /* trees in the file, set by readers of files of several; else 0 */
    size_t models;           /* models of the tree in the file, set by readers of files of several; else 0 */
    struct wf_repairs repairs;
    const char *detail[WF_REPAIR_COUNT]; /* worst case of a kind, in words; NULL: none */
};

/* Allocate columns for n cylinders: zeroed, except radii and length NAN, order, parent and next -1. Errors:
 * WF_EINPUT for more than INT32_MAX cylinders, WF_ENOMEM. */
enum wf_status wf_qsm_alloc(struct wf_qsm *q, size_t n, struct wf_arena *a, struct wf_err *e);

/* Count a note or repair. Given: how many cases, and the id (or line) of the first, which is kept if it is
 * the first of its kind; -1: none. */
void wf_qsm_count(struct wf_qsm *q, enum wf_repair what, size_t how_many, int64_t where);

/* Reduce or reorder a table to the rows pick[0..n). Parents and continuations are renumbered (-1 when their
 * row is not picked); counts and names do not change. Errors: WF_ENOMEM. */
enum wf_status wf_qsm_pick(struct wf_qsm *q, const int32_t *pick, size_t n, struct wf_arena *a,
                           struct wf_err *e);

/* Add a warning for each kind of note and repair that occurred: code, number of cases, place of the first,
 * worst case. */
void wf_qsm_report(const struct wf_qsm *q, struct wf_diag *d);

double wf_qsm_distance(const struct wf_qsm *q, size_t i); /* from start to end of row i [m] */
double wf_qsm_volume(const struct wf_qsm *q, size_t i); /* of row i as a frustum of its stated length [m3] */

/* Row of an id, and children of a row. */

/* A hash table (open addressing) from id to row; of several rows with one id the first is found. */
struct wf_ids {
    size_t slots; /* a power of two, at least twice the ids */
    int32_t *row; /* -1 = free                              */
    const int64_t *id;
};
/* An empty table for n ids id[0..n). Errors: WF_ENOMEM. */
enum wf_status wf_ids_begin(struct wf_ids *x, const int64_t *id, size_t n, struct wf_arena *a,
                            struct wf_err *e);
/* Add row i under id[i]. Returned: i, or the earlier row that has this id. */
int32_t wf_ids_enter(struct wf_ids *x, int32_t i);
/* Row of an id; -1 when there is none. */
int32_t wf_ids_find(const struct wf_ids *x, int64_t id);

/* Children of row i: child[begin[i] .. begin[i+1]), in row order; roots: child[begin[n] .. begin[n+1]). */
struct wf_children {
    int32_t *begin, *child;
};
/* Given: parent[n], -1 = a root. Errors: WF_ENOMEM. */
enum wf_status wf_children_of(const int32_t *parent, size_t n, struct wf_arena *a, struct wf_children *out,
                              struct wf_err *e);
#endif
