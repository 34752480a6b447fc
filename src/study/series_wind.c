#include "study/series_wind.h"
#include "wind/gust_words.h"
#include <math.h>
#include <string.h>

/* Can every frame have a direction of its own? */
static bool turns(const struct wf_series_spec *q)
{
    bool frames = q->solver == &wf_solver_deflect || q->solver == &wf_solver_deflect_as_printed;
    return !frames && !q->shelter;
}

/* How many components of the gust are used. */
static unsigned components(const struct wf_series_spec *q, const struct wf_gust_spec *gust, struct wf_diag *d)
{
    unsigned most = gust->model->components;
    if (gust->record && gust->record->components < most) most = 1;
    unsigned asked = q->components ? q->components : most;
    if (asked == 1 || turns(q)) return asked;
    wf_diag_warn(d, "along-wind-only",
                 "%s: the gust model '%s' has 3 components; the one along the wind alone is used, because %s",
                 q->name, gust->model->name,
                 q->shelter ? "the wind inside the crown is made for one direction"
                            : "the deflect solvers go from frame to frame in one direction");
    return 1;
}

static enum wf_status specify(const struct wf_series *s, struct wf_gust_spec *out, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    const struct wf_gust_model *model = wf_gust_named(q->gust);
    enum wf_status status;
    if (!model) return wf_fail(e, WF_EUSAGE, "no gust model is called '%s'", q->gust);
    wf_gust_spec_default(model, out);
    out->speed = q->speed;
    out->height = s->an.scenario.reference_height;
    if (!isnan(q->intensity)) out->intensity = q->intensity;
    out->step = q->step;
    out->steps = s->frames;
    out->seed = q->seed;
    if (!isnan(q->period) && wf_gust_set(out, "period", q->period, e)) return e->code;
    if ((status = wf_gust_set_words(out, q->gust_set, a, e))) return status;
    if (strcmp(model->name, "record") == 0)
        status = wf_gust_record_words(out, q->gust_file, q->gust_columns, a, d, e);
    else if (q->gust_file)
        status = wf_fail(e, WF_EUSAGE, "%s: a file goes with the gust model 'record', not '%s'", q->gust_file,
                         model->name);
    out->components = components(q, out, d);
    return status;
}

enum wf_status wf_series_wind(struct wf_series *s, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    struct wf_gust_spec spec;
    struct wf_gust gust;
    for (size_t k = 0; k < s->frames; k++) s->wind[k] = q->speed;
    if (!q->gust)
        return q->gust_file ? wf_fail(e, WF_EUSAGE, "%s: a steady wind has no file", q->gust_file) : WF_OK;
    enum wf_status status = specify(s, &spec, a, d, e);
    if (!status) status = wf_gust_open(&spec, a, d, &gust, e);
    if (status) return status;
    double *block = WF_TAKE(a, spec.components * gust.block, double);
    double **const part[] = { &s->wind, &s->across, &s->up };
    s->gust_words = wf_gust_words(&spec, a);
    bool room = block && s->gust_words;
    for (unsigned c = 1; c < spec.components; c++) room = (*part[c] = WF_TAKE(a, s->frames, double)) && room;
    if (!room) status = wf_fail(e, WF_ENOMEM, "no room for the wind");
    for (unsigned c = 0; c < spec.components && !status; c++)
        status = wf_gust_series(&gust, 0, c, block, *part[c], e);
    wf_gust_close(&gust);
    return status;
}

void wf_series_blow(const struct wf_series *s, size_t k, struct wf_wind *wind)
{
    double along = s->wind[k], across = s->across ? s->across[k] : 0.0, up = s->up ? s->up[k] : 0.0;
    double to[3] = { wind->direction[0], wind->direction[1], 0.0 }, speed = hypot(hypot(along, across), up);
    const double own[3] = { along * to[0] - across * to[1], along * to[1] + across * to[0], up };
    wind->speed = speed;
    for (int i = 0; i < 3 && speed > 0.0; i++) wind->direction[i] = own[i] / speed;
}
