#include "base/vec.h"
#include "study/validate_measure.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* Moment at share s of a row: the cubic with the end moments and, from dM/ds = -t x F, the end slopes. */
static void moment_at(const struct wf_tree *t, const struct wf_response *r, size_t row, double s, double m[3])
{
    double slope0[3], slope1[3], length = wf_tree_length(t, row);
    wf_cross(r->force0 + 3 * row, r->tangent0 + 3 * row, slope0);
    wf_cross(r->force1 + 3 * row, r->tangent1 + 3 * row, slope1);
    double h00 = (1 + 2 * s) * (1 - s) * (1 - s), h10 = s * (1 - s) * (1 - s), h01 = s * s * (3 - 2 * s),
           h11 = s * s * (s - 1);
    for (size_t k = 0; k < 3; k++)
        m[k] = h00 * r->moment0[3 * row + k] + h01 * r->moment1[3 * row + k] +
               length * (h10 * slope0[k] + h11 * slope1[k]);
}

double wf_stress_at(const struct wf_tree *t, const struct wf_response *r, size_t row, double s)
{
    double m[3], axis[3], outer = t->r0[row] + s * (t->r1[row] - t->r0[row]),
                          inner = t->i0[row] + s * (t->i1[row] - t->i0[row]);
    moment_at(t, r, row, s, m);
    for (size_t k = 0; k < 3; k++)
        axis[k] = (1 - s) * r->tangent0[3 * row + k] + s * r->tangent1[3 * row + k];
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
    /* a maximum at an end of the row lies exactly there */
    double s = best == 0 && wf_stress_at(t, r, row, 0.0) >= wf_stress_at(t, r, row, 0.5 * (a + b)) ? 0.0
               : best == SAMPLES && wf_stress_at(t, r, row, 1.0) >= wf_stress_at(t, r, row, 0.5 * (a + b))
                   ? 1.0
                   : 0.5 * (a + b);
    *share = s;
    return wf_stress_at(t, r, row, s);
}
