/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_UNIONS_H
#define WF_STUDY_UNIONS_H
/* Unions of branches and forks of stems by their aspect ratio. Geometry alone: no strength of a union by its
 * aspect ratio has a source, so that none is computed. */
#include "data/tree.h"

#define WF_UNIONS_SOURCE "Dahle et al. 2022, Forests 13:1007"
#define WF_UNIONS_UNASSESSED "strength of unions not assessed: no sourced factor by aspect ratio"

enum { WF_UNIONS_SHOWN = 20 }; /* on the terminal and the page; tables/unions.csv has all */

/* Classes by aspect ratio, of WF_UNIONS_SOURCE. */
struct wf_union_class {
    const char *name, *text;
    double from; /* lowest aspect ratio of the class [-] */
};
enum { WF_UNION_CLASSES = 4 };
extern const struct wf_union_class wf_union_classes[WF_UNION_CLASSES]; /* ascending; the first begins at 0 */

/* A row that begins where another, thicker one continues what is below. */
struct wf_union {
    int32_t branch, above, below; /* rows: the branch, the thickest one beside it, their parent; below -1:
                                   * they part at the ground */
    double height;                /* above the ground [m]                                         */
    double branch_diameter;       /* over bark, just above the union [m]                          */
    double above_diameter;        /* of the thickest row beside it, just above the union [m]       */
    double below_diameter;        /* just below the union [m]; NAN: they part at the ground        */
    double ratio;                 /* branch_diameter over above_diameter, 0 to 1 [-]              */
    const struct wf_union_class *in;
};
struct wf_unions {
    size_t n;
    struct wf_union *item; /* the largest aspect ratio first, then by row */
};

/* Unions of a tree whose branch is at least `from` [m] thick just above the union. Each branch of a node
 * stands beside the node's thickest one (of equals that of the lower level, then the first row). Rows that
 * begin on the ground are a union where they touch. Returned: *out, its items from the arena. Errors:
 * WF_ENOMEM. */
enum wf_status wf_unions_list(const struct wf_tree *t, double from, struct wf_arena *a, struct wf_unions *out,
                              struct wf_err *e);
/* How many of a list are of a class. */
size_t wf_unions_of(const struct wf_unions *u, const struct wf_union_class *in);
#endif
