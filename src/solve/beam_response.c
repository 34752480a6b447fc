#include "solve/beam_response.h"
#include "solve/gauss.h"
#include "solve/vec.h"

/* Force and moment at an element's base, load on it and the load's moment about `first`. */
static void bear(const struct wf_beam *b, size_t i, const double first[3], struct wf_beam_wrench *base,
                 double load[3], double moment[3])
{
    struct wf_line_load q[2];
    struct wf_beam_wrench at[2];
    double couple[2][3];
    const struct wf_beam_part *p = &b->mesh.part[i];
    wf_beam_load(p, &b->loads, &b->stage[i], q);
    wf_beam_couple(wf_beam_flat_of(b, i), couple);
    wf_beam_balance(p->h, &b->stage[i], wf_beam_flat_of(b, i), q, &b->wrench[i], at, base);
    for (int j = 0; j < 2; j++) {
        double arm[3], lever[3];
        for (int k = 0; k < 3; k++) arm[k] = b->stage[i].r[j][k] - first[k];
        wf_cross(arm, q[j].force, lever);
        v3_add(load, 0.5 * p->h, q[j].force);
        v3_add(moment, 0.5 * p->h, lever);
        v3_add(moment, 0.5 * p->h, couple[j]);
    }
}

/* Loads at element ends, summed about `first`: independent of the sweep that made the reactions. */
static void bear_ends(const struct wf_beam *b, const double first[3], double force[3], double moment[3])
{
    const struct wf_loads *l = &b->loads;
    double lever[3], arm[3];
    for (size_t i = 0; b->mesh.mass1 && i < b->mesh.n; i++) {
        const double f[3] = { 0, 0, -l->weight_scale * l->gravity * b->mesh.mass1[i] };
        for (int k = 0; k < 3; k++) arm[k] = b->pose[i].r[k] - first[k];
        wf_cross(arm, f, lever);
        v3_add(force, 1, f), v3_add(moment, 1, lever);
    }
    for (size_t q = 0; q < l->points; q++) {
        const struct wf_point_load *p = &l->point[q];
        const struct wf_beam_pose *at = &b->pose[b->mesh.last[p->segment]];
        double f[3], m[3];
        memcpy(f, p->force, sizeof f), memcpy(m, p->moment, sizeof m);
        if (p->kind == WF_POINT_FOLLOWER) m3_apply(at->L, f, f), m3_apply(at->L, m, m);
        for (int k = 0; k < 3; k++) arm[k] = at->r[k] - first[k];
        wf_cross(arm, f, lever);
        v3_add(force, l->point_scale, f);
        v3_add(moment, l->point_scale, m), v3_add(moment, l->point_scale, lever);
    }
}

static double apart(const double a[3], const double b[3])
{
    double d[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    return sqrt(wf_dot(d, d));
}

static void read_row(const struct wf_beam *b, size_t i, const double first[3], struct wf_response *r,
                     double force[3], double moment[3])
{
    const struct wf_tree *t = b->mesh.tree;
    size_t from = (size_t)b->mesh.first[i], to = (size_t)b->mesh.last[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, from, &ground);
    const struct wf_beam_pose *end = &b->pose[to];
    double at[3], axis[3], load[3] = { 0, 0, 0 };
    const double tip[3] = { t->x1[i], t->y1[i], t->z1[i] };
    for (size_t k = to + 1; k-- > from;) {
        struct wf_beam_wrench w;
        bear(b, k, first, &w, load, moment);
        if (k == from)
            memcpy(r->force0 + 3 * i, w.n, sizeof w.n), memcpy(r->moment0 + 3 * i, w.m, sizeof w.m);
    }
    v3_add(force, 1, load);
    wf_row_axis(t, i, 0, at, axis);
    m3_apply(base->L, axis, r->tangent0 + 3 * i);
    wf_row_axis(t, i, 1, at, axis);
    m3_apply(end->L, axis, r->tangent1 + 3 * i);
    rotation_vector(end->L, r->turn + 3 * i);
    for (size_t k = 0; k < 3; k++) {
        r->end[3 * i + k] = end->r[k] - tip[k];
        r->force1[3 * i + k] = b->wrench[to].n[k];
        r->moment1[3 * i + k] = b->wrench[to].m[k];
        r->load[3 * i + k] = load[k];
    }
}

void wf_beam_read(const struct wf_beam *b, struct wf_response *r)
{
    const struct wf_tree *t = b->mesh.tree;
    const double first[3] = { t->x0[0], t->y0[0], t->z0[0] };
    double force[3] = { 0, 0, 0 }, moment[3] = { 0, 0, 0 };
    for (size_t i = 0; i < t->n; i++) read_row(b, i, first, r, force, moment);
    bear_ends(b, first, force, moment);
    memcpy(r->base_force, b->base.n, sizeof r->base_force);
    memcpy(r->base_moment, b->base.m, sizeof r->base_moment);
    double f = sqrt(wf_dot(force, force)), m = sqrt(wf_dot(moment, moment));
    r->imbalance = fmax(f > 0 ? apart(force, b->base.n) / f : 0, m > 0 ? apart(moment, b->base.m) / m : 0);
    r->iterations = b->iterations;
    r->steps = b->steps;
}

void wf_beam_rotation_at(const struct wf_beam *b, size_t row, double s, double L[9])
{
    int32_t from = b->mesh.first[row], cut = b->mesh.last[row] - from + 1;
    int32_t k = (int32_t)fmin(floor(s * cut), cut - 1);
    double x = s * cut - k, v[3], R[9];
    const struct wf_beam_shape *u = &b->shape[from + k];
    /* the quadratic through 0 at the base and the two Gauss points */
    double a = x * (x - gauss_place[1]) / (gauss_place[0] * (gauss_place[0] - gauss_place[1]));
    double c = x * (x - gauss_place[0]) / (gauss_place[1] * (gauss_place[1] - gauss_place[0]));
    for (int i = 0; i < 3; i++) v[i] = a * u->v[0][i] + c * u->v[1][i];
    struct wf_beam_pose ground;
    rotation_matrix(v, R);
    m3_mul(wf_beam_base(b, (size_t)(from + k), &ground)->L, R, L);
}

void wf_beam_carry(const struct wf_beam *coarse, struct wf_beam *fine)
{
    memcpy(fine->tilt, coarse->tilt, fine->mesh.tree->n * sizeof *fine->tilt);
    for (size_t i = 0; i < fine->mesh.tree->n; i++) {
        int32_t from = fine->mesh.first[i], cut = fine->mesh.last[i] - from + 1;
        for (int32_t k = 0; k < cut; k++) {
            double base[9], at[9], R[9];
            wf_beam_rotation_at(coarse, i, (double)k / cut, base);
            for (int j = 0; j < 2; j++) {
                wf_beam_rotation_at(coarse, i, (k + gauss_place[j]) / cut, at);
                m3_mul_transposed(base, at, R);
                rotation_vector(R, fine->shape[from + k].v[j]);
            }
        }
    }
}
