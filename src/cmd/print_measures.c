/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/print_measures.h"
#include "cmd/option.h"
#include "study/guy.h"
#include <math.h>
#include <string.h>

static double degrees(double rad) { return rad * 180.0 / M_PI; }

/* "3.2 kN", of a rod that pushes "3.2 kN pushing". */
static void print_force(FILE *to, double force)
{
    wf_show(to, "%.3g kN", fabs(force) / 1e3);
    if (force < 0) wf_show(to, " pushing");
}

/* Its forces, to the end of the line. */
static void print_hold(FILE *to, const struct wf_beside_hold *h)
{
    if (isnan(h->force))
        wf_show(to, "no equilibrium in the given winds");
    else if (!(fabs(h->force) > 0))
        wf_show(to, "slack in the given winds");
    else {
        print_force(to, h->force);
        wf_show(to, " at most, in %.4g m/s", h->speed);
        if (isfinite(h->wind_from))
            wf_show(to, " from %.0f deg", fmod(round(degrees(h->wind_from)) + 360, 360));
    }
    if (isfinite(h->critical)) wf_show(to, ", ");
    if (!(fabs(h->critical) > 0) && isfinite(h->critical)) wf_show(to, "slack");
    if (fabs(h->critical) > 0) print_force(to, h->critical);
    if (isfinite(h->critical))
        wf_show(to, isfinite(h->wind_from) ? " in the critical wind of the weakest direction"
                                           : " in the critical wind");
    if (isfinite(h->safety)) wf_show(to, "; it breaks at %.4g kN: safety %.3g", h->breaking / 1e3, h->safety);
    wf_show(to, "\n");
}

void wf_print_holds(FILE *to, const struct wf_analysis *an)
{
    struct wf_arena scratch = { 0 };
    struct wf_err unsaid = { WF_OK, "" };
    const struct wf_beside_hold *hold;
    size_t n;
    if (wf_beside_holds(an, &scratch, &n, &hold, &unsaid)) n = 0;
    for (size_t k = 0; k < n; k++) {
        const struct wf_guy *g = k < an->scenario.guys ? &an->scenario.guy[k] : NULL;
        bool rod = !strcmp(hold[k].kind, "rod");
        if (g)
            wf_show(to, "  guy at %.4g m to an anchor %.4g m away towards %.0f deg: ", g->height, g->distance,
                    degrees(g->towards));
        else
            wf_show(to, rod ? "  rod from %s to %s: " : "  cable from %s to %s: ", hold[k].from, hold[k].to);
        print_hold(to, &hold[k]);
    }
    wf_arena_free(&scratch);
    if (an->scenario.guys)
        wf_show(to, "    static forces; the strength of guys, anchors and fittings is not assessed%s\n",
                an->loads.ties ? "; a foot that turns more than was computed puts more on them" : "");
    bool around = an->assessment && an->assessment->directions;
    if (an->scenario.braces && !around)
        wf_show(to, "    static forces in wind from this direction, at the peak of the load; how their ends "
                    "hold in the "
                    "wood, fittings, and rods that buckle, are not assessed\n");
    if (an->scenario.braces && around)
        wf_show(to,
                "    static forces, the largest of the directions below, at the peak of the load; how their "
                "ends hold in the wood, fittings, and rods that buckle, are not assessed\n");
}

static void print_cell(FILE *to, double x)
{
    if (isfinite(x))
        wf_show(to, "%12.4g", x);
    else
        wf_show(to, "%12s", "-");
}

void wf_print_name(FILE *to, const char *name, int width)
{
    bool longer = strlen(name) > (size_t)width;
    if (longer)
        wf_show(to, "  %s\n%*s", name, width, "");
    else
        wf_show(to, "%*s", width, name);
}

static void print_row(FILE *to, const struct wf_beside *x)
{
    wf_print_name(to, x->name ? x->name : "as it stands", 28);
    wf_show(to, "%9.0f %%%s", 100 * x->cut, x->cut > WF_ASSESS_CUT_FLAGGED ? "!" : " ");
    print_cell(to, x->drag / 1e3);
    print_cell(to, x->weight / 1e3);
    print_cell(to, x->base_moment / 1e3);
    print_cell(to, x->safety);
    print_cell(to, x->branches);
    if (isfinite(x->searched))
        wf_show(to, "%7s%-5.4g", "> ", x->searched);
    else
        print_cell(to, x->critical);
    wf_show(to, "\n");
}

void wf_print_beside_holds(FILE *to, size_t n, const struct wf_beside *x)
{
    size_t holds = 0;
    for (size_t k = 0; k < n; k++) holds += x[k].holds;
    if (holds)
        wf_show(to,
                "  static forces of what holds it; how ends, anchors and fittings hold is not assessed\n");
    for (size_t k = 0; k < n; k++)
        for (size_t i = 0; i < x[k].holds; i++) {
            const struct wf_beside_hold *h = &x[k].hold[i];
            if (!i) wf_show(to, "    %s\n", x[k].name ? x[k].name : "as it stands");
            wf_show(to, "      %s %s:%s: ", h->kind, h->from, h->to);
            print_hold(to, h);
        }
}

void wf_print_beside_gusts(FILE *to, size_t n, const struct wf_beside *x)
{
    for (size_t k = 1; k < n; k++)
        if (wf_beside_gustier(&x[k], &x[0]))
            wf_show(
                to,
                "  %s: its branches are less safe because those that stay bear nearly the load they had, and "
                "gusts make it %.2f in place of %.2f times the mean: a smaller crown damps its sway less "
                "(%.3f in place of %.3f of critical)\n",
                x[k].name, x[k].branch_gusts, x[0].branch_gusts, x[k].damping, x[0].damping);
}

void wf_print_beside(FILE *to, const struct wf_analysis *an)
{
    const struct wf_besides *r = an->beside;
    bool flagged = false, listed = false;
    if (!r) return;
    wf_show(to,
            "\n  Side by side, at the peak of the load in %.4g m/s where no other wind is named\n"
            "%28s%12s%12s%12s%12s%12s%12s%12s\n",
            r->item[0].speed, "what is done", "crown gone", "drag kN", "weight kN", "moment kNm", "safety",
            "branches", "lost at m/s");
    for (size_t k = 0; k < r->n; k++) {
        flagged = flagged || r->item[k].cut > WF_ASSESS_CUT_FLAGGED;
        listed = listed || isfinite(r->item[k].branches);
        print_row(to, &r->item[k]);
    }
    if (flagged)
        wf_show(to, "  !: more than %.0f %% of the crown: a loss that harms the tree\n",
                100 * WF_ASSESS_CUT_FLAGGED);
    if (listed)
        wf_show(to, "  'branches': the least safety of those from %.3g cm on\n",
                100 * an->search.branches_from);
    wf_show(
        to,
        "  '-': none found. What is left keeps its shape; the wound, new sprouts and more wind on what was "
        "sheltered are not computed\n");
    wf_print_beside_gusts(to, r->n, r->item);
    wf_print_beside_holds(to, r->n, r->item);
}
