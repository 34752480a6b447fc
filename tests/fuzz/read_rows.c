/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of any length, a row at a time: base/rows.h. */
#include "base/rows.h"
#include "base/text.h"
#include "fuzz.h"
#include <string.h>

static void add_size(void *context, const char *raw) { *(size_t *)context += strlen(raw); }

static void check_row(const struct wf_rows *r)
{
    struct wf_utf8_fault fault;
    must(strlen(r->raw) == r->size, "a row ends at its size");
    must(r->blank || (r->cells >= 1 && r->cells <= WF_ROW_CELLS), "a row has cells");
    for (size_t i = 0; i < r->cells && !r->blank; i++)
        must(r->wrong || wf_utf8_valid(r->cell[i], strlen(r->cell[i]), &fault), "a cell is UTF-8");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_rows r;
    size_t bytes = 0, line = 0;
    enum wf_status s = wf_rows_open(&r, f->path, add_size, &bytes, &f->err);
    must(s || (r.columns >= 1 && r.columns <= WF_ROW_CELLS), "a table has columns");
    while (!s && wf_rows_next(&r)) {
        must(r.line > line, "rows go down the file");
        line = r.line, bytes += r.size;
        check_row(&r);
    }
    /* two bytes of UTF-16 are up to three of UTF-8 */
    must(bytes <= (r.utf16 ? f->size / 2 * 3 : f->size), "no row has bytes that are not in the file");
    wf_rows_close(&r);
    return s;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
