/* What a change of a parameter disturbs in a solved tree, element by element, at a fixed shape. */
#include "fit/predict_parts.h"
#include "solve/beam_small.h"
#include "solve/gauss.h"
#include "solve/vec.h"

bool wf_disturbs(const struct wf_fit_param *p, size_t tree)
{
    if (wf_param_nuisance(p) || p->quantity == WF_FIT_DAMPING || p->quantity == WF_FIT_FRAME) return false;
    return p->tree < 0 || (size_t)p->tree == tree;
}

/* Law moment per unit of ln E (bending, and torsion where G follows E) or of ln G. */
static void by_modulus(const struct wf_beam *b, size_t i, bool bending, bool torsion, double factor,
                       struct wf_beam_disturbance *out)
{
    double m[2][3];
    wf_beam_law_moment(b, i, m);
    for (int j = 0; j < 2; j++) {
        const double *t = b->stage[i].t[j];
        double along = wf_dot(t, m[j]);
        for (int c = 0; c < 3; c++) {
            double twist = along * t[c], bend = m[j][c] - twist;
            out->law[j][c] = factor * ((bending ? bend : 0) + (torsion ? twist : 0));
        }
    }
}

/* Difference of the load at the Gauss points between two states of its inputs, over `step`. */
static void load_at(const struct wf_loads *l, const struct wf_line_point *q, const struct wf_beam *b,
                    size_t i, int j, double force[3])
{
    struct wf_line_load f;
    wf_line_load(l, q, b->stage[i].r[j], b->stage[i].t[j], &f);
    memcpy(force, f.force, sizeof f.force);
}

/* Numeric in the scalar laws only: mass, diameter, coefficients, exponent; relative error below 1e-9. */
static void by_load(const struct wf_disturber *x, const struct wf_beam *b, size_t i,
                    struct wf_beam_disturbance *out)
{
    const double step = 1e-4;
    const struct wf_beam_part *part = &b->mesh.part[i];
    const struct wf_tree *t = b->mesh.tree;
    size_t row = (size_t)part->row;
    for (int j = 0; j < 2; j++) {
        double side[2][3], outer = t->r0[row] + (t->r1[row] - t->r0[row]) * gauss_place[j],
                           inner = t->i0[row] + (t->i1[row] - t->i0[row]) * gauss_place[j];
        double wood = t->density[row] * M_PI * (outer * outer - inner * inner);
        for (int k = 0; k < 2; k++) {
            double up = k ? step : -step, factor = exp(up), *number;
            struct wf_loads l = b->loads;
            struct wf_line_point q = part->line[j];
            switch (x->param->quantity) {
            case WF_FIT_DENSITY:
                q.mass += wood * (factor - 1);
                break;
            case WF_FIT_RADIUS:
                q.diameter *= factor, q.mass += wood * (factor * factor - 1);
                break;
            case WF_FIT_AXIS_DRAG:
                q.drag *= factor;
                break;
            case WF_FIT_CROWN_DRAG:
                q.sail *= factor;
                break;
            default: /* Vogel exponent; its internal value is the exponent itself over `unit` */
                if ((number = wf_loads_streamline_number(&l, WF_FIT_CROWN_LAW)))
                    *number += up * x->param->unit;
            }
            load_at(&l, &q, b, i, j, side[k]);
        }
        for (int c = 0; c < 3; c++) out->force[j][c] = (side[1][c] - side[0][c]) / (2 * step);
    }
}

void wf_disturb(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out)
{
    const struct wf_disturber *x = ctx;
    const struct wf_fit_tree *t = x->tree;
    size_t row = (size_t)b->mesh.part[i].row, level = (size_t)t->tree.level[row];
    if (level >= t->species->levels) level = t->species->levels - 1;
    if (x->param->level >= 0 && (size_t)x->param->level != level) return;
    bool follows = !t->species->level[level].shear_modulus.given;
    switch (x->param->quantity) {
    case WF_FIT_YOUNGS:
        by_modulus(b, i, true, follows, 1, out);
        return;
    case WF_FIT_YOUNGS_TIP: {
        double s = 0.5 * (t->tree.z0[row] + t->tree.z1[row] - 2 * t->tree.z0[0]) / t->height;
        double q = exp(x->internal);
        by_modulus(b, i, true, follows, q * s / (1 + (q - 1) * s), out);
        return;
    }
    case WF_FIT_SHEAR:
        by_modulus(b, i, false, true, 1, out);
        return;
    case WF_FIT_ROOT:
        return;
    case WF_FIT_RADIUS:
        by_modulus(b, i, true, true, 4, out);
        by_load(x, b, i, out);
        return;
    default:
        by_load(x, b, i, out);
    }
}
