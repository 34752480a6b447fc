/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_CARD_H
#define WF_CMD_ASSESS_CARD_H
/* Options of windfirm assess: a tree card, and those of windfirm analyze that go with it. */
#include "cmd/analyze_request.h"
#include "grow/card.h"
#include "study/assessment.h"

struct wf_assess_fit; /* cmd/assess_fit.h */
struct wf_assess_options {
    struct wf_analyze_options run; /* comes first: its rows are taken as they are */
    const char *name, *species;    /* NULL: not given */
    double height, girth, dbh, crown_base;
    double lean, lean_towards;    /* [rad], clockwise from north; NAN: not given */
    double required;              /* safety [-] */
    const char *from;             /* NULL: none */
    const char *reports;          /* folder, of a table; NULL: none */
    const char *scans;            /* folder of the files that a table names; NULL: that of the table */
    const char *scan;             /* file of the tree in place of the card, of a row; NULL: none; no option */
    const char *extremes;         /* folder or file; NULL: none */
    double life;                  /* [years] */
    struct wf_assess_often often; /* of `extremes`; no option */
};

/* Options that act only beside one of others. Of a table the other may be a column. */
struct wf_assess_beside {
    const char *option, *other[2]; /* NULL: no more */
    const char *without;           /* the words behind "has no effect" */
};
extern const struct wf_assess_beside wf_assess_besides[]; /* ends at option == NULL */

/* Set the options that are not rows of assess, and give its rows; they end at name == NULL. */
const struct wf_option *wf_assess_options_of(struct wf_assess_options *o);

/* The model of a card with all that is said of its tree, without changes; `sp` NULL: the species is not
 * known, only the card is checked. Errors: WF_EINPUT with mistakes in `d`; any other error is in `e`. */
enum wf_status wf_assess_model(const struct wf_assess_options *o, const struct wf_species *sp,
                               struct wf_arena *a, struct wf_model *out, struct wf_diag *d, struct wf_err *e);

/* Is a file YAML, by its name: a card, or in place of one a model? Else it is a table, or a measured tree. */
bool wf_assess_is_yaml(const char *scan);

/* How often winds blow, by the options. */
struct wf_assess_often wf_assess_often_of(const struct wf_assess_options *o);

/* One tree in one wind, apart from a run of its own: with the changes of its options, without results. */
struct wf_assess_case {
    struct wf_assess_options options;
    const struct wf_species *species;
    const struct wf_assess_fit
        *fit;                     /* the tree is that of a fit, with its species' fitted values; NULL: none */
    const struct wf_model *whole; /* the tree as it stands; NULL: that of this case */
    double grown;                 /* of a fit: its height [m] */
    struct wf_model model;
    struct wf_analyze_request request;
    double cut;     /* share of the crown's frontal area that the changes take [-] */
    bool alone;     /* only wind towards this azimuth is looked at */
    double towards; /* [rad] */
    struct wf_analysis an;
    struct wf_assessment x;
    struct wf_assess_direction around[WF_ASSESS_DIRECTIONS]; /* of x, where directions differ */
};
/* Given: options and species. Returned: model and request, of a bare analysis unless there are reports. The
 * model is that of the file of `scan` where there is one: of the card the crown alone is taken, and that only
 * in leaf where the file shows no leaves.
 * Errors: as wf_assess_model. */
enum wf_status wf_assess_case_read(struct wf_assess_case *c, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_err *e);
/* Given: what the former returned. Returned: the analysis, in the weakest direction, and the assessment. */
enum wf_status wf_assess_case_run(struct wf_assess_case *c, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e);
#endif
