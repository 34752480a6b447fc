/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_ASSESSMENT_H
#define WF_STUDY_ASSESSMENT_H
/* Is a tree's safety enough? Its least safeties in the strongest given wind against the one that practice
 * requires, the same tree with sound sections beside it, and a word. */
#include "study/analysis.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Words of the verdict, from the worst. The first that holds is taken: none says more than was assessed. */
enum wf_assess_word {
    WF_ASSESS_UNKNOWN,      /* nothing was assessed */
    WF_ASSESS_LOST,         /* the tree is lost in this wind: a safety of 1 or less, or no equilibrium */
    WF_ASSESS_INSUFFICIENT, /* a safety is below the required one */
    WF_ASSESS_UNCERTAIN,    /* enough as computed, but not at the low end of the interval, or in wet soil */
    WF_ASSESS_INCOMPLETE,   /* enough, but something that loses trees was not assessed */
    WF_ASSESS_SUFFICIENT,   /* enough by all that was assessed, at the low end of the interval too */
    WF_ASSESS_WORDS
};
/* Name for files, and a sentence. */
struct wf_assess_row {
    const char *name, *text;
};
extern const struct wf_assess_row wf_assess_rows[WF_ASSESS_WORDS];

/* Why a word is not better: bits, and their names by the number of the bit; NULL after the last. */
extern const char *const wf_assess_reasons[];
enum {
    WF_ASSESS_NO_OVERTURNING = 1, /* overturning was not assessed */
    WF_ASSESS_NO_ELASTIC = 2,     /* the species has no compressive strength */
    WF_ASSESS_NO_INTERVAL = 4,
    WF_ASSESS_LOW_END = 8,         /* the low end of the interval is below the required safety */
    WF_ASSESS_WET = 16,            /* it overturns in saturated soil */
    WF_ASSESS_NO_STRENGTH = 32,    /* no strength is known: breakage was not assessed */
    WF_ASSESS_NO_EQUILIBRIUM = 64, /* the tree has no state in this wind */
    WF_ASSESS_WINTER = 128         /* a share of this wind blows with snow or ice on it; it was not assessed
                                      without them in the whole */
};

/* The least safety by the criteria of one kind. */
struct wf_assess_part {
    double safety; /* [-]; NAN: not assessed; 0: no equilibrium */
    enum wf_criterion_id criterion;
    int32_t row;   /* -1: none */
    double height; /* of the place above the ground [m] */
    double from;   /* where the wind comes from in which it is the least, clockwise from north [rad]; NAN: the
                      same from all directions */
};

struct wf_assess_direction {
    double from; /* where the wind comes from, clockwise from north [rad] */
    struct wf_assess_part breakage, overturning;
    struct wf_assess_part by[WF_CRITERIA]; /* as `least` of struct wf_assessment */
    double loss; /* least safety by criteria that lose the tree [-]; 0: no equilibrium */
    /* of what holds the tree, at the peak of the load on the stem, as struct wf_at_speed; NAN: no equilibrium
     * [N] */
    double tie[WF_TIES_MAX], link[WF_LINKS_MAX];
};

struct wf_beside; /* study/beside.h */
/* A crown cut above this share is flagged. */
#define WF_ASSESS_CUT_FLAGGED 0.3

enum { WF_ASSESS_DIRECTIONS = 16 };
struct wf_assessment {
    double required;                /* safety [-] */
    double speed;                   /* strongest given wind [m/s] */
    struct wf_assess_part breakage; /* of the stem, by the elastic limit too */
    struct wf_assess_part overturning;
    struct wf_assess_part least[WF_CRITERIA]; /* by each that loses the tree or of which practice wants more
                                                 than 1, of all directions that count; NAN: others, and in a
                                                 wind without equilibrium */
    double wet_low, wet_high;                 /* against overturning in saturated soil [-] */
    double sound;                             /* against breakage with sound, full sections [-] */
    double low, high;                         /* 5 and 95 % of the least of both [-]; NAN: no interval */
    double years;                             /* return period of the critical wind; NAN: unknown */
    bool years_least, years_most;             /* it is less, more than `years` */
    const char *years_unknown;                /* why */
    const char *years_by;                     /* the file of the extremes; NULL: the code of the given wind */
    double years_low, years_high; /* by the band of 90 % of the extremes; 0, INFINITY: beyond it; NAN: none */
    double exceedance;      /* probability of the critical wind in a year [-], with the same bounds; NAN */
    double over_life, life; /* the same in at least one of `life` years [-] */
    double exceedance_low;  /* in a year, of the low end of the critical wind's interval [-]; NAN */
    size_t directions;      /* 0: the same from all */
    const struct wf_assess_direction *direction;
    double from; /* where the wind of the analysis comes from, of which the critical wind and the interval
                    are: that in which the tree is lost first, or that was specified; clockwise from north
                    [rad]; NAN: the same from all */
    bool one;    /* it was specified, and counts alone */
    size_t scenarios;
    const struct wf_beside *scenario; /* the tree with something changed, in the same wind unless that is */
    double reduction;      /* least share of the crown's height and width off that makes it safe enough [-];
                              INFINITY: none up to `reduction_most`; NAN: not searched */
    double reduction_most; /* the largest share that was tried [-] */
    double reduction_cut;  /* share of its frontal area, or of its leaves, that is gone then [-] */
    const char *reduction_unknown; /* why it was not searched, where that was asked; NULL */
    const struct wf_diag *record;  /* what a test says by itself; NULL: there is none */
    enum wf_assess_word word;
    unsigned because; /* of WF_ASSESS_NO_OVERTURNING and so on */
    unsigned lost_by; /* all criteria that lose the tree in this wind: bits by their ids */
};

/* Is a tree's safety the same in wind from all directions? */
bool wf_assess_is_round(const struct wf_model *m, const struct wf_scenario *sc);

/* Safeties of a tree in one wind from WF_ASSESS_DIRECTIONS directions, evenly spaced from that in which it
 * leans. Given: where north is in the model, see study/directions.h [rad]. Returned:
 * out[WF_ASSESS_DIRECTIONS]; *worst, the azimuth in which the tree is lost first, or where that is unknown of
 * the least safety [rad]. Errors: those of wf_analysis_set_up. */
enum wf_status wf_assess_around(const struct wf_species *sp, const struct wf_model *m,
                                const struct wf_scenario *sc, const struct wf_solver *solver,
                                const struct wf_solve_options *o, double speed, double north,
                                struct wf_assess_direction *out, double *worst, struct wf_err *e);

/* How often winds blow. */
struct wf_assess_often {
    const struct wf_design_words *design; /* by the code of the given wind; NULL: none was given */
    const struct wf_extreme *extreme;     /* in place of it: of the largest 10-min mean of a year at 10 m over
                                             open     country; NULL: none */
    const char *source;                   /* of the latter */
    size_t levels;                        /* its band: return periods, ascending, 90 % of their winds [m/s] */
    const double *years, *low, *high;
    double life; /* probabilities are also given over so many years */
};

/* Assess a finished analysis. Given: the required safety; how often winds blow, from which the return period
 * follows. Returned: *out but for its directions. Errors: of the tree with sound sections. */
enum wf_status wf_assess(const struct wf_analysis *an, const struct wf_solve_options *o, double required,
                         const struct wf_assess_often *often, struct wf_assessment *out, struct wf_err *e);

/* Give an assessment its directions, which outlive it. The analysis is that of wind from the direction `from`
 * [rad], in which the tree is lost first; the safeties become the least of all directions, those in saturated
 * soil and the interval go with them, and the word follows. `one`: a direction was specified, and counts
 * alone. */
void wf_assess_all_around(struct wf_assessment *x, const struct wf_assess_direction *direction, double from,
                          bool one);

#ifdef __cplusplus
}
#endif
#endif
