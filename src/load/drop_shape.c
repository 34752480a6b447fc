/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/drop_shape.h"
#include "base/num.h"
#include <math.h>

static double roundness(double angle)
{
    double c = cos(angle);
    return 2 + c * c * c - 3 * c;
}

double wf_cap_radius(double mass, double angle)
{
    return cbrt(3 * mass / (WF_WATER_DENSITY * WF_PI * roundness(angle)));
}

double wf_cap_radius_printed(double mass, double angle)
{
    return cbrt(3 * mass / (WF_PI * roundness(angle)));
}

double wf_cap_volume(double r, double angle) { return WF_PI / 3 * r * r * r * roundness(angle); }

double wf_cap_volume_printed(double r) { return 3 * WF_PI * r * r * r / 8; }

double wf_cap_base(double r, double angle) { return r * sin(angle); }

double wf_cap_height(double r, double angle, double r1, double omega, bool printed)
{
    double square = r * r - r1 * r1;
    if (square <= 0) return 0;
    return omega * fmax(0, sqrt(square) - r * (printed ? sin(angle) : cos(angle)));
}

double wf_cap_omega(double lambda, double kappa) { return pow(lambda, kappa); }

double wf_tail_first(double r0, double beta, size_t n)
{
    double cube = beta * beta * beta;
    if (!n) return r0;
    if (cube >= 1 - 1e-12) return r0 / cbrt((double)n);
    return r0 * cbrt((1 - cube) / (1 - pow(cube, (double)n)));
}

double wf_drop_retention(double width, double receding, double advancing)
{
    return WF_PI / 4 * WF_WATER_TENSION * width * fmax(0, cos(receding) - cos(advancing));
}

double wf_drop_hanging(double diameter, double gravity)
{
    return WF_WATER_TENSION * WF_PI * diameter / gravity;
}

double wf_drop_attraction(double d, double r1, double r2)
{
    return d < r1 + r2 ? -log(fmax(d, 1e-300) / (r1 + r2)) : 0;
}

double wf_impact_share(double m, double body) { return m * body / ((m + body) * (m + body)); }
