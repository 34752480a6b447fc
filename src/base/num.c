/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/num.h"
#include <gsl/gsl_errno.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static bool is_digit(const char *s, const char *end) { return s < end && *s >= '0' && *s <= '9'; }

/* Numbers of any length: copied with '.' as decimal sign and converted by strtod in the "C" locale. */
static bool number_by_strtod(const char *s, const char *end, char point, double *value)
{
    char local[128], *copy = local;
    size_t n = (size_t)(end - s);
    if (n >= sizeof local && !(copy = malloc(n + 1))) return false;
    memcpy(copy, s, n);
    copy[n] = '\0';
    char *p = strchr(copy, point);
    if (p) *p = '.';
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    *value = c ? strtod_l(copy, NULL, c) : NAN;
    bool ok = isfinite(*value) && *value != 0; /* the digits are not all zero here */
    if (c) freelocale(c);
    if (copy != local) free(copy);
    return ok;
}

const char *wf_number_read(const char *s, const char *end, char point, double *value)
{
    static const double power[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    const char *start = s;
    bool negative = s < end && *s == '-';
    if (s < end && (*s == '-' || *s == '+')) s++;
    uint64_t m = 0;
    int digits = 0, seen = 0, scale = 0, ten = 0;
    for (; is_digit(s, end); s++, seen = 1) {
        if (digits < 19) m = m * 10 + (uint64_t)(*s - '0');
        digits += digits > 0 || *s != '0';
    }
    if (s < end && *s == point && (seen || is_digit(s + 1, end)))
        for (s++; is_digit(s, end); s++, seen = 1, scale--) {
            if (digits < 19) m = m * 10 + (uint64_t)(*s - '0');
            digits += digits > 0 || *s != '0';
            if (scale < -100000) return NULL;
        }
    if (!seen) return NULL;
    if (s < end && (*s == 'e' || *s == 'E')) {
        const char *x = s + 1;
        bool down = x < end && *x == '-';
        if (x < end && (*x == '-' || *x == '+')) x++;
        if (is_digit(x, end)) {
            for (; is_digit(x, end); x++)
                if (ten < 100000) ten = ten * 10 + (*x - '0');
            ten = down ? -ten : ten;
            s = x;
        }
    }
    int e10 = scale + ten;
    if (digits <= 19 && m <= (UINT64_C(1) << 53) && e10 >= -22 && e10 <= 22) {
        double v = (double)m;
        v = e10 < 0 ? v / power[-e10] : v * power[e10];
        *value = negative ? -v : v;
        return s;
    }
    if (digits == 0) {
        *value = negative ? -0.0 : 0.0;
        return s;
    }
    return number_by_strtod(start, s, point, value) ? s : NULL;
}

static pthread_mutex_t quiet_mutex = PTHREAD_MUTEX_INITIALIZER;
static unsigned quiet_depth;
static gsl_error_handler_t *quiet_saved;

void wf_quiet_begin(void)
{
    pthread_mutex_lock(&quiet_mutex);
    if (quiet_depth++ == 0) quiet_saved = gsl_set_error_handler_off();
    pthread_mutex_unlock(&quiet_mutex);
}

void wf_quiet_end(void)
{
    pthread_mutex_lock(&quiet_mutex);
    if (--quiet_depth == 0) gsl_set_error_handler(quiet_saved);
    pthread_mutex_unlock(&quiet_mutex);
}

int wf_ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void wf_curve_slopes(size_t n, const double *x, const double *y, double *slope)
{
    const size_t last = n - 1;
    slope[0] = (y[1] - y[0]) / (x[1] - x[0]);
    slope[last] = (y[last] - y[last - 1]) / (x[last] - x[last - 1]);
    for (size_t i = 1; i < last; i++) {
        double below = x[i] - x[i - 1], above = x[i + 1] - x[i];
        double a = (y[i] - y[i - 1]) / below, b = (y[i + 1] - y[i]) / above;
        /* the parabola through three points, limited to twice the smaller slope on either side */
        double middle = fabs(a * above + b * below) / (below + above);
        slope[i] = a * b > 0.0 ? copysign(fmin(2.0 * fmin(fabs(a), fabs(b)), middle), a) : 0.0;
    }
}
