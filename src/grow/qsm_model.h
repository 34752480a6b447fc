/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_QSM_MODEL_H
#define WF_GROW_QSM_MODEL_H
/* From a measured table of cylinders to the connected segments a structural analysis needs.
 *
 * A scan does not say how a branch is held: its first cylinder starts on the parent's axis, on its surface or
 * somewhere beyond, at any height of the parent cylinder. Two ways of joining:
 *
 * axis (default). A continuation of a branch starts at the end of the row below. A lateral branch is held
 * where it grows: at the point of the parent's axis nearest to its first start; the parent is divided there.
 * From that point to the branch's start runs a link of the parent's own wood: stiff as the parent (its
 * radius, at most three times that of the branch) but without mass, sail and strength of its own, because the
 * parent has them already. A start beyond the parent's surface leaves wood unseen: from surface to start a
 * bridge of the branch's own radius is added, counted with its volume. So the wood modelled is the wood
 * measured plus what the bridges and bent-in gaps hold, and the stress at a branch's base is that at the
 * parent's surface, where branches do fail.
 *
 * bridge. One segment a cylinder, straight from the end of the parent to its own end, with its own radius,
 * whatever the gap: common in finite-element models made from scans, and good for comparison with them. A
 * lateral branch moves to the upper end of its parent cylinder, so its lever arm and the wood volume change.
 */
#include "data/tree.h"
#include "grow/qsm.h"

enum wf_joint { WF_JOINT_AXIS, WF_JOINT_BRIDGE };

enum wf_segment_kind {
    WF_SEGMENT_WOOD,  /* measured                                                    */
    WF_SEGMENT_LINK,  /* inside the parent's wood: no mass, no sail, no strength      */
    WF_SEGMENT_BRIDGE /* wood that was not seen, from the parent's surface to a start */
};

struct wf_qsm_model {
    struct wf_tree tree;   /* geometry and levels only; materials by wf_clothe */
    uint8_t *kind;         /* enum wf_segment_kind per segment                  */
    int32_t *row;          /* the table's row per segment                       */
    size_t laterals;       /* branches that leave a parent's axis               */
    size_t links, bridges; /* segments of these kinds                           */
    size_t short_rows;     /* rows shorter than 1 mm: drawn together            */
    size_t gaps;           /* continuations that do not start at the end below  */
    double widest_gap;     /* between a start and what it was joined to, beyond the surface [m] */
    double volume;         /* wood as modelled, links excluded [m3]             */
    double bridge_volume;  /* of it in bridges [m3]                             */
};

/* Given: a table after wf_qsm_repair. Returned: connected segments, every parent before its children, several
 * roots where the table has several stems. Errors: WF_ENOMEM; WF_EINPUT when no row is longer than 1 mm. */
enum wf_status wf_qsm_to_tree(const struct wf_qsm *q, enum wf_joint joint, struct wf_arena *a,
                              struct wf_qsm_model *out, struct wf_err *e);
#endif
