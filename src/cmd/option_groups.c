/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/option_groups.h"
#include "base/text.h"
#include "cmd/commands.h"
#include "cmd/read_mat.h"
#include "data/crown_mass.h"
#include "fail/anchorage.h"
#include "fail/fail.h"
#include "grow/grow.h"
#include "grow/outline_svg.h"
#include "grow/silhouette.h"
#include "load/interception.h"
#include "out/docx.h"
#include "out/template.h"
#include "solve/solve.h"
#include "study/peak.h"
#include "study/preset.h"
#include "wind/category.h"
#include "wind/design.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <string.h>

const char *wf_solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
const char *wf_preset_word(size_t i) { return wf_presets[i].name; }
const char *wf_branch_strength_word(size_t i) { return wf_branch_strengths[i].name; }
const char *wf_shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }
const char *wf_profile_word(size_t i) { return wf_profiles[i].name; }
const char *wf_site_word(size_t i) { return wf_site_kinds[i].name; }
const char *wf_design_word(size_t i) { return wf_designs[i].name; }
const char *wf_peak_word(size_t i) { return wf_peak_methods[i].name; }
const char *wf_import_word(size_t i) { return wf_import_formats[i].name; }
const char *wf_storage_word(size_t i) { return wf_storages[i].name; }

bool wf_water_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_water_asked *w = (const void *)((const char *)options + o->group);
    if (o->member - o->group == offsetof(struct wf_water_asked, storage))
        return wf_option_unused(isnan(w->rain), why, "without --rain");
    return wf_option_unused(!isnan(w->film), why, "beside --water-film");
}

double wf_water_asked_film(const struct wf_water_asked *w)
{
    if (!isnan(w->film)) return w->film * 1000; /* 1 mm over 1 m2 is 1 kg */
    return w->rain > 0 ? wf_storage_named(w->storage)->film : 0;
}

void wf_water_asked_warn(const struct wf_water_asked *w, struct wf_diag *d)
{
    if (!isnan(w->film) || !(w->rain > 0)) return;
    const struct wf_storage *storage = wf_storage_named(w->storage);
    wf_diag_warn(d, "water-storage",
                 "the leaves are taken to hold %.3g mm (%s); sources differ five- to tenfold, --storage and "
                 "--water-film try others",
                 storage->film, storage->source);
}

bool wf_profile_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_profile_words *w = (const void *)((const char *)options + o->group);
    return wf_profile_unused(w, o->member - o->group, why, WF_WHY);
}

bool wf_site_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_profile_words *w = (const void *)((const char *)options + o->group);
    size_t member = o->member - o->group;
    bool of_code = member > offsetof(struct wf_profile_words, design);
    if (member == offsetof(struct wf_profile_words, design.code)) return false;
    if (of_code) return wf_option_unused(!w->design.code, why, "without a design wind, --design");
    if (wf_option_unused(w->design.code, why, "with a design wind, --design")) return true;
    bool at = member == offsetof(struct wf_profile_words, at);
    return wf_option_unused(at && !w->design.terrain && !w->site, why, "without --terrain or --site");
}

static bool is_svg(const char *path)
{
    size_t n = path ? strlen(path) : 0;
    return n > 4 && !strcasecmp(path + n - 4, ".svg");
}

bool wf_tree_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_tree_asked *t = (const void *)((const char *)options + o->group);
    size_t member = o->member - o->group;
    if (member == offsetof(struct wf_tree_asked, outline_base) ||
        member == offsetof(struct wf_tree_asked, outline_top))
        return wf_option_unused(!is_svg(t->outline), why, "without an SVG file (--crown-outline FILE.svg)");
    if (member == offsetof(struct wf_tree_asked, joint) || member >= offsetof(struct wf_tree_asked, scan))
        return wf_option_unused(t->model && !t->file, why, "with --model; it is of a measured tree (--tree)");
    return wf_option_unused(t->file && isnan(t->leaf_area) && isnan(t->crown.area) && isnan(t->crown.width) &&
                                !t->outline,
                            why, "with a measured tree (--tree) that has no leaves (--leaf-area)");
}

/* The members that a method takes. */
static bool peak_takes(const char *method, size_t member)
{
    if (member == offsetof(struct wf_peak_asked, damping) ||
        member == offsetof(struct wf_peak_asked, exponent)) {
        const struct wf_peak_method *m = wf_peak_method_named(method);
        return !m || m->sways;
    }
    return !strcmp(method, member == offsetof(struct wf_peak_asked, table) ? "table" : "gales");
}

bool wf_peak_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_peak_asked *p = (const void *)((const char *)options + o->group);
    bool stand = !p->method && p->spacing > 0.0; /* the site decides */
    const char *method = p->method ? p->method : stand ? "gales" : "en1991";
    return wf_option_unused(!peak_takes(method, o->member - o->group), why, "with --peak %s", method);
}

/* Is the tree in a stand or at its edge? */
static bool in_stand(const struct wf_scenario *s)
{
    const struct wf_site_kind *kind = wf_site_kind_named(s->site_kind);
    return kind && kind->stand;
}

static double given_or(double given, double otherwise) { return isnan(given) ? otherwise : given; }

enum wf_status wf_peak_asked_read(const struct wf_peak_asked *asked, bool preset, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_scenario *out, struct wf_err *e)
{
    struct wf_peak_table *table = NULL;
    const struct wf_site_kind *kind = wf_site_kind_named(out->site_kind);
    double edge = kind && kind->edge ? 0.0 : INFINITY;
    enum wf_status s = WF_OK;
    if (asked->table && !(table = WF_TAKE(a, 1, struct wf_peak_table)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    if (table) s = wf_peak_table_read(asked->table, a, d, table, e);
    out->peak = (struct wf_peak_request){
        .method = asked->method                           ? asked->method
                  : out->design                           ? out->design->peak
                  : preset                                ? "mean"
                  : in_stand(out) && asked->spacing > 0.0 ? "gales"
                                                          : "en1991",
        .damping = asked->damping,
        .exponent_by_law = !strcmp(asked->exponent, "law"),
        .table = table,
        .stand = { .height = given_or(asked->stand_height, 0.0),
                   .spacing = given_or(asked->spacing, 0.0),
                   .edge = given_or(asked->edge, edge),
                   .gap = given_or(asked->gap, INFINITY) },
    };
    if (!s && !isnan(asked->spacing) && strcmp(out->peak.method, "gales") != 0)
        return wf_fail(
            e, WF_EUSAGE,
            "--spacing has no effect with --peak %s; it is of --peak gales, which is taken with --site "
            "in-stand and forest-edge unless a method, a design wind or a preset says otherwise",
            out->peak.method);
    return s;
}

const char *wf_soil_word(size_t i) { return wf_soils[i].name; }

/* Not seasons of the year: what stands in leaf in winter is not leafless. */
const char *wf_season_meant(const char *text)
{
    if (wf_text_among("leaf_on in_leaf leaved belaubt feuille en_feuilles 有叶 带叶", text)) return "leaf_on";
    if (wf_text_among("leaf_off leafless no_leaves unbelaubt laublos defeuille sans_feuilles 无叶 落叶后",
                      text))
        return "leaf_off";
    return NULL;
}

bool wf_anchorage_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_anchorage_asked *q = (const void *)((const char *)options + o->group);
    return wf_option_unused(!q->table, why, "without --anchorage-table");
}

/* Exactly one source of the anchorage, or none. */
static enum wf_status check_sources(const struct wf_anchorage_asked *q, double root_stiffness,
                                    struct wf_err *e)
{
    const struct {
        const char *option;
        bool given;
    } source[] = { { "--pull-moment", !isnan(q->pull_moment) },
                   { "--root-secant", !isnan(q->secant) },
                   { "--tipping-curve", q->curve != NULL },
                   { "--anchorage-table", q->table != NULL },
                   { "--anchorage", q->method != NULL } };
    const char *first = NULL;
    for (size_t i = 0; i < WF_COUNT(source); i++) {
        if (source[i].given && first)
            return wf_fail(e, WF_EUSAGE, "give one of %s and %s, not both: each is an anchorage of its own",
                           first, source[i].option);
        if (source[i].given) first = source[i].option;
    }
    if (q->method && !strcmp(q->method, "root-stiffness") && isnan(root_stiffness))
        return wf_fail(e, WF_EUSAGE, "--anchorage root-stiffness needs --root-stiffness, fitted at 0.25 deg");
    return WF_OK;
}

enum wf_status wf_anchorage_asked_read(const struct wf_anchorage_asked *asked, double root_stiffness,
                                       struct wf_arena *a, struct wf_diag *d, struct wf_scenario *out,
                                       struct wf_err *e)
{
    bool spring = asked->method && !strcmp(asked->method, "root-stiffness");
    struct wf_anchorage_request *q = WF_TAKE(a, 1, struct wf_anchorage_request);
    if (!q) return wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
    *q = (struct wf_anchorage_request){ .method = spring ? NULL : asked->method,
                                        .soil = asked->soil,
                                        .rooting = asked->rooting,
                                        .pull_moment = asked->pull_moment,
                                        .secant = spring ? root_stiffness : asked->secant };
    out->anchorage = q;
    enum wf_status s = check_sources(asked, root_stiffness, e);
    if (!s && asked->curve) s = wf_tipping_curve_read(asked->curve, a, d, &q->curve, e);
    if (!s && asked->table) s = wf_anchorage_table_read(asked->table, a, d, &q->table, e);
    return s;
}

bool wf_pages_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_pages *p = (const void *)((const char *)options + o->group);
    return wf_option_unused(p->none, why, "without a page");
}

bool wf_docx_row_wrong(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_pages *p = (const void *)((const char *)options + o->group);
    struct wf_err e = { 0 };
    return p->docx && wf_option_unused(wf_docx_possible(&e) != WF_OK, why, "%s", e.text);
}

bool wf_template_row_wrong(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_pages *p = (const void *)((const char *)options + o->group);
    struct wf_err e = { 0 };
    return p->templates && wf_option_unused(wf_template_check(p->templates, &e) != WF_OK, why, "%s", e.text);
}

static double metres(const char *unit)
{
    if (!unit) return (double)NAN;
    return unit[0] == 'c' ? 0.01 : unit[1] == 'm' ? 0.001 : 1;
}

/* Options of an import by the program: MATLAB files are read in another process. */
static struct wf_import_options scan_options(const struct wf_scan_asked *scan)
{
    struct wf_import_options o = wf_import_default();
    o.mat = wf_read_mat;
    o.tree_id = scan->tree_id;
    o.scan_model = scan->scan_model;
    o.force = scan->force;
    o.cap_children = scan->cap_children;
    return o;
}

struct wf_import_options wf_import_asked_options(const struct wf_import_asked *asked)
{
    struct wf_import_options o = scan_options(&asked->scan);
    o.format = asked->format;
    o.strict = asked->strict;
    o.length_unit = metres(asked->length_unit);
    o.diameter_unit = metres(asked->diameter_unit);
    return o;
}

enum wf_joint wf_joint_named(const char *word)
{
    return strcmp(word, "axis") ? WF_JOINT_BRIDGE : WF_JOINT_AXIS;
}

int wf_tree_asked_check(const struct wf_tree_asked *t, const char *command, const char *file)
{
    const char *wrong = NULL;
    int given = (t->model != NULL) + (t->file != NULL) + (file != NULL);
    if (!given) wrong = "--model is needed, for example --model models/culm.yaml";
    if (given > 1) wrong = "more than one tree is given (--model, --tree); one is taken";
    if (wrong) wf_show(stderr, "windfirm %s: %s\n", command, wrong);
    return wrong ? 2 : -1;
}

/* The crown specified on the command line, in place of what the model says of the same thing. */
static enum wf_status take_crown(const struct wf_tree_asked *t, struct wf_arena *a, struct wf_silhouette *out,
                                 struct wf_diag *d, struct wf_err *e)
{
    const struct wf_silhouette *c = &t->crown;
    bool area = c->area > 0 || c->width > 0 || c->depth > 0 || t->outline;
    if (area) out->area = c->area, out->width = c->width, out->depth = c->depth, out->points = 0;
    bool heavy = c->mass > 0 || c->density > 0 || c->by;
    if (heavy) out->mass = c->mass, out->density = c->density, out->by = c->by;
    if (c->by && wf_crown_rule_check(c->by, e)) return e->code;
    if (!isnan(c->leafless)) out->leafless = c->leafless;
    for (int k = 0; t->crown_form && wf_crown_form_words[k]; k++)
        if (!strcmp(t->crown_form, wf_crown_form_words[k])) out->form = (enum wf_crown_form)k;
    enum wf_status s = WF_OK;
    if (is_svg(t->outline))
        s = wf_outline_svg_read(t->outline, t->outline_base, t->outline_top, out, a, e);
    else if (t->outline)
        s = wf_outline_read(t->outline, out, a, d, e);
    if (s) return s;
    if (t->crown_form && !(out->width > 0))
        return wf_fail(e, WF_EUSAGE, "--crown-form needs --crown-width and --crown-depth");
    return area || heavy ? wf_silhouette_check(out, e) : WF_OK;
}

/* Bark and cavities of the command line, in place of the model's. */
static enum wf_status take_hollow(const struct wf_tree_asked *t, struct wf_arena *a, struct wf_model *out,
                                  struct wf_diag *d, struct wf_err *e)
{
    struct wf_err why = { 0 };
    if (t->bark && !wf_bark_read(t->bark, &out->bark, &why))
        return wf_fail(e, WF_EUSAGE, "--bark: %s", why.text);
    return t->cavities ? wf_cavities_asked(t->cavities, a, &out->cavity, &out->cavities, d, e) : WF_OK;
}

enum wf_status wf_tree_asked_onto(const struct wf_tree_asked *t, bool imported, struct wf_arena *a,
                                  struct wf_model *out, struct wf_diag *d, struct wf_err *e)
{
    double area = t->leaf_area;
    if (!isnan(area)) {
        if (!imported && !(out->leaf_area_on > 0) && area > 0)
            return wf_fail(e, WF_EUSAGE, "--leaf-area: the model %s does not say where its leaves are",
                           out->key);
        out->leaf_area_on = area;
    }
    bool off = t->season ? !strcmp(t->season, "leaf_off") : out->season == WF_LEAF_OFF;
    if (off && area > 0)
        return wf_fail(e, WF_EUSAGE,
                       "--leaf-area: has no effect when the leaves have fallen (season leaf_off)");
    if (!off && !isnan(t->crown.leafless))
        return wf_fail(e, WF_EUSAGE, "--leaf-off-share: has no effect in leaf (season leaf_on)");
    wf_model_set_season(out, off ? WF_LEAF_OFF : WF_LEAF_ON);
    if (t->scanned) out->scanned = strcmp(t->scanned, "leaf_off") ? WF_SCANNED_LEAF_ON : WF_SCANNED_LEAF_OFF;
    if (t->rest) out->shape = strcmp(t->rest, "stress-free") ? WF_SHAPE_UNDER_WEIGHT : WF_SHAPE_STRESS_FREE;
    if (t->unload && t->rest)
        return wf_fail(e, WF_EUSAGE, "give one of --rest and --unload: --unload takes the stress-free shape");
    if (t->unload) out->shape = WF_SHAPE_UNLOADED;
    out->stands_strictly = t->strict;
    enum wf_status s = take_hollow(t, a, out, d, e);
    return s ? s : take_crown(t, a, &out->silhouette, d, e);
}

enum wf_status wf_tree_asked_read(const struct wf_tree_asked *t, const char *file, struct wf_arena *a,
                                  struct wf_model *out, const char **path, struct wf_diag *d,
                                  struct wf_err *e)
{
    const char *tree = file ? file : t->file;
    enum wf_status s;
    if (tree) {
        *path = tree;
        struct wf_model *scan = NULL;
        struct wf_import_options o = scan_options(&t->scan);
        if (!(s = wf_model_imported(tree, t->joint, &o, a, &scan, d, e))) *out = *scan;
    } else {
        s = wf_shipped("models", t->model, a, path, d, e);
        if (!s) s = wf_model_read(*path, a, out, d, e);
    }
    return s ? s : wf_tree_asked_onto(t, tree != NULL, a, out, d, e);
}

/* ---- What is done to a tree ---- */

bool wf_reduction_read(const char *text, struct wf_reduced *out)
{
    double v;
    const char *unit = text ? wf_number_read(text, text + strlen(text), '.', &v) : NULL;
    if (!unit) return !text;
    unit += strspn(unit, " ");
    if (!strcmp(unit, "%")) out->share = v / 100;
    if (!strcmp(unit, "m")) out->length = v;
    return (out->share > 0 && out->share <= 0.9) || (out->length > 0 && out->length <= 50);
}

/* ---- Roots that are lost ---- */

/* A number with one of two units; without one it is of the second where that is NULL. */
static bool read_part(const char *text, const char *unit, double per, double *out)
{
    const char *end = wf_number_read(text, text + strlen(text), '.', out);
    if (!end) return false;
    end += strspn(end, " ");
    if (!*end) return true;
    *out /= per;
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

bool wf_root_loss_read(const char *text, struct wf_anchorage_request *q)
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
    if (n != 2 && !read_part(part[n - 1], "%", 100, &q->lost)) return false;
    if (n > 1) {
        if (!read_part(part[0], "deg", 1, &from) || !read_part(part[1], "deg", 1, &to)) return false;
        if (!(fabs(from) <= 360 && fabs(to) <= 360)) return false;
        double width = to - from > 0 ? to - from : to - from + 360;
        if (from == to || !(width > 0 && width <= 360)) return false;
        q->lost_half = 0.5 * width * degree, q->lost_middle = (from + 0.5 * width) * degree;
    }
    return q->lost > 0 && q->lost <= (q->lost_half < WF_PI ? 1 : 0.95);
}
