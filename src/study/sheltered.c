/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/sheltered.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "load/drag.h"
#include <math.h>
#include <string.h>

static const double settled = 1e-3; /* largest displacement of the last pass over tree height */

/* Streamlining share in the undisturbed wind at the mean height of the sail. */
static double sail_share(const struct wf_tree *t, const struct wf_loads *l)
{
    double sail = 0.0, height = 0.0, x[3] = { 0 }, u[3], du[9], slope;
    for (size_t i = 0; i < t->n; i++) {
        double own = 0.5 * (t->sail0[i] + t->sail1[i]) * wf_tree_length(t, i);
        sail += own;
        height += own * 0.5 * (t->z0[i] + t->z1[i]);
    }
    if (!l->streamline || !(sail > 0.0)) return 1.0;
    x[2] = height / sail;
    l->wind->sample(l->wind, x, u, du);
    double share = wf_streamline_share(l->streamline, &l->streamline_par,
                                       sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]), &slope);
    return fmin(share, 1.0);
}

/* The tree with its rows' ends moved by `end`: straight rows between them. */
struct bent {
    struct wf_tree tree;
    double *end;  /* 3n */
    double *last; /* 3n: solution less shape of the last pass */
    double share; /* relaxation factor: share of that difference added to the shape */
};

static enum wf_status bent_make(struct bent *b, const struct wf_tree *t, struct wf_arena *a, struct wf_err *e)
{
    double **column[] = { &b->tree.x0, &b->tree.y0, &b->tree.z0, &b->tree.x1, &b->tree.y1, &b->tree.z1 };
    b->tree = *t;
    b->end = WF_TAKE(a, 3 * t->n, double);
    b->last = WF_TAKE(a, 3 * t->n, double);
    bool room = b->end && b->last;
    for (size_t k = 0; k < 6; k++) room = (*column[k] = WF_TAKE(a, t->n, double)) && room;
    return room ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for %zu bent segments", t->n);
}

static void bend(struct bent *b, const struct wf_tree *t)
{
    double *const start[3] = { b->tree.x0, b->tree.y0, b->tree.z0 }, *const stop[3] = { b->tree.x1,
                                                                                        b->tree.y1,
                                                                                        b->tree.z1 };
    const double *const from[3] = { t->x0, t->y0, t->z0 }, *const to[3] = { t->x1, t->y1, t->z1 };
    for (size_t i = 0; i < t->n; i++)
        for (int k = 0; k < 3; k++) {
            int32_t p = t->parent[i];
            start[k][i] = from[k][i] + (p >= 0 ? b->end[3 * p + k] : 0.0);
            stop[k][i] = to[k][i] + b->end[3 * i + (size_t)k];
        }
}

/* The next shape: relaxation by Aitken's rule for vectors (Irons & Tuck 1969, Int. J. Numer. Methods Eng.
 * 1:275-277), which shortens steps that alternate in sign and keeps the others. */
static void step(struct bent *b, const double *answer, size_t n, bool first)
{
    double along = 0.0, turn = 0.0;
    for (size_t k = 0; k < n; k++) {
        double now = answer[k] - b->end[k], change = now - b->last[k];
        along += b->last[k] * change;
        turn += change * change;
    }
    b->share = first || !(turn > 0.0) ? 1.0 : fmin(fmax(-b->share * along / turn, 0.1), 1.0);
    for (size_t k = 0; k < n; k++) {
        b->last[k] = answer[k] - b->end[k];
        b->end[k] += b->share * b->last[k];
    }
}

static double distance(const double *a, const double *b, size_t n)
{
    double most = 0.0;
    for (size_t i = 0; i < n; i++) {
        double d2 = 0.0;
        for (size_t k = 0; k < 3; k++) d2 += (a[3 * i + k] - b[3 * i + k]) * (a[3 * i + k] - b[3 * i + k]);
        most = fmax(most, d2);
    }
    return sqrt(most);
}

/* Replace the shelter and its wind by those of a new shape. */
static enum wf_status shelter(const struct wf_tree *shape, const struct wf_loads *l,
                              const struct wf_shelter_request *q, struct wf_sheltered *out, struct wf_err *e)
{
    wf_arena_free(&out->arena);
    enum wf_status s = wf_shelter_make(shape, l->wind, q, &out->arena, &out->shelter, e);
    if (s) return s;
    wf_shelter_field(&out->shelter, &out->wind);
    out->loads = *l;
    out->loads.wind = &out->wind;
    return WF_OK;
}

static void warn(const struct wf_sheltered *s, const struct wf_shelter_request *q, struct wf_diag *d)
{
    if (q->law->as_printed)
        wf_diag_warn(d, "shelter-as-printed", "shelter by '%s' reproduces a paper's picture: %s",
                     q->law->name, q->law->validity);
    if (s->change > settled)
        wf_diag_warn(d, "shelter-unsettled",
                     "shape and shelter still changed by %.2g of the tree's height after %zu passes",
                     s->change, s->passes);
}

/* Fixed-point iteration between shape and shelter. */
static enum wf_status settle(const struct wf_tree *t, const struct wf_shelter_request *q,
                             const struct wf_loads *l, const struct wf_solver *solver,
                             const struct wf_solve_options *o, struct wf_arena *a, struct wf_arena *scratch,
                             struct wf_sheltered *out, struct wf_response *r, struct wf_diag *d,
                             struct wf_err *e)
{
    struct bent b;
    struct wf_err open = { 0 };
    struct wf_diag quiet = { .arena = scratch }; /* only warnings of the last solution are reported */
    double height = wf_tree_height(t);
    if (bent_make(&b, t, scratch, e)) return e->code;
    /* no equilibrium without shelter: start from the unbent shape */
    bool stands = !solver->small_deflection && !solver->solve(t, l, o, scratch, r, &quiet, &open);
    if (open.code && open.code != WF_EUNSTABLE && open.code != WF_ENOCONV)
        return wf_fail(e, open.code, "%s", open.text);
    if (stands) memcpy(b.end, r->end, 3 * t->n * sizeof *b.end);
    for (out->passes = 1;; out->passes++) {
        if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
        wf_stage_step(0);
        bend(&b, t);
        enum wf_status s = shelter(&b.tree, l, q, out, e);
        if (s) return s;
        if (solver->small_deflection) break;
        if ((s = solver->solve(t, &out->loads, o, scratch, r, &quiet, e))) return s;
        out->change = distance(r->end, b.end, t->n) / height;
        if (out->change <= settled || out->passes == WF_SHELTER_PASSES) break;
        step(&b, r->end, 3 * t->n, out->passes == 1);
    }
    return solver->solve(t, &out->loads, o, a, r, d, e);
}

enum wf_status wf_sheltered_solve(const struct wf_tree *t, const struct wf_loads *l,
                                  const struct wf_shelter_request *q, const struct wf_solver *solver,
                                  const struct wf_solve_options *o, struct wf_arena *a,
                                  struct wf_sheltered *out, struct wf_response *r, struct wf_diag *d,
                                  struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_shelter_request own = *q;
    struct wf_solve_options mesh = *o;
    struct wf_err why = { 0 };
    *out = (struct wf_sheltered){ 0 };
    own.sail_share = sail_share(t, l);
    if (mesh.mesh_tolerance > 0.0) mesh.mesh_tolerance = fmax(mesh.mesh_tolerance, 1e-4);
    enum wf_status s = settle(t, &own, l, solver, &mesh, a, &scratch, out, r, d, &why);
    wf_arena_free(&scratch);
    warn(out, q, d);
    return s ? wf_fail(e, s, "%s", why.text) : WF_OK;
}

void wf_sheltered_end(struct wf_sheltered *s) { wf_arena_free(&s->arena); }
