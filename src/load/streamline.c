/* Streamlining laws of a crown: one row each. */
#include "load/streamline.h"
#include "load/smooth.h"
#include <math.h>
#include <string.h>

static double share_none(const struct wf_streamline_par *p, double speed, double *derivative)
{
    (void)p, (void)speed;
    *derivative = 0;
    return 1;
}

/* ln(share) = V g(x), x = ln(speed/reference). The law itself has g = 0 for x < 0 and g = x above, with a
 * corner at the reference speed that no crown has. Within |x| < h the parabola (x+h)^2/(4h) joins both
 * branches with a continuous slope; outside that band the law is untouched. */
static double share_vogel(const struct wf_streamline_par *p, double speed, double *derivative)
{
    const double h = WF_VOGEL_ROUNDING;
    *derivative = 0;
    if (!(speed > p->reference_speed * (1 - h))) return 1;
    double x = log(speed / p->reference_speed);
    if (x <= -h) return 1;
    double g = x < h ? (x + h) * (x + h) / (4 * h) : x, slope = x < h ? (x + h) / (2 * h) : 1;
    double share = exp(p->exponent * g);
    *derivative = share * p->exponent * slope / speed;
    return share;
}

static double share_table(const struct wf_streamline_par *p, double speed, double *derivative)
{
    const double *x = p->speed, *y = p->share;
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

const struct wf_streamline_law wf_streamline_laws[] = {
    { .name = "none",
      .source = "rigid crown: still-air drag area at every speed",
      .validity = "bare or stiff crowns, or speeds at which the crown does not yet reconfigure (a few m/s)",
      .speed_low = 0,
      .speed_high = 10,
      .share = share_none },
    { .name = "vogel",
      .source =
          "Vogel S. 1984. Drag and flexibility in sessile organisms. Am. Zool. 24(1):37-44; Vogel S. 1989. "
          "Drag and reconfiguration of broad leaves in high winds. J. Exp. Bot. 40(8):941-948",
      .validity =
          "a power law fitted within the speeds of the exponent's own experiment, mostly 4-20 m/s; above "
          "them the share of a crown levels off as the bare wood remains",
      .speed_low = 4,
      .speed_high = 20,
      .share = share_vogel },
    { .name = "table",
      .source = "the points given; between them monotone cubic pieces (Steffen M. 1990. Astron. Astrophys. "
                "239:443-450)",
      .validity = "from the first to the last point; held constant beyond",
      .speed_low = 0,
      .speed_high = INFINITY,
      .share = share_table },
    { .name = NULL }
};

const struct wf_streamline_law *wf_streamline_named(const char *name)
{
    for (const struct wf_streamline_law *l = wf_streamline_laws; name && l->name; l++)
        if (strcmp(l->name, name) == 0) return l;
    return NULL;
}
