/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_BESIDE_PART_H
#define WF_OUT_BESIDE_PART_H
/* What is done to a tree, or happens to it, as parts of results.json and as tables: cables, rods and guys with
 * their forces; the tree beside itself with something changed. */
#include "out/doc.h"
#include "out/tables.h"
#include "study/beside.h"

/* What holds a tree, with its forces. */
json_t *wf_part_guys(struct wf_doc *d, const struct wf_analysis *a);
json_t *wf_part_braces(struct wf_doc *d, const struct wf_analysis *a);

/* Safeties by direction. */
json_t *wf_part_around(struct wf_doc *d, size_t n, const struct wf_assess_direction *x);
/* n trees, each with something changed or as it stands. */
json_t *wf_part_beside(struct wf_doc *d, size_t n, const struct wf_beside *list);
/* The first and those of --remove, in the keys of earlier versions; NULL: there are none of the latter. */
json_t *wf_part_removals(struct wf_doc *d, const struct wf_besides *all);

/* Rows of wf_tables: scenarios, and what holds the tree in them. */
bool wf_besides_made(const struct wf_run *run);
size_t wf_besides_write(const struct wf_run *run, FILE *f);
bool wf_holds_made(const struct wf_run *run);
size_t wf_holds_write(const struct wf_run *run, FILE *f);
#endif
