/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trees as nodes: tables, raycloudtools, SWC, treegraph's JSON (grow/import_nodes.h). */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_import(data, size, "nodes"); }
