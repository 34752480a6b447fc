/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/print_measures.h"
#include "cmd/option.h"
#include "study/assessment.h"
#include "study/brace.h"
#include "study/guy.h"
#include "study/peak.h"
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

/* "3.2 kN", of a rod that pushes "3.2 kN pushing". */
static void print_force(FILE *to, double force)
{
    wf_show(to, "%.3g kN", fabs(force) / 1e3);
    if (force < 0) wf_show(to, " pushing");
}

void wf_print_braces(FILE *to, const struct wf_analysis *an)
{
    const struct wf_break *loss = wf_verdict_of(an->breaks).loss;
    /* where branches have a peak of their own, the state in the critical wind is that of the stem's alone */
    bool found = loss && loss->critical.outcome == WF_CRITICAL_FOUND && !loss->at.status &&
                 !wf_peak_branches(an->peak);
    for (size_t k = 0; k < an->scenario.braces; k++) {
        const struct wf_brace *b = &an->scenario.brace[k];
        const struct wf_at_speed *at = wf_brace_worst(an, k);
        wf_show(to, b->rod ? "  rod from %s to %s: " : "  cable from %s to %s: ", b->end[0].name,
                b->end[1].name);
        if (!at)
            wf_show(to, "no equilibrium in the given winds");
        else if (!(fabs(at->link[k]) > 0))
            wf_show(to, "slack in the given winds");
        else {
            print_force(to, at->link[k]);
            wf_show(to, " at most, in %.4g m/s", at->speed);
        }
        if (found) wf_show(to, ", ");
        if (found) print_force(to, loss->at.link[k]);
        if (found) wf_show(to, " in the critical wind");
        if (at && at->link[k] > 0 && isfinite(b->breaking))
            wf_show(to, "; it breaks at %.4g kN: safety %.3g", b->breaking / 1e3, b->breaking / at->link[k]);
        wf_show(to, "\n");
    }
    if (an->scenario.braces)
        wf_show(to, "    static forces in wind from this direction, at the peak of the load; how their ends "
                    "hold in the "
                    "wood, fittings, and rods that buckle, are not assessed\n");
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
