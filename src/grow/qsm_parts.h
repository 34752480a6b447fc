#ifndef WF_GROW_QSM_PARTS_H
#define WF_GROW_QSM_PARTS_H
/* The steps of wf_qsm_repair, in the order in which they run. Each counts what it changes. */
#include "grow/qsm.h"
#include "grow/qsm_index.h"

/* Ids to rows: repeated rows removed, repeated ids renumbered, parents and continuations found. */
enum wf_status wf_qsm_resolve(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e);

/* One tree: rings cut, then every root that does not stand on the ground joined to the nearest axis.
 * Ground: the lowest start of a root whose part holds at least 1 % of the largest part's wood. A root within
 * 0.5 m above it stands; any other is loose and, from the lowest up, becomes a child of the row whose surface
 * is nearest to its start. Errors: WF_EINPUT when more than 1000 parts are loose: then the parent column does
 * not fit the ids. */
enum wf_status wf_qsm_join(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e);

/* Every parent before its children; the file's order is kept when it already is so. */
enum wf_status wf_qsm_sort(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e);

/* Rows shorter than 1e-9 m removed, missing radii and lengths filled. Needs sorted rows. */
enum wf_status wf_qsm_fill(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e);

/* Branch order from 0 at the stem, continuations, limbs and branch numbers. Needs sorted rows.
 * A continuation the file does not name is, among the children of the same order, the one that starts nearest
 * the row's end; where the file has no orders, the thickest child that starts at the row's end. */
enum wf_status wf_qsm_branches(struct wf_qsm *q, struct wf_arena *a, struct wf_err *e);
#endif
