#include "solve/chain_row.h"
#include "base/vec.h"
#include <math.h>

enum { N = WF_CHAIN_POINTS };
#define PI 3.14159265358979323846

/* abscissae and weights on -1..1, Abramowitz & Stegun 1964, table 25.4 */
static const double node[N / 2] = { 0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                    0.96028985649753623168 };
static const double weight[N / 2] = { 0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                      0.10122853629037625915 };

void wf_chain_rule_fill(struct wf_chain_rule *g)
{
    for (int k = 0; k < N / 2; k++) {
        g->x[N / 2 - 1 - k] = 0.5 * (1 - node[k]), g->x[N / 2 + k] = 0.5 * (1 + node[k]);
        g->w[N / 2 - 1 - k] = g->w[N / 2 + k] = 0.5 * weight[k];
    }
    for (int k = 0; k < N; k++)
        for (int j = 0; j < N; j++) {
            double sum = 0;
            for (int m = 0; m < N; m++) { /* (x - x_k) times Lagrange's polynomial j, from x_k to 1 */
                double arm = (1 - g->x[k]) * g->x[m], x = g->x[k] + arm, lagrange = 1;
                for (int q = 0; q < N; q++)
                    if (q != j) lagrange *= (x - g->x[q]) / (g->x[j] - g->x[q]);
                sum += g->w[m] * arm * lagrange;
            }
            g->above[k][j] = (1 - g->x[k]) * sum;
        }
}

static double between(double a, double b, double s) { return a + (b - a) * s; }

/* Compliance in bending and torsion at s. */
static void compliance(const struct wf_tree *t, size_t i, double s, double *bending, double *torsion)
{
    double outer = between(t->r0[i], t->r1[i], s), inner = between(t->i0[i], t->i1[i], s);
    double inertia = 0.25 * PI * (pow(outer, 4) - pow(inner, 4));
    double ei = t->stiff ? t->stiff[4 * i + 2] : t->youngs[i] * inertia;
    double gj = t->stiff ? t->stiff[4 * i + 3] : t->shear[i] * 2 * inertia;
    *bending = 1 / ei;
    *torsion = 1 / gj;
}

/* Line load at s [N/m]: wind and weight on the unbent axis, and the dead line load. */
static void line_load(const struct wf_tree *t, size_t i, const struct wf_loads *l, const double base[3],
                      const double axis[3], double length, double s, double q[3])
{
    double outer = between(t->r0[i], t->r1[i], s), inner = between(t->i0[i], t->i1[i], s), x[3];
    for (int k = 0; k < 3; k++) x[k] = base[k] + s * length * axis[k];
    struct wf_line_point p = { .diameter = 2 * outer,
                               .drag = t->drag[i],
                               .lift = t->lift[i],
                               .sail = between(t->sail0[i], t->sail1[i], s),
                               .mass = t->density[i] * PI * (outer * outer - inner * inner) +
                                       between(t->burden0[i], t->burden1[i], s) };
    struct wf_line_load f;
    wf_line_load(l, &p, x, axis, &f);
    for (size_t k = 0; k < 3; k++) {
        q[k] = f.force[k];
        if (l->line) q[k] += l->point_scale * between(l->line[6 * i + k], l->line[6 * i + 3 + k], s);
    }
}

static double ratio(double a, double b) { return a > b ? a / b : b / a; }

/* Panels over which neither the radius nor the wall changes by more than a factor 1.5; their limits are
 * in geometric progression of whichever changes more. */
struct panels {
    double v0, v1;
    int n;
};

static struct panels panels_of(const struct wf_tree *t, size_t i)
{
    double r0 = t->r0[i], r1 = t->r1[i], w0 = r0 - t->i0[i], w1 = r1 - t->i1[i];
    struct panels p = { r0, r1, 1 };
    if (ratio(w0, w1) > ratio(r0, r1)) p.v0 = w0, p.v1 = w1;
    p.n += (int)floor(log(ratio(p.v0, p.v1)) / log(1.5));
    return p;
}

static double panel_limit(const struct panels *p, int k)
{
    if (k == 0 || k == p->n) return k == 0 ? 0 : 1;
    return (p->v0 * pow(p->v1 / p->v0, (double)k / p->n) - p->v0) / (p->v1 - p->v0);
}

void wf_chain_row_bend(const struct wf_chain_rule *g, const struct wf_chain_scheme *c,
                       const struct wf_tree *t, size_t i, const struct wf_loads *l, const double force[3],
                       const double moment[3], struct wf_chain_row *out)
{
    const double base[3] = { t->x0[i], t->y0[i], t->z0[i] };
    double axis[3] = { t->x1[i] - base[0], t->y1[i] - base[1], t->z1[i] - base[2] };
    double length = sqrt(wf_dot(axis, axis)), shear[3] = { 0 }, lever[3] = { 0 };
    for (int k = 0; k < 3; k++) axis[k] /= length;
    struct panels p = panels_of(t, i);
    *out = (struct wf_chain_row){ 0 };

    /* shear and lever: line load above the panel, summed, and its first moment about the panel's upper end */
    for (int part = p.n; part-- > 0;) {
        double low = panel_limit(&p, part), h = (panel_limit(&p, part + 1) - low) * length, q[N][3];
        for (int j = 0; j < N; j++) line_load(t, i, l, base, axis, length, low + g->x[j] * h / length, q[j]);
        for (int k = 0; k < N; k++) {
            double s = low + g->x[k] * h / length, arm = (1 - s) * length, up = (1 - g->x[k]) * h;
            double reach = arm * (1 - c->smear + 0.5 * c->smear * (1 - s)), side[3], m[3], curvature[3], v[3];
            double bending, torsion, mean = 0.5 + c->taper * (s - 0.5);
            for (int x = 0; x < 3; x++) {
                side[x] = reach * force[x] + lever[x] + up * shear[x];
                for (int j = 0; j < N; j++) side[x] += h * h * g->above[k][j] * q[j][x];
            }
            wf_cross(axis, side, m);
            for (int x = 0; x < 3; x++) m[x] += c->moment * moment[x];
            compliance(t, i, mean, &bending, &torsion);
            double twist = (torsion - bending) * wf_dot(m, axis);
            for (int x = 0; x < 3; x++) curvature[x] = bending * m[x] + twist * axis[x];
            wf_cross(curvature, axis, v);
            for (int x = 0; x < 3; x++) {
                out->turn[x] += g->w[k] * h * curvature[x];
                out->bend[x] += g->w[k] * h * arm * v[x];
            }
        }
        for (int x = 0; x < 3; x++) {
            lever[x] += h * shear[x];
            for (int j = 0; j < N; j++) {
                lever[x] += g->w[j] * h * g->x[j] * h * q[j][x];
                shear[x] += g->w[j] * h * q[j][x];
            }
        }
    }
    wf_cross(axis, lever, out->load_moment);
    for (int x = 0; x < 3; x++) out->load[x] = shear[x];
}
