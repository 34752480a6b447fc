/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/walls.h"
#include "base/num.h"
#include "data/cavity.h"
#include "data/hollow.h"
#include "study/walls.h"
#include <math.h>

enum { OUTLINE_MOST = 4096 };

static double degrees(double angle) { return angle * 360 / WF_TURN; }

/* Outline of the sound wood at the height where it was measured [mm]; lines end at null. */
static void outline_part(struct wf_doc *d, json_t *o, const struct wf_walls *w, struct wf_arena *a)
{
    double(*point)[2] = wf_arena_take(a, OUTLINE_MOST, sizeof *point);
    double *x = WF_TAKE(a, OUTLINE_MOST, double), *y = WF_TAKE(a, OUTLINE_MOST, double);
    if (!point || !x || !y) {
        d->failed = true;
        return;
    }
    size_t n = wf_hollow_outline(w->hollow, OUTLINE_MOST, point);
    for (size_t k = 0; k < n; k++) x[k] = 1e3 * w->radius * point[k][0], y[k] = 1e3 * w->radius * point[k][1];
    wf_doc_numbers(d, o, "outline_x_mm", x, n);
    wf_doc_numbers(d, o, "outline_y_mm", y, n);
}

/* The walls needed for each safety, by the given winds. */
static json_t *limits_part(struct wf_doc *d, const struct wf_analysis *an, const struct wf_walls *w)
{
    json_t *list = wf_doc_array(d);
    for (int l = 0; l < WF_WALL_LIMITS; l++) {
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "criterion", wf_wall_limits[l].criterion);
        wf_doc_number(d, o, "wall_safety", wf_wall_limits[l].required);
        wf_doc_number(d, o, "wall_share", w->at[an->n - 1].share[l]);
        json_t *walls = wf_doc_put(d, o, "least_walls_mm", wf_doc_array(d));
        for (size_t k = 0; k < an->n; k++) {
            double wall = 1e3 * w->radius * w->at[k].share[l];
            wf_doc_add(d, walls, isfinite(wall) ? json_real(wall) : json_null());
        }
    }
    return list;
}

static void cavity_part(struct wf_doc *d, json_t *o, const struct wf_analysis *an, const struct wf_walls *w,
                        struct wf_arena *a)
{
    const struct wf_wall_safety *last = &w->at[an->n - 1];
    wf_doc_number(d, o, "at_m", w->cavity->at);
    wf_doc_number(d, o, "from_m", w->cavity->from);
    wf_doc_number(d, o, "to_m", w->cavity->to);
    wf_doc_number(d, o, "wood_radius_mm", 1e3 * w->radius);
    wf_doc_number(d, o, "thinnest_wall_mm", 1e3 * w->wall);
    wf_doc_flag(d, o, "open", w->hollow->open);
    wf_doc_number(d, o, "strength_loss", w->strength_loss);
    wf_doc_number(d, o, "worst_towards_deg", degrees(w->worst));
    wf_doc_number(d, o, "strength_loss_with_wind", w->with_wind);
    wf_doc_number(d, o, "stiffness_loss", w->stiffness_loss);
    wf_doc_number(d, o, "speed_m_s", an->at[an->n - 1].speed);
    wf_doc_number(d, o, "safety_basic", last->basic);
    wf_doc_number(d, o, "safety_present", last->present);
    wf_doc_put(d, o, "wall_limits", limits_part(d, an, w));
    outline_part(d, o, w, a);
}

json_t *wf_part_walls(struct wf_doc *d, const struct wf_analysis *an)
{
    struct wf_arena scratch = { 0 };
    struct wf_err e = { 0 };
    struct wf_walls *w;
    size_t n;
    json_t *list = wf_doc_array(d);
    if (wf_walls_assess(an, &scratch, &w, &n, &e)) d->failed = true, n = 0;
    for (size_t k = 0; k < n; k++) cavity_part(d, wf_doc_add(d, list, wf_doc_object(d)), an, &w[k], &scratch);
    wf_arena_free(&scratch);
    return list;
}
