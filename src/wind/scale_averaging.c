/* The same wind under another averaging time. */
#include "base/near.h"
#include "wind/scale.h"
#include <math.h>
#include <string.h>

const struct wf_averaging_law wf_averaging_laws[] = {
    { "durst",
      "Durst C.S. (1960), Meteorol. Mag. 89:181-186; fit: Shore Protection Manual (1984), U.S. Army Corps of "
      "Engineers",
      "open country, strong winds other than tropical cyclones and thunderstorms; 1 s to 3600 s" },
    { "in-land", "Harper B.A., Kepert J.D., Ginger J.D. (2010), WMO/TD-No. 1555, table 1.1",
      "tropical cyclones, roughly open terrain" },
    { "off-land", "Harper et al. (2010)", "tropical cyclones, offshore wind at a coast" },
    { "off-sea", "Harper et al. (2010)", "tropical cyclones, onshore wind at a coast" },
    { "at-sea", "Harper et al. (2010)", "tropical cyclones, open sea more than 20 km out" },
    { 0 }
};

enum { TIMES = 6, CLASSES = 4, PERIODS = 2 };
static const double harper_time[TIMES] = { 3, 60, 120, 180, 600, 3600 };
/* [class][period of the mean: 600 s, 3600 s][gust duration]: largest gust / mean */
static const double harper[CLASSES][PERIODS][TIMES] = {
    { { 1.66, 1.21, 1.12, 1.09, 1.00 }, { 1.75, 1.28, 1.19, 1.15, 1.08, 1.00 } },
    { { 1.52, 1.16, 1.09, 1.06, 1.00 }, { 1.60, 1.22, 1.15, 1.12, 1.06, 1.00 } },
    { { 1.38, 1.11, 1.05, 1.03, 1.00 }, { 1.45, 1.17, 1.11, 1.09, 1.05, 1.00 } },
    { { 1.23, 1.05, 1.02, 1.00, 1.00 }, { 1.30, 1.11, 1.07, 1.06, 1.03, 1.00 } },
};

/* Largest gust of `gust` seconds over the mean of `period` seconds; 0 where the table has none. */
static double harper_factor(size_t class, double period, double gust)
{
    size_t row = fabs(period - 600.0) < 0.01 ? 0 : fabs(period - 3600.0) < 0.01 ? 1 : PERIODS;
    for (size_t i = 0; i < TIMES && row < PERIODS; i++)
        if (fabs(gust - harper_time[i]) < 0.01) return harper[class][row][i];
    return 0.0;
}

static double durst(double t) { return 1.277 + 0.296 * tanh(0.9 * log10(45.0 / t)); }

enum wf_status wf_wind_average(const char *law, double speed, double from, double to, double *out,
                               struct wf_err *e)
{
    const char *known[8];
    size_t row = 0;
    for (; wf_averaging_laws[row].name && strcmp(wf_averaging_laws[row].name, law) != 0; row++)
        known[row] = wf_averaging_laws[row].name;
    if (!wf_averaging_laws[row].name) {
        const char *near = wf_nearest(law, known, row);
        return wf_fail(
            e, WF_EUSAGE,
            "unknown averaging law '%s'%s%s%s; there are durst, in-land, off-land, off-sea, at-sea", law,
            near ? "; did you mean '" : "", near ? near : "", near ? "'" : "");
    }
    if (row == 0) {
        if (!(from >= 1.0 && from <= 3600.0 && to >= 1.0 && to <= 3600.0))
            return wf_fail(e, WF_EUSAGE, "durst: averaging times of %g s and %g s; 1 s to 3600 s are covered",
                           from, to);
        *out = speed * durst(to) / durst(from);
        return WF_OK;
    }
    double factor = harper_factor(row - 1, fmax(from, to), fmin(from, to));
    if (!(factor > 0.0))
        return wf_fail(
            e, WF_EUSAGE,
            "%s: averaging times of %g s and %g s; a mean over 600 s or 3600 s and gusts of 3, 60, 120, 180 "
            "or 600 s are tabulated",
            law, from, to);
    *out = to < from ? speed * factor : speed / factor;
    return WF_OK;
}
