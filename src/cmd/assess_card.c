/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_card.h"
#include "base/num.h"
#include "base/text.h"
#include "data/species.h"
#include "wind/wind.h"
#include <math.h>
#include <string.h>

/* ---- The card ---- */

static struct wf_card card_of(const struct wf_assess_options *o)
{
    const struct wf_tree_asked *t = &o->run.tree;
    struct wf_card c = { .height = o->height,
                         .girth = o->girth,
                         .dbh = o->dbh,
                         .crown_width = t->crown.width,
                         .crown_base = o->crown_base,
                         .lean = o->lean };
    if (isnan(c.crown_base)) c.crown_base = o->height - t->crown.depth;
    if (isnan(c.crown_base) && t->outline) c.crown_base = 0; /* the outline says where the crown is */
    if (!isnan(o->lean_towards)) c.lean_azimuth = wf_wind_azimuth(o->lean_towards + WF_PI, o->run.north);
    return c;
}

/* Are the options those of a command line with a table, whose rows say the rest? */
static bool of_table(const void *options) { return ((const struct wf_args *)options)->n > 0; }

static bool wrong_value(const void *options, enum wf_card_value v, char *why)
{
    struct wf_card c = card_of(options);
    return !of_table(options) && wf_card_wrong(&c, v, why, WF_WHY);
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
    if (of_table(options)) return false;
    int given = !isnan(t->crown.width) + !isnan(t->crown.area) + (t->outline != NULL);
    (void)row;
    if (wf_option_unused(!given, why, "is needed, or --frontal-area or --photo-outline")) return true;
    if (wf_option_unused(given > 1, why,
                         "is one of three that say how large the crown is, with --frontal-area and "
                         "--photo-outline. Give one"))
        return true;
    return wrong_value(options, WF_CARD_WIDTH, why);
}

static bool species_wrong(const void *options, const struct wf_option *row, char *why)
{
    const char *name = ((const struct wf_assess_options *)options)->species, *path;
    struct wf_arena scratch = { 0 };
    struct wf_diag unsaid = { .arena = &scratch };
    struct wf_err e = { WF_OK, "" };
    (void)row;
    bool wrong =
        (!name && !of_table(options)) || (name && wf_shipped("species", name, &scratch, &path, &unsaid, &e));
    (void)wf_option_unused(wrong, why, "%s",
                           name ? e.text : "is needed: a species table ('windfirm species list' shows them)");
    wf_arena_free(&scratch);
    return wrong;
}

static bool wind_wrong(const void *options, const struct wf_option *row, char *why)
{
    const struct wf_assess_options *o = options;
    (void)row;
    return wf_option_unused(!o->run.wind.n && !o->run.profile.design.code, why,
                            "is needed, or --wind: the wind in which the tree is assessed, for example "
                            "--design en1991 --basic-wind 25");
}

static bool towards_unused(const void *options, const struct wf_option *row, char *why)
{
    (void)row;
    return wf_option_unused(!(((const struct wf_assess_options *)options)->lean > 0), why, "without --lean");
}

/* ---- The rows ---- */

#define OPTIONS struct wf_assess_options
static const struct wf_option card_rows[] = {
    TEXT("--card", name, "NAME", NULL, "name of the tree; the first key of a card"),
    TEXT("--species", species, "SPECIES", NULL,
         "species table: a file or the name of a shipped one ('windfirm species list')",
         .wrong = species_wrong),
    NUMBER("--height", height, "LENGTH", LENGTH, "m", 0, 1e4, NULL, "from the ground to the top",
           .wrong = height_wrong),
    NUMBER("--girth", girth, "LENGTH", LENGTH, "m", 0, 1e4, NULL,
           "around the stem at 1.3 m above the ground, over bark", .wrong = girth_wrong),
    NUMBER("--dbh", dbh, "LENGTH", LENGTH, "m", 0, 1e4, NULL, "in place of --girth: the diameter there",
           .wrong = dbh_wrong),
    NUMBER("--crown-base", crown_base, "HEIGHT", LENGTH, "m", 0, 1e4, NULL,
           "height of the lowest living branches of the crown; or --crown-depth", .wrong = base_wrong),
    NUMBER("--lean", lean, "ANGLE", ANGLE, "deg", 0, 60, "0", "of the stem from the vertical"),
    NUMBER("--lean-towards", lean_towards, "ANGLE", ANGLE, "deg", -360, 360, NULL,
           "where it leans to, clockwise from north [+x]", .unused = towards_unused),
    PATH("--photo-outline", run.tree.outline, "FILE", NULL,
         "the crown's outline on a photograph: a table with the columns x_m and z_m (height above the "
         "ground), a point a row, or an SVG file with one closed path"),
    NUMBER("--required-safety", required, "NUMBER", NONE, NULL, 1, 10, "1.5",
           "safety that is required, of arborists' practice"),
    TEXT("--output", run.output, "PATH", NULL,
         "write results, tables, plots and pages there, as 'windfirm analyze' does [the terminal alone]; of "
         "a table "
         "of trees: the table to be written",
         .letter = "-o"),
};

/* Options of analyze that say something else, or nothing, of a card. */
static const char *const left_out[] = {
    "--output",  "--model",           "--tree",          "--joint",         "--leaf-area",
    "--rest",    "--scanned",         "--strict",        "--crown-outline", "--unload",
    "--tree-id", "--scan-model",      "--force",         "--cap-children",  "--preset",
    "--solver",  "--shelter",         "--branches-from", "--water-film",    "--rain",
    "--storage", "--branch-strength", "--weight-stress",
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
    if ((s = wf_card_model(&c, sp, a, out, e))) return s;
    if (o->name) out->name = o->name;
    beside.crown.width = beside.crown.depth = NAN; /* they are the card's */
    return wf_tree_asked_onto(&beside, false, a, out, d, e);
}
