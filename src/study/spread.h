/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_SPREAD_H
#define WF_STUDY_SPREAD_H
/* What is not known exactly of a tree and its load, as rows: by which law each value varies, and how it is
 * put into a copy of the analysis. low and high of a species table are the points below which 5 and 95 % of
 * the trees lie; its value is the median. */
#include "data/law.h"
#include "study/speed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Quantile of the standard normal distribution that 95 % lie below. */
#define WF_SPREAD_Z 1.6448536269514722

enum wf_spread_law {
    WF_SPREAD_LOGNORMAL, /* two halves of lognormal laws that join in the median */
    WF_SPREAD_NORMAL     /* two halves of normal laws */
};

enum wf_spread_place {
    WF_SPREAD_LEVEL,     /* a value of each level of the species, at the same share in all */
    WF_SPREAD_CROWN,     /* a value of the crown */
    WF_SPREAD_LAWS,      /* the values of its streamlining and axis drag laws */
    WF_SPREAD_WALL,      /* wall thickness of hollow levels */
    WF_SPREAD_RADIUS,    /* measured radii */
    WF_SPREAD_HEIGHT,    /* measured height */
    WF_SPREAD_LEAVES,    /* leaf area */
    WF_SPREAD_AREA,      /* frontal area that is given */
    WF_SPREAD_FORM,      /* exponent of the stem's relative radii, where a law of the genus gives them */
    WF_SPREAD_GUSTS,     /* factor of the peak load */
    WF_SPREAD_DAMPING,   /* structural */
    WF_SPREAD_BARE_DRAG, /* wind load of a tree without leaves, whose drag is by a law */
    WF_SPREAD_ANCHORAGE  /* moment that the root carries */
};

struct wf_spread {
    const char *name; /* key in the species table, or a name of this table */
    enum wf_spread_place place;
    enum wf_spread_law law;
    double sd;            /* where no range is given: of the logarithm, or over the value's size; 0: none */
    double sd_scanned;    /* the same of a measured tree; 0: sd */
    double least, most;   /* kept between */
    bool wood;            /* correlated with the other rows of the wood */
    const char *follower; /* keys, with blanks between, that change by the same factor; NULL: none */
    const char *source;   /* of sd; "rule": of ours */
};
extern const struct wf_spread wf_spreads[]; /* ends at name == NULL */
/* Correlation of the ranks of two rows of the wood (rule). */
#define WF_SPREAD_WOOD 0.7

/* One value that varies in an analysis. */
struct wf_varied {
    const struct wf_spread *row;
    const char *name;          /* of the row, or of a law's parameter */
    const char *unit;          /* to show it in, as in species tables; "": a plain number, or a factor */
    double value, low, high;   /* median, 5 and 95 %: of the stem or crown [SI], or factors about 1 */
    bool factor;               /* they are factors */
    bool ranged;               /* low and high are those of a table; else by the row */
    enum wf_standing standing; /* of the value; WF_MEASURED: of what is no value of the species */
    size_t offset;             /* of its struct wf_value in the species or in a level */
};

enum { WF_VARIED_MAX = 40 };
struct wf_variation {
    size_t n;
    struct wf_varied varied[WF_VARIED_MAX];
};

/* What varies in an analysis, after wf_sway_set_up. Errors: WF_EINPUT where a range does not hold its value.
 */
enum wf_status wf_variation_of(const struct wf_analysis *an, struct wf_variation *out, struct wf_err *e);

/* Correlations of the ranks of what varies: n x n. */
void wf_variation_ranks(const struct wf_variation *v, double *out);

/* What its name begins with in results: "", "crown." or "crown.streamlining.". */
const char *wf_varied_prefix(const struct wf_varied *v);
/* The value below which a share of the law lies. */
double wf_varied_at(const struct wf_varied *v, double share);

/* Values of one sample. */
struct wf_varied_copy {
    struct wf_species *species;
    struct wf_model *model;
    struct wf_misread misread;
    double load, damping, anchorage; /* factors to be put on after set-up */
};
/* Given: an analysis and what varies in it; a share for each. Returned: *out, with parts in the arena and
 * parts of the analysis. Errors: WF_ENOMEM. */
enum wf_status wf_variation_apply(const struct wf_variation *v, const struct wf_analysis *an,
                                  const double *share, struct wf_arena *a, struct wf_varied_copy *out,
                                  struct wf_err *e);

#ifdef __cplusplus
}
#endif
#endif
