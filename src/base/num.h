/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_NUM_H
#define WF_BASE_NUM_H
/* Numbers: constants and helpers used throughout, conversion of decimal text to double, and calls to GSL
 * without its error handler. */
#include <stddef.h>

#define WF_PI 3.14159265358979323846
#define WF_TURN 6.28318530717958647693 /* 2 pi: a full turn [rad] */
/* Number of elements of an array. */
#define WF_COUNT(array) (sizeof(array) / sizeof *(array))

/* Linear interpolation: a at s = 0, b at s = 1. */
static inline double wf_between(double a, double b, double s) { return a + (b - a) * s; }
/* Slopes at n >= 2 points (x ascending) of a cubic curve through them without overshoot, with a continuous
 * derivative. Source: Steffen M. 1990, Astron. Astrophys. 239:443-450, eqs 8, 11. */
void wf_curve_slopes(size_t n, const double *x, const double *y, double *slope);
/* For qsort: doubles in ascending order. */
int wf_ascending(const void *a, const void *b);

/* Convert decimal text to double, independently of the locale. Given: text from `s` up to `end`, decimal sign
 * `point` ('.' or ','). Returned: the end of the longest number [+-]digits[.digits][e[+-]digits] at `s`, and
 * its value, correctly rounded; NULL when there is no number or it is beyond the range of a double (1e999,
 * 1e-999). nan, inf and hexadecimal are not accepted.
 * Method: a number of up to 19 digits, below 2^53 and with a power of ten within 22, is one exact operation
 * (Clinger 1990); others are converted by strtod. */
const char *wf_number_read(const char *s, const char *end, char point, double *value);

/* Disable and restore GSL's error handler, which by default ends the program; between the two calls GSL's
 * functions return their error codes. The handler is process-wide: begin/end pairs from several threads are
 * counted; the first begin disables it, the last end restores it. */
void wf_quiet_begin(void);
void wf_quiet_end(void);
#endif
