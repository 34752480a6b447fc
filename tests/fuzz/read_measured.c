/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records of a test on a tree: fit/test_data.h. Columns are taken by the names of the file, so
 * that their units are read too. */
#include "base/csv.h"
#include "base/yaml.h"
#include "fit/test_data.h"
#include "fuzz.h"

enum { COLUMNS = 3 };

static void check(const struct wf_test_data *r)
{
    must(r->n > 0, "a record has rows");
    must_be_finite(r->time, r->n, "times are finite");
    must_be_finite(r->value, r->n * r->columns, "readings are finite");
    for (size_t i = 1; i < r->n; i++) {
        must(r->time[i] >= r->time[i - 1], "time goes on");
        must(r->line[i] > r->line[i - 1], "rows go down the file");
    }
}

/* The first columns of the file, each as force or speed, angle and length. */
static size_t columns_of(struct fuzz *f, struct wf_column *out, const char **time)
{
    const enum wf_dimension wanted[] = { f->size % 3 ? WF_DIM_FORCE : WF_DIM_SPEED, WF_DIM_ANGLE,
                                         WF_DIM_LENGTH };
    struct wf_csv c;
    struct wf_diag d = { .arena = &f->arena };
    struct wf_err e = { 0 };
    size_t n = 0;
    if (wf_csv_open(&c, f->path, &f->arena, &d, &e)) return 0;
    *time = c.name[0].text;
    for (size_t i = 1; i < c.columns && n < COLUMNS; i++, n++)
        out[n] = (struct wf_column){ c.name[i].text, NULL, wanted[n] };
    if (n == 1) out[0].unit = f->size % 3 ? "kN" : "km/h";
    return n;
}

static enum wf_status reading(struct fuzz *f, bool timed)
{
    struct wf_column column[COLUMNS];
    const char *time = NULL;
    struct wf_test_data r = { 0 };
    const struct wf_yaml_pair only = { "tree", "A" };
    const struct wf_test_rows how = { .time = timed ? time : NULL,
                                      .rate = timed ? 0 : 20,
                                      .missing = timed         ? NULL
                                                 : f->size % 5 ? "-99.9,7"
                                                               : "none",
                                      .dates = f->size % 7 ? WF_DATES_UNSAID : WF_DATES_MONTH_FIRST,
                                      .only = &only,
                                      .onlys = timed ? 0 : f->size % 2 };
    struct wf_err e = { 0 };
    size_t n = columns_of(f, column, &time);
    if (!n) return wf_fail(&f->err, WF_EINPUT, "no columns");
    enum wf_status s = wf_test_data_read(f->path, column, n, &how, &f->arena, &r, &f->diag, &f->err);
    if (s) return s;
    check(&r);
    if (fuzz_done(wf_loading_branch(&r, 0, 0.1, 0.9, "pull", &e), &e)) {
        size_t used = 0;
        for (size_t i = 0; i < r.n; i++) used += r.used[i];
        must(used >= 3, "a loading has three rows");
    }
    return WF_OK;
}
static enum wf_status read_timed(struct fuzz *f) { return reading(f, true); }
static enum wf_status read_rows(struct fuzz *f) { return reading(f, false); }

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_read(data, size, read_timed);
    return fuzz_read(data, size, read_rows);
}
