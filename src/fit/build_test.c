/* One test: its sensors, the states it went through, and what was read. */
#include "fit/build.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Sigma of a reading: absolute and relative parts add in squares. */
static double sigma_of(const struct wf_fit_sensor *s, double value)
{
    return s->estimated ? 1 : hypot(s->sigma, s->sigma_share * value);
}

static enum wf_status sensor(struct wf_units *u, const struct wf_fit_study *study,
                             const struct wf_study_test *t, const struct wf_study_sensor *s,
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
        return wf_fail(e, WF_EINPUT, "%s: test %s: %s: sigma: %s", study->file, t->name, s->name, why.text);
    if (s->sigma && !(out->sigma > 0))
        return wf_fail(e, WF_EINPUT, "%s: test %s: %s: sigma must be above zero", study->file, t->name,
                       s->name);
    if (s->value && wf_quantity_read_as(u, s->value, r->dimension, r->unit, value, &why))
        return wf_fail(e, WF_EINPUT, "%s: test %s: %s: value: %s", study->file, t->name, s->name, why.text);
    return WF_OK;
}

static void load_of(const struct wf_study_test *s, struct wf_fit_test *t, struct wf_fit_input *in)
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
        t->wind = (struct wf_wind){ .sample = wf_profile_named(s->wind.profile)->sample,
                                    .direction = { cos(s->wind.azimuth), sin(s->wind.azimuth), 0 },
                                    .reference_height = s->wind.reference_height,
                                    .roughness = s->wind.roughness,
                                    .exponent = s->wind.exponent };
        in->load_name = "wind", in->load_unit = "m/s", in->load_factor = 1;
    } else if (t->load == WF_FIT_WEIGHT) {
        in->load_name = s->along ? "along the axis" : "weight", in->load_unit = s->along ? "m" : "";
    }
}

/* Average neighbouring used rows down to `points` states. */
static enum wf_status average(const struct wf_study_test *s, struct wf_fit_test *t,
                              const struct wf_fit_record *r, const double *sign, struct wf_arena *a,
                              struct wf_fit_datum **data, size_t *n, struct wf_err *e)
{
    size_t used = 0, m = r->columns;
    for (size_t i = 0; i < r->n; i++) used += r->used[i];
    t->states = used < s->points ? used : s->points;
    t->state = WF_TAKE(a, t->states, struct wf_fit_state);
    *data = WF_TAKE(a, t->states * t->sensors, struct wf_fit_datum);
    double *sum = WF_TAKE(a, m, double);
    if (!t->state || !*data || !sum) return wf_fail(e, WF_ENOMEM, "no room for test %s", t->name);
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

static enum wf_status windows(const struct wf_study_test *s, struct wf_fit_record *r, struct wf_err *e)
{
    size_t left = 0;
    for (size_t i = 0; i < r->n; i++) {
        if (r->time[i] < s->after || r->time[i] > s->until) r->used[i] = false; /* NAN: no limit */
        left += r->used[i];
    }
    return left ? WF_OK : wf_fail(e, WF_EINPUT, "test %s: no row between 'after' and 'until'", s->name);
}

static enum wf_status sensor_columns(const struct wf_fit_build *b, const struct wf_study_test *s,
                                     struct wf_record_column *column, struct wf_err *e)
{
    for (size_t k = 0; k < s->sensors; k++) {
        const struct wf_study_sensor *q = &s->sensor[k];
        column[k] = (struct wf_record_column){ q->column, q->unit, wf_sensor_rows[q->kind].dimension };
        if (!q->column)
            return wf_fail(e, WF_EINPUT, "%s: test %s: sensor %s names no column", b->study->file, s->name,
                           q->name);
    }
    return WF_OK;
}

static enum wf_status from_file(const struct wf_fit_build *b, const struct wf_study_test *s, const char *path,
                                const double *sign, struct wf_arena *a, struct wf_diag *d,
                                struct wf_fit_test *t, struct wf_fit_input *in, struct wf_fit_datum **data,
                                size_t *n, struct wf_err *e)
{
    struct wf_record_column *column = WF_TAKE(a, s->sensors + 1, struct wf_record_column);
    if (!column) return wf_fail(e, WF_ENOMEM, "no room for the columns of %s", path);
    bool wind = s->wind.given;
    column[0] =
        (struct wf_record_column){ wind ? s->wind.column : s->pull.column, wind ? s->wind.unit : s->pull.unit,
                                   wind ? WF_DIM_SPEED : WF_DIM_FORCE };
    if (!column[0].name)
        return wf_fail(e, WF_EINPUT, "%s: test %s: the %s names no column", b->study->file, s->name,
                       in->load_name);
    enum wf_status status = sensor_columns(b, s, column + 1, e);
    if (!status) status = wf_fit_path(b->study, path, a, &in->path, e);
    if (!status)
        status = wf_fit_record_read(in->path, column, s->sensors + 1, s->time, s->rows, s->rows_n, a,
                                    &in->record, d, e);
    if (!status) status = windows(s, &in->record, e);
    if (!status && !wind) status = wf_loading_branch(&in->record, 0, s->pull.from, s->pull.to, s->name, e);
    if (status) return status;
    if (in->record.missing)
        wf_diag_warn(d, "rows-missing", "%s: test %s: %zu rows with an empty or NA cell were left out",
                     in->path, s->name, in->record.missing);
    double most = 0;
    for (size_t i = 0; i < in->record.n; i++)
        most = fmax(most, fabs(in->record.value[i * in->record.columns]));
    if (!(most > 0))
        return wf_fail(e, WF_EINPUT, "test %s: the %s is zero throughout", s->name, in->load_name);
    return average(s, t, &in->record, sign, a, data, n, e);
}

/* Rows are places along the axis: each is a state of its own, in which every sensor sits there. */
static enum wf_status from_places(const struct wf_fit_build *b, const struct wf_study_test *s,
                                  const char *path, const double *sign, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_fit_test *t, struct wf_fit_input *in, struct wf_fit_datum **data,
                                  size_t *n, struct wf_err *e)
{
    struct wf_record_column *column = WF_TAKE(a, s->sensors + 1, struct wf_record_column);
    struct wf_fit_record r;
    if (!column) return wf_fail(e, WF_ENOMEM, "no room for the columns of %s", path);
    column[0] = (struct wf_record_column){ s->along, NULL, WF_DIM_LENGTH };
    enum wf_status status = sensor_columns(b, s, column + 1, e);
    if (!status) status = wf_fit_path(b->study, path, a, &in->path, e);
    if (!status)
        status = wf_fit_record_read(in->path, column, s->sensors + 1, NULL, s->rows, s->rows_n, a, &r, d, e);
    if (status) return status;
    t->state = WF_TAKE(a, r.n, struct wf_fit_state);
    *data = WF_TAKE(a, r.n * t->sensors, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "no room for test %s", s->name);
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

/* Frequency and damping from a record of free sway become two readings. */
static enum wf_status from_sway(const struct wf_fit_build *b, const struct wf_study_test *s, const char *path,
                                struct wf_arena *a, struct wf_diag *d, struct wf_fit_test *t,
                                struct wf_fit_input *in, struct wf_fit_datum **data, size_t *n,
                                struct wf_err *e)
{
    struct wf_record_column column = { s->sway.column, NULL, WF_DIM_NONE };
    struct wf_err why = { 0 };
    enum wf_status status = wf_fit_path(b->study, path, a, &in->path, e);
    if (!status)
        status = wf_fit_record_read(in->path, &column, 1, s->time, s->rows, s->rows_n, a, &in->record, d, e);
    if (!status) status = windows(s, &in->record, e);
    if (status) return status;
    struct wf_fit_record *r = &in->record;
    double *time = WF_TAKE(a, r->n, double), *y = WF_TAKE(a, r->n, double);
    size_t m = 0;
    t->sensor = WF_TAKE(a, 2, struct wf_fit_sensor), t->state = WF_TAKE(a, 1, struct wf_fit_state);
    *data = WF_TAKE(a, 2, struct wf_fit_datum);
    if (!time || !y || !t->sensor || !t->state || !*data)
        return wf_fail(e, WF_ENOMEM, "no room for test %s", s->name);
    for (size_t i = 0; i < r->n; i++)
        if (r->used[i]) time[m] = r->time[i], y[m++] = r->value[i];
    if (wf_ring_down(time, y, m, a, &in->sway, &why))
        return wf_fail(e, why.code, "test %s: %s", s->name, why.text);
    in->swung = true;
    t->sensors = 2, t->states = 1;
    t->sensor[0] = (struct wf_fit_sensor){ .name = "frequency",
                                           .kind = WF_SENSOR_FREQUENCY,
                                           .azimuth = s->sway.azimuth,
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
    if (in->sway.explained < 0.8)
        wf_diag_warn(d, "poor-sway", "test %s: one damped sway explains only %.0f %% of the record", s->name,
                     100 * in->sway.explained);
    return WF_OK;
}

/* States of a plan; values stay open. */
static enum wf_status planned(const struct wf_study_test *s, struct wf_arena *a, struct wf_fit_test *t,
                              struct wf_fit_datum **data, size_t *n, struct wf_err *e)
{
    const double *load = s->pull.given ? s->pull.load : s->wind.speed;
    t->states = s->pull.given ? s->pull.loads : s->wind.speeds;
    if (!t->states)
        return wf_fail(e, WF_EINPUT, "test %s: a plan needs %s", s->name,
                       s->pull.given ? "'loads' in 'pull'" : "'speeds' in 'wind'");
    t->state = WF_TAKE(a, t->states, struct wf_fit_state),
    *data = WF_TAKE(a, t->states * t->sensors, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "no room for test %s", s->name);
    for (size_t i = 0; i < t->states; i++) {
        t->state[i] = (struct wf_fit_state){ .load = load[i], .time = (double)i, .rows = 1 };
        for (size_t k = 0; k < t->sensors; k++)
            (*data)[(*n)++] =
                (struct wf_fit_datum){ .state = i, .sensor = k, .value = NAN, .sigma = 1, .weight = 1 };
    }
    return WF_OK;
}

enum wf_status wf_fit_build_test(const struct wf_fit_build *b, size_t index, const char *path,
                                 struct wf_arena *a, struct wf_diag *d, struct wf_fit_test *t,
                                 struct wf_fit_input *in, struct wf_fit_datum **data, size_t *n,
                                 struct wf_err *e)
{
    const struct wf_study_test *s = &b->study->test[index];
    struct wf_units *u;
    double value, *sign = WF_TAKE(a, s->sensors + 1, double), *given = WF_TAKE(a, s->sensors + 1, double);
    *t = (struct wf_fit_test){
        .name = s->name, .tree = b->study->trees, .sensors = s->sensors, .pull_row = -1
    };
    *in = (struct wf_fit_input){ .load_name = "free sway", .load_unit = "", .load_factor = 1 };
    t->sensor = WF_TAKE(a, s->sensors + 2, struct wf_fit_sensor);
    if (!sign || !given || !t->sensor) return wf_fail(e, WF_ENOMEM, "no room for test %s", s->name);
    for (size_t k = 0; k < b->study->trees; k++)
        if (!s->tree || !strcmp(s->tree, b->study->tree[k].name)) t->tree = k;
    if (t->tree == b->study->trees)
        return wf_fail(e, WF_EINPUT, "%s: test %s: no tree is called '%s'", b->study->file, s->name, s->tree);
    load_of(s, t, in);
    enum wf_status status = wf_units_open(&u, e);
    if (status) return status;
    for (size_t k = 0; k < s->sensors && !status; k++) {
        sign[k] = s->sensor[k].sign ? -1 : 1;
        status = sensor(u, b->study, s, &s->sensor[k], &t->sensor[k], &given[k], e);
    }
    wf_units_close(u);
    if (status) return status;
    if (s->sway.given && !b->plan) return from_sway(b, s, path, a, d, t, in, data, n, e);
    if (s->pull.given || s->wind.given)
        return b->plan ? planned(s, a, t, data, n, e) : from_file(b, s, path, sign, a, d, t, in, data, n, e);
    if (s->along && path) return from_places(b, s, path, sign, a, d, t, in, data, n, e);
    if (s->along) return wf_fail(e, WF_EINPUT, "test %s: its places are read from 'data'", s->name);
    t->states = 1;
    t->state = WF_TAKE(a, 1, struct wf_fit_state), *data = WF_TAKE(a, s->sensors + 1, struct wf_fit_datum);
    if (!t->state || !*data) return wf_fail(e, WF_ENOMEM, "no room for test %s", s->name);
    t->state[0].row = -2;
    for (size_t k = 0; k < s->sensors; k++) {
        value = b->plan ? (double)NAN : given[k];
        (*data)[(*n)++] = (struct wf_fit_datum){
            .sensor = k, .value = value, .weight = 1, .sigma = sigma_of(&t->sensor[k], value)
        };
    }
    return WF_OK;
}
