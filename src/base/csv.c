/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Findings. */

void wf_csv_report(struct wf_csv *c, size_t line, size_t column, const char *text)
{
    c->mistakes++;
    if (c->mistakes <= WF_CSV_LISTED) {
        wf_diag_error(c->diag, c->file, line, column, "%s", text);
        return;
    }
    if (c->mistakes == WF_CSV_LISTED + 1)
        wf_diag_error(c->diag, c->file, line, 0, "more than %d mistakes; the rest is counted but not listed",
                      (int)WF_CSV_LISTED);
    else
        c->diag->errors++;
}

void wf_csv_mistake(struct wf_csv *c, size_t column, const char *fmt, ...)
{
    char text[1024];
    int n = 0;
    bool known = column < c->columns;
    if (known) n = snprintf(text, sizeof text, "%.100s: ", c->name[column].text);
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text + n, sizeof text - (size_t)n, fmt, args);
    va_end(args);
    wf_csv_report(c, known ? c->cell[column].line : c->row_line, known ? c->cell[column].column : 0, text);
}

/* Lines and their cells. */

static bool at_line_end(const struct wf_csv *c)
{
    return c->at == c->end || *c->at == '\n' || *c->at == '\r';
}

/* Step over one line end: LF, CR LF or CR. */
static void skip_line_end(struct wf_csv *c)
{
    if (c->at < c->end && *c->at == '\r') c->at++;
    if (c->at < c->end && *c->at == '\n') c->at++;
    c->line++;
}

static void skip_line(struct wf_csv *c)
{
    while (!at_line_end(c)) c->at++;
    if (c->at < c->end) skip_line_end(c);
}

/* Move to the next line that has cells; false at the end of the file. */
static bool seek_row(struct wf_csv *c)
{
    while (c->at < c->end) {
        const char *p = c->at;
        while (p < c->end && (*p == ' ' || (*p == '\t' && c->separator != '\t'))) p++;
        if (p < c->end && *p != '\n' && *p != '\r' && *c->at != '#') return true;
        skip_line(c);
    }
    return false;
}

/* Read a quoted cell from its opening quote and resolve doubled quotes in place. Returned: NULL, or what is
 * wrong. Nothing is written before the closing quote is found, so that reading can continue after a line with
 * unbalanced quotes; the search is bounded, because otherwise each line with an open quote would be searched
 * to the end of the file. */
static const char *quoted_cell(struct wf_csv *c, struct wf_cell *cell)
{
    char *close = c->at + 1, *end = c->end - c->at > WF_CSV_QUOTED ? c->at + WF_CSV_QUOTED : c->end;
    while (close < end && (*close != '"' || (close + 1 < c->end && close[1] == '"')))
        close += *close == '"' ? 2 : 1;
    if (close >= end && end < c->end) return "a quote is opened here and not closed within 64 kB";
    if (close >= c->end) return "a quote is opened here and never closed";
    char *after = close + 1;
    while (after < c->end && *after == ' ') after++;
    if (after < c->end && *after != c->separator && *after != '\n' && *after != '\r')
        return "text follows a closing quote";
    char *to = c->at;
    cell->text = to;
    for (const char *p = c->at + 1; p < close; p++) {
        c->line += *p == '\n';
        p += *p == '"';
        *to++ = *p;
    }
    cell->size = (size_t)(to - cell->text);
    c->at = after;
    return NULL;
}

static const char *unquoted_cell(struct wf_csv *c, struct wf_cell *cell)
{
    const char *trouble = NULL;
    cell->text = c->at;
    for (; !at_line_end(c) && *c->at != c->separator; c->at++)
        if (*c->at == '"') trouble = "a quote inside a cell that does not start with one";
    char *to = c->at;
    while (to > cell->text && (to[-1] == ' ' || to[-1] == '\t')) to--;
    cell->size = (size_t)(to - cell->text);
    return trouble;
}

/* Split one line into at most `max` cells and end each with a NUL. Returned: number of cells in the line (may
 * be larger than max); 0 after a mistake was reported. In both cases the line is read to its end. */
static size_t split_line(struct wf_csv *c, struct wf_cell *cell, size_t max)
{
    const char *start = c->at;
    c->row_line = c->line;
    for (size_t n = 0;;) {
        while (c->at < c->end && (*c->at == ' ' || (*c->at == '\t' && c->separator != '\t'))) c->at++;
        char *from = c->at;
        struct wf_cell spare, *k = n < max ? &cell[n] : &spare;
        *k = (struct wf_cell){ .line = c->line,
                               .column = c->line == c->row_line ? (size_t)(from - start) + 1 : 0 };
        const char *wrong = from < c->end && *from == '"' ? quoted_cell(c, k) : unquoted_cell(c, k);
        if (wrong) {
            c->at = from;
            wf_csv_report(c, k->line, k->column, wrong);
            skip_line(c);
            return 0;
        }
        n++;
        bool more = c->at < c->end && *c->at == c->separator;
        if (more)
            c->at++;
        else if (c->at < c->end)
            skip_line_end(c);
        k->text[k->size] = '\0';
        if (!more) return n;
    }
}

/* The header, and row after row. */

/* Which of comma, semicolon and tab is most frequent in the header outside quotes. */
static char detect_separator(const struct wf_csv *c)
{
    size_t comma = 0, semicolon = 0, tab = 0;
    bool inside = false;
    for (const char *p = c->at; p < c->end && (inside || (*p != '\n' && *p != '\r')); p++) {
        if (*p == '"') inside = !inside;
        if (inside) continue;
        comma += *p == ',';
        semicolon += *p == ';';
        tab += *p == '\t';
    }
    if (tab >= comma && tab >= semicolon && tab) return '\t';
    return semicolon >= comma && semicolon ? ';' : ',';
}

static void report_double_names(struct wf_csv *c)
{
    char text[256];
    for (size_t i = 0; i < c->columns; i++)
        for (size_t j = 0; *c->name[i].text && j < i; j++)
            if (!strcasecmp(c->name[i].text, c->name[j].text)) {
                (void)snprintf(text, sizeof text, "column '%.100s' occurs twice", c->name[i].text);
                wf_csv_report(c, c->name[i].line, c->name[i].column, text);
                break;
            }
}

enum wf_status wf_csv_open(struct wf_csv *c, const char *file, struct wf_arena *a, struct wf_diag *d,
                           struct wf_err *e)
{
    struct wf_bytes b;
    *c = (struct wf_csv){ .file = file, .line = 1, .separator = ',', .diag = d };
    enum wf_status code = wf_file_read_text(file, a, &b, e);
    if (code) return code;
    c->at = b.data;
    c->end = b.data + b.size;
    if (!seek_row(c)) return wf_fail(e, WF_EINPUT, "%s: the table is empty: a header row is expected", file);
    c->separator = detect_separator(c);
    struct wf_cell *wide = WF_TAKE(a, WF_CSV_COLUMNS, struct wf_cell);
    if (!wide) return wf_fail(e, WF_ENOMEM, "%s: no memory for the header", file);
    size_t before = c->mistakes;
    c->columns = split_line(c, wide, WF_CSV_COLUMNS);
    if (c->columns > WF_CSV_COLUMNS)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: more than %d columns", file, c->row_line,
                       (int)WF_CSV_COLUMNS);
    c->name = wide;
    c->cell = WF_TAKE(a, c->columns, struct wf_cell);
    if (!c->cell) return wf_fail(e, WF_ENOMEM, "%s: no memory for %zu columns", file, c->columns);
    report_double_names(c);
    if (c->mistakes > before) return wf_fail(e, WF_EINPUT, "%s: the header row is not usable", file);
    return WF_OK;
}

bool wf_csv_next(struct wf_csv *c)
{
    while (seek_row(c)) {
        size_t n = split_line(c, c->cell, c->columns);
        c->row++;
        if (n == c->columns) return true;
        if (!n) continue;
        char text[128];
        (void)snprintf(text, sizeof text, "%zu cells, the header has %zu", n, c->columns);
        wf_csv_report(c, c->row_line, 0, text);
    }
    return false;
}

/* Columns by name, and cells as numbers. */

size_t wf_csv_column(const struct wf_csv *c, const char *name)
{
    for (size_t i = 0; i < c->columns; i++)
        if (!strcasecmp(c->name[i].text, name)) return i;
    return WF_CSV_NONE;
}

size_t wf_csv_need(struct wf_csv *c, const char *name)
{
    size_t found = wf_csv_column(c, name), best = 0, least = (size_t)-1;
    if (found != WF_CSV_NONE) return found;
    for (size_t i = 0; i < c->columns; i++) {
        size_t d = wf_word_distance(name, c->name[i].text);
        if (d < least) {
            least = d;
            best = i;
        }
    }
    char text[1024];
    size_t line = c->columns ? c->name[0].line : 0;
    if (wf_word_is_near(name, least)) {
        (void)snprintf(text, sizeof text, "column '%s' is missing; is it '%.60s'?", name, c->name[best].text);
        wf_csv_report(c, line, c->name[best].column, text);
        return WF_CSV_NONE;
    }
    int n = snprintf(text, sizeof text, "column '%s' is missing; the header has: ", name);
    for (size_t i = 0; i < c->columns && n > 0 && (size_t)n < sizeof text; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%.60s", i ? ", " : "", c->name[i].text);
    wf_csv_report(c, line, 0, text);
    return WF_CSV_NONE;
}

const char *wf_csv_text(const struct wf_csv *c, size_t column)
{
    return column < c->columns ? c->cell[column].text : "";
}

/* The decimal sign of a cell: a point, or a comma where cells are not separated by commas. The first number
 * with decimals decides for the whole file. Returned: 0 after a mistake was reported. */
static char csv_decimal_sign(struct wf_csv *c, size_t column, const struct wf_cell *k)
{
    bool comma = c->separator != ',' && memchr(k->text, ',', k->size) != NULL;
    bool point = memchr(k->text, '.', k->size) != NULL;
    if (!comma && !point) return '.';
    char sign = comma ? ',' : '.';
    if (!c->point) c->point = sign;
    if (c->point == sign && !(comma && point)) return sign;
    wf_csv_mistake(c, column, "'%.40s': decimal comma and decimal point are mixed in this file", k->text);
    return 0;
}

bool wf_csv_number(struct wf_csv *c, size_t column, double low, double high, double *value)
{
    if (column >= c->columns) return false;
    const struct wf_cell *k = &c->cell[column];
    if (!k->size) {
        wf_csv_mistake(c, column, "is empty, a number is expected");
        return false;
    }
    char sign = csv_decimal_sign(c, column, k);
    if (!sign) return false;
    double v = 0.0;
    const char *end = k->text + k->size, *stop = wf_number_read(k->text, end, sign, &v);
    if (stop != end) {
        wf_csv_mistake(c, column, "'%.40s' is not a number", k->text);
        return false;
    }
    if (!(v >= low && v <= high)) {
        wf_csv_mistake(c, column, "%.40s is outside %g to %g", k->text, low, high);
        return false;
    }
    *value = v;
    return true;
}

bool wf_csv_integer(struct wf_csv *c, size_t column, long long low, long long high, long long *value)
{
    if (column >= c->columns) return false;
    const struct wf_cell *k = &c->cell[column];
    size_t i = k->size && (*k->text == '-' || *k->text == '+') ? 1 : 0;
    bool negative = i && *k->text == '-', ok = k->size > i && k->size - i <= 18;
    long long v = 0;
    for (; ok && i < k->size; i++) {
        ok = k->text[i] >= '0' && k->text[i] <= '9';
        v = v * 10 + (k->text[i] - '0');
    }
    if (!ok) {
        if (k->size)
            wf_csv_mistake(c, column, "'%.40s' is not a whole number", k->text);
        else
            wf_csv_mistake(c, column, "is empty, a whole number is expected");
        return false;
    }
    v = negative ? -v : v;
    if (v < low || v > high) {
        wf_csv_mistake(c, column, "%.40s is outside %lld to %lld", k->text, low, high);
        return false;
    }
    *value = v;
    return true;
}
