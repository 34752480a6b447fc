/* Shelter by the ground itself: angles to the skyline within a distance. */
#include "wind/terrain.h"
#include <math.h>

#define PI 3.14159265358979323846

double wf_terrain_horizon(const struct wf_terrain *t, size_t column, size_t row, double towards,
                          double distance, bool *seen)
{
    double here = t->z[row * t->columns + column], best = NAN, ex = sin(towards), ey = cos(towards);
    double x = t->x0 + (double)column * t->cell, y = t->y0 + (double)row * t->cell;
    /* along a diagonal the steps hit grid points too */
    double step = t->cell / fmax(fabs(ex), fabs(ey));
    *seen = true;
    for (size_t i = 1; (double)i * step <= distance * (1.0 + 1e-9); i++) {
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
        double angle = wf_terrain_horizon(t, column, row, d * PI / 4.0, distance, &on_map);
        if (!isnan(angle)) sum += angle;
        whole += on_map ? 0.125 : 0.0;
    }
    if (seen) *seen = whole;
    return isnan(t->z[row * t->columns + column]) ? NAN : sum;
}
