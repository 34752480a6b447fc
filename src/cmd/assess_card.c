/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_card.h"
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/assess_fit.h"
#include "cmd/scenarios.h"
#include "data/species.h"
#include "grow/silhouette.h"
#include "study/directions.h"
#include "wind/wind.h"
#include <math.h>
#include <string.h>

/* ---- The card ---- */

static enum wf_crown_form form_of(const char *word)
{
    int k = 0;
    while (word && wf_crown_form_words[k] && strcmp(word, wf_crown_form_words[k])) k++;
    return word && wf_crown_form_words[k] ? (enum wf_crown_form)k : WF_FORM_ELLIPSE;
}

/* Width of a crown of that form and depth with this area. */
static double width_of(double area, enum wf_crown_form form, double depth)
{
    const struct wf_silhouette one = { .area = NAN, .width = 1, .depth = depth, .form = form };
    return area / wf_silhouette_area(&one);
}

static struct wf_card card_of(const struct wf_assess_options *o)
{
    const struct wf_tree_asked *t = &o->run.tree;
    struct wf_card c = { .height = o->height,
                         .girth = o->girth,
                         .dbh = o->dbh,
                         .crown_width = t->crown.width,
                         .crown_base = o->crown_base,
                         .form = form_of(t->crown_form),
                         .lean = o->lean };
    if (isnan(c.crown_base)) c.crown_base = o->height - t->crown.depth;
    if (!isnan(t->crown.area)) c.crown_width = width_of(t->crown.area, c.form, c.height - c.crown_base);
    if (isnan(c.crown_base) && t->outline) c.crown_base = 0; /* the outline says where the crown is */
    if (!isnan(o->lean_towards)) c.lean_azimuth = wf_wind_azimuth(o->lean_towards + WF_PI, o->run.north);
    return c;
}

/* Is the tree described elsewhere, by the rows of a table, a fit or a file of its own? */
static bool elsewhere(const void *options)
{
    const struct wf_assess_options *o = options;
    return o->run.args.n > 0 || o->from || o->scan;
}

static bool wrong_value(const void *options, enum wf_card_value v, char *why)
{
    struct wf_card c = card_of(options);
    return !elsewhere(options) && wf_card_wrong(&c, v, why, WF_WHY);
}

static bool height_wrong(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wrong_value(options, WF_CARD_HEIGHT, why);
}

static bool girth_wrong(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wrong_value(options, WF_CARD_GIRTH, why);
}

static bool dbh_wrong(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wrong_value(options, WF_CARD_DBH, why);
}

static bool base_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_assess_options *o = options;
    double depth = o->run.tree.crown.depth;
    (void)row;
    if (wrong_value(options, WF_CARD_BASE, why)) return true;
    return wf_option_unused(fabs(o->height - o->crown_base - depth) > 0.02 * o->height, why,
                            "%.4g m and the crown depth of %.4g m do not add up to the height of %.4g m. "
                            "Give one of them",
                            o->crown_base, depth, o->height);
}

static bool width_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_tree_asked *t = &((const struct wf_assess_options *)options)->run.tree;
    if (elsewhere(options)) return false;
    int given = !isnan(t->crown.width) + !isnan(t->crown.area) + (t->outline != NULL);
    (void)row;
    if (wf_option_unused(!given, why, "is needed, or --frontal-area or --photo-outline")) return true;
    if (wf_option_unused(given > 1, why,
                         "is one of three that say how large the crown is, with --frontal-area and "
                         "--photo-outline. Give one"))
        return true;
    return wrong_value(options, WF_CARD_WIDTH, why);
}

/* "--girth 250 cm" without quotes: the unit is no table. */
static bool operand_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_args *a = options;
    const char *operand = a->n ? a->operand[0] : "";
    (void)row;
    if (!*operand || wf_file_is_there(operand)) return false;
    if (strpbrk(operand, "./"))
        return wf_option_unused(true, why, "%.200s: No such file or directory", operand);
    return wf_option_unused(
        true, why,
        "'%.60s' is taken as the name of a card or a table, and there is no such file; a value "
        "and its unit are one word, 250cm or '250 cm'",
        operand);
}

static bool species_wrong(const void *options, const struct wf_option *row, char *why)
{
    const char *name = ((const struct wf_assess_options *)options)->species, *path;
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_err e = { WF_OK, "" };
    (void)row;
    bool needed = !elsewhere(options) || ((const struct wf_assess_options *)options)->scan;
    bool wrong = (!name && needed) || (name && wf_shipped("species", name, &scratch, &path, &unsaid, &e));
    (void)wf_option_unused(wrong, why, "%s",
                           name ? e.text : "is needed: a species table ('windfirm species list' shows them)");
    wf_arena_free(&scratch);
    return wrong;
}

static bool calm_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_speeds *wind = &((const struct wf_assess_options *)options)->run.wind;
    (void)row;
    return wf_option_unused(wind->n && !(wind->speed[wind->n - 1] > 0), why,
                            "0 m/s is no wind in which a tree could be assessed; a storm is meant, for "
                            "example --wind 25");
}

static bool wind_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_assess_options *o = options;
    (void)row;
    bool needed = !o->run.args.n; /* of a table: asked of its columns, and of each row */
    return wf_option_unused(needed && !WF_GIVEN(&o->run, wind) && !o->run.profile.design.code, why,
                            "is needed, or --wind: the wind in which the tree is assessed, for example "
                            "--design en1991 --basic-wind 25");
}

/* Is the tree that of a fit, of which the card's own keys say nothing? */
static bool card_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(((const struct wf_assess_options *)options)->from != NULL, why,
                            "with --from: the tree is that of the fit");
}

static bool from_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(((const struct wf_args *)options)->n > 0, why, "with a table of trees");
}

static bool towards_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_assess_options *o = options;
    bool said =
        o->lean > 0 || wf_option_given(&o->run.args, offsetof(struct wf_assess_options, lean)); /* 0 */
    return card_unused(options, row, why) || wf_option_unused(!said, why, "without --lean");
}

const struct wf_assess_beside wf_assess_besides[] = {
    { "--winter-wind", { "--snow", "--ice" }, "without --snow and --ice" },
    { "--snow-density", { "--snow" }, "without --snow" },
    { 0 },
};

static bool is_option(const struct wf_args *a, size_t k, const char *name)
{
    return name && a->given[k] && !strcmp(a->option[k].name, name);
}

static bool beside_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_args *a = options;
    const struct wf_assess_beside *b = wf_assess_besides;
    bool acts = a->n > 0; /* of a table: asked when its columns are known */
    while (strcmp(b->option, row->name) != 0) b++;
    for (size_t k = 0; a->option[k].name; k++)
        acts = acts || is_option(a, k, b->other[0]) || is_option(a, k, b->other[1]);
    return wf_option_unused(!acts, why, "%s", b->without);
}

static bool change_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(((const struct wf_assess_options *)options)->run.args.n > 0, why,
                            "with a table of trees; a card has it");
}

static bool remove_unused(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_assess_options *o = options;
    if (o->run.args.n > 0) return change_unused(options, row, why);
    return wf_option_unused(!o->from, why,
                            "with a card, which draws the stem alone: reduce and thin change its crown");
}

static bool reports_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(!((const struct wf_args *)options)->n, why,
                            "without a table; -o FOLDER is of a card");
}

static bool scans_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(!((const struct wf_args *)options)->n, why, "without a table");
}

/* ---- The rows ---- */

#define OPTIONS struct wf_assess_options
static const struct wf_option card_rows[] = {
    TEXT("--card", name, "NAME", NULL, "name of the tree; the first key of a card", .wrong = operand_wrong),
    TEXT("--species", species, "SPECIES", NULL,
         "species table: a file or the name of a shipped one ('windfirm species list')",
         .wrong = species_wrong, .unused = card_unused),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0, 1e4, NULL, "from the ground to the top",
           .wrong = height_wrong, .unused = card_unused),
    NUMBER("--girth", girth, "LENGTH", LENGTH, "m", 0, 1e4, NULL,
           "around the stem at 1.3 m above the ground, over bark", .wrong = girth_wrong,
           .unused = card_unused),
    NUMBER("--dbh", dbh, "LENGTH", LENGTH, "m", 0, 1e4, NULL, "in place of --girth: the diameter there",
           .wrong = dbh_wrong, .unused = card_unused),
    NUMBER("--crown-base", crown_base, "HEIGHT", LENGTH, "m", 0, 1e4, NULL,
           "height of the lowest living branches of the crown; or --crown-depth", .wrong = base_wrong,
           .unused = card_unused),
    NUMBER("--lean", lean, "ANGLE", ANGLE, "deg", 0, 60, "0", "of the stem from the vertical",
           .unused = card_unused),
    NUMBER("--lean-towards", lean_towards, "ANGLE", ANGLE, "deg", -360, 360, NULL,
           "where it leans to, clockwise from north [+x]", .unused = towards_unused),
    PATH("--photo-outline", run.tree.outline, "FILE", NULL,
         "the crown's outline on a photograph: a table with the columns x_m and z_m (height above the "
         "ground), a point a row, or an SVG file with one closed path"),
    NUMBER("--required-safety", required, "NUMBER", NONE, NULL, 1, 10, "1.5",
           "safety that is required, of arborists' practice"),
    PATH("--extremes", extremes, "FOLDER|FILE", NULL,
         "how often winds blow, for the return period of the critical wind: results of 'windfirm wind "
         "extremes', or a table of annual maxima, 10-min means at 10 m over open country [the code's]"),
    NUMBER("--life", life, "YEARS", NONE, NULL, 1, 1000, "10",
           "time over which the chance of the critical wind is also given"),
    TEXT("--reports", reports, "FOLDER", NULL,
         "of a table: also results, tables, plots and pages of each tree, in a folder by the line of its row",
         .unused = reports_unused),
    PATH("--scans", scans, "FOLDER", NULL,
         "of a table: where the files of trees are that its column 'scan' names; none outside is opened [the "
         "table's folder]",
         .unused = scans_unused),
    PATH("--from", from, "FOLDER", NULL,
         "in place of a card: the tree of a pulling test, a results folder of 'windfirm fit'",
         .unused = from_unused),
    TEXT("--output", run.output, "PATH", NULL,
         "write results, tables, plots and pages there, as 'windfirm analyze' does [the terminal alone]; of "
         "a table "
         "of trees: the table to be written",
         .letter = "-o"),
};

/* Options of analyze that say something else, or nothing, of a card. */
static const char *const left_out[] = {
    "--output",  "--model",        "--tree",          "--joint",           "--leaf-area",
    "--rest",    "--scanned",      "--strict",        "--crown-outline",   "--unload",
    "--tree-id", "--scan-model",   "--force",         "--cap-children",    "--preset",
    "--solver",  "--shelter",      "--branches-from", "--branch-strength", "--weight-stress",
    "--unions",  "--node-spacing",
};

static bool is_left_out(const struct wf_option *row)
{
    for (size_t k = 0; k < WF_COUNT(left_out); k++)
        if (!strcmp(row->name, left_out[k])) return true;
    return false;
}

/* What an option that is no row holds; the defaults of numbers are in `run` already. */
static void set_left_out(struct wf_assess_options *o, const struct wf_option *row)
{
    void *member = (char *)o + row->member;
    if (row->kind == WF_OPTION_NUMBER)
        *(double *)member = NAN;
    else if (row->kind == WF_OPTION_FLAG)
        *(bool *)member = false;
    else
        *(const char **)member = row->initial;
}

const struct wf_option *wf_assess_options_of(struct wf_assess_options *o)
{
    static struct wf_option rows[WF_OPTIONS_MAX + 1];
    size_t n = WF_COUNT(card_rows);
    memcpy(rows, card_rows, sizeof card_rows);
    for (const struct wf_option *row = wf_analyze_options; row->name && n < WF_OPTIONS_MAX; row++) {
        if (is_left_out(row)) {
            set_left_out(o, row);
            continue;
        }
        rows[n] = *row;
        if (!strcmp(row->name, "--crown-width")) rows[n].wrong = width_wrong;
        if (!strcmp(row->name, "--design")) rows[n].wrong = wind_wrong;
        if (!strcmp(row->name, "--wind")) rows[n].wrong = calm_wrong;
        if (wf_scenario_changes(row) || !strcmp(row->name, "--scenarios")) rows[n].unused = change_unused;
        if (!strcmp(row->name, "--remove")) rows[n].unused = remove_unused;
        for (const struct wf_assess_beside *b = wf_assess_besides; b->option; b++)
            if (!strcmp(row->name, b->option)) rows[n].unused = beside_unused;
        n++;
    }
    o->run.branches_from = 0.05;
    return rows;
}
_Static_assert(offsetof(struct wf_assess_options, run) == 0, "rows of analyze are taken as they are");

/* ---- The model ---- */

enum wf_status wf_assess_model(const struct wf_assess_options *o, const struct wf_species *sp,
                               struct wf_arena *a, struct wf_model *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_tree_asked beside = o->run.tree;
    struct wf_card c = card_of(o);
    enum wf_status s = wf_card_check(&c, sp ? sp->latin : NULL, d, e);
    if (s || !sp) return s;
    if (wf_card_of_stand(&c) && isnan(o->run.peak.spacing))
        wf_diag_warn(d, "card-stand",
                     "a tree so slender (%.0f times as high as thick) with so high a crown grew in a stand; "
                     "without --spacing it is "
                     "assessed as one that stands alone in the open, which its neighbours' shelter does not "
                     "help: far lower winds",
                     o->height / (isnan(o->dbh) ? o->girth / WF_PI : o->dbh));
    if (o->lean > 0 && isnan(o->lean_towards))
        wf_diag_warn(d, "lean-towards",
                     "where the tree leans to is not given (--lean-towards): directions are as if it leaned "
                     "towards %.4g deg",
                     remainder(wf_wind_from(c.lean_azimuth, o->run.north) * 180 / WF_PI - 180, 360));
    if ((s = wf_card_model(&c, sp, a, out, e))) return s;
    if (o->name) out->name = o->name;
    beside.crown.width = beside.crown.depth = beside.crown.area = NAN; /* they are the card's */
    beside.crown.leafless = NAN; /* of a tree in leaf it is that of its scenarios without leaves */
    if ((s = wf_tree_asked_onto(&beside, false, a, out, d, e))) return s;
    out->silhouette.leafless = o->run.tree.crown.leafless;
    if (!isnan(out->silhouette.leafless) && out->season == WF_LEAF_ON && !o->run.leaf_off &&
        !o->run.scenarios)
        wf_diag_warn(d, "leaf-off-share", "%s: leaf_off_share has no effect on a tree in leaf", out->name);
    return WF_OK;
}

struct wf_assess_often wf_assess_often_of(const struct wf_assess_options *o)
{
    struct wf_assess_often often = o->often;
    often.design = &o->run.profile.design;
    often.life = o->life;
    return often;
}

/* ---- One tree apart ---- */

/* The crown in leaf, as it was measured, onto a tree whose file shows no leaves: its wood alone would catch
 * far too little wind. */
static enum wf_status put_crown(const struct wf_assess_options *o, struct wf_model *m, struct wf_err *e)
{
    const struct wf_tree_asked *t = &o->run.tree;
    struct wf_silhouette *s = &m->silhouette;
    double rise = wf_model_rise(m), depth = isnan(t->crown.depth) ? rise - o->crown_base : t->crown.depth;
    if (m->season == WF_LEAF_OFF || m->leaf_area > 0 || wf_silhouette_area(s) > 0) return WF_OK;
    if (o->crown_base >= rise)
        return wf_fail(e, WF_EINPUT,
                       "%s: the tree is %.4g m high; the crown base of %.4g m is not below that", o->scan,
                       rise, o->crown_base);
    if (t->crown.area > 0)
        s->area = t->crown.area;
    else if (t->crown.width > 0 && depth > 0)
        s->width = t->crown.width, s->depth = depth, s->form = form_of(t->crown_form);
    else
        return wf_fail(
            e, WF_EINPUT,
            "%s shows no leaves, and wood alone catches too little wind: a crown width with its base "
            "or depth is needed, or a frontal area, or the season leaf_off",
            o->scan);
    return wf_silhouette_check(s, e);
}

bool wf_assess_is_yaml(const char *scan)
{
    const char *ending = strrchr(scan, '.');
    return ending && (!strcmp(ending, ".yaml") || !strcmp(ending, ".yml"));
}

/* The tree of a file in place of the card. */
static enum wf_status read_scan(const struct wf_assess_options *o, struct wf_arena *a, struct wf_model *out,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_tree_asked t = o->run.tree;
    const char *path;
    *(wf_assess_is_yaml(o->scan) ? &t.model : &t.file) = o->scan;
    t.crown.width = t.crown.depth = t.crown.area = NAN, t.crown_form = NULL;
    enum wf_status s = wf_tree_asked_read(&t, NULL, a, out, &path, d, e);
    if (!s && o->name) out->name = o->name;
    return s ? s : put_crown(o, out, e);
}

/* What is done to the crown of a card. */
static enum wf_status change_crown(struct wf_assess_case *c, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_analyze_options *o = &c->options.run;
    struct wf_reduced asked = { 0 };
    (void)wf_reduction_read(o->reduce, &asked);
    const struct wf_card_change change = {
        .reduce_share = asked.share, .reduce_length = asked.length, .thin = o->thin, .cavity_growth = NAN
    };
    return wf_card_change(&change, a, &c->model, &c->cut, e);
}

enum wf_status wf_assess_case_read(struct wf_assess_case *c, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_err *e)
{
    bool card = !c->options.scan && !c->fit;
    enum wf_status s = c->fit ? wf_assess_fit_model(c->fit, &c->options.run, a, &c->model, d, e)
                       : card ? wf_assess_model(&c->options, c->species, a, &c->model, d, e)
                              : read_scan(&c->options, a, &c->model, d, e);
    if (!s) s = wf_analyze_request_read(&c->options.run, a, d, &c->request, e);
    c->request.search.bare = !c->options.reports;
    if (c->request.search.bare && card &&
        !WF_GIVEN(&c->options.run, mesh_tolerance)) { /* as for the samples of an interval */
        c->request.solve.mesh_tolerance = 0.0;
        c->request.solve.tolerance = fmax(c->request.solve.tolerance, 1e-2); /* its square is left */
    }
    if (!s && c->fit) s = wf_assess_fit_onto(c->fit, &c->options.run, a, &c->request, e);
    if (!s && card) s = change_crown(c, a, e);
    double grown = card ? c->options.height : c->fit ? c->grown : (double)NAN;
    return s ? s
             : wf_scenario_onto(&c->options.run, card, c->whole ? c->whole : &c->model, grown, a, &c->request,
                                &c->model, e);
}

enum wf_status wf_assess_case_run(struct wf_assess_case *c, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    struct wf_analyze_request *q = &c->request;
    const struct wf_speeds *wind = &c->options.run.wind;
    const struct wf_assess_often often = wf_assess_often_of(&c->options);
    double worst = q->scenario.azimuth;
    enum wf_status s = WF_OK;
    bool turns = !c->alone && !wf_assess_is_round(&c->model, &q->scenario);
    if (c->alone) worst = c->towards;
    if (turns)
        s = wf_assess_around(c->species, &c->model, &q->scenario, q->solver, &q->solve,
                             wind->speed[wind->n - 1], q->directions.north, c->around, &worst, e);
    if (!s && !WF_GIVEN(&c->options.run, azimuth))
        s = wf_scenario_turn(&q->scenario, worst, q->directions.north, e);
    if (!s)
        s = wf_analyze(c->species, &c->model, &q->scenario, &q->search, q->solver, &q->solve, wind->speed,
                       wind->n, a, d, &c->an, e);
    if (!s) s = wf_interval_take(&c->an, &q->solve, &q->interval, true, a, e);
    if (!s) s = wf_assess(&c->an, &q->solve, c->options.required, &often, &c->x, e);
    if (turns && !s)
        wf_assess_all_around(&c->x, c->around, wf_direction_from(&q->directions, q->scenario.azimuth),
                             WF_GIVEN(&c->options.run, azimuth));
    return s;
}
