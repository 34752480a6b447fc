#include "solve/chain.h"
#include "base/vec.h"
#include "solve/chain_row.h"
#include <math.h>

const struct wf_chain_scheme wf_chain_corrected = {
    .smear = 0, .moment = 1, .carry = 1, .taper = 1, .weight = 1
};
const struct wf_chain_scheme wf_chain_printed = {
    .smear = 1, .moment = 0, .carry = 0, .taper = 0, .weight = 0
};

static void add(double y[3], double s, const double x[3])
{
    for (int k = 0; k < 3; k++) y[k] += s * x[k];
}

/* y += s (a x b) */
static void add_cross(double y[3], double s, const double a[3], const double b[3])
{
    double c[3];
    wf_cross(a, b, c);
    add(y, s, c);
}

/* All loads and their moments about the first base, summed apart from what is handed down, as a check of it.
 */
struct tally {
    double force[3], moment[3], largest_force, largest_moment;
};

static void count(struct tally *sum, const struct wf_tree *t, const double at[3], const double force[3],
                  const double moment[3])
{
    const double arm[3] = { at[0] - t->x0[0], at[1] - t->y0[0], at[2] - t->z0[0] };
    double m[3] = { moment[0], moment[1], moment[2] };
    add_cross(m, 1, arm, force);
    add(sum->force, 1, force);
    add(sum->moment, 1, m);
    sum->largest_force = fmax(sum->largest_force, sqrt(wf_dot(force, force)));
    sum->largest_moment = fmax(sum->largest_moment, sqrt(wf_dot(m, m)));
}

static double imbalance(const struct tally *sum, const struct wf_response *r)
{
    double f[3], m[3];
    for (int k = 0; k < 3; k++)
        f[k] = r->base_force[k] - sum->force[k], m[k] = r->base_moment[k] - sum->moment[k];
    double force = sum->largest_force > 0 ? sqrt(wf_dot(f, f)) / sum->largest_force : 0;
    double moment = sum->largest_moment > 0 ? sqrt(wf_dot(m, m)) / sum->largest_moment : 0;
    return fmax(force, moment);
}

/* Point loads at the rows' ends: given ones and the weight of point masses. The rows above are added later.
 */
static enum wf_status load_ends(const struct wf_tree *t, const struct wf_loads *l, struct wf_response *r,
                                struct tally *sum, struct wf_err *e)
{
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *p = l->point + k;
        if (p->segment < 0 || (size_t)p->segment >= t->n)
            return wf_fail(e, WF_EUSAGE, "point load %zu: no segment %d (there are %zu)", k, (int)p->segment,
                           t->n);
        add(r->force1 + 3 * p->segment, l->point_scale, p->force);
        add(r->moment1 + 3 * p->segment, l->point_scale, p->moment);
    }
    for (size_t i = 0; i < t->n; i++) {
        const double at[3] = { t->x1[i], t->y1[i], t->z1[i] };
        if (t->mass1) r->force1[3 * i + 2] -= t->mass1[i] * l->gravity * l->weight_scale;
        count(sum, t, at, r->force1 + 3 * i, r->moment1 + 3 * i);
    }
    return WF_OK;
}

/* Tips to base: internal forces, and each row's own bending kept in end and turn. */
static void hand_down(const struct wf_chain_scheme *c, const struct wf_tree *t, const struct wf_loads *l,
                      struct wf_response *r, struct tally *sum)
{
    struct wf_chain_rule rule;
    wf_chain_rule_fill(&rule);
    for (size_t i = t->n; i-- > 0;) {
        const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
        const double chord[3] = { t->x1[i] - base[0], t->y1[i] - base[1], t->z1[i] - base[2] };
        double *f0 = r->force0 + 3 * i, *m0 = r->moment0 + 3 * i, *f1 = r->force1 + 3 * i,
               *m1 = r->moment1 + 3 * i;
        struct wf_chain_row row;
        wf_chain_row_bend(&rule, c, t, i, l, f1, m1, &row);
        for (size_t k = 0; k < 3; k++) {
            r->load[3 * i + k] = row.load[k];
            r->end[3 * i + k] = row.bend[k];
            r->turn[3 * i + k] = row.turn[k];
            f0[k] = f1[k] + row.load[k];
            m0[k] = m1[k] + row.load_moment[k];
        }
        add_cross(m0, 1, chord, f1);
        count(sum, t, base, row.load, row.load_moment);
        if (t->parent[i] >= 0) {
            size_t p = (size_t)t->parent[i];
            const double offset[3] = { base[0] - t->x1[p], base[1] - t->y1[p], base[2] - t->z1[p] };
            add(r->force1 + 3 * p, 1, f0);
            add(r->moment1 + 3 * p, 1, m0);
            add_cross(r->moment1 + 3 * p, 1, offset, f0);
        } else {
            const double offset[3] = { base[0] - t->x0[0], base[1] - t->y0[0], base[2] - t->z0[0] };
            add(r->base_force, 1, f0);
            add(r->base_moment, 1, m0);
            add_cross(r->base_moment, 1, offset, f0);
        }
    }
}

/* Axis direction after a small rotation, kept at unit length. */
static void lean(const double axis[3], const double turn[3], double out[3])
{
    wf_cross(turn, axis, out);
    add(out, 1, axis);
    double size = sqrt(wf_dot(out, out));
    for (int k = 0; k < 3; k++) out[k] /= size;
}

/* Base to tips: displacement and rotation of every row's end. */
static void sum_up(const struct wf_chain_scheme *c, const struct wf_tree *t, const struct wf_solve_options *o,
                   struct wf_response *r)
{
    for (size_t i = 0; i < t->n; i++) {
        double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
        double *end = r->end + 3 * i, *turn = r->turn + 3 * i, place[3] = { 0 }, tilt[3] = { 0 }, own[3];
        if (t->parent[i] >= 0) {
            size_t p = (size_t)t->parent[i];
            const double offset[3] = { t->x0[i] - t->x1[p], t->y0[i] - t->y1[p], t->z0[i] - t->z1[p] };
            add(place, 1, r->end + 3 * p);
            add(tilt, c->carry, r->turn + 3 * p);
            add_cross(place, 1, tilt, offset);
        } else {
            for (int k = 0; k < 2; k++)
                if (o->root_stiffness[k] > 0)
                    tilt[k] = c->carry * r->moment0[3 * i + (size_t)k] / o->root_stiffness[k];
        }
        add(end, 1, place);
        add_cross(end, 1, tilt, axis);
        add(turn, 1, tilt);
        double size = sqrt(wf_dot(axis, axis));
        for (int k = 0; k < 3; k++) own[k] = axis[k] / size;
        lean(own, tilt, r->tangent0 + 3 * i);
        lean(own, turn, r->tangent1 + 3 * i);
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
    struct tally sum = { 0 };
    loads.weight_scale *= c->weight;
    if (t->bend && d)
        wf_diag_warn(d, "straight-rows", "the chain takes curved segments as straight between their ends");
    if ((status = load_ends(t, &loads, r, &sum, e))) return status;
    hand_down(c, t, &loads, r, &sum);
    sum_up(c, t, o, r);
    r->imbalance = imbalance(&sum, r);
    r->load_factor = 1;
    r->iterations = r->steps = 1;
    r->small_deflection = true;
    return WF_OK;
}

static enum wf_status solve_corrected(const struct wf_tree *t, const struct wf_loads *l,
                                      const struct wf_solve_options *o, struct wf_arena *a,
                                      struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return wf_chain_solve(&wf_chain_corrected, t, l, o, a, r, d, e);
}

static enum wf_status solve_printed(const struct wf_tree *t, const struct wf_loads *l,
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
    .solve = solve_corrected
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
    .solve = solve_printed
};
