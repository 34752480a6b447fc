/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_mesh.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include <math.h>

/* eight-point Gauss-Legendre rule on 0..1, exact to degree 15 */
static const double gauss8[8] = { 0.01985507175123188416, 0.10166676129318663020, 0.23723379504183550709,
                                  0.40828267875217509753, 0.59171732124782490247, 0.76276620495816449291,
                                  0.89833323870681336980, 0.98014492824876811584 };
static const double weight8[8] = { 0.05061426814518812958, 0.11119051722668723527, 0.15685332293894364367,
                                   0.18134189168918099148, 0.18134189168918099148, 0.15685332293894364367,
                                   0.11119051722668723527, 0.05061426814518812958 };

/* A row is an arc of constant curvature between two points; its tangents follow from chord and curvature
 * vector. */
void wf_row_axis(const struct wf_tree *t, size_t i, double s, double position[3], double tangent[3])
{
    const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
    double chord[3] = { t->x1[i] - base[0], t->y1[i] - base[1], t->z1[i] - base[2] };
    double size = sqrt(wf_dot(chord, chord)), curvature = 0;
    if (t->bend) curvature = sqrt(wf_dot(t->bend + 3 * i, t->bend + 3 * i));
    if (!(curvature > 0)) {
        for (int k = 0; k < 3; k++) {
            position[k] = base[k] + s * chord[k];
            tangent[k] = chord[k] / size;
        }
        return;
    }
    double angle = wf_tree_length(t, i) * curvature, turn[3], R[9], half[3], along[3];
    for (int k = 0; k < 3; k++) turn[k] = t->bend[3 * i + (size_t)k] / curvature;
    for (int k = 0; k < 3; k++) half[k] = (s - 0.5) * angle * turn[k], along[k] = chord[k] / size;
    rotation_matrix(half, R);
    m3_apply(R, along, tangent);
    /* the chord from the base to arc fraction s has length sin(s angle/2)/sin(angle/2) of the whole */
    for (int k = 0; k < 3; k++) half[k] = (s - 1) * 0.5 * angle * turn[k];
    rotation_matrix(half, R);
    m3_apply(R, along, position);
    double share = size * sin(0.5 * s * angle) / sin(0.5 * angle);
    for (int k = 0; k < 3; k++) position[k] = base[k] + share * position[k];
}

void wf_beam_first_pieces(const struct wf_tree *t, const struct wf_solve_options *o, int32_t *pieces)
{
    enum { FEW = 24, FOOT = 3 }; /* elements */
    for (size_t i = 0; i < t->n; i++) {
        const int32_t some = t->n < FEW ? (int32_t)((FEW - 1) / t->n + 1) : t->parent[i] < 0 ? FOOT : 1;
        pieces[i] = o->mesh_tolerance > 0 ? some : 1;
    }
}

void wf_beam_second_pieces(const struct wf_tree *t, int32_t *pieces)
{
    enum { FOOT = 30, SHARE = 32 }; /* pieces of a row as long as the tree is high; a 32nd of all rows */
    double height = 0, feet = 0;
    for (size_t i = 0; i < t->n; i++) {
        pieces[i] *= 2;
        height = fmax(height, t->z1[i] - t->z0[0]);
        feet += t->parent[i] < 0;
    }
    const double most = floor((double)t->n / (SHARE * feet));
    for (size_t i = 0; i < t->n && height > 0; i++)
        if (t->parent[i] < 0)
            pieces[i] =
                (int32_t)fmax(pieces[i], fmin(2 * most, ceil(FOOT * cbrt(wf_tree_length(t, i) / height))));
}

int32_t wf_beam_piece_at(const struct wf_beam_mesh *m, size_t row, double s, double *x)
{
    const int32_t cut = wf_beam_pieces(m, row);
    if (!wf_beam_graded(m, row)) {
        const int32_t k = (int32_t)fmin(floor(s * cut), cut - 1);
        *x = s * cut - k;
        return k;
    }
    int32_t k = 0, above = cut;
    while (above - k > 1) {
        const int32_t middle = k + (above - k) / 2;
        if (s < wf_beam_cut(m, row, middle, cut))
            above = middle;
        else
            k = middle;
    }
    const double from = wf_beam_cut(m, row, k, cut);
    *x = (s - from) / (wf_beam_cut(m, row, k + 1, cut) - from);
    return k;
}

struct row_stiffness {
    double ei, gj, ea, ga;
    double across; /* bending stiffness about the width, of a section that is not round */
};

WF_INLINE struct row_stiffness round_stiffness(double youngs, double shear, double shear_factor, double s,
                                               double r0, double r1, double i0, double i1)
{
    double a = wf_between(r0, r1, s), b = wf_between(i0, i1, s), m = b / a;
    double area = wf_ring_area(a, b), inertia = wf_ring_inertia(a, b);
    /* Cowper 1966, J. Appl. Mech. 33:335, hollow circle */
    double nu = youngs / (2 * shear) - 1, q = (1 + m * m) * (1 + m * m), p = m * m;
    double cowper = 6 * (1 + nu) * q / ((7 + 6 * nu) * q + (20 + 12 * nu) * p);
    double k = shear_factor > 0 ? shear_factor : cowper;
    return (struct row_stiffness){
        .ea = youngs * area, .ga = k * shear * area, .ei = youngs * inertia, .gj = shear * 2 * inertia
    };
}

/* 5/6: the shear factor of a rectangle without lateral contraction, for all shapes */
static struct row_stiffness flat_stiffness_at(const struct wf_tree *t, size_t i, double s,
                                              double shear_factor)
{
    struct wf_section c;
    wf_section_at(t, i, s, &c);
    return (struct row_stiffness){ .ei = t->youngs[i] * c.lying,
                                   .across = t->youngs[i] * c.upright,
                                   .gj = t->shear[i] * c.torsion,
                                   .ea = t->youngs[i] * c.area,
                                   .ga = (shear_factor > 0 ? shear_factor : 5. / 6) * t->shear[i] * c.area };
}

static struct row_stiffness stiffness_at(const struct wf_tree *t, size_t i, double s, double shear_factor)
{
    if (t->stiff) {
        const double *k = t->stiff + 4 * i;
        return (struct row_stiffness){ .ea = k[0], .ga = k[1], .ei = k[2], .gj = k[3] };
    }
    if (!wf_section_is_ring(t, i)) return flat_stiffness_at(t, i, s, shear_factor);
    struct row_stiffness round =
        round_stiffness(t->youngs[i], t->shear[i], shear_factor, s, wf_wood_end(t, i, 0),
                        wf_wood_end(t, i, 1), t->i0[i], t->i1[i]);
    round.across = round.ei;
    return round;
}

/* Compliances at the two Gauss points that reproduce the integrals of c and s c over the piece s0..s1 of the
 * row. */
static void two_moments(const double *c8, double out[2])
{
    double i0 = 0, i1 = 0;
    for (int k = 0; k < 8; k++) i0 += weight8[k] * c8[k], i1 += weight8[k] * gauss8[k] * c8[k];
    out[1] = 2 * (i1 - gauss_place[0] * i0) / (gauss_place[1] - gauss_place[0]);
    out[0] = 2 * i0 - out[1];
}

/* Compliances of a round row at the eight points, as stiffness_at has them, one a lane. */
WF_WIDE static void round_compliances(const struct wf_tree *t, size_t i, double s0, double s1,
                                      double shear_factor, double bend[8], double twist[8], double stretch[8],
                                      double slide[8])
{
    const double youngs = t->youngs[i], shear = t->shear[i], r0 = wf_wood_end(t, i, 0),
                 r1 = wf_wood_end(t, i, 1), i0 = t->i0[i], i1 = t->i1[i];
    for (int k = 0; k < 8; k++) {
        struct row_stiffness s =
            round_stiffness(youngs, shear, shear_factor, wf_between(s0, s1, gauss8[k]), r0, r1, i0, i1);
        bend[k] = 1 / s.ei, twist[k] = 1 / s.gj, stretch[k] = 1 / s.ea, slide[k] = 1 / s.ga;
    }
}

static void set_stiffness(const struct wf_tree *t, size_t i, double s0, double s1,
                          const struct wf_solve_options *o, struct wf_beam_part *p)
{
    double bend[8], twist[8], stretch[8], slide[8], c[2];
    if (!t->stiff && !t->section)
        round_compliances(t, i, s0, s1, o->shear_factor, bend, twist, stretch, slide);
    for (int k = 0; k < 8 && (t->stiff || t->section); k++) {
        struct row_stiffness s = stiffness_at(t, i, wf_between(s0, s1, gauss8[k]), o->shear_factor);
        bend[k] = 1 / s.ei, twist[k] = 1 / s.gj, stretch[k] = 1 / s.ea, slide[k] = 1 / s.ga;
    }
    two_moments(bend, c);
    bool extreme = !(c[0] > 0 && c[1] > 0); /* a piece that tapers to a point: plain values at the Gauss
                                               points; the mesh refinement reduces the error */
    for (int j = 0; j < 2; j++) {
        struct row_stiffness s = stiffness_at(t, i, wf_between(s0, s1, gauss_place[j]), o->shear_factor);
        p->ei[j] = extreme ? s.ei : 1 / c[j];
        p->gj[j] = s.gj, p->ca[j] = 1 / s.ea, p->cs[j] = 1 / s.ga;
    }
    if (!extreme) {
        two_moments(twist, c);
        for (int j = 0; j < 2; j++) p->gj[j] = 1 / c[j];
        two_moments(stretch, p->ca);
        two_moments(slide, p->cs);
    }
    for (int j = 0; j < 2; j++) {
        if (o->inextensible) p->ca[j] = 0;
        if (o->inextensible || !o->shear_flexible) p->cs[j] = 0;
    }
}

/* Additional constants of an element that is not round; set_stiffness sets ei. */
static void set_flat_section(const struct wf_tree *t, size_t i, double s0, double s1,
                             const struct wf_solve_options *o, const struct wf_beam_part *p,
                             struct wf_beam_flat *f)
{
    const struct wf_tree_sections *sections = t->section;
    double bend[8], c[2];
    for (int k = 0; k < 8; k++)
        bend[k] = 1 / stiffness_at(t, i, wf_between(s0, s1, gauss8[k]), o->shear_factor).across;
    two_moments(bend, c);
    bool extreme = !(c[0] > 0 && c[1] > 0);
    for (int j = 0; j < 2; j++) {
        double s = wf_between(s0, s1, gauss_place[j]), ei = 1 / c[j];
        if (extreme) ei = stiffness_at(t, i, s, o->shear_factor).across;
        f->more[j] = ei - p->ei[j];
        f->give[j] = 1 / ei - 1 / p->ei[j];
        wf_cross(sections->up + 3 * i, p->t[j], f->across[j]);
        f->side[j] = wf_between(sections->side0[i], sections->side1[i], s);
    }
}

static void set_gauss_point(const struct wf_tree *t, const struct wf_loads *l, size_t i, double s,
                            struct wf_beam_part *p, int j)
{
    double a = wf_between(t->r0[i], t->r1[i], s), b = wf_between(t->i0[i], t->i1[i], s), at[3];
    wf_row_axis(t, i, s, at, p->t[j]);
    p->line[j] = wf_line_point_of(t, i, s);
    p->spin[j] = t->density[i] * 0.5 * WF_PI * (a * a * a * a - b * b * b * b);
    if (t->section && t->section->width0[i] > 0) {
        struct wf_section c;
        wf_section_at(t, i, s, &c);
        p->spin[j] = t->density[i] * (c.upright + c.lying);
    }
    if (l->line)
        for (size_t k = 0; k < 3; k++)
            p->dead[j][k] = wf_between(l->line[6 * i + k], l->line[6 * i + 3 + k], s);
}

/* What element `at` carried, the piece s0..s1 of its row. */
static void set_standing(struct wf_beam_mesh *m, size_t at, double s0, double s1)
{
    if (!m->standing) return;
    const struct wf_tree *t = m->tree;
    const struct wf_tree_standing *was = t->standing;
    const struct wf_beam_part *p = &m->part[at];
    const size_t i = (size_t)p->row;
    struct wf_beam_standing *x = &m->standing[at];
    for (int j = 0; j < 2; j++) {
        double s = wf_between(s0, s1, gauss_place[j]);
        x->mass[j] = t->density[i] * wf_tree_area(t, i, s) + wf_between(was->burden0[i], was->burden1[i], s);
        if (was->side0) x->side[j] = wf_between(was->side0[i], was->side1[i], s);
    }
}

/* Ends of the rows in the given shape, as the elements place them. */
static void place_still(struct wf_beam_mesh *m)
{
    const struct wf_tree *t = m->tree;
    for (size_t i = 0; i < t->n && m->still; i++) {
        const double foot[3] = { t->x0[i], t->y0[i], t->z0[i] };
        memcpy(m->still[i], t->parent[i] < 0 ? foot : m->still[t->parent[i]], sizeof foot);
        for (int32_t k = m->first[i]; k <= m->last[i]; k++)
            for (int c = 0; c < 3; c++)
                m->still[i][c] += 0.5 * m->part[k].h * (m->part[k].t[0][c] + m->part[k].t[1][c]);
    }
}

static enum wf_status check_joined(const struct wf_tree *t, size_t i, struct wf_err *e)
{
    if (t->parent[i] < 0) return WF_OK;
    size_t p = (size_t)t->parent[i];
    double gap[3] = { t->x0[i] - t->x1[p], t->y0[i] - t->y1[p], t->z0[i] - t->z1[p] };
    double size = sqrt(wf_dot(gap, gap));
    if (size <= 1e-6) return WF_OK;
    if (size <= 1e-6 * (1 + wf_tree_length(t, i))) return WF_OK;
    return wf_fail(e, WF_EINPUT, "segment %lld starts %.3g m away from the end of its parent %lld",
                   (long long)t->id[i], size, (long long)t->id[p]);
}

enum wf_status wf_beam_mesh_build(const struct wf_tree *t, const struct wf_loads *l,
                                  const struct wf_solve_options *o, const int32_t *pieces, struct wf_arena *a,
                                  struct wf_beam_mesh *m, struct wf_err *e)
{
    *m = (struct wf_beam_mesh){ .tree = t };
    for (size_t i = 0; i < t->n; i++) m->n += pieces ? (size_t)pieces[i] : 1;
    m->part = WF_TAKE(a, m->n, struct wf_beam_part);
    m->first = WF_TAKE(a, t->n, int32_t);
    m->last = WF_TAKE(a, t->n, int32_t);
    if (t->mass1) m->mass1 = WF_TAKE(a, m->n, double);
    if (t->section) m->flat = WF_TAKE(a, m->n, struct wf_beam_flat);
    if (t->standing) m->standing = WF_TAKE(a, m->n, struct wf_beam_standing);
    if (t->standing) m->root = wf_arena_take(a, t->n, sizeof *m->root);
    if (t->standing) m->still = wf_arena_take(a, t->n, sizeof *m->still);
    if (!m->part || !m->first || !m->last || (t->mass1 && !m->mass1) || (t->section && !m->flat) ||
        (t->standing && (!m->standing || !m->root || !m->still)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu beam elements", m->n);
    m->graded = o->mesh_tolerance > 0 && wf_loads_sheared(l);
    int32_t at = 0;
    for (size_t i = 0; i < t->n; i++) {
        int32_t cut = pieces ? pieces[i] : 1;
        enum wf_status status = check_joined(t, i, e);
        if (status) return status;
        m->first[i] = at;
        for (int32_t k = 0; k < cut; k++, at++) {
            struct wf_beam_part *p = m->part + at;
            double s0 = wf_beam_cut(m, i, k, cut), s1 = wf_beam_cut(m, i, k + 1, cut);
            p->row = (int32_t)i;
            p->parent = k ? at - 1 : t->parent[i] < 0 ? -1 : m->last[t->parent[i]];
            p->h = wf_tree_length(t, i) * (s1 - s0);
            set_stiffness(t, i, s0, s1, o, p);
            for (int j = 0; j < 2; j++) set_gauss_point(t, l, i, wf_between(s0, s1, gauss_place[j]), p, j);
            if (t->section) set_flat_section(t, i, s0, s1, o, p, m->flat + at);
            set_standing(m, (size_t)at, s0, s1);
        }
        m->last[i] = at - 1;
        if (t->mass1) m->mass1[at - 1] = t->mass1[i];
    }
    place_still(m);
    return WF_OK;
}
