/* A measured record as a gust model: resampled to the step by straight lines, the same at all points, carried
 * along at the mean speed. */
#include "wind/gust_rows.h"
#include <math.h>

struct play {
    const double *part[3];
    double scale; /* of all components: asked mean wind / recorded mean wind, 1 without rescaling */
};

enum wf_status wf_gust_record_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    const struct wf_record *r = s->record;
    struct play *w = WF_TAKE(a, 1, struct play);
    if (!w) return wf_fail(e, WF_ENOMEM, "no room for a gust model");
    *w = (struct play){ { r->u, r->v, r->w }, wf_gust_get(s, "rescale") > 0.0 ? s->speed / r->mean : 1.0 };
    g->work = w;
    return wf_gust_direct_open(g, a, e);
}

static double at_time(const double *x, const struct wf_record *r, double t)
{
    double place = fmin(fmax(t / r->step, 0.0), (double)(r->n - 1));
    size_t i = (size_t)place;
    if (i + 1 >= r->n) return x[r->n - 1];
    return x[i] + (x[i + 1] - x[i]) * (place - (double)i);
}

enum wf_status wf_gust_record_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e)
{
    const struct wf_gust_spec *s = &g->spec;
    const struct play *w = g->work;
    const struct wf_record *r = s->record;
    double carried = w->scale * r->mean;
    (void)e;
    for (unsigned c = 0; c < s->components; c++)
        for (size_t p = 0; p < s->points; p++) {
            double shift = c == 0 && s->mean ? s->mean[p] - carried : 0.0;
            for (size_t i = 0; i < steps; i++) {
                double t = (double)(first + i) * s->step - wf_gust_place(s, p, 0) / carried;
                out[(c * s->points + p) * g->block + i] =
                    w->part[c] ? shift + w->scale * at_time(w->part[c], r, t) : 0.0;
            }
        }
    return WF_OK;
}
