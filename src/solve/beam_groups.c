/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One kernel for groups of elements; compiled for each width (WF_WIDTH). */
#include "solve/beam_groups.h"
#define WF_ELEMENTS_ABREAST
#include "load/line_load.h"
#include "solve/beam_condense.h"
#include "solve/beam_lanes.h"
#include <stdbool.h>
#include <stddef.h>

#define NAMED(width) NAMED_(width)
#define NAMED_(width) wf_groups_##width

/* Numbers of an element in the arrays of struct wf_groups_sweep. */
enum { SHAPE = 12, POSE = 12, STAGE = 30, WRENCH = 6, LOAD = 6, REACTION = 48, SMALL = 150 };
enum { PART = sizeof(element) / sizeof(real) };
_Static_assert(sizeof(struct wf_beam_part) == offsetof(struct wf_beam_part, h) + PART * sizeof(double),
               "struct element is struct wf_beam_part from h on");
_Static_assert(sizeof(struct wf_beam_shape) == SHAPE * sizeof(real) &&
                   sizeof(struct wf_beam_stage) == STAGE * sizeof(real) &&
                   sizeof(struct wf_beam_reaction) == REACTION * sizeof(real) &&
                   sizeof(struct wf_beam_small) == SMALL * sizeof(real),
               "numbers of an element");

/* The lanes' places in an array of all elements. */
struct places {
    double *at[WF_WIDTH];
};

/* The first n numbers at each lane's place. */
WF_INLINE void gather(const struct places *from, size_t n, real *to)
{
    if (n >= WF_WIDTH) real_gather((const double *const *)from->at, n, to);
    for (size_t q = 0; n < WF_WIDTH && q < n; q++)
        for (int k = 0; k < WF_WIDTH; k++) real_lane(to[q], k) = from->at[k][q];
}

/* Numbers to the places of the first `some` lanes. */
WF_INLINE void scatter(const real *from, size_t n, size_t some, const struct places *to)
{
    for (size_t q = 0; n < WF_WIDTH && q < n; q++)
        for (size_t k = 0; k < some; k++) to->at[k][q] = real_lane(from[q], k);
    if (n >= WF_WIDTH) real_scatter(from, n, some, to->at);
}

/* Up to WF_WIDTH elements of a group, or of several trees. Lanes to spare repeat the first element, and
 * nothing is kept of them. */
struct some {
    size_t n;
    size_t id[WF_WIDTH];
    struct wf_groups_sweep *of[WF_WIDTH];
    real_truth here;
};

WF_INLINE void set_here(struct some *s)
{
#if WF_WIDTH == 8
    const real_truth lane = { 0, 1, 2, 3, 4, 5, 6, 7 };
#elif WF_WIDTH == 4
    const real_truth lane = { 0, 1, 2, 3 };
#else
    const real_truth lane = 0;
#endif
    s->here = (real_truth)(lane < (int64_t)s->n);
#if WF_WIDTH == 1
    s->here = -s->here;
#endif
}

WF_INLINE struct some some_of(struct wf_groups_sweep *x, const struct wf_beam_group *g, size_t from)
{
    size_t left = (size_t)g->n - from;
    struct some s = { .n = left < WF_WIDTH ? left : WF_WIDTH };
    for (size_t k = 0; k < WF_WIDTH; k++) s.id[k] = (size_t)g->id[from + k], s.of[k] = x;
    set_here(&s);
    return s;
}

/* An array of struct wf_groups_sweep. */
#define ARRAY(name) offsetof(struct wf_groups_sweep, name)

WF_INLINE double *array_of(const struct wf_groups_sweep *x, size_t array)
{
    double *out;
    memcpy(&out, (const char *)x + array, sizeof out);
    return out;
}

WF_INLINE struct places places_of(const struct some *s, size_t array, size_t per_element)
{
    struct places p;
    for (size_t k = 0; k < WF_WIDTH; k++) p.at[k] = array_of(s->of[k], array) + s->id[k] * per_element;
    return p;
}
/* The same of the elements below. */
WF_INLINE struct places places_below(const struct some *s, size_t array, size_t per_element)
{
    struct places p;
    for (size_t k = 0; k < WF_WIDTH; k++)
        p.at[k] = array_of(s->of[k], array) + (size_t)s->of[k]->mesh->part[s->id[k]].parent * per_element;
    return p;
}

WF_INLINE void gather_part(const struct some *s, element *p)
{
    struct places from;
    for (size_t k = 0; k < WF_WIDTH; k++) from.at[k] = &s->of[k]->mesh->part[s->id[k]].h;
    gather(&from, PART, (real *)p);
}

/* The lanes are anywhere in memory, where the processor does not expect them: fetch those of the next group
 * while this one is computed. */
WF_INLINE void fetch(const double *array, size_t id, size_t per_element)
{
    enum { LINE = 8 }; /* numbers */
    for (size_t q = 0; q < per_element; q += LINE) __builtin_prefetch(array + id * per_element + q);
}

WF_INLINE void fetch_up(const struct wf_groups_sweep *x, const struct wf_beam_group *g)
{
    for (int k = 0; k < g->n; k++) {
        size_t i = (size_t)g->id[k];
        fetch((const double *)x->mesh->part, i, PART + 1);
        fetch(x->shape, i, SHAPE), fetch(x->stage, i, STAGE), fetch(x->pose, i, POSE);
    }
}

WF_INLINE void fetch_down(const struct wf_groups_sweep *x, const struct wf_beam_group *g)
{
    for (int k = 0; k < g->n; k++) {
        size_t i = (size_t)g->id[k];
        fetch((const double *)x->mesh->part, i, PART + 1);
        fetch(x->shape, i, SHAPE), fetch(x->stage, i, STAGE);
        fetch(x->wrench, i, WRENCH), fetch(x->load, i, LOAD);
        if (x->tangent) fetch(x->node, i, REACTION), fetch(x->answer, i, REACTION);
    }
}

/* From the base up. */

static __attribute__((noinline)) void up_some(const struct some *s)
{
    element p;
    struct wf_beam_shape u;
    struct wf_beam_pose base, end;
    struct wf_beam_stage stage;
    struct places at = places_of(s, ARRAY(shape), SHAPE);
    gather_part(s, &p);
    gather(&at, SHAPE, (real *)&u);
    at = places_below(s, ARRAY(pose), POSE);
    gather(&at, POSE, (real *)&base);
    place_element(&p, &u, &base, &stage, &end);
    at = places_of(s, ARRAY(stage), STAGE);
    scatter((real *)&stage, STAGE, s->n, &at);
    at = places_of(s, ARRAY(pose), POSE);
    scatter((real *)&end, POSE, s->n, &at);
}

static void up(struct wf_groups_sweep *x)
{
    for (size_t g = x->groups->n; g-- > 0;) {
        const struct wf_beam_group *group = &x->groups->group[g];
        if (g) fetch_up(x, group - 1);
        for (size_t from = 0; from < (size_t)group->n; from += WF_WIDTH) {
            struct some s = some_of(x, group, from);
            up_some(&s);
        }
    }
}

/* From the tips down. */

struct work {
    const struct wf_groups_sweep *x; /* of all lanes, or the first: what they have in common */
    struct air air;
    real gravity, weight_scale, point_scale; /* of the lanes' loads */
    real margin;
    real_truth guard;
    bool counting; /* in some lane */
    struct beam_misfit misfit[WF_GROUP / WF_WIDTH];
    real_truth broken, apart;
};

/* An element with its state, and what of it is passed on. */
struct taken {
    element p;
    struct wf_beam_shape u;
    struct wf_beam_pose base;
    struct wf_beam_stage s;
    struct wf_beam_wrench end, at[2], down;
    struct wf_beam_reaction above;
    struct real_load load[2];
};

WF_INLINE void load_at(const struct work *w, int j, struct taken *t, struct shift *shift)
{
    struct real_load *load = &t->load[j];
    const struct fixed_point *line = &t->p.line[j];
    struct real_point point = { .diameter = line->diameter,
                                .drag = line->drag,
                                .lift = line->lift,
                                .sail = line->sail,
                                .weight = -line->mass * w->gravity * w->weight_scale };
    memcpy(point.x, t->s.r[j], sizeof point.x), memcpy(point.t, t->s.t[j], sizeof point.t);
    load_points(&w->air, &point, load, shift ? shift->force[j] : NULL);
    v3_add(load->force, w->point_scale, t->p.dead[j]);
    for (int i = 0; i < 9 && w->x->frozen; i++) load->by_place[i] = load->by_turn[i] = real_of(0);
}

/* shift: how the loads change where they grow; NULL: not wanted. */
WF_INLINE void take(const struct work *w, const struct some *s, struct taken *t, struct shift *shift)
{
    struct places at = places_of(s, ARRAY(shape), SHAPE);
    gather_part(s, &t->p);
    gather(&at, SHAPE, (real *)&t->u);
    at = places_of(s, ARRAY(stage), STAGE), gather(&at, STAGE, (real *)&t->s);
    at = places_below(s, ARRAY(pose), POSE), gather(&at, POSE, (real *)&t->base);
    at = places_of(s, ARRAY(wrench), WRENCH), gather(&at, WRENCH, (real *)&t->end);
    for (int j = 0; j < 2; j++) load_at(w, j, t, shift);
    real force[2][3];
    for (int j = 0; j < 2; j++) memcpy(force[j], t->load[j].force, sizeof force[j]);
    at = places_of(s, ARRAY(load), LOAD), scatter(force[0], LOAD, s->n, &at);
    balance_element(t->p.h, &t->s, NULL, t->load, &t->end, t->at, &t->down);
}

/* Add the residual of the lanes to `sum` (of the group's part); k: curvature of the material law. */
WF_INLINE void add_misfit(struct work *w, const struct some *s, const struct taken *t, real k[2][3],
                          real gap[2][3], struct beam_misfit *sum)
{
    struct beam_misfit here = {
        .bending = real_of(0), .energy = real_of(0), .strain = real_of(0), .turn = real_of(0)
    };
    misfit_add(&t->p, NULL, &t->s, t->at, k, gap, &here);
    sum->bending += real_choose(s->here, here.bending, real_of(0));
    sum->energy += real_choose(s->here, here.energy, real_of(0));
    sum->strain = real_max(real_choose(s->here, here.strain, real_of(0)), sum->strain);
    sum->turn = real_max(real_choose(s->here, here.turn, real_of(0)), sum->turn);
    for (size_t i = 0; i < s->n && w->x->off; i++) w->x->off[s->id[i]] = real_lane(here.bending, i);
}

WF_INLINE void pass_down(const struct some *s, const struct taken *t)
{
    struct places to = places_below(s, ARRAY(wrench), WRENCH);
    real_scatter_add((const real *)&t->down, WRENCH, s->n, to.at);
}

static __attribute__((noinline)) void forces_of_some(struct work *w, const struct some *s, size_t part)
{
    struct taken t;
    real k[2][3], gap[2][3];
    take(w, s, &t, NULL);
    curvature_of(&t.p, &t.u, k);
    for (int j = 0; j < 2; j++) {
        m3_apply(t.base.L, k[j], k[j]);
        for (int i = 0; i < 3; i++) k[j][i] += t.s.k0[j][i];
    }
    gap_of(&t.p, &t.s, t.at, gap);
    add_misfit(w, s, &t, k, gap, &w->misfit[part]);
    pass_down(s, &t);
}

/* Unstable directions, per element. */
WF_INLINE void count_unstable(const struct work *w, const struct some *s, const struct taken *t, real S[6][6],
                              const struct kinematics *k)
{
    real found = unstable_directions(&t->p, S, k, w->margin);
    for (size_t i = 0; i < s->n; i++) {
        struct wf_groups_sweep *x = s->of[i];
        if (!x->counting || !(real_lane(found, i) > 0)) continue;
        double n[3];
        for (int c = 0; c < 3; c++) n[c] = real_lane(t->down.n[c], i);
        x->negative += (size_t)real_lane(found, i);
        x->bears = fmax(x->bears, sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
        if (x->weak) x->weak[s->id[i]] = true;
    }
}

/* Elements taken by themselves; rare. Returned: lanes that have no answer so. */
static __attribute__((noinline)) real_truth answer_apart(const struct taken *t, const struct kinematics *k,
                                                         by_base A)
{
    return bend_apart(&t->p, NULL, k, &t->s, t->at, columns_of(0, TO_SIDE), A);
}

/* What is kept for small loads. S: the element's equations. */
static __attribute__((noinline)) void keep_small(const struct some *s, const struct taken *t,
                                                 const struct statics *q, real P[6][6], real S[6][6])
{
    struct wf_beam_small o;
    real T[6][6];
    by_base B;
    struct places to = places_of(s, ARRAY(small), SMALL);
    const real half = 0.5 * t->p.h;
    invert6(S, o.R);
    base_wrench_of(half, q, t->load, NULL, columns_of(0, TO_SIDE), T, B);
    small_of(half, q, t->at, &t->above, P, T, &o);
    scatter((const real *)&o, SMALL, s->n, &to);
}

/* Solve the element's equations; where its step is too large, take it by itself. Returned: such lanes. */
WF_INLINE real_truth solve_some(struct work *w, const struct some *s, const struct taken *t,
                                const struct kinematics *k, real P[6][6], real S[6][6], by_base A,
                                struct columns b)
{
    real_truth broken = solve6(S, A, b), apart = { 0 };
    if (real_any(w->guard) && real_any(apart = (leaps(A, P) | broken) & w->guard)) {
        by_base alone;
        real_truth still = answer_apart(t, k, alone);
        broken = (broken & ~apart) | (apart & still);
        for (int r = 0; r < 6; r++)
            for (int c = b.from; c < b.to; c++) A[r][c] = real_choose(apart, alone[r][c], A[r][c]);
    }
    w->broken |= broken & s->here, w->apart |= apart & s->here;
    return apart;
}

/* A row per unknown, as struct wf_beam_reaction; columns left out are those of the unit matrix times `unit`.
 */
WF_INLINE void take_rows(by_base A, struct columns b, double unit, real row[REACTION])
{
    for (int r = 0; r < 6; r++) {
        for (int c = 0; c < 6; c++) row[6 * r + c] = c < b.from ? real_of(r == c ? unit : 0) : A[r][c];
        row[36 + r] = A[r][NOW];
        row[42 + r] = b.side ? A[r][TO_SIDE] : real_of(0);
    }
}

WF_INLINE void keep_reaction(const struct some *s, size_t array, struct columns b, double unit, by_base A)
{
    real row[REACTION];
    struct places to = places_of(s, array, REACTION);
    take_rows(A, b, unit, row);
    scatter(row, REACTION, s->n, &to);
}

/* Rows of the end's motion that follow_answer leaves out. */
WF_INLINE void add_left_out(real P[6][6], by_base y, struct columns b, by_base Z)
{
    for (int i = 0; i < b.from; i++)
        for (int m = 0; m < 6; m++)
            for (int c = b.from; c < b.to; c++) Z[i][c] += P[i][m] * y[m][c];
}

/* Pass the reaction on to the elements below. */
WF_INLINE void pass_reaction(const struct some *s, struct columns b, by_base B, real_truth apart)
{
    real row[REACTION];
    struct places to = places_below(s, ARRAY(node), REACTION);
    if (real_any(apart))
        for (int r = 0; r < 6; r++)
            for (int c = b.from; c < b.to; c++) B[r][c] = real_choose(apart, real_of(0), B[r][c]);
    take_rows(B, b, 0, row);
    real_scatter_add(row, REACTION, s->n, to.at);
}

WF_INLINE void keep_strain(const struct some *s, const struct taken *t)
{
    real g[2][3];
    struct places to = places_of(s, ARRAY(shape), SHAPE);
    for (int k = 0; k < WF_WIDTH; k++) to.at[k] += SHAPE / 2;
    for (int j = 0; j < 2; j++) strain_of(&t->p, t->base.L, &t->s, t->at, j, g[j]);
    scatter(g[0], SHAPE / 2, s->n, &to);
}

/* Changes of the strains where the loads grow. */
WF_INLINE void keep_strain_shift(const struct some *s, const struct taken *t, const struct shift *shift)
{
    real g[2][3];
    struct places to = places_of(s, ARRAY(side), SHAPE);
    for (int k = 0; k < WF_WIDTH; k++) to.at[k] += SHAPE / 2;
    for (int j = 0; j < 2; j++) m3_apply_transposed(t->base.L, shift->gap[j], g[j]);
    scatter(g[0], SHAPE / 2, s->n, &to);
}

/* grows: the second constant is wanted too. */
WF_INLINE void eliminate_some(struct work *w, const struct some *s, size_t part, enum variation kind,
                              bool grows)
{
    const int from = first_column(kind);
    const struct columns b = columns_of(from, grows ? BY_BASE : TO_SIDE);
    struct taken t;
    struct shift given, *shift = grows ? &given : NULL;
    struct turns o;
    struct kinematics k;
    struct statics q;
    real P[6][6], S[6][6], T[6][6], Mn[2][9];
    by_base A, Z, B;
    struct places at = places_of(s, ARRAY(node), REACTION);
    take(w, s, &t, shift);
    gather(&at, REACTION, (real *)&t.above);
    const real half = 0.5 * t.p.h;
    turns_of(&t.u, &o);
    kinematics_of(&t.p, &t.u, &o, t.base.L, &t.s, NULL, &k);
    statics_of(&t.p, NULL, &t.s, t.load, kind, t.at, &q);
    add_misfit(w, s, &t, k.k, q.gap, &w->misfit[part]);
    pass_down(s, &t);
    stiffen_kinematics(&k, 1 + element_damping(&t.p, NULL, &k, &t.s, t.at));
    keep_strain(s, &t);
    if (grows) shift_of(&t.p, &t.s, t.at, &t.above, shift), keep_strain_shift(s, &t, shift);
    end_motion_of(half, &k, &q, shift, b, P, Z);
    element_equations(&t.p, NULL, &k, &q, &t.s, t.at, shift, from, S, A, Mn);
    attach_part_above(Mn, &t.above, P, Z, b, S, A);
    if (w->counting) count_unstable(w, s, &t, S, &k);
    if (w->x->small) keep_small(s, &t, &q, P, S);
    real_truth apart = solve_some(w, s, &t, &k, P, S, A, b);
    for (int r = 0; r < 6; r++)
        for (int c = from; c < b.to; c++) A[r][c] = -A[r][c];
    base_wrench_of(half, &q, t.load, shift, b, T, B);
    follow_answer(half, &q, &t.above, P, T, A, b, Z, B);
    add_left_out(P, A, b, Z);
    keep_reaction(s, ARRAY(answer), b, 0, A);
    keep_reaction(s, ARRAY(node), b, 1, Z);
    pass_reaction(s, b, B, apart);
}

static __attribute__((noinline)) void eliminate_upwards(struct work *w, const struct some *s, size_t part)
{
    eliminate_some(w, s, part, VARIES_UPWARDS, false);
}
static __attribute__((noinline)) void eliminate_varying(struct work *w, const struct some *s, size_t part)
{
    eliminate_some(w, s, part, VARIES, false);
}
static __attribute__((noinline)) void eliminate_upwards_growing(struct work *w, const struct some *s,
                                                                size_t part)
{
    eliminate_some(w, s, part, VARIES_UPWARDS, true);
}
static __attribute__((noinline)) void eliminate_varying_growing(struct work *w, const struct some *s,
                                                                size_t part)
{
    eliminate_some(w, s, part, VARIES, true);
}

/* Sums over the lanes, in one order at any width. */
static void sum_up(const struct work *w, struct wf_groups_sweep *x)
{
    x->bending = x->energy = x->strain = x->turn = 0;
    for (int i = 0; i < WF_GROUP; i++) {
        const struct beam_misfit *m = &w->misfit[i / WF_WIDTH];
        x->bending += real_lane(m->bending, i % WF_WIDTH), x->energy += real_lane(m->energy, i % WF_WIDTH);
        x->strain = fmax(x->strain, real_lane(m->strain, i % WF_WIDTH));
        x->turn = fmax(x->turn, real_lane(m->turn, i % WF_WIDTH));
    }
    x->strain = sqrt(x->strain), x->turn = sqrt(x->turn);
}

/* A sweep of so many lanes; those to spare are as the first. */
static void begin_work(struct wf_groups_sweep *const *x, size_t n, struct work *w)
{
    const struct wf_loads *loads[WF_WIDTH];
    *w = (struct work){ .x = x[0] };
    for (size_t k = 0; k < WF_WIDTH; k++) {
        struct wf_groups_sweep *own = x[k < n ? k : 0];
        loads[k] = own->loads;
        real_lane(w->gravity, k) = own->loads->gravity;
        real_lane(w->weight_scale, k) = own->loads->weight_scale;
        real_lane(w->point_scale, k) = own->loads->point_scale;
        real_lane(w->margin, k) = own->margin;
        real_lane(w->guard, k) = own->guard ? -1 : 0;
        w->counting = w->counting || own->counting;
        own->negative = 0, own->bears = 0;
    }
    set_air(loads, &w->air);
    for (size_t k = 0; k < WF_WIDTH && x[0]->grows; k++) {
        const struct wf_groups_sweep *own = x[k < n ? k : 0];
        real_lane(w->air.grows_speed, k) = own->growth.speed;
        real_lane(w->air.grows_density, k) = own->growth.density;
    }
}

/* What a sweep computes of some elements. */
typedef void of_some(struct work *, const struct some *, size_t);

static of_some *kind_of(const struct work *w)
{
    /* ties pull by where their ends are in all directions, as winds of any form blow */
    bool upwards = w->air.profile != WF_PROFILE_OTHER && !w->x->loads->ties;
    if (!w->x->tangent) return forces_of_some;
    if (w->x->grows) return upwards ? eliminate_upwards_growing : eliminate_varying_growing;
    return upwards ? eliminate_upwards : eliminate_varying;
}

static bool down(struct wf_groups_sweep *x)
{
    struct wf_groups_sweep *all[WF_WIDTH];
    struct work w;
    for (size_t k = 0; k < WF_WIDTH; k++) all[k] = x;
    begin_work(all, WF_WIDTH, &w);
    of_some *compute = kind_of(&w);
    for (size_t g = 0; g < x->groups->n && !real_any(w.broken); g++) {
        const struct wf_beam_group *group = &x->groups->group[g];
        if (g + 1 < x->groups->n) fetch_down(x, group + 1);
        for (size_t from = 0; from < (size_t)group->n; from += WF_WIDTH) {
            struct some s = some_of(x, group, from);
            compute(&w, &s, from / WF_WIDTH);
        }
    }
    sum_up(&w, x);
    x->apart = real_any(w.apart);
    return !real_any(w.broken);
}

/* The elements of chains that are `from_top` below the last one of each. Returned: whether one is left that
 * does not stand on the ground. */
static bool some_of_chains(struct wf_groups_sweep *const *x, size_t n, size_t from_top, struct some *s)
{
    s->n = n;
    while (s->n && x[s->n - 1]->mesh->n < from_top + 2) s->n--;
    for (size_t k = 0; k < WF_WIDTH && s->n; k++)
        s->of[k] = x[k < s->n ? k : 0], s->id[k] = s->of[k]->mesh->n - 1 - from_top;
    set_here(s);
    return s->n > 0;
}

static void chains_up(struct wf_groups_sweep *const *x, size_t n)
{
    struct some s;
    for (size_t step = x[0]->mesh->n; step-- > 0;) {
        if (some_of_chains(x, n, step, &s)) up_some(&s);
    }
}

static void chains_down(struct wf_groups_sweep *const *x, size_t n)
{
    struct work w;
    struct some s;
    begin_work(x, n, &w);
    of_some *compute = kind_of(&w);
    for (size_t step = 0; some_of_chains(x, n, step, &s); step++) compute(&w, &s, 0);
    for (size_t k = 0; k < n; k++) {
        const struct beam_misfit *m = &w.misfit[0];
        x[k]->bending = real_lane(m->bending, k), x[k]->energy = real_lane(m->energy, k);
        x[k]->strain = sqrt(real_lane(m->strain, k)), x[k]->turn = sqrt(real_lane(m->turn, k));
        x[k]->whole = !real_lane(w.broken, k), x[k]->apart = real_lane(w.apart, k);
    }
}

const struct wf_groups_kernel NAMED(WF_WIDTH) = {
    .width = WF_WIDTH, .up = up, .down = down, .chains_up = chains_up, .chains_down = chains_down
};

#if WF_WIDTH == 1 /* once */

/* Elements on which all above is done: a heap, the farthest from the ground on top, of these the last. */
struct ready {
    int32_t *id;
    const int32_t *depth; /* elements below */
    size_t n;
};

static bool before(const struct ready *r, int32_t a, int32_t b)
{
    return r->depth[a] != r->depth[b] ? r->depth[a] > r->depth[b] : a > b;
}

static void push(struct ready *r, int32_t id)
{
    size_t i = r->n++;
    for (; i && before(r, id, r->id[(i - 1) / 2]); i = (i - 1) / 2) r->id[i] = r->id[(i - 1) / 2];
    r->id[i] = id;
}

static int32_t pop(struct ready *r)
{
    int32_t top = r->id[0], last = r->id[--r->n];
    size_t i = 0;
    for (size_t next; (next = 2 * i + 1) < r->n; i = next) {
        if (next + 1 < r->n && before(r, r->id[next + 1], r->id[next])) next++;
        if (!before(r, r->id[next], last)) break;
        r->id[i] = r->id[next];
    }
    r->id[i] = last;
    return top;
}

/* Fill the groups. waits: per element, how many stand on it. */
static void fill_groups(const struct wf_beam_mesh *m, struct ready *r, int32_t *waits,
                        struct wf_beam_groups *out)
{
    for (size_t i = 0; i < m->n; i++)
        if (!waits[i] && m->part[i].parent >= 0) push(r, (int32_t)i);
    while (r->n) {
        struct wf_beam_group *g = &out->group[out->n++];
        for (g->n = 0; g->n < WF_GROUP && r->n; g->n++) g->id[g->n] = pop(r);
        for (int k = g->n; k < WF_GROUP; k++) g->id[k] = g->id[0];
        for (int k = 0; k < g->n; k++) {
            int32_t below = m->part[g->id[k]].parent;
            if (!--waits[below] && m->part[below].parent >= 0) push(r, below);
        }
    }
}

enum wf_status wf_beam_groups_make(const struct wf_beam_mesh *m, struct wf_arena *a,
                                   struct wf_beam_groups *out, struct wf_err *e)
{
    const double least = 2; /* elements of a group, on average, from which groups are faster */
    struct wf_arena scratch = { 0 };
    int32_t *depth = WF_TAKE(&scratch, m->n, int32_t), *waits = WF_TAKE(&scratch, m->n, int32_t);
    struct ready r = { .id = WF_TAKE(&scratch, m->n, int32_t), .depth = depth };
    *out = (struct wf_beam_groups){ .group = WF_TAKE(a, m->n, struct wf_beam_group) };
    bool memory = depth && waits && r.id && out->group;
    for (size_t i = 0; i < m->n && memory; i++) {
        int32_t below = m->part[i].parent;
        if (below < 0) continue;
        depth[i] = depth[below] + 1;
        waits[below]++;
    }
    if (memory) fill_groups(m, &r, waits, out);
    if ((double)m->n < least * (double)out->n) out->n = 0;
    wf_arena_free(&scratch);
    return memory ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for groups of %zu beam elements", m->n);
}

const struct wf_groups_kernel *wf_groups_kernel(size_t n)
{
    switch (wf_lanes_kernel(n)->width) {
    case 8:
        return &wf_groups_8;
    case 4:
        return &wf_groups_4;
    default:
        return &wf_groups_1;
    }
}

#endif
