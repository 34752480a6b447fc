/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_scenarios.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "cmd/scenarios.h"
#include "study/directions.h"
#include <math.h>
#include <string.h>

/* ---- Reading ---- */

static enum wf_status read_case(const struct wf_assess_options *o, const struct wf_scenario_words *x,
                                struct wf_units *units, struct wf_arena *a, struct wf_diag *d,
                                struct wf_assess_case *out, struct wf_err *e)
{
    out->options = *o;
    enum wf_status s = wf_scenario_options(&o->run.args, "assess", x, units, a, d, &out->options.run.args, e);
    out->options.run.samples = 0;
    return s;
}

enum wf_status wf_assess_list_read(const struct wf_assess_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_assess_list *out, struct wf_err *e)
{
    struct wf_units *units = NULL;
    size_t before = d->errors;
    struct wf_scenario_list *words = WF_TAKE(a, 1, struct wf_scenario_list);
    *out = (struct wf_assess_list){ .n = 0 };
    if (!words) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    enum wf_status s = wf_scenarios_split(&o->run, a, d, words, e);
    if (s || !words->n) return !s && d->errors > before ? wf_fail(e, WF_EUSAGE, "a scenario is wrong") : s;
    out->n = words->n;
    out->scenario = WF_TAKE(a, out->n, struct wf_beside);
    out->item = WF_TAKE(a, out->n, struct wf_assess_case);
    if (!out->scenario || !out->item) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    s = wf_units_open(&units, e);
    for (size_t k = 0; k < out->n && !s; k++) {
        out->scenario[k].name = words->item[k].name;
        s = read_case(o, &words->item[k], units, a, d, &out->item[k], e);
    }
    wf_units_close(units);
    return s || d->errors == before ? s : wf_fail(e, WF_EUSAGE, "a scenario is wrong");
}

/* ---- Running ---- */

static enum wf_status take_result(const struct wf_assess_case *c, struct wf_arena *a, struct wf_beside *out,
                                  struct wf_err *e)
{
    const char *name = out->name;
    struct wf_assess_direction *around = WF_TAKE(a, WF_ASSESS_DIRECTIONS, struct wf_assess_direction);
    if (!around) return wf_fail(e, WF_ENOMEM, "not enough memory for a scenario");
    struct wf_analysis an = c->an;
    an.assessment = &c->x;
    enum wf_status s = wf_beside_take(&an, a, out, e);
    memcpy(around, c->around, sizeof c->around);
    out->name = name;
    out->assessed = true;
    out->breakage = c->x.breakage.safety, out->overturning = c->x.overturning.safety;
    if (!c->fit) out->cut = c->cut;
    out->word = c->x.word;
    out->directions = c->x.directions, out->direction = around;
    return s;
}

/* What is wrong with a case that could not be read or run. */
static enum wf_status fail_case(enum wf_status s, const char *name, const struct wf_diag *d,
                                const struct wf_err *why, struct wf_err *e)
{
    const struct wf_finding *f = d->first;
    while (f && f->severity != WF_ERROR) f = f->next;
    return s ? wf_fail(e, s, "scenario '%s': %s", name, f ? f->text : why->text) : WF_OK;
}

static enum wf_status run_case(struct wf_assess_case *c, const struct wf_analysis *whole, struct wf_arena *a,
                               struct wf_beside *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag d = { .arena = &scratch };
    struct wf_err why = { WF_OK, "" };
    c->species = whole->species;
    enum wf_status s = wf_assess_case_read(c, &scratch, &d, &why);
    if (!s) s = wf_assess_case_run(c, &scratch, &d, &why);
    if (!s) s = take_result(c, a, out, &why);
    if (!s) wf_beside_pass(&d, whole->diag);
    s = fail_case(s, out->name, &d, &why, e);
    wf_arena_free(&scratch);
    return s;
}

/* The tree as it stands, onto a case of the list. */
static void of_list(const struct wf_assess_list *list, size_t k)
{
    list->item[k].fit = list->fit, list->item[k].whole = list->whole, list->item[k].grown = list->grown;
}

enum wf_status wf_assess_list_check(const struct wf_assess_list *list, const struct wf_species *sp,
                                    struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < list->n && !s; k++) {
        struct wf_assess_case *c = &list->item[k];
        struct wf_arena scratch = { 0 };
        struct wf_diag d = { .arena = &scratch };
        struct wf_err why = { WF_OK, "" };
        of_list(list, k);
        c->species = sp;
        s = wf_assess_case_read(c, &scratch, &d, &why);
        if (!s) s = wf_beside_check(sp, &c->model, &c->request.scenario, &why);
        s = fail_case(s, list->scenario[k].name, &d, &why, e);
        wf_arena_free(&scratch);
    }
    return s;
}

/* ---- The least reduction ---- */

/* What is searched in. */
struct reducing {
    const struct wf_assess_list *list;
    const struct wf_assess_options *options;
    const struct wf_analysis *whole;
    struct wf_arena *arena;
    struct wf_assess_case *room;
    bool turns;     /* directions differ */
    double towards; /* azimuth of the wind in which the tree is the least safe [rad] */
};

/* Is a reduction by whole percents enough, in the wind in which the tree was the least safe or (all) in any?
 */
static enum wf_status try_share(const struct reducing *r, int percent, bool all, bool *is, double *cut,
                                struct wf_err *e)
{
    struct wf_assess_case *c = r->room;
    struct wf_beside at;
    *c = (struct wf_assess_case){ .options = *r->options,
                                  .fit = r->list->fit,
                                  .whole = r->list->fit ? r->list->whole : NULL,
                                  .grown = r->list->grown,
                                  .alone = r->turns && !all,
                                  .towards = r->towards };
    struct wf_analyze_options *o = &c->options.run;
    o->samples = 0, o->thin = o->cavity_growth = NAN, o->root_loss = o->remove = NULL, o->leaf_off = false;
    if (!(o->reduce = wf_arena_print(r->arena, "%d%%", percent)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    at = (struct wf_beside){ .name = o->reduce };
    enum wf_status s = run_case(c, r->whole, r->arena, &at, e);
    if (s) return s;
    *is = fmin(at.breakage, at.overturning) >= c->options.required, *cut = at.cut;
    return WF_OK;
}

/* Between a share that is not enough and one that is, in whole percents: what is printed is what was tried.
 * Returned: *high and what it takes. */
static enum wf_status halve(const struct reducing *r, int low, bool all, int *high, double *cut,
                            struct wf_err *e)
{
    enum wf_status s = WF_OK;
    while (*high - low > 1 && !s) {
        bool is = false;
        int percent = (low + *high) / 2;
        double gone;
        s = try_share(r, percent, all, &is, &gone, e);
        if (is)
            *high = percent, *cut = gone;
        else
            low = percent;
    }
    return s;
}

/* The largest share of 60 %, 50 % ... that can be drawn: of a tree whose branches are drawn a twentieth of
 * the crown must be left. Returned: *most, 0 where none can be. */
static enum wf_status find_most(const struct reducing *r, int *most, bool *is, double *cut, struct wf_err *e)
{
    for (*most = 60; *most > 0; *most -= 10) {
        struct wf_err why = { WF_OK, "" };
        enum wf_status s = try_share(r, *most, true, is, cut, &why);
        if (!s) return WF_OK;
        if (s != WF_EINPUT || !r->list->fit) return wf_fail(e, s, "%s", why.text);
    }
    return WF_OK;
}

/* By halves in the wind in which the tree is the least safe, then looked at in all; where another wind wants
 * more, by halves in all from there. */
static enum wf_status find_reduction(const struct reducing *r, struct wf_assessment *x, struct wf_err *e)
{
    bool is = false;
    int most;
    double cut;
    enum wf_status s = find_most(r, &most, &is, &cut, e);
    if (s) return s;
    x->reduction_most = 0.01 * most;
    if (!most) return x->reduction_unknown = "no branches are drawn that could be cut back", WF_OK;
    if (!is) return x->reduction = INFINITY, WF_OK;
    int high = most, first;
    x->reduction_cut = cut;
    if ((s = halve(r, 0, false, &high, &x->reduction_cut, e))) return s;
    if (r->turns && high < most && (s = try_share(r, high, true, &is, &x->reduction_cut, e))) return s;
    if (!is) {
        first = high, high = most, x->reduction_cut = cut;
        s = halve(r, first, true, &high, &x->reduction_cut, e);
    }
    x->reduction = 0.01 * high;
    return s;
}

static enum wf_status search_reduction(const struct wf_assess_list *list, const struct wf_assess_options *o,
                                       struct wf_arena *a, const struct wf_analysis *an,
                                       struct wf_assessment *x, struct wf_err *e)
{
    const struct wf_assess_part *worst =
        x->overturning.safety < x->breakage.safety ? &x->overturning : &x->breakage;
    struct wf_directions_request place = { .north = o->run.north };
    const struct reducing r = { .list = list,
                                .options = o,
                                .whole = an,
                                .arena = a,
                                .room = WF_TAKE(a, 1, struct wf_assess_case),
                                .turns = x->directions > 0 && !x->one,
                                .towards = x->directions ? wf_direction_azimuth(&place, worst->from) : 0 };
    if (!r.room) return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    return find_reduction(&r, x, e);
}

/* The tree as it stands, and its scenarios, side by side. */
static enum wf_status put_beside(const struct wf_assessment *x, struct wf_arena *a, struct wf_analysis *an,
                                 struct wf_err *e)
{
    struct wf_besides *all = WF_TAKE(a, 1, struct wf_besides);
    struct wf_beside *list = WF_TAKE(a, x->scenarios + 1, struct wf_beside);
    if (!x->scenarios) return WF_OK;
    if (!all || !list) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    enum wf_status s = wf_beside_take(an, a, &list[0], e);
    list[0].assessed = true, list[0].word = x->word;
    list[0].breakage = x->breakage.safety, list[0].overturning = x->overturning.safety;
    list[0].directions = x->directions, list[0].direction = x->direction;
    for (size_t k = 0; k < x->scenarios; k++) list[k + 1] = x->scenario[k];
    *all = (struct wf_besides){ x->scenarios + 1, list };
    an->beside = all;
    return s;
}

enum wf_status wf_assess_list_run(const struct wf_assess_list *list, const struct wf_assess_options *o,
                                  struct wf_arena *a, struct wf_analysis *an, struct wf_assessment *x,
                                  struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < list->n && !s; k++) {
        of_list(list, k);
        s = run_case(&list->item[k], an, a, &list->scenario[k], e);
    }
    x->scenarios = list->n, x->scenario = list->scenario;
    if (!s) s = put_beside(x, a, an, e);
    bool low = fmin(x->breakage.safety, x->overturning.safety) < x->required;
    return !s && low && !wf_interrupted() ? search_reduction(list, o, a, an, x, e) : s;
}
