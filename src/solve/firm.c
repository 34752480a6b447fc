/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/firm.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include "solve/beam_newton.h"
#include "solve/beam_parts.h"
#include "solve/beam_rest.h"

enum { PASSES = 12 };

struct trial {
    struct wf_tree *tree;
    struct wf_beam beam;
    struct wf_loads weight;
    double limit;  /* mass of a part that is stiffened [kg] */
    double *mass;  /* per row: of the row and all above it [kg] */
    bool *weak;    /* per element: unstable with all above it */
    bool *covered; /* per row: a weak row is above it */
    double load_factor;
};

/* Mass of each row with all above it on the day of the shape. */
static void weigh(const struct wf_tree *t, double *mass)
{
    const struct wf_tree_standing *s = t->standing;
    for (size_t i = 0; i < t->n; i++)
        mass[i] = wf_tree_length(t, i) *
                      (t->density[i] * wf_tree_area(t, i, 0.5) + 0.5 * (s->burden0[i] + s->burden1[i])) +
                  (t->mass1 ? t->mass1[i] : 0);
    for (size_t i = t->n; i-- > 0;)
        if (t->parent[i] >= 0) mass[t->parent[i]] += mass[i];
}

/* Is the given shape, under `factor` times its weight, unstable in the elements that are not held? */
static bool unstable(struct trial *k, double factor)
{
    struct wf_beam *b = &k->beam;
    struct wf_beam_stability count = { .margin = 1e-6 };
    b->loads.weight_scale = factor;
    wf_beam_rest(&b->mesh, factor * b->loads.gravity);
    b->misfit = (struct wf_beam_misfit){ 0 };
    memset(k->weak, 0, b->mesh.n * sizeof *k->weak);
    return !wf_beam_sweep_down(b, true, &count) || count.negative > 0;
}

/* The lowest row of the part that row i belongs to: down its axis, while the part is light enough. */
static size_t foot_of(const struct trial *k, size_t i)
{
    const struct wf_tree *t = k->tree;
    while (t->parent[i] >= 0 && t->level[t->parent[i]] == t->level[i] && k->mass[t->parent[i]] <= k->limit)
        i = (size_t)t->parent[i];
    return i;
}

static bool part_holds(const struct wf_tree *t, size_t foot, bool *in, size_t i)
{
    return in[i] = i == foot || (i > foot && t->parent[i] >= 0 && in[t->parent[i]]);
}

/* Load factor of the part by itself, its base held, from the stable side; not below 1e-3. */
static double own_factor(struct trial *k, size_t foot)
{
    const struct wf_tree *t = k->tree;
    double low = 1e-3, high = k->load_factor;
    for (size_t i = 0; i < t->n; i++) {
        bool in = part_holds(t, foot, k->covered, i);
        for (int32_t m = k->beam.mesh.first[i]; m <= k->beam.mesh.last[i]; m++) k->beam.part.held[m] = !in;
    }
    wf_beam_move_only(&k->beam);
    for (int i = 0; i < 24 && high - low > 1e-4 * high; i++) {
        double middle = sqrt(low * high);
        if (unstable(k, middle))
            high = middle;
        else
            low = middle;
    }
    k->beam.only = NULL;
    return low;
}

/* Raise E and G of a part, in the tree and in the mesh. */
static void stiffen(struct trial *k, size_t foot, double raise)
{
    struct wf_tree *t = k->tree;
    for (size_t i = 0; i < t->n; i++) {
        if (!part_holds(t, foot, k->covered, i)) continue;
        t->youngs[i] *= raise, t->shear[i] *= raise;
        for (int32_t m = k->beam.mesh.first[i]; m <= k->beam.mesh.last[i]; m++) {
            struct wf_beam_part *p = &k->beam.mesh.part[m];
            for (int j = 0; j < 2; j++)
                p->ei[j] *= raise, p->gj[j] *= raise, p->ca[j] /= raise, p->cs[j] /= raise;
        }
    }
}

static enum wf_status note_part(struct trial *k, size_t foot, struct wf_firm *out, struct wf_err *e)
{
    size_t at = 0;
    while (at < out->n && out->part[at].row != foot) at++;
    if (at == k->tree->n) return wf_fail(e, WF_EINTERNAL, "more parts than rows");
    double factor = own_factor(k, foot), raise = k->load_factor / factor;
    /* a part that was stiffened before fails by the give of what carries it */
    if (at < out->n) raise = fmax(raise, 2);
    stiffen(k, foot, raise);
    if (at == out->n)
        out->part[out->n++] =
            (struct wf_firm_part){ .row = foot, .mass = k->mass[foot], .factor = factor, .raise = 1 };
    out->part[at].raise *= raise;
    return WF_OK;
}

/* Stiffen the light parts above row `foot` that carry less than the load factor, each with its base held: a
 * part that just stands by itself can bring down what carries it. Returned: *found, whether one was. */
static enum wf_status stiffen_above(struct trial *k, size_t foot, bool *in, struct wf_firm *out, bool *found,
                                    struct wf_err *e)
{
    const struct wf_tree *t = k->tree;
    enum wf_status s = WF_OK;
    for (size_t i = 0; i < t->n; i++)
        for (int32_t m = k->beam.mesh.first[i]; m <= k->beam.mesh.last[i]; m++)
            k->beam.part.held[m] = k->mass[i] > k->limit;
    wf_beam_move_only(&k->beam);
    (void)unstable(k, k->load_factor);
    k->beam.only = NULL;
    memset(in, 0, t->n * sizeof *in);
    for (size_t m = 0; m < k->beam.mesh.n; m++)
        if (k->weak[m]) in[foot_of(k, (size_t)k->beam.mesh.part[m].row)] = true;
    for (size_t i = t->n; i-- > 0 && !s;) {
        int32_t below = (int32_t)i;
        while (below >= 0 && below != (int32_t)foot) below = t->parent[(size_t)below];
        if (!in[i] || below < 0 || k->mass[i] > k->limit) continue;
        *found = true;
        s = note_part(k, i, out, e);
    }
    return s;
}

/* Stiffen the parts that are weak now, tips first. Returned: *found, whether one was. */
static enum wf_status stiffen_weak(struct trial *k, const bool *row_weak, bool *above, struct wf_firm *out,
                                   bool *found, struct wf_err *e)
{
    const struct wf_tree *t = k->tree;
    enum wf_status s = WF_OK;
    memset(above, 0, t->n * sizeof *above);
    *found = false;
    for (size_t i = t->n; i-- > 0 && !s;) {
        if (above[i] && t->parent[i] >= 0) above[t->parent[i]] = true;
        if (!row_weak[i] || above[i]) continue;
        if (k->mass[i] > k->limit) {
            bool helped = false;
            s = stiffen_above(k, i, above, out, &helped, e);
            out->gave_up = !helped;
            out->refused = helped ? -1 : (int32_t)i;
            *found = true;
            return s;
        }
        if (t->parent[i] >= 0) above[t->parent[i]] = true;
        *found = true;
        s = note_part(k, foot_of(k, i), out, e);
    }
    return s;
}

static enum wf_status take_trial(struct trial *k, const struct wf_solve_options *o, struct wf_arena *work,
                                 struct wf_err *e)
{
    struct wf_tree *t = k->tree;
    int32_t *pieces = WF_TAKE(work, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    wf_beam_first_pieces(t, o, pieces);
    enum wf_status s = wf_beam_init(&k->beam, t, &k->weight, o, pieces, work, work, e);
    if (s) return s;
    k->mass = WF_TAKE(work, t->n, double);
    k->covered = WF_TAKE(work, t->n, bool);
    k->weak = WF_TAKE(work, k->beam.mesh.n, bool);
    if (!k->mass || !k->covered || !k->weak)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    k->beam.weak = k->weak;
    weigh(t, k->mass);
    wf_beam_sweep_up(&k->beam);
    return WF_OK;
}

/* Own columns of E and G, which may belong to others. */
static enum wf_status own_columns(struct wf_tree *t, struct wf_arena *a, struct wf_err *e)
{
    double *E = WF_TAKE(a, t->n, double), *G = WF_TAKE(a, t->n, double);
    if (!E || !G) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    memcpy(E, t->youngs, t->n * sizeof *E);
    memcpy(G, t->shear, t->n * sizeof *G);
    t->youngs = E, t->shear = G;
    return WF_OK;
}

static enum wf_status make_firm(struct trial *k, struct wf_arena *work, struct wf_firm *out, struct wf_err *e)
{
    const struct wf_tree *t = k->tree;
    bool *row_weak = WF_TAKE(work, t->n, bool), *above = WF_TAKE(work, t->n, bool);
    if (!row_weak || !above) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    enum wf_status s = WF_OK;
    for (int pass = 0; pass < PASSES && !s; pass++) {
        bool found = false;
        if (!unstable(k, 1)) return WF_OK;
        memset(row_weak, 0, t->n * sizeof *row_weak);
        for (size_t m = 0; m < k->beam.mesh.n; m++)
            if (k->weak[m]) row_weak[k->beam.mesh.part[m].row] = true;
        s = stiffen_weak(k, row_weak, above, out, &found, e);
        if (out->gave_up) return s;
        if (!found) {
            out->root = out->gave_up = true;
            return s;
        }
    }
    if (!s) out->gave_up = unstable(k, 1);
    return s;
}

enum wf_status wf_firm(struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                       double share, double load_factor, struct wf_arena *a, struct wf_firm *out,
                       struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct trial k = { .tree = t, .weight = *l, .load_factor = load_factor };
    *out = (struct wf_firm){ .refused = -1, .part = WF_TAKE(a, t->n, struct wf_firm_part) };
    k.weight.wind = NULL, k.weight.points = k.weight.ties = k.weight.links = 0, k.weight.line = NULL;
    if (!out->part) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    enum wf_status s = own_columns(t, a, e);
    if (!s) s = take_trial(&k, o, &work, e);
    for (size_t i = 0; i < t->n && !s; i++)
        if (t->parent[i] < 0) out->mass += k.mass[i];
    k.limit = share * out->mass;
    if (!s) s = make_firm(&k, &work, out, e);
    wf_arena_free(&work);
    return s;
}
