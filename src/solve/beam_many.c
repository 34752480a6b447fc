/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_many.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "solve/beam.h"
#include "solve/beam_rest.h"
#include <stdlib.h>

/* Kernels and their memory. */

enum wf_status wf_lanes_joints_make(const struct wf_beam_mesh *m, struct wf_arena *a,
                                    struct wf_lanes_joints *out, struct wf_err *e)
{
    *out = (struct wf_lanes_joints){ .slot = WF_TAKE(a, m->n, int32_t), .opens = WF_TAKE(a, m->n, bool) };
    int32_t *left = WF_TAKE(a, m->n, int32_t); /* slots no longer in use */
    size_t spare = 0;
    if (!out->slot || !out->opens || !left)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the joints of %zu beam elements", m->n);
    for (size_t i = 0; i < m->n; i++) out->slot[i] = -1;
    for (size_t i = m->n; i-- > 0;) {
        int32_t p = m->part[i].parent;
        if (p >= 0 && out->slot[p] < 0) {
            out->opens[i] = true;
            out->slot[p] = spare ? left[--spare] : (int32_t)out->slots++;
        }
        if (out->slot[i] >= 0) left[spare++] = out->slot[i];
    }
    return WF_OK;
}

enum wf_status wf_lanes_take(const struct wf_lanes_kernel *k, struct wf_lanes *x, struct wf_arena *a,
                             struct wf_arena *newton, struct wf_err *e)
{
    size_t n = x->mesh->n, width = k->width * sizeof(double);
    x->shape = wf_arena_take(a, n, WF_LANES_SHAPE * width);
    x->pose = wf_arena_take(a, n, WF_LANES_POSE * width);
    x->row = wf_arena_take(a, x->mesh->tree->n, WF_LANES_ROW * width);
    x->sums = wf_arena_take(a, WF_LANES_SUMS, width);
    x->answer = wf_arena_take(newton, n, WF_LANES_ANSWER * width);
    x->step = wf_arena_take(newton, n, WF_LANES_STEP * width);
    x->slot = wf_arena_take(newton, x->joints->slots, WF_LANES_SLOT * width);
    if (!x->shape || !x->pose || !x->row || !x->sums || !x->answer || !x->step || !x->slot)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu states of %zu beam elements", k->width, n);
    return WF_OK;
}

/* A block of states on one mesh. State k is lane k % width of group k / width. */

struct level {
    struct wf_arena memory; /* of the mesh, shapes and poses */
    struct wf_beam_mesh mesh;
    struct wf_lanes_joints joints;
    struct wf_lanes group[WF_BEAM_BLOCK];
};

struct block {
    const struct wf_tree *tree;
    const struct wf_solve_options *options;
    const struct wf_beam_few *few; /* NULL: none */
    const struct wf_lanes_kernel *kernel;
    struct wf_beam_state *state;
    size_t n;                   /* states */
    bool wanted[WF_BEAM_BLOCK]; /* states that need this mesh */
    size_t iterations[WF_BEAM_BLOCK];
    struct wf_beam_check check[WF_BEAM_BLOCK];
    struct wf_arena work, newton;
    struct level level[2]; /* the mesh before, and the present one */
};

/* Numbers q of item i for a state: a pointer whose steps are the width. */
static const double *lane_of(const struct block *b, const double *array, size_t per_item, size_t i, size_t k)
{
    return array + i * per_item * b->kernel->width + k % b->kernel->width;
}

static void read_pose(const struct block *b, const struct level *l, size_t i, size_t k,
                      struct wf_beam_pose *out)
{
    const double *x = lane_of(b, l->group[k / b->kernel->width].pose, WF_LANES_POSE, i, k);
    const size_t width = b->kernel->width;
    for (size_t q = 0; q < 3; q++) out->r[q] = x[q * width];
    for (size_t q = 0; q < 9; q++) out->L[q] = x[(3 + q) * width];
}

/* Rotation vectors of the elements, without their strains. */
static void read_turns(const struct block *b, const struct level *l, size_t k, struct wf_beam_shape *out)
{
    for (size_t i = 0; i < l->mesh.n; i++) {
        const double *x = lane_of(b, l->group[k / b->kernel->width].shape, WF_LANES_SHAPE, i, k);
        for (size_t q = 0; q < 6; q++) out[i].v[q / 3][q % 3] = x[q * b->kernel->width];
    }
}

static enum wf_status make_level(struct block *b, const int32_t *pieces, struct level *l, struct wf_err *e)
{
    size_t width = b->kernel->width;
    *l = (struct level){ .mesh = { 0 } };
    enum wf_status s =
        wf_beam_mesh_build(b->tree, b->state[0].loads, b->options, pieces, &l->memory, &l->mesh, e);
    if (!s) wf_beam_rest(&l->mesh, b->state[0].loads->gravity * b->state[0].loads->weight_scale);
    if (!s) s = wf_lanes_joints_make(&l->mesh, &l->memory, &l->joints, e);
    for (size_t g = 0; !s && g * width < b->n; g++) {
        struct wf_lanes *x = &l->group[g];
        *x = (struct wf_lanes){ .mesh = &l->mesh, .joints = &l->joints, .options = b->options };
        bool any = false;
        for (size_t k = 0; k < width; k++) {
            size_t state = g * width + k;
            x->loads[k] = b->state[state < b->n ? state : 0].loads;
            x->wanted[k] = state < b->n && b->wanted[state];
            any = any || x->wanted[k];
        }
        if (any) s = wf_lanes_take(b->kernel, x, &l->memory, &b->newton, e);
    }
    return s;
}

/* Newton's method on the present mesh. The states that do not come to rest there are wanted no longer, and
 * are to be solved by themselves. */
static void settle_level(struct block *b, struct level *l)
{
    size_t width = b->kernel->width;
    for (size_t g = 0; g * width < b->n; g++) {
        struct wf_lanes *x = &l->group[g];
        if (!x->shape) continue;
        b->kernel->newton(x);
        b->kernel->read(x);
        for (size_t k = 0; k < width; k++) {
            size_t state = g * width + k;
            if (!x->wanted[k]) continue;
            b->iterations[state] += x->iterations[k];
            b->state[state].loose = x->loose[k];
            if (x->end[k] == WF_LANE_RESTS) continue;
            b->wanted[state] = false, b->state[state].alone = true;
        }
    }
}

/* The response of a state that needs no finer mesh. */
static void answer_state(const struct block *b, const struct level *l, size_t k)
{
    const struct wf_tree *t = b->tree;
    const size_t width = b->kernel->width;
    const struct wf_lanes *x = &l->group[k / width];
    struct wf_response *r = &b->state[k].response;
    struct wf_beam_wrench ground;
    double force[3], moment[3];
    for (size_t i = 0; i < t->n; i++) {
        static const struct wf_beam_pose clamped = { .L = { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };
        struct wf_beam_pose base = clamped, end;
        int32_t below = l->mesh.part[l->mesh.first[i]].parent;
        const double *row = lane_of(b, x->row, WF_LANES_ROW, i, k);
        double *const to[5] = { r->force0, r->moment0, r->force1, r->moment1, r->load };
        if (below >= 0) read_pose(b, l, (size_t)below, k, &base);
        read_pose(b, l, (size_t)l->mesh.last[i], k, &end);
        wf_beam_read_shape(&l->mesh, i, base.L, &end, r);
        for (size_t q = 0; q < WF_LANES_ROW; q++) to[q / 3][3 * i + q % 3] = row[q * width];
    }
    const double *sum = lane_of(b, x->sums, WF_LANES_SUMS, 0, k);
    for (size_t c = 0; c < 3; c++) {
        ground.n[c] = sum[c * width], ground.m[c] = sum[(3 + c) * width];
        force[c] = sum[(6 + c) * width], moment[c] = sum[(9 + c) * width];
    }
    wf_beam_read_balance(&ground, force, moment, r);
    r->iterations = b->iterations[k];
    r->load_factor = 1;
}

/* A state as wf_beam_check_meets takes the coarser; `pose` has room for all. */
static void view_state(const struct block *b, const struct level *l, size_t k, struct wf_beam_pose *pose,
                       double (*tilt)[3], struct wf_beam *out)
{
    const size_t width = b->kernel->width;
    const double *sum = lane_of(b, l->group[k / width].sums, WF_LANES_SUMS, 0, k);
    *out = (struct wf_beam){
        .mesh = l->mesh, .options = b->options, .loads = *b->state[k].loads, .pose = pose, .tilt = tilt
    };
    for (size_t i = 0; i < l->mesh.n; i++) read_pose(b, l, i, k, &pose[i]);
    for (size_t c = 0; c < 3; c++) out->base.n[c] = sum[c * width];
}

static void read_loads(const struct block *b, const struct level *l, size_t k, double *load)
{
    const size_t width = b->kernel->width;
    for (size_t i = 0; i < b->tree->n; i++) {
        const double *row = lane_of(b, l->group[k / width].row, WF_LANES_ROW, i, k);
        for (size_t c = 0; c < 3; c++) load[3 * i + c] = row[(12 + c) * width];
    }
}

/* Which states need a finer mesh, and the pieces of it; the others get their answers. */
static enum wf_status refine(struct block *b, int32_t *pieces, bool finest, struct wf_err *e)
{
    const struct wf_tree *t = b->tree;
    struct wf_arena scratch = { 0 };
    struct wf_beam_pose *pose[2] = { WF_TAKE(&scratch, b->level[0].mesh.n, struct wf_beam_pose),
                                     WF_TAKE(&scratch, b->level[1].mesh.n, struct wf_beam_pose) };
    struct wf_beam_shape *shape = WF_TAKE(&scratch, b->level[1].mesh.n, struct wf_beam_shape);
    double(*tilt)[3] = wf_arena_take(&scratch, t->n, sizeof *tilt);
    int32_t *own = WF_TAKE(&scratch, t->n, int32_t);
    bool memory = pose[0] && pose[1] && shape && tilt && own;
    for (size_t k = 0; k < b->n && memory; k++) {
        struct wf_beam coarse, fine;
        if (!b->wanted[k]) continue;
        view_state(b, &b->level[0], k, pose[0], tilt, &coarse);
        view_state(b, &b->level[1], k, pose[1], tilt, &fine);
        read_turns(b, &b->level[1], k, fine.shape = shape);
        read_loads(b, &b->level[1], k, b->check[k].load);
        if (wf_beam_check_meets(&coarse, &fine, &b->check[k]) || finest) {
            answer_state(b, &b->level[1], k);
            b->wanted[k] = false;
            continue;
        }
        wf_beam_check_choose(&fine, &b->check[k], own);
        for (size_t i = 0; i < t->n; i++)
            if (own[i] > pieces[i]) pieces[i] = own[i];
    }
    wf_arena_free(&scratch);
    return memory ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory to compare two meshes");
}

static bool any_wanted(const struct block *b)
{
    for (size_t k = 0; k < b->n; k++)
        if (b->wanted[k]) return true;
    return false;
}

/* The next mesh, started from the shapes on the one before. */
static enum wf_status next_level(struct block *b, const int32_t *pieces, struct wf_err *e)
{
    wf_arena_free(&b->newton);
    wf_arena_free(&b->level[0].memory);
    b->level[0] = b->level[1];
    for (size_t g = 0; g < WF_BEAM_BLOCK; g++) /* they pointed into the level that was moved */
        b->level[0].group[g].mesh = &b->level[0].mesh, b->level[0].group[g].joints = &b->level[0].joints;
    enum wf_status s = make_level(b, pieces, &b->level[1], e);
    for (size_t g = 0; !s && g < WF_BEAM_BLOCK; g++)
        if (b->level[1].group[g].shape) b->kernel->carry(&b->level[0].group[g], &b->level[1].group[g]);
    return s;
}

/* The states on the mesh of few elements. */
static enum wf_status settle_on_few(struct block *b, struct wf_err *e)
{
    enum wf_status s = make_level(b, b->few->pieces, &b->level[1], e);
    if (s) return s;
    settle_level(b, &b->level[1]);
    for (size_t k = 0; k < b->n; k++)
        if (b->wanted[k]) answer_state(b, &b->level[1], k);
    return WF_OK;
}

static enum wf_status settle_block(struct block *b, struct wf_err *e)
{
    enum { MESHES = 6 };
    const struct wf_tree *t = b->tree;
    int32_t *pieces = WF_TAKE(&b->work, t->n, int32_t);
    if (!pieces) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    wf_beam_first_pieces(t, b->options, pieces);
    for (size_t k = 0; k < b->n; k++) b->wanted[k] = true;
    bool few = true;
    for (size_t k = 0; k < b->n; k++)
        few = few && wf_beam_few_good(b->few, b->state[k].loads, b->options->mesh_tolerance);
    if (few) return settle_on_few(b, e);
    enum wf_status s = make_level(b, pieces, &b->level[1], e);
    if (s) return s;
    settle_level(b, &b->level[1]);
    for (size_t k = 0; k < b->n && !s; k++) {
        if (!b->wanted[k]) continue;
        if (b->options->mesh_tolerance > 0) {
            s = wf_beam_check_make(t, &b->work, &b->check[k], e);
            if (!s) read_loads(b, &b->level[1], k, b->check[k].before);
        } else {
            answer_state(b, &b->level[1], k);
            b->wanted[k] = false;
        }
    }
    wf_beam_second_pieces(t, pieces);
    for (int mesh = 1; !s && mesh < MESHES && any_wanted(b); mesh++) {
        if (wf_interrupted()) return wf_fail(e, WF_EINTERRUPTED, "interrupted");
        s = next_level(b, pieces, e);
        if (s) break;
        settle_level(b, &b->level[1]);
        s = refine(b, pieces, mesh + 1 == MESHES, e);
    }
    return s;
}

/* Do the lanes cover these states? */
static bool side_by_side(const struct wf_tree *t, const struct wf_beam_state *state, size_t n,
                         const struct wf_solve_options *o)
{
    bool covered = n > 1 && !t->section && !(o->root_stiffness[0] > 0) && !(o->root_stiffness[1] > 0);
    for (size_t k = 0; k < n && covered; k++)
        covered = !state[k].loads->points && !state[k].loads->ties && !state[k].loads->links &&
                  state[k].loads->line == state[0].loads->line;
    return covered;
}

static void solve_alone(const struct wf_tree *t, const struct wf_solve_options *o,
                        const struct wf_beam_few *few, struct wf_beam_state *x)
{
    struct wf_arena work = { 0 };
    struct wf_beam b;
    struct wf_beam_outcome out = { .load_factor = 0 };
    const bool good = wf_beam_few_good(few, x->loads, o->mesh_tolerance); /* then it is not changed */
    struct wf_beam_few mesh = good ? *few : (struct wf_beam_few){ .pieces = NULL };
    const struct wf_beam_known known = { .few = good ? &mesh : NULL };
    x->status = wf_beam_solve(t, x->loads, o, &known, &work, &work, &b, &out, &x->why);
    if (!x->status) {
        wf_beam_read(&b, &x->response);
        x->loose = b.loose;
    }
    x->response.load_factor = out.load_factor;
    x->beyond_limit = out.beyond_limit;
    wf_arena_free(&work);
}

struct many {
    const struct wf_tree *tree;
    const struct wf_solve_options *options;
    const struct wf_beam_few *few;
    struct wf_beam_state *state;
    size_t n;
};

static enum wf_status one_block(void *context, size_t at, struct wf_err *e)
{
    const struct many *m = context;
    size_t from = at * WF_BEAM_BLOCK, n = m->n - from < WF_BEAM_BLOCK ? m->n - from : WF_BEAM_BLOCK;
    struct wf_arena memory = { 0 };
    struct block *b = WF_TAKE(&memory, 1, struct block);
    if (!b) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu states", n);
    *b = (struct block){
        .tree = m->tree, .options = m->options, .few = m->few, .state = m->state + from, .n = n
    };
    b->kernel = wf_lanes_kernel(n);
    enum wf_status s = WF_OK;
    bool together = side_by_side(m->tree, b->state, n, m->options);
    for (size_t k = 0; k < n; k++) b->state[k].alone = !together;
    if (together) s = settle_block(b, e);
    for (size_t k = 0; k < 2; k++) wf_arena_free(&b->level[k].memory);
    wf_arena_free(&b->newton), wf_arena_free(&b->work);
    for (size_t k = 0; k < n && !s; k++)
        if (b->state[k].alone) solve_alone(m->tree, m->options, m->few, &b->state[k]);
    wf_arena_free(&memory);
    return s;
}

enum wf_status wf_beam_many(const struct wf_tree *t, struct wf_beam_state *state, size_t n,
                            const struct wf_solve_options *o, const struct wf_beam_few *few,
                            struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct many m = { t, o, few, state, n };
    for (size_t k = 0; k < n; k++) {
        state[k] = (struct wf_beam_state){ .loads = state[k].loads };
        enum wf_status s = wf_response_alloc(&state[k].response, t->n, a, e);
        if (!s) s = wf_solve_check(t, state[k].loads, d, e);
        if (s) return s;
    }
    enum wf_status s = wf_parallel((n + WF_BEAM_BLOCK - 1) / WF_BEAM_BLOCK, o->threads, one_block, &m, e);
    for (size_t k = 0; k < n && !s; k++) {
        struct wf_beam b = { .loose = state[k].loose };
        struct wf_beam_outcome out = { state[k].response.load_factor, state[k].beyond_limit };
        if (!state[k].status) wf_beam_warn(&b, &out, d);
    }
    return s;
}
