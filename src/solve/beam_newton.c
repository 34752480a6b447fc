#include "solve/beam_newton.h"
#include "solve/vec.h"
#include <float.h>

enum wf_status wf_beam_init(struct wf_beam *b, const struct wf_tree *t, const struct wf_loads *l,
                            const struct wf_solve_options *o, const int32_t *pieces, struct wf_arena *a,
                            struct wf_err *e)
{
    *b = (struct wf_beam){ .loads = *l, .options = o };
    enum wf_status status = wf_beam_mesh_build(t, l, o, pieces, a, &b->mesh, e);
    if (status) return status;
    size_t n = b->mesh.n;
    b->tilt = wf_arena_take(a, t->n, sizeof *b->tilt);
    b->root_step = wf_arena_take(a, t->n, sizeof *b->root_step);
    b->root_change = wf_arena_take(a, t->n, sizeof *b->root_change);
    b->root_give = wf_arena_take(a, t->n, sizeof *b->root_give);
    b->root_hold = wf_arena_take(a, t->n, sizeof *b->root_hold);
    b->shape = WF_TAKE(a, n, struct wf_beam_shape);
    b->pose = WF_TAKE(a, n, struct wf_beam_pose);
    b->stage = WF_TAKE(a, n, struct wf_beam_stage);
    if (b->mesh.flat) b->flat = WF_TAKE(a, n, struct wf_beam_flat);
    b->wrench = WF_TAKE(a, n, struct wf_beam_wrench);
    b->node = WF_TAKE(a, n, struct wf_beam_reaction);
    b->answer = WF_TAKE(a, n, struct wf_beam_answer);
    b->change = wf_arena_take(a, n, sizeof *b->change);
    b->dv = wf_arena_take(a, n, sizeof *b->dv);
    if (!b->tilt || !b->root_step || !b->root_change || !b->root_give || !b->root_hold || !b->shape ||
        !b->pose || !b->stage || !b->wrench || !b->node || !b->answer || !b->change || !b->dv ||
        (b->mesh.flat && !b->flat))
        return wf_fail(e, WF_ENOMEM, "no room for the state of %zu beam elements", n);
    return WF_OK;
}

/* Keep an element's own turn below a limit; what it carries then follows as far. base, end: changes of its
 * ends. */
static void shorten(const struct wf_beam_pose *at_base, const struct wf_beam_pose *at_end,
                    const double base[6], double dv[2][3], double end[6])
{
    const double limit = 0.7; /* rad */
    double most = fmax(wf_dot(dv[0], dv[0]), wf_dot(dv[1], dv[1])), arm[3], swing[3];
    if (most <= limit * limit) return;
    double share = limit / sqrt(most);
    for (int i = 0; i < 3; i++) arm[i] = at_end->r[i] - at_base->r[i];
    wf_cross(base + 3, arm, swing);
    for (int i = 0; i < 3; i++) {
        double place = base[i] + swing[i];
        dv[0][i] *= share, dv[1][i] *= share;
        end[i] = place + share * (end[i] - place);
        end[3 + i] = base[3 + i] + share * (end[3 + i] - base[3 + i]);
    }
}

/* Corrections of all unknowns from the base up. Returned: the largest turn any node would make. */
static double corrections(struct wf_beam *b)
{
    double most = 0;
    for (size_t i = 0; i < b->mesh.n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        struct wf_beam_pose ground;
        const struct wf_beam_pose *base = wf_beam_base(b, i, &ground);
        const double *below = p->parent >= 0 ? b->change[p->parent] : b->root_change[p->row];
        wf_beam_correct(&b->shape[i], base->L, &b->answer[i], &b->node[i], below, b->dv[i], b->change[i]);
        shorten(base, &b->pose[i], below, b->dv[i], b->change[i]);
        most = fmax(most, wf_dot(b->change[i] + 3, b->change[i] + 3));
    }
    return sqrt(most);
}

static void move(struct wf_beam *b, double share)
{
    for (size_t i = 0; i < b->mesh.n; i++)
        for (int j = 0; j < 2; j++) v3_add(b->shape[i].v[j], share, b->dv[i][j]);
    for (size_t i = 0; i < b->mesh.tree->n; i++)
        if (b->mesh.tree->parent[i] < 0) v3_add(b->tilt[i], share, b->root_step[i]);
    wf_beam_sweep_up(b);
}

/* One correction, shortened until the misfit falls. */
static bool step(struct wf_beam *b)
{
    const double turn_limit = 3; /* rad a node may turn in one step */
    double turn = corrections(b), share = turn > turn_limit ? turn_limit / turn : 1, done = 0;
    struct wf_beam_misfit before = b->misfit;
    if (!isfinite(turn)) return false;
    for (int halvings = 0; halvings < 8; halvings++, share *= 0.5) {
        move(b, share - done);
        done = share;
        if (!wf_beam_sweep_down(b, true, NULL)) continue;
        if (b->misfit.bending <= before.bending * (1 - 1e-4 * share)) return true;
        if (b->misfit.bending <= 1e-24 * b->misfit.energy) return true; /* at rounding */
    }
    return false;
}

static bool settled(const struct wf_beam *b)
{
    const double rounding = 8 * DBL_EPSILON; /* of unit tangents */
    double t = b->options->tolerance;
    return b->misfit.bending <= t * t * b->misfit.energy && b->misfit.strain <= t * b->misfit.turn + rounding;
}

enum wf_status wf_beam_newton(struct wf_beam *b)
{
    b->misfit = (struct wf_beam_misfit){ .bending = 1, .energy = 1 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL)) return WF_ENOCONV;
    for (size_t i = 0; i < b->options->iterations_max && !settled(b); i++) {
        b->iterations++;
        if (!step(b)) return WF_ENOCONV;
    }
    return settled(b) ? WF_OK : WF_ENOCONV;
}
