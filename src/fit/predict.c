/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/predict.h"
#include "base/num.h"
#include "base/random.h"
#include "base/vec3.h"
#include "data/species.h"
#include "fit/free_sway.h"
#include "fit/plant.h"
#include "fit/sensor.h"
#include "solve/beam_settle.h"
#include "solve/beam_small.h"
#include <math.h>
#include <string.h>

enum wf_status wf_predictor_open(const struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                                 struct wf_arena *a, struct wf_predictor **out, struct wf_err *e)
{
    struct wf_predictor *w = WF_TAKE(a, 1, struct wf_predictor);
    size_t states = 0, at = 0;
    for (size_t k = 0; k < x->tests; k++) states += x->test[k].states + 1;
    if (!w || !(w->tree = WF_TAKE(a, x->trees, struct wf_tree)) ||
        !(w->sway = WF_TAKE(a, x->tests, struct wf_sway_found)) ||
        !(w->warm = WF_TAKE(a, states, struct wf_warm)) || !(w->first_state = WF_TAKE(a, x->tests, size_t)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the predictions");
    w->x = x, w->p = p, w->params = n;
    for (size_t k = 0; k < x->trees; k++) {
        struct wf_tree *t = &w->tree[k];
        *t = x->tree[k].tree;
        double **column[] = { &t->youngs, &t->shear, &t->density, &t->r0,    &t->r1,
                              &t->i0,     &t->i1,    &t->drag,    &t->sail0, &t->sail1 };
        for (size_t c = 0; c < WF_COUNT(column); c++)
            if (!(*column[c] = WF_TAKE(a, t->n, double)))
                return wf_fail(e, WF_ENOMEM, "not enough memory for a tree");
    }
    for (size_t k = 0; k < x->tests; k++) {
        size_t rows = x->tree[x->test[k].tree].tree.n;
        w->first_state[k] = at;
        if (x->test[k].sensors > w->most_sensors) w->most_sensors = x->test[k].sensors;
        for (size_t i = 0; i <= x->test[k].states; i++, at++) {
            w->warm[at].shape = WF_TAKE(a, rows, struct wf_beam_shape);
            w->warm[at].tilt = wf_arena_take(a, rows, sizeof *w->warm[at].tilt);
            if (!w->warm[at].shape || !w->warm[at].tilt)
                return wf_fail(e, WF_ENOMEM, "not enough memory for the shapes");
        }
    }
    size_t m = w->most_sensors;
    w->rest = WF_TAKE(a, m, double), w->other = WF_TAKE(a, m, double);
    if (!(w->solved = WF_TAKE(a, n, double)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for the parameters");
    for (size_t k = 0; k < n; k++) w->solved[k] = NAN;
    w->rest_slope = WF_TAKE(a, m * n, double), w->other_slope = WF_TAKE(a, m * n, double);
    w->told = WF_TAKE(a, x->data, double), w->told_slope = WF_TAKE(a, x->data * n, double);
    if (!w->rest || !w->other || !w->rest_slope || !w->other_slope || !w->told || !w->told_slope)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the readings");
    *out = w;
    return WF_OK;
}

void wf_predictor_close(struct wf_predictor *w) { wf_arena_free(&w->scratch); }

/* One test while its states are solved. */
struct bench {
    struct wf_predictor *w;
    const struct wf_fit_test *test;
    struct wf_beam beam;
    struct wf_beam_small *small; /* kept here while the beam is being solved */
    struct wf_point_load pull;
    struct wf_wind wind;
    double force;                    /* in the rope [N]                                   */
    double frame;                    /* azimuth of measured coordinates                   */
    const struct wf_fit_state *now;  /* the current state; NULL: at rest                  */
    wf_four (*ends)[6], (*moved)[6]; /* motions of the ends */
    wf_four (*node)[6], (*root)[3];  /* wrenches on ends and root plates */
    double (*one)[6];                /* one side of `ends` */
    struct wf_disturber *disturber;  /* per parameter */
};

/* A sensor with its row and azimuth in the current state. */
static struct wf_fit_sensor placed(const struct bench *k, size_t s)
{
    struct wf_fit_sensor sensor = k->test->sensor[s];
    if (k->test->load == WF_FIT_WEIGHT && k->now->row >= -1) sensor.row = k->now->row;
    if (wf_sensor_framed(&sensor)) sensor.azimuth += k->frame;
    return sensor;
}

/* Set the rope's force in its present direction. Returned: its free length [m]. */
static double aim(struct bench *k, const double at[3], double u[3])
{
    const struct wf_fit_test *t = k->test;
    double length = INFINITY;
    if (t->anchored) {
        for (int i = 0; i < 3; i++) u[i] = t->anchor[i] - at[i];
        length = sqrt(wf_dot(u, u));
        for (int i = 0; i < 3; i++) u[i] /= length;
    } else {
        u[0] = cos(t->azimuth) * cos(t->elevation);
        u[1] = sin(t->azimuth) * cos(t->elevation);
        u[2] = sin(t->elevation);
    }
    for (int i = 0; i < 3; i++) k->pull.force[i] = k->force * u[i];
    return length;
}

/* Solve. near: the shape solves the same state for other parameters, so Newton's method is tried first. */
static enum wf_status settle(struct bench *k, bool near, struct wf_err *e)
{
    struct wf_beam_outcome outcome;
    struct wf_beam *b = &k->beam;
    b->small = NULL;
    b->frozen = false;
    for (int pass = 0;; pass++) {
        /* the shape of a standing tree is an equilibrium of any wood: the last one may no longer be stable */
        bool found = (near || pass) && !wf_beam_newton(b) && (!b->mesh.standing || wf_beam_stable(b));
        if (!found) {
            enum wf_status status = wf_beam_settle(b, &k->w->scratch, &outcome, e);
            if (status) return status;
        }
        if (k->test->load != WF_FIT_PULL || !k->test->anchored || k->force == 0) return WF_OK;
        double before[3], u[3], change = 0;
        memcpy(before, k->pull.force, sizeof before);
        aim(k, b->pose[b->mesh.last[k->test->pull_row]].r, u);
        for (int i = 0; i < 3; i++) change = fmax(change, fabs(k->pull.force[i] - before[i]));
        if (change <= 1e-11 * fabs(k->force)) return WF_OK;
        if (pass > 60)
            return wf_fail(e, WF_ENOCONV, "the direction of the rope of test %s did not converge",
                           k->test->name);
    }
}

static enum wf_status linearise(struct bench *k, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    if (!k->small) {
        enum wf_status status = wf_beam_linearise(b, false, &k->w->scratch, e);
        k->small = b->small;
        return status;
    }
    b->small = k->small;
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    if (wf_beam_sweep_down(b, true, NULL)) return WF_OK;
    return wf_fail(e, WF_EUNSTABLE, "the tree has no stiffness left");
}

/* Change of the rope's force because its direction follows the strap, including the motion of the strap by
 * that change. Given: flexibility C of the strap, stiffness K of the rope, motion of the strap at constant
 * force. Returned: change of force. */
static void follow(const double C[9], const double K[9], const double moved[3], double force[3])
{
    double A[3][4];
    for (int i = 0; i < 3; i++) { /* (I - K C) df = K moved */
        for (int j = 0; j < 3; j++) {
            A[i][j] = i == j;
            for (int m = 0; m < 3; m++) A[i][j] -= K[3 * i + m] * C[3 * m + j];
        }
        A[i][3] = K[3 * i] * moved[0] + K[3 * i + 1] * moved[1] + K[3 * i + 2] * moved[2];
    }
    for (int c = 0; c < 3; c++) { /* near the unit matrix: the rope is much longer than the motion */
        int best = c;
        for (int r = c + 1; r < 3; r++)
            if (fabs(A[r][c]) > fabs(A[best][c])) best = r;
        for (int j = 0; j < 4; j++) {
            double hold = A[c][j];
            A[c][j] = A[best][j], A[best][j] = hold;
        }
        for (int r = 0; r < 3; r++)
            for (int j = 3; r != c && j >= c; j--) A[r][j] -= A[r][c] / A[c][c] * A[c][j];
    }
    for (int i = 0; i < 3; i++) force[i] = A[i][3] / A[i][i];
}

/* Response to forces on the strap, one a side. */
static void push_answer(struct bench *k, wf_four force[3], struct wf_beam_small_answer *x)
{
    size_t at = (size_t)k->beam.mesh.last[k->test->pull_row];
    memcpy(k->node[at], force, 3 * sizeof *force);
    *x = (struct wf_beam_small_answer){ .ends = k->moved };
    wf_beam_answer_small(&k->beam, NULL, NULL, (const wf_four(*)[6])k->node, NULL, x);
    memset(k->node[at], 0, sizeof k->node[at]);
}

/* Stiffness of the rope's direction, K = dF/dx = -F/length (1 - u u'), and the strap's flexibility C. */
static bool rope(struct bench *k, double C[9], double K[9])
{
    const struct wf_fit_test *t = k->test;
    double u[3];
    wf_four unit[3] = { { 1 }, { 0, 1 }, { 0, 0, 1 } };
    if (t->load != WF_FIT_PULL || !t->anchored || k->force == 0) return false;
    size_t at = (size_t)k->beam.mesh.last[t->pull_row];
    double length = aim(k, k->beam.pose[at].r, u);
    struct wf_beam_small_answer x;
    push_answer(k, unit, &x);
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++) {
            C[3 * i + j] = k->moved[at][i][j];
            K[3 * i + j] = -k->force / length * ((i == j) - u[i] * u[j]);
        }
    return true;
}

/* Derivatives of the horizontal coordinates by the azimuth that they are measured at. */
static void frame_slopes(struct bench *k, size_t p, double *slope)
{
    const struct wf_fit_param *q = &k->w->p[p];
    if (q->quantity != WF_FIT_FRAME || (q->tree >= 0 && (size_t)q->tree != k->test->tree)) return;
    for (size_t s = 0; s < k->test->sensors; s++) {
        struct wf_fit_sensor sensor = placed(k, s);
        slope[s * k->w->params + p] = wf_sensor_by_azimuth(&sensor, &k->beam);
    }
}

/* Add the motion that follows from the change of the rope's direction in the motions *x. */
static void add_rope(struct bench *k, const double C[9], const double K[9], struct wf_beam_small_answer *x)
{
    const struct wf_beam *b = &k->beam;
    size_t at = (size_t)b->mesh.last[k->test->pull_row];
    wf_four force[3], spin[6];
    struct wf_beam_small_answer more;
    memcpy(spin, b->root_moved[0], sizeof spin);
    for (int side = 0; side < WF_BEAM_SIDES; side++) {
        double moved[3], direct[3];
        for (int i = 0; i < 3; i++) moved[i] = x->ends[at][i][side];
        follow(C, K, moved, direct);
        for (int i = 0; i < 3; i++) force[i][side] = direct[i];
    }
    push_answer(k, force, &more);
    for (int c = 0; c < 6; c++) {
        for (size_t i = 0; i < b->mesh.n; i++) x->ends[i][c] += k->moved[i][c];
        x->ground[c] += more.ground[c], b->root_moved[0][c] += spin[c];
    }
}

/* Derivatives of the readings by parameter p, the given side of the motions *x. */
static void read_slopes(struct bench *k, const struct wf_beam_small_answer *x, size_t side, size_t p,
                        double *slope)
{
    struct wf_beam *b = &k->beam;
    const struct wf_fit_param *q = &k->w->p[p];
    size_t levels = k->w->x->tree[k->test->tree].species->levels;
    double ground[6];
    for (size_t c = 0; c < 6; c++) {
        ground[c] = x->ground[c][side], b->root_change[0][c] = b->root_moved[0][c][side];
        for (size_t i = 0; i < b->mesh.n; i++) k->one[i][c] = x->ends[i][c][side];
    }
    for (size_t s = 0; s < k->test->sensors; s++) {
        struct wf_fit_sensor sensor = placed(k, s);
        double *to = &slope[s * k->w->params + p];
        *to = wf_sensor_change(&sensor, b, (const double(*)[6])k->one, ground);
        if (q->quantity == WF_FIT_RADIUS) *to += wf_sensor_by_radius(&sensor, b, q->level, levels);
    }
}

/* Moment on a root plate that its springs do not hold because the state at rest changed by `still`: the plate
 * takes it in the axes of its tilt. */
static void add_still_moment(const double tilt[3], const double still[3], size_t side, wf_four moment[3])
{
    double x = wf_dot(tilt, tilt), inverse[9], m[3];
    struct rotation o = rotation_of(x);
    rotation_tangent_inverse(&o, tilt, x, inverse);
    m3_apply_transposed(inverse, still, m);
    for (int c = 0; c < 3; c++) moment[c][side] -= m[c];
}

/* Moments on the root plates of the test's tree: by a unit change of their stiffness, by the change of the
 * state at rest. */
static void root_moments(struct bench *k, const struct wf_disturber *x, size_t side)
{
    const struct wf_beam *b = &k->beam;
    bool root = x->param->quantity == WF_FIT_ROOT;
    for (size_t i = 0; i < b->mesh.tree->n; i++) {
        if (b->mesh.tree->parent[i] >= 0) continue;
        for (int c = 0; c < 3; c++)
            k->root[i][c][side] = root && c < 2 ? -b->options->root_stiffness[c] * b->tilt[i][c] : 0;
        if (x->rest_root) add_still_moment(b->tilt[i], x->rest_root[i], side, k->root[i]);
    }
}

/* What each parameter disturbs in the test's tree. */
static enum wf_status set_disturbers(struct bench *k, const double *internal, struct wf_err *e)
{
    const struct wf_predictor *w = k->w;
    enum wf_status s = WF_OK;
    k->disturber = WF_TAKE(&k->w->scratch, w->params, struct wf_disturber);
    if (!k->disturber) return wf_fail(e, WF_ENOMEM, "not enough memory for a solution");
    for (size_t p = 0; p < w->params && !s; p++) {
        k->disturber[p] = (struct wf_disturber){ .tree = &w->x->tree[k->test->tree],
                                                 .param = &w->p[p],
                                                 .internal = internal[p] };
        if (wf_disturbs(&w->p[p], k->test->tree))
            s = wf_disturb_rest(&k->disturber[p], &k->beam, &k->w->scratch, e);
    }
    return s;
}

static void slopes(struct bench *k, double *slope)
{
    const struct wf_predictor *w = k->w;
    double C[9], K[9];
    bool roped = rope(k, C, K);
    for (size_t p = 0; p < w->params;) {
        struct wf_disturbers d = { .count = 0 };
        struct wf_beam_small_answer x = { .ends = k->ends };
        size_t param[WF_BEAM_SIDES];
        for (; p < w->params && d.count < WF_BEAM_SIDES; p++) {
            frame_slopes(k, p, slope);
            if (!wf_disturbs(&w->p[p], k->test->tree)) continue;
            root_moments(k, &k->disturber[p], d.count);
            param[d.count] = p;
            d.side[d.count++] = k->disturber[p];
        }
        if (!d.count) break;
        wf_beam_answer_small(&k->beam, wf_disturb, &d, NULL, (const wf_four(*)[3])k->root, &x);
        if (roped) add_rope(k, C, K, &x);
        for (size_t side = 0; side < d.count; side++) read_slopes(k, &x, side, param[side], slope);
    }
}

/* Solve the state of the present loads, starting from its last solution. */
static enum wf_status state(struct bench *k, size_t warm, double *reading, double *slope, struct wf_err *e)
{
    struct wf_beam *b = &k->beam;
    struct wf_warm *last = &k->w->warm[warm];
    size_t n = b->mesh.n;
    if (last->known) {
        memcpy(b->shape, last->shape, n * sizeof *b->shape);
        memcpy(b->tilt, last->tilt, n * sizeof *b->tilt);
    }
    bool done = last->known && k->w->same;
    if (done) memcpy(k->pull.force, last->pull, sizeof last->pull);
    if (done && slope) {
        enum wf_status status = linearise(k, e);
        if (status) return status;
    } else if (done) {
        wf_beam_sweep_up(b);
        (void)wf_beam_sweep_down(b, false, NULL);
    } else {
        enum wf_status status = settle(k, last->known, e);
        if (status) return status;
        if (slope && (status = linearise(k, e))) return status;
    }
    memcpy(last->pull, k->pull.force, sizeof last->pull);
    memcpy(last->shape, b->shape, n * sizeof *b->shape);
    memcpy(last->tilt, b->tilt, n * sizeof *b->tilt);
    last->known = true;
    for (size_t s = 0; s < k->test->sensors; s++) {
        struct wf_fit_sensor sensor = placed(k, s);
        reading[s] = wf_sensor_read(&sensor, b);
    }
    if (!slope) return WF_OK;
    memset(slope, 0, k->test->sensors * k->w->params * sizeof *slope);
    slopes(k, slope);
    return WF_OK;
}

/* Set a test's wind and air. */
static void blow(const struct wf_fit_test *t, struct wf_loads *loads, const struct wf_wind *wind)
{
    loads->wind = wind;
    if (t->air_density > 0) loads->air_density = t->air_density;
    if (t->air_viscosity > 0) loads->air_viscosity = t->air_viscosity;
}

/* Wind at the tree in a state of a test, at the reference height [m/s]. */
static double wind_met(const struct wf_fit_test *t, size_t state)
{
    return t->speed_up > 0 ? t->speed_up * t->state[state].load : t->state[state].load;
}

static enum wf_status static_test(struct wf_predictor *w, size_t index, const double *internal,
                                  double *reading, double *slope, size_t *at, struct wf_err *e)
{
    const struct wf_fit_test *t = &w->x->test[index];
    struct wf_tree *tree = &w->tree[t->tree];
    struct wf_loads loads;
    struct wf_solve_options options;
    wf_param_apply(w->x, w->p, w->params, internal, t->tree, tree, &loads, &options);
    struct bench k = { .w = w, .test = t, .wind = t->wind, .pull = { .segment = t->pull_row } };
    for (size_t p = 0; p < w->params; p++)
        if (w->p[p].quantity == WF_FIT_FRAME && (w->p[p].tree < 0 || (size_t)w->p[p].tree == t->tree))
            k.frame = wf_param_value(&w->p[p], internal[p]);
    if (t->load == WF_FIT_WIND) blow(t, &loads, &k.wind);
    if (t->load == WF_FIT_PULL) loads.point = &k.pull, loads.points = 1;
    enum wf_status status = wf_beam_init(&k.beam, tree, &loads, &options, NULL, &w->scratch, &w->scratch, e);
    size_t n = tree->n, m = w->params;
    k.ends = wf_arena_take(&w->scratch, n, sizeof *k.ends),
    k.moved = wf_arena_take(&w->scratch, n, sizeof *k.ends);
    k.node = wf_arena_take(&w->scratch, n, sizeof *k.node),
    k.root = wf_arena_take(&w->scratch, n, sizeof *k.root);
    if (status) return status;
    k.one = wf_arena_take(&w->scratch, n, sizeof *k.one);
    if (!k.ends || !k.moved || !k.node || !k.root || !k.one)
        return wf_fail(e, WF_ENOMEM, "not enough memory for a solution");
    if (slope && (status = set_disturbers(&k, internal, e))) return status;
    bool rest = t->from_rest && loads.gravity > 0;
    memset(w->rest, 0, t->sensors * sizeof *w->rest);
    memset(w->rest_slope, 0, t->sensors * m * sizeof *w->rest_slope);
    k.wind.speed = 0;
    if (rest) status = state(&k, w->first_state[index] + t->states, w->rest, slope ? w->rest_slope : NULL, e);
    for (size_t i = 0; i < t->states && !status; i++) {
        double u[3];
        k.now = &t->state[i];
        k.force = t->load == WF_FIT_PULL ? t->state[i].load : 0;
        k.wind.speed = t->load == WF_FIT_WIND ? wind_met(t, i) : 0;
        if (t->load == WF_FIT_PULL) aim(&k, k.beam.pose[t->pull_row].r, u);
        status = state(&k, w->first_state[index] + i, w->other, slope ? w->other_slope : NULL, e);
        for (; !status && *at < w->x->data && w->x->datum[*at].test == index && w->x->datum[*at].state == i;
             ++*at) {
            size_t s = w->x->datum[*at].sensor;
            reading[*at] = w->other[s] - w->rest[s];
            for (size_t p = 0; slope && p < m; p++)
                slope[*at * m + p] = w->other_slope[s * m + p] - w->rest_slope[s * m + p];
        }
        if (status && e) {
            const struct wf_err why = *e;
            *e = (struct wf_err){ 0 };
            if (t->load != WF_FIT_PULL && t->load != WF_FIT_WIND)
                return wf_fail(e, status, "test %s: %.700s", t->name, why.text);
            bool pull = t->load == WF_FIT_PULL;
            return wf_fail(e, status, "test %s, %s %.4g %s: %.700s", t->name, pull ? "pull" : "wind",
                           t->state[i].load, pull ? "N" : "m/s", why.text);
        }
    }
    return status;
}

/* Add the sensors' offsets and drifts to the predicted readings. */
static void nuisance(const struct wf_predictor *w, const double *internal, double *reading, double *slope)
{
    for (size_t p = 0; p < w->params; p++) {
        const struct wf_fit_param *q = &w->p[p];
        if (!wf_param_nuisance(q)) continue;
        for (size_t i = 0; i < w->x->data; i++) {
            const struct wf_fit_datum *d = &w->x->datum[i];
            if (d->test != q->test || d->sensor != q->sensor) continue;
            double by =
                q->unit * (q->quantity == WF_FIT_DRIFT ? w->x->test[d->test].state[d->state].time : 1);
            reading[i] += by * internal[p];
            if (slope) slope[i * w->params + p] = by;
        }
    }
}

/* Do all parameters equal those of the last prediction? nuisance: compare offsets and drifts as well. */
static bool repeated(const struct wf_predictor *w, const double *internal, bool nuisance)
{
    for (size_t p = 0; p < w->params; p++)
        if (internal[p] != w->solved[p] && (nuisance || !wf_param_nuisance(&w->p[p]))) return false;
    return true;
}

/* Let the standing trees stand with the values given. A part that is stiffened makes another tree. */
static enum wf_status stand_firm(struct wf_predictor *w, const double *internal, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < w->x->trees && !s; k++) {
        const struct wf_fit_tree *t = &w->x->tree[k];
        struct wf_loads loads;
        struct wf_solve_options options;
        if (!t->props) continue;
        size_t before = t->props->times;
        wf_param_apply(w->x, w->p, w->params, internal, k, &w->tree[k], &loads, &options);
        s = wf_fit_tree_firm(t, &w->tree[k], &loads, &options, e);
        if (t->props->times > before) w->same = false;
    }
    return s;
}

enum wf_status wf_predict(struct wf_predictor *w, const double *internal, double *reading, double *slope,
                          struct wf_err *e)
{
    const size_t m = w->x->data, n = w->params;
    if (repeated(w, internal, true) && (w->sloped || !slope)) {
        memcpy(reading, w->told, m * sizeof *reading);
        if (slope) memcpy(slope, w->told_slope, m * n * sizeof *slope);
        return WF_OK;
    }
    size_t at = 0;
    enum wf_status status = WF_OK;
    if (slope) memset(slope, 0, m * n * sizeof *slope);
    w->same = repeated(w, internal, false);
    for (size_t p = 0; p < n; p++) w->solved[p] = NAN;
    if (!w->same) status = stand_firm(w, internal, e);
    for (size_t k = 0; k < w->x->tests && !status; k++) {
        bool free = w->x->test[k].load == WF_FIT_FREE;
        status = (free ? wf_free_sway_test : static_test)(w, k, internal, reading, slope, &at, e);
        wf_arena_free(&w->scratch);
    }
    if (status) return status;
    nuisance(w, internal, reading, slope);
    memcpy(w->solved, internal, n * sizeof *internal);
    memcpy(w->told, reading, m * sizeof *reading);
    if (slope) memcpy(w->told_slope, slope, m * n * sizeof *slope);
    w->sloped = slope != NULL;
    return WF_OK;
}

enum { NOISE = 43 }; /* stream of random numbers */

enum wf_status wf_fit_expect(struct wf_experiment *x, const struct wf_fit_param *p, size_t n,
                             struct wf_arena *a, double *reading, double *slope, struct wf_diag *d,
                             struct wf_err *e)
{
    struct wf_predictor *w = NULL;
    double *at = WF_TAKE(a, n, double);
    if (!at) return wf_fail(e, WF_ENOMEM, "not enough memory for the plan");
    for (size_t k = 0; k < n; k++) at[k] = wf_param_internal(&p[k], p[k].start);
    enum wf_status s = wf_predictor_open(x, p, n, a, &w, e);
    if (!s) s = wf_predict(w, at, reading, slope, e);
    if (!s) wf_free_sway_warn(w, d);
    for (size_t k = 0; k < x->trees && !s; k++) wf_fit_tree_warn(&x->tree[k], d);
    if (w) wf_predictor_close(w);
    for (size_t i = 0; i < x->data && !s; i++) {
        struct wf_fit_datum *q = &x->datum[i];
        const struct wf_fit_sensor *sensor = &x->test[q->test].sensor[q->sensor];
        if (sensor->estimated)
            return wf_fail(e, WF_EINPUT, "test %s: sensor %s: a plan needs its 'sigma' or 'sigma_share'",
                           x->test[q->test].name, sensor->name);
        q->sigma =
            fmax(hypot(sensor->sigma, sensor->sigma_share * reading[i]), 1e-12 * fabs(reading[i]) + 1e-300);
    }
    return s;
}

void wf_fit_make_up(struct wf_experiment *x, const double *reading, uint64_t seed, double noise)
{
    for (size_t i = 0; i < x->data; i++) {
        struct wf_fit_datum *q = &x->datum[i];
        q->value =
            reading[i] +
            noise * q->sigma * wf_random_normal(seed, wf_random_stream(NOISE, q->test, q->sensor), q->state);
    }
}
