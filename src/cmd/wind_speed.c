#include "cmd/wind_speed.h"
#include "base/number.h"
#include "base/units.h"
#include "wind/scale.h"
#include <math.h>
#include <string.h>

static const double MEAN_TIME = 600.0; /* s */

static enum wf_status grade(const char *text, const char *law, FILE *to, double *speed, struct wf_err *e)
{
    struct wf_scale_wind w;
    enum wf_status s = wf_wind_scale_parse(text, &w, e);
    if (s) return s;
    *speed = w.speed;
    if (w.scale->averaging < MEAN_TIME)
        s = wf_wind_average(law, w.speed, w.scale->averaging, MEAN_TIME, speed, e);
    if (s || !to) return s;
    fprintf(to, "%s: %s, ", text, w.grade->text);
    if (isfinite(w.grade->high))
        fprintf(to, "%.1f to %.1f m/s", w.grade->low, w.grade->high);
    else
        fprintf(to, "from %.1f m/s", w.grade->low);
    fprintf(to, " averaged over %g min at %g m (%s)", w.scale->averaging / 60.0, w.scale->height,
            w.scale->source);
    if (w.scale->averaging < MEAN_TIME)
        fprintf(to, "; %.1f m/s taken as %.1f m/s over 10 min by the law '%s'\n", w.speed, *speed, law);
    else
        fprintf(to, "; taken as %.1f m/s\n", *speed);
    return WF_OK;
}

enum wf_status wf_wind_speed_read(const char *text, const char *law, FILE *to, double *speed,
                                  struct wf_err *e)
{
    struct wf_units *u;
    if (wf_wind_scale_is(text)) return grade(text, law, to, speed, e);
    const char *end = wf_number_read(text, text + strlen(text), '.', speed);
    if (end && !*end) return WF_OK;
    enum wf_status s = wf_units_open(&u, e);
    if (s) return s;
    s = wf_quantity_read(u, text, WF_DIM_SPEED, speed, e);
    wf_units_close(u);
    return s;
}
