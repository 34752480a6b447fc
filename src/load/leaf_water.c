/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/leaf_water.h"
#include "base/num.h"
#include "load/drop_shape.h"
#include <math.h>
#include <string.h>

const char *const wf_drop_states[WF_DROP_STATES] = { "rest", "run", "hang" };
const char *const wf_water_events[WF_WATER_EVENTS] = { "merged", "hung", "fell", "ran" };

/* ---- Constants ---- */

void wf_water_law_default(struct wf_water_law *w, bool printed)
{
    *w = (struct wf_water_law){ .printed = printed,
                                .angle = WF_PI / 3,
                                .receding = 50 * WF_PI / 180,
                                .advancing = 70 * WF_PI / 180,
                                .friction = 0.1,
                                .adhesion = 5e-5,
                                .hang = 5e-4,
                                .apex = 2e-3,
                                .beta = 0.8,
                                .tail = 8,
                                .tail_step = 0.02,
                                .omega = 0.5,
                                .lambda = 1.05,
                                .zeta = 0.5,
                                .eta = 0.95,
                                .film = 10e-6,
                                .gravity = printed ? 9.8 : 9.81 };
    if (!printed) w->omega = 1; /* the cap's own height */
}

enum wf_status wf_water_law_check(const struct wf_water_law *w, struct wf_err *e)
{
    if (!(w->angle > 0 && w->angle < WF_PI))
        return wf_fail(
            e, WF_EUSAGE,
            "a contact angle lies between 0 and 180 degrees, not at %g: a drop at 0 is a film without "
            "edge, one at 180 touches in a point",
            w->angle * 180 / WF_PI);
    if (!(w->receding > 0 && w->receding <= w->advancing && w->advancing < WF_PI))
        return wf_fail(e, WF_EUSAGE,
                       "the receding contact angle lies above 0 and not above the advancing one");
    if (!(w->friction >= 0) || !(w->adhesion >= 0) || !(w->hang >= 0) || !(w->apex > 0) || !(w->film >= 0))
        return wf_fail(e, WF_EUSAGE, "friction, adhesion, film and what hangs at an edge are 0 or more");
    if (!(w->beta > 0 && w->beta <= 1) || !w->tail || w->tail > WF_TAIL_MOST || !(w->tail_step > 0))
        return wf_fail(e, WF_EUSAGE, "subdrops: beta lies above 0 and up to 1, their number is 1 to %d",
                       WF_TAIL_MOST);
    if (!(w->zeta > 0 && w->zeta <= 1) || !(w->eta > 0 && w->eta <= 1))
        return wf_fail(e, WF_EUSAGE, "zeta and eta of the wet trace lie above 0 and up to 1");
    return WF_OK;
}

/* ---- Building ---- */

enum wf_status wf_leaf_water_make(const struct wf_blade *b, double fold, size_t grid, struct wf_arena *a,
                                  struct wf_leaf_water *out, struct wf_err *e)
{
    if (!grid || grid > 4096)
        return wf_fail(e, WF_EUSAGE, "the grid of a leaf has 1 to 4096 cells a side, not %zu", grid);
    if (!(b->length > 0) || !(b->half > 0))
        return wf_fail(e, WF_EINPUT, "a leaf needs an area: its length is %g m and its half width %g m",
                       b->length, b->half);
    memset(out, 0, sizeof *out);
    out->blade = *b, out->fold = fold, out->grid = grid;
    out->cell[0] = b->length / (double)grid, out->cell[1] = 2 * b->half / (double)grid;
    if (!(out->wet = WF_TAKE(a, grid * grid, float)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a leaf of %zu x %zu cells", grid, grid);
    for (size_t i = 0; i < grid; i++) {
        double w = wf_blade_half(b, ((double)i + 0.5) * out->cell[0]);
        for (size_t j = 0; j < grid; j++) {
            out->wet[i * grid + j] = -INFINITY;
            out->cells += fabs(((double)j + 0.5) * out->cell[1] - b->half) < w;
        }
    }
    return WF_OK;
}

/* ---- One drop ---- */

static void shape(const struct wf_water_law *law, struct wf_leaf_drop *d)
{
    d->radius = law->printed ? cbrt(8 * d->mass / (3 * WF_PI * WF_WATER_DENSITY)) /* V0 = 3 pi r^3/8 */
                             : wf_cap_radius(d->mass, law->angle);
    d->base = wf_cap_base(d->radius, law->angle);
}

double wf_leaf_friction(const struct wf_water_law *law, const struct wf_leaf_drop *d, double press)
{
    double hold =
        law->printed ? law->adhesion : wf_drop_retention(2 * d->base, law->receding, law->advancing);
    return law->friction * d->mass * fmax(0, press) + hold;
}

double wf_leaf_hanging(const struct wf_water_law *law)
{
    return law->printed ? law->hang / law->gravity : wf_drop_hanging(law->apex, law->gravity);
}

double wf_leaf_water_held(const struct wf_leaf_water *w)
{
    double sum = 0;
    for (size_t i = 0; i < w->drops; i++) sum += w->drop[i].mass;
    return sum;
}

void wf_leaf_gravity(const struct wf_leaf_water *w, const struct wf_leaf_lie *lie, double g,
                     const double at[2], double along[2], double *press)
{
    double u = fmin(fmax(at[0] / w->blade.length, 0), 1) * (double)(lie->n - 1);
    size_t i = u >= (double)(lie->n - 1) ? lie->n - 2 : (size_t)u;
    double s = u - (double)i, up[3], side = at[1] > 0 ? 1 : at[1] < 0 ? -1 : 0;
    for (int c = 0; c < 3; c++) up[c] = wf_between(lie->up[i][c], lie->up[i + 1][c], s);
    double c = cos(w->fold), t = sin(w->fold);
    along[0] = -g * up[0];
    along[1] = -g * (c * up[1] + side * t * up[2]);
    *press = g * (c * up[2] - side * t * up[1]);
    if (side == 0 && w->fold > 0) { /* in the vein: a gutter while both halves lean to it */
        double left = c * up[1] + t * up[2], right = c * up[1] - t * up[2];
        along[1] = left > 0 && right < 0 ? 0 : left <= 0 ? -g * left : -g * right;
    }
}

/* ---- The trace ---- */

/* Wet the cells under a drop. Returned: area that was never wet before [m2]. */
static double stamp(struct wf_leaf_water *w, const struct wf_water_law *law, const struct wf_leaf_drop *d,
                    double time)
{
    double fresh = 0, since = -log(law->zeta) * time, fade = log(law->eta), square = d->base * d->base;
    double unit[2] = { 1e-3, 1e-3 }; /* of c in eta^c: millimetres, as printed cells [m] */
    if (law->printed) unit[0] = w->cell[0], unit[1] = w->cell[1];
    double low[2] = { d->at[0] - d->base, d->at[1] - d->base + w->blade.half };
    size_t from[2], to[2];
    for (int k = 0; k < 2; k++) {
        from[k] = (size_t)fmax(0, floor(low[k] / w->cell[k]));
        to[k] = (size_t)fmin((double)w->grid, fmax(0, ceil((low[k] + 2 * d->base) / w->cell[k])));
    }
    for (size_t i = from[0]; i < to[0]; i++) {
        double x = ((double)i + 0.5) * w->cell[0], half = wf_blade_half(&w->blade, x);
        for (size_t j = from[1]; j < to[1]; j++) {
            double y = ((double)j + 0.5) * w->cell[1] - w->blade.half;
            double off[2] = { x - d->at[0], y - d->at[1] };
            if (off[0] * off[0] + off[1] * off[1] > square || fabs(y) >= half) continue;
            off[0] /= unit[0], off[1] /= unit[1];
            float *cell = &w->wet[i * w->grid + j];
            float now = (float)(since + fade * sqrt(off[0] * off[0] + off[1] * off[1]));
            if (!(*cell > -INFINITY)) fresh += w->cell[0] * w->cell[1], w->wetted++;
            if (now > *cell) *cell = now;
        }
    }
    return fresh;
}

double wf_leaf_wetness(const struct wf_leaf_water *w, const struct wf_water_law *law, size_t i, size_t j,
                       double time)
{
    float v = w->wet[i * w->grid + j];
    return v > -INFINITY ? fmin(1, exp(v + log(law->zeta) * time)) : 0;
}

/* ---- Arriving and merging ---- */

static void remove_drop(struct wf_leaf_water *w, size_t i)
{
    memmove(&w->drop[i], &w->drop[i + 1], (--w->drops - i) * sizeof *w->drop);
}

/* Drop j becomes part of drop i; momentum and centre of mass are kept; a hanging drop stays where it hangs.
 */
static void merge(struct wf_leaf_water *w, const struct wf_water_law *law, size_t i, size_t j)
{
    struct wf_leaf_drop *a = &w->drop[i], *b = &w->drop[j];
    double m = a->mass + b->mass;
    const struct wf_leaf_drop *still = a->state == WF_DROP_HANG ? a : b->state == WF_DROP_HANG ? b : NULL;
    struct wf_leaf_drop both = a->mass >= b->mass ? *a : *b;
    for (int c = 0; c < 2; c++) {
        both.v[c] = (a->mass * a->v[c] + b->mass * b->v[c]) / m;
        both.at[c] = still ? still->at[c] : (a->mass * a->at[c] + b->mass * b->at[c]) / m;
    }
    both.mass = m;
    both.edge = still ? still->edge : a->edge && b->edge;
    both.state = still                                                ? WF_DROP_HANG
                 : a->state == WF_DROP_RUN || b->state == WF_DROP_RUN ? WF_DROP_RUN
                                                                      : a->state;
    shape(law, &both);
    *a = both;
    remove_drop(w, j);
    w->count[WF_WATER_MERGED]++;
}

void wf_leaf_water_add(struct wf_leaf_water *w, const struct wf_water_law *law, double mass,
                       const double at[2], const double v[2], double time)
{
    struct wf_leaf_drop d = { .mass = mass,
                              .at = { at[0], at[1] },
                              .v = { v[0], v[1] },
                              .state = WF_DROP_RUN,
                              .stamped = { at[0], at[1] } };
    w->received += mass;
    shape(law, &d);
    stamp(w, law, &d, time);
    if (w->drops == WF_LEAF_DROPS) { /* no room: the nearest takes it */
        size_t near = 0;
        for (size_t i = 1; i < w->drops; i++)
            if (hypot(w->drop[i].at[0] - at[0], w->drop[i].at[1] - at[1]) <
                hypot(w->drop[near].at[0] - at[0], w->drop[near].at[1] - at[1]))
                near = i;
        w->drop[near].mass += mass;
        shape(law, &w->drop[near]);
        w->count[WF_WATER_MERGED]++;
        return;
    }
    w->drop[w->drops++] = d;
}

/* Whether two drops pull each other over the leaf (12): more than the friction of one of them. */
static bool joins(const struct wf_leaf_water *w, const struct wf_water_law *law,
                  const struct wf_leaf_lie *lie, const struct wf_leaf_drop *a, const struct wf_leaf_drop *b)
{
    double x = a->at[0] - b->at[0], y = a->at[1] - b->at[1], reach = a->base + b->base;
    if (x * x + y * y > reach * reach) return false;
    double along[2], press, pull = wf_drop_attraction(sqrt(x * x + y * y), a->base, b->base);
    if (!law->printed) pull *= WF_WATER_TENSION * 2 * fmin(a->base, b->base);
    wf_leaf_gravity(w, lie, law->gravity, a->at, along, &press);
    return pull > fmin(wf_leaf_friction(law, a, press), wf_leaf_friction(law, b, press));
}

static void merge_all(struct wf_leaf_water *w, const struct wf_water_law *law, const struct wf_leaf_lie *lie)
{
    for (size_t i = 0; i < w->drops; i++)
        for (size_t j = i + 1; j < w->drops; j++)
            if (joins(w, law, lie, &w->drop[i], &w->drop[j])) {
                merge(w, law, i, j);
                j = i; /* the larger one may reach others */
            }
}

/* ---- Moving ---- */

/* Onto the edge of the blade, with what of the velocity goes along it. */
static void hold_at_edge(const struct wf_leaf_water *w, struct wf_leaf_drop *d)
{
    double side = d->at[1] < 0 ? -1 : 1, x = fmin(fmax(d->at[0], 1e-6 * w->blade.length), w->blade.length);
    double slope = side * wf_blade_slope(&w->blade, fmin(x, (1 - 1e-6) * w->blade.length));
    double size = sqrt(1 + slope * slope), speed = (d->v[0] + slope * d->v[1]) / size;
    d->edge = true;
    d->at[0] = x;
    d->at[1] = side * wf_blade_half(&w->blade, x);
    d->v[0] = speed / size, d->v[1] = speed * slope / size;
}

/* Gravity of a drop on the edge: what pulls it outwards is held by the edge; inwards it may leave. Returned:
 * false when it does. */
static bool edge_gravity(const struct wf_leaf_water *w, const struct wf_leaf_drop *d, double along[2])
{
    double side = d->at[1] < 0 ? -1 : 1, last = (1 - 1e-6) * w->blade.length;
    if (d->at[0] >= last) { /* the apex holds in every direction outwards */
        if (along[0] < 0) return false;
        along[0] = along[1] = 0;
        return true;
    }
    double slope = side * wf_blade_slope(&w->blade, d->at[0]), size = sqrt(1 + slope * slope);
    double out = side * (along[1] - slope * along[0]) / size, on = (along[0] + slope * along[1]) / size;
    if (out < 0) return false;
    along[0] = on / size, along[1] = on * slope / size;
    return true;
}

/* Newton's law along the leaf; friction and adhesion stand against the motion, or hold a drop at rest (7). */
static void accelerate(const struct wf_water_law *law, struct wf_leaf_drop *d, const double along[2],
                       double press, double dt)
{
    double hold = wf_leaf_friction(law, d, press) / d->mass, pull = hypot(along[0], along[1]);
    double speed = hypot(d->v[0], d->v[1]), next[2];
    if (speed <= 0 && pull <= hold) {
        d->state = d->edge ? WF_DROP_HANG : WF_DROP_REST;
        return;
    }
    const double *way = speed > 0 ? d->v : along;
    double size = speed > 0 ? speed : pull;
    for (int c = 0; c < 2; c++) next[c] = d->v[c] + dt * (along[c] - hold * way[c] / size);
    /* stopped within the step, where gravity alone would not start it again */
    bool turned = next[0] * way[0] + next[1] * way[1] <= 0;
    if (turned && pull <= hold) {
        d->v[0] = d->v[1] = 0;
        d->state = d->edge ? WF_DROP_HANG : WF_DROP_REST;
        return;
    }
    d->state = WF_DROP_RUN;
    for (int c = 0; c < 2; c++) d->v[c] = next[c];
}

/* As printed a drop goes to a cell of the ring r = v dt around it: the one nearest to its new direction. */
static void go(const struct wf_leaf_water *w, const struct wf_water_law *law, struct wf_leaf_drop *d,
               double dt)
{
    double to[2] = { d->at[0] + dt * d->v[0], d->at[1] + dt * d->v[1] };
    if (law->printed) {
        double r = dt * hypot(d->v[0], d->v[1]);
        for (int c = 0; c < 2 && r >= fmin(w->cell[0], w->cell[1]); c++) {
            double first = c ? -w->blade.half : 0;
            to[c] = first + (floor((to[c] - first) / w->cell[c]) + 0.5) * w->cell[c];
        }
    }
    if (!d->edge && w->fold > 0 && d->at[1] * to[1] < 0) to[1] = 0, d->v[1] = 0; /* caught by the vein */
    d->at[0] = to[0], d->at[1] = to[1];
}

static void keep_trail(const struct wf_water_law *law, struct wf_leaf_drop *d, double dt)
{
    size_t had = (size_t)(d->ran / law->tail_step), now = (size_t)((d->ran + dt) / law->tail_step);
    d->ran += dt;
    if (now == had && d->trail) return;
    memmove(d->behind + 1, d->behind, (WF_TAIL_MOST - 1) * sizeof *d->behind);
    memcpy(d->behind[0], d->at, sizeof d->at);
    if (d->trail < law->tail) d->trail++;
}

static void let_fall(struct wf_leaf_water *w, size_t i)
{
    w->fell += w->drop[i].mass;
    w->count[WF_WATER_FELL]++;
    w->fall[w->falls++] = w->drop[i];
    remove_drop(w, i);
}

/* Water that a running drop leaves in a trace it has newly wetted. Returned: false when nothing is left of
 * it. */
static bool leave_film(struct wf_leaf_water *w, const struct wf_water_law *law, struct wf_leaf_drop *d,
                       double time)
{
    /* drawn anew when the drop has gone half a cell: in that time the trace has faded by less than is seen */
    if (fabs(d->at[0] - d->stamped[0]) < w->cell[0] / 2 && fabs(d->at[1] - d->stamped[1]) < w->cell[1] / 2)
        return true;
    double film = stamp(w, law, d, time) * law->film * WF_WATER_DENSITY;
    memcpy(d->stamped, d->at, sizeof d->at);
    if (law->printed || film <= 0) return true;
    film = fmin(film, d->mass);
    d->mass -= film;
    w->film += film;
    if (d->mass <= 0) return false;
    shape(law, d);
    return true;
}

/* Mass of a drop that its edge, or the under side of its leaf, must hold: as heavy as in a leaf at rest. */
static double hung_mass(const struct wf_water_law *law, const struct wf_leaf_lie *lie,
                        const struct wf_leaf_water *w, const struct wf_leaf_drop *d, double press)
{
    if (!d->edge) return press < 0 ? d->mass * -press / law->gravity : 0;
    size_t i = (size_t)(fmin(fmax(d->at[0] / w->blade.length, 0), 1) * (double)(lie->n - 1) + 0.5);
    return d->mass * (lie->pull ? lie->pull[i] : 1);
}

/* Returned: false when the drop is gone. */
static bool move_drop(struct wf_leaf_water *w, const struct wf_water_law *law, const struct wf_leaf_lie *lie,
                      size_t i, double time, double dt)
{
    struct wf_leaf_drop *d = &w->drop[i];
    enum wf_drop_state before = d->state;
    double along[2], press;
    wf_leaf_gravity(w, lie, law->gravity, d->at, along, &press);
    if (d->edge && !edge_gravity(w, d, along)) {
        d->edge = false;
        d->at[1] *= 0.999;
    }
    /* what hangs, at the edge or under a leaf that has turned over, is held up to the limit */
    if (hung_mass(law, lie, w, d, press) > wf_leaf_hanging(law) && w->falls < WF_COUNT(w->fall)) {
        let_fall(w, i);
        return false;
    }
    accelerate(law, d, along, press, dt);
    if (d->state == WF_DROP_HANG && before != WF_DROP_HANG) w->count[WF_WATER_HUNG]++;
    if (d->state != WF_DROP_RUN) {
        d->ran = 0, d->trail = 0;
        return true;
    }
    if (before != WF_DROP_RUN || d->ran == 0) w->count[WF_WATER_RAN]++;
    keep_trail(law, d, dt);
    go(w, law, d, dt);
    if (d->at[0] < 0) d->at[0] = 0, d->v[0] = fmax(0, d->v[0]); /* the petiole */
    if (d->edge || d->at[0] >= w->blade.length || fabs(d->at[1]) >= wf_blade_half(&w->blade, d->at[0]))
        hold_at_edge(w, d);
    if (leave_film(w, law, d, time)) return true;
    remove_drop(w, i);
    return false;
}

void wf_leaf_water_step(struct wf_leaf_water *w, const struct wf_water_law *law,
                        const struct wf_leaf_lie *lie, double time, double dt)
{
    w->falls = 0;
    for (size_t i = 0; i < w->drops;) i += move_drop(w, law, lie, i, time, dt);
    merge_all(w, law, lie);
}

/* ---- What is seen ---- */

size_t wf_leaf_tail(const struct wf_water_law *law, const struct wf_leaf_drop *d, double radius[WF_TAIL_MOST])
{
    size_t n = d->trail < law->tail ? d->trail : law->tail;
    if (d->state != WF_DROP_RUN || n < 2) {
        radius[0] = d->radius;
        return 1;
    }
    radius[0] = wf_tail_first(d->radius, law->beta, n);
    for (size_t i = 1; i < n; i++) radius[i] = law->beta * radius[i - 1];
    return n;
}

/* Height of a cap at a distance from its middle, with the factor omega. */
static double height_of(const struct wf_water_law *law, double r, double off, double omega)
{
    return wf_cap_height(r, law->angle, off, omega, law->printed);
}

double wf_leaf_height(const struct wf_leaf_water *w, const struct wf_water_law *law,
                      const struct wf_leaf_lie *lie, const double at[2])
{
    double most = 0;
    for (size_t i = 0; i < w->drops; i++) {
        const struct wf_leaf_drop *d = &w->drop[i];
        double radius[WF_TAIL_MOST], along[2], press, omega = law->omega;
        size_t n = wf_leaf_tail(law, d, radius);
        for (size_t k = 0; k < n; k++) {
            const double *middle = k ? d->behind[k - 1] : d->at;
            double off = hypot(at[0] - middle[0], at[1] - middle[1]);
            if (off >= radius[k]) continue;
            if (!(law->omega > 0)) { /* lambda^kappa: the drop's normal leans downhill on a tilted leaf */
                wf_leaf_gravity(w, lie, law->gravity, middle, along, &press);
                double side = (along[0] * (at[0] - middle[0]) + along[1] * (at[1] - middle[1])) /
                              (law->gravity * radius[k]);
                omega = wf_cap_omega(law->lambda, sqrt(1 - off * off / (radius[k] * radius[k])) + side);
            }
            most = fmax(most, height_of(law, radius[k], off, omega));
        }
    }
    return most;
}
