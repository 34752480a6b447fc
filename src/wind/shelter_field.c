/* The sheltered wind at any point, from the ratios at planes and cells. */
#include "base/vec.h"
#include "wind/shelter.h"
#include "wind/shelter_parts.h"
#include <math.h>
#include <string.h>

/* Three neighbours of a coordinate in cells (centres at 0.5, 1.5, ...), weights of the quadratic B-spline and
 * their slopes per cell. */
static void spline(double at, long index[3], double weight[3], double slope[3])
{
    double cell = floor(at), t = at - cell;
    for (int k = 0; k < 3; k++) index[k] = (long)cell - 1 + k;
    weight[0] = 0.5 * (1.0 - t) * (1.0 - t);
    weight[1] = 0.5 + t * (1.0 - t);
    weight[2] = 0.5 * t * t;
    slope[0] = t - 1.0;
    slope[1] = 1.0 - 2.0 * t;
    slope[2] = t;
}

/* Place of each neighbour in the arrays; -1 where the wind is undisturbed. Behind the last plane it stays as
 * it is there, below the grid as in the lowest cells. */
static void clip(int axis, long n, long index[3])
{
    for (int k = 0; k < 3; k++) {
        if (index[k] < 0) index[k] = axis == 2 ? 0 : -1;
        if (index[k] >= n) index[k] = axis == 0 ? n - 1 : -1;
    }
}

static double clamped(double v, double low, double high) { return fmin(fmax(v, low), high); }

void wf_shelter_ratio(const struct wf_shelter *s, const double x[3], double ratio[3], double slope[9])
{
    double local[3], weight[3][3], rise[3][3], value[3] = { 0 }, by[3][3] = { { 0 } };
    long index[3][3];
    const long n[3] = { (long)s->planes, (long)s->across, (long)s->up };
    wf_shelter_turn(s, x, local);
    for (int k = 0; k < 3; k++) {
        double at = (local[k] - s->low[k]) / s->step[k] - (k == 0 ? WF_SHELTER_LAG : 0.0);
        spline(clamped(at, -9.0, (double)n[k] + 9.0), index[k], weight[k], rise[k]);
        clip(k, n[k], index[k]);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++) {
                if (index[0][i] < 0 || index[1][j] < 0 || index[2][k] < 0) continue;
                size_t cell =
                    ((size_t)index[0][i] * s->up + (size_t)index[2][k]) * s->across + (size_t)index[1][j];
                double w[3] = { weight[0][i], weight[1][j], weight[2][k] };
                for (size_t p = 0; p < s->request.law->parts; p++) {
                    double v = s->part[p][cell];
                    value[p] += w[0] * w[1] * w[2] * v;
                    by[p][0] += rise[0][i] * w[1] * w[2] * v;
                    by[p][1] += w[0] * rise[1][j] * w[2] * v;
                    by[p][2] += w[0] * w[1] * rise[2][k] * v;
                }
            }
    for (int p = 0; p < 3; p++) {
        ratio[p] = (p == 0 ? 1.0 : 0.0) - value[p];
        for (int j = 0; j < 3; j++) {
            slope[3 * p + j] = 0.0;
            for (int k = 0; k < 3; k++) slope[3 * p + j] -= by[p][k] / s->step[k] * s->axis[k][j];
        }
    }
}

/* u = base + q ((r0 - 1) e0 + r1 e1 + r2 e2), q the undisturbed speed along the wind. */
static void sample(const struct wf_wind *w, const double x[3], double u[3], double du[9])
{
    const struct wf_shelter *s = w->field;
    struct wf_wind base = s->base;
    double ratio[3], slope[9], q = 0.0, dq[3] = { 0 };
    base.speed = w->speed;
    base.sample(&base, x, u, du);
    wf_shelter_ratio(s, x, ratio, slope);
    for (int i = 0; i < 3; i++) {
        q += s->axis[0][i] * u[i];
        for (int j = 0; j < 3; j++) dq[j] += s->axis[0][i] * du[3 * i + j];
    }
    ratio[0] -= 1.0;
    for (int i = 0; i < 3; i++)
        for (int p = 0; p < 3; p++) {
            u[i] += q * ratio[p] * s->axis[p][i];
            for (int j = 0; j < 3; j++)
                du[3 * i + j] += (dq[j] * ratio[p] + q * slope[3 * p + j]) * s->axis[p][i];
        }
}

/* To the next face between cells, where the curvature of the splines jumps; a face at hand counts as passed.
 */
static double clear(const struct wf_wind *w, const double x[3], const double t[3])
{
    const struct wf_shelter *s = w->field;
    const double at_hand = 2e-3; /* cells */
    double local[3], nearest = INFINITY;
    wf_shelter_turn(s, x, local);
    for (int k = 0; k < 3; k++) {
        double at = (local[k] - s->low[k]) / s->step[k] - (k == 0 ? WF_SHELTER_LAG : 0.0);
        double rate = wf_dot(s->axis[k], t) / s->step[k], ahead = floor(at) + 1.0 - at;
        if (rate < 0.0) rate = -rate, ahead = at + 1.0 - ceil(at);
        if (ahead < at_hand) ahead += 1.0;
        if (rate > 0.0) nearest = fmin(nearest, ahead / rate);
    }
    return nearest;
}

void wf_shelter_field(const struct wf_shelter *s, struct wf_wind *out)
{
    *out = s->base;
    out->sample = sample;
    out->clear = clear;
    out->field = s;
}
