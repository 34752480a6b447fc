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

bool wf_csv_sheet_error(const char *text, size_t n)
{
    if (!n || *text != '#' || memchr(text, ' ', n)) return false;
    return text[n - 1] == '!' || text[n - 1] == '?' || (n == 4 && !strncasecmp(text, "#N/A", n)) ||
           (n == 3 && !strncasecmp(text, "#NV", n));
}

bool wf_csv_missing(const char *text, size_t n)
{
    static const char *const words[] = { "-",    "--",   "NA",  "N/A",      "NaN",    "nil",
                                         "null", "none", "inf", "Infinity", "missing" };
    if (!n || wf_csv_sheet_error(text, n)) return true;
    size_t sign = n > 1 && (*text == '-' || *text == '+');
    if (text[sign] >= '0' && text[sign] <= '9') return false; /* most cells: a number */
    for (size_t i = 0; i < WF_COUNT(words); i++) {
        size_t size = strlen(words[i]);
        if ((size == n && !strncasecmp(text, words[i], n)) ||
            (size == n - sign && !strncasecmp(text + sign, words[i], size)))
            return true;
    }
    return false;
}

/* Is the line a comment? One that begins with a cell of a spreadsheet's error, "#N/A,...", is a row. */
static bool is_comment(const struct wf_csv *c)
{
    const char *end = c->at;
    if (*end != '#') return false;
    while (end < c->end && *end != c->separator && *end != '\n' && *end != '\r') end++;
    return !wf_csv_sheet_error(c->at, (size_t)(end - c->at));
}

/* Move to the next line that has cells; false at the end of the file. */
static bool seek_row(struct wf_csv *c)
{
    while (c->at < c->end) {
        const char *p = c->at;
        while (p < c->end && (*p == ' ' || (*p == '\t' && c->separator != '\t'))) p++;
        if (p < c->end && *p != '\n' && *p != '\r' && !is_comment(c)) return true;
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

/* Heads of loggers. */

static bool is_toa5(const struct wf_csv *c)
{
    const char *p = c->at < c->end && *c->at == '"' ? c->at + 1 : c->at;
    return c->end - p > 5 && !memcmp(p, "TOA5", 4) && (p[4] == '"' || p[4] == ',');
}

static bool is_tob(const struct wf_csv *c)
{
    return c->end - c->at > 7 && !memcmp(c->at, "\"TOB", 4) && c->at[4] >= '1' && c->at[4] <= '3' &&
           c->at[5] == '"';
}

/* Whether the first line is "[word]". */
static bool is_sections(const struct wf_csv *c)
{
    size_t n = 0;
    while (c->at + n < c->end && c->at[n] != '\n' && c->at[n] != '\r') n++;
    while (n && (c->at[n - 1] == ' ' || c->at[n - 1] == '\t')) n--;
    return n > 2 && *c->at == '[' && c->at[n - 1] == ']' && !memchr(c->at, ',', n);
}

/* Whether the first 13 lines are one cell each, the 4th to the last of them KEY=VALUE. */
static bool is_linescale(const struct wf_csv *c)
{
    const char *p = c->at;
    for (int line = 1; line <= 13; line++) {
        const char *end = memchr(p, '\n', (size_t)(c->end - p));
        if (!end || memchr(p, ',', (size_t)(end - p)) || memchr(p, ';', (size_t)(end - p))) return false;
        if (line > 3 && !memchr(p, '=', (size_t)(end - p))) return false;
        p = end + 1;
    }
    return true;
}

const struct wf_csv_head wf_csv_heads[] = {
    { .name = "Campbell Scientific TOA5",
      .source = "Campbell Scientific, LoggerNet manual, appendix B.1.4",
      .is = is_toa5,
      .before = 1,
      .after = 2,
      .units = 1 },
    { .name = "Campbell Scientific TOB1, TOB2 or TOB3",
      .source = "Campbell Scientific, LoggerNet manual, appendix B.1.5",
      .is = is_tob,
      .refused = "its rows are binary; convert it to TOA5 with the logger's own program" },
    { .name = "sections as of PiCUS TreeQinetic",
      .source = "Jensen K. (2023), treeqinetic 1.0.0, a reader of these files",
      .is = is_sections,
      .section = "data" },
    { .name = "LineScale 3",
      .source = "Jensen K. (2023), linescale3, a reader of these files",
      .is = is_linescale,
      .refused =
          "its rows have no names and no times; replace its 13 lines by one with the column's name and unit "
          "as in line 5, for example force_kN, and give the rate" },
    { 0 },
};

/* Move to the line after "[section]"; false: there is none. */
static bool seek_section(struct wf_csv *c, const char *section)
{
    size_t n = strlen(section);
    while (c->at < c->end) {
        const char *p = c->at;
        bool found =
            (size_t)(c->end - p) > n + 2 && *p == '[' && !strncasecmp(p + 1, section, n) && p[n + 1] == ']';
        skip_line(c);
        if (found) return true;
    }
    return false;
}

/* Recognise the head of a logger and move to its header row. */
static enum wf_status skip_head(struct wf_csv *c, struct wf_err *e)
{
    for (const struct wf_csv_head *h = wf_csv_heads; h->name && !c->head; h++)
        if (h->is(c)) c->head = h;
    if (!c->head) return WF_OK;
    if (c->head->refused)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: a file of %s is not read: %s", c->file, c->line,
                       c->head->name, c->head->refused);
    for (size_t i = 0; i < c->head->before; i++) skip_line(c);
    if (c->head->section && !seek_section(c, c->head->section))
        return wf_fail(e, WF_EINPUT, "%s:1: error: sections without [%s]", c->file, c->head->section);
    return seek_row(c) ? WF_OK : wf_fail(e, WF_EINPUT, "%s: no header row follows the head", c->file);
}

/* Read the lines between the header row and the data. */
static enum wf_status read_units(struct wf_csv *c, struct wf_arena *a, struct wf_err *e)
{
    for (size_t i = 1; c->head && i <= c->head->after; i++) {
        if (i != c->head->units) {
            skip_line(c);
            continue;
        }
        size_t n = split_line(c, c->cell, c->columns);
        c->unit = WF_TAKE(a, c->columns, const char *);
        if (!c->unit) return wf_fail(e, WF_ENOMEM, "%s: no memory for %zu columns", c->file, c->columns);
        if (n != c->columns)
            return wf_fail(e, WF_EINPUT, "%s:%zu: error: %zu units for %zu columns", c->file, c->row_line, n,
                           c->columns);
        for (size_t k = 0; k < n; k++) c->unit[k] = c->cell[k].text;
    }
    return WF_OK;
}

/* Missing marks. */

bool wf_csv_declare(struct wf_csv *c, const char *list)
{
    const char *p = list + strspn(list, " \t"), *end = p + strcspn(p, "\r\n");
    while (p < end) {
        double v;
        const char *stop = wf_number_read(p, end, '.', &v);
        if (!stop || c->marks == WF_CSV_MARKS) return false;
        p = stop + strspn(stop, " \t");
        if (p < end && *p != ',' && *p != ';') return false;
        c->mark[c->marks++] = v;
        p += p < end;
        p += strspn(p, " \t");
    }
    return true;
}

/* Take marks from comment lines before the header, "# missing: -99.9" or "# missing value = -99.9". */
static enum wf_status declared_marks(struct wf_csv *c, struct wf_err *e)
{
    size_t line = c->line;
    for (const char *p = c->at; p < c->end && *p == '#'; line++) {
        const char *end = memchr(p, '\n', (size_t)(c->end - p)), *word = p + 1 + strspn(p + 1, "# \t");
        if (!strncasecmp(word, "missing", 7)) {
            word += strcspn(word, ":=\n");
            if (*word == ':' || *word == '=')
                if (!wf_csv_declare(c, word + 1))
                    return wf_fail(e, WF_EINPUT,
                                   "%s:%zu: error: missing marks are numbers separated by commas, at "
                                   "most %d, as in '# missing: -99.9, 999'",
                                   c->file, line, (int)WF_CSV_MARKS);
        }
        p = end ? end + 1 : c->end;
    }
    return WF_OK;
}

enum wf_status wf_csv_open(struct wf_csv *c, const char *file, struct wf_arena *a, struct wf_diag *d,
                           struct wf_err *e)
{
    struct wf_bytes b;
    *c = (struct wf_csv){ .file = file, .line = 1, .separator = ',', .diag = d };
    enum wf_status code = wf_file_read_table(file, a, &b, d, e);
    if (code) return code;
    c->at = b.data;
    c->end = b.data + b.size;
    if ((code = declared_marks(c, e))) return code;
    if (!seek_row(c)) return wf_fail(e, WF_EINPUT, "%s: the table is empty: a header row is expected", file);
    if ((code = skip_head(c, e))) return code;
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
    return read_units(c, a, e);
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
 * with decimals decides for the whole file. Returned: 0 when the cell has the other sign. */
static char csv_decimal_sign(const struct wf_csv *c, const struct wf_cell *k)
{
    bool comma = c->separator != ',' && memchr(k->text, ',', k->size) != NULL;
    bool point = memchr(k->text, '.', k->size) != NULL;
    if (!comma && !point) return '.';
    char sign = comma ? ',' : '.';
    return (!c->point || c->point == sign) && !(comma && point) ? sign : 0;
}

enum wf_csv_kind wf_csv_value(struct wf_csv *c, size_t column, double *value)
{
    const struct wf_cell *k = &c->cell[column];
    if (wf_csv_missing(k->text, k->size)) return WF_CSV_MISSING;
    char sign = csv_decimal_sign(c, k);
    const char *end = k->text + k->size, *stop = wf_number_read(k->text, end, sign ? sign : ',', value);
    if (stop != end && !sign) stop = wf_number_read(k->text, end, '.', value);
    if (stop != end) return sign || !stop ? WF_CSV_WORD : WF_CSV_MIXED;
    if (!sign) return WF_CSV_MIXED;
    if (!c->point && memchr(k->text, sign, k->size)) c->point = sign;
    return WF_CSV_NUMBER;
}

enum wf_csv_kind wf_csv_reading(struct wf_csv *c, size_t column, double *value)
{
    enum wf_csv_kind kind = wf_csv_value(c, column, value);
    for (size_t i = 0; kind == WF_CSV_NUMBER && i < c->marks; i++)
        if (*value == c->mark[i]) kind = WF_CSV_MISSING;
    return kind;
}

bool wf_csv_number(struct wf_csv *c, size_t column, double low, double high, double *value)
{
    if (column >= c->columns) return false;
    const struct wf_cell *k = &c->cell[column];
    double v = 0.0;
    enum wf_csv_kind kind = wf_csv_value(c, column, &v);
    if (!k->size)
        wf_csv_mistake(c, column, "is empty, a number is expected");
    else if (kind == WF_CSV_MIXED)
        wf_csv_mistake(c, column, "'%.40s': decimal comma and decimal point are mixed in this file", k->text);
    else if (kind != WF_CSV_NUMBER)
        wf_csv_mistake(c, column, "'%.40s' is not a number", k->text);
    else if (!(v >= low && v <= high))
        wf_csv_mistake(c, column, "%.40s is outside %g to %g", k->text, low, high);
    else
        return *value = v, true;
    return false;
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
