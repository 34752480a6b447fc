/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/scenarios.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "grow/card.h"
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
        "--card",      "--species",   "--height",         "--girth",          "--dbh",           "--output",
        "--model",     "--tree",      "--joint",          "--rest",           "--scanned",       "--strict",
        "--unload",    "--solver",    "--preset",         "--shelter",        "--branches-from", "--unions",
        "--corridor",  "--threads",   "--tip-angle-limit", "--directions",    "--climate",       "--north",
        "--dem",       "--at",        "--search-to",      "--search-time",    "--samples",       "--seed",
        "--reports",   "--scans",     "--mesh-tolerance", "--corridor-towards", "--from",        "--extremes",
        "--life",      "--scenarios", "--quiet",          "--weight-stress",  "--required-safety",
    };
#define OF_GROUP(group)                                                                                      \
    (row->member >= offsetof(struct wf_analyze_options, group) &&                                            \
     row->member < offsetof(struct wf_analyze_options, group) +                                              \
                       sizeof(((struct wf_analyze_options *)NULL)->group))
    bool group = OF_GROUP(job) || OF_GROUP(pages) || OF_GROUP(tree.scan);
#undef OF_GROUP
    return group || row->kind == WF_OPTION_STUDY || is_among(row->name, list, WF_COUNT(list));
}

bool wf_scenario_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_analyze_options *o = options;
    const struct wf_preset *p = wf_preset_named(o->preset);
    const struct wf_solver *s = p && p->solver ? wf_solver_named(p->solver) : wf_solver_named(o->solver);
    (void)row;
    if (strcmp(o->preset, wf_presets[0].name) != 0)
        return wf_option_unused(true, why, "with the preset '%s', which repeats a publication", o->preset);
    if (s && !s->tracked)
        return wf_option_unused(true, why, "with the solver '%s': its solutions have no slopes", s->name);
    return wf_option_unused(o->shelter && strcmp(o->shelter, "none") != 0, why, "with --shelter");
}

/* ---- Roots ---- */

/* A number with one of two units; without one it is of the second where that is NULL. */
static bool read_part(const char *text, const char *unit, double factor, double *out)
{
    const char *end = wf_number_read(text, text + strlen(text), '.', out);
    if (!end) return false;
    end += strspn(end, " ");
    if (!*end) return true;
    *out *= factor;
    return !strcmp(end, unit);
}

/* "from=30,to=120,share=60%", as a table of a card arrives, as "30:120:60%". */
static void join_table(char *text)
{
    static const char *const key[] = { "from=", ",to=", ",share=" };
    for (size_t k = 0; k < WF_COUNT(key); k++) {
        char *at = strstr(text, key[k]);
        if (!at || (k == 0 && at != text)) break;
        if (k) *at++ = ':';
        const char *rest = at + strlen(key[k]) - (k > 0);
        memmove(at, rest, strlen(rest) + 1);
    }
}

/* "40 %" all around, "30deg:120deg" or "30deg:120deg:40 %", clockwise from north. Returned: whether it is one
 * of them; in *q the loss, its sector as on a compass: middle and half the width [rad]. */
static bool read_root_loss(const char *text, struct wf_anchorage_request *q)
{
    char copy[80], *part[3] = { copy };
    const double degree = WF_PI / 180;
    double from, to;
    size_t n = 1;
    if (!text) return true;
    if (strlen(text) >= sizeof copy) return false;
    memcpy(copy, text, strlen(text) + 1);
    join_table(copy);
    for (char *p = copy; (p = strchr(p, ':')); part[n++] = p) {
        if (n == WF_COUNT(part)) return false;
        *p++ = '\0';
        p += strspn(p, " ");
    }
    q->lost = 1, q->lost_half = WF_PI;
    if (n != 2 && !read_part(part[n - 1], "%", 0.01, &q->lost)) return false;
    if (n > 1) {
        if (!read_part(part[0], "deg", 1, &from) || !read_part(part[1], "deg", 1, &to)) return false;
        if (!(fabs(from) <= 360 && fabs(to) <= 360)) return false;
        double width = to - from > 0 ? to - from : to - from + 360;
        if (from == to || !(width > 0 && width <= 360)) return false;
        q->lost_half = 0.5 * width * degree, q->lost_middle = (from + 0.5 * width) * degree;
    }
    return q->lost > 0 && q->lost <= (n > 1 ? 1 : 0.95);
}

bool wf_scenario_roots_wrong(const void *options, const struct wf_option *row, char *why)
{
    const char *text = ((const struct wf_analyze_options *)options)->root_loss;
    struct wf_anchorage_request q;
    (void)row;
    return wf_option_unused(!read_root_loss(text, &q), why,
                            "'%.60s' is no loss of roots: a share up to 95%% all around, 40%%, or a sector "
                            "clockwise from north with or without a share, 30deg:120deg:60%%",
                            text);
}

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
    if (value) *value++ = '\0';
    text = wf_text_trim(text);
    size_t row = row_named(rows, text);
    if (row == (size_t)-1 && !value && before && !strcmp(before->name, "--remove")) {
        const char **cell = &out->cell[out->n - 1];
        *cell = wf_arena_print(a, "%s+%s", *cell, text);
        return *cell ? NULL : "not enough memory";
    }
    if (row == (size_t)-1) return wf_arena_print(a, "'%.40s' is no key of a tree", text);
    if (is_of_run(&rows[row])) return wf_arena_print(a, "'%.40s' is the same in all scenarios", text);
    if (!value && rows[row].kind != WF_OPTION_FLAG)
        return wf_arena_print(a, "'%.40s' has no value; it is written %s=VALUE", text, text);
    for (size_t k = 0; k < out->n; k++)
        if (out->option[k] == row)
            return wf_arena_print(a, "'%.40s' is there twice; several cables stand in one, apart by ';'", text);
    if (out->n == WF_SCENARIO_CHANGES) return "more than 12 changes";
    out->option[out->n] = row;
    out->cell[out->n++] = value ? value + strspn(value, " ") : "yes";
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
        const char *name = wf_arena_text(a, item);
        if (!text || !name) return wf_fail(e, WF_ENOMEM, "not enough memory for a removal");
        s = add_item(o, text, a, d, out, e);
        if (!s && out->n > before) out->item[before].name = name, out->item[before].removal = true;
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

enum wf_status wf_scenario_options(const struct wf_args *line, const char *command,
                                   const struct wf_scenario_words *x, struct wf_units *units, struct wf_arena *a,
                                   struct wf_diag *d, struct wf_args *out, struct wf_err *e)
{
    struct wf_args *beside = WF_TAKE(a, 1, struct wf_args);
    struct wf_sink sink;
    if (!beside) return wf_fail(e, WF_ENOMEM, "not enough memory for a scenario");
    *beside = *line;
    for (size_t k = 0; beside->option[k].name; k++) {
        const struct wf_option *row = &beside->option[k];
        bool other = !strcmp(row->name, "--scenarios") || !strcmp(row->name, "--remove");
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
    if (!said && o->root_loss)
        return wf_fail(e, WF_EUSAGE, "root_loss has no effect: nothing says what the roots hold (soil, pull_moment)");
    if (!said) return WF_OK;
    if (!roots) return wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
    *roots = *said;
    if (!(roots->grown > 0)) roots->grown = grown;
    if (o->root_loss) {
        (void)read_root_loss(o->root_loss, roots);
        roots->lost_middle = wf_wind_azimuth(roots->lost_middle + WF_PI, q->directions.north);
    }
    q->scenario.anchorage = roots;
    return WF_OK;
}

enum wf_status wf_scenario_onto(const struct wf_analyze_options *o, const struct wf_model *whole, double grown,
                                struct wf_arena *a, struct wf_analyze_request *q, struct wf_model *m,
                                struct wf_err *e)
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
    if (!s) s = wf_card_change(&walls, a, m, &cut, e);
    return s ? s : lose_roots(o, grown, a, q, e);
}
