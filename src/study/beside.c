/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/beside.h"
#include "base/num.h"
#include "study/brace.h"
#include "study/guy.h"
#include "study/node.h"
#include "study/verdict.h"
#include <math.h>

/* ---- What holds it ---- */

/* Was a wind found in which the tree is lost? */
static bool is_lost(const struct wf_analysis *an)
{
    const struct wf_break *loss = wf_verdict_of(an->breaks).loss;
    return loss && loss->critical.outcome == WF_CRITICAL_FOUND;
}

static struct wf_beside_hold hold_of_guy(const struct wf_analysis *an, size_t k, struct wf_arena *a)
{
    const struct wf_guy *g = &an->scenario.guy[k];
    const struct wf_at_speed *at = &an->at[an->n - 1];
    const double degrees = 180 / WF_PI;
    struct wf_beside_hold out = { .kind = "guy", .breaking = NAN, .safety = NAN };
    out.from = wf_arena_print(a, "%.4gm", g->height);
    out.to = wf_arena_print(a, "%.4gm:%.4gdeg", g->distance, degrees * g->towards);
    out.force = at->status ? (double)NAN : at->tie[k];
    out.speed = at->status ? (double)NAN : at->speed;
    out.critical = is_lost(an) ? an->held.tie[k] : (double)NAN;
    return out;
}

static struct wf_beside_hold hold_of_brace(const struct wf_analysis *an, size_t k, struct wf_arena *a)
{
    const struct wf_brace *b = &an->scenario.brace[k];
    const struct wf_at_speed *at = wf_brace_worst(an, k);
    struct wf_beside_hold out = { .kind = b->rod ? "rod" : "cable", .breaking = b->breaking };
    out.from = wf_arena_text(a, b->end[0].name), out.to = wf_arena_text(a, b->end[1].name);
    out.force = at ? at->link[k] : (double)NAN;
    out.speed = at ? at->speed : (double)NAN;
    out.critical = is_lost(an) ? an->held.link[k] : (double)NAN;
    out.safety = out.force > 0 ? b->breaking / out.force : (double)NAN;
    return out;
}

enum wf_status wf_beside_holds(const struct wf_analysis *an, struct wf_arena *a, size_t *n,
                               const struct wf_beside_hold **out, struct wf_err *e)
{
    size_t guys = an->scenario.guys, braces = an->scenario.braces;
    struct wf_beside_hold *list = WF_TAKE(a, guys + braces + 1, struct wf_beside_hold);
    bool whole = list;
    for (size_t k = 0; whole && k < guys + braces; k++) {
        list[k] = k < guys ? hold_of_guy(an, k, a) : hold_of_brace(an, k - guys, a);
        whole = list[k].from && list[k].to;
    }
    *n = guys + braces, *out = list;
    return whole ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for cables");
}

enum wf_status wf_beside_held(struct wf_analysis *an, const struct wf_solve_options *o, struct wf_nodes *nodes,
                              struct wf_err *e)
{
    const struct wf_solve_options quick = wf_nodes_quick(o);
    const struct wf_node *node;
    struct wf_at_speed at;
    struct wf_err why = { WF_OK, "" };
    for (size_t k = 0; k < WF_TIES_MAX; k++) an->held.tie[k] = NAN;
    for (size_t k = 0; k < WF_LINKS_MAX; k++) an->held.link[k] = NAN;
    if (!an->loads.ties && !an->loads.links) return WF_OK;
    if (!is_lost(an)) return WF_OK;
    const double speed = wf_verdict_of((const struct wf_break(*)[WF_SCOPES])an->breaks).loss->critical.speed;
    enum wf_status s;
    if (!wf_nodes_tracked(an))
        s = wf_speed_totals(an, o, speed, &at, &why);
    else if (!(s = wf_nodes_solve(nodes, &quick, speed, &node, &why)))
        at = node->at;
    if (s && wf_nodes_late(nodes)) return WF_OK;
    if (s) return wf_fail(e, s, "%s", why.text);
    for (size_t k = 0; k < an->loads.ties && !at.status; k++) an->held.tie[k] = at.tie[k];
    for (size_t k = 0; k < an->loads.links && !at.status; k++) an->held.link[k] = at.link[k];
    return WF_OK;
}

/* ---- Branches ---- */

double wf_beside_branches(const struct wf_analysis *an, const struct wf_node *node)
{
    const struct wf_tree *t = &an->tree;
    double most = 0;
    for (int c = 0; c < WF_CRITERIA && !node->at.status; c++) {
        const float *utilisation = node->column[c].value;
        if (!wf_criteria[c].loses_tree || !utilisation) continue;
        for (size_t i = 0; i < t->n; i++)
            if (2 * fmax(t->r0[i], t->r1[i]) >= an->search.branches_from &&
                wf_scope_holds(WF_SCOPE_BRANCHES, t, i))
                most = fmax(most, (double)utilisation[i]);
    }
    return most > 0 ? 1 / most : (double)NAN;
}

/* The same of an analysis that keeps the columns of its winds. */
static double listed_branches(const struct wf_analysis *an)
{
    struct wf_branch_class list[WF_BRANCH_CLASSES];
    double least = NAN;
    for (size_t k = 0, n = wf_branch_classes(an, list); k < n; k++) least = fmin(least, list[k].worst.safety);
    return least;
}

/* ---- All ---- */

enum wf_status wf_beside_take(const struct wf_analysis *an, struct wf_arena *a, struct wf_beside *out,
                              struct wf_err *e)
{
    const struct wf_at_speed *at = &an->at[an->n - 1];
    const struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_critical *c = v.loss ? &v.loss->critical : NULL;
    *out = (struct wf_beside){ .cut = an->cut,
                               .speed = at->speed,
                               .drag = at->drag,
                               .weight = at->weight,
                               .base_moment = at->base_moment,
                               .safety = wf_verdict_safety(at, NULL),
                               .breakage = NAN,
                               .overturning = NAN };
    out->branches = at->status ? (double)NAN : an->search.bare ? an->branch_safety : listed_branches(an);
    out->critical = c && c->outcome == WF_CRITICAL_FOUND ? c->speed : (double)NAN;
    out->searched = c && c->outcome == WF_CRITICAL_ABOVE ? c->speed_high : (double)NAN;
    return wf_beside_holds(an, a, &out->holds, &out->hold, e);
}

enum wf_status wf_beside_check(const struct wf_species *sp, const struct wf_model *m,
                               const struct wf_scenario *sc, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_analysis an = { .species = sp, .model = m, .scenario = *sc };
    enum wf_status s = wf_analysis_draw(&an, &scratch, &unsaid, e);
    wf_arena_free(&scratch);
    return s;
}
