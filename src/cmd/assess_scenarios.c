/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_scenarios.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "study/verdict.h"
#include <math.h>
#include <string.h>

enum { SCENARIOS_MAX = 50, CHANGES_MAX = 12 };

/* ---- Reading ---- */

/* Options beside those of the tree as it stands. */
struct beside {
    size_t n, option[CHANGES_MAX];
    const char *cell[CHANGES_MAX];
};

/* The row that a key names: "lean_towards" is --lean-towards. */
static size_t row_named(const struct wf_option *rows, const char *key)
{
    for (size_t k = 0; rows[k].name; k++) {
        const char *name = rows[k].name + 2;
        size_t i = 0;
        while (name[i] && (name[i] == key[i] || (name[i] == '-' && key[i] == '_'))) i++;
        if (!name[i] && !key[i]) return k;
    }
    return (size_t)-1;
}

/* One "key=value", or a key alone, which is a flag. Returned: NULL, or what is wrong. */
static const char *add_change(const struct wf_option *rows, char *text, struct beside *out,
                              struct wf_arena *a)
{
    char *value = strchr(text, '=');
    if (value) *value++ = '\0';
    for (char *end = text + strlen(text); end > text && end[-1] == ' ';) *--end = '\0';
    while (*text == ' ') text++;
    size_t row = row_named(rows, text);
    if (row == (size_t)-1) return wf_arena_print(a, "'%.40s' is no key of a card", text);
    const struct wf_option *o = &rows[row];
    bool barred = o->kind == WF_OPTION_STUDY || o->kind == WF_OPTION_TEXTS || !strcmp(o->name, "--output") ||
                  !strcmp(o->name, "--species");
    bool list = !strcmp(o->name, "--cavity") || !strcmp(o->name, "--guy") || !strcmp(o->name, "--cable") ||
                !strcmp(o->name, "--rod");
    if (barred && !list) return wf_arena_print(a, "'%.40s' is the same in all scenarios", text);
    if (out->n == CHANGES_MAX) return "more than 12 changes";
    out->option[out->n] = row;
    out->cell[out->n++] = value ? value + strspn(value, " ") : "yes";
    return NULL;
}

/* A case of the options beside those of the line, of which changes are taken alone where `with`. */
static enum wf_status read_case(const struct wf_assess_options *o, bool with, const struct beside *beside,
                                const char *name, struct wf_units *units, struct wf_arena *a,
                                struct wf_diag *d, struct wf_assess_case *out, struct wf_err *e)
{
    struct wf_args *line = WF_TAKE(a, 1, struct wf_args);
    struct wf_sink sink;
    if (!line) return wf_fail(e, WF_ENOMEM, "not enough memory for a scenario");
    *line = o->run.args;
    for (size_t k = 0; line->option[k].name; k++) {
        bool list = !strcmp(line->option[k].name, "--scenarios");
        if (list || (!with && wf_assess_changes(&line->option[k]))) line->given[k] = false;
    }
    out->options = *o;
    if (!wf_args_read_cells(line, "assess", beside->option, beside->cell, beside->n, units, a,
                            &out->options.run.args, &sink))
        wf_diag_error(d, NULL, 0, 0, "scenario '%s': %s", name, sink.text);
    out->options.run.samples = 0;
    return WF_OK;
}

static enum wf_status add_case(const struct wf_assess_options *o, bool with, char *text,
                               struct wf_units *units, struct wf_arena *a, struct wf_diag *d,
                               struct wf_assess_list *out, struct wf_err *e)
{
    struct beside beside = { 0 };
    const char *name = wf_arena_text(a, text), *wrong = NULL;
    for (char *rest = with ? NULL : text, *next; rest && !wrong; rest = next) {
        if ((next = strchr(rest, '+'))) *next++ = '\0';
        wrong = add_change(o->run.args.option, rest, &beside, a);
    }
    if (wrong) {
        wf_diag_error(d, NULL, 0, 0, "scenario '%s': %s", name, wrong);
        return WF_OK;
    }
    if (out->n == SCENARIOS_MAX) return wf_fail(e, WF_EUSAGE, "more than %d scenarios", SCENARIOS_MAX);
    out->scenario[out->n].name = name;
    return read_case(o, with, &beside, name, units, a, d, &out->item[out->n++], e);
}

/* The changes given as options, in words; NULL: none. */
static char *changes_given(const struct wf_assess_options *o, struct wf_arena *a)
{
    const struct wf_args *line = &o->run.args;
    char *text = NULL;
    for (size_t k = 0; line->option[k].name; k++) {
        const struct wf_option *row = &line->option[k];
        if (!line->given[k] || !wf_assess_changes(row)) continue;
        bool flag = row->kind == WF_OPTION_FLAG;
        text = wf_arena_print(a, "%s%s%s%s%s", text ? text : "", text ? " + " : "", row->name + 2,
                              flag ? "" : " ", flag ? "" : line->text[k]);
    }
    return text;
}

enum wf_status wf_assess_list_read(const struct wf_assess_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_assess_list *out, struct wf_err *e)
{
    struct wf_units *units = NULL;
    char *given = changes_given(o, a), *rest = o->scenarios ? wf_arena_text(a, o->scenarios) : NULL;
    *out = (struct wf_assess_list){ 0, WF_TAKE(a, SCENARIOS_MAX, struct wf_assess_scenario),
                                    WF_TAKE(a, SCENARIOS_MAX, struct wf_assess_case) };
    if (!given && !rest) return WF_OK;
    if (!out->scenario || !out->item) return wf_fail(e, WF_ENOMEM, "not enough memory for scenarios");
    enum wf_status s = wf_units_open(&units, e);
    if (!s && given) s = add_case(o, true, given, units, a, d, out, e);
    for (char *item; rest && !s && (item = wf_list_item(&rest));)
        s = add_case(o, false, item, units, a, d, out, e);
    wf_units_close(units);
    return s;
}

/* ---- Running ---- */

static void take_result(const struct wf_assess_case *c, struct wf_assess_scenario *out)
{
    struct wf_verdict v = wf_verdict_of(c->an.breaks);
    const struct wf_critical *k = v.loss ? &v.loss->critical : NULL;
    out->breakage = c->x.breakage.safety, out->overturning = c->x.overturning.safety;
    out->critical = k && k->outcome == WF_CRITICAL_FOUND ? k->speed : (double)NAN;
    out->cut = c->cut;
    out->word = c->x.word;
    out->directions = c->x.directions, out->direction = c->around;
}

static enum wf_status run_case(struct wf_assess_case *c, const struct wf_species *sp, const char *name,
                               struct wf_assess_scenario *out, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag d = { .arena = &scratch };
    struct wf_err why = { WF_OK, "" };
    c->species = sp;
    enum wf_status s = wf_assess_case_read(c, &scratch, &d, &why);
    if (!s) s = wf_assess_case_run(c, &scratch, &d, &why);
    if (!s) take_result(c, out);
    const struct wf_finding *f = d.first;
    while (f && f->severity != WF_ERROR) f = f->next;
    if (s) (void)wf_fail(e, s, "scenario '%s': %s", name, s && f ? f->text : why.text);
    wf_arena_free(&scratch);
    return s;
}

static bool enough(const struct wf_assess_scenario *x, double required)
{
    return fmin(x->breakage, x->overturning) >= required;
}

/* By halves: from 0 to 60 % of the crown's height and width, to 1 %. */
static enum wf_status find_reduction(const struct wf_assess_options *o, const struct wf_species *sp,
                                     struct wf_arena *a, struct wf_assessment *x, struct wf_err *e)
{
    const double most = 0.6;
    struct wf_assess_case *c = WF_TAKE(a, 1, struct wf_assess_case);
    struct wf_assess_scenario at = { 0 };
    double low = 0, high = most;
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
    for (double share = most; share == most || high - low > 0.01; share = 0.5 * (low + high)) {
        *c = (struct wf_assess_case){ .options = *o };
        c->options.run.samples = 0;
        c->options.thin = c->options.cavity_growth = NAN, c->options.root_loss = NULL;
        c->options.leaf_off = false;
        if (!(c->options.reduce = wf_arena_print(a, "%.4g%%", 100 * share)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for a reduction");
        enum wf_status s = run_case(c, sp, c->options.reduce, &at, e);
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

enum wf_status wf_assess_list_run(const struct wf_assess_list *list, const struct wf_assess_options *o,
                                  const struct wf_species *sp, struct wf_arena *a, struct wf_assessment *x,
                                  struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < list->n && !s; k++)
        s = run_case(&list->item[k], sp, list->scenario[k].name, &list->scenario[k], e);
    x->scenarios = list->n, x->scenario = list->scenario;
    bool width = o->run.tree.crown.width > 0 || o->run.tree.outline;
    bool low = fmin(x->breakage.safety, x->overturning.safety) < x->required;
    return !s && low && width ? find_reduction(o, sp, a, x, e) : s;
}
