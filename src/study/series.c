/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/series.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "solve/solve.h"
#include "study/limits.h"
#include "study/verdict.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- The changing wind ---- */

/* Can the wind direction change from frame to frame? */
static bool turns(const struct wf_series_spec *q)
{
    bool frames = q->solver == &wf_solver_deflect || q->solver == &wf_solver_deflect_as_printed;
    return !frames && !q->shelter;
}

/* Number of gust components used. */
static unsigned components(const struct wf_series_spec *q, const struct wf_gust_spec *gust, struct wf_diag *d)
{
    unsigned most = gust->model->components;
    if (gust->record && gust->record->components < most) most = 1;
    unsigned asked = q->components ? q->components : most;
    if (asked == 1 || turns(q)) return asked;
    wf_diag_warn(d, "along-wind-only",
                 "%s: the gust model '%s' has 3 components; the one along the wind alone is used, because %s",
                 q->name, gust->model->name,
                 q->shelter ? "the wind inside the crown is made for one direction"
                            : "the deflect solvers go from frame to frame in one direction");
    return 1;
}

static enum wf_status specify(const struct wf_series *s, struct wf_gust_spec *out, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    const struct wf_gust_model *model = wf_gust_named(q->gust);
    enum wf_status status;
    if (!model) return wf_fail(e, WF_EUSAGE, "unknown gust model '%s'", q->gust);
    wf_gust_spec_default(model, out);
    out->speed = wf_scenario_speed(&s->an.scenario, q->speed);
    out->height = s->an.scenario.reference_height;
    if (!isnan(q->intensity)) out->intensity = q->intensity;
    out->step = q->step;
    out->steps = s->frames;
    out->seed = q->seed;
    if (!isnan(q->period) && wf_gust_set(out, "period", q->period, e)) return e->code;
    if ((status = wf_gust_set_words(out, q->gust_set, a, e))) return status;
    if (strcmp(model->name, "record") == 0)
        status = wf_gust_record_words(out, q->gust_file, &q->record, a, d, e);
    else if (q->gust_file)
        status = wf_fail(e, WF_EUSAGE, "%s: a file is for the gust model 'record', not '%s'", q->gust_file,
                         model->name);
    out->components = components(q, out, d);
    return status;
}

/* Fill s->wind, and s->across and s->up where the wind direction changes, from the gust model. */
static enum wf_status series_wind(struct wf_series *s, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    struct wf_gust_spec spec;
    struct wf_gust gust;
    const double steady = wf_scenario_speed(&s->an.scenario, q->speed);
    for (size_t k = 0; k < s->frames; k++) s->wind[k] = steady;
    if (!q->gust)
        return q->gust_file ? wf_fail(e, WF_EUSAGE, "%s: a steady wind has no file", q->gust_file) : WF_OK;
    enum wf_status status = specify(s, &spec, a, d, e);
    if (!status) status = wf_gust_open(&spec, a, d, &gust, e);
    if (status) return status;
    double *block = WF_TAKE(a, spec.components * gust.block, double);
    double **const part[] = { &s->wind, &s->across, &s->up };
    s->gust_words = wf_gust_words(&spec, a);
    bool room = block && s->gust_words;
    for (unsigned c = 1; c < spec.components; c++) room = (*part[c] = WF_TAKE(a, s->frames, double)) && room;
    if (!room) status = wf_fail(e, WF_ENOMEM, "not enough memory for the wind");
    for (unsigned c = 0; c < spec.components && !status; c++)
        status = wf_gust_history(&gust, 0, c, block, *part[c], e);
    wf_gust_close(&gust);
    return status;
}

/* Set speed and direction of frame k in place of those of the mean wind. */
static void series_blow(const struct wf_series *s, size_t k, struct wf_wind *wind)
{
    double along = s->wind[k], across = s->across ? s->across[k] : 0.0, up = s->up ? s->up[k] : 0.0;
    double to[3] = { wind->direction[0], wind->direction[1], 0.0 }, speed = hypot(hypot(along, across), up);
    const double own[3] = { along * to[0] - across * to[1], along * to[1] + across * to[0], up };
    wind->speed = speed;
    for (int i = 0; i < 3 && speed > 0.0; i++) wind->direction[i] = own[i] / speed;
}

/* ---- The run ---- */

void wf_series_default(struct wf_series_spec *s)
{
    *s = (struct wf_series_spec){ .name = "series",
                                  .preset = &wf_presets[0],
                                  .solver = wf_solvers[0],
                                  .speed = 10,
                                  .intensity = NAN,
                                  .period = NAN,
                                  .record = { .columns = WF_RECORD_COLUMNS, .rate = NAN },
                                  .seed = 1,
                                  .step = 0.1,
                                  .frames = 600,
                                  .keys = 8,
                                  .youngs = NAN,
                                  .transmission = 0.2,
                                  .leaf_motion = &wf_leaf_motions[0],
                                  .leaf_period = 1,
                                  .flutter = { { 3, 0.5, 2, 1 }, { 0 }, 0.5 },
                                  .profile = WF_PROFILE_UNSAID };
    wf_leaf_amplitude(0.5235987755982988, &s->flutter); /* 30 degrees */
    wf_solve_options_default(&s->solve);
    wf_scenario_default(&s->scenario);
}

static enum wf_status set_up(struct wf_series *s, struct wf_shelter *shelter, struct wf_arena *a,
                             struct wf_diag *d, struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    s->an = (struct wf_analysis){
        .species = q->species, .model = q->model, .solver = q->solver, .scenario = q->scenario, .diag = d
    };
    struct wf_scenario *sc = &s->an.scenario;
    enum wf_status status = wf_scenario_profile(sc, &q->profile, a, d, e);
    if (!status) status = wf_scenario_check(sc, e);
    if (!status) status = wf_analysis_set_up(&s->an, &q->solve, a, d, e);
    if (status) return status;
    wf_limits_profile(sc, s->an.tallness, q->model->name, d);
    for (size_t i = 0; !isnan(q->youngs) && i < s->an.tree.n; i++) {
        s->an.tree.shear[i] *= q->youngs / s->an.tree.youngs[i];
        s->an.tree.youngs[i] = q->youngs;
    }
    s->an.wind.speed = wf_scenario_speed(sc, q->speed);
    if (q->shelter) {
        struct wf_shelter_request r;
        wf_shelter_request_default(&r);
        r.law = q->shelter;
        r.transmission = q->transmission;
        struct wf_wind *base = WF_TAKE(a, 1, struct wf_wind);
        if (!base) return wf_fail(e, WF_ENOMEM, "not enough memory for the wind");
        *base = s->an.wind;
        if ((status = wf_shelter_make(&s->an.tree, base, &r, a, shelter, e))) return status;
        wf_shelter_field(shelter, &s->an.wind);
    }
    if (s->an.tree.n == 0) return wf_fail(e, WF_EUSAGE, "the tree has no segments");
    return q->model->generator == WF_GENERATOR_STEM
               ? WF_OK
               : wf_leaves_place(q->model, &s->an.tree, a, &s->leaves, e);
}

static void place_keys(struct wf_series *s)
{
    for (size_t k = 0; k < s->spec.keys; k++) s->key[k] = k * s->frames / s->spec.keys;
}

static enum wf_status take(struct wf_series *s, struct wf_arena *a, struct wf_err *e)
{
    size_t n = s->an.tree.n, f = s->frames;
    s->status = WF_TAKE(a, f, enum wf_status);
    s->place = WF_TAKE(a, 3 * n * f, double);
    s->deflection = WF_TAKE(a, f, double);
    s->moment = WF_TAKE(a, f, double);
    s->safety = WF_TAKE(a, f, double);
    s->broken = f;
    s->key = WF_TAKE(a, s->spec.keys, size_t);
    for (size_t i = 0; i < n; i++)
        if ((size_t)s->an.tree.level[i] >= s->levels) s->levels = (size_t)s->an.tree.level[i] + 1;
    s->level = WF_TAKE(a, s->levels, struct wf_series_level);
    if (!s->status || !s->place || !s->deflection || !s->moment || !s->safety || !s->key || !s->level)
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu frames of %zu segments", f, n);
    place_keys(s);
    for (size_t k = 0; k < f; k++) s->safety[k] = NAN;
    s->tip = wf_tip_row(&s->an.tree);
    return WF_OK;
}

static void keep(struct wf_series *s, size_t frame, const double *end, size_t stride)
{
    const struct wf_tree *t = &s->an.tree;
    double *to = s->place + frame * 3 * t->n;
    for (size_t i = 0; i < t->n; i++)
        for (size_t k = 0; k < 3; k++) to[3 * i + k] = end[stride * i + k];
    const double *tip = end + stride * s->tip;
    s->deflection[frame] =
        hypot(tip[0] - t->x1[s->tip], hypot(tip[1] - t->y1[s->tip], tip[2] - t->z1[s->tip]));
}

/* An interrupt in a run: the first k frames, which are finished, stay. Returned: whether the run ends here.
 */
static bool ends_early(struct wf_series *s, size_t k, struct wf_diag *d)
{
    if (!k || !wf_interrupted()) return false;
    wf_diag_warn(d, "interrupted", "%s: interrupted: %zu of %zu frames", s->spec.name, k, s->frames);
    s->frames = s->spec.frames = k;
    if (s->spec.keys > k) s->spec.keys = k;
    place_keys(s);
    return true;
}

/* The deflect scheme: each frame depends on the one before. */
static enum wf_status run_frames(struct wf_series *s, bool printed, struct wf_arena *a, struct wf_diag *found,
                                 struct wf_err *e)
{
    const struct wf_series_spec *q = &s->spec;
    const struct wf_deflect_scheme scheme = { printed, q->restoring, q->damping };
    const struct wf_tree *t = &s->an.tree;
    struct wf_deflect d;
    if (wf_deflect_open(t, &s->an.loads, &scheme, a, &d, e)) return e->code;
    wf_stage_begin(s->frames, false, "%s: frames", q->name);
    for (size_t k = 0; k < s->frames && !ends_early(s, k, found); k++) {
        wf_stage_step(k > 0);
        double moment[3] = { 0 };
        wf_deflect_frame(&d, q->speed > 0 ? s->wind[k] / q->speed : 0, k ? q->step : 0);
        keep(s, k, d.end[0], 3);
        s->clamped += d.clamped > 0;
        for (size_t i = 0; i < t->n; i++) { /* force at the middle of the row it acts on */
            double arm[3], lever[3];
            for (int x = 0; x < 3; x++) arm[x] = d.end[i][x] - 0.5 * d.row[i].length * d.chord[i][x];
            wf_cross(arm, d.force[i], lever);
            v3_add(moment, 1, lever);
        }
        s->moment[k] = hypot(moment[0], moment[1]);
    }
    return WF_OK;
}

/* A frame without a result repeats the one before it; the first shows the unloaded tree. */
static void show_last(struct wf_series *s, size_t k)
{
    const struct wf_tree *t = &s->an.tree;
    double *to = s->place + k * 3 * t->n;
    if (k) memcpy(to, to - 3 * t->n, 3 * t->n * sizeof *to);
    for (size_t i = 0; !k && i < t->n; i++)
        to[3 * i] = t->x1[i], to[3 * i + 1] = t->y1[i], to[3 * i + 2] = t->z1[i];
}

/* A frame of the same wind as the one before it. */
static void repeat_frame(struct wf_series *s, size_t k)
{
    show_last(s, k);
    s->status[k] = s->status[k - 1];
    s->failed += s->status[k] != WF_OK;
    s->deflection[k] = s->deflection[k - 1], s->moment[k] = s->moment[k - 1], s->safety[k] = s->safety[k - 1];
}

/* Keep the equilibrium of frame k and compare its stresses with the strength. */
static enum wf_status keep_balance(struct wf_series *s, size_t k, struct wf_response *r,
                                   struct wf_arena *scratch, struct wf_err *e)
{
    const struct wf_tree *t = &s->an.tree;
    struct wf_breakage stresses;
    struct wf_at_speed at = { .status = WF_OK };
    enum wf_status status = wf_breakage_check(t, r, NULL, scratch, &stresses, e);
    if (status) return status;
    wf_criteria_check(t, r, &stresses, at.worst);
    const struct wf_worst *breaks = &at.worst[WF_BREAKAGE][WF_SCOPE_TREE];
    if (breaks->row >= 0) s->safety[k] = breaks->safety;
    s->safety[k] = fmin(s->safety[k], wf_verdict_safety(&at, NULL));
    for (size_t i = 0; i < t->n; i++)
        r->end[3 * i] += t->x1[i], r->end[3 * i + 1] += t->y1[i], r->end[3 * i + 2] += t->z1[i];
    keep(s, k, r->end, 3);
    s->moment[k] = hypot(r->base_moment[0], r->base_moment[1]);
    return WF_OK;
}

/* Solve frame k. Returned: a status that ends the run, else WF_OK; why: what a frame without result says. */
static enum wf_status solve_frame(struct wf_series *s, size_t k, struct wf_diag *d, struct wf_err *why)
{
    struct wf_arena scratch = { 0 };
    struct wf_diag quiet = { .arena = &scratch };
    struct wf_wind wind = s->an.wind;
    struct wf_loads loads = s->an.loads;
    struct wf_response r;
    series_blow(s, k, &wind);
    wf_loads_blow(&loads, &wind);
    enum wf_status status =
        s->an.solver->solve(&s->an.tree, &loads, &s->spec.solve, &scratch, &r, k ? &quiet : d, why);
    if (!status) status = keep_balance(s, k, &r, &scratch, why);
    s->status[k] = status;
    if (status) {
        s->failed++;
        s->deflection[k] = s->moment[k] = NAN;
        show_last(s, k);
    }
    wf_arena_free(&scratch);
    return status == WF_ENOMEM || status == WF_EINPUT || status == WF_EUSAGE ? status : WF_OK;
}

/* Quasi-static: one static equilibrium for each frame; in a steady wind one for all. */
static enum wf_status run_balances(struct wf_series *s, struct wf_diag *d, struct wf_err *e)
{
    struct wf_err first = { 0 };
    wf_stage_begin(s->frames, false, "%s: frames", s->spec.name);
    for (size_t k = 0; k < s->frames && !ends_early(s, k, d); k++) {
        struct wf_err why = { 0 };
        wf_stage_step(k > 0);
        if (k && !s->spec.gust) {
            repeat_frame(s, k);
            continue;
        }
        enum wf_status status = solve_frame(s, k, d, &why);
        if (why.code && !first.code) first = why;
        if (status) return wf_fail(e, status, "%s", first.text);
    }
    if (s->failed == s->frames) return wf_fail(e, first.code, "%s", first.text);
    if (s->failed)
        wf_diag_warn(d, "no-equilibrium",
                     "%s: %zu of %zu frames have no result (%s); they show the frame before", s->spec.name,
                     s->failed, s->frames, first.text);
    if (s->spec.gust || s->frames < 2) return WF_OK;
    wf_diag_warn(
        d, "steady-wind",
        "%s: the wind does not change, so neither does the tree: one frame is drawn; --gust (key: gust) "
        "makes it change, 'windfirm wind list' shows how",
        s->spec.name);
    s->spec.keys = 1;
    return WF_OK;
}

/* ---- What the frames must be read with ---- */

static void check_broken(struct wf_series *s, struct wf_diag *d)
{
    for (s->broken = 0; s->broken < s->frames && !(s->safety[s->broken] <= 1.0);) s->broken++;
    if (s->broken == s->frames) return;
    wf_diag_warn(
        d, "broken",
        "%s: a part breaks or the tree is lost at %.4g s in a wind of %.4g m/s; from there on (grey) the "
        "frames are those of a tree that cannot break",
        s->spec.name, (double)s->broken * s->spec.step, s->wind[s->broken]);
}

/* The frame that is deepest below the ground. */
static void check_ground(const struct wf_series *s, struct wf_diag *d)
{
    const struct wf_tree *t = &s->an.tree;
    size_t worst = 0;
    double lowest = 0.0;
    char when[60];
    for (size_t k = 0; k < s->frames; k++) {
        double z = wf_limits_ground(t, s->place + k * 3 * t->n, false, "", "", NULL);
        if (z < lowest) lowest = z, worst = k;
    }
    if (!(lowest < 0.0)) return;
    (void)snprintf(when, sizeof when, "at %.4g s (%.4g m/s)", (double)worst * s->spec.step, s->wind[worst]);
    wf_limits_ground(t, s->place + worst * 3 * t->n, false, s->spec.name, when, d);
}

/* Half the range along the wind of a row's end; with a foot, relative to that row's end [m]. */
static double swing(const struct wf_series *s, size_t row, int32_t foot)
{
    const double *to = s->an.wind.direction;
    double low = INFINITY, high = -INFINITY;
    for (size_t k = 0; k < s->frames; k++) {
        const double *p = s->place + k * 3 * s->an.tree.n, *q = p + 3 * row;
        double x = 0;
        for (size_t j = 0; j < 3; j++) x += to[j] * (q[j] - (foot >= 0 ? p[3 * (size_t)foot + j] : 0));
        low = fmin(low, x), high = fmax(high, x);
    }
    return 0.5 * (high - low);
}

static enum wf_status measure_levels(struct wf_series *s, struct wf_err *e)
{
    const struct wf_tree *t = &s->an.tree;
    struct wf_arena scratch = { 0 };
    bool *goes_on = WF_TAKE(&scratch, t->n, bool);
    int32_t *foot = WF_TAKE(&scratch, t->n, int32_t); /* parent row of the axis */
    size_t *side = WF_TAKE(&scratch, 2 * s->levels, size_t);
    if (!goes_on || !foot || !side) {
        wf_arena_free(&scratch);
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    }
    for (size_t i = 0; i < t->n; i++) {
        int32_t p = t->parent[i];
        bool same = p >= 0 && t->level[p] == t->level[i];
        if (same) goes_on[p] = true;
        foot[i] = same ? foot[p] : p;
    }
    for (size_t i = 0; i < t->n; i++) {
        if (goes_on[i]) continue;
        struct wf_series_level *l = &s->level[t->level[i]];
        const double *to = s->an.wind.direction;
        double far = swing(s, i, -1);
        double x = to[0] * (t->x1[i] - t->x0[0]) + to[1] * (t->y1[i] - t->y0[0]);
        bool lee = x > 0;
        l->axes++;
        l->swing_mean += far;
        l->swing_most = fmax(l->swing_most, far);
        double own = swing(s, i, foot[i]);
        l->own_mean += own;
        *(lee ? &l->leeward : &l->windward) += far;
        *(lee ? &l->own_leeward : &l->own_windward) += own;
        side[2 * (size_t)t->level[i] + lee]++;
    }
    for (size_t k = 0; k < s->levels; k++) {
        struct wf_series_level *l = &s->level[k];
        if (!l->axes) continue;
        l->swing_mean /= (double)l->axes, l->own_mean /= (double)l->axes;
        double of[2] = { side[2 * k] ? (double)side[2 * k] : NAN,
                         side[2 * k + 1] ? (double)side[2 * k + 1] : NAN };
        l->windward /= of[0], l->own_windward /= of[0];
        l->leeward /= of[1], l->own_leeward /= of[1];
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

enum wf_status wf_series_run(const struct wf_series_spec *spec, struct wf_arena *a, struct wf_diag *d,
                             struct wf_series *s, struct wf_err *e)
{
    *s = (struct wf_series){ .spec = *spec, .frames = spec->frames, .diag = d };
    if (spec->frames < 1 || spec->keys < 1 || spec->keys > spec->frames)
        return wf_fail(e, WF_EUSAGE,
                       "%zu frames with %zu key frames: at least one of each, and no more keys than "
                       "frames",
                       spec->frames, spec->keys);
    struct wf_shelter *shelter = WF_TAKE(a, 1, struct wf_shelter);
    s->wind = WF_TAKE(a, s->frames, double);
    if (!shelter || !s->wind) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu frames", s->frames);
    enum wf_status status = set_up(s, shelter, a, d, e);
    if (!status) status = series_wind(s, a, d, e);
    if (!status) status = take(s, a, e);
    s->an.loads.wind = &s->an.wind;
    bool printed = spec->solver == &wf_solver_deflect_as_printed;
    bool frames = printed || spec->solver == &wf_solver_deflect;
    if (!frames && (spec->restoring > 0 || spec->damping > 0))
        return wf_fail(e, WF_EUSAGE,
                       "restoring and damping factors belong to the solvers deflect and "
                       "deflect-as-printed, not to '%s'",
                       spec->solver->name);
    if (!status) status = frames ? run_frames(s, printed, a, d, e) : run_balances(s, d, e);
    if (!status) status = measure_levels(s, e);
    if (status) return status;
    check_broken(s, d);
    check_ground(s, d);
    if (s->clamped)
        wf_diag_warn(d, "asin-clamped",
                     "%s: in %zu of %zu frames a segment would deflect by more than its length; "
                     "it was held at 90 degrees",
                     spec->name, s->clamped, s->frames);
    wf_preset_warn(spec->preset, &s->an, d);
    if (spec->preset->in_time && spec->frames > 1) spec->preset->in_time(d);
    if (spec->shelter && spec->shelter->as_printed) wf_departures_shelter(d);
    return WF_OK;
}

/* ---- Leaves: own rotations and positions ---- */

void wf_leaf_matrix(const double angle[3], double R[9])
{
    double sx = sin(angle[0]), cx = cos(angle[0]), sy = sin(angle[1]), cy = cos(angle[1]), sz = sin(angle[2]),
           cz = cos(angle[2]);
    const double all[9] = { cz * cy,
                            cz * sy * sx - sz * cx,
                            cz * sy * cx + sz * sx,
                            sz * cy,
                            sz * sy * sx + cz * cx,
                            sz * sy * cx - cz * sx,
                            -sy,
                            cy * sx,
                            cy * cx };
    memcpy(R, all, sizeof all);
}

void wf_leaf_place(const struct wf_leaf_stand *s, const double (*turn)[9], const double (*end)[3],
                   const double R[9], struct wf_leaf_pose *out)
{
    const double *T = turn[s->row];
    double v[3];
    m3_apply(T, s->axis, out->at);
    for (int k = 0; k < 3; k++) out->at[k] = end[s->row][k] - s->along * out->at[k];
    m3_apply(R, s->direction, v);
    m3_apply(T, v, out->tip);
    m3_apply(R, s->side, v);
    m3_apply(T, v, out->side);
}

static void leaf_turn(const double v[3], double x[3])
{
    double R[9];
    rotation_matrix(v, R);
    m3_apply(R, x, x);
}

void wf_leaf_swing(double phi, double psi, struct wf_leaf_pose *p)
{
    const double up[3] = { 0, 0, 1 };
    double hinge[3], size;
    wf_cross(up, p->tip, hinge);
    size = sqrt(wf_dot(hinge, hinge));
    if (!(size > 0)) memcpy(hinge, p->side, sizeof hinge), size = 1; /* vertical leaf: about its own side */
    const double swing[3] = { -phi * hinge[0] / size, -phi * hinge[1] / size, -phi * hinge[2] / size };
    const double twist[3] = { 0, 0, psi };
    leaf_turn(swing, p->tip), leaf_turn(swing, p->side);
    leaf_turn(twist, p->tip), leaf_turn(twist, p->side);
}

void wf_leaf_amplitude(double angle, struct wf_leaf_flutter *f)
{
    for (int k = 0; k < 3; k++) f->amplitude[k] = angle / wf_noise_range(&f->octaves);
}

static void in_proportion(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    (void)leaf;
    angle[0] = s->leaves.swing * s->wind[frame];
    angle[1] = s->leaves.twist * s->wind[frame];
}

static void by_noise(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    double time = (double)frame * s->spec.step / s->spec.leaf_period;
    wf_noise_leaf(s->spec.seed, leaf, &s->spec.flutter, time, angle);
}

static void turn_swung(const double angle[3], struct wf_leaf_pose *p)
{
    wf_leaf_swing(angle[0], angle[1], p);
}

const struct wf_leaf_motion wf_leaf_motions[] = {
    { .name = "eq13",
      .title = "swing and twist in proportion to the wind's speed",
      .source = "Tang L., Zou J., Lin D., Chen C. 2012, eq 13",
      .angles = { "swing", "twist" },
      .angle = in_proportion,
      .hang = turn_swung },
    { .name = "noise",
      .title = "turns about three axes from three noises",
      .source = "Zhao P., Zhang Z. 2013, section 3.3",
      .angles = { "theta_x", "theta_y", "theta_z" },
      .angle = by_noise },
    { .name = NULL },
};

const struct wf_leaf_motion *wf_leaf_motion_named(const char *name)
{
    for (const struct wf_leaf_motion *m = wf_leaf_motions; m->name; m++)
        if (!strcmp(m->name, name)) return m;
    return NULL;
}

void wf_series_leaf_angles(const struct wf_series *s, size_t leaf, size_t frame, double angle[3])
{
    memset(angle, 0, 3 * sizeof *angle);
    s->spec.leaf_motion->angle(s, leaf, frame, angle);
}

/* Smallest rotation from a row's unbent direction to its present one. */
static void chord_turn(const struct wf_series *s, size_t row, const double *place, double at[3], double R[9])
{
    const struct wf_tree *t = &s->an.tree;
    const double base[3] = { t->x0[row], t->y0[row], t->z0[row] };
    double was[3] = { t->x1[row] - base[0], t->y1[row] - base[1], t->z1[row] - base[2] }, is[3], v[3],
           foot[3];
    int32_t p = t->parent[row];
    for (int k = 0; k < 3; k++) {
        foot[k] = p >= 0 ? place[3 * p + k] : base[k];
        at[k] = place[3 * row + (size_t)k];
        is[k] = at[k] - foot[k];
    }
    double a = sqrt(wf_dot(was, was)), b = sqrt(wf_dot(is, is));
    wf_cross(was, is, v);
    double size = sqrt(wf_dot(v, v)), angle = atan2(size, wf_dot(was, is));
    for (int k = 0; k < 3; k++) v[k] = size > 1e-12 * a * b ? v[k] * angle / size : 0;
    rotation_matrix(v, R);
}

/* Pose of a leaf: its own rotations, where they are about the tree's axes, then the rotation of its row. */
static void carry_leaf(const struct wf_series *s, size_t i, const double R[9], const double own[9],
                       struct wf_leaf_pose *p)
{
    double v[3];
    m3_apply(own, s->leaves.direction + 3 * i, v);
    m3_apply(R, v, p->tip);
    m3_apply(own, s->leaves.side + 3 * i, v);
    m3_apply(R, v, p->side);
}

void wf_series_leaves(const struct wf_series *s, size_t frame, double *at, double *tip)
{
    const struct wf_tree *t = &s->an.tree;
    const struct wf_leaf_motion *motion = s->spec.leaf_motion;
    const double *place = s->place + frame * 3 * t->n, still[3] = { 0 };
    for (size_t i = 0; i < s->leaves.n; i++) {
        size_t row = (size_t)s->leaves.row[i];
        double end[3], R[9], own[9], angle[3], back[3];
        const double axis[3] = { t->x1[row] - t->x0[row], t->y1[row] - t->y0[row], t->z1[row] - t->z0[row] };
        struct wf_leaf_pose p;
        chord_turn(s, row, place, end, R);
        m3_apply(R, axis, back);
        for (int k = 0; k < 3; k++) p.at[k] = end[k] - (1 - s->leaves.place[i]) * back[k];
        wf_series_leaf_angles(s, i, frame, angle);
        wf_leaf_matrix(motion->hang ? still : angle, own);
        carry_leaf(s, i, R, own, &p);
        if (motion->hang) motion->hang(angle, &p);
        double length = sqrt(s->leaves.area[i]); /* drawn with the side of a square of its area */
        for (size_t k = 0; k < 3; k++) {
            at[3 * i + k] = p.at[k];
            tip[3 * i + k] = p.at[k] + length * p.tip[k];
        }
    }
}
