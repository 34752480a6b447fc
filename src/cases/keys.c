/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/keys.h"
#include "base/num.h"
#include "cases/measure.h"
#include "load/drag.h"
#include "solve/chain.h"
#include "solve/solve.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* Readers of keys: each takes the words of its line; false after reporting a mistake. This section: text,
 * numbers, structure, support. */

static void *key_field(struct wf_case *c, const struct wf_case_key *k) { return (char *)c + k->offset; }

/* prose; a repeated key continues it */
static bool key_text(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    const char **text = key_field(c, k), *joined = w->rest;
    if (!*w->rest) return wf_words_wrong(w, w->n, "text is expected");
    bool continues = *text && c->given[k - wf_case_keys] >= c->line;
    if (continues) joined = wf_arena_print(w->arena, "%s %s", *text, w->rest);
    if (!joined) return wf_words_wrong(w, 1, "no memory");
    *text = joined;
    return true;
}

/* one word of k->choices */
static bool key_choice(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    const char *word[8];
    char *all = wf_arena_text(w->arena, k->choices), *save = NULL;
    size_t n = 0, chosen;
    if (!all) return wf_words_wrong(w, 1, "no memory");
    for (char *s = strtok_r(all, "|", &save); s && n < 8; s = strtok_r(NULL, "|", &save)) word[n++] = s;
    if (!wf_words_choice(w, "word", word, n, &chosen) || !wf_words_end(w)) return false;
    *(int *)key_field(c, k) = (int)chosen;
    return true;
}

/* k->count_low..k->count numbers and a unit, within k->low..k->high */
static bool key_numbers(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    double v[3];
    size_t n, at = w->next;
    if (!wf_words_quantities(w, k->dimension, k->count_low, k->count, false, NULL, v, &n, NULL) ||
        !wf_words_end(w))
        return false;
    for (size_t i = 0; i < n; i++)
        if (v[i] < k->low || v[i] > k->high)
            return wf_words_wrong(w, at + i, "'%s' is outside the allowed range %g to %g", w->word[at + i],
                                  k->low, k->high);
    for (size_t i = 0; i < k->count; i++) ((double *)key_field(c, k))[i] = v[i < n ? i : 0];
    return true;
}

/* A case has one structure. */
static bool set_case_shape(struct wf_words *w, struct wf_case *c, enum wf_case_shape s)
{
    if (c->shape != WF_SHAPE_NONE && c->shape != s)
        return wf_words_wrong(
            w, 0,
            "the case already has another structure (cantilever, arc, node/branch, tree, flow or gust_rule)");
    c->shape = s;
    return true;
}

/* LENGTH */
static bool key_cantilever(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    size_t n;
    if (!set_case_shape(w, c, WF_SHAPE_CANTILEVER) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 1, 1, false, NULL, &c->length, &n, NULL) || !wf_words_end(w))
        return false;
    return c->length > 0.0 || wf_words_wrong(w, 1, "a length must be positive");
}

static bool vector_after(struct wf_words *w, const char *word, double out[3])
{
    if (!wf_words_skip(w, word)) return wf_words_wrong(w, w->next, "'%s X Y Z' is expected here", word);
    for (int i = 0; i < 3; i++)
        if (!wf_words_number(w, word, &out[i])) return false;
    return true;
}

/* RADIUS UNIT ANGLE UNIT from X Y Z towards X Y Z */
static bool key_arc(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    size_t n;
    if (!set_case_shape(w, c, WF_SHAPE_ARC) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 1, 1, false, "angle", &c->arc[0], &n, NULL))
        return false;
    if (!wf_words_skip(w, "angle"))
        return wf_words_wrong(w, w->n, "'angle NUMBER UNIT' is expected after the radius");
    if (!wf_words_quantities(w, WF_DIM_ANGLE, 1, 1, false, "from", &c->arc[1], &n, NULL) ||
        !vector_after(w, "from", c->arc_from) || !vector_after(w, "towards", c->arc_towards) ||
        !wf_words_end(w))
        return false;
    if (c->arc[0] <= 0.0 || c->arc[1] <= 0.0 || c->arc[1] > 6.2831)
        return wf_words_wrong(w, 1, "the radius must be positive and the angle between 0 and a full turn");
    double dot = 0.0, ff = 0.0, tt = 0.0;
    for (int i = 0; i < 3; i++) {
        dot += c->arc_from[i] * c->arc_towards[i];
        ff += c->arc_from[i] * c->arc_from[i];
        tt += c->arc_towards[i] * c->arc_towards[i];
    }
    if (!(ff > 0.0 && tt > 0.0 && fabs(dot) <= 1e-12 * sqrt(ff * tt)))
        return wf_words_wrong(w, 1, "'from' (root tangent) and 'towards' must be perpendicular");
    return true;
}

/* ID X Y Z UNIT */
static bool key_node(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_node node = { .line = w->line };
    long long id;
    size_t n;
    if (!set_case_shape(w, c, WF_SHAPE_BRANCHES) || !wf_words_whole(w, "node", 0, INT64_MAX, &id) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 3, 3, false, NULL, node.x, &n, NULL))
        return false;
    node.id = id;
    const struct wf_case_node *other = c->nodes.data;
    for (size_t i = 0; i < c->nodes.n; i++)
        if (other[i].id == id)
            return wf_words_wrong(w, 1, "node %lld was given on line %zu", id, other[i].line);
    return wf_list_add(&c->nodes, &node, sizeof node, w->arena) || wf_words_wrong(w, 1, "no memory");
}

static const struct wf_case_node *node_named(const struct wf_case *c, long long id)
{
    const struct wf_case_node *node = c->nodes.data;
    for (size_t i = 0; i < c->nodes.n; i++)
        if (node[i].id == id) return &node[i];
    return NULL;
}

/* FROM TO RADIUS RADIUS UNIT */
static bool key_branch(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_branch b = { .line = w->line };
    long long end[2];
    size_t n;
    if (!set_case_shape(w, c, WF_SHAPE_BRANCHES)) return false;
    for (int i = 0; i < 2; i++) {
        if (!wf_words_whole(w, "node", 0, INT64_MAX, &end[i])) return false;
        if (!node_named(c, end[i]))
            return wf_words_wrong(w, w->next - 1, "there is no node %lld above this line", end[i]);
    }
    b.from = end[0];
    b.to = end[1];
    if (!wf_words_quantities(w, WF_DIM_LENGTH, 2, 2, false, NULL, b.radius, &n, NULL)) return false;
    if (b.radius[0] <= 0.0 || b.radius[1] <= 0.0) return wf_words_wrong(w, 3, "a radius must be positive");
    const struct wf_case_branch *other = c->branches.data;
    bool reached = c->branches.n == 0;
    for (size_t i = 0; i < c->branches.n; i++) {
        reached |= other[i].to == b.from || other[i].from == b.from;
        if (other[i].to == b.to || other[i].from == b.to)
            return wf_words_wrong(w, 2, "node %lld is already reached by line %zu", end[1], other[i].line);
    }
    if (!reached)
        return wf_words_wrong(w, 1, "no branch above this line reaches node %lld; begin at the ground",
                              end[0]);
    return wf_list_add(&c->branches, &b, sizeof b, w->arena) || wf_words_wrong(w, 1, "no memory");
}

/* FILE.csv */
static bool key_tree(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (!set_case_shape(w, c, WF_SHAPE_TREE)) return false;
    if (!wf_words_peek(w))
        return wf_words_wrong(w, w->n, "the name of a tree file beside the case is expected");
    c->tree_file = w->word[w->next++];
    return wf_words_end(w);
}

/* Parameters of a law, each after its name, in the order of the law's row. */
static bool law_parameters(struct wf_words *w, const struct wf_law *l, struct wf_law_values *out)
{
    for (size_t k = 0, n = wf_law_count(l), got; k < n; k++) {
        const struct wf_law_parameter *p = &l->parameter[k];
        bool list = p->kind == WF_LAW_LIST;
        double *v = wf_arena_take(w->arena, WF_WORDS_MAX, sizeof *v);
        if (!v) return wf_words_wrong(w, 1, "no memory");
        if (!wf_words_skip(w, p->name))
            return wf_words_wrong(w, w->next, "'%s NUMBER' is expected here", p->name);
        size_t at = w->next;
        if (!wf_words_quantities(w, p->dimension, 1, list ? WF_WORDS_MAX : 1, false, p[1].name, v, &got,
                                 NULL))
            return false;
        for (size_t i = 0; i < got; i++)
            if (v[i] < p->low || v[i] > p->high)
                return wf_words_wrong(w, at + i, "'%s' is outside the allowed range %g to %g",
                                      w->word[at + i], p->low, p->high);
        if (list && out->n && out->n != got)
            return wf_words_wrong(w, at, "%zu numbers, but the list before has %zu", got, out->n);
        if (list)
            out->list[k] = v, out->n = got;
        else
            out->number[k] = *v;
    }
    return wf_words_end(w);
}

/* LAW [PARAMETER NUMBER UNIT]... */
static bool key_law(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    enum { MOST = 24 };
    bool axis = !strcmp(k->name, "axis_drag");
    const char *known[MOST];
    size_t n = 0, chosen;
    for (const struct wf_law *l;
         n < MOST && (l = wf_law_row(axis ? wf_laws.axis_drag : wf_laws.streamlining, n)); n++)
        known[n] = l->name;
    if (!wf_words_choice(w, "law", known, n, &chosen)) return false;
    if (!axis) {
        c->streamlining = &wf_streamline_laws[chosen];
        return law_parameters(w, &c->streamlining->law, &c->streamlining_par);
    }
    c->axis_drag = &wf_axis_drag_laws[chosen];
    return law_parameters(w, &c->axis_drag->law, &c->axis_drag_par);
}

/* clamped | spring ABOUT_X [ABOUT_Y] UNIT */
static bool key_support(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "clamped", "spring" };
    size_t kind, n;
    if (!wf_words_choice(w, "support", known, 2, &kind)) return false;
    c->spring[0] = c->spring[1] = 0.0;
    if (kind == 0) return wf_words_end(w);
    if (!wf_words_quantities(w, WF_DIM_ROTATIONAL_STIFFNESS, 1, 2, false, NULL, c->spring, &n, NULL))
        return false;
    if (n == 1) c->spring[1] = c->spring[0];
    if (c->spring[0] <= 0.0 || c->spring[1] <= 0.0)
        return wf_words_wrong(w, 2, "a spring stiffness must be positive");
    return true;
}

/* cylinder | line-source | point-source | finite-line-source */
static bool key_flow(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "cylinder", "line-source", "point-source", "finite-line-source" };
    size_t kind;
    if (!set_case_shape(w, c, WF_SHAPE_FLOW) || !wf_words_choice(w, "flow", known, 4, &kind) ||
        !wf_words_end(w))
        return false;
    c->flow = known[kind];
    return true;
}

/* en1991 | gb50009 | asce7 */
static bool key_gust_rule(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    enum { MOST = 8 };
    const char *known[MOST];
    size_t n = 0, rule;
    (void)k;
    while (n < MOST && wf_gust_rules[n].name) known[n] = wf_gust_rules[n].name, n++;
    if (!set_case_shape(w, c, WF_SHAPE_GUST) || !wf_words_choice(w, "gust rule", known, n, &rule))
        return false;
    c->gust.rule = &wf_gust_rules[rule];
    return wf_words_end(w);
}

/* 0 | I | II | III | IV */
static bool key_terrain(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    enum { MOST = 8 };
    const char *known[MOST];
    size_t n = 0, category;
    (void)k;
    while (n < MOST && wf_categories[n].name) known[n] = wf_categories[n].name, n++;
    if (!wf_words_choice(w, "terrain", known, n, &category)) return false;
    c->gust.terrain = &wf_categories[category];
    return wf_words_end(w);
}

/* Readers of keys: loads, solvers, fits and wanted values. */

/* force|moment|follower PLACE X Y Z UNIT */
static bool key_point(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    struct wf_case_load l = { .line = w->line };
    size_t n;
    l.moment = !strcmp(k->name, "moment");
    l.follower = !strcmp(k->name, "follower");
    if (!wf_place_read(w, &l.at) || !wf_words_quantities(w, l.moment ? WF_DIM_MOMENT : WF_DIM_FORCE, 3, 3,
                                                         false, NULL, l.value, &n, NULL))
        return false;
    if (l.at.kind == WF_PLACE_BASE)
        return wf_words_wrong(w, 1, "the base is fixed; a load there has no effect");
    return wf_list_add(&c->loads, &l, sizeof l, w->arena) || wf_words_wrong(w, 1, "no memory");
}

/* PLACE MASS UNIT */
static bool key_mass(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_mass m = { .line = w->line };
    size_t n;
    if (!wf_place_read(w, &m.at) ||
        !wf_words_quantities(w, WF_DIM_MASS, 1, 1, false, NULL, &m.mass, &n, NULL))
        return false;
    if (m.at.kind == WF_PLACE_BASE)
        return wf_words_wrong(w, 1, "the base is fixed; a mass there has no effect");
    if (m.mass < 0.0) return wf_words_wrong(w, w->n - 1, "a mass must not be negative");
    return wf_list_add(&c->masses, &m, sizeof m, w->arena) || wf_words_wrong(w, 1, "no memory");
}

/* NAME... */
static bool key_solver(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    enum { KNOWN = 32 };
    const struct wf_solver *known[KNOWN];
    const char *name[KNOWN];
    size_t n = 0, chosen;
    for (size_t i = 0; n < KNOWN && wf_solvers[i]; i++) known[n++] = wf_solvers[i];
    for (size_t i = 0; n < KNOWN && wf_chain_variants[i]; i++) known[n++] = wf_chain_variants[i];
    for (size_t i = 0; i < n; i++) name[i] = known[i]->name;
    c->solvers = 0;
    do {
        if (c->solvers == WF_CASE_SOLVERS_MAX)
            return wf_words_wrong(w, w->next, "at most %d solvers", WF_CASE_SOLVERS_MAX);
        if (!wf_words_choice(w, "solver", name, n, &chosen)) return false;
        c->solver[c->solvers++] = known[chosen];
    } while (wf_words_peek(w));
    return true;
}

/* default | one-element-per-row | tolerance NUMBER */
static bool key_mesh(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "default", "one-element-per-row", "tolerance" };
    size_t kind;
    struct wf_solve_options o;
    wf_solve_options_default(&o);
    if (!wf_words_choice(w, "mesh", known, 3, &kind)) return false;
    c->mesh_tolerance = kind == 0 ? o.mesh_tolerance : 0.0;
    if (kind == 2) {
        if (!wf_words_number(w, "tolerance", &c->mesh_tolerance)) return false;
        if (!(c->mesh_tolerance > 0.0 && c->mesh_tolerance < 1.0))
            return wf_words_wrong(w, w->next - 1, "a mesh tolerance must be between 0 and 1");
    }
    return wf_words_end(w);
}

/* STUDY.yaml */
static bool key_fit(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (c->shape != WF_SHAPE_NONE && c->shape != WF_SHAPE_FIT)
        return wf_words_wrong(w, 0, "the case has a structure; a fit uses that of its study");
    if (!wf_words_peek(w))
        return wf_words_wrong(w, w->n,
                              "the name of a calibration study, from the case's folder, is expected");
    c->shape = WF_SHAPE_FIT;
    c->fit_calibration = w->word[w->next++];
    return wf_words_end(w);
}

/* NAME... */
static bool key_free(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (!*w->rest) return wf_words_wrong(w, w->n, "names of parameters are expected");
    c->fit_free = w->rest;
    w->next = w->n;
    return true;
}

/* PARTS PARTS... */
static bool key_order(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    long long parts, before = 0;
    for (c->pieces = 0; wf_words_peek(w); c->piece[c->pieces++] = (size_t)parts, before = parts) {
        if (c->pieces == WF_CASE_PIECES_MAX)
            return wf_words_wrong(w, w->next, "at most %d meshes", WF_CASE_PIECES_MAX);
        if (!wf_words_whole(w, "parts of a row", before + 1, 4096, &parts)) return false;
    }
    return c->pieces >= 2 ||
           wf_words_wrong(w, w->n, "at least two meshes are needed, for example: order 1 2 4 8");
}

/* see wf_want_read */
static bool key_want(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_want want;
    if (!wf_want_read(w, &want)) return false;
    return wf_list_add(&c->wants, &want, sizeof want, w->arena) || wf_words_wrong(w, 1, "no memory");
}

/* The rows. */

#define AT(field) offsetof(struct wf_case, field)
#define NUMBER(name, field, dim, lo, hi)                                                                     \
    {                                                                                                        \
        name, key_numbers, AT(field), dim, 1, 1, lo, hi, NULL, false                                         \
    }
#define PAIR(name, field, dim, lo, hi)                                                                       \
    {                                                                                                        \
        name, key_numbers, AT(field), dim, 1, 2, lo, hi, NULL, false                                         \
    }
#define VECTOR(name, field, dim)                                                                             \
    {                                                                                                        \
        name, key_numbers, AT(field), dim, 3, 3, -HUGE_VAL, HUGE_VAL, NULL, false                            \
    }
#define TEXT(name, field)                                                                                    \
    {                                                                                                        \
        name, key_text, AT(field), 0, 0, 0, 0, 0, NULL, true                                                 \
    }
#define CHOICE(name, field, words)                                                                           \
    {                                                                                                        \
        name, key_choice, AT(field), 0, 0, 0, 0, 0, words, false                                             \
    }
#define SPECIAL(name, reader, repeats)                                                                       \
    {                                                                                                        \
        name, reader, 0, 0, 0, 0, 0, 0, NULL, repeats                                                        \
    }
#define TINY 1e-300 /* positive */
#define VAST 1e300

const struct wf_case_key wf_case_keys[] = {
    /* what it is */
    TEXT("title", title),
    TEXT("source", source),
    TEXT("note", note),
    CHOICE("kind", kind, "closed-form|published|computed-reference|field|regression"),
    CHOICE("units", nondimensional, "si|none"),
    /* the structure */
    SPECIAL("cantilever", key_cantilever, false),
    NUMBER("rows", rows, WF_DIM_NONE, 1, 100000),
    VECTOR("direction", direction, WF_DIM_NONE),
    SPECIAL("arc", key_arc, false),
    SPECIAL("node", key_node, true),
    SPECIAL("branch", key_branch, true),
    SPECIAL("tree", key_tree, false),
    /* section and material */
    PAIR("radius", radius, WF_DIM_LENGTH, TINY, VAST),
    PAIR("inner_radius", inner, WF_DIM_LENGTH, 0, VAST),
    NUMBER("taper", taper, WF_DIM_NONE, TINY, 1),
    NUMBER("taper_power", taper_power, WF_DIM_NONE, TINY, 10),
    NUMBER("youngs_modulus", youngs, WF_DIM_PRESSURE, TINY, VAST),
    NUMBER("poisson", poisson, WF_DIM_NONE, -0.999, 0.5),
    NUMBER("shear_modulus", shear, WF_DIM_PRESSURE, TINY, VAST),
    NUMBER("density", density, WF_DIM_DENSITY, 0, VAST),
    NUMBER("EA", ea, WF_DIM_FORCE, TINY, VAST),
    NUMBER("GA", ga, WF_DIM_FORCE, TINY, VAST),
    NUMBER("EI", ei, WF_DIM_BENDING_STIFFNESS, TINY, VAST),
    NUMBER("GJ", gj, WF_DIM_BENDING_STIFFNESS, TINY, VAST),
    NUMBER("mass_per_length", mass_per_length, WF_DIM_MASS_PER_LENGTH, 0, VAST),
    CHOICE("model", model, "K|EB|SR"),
    NUMBER("shear_factor", shear_factor, WF_DIM_NONE, TINY, 2),
    SPECIAL("support", key_support, false),
    /* loads */
    SPECIAL("force", key_point, true),
    SPECIAL("moment", key_point, true),
    SPECIAL("follower", key_point, true),
    SPECIAL("mass", key_mass, true),
    VECTOR("line_load", line_load, WF_DIM_FORCE_PER_LENGTH),
    VECTOR("line_load_by_radius", line_by_radius, WF_DIM_FORCE_PER_LENGTH),
    VECTOR("wind", wind, WF_DIM_SPEED),
    NUMBER("air_density", air_density, WF_DIM_DENSITY, TINY, VAST),
    NUMBER("drag_coefficient", drag, WF_DIM_NONE, 0, 100),
    SPECIAL("axis_drag", key_law, false),
    SPECIAL("streamlining", key_law, false),
    NUMBER("crown_area", crown_area, WF_DIM_LENGTH, 0, VAST),
    NUMBER("air_viscosity", air_viscosity, WF_DIM_VISCOSITY, TINY, VAST),
    NUMBER("cauchy", cauchy, WF_DIM_NONE, 0, VAST),
    NUMBER("gravity", gravity, WF_DIM_ACCELERATION, -VAST, VAST),
    NUMBER("weight_parameter", weight_parameter, WF_DIM_NONE, -VAST, VAST),
    /* potential flow */
    SPECIAL("flow", key_flow, false),
    NUMBER("speed", flow_speed, WF_DIM_SPEED, -VAST, VAST),
    NUMBER("cylinder_radius", flow_radius, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("circulation", flow_circulation, WF_DIM_VISCOSITY, -VAST, VAST),
    NUMBER("strength", flow_strength, WF_DIM_NONE, -VAST, VAST),
    { "segment", key_numbers, AT(flow_segment), WF_DIM_LENGTH, 2, 2, -VAST, VAST, NULL, false },
    /* gusts */
    SPECIAL("gust_rule", key_gust_rule, false),
    SPECIAL("terrain", key_terrain, false),
    NUMBER("height", gust.height, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("breadth", gust.breadth, WF_DIM_LENGTH, 0, VAST),
    NUMBER("sway_frequency", gust.frequency, WF_DIM_FREQUENCY, TINY, VAST),
    NUMBER("damping", gust.damping, WF_DIM_NONE, TINY, 1),
    NUMBER("basic_wind", gust.basic_wind, WF_DIM_SPEED, TINY, VAST),
    NUMBER("mean_wind", gust.mean_wind, WF_DIM_SPEED, TINY, VAST),
    NUMBER("bending_strength", gust.strength, WF_DIM_PRESSURE, TINY, VAST),
    NUMBER("crown_depth", gust.crown_depth, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("crown_width", gust.crown_width, WF_DIM_LENGTH, 0, VAST),
    NUMBER("crown_drag", gust.crown_drag, WF_DIM_NONE, 0, 100),
    NUMBER("crown_mass", gust.crown_mass, WF_DIM_MASS, 0, VAST),
    NUMBER("displacement", gust.displacement, WF_DIM_LENGTH, 0, VAST),
    NUMBER("roughness", gust.roughness, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("spacing", gust.spacing, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("edge_distance", gust.edge_distance, WF_DIM_LENGTH, 0, VAST),
    NUMBER("gap", gust.gap, WF_DIM_LENGTH, 0, VAST),
    /* calibration */
    SPECIAL("fit", key_fit, false),
    SPECIAL("free", key_free, false),
    NUMBER("data_sets", data_sets, WF_DIM_NONE, 1, 10000),
    NUMBER("noise", noise, WF_DIM_NONE, 0, 1),
    /* how it is run, what is wanted */
    SPECIAL("solver", key_solver, false),
    SPECIAL("mesh", key_mesh, false),
    NUMBER("accuracy", accuracy, WF_DIM_NONE, 1e-15, 1e-3),
    NUMBER("tolerance", tolerance, WF_DIM_NONE, 1e-15, 0.5),
    SPECIAL("order", key_order, false),
    SPECIAL("want", key_want, true),
    { .name = NULL },
};
_Static_assert(WF_COUNT(wf_case_keys) <= WF_CASE_KEYS_MAX, "room for every key in wf_case.given");

size_t wf_case_key_index(const char *name)
{
    size_t k = 0;
    while (wf_case_keys[k].name && strcmp(name, wf_case_keys[k].name) != 0) k++;
    return k;
}

void wf_case_default(struct wf_case *c)
{
    *c = (struct wf_case){
        .kind = -1, .model = WF_MODEL_EB, .shape = WF_SHAPE_NONE, .tolerance = 1e-6, .rows = 1
    };
    c->direction[2] = 1.0;
    for (const struct wf_case_key *k = wf_case_keys; k->name; k++)
        if (k->read == key_numbers && k->offset != AT(rows) && k->offset != AT(direction) &&
            k->offset != AT(tolerance))
            for (size_t i = 0; i < k->count; i++) ((double *)(void *)((char *)c + k->offset))[i] = NAN;
    c->length = c->arc[0] = c->arc[1] = c->mesh_tolerance = NAN;
}
