/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/print_walls.h"
#include "base/num.h"
#include "cmd/option.h"
#include "data/cavity.h"
#include "data/hollow.h"
#include "study/walls.h"
#include <math.h>

static void print_safety(FILE *to, double safety)
{
    if (isnan(safety))
        wf_show(to, "not known");
    else
        wf_show(to, "%.2f", safety);
}

static void print_wall(FILE *to, const struct wf_walls *w, double share)
{
    if (isinf(share))
        wf_show(to, "%19s", "not even solid");
    else if (isnan(share))
        wf_show(to, "%19s", "-");
    else
        wf_show(to, "%8.0f mm (%.3f)", 1e3 * w->radius * share, share);
}

/* One cavity: what it takes, and the least wall by wind. */
static void print_cavity(FILE *to, const struct wf_analysis *an, const struct wf_walls *w)
{
    const struct wf_wall_safety *last = &w->at[an->n - 1];
    wf_show(to, "  cavity at %g m: thinnest wall %.0f mm of %.0f mm wood radius (t/R %.3f)%s\n",
            w->cavity->at, 1e3 * w->wall, 1e3 * w->radius, w->wall / w->radius,
            w->hollow->open ? ", open: upper bound, cracking at the opening not assessed" : "");
    wf_show(to,
            "    strength loss %.0f %% with the wind, at most %.0f %% (towards %.0f deg); stiffness loss "
            "%.0f %%; "
            "safety at %.6g m/s ",
            100 * w->with_wind, 100 * w->strength_loss, w->worst * 360 / WF_TURN, 100 * w->stiffness_loss,
            an->at[an->n - 1].speed);
    print_safety(to, last->present);
    wf_show(to, ", without the cavity ");
    print_safety(to, last->basic);
    wf_show(to, "\n    least wall of a closed ring under the same moment, for a safety of 1.0 and 1.5 by "
                "bending strength, 1.5 "
                "by the elastic limit, splitting included:\n");
    for (size_t k = 0; k < an->n; k++) {
        wf_show(to, "%10.6g m/s", an->at[k].speed);
        for (int l = 0; l < WF_WALL_LIMITS; l++) print_wall(to, w, w->at[k].share[l]);
        fputc('\n', to);
    }
}

void wf_print_walls(FILE *to, const struct wf_analysis *an)
{
    struct wf_arena scratch = { 0 };
    struct wf_err e = { 0 };
    struct wf_walls *w;
    size_t n;
    if (wf_walls_assess(an, &scratch, &w, &n, &e)) wf_show(to, "  cavities: %s\n", e.text), n = 0;
    for (size_t k = 0; k < n; k++) print_cavity(to, an, &w[k]);
    wf_arena_free(&scratch);
}
