/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_MTG_H
#define WF_GROW_IMPORT_MTG_H
/* Reader of OpenAlea multi-scale tree graphs (MTG): each entity of the finest scale is a segment that ends at
 * its coordinates. It starts at the end of the entity that it follows or branches from; the first segment of
 * an axis starts at the coordinates of the axis, when the file gives them. Lengths are in centimetres unless
 * the options say otherwise. */
#include "grow/import_file.h"

wf_import_reader wf_import_mtg;
#endif
