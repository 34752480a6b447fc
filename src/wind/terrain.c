/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wind/terrain.h"
#include "base/file.h"
#include "base/num.h"
#include "base/random.h"
#include <ctype.h>
#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <string.h>
#include <strings.h>

enum { STREAM_TERRAIN = 0x41 };

/* Sizes of a cell and of a map's coordinates [m]: with smaller cells or larger numbers neighbouring points
 * would have the same coordinates, and the work of a sight line would have no bound. */
#define CELL_LEAST 0.01
#define CELL_MOST 1e5
#define PLACE_MOST 1e9

enum wf_status wf_terrain_alloc(struct wf_terrain *t, size_t columns, size_t rows, double cell,
                                struct wf_arena *a, struct wf_err *e)
{
    *t = (struct wf_terrain){ .columns = columns, .rows = rows, .cell = cell };
    if (columns < 2 || rows < 2 || columns > WF_TERRAIN_MAX || rows > WF_TERRAIN_MAX)
        return wf_fail(e, WF_EINPUT, "a map of %zu columns and %zu rows: 2..%d are allowed", columns, rows,
                       WF_TERRAIN_MAX);
    if (!(cell >= CELL_LEAST && cell <= CELL_MOST))
        return wf_fail(e, WF_EINPUT, "a cell of %g m: 1 cm to 100 km", cell);
    t->z = WF_TAKE(a, columns * rows, double);
    return t->z ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for a map of %zu x %zu", columns, rows);
}

/* Set a height to the mean of the neighbours on the map plus the random draw of its place. */
static void set_height(struct wf_terrain *t, size_t c, size_t r, const int (*offset)[2], int n, size_t reach,
                       double size, uint64_t seed)
{
    double sum = 0.0, count = 0.0;
    for (int i = 0; i < n; i++) {
        long long x = (long long)c + offset[i][0] * (long long)reach,
                  y = (long long)r + offset[i][1] * (long long)reach;
        if (x < 0 || y < 0 || x >= (long long)t->columns || y >= (long long)t->rows) continue;
        sum += t->z[(size_t)y * t->columns + (size_t)x];
        count += 1.0;
    }
    size_t at = r * t->columns + c;
    double draw = wf_random_normal(seed, wf_random_stream(STREAM_TERRAIN, t->columns, 0), at);
    t->z[at] = (count > 0.0 ? sum / count : 0.0) + size * draw;
}

static void scale_to_relief(struct wf_terrain *t, double relief)
{
    double mean = 0.0, square = 0.0, low = INFINITY, n = (double)(t->columns * t->rows);
    for (size_t i = 0; i < t->columns * t->rows; i++) mean += t->z[i] / n;
    for (size_t i = 0; i < t->columns * t->rows; i++) {
        square += (t->z[i] - mean) * (t->z[i] - mean) / n;
        low = fmin(low, t->z[i]);
    }
    for (size_t i = 0; i < t->columns * t->rows; i++) t->z[i] = (t->z[i] - low) * relief / sqrt(square);
}

enum wf_status wf_terrain_make(unsigned n, double cell, double h, double relief, uint64_t seed,
                               struct wf_arena *a, struct wf_terrain *t, struct wf_err *e)
{
    static const int corner[4][2] = { { -1, -1 }, { 1, -1 }, { -1, 1 }, { 1, 1 } };
    static const int edge[4][2] = { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
    if (n < 1 || n > 12) return wf_fail(e, WF_EUSAGE, "terrain size 2^%u + 1: the power is 1..12", n);
    if (!(h >= 0.0 && h <= 1.0)) return wf_fail(e, WF_EUSAGE, "roughness exponent %g is outside 0..1", h);
    if (!(relief > 0.0 && relief <= 5000.0))
        return wf_fail(e, WF_EUSAGE, "relief %g m is outside 0..5000 m", relief);
    size_t side = ((size_t)1 << n) + 1;
    if (wf_terrain_alloc(t, side, side, cell, a, e)) return e ? e->code : WF_EUSAGE;
    double size = 1.0;
    for (size_t r = 0; r < side; r += side - 1)
        for (size_t c = 0; c < side; c += side - 1) set_height(t, c, r, corner, 0, 0, size, seed);
    for (size_t reach = (side - 1) / 2; reach > 0; reach /= 2) {
        size *= pow(2.0, -0.5 * h);
        for (size_t r = reach; r < side; r += 2 * reach)
            for (size_t c = reach; c < side; c += 2 * reach)
                set_height(t, c, r, corner, 4, reach, size, seed);
        size *= pow(2.0, -0.5 * h);
        for (size_t r = 0; r < side; r += reach)
            for (size_t c = (r / reach) % 2 ? 0 : reach; c < side; c += 2 * reach)
                set_height(t, c, r, edge, 4, reach, size, seed);
    }
    scale_to_relief(t, relief);
    return WF_OK;
}

double wf_terrain_height(const struct wf_terrain *t, double x, double y)
{
    double c = (x - t->x0) / t->cell, r = (y - t->y0) / t->cell, slack = 1e-9;
    if (!(c >= -slack && r >= -slack && c <= (double)(t->columns - 1) + slack &&
          r <= (double)(t->rows - 1) + slack))
        return NAN;
    size_t i = (size_t)fmin(fmax(c, 0.0), (double)(t->columns - 2)),
           j = (size_t)fmin(fmax(r, 0.0), (double)(t->rows - 2));
    const double *z = t->z + j * t->columns + i;
    double a = fmin(fmax(c - (double)i, 0.0), 1.0), b = fmin(fmax(r - (double)j, 0.0), 1.0), sum = 0.0;
    /* leave out corners of weight zero, which may have no data */
    if ((1.0 - a) * (1.0 - b) > 0.0) sum += (1.0 - a) * (1.0 - b) * z[0];
    if (a * (1.0 - b) > 0.0) sum += a * (1.0 - b) * z[1];
    if ((1.0 - a) * b > 0.0) sum += (1.0 - a) * b * z[t->columns];
    if (a * b > 0.0) sum += a * b * z[t->columns + 1];
    return sum;
}

/* Largest slope |dz/ds| of the map, by central differences [-]. */
static double terrain_steepest(const struct wf_terrain *t)
{
    double worst = 0.0;
    for (size_t r = 1; r + 1 < t->rows; r++)
        for (size_t c = 1; c + 1 < t->columns; c++) {
            const double *z = t->z + r * t->columns + c;
            double slope = hypot(z[1] - z[-1], z[t->columns] - *(z - t->columns)) / (2.0 * t->cell);
            if (slope > worst) worst = slope;
        }
    return worst;
}

/* ESRI ASCII grids. */

struct grid_text {
    const char *path, *at, *end, *word;
    size_t line, column, size; /* of the current word */
    const char *start;         /* of the line         */
};

/* Move to the next word; false at the end of the text. */
static bool next_word(struct grid_text *t)
{
    while (t->at < t->end && isspace((unsigned char)*t->at))
        if (*t->at++ == '\n') t->line++, t->start = t->at;
    t->word = t->at;
    t->column = (size_t)(t->at - t->start) + 1;
    while (t->at < t->end && !isspace((unsigned char)*t->at)) t->at++;
    t->size = (size_t)(t->at - t->word);
    return t->size > 0;
}

static enum wf_status grid_number(struct grid_text *t, const char *what, double *value, struct wf_err *e)
{
    if (!next_word(t))
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

static enum wf_status read_header(struct grid_text *t, double value[KEYS], struct wf_err *e)
{
    for (int k = 0; k < KEYS; k++) value[k] = NAN;
    for (;;) {
        struct grid_text before = *t;
        if (!next_word(t)) break;
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
        if (grid_number(t, key[k], &value[k], e)) return WF_EINPUT;
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
    if (!(value[CELL] >= CELL_LEAST && value[CELL] <= CELL_MOST))
        return wf_fail(e, WF_EINPUT, "%s: error: %s = %g m: 1 cm to 100 km", t->path, key[CELL], value[CELL]);
    for (int k = 0; k < KEYS; k++)
        if ((k == X || k == Y || k >= X_CENTRE) && fabs(value[k]) > PLACE_MOST)
            return wf_fail(e, WF_EINPUT, "%s: error: %s = %g m: at most %g m from 0", t->path, key[k],
                           value[k], PLACE_MOST);
    return WF_OK;
}

enum wf_status wf_terrain_read(const char *path, struct wf_arena *a, struct wf_terrain *out, struct wf_err *e)
{
    struct wf_bytes bytes;
    double value[KEYS];
    if (wf_file_read_text(path, a, &bytes, e)) return e ? e->code : WF_EINPUT;
    struct grid_text t = {
        .path = path, .at = bytes.data, .end = bytes.data + bytes.size, .line = 1, .start = bytes.data
    };
    if (read_header(&t, value, e)) return WF_EINPUT;
    enum wf_status s = wf_terrain_alloc(out, (size_t)value[COLUMNS], (size_t)value[ROWS], value[CELL], a, e);
    if (s) return s;
    out->x0 = isnan(value[X_CENTRE]) ? value[X] + 0.5 * out->cell : value[X_CENTRE];
    out->y0 = isnan(value[Y_CENTRE]) ? value[Y] + 0.5 * out->cell : value[Y_CENTRE];
    for (size_t r = out->rows; r-- > 0;)
        for (size_t c = 0; c < out->columns; c++) {
            double *z = &out->z[r * out->columns + c];
            if (grid_number(&t, "a height", z, e)) return WF_EINPUT;
            if (*z == value[NODATA])
                *z = NAN;
            else if (fabs(*z) > 12000.0)
                return wf_fail(e, WF_EINPUT,
                               "%s:%zu:%zu: error: height %g m; is the no-data value %g in the header?", path,
                               t.line, t.column, *z, *z);
        }
    if (next_word(&t))
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

/* Shelter by the terrain: elevation angles of the skyline within a distance. */

double wf_terrain_horizon(const struct wf_terrain *t, size_t column, size_t row, double towards,
                          double distance, bool *seen)
{
    double here = t->z[row * t->columns + column], best = NAN, ex = sin(towards), ey = cos(towards);
    double x = t->x0 + (double)column * t->cell, y = t->y0 + (double)row * t->cell;
    /* steps that hit grid points in the diagonal directions too */
    double step = t->cell / fmax(fabs(ex), fabs(ey));
    /* behind the map's edge there is nothing to see, however far the distance */
    double beyond = (hypot((double)t->columns, (double)t->rows) + 2.0) * t->cell,
           most = fmin(distance * (1.0 + 1e-9), beyond);
    *seen = true;
    for (size_t i = 1; (double)i * step <= most; i++) {
        double run = (double)i * step, z = wf_terrain_height(t, x + run * ex, y + run * ey);
        if (isnan(z)) {
            *seen = false;
            continue;
        }
        double angle = atan2(z - here, run);
        if (!(angle <= best)) best = angle;
    }
    return best;
}

double wf_terrain_topex(const struct wf_terrain *t, size_t column, size_t row, double distance, double *seen)
{
    double sum = 0.0, whole = 0.0;
    for (int d = 0; d < 8; d++) {
        bool on_map;
        double angle = wf_terrain_horizon(t, column, row, d * WF_PI / 4.0, distance, &on_map);
        if (!isnan(angle)) sum += angle;
        whole += on_map ? 0.125 : 0.0;
    }
    if (seen) *seen = whole;
    return isnan(t->z[row * t->columns + column]) ? NAN : sum;
}

/* Wind over low hills: the linear response of a neutral wind, by Fourier transform of the map. */

struct map_plane {
    size_t nx, ny;
    double *h; /* complex, ny rows of nx */
    gsl_fft_complex_wavetable *wx, *wy;
    gsl_fft_complex_workspace *sx, *sy;
};

/* The smallest number from n with no prime factors other than 2, 3, 5: a length that transforms fast. */
static size_t smooth_size(size_t n)
{
    for (;; n++) {
        size_t rest = n;
        while (rest % 2 == 0) rest /= 2;
        while (rest % 3 == 0) rest /= 3;
        while (rest % 5 == 0) rest /= 5;
        if (rest == 1) return n;
    }
}

static void free_plane(struct map_plane *p)
{
    if (p->wx) gsl_fft_complex_wavetable_free(p->wx);
    if (p->wy) gsl_fft_complex_wavetable_free(p->wy);
    if (p->sx) gsl_fft_complex_workspace_free(p->sx);
    if (p->sy) gsl_fft_complex_workspace_free(p->sy);
}

static enum wf_status take_plane(struct map_plane *p, const struct wf_terrain *t, struct wf_arena *a,
                                 struct wf_err *e)
{
    p->nx = smooth_size(2 * t->columns - 2);
    p->ny = smooth_size(2 * t->rows - 2);
    p->h = WF_TAKE(a, 2 * p->nx * p->ny, double);
    wf_quiet_begin();
    p->wx = gsl_fft_complex_wavetable_alloc(p->nx);
    p->wy = gsl_fft_complex_wavetable_alloc(p->ny);
    p->sx = gsl_fft_complex_workspace_alloc(p->nx);
    p->sy = gsl_fft_complex_workspace_alloc(p->ny);
    wf_quiet_end();
    if (p->h && p->wx && p->wy && p->sx && p->sy) return WF_OK;
    free_plane(p);
    return wf_fail(e, WF_ENOMEM, "not enough memory for the transform of a map of %zu x %zu", t->columns,
                   t->rows);
}

static void transform_plane(struct map_plane *p, gsl_fft_direction way)
{
    for (size_t r = 0; r < p->ny; r++)
        gsl_fft_complex_transform(p->h + 2 * r * p->nx, 1, p->nx, p->wx, p->sx, way);
    for (size_t c = 0; c < p->nx; c++)
        gsl_fft_complex_transform(p->h + 2 * c, p->nx, p->ny, p->wy, p->sy, way);
}

/* Index into the mirrored map, padded with its first value to an FFT-friendly length: the grid point at place
 * i. */
static size_t mirror_index(size_t i, size_t n) { return i < n ? i : i < 2 * n - 2 ? 2 * n - 2 - i : 0; }

static double wavenumber(size_t i, size_t n, double cell)
{
    double k = i <= n / 2 ? (double)i : (double)i - (double)n;
    return WF_TURN * k / ((double)n * cell);
}

/* Length scale of the terrain [m]: the mean of 1/|k| over all waves, weighted by |k| times their height
 * variance; 1/k for a single wave of wavenumber k. */
static double mean_length(const struct map_plane *p, double cell)
{
    double energy = 0.0, weighted = 0.0;
    for (size_t r = 0; r < p->ny; r++)
        for (size_t c = 0; c < p->nx; c++) {
            const double *h = p->h + 2 * (r * p->nx + c);
            double k = hypot(wavenumber(c, p->nx, cell), wavenumber(r, p->ny, cell)),
                   e2 = h[0] * h[0] + h[1] * h[1];
            energy += k > 0.0 ? e2 : 0.0;
            weighted += k * e2;
        }
    return weighted > 0.0 ? energy / weighted : 0.0;
}

/* Inner-layer height: l ln(l/z0) = 2 kappa^2 L with kappa = 0.4, by Newton's method from above, where the
 * left side is convex. */
static double inner_height(double length, double z0)
{
    double l = fmax(length, 3.0 * z0);
    for (int i = 0; i < 60; i++) l -= (l * log(l / z0) - 0.32 * length) / (log(l / z0) + 1.0);
    return l;
}

static enum wf_status apply_response(const struct wf_terrain *t, const struct wf_speedup_request *q,
                                     struct map_plane *p, struct wf_speedup *out, struct wf_err *e)
{
    double ex = -sin(q->from), ey = -cos(q->from);
    out->length = q->length > 0.0 ? q->length : mean_length(p, t->cell);
    if (!(out->length > 4.0 * q->roughness) && out->length > 0.0)
        return wf_fail(e, WF_EUSAGE, "hills %g m long over a roughness of %g m", out->length, q->roughness);
    out->inner = out->length > 0.0 ? inner_height(out->length, q->roughness) : 0.0;
    double z = fmin(fmax(q->height, out->inner), fmax(out->length, out->inner));
    double ratio = out->length > 0.0 ? log(out->length / q->roughness) / log(z / q->roughness) : 1.0;
    out->gain = ratio * ratio;
    for (size_t r = 0; r < p->ny; r++)
        for (size_t c = 0; c < p->nx; c++) {
            double kx = wavenumber(c, p->nx, t->cell), ky = wavenumber(r, p->ny, t->cell), k = hypot(kx, ky);
            double along = kx * ex + ky * ey;
            double response = k > 0.0 ? out->gain * along * along / k * exp(-k * q->height) : 0.0;
            p->h[2 * (r * p->nx + c)] *= response;
            p->h[2 * (r * p->nx + c) + 1] *= response;
        }
    return WF_OK;
}

enum wf_status wf_terrain_speedup(const struct wf_terrain *t, const struct wf_speedup_request *q,
                                  struct wf_arena *a, struct wf_speedup *out, struct wf_err *e)
{
    struct map_plane p = { 0 };
    double mean = 0.0;
    memset(out, 0, sizeof *out);
    if (!(q->roughness > 0.0 && q->roughness <= 10.0 && q->height > q->roughness && q->height <= 500.0 &&
          q->length >= 0.0))
        return wf_fail(e, WF_EUSAGE,
                       "speed-up at %g m over a roughness of %g m: 0 < z0 <= 10 m, z0 < z <= 500 m",
                       q->height, q->roughness);
    for (size_t i = 0; i < t->rows * t->columns; i++) {
        if (isnan(t->z[i]))
            return wf_fail(
                e, WF_EINPUT,
                "the map has points without data (first at %.9g, %.9g); the speed-up needs a whole map: "
                "fill them, or cut out a part without gaps",
                t->x0 + (double)(i % t->columns) * t->cell, t->y0 + (double)(i / t->columns) * t->cell);
        mean += t->z[i] / (double)(t->rows * t->columns);
    }
    out->ds = WF_TAKE(a, t->rows * t->columns, double);
    if (!out->ds || take_plane(&p, t, a, e))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the speed-up of a map");
    for (size_t r = 0; r < p.ny; r++)
        for (size_t c = 0; c < p.nx; c++)
            p.h[2 * (r * p.nx + c)] =
                t->z[mirror_index(r, t->rows) * t->columns + mirror_index(c, t->columns)] - mean;
    transform_plane(&p, gsl_fft_forward);
    enum wf_status s = apply_response(t, q, &p, out, e);
    if (!s) {
        transform_plane(&p, gsl_fft_backward);
        for (size_t r = 0; r < t->rows; r++)
            for (size_t c = 0; c < t->columns; c++)
                out->ds[r * t->columns + c] = p.h[2 * (r * p.nx + c)] / (double)(p.nx * p.ny);
    }
    out->steepest = terrain_steepest(t);
    free_plane(&p);
    return s;
}

/* A tree on the map. */

bool wf_site_place(const char *text, double *x, double *y)
{
    const char *comma = text ? strchr(text, ',') : NULL, *end = text ? text + strlen(text) : NULL;
    return comma && wf_number_read(text, comma, '.', x) == comma &&
           wf_number_read(comma + 1, end, '.', y) == end;
}

enum wf_status wf_site_read(struct wf_site *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_terrain *t = &s->ground;
    enum wf_status status = wf_terrain_read(s->file, a, t, e);
    if (status) return status;
    double x1 = t->x0 + (double)(t->columns - 1) * t->cell, y1 = t->y0 + (double)(t->rows - 1) * t->cell;
    if (isnan(wf_terrain_height(t, s->x, s->y)))
        return wf_fail(
            e, WF_EUSAGE,
            "%s: the tree at %.9g, %.9g is outside the map or where it has no data; it reaches from %.9g, "
            "%.9g to %.9g, %.9g",
            s->file, s->x, s->y, t->x0, t->y0, x1, y1);
    s->steepest = terrain_steepest(t);
    s->edge = fmin(fmin(s->x - t->x0, x1 - s->x), fmin(s->y - t->y0, y1 - s->y));
    return WF_OK;
}

enum wf_status wf_site_speed_up(const struct wf_site *s, double from, double height, double roughness,
                                double *factor, struct wf_err *e)
{
    const struct wf_speedup_request q = { .from = from, .height = height, .roughness = roughness };
    struct wf_arena scratch = { 0 };
    struct wf_speedup up;
    enum wf_status status = wf_terrain_speedup(&s->ground, &q, &scratch, &up, e);
    if (!status) {
        struct wf_terrain change = s->ground; /* the speed-up on the same grid */
        change.z = up.ds;
        *factor = 1.0 + wf_terrain_height(&change, s->x, s->y);
        if (!wf_speedup_holds(*factor))
            status = wf_fail(
                e, WF_EINPUT,
                "%s: wind from %.1f deg would be %.3g times that over level ground; slopes up to %.2f are "
                "too steep for the linear speed-up",
                s->file, from * 180.0 / WF_PI, *factor, s->steepest);
    }
    wf_arena_free(&scratch);
    return status;
}
