#include "base/vec.h"
#include "study/validate_measure.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* Axis direction at a row's base (0) or end (1): bent, or unbent where the answer is one of small deflection.
 */
static void axis_at(const struct wf_tree *t, const struct wf_response *r, size_t row, bool end,
                    double axis[3])
{
    const double *bent = (end ? r->tangent1 : r->tangent0) + 3 * row;
    const double chord[3] = { t->x1[row] - t->x0[row], t->y1[row] - t->y0[row], t->z1[row] - t->z0[row] };
    double size = sqrt(wf_dot(chord, chord));
    for (int k = 0; k < 3; k++) axis[k] = r->small_deflection ? chord[k] / size : bent[k];
}

double wf_stress_at(const struct wf_tree *t, const struct wf_response *r, size_t row, double s)
{
    double axis0[3], axis1[3], slope0[3], slope1[3], m[3], axis[3], length = wf_tree_length(t, row);
    axis_at(t, r, row, false, axis0);
    axis_at(t, r, row, true, axis1);
    /* the cubic with the end moments and, from dM/ds = -t x F, the end slopes */
    wf_cross(r->force0 + 3 * row, axis0, slope0);
    wf_cross(r->force1 + 3 * row, axis1, slope1);
    double h00 = (1 + 2 * s) * (1 - s) * (1 - s), h10 = s * (1 - s) * (1 - s), h01 = s * s * (3 - 2 * s),
           h11 = s * s * (s - 1);
    for (size_t k = 0; k < 3; k++) {
        m[k] = h00 * r->moment0[3 * row + k] + h01 * r->moment1[3 * row + k] +
               length * (h10 * slope0[k] + h11 * slope1[k]);
        axis[k] = (1 - s) * axis0[k] + s * axis1[k];
    }
    double outer = t->r0[row] + s * (t->r1[row] - t->r0[row]),
           inner = t->i0[row] + s * (t->i1[row] - t->i0[row]);
    double twist = wf_dot(m, axis), bending = wf_dot(m, m) - twist * twist / wf_dot(axis, axis);
    return sqrt(fmax(bending, 0.0)) * outer / (0.25 * pi * (pow(outer, 4) - pow(inner, 4)));
}

double wf_span_stress(const struct wf_tree *t, const struct wf_response *r, size_t row, double *share)
{
    enum { SAMPLES = 64 };
    const double golden = 0.61803398874989484820;
    size_t best = 0;
    for (size_t i = 1; i <= SAMPLES; i++)
        if (wf_stress_at(t, r, row, (double)i / SAMPLES) > wf_stress_at(t, r, row, (double)best / SAMPLES))
            best = i;
    double a = fmax(0.0, ((double)best - 1) / SAMPLES), b = fmin(1.0, ((double)best + 1) / SAMPLES);
    for (int i = 0; i < 48; i++) { /* golden section down to rounding */
        double left = b - golden * (b - a), right = a + golden * (b - a);
        if (wf_stress_at(t, r, row, left) < wf_stress_at(t, r, row, right))
            a = left;
        else
            b = right;
    }
    double s = 0.5 * (a + b);
    for (int k = 0; k < 2; k++) /* a maximum at an end of the row lies exactly there */
        if (wf_stress_at(t, r, row, k) >= wf_stress_at(t, r, row, s)) s = k;
    *share = s;
    return wf_stress_at(t, r, row, s);
}
