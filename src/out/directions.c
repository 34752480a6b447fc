/* Winds from all around: their part of results.json and their table. */
#include "study/directions.h"
#include "out/parts.h"
#include "out/tables.h"
#include <math.h>

static const double degrees = 57.295779513082320877; /* 180 / pi */
static const char none[] = "no climate, or no critical wind speed";

static json_t *one(struct wf_doc *d, const struct wf_analysis *a, const struct wf_direction *x)
{
    json_t *o = wf_doc_object(d), *winds;
    const double *exposed = a->directions->request.speed_up;
    wf_doc_quantity(d, o, "from", x->from, "rad", NULL);
    wf_doc_quantity(d, o, "speed_up", exposed ? exposed[x - a->directions->direction] : a->scenario.speed_up,
                    "1", NULL);
    winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    for (size_t k = 0; k < a->n; k++) wf_doc_add(d, winds, wf_part_wind(d, a, &x->at[k]));
    wf_doc_put(d, o, "critical", wf_part_critical(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", wf_part_critical(d, a, &x->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
    wf_doc_put(d, o, "criteria", wf_part_criteria(d, a, x->breaks, x->at));
    wf_doc_quantity(d, o, "hours_a_year", WF_HOURS_A_YEAR * x->hourly, "h", none);
    wf_doc_quantity(d, o, "hours_a_year_10_min", WF_HOURS_A_YEAR * x->strongest, "h", none);
    return o;
}

json_t *wf_part_directions(struct wf_doc *d, const struct wf_analysis *a)
{
    const struct wf_directions *x = a->directions;
    if (!x) return json_null();
    const struct wf_directions_request *q = &x->request;
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "number", q->n);
    wf_doc_quantity(d, o, "north", q->north, "rad", NULL);
    wf_doc_quantity(d, o, "main_from", wf_direction_from(q, a->scenario.azimuth), "rad", NULL);
    wf_doc_text(d, o, "climate_file", q->climate_file);
    wf_doc_text(d, o, "averaging_law", q->rose ? q->law : NULL);
    wf_doc_quantity(d, o, "strongest_10_min_over_hourly", x->gust, "1", none);
    wf_doc_quantity(d, o, "hours_a_year", WF_HOURS_A_YEAR * x->hourly, "h", none);
    wf_doc_quantity(d, o, "hours_a_year_10_min", WF_HOURS_A_YEAR * x->strongest, "h", none);
    wf_doc_flag(d, o, "searched_to_the_end", x->above);
    wf_doc_quantity(d, o, "searched_to", a->search.speed_max, "m/s", NULL);
    json_t *list = wf_doc_put(d, o, "directions", wf_doc_array(d));
    for (size_t k = 0; k < q->n; k++) wf_doc_add(d, list, one(d, a, &x->direction[k]));
    return o;
}

static void row(const struct wf_run *run, size_t tree, size_t k, size_t wind, FILE *f)
{
    const struct wf_analysis *a = &run->analysis[tree];
    const struct wf_directions *x = a->directions;
    const struct wf_direction *d = &x->direction[k];
    const struct wf_at_speed *at = &d->at[wind];
    const double total[] = { at->tip_deflection,
                             degrees * at->tip_angle,
                             at->drag,
                             at->base_shear,
                             at->base_moment,
                             1e-6 * at->breakage.largest_stress,
                             at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety };
    wf_table_lead(f, run, tree, at->speed);
    wf_table_cell(f, degrees * d->from);
    fprintf(f, ",%s", wf_part_status(at->status));
    for (size_t c = 0; c < sizeof total / sizeof *total; c++) wf_table_cell(f, at->status ? NAN : total[c]);
    const struct wf_break *const breaks[] = { &d->breaks[WF_BREAKAGE][WF_SCOPE_TREE],
                                              &d->breaks[WF_BREAKAGE][WF_SCOPE_STEM] };
    for (size_t c = 0; c < 2; c++) {
        wf_table_cell(f, breaks[c]->critical.speed);
        fprintf(f, ",%s", wf_part_outcome(breaks[c]->critical.outcome));
        wf_table_cell(f, breaks[c]->height);
    }
    const struct wf_rose *r = x->request.rose;
    wf_table_cell(f, r ? r->frequency[k] : NAN);
    wf_table_cell(f, r ? r->scale[k] : NAN);
    wf_table_cell(f, r ? r->shape[k] : NAN);
    wf_table_cell(f, WF_HOURS_A_YEAR * d->hourly);
    wf_table_cell(f, WF_HOURS_A_YEAR * d->strongest);
    wf_table_cell(f, x->request.speed_up ? x->request.speed_up[k] : a->scenario.speed_up);
    putc('\n', f);
}

bool wf_directions_made(const struct wf_run *run) { return run->analysis[0].directions != NULL; }

size_t wf_directions_write(const struct wf_run *run, FILE *f)
{
    size_t rows = 0;
    fputs("tree,species,wind_m_s,from_deg,status,tip_deflection_m,tip_angle_deg,drag_N,base_shear_N,base_"
          "moment_Nm,"
          "largest_stress_MPa,least_safety,critical_wind_m_s,critical_outcome,critical_height_m,"
          "stem_critical_wind_m_s,stem_critical_outcome,stem_critical_height_m,frequency,weibull_scale_m_s,"
          "weibull_shape,hours_a_year,hours_a_year_10_min,speed_up\n",
          f);
    for (size_t i = 0; i < run->n; i++)
        for (size_t wind = 0; wind < run->analysis[i].n; wind++)
            for (size_t k = 0; k < run->analysis[i].directions->request.n; k++, rows++)
                row(run, i, k, wind, f);
    return rows;
}
