/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_CLOSE_H
#define WF_TESTS_CLOSE_H
/* cmocka with a comparison in double precision (its own assert_float_equal casts to float). */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>

/* |got - want| <= tolerance * |want|; for want == 0 the tolerance is absolute. NaN never passes. */
#define assert_close(got, want, tolerance)                                                                   \
    do {                                                                                                     \
        double got_ = (got), want_ = (want), tol_ = (tolerance);                                             \
        double scale_ = want_ != 0.0 ? fabs(want_) : 1.0;                                                    \
        if (!(fabs(got_ - want_) <= tol_ * scale_))                                                          \
            fail_msg("%s = %.17g, want %.17g within %g (off by %.3g)", #got, got_, want_, tol_,              \
                     (got_ - want_) / scale_);                                                               \
    } while (0)
#endif
