/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fit/build.h"
#include "fit/plant.h"
#include "study/limits.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* One test: its sensors, states and readings. */

/* Sigma of a reading: absolute and relative parts add in squares. */
static double sigma_of(const struct wf_fit_sensor *s, double value)
{
    return s->estimated ? 1 : hypot(s->sigma, s->sigma_share * value);
}

static enum wf_status sensor(struct wf_units *u, const struct wf_calibration *calibration,
                             const struct wf_calibration_test *t, const struct wf_calibration_sensor *s,
                             struct wf_fit_sensor *out, double *value, struct wf_err *e)
{
    const struct wf_sensor_row *r = &wf_sensor_rows[s->kind];
    struct wf_err why = { 0 };
    double load = t->pull.given ? t->pull.azimuth : t->wind.given ? t->wind.azimuth : NAN;
    bool sway = s->kind == WF_SENSOR_FREQUENCY || s->kind == WF_SENSOR_DAMPING;
    *out = (struct wf_fit_sensor){ .name = s->name,
                                   .kind = s->kind,
                                   .height = isnan(s->along) ? s->height : s->along,
                                   .along = !isnan(s->along),
                                   .lowest = s->mode && !strcmp(s->mode, "lowest"),
                                   .azimuth = isnan(s->azimuth) && !sway ? load : s->azimuth,
                                   .gauge = isnan(s->gauge) ? 0.1 : s->gauge,
                                   .sigma_share = isnan(s->sigma_share) ? 0 : s->sigma_share,
                                   .offset = s->offset,
                                   .drift = s->drift,
                                   .row = -1,
                                   .low_row = -1 };
    out->estimated = !s->sigma && !(out->sigma_share > 0);
    *value = NAN;
    if (s->sigma && wf_quantity_read_as(u, s->sigma, r->dimension, r->unit, &out->sigma, &why))
        return wf_fail(e, why.code, "%s: test %s: %s: sigma: %s", calibration->file, t->name, s->name,
                       why.text);
    if (s->sigma && !(out->sigma > 0))
        return wf_fail(e, WF_EINPUT, "%s: test %s: %s: sigma must be above zero", calibration->file, t->name,
                       s->name);
    if (s->value && wf_quantity_read_as(u, s->value, r->dimension, r->unit, value, &why))
        return wf_fail(e, why.code, "%s: test %s: %s: value: %s", calibration->file, t->name, s->name,
                       why.text);
    return WF_OK;
}

static void load_of(const struct wf_calibration_test *s, struct wf_fit_test *t, struct wf_fit_input *in)
{
    bool sways =
        s->sway.given ||
        (s->sensors && (s->sensor[0].kind == WF_SENSOR_FREQUENCY || s->sensor[0].kind == WF_SENSOR_DAMPING));
    t->load = s->pull.given ? WF_FIT_PULL : s->wind.given ? WF_FIT_WIND : sways ? WF_FIT_FREE : WF_FIT_WEIGHT;
    t->from_rest = s->zero == 0;
    if (s->pull.given) {
        t->azimuth = s->pull.azimuth, t->elevation = s->pull.elevation;
        t->anchored = !isnan(s->pull.anchor_distance);
        t->anchor[0] = s->pull.anchor_distance * cos(t->azimuth);
        t->anchor[1] = s->pull.anchor_distance * sin(t->azimuth);
        t->anchor[2] = s->pull.anchor_height;
        in->load_name = "pull", in->load_unit = "kN", in->load_factor = 1e-3;
    } else if (s->wind.given) {
        in->load_name = "wind", in->load_unit = "m/s", in->load_factor = 1;
    } else if (t->load == WF_FIT_WEIGHT) {
        in->load_name = s->along ? "along the axis" : "weight", in->load_unit = s->along ? "m" : "";
    }
}

/* Report a mistake in a test's wind that is found when its files are read. */
static enum wf_status wind_fails(const struct wf_fit_build *b, size_t test, const char *key,
                                 struct wf_yaml_mark place, const struct wf_err *why, struct wf_diag *d,
                                 struct wf_err *e)
{
    if (why->code == WF_EMISSING || why->code == WF_ENOMEM) return wf_fail(e, why->code, "%s", why->text);
    wf_diag_error(d, b->calibration->file, place.line, place.column, "tests[%zu].wind.%s: %s", test, key,
                  why->text);
    return wf_fail(e, WF_EINPUT, "%s: test %s: its wind cannot be used", b->calibration->file,
                   b->calibration->test[test].name);
}

/* Read the measured profile of a test's wind into the scene. */
static enum wf_status read_profile(const struct wf_fit_build *b, size_t test, struct wf_arena *a,
                                   struct wf_diag *d, struct wf_scenario *scene, const char **file,
                                   struct wf_err *e)
{
    const struct wf_calibration_wind *w = &b->calibration->test[test].wind;
    struct wf_profile_words words = w->profile;
    struct wf_err why = { 0 };
    if (!words.file) return WF_OK;
    enum wf_status status = wf_calibration_path(b->calibration, words.file, a, file, &why);
    words.file = *file;
    if (!status) status = wf_scenario_profile(scene, &words, a, d, &why);
    if (!status) status = wf_scenario_check(scene, &why);
    return status ? wind_fails(b, test, "profile_file", w->profile_file_place, &why, d, e) : WF_OK;
}

/* Read the terrain around a test's tree into the scene. */
static enum wf_status read_ground(const struct wf_fit_build *b, size_t test, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_scenario *scene, const char **file,
                                  struct wf_err *e)
{
    const struct wf_calibration_wind *w = &b->calibration->test[test].wind;
    struct wf_err why = { 0 };
    if (!w->dem) return WF_OK;
    struct wf_site *site = WF_TAKE(a, 1, struct wf_site);
    if (!site) return wf_fail(e, WF_ENOMEM, "not enough memory for a map");
    enum wf_status status = wf_calibration_path(b->calibration, w->dem, a, file, &why);
    site->file = *file;
    wf_site_place(w->at, &site->x, &site->y);
    if (!status) status = wf_scenario_site(scene, site, w->north, a, &why);
    return status ? wind_fails(b, test, "dem", w->dem_place, &why, d, e) : WF_OK;
}

/* Set a test's wind, air and speed-up. Air that the calibration does not give is the standard air of the
 * tree's loads. */
static enum wf_status scene_of(const struct wf_fit_build *b, size_t test, const struct wf_fit_tree *tree,
                               struct wf_arena *a, struct wf_diag *d, struct wf_fit_test *t,
                               struct wf_fit_input *in, struct wf_err *e)
{
    const struct wf_calibration_wind *w = &b->calibration->test[test].wind;
    struct wf_scenario scene;
    struct wf_loads loads;
    if (t->load != WF_FIT_WIND) return WF_OK;
    enum wf_status status = wf_calibration_wind_scene(w, &scene, e);
    if (!status) status = read_profile(b, test, a, d, &scene, &in->profile, e);
    if (!status) status = read_ground(b, test, a, d, &scene, &in->ground, e);
    if (!status) status = wf_scenario_loads(&scene, tree->species, &t->wind, &loads, e);
    if (status) return status;
    wf_limits_profile(&scene, tree->height, tree->name, d);
    wf_limits_site(scene.site, d);
    t->speed_up = wf_scenario_speed(&scene, 1);
    if (isnan(w->temperature) && isnan(w->altitude) && isnan(w->air_density)) return WF_OK;
    t->air_density = loads.air_density, t->air_viscosity = loads.air_viscosity;
    return WF_OK;
}

/* Average neighbouring used rows into at most `points` states. */
static enum wf_status average(const struct wf_calibration_test *s, struct wf_fit_test *t,
                              const struct wf_test_data *r, const double *sign, struct wf_arena *a,
                              struct wf_fit_datum **data, size_t *n, struct wf_err *e)
{
    size_t used = 0, m = r->columns;
    for (size_t i = 0; i < r->n; i++) used += r->used[i];
    t->states = used < s->points ? used : s->points;
    t->state = WF_TAKE(a, t->states, struct wf_fit_state);
    *data = WF_TAKE(a, t->states * t->sensors, struct wf_fit_datum);
    double *sum = WF_TAKE(a, m, double);
    if (!t->state || !*data || !sum) return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", t->name);
    size_t from = 0, seen = 0;
    for (size_t k = 0; k < t->states; k++) {
        size_t until = used * (k + 1) / t->states, count = 0, line = 0;
        double time = 0;
        for (size_t c = 0; c < m; c++) sum[c] = 0;
        for (; seen < until; from++) {
            if (!r->used[from]) continue;
            for (size_t c = 0; c < m; c++) sum[c] += r->value[from * m + c];
            time += r->time[from];
            if (!line) line = r->line[from];
            count++, seen++;
        }
        t->state[k] = (struct wf_fit_state){ .load = sum[0] / (double)count,
                                             .time = time / (double)count,
                                             .rows = count };
        for (size_t c = 0; c < t->sensors; c++) {
            double v = sign[c] * sum[c + 1] / (double)count;
            (*data)[(*n)++] = (struct wf_fit_datum){ .state = k,
                                                     .sensor = c,
                                                     .value = v,
                                                     .line = line,
                                                     .weight = 1,
                                                     .sigma = sigma_of(&t->sensor[c], v) };
        }
    }
    return WF_OK;
}

static enum wf_status windows(const struct wf_calibration_test *s, struct wf_test_data *r, struct wf_err *e)
{
    size_t left = 0;
    for (size_t i = 0; i < r->n; i++) {
        if (r->time[i] < s->after || r->time[i] > s->until) r->used[i] = false; /* NAN: no limit */
        left += r->used[i];
    }
    return left ? WF_OK : wf_fail(e, WF_EINPUT, "test %s: no row between 'after' and 'until'", s->name);
}

static enum wf_status sensor_columns(const struct wf_fit_build *b, const struct wf_calibration_test *s,
                                     struct wf_column *column, struct wf_err *e)
{
    for (size_t k = 0; k < s->sensors; k++) {
        const struct wf_calibration_sensor *q = &s->sensor[k];
        column[k] = (struct wf_column){ q->column, q->unit, wf_sensor_rows[q->kind].dimension };
        if (!q->column)
            return wf_fail(e, WF_EINPUT, "%s: test %s: sensor %s names no column", b->calibration->file,
                           s->name, q->name);
    }
    return WF_OK;
}

/* How the rows of a test's file are read. Errors: WF_EINPUT where time counts and is not known: free sway, a
 * limit in time, a drift. */
static enum wf_status test_rows(const struct wf_fit_build *b, const struct wf_calibration_test *s,
                                struct wf_test_rows *how, struct wf_err *e)
{
    const char *use = s->sway.given                          ? "the frequency of free sway"
                      : !isnan(s->after) || !isnan(s->until) ? "'after' and 'until'"
                                                             : NULL;
    for (size_t k = 0; k < s->sensors && !use; k++)
        if (s->sensor[k].drift) use = "a drift";
    *how = (struct wf_test_rows){ s->time, s->rate, s->missing, WF_DATES_UNSAID, s->rows, s->rows_n };
    if (!wf_dates_named(s->dates, &how->dates))
        return wf_fail(e, WF_EINPUT, "%s: test %s: dates: '%s'; there are: day-first, month-first",
                       b->calibration->file, s->name, s->dates);
    if (use && !s->time && !(s->rate > 0))
        return wf_fail(
            e, WF_EINPUT,
            "%s: test %s: %s needs the time of the rows; name its column with 'time', or give the rate of "
            "the rows, for example 'rate: 20 Hz'",
            b->calibration->file, s->name, use);
    return WF_OK;
}

static enum wf_status from_file(const struct wf_fit_build *b, const struct wf_calibration_test *s,
                                const char *path, const double *sign, struct wf_arena *a, struct wf_diag *d,
                                struct wf_fit_test *t, struct wf_fit_input *in, struct wf_fit_datum **data,
                                size_t *n, struct wf_err *e)
{
    struct wf_column *column = WF_TAKE(a, s->sensors + 1, struct wf_column);
    if (!column) return wf_fail(e, WF_ENOMEM, "not enough memory for the columns of %s", path);
    bool wind = s->wind.given;
    column[0] = (struct wf_column){ wind ? s->wind.column : s->pull.column,
                                    wind ? s->wind.unit : s->pull.unit, wind ? WF_DIM_SPEED : WF_DIM_FORCE };
    if (!column[0].name)
        return wf_fail(e, WF_EINPUT, "%s: test %s: the %s names no column", b->calibration->file, s->name,
                       in->load_name);
    struct wf_test_rows how;
    enum wf_status status = sensor_columns(b, s, column + 1, e);
    if (!status) status = test_rows(b, s, &how, e);
    if (!status) status = wf_calibration_path(b->calibration, path, a, &in->path, e);
    if (!status) status = wf_test_data_read(in->path, column, s->sensors + 1, &how, a, &in->data, d, e);
    if (!status) status = windows(s, &in->data, e);
    if (!status && !wind) status = wf_loading_branch(&in->data, 0, s->pull.from, s->pull.to, s->name, e);
    if (status) return status;
    if (in->data.missing)
        wf_diag_warn(d, "rows-missing", "%s: test %s: %zu rows with an empty or NA cell were left out",
                     in->path, s->name, in->data.missing);
    double most = 0;
    for (size_t i = 0; i < in->data.n; i++) most = fmax(most, fabs(in->data.value[i * in->data.columns]));
    if (!(most > 0))
        return wf_fail(e, WF_EINPUT, "test %s: the %s is zero throughout", s->name, in->load_name);
    return average(s, t, &in->data, sign, a, data, n, e);
}

/* Readings by position along the axis: each row becomes a state, in which all sensors are at its position. */
static enum wf_status from_places(const struct wf_fit_build *b, const struct wf_calibration_test *s,
                                  const char *path, const double *sign, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_fit_test *t, struct wf_fit_input *in, struct wf_fit_datum **data,
                                  size_t *n, struct wf_err *e)
{
    struct wf_column *column = WF_TAKE(a, s->sensors + 1, struct wf_column);
    struct wf_test_data r;
    if (!column) return wf_fail(e, WF_ENOMEM, "not enough memory for the columns of %s", path);
    column[0] = (struct wf_column){ s->along, NULL, WF_DIM_LENGTH };
    struct wf_test_rows how;
    enum wf_status status = sensor_columns(b, s, column + 1, e);
    if (!status) status = test_rows(b, s, &how, e);
    how.time = NULL;
    if (!status) status = wf_calibration_path(b->calibration, path, a, &in->path, e);
    if (!status) status = wf_test_data_read(in->path, column, s->sensors + 1, &how, a, &r, d, e);
    if (status) return status;
    t->state = WF_TAKE(a, r.n, struct wf_fit_state);
    *data = WF_TAKE(a, r.n * t->sensors, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", s->name);
    for (size_t i = 0; i < r.n; i++) {
        const double *row = r.value + i * r.columns;
        if (fabs(row[0]) <= 1e-3) continue; /* the base itself */
        for (size_t c = 0; c < t->sensors; c++) {
            double v = sign[c] * row[c + 1];
            (*data)[(*n)++] = (struct wf_fit_datum){ .state = t->states,
                                                     .sensor = c,
                                                     .value = b->plan ? (double)NAN : v,
                                                     .line = r.line[i],
                                                     .weight = 1,
                                                     .sigma = sigma_of(&t->sensor[c], v) };
        }
        t->state[t->states++] =
            (struct wf_fit_state){ .load = row[0], .time = (double)i, .rows = 1, .row = -1 };
    }
    return t->states ? WF_OK : wf_fail(e, WF_EINPUT, "test %s: no row beyond the base", s->name);
}

/* Sample that is furthest from the mean. */
static size_t largest_swing(const double *y, size_t n, double mean)
{
    size_t most = 0;
    for (size_t i = 1; i < n; i++)
        if (fabs(y[i] - mean) > fabs(y[most] - mean)) most = i;
    return most;
}

/* Fit frequency and damping to measured free sway; they become two readings. */
static enum wf_status from_sway(const struct wf_fit_build *b, const struct wf_calibration_test *s,
                                const char *path, struct wf_arena *a, struct wf_diag *d,
                                struct wf_fit_test *t, struct wf_fit_input *in, struct wf_fit_datum **data,
                                size_t *n, struct wf_err *e)
{
    struct wf_column column = { s->sway.column, NULL, WF_DIM_NONE };
    struct wf_err why = { 0 };
    struct wf_test_rows how;
    enum wf_status status = test_rows(b, s, &how, e);
    if (!status) status = wf_calibration_path(b->calibration, path, a, &in->path, e);
    if (!status) status = wf_test_data_read(in->path, &column, 1, &how, a, &in->data, d, e);
    if (!status) status = windows(s, &in->data, e);
    if (status) return status;
    struct wf_test_data *r = &in->data;
    double *time = WF_TAKE(a, r->n, double), *y = WF_TAKE(a, r->n, double);
    size_t m = 0;
    t->sensor = WF_TAKE(a, 2, struct wf_fit_sensor), t->state = WF_TAKE(a, 1, struct wf_fit_state);
    *data = WF_TAKE(a, 2, struct wf_fit_datum);
    if (!time || !y || !t->sensor || !t->state || !*data)
        return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", s->name);
    for (size_t i = 0; i < r->n; i++)
        if (r->used[i]) time[m] = r->time[i], y[m++] = r->value[i];
    if (wf_ring_down(time, y, m, a, &in->sway, &why))
        return wf_fail(e, why.code, "test %s: %s", s->name, why.text);
    in->swung = true;
    t->sensors = 2, t->states = 1;
    t->sensor[0] = (struct wf_fit_sensor){ .name = "frequency",
                                           .kind = WF_SENSOR_FREQUENCY,
                                           .azimuth = s->sway.azimuth,
                                           .lowest = s->sway.mode && !strcmp(s->sway.mode, "lowest"),
                                           .sigma = in->sway.frequency_sd,
                                           .row = -1,
                                           .low_row = -1 };
    t->sensor[1] = (struct wf_fit_sensor){ .name = "damping",
                                           .kind = WF_SENSOR_DAMPING,
                                           .azimuth = s->sway.azimuth,
                                           .sigma = in->sway.damping_sd,
                                           .row = -1,
                                           .low_row = -1 };
    const double value[2] = { in->sway.frequency, in->sway.damping };
    for (size_t k = 0; k < 2; k++)
        (*data)[(*n)++] =
            (struct wf_fit_datum){ .sensor = k, .value = value[k], .sigma = t->sensor[k].sigma, .weight = 1 };
    if (in->sway.explained < 0.8) {
        double at = time[largest_swing(y, m, in->sway.mean)];
        wf_diag_warn(
            d, "poor-sway",
            "test %s: one damped sway explains only %.0f %% of the record; its largest swing is at %.6g s "
            "('after: %.6g s' leaves out what was before)",
            s->name, 100 * in->sway.explained, at, at);
    }
    return WF_OK;
}

/* States of a planned test; its readings are NAN. */
static enum wf_status planned(const struct wf_calibration_test *s, struct wf_arena *a, struct wf_fit_test *t,
                              struct wf_fit_datum **data, size_t *n, struct wf_err *e)
{
    const double *load = s->pull.given ? s->pull.load : s->wind.speed;
    t->states = s->pull.given ? s->pull.loads : s->wind.speeds;
    if (!t->states)
        return wf_fail(e, WF_EINPUT, "test %s: a plan needs %s", s->name,
                       s->pull.given ? "'loads' in 'pull'" : "'speeds' in 'wind'");
    t->state = WF_TAKE(a, t->states, struct wf_fit_state),
    *data = WF_TAKE(a, t->states * t->sensors, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", s->name);
    for (size_t i = 0; i < t->states; i++) {
        t->state[i] = (struct wf_fit_state){ .load = load[i], .time = (double)i, .rows = 1 };
        for (size_t k = 0; k < t->sensors; k++)
            (*data)[(*n)++] =
                (struct wf_fit_datum){ .state = i, .sensor = k, .value = NAN, .sigma = 1, .weight = 1 };
    }
    return WF_OK;
}

/* What was measured of free sway, one value a sensor. */
static enum wf_status check_values(const struct wf_calibration *c, const struct wf_calibration_test *t,
                                   struct wf_err *e)
{
    for (size_t k = 0; k < t->sensors; k++) {
        const struct wf_calibration_sensor *q = &t->sensor[k];
        if ((q->kind == WF_SENSOR_FREQUENCY || q->kind == WF_SENSOR_DAMPING) && !q->value)
            return wf_fail(
                e, WF_EINPUT,
                "%s: test %s: %s: a %s needs 'value', unless the test is a plan (simulate-test); records "
                "of sway go under 'sway'",
                c->file, t->name, q->name, wf_sensor_rows[q->kind].name);
    }
    return WF_OK;
}

static enum wf_status fit_build_test(const struct wf_fit_build *b, size_t index, const char *path,
                                     struct wf_arena *a, struct wf_diag *d, struct wf_fit_test *t,
                                     struct wf_fit_input *in, struct wf_fit_datum **data, size_t *n,
                                     struct wf_err *e)
{
    const struct wf_calibration_test *s = &b->calibration->test[index];
    struct wf_units *u;
    double value, *sign = WF_TAKE(a, s->sensors + 1, double), *given = WF_TAKE(a, s->sensors + 1, double);
    *t = (struct wf_fit_test){
        .name = s->name, .tree = b->calibration->trees, .sensors = s->sensors, .pull_row = -1
    };
    *in = (struct wf_fit_input){ .load_name = "free sway", .load_unit = "", .load_factor = 1 };
    t->sensor = WF_TAKE(a, s->sensors + 2, struct wf_fit_sensor);
    if (!sign || !given || !t->sensor) return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", s->name);
    for (size_t k = 0; k < b->calibration->trees; k++)
        if (!s->tree || !strcmp(s->tree, b->calibration->tree[k].name)) t->tree = k;
    if (t->tree == b->calibration->trees)
        return wf_fail(e, WF_EINPUT, "%s: test %s: unknown tree '%s'", b->calibration->file, s->name,
                       s->tree);
    load_of(s, t, in);
    enum wf_status status = wf_units_open(&u, e);
    if (status) return status;
    for (size_t k = 0; k < s->sensors && !status; k++) {
        sign[k] = s->sensor[k].sign ? -1 : 1;
        status = sensor(u, b->calibration, s, &s->sensor[k], &t->sensor[k], &given[k], e);
    }
    wf_units_close(u);
    if (!status && !b->plan) status = check_values(b->calibration, s, e);
    if (status) return status;
    if (s->sway.given && !b->plan) return from_sway(b, s, path, a, d, t, in, data, n, e);
    if (s->pull.given || s->wind.given)
        return b->plan ? planned(s, a, t, data, n, e) : from_file(b, s, path, sign, a, d, t, in, data, n, e);
    if (s->along && path) return from_places(b, s, path, sign, a, d, t, in, data, n, e);
    if (s->along) return wf_fail(e, WF_EINPUT, "test %s: its places are read from 'data'", s->name);
    t->states = 1;
    t->state = WF_TAKE(a, 1, struct wf_fit_state), *data = WF_TAKE(a, s->sensors + 1, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "not enough memory for test %s", s->name);
    t->state[0].row = -2;
    for (size_t k = 0; k < s->sensors; k++) {
        value = b->plan ? (double)NAN : given[k];
        (*data)[(*n)++] = (struct wf_fit_datum){
            .sensor = k, .value = value, .weight = 1, .sigma = sigma_of(&t->sensor[k], value)
        };
    }
    return WF_OK;
}

/* A place and where to store its row. */
struct place {
    struct wf_fit_place at;
    int32_t *row;
};
enum { PLACES = 64 };

static enum wf_status place(struct place *list, size_t *n, double at, bool along, int32_t *row,
                            const char *tree, struct wf_err *e)
{
    if (*n == PLACES) return wf_fail(e, WF_EINPUT, "tree %s: more than %d places", tree, (int)PLACES);
    list[(*n)++] = (struct place){ { at, along }, row };
    return WF_OK;
}

/* Divide a tree's rows where its tests pull and measure, and store the rows in the tests. */
static enum wf_status cut(const struct wf_fit_build *b, struct wf_experiment *x, size_t tree,
                          struct wf_arena *a, struct wf_err *e)
{
    struct place list[PLACES];
    struct wf_fit_place at[PLACES] = { { 0 } };
    int32_t row[PLACES];
    size_t n = 0;
    struct wf_fit_tree *t = &x->tree[tree];
    enum wf_status status = WF_OK;
    for (size_t k = 0; k < x->tests && !status; k++) {
        struct wf_fit_test *q = &x->test[k];
        if (q->tree != tree) continue;
        if (q->load == WF_FIT_PULL)
            status = place(list, &n, b->calibration->test[k].pull.height, false, &q->pull_row, t->name, e);
        bool places = b->calibration->test[k].along != NULL;
        for (size_t s = 0; places && s < q->states && !status; s++)
            status = place(list, &n, q->state[s].load, true, &q->state[s].row, t->name, e);
        for (size_t s = 0; s < q->sensors && !status; s++) {
            struct wf_fit_sensor *w = &q->sensor[s];
            bool gauge = w->kind == WF_SENSOR_STRAIN || w->kind == WF_SENSOR_EXTENSION;
            if (gauge && t->tree.section)
                return wf_fail(e, WF_EINPUT,
                               "%s: test %s: %s: strain is not computed for a stem with 'sections'",
                               b->calibration->file, q->name, w->name);
            if (!wf_sensor_rows[w->kind].placed || places) continue;
            status = place(list, &n, w->height + (gauge ? 0.5 * w->gauge : 0), w->along, &w->row, t->name, e);
            if (gauge && !status)
                status =
                    place(list, &n, fmax(w->height - 0.5 * w->gauge, 0), w->along, &w->low_row, t->name, e);
        }
    }
    for (size_t k = 0; k < n; k++) at[k] = list[k].at;
    struct wf_err why = { 0 };
    if (!status && wf_fit_divide(&t->tree, t->size / 40, at, n, row, a, &why))
        return wf_fail(e, why.code, "%s: tree %s: %s", b->calibration->file, t->name, why.text);
    for (size_t k = 0; k < n && !status; k++) *list[k].row = row[k];
    return status;
}

/* Weight alone does not bend a tree that stands in its shape with the leaves it had then. */
static enum wf_status check_weight(const struct wf_fit_build *b, const struct wf_experiment *x, size_t index,
                                   struct wf_err *e)
{
    const struct wf_fit_test *t = &x->test[index];
    const struct wf_fit_tree *tree = &x->tree[t->tree];
    bool read = false;
    for (size_t k = 0; k < t->sensors; k++) read = read || t->sensor[k].kind != WF_SENSOR_MOMENT;
    if (t->load != WF_FIT_WEIGHT || !read || !tree->props || !wf_fit_tree_unchanged(tree)) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: test %s: tree %s stands in its shape (rest: as-drawn), so its weight alone bends it "
                   "no further and these readings tell nothing of its wood; 'rest: stress-free' takes the "
                   "shape as unloaded",
                   b->calibration->file, t->name, tree->name);
}

enum wf_status wf_fit_build(const struct wf_fit_build *b, struct wf_arena *a, struct wf_diag *d,
                            struct wf_experiment *x, struct wf_fit_input *in, struct wf_err *e)
{
    const struct wf_calibration *s = b->calibration;
    size_t used = 0, room = 0;
    *x = (struct wf_experiment){ .trees = s->trees, .tests = s->tests };
    x->tree = WF_TAKE(a, s->trees, struct wf_fit_tree), x->test = WF_TAKE(a, s->tests, struct wf_fit_test);
    if (!x->tree || !x->test) return wf_fail(e, WF_ENOMEM, "%s: not enough memory", s->file);
    enum wf_status status = WF_OK;
    for (size_t k = 0; k < s->trees && !status; k++)
        status = wf_fit_tree_build(s, k, b->share, b->mat, a, d, &x->tree[k], e);
    for (size_t k = 0; k < s->tests && !status; k++) {
        const char *named = s->test[k].data;
        bool wants = s->test[k].along ||
                     (!b->plan && (s->test[k].pull.given || s->test[k].wind.given || s->test[k].sway.given));
        if (wants && !named && used < b->datas) named = b->data[used++];
        if (wants && !named)
            return wf_fail(e, WF_EUSAGE, "%s: test %s names no data; give it with --data FILE", s->file,
                           s->test[k].name);
        struct wf_fit_datum *data = NULL;
        size_t n = 0;
        status = fit_build_test(b, k, wants ? named : NULL, a, d, &x->test[k], &in[k], &data, &n, e);
        if (!status) status = scene_of(b, k, &x->tree[x->test[k].tree], a, d, &x->test[k], &in[k], e);
        if (status) break;
        if (x->data + n > room) {
            room = 2 * (x->data + n);
            struct wf_fit_datum *more = WF_TAKE(a, room, struct wf_fit_datum);
            if (!more) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its data", s->file);
            if (x->data) memcpy(more, x->datum, x->data * sizeof *more);
            x->datum = more;
        }
        for (size_t i = 0; i < n; i++) {
            data[i].test = k;
            x->datum[x->data++] = data[i];
        }
    }
    if (!status && used < b->datas)
        return wf_fail(e, WF_EUSAGE, "--data: '%s' is not needed: every test of %s names its own data",
                       b->data[used], s->file);
    for (size_t k = 0; k < s->trees && !status; k++) status = cut(b, x, k, a, e);
    for (size_t k = 0; k < s->trees && !status; k++) status = wf_tree_check(&x->tree[k].tree, d, e);
    for (size_t k = 0; k < s->trees && !status; k++) status = wf_fit_tree_prop(&x->tree[k], a, e);
    for (size_t k = 0; k < s->tests && !status; k++) status = check_weight(b, x, k, e);
    return status;
}

static enum wf_status bound(struct wf_units *u, const struct wf_calibration *s, const struct wf_fit_param *p,
                            const char *key, const char *text, double *value, struct wf_err *e)
{
    struct wf_err why = { 0 };
    const struct wf_fit_quantity_row *r = &wf_fit_quantities[p->quantity];
    if (!text || !wf_quantity_read_as(u, text, r->dimension, r->unit, value, &why)) return WF_OK;
    return wf_fail(e, why.code, "%s: free: %s: %s: %s", s->file, p->name, key, why.text);
}

enum wf_status wf_fit_params(const struct wf_calibration *s, const char *names, const struct wf_experiment *x,
                             bool plan, struct wf_arena *a, struct wf_fit_param **out, size_t *n,
                             struct wf_err *e)
{
    struct wf_units *u;
    char *list = names ? wf_arena_text(a, names) : NULL, *rest = NULL;
    size_t count = s->frees;
    for (const char *c = names; c && *c; c++) count += *c == ',';
    *n = 0;
    *out = WF_TAKE(a, (count + 1) * x->trees + wf_param_nuisances(x), struct wf_fit_param);
    if (!*out || (names && !list))
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for parameters", s->file);
    enum wf_status status = WF_OK;
    for (char *p = list ? strtok_r(list, ", ", &rest) : NULL; p && !status; p = strtok_r(NULL, ", ", &rest))
        status = wf_param_add(x, p, a, *out, n, e);
    if (!status) status = wf_units_open(&u, e);
    if (status) return status;
    /* bounds of the calibration also apply to a parameter named on the command line */
    for (size_t k = 0; k < s->frees && !status; k++) {
        size_t from = *n, to;
        if (!names) status = wf_param_add(x, s->free[k].parameter, a, *out, n, e);
        to = *n;
        for (size_t i = names ? 0 : from; i < to && !status; i++) {
            struct wf_fit_param *p = &(*out)[i];
            if (names && strcmp(p->name, s->free[k].parameter) != 0) continue;
            double table = p->start;
            status = bound(u, s, p, "start", s->free[k].start, &p->start, e);
            if (plan) p->start = table;
            if (!status) status = bound(u, s, p, "low", s->free[k].low, &p->low, e);
            if (!status) status = bound(u, s, p, "high", s->free[k].high, &p->high, e);
            if (!status && wf_fit_quantities[p->quantity].log && !(p->low > 0 && p->start > 0))
                status = wf_fail(e, WF_EINPUT, "%s: free: %s: start and bounds must be above zero", s->file,
                                 p->name);
        }
    }
    wf_units_close(u);
    return status ? status : wf_param_add_nuisance(x, a, *out, n, e);
}
