/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_BESIDE_PART_H
#define WF_OUT_BESIDE_PART_H
/* What is done to a tree, or happens to it, as parts of results.json and as tables: cables, rods and guys
 * with their forces; the tree beside itself with something changed. */
#include "out/doc.h"
#include "study/beside.h"
#include <stdio.h>

/* What holds a tree, with its forces. */
json_t *wf_part_guys(struct wf_doc *d, const struct wf_analysis *a);
json_t *wf_part_braces(struct wf_doc *d, const struct wf_analysis *a);

/* Safeties by direction. */
json_t *wf_part_around(struct wf_doc *d, size_t n, const struct wf_assess_direction *x);
/* n trees, each with something changed or as it stands. */
json_t *wf_part_beside(struct wf_doc *d, size_t n, const struct wf_beside *list);
/* The first and those of --remove, in the keys of earlier versions; NULL: there are none of the latter. */
json_t *wf_part_removals(struct wf_doc *d, const struct wf_besides *all);

/* Rows of tables, of a tree by its number and the key of its species: its scenarios; what holds it in them (f
 * NULL: counted alone). Returned: how many. */
#define WF_BESIDES_HEAD                                                                                      \
    "tree,species,wind_m_s,scenario,crown_gone,drag_N,weight_N,base_moment_Nm,stem_safety,branch_safety,"    \
    "lost_wind_m_s,searched_to_m_s,breakage_safety,overturning_safety,verdict\n"
size_t wf_besides_rows(FILE *f, size_t tree, const char *species, const struct wf_besides *all);
#define WF_HOLDS_HEAD                                                                                        \
    "tree,species,wind_m_s,scenario,kind,from,to,force_N,wind_from_deg,critical_force_N,breaks_at_N,"        \
    "safety\n"
size_t wf_holds_rows(FILE *f, size_t tree, const char *species, const struct wf_besides *all);
#endif
