#include "solve/beam.h"
#include "solve/modes.h"
#include "solve/vec.h"

/* Has the unloaded shape under `factor` times the weight an unstable direction? */
static bool gives_way(struct wf_beam *b, double factor)
{
    struct wf_beam_stability count = { .margin = 0 };
    b->loads.weight_scale = factor;
    b->misfit = (struct wf_beam_misfit){ 0 };
    return !wf_beam_sweep_down(b, true, &count) || count.negative > 0;
}

static double smallest_factor(struct wf_beam *b)
{
    double low = 0, high = 1;
    while (!gives_way(b, high)) {
        low = high, high *= 2;
        if (high > 1e6) return INFINITY;
    }
    for (int i = 0; i < 200 && high - low > 1e-13 * high; i++) {
        double middle = 0.5 * (low + high);
        if (gives_way(b, middle))
            high = middle;
        else
            low = middle;
    }
    return 0.5 * (low + high);
}

enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_loads weight = *l;
    struct wf_arena work = { 0 };
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    weight.wind = NULL, weight.points = 0, weight.line = NULL;
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;
    double before = NAN;
    for (int mesh = 0; mesh < MESHES; mesh++) {
        struct wf_beam b;
        status = wf_beam_init(&b, t, &weight, o, pieces, &work, e);
        if (status) break;
        wf_beam_sweep_up(&b);
        *factor = smallest_factor(&b);
        /* error of the finer of two meshes of ratio 2: a fifteenth of their difference */
        if (!(o->mesh_tolerance > 0) || isinf(*factor) ||
            fabs(before / *factor - 1) <= 15 * 0.25 * o->mesh_tolerance)
            break;
        before = *factor;
        for (size_t i = 0; i < t->n; i++) pieces[i] *= 2;
    }
    wf_arena_free(&work);
    return status;
}
