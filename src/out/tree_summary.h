#ifndef WF_OUT_TREE_SUMMARY_H
#define WF_OUT_TREE_SUMMARY_H
/* Size of a tree, level by level. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"

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
#endif
