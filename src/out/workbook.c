/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/workbook.h"
#include "base/file.h"
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef WF_XLSX

static const char missing[] =
    "this program was built without libxlsxwriter (Debian: libxlsxwriter-dev); it writes no workbook";

enum wf_status wf_workbook_make(const char *folder, struct wf_diag *d, struct wf_err *e)
{
    (void)folder, (void)d;
    return wf_fail(e, WF_EMISSING, "%s", missing);
}
enum wf_status wf_workbook_open(struct wf_workbook **out, const char *path, const char *sheet,
                                struct wf_err *e)
{
    (void)path, (void)sheet;
    *out = NULL;
    return wf_fail(e, WF_EMISSING, "%s", missing);
}
void wf_workbook_cell(struct wf_workbook *w, size_t row, size_t column, const char *text, bool numbers)
{
    (void)w, (void)row, (void)column, (void)text, (void)numbers;
}
enum wf_status wf_workbook_close(struct wf_workbook *w, struct wf_err *e) { return (void)w, (void)e, WF_OK; }

#else
#include "base/csv.h"
#include <xlsxwriter.h>

enum { SHEET_NAME = 31, CELL_MAX = 32767 }; /* characters, of the format */

struct wf_workbook {
    lxw_workbook *book;
    lxw_worksheet *sheet;
    lxw_format *head;
    struct wf_file file; /* its stream is closed: the library writes to its name */
    lxw_error first;     /* that was met */
};

static void note(struct wf_workbook *w, lxw_error error)
{
    if (w->first == LXW_NO_ERROR) w->first = error;
}

static enum wf_status begin(struct wf_workbook *w, const char *path, struct wf_err *e)
{
    /* in constant memory rows go to temporary files; texts are in the cells, not in a table of all texts */
    lxw_workbook_options options = { .constant_memory = LXW_TRUE };
    enum wf_status s = wf_file_begin(&w->file, path, e);
    if (s) return s;
    const char *name = w->file.temporary[0] ? w->file.temporary : path;
    if (!(w->book = workbook_new_opt(name, &options))) {
        wf_file_abandon(&w->file);
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a workbook", path);
    }
    lxw_doc_properties fixed = { .created = 315532800 }; /* 1980: the same tables give the same bytes */
    note(w, workbook_set_properties(w->book, &fixed));
    w->head = workbook_add_format(w->book);
    if (w->head) format_set_bold(w->head);
    return WF_OK;
}

/* A sheet; characters that a sheet's name must not have become '_'. */
static void add_sheet(struct wf_workbook *w, const char *name)
{
    char safe[SHEET_NAME + 1];
    (void)snprintf(safe, sizeof safe, "%.*s", SHEET_NAME, name);
    for (char *s = safe; *s; s++)
        if (strchr("[]:*?/\\'", *s) || (unsigned char)*s >= 128) *s = '_';
    w->sheet = workbook_add_worksheet(w->book, safe);
    if (w->sheet)
        worksheet_freeze_panes(w->sheet, 1, 0);
    else
        note(w, LXW_ERROR_MEMORY_MALLOC_FAILED);
}

static bool is_number(const char *text, double *value)
{
    char *end;
    if (!strspn(text, "+-.0123456789")) return false;
    *value = strtod(text, &end);
    return end != text && !*end && isfinite(*value) && !strpbrk(text, "xXpP");
}

void wf_workbook_cell(struct wf_workbook *w, size_t row, size_t column, const char *text, bool numbers)
{
    double value;
    char cut[CELL_MAX + 1];
    if (!w->sheet || !*text || row >= LXW_ROW_MAX || column >= LXW_COL_MAX) return;
    if (numbers && row && is_number(text, &value)) {
        note(w, worksheet_write_number(w->sheet, (lxw_row_t)row, (lxw_col_t)column, value, NULL));
        return;
    }
    if (strlen(text) > CELL_MAX) {
        size_t n = CELL_MAX;
        while (n && ((unsigned char)text[n] & 0xc0) == 0x80) n--;
        memcpy(cut, text, n), cut[n] = '\0', text = cut;
    }
    note(w, worksheet_write_string(w->sheet, (lxw_row_t)row, (lxw_col_t)column, text, row ? NULL : w->head));
}

/* Close the book, which frees it; its file stays only where `keep` is true and nothing failed. */
static enum wf_status finish(struct wf_workbook *w, bool keep, struct wf_err *e)
{
    note(w, workbook_close(w->book));
    if (keep && w->first == LXW_NO_ERROR) return wf_file_commit(&w->file, e);
    wf_file_abandon(&w->file);
    return keep ? wf_fail(e, WF_EOUTPUT, "%s: %s", w->file.path, lxw_strerror(w->first)) : WF_OK;
}

enum wf_status wf_workbook_open(struct wf_workbook **out, const char *path, const char *sheet,
                                struct wf_err *e)
{
    struct wf_workbook *w = calloc(1, sizeof *w);
    *out = NULL;
    if (!w) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a workbook", path);
    enum wf_status s = begin(w, path, e);
    if (s) return free(w), s;
    add_sheet(w, sheet);
    *out = w;
    return WF_OK;
}

enum wf_status wf_workbook_close(struct wf_workbook *w, struct wf_err *e)
{
    enum wf_status s = w ? finish(w, true, e) : WF_OK;
    free(w);
    return s;
}

void wf_workbook_abandon(struct wf_workbook *w)
{
    (void)finish(w, false, NULL);
    free(w);
}

/* ---- A results folder ---- */

static enum wf_status copy_table(struct wf_workbook *w, const char *path, const char *name, struct wf_diag *d,
                                 struct wf_err *e)
{
    struct wf_arena arena = { 0 };
    struct wf_diag inner = { .arena = &arena };
    struct wf_csv csv = { 0 };
    size_t row = 0;
    enum wf_status s = wf_csv_open(&csv, path, &arena, &inner, e);
    if (!s) add_sheet(w, name);
    for (size_t c = 0; !s && c < csv.columns; c++) wf_workbook_cell(w, 0, c, csv.name[c].text, false);
    while (!s && row < LXW_ROW_MAX && wf_csv_next(&csv)) {
        row++;
        for (size_t c = 0; c < csv.columns; c++) wf_workbook_cell(w, row, c, wf_csv_text(&csv, c), true);
    }
    if (!s && row >= LXW_ROW_MAX)
        wf_diag_warn(d, "workbook-cut", "%s: a sheet of the workbook holds %d rows; the table has more", name,
                     LXW_ROW_MAX - 1);
    wf_arena_free(&arena);
    return s;
}

static int is_table(const struct dirent *f)
{
    size_t n = strlen(f->d_name);
    return f->d_name[0] != '.' && n > 4 && strcmp(f->d_name + n - 4, ".csv") == 0;
}

enum wf_status wf_workbook_make(const char *folder, struct wf_diag *d, struct wf_err *e)
{
    struct wf_workbook w = { 0 };
    struct dirent **list;
    char path[WF_PATH_MAX], name[256];
    (void)snprintf(path, sizeof path, "%s/tables", folder);
    int n = scandir(path, &list, is_table, alphasort);
    if (n < 0) return wf_fail(e, WF_EOUTPUT, "%s: %s", path, strerror(errno));
    (void)snprintf(path, sizeof path, "%s/" WF_WORKBOOK, folder);
    enum wf_status s = n ? begin(&w, path, e) : WF_OK;
    for (int i = 0; i < n && !s; i++) {
        (void)snprintf(name, sizeof name, "%.*s", (int)strlen(list[i]->d_name) - 4, list[i]->d_name);
        (void)snprintf(path, sizeof path, "%s/tables/%s", folder, list[i]->d_name);
        s = copy_table(&w, path, name, d, e);
    }
    if (w.book) {
        enum wf_status closed = finish(&w, !s, e);
        s = s ? s : closed;
    }
    for (int i = 0; i < n; i++) free(list[i]);
    free(list);
    return s;
}
#endif
