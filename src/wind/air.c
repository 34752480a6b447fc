/* Properties of dry air. */
#include "wind/wind.h"
#include <math.h>

double wf_air_density(double temperature, double altitude)
{
    const double gas = 287.05287, p0 = 101325, t0 = 288.15, lapse = 0.0065, gravity = 9.80665;
    if (!(temperature > 0 && altitude <= 11000)) return NAN;
    return p0 * pow(1 - lapse * altitude / t0, gravity / (gas * lapse)) / (gas * temperature);
}

double wf_air_viscosity(double temperature, double density)
{
    if (!(temperature > 0 && density > 0)) return NAN;
    return 1.458e-6 * temperature * sqrt(temperature) / (temperature + 110.4) / density;
}
