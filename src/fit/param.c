#include "fit/param.h"
#include <math.h>
#include <string.h>

const struct wf_fit_quantity_row wf_fit_quantities[WF_FIT_QUANTITIES] = {
    [WF_FIT_YOUNGS] = { "levelN.youngs_modulus", WF_DIM_PRESSURE, "GPa", 1e-9, true, 1e8, 1e11,
                        "modulus of elasticity along the grain of a level; 'wood' for levelN: one factor on "
                        "all levels, told as that of level 0" },
    [WF_FIT_YOUNGS_TIP] = { "youngs_modulus_tip_share", WF_DIM_NONE, "", 1, true, 0.05, 20,
                            "modulus at the top of the tree over that at its base, linear with height" },
    [WF_FIT_SHEAR] = { "levelN.shear_modulus", WF_DIM_PRESSURE, "GPa", 1e-9, true, 1e6, 1e10,
                       "shear modulus of a level" },
    [WF_FIT_DENSITY] = { "levelN.density", WF_DIM_DENSITY, "kg/m3", 1, true, 100, 2000,
                         "density of a level as it stands" },
    [WF_FIT_RADIUS] = { "levelN.radius_factor", WF_DIM_NONE, "", 1, true, 0.5, 2,
                        "factor on all radii of a level" },
    [WF_FIT_AXIS_DRAG] = { "levelN.drag_coefficient", WF_DIM_NONE, "", 1, true, 0.05, 5,
                           "cross-flow drag coefficient of a level's axes" },
    [WF_FIT_CROWN_DRAG] = { "crown.drag_coefficient", WF_DIM_NONE, "", 1, true, 0.02, 5,
                            "drag coefficient of the crown on its still-air frontal area" },
    [WF_FIT_VOGEL] = { "crown.streamlining.exponent", WF_DIM_NONE, "", 1, false, -1.9, 0,
                       "Vogel exponent of the crown" },
    [WF_FIT_ROOT] = { "root.stiffness", WF_DIM_ROTATIONAL_STIFFNESS, "kN m/rad", 1e-3, true, 1e2, 1e10,
                      "rotational stiffness of the root plate" },
    [WF_FIT_DAMPING] = { "damping_ratio", WF_DIM_NONE, "%", 100, true, 1e-4, 0.9,
                         "damping ratio of free sway, all causes together" },
    [WF_FIT_FRAME] = { "frame.azimuth", WF_DIM_ANGLE, "deg", 180 / M_PI, false, -M_PI, M_PI,
                       "direction, in the model, of azimuth 0 of measured coordinates (deflection, reach)" },
    [WF_FIT_OFFSET] = { NULL, WF_DIM_NONE, "", 1, false, -1e3, 1e3, "zero of a sensor" },
    [WF_FIT_DRIFT] = { NULL, WF_DIM_NONE, "", 1, false, -1e3, 1e3, "drift of a sensor's zero" },
};

double wf_param_value(const struct wf_fit_param *p, double x)
{
    return wf_fit_quantities[p->quantity].log ? exp(x) : x * p->unit;
}

double wf_param_internal(const struct wf_fit_param *p, double v)
{
    return wf_fit_quantities[p->quantity].log ? log(v) : v / p->unit;
}

bool wf_param_nuisance(const struct wf_fit_param *p)
{
    return p->quantity == WF_FIT_OFFSET || p->quantity == WF_FIT_DRIFT;
}

const char *wf_param_unit(const struct wf_experiment *x, const struct wf_fit_param *p, double *factor)
{
    if (wf_param_nuisance(p)) {
        const struct wf_sensor_row *r = &wf_sensor_rows[x->test[p->test].sensor[p->sensor].kind];
        *factor = r->factor;
        return r->unit;
    }
    *factor = wf_fit_quantities[p->quantity].factor;
    return wf_fit_quantities[p->quantity].unit;
}

/* Does a parameter act on a row of a tree? */
static bool acts(const struct wf_fit_param *p, const struct wf_fit_tree *t, size_t row)
{
    size_t level = (size_t)t->tree.level[row], most = t->species->levels;
    if (level >= most) level = most - 1;
    return p->level < 0 || (size_t)p->level == level;
}

static void scale_rows(const struct wf_fit_param *p, const struct wf_fit_tree *t, struct wf_tree *into,
                       double v)
{
    for (size_t i = 0; i < into->n; i++) {
        if (!acts(p, t, i)) continue;
        size_t level =
            (size_t)t->tree.level[i] < t->species->levels ? (size_t)t->tree.level[i] : t->species->levels - 1;
        const struct wf_level *l = &t->species->level[level];
        double factor = v / t->species->level[0].youngs_modulus.value;
        switch (p->quantity) {
        case WF_FIT_YOUNGS:
            if (p->level >= 0) factor = v / l->youngs_modulus.value;
            into->youngs[i] *= factor;
            if (!l->shear_modulus.given) into->shear[i] *= factor;
            break;
        case WF_FIT_YOUNGS_TIP: {
            double s = 0.5 * (t->tree.z0[i] + t->tree.z1[i] - 2 * t->tree.z0[0]) / t->height;
            into->youngs[i] *= 1 + (v - 1) * s;
            if (!l->shear_modulus.given) into->shear[i] *= 1 + (v - 1) * s;
            break;
        }
        case WF_FIT_SHEAR:
            into->shear[i] *= v / l->shear_modulus.value;
            break;
        case WF_FIT_DENSITY:
            if (into->density[i] > 0) into->density[i] = v;
            break;
        case WF_FIT_RADIUS:
            into->r0[i] *= v, into->r1[i] *= v, into->i0[i] *= v, into->i1[i] *= v;
            break;
        case WF_FIT_AXIS_DRAG:
            if (into->drag[i] != 0) into->drag[i] = v;
            break;
        default:
            into->sail0[i] *= v / t->species->crown_drag.value;
            into->sail1[i] *= v / t->species->crown_drag.value;
        }
    }
}

void wf_param_apply(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                    const double *internal, size_t tree, struct wf_tree *into, struct wf_loads *loads,
                    struct wf_solve_options *options)
{
    const struct wf_fit_tree *t = &x->tree[tree];
    const size_t bytes = t->tree.n * sizeof(double);
    double *const column[][2] = {
        { into->youngs, t->tree.youngs }, { into->shear, t->tree.shear }, { into->density, t->tree.density },
        { into->r0, t->tree.r0 },         { into->r1, t->tree.r1 },       { into->i0, t->tree.i0 },
        { into->i1, t->tree.i1 },         { into->drag, t->tree.drag },   { into->sail0, t->tree.sail0 },
        { into->sail1, t->tree.sail1 },
    };
    for (size_t k = 0; k < sizeof column / sizeof *column; k++) memcpy(column[k][0], column[k][1], bytes);
    *loads = t->loads;
    *options = t->options;
    for (size_t k = 0; k < n; k++) {
        if (wf_param_nuisance(&p[k]) || (p[k].tree >= 0 && (size_t)p[k].tree != tree)) continue;
        double v = wf_param_value(&p[k], internal[k]), *number;
        if (p[k].quantity == WF_FIT_ROOT)
            options->root_stiffness[0] = options->root_stiffness[1] = v;
        else if (p[k].quantity == WF_FIT_VOGEL &&
                 (number = wf_loads_streamline_number(loads, WF_FIT_CROWN_LAW)))
            *number = v;
        else if (p[k].quantity != WF_FIT_VOGEL && p[k].quantity != WF_FIT_DAMPING &&
                 p[k].quantity != WF_FIT_FRAME)
            scale_rows(&p[k], t, into, v);
    }
}
