/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/read.h"
#include "base/err.h"
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include "cases/gusts.h"
#include "cases/keys.h"
#include "cases/measure.h"
#include "solve/solve.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Checks of a complete case: missing keys, keys that exclude each other. */

static bool key_given(const struct wf_case *c, const char *key)
{
    return c->given[wf_case_key_index(key)] != 0;
}

struct case_checking {
    struct wf_case *c;
    struct wf_diag *d;
};

__attribute__((format(printf, 3, 4))) static void case_wrong(struct case_checking *k, size_t line,
                                                             const char *fmt, ...)
{
    char text[512];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    k->c->faulty = true;
    wf_diag_error(k->d, k->c->file, line, 1, "%s: %s", k->c->name ? k->c->name : "case", text);
}

static void case_needs(struct case_checking *k, bool there, const char *what)
{
    if (!there) case_wrong(k, k->c->line, "%s is missing", what);
}

static void case_excludes(struct case_checking *k, const char *a, const char *b)
{
    if (key_given(k->c, a) && key_given(k->c, b))
        case_wrong(k, k->c->given[wf_case_key_index(b)], "'%s' and '%s' exclude each other", a, b);
}

/* Section and material: from radii and moduli, or stiffnesses given directly. */
static void check_section(struct case_checking *k)
{
    struct wf_case *c = k->c;
    bool straight = c->shape == WF_SHAPE_CANTILEVER || c->shape == WF_SHAPE_ARC;
    bool direct = key_given(c, "EI"), all = key_given(c, "EA") || key_given(c, "GA") || key_given(c, "GJ");
    case_excludes(k, "EI", "youngs_modulus");
    case_excludes(k, "poisson", "shear_modulus");
    case_excludes(k, "mass_per_length", "density");
    case_excludes(k, "taper", "inner_radius");
    if ((direct || all || key_given(c, "taper") || key_given(c, "mass_per_length") ||
         key_given(c, "radius") || key_given(c, "inner_radius")) &&
        !straight)
        case_wrong(k, c->line,
                   "radius, taper, EI, EA, GA, GJ and mass_per_length apply only to a cantilever or an arc");
    if (all && !(direct && key_given(c, "EA") && key_given(c, "GA") && key_given(c, "GJ")))
        case_wrong(k, c->line, "give EI alone or all four of EA, GA, EI, GJ");
    if (all && (key_given(c, "taper") || c->radius[0] != c->radius[1]) && key_given(c, "radius"))
        case_wrong(k, c->line,
                   "given stiffnesses EA, GA, EI, GJ are constant; taper cannot be combined with them");
    if (key_given(c, "taper") && key_given(c, "radius") && c->radius[1] != c->radius[0])
        case_wrong(k, c->line, "give the tip radius or 'taper', not both");
    if (straight) case_needs(k, direct || key_given(c, "radius"), "radius (or EI)");
    case_needs(k, direct || key_given(c, "youngs_modulus"), "youngs_modulus (or EI of a cantilever)");
    case_needs(k, direct || key_given(c, "poisson") || key_given(c, "shear_modulus"),
               "poisson or shear_modulus");
    for (int i = 0; i < 2; i++)
        if (c->inner[i] >= c->radius[i]) case_wrong(k, c->line, "inner_radius must be smaller than radius");
    if (c->model == WF_MODEL_SR && !all)
        case_needs(k, key_given(c, "shear_factor"), "shear_factor (model SR)");
}

static void check_case_loads(struct case_checking *k)
{
    struct wf_case *c = k->c;
    bool straight = c->shape == WF_SHAPE_CANTILEVER || c->shape == WF_SHAPE_ARC;
    bool massive = key_given(c, "density") || key_given(c, "mass_per_length");
    case_excludes(k, "weight_parameter", "gravity");
    case_excludes(k, "cauchy", "air_density");
    if ((key_given(c, "cauchy") || key_given(c, "weight_parameter") || key_given(c, "line_load_by_radius")) &&
        !straight)
        case_wrong(k, c->line,
                   "cauchy, weight_parameter and line_load_by_radius apply only to a cantilever or an arc");
    case_excludes(k, "axis_drag", "drag_coefficient");
    case_excludes(k, "axis_drag", "cauchy");
    if ((key_given(c, "wind") && !key_given(c, "axis_drag")) || key_given(c, "cauchy"))
        case_needs(k, key_given(c, "drag_coefficient"), "drag_coefficient (wind)");
    if (key_given(c, "wind") && !key_given(c, "cauchy"))
        case_needs(k, key_given(c, "air_density"), "air_density (wind)");
    if (key_given(c, "gravity") && c->gravity != 0.0)
        case_needs(k, massive, "density or mass_per_length (gravity)");
}

static void check_place(struct case_checking *k, const struct wf_place *p, size_t line)
{
    enum wf_case_shape s = k->c->shape;
    if (p->kind == WF_PLACE_TIP && s != WF_SHAPE_CANTILEVER && s != WF_SHAPE_ARC)
        case_wrong(k, line, "'tip' is the end of a cantilever or arc; name a node or row");
    if (p->kind == WF_PLACE_AT && s != WF_SHAPE_CANTILEVER && s != WF_SHAPE_ARC)
        case_wrong(k, line, "'at' is a place of a cantilever or arc; name a node or row");
    if ((p->kind == WF_PLACE_NODE || p->kind == WF_PLACE_ROW) && s != WF_SHAPE_BRANCHES && s != WF_SHAPE_TREE)
        case_wrong(k, line, "nodes and rows belong to trees; use tip, base or at");
}

/* Can the case's structure answer the want? */
static void check_answer(struct case_checking *k, const struct wf_want *w)
{
    static const struct {
        enum wf_answer by;
        enum wf_case_shape shape;
        const char *text;
    } own[] = { { WF_BY_FLOW, WF_SHAPE_FLOW, "a flow" },
                { WF_BY_FIT, WF_SHAPE_FIT, "a fit" },
                { WF_BY_GUST, WF_SHAPE_GUST, "a gust rule" } };
    const struct wf_case *c = k->c;
    enum wf_answer by = w->quantity->by;
    const char *of = "a structure", *missing = NULL;
    bool can = by != WF_BY_STAND || c->shape == WF_SHAPE_CANTILEVER;
    if (!can) of = "anything but a cantilever";
    for (size_t i = 0; i < WF_COUNT(own); i++) {
        can &= (by == own[i].by) == (c->shape == own[i].shape);
        if (c->shape == own[i].shape) of = own[i].text;
    }
    if (!can) case_wrong(k, w->line, "'%s' cannot be wanted of %s", w->quantity->name, of);
    if (can && (by == WF_BY_GUST || by == WF_BY_STAND)) missing = wf_gust_missing(c, w->quantity->name);
    if (missing) case_wrong(k, w->line, "%s is missing ('%s' is wanted)", missing, w->quantity->name);
}

/* Crown and taper of a cantilever that is a stem. */
static void check_stem(struct case_checking *k)
{
    const struct wf_case *c = k->c;
    bool crown = key_given(c, "crown_depth");
    case_excludes(k, "taper", "taper_power");
    case_excludes(k, "inner_radius", "taper_power");
    case_excludes(k, "crown_area", "crown_depth");
    if ((crown || key_given(c, "taper_power")) && c->shape != WF_SHAPE_CANTILEVER)
        case_wrong(k, c->line, "taper_power and crown_depth apply only to a cantilever");
    if (crown)
        case_needs(k, key_given(c, "crown_width") && key_given(c, "crown_drag") && key_given(c, "crown_mass"),
                   "crown_width, crown_drag and crown_mass (crown_depth)");
    if (crown && c->shape == WF_SHAPE_CANTILEVER && c->gust.crown_depth > c->length)
        case_wrong(k, c->given[wf_case_key_index("crown_depth")], "the crown is longer than the stem");
}

static void check_wants(struct case_checking *k)
{
    struct wf_case *c = k->c;
    struct wf_want *w = c->wants.data;
    bool by_solver = false;
    case_needs(k, c->wants.n > 0, "a wanted value ('want ...')");
    for (size_t i = 0; i < c->wants.n; i++) {
        enum wf_answer by = w[i].quantity->by;
        by_solver |= by == WF_BY_SOLVER;
        check_answer(k, &w[i]);
        if (by == WF_BY_MODES || by == WF_BY_BUCKLING)
            if (!key_given(c, "density") && !key_given(c, "mass_per_length") &&
                !key_given(c, "weight_parameter"))
                case_wrong(k, w[i].line, "'%s' needs density, mass_per_length or weight_parameter",
                           w[i].quantity->name);
        if (isnan(w[i].tolerance)) w[i].tolerance = c->tolerance;
        check_place(k, &w[i].at, w[i].line);
    }
    if (by_solver && !c->solvers) c->solver[c->solvers++] = wf_solvers[0];
    for (size_t i = 0; i < c->solvers; i++)
        if (c->solver[i]->clamped && (c->spring[0] > 0.0 || c->spring[1] > 0.0))
            case_wrong(
                k, c->line,
                "a spring at the base ('support') has no effect with the solver '%s', which clamps the base",
                c->solver[i]->name);
    if (!by_solver && c->given[wf_case_key_index("solver")] > c->line)
        case_wrong(k, c->line, "'solver' is given, but no wanted value needs one");
    if (!by_solver) c->solvers = 0;
}

/* Set defaults that depend on other keys (tolerance of each want, solver) and report what is missing or
 * contradictory, at the case's line. */
static void case_check(struct wf_case *c, struct wf_diag *d)
{
    struct case_checking k = { c, d };
    if (c->faulty) return; /* its errors are already reported; follow-up errors would only confuse */
    case_needs(&k, c->kind >= 0, "kind");
    case_needs(&k, c->source != NULL, "source");
    case_needs(&k, c->shape != WF_SHAPE_NONE,
               "a structure (cantilever, arc, node and branch, tree, flow, gust_rule or fit)");
    if (c->shape == WF_SHAPE_BRANCHES) case_needs(&k, c->branches.n > 0, "a branch");
    if (c->shape == WF_SHAPE_NONE) return;
    if (c->shape == WF_SHAPE_FLOW)
        case_needs(&k, !wf_flow_missing(c), wf_flow_missing(c));
    else if (c->shape != WF_SHAPE_FIT && c->shape != WF_SHAPE_GUST)
        check_section(&k), check_stem(&k), check_case_loads(&k);
    const struct wf_case_load *l = c->loads.data;
    for (size_t i = 0; i < c->loads.n; i++) check_place(&k, &l[i].at, l[i].line);
    const struct wf_case_mass *m = c->masses.data;
    for (size_t i = 0; i < c->masses.n; i++) check_place(&k, &m[i].at, m[i].line);
    check_wants(&k);
}

/* From lines to cases. Lines above the first `case` apply to every case of the file. */

static const char *const kind_names[WF_CASE_KIND_COUNT] = {
    [WF_CASE_CLOSED_FORM] = "closed-form",
    [WF_CASE_PUBLISHED] = "published",
    [WF_CASE_COMPUTED_REFERENCE] = "computed-reference",
    [WF_CASE_FIELD] = "field",
    [WF_CASE_REGRESSION] = "regression",
};

const char *wf_case_kind_name(enum wf_case_kind k)
{
    return (unsigned)k < WF_CASE_KIND_COUNT ? kind_names[k] : "unknown";
}

struct case_reader {
    struct wf_words w;
    struct wf_case common, now;
    bool in_case;
    struct wf_list cases;
};

static bool copy_list(struct wf_list *l, size_t size, struct wf_arena *a)
{
    void *data = wf_arena_take(a, l->n, size);
    if (data && l->n) memcpy(data, l->data, l->n * size);
    l->data = data;
    l->room = l->n;
    return data != NULL;
}

/* A copy with its own lists, because both will be appended to. */
static bool copy_case(const struct wf_case *c, struct wf_case *out, struct wf_arena *a)
{
    *out = *c;
    return copy_list(&out->nodes, sizeof(struct wf_case_node), a) &&
           copy_list(&out->branches, sizeof(struct wf_case_branch), a) &&
           copy_list(&out->loads, sizeof(struct wf_case_load), a) &&
           copy_list(&out->masses, sizeof(struct wf_case_mass), a) &&
           copy_list(&out->wants, sizeof(struct wf_want), a);
}

static bool close_case(struct case_reader *r)
{
    case_check(&r->now, r->w.diag);
    return wf_list_add(&r->cases, &r->now, sizeof r->now, r->w.arena) ||
           wf_words_wrong(&r->w, 0, "no memory");
}

static void begin_case(struct case_reader *r)
{
    if (r->in_case) (void)close_case(r);
    if (!copy_case(&r->common, &r->now, r->w.arena)) (void)wf_words_wrong(&r->w, 0, "no memory");
    r->now.line = r->w.line;
    r->in_case = true;
    r->now.name = r->w.n > 1 ? r->w.word[1] : "";
    if (r->w.n < 2) (void)wf_words_wrong(&r->w, r->w.n, "the name of the case is missing");
    if (r->w.n > 2) (void)wf_words_wrong(&r->w, 2, "a name is one word; write more in 'title' or 'note'");
    const struct wf_case *other = r->cases.data;
    for (size_t i = 0; i < r->cases.n; i++)
        if (!strcmp(other[i].name, r->now.name))
            (void)wf_words_wrong(&r->w, 1, "case '%s' is already defined on line %zu", r->now.name,
                                 other[i].line);
}

static void unknown_key(struct wf_words *w)
{
    const char *names[WF_CASE_KEYS_MAX + 1];
    size_t n = 0;
    for (; wf_case_keys[n].name; n++) names[n] = wf_case_keys[n].name;
    names[n++] = "case";
    wf_diag_error(w->diag, w->file, w->line, w->column[0], "unknown key '%s'%s", w->key,
                  wf_did_you_mean(w->key, names, n).text);
}

static void read_line(struct case_reader *r, const char *text, size_t length)
{
    struct wf_words *w = &r->w;
    struct wf_case *c = r->in_case ? &r->now : &r->common;
    if (!wf_words_split(w, text, length) || !w->n) return;
    if (!strcmp(w->key, "case")) {
        begin_case(r);
        return;
    }
    size_t k = wf_case_key_index(w->key);
    const struct wf_case_key *key = &wf_case_keys[k];
    if (!key->name) {
        unknown_key(w);
        return;
    }
    if (!key->repeats && c->given[k] >= c->line && c->given[k]) {
        (void)wf_words_wrong(w, 0, "given twice; first on line %zu", c->given[k]);
        return;
    }
    if (!key->read(w, c, key)) c->faulty = true;
    c->given[k] = w->line;
    if (!strcmp(w->key, "units")) w->plain = c->nondimensional != 0;
    if (!strcmp(w->key, "units") && (r->in_case || c->wants.n))
        (void)wf_words_wrong(
            w, 0, "must come before the first case and the first wanted value: it applies to the whole file");
}

static const char *stem_of(const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(path, '/');
    char *name = wf_arena_text(a, slash ? slash + 1 : path);
    char *dot = name ? strrchr(name, '.') : NULL;
    if (dot) *dot = '\0';
    return name;
}

static enum wf_status read_lines(struct case_reader *r, const struct wf_bytes *text)
{
    const char *s = text->data, *end = s + text->size;
    while (s < end) {
        const char *newline = memchr(s, '\n', (size_t)(end - s)), *stop = newline ? newline : end;
        r->w.line++;
        read_line(r, s, (size_t)(stop - s));
        s = stop + 1;
    }
    if (!r->in_case) { /* a file without `case` lines is one case */
        r->now = r->common;
        r->now.name = stem_of(r->w.file, r->w.arena);
        if (!r->now.name) return WF_ENOMEM;
    }
    return close_case(r) ? WF_OK : WF_ENOMEM;
}

enum wf_status wf_case_read(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_case **list,
                            size_t *n, struct wf_err *e)
{
    struct wf_bytes text;
    struct case_reader r = { .w = { .file = path, .arena = a, .diag = d } };
    size_t errors = d->errors;
    *list = NULL;
    *n = 0;
    if (wf_file_read_text(path, a, &text, e)) return e->code;
    if (text.size > 16 * 1024 * 1024)
        return wf_fail(e, WF_EINPUT, "%s: too long for a validation case", path);
    wf_case_default(&r.common);
    r.common.file = path;
    r.common.line = 1;
    if (wf_units_open(&r.w.units, e)) return e->code;
    enum wf_status status = read_lines(&r, &text);
    wf_units_close(r.w.units);
    if (status) return wf_fail(e, status, "%s: no memory", path);
    *list = r.cases.data;
    *n = r.cases.n;
    if (d->errors > errors)
        return wf_fail(e, WF_EINPUT, "%s: %zu mistake%s", path, d->errors - errors,
                       d->errors - errors == 1 ? "" : "s");
    return WF_OK;
}
