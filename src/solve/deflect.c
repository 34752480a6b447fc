/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/deflect.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include "load/drag.h"
#include "solve/chain.h"

static double mean_of_ends(double a, double b) { return 0.5 * (a + b); }

static void describe_rod(const struct wf_tree *t, const struct wf_loads *l, size_t i,
                         struct wf_deflect_row *o)
{
    const double base[3] = { t->x0[i], t->y0[i], t->z0[i] }, end[3] = { t->x1[i], t->y1[i], t->z1[i] };
    double x[3], du[9], r = mean_of_ends(t->r0[i], t->r1[i]), q = mean_of_ends(t->i0[i], t->i1[i]);
    double inertia = wf_ring_inertia(mean_of_ends(wf_wood_end(t, i, 0), wf_wood_end(t, i, 1)), q);
    double half = 0.5 * l->air_density * l->wind_scale;
    o->parent = t->parent[i];
    for (int k = 0; k < 3; k++) o->axis[k] = end[k] - base[k], x[k] = mean_of_ends(base[k], end[k]);
    o->length = sqrt(wf_dot(o->axis, o->axis));
    for (int k = 0; k < 3; k++) o->axis[k] /= o->length, o->base[k] = base[k];
    if (o->parent >= 0) {
        o->base[0] -= t->x1[o->parent], o->base[1] -= t->y1[o->parent], o->base[2] -= t->z1[o->parent];
    }
    if (l->wind) l->wind->sample(l->wind, x, o->wind, du);
    const double along = wf_dot(o->wind, o->axis);
    for (int k = 0; k < 3; k++) o->normal[k] = o->wind[k] - along * o->axis[k];
    o->across = sqrt(wf_dot(o->normal, o->normal)), o->speed = sqrt(wf_dot(o->wind, o->wind));
    wf_cross(o->axis, o->normal, o->lifted);
    o->drag = isnan(t->drag[i]) ? -half * 2 * r * o->length : half * t->drag[i] * 2 * r * o->length;
    o->lift = half * t->lift[i] * 2 * r * o->length;
    o->sail = half * mean_of_ends(t->sail0[i], t->sail1[i]) * o->length;
    o->weight = l->gravity * l->weight_scale * o->length *
                (t->density[i] * wf_ring_area(r, q) + mean_of_ends(t->burden0[i], t->burden1[i]));
    o->bend = 1 / (t->stiff ? t->stiff[4 * i + 2] : t->youngs[i] * inertia);
    o->twist = 1 / (t->stiff ? t->stiff[4 * i + 3] : t->shear[i] * 2 * inertia);
    o->radius = r;
    o->printed = 4 * o->length * o->length / (3 * WF_PI * t->youngs[i] * r * r * r);
}

enum wf_status wf_deflect_open(const struct wf_tree *t, const struct wf_loads *l,
                               const struct wf_deflect_scheme *scheme, struct wf_arena *a,
                               struct wf_deflect *d, struct wf_err *e)
{
    enum wf_status round = wf_solve_check_round(t, "the deflection recursion", e);
    if (round) return round;
    if (!(scheme->restoring >= 0 && scheme->restoring < 1))
        return wf_fail(e, WF_EUSAGE,
                       "restoring factor k = %.6g is outside 0 <= k < 1: F(t) = F_1 - k F(t-1) settles to "
                       "F_1/(1 + k) only below 1; from 1 on it oscillates or diverges",
                       scheme->restoring);
    if (!(scheme->damping >= 0))
        return wf_fail(e, WF_EUSAGE, "damping factor %.6g N s2 is negative: it would drive the motion",
                       scheme->damping);
    *d = (struct wf_deflect){ .scheme = *scheme, .loads = l, .n = t->n };
    d->row = WF_TAKE(a, t->n, struct wf_deflect_row);
    d->turn = wf_arena_take(a, t->n, sizeof *d->turn);
    d->end = wf_arena_take(a, t->n, sizeof *d->end);
    d->chord = wf_arena_take(a, t->n, sizeof *d->chord);
    d->force = wf_arena_take(a, t->n, sizeof *d->force);
    d->above = wf_arena_take(a, t->n, sizeof *d->above);
    d->angle = WF_TAKE(a, t->n, double);
    d->spin = WF_TAKE(a, t->n, double);
    if (!d->row || !d->turn || !d->end || !d->chord || !d->force || !d->above || !d->angle || !d->spin)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) describe_rod(t, l, i, &d->row[i]);
    return WF_OK;
}

/* A frame: forces and rotations. */

/* Wind force on a row of direction t (eqs 1 and 2): drag and lift on the area projected across it, crown
 * drag along the wind. */
static void wind_force(const struct wf_loads *l, const struct wf_deflect_row *o, double gust,
                       const double t[3], double f[3])
{
    double u[3], n[3], b[3];
    for (int k = 0; k < 3; k++) u[k] = gust * o->wind[k];
    double along = wf_dot(u, t);
    for (int k = 0; k < 3; k++) n[k] = u[k] - along * t[k];
    double across = sqrt(wf_dot(n, n)), drag = o->drag;
    if (drag < 0) {
        double slope;
        drag *=
            -l->axis_drag->coefficient(&l->axis_drag_par, across, 2 * o->radius, l->air_viscosity, &slope);
    }
    for (int k = 0; k < 3; k++) f[k] = drag * across * n[k];
    if (o->lift > 0 || o->lift < 0) {
        wf_cross(t, n, b);
        v3_add(f, o->lift * across, b);
    }
    if (o->sail > 0) {
        double speed = sqrt(wf_dot(u, u)), share = 1, slope;
        if (l->streamline) share = wf_streamline_share(l->streamline, &l->streamline_par, speed, &slope);
        v3_add(f, o->sail * share * speed, u);
    }
}

/* Wind force on the undeformed row, where only the speed changes. */
static void wind_force_unbent(const struct wf_loads *l, const struct wf_deflect_row *o, double gust,
                              double f[3])
{
    double drag = o->drag, size = fabs(gust), pressure = gust * size * o->across;
    if (drag < 0) {
        double slope;
        drag *= -l->axis_drag->coefficient(&l->axis_drag_par, size * o->across, 2 * o->radius,
                                           l->air_viscosity, &slope);
    }
    for (int k = 0; k < 3; k++) f[k] = pressure * (drag * o->normal[k] + o->lift * o->lifted[k]);
    if (o->sail > 0) {
        double share = 1, slope;
        if (l->streamline)
            share = wf_streamline_share(l->streamline, &l->streamline_par, size * o->speed, &slope);
        v3_add(f, o->sail * share * gust * size * o->speed, o->wind);
    }
}

/* R' = rotation by the angle of sine s and cosine c about the unit axis a, times R */
static void turn_by(const double a[3], double s, double c, const double R[9], double out[9])
{
    for (int j = 0; j < 3; j++) {
        double x = R[j], y = R[3 + j], z = R[6 + j], along = (1 - c) * (a[0] * x + a[1] * y + a[2] * z);
        out[j] = c * x + s * (a[1] * z - a[2] * y) + along * a[0];
        out[3 + j] = c * y + s * (a[2] * x - a[0] * z) + along * a[1];
        out[6 + j] = c * z + s * (a[0] * y - a[1] * x) + along * a[2];
    }
}

static const double upright[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };

static const double *row_base(const struct wf_deflect *d, size_t i, double at[3])
{
    const struct wf_deflect_row *o = &d->row[i];
    memcpy(at, o->base, 3 * sizeof *at);
    if (o->parent < 0) return upright;
    m3_apply(d->turn[o->parent], o->base, at);
    v3_add(at, 1, d->end[o->parent]);
    return d->turn[o->parent];
}

/* Limit delta/L to 1; count the rows limited and keep the largest ratio. */
static double bounded_ratio(struct wf_deflect *d, size_t i, double ratio)
{
    if (ratio > d->worst_ratio) d->worst_ratio = ratio, d->worst = (int32_t)i;
    if (ratio <= 1) return ratio;
    d->clamped++;
    return 1;
}

static void store_angle(struct wf_deflect *d, size_t i, double sine, double step)
{
    if (!(d->scheme.damping > 0)) return;
    double y = sine * sine, angle;
    if (y < 0.01) /* series to rounding */
        angle =
            sine *
            (1 + y * (1. / 6 +
                      y * (3. / 40 +
                           y * (15. / 336 + y * (105. / 3456 + y * (945. / 42240 + y * 10395. / 599040))))));
    else
        angle = asin(sine);
    d->spin[i] = step > 0 ? (angle - d->angle[i]) / step : 0;
    d->angle[i] = angle;
}

static void frame_printed(struct wf_deflect *d, double gust, double step)
{
    for (size_t i = 0; i < d->n; i++) {
        const struct wf_deflect_row *o = &d->row[i];
        double at[3], t[3], f[3], side[3], hinge[3] = { 1, 0, 0 };
        const double *base = row_base(d, i, at);
        m3_apply(base, o->axis, t);
        wind_force(d->loads, o, gust, t, f);
        v3_add(f, -d->scheme.restoring, d->force[i]);
        v3_add(f, d->scheme.damping * d->spin[i] * d->spin[i], t);
        memcpy(d->force[i], f, sizeof f);
        wf_cross(t, f, side); /* |side| = F_Y, along the hinge */
        double across = sqrt(wf_dot(side, side)), sine = bounded_ratio(d, i, o->printed * across);
        for (int k = 0; across > 0 && k < 3; k++) hinge[k] = side[k] / across;
        turn_by(hinge, sine, sqrt(1 - sine * sine), base, d->turn[i]);
        m3_apply(d->turn[i], o->axis, d->chord[i]);
        for (int k = 0; k < 3; k++) d->end[i][k] = at[k] + o->length * d->chord[i][k];
        store_angle(d, i, sine, step);
    }
}

/* Reduce the force across row i by the damping of its last motion, at most to zero. */
static void add_damping(const struct wf_deflect *d, size_t i, double f[3])
{
    double spin = d->spin[i], against = d->scheme.damping * spin * fabs(spin), side[3];
    if (!(fabs(against) > 0)) return;
    double along = wf_dot(f, d->row[i].axis);
    for (int k = 0; k < 3; k++) side[k] = f[k] - along * d->row[i].axis[k];
    double size = sqrt(wf_dot(side, side));
    if (fabs(against) > size) against = against > 0 ? size : -size;
    if (size > 0) v3_add(f, -against / size, side);
}

/* Tips to root on the undeformed tree: force and moment on each row's end. */
static void deflect_hand_down(struct wf_deflect *d, double gust)
{
    const struct wf_loads *l = d->loads;
    memset(d->above, 0, d->n * sizeof *d->above);
    for (size_t k = 0; k < l->points; k++) {
        v3_add(d->above[l->point[k].segment], l->point_scale, l->point[k].force);
        v3_add(d->above[l->point[k].segment] + 3, l->point_scale, l->point[k].moment);
    }
    for (size_t i = d->n; i-- > 0;) {
        const struct wf_deflect_row *o = &d->row[i];
        const double *P = d->above[i];
        double *f = d->force[i], lever[3], total[3], by_length[3], by_base[3];
        wind_force_unbent(l, o, gust, f);
        f[2] -= o->weight;
        if (l->line)
            for (size_t k = 0; k < 3; k++)
                f[k] += l->point_scale * o->length * mean_of_ends(l->line[6 * i + k], l->line[6 * i + 3 + k]);
        add_damping(d, i, f);
        if (o->parent < 0) continue;
        for (int k = 0; k < 3; k++) total[k] = P[k] + f[k], lever[k] = o->length * (P[k] + 0.5 * f[k]);
        wf_cross(o->axis, lever, by_length);
        wf_cross(o->base, total, by_base);
        double *below = d->above[o->parent];
        for (int k = 0; k < 3; k++)
            below[k] += total[k], below[3 + k] += P[3 + k] + by_length[k] + by_base[k];
    }
}

/* out = R exp([v]x), row by row: r cos + (r x v) sin/angle + (r.v) v (1 - cos)/angle^2 */
static inline void rotated_by(const double R[9], const double v[3], double out[9])
{
    double x = wf_dot(v, v), by[3];
    struct rotation o = rotation_of(x);
    double sine = 1 - x * o.b, cosine = 1 - x * o.a;
    for (int k = 0; k < 9; k += 3) {
        double along = o.a * wf_dot(R + k, v);
        wf_cross(R + k, v, by);
        for (int j = 0; j < 3; j++) out[k + j] = cosine * R[k + j] + sine * by[j] + along * v[j];
    }
}

static void frame_corrected(struct wf_deflect *d, double gust, double step)
{
    const double third = 1. / 3, sixth = 1. / 6;
    deflect_hand_down(d, gust);
    for (size_t i = 0; i < d->n; i++) {
        const struct wf_deflect_row *o = &d->row[i];
        const double *P = d->above[i], *m = d->above[i] + 3, *f = d->force[i];
        const double *t = o->axis, L = o->length, bend = o->bend * L, along = wf_dot(m, t);
        double at[3], push[3], slope[3], chord[3], turn[3], lean[3];
        const double *base = row_base(d, i, at);
        /* cantilever: end force P, spread force f, end moment m; rotation of its chord and of its end */
        for (int k = 0; k < 3; k++)
            push[k] = L * (third * P[k] + 0.125 * f[k]), slope[k] = L * (0.5 * P[k] + sixth * f[k]);
        wf_cross(t, push, chord);
        wf_cross(t, slope, turn);
        for (int k = 0; k < 3; k++) {
            double across = m[k] - along * t[k];
            chord[k] = bend * (chord[k] + 0.5 * across);
            turn[k] = bend * (turn[k] + across) + o->twist * L * along * t[k];
        }
        double square = wf_dot(chord, chord), ratio = sqrt(square), sine = bounded_ratio(d, i, ratio);
        double shrink = ratio > 1 ? 1 / ratio : 1, cosine = ratio > 1 ? 0 : sqrt(1 - square);
        wf_cross(chord, t, lean);
        for (int k = 0; k < 3; k++) lean[k] = cosine * t[k] + shrink * lean[k];
        m3_apply(base, lean, d->chord[i]);
        for (int k = 0; k < 3; k++) d->end[i][k] = at[k] + L * d->chord[i][k];
        rotated_by(base, turn, d->turn[i]);
        store_angle(d, i, sine, step);
    }
}

void wf_deflect_frame(struct wf_deflect *d, double gust, double step)
{
    d->clamped = 0;
    d->worst = -1;
    d->worst_ratio = 0;
    if (d->scheme.printed)
        frame_printed(d, gust, step);
    else
        frame_corrected(d, gust, step);
}

/* One steady frame as a solver: shape by the scheme, internal forces by statics on the undeformed tree. */

static void warn_clamped(const struct wf_deflect *d, const struct wf_tree *t, struct wf_diag *diag)
{
    if (!d->clamped || !diag) return;
    wf_diag_warn(diag, "asin-clamped",
                 "%zu segment%s would deflect by more than %s length, where asin(delta/L) has no value, and "
                 "%s held at 90 degrees; the largest is delta/L = %.3g at segment %lld",
                 d->clamped, d->clamped > 1 ? "s" : "", d->clamped > 1 ? "their" : "its",
                 d->clamped > 1 ? "are" : "is", d->worst_ratio, (long long)t->id[d->worst]);
}

static void deflect_read(const struct wf_deflect *d, const struct wf_tree *t, struct wf_response *r)
{
    for (size_t i = 0; i < d->n; i++) {
        const double tip[3] = { t->x1[i], t->y1[i], t->z1[i] };
        const struct wf_deflect_row *o = &d->row[i];
        double *t0 = r->tangent0 + 3 * i;
        for (size_t k = 0; k < 3; k++) r->end[3 * i + k] = d->end[i][k] - tip[k];
        rotation_vector(d->turn[i], r->turn + 3 * i);
        m3_apply(d->turn[i], o->axis, r->tangent1 + 3 * i);
        memcpy(t0, d->scheme.printed ? d->chord[i] : o->axis, 3 * sizeof *t0);
        if (!d->scheme.printed && o->parent >= 0) m3_apply(d->turn[o->parent], o->axis, t0);
    }
}

static enum wf_status deflect_solve(bool printed, const struct wf_tree *t, const struct wf_loads *l,
                                    const struct wf_solve_options *o, struct wf_arena *a,
                                    struct wf_response *r, struct wf_diag *diag, struct wf_err *e)
{
    const struct wf_deflect_scheme scheme = { .printed = printed };
    struct wf_arena work = { 0 };
    struct wf_deflect d;
    enum wf_status status =
        wf_chain_solve(printed ? &wf_chain_printed : &wf_chain_corrected, t, l, o, a, r, diag, e);
    if (!status) status = wf_deflect_open(t, l, &scheme, &work, &d, e);
    if (!status) {
        wf_deflect_frame(&d, 1, 0);
        deflect_read(&d, t, r);
        warn_clamped(&d, t, diag);
    }
    wf_arena_free(&work);
    return status;
}

static enum wf_status deflect_solve_corrected(const struct wf_tree *t, const struct wf_loads *l,
                                              const struct wf_solve_options *o, struct wf_arena *a,
                                              struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return deflect_solve(false, t, l, o, a, r, d, e);
}

static enum wf_status deflect_solve_printed(const struct wf_tree *t, const struct wf_loads *l,
                                            const struct wf_solve_options *o, struct wf_arena *a,
                                            struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return deflect_solve(true, t, l, o, a, r, d, e);
}

#define ZHAO                                                                                                 \
    "Zhao P., Zhang Z. 2013. Research on fast dynamic simulation of IFS trees swaying. Computer "            \
    "Engineering and Applications 49(14):160-163, eqs 1-4"

const struct wf_solver wf_solver_deflect = {
    .name = "deflect",
    .title = "rods turned by their deflection, force and moment handed down",
    .source = ZHAO "; corrected: R^4, forces and moments from above",
    .validity =
        "small deflection: below about 10 % of the height and 15 degrees; loads and weight act on the "
        "unbent tree; converges as segments are refined",
    .small_deflection = true,
    .unmeshed = true,
    .clamped = true,
    .solve = deflect_solve_corrected,
};
const struct wf_solver wf_solver_deflect_as_printed = {
    .name = "deflect-as-printed",
    .title = "rods turned by their own wind force as printed by Zhao and Zhang 2013",
    .source = ZHAO,
    .validity = "reproduces the printed formula: R^3 for R^4, nothing handed on from segment to segment, no "
                "weight; the deflection depends on the number of segments",
    .small_deflection = true,
    .as_printed = true,
    .unmeshed = true,
    .clamped = true,
    .solve = deflect_solve_printed,
};
