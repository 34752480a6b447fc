#include "cases/solve.h"
#include "base/vec.h"
#include <math.h>

enum wf_status wf_setup_solve(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              struct wf_response *r, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    enum wf_status status = solver->solve(&s->tree, &s->loads, &s->options, a, r, &d, e);
    if (status) return status;
    char text[800];
    if (d.errors) return wf_fail(e, WF_EINPUT, "%s", wf_finding_print(d.first, text, sizeof text));
    if (!(r->load_factor >= 1.0))
        return wf_fail(e, WF_EUNSTABLE, "only %.4g of the load was carried", r->load_factor);
    return WF_OK;
}

enum wf_status wf_rigid_drag(const struct wf_setup *s, double *drag, struct wf_err *e)
{
    static const double place[2] = { 0.33998104358485626480, 0.86113631159405257522 };
    static const double weight[2] = { 0.65214515486254614263, 0.34785484513745385737 };
    const struct wf_tree *t = &s->tree;
    if (!s->loads.wind) return wf_fail(e, WF_EINPUT, "without wind there is no drag to compare with");
    *drag = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double base[3] = { t->x0[i], t->y0[i], t->z0[i] }, end[3] = { t->x1[i], t->y1[i], t->z1[i] }, axis[3],
               x[3];
        double length = wf_tree_length(t, i), chord = 0.0;
        for (int k = 0; k < 3; k++) axis[k] = end[k] - base[k], chord += axis[k] * axis[k];
        for (int k = 0; k < 3; k++) axis[k] /= sqrt(chord);
        for (int g = 0; g < 4; g++) {
            double u = 0.5 * (1.0 + (g % 2 ? 1.0 : -1.0) * place[g / 2]);
            struct wf_line_parts parts;
            struct wf_line_point p = { .diameter = 2.0 * (t->r0[i] + u * (t->r1[i] - t->r0[i])),
                                       .drag = t->drag[i] };
            for (int k = 0; k < 3; k++) x[k] = base[k] + u * (end[k] - base[k]);
            wf_line_parts(&s->loads, &p, x, axis, &parts);
            *drag += 0.5 * weight[g / 2] * length * wf_dot(parts.drag_axis, s->wind.direction);
        }
    }
    return WF_OK;
}

enum wf_status wf_local_vogel(const struct wf_setup *s, const struct wf_solver *solver, struct wf_arena *a,
                              double *v, struct wf_err *e)
{
    static const double step[4] = { -2, -1, 1, 2 }, coefficient[4] = { 1. / 12, -8. / 12, 8. / 12, -1. / 12 };
    const double h = 0.01;
    if (!s->loads.wind) return wf_fail(e, WF_EINPUT, "without wind there is no Vogel exponent");
    *v = -2.0;
    for (int i = 0; i < 4; i++) {
        struct wf_setup other = *s;
        struct wf_response r;
        other.loads.wind = &other.wind;
        other.wind.speed = s->wind.speed * exp(step[i] * h);
        if (wf_setup_solve(&other, solver, a, &r, e)) return e->code;
        double f = wf_dot(r.base_force, s->wind.direction);
        if (!(f > 0.0)) return wf_fail(e, WF_EINPUT, "the force along the wind is not positive");
        *v += coefficient[i] * log(f) / h;
    }
    return WF_OK;
}
