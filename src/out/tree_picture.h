/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TREE_PICTURE_H
#define WF_OUT_TREE_PICTURE_H
/* Size of a tree: of one as analysed, level by level; of a measured one, as a line of a table. */
#include "base/arena.h"
#include "base/err.h"
#include "base/num.h"
#include "data/model.h"
#include "data/tree.h"
#include "grow/qsm_model.h"
#include "load/qsm_metrics.h"
#include <libxml/tree.h>
#include <stdbool.h>
#include <stdio.h>

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

/* An axis is a run of rows of one level joined end to end. Given: enum wf_segment_kind of each row, NULL: all
 * wood. Links are inside the wood of other rows and not counted. WF_ENOMEM without memory for scratch. */
enum wf_status wf_tree_summarise(const struct wf_tree *t, const uint8_t *kind, struct wf_tree_summary *out,
                                 struct wf_err *e);

/* Properties that the user gives in addition to the geometry. */
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

/* Picture of a tree from the front and the side, coloured by level, with its parameters beside it. */

struct wf_species;

/* Segments above which the picture in a report is one of points (PNG), not of lines (SVG). */
enum { WF_PICTURE_LINES_MAX = 5000 };

struct wf_tree_picture {
    const struct wf_tree *tree;
    const struct wf_model *model;
    const struct wf_species *species;
    bool unspecified; /* the user named no species: `species` only makes the model drawable */
};

/* Write what reports/plots/tree.gp draws: FOLDER/plots/tree.dat (outlines of the segments by level, seen
 * along +y and along -x) and FOLDER/plots/tree.csv (sizes, names, the table beside the picture). The
 * folders are made. */
enum wf_status wf_tree_picture_write(const struct wf_tree_picture *p, const char *folder, struct wf_err *e);
/* Remove both, so that a picture of an earlier run is not taken for this one's. */
void wf_tree_picture_remove(const char *folder);

/* Draw a tree to `path`, which ends in .svg, .png or .pdf. Warnings of gnuplot are added to `d` (may be
 * NULL). Errors: WF_EMISSING without gnuplot, WF_EUSAGE for another ending. */
enum wf_status wf_tree_picture_draw(const struct wf_tree_picture *p, const char *path, struct wf_diag *d,
                                    struct wf_err *e);

/* Is there a picture to draw in a results folder? */
bool wf_tree_picture_there(const char *folder);
/* Has it few enough segments to be drawn as lines, the figure "tree" (out/figures.h)? */
bool wf_tree_picture_lines(const char *folder);
/* Draw FOLDER/plots/tree.png, of a tree of many segments, from the files of wf_tree_picture_write. Labels in
 * a language ("en", "zh"). Returned: the picture as an SVG document to be put into a page. Warnings of
 * gnuplot are added to `d` (may be NULL). */
enum wf_status wf_tree_picture_report(const char *folder, const char *language, xmlDoc **svg,
                                      struct wf_diag *d, struct wf_err *e);
#endif
