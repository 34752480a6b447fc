/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/num.h"
#include "fail/fail.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdbool.h>

enum { STEPS_MAX = 100 };

typedef enum wf_status criterion_fn(void *ctx, double speed, double *value, struct wf_err *e);

struct speed_search {
    criterion_fn *criterion;
    void *ctx;
    double stands; /* highest speed known with criterion < 1 */
    double falls;  /* lowest known with criterion >= 1; INFINITY when none */
    double lost;   /* lowest known without equilibrium; INFINITY when none */
    size_t evaluations;
    enum wf_status fault; /* an error that is not a finding about the tree, e.g. out of memory */
    struct wf_err *err;
};

/* Absence of equilibrium is a result of the search; every other error ends it. */
static bool no_equilibrium(enum wf_status s) { return s == WF_ENOCONV || s == WF_EUNSTABLE; }

/* criterion - 1 at a speed, at most 1; 1 where no equilibrium is found. Updates the brackets. */
static double excess(double speed, void *search)
{
    struct speed_search *s = search;
    struct wf_err why = { 0 };
    double value = NAN;
    if (s->fault) return 1;
    enum wf_status status = s->criterion(s->ctx, speed, &value, &why);
    s->evaluations++;
    if (no_equilibrium(status)) {
        s->lost = fmin(s->lost, speed);
        return 1;
    }
    if (status)
        s->fault = wf_fail(s->err, status, "%s", why.text);
    else if (isnan(value))
        s->fault =
            wf_fail(s->err, WF_EINTERNAL, "critical speed: the criterion is not a number at %g m/s", speed);
    else if (value >= 1)
        s->falls = fmin(s->falls, speed);
    else
        s->stands = fmax(s->stands, speed);
    return s->fault ? 1 : fmin(value - 1, 1);
}

/* Bisect between the highest speed with criterion < 1 and the lowest without equilibrium, until a speed with
 * criterion >= 1 is found or the interval is within the tolerance. */
static void find_edge(struct speed_search *s, double tolerance)
{
    while (!s->fault && s->lost < s->falls && s->lost - s->stands > tolerance * s->lost)
        excess(0.5 * (s->stands + s->lost), s);
}

/* Brent's method between a speed with criterion < 1 and one with criterion >= 1, until evaluations on both
 * sides confirm a bracket within the tolerance; ends early when a speed below has no equilibrium. Brent's
 * bracket tends to shrink from one side only, so once its steps are small the other side is evaluated.
 * Returned: best estimate. */
static double find_crossing(struct speed_search *s, double tolerance, gsl_root_fsolver *solver)
{
    gsl_function f = { excess, s };
    double root = s->falls;
    if (gsl_root_fsolver_set(solver, &f, s->stands, s->falls) != GSL_SUCCESS) return root;
    for (int k = 0; k < STEPS_MAX && !s->fault; k++) {
        double before = root;
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS || s->lost < s->falls) break;
        root = gsl_root_fsolver_root(solver);
        if (fabs(root - before) <= tolerance * root)
            excess(root * (s->stands < root ? 1 - 0.5 * tolerance : 1 + 0.5 * tolerance), s);
        if (s->falls - s->stands <= tolerance * s->falls) return root;
    }
    while (!s->fault && s->lost > s->falls && s->falls - s->stands > tolerance * s->falls)
        excess(0.5 * (s->stands + s->falls), s);
    return 0.5 * (s->stands + s->falls);
}

/* Narrow the bracket [stands, falls] or [stands, lost] found by the even steps. Returned: the crossing; NAN
 * where there is none. */
static double narrow_bracket(struct speed_search *s, double tolerance)
{
    wf_quiet_begin();
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    double root = NAN;
    if (!solver)
        s->fault = wf_fail(s->err, WF_ENOMEM, "critical speed: not enough memory for the root search");
    while (!s->fault) {
        find_edge(s, tolerance);
        if (s->fault || s->lost < s->falls) break;
        root = find_crossing(s, tolerance, solver);
        if (s->falls < s->lost) break;
    }
    if (solver) gsl_root_fsolver_free(solver);
    wf_quiet_end();
    return root;
}

/* Slope of the criterion at its crossing by a difference over 0.1 % of the speed to both sides; from below
 * alone where no equilibrium exists above. */
static double slope_at_crossing(struct speed_search *s, double root)
{
    double below = root * (1 - 1e-3), above = root * (1 + 1e-3);
    double low = excess(below, s), high = excess(above, s);
    return s->lost <= above ? -low / (root - below) : (high - low) / (above - below);
}

static double rung_step(double speed_max)
{
    const double step = 3.125; /* [m/s] */
    return fmax(step, speed_max / WF_CRITICAL_RUNGS_MAX);
}

int wf_critical_rungs(double speed_max) { return (int)ceil(speed_max / rung_step(speed_max)); }

double wf_critical_rung(double speed_max, int k) { return fmin(k * rung_step(speed_max), speed_max); }

enum wf_status wf_critical_search(criterion_fn *criterion, void *ctx, double speed_max, double tolerance,
                                  struct wf_critical *out, struct wf_err *e)
{
    struct speed_search s = { criterion, ctx, 0, INFINITY, INFINITY, 0, WF_OK, e };
    *out = (struct wf_critical){ .speed = NAN, .speed_high = speed_max, .gradient = NAN, .evaluations = 1 };
    if (!(speed_max > 0 && isfinite(speed_max) && tolerance > 0 && tolerance < 1))
        return wf_fail(e, WF_EUSAGE,
                       "critical speed: highest speed %g m/s and tolerance %g: must be positive", speed_max,
                       tolerance);

    double still = NAN;
    struct wf_err why = { 0 };
    enum wf_status status = criterion(ctx, 0, &still, &why);
    if (status && !no_equilibrium(status)) return wf_fail(e, status, "%s", why.text);
    if (status || still >= 1 || isnan(still)) {
        out->outcome = status || still >= 1 ? WF_CRITICAL_SELF_WEIGHT : WF_CRITICAL_NO_STRENGTH;
        out->speed_high = 0;
        return WF_OK;
    }

    for (int k = 1, n = wf_critical_rungs(speed_max); k <= n && !s.fault && isinf(s.falls) && isinf(s.lost);
         k++)
        excess(wf_critical_rung(speed_max, k), &s);
    if (isinf(s.falls) && isinf(s.lost))
        out->outcome = WF_CRITICAL_ABOVE;
    else {
        double root = narrow_bracket(&s, tolerance);
        bool found = s.falls < s.lost;
        out->outcome = found ? WF_CRITICAL_FOUND : WF_CRITICAL_UNSOLVED;
        out->speed_low = s.stands;
        out->speed_high = found ? s.falls : s.lost;
        if (found && !s.fault) out->speed = root, out->gradient = slope_at_crossing(&s, root);
    }
    out->evaluations = s.evaluations + 1;
    return s.fault;
}

const char *wf_critical_text(enum wf_critical_outcome o)
{
    switch (o) {
    case WF_CRITICAL_FOUND:
        return "found";
    case WF_CRITICAL_ABOVE:
        return "above the highest speed searched";
    case WF_CRITICAL_SELF_WEIGHT:
        return "fails under its own weight, without wind";
    case WF_CRITICAL_NO_STRENGTH:
        return "its resistance is not known";
    case WF_CRITICAL_UNSOLVED:
        return "not known: no equilibrium was found from a speed on, and the tree may be lost there";
    case WF_CRITICAL_UNSEARCHED:
        return "not found: the search ended before, or another part of the tree fails first";
    case WF_CRITICAL_INTERRUPTED:
        return "not computed: the run was interrupted";
    }
    return "unknown";
}
