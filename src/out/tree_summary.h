/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TREE_SUMMARY_H
#define WF_OUT_TREE_SUMMARY_H
/* Size of a tree: of one as analysed, level by level; of a measured one, as a line of a table. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include "grow/qsm_model.h"
#include "load/qsm_metrics.h"
#include <stdio.h>

struct wf_species;

enum { WF_SUMMARY_LEVELS = 16 };

struct wf_level_summary {
    size_t axes, segments;
    double length_mean, length_least, length_most; /* of an axis [m]          */
    double diameter_mean;                          /* at the base of an axis [m] */
};

struct wf_tree_summary {
    size_t levels; /* the last collects those beyond */
    struct wf_level_summary level[WF_SUMMARY_LEVELS];
    double height, wood_volume, leaf_area; /* [m], [m3] without hollows, one-sided [m2] */
    double low[3], high[3];                /* extent of all ends [m] */
};

/* An axis is a run of rows of one level joined end to end. WF_ENOMEM without room for scratch. */
enum wf_status wf_tree_summarise(const struct wf_tree *t, struct wf_tree_summary *out, struct wf_err *e);

/* What the user knows beyond the geometry. */
struct wf_tree_wear {
    double density;                   /* NAN: of the species, else unknown [kg m-3] */
    double leaf_area;                 /* one-sided; NAN: unknown [m2]               */
    const struct wf_species *species; /* NULL: unknown                              */
};
/* Mass of the measured wood by the density given, else of the species by level; NAN when neither is known
 * [kg]. */
double wf_tree_wear_mass(const struct wf_qsm_metrics *g, const struct wf_tree_wear *w);
/* Still-air frontal area of the leaves; NAN when unknown [m2]. */
double wf_tree_wear_sail(const struct wf_tree_wear *w);
/* Measured trees as CSV: the header, then one line each. */
void wf_tree_table_head(FILE *to);
void wf_tree_table_line(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w);
#endif
