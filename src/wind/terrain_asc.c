/* ESRI ASCII grids. */
#include "base/file.h"
#include "base/number.h"
#include "wind/terrain.h"
#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

struct text {
    const char *path, *at, *end, *word;
    size_t line, column, size; /* of the word in hand */
    const char *start;         /* of the line         */
};

/* The next word; false at the end. */
static bool next(struct text *t)
{
    while (t->at < t->end && isspace((unsigned char)*t->at))
        if (*t->at++ == '\n') t->line++, t->start = t->at;
    t->word = t->at;
    t->column = (size_t)(t->at - t->start) + 1;
    while (t->at < t->end && !isspace((unsigned char)*t->at)) t->at++;
    t->size = (size_t)(t->at - t->word);
    return t->size > 0;
}

static enum wf_status number(struct text *t, const char *what, double *value, struct wf_err *e)
{
    if (!next(t))
        return wf_fail(e, WF_EINPUT, "%s:%zu:%zu: error: the file ends where %s is expected", t->path,
                       t->line, t->column, what);
    const char *end = wf_number_read(t->word, t->word + t->size, '.', value);
    if (end == t->word + t->size) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s:%zu:%zu: error: %s: expected a number, got '%.*s'", t->path, t->line,
                   t->column, what, (int)(t->size < 40 ? t->size : 40), t->word);
}

enum { COLUMNS, ROWS, X, Y, CELL, NODATA, X_CENTRE, Y_CENTRE, KEYS };
static const char *const key[KEYS] = { "ncols",    "nrows",        "xllcorner", "yllcorner",
                                       "cellsize", "nodata_value", "xllcenter", "yllcenter" };

static enum wf_status header(struct text *t, double value[KEYS], struct wf_err *e)
{
    for (int k = 0; k < KEYS; k++) value[k] = NAN;
    for (;;) {
        struct text before = *t;
        if (!next(t)) break;
        if (!isalpha((unsigned char)t->word[0]) || strncasecmp(t->word, "nan", t->size) == 0) {
            *t = before;
            break;
        }
        int k = 0;
        while (k < KEYS && !(strlen(key[k]) == t->size && strncasecmp(key[k], t->word, t->size) == 0)) k++;
        if (k == KEYS)
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu:%zu: error: unknown header word '%.*s'; an ESRI ASCII grid has ncols, "
                           "nrows, xllcorner, "
                           "yllcorner, cellsize, nodata_value",
                           t->path, t->line, t->column, (int)(t->size < 40 ? t->size : 40), t->word);
        if (number(t, key[k], &value[k], e)) return WF_EINPUT;
    }
    for (int k = COLUMNS; k <= CELL; k++) {
        bool centre = (k == X && !isnan(value[X_CENTRE])) || (k == Y && !isnan(value[Y_CENTRE]));
        if (isnan(value[k]) && !centre)
            return wf_fail(e, WF_EINPUT, "%s: error: the header has no %s", t->path, key[k]);
    }
    for (int k = COLUMNS; k <= ROWS; k++)
        if (!(value[k] >= 2.0 && value[k] <= WF_TERRAIN_MAX && value[k] == floor(value[k])))
            return wf_fail(e, WF_EINPUT, "%s: error: %s = %g: a whole number 2..%d", t->path, key[k],
                           value[k], WF_TERRAIN_MAX);
    if (!(value[CELL] > 0.0 && value[CELL] <= 1e5))
        return wf_fail(e, WF_EINPUT, "%s: error: %s = %g m: above 0, at most 100 km", t->path, key[CELL],
                       value[CELL]);
    return WF_OK;
}

enum wf_status wf_terrain_read(const char *path, struct wf_arena *a, struct wf_terrain *out, struct wf_err *e)
{
    struct wf_bytes bytes;
    double value[KEYS];
    if (wf_file_read_text(path, a, &bytes, e)) return e ? e->code : WF_EINPUT;
    struct text t = {
        .path = path, .at = bytes.data, .end = bytes.data + bytes.size, .line = 1, .start = bytes.data
    };
    if (header(&t, value, e)) return WF_EINPUT;
    enum wf_status s = wf_terrain_alloc(out, (size_t)value[COLUMNS], (size_t)value[ROWS], value[CELL], a, e);
    if (s) return s;
    out->x0 = isnan(value[X_CENTRE]) ? value[X] + 0.5 * out->cell : value[X_CENTRE];
    out->y0 = isnan(value[Y_CENTRE]) ? value[Y] + 0.5 * out->cell : value[Y_CENTRE];
    for (size_t r = out->rows; r-- > 0;)
        for (size_t c = 0; c < out->columns; c++) {
            double *z = &out->z[r * out->columns + c];
            if (number(&t, "a height", z, e)) return WF_EINPUT;
            if (*z == value[NODATA])
                *z = NAN;
            else if (fabs(*z) > 12000.0)
                return wf_fail(e, WF_EINPUT,
                               "%s:%zu:%zu: error: height %g m; is the no-data value %g in the header?", path,
                               t.line, t.column, *z, *z);
        }
    if (next(&t))
        return wf_fail(e, WF_EINPUT, "%s:%zu:%zu: error: more heights than ncols x nrows = %zu", path, t.line,
                       t.column, out->rows * out->columns);
    return WF_OK;
}

enum wf_status wf_terrain_write(const char *path, const struct wf_terrain *t, const double *values,
                                struct wf_err *e)
{
    struct wf_file f;
    const double *z = values ? values : t->z;
    if (wf_file_begin(&f, path, e)) return e ? e->code : WF_EOUTPUT;
    fprintf(f.stream,
            "ncols %zu\nnrows %zu\nxllcorner %.12g\nyllcorner %.12g\ncellsize %.12g\nNODATA_value -9999\n",
            t->columns, t->rows, t->x0 - 0.5 * t->cell, t->y0 - 0.5 * t->cell, t->cell);
    for (size_t r = t->rows; r-- > 0;)
        for (size_t c = 0; c < t->columns; c++) {
            double v = z[r * t->columns + c];
            fprintf(f.stream, "%.7g%c", isnan(v) ? -9999.0 : v, c + 1 < t->columns ? ' ' : '\n');
        }
    return wf_file_commit(&f, e);
}
