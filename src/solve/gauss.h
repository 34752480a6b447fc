#ifndef WF_SOLVE_GAUSS_H
#define WF_SOLVE_GAUSS_H
/* Two-stage Gauss collocation on 0..1 (Hairer, Lubich & Wanner 2006, Geometric Numerical Integration,
 * II.1.3). Weights are 1/2 each. */
/* where the stages are */
static const double gauss_place[2] = { 0.21132486540518711775, 0.78867513459481288225 };
#define GAUSS_ROOT3 1.7320508075688772935
/* from the base up to stage i: integral = h sum_j up[i][j] f_j */
static const double gauss_up[2][2] = { { 0.25, 0.25 - GAUSS_ROOT3 / 6 }, { 0.25 + GAUSS_ROOT3 / 6, 0.25 } };
/* from stage i up to the end */
static const double gauss_down[2][2] = { { 0.25, 0.25 + GAUSS_ROOT3 / 6 }, { 0.25 - GAUSS_ROOT3 / 6, 0.25 } };
/* slope at stage i of the quadratic that is 0 at the base: f'_i = sum_j slope[i][j] f_j / h (inverse of up)
 */
static const double gauss_slope[2][2] = { { 3, -3 + 2 * GAUSS_ROOT3 }, { -3 - 2 * GAUSS_ROOT3, 3 } };
/* its value at the end: sum_j gauss_end[j] f_j */
static const double gauss_end[2] = { -GAUSS_ROOT3, GAUSS_ROOT3 };
#endif
