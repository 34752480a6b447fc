/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/chain.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include "data/tree.h"
#include "load/load.h"
#include <math.h>

/* One row of the chain as a cantilever with a straight axis and a tapered section. */

enum { CHAIN_POINTS = 8 };

/* Eight-point Gauss-Legendre rule on 0..1, and above[k][j]: the moment about point k of the line load
 * between point k and the end, for values f_j at the points: sum_j above[k][j] f_j, exact to degree 7. */
struct chain_rule {
    double x[CHAIN_POINTS], w[CHAIN_POINTS], above[CHAIN_POINTS][CHAIN_POINTS];
};

struct chain_row {
    double load[3];        /* line load, summed [N] */
    double load_moment[3]; /* its moment about the row's base [N m] */
    double bend[3];        /* displacement of the end relative to a clamped base [m] */
    double turn[3];        /* rotation of the end relative to it [rad] */
};

/* abscissae and weights on -1..1, Abramowitz & Stegun 1964, table 25.4 */
static const double node[CHAIN_POINTS / 2] = { 0.18343464249564980494, 0.52553240991632898582,
                                               0.79666647741362673959, 0.96028985649753623168 };
static const double weight[CHAIN_POINTS / 2] = { 0.36268378337836198297, 0.31370664587788728734,
                                                 0.22238103445337447054, 0.10122853629037625915 };

static void chain_rule_fill(struct chain_rule *g)
{
    for (int k = 0; k < CHAIN_POINTS / 2; k++) {
        g->x[CHAIN_POINTS / 2 - 1 - k] = 0.5 * (1 - node[k]),
                                    g->x[CHAIN_POINTS / 2 + k] = 0.5 * (1 + node[k]);
        g->w[CHAIN_POINTS / 2 - 1 - k] = g->w[CHAIN_POINTS / 2 + k] = 0.5 * weight[k];
    }
    for (int k = 0; k < CHAIN_POINTS; k++)
        for (int j = 0; j < CHAIN_POINTS; j++) {
            double sum = 0;
            for (int m = 0; m < CHAIN_POINTS;
                 m++) { /* (x - x_k) times Lagrange's polynomial j, from x_k to 1 */
                double arm = (1 - g->x[k]) * g->x[m], x = g->x[k] + arm, lagrange = 1;
                for (int q = 0; q < CHAIN_POINTS; q++)
                    if (q != j) lagrange *= (x - g->x[q]) / (g->x[j] - g->x[q]);
                sum += g->w[m] * arm * lagrange;
            }
            g->above[k][j] = (1 - g->x[k]) * sum;
        }
}

/* Compliance in bending and torsion at fraction s of row i. */
static void row_compliance(const struct wf_tree *t, size_t i, double s, double *bending, double *torsion)
{
    double inertia = wf_ring_inertia(wf_wood_radius(t, i, s), wf_between(t->i0[i], t->i1[i], s));
    double ei = t->stiff ? t->stiff[4 * i + 2] : t->youngs[i] * inertia;
    double gj = t->stiff ? t->stiff[4 * i + 3] : t->shear[i] * 2 * inertia;
    *bending = 1 / ei;
    *torsion = 1 / gj;
}

/* Line load at s [N/m]: wind and weight on the undeformed axis, and the dead line load. */
static void unbent_line_load(const struct wf_tree *t, size_t i, const struct wf_loads *l,
                             const double base[3], const double axis[3], double length, double s, double q[3])
{
    double outer = wf_between(t->r0[i], t->r1[i], s), inner = wf_between(t->i0[i], t->i1[i], s), x[3];
    for (int k = 0; k < 3; k++) x[k] = base[k] + s * length * axis[k];
    struct wf_line_point p = { .diameter = 2 * outer,
                               .drag = t->drag[i],
                               .lift = t->lift[i],
                               .sail = wf_between(t->sail0[i], t->sail1[i], s),
                               .mass = t->density[i] * WF_PI * (outer * outer - inner * inner) +
                                       wf_between(t->burden0[i], t->burden1[i], s) };
    struct wf_line_load f;
    wf_load_on_line(l, &p, x, axis, &f);
    for (size_t k = 0; k < 3; k++) {
        q[k] = f.force[k];
        if (l->line) q[k] += l->point_scale * wf_between(l->line[6 * i + k], l->line[6 * i + 3 + k], s);
    }
}

static double ratio_above_one(double a, double b) { return a > b ? a / b : b / a; }

/* Panels of a row over which neither the radius nor the wall thickness changes by more than a factor 1.5;
 * their limits are in geometric progression of the quantity that changes more. */
struct panels {
    double v0, v1;
    int n;
};

static struct panels panels_of(const struct wf_tree *t, size_t i)
{
    double r0 = wf_wood_end(t, i, 0), r1 = wf_wood_end(t, i, 1), w0 = r0 - t->i0[i], w1 = r1 - t->i1[i];
    struct panels p = { r0, r1, 1 };
    if (ratio_above_one(w0, w1) > ratio_above_one(r0, r1)) p.v0 = w0, p.v1 = w1;
    p.n += (int)floor(log(ratio_above_one(p.v0, p.v1)) / log(1.5));
    return p;
}

static double panel_limit(const struct panels *p, int k)
{
    if (k == 0 || k == p->n) return k == 0 ? 0 : 1;
    return (p->v0 * pow(p->v1 / p->v0, (double)k / p->n) - p->v0) / (p->v1 - p->v0);
}

/* Bend one row as a cantilever. Given: rule, scheme, tree, row, loads, force [N] and moment [N m] that the
 * upper part exerts on the row's end. Returned: *out. Method: curvature M/(EI) across and M/(GJ) along the
 * axis, integrated by the rule over panels short enough (radius ratio at most 1.5) for rounding-error
 * accuracy; displacement = integral of (l - s) curvature x tangent. */
static void chain_row_bend(const struct chain_rule *g, const struct wf_chain_scheme *c,
                           const struct wf_tree *t, size_t i, const struct wf_loads *l, const double force[3],
                           const double moment[3], struct chain_row *out)
{
    const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
    double axis[3] = { t->x1[i] - base[0], t->y1[i] - base[1], t->z1[i] - base[2] };
    double length = sqrt(wf_dot(axis, axis)), shear[3] = { 0 }, lever[3] = { 0 };
    for (int k = 0; k < 3; k++) axis[k] /= length;
    struct panels p = panels_of(t, i);
    *out = (struct chain_row){ 0 };

    /* shear and lever: line load above the panel, integrated, and its first moment about the panel's upper
     * end */
    for (int part = p.n; part-- > 0;) {
        double low = panel_limit(&p, part), h = (panel_limit(&p, part + 1) - low) * length,
               q[CHAIN_POINTS][3];
        for (int j = 0; j < CHAIN_POINTS; j++)
            unbent_line_load(t, i, l, base, axis, length, low + g->x[j] * h / length, q[j]);
        for (int k = 0; k < CHAIN_POINTS; k++) {
            double s = low + g->x[k] * h / length, arm = (1 - s) * length, up = (1 - g->x[k]) * h;
            double reach = arm * (1 - c->smear + 0.5 * c->smear * (1 - s)), side[3], m[3], curvature[3], v[3];
            double bending, torsion, mean = 0.5 + c->taper * (s - 0.5);
            for (int x = 0; x < 3; x++) {
                side[x] = reach * force[x] + lever[x] + up * shear[x];
                for (int j = 0; j < CHAIN_POINTS; j++) side[x] += h * h * g->above[k][j] * q[j][x];
            }
            wf_cross(axis, side, m);
            for (int x = 0; x < 3; x++) m[x] += c->moment * moment[x];
            row_compliance(t, i, mean, &bending, &torsion);
            double twist = (torsion - bending) * wf_dot(m, axis);
            for (int x = 0; x < 3; x++) curvature[x] = bending * m[x] + twist * axis[x];
            wf_cross(curvature, axis, v);
            for (int x = 0; x < 3; x++) {
                out->turn[x] += g->w[k] * h * curvature[x];
                out->bend[x] += g->w[k] * h * arm * v[x];
            }
        }
        for (int x = 0; x < 3; x++) {
            lever[x] += h * shear[x];
            for (int j = 0; j < CHAIN_POINTS; j++) {
                lever[x] += g->w[j] * h * g->x[j] * h * q[j][x];
                shear[x] += g->w[j] * h * q[j][x];
            }
        }
    }
    wf_cross(axis, lever, out->load_moment);
    for (int x = 0; x < 3; x++) out->load[x] = shear[x];
}

/* The tree: internal forces from the tips down, displacements from the base up. */

/* y += s (a x b) */
static void add_cross(double y[3], double s, const double a[3], const double b[3])
{
    double c[3];
    wf_cross(a, b, c);
    v3_add(y, s, c);
}

/* All loads and their moments about the first base, summed independently of the forces passed down, to check
 * these. */
struct load_tally {
    double force[3], moment[3], largest_force, largest_moment;
};

static void tally_load(struct load_tally *sum, const struct wf_tree *t, const double at[3],
                       const double force[3], const double moment[3])
{
    const double arm[3] = { at[0] - t->x0[0], at[1] - t->y0[0], at[2] - t->z0[0] };
    double m[3] = { moment[0], moment[1], moment[2] };
    add_cross(m, 1, arm, force);
    v3_add(sum->force, 1, force);
    v3_add(sum->moment, 1, m);
    sum->largest_force = fmax(sum->largest_force, sqrt(wf_dot(force, force)));
    sum->largest_moment = fmax(sum->largest_moment, sqrt(wf_dot(m, m)));
}

static double tally_imbalance(const struct load_tally *sum, const struct wf_response *r)
{
    double f[3], m[3];
    for (int k = 0; k < 3; k++)
        f[k] = r->base_force[k] - sum->force[k], m[k] = r->base_moment[k] - sum->moment[k];
    double force = sum->largest_force > 0 ? sqrt(wf_dot(f, f)) / sum->largest_force : 0;
    double moment = sum->largest_moment > 0 ? sqrt(wf_dot(m, m)) / sum->largest_moment : 0;
    return fmax(force, moment);
}

/* Loads at the rows' ends: point loads and the weight of point masses. chain_hand_down adds the rows
 * above. */
static enum wf_status chain_load_ends(const struct wf_tree *t, const struct wf_loads *l,
                                      struct wf_response *r, struct load_tally *sum, struct wf_err *e)
{
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *p = l->point + k;
        if (p->segment < 0 || (size_t)p->segment >= t->n)
            return wf_fail(e, WF_EUSAGE, "point load %zu: no segment %d (there are %zu)", k, (int)p->segment,
                           t->n);
        v3_add(r->force1 + 3 * p->segment, l->point_scale, p->force);
        v3_add(r->moment1 + 3 * p->segment, l->point_scale, p->moment);
    }
    for (size_t i = 0; i < t->n; i++) {
        const double at[3] = { t->x1[i], t->y1[i], t->z1[i] };
        if (t->mass1) r->force1[3 * i + 2] -= t->mass1[i] * l->gravity * l->weight_scale;
        tally_load(sum, t, at, r->force1 + 3 * i, r->moment1 + 3 * i);
    }
    return WF_OK;
}

/* Tips to base: internal forces; end and turn receive each row's own bending. */
static void chain_hand_down(const struct wf_chain_scheme *c, const struct wf_tree *t,
                            const struct wf_loads *l, struct wf_response *r, struct load_tally *sum)
{
    struct chain_rule rule;
    chain_rule_fill(&rule);
    for (size_t i = t->n; i-- > 0;) {
        const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
        const double chord[3] = { t->x1[i] - base[0], t->y1[i] - base[1], t->z1[i] - base[2] };
        double *f0 = r->force0 + 3 * i, *m0 = r->moment0 + 3 * i, *f1 = r->force1 + 3 * i,
               *m1 = r->moment1 + 3 * i;
        struct chain_row row;
        chain_row_bend(&rule, c, t, i, l, f1, m1, &row);
        for (size_t k = 0; k < 3; k++) {
            r->load[3 * i + k] = row.load[k];
            r->end[3 * i + k] = row.bend[k];
            r->turn[3 * i + k] = row.turn[k];
            f0[k] = f1[k] + row.load[k];
            m0[k] = m1[k] + row.load_moment[k];
        }
        add_cross(m0, 1, chord, f1);
        tally_load(sum, t, base, row.load, row.load_moment);
        if (t->parent[i] >= 0) {
            size_t p = (size_t)t->parent[i];
            const double offset[3] = { base[0] - t->x1[p], base[1] - t->y1[p], base[2] - t->z1[p] };
            v3_add(r->force1 + 3 * p, 1, f0);
            v3_add(r->moment1 + 3 * p, 1, m0);
            add_cross(r->moment1 + 3 * p, 1, offset, f0);
        } else {
            const double offset[3] = { base[0] - t->x0[0], base[1] - t->y0[0], base[2] - t->z0[0] };
            v3_add(r->base_force, 1, f0);
            v3_add(r->base_moment, 1, m0);
            add_cross(r->base_moment, 1, offset, f0);
        }
    }
}

/* Axis direction after a small rotation, normalised to unit length. */
static void tilted_axis(const double axis[3], const double turn[3], double out[3])
{
    wf_cross(turn, axis, out);
    v3_add(out, 1, axis);
    double size = sqrt(wf_dot(out, out));
    for (int k = 0; k < 3; k++) out[k] /= size;
}

/* Base to tips: displacement and rotation of every row's end. */
static void sum_displacements(const struct wf_chain_scheme *c, const struct wf_tree *t,
                              const struct wf_solve_options *o, struct wf_response *r)
{
    for (size_t i = 0; i < t->n; i++) {
        double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
        double *end = r->end + 3 * i, *turn = r->turn + 3 * i, place[3] = { 0 }, tilt[3] = { 0 }, own[3];
        if (t->parent[i] >= 0) {
            size_t p = (size_t)t->parent[i];
            const double offset[3] = { t->x0[i] - t->x1[p], t->y0[i] - t->y1[p], t->z0[i] - t->z1[p] };
            v3_add(place, 1, r->end + 3 * p);
            v3_add(tilt, c->carry, r->turn + 3 * p);
            add_cross(place, 1, tilt, offset);
        } else {
            for (int k = 0; k < 2; k++)
                if (o->root_stiffness[k] > 0)
                    tilt[k] = c->carry * r->moment0[3 * i + (size_t)k] / o->root_stiffness[k];
        }
        v3_add(end, 1, place);
        add_cross(end, 1, tilt, axis);
        v3_add(turn, 1, tilt);
        double size = sqrt(wf_dot(axis, axis));
        for (int k = 0; k < 3; k++) own[k] = axis[k] / size;
        tilted_axis(own, tilt, r->tangent0 + 3 * i);
        tilted_axis(own, turn, r->tangent1 + 3 * i);
    }
}

enum wf_status wf_chain_solve(const struct wf_chain_scheme *c, const struct wf_tree *t,
                              const struct wf_loads *l, const struct wf_solve_options *o, struct wf_arena *a,
                              struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status status = wf_response_alloc(r, t->n, a, e);
    if (!status) status = wf_solve_check_round(t, "the chain", e);
    if (status || (status = wf_tree_check(t, d, e))) return status;
    struct wf_loads loads = *l;
    struct load_tally sum = { 0 };
    loads.weight_scale *= c->weight;
    if (t->bend && d)
        wf_diag_warn(d, "straight-rows", "the chain treats curved segments as straight between their ends");
    if ((status = chain_load_ends(t, &loads, r, &sum, e))) return status;
    chain_hand_down(c, t, &loads, r, &sum);
    sum_displacements(c, t, o, r);
    r->imbalance = tally_imbalance(&sum, r);
    r->load_factor = 1;
    r->iterations = r->steps = 1;
    r->small_deflection = true;
    return WF_OK;
}

/* The solvers as rows. */

const struct wf_chain_scheme wf_chain_corrected = {
    .smear = 0, .moment = 1, .carry = 1, .taper = 1, .weight = 1
};
const struct wf_chain_scheme wf_chain_printed = {
    .smear = 1, .moment = 0, .carry = 0, .taper = 0, .weight = 0
};

static enum wf_status chain_solve_corrected(const struct wf_tree *t, const struct wf_loads *l,
                                            const struct wf_solve_options *o, struct wf_arena *a,
                                            struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return wf_chain_solve(&wf_chain_corrected, t, l, o, a, r, d, e);
}

static enum wf_status chain_solve_printed(const struct wf_tree *t, const struct wf_loads *l,
                                          const struct wf_solve_options *o, struct wf_arena *a,
                                          struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return wf_chain_solve(&wf_chain_printed, t, l, o, a, r, d, e);
}

#define TANG                                                                                                 \
    "Tang L., Zou J., Lin D., Chen C. 2012. Visual simulating virtual tree movement in wind. "               \
    "Trans. Chin. Soc. Agric. Mach. 43(1):165-168, eqs 5-12"

const struct wf_solver wf_solver_chain = {
    .name = "chain",
    .title = "chain of cantilevers, force, moment and rotation handed on",
    .source = TANG "; corrected: moments and rotations are handed on",
    .validity =
        "small deflection: below about 10 % of the height and 15 degrees; loads and weight act on the unbent "
        "tree, so weight does not add to the bending",
    .small_deflection = true,
    .unmeshed = true,
    .solve = chain_solve_corrected
};
const struct wf_solver wf_solver_chain_as_printed = {
    .name = "chain-as-printed",
    .title = "chain of cantilevers as printed by Tang et al. 2012",
    .source = TANG,
    .validity = "reproduces the printed scheme: the deflection depends on the number of segments and falls "
                "to zero as "
                "they are refined; no weight; right for a single uniform segment only",
    .small_deflection = true,
    .as_printed = true,
    .unmeshed = true,
    .clamped = true,
    .solve = chain_solve_printed
};

/* The schemes between the two, for validation cases. */

#define VARIANT(id, called, spread, handed, turned)                                                          \
    static enum wf_status chain_solve_##id(const struct wf_tree *t, const struct wf_loads *l,                \
                                           const struct wf_solve_options *o, struct wf_arena *a,             \
                                           struct wf_response *r, struct wf_diag *d, struct wf_err *e)       \
    {                                                                                                        \
        static const struct wf_chain_scheme scheme = {                                                       \
            .smear = spread, .moment = handed, .carry = turned, .taper = 1, .weight = 1                      \
        };                                                                                                   \
        return wf_chain_solve(&scheme, t, l, o, a, r, d, e);                                                 \
    }                                                                                                        \
    static const struct wf_solver id = { .name = called,                                                     \
                                         .title = "a variant between the printed and the corrected chain",   \
                                         .source = "variants of Tang et al. 2012, eqs 5-12",                 \
                                         .validity = "to compare schemes; not for trees",                    \
                                         .small_deflection = true,                                           \
                                         .solve = chain_solve_##id }

VARIANT(s1, "chain-S1", 1, 0, 0);
VARIANT(s1_turned, "chain-S1-turned", 1, 0, 1);
VARIANT(s2, "chain-S2", 0, 0, 0);
VARIANT(s2_turned, "chain-S2-turned", 0, 0, 1);
VARIANT(s3, "chain-S3", 1, 1, 0);
VARIANT(s3_turned, "chain-S3-turned", 1, 1, 1);
VARIANT(s4, "chain-S4", 0, 1, 0);
VARIANT(s4_turned, "chain-S4-turned", 0, 1, 1);

const struct wf_solver *const wf_chain_variants[] = { &s1,        &s1_turned, &s2,        &s2_turned, &s3,
                                                      &s3_turned, &s4,        &s4_turned, NULL };
