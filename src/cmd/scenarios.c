/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/scenarios.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "grow/card.h"
#include "grow/silhouette.h"
#include "study/removal.h"
#include "wind/wind.h"
#include <math.h>
#include <string.h>

/* ---- Which options ---- */

static bool is_among(const char *name, const char *const *list, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!strcmp(name, list[k])) return true;
    return false;
}

bool wf_scenario_changes(const struct wf_option *row)
{
    static const char *const list[] = { "--reduce",        "--thin",      "--leaf-off",
                                        "--cavity-growth", "--root-loss", "--remove" };
    return is_among(row->name, list, WF_COUNT(list));
}

/* Options that are of the run and not of a tree, or that say which tree it is. */
static bool is_of_run(const struct wf_option *row)
{
    static const char *const list[] = {
        "--card",
        "--species",
        "--output",
        "--model",
        "--tree",
        "--joint",
        "--rest",
        "--scanned",
        "--strict",
        "--unload",
        "--solver",
        "--preset",
        "--shelter",
        "--branches-from",
        "--unions",
        "--corridor",
        "--threads",
        "--tip-angle-limit",
        "--directions",
        "--climate",
        "--north",
        "--dem",
        "--at",
        "--search-to",
        "--search-time",
        "--samples",
        "--seed",
        "--reports",
        "--scans",
        "--mesh-tolerance",
        "--corridor-towards",
        "--from",
        "--extremes",
        "--life",
        "--scenarios",
        "--quiet",
        "--weight-stress",
        "--required-safety",
    };
#define OF_GROUP(group)                                                                                      \
    (row->member >= offsetof(struct wf_analyze_options, group) &&                                            \
     row->member <                                                                                           \
         offsetof(struct wf_analyze_options, group) + sizeof(((struct wf_analyze_options *)NULL)->group))
    bool group = OF_GROUP(job) || OF_GROUP(pages) || OF_GROUP(tree.scan);
#undef OF_GROUP
    return group || row->kind == WF_OPTION_STUDY || is_among(row->name, list, WF_COUNT(list));
}

bool wf_scenario_takes(const struct wf_option *row) { return !is_of_run(row); }

/* ---- Reading ---- */

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

/* One "key=value", or a key alone, which is a flag; behind a removal also one more of its parts. Returned:
 * NULL, or what is wrong. */
static const char *add_change(const struct wf_option *rows, char *text, struct wf_scenario_words *out,
                              struct wf_arena *a)
{
    char *value = strchr(text, '=');
    const struct wf_option *before = out->n ? &rows[out->option[out->n - 1]] : NULL;
    if (value) *value++ = '\0', value = wf_text_trim(value);
    text = wf_text_trim(text);
    size_t row = row_named(rows, text);
    if (row == (size_t)-1 && !value && before && !strcmp(before->name, "--remove")) {
        const char **cell = &out->cell[out->n - 1];
        *cell = wf_arena_print(a, "%s+%s", *cell, text);
        return *cell ? NULL : "not enough memory";
    }
    if (row == (size_t)-1) return wf_arena_print(a, "'%.40s' is no key of a tree", text);
    if (is_of_run(&rows[row])) return wf_arena_print(a, "'%.40s' is the same in all scenarios", text);
    if (value ? !*value : rows[row].kind != WF_OPTION_FLAG)
        return wf_arena_print(a, "'%.40s' has no value; it is written %s=VALUE", text, text);
    for (size_t k = 0; k < out->n; k++)
        if (out->option[k] == row)
            return wf_arena_print(a, "'%.40s' is there twice; several cables stand in one, apart by ';'",
                                  text);
    if (out->n == WF_SCENARIO_CHANGES) return "more than 12 changes";
    out->option[out->n] = row;
    out->cell[out->n++] = value ? value : "yes";
    return NULL;
}

static enum wf_status add_item(const struct wf_analyze_options *o, char *text, struct wf_arena *a,
                               struct wf_diag *d, struct wf_scenario_list *out, struct wf_err *e)
{
    if (out->n == WF_SCENARIOS_MAX)
        return wf_fail(e, WF_EUSAGE, "more than %d scenarios", (int)WF_SCENARIOS_MAX);
    struct wf_scenario_words *x = &out->item[out->n++];
    const char *wrong = NULL;
    x->name = wf_arena_text(a, text);
    if (!x->name) return wf_fail(e, WF_ENOMEM, "not enough memory for a scenario");
    for (char *rest = text, *next; rest && !wrong; rest = next) {
        if ((next = strchr(rest, '+'))) *next++ = '\0';
        wrong = add_change(o->args.option, rest, x, a);
    }
    if (wrong) wf_diag_error(d, NULL, 0, 0, "scenario '%s': %s", x->name, wrong), out->n--;
    return WF_OK;
}

/* Each removal of the option --remove is a scenario. */
static enum wf_status add_removals(const struct wf_analyze_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_scenario_list *out, struct wf_err *e)
{
    char *rest = o->remove ? wf_arena_text(a, o->remove) : NULL;
    enum wf_status s = WF_OK;
    for (char *item; rest && !s && (item = wf_list_item(&rest));) {
        size_t before = out->n;
        char *text = wf_arena_print(a, "remove=%s", item);
        if (!text) return wf_fail(e, WF_ENOMEM, "not enough memory for a removal");
        s = add_item(o, text, a, d, out, e);
        if (!s && out->n > before) out->item[before].removal = true;
    }
    return s;
}

/* The other changes given as options, in words; NULL: none. */
static char *changes_given(const struct wf_args *line, struct wf_arena *a)
{
    char *text = NULL;
    for (size_t k = 0; line->option[k].name; k++) {
        const struct wf_option *row = &line->option[k];
        if (!line->given[k] || !wf_scenario_changes(row) || !strcmp(row->name, "--remove")) continue;
        bool flag = row->kind == WF_OPTION_FLAG;
        text = wf_arena_print(a, "%s%s%s%s%s", text ? text : "", text ? " + " : "", row->name + 2,
                              flag ? "" : " ", flag ? "" : line->text[k]);
    }
    return text;
}

enum wf_status wf_scenarios_split(const struct wf_analyze_options *o, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_scenario_list *out, struct wf_err *e)
{
    char *given = changes_given(&o->args, a), *rest = o->scenarios ? wf_arena_text(a, o->scenarios) : NULL;
    *out = (struct wf_scenario_list){ 0 };
    if (given) out->item[out->n++] = (struct wf_scenario_words){ .name = given, .given = true };
    enum wf_status s = add_removals(o, a, d, out, e);
    for (char *item; rest && !s && (item = wf_list_item(&rest));) s = add_item(o, item, a, d, out, e);
    return s;
}

/* What is said of a stand. */
static const char *const of_stand[] = { "--spacing", "--stand-height", "--edge-distance", "--gap" };

/* Does the scenario take another peak load than that of stands? Then the tree stands alone in it. */
static bool leaves_stand(const struct wf_scenario_words *x, const struct wf_args *line)
{
    for (size_t k = 0; k < x->n; k++)
        if (!strcmp(line->option[x->option[k]].name, "--peak")) return strcmp(x->cell[k], "gales") != 0;
    return false;
}

enum wf_status wf_scenario_options(const struct wf_args *line, const char *command,
                                   const struct wf_scenario_words *x, struct wf_units *units,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_args *out,
                                   struct wf_err *e)
{
    struct wf_args *beside = WF_TAKE(a, 1, struct wf_args);
    struct wf_sink sink;
    if (!beside) return wf_fail(e, WF_ENOMEM, "not enough memory for a scenario");
    *beside = *line;
    const bool alone = leaves_stand(x, line);
    for (size_t k = 0; beside->option[k].name; k++) {
        const struct wf_option *row = &beside->option[k];
        bool other = !strcmp(row->name, "--scenarios") || !strcmp(row->name, "--remove") ||
                     (alone && is_among(row->name, of_stand, WF_COUNT(of_stand)));
        if (other || (!x->given && wf_scenario_changes(row))) beside->given[k] = false;
    }
    if (!wf_args_read_cells(beside, command, x->option, x->cell, x->n, units, a, out, &sink))
        wf_diag_error(d, NULL, 0, 0, "scenario '%s': %s", x->name, sink.text);
    return WF_OK;
}

bool wf_scenario_draws(const struct wf_scenario_words *x, const struct wf_args *line)
{
    const size_t from = offsetof(struct wf_analyze_options, tree);
    for (size_t k = 0; k < x->n; k++) {
        size_t member = line->option[x->option[k]].member;
        if (member >= from && member < from + sizeof(struct wf_tree_asked)) return true;
    }
    return false;
}

/* ---- On a tree ---- */

static enum wf_status lose_roots(const struct wf_analyze_options *o, double grown, struct wf_arena *a,
                                 struct wf_analyze_request *q, struct wf_err *e)
{
    struct wf_anchorage_request *roots = WF_TAKE(a, 1, struct wf_anchorage_request);
    const struct wf_anchorage_request *said = q->scenario.anchorage;
    if (!said) return WF_OK;
    if (!roots) return wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
    *roots = *said;
    if (!(roots->grown > 0)) roots->grown = grown;
    if (o->root_loss) {
        (void)wf_root_loss_read(o->root_loss, roots);
        roots->lost_middle = wf_wind_azimuth(roots->lost_middle + WF_PI, q->directions.north);
    }
    q->scenario.anchorage = roots;
    return WF_OK;
}

/* A drawn crown, or one of leaves whose place a model says. */
static enum wf_status change_crown(const struct wf_analyze_options *o, struct wf_analyze_request *q,
                                   struct wf_model *m, struct wf_err *e)
{
    (void)wf_reduction_read(o->reduce, &q->scenario.reduced);
    if (!(o->thin > 0)) return WF_OK;
    bool crown = wf_silhouette_area(&m->silhouette) > 0;
    if (!(m->leaf_area > 0) && !crown)
        return wf_fail(e, WF_EINPUT, "%s: thin has no effect: the tree has no leaves (its branches stay)",
                       m->name);
    m->leaf_area *= 1 - o->thin;
    if (crown) m->silhouette.thinned = o->thin;
    q->scenario.reduced.thin = o->thin;
    return WF_OK;
}

enum wf_status wf_scenario_onto(const struct wf_analyze_options *o, bool card, const struct wf_model *whole,
                                double grown, struct wf_arena *a, struct wf_analyze_request *q,
                                struct wf_model *m, struct wf_err *e)
{
    const struct wf_card_change walls = { .thin = NAN, .cavity_growth = o->cavity_growth };
    enum wf_status s = WF_OK;
    double cut;
    size_t n = 0;
    if (o->remove) s = wf_removals_read(o->remove, a, &q->scenario.removed, &n, e);
    if (!s && n > 1) s = wf_fail(e, WF_EUSAGE, "parts that are removed together are apart by '+'");
    if (o->leaf_off) wf_model_set_season(m, WF_LEAF_OFF);
    if (m->scanned == WF_SCANNED_AS_SEASON)
        m->scanned = whole->season == WF_LEAF_OFF ? WF_SCANNED_LEAF_OFF : WF_SCANNED_LEAF_ON;
    if (!s && !card) s = change_crown(o, q, m, e);
    if (!s) s = wf_card_change(&walls, a, m, &cut, e);
    struct wf_stand *stand = &q->scenario.peak.stand; /* its other trees are not cut */
    const double before =
        o->reduce || o->remove ? grown : 0; /* else samples of the height are those of the roots */
    if (!(stand->height > 0) && before > 0) stand->height = before;
    return s ? s : lose_roots(o, before, a, q, e);
}
