#include "cmd/study_directions.h"
#include <math.h>

static void number(FILE *to, int width, int digits, double value)
{
    if (isfinite(value))
        fprintf(to, "%*.*f", width, digits, value);
    else
        fprintf(to, "%*s", width, isinf(value) ? "inf" : "-");
}

static void row(FILE *to, const struct wf_at_speed *at)
{
    number(to, 10, fmod(at->speed, 1.0) == 0.0 ? 0 : 2, at->speed);
    if (at->status) {
        fprintf(to, "   no equilibrium; %.0f %% of the load stood\n", 100.0 * at->response.load_factor);
        return;
    }
    number(to, 12, 3, at->tip_deflection);
    number(to, 10, 1, 100.0 * at->tip_deflection_share);
    number(to, 10, 1, at->tip_angle * 180.0 / M_PI);
    number(to, 13, 3, at->base_moment / 1e3);
    number(to, 12, 2, at->breakage.largest_stress / 1e6);
    number(to, 10, 2, at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety);
    fputc('\n', to);
}

static void critical(FILE *to, const struct wf_analysis *an, const char *what, const struct wf_break *b)
{
    const struct wf_critical *c = &b->critical;
    if (c->outcome != WF_CRITICAL_FOUND) {
        fprintf(to, "  %s: none; %s\n", what, wf_critical_text(c->outcome));
        return;
    }
    fprintf(to, "  %s %.2f m/s (%.0f km/h) at %.6g m", what, c->speed, 3.6 * c->speed,
            an->scenario.reference_height);
    if (b->row >= 0)
        fprintf(to, "; the %s breaks%s %.2f m above the ground",
                wf_model_level_name(an->model, an->species, an->tree.level[b->row]),
                b == &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE] ? " first" : "", b->height);
    fputc('\n', to);
}

void wf_study_print(FILE *to, const struct wf_run *run)
{
    const struct wf_analysis *first = &run->analysis[0];
    const struct wf_scenario *s = &first->scenario;
    fprintf(to, "Model %s, %.6g m high; wind profile %s; air %.3f kg/m3; solver %s\n", first->model->key,
            first->tallness, s->profile, first->loads.air_density, first->solver->name);
    fprintf(to, "Wind speeds are 10-min means at %.6g m\n", s->reference_height);
    if (s->speed_up != 1.0)
        fprintf(to,
                "The tree meets %.4g times the wind named (exposure of the site); critical speeds are of the "
                "wind "
                "named\n",
                s->speed_up);
    for (size_t k = 0; k < run->n; k++) {
        const struct wf_analysis *an = &run->analysis[k];
        fprintf(to, "\n%s (%s)\n", an->species->name,
                an->species->latin ? an->species->latin : an->species->key);
        fprintf(to, "%10s%12s%10s%10s%13s%12s%10s\n", "wind", "tip moves", "", "tip turns", "base moment",
                "stress", "safety");
        fprintf(to, "%10s%12s%10s%10s%13s%12s%10s\n", "m/s", "m", "% height", "deg", "kN m", "MPa", "factor");
        for (size_t i = 0; i < an->n; i++) row(to, &an->at[i]);
        critical(to, an, "critical wind speed", &an->breaks[WF_BREAKAGE][WF_SCOPE_TREE]);
        int32_t row = an->breaks[WF_BREAKAGE][WF_SCOPE_TREE].row;
        if (row >= 0 && an->tree.level[row] > 0)
            critical(to, an, "of the stem alone", &an->breaks[WF_BREAKAGE][WF_SCOPE_STEM]);
        wf_directions_print(to, an);
    }
}
