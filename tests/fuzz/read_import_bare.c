/* SPDX-License-Identifier: GPL-3.0-or-later */
/* TreeQSM text: columns of numbers without names (grow/import_text.h). */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_import(data, size, "treeqsm"); }
