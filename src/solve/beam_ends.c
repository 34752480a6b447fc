/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/beam_ends.h"
#include "base/vec3.h"
#include "solve/beam_path.h"

static size_t end_of_row(const struct wf_beam *b, int32_t row) { return (size_t)b->mesh.last[row]; }

enum { DIRECTIONS = 3 * WF_LINKS_MAX };

/* A direction in which the two ends of a link resist to move apart. */
struct direction {
    size_t link, from, to; /* from, to: elements, at their ends */
    double axis[3], stiffness;
    double gap; /* along: what the ends are apart beyond the link's length under its force [m]; across: 0 */
};
/* The force of each link, an unknown of its own, and what follows from the present shape. */
struct pulling {
    double force;              /* [N] */
    double change;             /* by the last tangent */
    double before, step;       /* of the correction: the force before it, its change */
    double axis[3][3], length; /* [m] */
    double gap;                /* [m]; 0: a cable is slack */
    double give;               /* 1/D + F along the link, of the last tangent [m/N] */
};
struct wf_beam_links {
    struct pulling link[WF_LINKS_MAX];
    size_t n;
    struct direction at[DIRECTIONS];
    double flexibility[DIRECTIONS][DIRECTIONS]; /* 1/D + F [m/N] */
    double inverse[DIRECTIONS][DIRECTIONS];
    size_t below;                          /* elements that carry an end */
    int32_t *path;                         /* these, from the tips to the base */
    double (*strain)[2][3];                /* of each: change of g by the last tangent */
    double (*step)[2][3], (*before)[2][3]; /* by the correction; g before it */
    bool stretched;                        /* the correction has a step */
    double share;                          /* of it that was added */
};

/* A link in the present shape. A cable that would have to push lets go. */
static void see_link(const struct wf_beam *b, size_t k)
{
    const double least = 1e-9; /* of its length: a cable at rest is slack, whatever is rounded */
    const struct wf_link *q = &b->loads.link[k];
    struct pulling *p = &b->links->link[k];
    p->length = wf_link_axes(b->pose[end_of_row(b, q->segment[0])].r, b->pose[end_of_row(b, q->segment[1])].r,
                             p->axis);
    p->gap = p->length - q->length - p->force / q->stiffness;
    if (q->pushes || (p->force > 0 && p->force + p->gap / p->give > 0)) return;
    p->force = 0;
    p->gap = p->length - q->length;
    if (!(p->gap > least * q->length)) p->gap = 0;
}

static bool is_slack(const struct wf_link *q, const struct pulling *p)
{
    return !q->pushes && !(p->force > 0) && !(p->gap > 0);
}

/* Forces of links: their own, or where only the shape is known those by it. */
static void load_links(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    for (size_t k = 0; k < l->links; k++) {
        size_t from = end_of_row(b, l->link[k].segment[0]), to = end_of_row(b, l->link[k].segment[1]);
        double f[3];
        if (b->links) {
            see_link(b, k);
            for (int i = 0; i < 3; i++) f[i] = b->links->link[k].force * b->links->link[k].axis[0][i];
        } else
            (void)wf_link_pull(&l->link[k], b->pose[from].r, b->pose[to].r, f);
        v3_add(b->wrench[from].n, 1, f);
        v3_add(b->wrench[to].n, -1, f);
    }
}

/* ---- At element ends ---- */

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
    load_links(b);
}

/* Follower loads rotate with their section: dn = spin x n. Cables resist as their ends move. */
void wf_beam_ends_react(struct wf_beam *b)
{
    const struct wf_loads *l = &b->loads;
    if (!b->only) memset(b->node, 0, b->mesh.n * sizeof *b->node);
    for (size_t k = 0; b->only && k < b->only->n; k++) memset(&b->node[b->only->id[k]], 0, sizeof *b->node);
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

/* Mark an element and all below it. */
static void mark_path(const struct wf_beam *b, size_t end, bool *on)
{
    for (int32_t i = (int32_t)end; i >= 0 && !on[i]; i = b->mesh.part[i].parent) on[i] = true;
}

/* Its force where the tree was drawn. */
static void begin_link(const struct wf_tree *t, const struct wf_link *q, struct pulling *p)
{
    const int32_t a = q->segment[0], c = q->segment[1];
    const double from[3] = { t->x1[a], t->y1[a], t->z1[a] }, to[3] = { t->x1[c], t->y1[c], t->z1[c] };
    double f[3];
    p->force = wf_link_pull(q, from, to, f);
    p->give = 1 / q->stiffness;
}

enum wf_status wf_beam_links_take(struct wf_beam *b, struct wf_arena *a, struct wf_arena *newton,
                                  struct wf_err *e)
{
    const struct wf_loads *l = &b->loads;
    struct wf_arena scratch = { 0 };
    bool *on = WF_TAKE(&scratch, b->mesh.n, bool);
    struct wf_beam_links *x = b->links = WF_TAKE(a, 1, struct wf_beam_links);
    if (x) x->path = WF_TAKE(a, b->mesh.n, int32_t);
    if (x) x->strain = wf_arena_take(a, b->mesh.n, sizeof *x->strain);
    if (x) x->step = wf_arena_take(a, b->mesh.n, sizeof *x->step);
    if (x) x->before = wf_arena_take(a, b->mesh.n, sizeof *x->before);
    bool room = on && x && x->path && x->strain && x->step && x->before;
    for (size_t k = 0; k < 2 * l->links && room; k++)
        mark_path(b, end_of_row(b, l->link[k / 2].segment[k % 2]), on);
    for (size_t i = b->mesh.n; room && i-- > 0;)
        if (on[i]) x->path[x->below++] = (int32_t)i;
    for (size_t k = 0; k < l->links && room; k++) begin_link(b->mesh.tree, &l->link[k], &x->link[k]);
    wf_arena_free(&scratch);
    return room ? wf_beam_small_take(b, newton, e) : wf_fail(e, WF_ENOMEM, "not enough memory for cables");
}

/* The directions in which links resist in the present shape. */
static void find_directions(struct wf_beam *b)
{
    const double none = 1e-12; /* of the stiffness along a link */
    const struct wf_loads *l = &b->loads;
    struct wf_beam_links *x = b->links;
    x->n = 0;
    for (size_t k = 0; k < l->links; k++) {
        const struct wf_link *q = &l->link[k];
        const struct pulling *p = &x->link[k];
        if (is_slack(q, p)) continue;
        for (int i = 0; i < 3; i++) {
            double stiffness = i ? p->force / p->length : q->stiffness;
            if (!(fabs(stiffness) > none * q->stiffness)) continue;
            x->at[x->n] = (struct direction){ .link = k,
                                              .from = end_of_row(b, q->segment[0]),
                                              .to = end_of_row(b, q->segment[1]),
                                              .stiffness = stiffness,
                                              .gap = i ? 0 : p->gap };
            memcpy(x->at[x->n++].axis, p->axis[i], sizeof p->axis[i]);
        }
    }
}

/* Is a direction that along its link? */
static bool is_along(const struct wf_beam_links *x, size_t i)
{
    return !i || x->at[i].link != x->at[i - 1].link;
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
static void find_flexibility(struct wf_beam *b)
{
    struct wf_beam_links *x = b->links;
    for (size_t from = 0; from < x->n; from += WF_BEAM_SIDES) {
        size_t some = x->n - from < WF_BEAM_SIDES ? x->n - from : WF_BEAM_SIDES;
        clear_pushes(b);
        for (size_t c = 0; c < some; c++) pull(b, &x->at[from + c], (int)c, 1);
        wf_beam_answer_path(b, x->path, x->below);
        for (size_t r = 0; r < x->n; r++)
            for (size_t c = 0; c < some; c++) x->flexibility[r][from + c] = -parted(b, &x->at[r], (int)c);
    }
    for (size_t k = 0; k < x->n; k++) {
        x->flexibility[k][k] += 1 / x->at[k].stiffness;
        if (is_along(x, k)) x->link[x->at[k].link].give = fabs(x->flexibility[k][k]);
    }
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

/* Forces that answer to the ends' moving apart in one lane, and with `gaps` to what they are apart already.
 */
static void resist(const struct wf_beam *b, int lane, bool gaps, double force[DIRECTIONS])
{
    const struct wf_beam_links *x = b->links;
    double apart[DIRECTIONS];
    for (size_t k = 0; k < x->n; k++) apart[k] = parted(b, &x->at[k], lane) + (gaps ? x->at[k].gap : 0);
    for (size_t k = 0; k < x->n; k++) {
        force[k] = 0;
        for (size_t c = 0; c < x->n; c++) force[k] += x->inverse[k][c] * apart[c];
    }
}

/* Energy of the gaps. */
static void add_misfit(struct wf_beam *b)
{
    for (size_t k = 0; k < b->loads.links; k++) {
        const struct pulling *p = &b->links->link[k];
        b->misfit.bending += 0.5 * p->gap * p->gap / p->give;
    }
}

static bool join_tangent(struct wf_beam *b, struct wf_beam_stability *count)
{
    struct wf_beam_links *x = b->links;
    double force[DIRECTIONS];
    find_directions(b);
    memset(x->strain, 0, x->below * sizeof *x->strain);
    for (size_t k = 0; k < b->loads.links; k++) x->link[k].change = 0;
    if (!x->n) return true;
    find_flexibility(b);
    if (!invert(x)) return false;
    if (count) count_links(x, count);
    correct_path(b);
    resist(b, 0, true, force);
    clear_pushes(b);
    for (size_t k = 0; k < x->n; k++) {
        pull(b, &x->at[k], 0, force[k]);
        if (is_along(x, k)) x->link[x->at[k].link].change = force[k];
    }
    wf_beam_correct_path(b, x->path, x->below, x->strain);
    return true;
}

bool wf_beam_links_join(struct wf_beam *b, bool tangent, struct wf_beam_stability *count)
{
    bool joined = !tangent || join_tangent(b, count);
    add_misfit(b);
    return joined;
}

void wf_beam_links_keep(struct wf_beam *b)
{
    struct wf_beam_links *x = b->links;
    x->stretched = x->n, x->share = 0;
    for (size_t k = 0; k < b->loads.links; k++) {
        struct pulling *p = &x->link[k];
        p->before = p->force, p->step = p->change;
    }
    memcpy(x->step, x->strain, x->below * sizeof *x->step);
    for (size_t k = 0; k < x->below; k++) memcpy(x->before[k], b->shape[x->path[k]].g, sizeof x->before[k]);
}

void wf_beam_links_stretch(struct wf_beam *b, double share)
{
    struct wf_beam_links *x = b->links;
    x->share += share;
    for (size_t k = 0; k < b->loads.links; k++) {
        struct pulling *p = &x->link[k];
        p->force = p->before + x->share * p->step;
        if (!b->loads.link[k].pushes) p->force = fmax(p->force, 0);
    }
    for (size_t k = 0; k < x->below && x->stretched; k++) {
        struct wf_beam_shape *u = &b->shape[x->path[k]];
        memcpy(u->g, x->before[k], sizeof u->g); /* a sweep at another share may have changed it */
        for (int j = 0; j < 2; j++) v3_add(u->g[j], x->share, x->step[k][j]);
    }
}

bool wf_beam_links_linearise(struct wf_beam *b)
{
    find_directions(b);
    find_flexibility(b);
    return invert(b->links);
}

void wf_beam_links_answer(struct wf_beam *b)
{
    double force[WF_BEAM_SIDES][DIRECTIONS];
    for (int lane = 0; lane < WF_BEAM_SIDES; lane++) resist(b, lane, false, force[lane]);
    for (int lane = 0; lane < WF_BEAM_SIDES; lane++)
        for (size_t k = 0; k < b->links->n; k++) pull(b, &b->links->at[k], lane, force[lane][k]);
}

void wf_beam_links_carry(const struct wf_beam *from, struct wf_beam *to)
{
    if (!from->links || !to->links) return;
    for (size_t k = 0; k < to->loads.links; k++) {
        to->links->link[k].force = from->links->link[k].force;
        to->links->link[k].give = from->links->link[k].give;
    }
}

void wf_beam_links_read(const struct wf_beam *b, double force[WF_LINKS_MAX])
{
    for (size_t k = 0; k < WF_LINKS_MAX; k++)
        force[k] = b->links && k < b->loads.links ? b->links->link[k].force : 0;
}
