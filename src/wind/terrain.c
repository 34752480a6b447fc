#include "wind/terrain.h"
#include "base/random.h"
#include <math.h>

enum { STREAM_TERRAIN = 0x41 };

enum wf_status wf_terrain_alloc(struct wf_terrain *t, size_t columns, size_t rows, double cell,
                                struct wf_arena *a, struct wf_err *e)
{
    *t = (struct wf_terrain){ .columns = columns, .rows = rows, .cell = cell };
    if (columns < 2 || rows < 2 || columns > WF_TERRAIN_MAX || rows > WF_TERRAIN_MAX)
        return wf_fail(e, WF_EINPUT, "a map of %zu columns and %zu rows: 2..%d are taken", columns, rows,
                       WF_TERRAIN_MAX);
    if (!(cell > 0.0 && cell <= 1e5))
        return wf_fail(e, WF_EINPUT, "a cell of %g m: above 0, at most 100 km", cell);
    t->z = WF_TAKE(a, columns * rows, double);
    return t->z ? WF_OK : wf_fail(e, WF_ENOMEM, "no room for a map of %zu x %zu", columns, rows);
}

/* Mean of the neighbours that exist plus the draw of this place. */
static void set(struct wf_terrain *t, size_t c, size_t r, const int (*offset)[2], int n, size_t reach,
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

static void scale_to(struct wf_terrain *t, double relief)
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
        for (size_t c = 0; c < side; c += side - 1) set(t, c, r, corner, 0, 0, size, seed);
    for (size_t reach = (side - 1) / 2; reach > 0; reach /= 2) {
        size *= pow(2.0, -0.5 * h);
        for (size_t r = reach; r < side; r += 2 * reach)
            for (size_t c = reach; c < side; c += 2 * reach) set(t, c, r, corner, 4, reach, size, seed);
        size *= pow(2.0, -0.5 * h);
        for (size_t r = 0; r < side; r += reach)
            for (size_t c = (r / reach) % 2 ? 0 : reach; c < side; c += 2 * reach)
                set(t, c, r, edge, 4, reach, size, seed);
    }
    scale_to(t, relief);
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
    /* a corner of weight zero may be without data */
    if ((1.0 - a) * (1.0 - b) > 0.0) sum += (1.0 - a) * (1.0 - b) * z[0];
    if (a * (1.0 - b) > 0.0) sum += a * (1.0 - b) * z[1];
    if ((1.0 - a) * b > 0.0) sum += (1.0 - a) * b * z[t->columns];
    if (a * b > 0.0) sum += a * b * z[t->columns + 1];
    return sum;
}

double wf_terrain_steepest(const struct wf_terrain *t)
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
