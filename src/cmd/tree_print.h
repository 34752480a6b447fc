#ifndef WF_CMD_TREE_PRINT_H
#define WF_CMD_TREE_PRINT_H
/* Figures of a measured tree on the terminal. */
#include "data/species.h"
#include "grow/qsm_model.h"
#include "load/qsm_metrics.h"
#include <stdio.h>

/* What the user knows beyond the geometry. */
struct wf_tree_wear {
    double density;                   /* NAN: of the species, else unknown [kg m-3] */
    double leaf_area;                 /* one-sided; NAN: unknown [m2]               */
    const struct wf_species *species; /* NULL: unknown                              */
};

/* One tree, one page. */
void wf_tree_print_page(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w);
/* Many trees as CSV: the header, then one line each. */
void wf_tree_print_head(FILE *to);
void wf_tree_print_line(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w);
#endif
