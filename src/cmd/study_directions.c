#include "cmd/study_directions.h"
#include "base/number.h"
#include "wind/scale.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }

enum wf_status wf_directions_asked(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_directions_request *out, struct wf_err *e)
{
    const char *n = wf_args_text(g, "--directions"), *climate = wf_args_text(g, "--climate");
    const char *law = wf_args_text(g, "--averaging");
    *out = (struct wf_directions_request){ .n = n ? (size_t)atoi(n) : 0,
                                           .north = wf_args_number(g, "--north"),
                                           .climate_file = climate,
                                           .law = law ? law : "durst" };
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

/* "x,y". */
static enum wf_status place(const char *text, double *x, double *y, struct wf_err *e)
{
    const char *end = text ? text + strlen(text) : NULL, *comma = text ? strchr(text, ',') : NULL;
    if (comma && wf_number_read(text, comma, '.', x) == comma &&
        wf_number_read(comma + 1, end, '.', y) == end)
        return WF_OK;
    return wf_fail(e, WF_EUSAGE,
                   "--at: '%.100s': the tree's place on --dem is written x,y in m, for example 450,1200",
                   text ? text : "");
}

static enum wf_status found(struct wf_site *site, const struct wf_args *g, struct wf_arena *a,
                            struct wf_scenario *s, struct wf_directions_request *q, struct wf_err *e)
{
    double *factor = WF_TAKE(a, q->n + 1, double), from = wf_direction_from(q, s->azimuth);
    enum wf_status status = place(wf_args_text(g, "--at"), &site->x, &site->y, e);
    if (!factor) return wf_fail(e, WF_ENOMEM, "no room for %zu directions", q->n);
    if (!status) status = wf_site_read(site, a, e);
    if (!status) status = wf_site_speed_up(site, from, s->reference_height, s->roughness, &s->speed_up, e);
    for (size_t k = 0; k < q->n && !status; k++)
        status = wf_site_speed_up(site, 2.0 * M_PI * (double)k / (double)q->n, s->reference_height,
                                  s->roughness, &factor[k], e);
    s->site = site, q->speed_up = factor;
    return status;
}

enum wf_status wf_exposure_asked(const struct wf_args *g, struct wf_arena *a, struct wf_scenario *s,
                                 struct wf_directions_request *q, struct wf_err *e)
{
    const char *dem = wf_args_text(g, "--dem");
    if (wf_args_given(g, "--speed-up")) s->speed_up = wf_args_number(g, "--speed-up");
    if (!dem && wf_args_given(g, "--at"))
        return wf_fail(e, WF_EUSAGE, "--at: a place on the ground needs the ground, --dem");
    if (dem && wf_args_given(g, "--speed-up"))
        return wf_fail(e, WF_EUSAGE, "--speed-up and --dem: one of them says how exposed the tree is");
    if (!dem) return WF_OK;
    struct wf_site *site = WF_TAKE(a, 1, struct wf_site);
    if (!site) return wf_fail(e, WF_ENOMEM, "no room for a map");
    site->file = dem;
    return found(site, g, a, s, q, e);
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
    cell(to, 9, 2, at->status ? NAN : at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety);
    cell(to, 12, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.speed);
    cell(to, 10, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_TREE].height);
    cell(to, 12, 2, d->breaks[WF_BREAKAGE][WF_SCOPE_STEM].critical.speed);
    const struct wf_directions_request *q = &an->directions->request;
    if (q->speed_up) cell(to, 10, 3, q->speed_up[d - an->directions->direction]);
    if (q->rose) {
        cell(to, 12, 3, WF_HOURS_A_YEAR * d->hourly);
        cell(to, 12, 3, WF_HOURS_A_YEAR * d->strongest);
    }
    fputc('\n', to);
}

static void climate(FILE *to, const struct wf_analysis *an)
{
    const struct wf_directions *x = an->directions;
    fprintf(to, "%-*s", x->request.speed_up ? 85 : 75, "     all, hours a year");
    cell(to, 12, 3, WF_HOURS_A_YEAR * x->hourly);
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
    bool rose = x->request.rose, site = x->request.speed_up;
    fprintf(to, "\n  Wind from all around, clockwise from north; north is ");
    if (x->request.north == 0.0)
        fprintf(to, "+y, east +x of the model\n");
    else
        fprintf(to, "%g deg clockwise from +y of the model\n", degrees(x->request.north));
    fprintf(to, "%8s%13s%11s%9s%12s%10s%12s%s%s\n", "from", "base moment", "tip moves", "safety", "critical",
            "breaks", "stem alone", site ? "  exposure" : "", rose ? "  hours/year with wind" : "");
    fprintf(to, "%8s%13s%11s%9s%12s%10s%12s%s%s\n", "deg", "kN m", "m", "factor", "wind m/s", "at m", "m/s",
            site ? "          " : "", rose ? "  above: mean      10 min" : "");
    for (size_t k = 0; k < x->request.n; k++) row(to, an, &x->direction[k]);
    if (rose) climate(to, an);
    fprintf(to, "  Moment, movement and safety at %.6g m/s.\n", an->at[an->n - 1].speed);
}
