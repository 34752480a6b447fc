/* SPDX-License-Identifier: GPL-3.0-or-later */
/* MATLAB files (grow/import_mat.h). */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_import(data, size, "mat"); }
