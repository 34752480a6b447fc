#include "study/exposure.h"
#include "study/limits.h"
#include "study/scenario.h"
#include <math.h>
#include <string.h>

/* Wind at the unloaded end of a row when the speed at reference height is `speed` [m/s]. */
static double wind_at_end(const struct wf_analysis *an, size_t i, double speed)
{
    struct wf_wind wind = an->wind;
    const double x[3] = { an->tree.x1[i], an->tree.y1[i], an->tree.z1[i] };
    double u[3], gradient[9];
    wind.speed = wf_scenario_speed(&an->scenario, speed);
    wind.sample(&wind, x, u, gradient);
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

/* Least and largest wind the crown meets at one speed; false without a crown. */
static bool crown_wind(const struct wf_analysis *an, double speed, double *low, double *high)
{
    *low = INFINITY;
    *high = 0.0;
    for (size_t i = 0; i < an->tree.n; i++) {
        if (an->tree.sail1[i] <= 0.0) continue;
        double u = wind_at_end(an, i, speed);
        *low = fmin(*low, u);
        *high = fmax(*high, u);
    }
    return *high > 0.0;
}

static void check_streamline(const struct wf_analysis *an, struct wf_diag *d)
{
    const struct wf_law_use *law = &an->species->streamlining;
    double least = INFINITY, largest = 0.0, low, high;
    const struct wf_critical *first = &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical;
    bool critical = first->outcome == WF_CRITICAL_FOUND;
    if (!an->loads.streamline || an->loads.streamline->rigid || !(law->high > 0.0)) return;
    for (size_t k = 0; k < an->n + critical; k++) {
        double speed = k < an->n ? an->at[k].speed : first->speed;
        if (!crown_wind(an, speed, &low, &high)) continue;
        least = fmin(least, low);
        largest = fmax(largest, high);
    }
    if (largest > law->high)
        wf_diag_warn(
            d, "streamline-range",
            "%s: the crown meets wind up to %.1f m/s%s; the evidence for its streamlining law '%s' ends at "
            "%.3g m/s (%.0f %% beyond)",
            an->species->name, largest, critical ? " (critical speed included)" : "", law->law, law->high,
            100.0 * (largest / law->high - 1.0));
    if (least < law->low)
        wf_diag_warn(
            d, "streamline-range",
            "%s: the crown meets wind down to %.1f m/s; the evidence for its streamlining law '%s' begins "
            "at %.3g m/s (%.0f %% below)",
            an->species->name, least, law->law, law->low, 100.0 * (1.0 - least / law->low));
}

static void check_reynolds(const struct wf_analysis *an, struct wf_diag *d)
{
    const double law_low = an->loads.axis_drag->law.low, law_high = an->loads.axis_drag->law.high;
    double least = INFINITY, largest = 0.0;
    for (size_t k = 0; k < an->n; k++)
        for (size_t i = 0; i < an->tree.n; i++) {
            double wind = wind_at_end(an, i, an->at[k].speed);
            double re = wind * 2.0 * an->tree.r1[i] / an->loads.air_viscosity;
            if (!isnan(an->tree.drag[i]) || wind <= 0.0) continue;
            least = fmin(least, re);
            largest = fmax(largest, re);
        }
    if (largest > law_high || least < law_low)
        wf_diag_warn(d, "reynolds-range",
                     "%s: Reynolds numbers of the axes run from %.3g to %.3g; the drag law of the cylinder "
                     "is measured "
                     "for %.0g to %.0g and held constant outside",
                     an->species->name, least, largest, law_low, law_high);
}

static void check_measured(const struct wf_scenario *s, double tallness, const char *tree, struct wf_diag *d)
{
    const struct wf_measured_profile *p = s->measured;
    double low = p->z[1], high = p->z[p->n - 1];
    if (tallness > high)
        wf_diag_warn(
            d, "profile-range",
            "%s: the tree is %.4g m high, the measured profile ends at %.4g m; above it the wind is taken "
            "as constant, which is less than it is over open ground",
            tree, tallness, high);
    if (low > 0.1 * tallness)
        wf_diag_warn(d, "profile-range",
                     "%s: the lowest %.4g m of the tree (%.0f %% of its height) stand below the lowest wind "
                     "measured; there it is taken to fall to 0 at the ground",
                     tree, fmin(low, tallness), fmin(100.0, 100.0 * low / tallness));
    if (s->reference_height > high || s->reference_height < low)
        wf_diag_warn(d, "profile-range",
                     "the reference height of %.4g m is outside the heights measured (%.4g to %.4g m)",
                     s->reference_height, low, high);
}

/* The logarithmic profile holds above its zero plane and inside the surface layer, some 100 m deep (Stull
 * 1988, An Introduction to Boundary Layer Meteorology); power-law exponents are fitted up to some 200 m
 * (Davenport 1960). */
void wf_limits_profile(const struct wf_scenario *s, double tallness, const char *tree, struct wf_diag *d)
{
    bool logarithmic = strcmp(s->profile, "log") == 0, power = strcmp(s->profile, "power") == 0;
    double bottom = s->displacement + s->roughness, top = logarithmic ? 100.0 : 200.0;
    if (logarithmic && bottom > 0.05 * tallness)
        wf_diag_warn(
            d, "profile-range",
            "%s: the lowest %.2f m of the tree (%.0f %% of its height) stand below displacement + roughness "
            "length, where the logarithmic profile gives no wind",
            tree, fmin(bottom, tallness), fmin(100.0, 100.0 * bottom / tallness));
    if ((logarithmic || power) && tallness > top)
        wf_diag_warn(d, "profile-range",
                     "%s: the tree is %.0f m high; the '%s' profile holds up to some %.0f m", tree, tallness,
                     s->profile, top);
    if (s->measured && strcmp(s->profile, "measured") == 0) check_measured(s, tallness, tree, d);
}

static void check_site(const struct wf_site *s, struct wf_diag *d)
{
    if (!s) return;
    if (s->steepest > 0.3)
        wf_diag_warn(d, "steep",
                     "%s: slopes up to %.2f: the linear speed-up holds to about 0.3; beyond, the wind "
                     "separates in the "
                     "lee and is overestimated there",
                     s->file, s->steepest);
    if (s->edge < 1000.0)
        wf_diag_warn(
            d, "map-edge",
            "%s: the tree stands %.0f m from the edge of the map; ground beyond it is taken as the mirror "
            "image of what is known",
            s->file, s->edge);
}

void wf_limits_wind(const struct wf_analysis *an, struct wf_diag *d)
{
    check_streamline(an, d);
    wf_limits_profile(&an->scenario, an->tallness, an->model->name, d);
    check_reynolds(an, d);
    check_site(an->scenario.site, d);
}
