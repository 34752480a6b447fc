#ifndef WF_SOLVE_ROD_PIECE_H
#define WF_SOLVE_ROD_PIECE_H
/* Pieces of rods: each row of a tree cut into equal arcs, short enough to shoot through. */
#include "base/arena.h"
#include "data/tree.h"
#include "load/load.h"
#include "solve/vec.h"
#include <stdint.h>

struct wf_rod_pose {
    double r[3], q[4]; /* place; turn from the unloaded to the loaded state, unit quaternion (w, x, y, z) */
};
struct wf_rod_wrench {
    double n[3], m[3]; /* what the upper part puts on a section */
};

struct wf_rod_piece {
    int32_t parent; /* piece below; -1 = ground                                 */
    int32_t row;
    bool last;         /* the row ends here                                        */
    double s0, s1;     /* share of the row's arc at base and end                   */
    double h;          /* arc length [m]                                           */
    double stiffness;  /* bending stiffness to measure force and moment by [N m2]  */
    double first_step; /* last step the integrator took here, share of the piece   */
    double *step;      /* all it took, see rod_step.h                              */
    size_t steps, room;
};

/* The section and the axis of a row at share s of its arc. */
struct wf_rod_section {
    double ei, gj; /* [N m2] */
    struct wf_line_point line;
    double dead[3]; /* dead line load [N/m] */
};
void wf_rod_section_at(const struct wf_tree *t, const struct wf_loads *l, size_t row, double s,
                       struct wf_rod_section *out);

/* Cut the rows. Given: tree, loads, least number of pieces a row. Returned: pieces in *n, in the order of the
 * rows, from the arena; NULL without room. A row under the force N of all above it is cut so that h
 * sqrt(N/EI), the exponent by which errors of a guess grow along a piece, stays below 1.5. */
struct wf_rod_piece *wf_rod_cut(const struct wf_tree *t, const struct wf_loads *l, int32_t least,
                                struct wf_arena *a, size_t *n);

static inline void wf_rod_turn(const double q[4], const double v[3], double out[3])
{
    double c[3], d[3];
    wf_cross(q + 1, v, c);
    for (int k = 0; k < 3; k++) c[k] += q[0] * v[k];
    wf_cross(q + 1, c, d);
    for (int k = 0; k < 3; k++) out[k] = v[k] + 2 * d[k];
}

static inline void wf_rod_times(const double a[4], const double b[4], double out[4])
{
    double c[3], s = a[0] * b[0] - wf_dot(a + 1, b + 1);
    wf_cross(a + 1, b + 1, c);
    for (int k = 0; k < 3; k++) c[k] += a[0] * b[1 + k] + b[0] * a[1 + k];
    out[0] = s;
    memcpy(out + 1, c, sizeof c);
}

/* exp of half a rotation vector */
static inline void wf_rod_quaternion(const double v[3], double q[4])
{
    double angle = sqrt(wf_dot(v, v)), s = angle > 1e-8 ? sin(0.5 * angle) / angle : 0.5;
    q[0] = cos(0.5 * angle);
    for (int k = 0; k < 3; k++) q[1 + k] = s * v[k];
}

/* rotation vector of a unit quaternion, angle in 0..pi */
static inline void wf_rod_vector(const double q[4], double v[3])
{
    double size = sqrt(wf_dot(q + 1, q + 1)), sign = q[0] < 0 ? -1 : 1;
    double f = size > 1e-150 ? sign * 2 * atan2(size, fabs(q[0])) / size : 2 * sign;
    for (int k = 0; k < 3; k++) v[k] = f * q[1 + k];
}
#endif
