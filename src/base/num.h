/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_NUM_H
#define WF_BASE_NUM_H
/* Numbers: constants and helpers of every room, decimal text to double, GSL without its error handler. */
#include <stddef.h>

#define WF_PI 3.14159265358979323846
#define WF_TURN 6.28318530717958647693 /* 2 pi: a full turn [rad] */
#define WF_COUNT(array) (sizeof(array) / sizeof *(array))

/* Linear between a at s = 0 and b at s = 1. */
static inline double wf_between(double a, double b, double s) { return a + (b - a) * s; }
/* For qsort: doubles in rising order. */
int wf_ascending(const void *a, const void *b);

/* Decimal text to double, the same in every locale. */

/* Given: text from `s` up to `end`, `point` the decimal sign ('.' or ',').
 * Returned: just behind the longest number [+-]digits[.digits][e[+-]digits] at `s` and the value, correctly
 * rounded; NULL when there is no number, or it is beyond the range of a double (1e999, 1e-999).
 * Not numbers: nan, inf, hexadecimal.
 * Method: up to 19 digits with a power of ten within 22 are exact in one operation (Clinger 1990); the rest
 * goes through strtod. */
const char *wf_number_read(const char *s, const char *end, char point, double *value);

/* GSL without its error handler, which ends the program: inside such a stretch its functions return their
 * codes. The handler is one for the whole process, so stretches of several threads are counted: the first
 * puts it away, the last puts it back. Every begin needs its end. */
void wf_quiet_begin(void);
void wf_quiet_end(void);
#endif
