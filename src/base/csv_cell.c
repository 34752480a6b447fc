/* Columns by name, and cells as numbers. */
#include "base/csv.h"
#include "base/near.h"
#include "base/number.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

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

/* The decimal sign of a cell: a point, or a comma where cells are not separated by commas. The first number
 * with decimals decides for the file. Returned: 0 after a finding. */
static char decimal_sign(struct wf_csv *c, size_t column, const struct wf_cell *k)
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
    char sign = decimal_sign(c, column, k);
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
