#include "wind/potential.h"
#include "base/num.h"
#include <math.h>

void wf_flow_cylinder(double stream, double radius, double circulation, const double x[2], double u[2])
{
    double r2 = x[0] * x[0] + x[1] * x[1], doublet = stream * radius * radius / (r2 * r2),
           vortex = circulation / (2.0 * WF_PI * r2);
    u[0] = stream - doublet * (x[0] * x[0] - x[1] * x[1]) + vortex * x[1];
    u[1] = -doublet * 2.0 * x[0] * x[1] - vortex * x[0];
}

double wf_flow_pressure(double stream, const double u[2])
{
    return 1.0 - (u[0] * u[0] + u[1] * u[1]) / (stream * stream);
}

void wf_flow_line_source(double strength, const double x[3], double u[3])
{
    double k = strength / (2.0 * WF_PI * (x[0] * x[0] + x[1] * x[1]));
    u[0] = k * x[0];
    u[1] = k * x[1];
    u[2] = 0.0;
}

void wf_flow_point_source(double strength, const double x[3], double u[3])
{
    double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], k = strength / (4.0 * WF_PI * r2 * sqrt(r2));
    for (int i = 0; i < 3; i++) u[i] = k * x[i];
}

void wf_flow_segment_source(double strength, double from, double to, const double x[3], double u[3])
{
    double r2 = x[0] * x[0] + x[1] * x[1], a = x[2] - from, b = x[2] - to;
    double ra = sqrt(r2 + a * a), rb = sqrt(r2 + b * b), k = strength / (4.0 * WF_PI), radial;
    /* (a/ra - b/rb)/r^2; above or below the source both terms are near 1: a/ra = 1 - r^2/(ra (ra + a)) */
    if (a > 0.0 && b > 0.0)
        radial = 1.0 / (rb * (rb + b)) - 1.0 / (ra * (ra + a));
    else if (a < 0.0 && b < 0.0)
        radial = 1.0 / (ra * (ra - a)) - 1.0 / (rb * (rb - b));
    else
        radial = (a / ra - b / rb) / r2;
    u[0] = k * radial * x[0];
    u[1] = k * radial * x[1];
    u[2] = k * (1.0 / rb - 1.0 / ra);
}

void wf_feng_cylinder_potential(double stream, double radius, const double x[2], double f[2])
{
    double share = radius * radius / (x[0] * x[0] + x[1] * x[1]);
    f[0] = stream * x[0] * (1.0 + share);
    f[1] = stream * x[1] * (1.0 - share);
}

void wf_feng_hole_potential(double strength, const double x[2], double f[2])
{
    double k = strength / (2.0 * WF_PI);
    f[0] = k * log(hypot(x[0], x[1]));
    f[1] = k * atan2(x[1], x[0]);
}

double wf_feng_slit_stream(double stream, double length, const double x[2])
{
    return -stream * (hypot(x[0], x[1]) - hypot(x[0] - length, x[1]));
}

void wf_feng_slit(double stream, double length, const double x[2], double u[2])
{
    double r = hypot(x[0], x[1]), r1 = hypot(x[0] - length, x[1]);
    u[0] = -stream * (x[1] / r - x[1] / r1);
    u[1] = stream * (x[0] / r - (x[0] - length) / r1);
}
