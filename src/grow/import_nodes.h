/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_NODES_H
#define WF_GROW_IMPORT_NODES_H
/* Reader of trees as nodes: points with a radius, each with the point below it as its parent. A node is a
 * cylinder from its parent's point to its own, with its own radius; the root is a point, and its radius is
 * not used. Forms: a CSV with a row a node (PypeTree), raycloudtools' tree files (a line a tree, all its
 * nodes one after the other), SWC, and treegraph's JSON. A file of several trees needs the option `tree_id`,
 * the number of the tree in the file, from 1; without it q->trees says how many there are, and the file is
 * refused. */
#include "grow/import_file.h"

wf_import_reader wf_import_nodes;

/* Whether a text holds nodes, by its first lines. */
bool wf_import_is_nodes(const struct wf_import_head *h);
#endif
