/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/drag.h"
#include "base/units.h"
#include <math.h>

/* Streamlining of a crown. */

static double share_none(const struct wf_law_values *p, double speed, double *derivative)
{
    (void)p, (void)speed;
    *derivative = 0;
    return 1;
}

/* ln(share) = V g(x), x = ln(speed/reference). The sharp law has g = 0 for x < 0 and g = x above, with a
 * corner at the reference speed that real crowns do not have. Within |x| < h the parabola (x+h)^2/(4h) joins
 * both branches with a continuous slope; outside that band the law is unchanged. */
static double share_vogel(const struct wf_law_values *p, double speed, double *derivative)
{
    const double h = WF_VOGEL_ROUNDING, exponent = p->number[0], reference = p->number[1];
    *derivative = 0;
    if (!(speed > reference * (1 - h))) return 1;
    double x = log(speed / reference);
    if (x <= -h) return 1;
    double g = x < h ? (x + h) * (x + h) / (4 * h) : x, slope = x < h ? (x + h) / (2 * h) : 1;
    double share = exp(exponent * g);
    *derivative = share * exponent * slope / speed;
    return share;
}

static double share_table(const struct wf_law_values *p, double speed, double *derivative)
{
    const double *x = p->list[0], *y = p->list[1];
    size_t n = p->n, i = 1;
    *derivative = 0;
    if (n == 0) return 1;
    if (speed <= x[0]) return y[0];
    if (speed >= x[n - 1]) return y[n - 1];
    while (speed >= x[i]) i++;
    double h = x[i] - x[i - 1];
    return wf_smooth_piece(y[i - 1], y[i], wf_smooth_slope(x, y, n, i - 1), wf_smooth_slope(x, y, n, i), h,
                           (speed - x[i - 1]) / h, derivative);
}

#define SPEEDS .dimension = WF_DIM_SPEED, .unit = "m/s"
static const struct wf_law_parameter vogel_parameters[] = {
    { "exponent", WF_LAW_VALUE, .low = -2, .high = 0, .result = "vogel_exponent",
      .doc = "Vogel exponent V: crown drag grows with wind speed to the power 2 + V.", .example = "-0.7" },
    { "reference_speed", WF_LAW_NUMBER, SPEEDS, .low = 0.1, .high = 100, .result = "reference_speed",
      .doc = "Wind speed below which the crown keeps its still-air drag area.", .example = "5 m/s" },
    { .name = NULL },
};
static const struct wf_law_parameter table_parameters[] = {
    { "speed", WF_LAW_LIST, SPEEDS, .low = 0, .high = 150, .result = "table_speed_m_s",
      .doc = "Wind speeds of the table, ascending.", .example = "[4 m/s, 20 m/s]" },
    { "share", WF_LAW_LIST, .low = 0, .high = 2, .result = "table_share",
      .doc = "Share of the still-air drag area left at these speeds; constant outside.",
      .example = "[1, 0.28]" },
    { .name = NULL },
};

const struct wf_streamline_law wf_streamline_laws[] = {
    { .law = { .name = "none",
               .summary = "a rigid crown",
               .source = "rigid crown: still-air drag area at every speed",
               .validity =
                   "bare or stiff crowns, or speeds at which the crown does not yet reconfigure (a few "
                   "m/s)",
               .low = 0,
               .high = 10 },
      .rigid = true,
      .share = share_none },
    { .law = { .name = "vogel",
               .summary = "share = (U / reference_speed)^exponent above the reference speed, 1 below",
               .source =
                   "Vogel S. 1984. Drag and flexibility in sessile organisms. Am. Zool. 24(1):37-44; "
                   "Vogel S. 1989. Drag and reconfiguration of broad leaves in high winds. J. Exp. Bot. "
                   "40(8):941-948",
               .validity = "a power law fitted within the speeds of the exponent's own experiment, mostly "
                           "4-20 m/s; above them the share of a crown levels off as the bare wood remains",
               .low = 4,
               .high = 20,
               .parameter = vogel_parameters },
      .share = share_vogel },
    { .law = { .name = "table",
               .summary = "a monotone cubic curve through the shares at the speeds given",
               .source = "the points given; between them monotone cubic pieces (Steffen M. 1990. Astron. "
                         "Astrophys. 239:443-450)",
               .validity = "from the first to the last point; held constant beyond",
               .low = 0,
               .high = INFINITY,
               .parameter = table_parameters },
      .share = share_table },
    { .law = { .name = NULL } },
};

const struct wf_streamline_law *wf_streamline_named(const char *name)
{
    return (const void *)wf_law_named((struct wf_law_table){ wf_streamline_laws, sizeof *wf_streamline_laws },
                                      name);
}

/* Drag of a bare axis. */

#define LG2 0.30102999566398120 /* log10 2 */
#define LG5 0.69897000433601880 /* log10 5 */
#define DECADE(d) (d), (d) + LG2, (d) + LG5

static const double bark_log_re[] = { DECADE(-1), DECADE(0), DECADE(1), DECADE(2), DECADE(3),
                                      DECADE(4),  DECADE(5), DECADE(6), 7 };
static const double bark_drag[] = {
    58,   34,   17,   /* 1e-1 */
    10.5, 6.8,  4.0,  /* 1e0 */
    2.8,  2.08, 1.55, /* 1e1 */
    1.37, 1.25, 1.13, /* 1e2 */
    1.00, 0.95, 1.00, /* 1e3 */
    1.10, 1.17, 1.20, /* 1e4 */
    1.20, 1.14, 1.05, /* 1e5: rough bark, beyond the drag crisis of a smooth cylinder */
    1.05, 1.05, 1.05, /* 1e6 */
    1.05,             /* 1e7 */
};
/* Slopes d drag / d log10 Re at the points by wf_smooth_slope, tabulated because this law is evaluated at
 * every load point of every element. */
static const double bark_rise[] = {
    0,
    -63.788542506732597,
    -30.691640612488143, /* 1e-1 */
    -16.941833283925543,
    -10.027972788855955,
    -5.2998439468210314, /* 1e0 */
    -3.1890509710918673,
    -1.9353015759351511,
    -0.91402574605560827, /* 1e1 */
    -0.49828921423310435,
    -0.35682198881671667,
    -0.37573450418485604, /* 1e2 */
    -0.29897352853986248,
    0,
    0.24323840551433046, /* 1e3 */
    0.28236388806542562,
    0.15077649568392379,
    0, /* 1e4 */
    0,
    -0.21087894550811814,
    0, /* 1e5 */
    0,
    0,
    0, /* 1e6 */
    0, /* 1e7 */
};
enum { BARK_POINTS = sizeof bark_drag / sizeof *bark_drag };

static double bark(const struct wf_law_values *p, double speed, double diameter, double viscosity,
                   double *derivative)
{
    (void)p;
    double re = speed * diameter / viscosity, slope;
    *derivative = 0;
    if (!(re > 0.1)) return bark_drag[0];
    if (re >= 1e7) return bark_drag[BARK_POINTS - 1];
    double x = fmax(log(re) * (1 / M_LN10), -1), part = x - floor(x);
    size_t i = 3 * (size_t)(floor(x) + 1) + (part >= LG2) + (part >= LG5);
    if (i > BARK_POINTS - 2) i = BARK_POINTS - 2; /* rounding of the logarithm just below the last point */
    double h = bark_log_re[i + 1] - bark_log_re[i];
    double cd = wf_smooth_piece(bark_drag[i], bark_drag[i + 1], bark_rise[i], bark_rise[i + 1], h,
                                (x - bark_log_re[i]) / h, &slope);
    *derivative = slope / (speed * M_LN10);
    return cd;
}

const struct wf_axis_drag_law wf_axis_drag_laws[] = {
    { .law = { .name = "bark",
               .summary = "a rough cylinder's, by Reynolds number",
               .source =
                   "Wieselsberger C. 1921. Phys. Z. 22:321-328; Hoerner S. F. 1965. Fluid-Dynamic Drag, "
                   "ch. 3; Achenbach E. 1971. J. Fluid Mech. 46:321-335",
               .validity =
                   "measured for Reynolds numbers from 1 to 1e7 and held constant outside; above 5e4 on "
                   "the upper side of what rough cylinders and trunks showed",
               .low = 1,
               .high = 1e7 },
      .coefficient = bark },
    { .law = { .name = NULL } },
};

const struct wf_axis_drag_law *wf_axis_drag_named(const char *name)
{
    return (const void *)wf_law_named((struct wf_law_table){ wf_axis_drag_laws, sizeof *wf_axis_drag_laws },
                                      name);
}
