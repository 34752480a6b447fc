#include "cmd/study_directions.h"
#include "wind/scale.h"
#include <math.h>
#include <stdlib.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }

enum wf_status wf_directions_asked(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_directions_request *out, struct wf_err *e)
{
    const char *n = wf_args_text(g, "--directions"), *climate = wf_args_text(g, "--climate");
    const char *law = wf_args_text(g, "--averaging");
    *out = (struct wf_directions_request){ .n = n ? (size_t)atoi(n) : 0,
                                           .north = wf_args_number(g, "--north"),
                                           .climate_file = climate,
                                           .law = law ? law : "durst",
                                           .threads = (size_t)llround(wf_args_number(g, "--threads")) };
    if (!climate) return WF_OK;
    struct wf_rose *rose = WF_TAKE(a, 1, struct wf_rose);
    if (!rose) return wf_fail(e, WF_ENOMEM, "no room for a climate");
    enum wf_status s = wf_rose_read(climate, a, d, rose, e);
    if (s) return s;
    out->rose = rose;
    if (n && out->n != rose->sectors)
        return wf_fail(e, WF_EUSAGE, "--directions %s: %s has %zu; leave --directions out to take them", n,
                       climate, rose->sectors);
    out->n = rose->sectors;
    return WF_OK;
}

static void cell(FILE *to, int width, int digits, double x)
{
    if (isfinite(x))
        fprintf(to, "%*.*f", width, digits, x);
    else
        fprintf(to, "%*s", width, "-");
}

/* At the strongest wind asked for. */
static void row(FILE *to, const struct wf_analysis *an, const struct wf_direction *d)
{
    const struct wf_at_speed *at = &d->at[an->n - 1];
    fprintf(to, "%8g", degrees(d->from));
    cell(to, 13, 3, at->base_moment / 1e3);
    cell(to, 11, 3, at->tip_deflection);
    cell(to, 9, 2, at->status ? NAN : at->breakage.least_safety);
    cell(to, 12, 2, d->breaks.critical.speed);
    cell(to, 10, 2, d->breaks.height);
    cell(to, 12, 2, d->stem.critical.speed);
    if (an->directions->request.rose) {
        cell(to, 12, 3, WF_HOURS_A_YEAR * d->hourly);
        cell(to, 12, 3, WF_HOURS_A_YEAR * d->strongest);
    }
    fputc('\n', to);
}

static void climate(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    fprintf(to, "%-65s", "     all, hours a year");
    cell(to, 22, 3, WF_HOURS_A_YEAR * x->hourly);
    cell(to, 12, 3, WF_HOURS_A_YEAR * x->strongest);
    fprintf(to,
            "\n  The critical wind is one that lasts, a 10-min mean at %.6g m. Hours a year: with an hourly "
            "mean above "
            "it;\n  with a 10-min mean above it, %.3f of the hourly mean by the law '%s'. Climate: %s.\n",
            an->scenario.reference_height, x->gust, x->request.law, x->request.climate_file);
    if (x->above)
        fprintf(to, "  '-': no breakage up to %.4g m/s; these directions count as 0 hours.\n",
                an->scenario.speed_max);
}

void wf_directions_print(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    if (!x) return;
    bool rose = x->request.rose;
    fprintf(to, "\n  Wind from all around, clockwise from north; north is ");
    if (x->request.north == 0.0)
        fprintf(to, "+y, east +x of the model\n");
    else
        fprintf(to, "%g deg clockwise from +y of the model\n", degrees(x->request.north));
    fprintf(to, "%8s%13s%11s%9s%12s%10s%12s%s\n", "from", "base moment", "tip moves", "safety", "critical",
            "breaks", "stem alone", rose ? "  hours/year with wind" : "");
    fprintf(to, "%8s%13s%11s%9s%12s%10s%12s%s\n", "deg", "kN m", "m", "factor", "wind m/s", "at m", "m/s",
            rose ? "  above: mean      10 min" : "");
    for (size_t k = 0; k < x->request.n; k++) row(to, an, &x->direction[k]);
    if (rose) climate(to, an);
    fprintf(to, "  Moment, movement and safety at %.6g m/s.\n", an->at[an->n - 1].speed);
}
