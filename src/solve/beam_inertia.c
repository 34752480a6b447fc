/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One kernel for groups of elements; compiled for each width (WF_WIDTH). */
#include "solve/beam_inertia.h"
#include "base/real.h"
#include <stdbool.h>

#define NAMED(width) NAMED_(width)
#define NAMED_(width) wf_inertia_##width

enum { ROW = 8, INNER = 12 };

/* Places of an element's numbers: those of the way down, of both ways, of the way up. `held`: the rows by
 * which the wrench on the base answers to the element, 3 (moments) or, of a tied tree, 6. */
enum { R = 0, GIVE = 36, T = 40 };
#define VN(held) (T + 6 * (held)) /* as all below: first number */
#define AXIS(held) (VN(held) + 18)
#define ROOT(held) (AXIS(held) + 6)
#define P(held) (ROOT(held) + 4)
#define X(held) (P(held) + 18)
#define NUMBERS(held) (X(held) + 6 * (held))

/* Elements of a group, from the lane `from` on. */
struct some {
    size_t n; /* that count */
    const double *factor;
    double *inner;
    const int32_t *id, *base;
};

WF_INLINE struct some some_of(const struct wf_beam_inertia *x, size_t g, size_t lanes, size_t from)
{
    size_t left = (size_t)x->some[g] > from ? (size_t)x->some[g] - from : 0;
    return (struct some){ .n = left < WF_WIDTH ? left : WF_WIDTH,
                          .factor = x->factor + g * x->numbers * lanes + from,
                          .inner = x->inner + g * x->vectors * INNER * lanes + from,
                          .id = x->id + g * lanes + from,
                          .base = x->base + g * lanes + from };
}

WF_INLINE real load(const double *at)
{
    real out;
    memcpy(&out, at, sizeof out);
    return out;
}

WF_INLINE void gather(const double *array, const int32_t *id, size_t stride, size_t n, real *to)
{
    const double *at[WF_WIDTH];
    for (size_t k = 0; k < WF_WIDTH; k++) at[k] = array + (size_t)id[k] * stride;
    real_gather(at, n, to);
}

/* n numbers to the places of the first `some` lanes; `add`: added to those there. */
WF_INLINE void scatter(const real *from, size_t n, bool add, double *array, const int32_t *id, size_t stride,
                       size_t some)
{
    double *at[WF_WIDTH];
    for (size_t k = 0; k < WF_WIDTH; k++) at[k] = array + (size_t)id[k] * stride;
    if (add)
        real_scatter_add(from, n, some, at);
    else
        real_scatter(from, n, some, at);
}

#define NUMBER(q) load(f + (size_t)(q)*lanes)

/* Wrench on the base, of an element with the wrench `push` on its end and inertia from `in`. */
WF_INLINE void element_down(const double *f, size_t lanes, int held, const real push[6], const real in[8],
                            double *inner, real down[6])
{
    real force[2][3], couple[2], turn[2][3], d[6];
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++) force[j][i] = 2 * NUMBER(ROOT(held) + j) * in[4 * j + i];
        couple[j] = 2 * NUMBER(ROOT(held) + 2 + j) * in[4 * j + 3];
    }
    for (int j = 0; j < 2; j++) {
        real n[3], t[3], along, across = NUMBER(GIVE + j);
        for (int i = 0; i < 3; i++) {
            n[i] = push[i] + (gauss_down[j][0] * force[0][i] + gauss_down[j][1] * force[1][i]);
            t[i] = NUMBER(AXIS(held) + 3 * j + i);
        }
        along = NUMBER(GIVE + 2 + j) * (t[0] * n[0] + t[1] * n[1] + t[2] * n[2]);
        for (int i = 0; i < 3; i++) {
            const int at = VN(held) + 9 * j + 3 * i;
            real stretch = across * n[i] + along * t[i];
            memcpy(inner + (size_t)(6 + 3 * j + i) * lanes, &stretch, sizeof stretch);
            turn[j][i] = NUMBER(at) * n[0] + NUMBER(at + 1) * n[1] + NUMBER(at + 2) * n[2] + couple[j] * t[i];
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            d[3 * j + i] = push[3 + i] + (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        down[i] = push[i] + 0.5 * (force[0][i] + force[1][i]);
        down[3 + i] = push[3 + i] + 0.5 * (turn[0][i] + turn[1][i]);
    }
    real y[6];
    for (int r = 0; r < 6; r++) {
        y[r] = NUMBER(R + 6 * r) * d[0];
        for (int c = 1; c < 6; c++) y[r] += NUMBER(R + 6 * r + c) * d[c];
        memcpy(inner + (size_t)r * lanes, &y[r], sizeof y[r]);
    }
    for (int r = 0; r < held; r++)
        for (int c = 0; c < 6; c++) down[6 - held + r] += NUMBER(T + 6 * r + c) * y[c];
}

/* Motion of an element, and of its end, for the displacement and spin of its base. */
WF_INLINE void element_up(const double *f, size_t lanes, int held, const real base[6], const double *inner,
                          real motion[8], real end[6])
{
    real y[6], spin[2][3], rise[2][3];
    for (int r = 0; r < 6; r++) {
        y[r] = load(inner + (size_t)r * lanes);
        for (int c = 0; c < held; c++) y[r] += NUMBER(X(held) + held * r + c) * base[6 - held + c];
    }
    for (int j = 0; j < 2; j++) {
        const int at = VN(held) + 9 * j; /* transposed it turns spin into rise */
        for (int i = 0; i < 3; i++) spin[j][i] = base[3 + i] + y[3 * j + i];
        for (int i = 0; i < 3; i++)
            rise[j][i] = NUMBER(at + i) * spin[j][0] + NUMBER(at + 3 + i) * spin[j][1] +
                         NUMBER(at + 6 + i) * spin[j][2] + load(inner + (size_t)(6 + 3 * j + i) * lanes);
    }
    for (int j = 0; j < 2; j++) {
        real twist = NUMBER(AXIS(held) + 3 * j) * spin[j][0];
        for (int i = 1; i < 3; i++) twist += NUMBER(AXIS(held) + 3 * j + i) * spin[j][i];
        for (int i = 0; i < 3; i++)
            motion[4 * j + i] = NUMBER(ROOT(held) + j) *
                                (base[i] + (gauss_up[j][0] * rise[0][i] + gauss_up[j][1] * rise[1][i]));
        motion[4 * j + 3] = NUMBER(ROOT(held) + 2 + j) * twist;
    }
    for (int i = 0; i < 3; i++) {
        const int at = P(held) + 6 * i;
        end[i] = base[i] + 0.5 * (rise[0][i] + rise[1][i]);
        end[3 + i] = base[3 + i] + NUMBER(at) * y[0];
        for (int c = 1; c < 6; c++) end[3 + i] += NUMBER(at + c) * y[c];
    }
}

/* Number c of vector v at c * vectors + v, and of it alone. */
WF_INLINE void take_vector(const real *all, size_t vectors, size_t v, real one[ROW])
{
    for (size_t c = 0; c < ROW; c++) one[c] = all[c * vectors + v];
}

WF_INLINE void some_down(const struct wf_beam_inertia *x, const struct some *s, size_t lanes, int held,
                         const double *in)
{
    const size_t many = x->vectors;
    real all[ROW * WF_INERTIA_MOST];
    gather(in, s->id, ROW * many, ROW * many, all);
    for (size_t v = 0; v < many; v++) {
        real one[ROW], push[ROW], down[ROW];
        down[6] = down[7] = real_of(0);
        take_vector(all, many, v, one);
        gather(x->ends + ROW * v, s->id, ROW * many, ROW, push);
        element_down(s->factor, lanes, held, push, one, s->inner + v * INNER * lanes, down);
        scatter(down, ROW, true, x->ends + ROW * v, s->base, ROW * many, s->n);
    }
}

WF_INLINE void some_up(const struct wf_beam_inertia *x, const struct some *s, size_t lanes, int held,
                       double *out)
{
    const size_t many = x->vectors;
    real all[ROW * WF_INERTIA_MOST];
    for (size_t v = 0; v < many; v++) {
        real base[ROW], one[ROW], end[ROW];
        end[6] = end[7] = real_of(0);
        gather(x->ends + ROW * v, s->base, ROW * many, ROW, base);
        element_up(s->factor, lanes, held, base, s->inner + v * INNER * lanes, one, end);
        scatter(end, ROW, false, x->ends + ROW * v, s->id, ROW * many, s->n);
        for (size_t c = 0; c < ROW; c++) all[c * many + v] = one[c];
    }
    if (out) scatter(all, ROW * many, false, out, s->id, ROW * many, s->n);
}

/* All groups from the tips down, or up from the base. */
WF_INLINE void all_groups(const struct wf_beam_inertia *x, size_t lanes, int held, bool downwards,
                          const double *in, double *out)
{
    for (size_t k = 0; k < x->groups; k++)
        for (size_t from = 0; from < lanes; from += WF_WIDTH) {
            struct some s = some_of(x, downwards ? k : x->groups - 1 - k, lanes, from);
            if (s.n && downwards) some_down(x, &s, lanes, held, in);
            if (s.n && !downwards) some_up(x, &s, lanes, held, out);
        }
}

enum { FREE = 3, TIED = 6 };

/* A variant of its own for each number of lanes and rows. */
WF_INLINE void sweep(const struct wf_beam_inertia *x, bool downwards, const double *in, double *out)
{
    if (WF_WIDTH == 1 && x->lanes == 1 && x->tied)
        all_groups(x, 1, TIED, downwards, in, out);
    else if (WF_WIDTH == 1 && x->lanes == 1)
        all_groups(x, 1, FREE, downwards, in, out);
    else if (x->tied)
        all_groups(x, WF_GROUP, TIED, downwards, in, out);
    else
        all_groups(x, WF_GROUP, FREE, downwards, in, out);
}

static void down(const struct wf_beam_inertia *x, const double *in) { sweep(x, true, in, NULL); }
static void up(const struct wf_beam_inertia *x, double *out) { sweep(x, false, NULL, out); }

const struct wf_inertia_kernel NAMED(WF_WIDTH) = { .width = WF_WIDTH, .down = down, .up = up };

#if WF_WIDTH == 1 /* once */
#include "solve/beam_ends.h"
#include "solve/beam_lanes.h"
#include "solve/beam_path.h"

size_t wf_beam_motion_size(const struct wf_beam *b) { return b->mesh.n * (b->mesh.mass1 ? 11 : 8); }

void wf_beam_motion_mass(const struct wf_beam *b, double *mass)
{
    size_t n = b->mesh.n;
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        for (size_t j = 0; j < 2; j++) {
            for (size_t c = 0; c < 3; c++) mass[8 * i + 4 * j + c] = 0.5 * p->h * p->line[j].mass;
            mass[8 * i + 4 * j + 3] = 0.5 * p->h * p->spin[j];
        }
        for (size_t c = 0; b->mesh.mass1 && c < 3; c++) mass[8 * n + 3 * i + c] = b->mesh.mass1[i];
    }
}

/* The numbers of an element, each `lanes` from the one before. */
static void pack_element(const struct wf_beam_inertia *x, size_t i, size_t held, double *to)
{
    const struct wf_beam *b = x->beam;
    const struct wf_beam_part *p = &b->mesh.part[i];
    const struct wf_beam_small *q = &b->small[i];
    const struct wf_beam_stage *g = &b->stage[i];
    const size_t lanes = x->lanes;
#define TO(number) to[(size_t)(number)*lanes]
    for (size_t k = 0; k < 36; k++) TO(R + k) = q->R[k / 6][k % 6];
    for (size_t k = 0; k < 6 * held; k++) TO(T + k) = q->T[6 - held + k / 6][k % 6];
    for (size_t k = 0; k < 18; k++) TO(VN(held) + k) = p->h * q->Vn[k / 9][k % 9];
    for (size_t k = 0; k < 18; k++) TO(P(held) + k) = q->P[3 + k / 6][k % 6];
    for (size_t k = 0; k < 6 * held; k++) TO(X(held) + k) = b->answer[i].X[k / held][6 - held + k % held];
    for (size_t j = 0; j < 2; j++) {
        TO(GIVE + j) = p->h * p->cs[j], TO(GIVE + 2 + j) = p->h * (p->ca[j] - p->cs[j]);
        TO(ROOT(held) + j) = x->root[8 * i + 4 * j], TO(ROOT(held) + 2 + j) = x->root[8 * i + 4 * j + 3];
        for (size_t c = 0; c < 3; c++) TO(AXIS(held) + 3 * j + c) = g->t[j][c];
    }
#undef TO
}

/* A group of the elements id[n]; lanes to spare repeat the first. */
static void add_group(struct wf_beam_inertia *x, const int32_t *id, size_t n)
{
    const size_t g = x->groups++, lanes = x->lanes;
    x->some[g] = (int32_t)n;
    for (size_t k = 0; k < lanes; k++) x->id[g * lanes + k] = id[k < n ? k : 0];
}

/* Groups from the tips down; then those of the elements that stand on the ground. */
static void add_groups(struct wf_beam_inertia *x)
{
    const struct wf_beam_mesh *m = &x->beam->mesh;
    const struct wf_beam_groups *by = &x->beam->groups;
    for (size_t g = 0; g < by->n; g++) add_group(x, by->group[g].id, (size_t)by->group[g].n);
    for (size_t i = m->n; i-- > 0;) {
        const int32_t id = (int32_t)i;
        if (!by->n || m->part[i].parent < 0) add_group(x, &id, 1);
    }
}

static void place_bases(struct wf_beam_inertia *x)
{
    const struct wf_beam_mesh *m = &x->beam->mesh;
    for (size_t k = 0; k < x->groups * x->lanes; k++) {
        const struct wf_beam_part *p = &m->part[x->id[k]];
        if (p->parent >= 0) {
            x->base[k] = p->parent;
            continue;
        }
        size_t r = 0;
        while (r < x->roots && x->grounded[r] != p->row) r++;
        if (r == x->roots) x->grounded[x->roots++] = p->row;
        x->base[k] = (int32_t)(m->n + r);
    }
}

enum wf_status wf_beam_inertia_open(struct wf_beam *b, const double *root, size_t vectors, struct wf_arena *a,
                                    struct wf_beam_inertia *x, struct wf_err *e)
{
    const size_t n = b->mesh.n, lanes = b->groups.n ? WF_GROUP : 1;
    size_t roots = 0;
    for (size_t i = 0; i < n; i++) roots += b->mesh.part[i].parent < 0;
    const size_t most = (b->groups.n ? b->groups.n + roots : n);
    *x = (struct wf_beam_inertia){
        .beam = b, .root = root, .vectors = vectors, .lanes = lanes, .tied = b->loads.ties > 0
    };
    x->numbers = (size_t)NUMBERS(x->tied ? TIED : FREE);
    x->id = WF_TAKE(a, most * lanes, int32_t), x->base = WF_TAKE(a, most * lanes, int32_t);
    x->some = WF_TAKE(a, most, int32_t), x->grounded = WF_TAKE(a, roots, int32_t);
    x->factor = wf_arena_take_unset(a, most * lanes * x->numbers, sizeof *x->factor);
    x->inner = wf_arena_take_unset(a, most * lanes * vectors * INNER, sizeof *x->inner);
    x->ends = wf_arena_take_unset(a, (n + roots) * vectors * ROW, sizeof *x->ends);
    if (!x->id || !x->base || !x->some || !x->grounded || !x->factor || !x->inner || !x->ends)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the motions of %zu elements", n);
    add_groups(x);
    place_bases(x);
    for (size_t k = 0; k < x->groups * lanes; k++)
        pack_element(x, (size_t)x->id[k], x->tied ? TIED : FREE,
                     x->factor + k / lanes * lanes * x->numbers + k % lanes);
    return WF_OK;
}

/* The inertia of point masses on the ends. */
static void push_masses(const struct wf_beam_inertia *x, const double *in)
{
    const size_t n = x->beam->mesh.n, many = x->vectors;
    memset(x->ends, 0, (n + x->roots) * many * ROW * sizeof *x->ends);
    for (size_t q = 8 * n; q < 11 * n && x->beam->mesh.mass1; q++)
        for (size_t v = 0; v < many; v++)
            x->ends[ROW * ((q - 8 * n) / 3 * many + v) + (q - 8 * n) % 3] = x->root[q] * in[q * many + v];
}

/* Root plates answer to the moments on them. */
static void turn_roots(const struct wf_beam_inertia *x)
{
    for (size_t r = 0; r < x->roots; r++)
        for (size_t v = 0; v < x->vectors; v++) {
            double *at = x->ends + ROW * ((x->beam->mesh.n + r) * x->vectors + v), spin[3];
            m3_apply(x->beam->root_give[x->grounded[r]], at + 3, spin);
            memset(at, 0, ROW * sizeof *at);
            memcpy(at + 3, spin, sizeof spin);
        }
}

/* Answer without the stiffness of links, to what is on the ends and to inertia. */
static void answer(const struct wf_beam_inertia *x, const struct wf_inertia_kernel *k, const double *in,
                   double *out)
{
    k->down(x, in);
    turn_roots(x);
    k->up(x, out);
}

/* What the links answer to the displacements of the ends, on them beside point masses. */
static void push_links(const struct wf_beam_inertia *x, const double *in)
{
    struct wf_beam *b = x->beam;
    memset(b->sides, 0, b->mesh.n * sizeof *b->sides);
    for (size_t i = 0; i < b->mesh.n; i++)
        for (size_t v = 0; v < x->vectors; v++)
            for (size_t c = 0; c < 6; c++) b->sides[i].y[c][v] = wf_beam_inertia_end(x, i, v)[c];
    wf_beam_links_answer(b);
    push_masses(x, in);
    for (size_t i = 0; i < b->mesh.n; i++)
        for (size_t v = 0; v < x->vectors; v++)
            for (size_t c = 0; c < 6; c++) x->ends[ROW * (i * x->vectors + v) + c] += b->sides[i].push[c][v];
}

static const struct wf_inertia_kernel *kernel_of(const struct wf_beam_inertia *x)
{
    size_t width = x->lanes == 1 ? 1 : wf_lanes_kernel(WF_LANES_MOST)->width;
    return width == 8 ? &wf_inertia_8 : width == 4 ? &wf_inertia_4 : &wf_inertia_1;
}

void wf_beam_inertia_answer(const struct wf_beam_inertia *x, const double *in, double *out)
{
    const struct wf_inertia_kernel *k = kernel_of(x);
    const size_t n = x->beam->mesh.n, many = x->vectors;
    push_masses(x, in);
    if (x->beam->links) {
        answer(x, k, in, NULL);
        push_links(x, in);
    }
    answer(x, k, in, out);
    for (size_t q = 8 * n; q < 11 * n && x->beam->mesh.mass1; q++)
        for (size_t v = 0; v < many; v++)
            out[q * many + v] = x->root[q] * wf_beam_inertia_end(x, (q - 8 * n) / 3, v)[(q - 8 * n) % 3];
}

#endif
