/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_table.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/text.h"
#include "cmd/assess_often.h"
#include "cmd/assess_row.h"
#include "cmd/commands.h"
#include "cmd/press.h"
#include "data/species.h"
#include "out/results.h"
#include "out/workbook.h"
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

/* Rows at a time; of them trees of files, which are larger; where each has a report. */
enum { BATCH = 128, SCANS = 8, REPORTS = 16 };
enum { NUMBERS = 1 << 16 }; /* of trees, of which three quarters are compared at most */

struct table {
    struct wf_assess_options *line;
    struct wf_arena arena;
    struct wf_rows rows;
    struct wf_tree_columns *columns;
    const char *command;
    struct wf_input_file input;
    const char *out, *partial, *note; /* the table, while it grows, and what it is of */
    FILE *to;
    char *before; /* lines before the header, and the header */
    struct wf_tree_row row[BATCH];
    pthread_mutex_t lock;  /* of the rows that are finished and of what is written */
    size_t rows_read, put; /* rows of the batch, and those of them in the table */
    bool finished[BATCH];
    struct wf_press press; /* of the reports */
    size_t written;        /* rows in the table, blank ones too */
    size_t done, mistakes, failed;
    struct timespec began, shown;
    size_t resumed;
    size_t numbers, twice, first_twice; /* of trees, seen; rows with one that was there; line of the first */
    uint64_t number[NUMBERS];           /* by hash; 0: none */
    size_t formulas, first_formula;     /* cells that a spreadsheet would compute; line of the first */
};

/* ---- What a table that is not finished is of ---- */

/* The command, the program and the input's fingerprint. */
static char *note_text(struct table *t, const char *command, struct wf_err *e)
{
    char sum[WF_SHA256_TEXT];
    if (wf_sha256_file(t->rows.file, &t->arena, sum, e)) return NULL;
    char *text = wf_arena_print(&t->arena, "%s\nwindfirm " WF_VERSION "\n%s\n", command, sum);
    if (!text) (void)wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    return text;
}

static bool same_note(struct table *t, const char *note)
{
    struct wf_bytes found;
    struct wf_err unsaid = { WF_OK, "" };
    return wf_file_is_there(t->note) && !wf_file_read(t->note, &t->arena, &found, &unsaid) &&
           !strcmp(found.data, note);
}

static void no_lines(void *context, const char *raw) { (void)context, (void)raw; }

static void count_word(struct table *t, const struct wf_rows *r)
{
    const char *word = r->cells > t->rows.columns ? r->cell[t->rows.columns] : "";
    t->done += !strcmp(word, "assessed");
    t->mistakes += !strcmp(word, "mistake");
    t->failed += !strcmp(word, "failed");
}

/* Whole rows that an earlier run wrote, what they say, and the size of the table with them. */
static size_t count_rows(struct table *t, long *size)
{
    struct wf_rows r;
    struct wf_err unsaid = { WF_OK, "" };
    size_t n = 0;
    *size = 0;
    bool more = !wf_rows_open(&r, t->partial, no_lines, NULL, &unsaid);
    if (more) *size = ftell(r.stream) - (long)r.held_size;
    while (more && (more = wf_rows_next(&r))) {
        long end = ftell(r.stream) - (long)r.held_size;
        if (r.wrong || end - *size == (long)r.size) break; /* its line end is missing */
        *size = end, n++;
        count_word(t, &r);
    }
    wf_rows_close(&r);
    return n;
}

static enum wf_status out_error(const struct table *t, struct wf_err *e)
{
    return wf_fail(e, WF_EOUTPUT, "%s: %s", t->partial, strerror(errno ? errno : EIO));
}

/* Go on with the table of an earlier run of this command. Returned: false when there is none. */
static bool go_on(struct table *t, const char *note)
{
    long size;
    if (!wf_file_is_there(t->partial) || !same_note(t, note)) return false;
    size_t n = count_rows(t, &size);
    if (!n || truncate(t->partial, size) || !(t->to = fopen(t->partial, "ab"))) return false;
    for (t->resumed = 0; t->resumed < n && wf_rows_next(&t->rows);) t->resumed++;
    t->written = t->resumed;
    return true;
}

static enum wf_status write_note(const struct table *t, const char *note, struct wf_err *e)
{
    struct wf_file f;
    enum wf_status s = wf_file_begin(&f, t->note, e);
    if (s) return s;
    fputs(note, f.stream);
    return wf_file_commit(&f, e);
}

/* A run that was ended before the head was written leaves an empty file. */
static bool holds_anything(const char *path)
{
    struct stat there;
    return !stat(path, &there) && there.st_size > 0;
}

static enum wf_status begin_table(struct table *t, const char *note, struct wf_err *e)
{
    errno = 0;
    if (go_on(t, note)) return WF_OK;
    if (holds_anything(t->partial) && wf_file_is_there(t->note) && !t->line->run.args.quiet)
        wf_show(stderr, "%s is of another command or table; it is begun anew\n", t->partial);
    if (!(t->to = fopen(t->partial, "wb"))) return out_error(t, e);
    enum wf_status s = write_note(t, note, e);
    if (s) return s;
    if (t->rows.marked) fputs("\xEF\xBB\xBF", t->to); /* by which spreadsheets know UTF-8 */
    wf_tree_header_write(t->columns, t->before, t->to);
    return fflush(t->to) ? out_error(t, e) : WF_OK;
}

/* ---- Rows ---- */

static void count(struct table *t, const struct wf_tree_row *r)
{
    t->done += r->state == WF_ROW_DONE;
    t->mistakes += r->state == WF_ROW_MISTAKE;
    t->failed += r->state == WF_ROW_FAILED;
}

/* Rows of the batch up to `end` into the table and out of the program, so that nothing that is finished is
 * lost when it is ended. */
static enum wf_status put_rows(struct table *t, size_t end, struct wf_err *e)
{
    if (t->put >= end) return WF_OK;
    for (; t->put < end; t->put++, t->written++) {
        wf_tree_row_write(t->columns, &t->row[t->put], t->to);
        count(t, &t->row[t->put]);
    }
    return fflush(t->to) ? out_error(t, e) : WF_OK;
}

/* A row that has a report is finished when that is in place. */
static enum wf_status assess(void *context, size_t k, struct wf_err *e)
{
    struct table *t = context;
    enum wf_status s = WF_OK;
    wf_tree_row_assess(&t->row[k]);
    if (t->line->reports || t->row[k].state == WF_ROW_READ) return WF_OK; /* or it was interrupted */
    (void)pthread_mutex_lock(&t->lock);
    t->finished[k] = true;
    size_t end = t->put;
    while (end < t->rows_read && t->finished[end]) end++;
    s = put_rows(t, end, e);
    (void)pthread_mutex_unlock(&t->lock);
    return s;
}

/* Which tree the page of a row is of: its number, or file and line of the table. NULL: no memory. */
static const char *tree_said(const struct table *t, struct wf_tree_row *row)
{
    const char *file = t->input.path, *name = strrchr(file, '/');
    if (row->number) return row->number;
    return wf_arena_print(&row->arena, "%s:%zu", name ? name + 1 : file, row->line);
}

/* The files that a row was assessed from. */
static enum wf_status note_files(const struct table *t, struct wf_tree_row *row, struct wf_inputs *in,
                                 struct wf_err *e)
{
    const struct wf_assess_case *x = &row->single;
    *in = (struct wf_inputs){ &row->arena, 1, WF_TAKE(&row->arena, WF_OPTION_FILES, struct wf_input_file) };
    if (!in->item) return wf_fail(e, WF_ENOMEM, "not enough memory for a report");
    in->item[0] = t->input;
    enum wf_status s = wf_inputs_note(in, "species", x->species->file, e);
    if (!s && x->options.scan) s = wf_inputs_note(in, "model", x->options.scan, e);
    if (!s && t->line->extremes) s = wf_assess_often_note(t->line->extremes, in, e);
    return s ? s : wf_analyze_files_note(&x->options.run, &x->request, &x->model, in, e);
}

/* Results and pages of a row that was assessed. */
static enum wf_status report(struct table *t, size_t k, struct wf_err *e)
{
    struct wf_tree_row *row = &t->row[k];
    const struct wf_pages *pages = &t->line->run.pages;
    struct wf_run_folder folder = { 0 };
    struct wf_inputs in;
    struct wf_job job = t->line->run.job;
    job.tree_number = tree_said(t, row);
    job.photo = NULL, job.logo = NULL;
    struct wf_run run = { .job = &job,
                          .command = t->command,
                          .version = WF_VERSION,
                          .date = wf_run_date(&row->arena),
                          .n = 1,
                          .analysis = &row->single.an };
    char *path = wf_arena_print(&row->arena, "%s/row_%zu", t->line->reports, row->line);
    if (!path || !run.date || !job.tree_number)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a report");
    row->single.an.assessment = &row->single.x;
    enum wf_status s = note_files(t, row, &in, e);
    run.inputs = in.n, run.input = in.item;
    if (!s) s = wf_results_begin(&folder, path, pages->none ? NULL : "report", e);
    if (!s) s = wf_results_write(&run, folder.stage, e);
    if (!s) return wf_press_put(&t->press, &folder, k, pages, &row->arena, e);
    wf_run_abandon(&folder);
    t->press.failed = k < t->press.failed ? k : t->press.failed;
    return s;
}

/* Reports of the first n rows that were assessed. Returned: *good, how many rows have what they need; the row
 * whose report an interrupt may have cut is not among them, and its folder is written again. */
static enum wf_status report_all(struct table *t, size_t n, size_t *good, struct wf_err *e)
{
    struct wf_err after = { 0 };
    enum wf_status s = WF_OK;
    t->press.failed = SIZE_MAX;
    for (*good = 0; *good < n && !s && !wf_interrupted();) {
        if (t->row[*good].state == WF_ROW_DONE) s = report(t, *good, e);
        *good += !wf_interrupted();
        if (!s) s = put_rows(t, wf_press_placed(&t->press, *good), e);
    }
    enum wf_status last = wf_press_drain(&t->press, s ? &after : e);
    if (t->press.failed < *good) *good = t->press.failed;
    return s ? s : last;
}

/* Assess n rows side by side. Returned: *good, those before the first that an interrupt left unfinished. */
static enum wf_status assess_all(struct table *t, size_t n, size_t *good, struct wf_err *e)
{
    struct wf_err why = { 0 };
    enum wf_status s = wf_parallel_abreast(n, t->line->run.threads, assess, t, &why);
    *good = 0;
    if (s && s != WF_EINTERRUPTED) return wf_fail(e, s, "%s", why.text);
    while (*good < n && t->row[*good].state != WF_ROW_READ) ++*good;
    return WF_OK;
}

/* Cells of the user stay as they are; those that a spreadsheet takes for formulas are counted. */
static void count_formulas(struct table *t)
{
    for (size_t c = 0; c < t->rows.cells; c++) {
        const char *text = t->rows.cell[c];
        char *end;
        bool sign = *text == '+' || *text == '-';
        if (sign) (void)strtod(text, &end), sign = *end != '\0';
        if (!sign && *text != '=' && *text != '@' && *text != '\t') continue;
        if (!t->formulas++) t->first_formula = t->rows.line;
    }
}

/* Rows with the number of a tree that was there before are counted: two trees, or one twice. */
static void count_number(struct table *t, const struct wf_tree_row *row)
{
    uint64_t hash = 14695981039346656037U; /* FNV-1a */
    if (!row->number || t->numbers > NUMBERS / 4 * 3) return;
    for (const char *p = row->number; *p; p++) hash = (hash ^ (unsigned char)*p) * 1099511628211U;
    hash += !hash;
    size_t k = hash % NUMBERS;
    while (t->number[k] && t->number[k] != hash) k = (k + 1) % NUMBERS;
    if (t->number[k] && !t->twice++) t->first_twice = row->line;
    t->numbers += !t->number[k];
    t->number[k] = hash;
}

/* Some rows: read, assess side by side, write in order. Returned: *n rows; 0 at the end. */
static enum wf_status batch(struct table *t, size_t *n, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    size_t scans = 0;
    const size_t most = t->line->reports ? REPORTS : BATCH;
    for (*n = 0; *n < most && scans < SCANS && !s && wf_rows_next(&t->rows);) {
        count_formulas(t);
        s = wf_tree_row_read(t->columns, &t->rows, &t->row[*n], e);
        t->finished[*n] = false;
        count_number(t, &t->row[*n]);
        scans += t->row[(*n)++].single.options.scan != NULL;
    }
    size_t good = 0;
    t->rows_read = *n, t->put = 0;
    if (!s) s = assess_all(t, *n, &good, e);
    if (!s && t->line->reports) s = report_all(t, good, &good, e);
    enum wf_status put = put_rows(t, good, s ? &(struct wf_err){ 0 } : e);
    for (size_t k = 0; k < *n; k++) wf_arena_free(&t->row[k].arena);
    return s ? s : put;
}

static double since(const struct timespec *from)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - from->tv_sec) + 1e-9 * (double)(now.tv_nsec - from->tv_nsec);
}

/* On a terminal a line that is written over; else a line every ten seconds. */
static void show(struct table *t, bool last)
{
    bool live = isatty(STDERR_FILENO);
    double run = since(&t->began);
    size_t fresh = t->written - t->resumed;
    if (t->line->run.args.quiet || (!last && since(&t->shown) < (live ? 0.5 : 10))) return;
    (void)clock_gettime(CLOCK_MONOTONIC, &t->shown);
    if (live && !last) fputs("\r", stderr);
    size_t rows = t->done + t->mistakes + t->failed;
    wf_show(stderr, "%zu rows: %zu assessed, %zu with mistakes, %zu failed; %.3g/s", rows, t->done,
            t->mistakes, t->failed, run > 0 ? (double)fresh / run : 0);
    if (t->written > rows) wf_show(stderr, "; %zu blank lines and remarks kept", t->written - rows);
    fputs(live && !last ? "\033[K" : "\n", stderr);
    fflush(stderr);
}

static enum wf_status all_rows(struct table *t, struct wf_err *e)
{
    struct wf_err why = { 0 };
    enum wf_status s = WF_OK;
    (void)clock_gettime(CLOCK_MONOTONIC, &t->began);
    t->shown = t->began;
    for (size_t n = 1; n && !s && !wf_interrupted();) {
        s = batch(t, &n, &why);
        show(t, false);
    }
    if (isatty(STDERR_FILENO)) fputs("\r\033[K", stderr);
    show(t, true);
    if (s && s != WF_EINTERRUPTED) return wf_fail(e, s, "%s", why.text);
    if (!wf_interrupted()) return WF_OK;
    return wf_fail(e, WF_EINTERRUPTED, "interrupted after %zu rows; the same command goes on from %s",
                   t->written, t->partial);
}

/* ---- The run ---- */

static void keep_line(void *context, const char *raw)
{
    struct table *t = context;
    char *more = wf_arena_print(&t->arena, "%s%s%s", t->before ? t->before : "", t->before ? "\n" : "", raw);
    if (more) t->before = more;
}

static enum wf_status fill_workbook(const struct table *t, struct wf_workbook *w, struct wf_err *e)
{
    struct wf_rows r;
    const size_t most = 1048575; /* rows of a sheet below its head */
    size_t row = 0;
    enum wf_status s = wf_rows_open(&r, t->out, no_lines, NULL, e);
    if (s) return s;
    for (size_t c = 0; c < r.columns; c++) wf_workbook_cell(w, 0, c, r.name[c], false);
    while (!s && wf_rows_next(&r)) {
        if (r.blank) continue;
        if (++row > most)
            s = wf_fail(e, WF_EOUTPUT, "%s has more rows than a sheet of a workbook (%zu)", t->out, most);
        for (size_t c = 0; c < r.cells; c++) wf_workbook_cell(w, row, c, r.cell[c], true);
    }
    wf_rows_close(&r);
    return s;
}

/* The table as a workbook beside it, with .xlsx in the place of .csv. */
static enum wf_status write_workbook(struct table *t, struct wf_err *e)
{
    struct wf_workbook *w;
    size_t n = strlen(t->out);
    if (n > 4 && !strcmp(t->out + n - 4, ".csv")) n -= 4;
    const char *path = wf_arena_print(&t->arena, "%.*s.xlsx", (int)n, t->out);
    if (!path) return wf_fail(e, WF_ENOMEM, "not enough memory for a workbook");
    enum wf_status s = wf_workbook_open(&w, path, "trees", e);
    if (s) return s;
    if ((s = fill_workbook(t, w, e))) return wf_workbook_abandon(w), s;
    return wf_workbook_close(w, e);
}

static enum wf_status finish(struct table *t, struct wf_err *e)
{
    bool whole = !ferror(t->to) && !fclose(t->to);
    t->to = NULL;
    if (!whole || rename(t->partial, t->out)) return out_error(t, e);
    (void)unlink(t->note);
    return WF_OK;
}

/* A table of a header alone: nothing is written. */
static enum wf_status no_trees(struct table *t, struct wf_err *e)
{
    (void)fclose(t->to), t->to = NULL;
    (void)unlink(t->partial), (void)unlink(t->note);
    return wf_fail(e, WF_EINPUT,
                   "%s: there is no row below the header: nothing was assessed, nothing written",
                   t->rows.file);
}

static enum wf_status read_extremes(struct table *t, struct wf_err *e)
{
    struct wf_diag d = { .arena = &t->arena };
    enum wf_status s = wf_assess_often_read(t->line->extremes, &t->arena, &d, &t->line->often, e);
    wf_print_findings(&d, t->line->run.args.quiet);
    return s;
}

/* Rows take and give back the same memory, thousands of times: it is kept, which saves the system's zeroing
 * of fresh pages. */
static void keep_memory(void)
{
#ifdef __GLIBC__
    enum { KEPT = 64 << 20 };
    (void)mallopt(M_MMAP_THRESHOLD, KEPT);
    (void)mallopt(M_TRIM_THRESHOLD, KEPT);
    (void)mallopt(M_TOP_PAD, 1 << 20);
#endif
}

/* A file is written: no folder, and nothing that only looks like a file; its folder is there. */
static enum wf_status check_output(struct table *t, struct wf_err *e)
{
    struct stat there;
    const char *slash = strrchr(t->out, '/');
    if (!stat(t->out, &there) && !S_ISREG(there.st_mode))
        return wf_fail(e, WF_EUSAGE, "-o %s: is %s; a file is written, for example -o assessed.csv", t->out,
                       S_ISDIR(there.st_mode) ? "a folder" : "no file");
    const char *folder = !slash            ? "."
                         : slash == t->out ? "/"
                                           : wf_arena_print(&t->arena, "%.*s", (int)(slash - t->out), t->out);
    if (!folder) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    if (!stat(folder, &there) && S_ISDIR(there.st_mode)) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "-o %s: there is no folder %s", t->out, folder);
}

/* The table that is read is not written over, by whatever name it is called. */
static enum wf_status keep_input(const struct table *t, const char *file, struct wf_err *e)
{
    const char *const written[] = { t->out, t->partial, t->note };
    struct stat input, there;
    if (stat(file, &input)) return WF_OK; /* said where it is opened */
    for (size_t k = 0; k < WF_COUNT(written); k++)
        if (!stat(written[k], &there) && there.st_dev == input.st_dev && there.st_ino == input.st_ino)
            return wf_fail(e, WF_EUSAGE,
                           "-o %s: %s is the table that is read, which is not written over; give another "
                           "name, for example -o assessed.csv",
                           t->out, written[k]);
    return WF_OK;
}

static enum wf_status run(struct table *t, const char *file, const char *command, struct wf_err *e)
{
    t->out = t->line->run.output;
    t->command = command;
    if (!t->out)
        return wf_fail(e, WF_EUSAGE, "-o is needed: the table to be written, for example -o assessed.csv");
    size_t n = strlen(t->out);
    if (n > 5 && !strcmp(t->out + n - 5, ".xlsx"))
        return wf_fail(e, WF_EUSAGE,
                       "-o %s: the table is a CSV, for example %.*s.csv; --xlsx writes a workbook beside it",
                       t->out, (int)n - 5, t->out);
    t->partial = wf_arena_print(&t->arena, "%s.partial", t->out);
    t->note = wf_arena_print(&t->arena, "%s.partial.run", t->out);
    if (!t->partial || !t->note) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    enum wf_status s = check_output(t, e);
    if (!s) s = keep_input(t, file, e);
    if (!s && t->line->extremes) s = read_extremes(t, e);
    if (!s) s = wf_rows_open(&t->rows, file, keep_line, t, e);
    if (!s) s = wf_tree_columns_open(&t->columns, &t->rows, t->line, e);
    if (!s) s = wf_input_file_note("table", file, &t->arena, &t->input, e);
    const char *note = s ? NULL : note_text(t, command, e);
    if (s || !note) return e->code;
    if (t->rows.utf16 && !t->line->run.args.quiet)
        wf_show(stderr, "%s: UTF-16; it is read, and the new table written, as UTF-8\n", file);
    if (!t->line->run.args.quiet) wf_tree_columns_say(t->columns, &t->arena);
    if ((s = wf_tree_columns_check(t->columns, e))) return s;
    wf_interrupt_catch();
    wf_progress_watch(NULL);
    keep_memory();
    if ((s = begin_table(t, note, e))) return s;
    if (t->resumed && !t->line->run.args.quiet)
        wf_show(stderr, "goes on after %zu rows of %s\n", t->resumed, t->partial);
    wf_press_open(&t->press, t->line->run.threads);
    s = all_rows(t, e);
    wf_press_close(&t->press);
    if (t->formulas && !t->line->run.args.quiet)
        wf_show(stderr,
                "cells that begin with =, @, + or - and are no numbers: %zu, the first in line %zu; they are "
                "kept, and a spreadsheet may "
                "compute them\n",
                t->formulas, t->first_formula);
    if (t->twice && !t->line->run.args.quiet)
        wf_show(stderr,
                "rows whose tree number was there before: %zu, the first in line %zu; each is assessed by "
                "itself\n",
                t->twice, t->first_twice);
    if (!s && !(t->done + t->mistakes + t->failed)) s = no_trees(t, e);
    if (!s) s = finish(t, e);
    return s || !t->line->run.pages.xlsx ? s : write_workbook(t, e);
}

int wf_assess_table(const char *file, struct wf_assess_options *line, const char *command)
{
    struct table *t = calloc(1, sizeof *t);
    struct wf_err e = { WF_OK, "" };
    int code = 1;
    if (!t) return wf_complain(&(struct wf_err){ WF_ENOMEM, "not enough memory for a table" });
    t->line = line;
    (void)pthread_mutex_init(&t->lock, NULL);
    enum wf_status s = run(t, file, command, &e);
    if (s)
        code = wf_complain(&e);
    else
        code = t->mistakes ? 2 : t->failed ? 1 : 0;
    if (t->to) fclose(t->to);
    (void)pthread_mutex_destroy(&t->lock);
    wf_rows_close(&t->rows);
    wf_tree_columns_close(t->columns);
    wf_arena_free(&t->arena);
    free(t);
    return code;
}
