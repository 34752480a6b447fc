/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_LOG_EXP_H
#define WF_BASE_LOG_EXP_H
/* Logarithm, exponential and power of a real (base/real.h), the same bytes for any number of lanes. The error
 * is below 1 unit in the last place for log and exp; of a power x^a it is below 2 + 2 |a ln x| units. */
#include "base/real.h"
#include <float.h>

/* ln 2 in two parts: the product of the first with an exponent is exact */
#define LOG_EXP_LN2 0x1.62e42fee00000p-1
#define LOG_EXP_LN2_REST 0x1.a39ef35793c76p-33

/* ln x. x below 2.2e-308, where numbers lose digits, zero and negative x count as 2.2e-308; x must be finite.
 * Method: x = 2^k m with sqrt(1/2) <= m < sqrt(2); with s = (m - 1) / (m + 1), ln m = 2 artanh s, by a
 * polynomial in s^2 fitted to Chebyshev points. */
WF_INLINE real real_log(real x)
{
    const int64_t root = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;       /* bits of sqrt(1/2) and 1 */
    const int64_t fraction = 0x000fffffffffffff, whole = 0x4330000000000000; /* of a mantissa; of 2^52 */
    real_truth bits = real_bits(real_max(x, real_of(DBL_MIN))) + (one - root);
    real m = real_from_bits((bits & fraction) + root);
    real k = real_from_bits((bits >> 52) | whole) - (0x1p52 + 1023);
    real f = m - 1, s = f / (2 + f), z = s * s, half = 0.5 * f * f;
    real r = 0.66666666666666697077 +
             z * (0.39999999999898890514 +
                  z * (0.28571428626253837606 +
                       z * (0.22222211089379496214 +
                            z * (0.18182892432536871201 +
                                 z * (0.15331611722055007885 + z * 0.14617807153417324964)))));
    return k * LOG_EXP_LN2 - ((half - (s * (half + z * r) + k * LOG_EXP_LN2_REST)) - f);
}

/* e^x, with x held within -708 .. 709. Method: x = k ln 2 + r with |r| <= ln 2 / 2, and a polynomial in r
 * fitted to Chebyshev points. */
WF_INLINE real real_exp(real x)
{
    const double to_bits =
        0x1.8p52; /* a number added to it is rounded to an integer, which its last bits are */
    real held = real_max(real_min(x, real_of(709)), real_of(-708));
    real shifted = held * 0x1.71547652b82fep+0 + to_bits, k = shifted - to_bits;
    real high = held - k * LOG_EXP_LN2, low = k * LOG_EXP_LN2_REST, r = high - low;
    real p =
        0.50000000000000010314 +
        r * (0.1666666666666666746 + r * (0.041666666666623820532 +
                                          r * (0.0083333333333300381973 +
                                               r * (0.0013888888917367080562 +
                                                    r * (0.00019841269863171556026 +
                                                         r * (0.000024801521057868205199 +
                                                              r * (2.7557268276905696187e-6 +
                                                                   r * (2.7620201591031548792e-7 +
                                                                        r * 2.5100472505694996003e-8))))))));
    real y = 1 + (high - (low - r * r * p));
    return real_from_bits(real_bits(y) + real_bits_up(real_bits(shifted), 52));
}

/* x^a for x > 0. */
WF_INLINE real real_power(real x, real a) { return real_exp(a * real_log(x)); }
#endif
