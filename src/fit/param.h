/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_PARAM_H
#define WF_FIT_PARAM_H
/* Parameters of a fit. Quantities are rows; a free parameter is a quantity of a level and a tree. The least
 * squares solver uses internal values: the logarithm of positive quantities, others over `unit`. */
#include "fit/experiment.h"

/* Parameter of a crown's streamlining law that can be fitted (WF_FIT_VOGEL). */
#define WF_FIT_CROWN_LAW "exponent"

enum wf_fit_quantity {
    WF_FIT_YOUNGS,
    WF_FIT_YOUNGS_TIP, /* E at the top of the tree over E at its base, linear between */
    WF_FIT_SHEAR,
    WF_FIT_DENSITY,
    WF_FIT_RADIUS, /* factor on all radii                                          */
    WF_FIT_AXIS_DRAG,
    WF_FIT_CROWN_DRAG,
    WF_FIT_VOGEL,
    WF_FIT_ROOT,    /* rotational stiffness of the root plate about any horizontal axis */
    WF_FIT_DAMPING, /* damping ratio of free sway, sum of all causes                    */
    WF_FIT_FRAME,   /* azimuth, in the model, of the measured coordinates' x axis       */
    WF_FIT_OFFSET,  /* zero of one sensor                                               */
    WF_FIT_DRIFT,   /* its change with time                                             */
    WF_FIT_QUANTITIES
};
struct wf_fit_quantity_row {
    const char *name; /* "levelN.youngs_modulus": N is a number; NULL: users cannot name it */
    enum wf_dimension dimension;
    const char *unit; /* shown in reports */
    double factor;    /* SI to that unit  */
    bool log;
    double low, high; /* bounds unless others are given [SI] */
    const char *doc;
};
extern const struct wf_fit_quantity_row wf_fit_quantities[WF_FIT_QUANTITIES];

/* The quantity of a value of a species table. Given: the table that contains its key, "levelN.", "crown." or
 * "crown.streamlining.", and the key. Returned: WF_FIT_QUANTITIES for a value that cannot be fitted. */
enum wf_fit_quantity wf_fit_quantity_of(const char *table, const char *key);

struct wf_fit_param {
    const char *name; /* as given by the user, for one of several trees with the prefix "TREE:" */
    enum wf_fit_quantity quantity;
    int32_t level;  /* of the species table; -1: none or all     */
    ptrdiff_t tree; /* -1: shared by all                         */
    size_t test, sensor;
    double unit;                 /* quantity at internal value 1, where the scale is not logarithmic */
    double start, low, high;     /* [SI]                                */
    double prior_mean, prior_sd; /* of the internal value; sd 0: no prior */
};

double wf_param_value(const struct wf_fit_param *p, double internal);
double wf_param_internal(const struct wf_fit_param *p, double value);
bool wf_param_nuisance(const struct wf_fit_param *p);
/* Unit and factor for reports: those of the sensor for offsets. */
const char *wf_param_unit(const struct wf_experiment *x, const struct wf_fit_param *p, double *factor);

/* Add the parameter of a name ("level0.youngs_modulus", "root.stiffness", "TREE:root.stiffness",
 * "each:..." for one parameter of every tree). Start and prior come from the species table. Given: space at
 * out[*n] for one parameter of every tree. Errors: WF_EUSAGE with the known names and the nearest one. */
enum wf_status wf_param_add(const struct wf_experiment *x, const char *name, struct wf_arena *a,
                            struct wf_fit_param *out, size_t *n, struct wf_err *e);
/* Add the offsets and drifts of sensors that have them; unit = range of the sensor's data, for drifts
 * over the duration. */
enum wf_status wf_param_add_nuisance(const struct wf_experiment *x, struct wf_arena *a,
                                     struct wf_fit_param *out, size_t *n, struct wf_err *e);
size_t wf_param_nuisances(const struct wf_experiment *x);

/* Write the parameters' values into a tree: `into` has its own columns and starts as a copy of the tree of
 * index `tree`. Also writes loads and options. */
void wf_param_apply(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                    const double *internal, size_t tree, struct wf_tree *into, struct wf_loads *loads,
                    struct wf_solve_options *options);
#endif
