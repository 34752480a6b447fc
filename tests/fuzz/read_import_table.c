/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tree files by content: CSV tables, TreeQSM text and MTG (grow/import.h). MATLAB files have a harness of
 * their own. */
#include "fuzz.h"
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 6 && (!memcmp(data, "MATLAB", 6) || !memcmp(data, "\x89HDF", 4))) return 0;
    return fuzz_import(data, size, NULL);
}
