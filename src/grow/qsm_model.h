/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_MODEL_H
#define WF_GROW_QSM_MODEL_H
/* Conversion of a measured table of cylinders to the connected segments that a structural analysis needs.
 *
 * A scan does not show how a branch is attached: its first cylinder starts on the parent's axis, on the
 * parent's surface or somewhere outside, at any height of the parent cylinder. Two ways of joining:
 *
 * axis (default). A continuation of a branch starts at the end of the row below. A lateral branch is attached
 * to the point of the parent's axis nearest to its start; the parent is divided there. From that point a link
 * leads to the branch's start, inside the parent's wood: it is as stiff as the parent (with the parent's
 * radius, at most three times that of the branch), but has no mass, sail and strength, because these are
 * already those of the parent. If the start lies outside the parent's surface, the wood between was not
 * measured: from surface to start a bridge with the radius of the branch is added, and its volume is counted.
 * Thus the wood modelled is the wood measured plus that of bridges and of gaps that were closed, and the
 * stress at the base of a branch is that at the parent's surface, where branches fail.
 *
 * bridge. One segment for each cylinder, straight from the end of the parent to the cylinder's end, with the
 * cylinder's radius, however large the gap. This is common in finite-element models made from scans, and
 * useful for comparison with them. A lateral branch is moved to the upper end of its parent cylinder, so its
 * lever arm and the volume of wood change. */
#include "data/tree.h"
#include "grow/qsm.h"

enum wf_joint { WF_JOINT_AXIS, WF_JOINT_BRIDGE };

enum wf_segment_kind {
    WF_SEGMENT_WOOD,  /* measured                                                    */
    WF_SEGMENT_LINK,  /* inside the parent's wood: no mass, no sail, no strength      */
    WF_SEGMENT_BRIDGE /* wood that was not measured, from the parent's surface to a start */
};

struct wf_qsm_model {
    struct wf_tree tree;   /* geometry and levels only; materials by wf_clothe */
    uint8_t *kind;         /* enum wf_segment_kind per segment                  */
    int32_t *row;          /* the table's row per segment                       */
    size_t laterals;       /* rows that do not continue their parent            */
    size_t links, bridges; /* segments of these kinds                           */
    size_t short_rows;     /* rows too short for a segment: reduced to a point  */
    size_t gaps;           /* continuations that do not start at the end below  */
    double
        widest_gap; /* largest distance between a row's start and the surface or end it was joined to [m] */
    int32_t widest_row;   /* its row of the table; -1 = none           */
    double volume;        /* of the modelled wood, without links [m3]          */
    double bridge_volume; /* part of it in bridges [m3]                        */
};

/* Convert a table. Given: a table after wf_qsm_repair, the way of joining. Returned: connected segments,
 * every parent before its children; several roots if the table has several stems. Errors: WF_ENOMEM;
 * WF_EINPUT when all rows are too short. */
enum wf_status wf_qsm_to_tree(const struct wf_qsm *q, enum wf_joint joint, struct wf_arena *a,
                              struct wf_qsm_model *out, struct wf_err *e);
#endif
