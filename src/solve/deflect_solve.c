/* One steady frame as a solver: the shape by the scheme, internal forces by statics on the unbent tree. */
#include "solve/chain.h"
#include "solve/deflect.h"
#include "solve/vec.h"

static void warn(const struct wf_deflect *d, const struct wf_tree *t, struct wf_diag *diag)
{
    if (!d->clamped || !diag) return;
    wf_diag_warn(diag, "asin-clamped",
                 "%zu segment%s would deflect by more than %s length, where asin(delta/L) has no value, and "
                 "%s held at 90 degrees; the largest is delta/L = %.3g at segment %lld",
                 d->clamped, d->clamped > 1 ? "s" : "", d->clamped > 1 ? "their" : "its",
                 d->clamped > 1 ? "are" : "is", d->worst_ratio, (long long)t->id[d->worst]);
}

static void read(const struct wf_deflect *d, const struct wf_tree *t, struct wf_response *r)
{
    for (size_t i = 0; i < d->n; i++) {
        const double tip[3] = { t->x1[i], t->y1[i], t->z1[i] };
        const struct wf_deflect_row *o = &d->row[i];
        double *t0 = r->tangent0 + 3 * i;
        for (size_t k = 0; k < 3; k++) r->end[3 * i + k] = d->end[i][k] - tip[k];
        rotation_vector(d->turn[i], r->turn + 3 * i);
        m3_apply(d->turn[i], o->axis, r->tangent1 + 3 * i);
        memcpy(t0, d->scheme.printed ? d->chord[i] : o->axis, 3 * sizeof *t0);
        if (!d->scheme.printed && o->parent >= 0) m3_apply(d->turn[o->parent], o->axis, t0);
    }
}

static enum wf_status solve(bool printed, const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, struct wf_arena *a, struct wf_response *r,
                            struct wf_diag *diag, struct wf_err *e)
{
    const struct wf_deflect_scheme scheme = { .printed = printed };
    struct wf_arena work = { 0 };
    struct wf_deflect d;
    enum wf_status status =
        wf_chain_solve(printed ? &wf_chain_printed : &wf_chain_corrected, t, l, o, a, r, diag, e);
    if (!status) status = wf_deflect_open(t, l, &scheme, &work, &d, e);
    if (!status) {
        wf_deflect_frame(&d, 1, 0);
        read(&d, t, r);
        warn(&d, t, diag);
    }
    wf_arena_free(&work);
    return status;
}

static enum wf_status solve_corrected(const struct wf_tree *t, const struct wf_loads *l,
                                      const struct wf_solve_options *o, struct wf_arena *a,
                                      struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return solve(false, t, l, o, a, r, d, e);
}

static enum wf_status solve_printed(const struct wf_tree *t, const struct wf_loads *l,
                                    const struct wf_solve_options *o, struct wf_arena *a,
                                    struct wf_response *r, struct wf_diag *d, struct wf_err *e)
{
    return solve(true, t, l, o, a, r, d, e);
}

#define ZHAO                                                                                                 \
    "Zhao P., Zhang Z. 2013. Research on fast dynamic simulation of IFS trees swaying. Computer "            \
    "Engineering and Applications 49(14):160-163, eqs 1-4"

const struct wf_solver wf_solver_deflect = {
    .name = "deflect",
    .title = "rods turned by their deflection, force and moment handed down",
    .source = ZHAO "; corrected: R^4, forces and moments from above",
    .validity =
        "small deflection: below about 10 % of the height and 15 degrees; loads and weight act on the "
        "unbent tree; converges as segments are refined",
    .small_deflection = true,
    .solve = solve_corrected,
};
const struct wf_solver wf_solver_deflect_as_printed = {
    .name = "deflect-as-printed",
    .title = "rods turned by their own wind force as printed by Zhao and Zhang 2013",
    .source = ZHAO,
    .validity = "reproduces the printed formula: R^3 for R^4, nothing handed on from segment to segment, no "
                "weight; the deflection depends on the number of segments",
    .small_deflection = true,
    .as_printed = true,
    .solve = solve_printed,
};
