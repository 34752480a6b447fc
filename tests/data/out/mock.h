/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_MOCK_H
#define WF_TESTS_MOCK_H
/* A run made by hand: tapered cantilevers under a wind load that grows towards the top, good enough to look
 * like results. It tests what is written and drawn, not the mechanics. */
#include "data/model.h"
#include "data/species.h"
#include "load/drag.h"
#include "out/results.h"
#include "wind/category.h"
#include <math.h>
#include <string.h>

enum { MOCK_SEGMENTS = 40, MOCK_SWEEP = 61 };

struct mock_kind {
    const char *key, *name, *name_zh, *latin;
    double youngs, strength, radius, wall; /* [Pa], [Pa], [m], share of radius (0: solid) */
    double sail;                           /* drag area of the whole crown [m2] */
};
static const struct mock_kind mock_kinds[] = {
    { "moso_bamboo", "Moso bamboo", "毛竹", "Phyllostachys edulis", 10e9, 100e6, 0.055, 0.2, 1.6 },
    { "weeping_willow", "Weeping willow", "垂柳", "Salix babylonica", 6e9, 14e6, 0.075, 0, 2.4 },
    { "chinese_fir", "Chinese fir", "杉木", "Cunninghamia lanceolata", 8e9, 45e6, 0.08, 0, 2.2 },
    { "masson_pine", "Masson pine", "马尾松", "Pinus massoniana", 9e9, 50e6, 0.085, 0, 2.6 },
    { "norway_spruce", "Norway spruce", "欧洲云杉", "Picea abies", 7e9, 36e6, 0.08, 0, 3.0 },
    { "beech", "European beech", "欧洲山毛榉", "Fagus sylvatica", 10e9, 65e6, 0.07, 0, 2.9 },
};

static inline struct wf_value mock_value(double value, double spread, enum wf_standing standing,
                                         const char *source)
{
    return (struct wf_value){ .value = value,
                              .low = value * (1 - spread),
                              .high = value * (1 + spread),
                              .standing = standing,
                              .source = source,
                              .given = true,
                              .note = "a note on where the figure comes from" };
}

/* What a species table leaves out: the program's default, or nothing (NAN). */
static inline struct wf_value mock_default(double value)
{
    return (struct wf_value){ .value = value, .low = value, .high = value, .standing = WF_ASSUMED };
}

static inline struct wf_species *mock_species(const struct mock_kind *kind, struct wf_arena *a)
{
    struct wf_species *sp = WF_TAKE(a, 1, struct wf_species);
    struct wf_level *level = WF_TAKE(a, 1, struct wf_level);
    static const char *const handbook =
        "Wood Handbook. 2010. Forest Products Laboratory, General Technical Report 190";
    static const char *const amada =
        "Amada S., Lakes R.S. 1997. Viscoelastic properties of bamboo. J. Mater. Sci. 32:2693-2697";
    static const char *const vollsinger =
        "Vollsinger S., Mitchell S.J., Byrne K.E., Novak M.D., Rudnicki M. 2005. "
        "Wind tunnel measurements of crown streamlining and drag relationships for "
        "several hardwood species. Can. J. For. Res. 35:1238-1249";
    *level = (struct wf_level){ .name = "stem" };
    level->youngs_modulus = mock_value(kind->youngs, 0.2, WF_HANDBOOK, handbook);
    level->shear_modulus = mock_default(kind->youngs / 16);
    level->density = mock_value(900, 0.15, WF_MEASURED, handbook);
    level->modulus_of_rupture = mock_value(kind->strength, 0.3, WF_MEASURED, handbook);
    level->radius = mock_value(kind->radius, 0.3, WF_HANDBOOK, handbook);
    level->damping_ratio = mock_value(0.0068, 0.1, WF_MEASURED, amada);
    level->knot_factor = mock_value(0.9, 0.1, WF_ASSUMED, NULL);
    level->drag_coefficient = mock_default(NAN);
    level->lift_coefficient = mock_default(0);
    if (kind->wall > 0) {
        static double at[] = { 0, 0.3, 1 }, share[] = { 0.2, 0.2, 0.24 };
        level->wall = (struct wf_along){ 3, at, share };
        level->wall_note =
            mock_value(0, 0, WF_ASSUMED, "Flora of China, vol. 22. 2006. Science Press, Beijing");
    }
    *sp = (struct wf_species){ .key = kind->key,
                               .name = kind->name,
                               .latin = kind->latin,
                               .name_zh = kind->name_zh,
                               .note = "Made for a test.",
                               .file = "species/mock.yaml",
                               .levels = 1,
                               .level = level,
                               .preset = "corrected" };
    sp->crown.drag_coefficient = mock_value(0.5, 0.4, WF_BORROWED, vollsinger);
    sp->crown.leaf_mass_per_area = mock_value(0.13, 0.2, WF_BORROWED, vollsinger);
    sp->crown.frontal_share = mock_value(0.35, 0.4, WF_ASSUMED, NULL);
    sp->streamlining = (struct wf_law_use){ .law = "vogel",
                                            .low = 4,
                                            .high = 20,
                                            .parameter = { mock_value(-0.7, 0.2, WF_BORROWED, vollsinger),
                                                           { .value = 5 } } };
    return sp;
}

static inline double *mock_column(struct wf_arena *a, size_t n) { return WF_TAKE(a, n, double); }

static inline void mock_tree(struct wf_analysis *an, const struct mock_kind *kind, double height,
                             struct wf_arena *a)
{
    struct wf_tree *t = &an->tree;
    size_t n = MOCK_SEGMENTS;
    t->n = n;
    t->parent = WF_TAKE(a, n, int32_t);
    t->level = WF_TAKE(a, n, int32_t);
    t->id = WF_TAKE(a, n, int64_t);
    double **column[] = { &t->x0,       &t->y0,          &t->z0,       &t->x1,         &t->y1,
                          &t->z1,       &t->r0,          &t->r1,       &t->i0,         &t->i1,
                          &t->strength, &t->compressive, &t->shearing, &t->tangential, &t->transverse };
    for (size_t c = 0; c < sizeof column / sizeof *column; c++) *column[c] = mock_column(a, n);
    for (size_t i = 0; i < n; i++) {
        t->strength[i] = kind->strength;
        double s0 = (double)i / (double)n, s1 = (double)(i + 1) / (double)n;
        t->parent[i] = (int32_t)i - 1;
        t->id[i] = (int64_t)i + 1;
        t->z0[i] = height * s0, t->z1[i] = height * s1;
        t->r0[i] = kind->radius * (1 - 0.81 * s0), t->r1[i] = kind->radius * (1 - 0.81 * s1);
        t->i0[i] = kind->wall > 0 ? t->r0[i] * (1 - kind->wall) : 0;
        t->i1[i] = kind->wall > 0 ? t->r1[i] * (1 - kind->wall) : 0;
    }
}

/* Fill one wind speed. The bending moment is that of a load spread over the upper 60 % of the height. */
static inline void mock_speed(const struct wf_analysis *an, const struct mock_kind *kind, double speed,
                              bool rows, struct wf_at_speed *at, struct wf_arena *a)
{
    const struct wf_tree *t = &an->tree;
    size_t n = t->n;
    double height = an->tallness, force = 0.6 * kind->sail * pow(speed, 1.3) * 2.5, angle = 0, x = 0, z = 0;
    struct wf_breakage *b = &at->breakage;
    struct wf_figures *g = &at->figures;
    *at = (struct wf_at_speed){ .speed = speed, .status = WF_OK };
    double **column[] = { &b->shear0,     &b->shear1,   &b->axial0,         &b->axial1,  &b->bending0,
                          &b->bending1,   &b->torsion0, &b->torsion1,       &b->stress0, &b->stress1,
                          &b->safety0,    &b->safety1,  &g->projected_area, &g->drag,    &g->lift,
                          &g->deflection, &g->slope };
    for (size_t c = 0; c < sizeof column / sizeof *column; c++) *column[c] = mock_column(a, n);
    at->response.end = mock_column(a, 3 * n);
    at->response.load_factor = 1, at->response.iterations = 12, at->response.steps = 2,
    at->response.imbalance = 3e-12;
    struct wf_worst *worst = &at->worst[WF_BREAKAGE][WF_SCOPE_TREE];
    for (int c = WF_BREAKAGE + 1; c < WF_CRITERIA; c++) /* not known */
        for (int s = 0; s < WF_SCOPES; s++) at->worst[c][s] = (struct wf_worst){ .safety = NAN, .row = -1 };
    b->n = n, worst->row = -1, worst->safety = INFINITY;
    for (size_t i = 0; i < n; i++) {
        for (int end = 0; end < 2; end++) {
            double s = end ? t->z1[i] / height : t->z0[i] / height, up = s > 0.4 ? (1 - s) / 0.6 : 1;
            double shear = force * up,
                   moment = s > 0.4 ? force * height * 0.3 * up * up : force * height * (0.7 - s);
            double r = end ? t->r1[i] : t->r0[i], inner = end ? t->i1[i] : t->i0[i];
            double inertia = M_PI / 4 * (pow(r, 4) - pow(inner, 4)), stress = moment * r / inertia;
            (end ? b->shear1 : b->shear0)[i] = shear;
            (end ? b->axial1 : b->axial0)[i] = -300 * (1 - s);
            (end ? b->bending1 : b->bending0)[i] = moment;
            (end ? b->stress1 : b->stress0)[i] = stress;
            (end ? b->safety1 : b->safety0)[i] = kind->strength / stress;
            if (stress > b->largest_stress) b->largest_stress = stress, b->largest_stress_row = (int32_t)i;
            if (kind->strength / stress < worst->safety) {
                worst->safety = kind->strength / stress;
                worst->row = (int32_t)i, worst->place = end;
            }
            if (end) angle += moment * cos(angle) / (kind->youngs * inertia) * height / (double)n;
        }
        x += sin(angle) * height / (double)n, z += cos(angle) * height / (double)n;
        at->response.end[3 * i] = x, at->response.end[3 * i + 2] = z - t->z1[i];
        g->deflection[i] = hypot(x, z - t->z1[i]), g->slope[i] = angle;
        g->drag[i] = force / (double)n, g->projected_area[i] = kind->sail / (double)n * cos(angle);
    }
    at->drag = force, at->weight = 420, at->tip_angle = angle, at->tip_deflection = g->deflection[n - 1];
    at->tip_deflection_share = at->tip_deflection / height;
    at->base_shear = force, at->base_moment = b->bending0[0];
    at->steady =
        (struct wf_steady){ at->drag,      at->tip_deflection, at->top_deflection,
                            at->tip_angle, at->base_shear,     at->base_moment };
    if (isinf(worst->safety)) worst->row = -1;
    if (!rows) memset(g, 0, sizeof *g);
}

static inline void mock_settle_worst(struct wf_worst (*worst)[WF_SCOPES])
{
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int k = 0; k < WF_SCOPES; k++)
            if (c != WF_BREAKAGE || k == WF_SCOPE_BRANCHES)
                worst[c][k] = (struct wf_worst){ .safety = NAN, .row = -1 };
    worst[WF_BREAKAGE][WF_SCOPE_STEM] = worst[WF_BREAKAGE][WF_SCOPE_TREE];
}

/* The tree is its stem, and breakage is all that is known: after a change of the whole tree's breakage. */
static inline void mock_settle(struct wf_analysis *an)
{
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int k = 0; k < WF_SCOPES; k++)
            if (c != WF_BREAKAGE || k == WF_SCOPE_BRANCHES)
                an->breaks[c][k] = (struct wf_break){
                    .critical = { .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN }, .row = -1, .height = NAN
                };
    an->breaks[WF_BREAKAGE][WF_SCOPE_STEM] = an->breaks[WF_BREAKAGE][WF_SCOPE_TREE];
    for (size_t k = 0; k < an->n; k++) mock_settle_worst(an->at[k].worst);
    for (size_t k = 0; k < an->sweep_n; k++) mock_settle_worst(an->sweep[k].worst);
}

static inline void mock_analysis(const struct mock_kind *kind, const double *speed, size_t n,
                                 struct wf_arena *a, struct wf_analysis *out)
{
    static const struct wf_solver solver = { .name = "beam",
                                             .title = "Geometrically exact beam",
                                             .source = "Reissner 1972; Simo 1985",
                                             .validity =
                                                 "any deflection; cross-sections stay plane and circular" };
    static const struct wf_model model = { .key = "culm",
                                           .name = "One stem shape for comparing species, 14 m",
                                           .note = "Made for a test.",
                                           .source = "assumed for comparison",
                                           .file = "models/mock.yaml",
                                           .height = 14,
                                           .radius = 0.0525,
                                           .taper = WF_TAPER_LINEAR,
                                           .tip_ratio = 0.19,
                                           .segments = MOCK_SEGMENTS,
                                           .crown_base = 5.5,
                                           .crown_top = 14,
                                           .leaf_area = 17 };
    *out = (struct wf_analysis){
        .species = mock_species(kind, a), .model = &model, .solver = &solver, .tallness = 14, .n = n
    };
    out->scenario = (struct wf_scenario){ .profile = "power",
                                          .reference_height = 10,
                                          .exponent = 0.16,
                                          .roughness = NAN,
                                          .displacement = NAN,
                                          .temperature = 288.15,
                                          .air_density = NAN,
                                          .gravity = 9.81,
                                          .speed_up = 1,
                                          .carried = 1,
                                          .category = wf_category_open(),
                                          .named = { wf_category_open(), 10 } };
    out->loads.air_density = 1.225;
    out->loads.streamline = wf_streamline_named("vogel");
    out->loads.axis_drag = wf_axis_drag_laws;
    mock_tree(out, kind, 14, a);
    out->at = WF_TAKE(a, n, struct wf_at_speed);
    for (size_t k = 0; k < n; k++) mock_speed(out, kind, speed[k], true, &out->at[k], a);
    out->sweep_n = MOCK_SWEEP;
    out->sweep = WF_TAKE(a, MOCK_SWEEP, struct wf_at_speed);
    for (int c = WF_BREAKAGE + 1; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++)
            out->breaks[c][s] = (struct wf_break){
                .critical = { .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN }, .row = -1, .height = NAN
            };
    out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical = (struct wf_critical){
        .outcome = WF_CRITICAL_ABOVE, .speed = NAN, .speed_low = 0, .speed_high = 60, .evaluations = 31
    };
    out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].row = -1, out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].height = NAN;
    for (size_t k = 0; k < MOCK_SWEEP; k++) {
        mock_speed(out, kind, (double)k, false, &out->sweep[k], a);
        if (out->sweep[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety < 1 &&
            out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome == WF_CRITICAL_ABOVE) {
            out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical =
                (struct wf_critical){ .outcome = WF_CRITICAL_FOUND,
                                      .speed = (double)k - 0.37,
                                      .speed_low = (double)k - 0.371,
                                      .speed_high = (double)k - 0.369,
                                      .gradient = 0.04,
                                      .evaluations = 19 };
            out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].row = out->sweep[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].row;
            out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].height =
                out->tree.z0[out->breaks[WF_BREAKAGE][WF_SCOPE_TREE].row];
        }
    }
    mock_settle(out);
    out->diag = WF_TAKE(a, 1, struct wf_diag);
    out->diag->arena = a;
    wf_diag_warn(out->diag, "streamlining-range",
                 "%s: 25 m/s is above 20 m/s, the highest speed the source of the crown's "
                 "streamlining covers",
                 kind->name);
}

/* A run of `trees` kinds (at most six) at n wind speeds. */
static inline struct wf_run mock_run(size_t trees, const double *speed, size_t n, struct wf_arena *a)
{
    static struct wf_input_file files[2] = {
        { "species", "species/mock.yaml",
          "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad" },
        { "model", "models/mock.yaml", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855" },
    };
    struct wf_analysis *list = WF_TAKE(a, trees, struct wf_analysis);
    for (size_t i = 0; i < trees; i++) mock_analysis(&mock_kinds[i], speed, n, a, &list[i]);
    return (struct wf_run){ .command = "windfirm compare species/mock.yaml --wind 10,15,25 -o out/mock",
                            .version = "0.1.0",
                            .date = "2026-11-23T09:45:00Z",
                            .n = trees,
                            .analysis = list,
                            .inputs = 2,
                            .input = files };
}
#endif
