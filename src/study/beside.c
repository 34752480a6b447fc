/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/beside.h"
#include "base/num.h"
#include "fail/anchorage.h"
#include "study/brace.h"
#include "study/directions.h"
#include "study/guy.h"
#include "study/peak.h"
#include "study/verdict.h"
#include <math.h>
#include <string.h>

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

/* Is it larger in the strongest wind from another direction of an assessment? */
static void look_around(const struct wf_analysis *an, size_t tie, size_t link, struct wf_beside_hold *out)
{
    const struct wf_assessment *x = an->assessment;
    const struct wf_directions_request place = { .north = 0 };
    out->wind_from = NAN;
    if (!x || !x->directions) return;
    out->wind_from = wf_direction_from(&place, an->scenario.azimuth);
    for (size_t k = 0; k < x->directions; k++) {
        const struct wf_assess_direction *d = &x->direction[k];
        double force = tie < WF_TIES_MAX ? d->tie[tie] : d->link[link];
        if (!(fabs(force) > fabs(out->force))) continue;
        out->force = force, out->speed = x->speed, out->wind_from = d->from;
    }
    out->safety = out->force > 0 ? out->breaking / out->force : (double)NAN;
}

enum wf_status wf_beside_holds(const struct wf_analysis *an, struct wf_arena *a, size_t *n,
                               const struct wf_beside_hold **out, struct wf_err *e)
{
    size_t guys = an->scenario.guys, braces = an->scenario.braces;
    struct wf_beside_hold *list = WF_TAKE(a, guys + braces + 1, struct wf_beside_hold);
    bool whole = list;
    for (size_t k = 0; whole && k < guys + braces; k++) {
        list[k] = k < guys ? hold_of_guy(an, k, a) : hold_of_brace(an, k - guys, a);
        look_around(an, k < guys ? k : WF_TIES_MAX, k < guys ? 0 : k - guys, &list[k]);
        whole = list[k].from && list[k].to;
    }
    *n = guys + braces, *out = list;
    return whole ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for cables");
}

/* ---- Branches ---- */

/* The least safety of the branches that are listed, of an analysis that keeps the columns of its winds. */
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
    struct wf_peak_parts gusts = { .factor = NAN, .damping = NAN };
    if (wf_peak_branches(an->peak)) wf_peak_parts_at(an->peak, at->speed, WF_PART_BRANCHES, &gusts);
    out->branch_gusts = gusts.factor, out->damping = gusts.damping;
    out->critical = c && c->outcome == WF_CRITICAL_FOUND ? c->speed : (double)NAN;
    out->searched = c && c->outcome == WF_CRITICAL_ABOVE ? c->speed_high : (double)NAN;
    return wf_beside_holds(an, a, &out->holds, &out->hold, e);
}

bool wf_beside_gustier(const struct wf_beside *x, const struct wf_beside *stands)
{
    const double alike = 5e-3;
    return x->branches < stands->branches * (1 - alike) &&
           x->branch_gusts > stands->branch_gusts * (1 + alike) && x->damping < stands->damping;
}

void wf_beside_pass(const struct wf_diag *from, struct wf_diag *to)
{
    for (const struct wf_finding *f = from->first; f; f = f->next)
        if (f->code && (!strcmp(f->code, WF_EVERGREEN) || !strcmp(f->code, WF_ANCHORAGE_SOIL)))
            wf_diag_pass(to, f);
}

enum wf_status wf_beside_check(const struct wf_species *sp, const struct wf_model *m,
                               const struct wf_scenario *sc, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_analysis an = { .species = sp, .model = m, .scenario = *sc };
    enum wf_status s = wf_analysis_draw(&an, &scratch, &unsaid, e);
    if (!s && sc->anchorage && sc->anchorage->lost > 0 && !an.anchorage->method)
        s = wf_fail(e, WF_EINPUT, "root_loss has no effect: what the roots hold is not known: %s",
                    an.anchorage->text ? an.anchorage->text : WF_ANCHORAGE_UNSAID);
    wf_arena_free(&scratch);
    return s;
}
