#include "study/series_leaf.h"
#include "solve/vec.h"

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
