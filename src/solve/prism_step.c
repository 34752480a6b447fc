/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/prism_step.h"
#include "base/vec3.h"
#include "solve/prism_blocks.h"
#include "solve/prism_rest.h"
#include <math.h>
#include <string.h>

/* Rounds before the matrix is made again, before a step is halved; how often it is halved. */
enum { ROUNDS_SAME = 12, ROUNDS_MOST = 40, HALVED_MOST = 12 };

struct wf_prism_stepper {
    struct wf_prism_blocks blocks;
    bool ready;                          /* the blocks hold a factor */
    double *next, *force, *right, *body; /* 9 sections; body: weight */
    double h;                            /* step that is being taken: m->step or a part of it [s] */
    double dashed;                       /* energy that dashpots take in the step [J] */
    double factored;                     /* step of the factor [s] */
    double size;                         /* of the system [m] */
};

double wf_prism_euler_limit(double damping, double fastest)
{
    return fastest > 0 ? damping / (fastest * fastest) : INFINITY;
}

/* M v of section s, vertex i, component c. */
static inline double massed(const struct wf_prism *p, const double *v, size_t s, size_t i, size_t c)
{
    const double *m = p->mass + 9 * s + 3 * i;
    return m[0] * v[9 * s + c] + m[1] * v[9 * s + 3 + c] + m[2] * v[9 * s + 6 + c];
}

static double kinetic_of(const struct wf_prism *p, const double *v)
{
    double sum = 0;
    for (size_t k = 0; k < p->unknown; k++)
        for (size_t i = 0, s = (size_t)p->order[k]; i < 3; i++)
            for (size_t c = 0; c < 3; c++) sum += 0.5 * v[9 * s + 3 * i + c] * massed(p, v, s, i, c);
    return sum;
}

static enum wf_status check(const struct wf_prism_motion *m, struct wf_arena *a, struct wf_err *e)
{
    double omega;
    if (!(m->step > 0) || !isfinite(m->step)) return wf_fail(e, WF_EUSAGE, "prisms: a step must be positive");
    if (!(m->damping >= 0)) return wf_fail(e, WF_EUSAGE, "prisms: damping must be 0 or more");
    if (!(m->internal >= 0)) return wf_fail(e, WF_EUSAGE, "prisms: internal damping must be 0 or more");
    if (m->method != WF_PRISM_EULER) return WF_OK;
    if (m->internal > 0) return wf_fail(e, WF_EUSAGE, "prisms: explicit Euler has no internal damping");
    enum wf_status s = wf_prism_fastest(m->p, m->x, a, &omega, e);
    double limit = s ? 0 : wf_prism_euler_limit(m->damping, omega);
    if (s || m->step <= limit) return s;
    if (!(m->damping > 0))
        return wf_fail(e, WF_EUSAGE,
                       "explicit Euler has no stable step without damping: every oscillation grows; give "
                       "damping, or take the implicit midpoint step");
    return wf_fail(
        e, WF_EUSAGE,
        "explicit Euler with a step of %.3g s is unstable: with the highest frequency %.4g rad/s "
        "and its damping ratio %.3g the limit is 2 zeta/omega = %.3g s (%.3g steps a second); take "
        "a shorter step, more damping, or the implicit midpoint step",
        m->step, omega, m->damping / (2 * omega), limit, 1 / limit);
}

enum wf_status wf_prism_begin(struct wf_prism_motion *m, const double *x, struct wf_arena *a,
                              struct wf_err *e)
{
    size_t n = 9 * m->p->sections;
    struct wf_prism_stepper *o = m->of = WF_TAKE(a, 1, struct wf_prism_stepper);
    m->x = WF_TAKE(a, n, double), m->v = WF_TAKE(a, n, double), m->load = WF_TAKE(a, n, double);
    if (!o || !m->x || !m->v || !m->load) return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    o->next = WF_TAKE(a, n, double), o->force = WF_TAKE(a, n, double);
    o->right = WF_TAKE(a, n, double), o->body = WF_TAKE(a, n, double);
    if (!o->next || !o->force || !o->right || !o->body)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the prisms");
    memcpy(m->x, x ? x : m->p->rest, n * sizeof *m->x);
    wf_prism_follow(m->p, m->x);
    enum wf_status s = check(m, a, e);
    if (s || (s = wf_prism_blocks_make(m->p, a, &o->blocks, e))) return s;
    for (size_t i = 0; i < n; i++) o->size = fmax(o->size, fabs(m->x[i] - m->x[i % 3]));
    wf_prism_weight(m->p, m->gravity, o->body);
    m->spring = wf_prism_forces(m->p, m->x, o->force, NULL);
    if (!(m->tolerance > 0)) m->tolerance = 1e-13;
    m->work = (struct wf_prism_work){ 0 };
    m->time = m->kinetic = 0;
    m->steps = m->iterations = m->factors = 0;
    return WF_OK;
}

/* Forces of the springs between two places that do exactly the work of the change of energy (discrete
 * gradient: Gonzalez 1996, J. Nonlinear Sci. 6:449-467): along the sum of both chords, by the mean stretch.
 */
static double mean_forces(const struct wf_prism *p, const double *x, const double *y, double dash, double *f)
{
    double loss = 0;
    for (size_t i = 0; i < p->springs; i++) {
        const struct wf_prism_spring *s = &p->spring[i];
        const double *xa = x + 3 * s->a, *ya = y + 3 * s->a;
        if (s->b < 0) {
            const double *rest = p->rest + 3 * s->a;
            for (int c = 0; c < 3; c++) f[3 * s->a + c] += s->k * (rest[c] - 0.5 * (xa[c] + ya[c]));
            continue;
        }
        const double *xb = x + 3 * s->b, *yb = y + 3 * s->b;
        double d[3] = { xb[0] - xa[0], xb[1] - xa[1], xb[2] - xa[2] };
        double g[3] = { yb[0] - ya[0], yb[1] - ya[1], yb[2] - ya[2] };
        double was = sqrt(wf_dot(d, d)), is = sqrt(wf_dot(g, g)), sum = was + is, more = is - was;
        double pull = s->k * (0.5 * sum - s->rest + dash * more) / sum;
        loss += dash * s->k * more * more;
        for (int c = 0; c < 3; c++) {
            double t = pull * (d[c] + g[c]);
            f[3 * s->a + c] += t, f[3 * s->b + c] -= t;
        }
    }
    wf_prism_pass(p, f);
    return loss;
}

/* Residual of the midpoint equations at o->next, in the order of elimination in o->right. */
static void residual(struct wf_prism_motion *m)
{
    struct wf_prism_stepper *o = m->of;
    const struct wf_prism *p = m->p;
    size_t n = 9 * p->sections;
    double h = o->h;
    for (size_t i = 0; i < n; i++) o->force[i] = o->body[i] + m->load[i];
    o->dashed = mean_forces(p, m->x, o->next, m->internal / h, o->force);
    for (size_t k = 0; k < p->unknown; k++) {
        size_t s = (size_t)p->order[k];
        double want[9]; /* change of velocity over the step and what damping takes, per time */
        for (size_t i = 0; i < 9; i++) {
            double mean = (o->next[9 * s + i] - m->x[9 * s + i]) / h;
            want[i] = 2 * (mean - m->v[9 * s + i]) / h + m->damping * mean;
        }
        const double *M = p->mass + 9 * s;
        for (size_t i = 0; i < 3; i++)
            for (size_t c = 0; c < 3; c++)
                o->right[9 * k + 3 * i + c] =
                    o->force[9 * s + 3 * i + c] -
                    (M[3 * i] * want[c] + M[3 * i + 1] * want[3 + c] + M[3 * i + 2] * want[6 + c]);
    }
}

static bool factor(struct wf_prism_motion *m)
{
    struct wf_prism_stepper *o = m->of;
    m->factors++;
    o->factored = o->h;
    wf_prism_blocks_fill(m->p, m->x, o->next, 2 / (o->h * o->h) + m->damping / o->h, 0.5, m->internal / o->h,
                         false, &o->blocks);
    return o->ready = wf_prism_blocks_factor(&o->blocks);
}

/* Solve the midpoint equations; o->next holds the answer. */
static bool solve_step(struct wf_prism_motion *m)
{
    struct wf_prism_stepper *o = m->of;
    const struct wf_prism *p = m->p;
    double last = INFINITY;
    for (int round = 0, same = 0; round < ROUNDS_MOST; round++, same++) {
        double longest = 0;
        if ((!o->ready || o->factored != o->h || same > ROUNDS_SAME) && (same = 0, !factor(m))) return false;
        residual(m);
        wf_prism_blocks_solve(&o->blocks, o->right);
        for (size_t k = 0; k < p->unknown; k++)
            for (size_t i = 0; i < 9; i++) {
                o->next[9 * (size_t)p->order[k] + i] += o->right[9 * k + i];
                longest = fmax(longest, fabs(o->right[9 * k + i]));
            }
        wf_prism_follow(p, o->next);
        m->iterations++;
        if (!isfinite(longest)) return false;
        if (longest <= m->tolerance * o->size || (longest <= 1e-11 * o->size && longest >= 0.5 * last))
            return true;
        if (longest > 0.3 * last && same > 2) o->ready = false;
        last = longest;
    }
    return false;
}

/* Book the work of a step from m->x to o->next with the mean velocity. */
static void book(struct wf_prism_motion *m, double kinetic, double spring)
{
    struct wf_prism_stepper *o = m->of;
    const struct wf_prism *p = m->p;
    double weight = 0, load = 0, loss = 0;
    for (size_t k = 0; k < p->unknown; k++) {
        size_t s = (size_t)p->order[k];
        double mean[9];
        for (size_t i = 0; i < 9; i++) {
            double d = o->next[9 * s + i] - m->x[9 * s + i];
            weight += o->body[9 * s + i] * d;
            load += m->load[9 * s + i] * d;
            mean[i] = d / o->h;
        }
        const double *M = p->mass + 9 * s;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int c = 0; c < 3; c++) loss += M[3 * i + j] * mean[3 * i + c] * mean[3 * j + c];
    }
    loss = loss * m->damping * o->h + o->dashed;
    m->work.weight += weight, m->work.load += load, m->work.damping += loss;
    m->work.solver += kinetic - m->kinetic + spring - m->spring - weight - load + loss;
    m->kinetic = kinetic, m->spring = spring;
}

/* A step of o->h; where its equations find no answer, two of half the length, and so on. */
static enum wf_status midpoint(struct wf_prism_motion *m, int halved, struct wf_err *e)
{
    struct wf_prism_stepper *o = m->of;
    const struct wf_prism *p = m->p;
    size_t n = 9 * p->sections;
    double h = o->h;
    memcpy(o->next, m->x, n * sizeof *o->next); /* places carried on by v would stretch what turns */
    if (!solve_step(m)) {
        if (halved == HALVED_MOST)
            return wf_fail(e, WF_ENOCONV, "prisms: the step at %.6g s found no answer", m->time);
        enum wf_status s = WF_OK;
        for (int k = 0; k < 2 && !s; k++) o->ready = false, o->h = 0.5 * h, s = midpoint(m, halved + 1, e);
        o->h = h;
        return s;
    }
    for (size_t k = 0; k < p->unknown; k++)
        for (size_t i = 9 * (size_t)p->order[k]; i < 9 * (size_t)p->order[k] + 9; i++)
            m->v[i] = 2 * (o->next[i] - m->x[i]) / h - m->v[i];
    wf_prism_follow(p, m->v);
    memset(o->force, 0, n * sizeof *o->force);
    o->dashed = mean_forces(p, m->x, o->next, m->internal / h, o->force);
    memset(o->force, 0, n * sizeof *o->force);
    double spring = wf_prism_forces(p, o->next, o->force, NULL);
    book(m, kinetic_of(p, m->v), spring);
    memcpy(m->x, o->next, n * sizeof *m->x);
    return WF_OK;
}

static enum wf_status euler(struct wf_prism_motion *m, struct wf_err *e)
{
    struct wf_prism_stepper *o = m->of;
    const struct wf_prism *p = m->p;
    size_t n = 9 * p->sections;
    double h = m->step;
    for (size_t i = 0; i < n; i++) o->force[i] = o->body[i] + m->load[i];
    o->dashed = 0;
    wf_prism_forces(p, m->x, o->force, NULL);
    memcpy(o->next, m->x, n * sizeof *m->x);
    for (size_t k = 0; k < p->unknown; k++) {
        size_t s = (size_t)p->order[k];
        const double *W = p->inverse + 9 * s, *f = o->force + 9 * s;
        for (size_t i = 0; i < 3; i++)
            for (size_t c = 0; c < 3; c++) {
                size_t at = 9 * s + 3 * i + c;
                double speed = m->v[at];
                o->next[at] += h * speed;
                m->v[at] += h * (W[3 * i] * f[c] + W[3 * i + 1] * f[3 + c] + W[3 * i + 2] * f[6 + c] -
                                 m->damping * speed);
            }
    }
    wf_prism_follow(p, o->next);
    wf_prism_follow(p, m->v);
    memset(o->force, 0, n * sizeof *o->force);
    double spring = wf_prism_forces(p, o->next, o->force, NULL), kinetic = kinetic_of(p, m->v);
    if (!isfinite(spring + kinetic))
        return wf_fail(e, WF_ENOCONV, "prisms: explicit Euler grew without bound at %.6g s", m->time);
    book(m, kinetic, spring);
    memcpy(m->x, o->next, n * sizeof *m->x);
    return WF_OK;
}

enum wf_status wf_prism_advance(struct wf_prism_motion *m, struct wf_err *e)
{
    m->of->h = m->step;
    enum wf_status s = m->method == WF_PRISM_EULER ? euler(m, e) : midpoint(m, 0, e);
    m->steps++;
    m->time += m->step;
    return s;
}

/* ---- Points ---- */

void wf_prism_at(const struct wf_prism_point *q, const double *x, double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (size_t i = 0; i < q->n; i++) v3_add(out, q->share[i], x + 3 * q->vertex[i]);
}

void wf_prism_put(const struct wf_prism_point *q, const double force[3], double *f)
{
    for (size_t i = 0; i < q->n; i++) v3_add(f + 3 * q->vertex[i], q->share[i], force);
}

/* Shares of unknown vertices: those on bonded ones passed on. */
static size_t spread(const struct wf_prism *p, const struct wf_prism_point *q, int32_t vertex[24],
                     double share[24])
{
    size_t n = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t v = q->vertex[i];
        bool bonded = p->bonded[v / 3];
        for (int k = 0; k < (bonded ? 4 : 1); k++) {
            int32_t on = bonded ? p->bond[v].on[k] : v;
            if (p->free[on / 3] < 0) continue;
            vertex[n] = on;
            share[n++] = q->share[i] * (bonded ? p->bond[v].share[k] : 1);
        }
    }
    return n;
}

double wf_prism_yield(const struct wf_prism *p, const struct wf_prism_point *q)
{
    int32_t vertex[24];
    double share[24], sum = 0;
    size_t n = spread(p, q, vertex, share);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            if (vertex[i] / 3 == vertex[j] / 3)
                sum += share[i] * share[j] *
                       p->inverse[9 * (vertex[i] / 3) + 3 * (vertex[i] % 3) + vertex[j] % 3];
    return sum;
}

double wf_prism_push(struct wf_prism_motion *m, const struct wf_prism_point *q, const double impulse[3])
{
    const struct wf_prism *p = m->p;
    int32_t vertex[24];
    double share[24];
    size_t n = spread(p, q, vertex, share);
    for (size_t i = 0; i < n; i++)
        for (int32_t j = 0; j < 3; j++) {
            int32_t s = vertex[i] / 3;
            v3_add(m->v + 9 * s + 3 * j, share[i] * p->inverse[9 * s + 3 * j + vertex[i] % 3], impulse);
        }
    wf_prism_follow(p, m->v);
    double kinetic = kinetic_of(p, m->v), gain = kinetic - m->kinetic;
    m->kinetic = kinetic;
    m->work.push += gain;
    return gain;
}
