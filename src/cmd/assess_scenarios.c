/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_scenarios.h"
#include "base/num.h"
#include "cmd/scenarios.h"
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

static bool enough(const struct wf_beside *x, double required)
{
    return fmin(x->breakage, x->overturning) >= required;
}

/* By halves: from 0 to 60 % of the crown's height and width, to 1 %. */
static enum wf_status find_reduction(const struct wf_assess_options *o, const struct wf_analysis *whole,
                                     struct wf_arena *a, struct wf_assessment *x, struct wf_err *e)
{
    const double most = 0.6;
    struct wf_assess_case *c = WF_TAKE(a, 1, struct wf_assess_case);
    struct wf_beside at;
    double low = 0, high = most;
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    for (double share = most; share == most || high - low > 0.01; share = 0.5 * (low + high)) {
        *c = (struct wf_assess_case){ .options = *o };
        c->options.run.samples = 0;
        c->options.run.thin = c->options.run.cavity_growth = NAN, c->options.run.root_loss = NULL;
        c->options.run.leaf_off = false;
        if (!(c->options.run.reduce = wf_arena_print(a, "%.4g%%", 100 * share)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
        at = (struct wf_beside){ .name = c->options.run.reduce };
        enum wf_status s = run_case(c, whole, a, &at, e);
        if (s) return s;
        bool is = enough(&at, o->required);
        if (share == most && !is) return x->reduction = INFINITY, WF_OK;
        if (is)
            high = share, x->reduction_cut = at.cut;
        else
            low = share;
    }
    x->reduction = high;
    return WF_OK;
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
    bool width = !list->fit && (o->run.tree.crown.width > 0 || o->run.tree.outline);
    bool low = fmin(x->breakage.safety, x->overturning.safety) < x->required;
    return !s && low && width ? find_reduction(o, an, a, x, e) : s;
}
