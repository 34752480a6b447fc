/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_ends.h"
#include "base/vec3.h"
#include "solve/beam_path.h"

/* ---- Forces at single ends ---- */

static size_t end_of_row(const struct wf_beam *b, int32_t row) { return (size_t)b->mesh.last[row]; }

void wf_beam_ends_load(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    for (size_t k = 0; k < wf_beam_moving(b); k++) {
        size_t i = wf_beam_moved(b, k);
        b->wrench[i] = (struct wf_beam_wrench){ { 0 }, { 0 } };
        if (b->mesh.mass1) b->wrench[i].n[2] -= l->weight_scale * l->gravity * b->mesh.mass1[i];
    }
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        size_t i = end_of_row(b, q->segment);
        double f[3], m[3];
        if (wf_beam_held(b, i)) continue;
        memcpy(f, q->force, sizeof f), memcpy(m, q->moment, sizeof m);
        if (q->kind == WF_POINT_FOLLOWER) m3_apply(b->pose[i].L, f, f), m3_apply(b->pose[i].L, m, m);
        v3_add(b->wrench[i].n, l->point_scale, f);
        v3_add(b->wrench[i].m, l->point_scale, m);
    }
    for (size_t k = 0; k < l->ties; k++) {
        size_t i = end_of_row(b, l->tie[k].segment);
        double f[3];
        if (wf_beam_held(b, i)) continue;
        (void)wf_tie_pull(&l->tie[k], b->pose[i].r, f, NULL);
        v3_add(b->wrench[i].n, 1, f);
    }
    for (size_t k = 0; k < l->links; k++) {
        size_t from = end_of_row(b, l->link[k].segment[0]), to = end_of_row(b, l->link[k].segment[1]);
        double f[3];
        (void)wf_link_pull(&l->link[k], b->pose[from].r, b->pose[to].r, f);
        if (!wf_beam_held(b, from)) v3_add(b->wrench[from].n, 1, f);
        if (!wf_beam_held(b, to)) v3_add(b->wrench[to].n, -1, f);
    }
}

/* Follower loads rotate with their section: dn = spin x n. Cables resist as their ends move. */
void wf_beam_ends_react(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    for (size_t k = 0; k < wf_beam_moving(b); k++) memset(&b->node[wf_beam_moved(b, k)], 0, sizeof *b->node);
    for (size_t k = 0; k < l->points; k++) {
        const struct wf_point_load *q = &l->point[k];
        size_t i = end_of_row(b, q->segment);
        if (q->kind != WF_POINT_FOLLOWER || b->frozen || wf_beam_held(b, i)) continue;
        double f[3], m[3], N[9] = { 0 }, M[9] = { 0 };
        m3_apply(b->pose[i].L, q->force, f), m3_apply(b->pose[i].L, q->moment, m);
        m3_add_cross(N, -l->point_scale, f), m3_add_cross(M, -l->point_scale, m);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                b->node[i].K[r][3 + c] += N[3 * r + c];
                b->node[i].K[3 + r][3 + c] += M[3 * r + c];
            }
    }
    for (size_t k = 0; k < l->ties; k++) {
        size_t i = end_of_row(b, l->tie[k].segment);
        double f[3], by[9];
        if (wf_beam_held(b, i)) continue;
        (void)wf_tie_pull(&l->tie[k], b->pose[i].r, f, by);
        for (int r = 0; r < 9; r++) b->node[i].K[r / 3][r % 3] += by[r];
    }
}

/* ---- Links ---- */

enum { DIRECTIONS = 3 * WF_LINKS_MAX };

/* A direction in which the two ends of a link resist to move apart. */
struct direction {
    size_t from, to; /* elements, at their ends */
    double axis[3], stiffness;
};
struct wf_beam_links {
    size_t n;
    struct direction at[DIRECTIONS];
    double flexibility[DIRECTIONS][DIRECTIONS]; /* 1/D + F [m/N] */
    double inverse[DIRECTIONS][DIRECTIONS];
    size_t below;  /* elements that carry an end */
    int32_t *path; /* these, from the tips to the base */
};

/* Mark an element and all below it. */
static void mark_path(const struct wf_beam *b, size_t end, bool *on)
{
    for (int32_t i = (int32_t)end; i >= 0 && !on[i]; i = b->mesh.part[i].parent) on[i] = true;
}

enum wf_status wf_beam_links_take(struct wf_beam *b, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_loads *l = &b->loads;
    struct wf_arena scratch = { 0 };
    bool *on = WF_TAKE(&scratch, b->mesh.n, bool);
    struct wf_beam_links *x = b->links = WF_TAKE(a, 1, struct wf_beam_links);
    if (x) x->path = WF_TAKE(a, b->mesh.n, int32_t);
    bool room = on && x && x->path;
    for (size_t k = 0; k < 2 * l->links && room; k++)
        mark_path(b, end_of_row(b, l->link[k / 2].segment[k % 2]), on);
    for (size_t i = b->mesh.n; room && i-- > 0;)
        if (on[i]) x->path[x->below++] = (int32_t)i;
    wf_arena_free(&scratch);
    return room ? wf_beam_small_take(b, a, e) : wf_fail(e, WF_ENOMEM, "not enough memory for cables");
}

/* The directions in which links resist in the present shape. */
static void find_directions(struct wf_beam *b)
{
    const double none = 1e-12; /* of the stiffness along a link */
    const struct wf_loads *l = &b->loads;
    struct wf_beam_links *x = b->links;
    x->n = 0;
    for (size_t k = 0; k < l->links; k++) {
        struct direction d = {
            end_of_row(b, l->link[k].segment[0]), end_of_row(b, l->link[k].segment[1]), { 0 }, 0
        };
        double axis[3][3], stiffness[3];
        wf_link_stiffness(&l->link[k], b->pose[d.from].r, b->pose[d.to].r, axis, stiffness);
        for (int i = 0; i < 3; i++) {
            if (!(fabs(stiffness[i]) > none * l->link[k].stiffness)) continue;
            memcpy(d.axis, axis[i], sizeof d.axis);
            d.stiffness = stiffness[i];
            x->at[x->n++] = d;
        }
    }
}

static void clear_pushes(struct wf_beam *b)
{
    for (size_t k = 0; k < b->links->below; k++)
        memset(b->sides[b->links->path[k]].push, 0, sizeof b->sides->push);
}

/* A force that pulls the ends together, in one lane. */
static void pull(struct wf_beam *b, const struct direction *d, int lane, double force)
{
    for (int i = 0; i < 3; i++) {
        b->sides[d->from].push[i][lane] += force * d->axis[i];
        b->sides[d->to].push[i][lane] -= force * d->axis[i];
    }
}

/* By how much the ends move apart, in one lane. */
static double parted(const struct wf_beam *b, const struct direction *d, int lane)
{
    double apart = 0;
    for (int i = 0; i < 3; i++)
        apart += d->axis[i] * (b->sides[d->to].y[i][lane] - b->sides[d->from].y[i][lane]);
    return apart;
}

/* 1/D + F, by the answers of the path to unit forces. */
static void find_flexibility(struct wf_beam *b, bool stretching)
{
    struct wf_beam_links *x = b->links;
    for (size_t from = 0; from < x->n; from += WF_BEAM_SIDES) {
        size_t some = x->n - from < WF_BEAM_SIDES ? x->n - from : WF_BEAM_SIDES;
        clear_pushes(b);
        for (size_t c = 0; c < some; c++) pull(b, &x->at[from + c], (int)c, 1);
        wf_beam_answer_path(b, x->path, x->below, stretching);
        for (size_t r = 0; r < x->n; r++)
            for (size_t c = 0; c < some; c++) x->flexibility[r][from + c] = -parted(b, &x->at[r], (int)c);
    }
    for (size_t k = 0; k < x->n; k++) x->flexibility[k][k] += 1 / x->at[k].stiffness;
}

/* Inverse by elimination with exchange of rows. false: singular. */
static bool invert(struct wf_beam_links *x)
{
    double A[DIRECTIONS][DIRECTIONS], (*B)[DIRECTIONS] = x->inverse;
    memcpy(A, x->flexibility, sizeof A);
    for (size_t i = 0; i < x->n; i++)
        for (size_t j = 0; j < x->n; j++) B[i][j] = i == j;
    for (size_t c = 0; c < x->n; c++) {
        size_t best = c;
        for (size_t r = c + 1; r < x->n; r++)
            if (fabs(A[r][c]) > fabs(A[best][c])) best = r;
        if (!(fabs(A[best][c]) > 0)) return false;
        for (size_t j = 0; j < x->n && best != c; j++) {
            double a = A[c][j], d = B[c][j];
            A[c][j] = A[best][j], A[best][j] = a, B[c][j] = B[best][j], B[best][j] = d;
        }
        for (size_t r = 0; r < x->n; r++) {
            double f = A[r][c] / A[c][c];
            if (r == c || !(fabs(f) > 0)) continue;
            for (size_t j = 0; j < x->n; j++) A[r][j] -= f * A[c][j], B[r][j] -= f * B[c][j];
        }
    }
    for (size_t r = 0; r < x->n; r++)
        for (size_t j = 0; j < x->n; j++) B[r][j] /= A[r][r];
    return true;
}

/* Positive pivots of 1/D + F less those of 1/D. */
static long gained(const struct wf_beam_links *x)
{
    double A[DIRECTIONS][DIRECTIONS];
    long count = 0;
    memcpy(A, x->flexibility, sizeof A);
    for (size_t c = 0; c < x->n; c++) {
        count += (A[c][c] > 0) - (x->at[c].stiffness > 0);
        for (size_t r = c + 1; r < x->n; r++) {
            double f = A[r][c] / A[c][c];
            for (size_t j = c; j < x->n; j++) A[r][j] -= f * A[c][j];
        }
    }
    return count;
}

/* Unstable directions that links take away, or rods make. What is left of a tree that is not stable without
 * them is not told apart: it counts as large as it was. */
static void count_links(const struct wf_beam_links *x, struct wf_beam_stability *count)
{
    long more = gained(x), left = (long)count->negative + more;
    if (more > 0) count->bears = INFINITY;
    if (left <= 0) count->bears = 0;
    count->negative = left > 0 ? (size_t)left : 0;
}

/* Newton corrections of the ends of the path without the links' stiffness, as lane 0 of b->sides[].y. */
static void correct_path(struct wf_beam *b)
{
    const struct wf_beam_links *x = b->links;
    for (size_t k = x->below; k-- > 0;) {
        size_t i = (size_t)x->path[k];
        const struct wf_beam_part *p = &b->mesh.part[i];
        for (int r = 0; r < 6; r++) {
            double sum = b->node[i].k[r];
            for (int c = 0; c < 6; c++)
                sum += b->node[i].K[r][c] *
                       (p->parent >= 0 ? b->sides[p->parent].y[c][0] : b->root_change[p->row][c]);
            b->sides[i].y[r] = (wf_four){ sum, 0, 0, 0 };
        }
    }
}

/* Forces that answer to the ends' moving apart in one lane. */
static void resist(const struct wf_beam *b, int lane, double force[DIRECTIONS])
{
    const struct wf_beam_links *x = b->links;
    double apart[DIRECTIONS];
    for (size_t k = 0; k < x->n; k++) apart[k] = parted(b, &x->at[k], lane);
    for (size_t k = 0; k < x->n; k++) {
        force[k] = 0;
        for (size_t c = 0; c < x->n; c++) force[k] += x->inverse[k][c] * apart[c];
    }
}

bool wf_beam_links_join(struct wf_beam *b, struct wf_beam_stability *count)
{
    struct wf_beam_links *x = b->links;
    double force[DIRECTIONS];
    find_directions(b);
    if (!x->n) return true;
    find_flexibility(b, false); /* the strains of the step are those of the present forces */
    if (!invert(x)) return false;
    if (count) count_links(x, count);
    correct_path(b);
    resist(b, 0, force);
    clear_pushes(b);
    for (size_t k = 0; k < x->n; k++) pull(b, &x->at[k], 0, force[k]);
    wf_beam_correct_path(b, x->path, x->below);
    return true;
}

bool wf_beam_links_linearise(struct wf_beam *b)
{
    find_directions(b);
    find_flexibility(b, true);
    return invert(b->links);
}

void wf_beam_links_answer(struct wf_beam *b)
{
    double force[WF_BEAM_SIDES][DIRECTIONS];
    for (int lane = 0; lane < WF_BEAM_SIDES; lane++) resist(b, lane, force[lane]);
    for (int lane = 0; lane < WF_BEAM_SIDES; lane++)
        for (size_t k = 0; k < b->links->n; k++) pull(b, &b->links->at[k], lane, force[lane][k]);
}
