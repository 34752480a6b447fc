#include "study/validate_check.h"
#include "study/validate_flow.h"
#include "study/validate_keys.h"
#include "study/validate_measure.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static bool given(const struct wf_case *c, const char *key) { return c->given[wf_case_key_index(key)] != 0; }

struct checking {
    struct wf_case *c;
    struct wf_diag *d;
};

static void wrong(struct checking *k, size_t line, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));

static void wrong(struct checking *k, size_t line, const char *fmt, ...)
{
    char text[512];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    k->c->faulty = true;
    wf_diag_error(k->d, k->c->file, line, 1, "%s: %s", k->c->name ? k->c->name : "case", text);
}

static void need(struct checking *k, bool there, const char *what)
{
    if (!there) wrong(k, k->c->line, "%s is missing", what);
}

static void exclude(struct checking *k, const char *a, const char *b)
{
    if (given(k->c, a) && given(k->c, b))
        wrong(k, k->c->given[wf_case_key_index(b)], "'%s' and '%s' exclude each other", a, b);
}

/* Section and material: from radii and moduli, or stiffnesses given directly. */
static void check_section(struct checking *k)
{
    struct wf_case *c = k->c;
    bool straight = c->shape == WF_SHAPE_CANTILEVER || c->shape == WF_SHAPE_ARC;
    bool direct = given(c, "EI"), all = given(c, "EA") || given(c, "GA") || given(c, "GJ");
    exclude(k, "EI", "youngs_modulus");
    exclude(k, "poisson", "shear_modulus");
    exclude(k, "mass_per_length", "density");
    exclude(k, "taper", "inner_radius");
    if ((direct || all || given(c, "taper") || given(c, "mass_per_length") || given(c, "radius") ||
         given(c, "inner_radius")) &&
        !straight)
        wrong(k, c->line,
              "radius, taper, EI, EA, GA, GJ and mass_per_length describe a cantilever or an arc");
    if (all && !(direct && given(c, "EA") && given(c, "GA") && given(c, "GJ")))
        wrong(k, c->line, "give EI alone or all four of EA, GA, EI, GJ");
    if (all && (given(c, "taper") || c->radius[0] != c->radius[1]) && given(c, "radius"))
        wrong(k, c->line, "given stiffnesses EA, GA, EI, GJ are constant; taper does not go with them");
    if (given(c, "taper") && given(c, "radius") && c->radius[1] != c->radius[0])
        wrong(k, c->line, "give the tip radius or 'taper', not both");
    if (straight) need(k, direct || given(c, "radius"), "radius (or EI)");
    need(k, direct || given(c, "youngs_modulus"), "youngs_modulus (or EI of a cantilever)");
    need(k, direct || given(c, "poisson") || given(c, "shear_modulus"), "poisson or shear_modulus");
    for (int i = 0; i < 2; i++)
        if (c->inner[i] >= c->radius[i]) wrong(k, c->line, "inner_radius must be smaller than radius");
    if (c->model == WF_MODEL_SR && !all) need(k, given(c, "shear_factor"), "shear_factor (model SR)");
}

static void check_loads(struct checking *k)
{
    struct wf_case *c = k->c;
    bool straight = c->shape == WF_SHAPE_CANTILEVER || c->shape == WF_SHAPE_ARC;
    bool massive = given(c, "density") || given(c, "mass_per_length");
    exclude(k, "weight_parameter", "gravity");
    exclude(k, "cauchy", "air_density");
    if ((given(c, "cauchy") || given(c, "weight_parameter") || given(c, "line_load_by_radius")) && !straight)
        wrong(k, c->line, "cauchy, weight_parameter and line_load_by_radius go with a cantilever or an arc");
    exclude(k, "axis_drag", "drag_coefficient");
    exclude(k, "axis_drag", "cauchy");
    if ((given(c, "wind") && !given(c, "axis_drag")) || given(c, "cauchy"))
        need(k, given(c, "drag_coefficient"), "drag_coefficient (wind)");
    if (given(c, "wind") && !given(c, "cauchy")) need(k, given(c, "air_density"), "air_density (wind)");
    if (given(c, "gravity") && c->gravity != 0.0) need(k, massive, "density or mass_per_length (gravity)");
}

static void check_place(struct checking *k, const struct wf_place *p, size_t line)
{
    enum wf_case_shape s = k->c->shape;
    if (p->kind == WF_PLACE_TIP && s != WF_SHAPE_CANTILEVER && s != WF_SHAPE_ARC)
        wrong(k, line, "'tip' is the end of a cantilever or arc; name a node or row");
    if (p->kind == WF_PLACE_AT && s != WF_SHAPE_CANTILEVER && s != WF_SHAPE_ARC)
        wrong(k, line, "'at' is a place of a cantilever or arc; name a node or row");
    if ((p->kind == WF_PLACE_NODE || p->kind == WF_PLACE_ROW) && s != WF_SHAPE_BRANCHES && s != WF_SHAPE_TREE)
        wrong(k, line, "nodes and rows belong to trees; say tip, base or at");
}

static void check_wants(struct checking *k)
{
    struct wf_case *c = k->c;
    struct wf_want *w = c->wants.data;
    bool by_flow = c->shape == WF_SHAPE_FLOW, by_fit = c->shape == WF_SHAPE_FIT, by_solver = false;
    need(k, c->wants.n > 0, "a wanted value ('want ...')");
    for (size_t i = 0; i < c->wants.n; i++) {
        enum wf_answer by = w[i].quantity->by;
        by_solver |= by == WF_BY_SOLVER;
        if ((by == WF_BY_FLOW) != by_flow || (by == WF_BY_FIT) != by_fit)
            wrong(k, w[i].line, "'%s' cannot be wanted of %s", w[i].quantity->name,
                  by_flow  ? "a flow"
                  : by_fit ? "a fit"
                           : "a structure");
        if (by == WF_BY_MODES || by == WF_BY_BUCKLING)
            if (!given(c, "density") && !given(c, "mass_per_length") && !given(c, "weight_parameter"))
                wrong(k, w[i].line, "'%s' needs density, mass_per_length or weight_parameter",
                      w[i].quantity->name);
        if (isnan(w[i].tolerance)) w[i].tolerance = c->tolerance;
        check_place(k, &w[i].at, w[i].line);
    }
    if (by_solver && !c->solvers) c->solver[c->solvers++] = wf_solvers[0];
    if (!by_solver && c->given[wf_case_key_index("solver")] > c->line)
        wrong(k, c->line, "'solver' is given but nothing wanted comes from one");
    if (!by_solver) c->solvers = 0;
}

void wf_case_check(struct wf_case *c, struct wf_diag *d)
{
    struct checking k = { c, d };
    if (c->faulty) return; /* what is wrong has been said; what follows from it would only confuse */
    need(&k, c->kind >= 0, "kind");
    need(&k, c->source != NULL, "source");
    need(&k, c->shape != WF_SHAPE_NONE, "a structure (cantilever, arc, node and branch, tree, flow or fit)");
    if (c->shape == WF_SHAPE_BRANCHES) need(&k, c->branches.n > 0, "a branch");
    if (c->shape == WF_SHAPE_NONE) return;
    if (c->shape == WF_SHAPE_FLOW)
        need(&k, !wf_flow_missing(c), wf_flow_missing(c));
    else if (c->shape != WF_SHAPE_FIT)
        check_section(&k), check_loads(&k);
    const struct wf_case_load *l = c->loads.data;
    for (size_t i = 0; i < c->loads.n; i++) check_place(&k, &l[i].at, l[i].line);
    const struct wf_case_mass *m = c->masses.data;
    for (size_t i = 0; i < c->masses.n; i++) check_place(&k, &m[i].at, m[i].line);
    check_wants(&k);
}
