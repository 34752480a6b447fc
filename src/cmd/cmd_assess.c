/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm assess: from what a person measures on a tree to whether it is safe enough. */
#include "base/num.h"
#include "cmd/analyze_run.h"
#include "cmd/args.h"
#include "cmd/assess_card.h"
#include "cmd/assess_fit.h"
#include "cmd/assess_often.h"
#include "cmd/assess_print.h"
#include "cmd/assess_scenarios.h"
#include "cmd/assess_table.h"
#include "data/species.h"
#include "out/folder.h"
#include "study/assessment.h"
#include "study/directions.h"
#include <math.h>

struct work {
    struct wf_analyze_work run; /* comes first: the hooks are called with it */
    struct wf_assess_options options;
    struct wf_assess_list list;
    struct wf_assess_fit fit; /* of --from */
    size_t directions;        /* 0: all alike */
    struct wf_assess_direction direction[WF_ASSESS_DIRECTIONS];
};

/* Results of the fit, its study and its model. */
static enum wf_status note_fit(struct work *w, struct wf_err *e)
{
    struct wf_inputs *in = &w->run.inputs;
    const char *results = wf_arena_print(in->arena, "%s/%s", w->options.from, WF_DOCUMENT);
    if (!results) return wf_fail(e, WF_ENOMEM, "not enough memory for a fit");
    enum wf_status s = wf_input_file_note("model", w->fit.model, in->arena, &in->item[0], e);
    if (!s) s = wf_inputs_note(in, "fit", results, e);
    return s ? s : wf_inputs_note(in, "study", w->fit.study, e);
}

/* The tree of a fit, with its fitted values. */
static enum wf_status take_fit(struct work *w, struct wf_diag *d, struct wf_err *e)
{
    struct wf_analyze_work *run = &w->run;
    enum wf_status s = wf_assess_fit_read(w->options.from, &run->arena, d, &w->fit, e);
    run->options.args.n = s ? 0 : 1; /* without a fit there is no species */
    run->options.args.operand[0] = w->fit.species;
    if (!s) s = wf_assess_fit_model(&w->fit, &run->options, &run->arena, &run->model, d, e);
    if (!s) s = note_fit(w, e);
    if (!s && w->options.name) run->model.name = w->options.name;
    return s ? s : wf_assess_list_read(&w->options, &run->arena, d, &w->list, e);
}

/* The card's model. A species that cannot be read is reported by the run. */
static enum wf_status take_tree(struct wf_analyze_work *run, struct wf_diag *d, struct wf_err *e)
{
    struct work *w = (struct work *)run;
    struct wf_species *sp = WF_TAKE(&run->arena, 1, struct wf_species);
    struct wf_diag unsaid = { .arena = &run->arena };
    struct wf_err why = { WF_OK, "" };
    if (!sp) return wf_fail(e, WF_ENOMEM, "not enough memory for a species");
    const char *extremes = w->options.extremes;
    if (extremes && (wf_assess_often_read(extremes, &run->arena, d, &w->options.often, e) ||
                     wf_assess_often_note(extremes, &run->inputs, e)))
        return e->code;
    if (w->options.from) return take_fit(w, d, e);
    if (wf_assess_list_read(&w->options, &run->arena, d, &w->list, e)) return e->code;
    bool known = !wf_species_named(w->options.species, &run->arena, sp, &unsaid, &why);
    return wf_assess_model(&w->options, known ? sp : NULL, &run->arena, &run->model, d, e);
}

/* Where directions differ, the weakest is taken, unless one is specified. */
static enum wf_status take_direction(struct wf_analyze_work *run, struct wf_err *e)
{
    struct work *w = (struct work *)run;
    struct wf_analyze_request *q = &run->request;
    double worst = q->scenario.azimuth;
    q->search.bare = !run->folder && !w->options.from;
    if (w->options.from) {
        if (w->fit.youngs.given) run->species->level[0].youngs_modulus = w->fit.youngs;
        if (wf_assess_fit_onto(&w->fit, &run->options, &run->arena, q, e)) return e->code;
    }
    w->list.fit = w->options.from ? &w->fit : NULL, w->list.whole = &run->model;
    if (wf_assess_list_check(&w->list, run->species, e)) return e->code;
    if (wf_assess_is_round(&run->model, &q->scenario)) return WF_OK;
    w->directions = WF_ASSESS_DIRECTIONS;
    enum wf_status s = wf_assess_around(run->species, &run->model, &q->scenario, q->solver, &q->solve,
                                        run->options.wind.speed[run->options.wind.n - 1], q->directions.north,
                                        w->direction, &worst, e);
    if (s || WF_GIVEN(&run->options, azimuth)) return s;
    return wf_scenario_turn(&q->scenario, worst, q->directions.north, e);
}

static enum wf_status take_assessment(struct wf_analyze_work *run, struct wf_analysis *an, struct wf_err *e)
{
    struct work *w = (struct work *)run;
    struct wf_assessment *out = WF_TAKE(&run->arena, 1, struct wf_assessment);
    const struct wf_assess_often often = wf_assess_often_of(&w->options);
    if (!out) return wf_fail(e, WF_ENOMEM, "not enough memory for an assessment");
    if (wf_assess(an, &run->request.solve, w->options.required, &often, out, e)) return e->code;
    if (w->directions)
        wf_assess_all_around(out, w->direction,
                             wf_direction_from(&run->request.directions, an->scenario.azimuth),
                             WF_GIVEN(&run->options, azimuth));
    an->assessment = out;
    w->list.grown = an->tallness;
    if (wf_assess_list_run(&w->list, &w->options, &run->arena, an, out, e)) return e->code;
    if (w->options.from && wf_assess_fit_say(&w->fit, an, &run->arena, out, e)) return e->code;
    if (run->options.args.quiet) return WF_OK;
    wf_print_assessment(stdout, an);
    if (w->options.from) wf_assess_fit_print(stdout, &w->fit, out);
    return WF_OK;
}

static const struct wf_analyze_hooks hooks = { take_tree, take_direction, take_assessment };

static const char about[] =
    "A tree is described by what is measured on it with a tape and a height meter, as options or in a card, "
    "a "
    "YAML file with the same keys that begins with 'card:'. The verdict is a word: sufficient, incomplete, "
    "uncertain, insufficient, lost or unknown; docs/assess.md says when each is given.\n"
    "\n"
    "  windfirm assess --species oak --height 20m --girth 2.5m --crown-width 14m \\\n"
    "      --crown-base 4m --soil mineral --design en1991 --basic-wind 25 --terrain III\n"
    "  windfirm assess models/cards/oak.yaml -o out/oak\n"
    "\n"
    "Or by a table, a tree a row: its columns are recognised by their names, and the same table is written "
    "with the assessments behind. Options then hold for all rows.\n"
    "\n"
    "  windfirm assess trees.csv -o assessed.csv --design en1991 --basic-wind 25";

int wf_cmd_assess(int argc, char **argv)
{
    static struct work w;
    struct wf_err e = { 0 };
    struct wf_analyze_work *run = &w.run;
    (void)clock_gettime(CLOCK_REALTIME, &run->started);
    int code = wf_args_read(argc, argv, wf_assess_options_of(&w.options), about, 0, 1, &run->arena,
                            &w.options.run.args);
    if (code < 0 && w.options.run.args.n) {
        const char *table = w.options.run.args.operand[0];
        if (wf_assess_is_yaml(table)) {
            wf_show(stderr, "windfirm assess: %s: a card begins with 'card:' and the name of the tree\n",
                    table);
            code = 2;
        }
    }
    if (code < 0 && w.options.run.args.n) {
        const char *command = wf_command_line(argc, argv, &run->arena);
        code = command ? wf_assess_table(w.options.run.args.operand[0], &w.options, command) : 1;
    }
    if (code < 0) {
        const char **species = WF_TAKE(&run->arena, 1, const char *);
        run->options = w.options.run;
        run->hooks = &hooks;
        run->folder = run->options.output;
        if (species)
            *species = w.options.species, run->options.args.n = 1, run->options.args.operand = species;
        code = species && wf_analyze_run(run, argc, argv, &e) == WF_OK ? 0 : wf_complain(&e);
        wf_run_abandon(&run->results);
    }
    wf_arena_free(&run->arena);
    return code;
}
