/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TREE_PICTURE_H
#define WF_OUT_TREE_PICTURE_H
/* Picture of a tree from the front and the side, coloured by level, with its parameters beside it. */
#include "base/err.h"
#include "base/num.h"
#include "data/model.h"
#include "data/tree.h"
#include <libxml/tree.h>
#include <stdbool.h>

struct wf_species;

/* Segments above which the picture in a report is one of points (PNG), not of lines (SVG). */
enum { WF_PICTURE_LINES_MAX = 5000 };

struct wf_tree_picture {
    const struct wf_tree *tree;
    const struct wf_model *model;
    const struct wf_species *species;
};

/* Write what reports/plots/tree.gp draws: FOLDER/plots/tree.dat (outlines of the segments by level, seen
 * along +y and along -x) and FOLDER/plots/tree.csv (sizes, names, the table beside the picture). The
 * folders are made. */
enum wf_status wf_tree_picture_write(const struct wf_tree_picture *p, const char *folder, struct wf_err *e);
/* Remove both, so that a picture of an earlier run is not taken for this one's. */
void wf_tree_picture_remove(const char *folder);

/* Draw a tree to `path`, which ends in .svg, .png or .pdf. Errors: WF_EMISSING without gnuplot, WF_EUSAGE for
 * another ending. */
enum wf_status wf_tree_picture_draw(const struct wf_tree_picture *p, const char *path, struct wf_err *e);

/* Is there a picture to draw in a results folder? */
bool wf_tree_picture_there(const char *folder);
/* Draw FOLDER/plots/tree.svg, or tree.png for a tree of many segments, from what wf_tree_picture_write left.
 * Labels in a language ("en", "zh"). Returned: the picture as an SVG document to be put into a page. */
enum wf_status wf_tree_picture_report(const char *folder, const char *language, xmlDoc **svg,
                                      struct wf_err *e);
#endif
