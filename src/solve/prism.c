/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/prism.h"
#include "base/vec3.h"
#include <math.h>
#include <string.h>

const struct wf_prism_kind wf_prism_kinds[WF_PRISM_ROWS] = {
    { "structural", "neighbours along the axis, and the three vertices of a section" },
    { "shear", "both diagonals of every side face" },
    { "bending", "a vertex and the one two sections on" },
    { "restoring", "a vertex and its rest place" },
};

/* Shares of the bending stiffness: what the diagonals take where the segments are longest, what the bending
 * springs take, and what is left of the diagonals' own when their section gives under them. */
static const double shear_share = 0.5, bending_share = 0.25, firm = 0.9;

/* ---- Building ---- */

static enum wf_status check_axis(const struct wf_prism_axis *x, size_t k, size_t sections, struct wf_err *e)
{
    if (!x->segments) return wf_fail(e, WF_EINPUT, "prisms: axis %zu has no segments", k + 1);
    if (sections + x->segments + 1 > WF_PRISM_SECTIONS_MAX)
        return wf_fail(e, WF_EINPUT, "prisms: more than %d sections", WF_PRISM_SECTIONS_MAX);
    if (x->on >= (int32_t)sections)
        return wf_fail(e, WF_EINPUT, "prisms: axis %zu stands on section %d, which comes later", k + 1,
                       (int)x->on);
    if (!(x->restoring >= 0))
        return wf_fail(e, WF_EINPUT, "prisms: axis %zu: a restoring constant is 0 or more", k + 1);
    for (size_t i = 0; i < x->segments; i++) {
        double d[3];
        for (int c = 0; c < 3; c++) d[c] = x->place[3 * i + 3 + (size_t)c] - x->place[3 * i + (size_t)c];
        if (!(wf_dot(d, d) > 0))
            return wf_fail(e, WF_EINPUT, "prisms: segment %zu of axis %zu has no length", i + 1, k + 1);
        if (!(x->bending[i] > 0) || !(x->torsion[i] > 0) || !isfinite(x->bending[i] + x->torsion[i]))
            return wf_fail(e, WF_EINPUT,
                           "prisms: segment %zu of axis %zu: EI = %g and GJ = %g N m2 must be positive",
                           i + 1, k + 1, x->bending[i], x->torsion[i]);
    }
    for (size_t i = 0; i <= x->segments; i++)
        if (!(x->mass[i] > 0) || !(x->polar[i] > 0))
            return wf_fail(e, WF_EINPUT, "prisms: node %zu of axis %zu has no mass", i + 1, k + 1);
    return WF_OK;
}

static double length_of(const struct wf_prism_axis *x, size_t i)
{
    double d[3];
    for (int c = 0; c < 3; c++) d[c] = x->place[3 * i + 3 + (size_t)c] - x->place[3 * i + (size_t)c];
    return sqrt(wf_dot(d, d));
}

/* Distance of the vertices from the axis: the diagonals take shear_share of EI where GJ h^2/EI is largest. */
static double arm_of(const struct wf_prism_axis *x)
{
    double most = 0;
    for (size_t i = 0; i < x->segments; i++) {
        double h = length_of(x, i);
        most = fmax(most, x->torsion[i] * h * h / x->bending[i]);
    }
    return sqrt(most / (6 * shear_share));
}

static void unit(double v[3])
{
    double s = 1 / sqrt(wf_dot(v, v));
    for (int c = 0; c < 3; c++) v[c] *= s;
}

/* Axis direction at node i: along its segment, at a joint half way between the two. */
static void direction_at(const struct wf_prism_axis *x, size_t i, double t[3])
{
    size_t from = i ? i - 1 : 0, to = i < x->segments ? i + 1 : i;
    for (size_t c = 0; c < 3; c++) t[c] = x->place[3 * to + c] - x->place[3 * from + c];
    unit(t);
}

/* Rest places of an axis; the normal is carried along with the least turn. */
static void lay_out(const struct wf_prism_axis *x, double arm, double *rest)
{
    double normal[3], t[3], left[3];
    memcpy(normal, x->normal, sizeof normal);
    for (size_t i = 0; i <= x->segments; i++) {
        direction_at(x, i, t);
        double along = wf_dot(normal, t);
        for (int c = 0; c < 3; c++) normal[c] -= along * t[c];
        unit(normal);
        wf_cross(normal, t, left); /* so that (along, left, normal) is right-handed */
        for (int j = 0; j < 3; j++) {
            double angle = 2.0943951023931953 * j, up = arm * cos(angle), side = arm * sin(angle);
            for (int c = 0; c < 3; c++)
                rest[9 * i + (size_t)(3 * j + c)] =
                    x->place[3 * i + (size_t)c] + up * normal[c] + side * left[c];
        }
    }
}

void wf_prism_shares(double arm, double across, double along_normal, double share[3])
{
    double up = along_normal / arm, side = across / (arm * 1.7320508075688772);
    share[0] = 1.0 / 3 + 2 * up / 3;
    share[1] = 1.0 / 3 - up / 3 + side;
    share[2] = 1.0 / 3 - up / 3 - side;
}

/* The inverse of a symmetric 3 x 3 matrix. Returned: false where it is not positive definite. */
static bool invert(const double m[9], double out[9])
{
    double c0 = m[4] * m[8] - m[5] * m[7], c1 = m[5] * m[6] - m[3] * m[8], c2 = m[3] * m[7] - m[4] * m[6];
    double det = m[0] * c0 + m[1] * c1 + m[2] * c2;
    if (!(det > 0) || !(m[0] > 0) || !(m[0] * m[4] - m[1] * m[3] > 0)) return false;
    const double cofactor[9] = { c0, m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
                                 c1, m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
                                 c2, m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3] };
    for (int i = 0; i < 9; i++) out[i] = cofactor[i] / det;
    return true;
}

/* Mass matrix of a section: the round part by mass and polar moment, the plate by its width. */
static void mass_of(const struct wf_prism_axis *x, size_t i, double arm, double m[9])
{
    double round = x->mass[i], plate = x->plate ? x->plate[i] : 0, half = x->plate ? x->half[i] : 0;
    memset(m, 0, 9 * sizeof *m);
    if (x->diagonal) {
        m[0] = m[4] = m[8] = (round + plate) / 3;
        return;
    }
    double apart = x->polar[i] / (3 * arm * arm);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) m[3 * r + c] = round / 9 - apart / 3 + (r == c ? apart : 0);
    /* the plate's points stand at (y, fold |y|): shares 1/3 + y side + z rise, mean y^2 = half^2/3 */
    const double side[3] = { 0, 1 / (arm * sqrt(3)), -1 / (arm * sqrt(3)) };
    const double rise[3] = { 2 / (3 * arm), -1 / (3 * arm), -1 / (3 * arm) };
    double square = half * half / 3, z = x->fold * half / 2;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            m[3 * r + c] += plate * (1.0 / 9 + square * side[r] * side[c] + z / 3 * (rise[r] + rise[c]) +
                                     x->fold * x->fold * square * rise[r] * rise[c]);
}

static enum wf_status put_masses(struct wf_prism *p, const struct wf_prism_axis *x, size_t k,
                                 struct wf_err *e)
{
    size_t s = (size_t)p->first[k];
    for (size_t i = 0; i <= x->segments; i++, s++) {
        mass_of(x, i, p->arm[k], p->mass + 9 * s);
        if (!invert(p->mass + 9 * s, p->inverse + 9 * s))
            return wf_fail(e, WF_EINPUT, "prisms: node %zu of axis %zu: its masses are not positive", i + 1,
                           k + 1);
    }
    return WF_OK;
}

/* ---- Springs ---- */

static void join(struct wf_prism *p, int32_t a, int32_t b, double k, enum wf_prism_row row)
{
    double d[3] = { 0 };
    if (!(k > 0)) return;
    for (int c = 0; c < 3 && b >= 0; c++) d[c] = p->rest[3 * b + c] - p->rest[3 * a + c];
    p->spring[p->springs++] =
        (struct wf_prism_spring){ .a = a, .b = b, .k = k, .rest = sqrt(wf_dot(d, d)), .row = (int32_t)row };
}

/* Constants of a segment. */
struct constants {
    double diagonal, edge, own; /* [N/m]; edge: of a section that holds its diagonals; own: bending by them */
};

static struct constants constants_of(const struct wf_prism_axis *x, size_t i, double arm)
{
    double h = length_of(x, i), w2 = 3 * arm * arm, d2 = h * h + w2;
    double k = 2.0 / 9 * x->torsion[i] / h * d2 / (arm * arm * arm * arm);
    /* how far the sections of this segment give, over sections far from the root, which does not: their
     * balance is k_T e_i + q (e_(i-1) + 2 e_i + e_(i+1))/2 = const, so e_i = e (1 - r^i) */
    double stiff = 2 * firm / (1 - firm) + 1, r = sqrt(stiff * stiff - 1) - stiff;
    double give = 1 - 0.5 * (pow(r, (double)i) + pow(r, (double)i + 1)), held = 1 - (1 - firm) * give;
    return (struct constants){ .diagonal = k,
                               .edge = firm / (1 - firm) * 2 * k * w2 / d2,
                               .own = held * x->torsion[i] * h / (6 * arm * arm) };
}

/* Bending spring that passes node i: a share of the softer of its two segments; none at the ends. */
static double passing(const struct wf_prism_axis *x, size_t i, double arm)
{
    if (!i || i >= x->segments) return 0;
    double below = x->bending[i - 1] / length_of(x, i - 1), above = x->bending[i] / length_of(x, i);
    return bending_share * fmin(below, above) / (6 * arm * arm);
}

static void add_springs(struct wf_prism *p, const struct wf_prism_axis *x, size_t k)
{
    double arm = p->arm[k], hold = 0;
    int32_t v = 3 * p->first[k];
    for (size_t i = 0; i <= x->segments; i++, v += 3) {
        bool ends = i == x->segments;
        struct constants c = ends ? (struct constants){ 0 } : constants_of(x, i, arm);
        if (i) /* a clamped or bonded section needs no edges */
            for (int32_t j = 0; j < 3; j++)
                join(p, v + j, v + (j + 1) % 3, fmax(hold, c.edge), WF_PRISM_STRUCTURAL);
        for (int32_t j = 0; j < 3 && i; j++)
            join(p, v + j, -1, ends ? 0.5 * x->restoring : x->restoring, WF_PRISM_RESTORING);
        if (ends) return;
        double bend = x->bending[i] / length_of(x, i), by = passing(x, i, arm) + passing(x, i + 1, arm);
        double straight = (bend - c.own - 3 * arm * arm * by) / (1.5 * arm * arm);
        for (int32_t j = 0; j < 3; j++) {
            join(p, v + j, v + 3 + j, straight, WF_PRISM_STRUCTURAL);
            join(p, v + j, v + 3 + (j + 1) % 3, c.diagonal, WF_PRISM_SHEAR);
            join(p, v + (j + 1) % 3, v + 3 + j, c.diagonal, WF_PRISM_SHEAR);
            if (i + 1 < x->segments) join(p, v + j, v + 6 + j, passing(x, i + 1, arm), WF_PRISM_BENDING);
        }
        hold = c.edge;
    }
}

/* ---- Bonds ---- */

/* Shares of four points of which the fourth is off the plane of the others. */
static bool shares_in(const double *const on[4], const double x[3], double share[4])
{
    double u[3], v[3], w[3], d[3], vw[3], wu[3], uv[3];
    for (int c = 0; c < 3; c++) {
        u[c] = on[1][c] - on[0][c], v[c] = on[2][c] - on[0][c];
        w[c] = on[3][c] - on[0][c], d[c] = x[c] - on[0][c];
    }
    wf_cross(v, w, vw), wf_cross(w, u, wu), wf_cross(u, v, uv);
    double det = wf_dot(u, vw);
    if (!(fabs(det) > 0)) return false;
    share[1] = wf_dot(d, vw) / det, share[2] = wf_dot(d, wu) / det, share[3] = wf_dot(d, uv) / det;
    share[0] = 1 - share[1] - share[2] - share[3];
    return true;
}

static enum wf_status bond_root(struct wf_prism *p, const struct wf_prism_axis *x, size_t k, struct wf_err *e)
{
    int32_t root = p->first[k], on = x->on, other = on;
    for (size_t i = 0; i < k; i++)
        if (on >= p->first[i] && on < p->first[i] + p->count[i]) other = on > p->first[i] ? on - 1 : on + 1;
    if (p->bonded[on] || p->bonded[other])
        return wf_fail(e, WF_EINPUT, "prisms: axis %zu stands on a section that is itself bonded", k + 1);
    p->bonded[root] = true;
    for (int32_t j = 0; j < 3; j++) {
        struct wf_prism_bond *b = &p->bond[3 * root + j];
        const double *place[4];
        for (int32_t i = 0; i < 4; i++) {
            b->on[i] = i < 3 ? 3 * on + i : 3 * other;
            place[i] = p->rest + 3 * b->on[i];
        }
        if (!shares_in(place, p->rest + 3 * (3 * root + j), b->share))
            return wf_fail(e, WF_EINPUT, "prisms: axis %zu stands on a section without volume", k + 1);
    }
    return WF_OK;
}

/* Numbers of the unknown sections: last axis first, from its tip down, so that what an axis stands on is
 * eliminated after it. */
static void number_sections(struct wf_prism *p)
{
    for (size_t k = p->axes; k-- > 0;)
        for (int32_t s = p->first[k] + p->count[k]; s-- > p->first[k];) {
            p->free[s] = s == p->first[k] ? -1 : (int32_t)p->unknown;
            if (p->free[s] >= 0) p->order[p->unknown++] = s;
        }
}

static bool allocate(struct wf_prism *p, size_t axes, size_t sections, struct wf_arena *a)
{
    p->first = WF_TAKE(a, axes, int32_t);
    p->count = WF_TAKE(a, axes, int32_t);
    p->arm = WF_TAKE(a, axes, double);
    p->rest = WF_TAKE(a, 9 * sections, double);
    p->mass = WF_TAKE(a, 9 * sections, double);
    p->inverse = WF_TAKE(a, 9 * sections, double);
    p->free = WF_TAKE(a, sections, int32_t);
    p->order = WF_TAKE(a, sections, int32_t);
    p->bond = WF_TAKE(a, 3 * sections, struct wf_prism_bond);
    p->bonded = WF_TAKE(a, sections, bool);
    p->spring = WF_TAKE(a, 18 * sections, struct wf_prism_spring);
    return p->first && p->count && p->arm && p->rest && p->mass && p->inverse && p->free && p->order &&
           p->bond && p->bonded && p->spring;
}

enum wf_status wf_prism_make(const struct wf_prism_axis *axis, size_t n, struct wf_arena *a,
                             struct wf_prism *out, struct wf_err *e)
{
    size_t sections = 0;
    *out = (struct wf_prism){ .axes = n, .error = 1 - firm };
    for (size_t k = 0; k < n; k++) {
        enum wf_status s = check_axis(&axis[k], k, sections, e);
        if (s) return s;
        sections += axis[k].segments + 1;
    }
    out->sections = sections;
    if (!allocate(out, n, sections, a)) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    for (size_t k = 0, s = 0; k < n; k++) {
        out->first[k] = (int32_t)s;
        out->count[k] = (int32_t)axis[k].segments + 1;
        out->arm[k] = arm_of(&axis[k]);
        lay_out(&axis[k], out->arm[k], out->rest + 9 * s);
        enum wf_status status = put_masses(out, &axis[k], k, e);
        if (!status && axis[k].on >= 0) status = bond_root(out, &axis[k], k, e);
        if (status) return status;
        add_springs(out, &axis[k], k);
        s += axis[k].segments + 1;
    }
    number_sections(out);
    return WF_OK;
}

/* ---- Places and forces ---- */

void wf_prism_follow(const struct wf_prism *p, double *x)
{
    for (size_t k = 0; k < p->axes; k++) {
        int32_t s = p->first[k];
        for (int32_t v = 3 * s; v < 3 * s + 3 && p->bonded[s]; v++) {
            const struct wf_prism_bond *b = &p->bond[v];
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int i = 0; i < 4; i++) sum += b->share[i] * x[3 * b->on[i] + c];
                x[3 * v + c] = sum;
            }
        }
    }
}

void wf_prism_pass(const struct wf_prism *p, double *f)
{
    for (size_t k = p->axes; k-- > 0;) {
        int32_t s = p->first[k];
        for (int32_t v = 3 * s; v < 3 * s + 3 && p->bonded[s]; v++)
            for (int c = 0; c < 3; c++) {
                for (int i = 0; i < 4; i++) f[3 * p->bond[v].on[i] + c] += p->bond[v].share[i] * f[3 * v + c];
                f[3 * v + c] = 0;
            }
    }
}

double wf_prism_forces(const struct wf_prism *p, const double *x, double *f, double of_row[WF_PRISM_ROWS])
{
    double energy[WF_PRISM_ROWS] = { 0 };
    for (size_t i = 0; i < p->springs; i++) {
        const struct wf_prism_spring *s = &p->spring[i];
        const double *from = x + 3 * s->a, *to = s->b < 0 ? p->rest + 3 * s->a : x + 3 * s->b;
        double d[3] = { to[0] - from[0], to[1] - from[1], to[2] - from[2] }, l = sqrt(wf_dot(d, d));
        double stretch = l - s->rest, g = s->b < 0 ? s->k : s->k * stretch / l;
        energy[s->row] += 0.5 * s->k * stretch * stretch;
        for (int c = 0; c < 3; c++) {
            f[3 * s->a + c] += g * d[c];
            if (s->b >= 0) f[3 * s->b + c] -= g * d[c];
        }
    }
    wf_prism_pass(p, f);
    double sum = 0;
    for (int r = 0; r < WF_PRISM_ROWS; r++) {
        sum += energy[r];
        if (of_row) of_row[r] = energy[r];
    }
    return sum;
}

void wf_prism_weight(const struct wf_prism *p, double gravity, double *f)
{
    for (size_t s = 0; s < p->sections; s++)
        for (size_t i = 0; i < 3; i++) {
            const double *m = p->mass + 9 * s + 3 * i;
            f[9 * s + 3 * i + 2] -= gravity * (m[0] + m[1] + m[2]);
        }
    wf_prism_pass(p, f);
}

void wf_prism_frame(const struct wf_prism *p, const double *x, size_t section, double centre[3],
                    double along[3], double left[3], double normal[3])
{
    const double *v = x + 9 * section;
    (void)p;
    for (int c = 0; c < 3; c++) {
        centre[c] = (v[c] + v[3 + c] + v[6 + c]) / 3;
        normal[c] = v[c] - centre[c];
        left[c] = v[3 + c] - v[6 + c];
    }
    unit(left);
    double part = wf_dot(normal, left);
    for (int c = 0; c < 3; c++) normal[c] -= part * left[c];
    unit(normal);
    wf_cross(left, normal, along);
}
