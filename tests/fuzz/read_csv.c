/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables: base/csv.h. */
#include "base/csv.h"
#include "fuzz.h"
#include <string.h>

static void check_cell(struct wf_csv *c, size_t i)
{
    double v;
    long long n;
    const struct wf_cell *k = &c->cell[i];
    must(k->text[k->size] == '\0' && strlen(k->text) == k->size, "a cell ends at its size");
    must(k->line >= 1 && k->line >= c->row_line, "a cell has a line");
    if (wf_csv_number(c, i, -1e3, 1e3, &v)) must(v >= -1e3 && v <= 1e3, "a number lies in its range");
    if (wf_csv_integer(c, i, -5, 1000, &n)) must(n >= -5 && n <= 1000, "an integer lies in its range");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_csv c;
    size_t line = 0, rows = 0;
    enum wf_status s = wf_csv_open(&c, f->path, &f->arena, &f->diag, &f->err);
    if (s) return s;
    must(c.columns > 0 && c.columns <= WF_CSV_COLUMNS, "a table has columns");
    for (size_t i = 0; i < c.columns; i++)
        must(!c.name[i].size || wf_csv_column(&c, c.name[i].text) == i, "a column is found by its name");
    (void)wf_csv_need(&c, "id");
    for (; wf_csv_next(&c); rows++) {
        must(c.row_line > line, "rows go down the file");
        line = c.row_line;
        for (size_t i = 0; i < c.columns && i < 50; i++) check_cell(&c, i);
    }
    must(rows <= f->size, "a row has bytes");
    must(f->diag.errors >= (c.mistakes > WF_CSV_LISTED ? WF_CSV_LISTED : c.mistakes), "mistakes are listed");
    return f->diag.errors ? wf_fail(&f->err, WF_EINPUT, "mistakes") : WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
