#include "base/vec.h"
#include "cases/measure.h"
#include <math.h>
#include <string.h>

/* Point at share s of a row's arc: on the chord of a straight row, on the circle of a bent one. A circle of
 * curvature vector k (perpendicular to the chord of length c, direction d) starts along d turned back by half
 * its angle about k. */
static void point_at(const struct wf_tree *t, size_t i, double s, double x[3])
{
    double base[3] = { t->x0[i], t->y0[i], t->z0[i] }, chord[3], along[3], side[3];
    for (int j = 0; j < 3; j++) chord[j] = (double[]){ t->x1[i], t->y1[i], t->z1[i] }[j] - base[j];
    double c = sqrt(wf_dot(chord, chord)),
           kappa = t->bend ? sqrt(wf_dot(t->bend + 3 * i, t->bend + 3 * i)) : 0.0;
    if (kappa * c < 1e-12) {
        for (int j = 0; j < 3; j++) x[j] = base[j] + s * chord[j];
        return;
    }
    double angle = 2.0 * asin(0.5 * kappa * c), unit[3];
    for (int j = 0; j < 3; j++) unit[j] = t->bend[3 * i + (size_t)j] / kappa, along[j] = chord[j] / c;
    wf_cross(unit, along, side);
    /* tangent at the base: cos(a/2) d - sin(a/2) (k x d); its normal: cos(a/2) (k x d) + sin(a/2) d */
    double ch = cos(0.5 * angle), sh = sin(0.5 * angle), u = sin(s * angle) / kappa,
           v = (1.0 - cos(s * angle)) / kappa;
    for (int j = 0; j < 3; j++)
        x[j] = base[j] + u * (ch * along[j] - sh * side[j]) + v * (ch * side[j] + sh * along[j]);
}

static double between(double a, double b, double s) { return a + s * (b - a); }

static void split_row(const struct wf_tree *t, const double *line, size_t i, size_t pieces, struct wf_tree *o,
                      double *out_line)
{
    for (size_t p = 0; p < pieces; p++) {
        size_t j = i * pieces + p;
        double s0 = (double)p / (double)pieces, s1 = (double)(p + 1) / (double)pieces, x[3];
        o->parent[j] = p                  ? (int32_t)j - 1
                       : t->parent[i] < 0 ? -1
                                          : (int32_t)((size_t)t->parent[i] * pieces + pieces - 1);
        o->level[j] = t->level[i];
        o->id[j] = t->id[i];
        point_at(t, i, s0, x);
        o->x0[j] = x[0], o->y0[j] = x[1], o->z0[j] = x[2];
        point_at(t, i, s1, x);
        o->x1[j] = x[0], o->y1[j] = x[1], o->z1[j] = x[2];
        double *const pair[][4] = { { t->r0, t->r1, o->r0, o->r1 },
                                    { t->i0, t->i1, o->i0, o->i1 },
                                    { t->sail0, t->sail1, o->sail0, o->sail1 },
                                    { t->leaf0, t->leaf1, o->leaf0, o->leaf1 },
                                    { t->burden0, t->burden1, o->burden0, o->burden1 } };
        for (size_t k = 0; k < sizeof pair / sizeof *pair; k++) {
            pair[k][2][j] = between(pair[k][0][i], pair[k][1][i], s0);
            pair[k][3][j] = between(pair[k][0][i], pair[k][1][i], s1);
        }
        double *const same[][2] = { { t->youngs, o->youngs },   { t->shear, o->shear },
                                    { t->density, o->density }, { t->strength, o->strength },
                                    { t->drag, o->drag },       { t->lift, o->lift },
                                    { t->damping, o->damping } };
        for (size_t k = 0; k < sizeof same / sizeof *same; k++) same[k][1][j] = same[k][0][i];
        if (t->bend) memcpy(o->bend + 3 * j, t->bend + 3 * i, 3 * sizeof(double));
        if (t->stiff) memcpy(o->stiff + 4 * j, t->stiff + 4 * i, 4 * sizeof(double));
        if (t->mass1) o->mass1[j] = p + 1 == pieces ? t->mass1[i] : 0.0;
        for (size_t k = 0; line && k < 3; k++) {
            out_line[6 * j + k] = between(line[6 * i + k], line[6 * i + 3 + k], s0);
            out_line[6 * j + 3 + k] = between(line[6 * i + k], line[6 * i + 3 + k], s1);
        }
    }
}

enum wf_status wf_tree_split(const struct wf_tree *t, const double *line, size_t pieces, struct wf_arena *a,
                             struct wf_tree *out, double **out_line, struct wf_err *e)
{
    size_t n = t->n * pieces;
    if (pieces == 0 || n / pieces != t->n || n > INT32_MAX)
        return wf_fail(e, WF_EINPUT, "a mesh of %zu x %zu rows is too fine", t->n, pieces);
    if (wf_tree_alloc(out, n, a, e)) return e->code;
    out->name = t->name;
    *out_line = line ? WF_TAKE(a, 6 * n, double) : NULL;
    if (t->bend) out->bend = WF_TAKE(a, 3 * n, double);
    if (t->stiff) out->stiff = WF_TAKE(a, 4 * n, double);
    if (t->mass1) out->mass1 = WF_TAKE(a, n, double);
    if ((line && !*out_line) || (t->bend && !out->bend) || (t->stiff && !out->stiff) ||
        (t->mass1 && !out->mass1))
        return wf_fail(e, WF_ENOMEM, "no memory for a tree of %zu rows", n);
    for (size_t i = 0; i < t->n; i++) split_row(t, line, i, pieces, out, *out_line);
    return WF_OK;
}
