/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/series_leaves.h"
#include "base/vec3.h"
#include "study/series.h"
#include <string.h>

void wf_leaf_matrix(const double angle[3], double R[9])
{
    double sx = sin(angle[0]), cx = cos(angle[0]), sy = sin(angle[1]), cy = cos(angle[1]), sz = sin(angle[2]),
           cz = cos(angle[2]);
    const double all[9] = { cz * cy,
                            cz * sy * sx - sz * cx,
                            cz * sy * cx + sz * sx,
                            sz * cy,
                            sz * sy * sx + cz * cx,
                            sz * sy * cx - cz * sx,
                            -sy,
                            cy * sx,
                            cy * cx };
    memcpy(R, all, sizeof all);
}

void wf_leaf_place(const struct wf_leaf_stand *s, const double (*turn)[9], const double (*end)[3],
                   const double R[9], struct wf_leaf_pose *out)
{
    const double *T = turn[s->row];
    double v[3];
    m3_apply(T, s->axis, out->at);
    for (int k = 0; k < 3; k++) out->at[k] = end[s->row][k] - s->along * out->at[k];
    m3_apply(R, s->direction, v);
    m3_apply(T, v, out->tip);
    m3_apply(R, s->side, v);
    m3_apply(T, v, out->side);
}

static void turn(const double v[3], double x[3])
{
    double R[9];
    rotation_matrix(v, R);
    m3_apply(R, x, x);
}

void wf_leaf_swing(double phi, double psi, struct wf_leaf_pose *p)
{
    const double up[3] = { 0, 0, 1 };
    double hinge[3], size;
    wf_cross(up, p->tip, hinge);
    size = sqrt(wf_dot(hinge, hinge));
    if (!(size > 0)) memcpy(hinge, p->side, sizeof hinge), size = 1; /* hangs straight: about its own side */
    const double swing[3] = { -phi * hinge[0] / size, -phi * hinge[1] / size, -phi * hinge[2] / size };
    const double twist[3] = { 0, 0, psi };
    turn(swing, p->tip), turn(swing, p->side);
    turn(twist, p->tip), turn(twist, p->side);
}

/* Leaves of a run: their own turns, and where they are. */

void wf_leaf_amplitude(double angle, struct wf_leaf_flutter *f)
{
    for (int k = 0; k < 3; k++) f->amplitude[k] = angle / wf_noise_range(&f->octaves);
}

static void in_proportion(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    (void)leaf;
    angle[0] = s->leaves.swing * s->wind[frame];
    angle[1] = s->leaves.twist * s->wind[frame];
}

static void by_noise(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    double time = (double)frame * s->spec.step / s->spec.leaf_period;
    wf_noise_leaf(s->spec.seed, leaf, &s->spec.flutter, time, angle);
}

static void turn_swung(const double angle[3], struct wf_leaf_pose *p)
{
    wf_leaf_swing(angle[0], angle[1], p);
}

const struct wf_leaf_motion wf_leaf_motions[] = {
    { .name = "eq13",
      .title = "swing and twist in proportion to the wind's speed",
      .source = "Tang L., Zou J., Lin D., Chen C. 2012, eq 13",
      .angles = { "swing", "twist" },
      .angle = in_proportion,
      .hang = turn_swung },
    { .name = "noise",
      .title = "turns about three axes from three noises",
      .source = "Zhao P., Zhang Z. 2013, section 3.3",
      .angles = { "theta_x", "theta_y", "theta_z" },
      .angle = by_noise },
    { .name = NULL },
};

const struct wf_leaf_motion *wf_leaf_motion_named(const char *name)
{
    for (const struct wf_leaf_motion *m = wf_leaf_motions; m->name; m++)
        if (!strcmp(m->name, name)) return m;
    return NULL;
}

void wf_series_leaf_angles(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    memset(angle, 0, 3 * sizeof *angle);
    s->spec.leaf_motion->angle(s, leaf, frame, angle);
}

/* Turn that brings a row's unbent direction to its present one, the shortest way. */
static void chord_turn(const struct wf_series *s, size_t row, const double *place, double at[3], double R[9])
{
    const struct wf_tree *t = &s->an.tree;
    const double base[3] = { t->x0[row], t->y0[row], t->z0[row] };
    double was[3] = { t->x1[row] - base[0], t->y1[row] - base[1], t->z1[row] - base[2] }, is[3], v[3],
           foot[3];
    int32_t p = t->parent[row];
    for (int k = 0; k < 3; k++) {
        foot[k] = p >= 0 ? place[3 * p + k] : base[k];
        at[k] = place[3 * row + (size_t)k];
        is[k] = at[k] - foot[k];
    }
    double a = sqrt(wf_dot(was, was)), b = sqrt(wf_dot(is, is));
    wf_cross(was, is, v);
    double size = sqrt(wf_dot(v, v)), angle = atan2(size, wf_dot(was, is));
    for (int k = 0; k < 3; k++) v[k] = size > 1e-12 * a * b ? v[k] * angle / size : 0;
    rotation_matrix(v, R);
}

/* A leaf as its row carries it: by its own turns about the tree's axes where they are such, then by the row.
 */
static void carry(const struct wf_series *s, size_t i, const double R[9], const double own[9],
                  struct wf_leaf_pose *p)
{
    double v[3];
    m3_apply(own, s->leaves.direction + 3 * i, v);
    m3_apply(R, v, p->tip);
    m3_apply(own, s->leaves.side + 3 * i, v);
    m3_apply(R, v, p->side);
}

void wf_series_leaves(const struct wf_series *s, size_t frame, double *at, double *tip)
{
    const struct wf_tree *t = &s->an.tree;
    const struct wf_leaf_motion *motion = s->spec.leaf_motion;
    const double *place = s->place + frame * 3 * t->n, still[3] = { 0 };
    for (size_t i = 0; i < s->leaves.n; i++) {
        size_t row = (size_t)s->leaves.row[i];
        double end[3], R[9], own[9], angle[3], back[3];
        const double axis[3] = { t->x1[row] - t->x0[row], t->y1[row] - t->y0[row], t->z1[row] - t->z0[row] };
        struct wf_leaf_pose p;
        chord_turn(s, row, place, end, R);
        m3_apply(R, axis, back);
        for (int k = 0; k < 3; k++) p.at[k] = end[k] - (1 - s->leaves.place[i]) * back[k];
        wf_series_leaf_angles(s, i, frame, angle);
        wf_leaf_matrix(motion->hang ? still : angle, own);
        carry(s, i, R, own, &p);
        if (motion->hang) motion->hang(angle, &p);
        double length = sqrt(s->leaves.area[i]); /* drawn as long as a square of its area is wide */
        for (size_t k = 0; k < 3; k++) {
            at[3 * i + k] = p.at[k];
            tip[3 * i + k] = p.at[k] + length * p.tip[k];
        }
    }
}
