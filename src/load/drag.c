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

static double share_vogel(const struct wf_law_values *p, double speed, double *derivative)
{
    return vogel_share(p->number[0], p->number[1], speed, derivative);
}

static double share_table(const struct wf_law_values *p, double speed, double *derivative)
{
    return table_share(p, NULL, speed, derivative);
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
      .share = share_none,
      .form = WF_SHARE_NONE },
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
      .share = share_vogel,
      .form = WF_SHARE_VOGEL },
    { .law = { .name = "table",
               .summary = "a monotone cubic curve through the shares at the speeds given",
               .source = "the points given; between them monotone cubic pieces (Steffen M. 1990. Astron. "
                         "Astrophys. 239:443-450)",
               .validity = "from the first to the last point; held constant beyond",
               .low = 0,
               .high = INFINITY,
               .parameter = table_parameters },
      .share = share_table,
      .form = WF_SHARE_TABLE },
    { .law = { .name = NULL } },
};

const struct wf_streamline_law *wf_streamline_named(const char *name)
{
    return (const void *)wf_law_named((struct wf_law_table){ wf_streamline_laws, sizeof *wf_streamline_laws },
                                      name);
}

/* Drag of a bare axis. */

static double bark(const struct wf_law_values *p, double speed, double diameter, double viscosity,
                   double *derivative)
{
    (void)p;
    return bark_drag_law(speed, diameter, viscosity, derivative);
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
      .coefficient = bark,
      .form = WF_DRAG_BARK },
    { .law = { .name = NULL } },
};

const struct wf_axis_drag_law *wf_axis_drag_named(const char *name)
{
    return (const void *)wf_law_named((struct wf_law_table){ wf_axis_drag_laws, sizeof *wf_axis_drag_laws },
                                      name);
}
