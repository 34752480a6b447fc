/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_WIND_KERNEL_H
#define WF_WIND_WIND_KERNEL_H
/* Wind profiles given by a formula, for a double or for many lanes (base/real.h). Returned: speed [m/s], and
 * its slope by height [1/s]. */
#include "base/log_exp.h"

/* (z/h)^a has an infinite gradient at the ground. Below a ten-thousandth of the reference height (1 mm for 10
 * m) it is therefore replaced by the parabola that has the same value and slope there and is zero at the
 * ground. Given: speed at the reference height. */
WF_INLINE real power_profile(real at_reference, real reference, real a, real z, real *slope)
{
    const double least = 1e-4;
    real s = z / reference, held = real_max(s, real_of(least)), q = s * (1 / least);
    real top = at_reference * real_power(held, a), parabola = top * q * (2 - a - (1 - a) * q);
    real above = a * top / (held * reference), below = top * (2 - a - 2 * (1 - a) * q) / (least * reference);
    real_truth high = real_not_above(real_of(least), s), ground = real_not_above(z, real_of(0));
    *slope = real_choose(ground, real_of(0), real_choose(high, above, below));
    return real_choose(ground, real_of(0), real_choose(high, top, parabola));
}

/* The gradient is discontinuous at z = d + z0, where the speed is zero; forces, which are proportional to the
 * square of the speed, have a continuous derivative there. scale: friction velocity / kappa [m/s]. */
WF_INLINE real log_profile(real scale, real displacement, real roughness, real z, real *slope)
{
    real above = z - displacement, held = real_max(above, roughness);
    real_truth calm = real_not_above(above, roughness);
    *slope = real_choose(calm, real_of(0), scale / held);
    return real_choose(calm, real_of(0), scale * real_log(held / roughness));
}

WF_INLINE real log_profile_scale(real at_reference, real reference, real displacement, real roughness)
{
    return at_reference / real_log((reference - displacement) / roughness);
}

/* A profile whose speed is constant below a height. Given: its slope there, as at that height. */
WF_INLINE real slope_above(real z, real least, real slope)
{
    return real_choose(real_not_above(z, least), real_of(0), slope);
}

/* The mean wind of a terrain category: the log law, constant below z_min. */
WF_INLINE real terrain_profile(real scale, real roughness, real least, real z, real *slope)
{
    real at, speed = log_profile(scale, real_of(0), roughness, real_max(z, least), &at);
    *slope = slope_above(z, least, at);
    return speed;
}

/* The power law, constant below a height above the calm layer. */
WF_INLINE real floor_profile(real at_reference, real reference, real a, real least, real z, real *slope)
{
    real at, speed = power_profile(at_reference, reference, a, real_max(z, least), &at);
    *slope = slope_above(z, least, at);
    return speed;
}
#endif
