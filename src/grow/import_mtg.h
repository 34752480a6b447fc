/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_MTG_H
#define WF_GROW_IMPORT_MTG_H
/* Reader of OpenAlea multi-scale tree graphs. */
#include "grow/import_file.h"

wf_import_reader wf_import_mtg;
#endif
