/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/verdict.h"
#include "data/section.h"
#include "fail/anchorage.h"
#include <math.h>

double wf_verdict_bound(const struct wf_critical *c)
{
    switch (c->outcome) {
    case WF_CRITICAL_FOUND:
        return c->speed;
    case WF_CRITICAL_SELF_WEIGHT:
        return 0;
    case WF_CRITICAL_ABOVE:
        return c->speed_high;
    case WF_CRITICAL_UNSOLVED:
    case WF_CRITICAL_UNSEARCHED:
    case WF_CRITICAL_INTERRUPTED:
        return c->speed_low;
    case WF_CRITICAL_NO_STRENGTH:
        break;
    }
    return INFINITY;
}

bool wf_verdict_reached(const struct wf_critical *c)
{
    return c->outcome == WF_CRITICAL_FOUND || c->outcome == WF_CRITICAL_SELF_WEIGHT;
}

/* Does a result govern in place of one found before? A speed that was found, or none because the tree fails
 * at rest, goes before the end of another's search, which may be that very speed: no criterion is searched
 * above one that was found. */
static bool governs(const struct wf_critical *c, const struct wf_critical *before)
{
    double bound = wf_verdict_bound(c), lowest = wf_verdict_bound(before);
    return wf_verdict_reached(c) && !wf_verdict_reached(before) ? bound <= lowest * (1 + WF_VERDICT_SAME)
                                                                : bound < lowest * (1 - WF_VERDICT_SAME);
}

struct wf_verdict wf_verdict_of(const struct wf_break (*breaks)[WF_SCOPES])
{
    struct wf_verdict v = { .loss = NULL };
    for (int c = 0; c < WF_CRITERIA; c++) {
        if (!wf_criteria[c].loses_tree) continue;
        const struct wf_break *b = &breaks[c][WF_SCOPE_STEM];
        v.assessed[c] = b->critical.outcome != WF_CRITICAL_NO_STRENGTH;
        if (v.loss && !governs(&b->critical, &v.loss->critical)) continue;
        v.loss = b, v.criterion = (enum wf_criterion_id)c;
    }
    return v;
}

const struct wf_break *wf_verdict_first(const struct wf_break (*breaks)[WF_SCOPES],
                                        enum wf_criterion_id *criterion)
{
    const struct wf_break *first = &breaks[WF_BREAKAGE][WF_SCOPE_TREE];
    *criterion = WF_BREAKAGE;
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_break *b = &breaks[c][WF_SCOPE_TREE];
        if (!wf_criteria[c].loses_tree || wf_criteria[c].whole || !governs(&b->critical, &first->critical))
            continue;
        first = b, *criterion = (enum wf_criterion_id)c;
    }
    return first;
}

size_t wf_verdict_nearest(const struct wf_analysis *an, enum wf_criterion_id order[WF_CRITERIA])
{
    const struct wf_at_speed *at = an->at && an->n ? &an->at[an->n - 1] : NULL;
    size_t n = 0;
    for (int c = 0; c < WF_CRITERIA; c++) {
        if (!wf_criteria[c].loses_tree) continue;
        size_t k = n++;
        for (; k && at &&
               at->worst[c][WF_SCOPE_STEM].safety <
                   (1 - WF_VERDICT_SAME) * at->worst[order[k - 1]][WF_SCOPE_STEM].safety;
             k--)
            order[k] = order[k - 1];
        order[k] = (enum wf_criterion_id)c;
    }
    return n;
}

bool wf_verdict_twig(const struct wf_analysis *an, int32_t row)
{
    return row >= 0 && wf_scope_holds(WF_SCOPE_BRANCHES, &an->tree, (size_t)row) &&
           wf_tree_thickness(&an->tree, (size_t)row, NAN) < an->search.branches_from;
}

double wf_verdict_safety(const struct wf_at_speed *at, enum wf_criterion_id *criterion)
{
    double least = NAN;
    for (int c = 0; c < WF_CRITERIA && !at->status; c++) {
        double safety = at->worst[c][WF_SCOPE_STEM].safety;
        if (!wf_criteria[c].loses_tree || isnan(safety) || least <= safety) continue;
        if (criterion && !(safety >= least * (1 - WF_VERDICT_SAME))) *criterion = (enum wf_criterion_id)c;
        least = safety;
    }
    return least;
}

const struct wf_at_speed *wf_verdict_wind(const struct wf_analysis *an)
{
    for (size_t k = an->n; k-- > 0;)
        if (!an->at[k].status) return &an->at[k];
    return NULL;
}

bool wf_verdict_lost(const struct wf_verdict *v, const struct wf_at_speed *at)
{
    const bool reached = v->loss && wf_verdict_reached(&v->loss->critical);
    return (reached && at->speed > wf_verdict_bound(&v->loss->critical)) || wf_verdict_safety(at, NULL) <= 1;
}

const char *wf_verdict_unassessed(const struct wf_analysis *an, const struct wf_verdict *v,
                                  enum wf_criterion_id c)
{
    const struct wf_criterion *x = &wf_criteria[c];
    if (!x->loses_tree || v->assessed[c]) return NULL;
    if (c != WF_BREAKAGE && x->section)
        return c != WF_TORSION && wf_criterion_applies(x, &an->tree, WF_SCOPE_STEM) ? x->wants : NULL;
    if (c == WF_OVERTURNING && !an->anchorage) return WF_ANCHORAGE_UNSAID;
    if (c == WF_OVERTURNING && !an->anchorage->method) return an->anchorage->text;
    return wf_criteria[c].whole ? "the root's row is not credible as drawn" : "strength unknown";
}

double wf_verdict_size(const struct wf_analysis *an)
{
    static const enum wf_criterion_id bent[] = { WF_BREAKAGE, WF_TORSION };
    const struct wf_at_speed *given = wf_verdict_wind(an);
    double largest = 0;
    for (size_t k = 0; k < WF_COUNT(bent); k++) {
        const struct wf_at_speed *at[] = { &an->breaks[bent[k]][WF_SCOPE_STEM].at, given };
        for (size_t i = 0; i < WF_COUNT(at); i++) {
            if (!at[i] || at[i]->status || isnan(at[i]->speed)) continue;
            const struct wf_worst *w = &at[i]->worst[bent[k]][WF_SCOPE_STEM];
            if (w->row >= 0) largest = fmax(largest, 2 * wf_wood_radius(&an->tree, (size_t)w->row, w->place));
        }
    }
    return largest > WF_SIZE_FROM ? largest : 0;
}

bool wf_verdict_any_soil(const struct wf_analysis *an)
{
    return an->anchorage && an->anchorage->method && an->anchorage->soil;
}

/* ---- Branches ---- */

static double thickness(const struct wf_tree *t, size_t i) { return wf_tree_thickness(t, i, NAN); }

static size_t class_of(double from, double diameter)
{
    size_t k = 0;
    for (double to = 2 * from; k + 1 < WF_BRANCH_CLASSES && diameter >= to; to *= 2) k++;
    return k;
}

/* The criterion nearest to its limit in a row at a wind. */
static struct wf_worst worst_of_row(const struct wf_tree *t, const struct wf_at_speed *at, size_t i,
                                    enum wf_criterion_id *criterion)
{
    struct wf_worst worst = { .safety = NAN, .row = -1 };
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_criterion *x = &wf_criteria[c];
        if (!x->loses_tree) continue;
        double place = 0, safety = wf_criterion_safety(x, t, &at->response, &at->breakage, i, &place);
        if (isnan(safety) || worst.safety <= safety) continue;
        worst = (struct wf_worst){ .safety = safety, .row = (int32_t)i, .place = place };
        *criterion = (enum wf_criterion_id)c;
    }
    return worst;
}

static void add_row(const struct wf_analysis *an, size_t i, struct wf_branch_class *k)
{
    const struct wf_at_speed *last = wf_verdict_wind(an);
    k->segments++;
    for (size_t w = 0; w < an->n; w++) {
        const struct wf_at_speed *at = &an->at[w];
        enum wf_criterion_id c = WF_BREAKAGE;
        if (at->status || at->breakage.n != an->tree.n) continue;
        struct wf_worst worst = worst_of_row(&an->tree, at, i, &c);
        if (worst.safety <= 1 && !(k->fails <= at->speed)) k->fails = at->speed;
        if (at == last && worst.row >= 0 && !(k->worst.safety <= worst.safety))
            k->worst = worst, k->criterion = c;
    }
}

size_t wf_branch_classes(const struct wf_analysis *an, struct wf_branch_class out[WF_BRANCH_CLASSES])
{
    const double thinnest = 1e-3;
    const struct wf_tree *t = &an->tree;
    double from = fmax(an->search.branches_from, thinnest);
    size_t n = 0;
    for (size_t k = 0; k < WF_BRANCH_CLASSES; k++)
        out[k] =
            (struct wf_branch_class){ .from = ldexp(from, (int)k),
                                      .to = k + 1 < WF_BRANCH_CLASSES ? ldexp(from, (int)k + 1) : INFINITY,
                                      .worst = { .safety = NAN, .row = -1 },
                                      .fails = NAN };
    for (size_t i = 0; i < t->n; i++) {
        if (thickness(t, i) < from || !wf_scope_holds(WF_SCOPE_BRANCHES, t, i)) continue;
        size_t k = class_of(from, thickness(t, i));
        add_row(an, i, &out[k]);
        if (k >= n) n = k + 1;
    }
    return n;
}
