/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/print_measures.h"
#include "cmd/option.h"
#include "study/assessment.h"
#include "study/guy.h"
#include "study/removal.h"
#include "study/verdict.h"
#include <math.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }

void wf_print_guys(FILE *to, const struct wf_analysis *an)
{
    const struct wf_at_speed *at = &an->at[an->n - 1];
    const struct wf_break *loss = wf_verdict_of(an->breaks).loss;
    for (size_t k = 0; k < an->scenario.guys; k++) {
        const struct wf_guy *g = &an->scenario.guy[k];
        wf_show(to, "  guy at %.4g m to an anchor %.4g m away towards %.0f deg: ", g->height, g->distance,
                degrees(g->towards));
        if (at->status)
            wf_show(to, "no equilibrium in %.4g m/s", at->speed);
        else
            wf_show(to, at->tie[k] > 0 ? "%.3g kN in %.4g m/s" : "slack in %.4g m/s",
                    at->tie[k] > 0 ? at->tie[k] / 1e3 : at->speed, at->speed);
        if (loss && loss->critical.outcome == WF_CRITICAL_FOUND && !loss->at.status)
            wf_show(to, ", %.3g kN in the critical wind", loss->at.tie[k] / 1e3);
        wf_show(to, "\n");
    }
    if (an->scenario.guys)
        wf_show(to, "    static forces; the strength of guys, anchors and fittings is not assessed%s\n",
                an->loads.ties ? "; a foot that turns more than was computed puts more on them" : "");
}

static void print_cell(FILE *to, double x)
{
    if (isfinite(x))
        wf_show(to, "%12.4g", x);
    else
        wf_show(to, "%12s", "-");
}

void wf_print_removals(FILE *to, const struct wf_analysis *an)
{
    const struct wf_removals *r = an->removals;
    bool flagged = false;
    if (!r) return;
    wf_show(to, "\n  Without branches, at the peak of the load in %.4g m/s\n%28s%12s%12s%12s%12s%12s%12s\n",
            an->at[an->n - 1].speed, "without", "crown gone", "drag kN", "weight kN", "moment kNm", "safety",
            "lost at m/s");
    for (size_t k = 0; k < r->n; k++) {
        const struct wf_removal *x = &r->item[k];
        bool much = x->cut > WF_ASSESS_CUT_FLAGGED;
        flagged = flagged || much;
        wf_show(to, "%28.28s%9.0f %%%s", x->what ? x->what->name : "as it stands", 100 * x->cut,
                much ? "!" : " ");
        print_cell(to, x->drag / 1e3);
        print_cell(to, x->weight / 1e3);
        print_cell(to, x->base_moment / 1e3);
        print_cell(to, x->safety);
        if (isfinite(x->searched))
            wf_show(to, "%7s%-5.4g", "> ", x->searched);
        else
            print_cell(to, x->critical);
        wf_show(to, "\n");
    }
    if (flagged)
        wf_show(to, "  !: more than %.0f %% of the crown: a loss that harms the tree\n",
                100 * WF_ASSESS_CUT_FLAGGED);
    wf_show(
        to,
        "  '-': none found. What is left keeps its shape; the wound, new sprouts and more wind on what was "
        "sheltered are not computed\n");
}
