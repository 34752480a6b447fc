/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/modes.h"
#include "base/num.h"
#include "base/vec3.h"
#include "solve/beam.h"
#include "solve/beam_small.h"
#include "solve/lanczos.h"

/* Flexibility x mass made symmetric: with x = sqrt(mass) u, A = sqrt(mass) flexibility sqrt(mass). */
struct sway {
    struct wf_beam *beam;
    size_t size;
    double *root, *u; /* square root of the mass; a motion */
    double (*node)[6], (*ends)[6];
};

static void sway(void *ctx, const double *in, double *out)
{
    struct sway *s = ctx;
    for (size_t i = 0; i < s->size; i++) s->u[i] = s->root[i] > 0 ? in[i] / s->root[i] : 0;
    wf_beam_inertia_answer(s->beam, s->u, out, s->node, s->ends);
    for (size_t i = 0; i < s->size; i++) out[i] *= s->root[i];
}

/* The state to sway about: Newton from where the beam is; only if that fails the longer ways. A shape that is
 * balanced but unstable is kept: its modes say so. */
static enum wf_status balance(struct wf_beam *b, struct wf_arena *work, struct wf_err *e)
{
    struct wf_beam_outcome out;
    return wf_beam_newton(b) == WF_OK ? WF_OK : wf_beam_settle(b, work, &out, e);
}

/* Sort by rising omega^2 = 1 / value, negative first. */
static void arrange(double *value, size_t *order, size_t n)
{
    for (size_t i = 0; i < n; i++) order[i] = i;
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0 && 1 / value[order[j]] < 1 / value[order[j - 1]]; j--) {
            size_t hold = order[j];
            order[j] = order[j - 1], order[j - 1] = hold;
        }
}

static double hertz(double value)
{
    return value > 0 ? 1 / (WF_TURN * sqrt(value)) : -1 / (WF_TURN * sqrt(-value));
}

/* Room for what is kept of a beam, and its state. */
static enum wf_status keep(const struct wf_beam *b, const int32_t *pieces, size_t count, struct wf_arena *a,
                           struct wf_modes_kept *kept, struct wf_err *e)
{
    size_t rows = b->mesh.tree->n;
    kept->size = wf_beam_motion_size(b);
    kept->pieces = WF_TAKE(a, rows, int32_t);
    kept->shape = WF_TAKE(a, b->mesh.n, struct wf_beam_shape);
    kept->tilt = wf_arena_take(a, rows, sizeof *kept->tilt);
    kept->motion = WF_TAKE(a, count * kept->size, double);
    if (!kept->pieces || !kept->shape || !kept->tilt || !kept->motion)
        return wf_fail(e, WF_ENOMEM, "no room for %zu modes", count);
    memcpy(kept->pieces, pieces, rows * sizeof *pieces);
    memcpy(kept->shape, b->shape, b->mesh.n * sizeof *b->shape);
    memcpy(kept->tilt, b->tilt, rows * sizeof *b->tilt);
    return WF_OK;
}

/* Frequencies on the beam's mesh; ends' displacements by one more answer to the mode's inertia. */
static enum wf_status modes_on(struct wf_beam *b, size_t count, struct wf_arena *work, double *frequency,
                               double *shape, struct wf_modes_kept *kept, struct wf_err *e)
{
    size_t size = wf_beam_motion_size(b), n = b->mesh.tree->n;
    enum wf_status status = wf_beam_linearise(b, true, work, e);
    double *value = WF_TAKE(work, count, double),
           *vector = shape || kept ? WF_TAKE(work, count * size, double) : NULL;
    double *answer = WF_TAKE(work, size, double);
    size_t *order = WF_TAKE(work, count, size_t);
    struct sway s = { .beam = b,
                      .size = size,
                      .root = WF_TAKE(work, size, double),
                      .u = WF_TAKE(work, size, double),
                      .node = wf_arena_take(work, b->mesh.n, sizeof *s.node),
                      .ends = wf_arena_take(work, b->mesh.n, sizeof *s.ends) };
    if (!value || ((shape || kept) && !vector) || !answer || !order || !s.root || !s.u || !s.node || !s.ends)
        return wf_fail(e, WF_ENOMEM, "no room for %zu modes", count);
    wf_beam_motion_mass(b, s.root);
    for (size_t i = 0; i < size; i++) s.root[i] = sqrt(s.root[i]);
    struct wf_lanczos l = {
        .size = size, .apply = sway, .ctx = &s, .wanted = count, .tolerance = kept ? 1e-8 : 1e-5
    };
    if (!status) status = wf_lanczos(&l, value, vector, work, e);
    if (status) return status;
    arrange(value, order, count);
    for (size_t i = 0; i < count; i++) {
        double most = 0;
        frequency[i] = hertz(value[order[i]]);
        for (size_t k = 0; vector && k < size; k++)
            s.u[k] = s.root[k] > 0 ? vector[order[i] * size + k] / s.root[k] : 0;
        if (kept) memcpy(kept->motion + i * size, s.u, size * sizeof *s.u);
        if (!shape) continue;
        wf_beam_inertia_answer(b, s.u, answer, s.node, s.ends);
        for (size_t r = 0; r < n; r++)
            for (size_t c = 0; c < 3; c++) {
                double x = s.ends[b->mesh.last[r]][c];
                shape[3 * n * i + 3 * r + c] = x;
                if (fabs(x) > fabs(most)) most = x;
            }
        for (size_t r = 0; r < 3 * n && most != 0; r++) shape[3 * n * i + r] /= most;
    }
    return WF_OK;
}

/* Pieces for the next mesh: the error of a figure falls with the fourth power. */
static bool finer(const double *coarse, const double *fine, size_t count, double tolerance, double ratio,
                  int32_t *pieces, size_t n)
{
    double worst = 0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(fine[i])) worst = fmax(worst, fabs(fine[i] / coarse[i] - 1) / (pow(ratio, 4) - 1));
    if (worst <= 0.25 * tolerance) return false;
    double grow = fmin(4, fmax(1.3, 1.1 * pow(4 * worst / tolerance, 0.25)));
    for (size_t i = 0; i < n; i++) pieces[i] = (int32_t)ceil(grow * pieces[i]);
    return true;
}

enum wf_status wf_modes_keep(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, size_t count, struct wf_arena *a,
                             double *frequency, double *shape, struct wf_modes_kept *kept, struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_arena work = { 0 };
    struct wf_beam b, last;
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    double *before = WF_TAKE(a, count, double);
    if (!pieces || !before) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;
    for (int mesh = 0; mesh < MESHES && !status; mesh++) {
        status = wf_beam_init(&b, t, l, o, pieces, &work, e);
        if (!status && mesh > 0) wf_beam_carry(&last, &b);
        if (!status) status = balance(&b, &work, e);
        if (!status && kept) status = keep(&b, pieces, count, a, kept, e);
        if (!status) status = modes_on(&b, count, &work, frequency, shape, kept, e);
        if (status || !(o->mesh_tolerance > 0)) break;
        if (mesh == 0)
            for (size_t i = 0; i < t->n; i++) pieces[i] *= 2;
        else {
            double ratio = (double)b.mesh.n / (double)last.mesh.n;
            if (!finer(before, frequency, count, o->mesh_tolerance, ratio, pieces, t->n)) break;
        }
        memcpy(before, frequency, count * sizeof *before);
        last = b;
    }
    wf_arena_free(&work);
    return status;
}

enum wf_status wf_modes(const struct wf_tree *t, const struct wf_loads *l, const struct wf_solve_options *o,
                        size_t count, struct wf_arena *a, double *frequency, double *shape, struct wf_err *e)
{
    return wf_modes_keep(t, l, o, count, a, frequency, shape, NULL, e);
}

enum wf_status wf_modes_held(const struct wf_tree *t, const struct wf_loads *l,
                             const struct wf_solve_options *o, const struct wf_modes_kept *kept, size_t k,
                             double *frequency, struct wf_err *e)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    const double *u = kept->motion + k * kept->size;
    double *mass = WF_TAKE(&work, kept->size, double), *answer = WF_TAKE(&work, kept->size, double), up = 0,
           down = 0;
    enum wf_status status = wf_beam_init(&b, t, l, o, kept->pieces, &work, e);
    double(*node)[6] = status ? NULL : wf_arena_take(&work, b.mesh.n, sizeof *node);
    double(*ends)[6] = status ? NULL : wf_arena_take(&work, b.mesh.n, sizeof *ends);
    if (!status && (!mass || !answer || !node || !ends))
        status = wf_fail(e, WF_ENOMEM, "no room for a motion of %zu segments", t->n);
    if (!status) {
        memcpy(b.shape, kept->shape, b.mesh.n * sizeof *b.shape);
        memcpy(b.tilt, kept->tilt, t->n * sizeof *b.tilt);
        status = balance(&b, &work, e);
    }
    if (!status) status = wf_beam_linearise(&b, true, &work, e);
    if (!status) {
        wf_beam_motion_mass(&b, mass);
        wf_beam_inertia_answer(&b, u, answer, node, ends);
        for (size_t i = 0; i < kept->size; i++) {
            up += mass[i] * u[i] * answer[i];
            down += mass[i] * u[i] * u[i];
        }
        *frequency = hertz(up / down);
    }
    wf_arena_free(&work);
    return status;
}

/* Has the unloaded shape under `factor` times the weight an unstable direction? */
static bool gives_way(struct wf_beam *b, double factor)
{
    struct wf_beam_stability count = { .margin = 0 };
    b->loads.weight_scale = factor;
    b->misfit = (struct wf_beam_misfit){ 0 };
    return !wf_beam_sweep_down(b, true, &count) || count.negative > 0;
}

static double smallest_factor(struct wf_beam *b)
{
    double low = 0, high = 1;
    while (!gives_way(b, high)) {
        low = high, high *= 2;
        if (high > 1e6) return INFINITY;
    }
    for (int i = 0; i < 200 && high - low > 1e-13 * high; i++) {
        double middle = 0.5 * (low + high);
        if (gives_way(b, middle))
            high = middle;
        else
            low = middle;
    }
    return 0.5 * (low + high);
}

enum wf_status wf_buckling(const struct wf_tree *t, const struct wf_loads *l,
                           const struct wf_solve_options *o, struct wf_arena *a, double *factor,
                           struct wf_err *e)
{
    enum { MESHES = 6 };
    struct wf_loads weight = *l;
    struct wf_arena work = { 0 };
    enum wf_status status = wf_solve_check(t, l, NULL, e);
    if (status) return status;
    int32_t *pieces = WF_TAKE(a, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "no room for %zu segments", t->n);
    weight.wind = NULL, weight.points = 0, weight.line = NULL;
    int32_t start = wf_beam_first_pieces(t, o);
    for (size_t i = 0; i < t->n; i++) pieces[i] = start;
    double before = NAN;
    for (int mesh = 0; mesh < MESHES; mesh++) {
        struct wf_beam b;
        status = wf_beam_init(&b, t, &weight, o, pieces, &work, e);
        if (status) break;
        wf_beam_sweep_up(&b);
        *factor = smallest_factor(&b);
        /* error of the finer of two meshes of ratio 2: a fifteenth of their difference */
        if (!(o->mesh_tolerance > 0) || isinf(*factor) ||
            fabs(before / *factor - 1) <= 15 * 0.25 * o->mesh_tolerance)
            break;
        before = *factor;
        for (size_t i = 0; i < t->n; i++) pieces[i] *= 2;
    }
    wf_arena_free(&work);
    return status;
}
