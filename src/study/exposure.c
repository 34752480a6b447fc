#include "study/exposure.h"
#include "base/num.h"
#include <math.h>

enum wf_status wf_site_read(struct wf_site *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_terrain *t = &s->ground;
    enum wf_status status = wf_terrain_read(s->file, a, t, e);
    if (status) return status;
    double x1 = t->x0 + (double)(t->columns - 1) * t->cell, y1 = t->y0 + (double)(t->rows - 1) * t->cell;
    if (isnan(wf_terrain_height(t, s->x, s->y)))
        return wf_fail(
            e, WF_EUSAGE,
            "%s: the tree at %.9g, %.9g is outside the map or where it has no data; it reaches from %.9g, "
            "%.9g to %.9g, %.9g",
            s->file, s->x, s->y, t->x0, t->y0, x1, y1);
    s->steepest = wf_terrain_steepest(t);
    s->edge = fmin(fmin(s->x - t->x0, x1 - s->x), fmin(s->y - t->y0, y1 - s->y));
    return WF_OK;
}

enum wf_status wf_site_speed_up(const struct wf_site *s, double from, double height, double roughness,
                                double *factor, struct wf_err *e)
{
    const struct wf_speedup_request q = { .from = from, .height = height, .roughness = roughness };
    struct wf_arena scratch = { 0 };
    struct wf_speedup up;
    enum wf_status status = wf_terrain_speedup(&s->ground, &q, &scratch, &up, e);
    if (!status) {
        struct wf_terrain change = s->ground; /* the same grid, holding the change of the wind */
        change.z = up.ds;
        *factor = 1.0 + wf_terrain_height(&change, s->x, s->y);
        if (!(*factor >= 0.1 && *factor <= 5.0))
            status = wf_fail(
                e, WF_EINPUT,
                "%s: wind from %.1f deg would be %.3g times that over level ground; slopes up to %.2f are "
                "too steep for the linear speed-up",
                s->file, from * 180.0 / WF_PI, *factor, s->steepest);
    }
    wf_arena_free(&scratch);
    return status;
}
