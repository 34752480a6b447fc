/* The quantities a validation case can want, as rows. */
#include "study/validate_measure.h"
#include "base/vec.h"
#include "study/validate_flow.h"
#include "study/validate_solve.h"
#include <math.h>
#include <stdint.h>

static const double pi = 3.14159265358979323846;

static int32_t row_of(const struct wf_measured *m, const struct wf_want *w)
{
    return wf_setup_row(m->setup, &w->at);
}

/* A column of the response at a place; at the base `base`, or nothing moved. */
static void take(const double *column, int32_t row, const double *base, double out[3])
{
    for (int k = 0; k < 3; k++) out[k] = row >= 0 ? column[3 * row + k] : base ? base[k] : 0.0;
}

static enum wf_status displacement(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                   struct wf_err *e)
{
    (void)e;
    take(m->response->end, row_of(m, w), NULL, out);
    return WF_OK;
}

static enum wf_status position(const struct wf_measured *m, const struct wf_want *w, double out[3],
                               struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    int32_t i = row_of(m, w);
    (void)e;
    take(m->response->end, i, NULL, out);
    const double *const x[3] = { i < 0 ? t->x0 : t->x1, i < 0 ? t->y0 : t->y1, i < 0 ? t->z0 : t->z1 };
    for (int k = 0; k < 3; k++) out[k] += x[k][i < 0 ? 0 : i];
    return WF_OK;
}

static enum wf_status rotation(const struct wf_measured *m, const struct wf_want *w, double out[3],
                               struct wf_err *e)
{
    (void)e;
    take(m->response->turn, row_of(m, w), NULL, out);
    return WF_OK;
}

static enum wf_status force(const struct wf_measured *m, const struct wf_want *w, double out[3],
                            struct wf_err *e)
{
    (void)e;
    take(m->response->force1, row_of(m, w), m->response->base_force, out);
    return WF_OK;
}

static enum wf_status moment(const struct wf_measured *m, const struct wf_want *w, double out[3],
                             struct wf_err *e)
{
    (void)e;
    take(m->response->moment1, row_of(m, w), m->response->base_moment, out);
    return WF_OK;
}

static enum wf_status stress(const struct wf_measured *m, const struct wf_want *w, double out[3],
                             struct wf_err *e)
{
    int32_t i = row_of(m, w);
    (void)e;
    out[0] = wf_stress_at(&m->setup->tree, m->response, i < 0 ? 0 : (size_t)i, i < 0 ? 0.0 : 1.0);
    return WF_OK;
}

/* Largest stress of the whole tree [Pa] and its distance from the base of a single axis, as share of its
 * length. */
static double largest_stress(const struct wf_measured *m, double *place)
{
    const struct wf_tree *t = &m->setup->tree;
    double best = -1.0, at = 0.0, length = 0.0, share;
    for (size_t i = 0; i < t->n; i++) {
        double s = wf_span_stress(t, m->response, i, &share), own = wf_tree_length(t, i);
        if (s > best) best = s, at = length + share * own;
        length += own;
    }
    *place = at / length;
    return best;
}

static enum wf_status max_stress(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                 struct wf_err *e)
{
    double place;
    (void)w, (void)e;
    out[0] = largest_stress(m, &place);
    return WF_OK;
}

static enum wf_status max_stress_place(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                       struct wf_err *e)
{
    (void)w;
    if (m->of->shape == WF_SHAPE_BRANCHES || m->of->shape == WF_SHAPE_TREE)
        return wf_fail(e, WF_EINPUT, "max_stress_position is a share of the length of a cantilever or arc");
    (void)largest_stress(m, out);
    return WF_OK;
}

/* Over the ends of rows that carry no other row. */
static enum wf_status tips(const struct wf_measured *m, double *largest, double *mean, struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    bool *carries = WF_TAKE(m->arena, t->n, bool);
    size_t count = 0;
    if (!carries) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < t->n; i++)
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
    *largest = *mean = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        const double *u = m->response->end + 3 * i;
        if (carries[i]) continue;
        *largest = fmax(*largest, sqrt(wf_dot(u, u)));
        *mean += sqrt(wf_dot(u, u));
        count++;
    }
    *mean /= (double)count;
    return WF_OK;
}

static enum wf_status max_tip(const struct wf_measured *m, const struct wf_want *w, double out[3],
                              struct wf_err *e)
{
    double mean;
    (void)w;
    return tips(m, out, &mean, e);
}

static enum wf_status mean_tip(const struct wf_measured *m, const struct wf_want *w, double out[3],
                               struct wf_err *e)
{
    double largest;
    (void)w;
    return tips(m, &largest, out, e);
}

static enum wf_status reconfiguration(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                      struct wf_err *e)
{
    (void)w;
    double rigid;
    if (wf_rigid_drag(m->setup, &rigid, e)) return e->code;
    out[0] = wf_dot(m->response->base_force, m->setup->wind.direction) / rigid;
    return WF_OK;
}

static enum wf_status vogel(const struct wf_measured *m, const struct wf_want *w, double out[3],
                            struct wf_err *e)
{
    (void)w;
    return wf_local_vogel(m->setup, m->solver, m->arena, out, e);
}

static enum wf_status bending_stiffness(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                        struct wf_err *e)
{
    const struct wf_tree *t = &m->setup->tree;
    int32_t i = row_of(m, w);
    (void)e;
    double r = i < 0 ? t->r0[0] : t->r1[i], q = i < 0 ? t->i0[0] : t->i1[i];
    out[0] = t->stiff ? t->stiff[4 * (i < 0 ? 0 : i) + 2]
                      : t->youngs[i < 0 ? 0 : i] * 0.25 * pi * (pow(r, 4) - pow(q, 4));
    return WF_OK;
}

static enum wf_status imbalance(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                struct wf_err *e)
{
    (void)w, (void)e;
    out[0] = m->response->imbalance;
    return WF_OK;
}

static enum wf_status frequency(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                struct wf_err *e)
{
    (void)e;
    out[0] = m->frequency[w->number - 1];
    return WF_OK;
}

static enum wf_status angular_frequency(const struct wf_measured *m, const struct wf_want *w, double out[3],
                                        struct wf_err *e)
{
    (void)e;
    out[0] = 2.0 * pi * m->frequency[w->number - 1];
    return WF_OK;
}

static enum wf_status buckling(const struct wf_measured *m, const struct wf_want *w, double out[3],
                               struct wf_err *e)
{
    (void)w, (void)e;
    out[0] = m->buckling_factor;
    return WF_OK;
}

const struct wf_quantity wf_quantities[] = {
    { "displacement", WF_DIM_LENGTH, true, WF_NEED_PLACE, WF_BY_SOLVER, displacement },
    { "position", WF_DIM_LENGTH, true, WF_NEED_PLACE, WF_BY_SOLVER, position },
    { "rotation", WF_DIM_ANGLE, true, WF_NEED_PLACE, WF_BY_SOLVER, rotation },
    { "force", WF_DIM_FORCE, true, WF_NEED_PLACE, WF_BY_SOLVER, force },
    { "moment", WF_DIM_MOMENT, true, WF_NEED_PLACE, WF_BY_SOLVER, moment },
    { "stress", WF_DIM_PRESSURE, false, WF_NEED_PLACE, WF_BY_SOLVER, stress },
    { "max_stress", WF_DIM_PRESSURE, false, WF_NEED_NOTHING, WF_BY_SOLVER, max_stress },
    { "max_stress_position", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, max_stress_place },
    { "max_tip_displacement", WF_DIM_LENGTH, false, WF_NEED_NOTHING, WF_BY_SOLVER, max_tip },
    { "mean_tip_displacement", WF_DIM_LENGTH, false, WF_NEED_NOTHING, WF_BY_SOLVER, mean_tip },
    { "reconfiguration_number", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, reconfiguration },
    { "vogel_exponent", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, vogel },
    { "imbalance", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_SOLVER, imbalance },
    { "bending_stiffness", WF_DIM_BENDING_STIFFNESS, false, WF_NEED_PLACE, WF_BY_SETUP, bending_stiffness },
    { "frequency", WF_DIM_FREQUENCY, false, WF_NEED_NUMBER, WF_BY_MODES, frequency },
    { "angular_frequency", WF_DIM_FREQUENCY, false, WF_NEED_NUMBER, WF_BY_MODES, angular_frequency },
    { "buckling_factor", WF_DIM_NONE, false, WF_NEED_NOTHING, WF_BY_BUCKLING, buckling },
    { "velocity", WF_DIM_SPEED, true, WF_NEED_POINT, WF_BY_FLOW, wf_flow_velocity },
    { "pressure_coefficient", WF_DIM_NONE, false, WF_NEED_POINT, WF_BY_FLOW, wf_flow_cp },
    { "fitted_modulus", WF_DIM_PRESSURE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "fitted_stiffness", WF_DIM_ROTATIONAL_STIFFNESS, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "fitted_number", WF_DIM_NONE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { "intervals_that_cover", WF_DIM_NONE, false, WF_NEED_NAME, WF_BY_FIT, NULL },
    { .name = NULL },
};
