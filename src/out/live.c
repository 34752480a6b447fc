/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/live.h"
#include "base/csv.h"
#include "base/num.h"
#include "out/doc.h"
#include "out/page_units.h"
#include <math.h>
#include <string.h>

enum { POINTS = 20000, TREES = 64 }; /* points of shapes that a page carries: about 0.5 MB */

static double value_of(const json_t *o, const char *key)
{
    const json_t *x = json_object_get(json_object_get(o, key), "value");
    return json_is_number(x) ? json_number_value(x) : NAN;
}

static const char *text_of(const json_t *o, const char *key)
{
    return json_string_value(json_object_get(o, key));
}

/* A length to 0.1 mm; 0 where there is none. */
static double rounded(double x) { return isfinite(x) ? round(x * 1e4) / 1e4 : 0; }

/* Numbers of a wind, as the first table of the page gives them: movement in the mean wind, the rest at the
 * peak. */
static json_t *wind_part(struct wf_doc *d, const json_t *wind, double gust)
{
    const json_t *mean = json_object_get(wind, "mean_state");
    json_t *o = wf_doc_object(d);
    wf_doc_number(d, o, "speed", value_of(wind, "speed"));
    wf_doc_number(d, o, "gust", gust * value_of(wind, "speed"));
    wf_doc_number(d, o, "tip", value_of(json_is_object(mean) ? mean : wind, "tip_deflection"));
    wf_doc_number(d, o, "top", value_of(json_is_object(mean) ? mean : wind, "top_deflection"));
    wf_doc_number(d, o, "moment", value_of(wind, "base_moment") / 1e3);
    wf_doc_number(d, o, "breakage", value_of(wind, "least_safety"));
    wf_doc_number(d, o, "safety", value_of(wind, "loss_safety"));
    wf_doc_put(d, o, "axes", wf_doc_array(d));
    return o;
}

/* What the table of directions says of each: where the wind comes from [deg], the wind in which the tree is
 * lost, moment and safety in the strongest wind. */
static json_t *around_part(struct wf_doc *d, const json_t *directions)
{
    json_t *list = wf_doc_array(d), *x;
    size_t i;
    json_array_foreach(json_object_get(directions, "directions"), i, x)
    {
        const json_t *winds = json_object_get(x, "winds"),
                     *last = json_array_get(winds, json_array_size(winds) - 1);
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_number(d, o, "from", value_of(x, "from") * 180 / M_PI);
        const json_t *loss = json_object_get(x, "loss");
        const char *outcome = text_of(loss, "outcome");
        bool still = outcome && !strcmp(outcome, "self-weight");
        wf_doc_number(d, o, "lost", still ? 0 : value_of(loss, "critical_speed"));
        wf_doc_number(d, o, "moment", value_of(last, "base_moment") / 1e3);
        wf_doc_number(d, o, "safety", value_of(last, "loss_safety"));
    }
    return list;
}

static json_t *tree_part(struct wf_doc *d, const json_t *tree)
{
    const json_t *scenario = json_object_get(tree, "scenario"), *x;
    double lost = value_of(json_object_get(tree, "verdict"), "critical_speed");
    json_t *o = wf_doc_object(d);
    wf_doc_number(d, o, "lost", lost);
    wf_doc_put(d, o, "still", wf_doc_array(d));
    wf_doc_put(d, o, "around", around_part(d, json_object_get(tree, "directions")));
    json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    size_t i;
    json_array_foreach(json_object_get(tree, "winds"), i, x)
    {
        const char *status = text_of(x, "status");
        if (status && !strcmp(status, "ok"))
            wf_doc_add(d, winds, wind_part(d, x, value_of(scenario, "gust_over_mean")));
    }
    return o;
}

/* Where a row of the table belongs: the wind of its tree. NULL: none. */
static json_t *wind_of(json_t *tree, double speed, bool *first)
{
    json_t *winds = json_object_get(tree, "winds"), *x;
    size_t i;
    json_array_foreach(winds, i, x)
    {
        *first = i == 0;
        if (fabs(json_number_value(json_object_get(x, "speed")) - speed) <= 1e-9 * (1 + speed)) return x;
    }
    return NULL;
}

static void add_point(struct wf_doc *d, json_t *axes, bool begins, double along, double z)
{
    if (begins || !json_array_size(axes)) wf_doc_add(d, axes, wf_doc_array(d));
    json_t *p = wf_doc_add(d, json_array_get(axes, json_array_size(axes) - 1), wf_doc_array(d));
    wf_doc_add(d, p, json_real(rounded(along)));
    wf_doc_add(d, p, json_real(rounded(z)));
}

struct columns {
    size_t tree, wind, axis, segment, at[6]; /* x, y, z, loaded x, y, z */
};

static enum wf_status open_shapes(struct wf_csv *c, const char *path, struct wf_arena *a,
                                  struct wf_diag *diag, struct columns *k, struct wf_err *e)
{
    static const char *const name[] = { "x_m", "y_m", "z_m", "loaded_x_m", "loaded_y_m", "loaded_z_m" };
    if (wf_csv_open(c, path, a, diag, e)) return e->code;
    *k = (struct columns){ wf_csv_need(c, "tree"),
                           wf_csv_need(c, "wind_m_s"),
                           wf_csv_need(c, "axis"),
                           wf_csv_need(c, "segment"),
                           { 0 } };
    for (size_t i = 0; i < 6; i++) k->at[i] = wf_csv_need(c, name[i]);
    return diag->errors ? wf_fail(e, WF_EINPUT, "%s: is no table of shapes", path) : WF_OK;
}

/* Put the points of the table where they belong; those of branches only where `all`. Returned: *n rows. */
static enum wf_status read_shapes(const char *path, const json_t *results, json_t *trees, bool all,
                                  bool count, struct wf_doc *d, size_t *n, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag diag = { .arena = &a };
    struct wf_csv c;
    struct columns k = { 0 };
    enum wf_status s = open_shapes(&c, path, &a, &diag, &k, e);
    for (*n = 0; !s && wf_csv_next(&c);) {
        double tree, wind, axis, segment, at[6];
        bool read = wf_csv_number(&c, k.tree, 1, 1e6, &tree) && wf_csv_number(&c, k.wind, 0, 1e3, &wind) &&
                    wf_csv_number(&c, k.axis, 1, 1e9, &axis) &&
                    wf_csv_number(&c, k.segment, 0, 1e9, &segment),
             first = false;
        for (size_t i = 0; i < 6 && read; i++) read = wf_csv_number(&c, k.at[i], -1e6, 1e6, &at[i]);
        if (!read) s = wf_fail(e, WF_EINPUT, "%s: is no table of shapes", path);
        *n += 1;
        if (s || count || (!all && axis > 1)) continue;
        json_t *to = json_array_get(trees, (size_t)tree - 1), *in = wind_of(to, wind, &first);
        const json_t *from = json_array_get(json_object_get(results, "trees"), (size_t)tree - 1);
        double azimuth = value_of(json_object_get(from, "scenario"), "azimuth"), u = cos(azimuth),
               v = sin(azimuth);
        if (!in) continue;
        add_point(d, json_object_get(in, "axes"), segment < 1, u * at[3] + v * at[4], at[5]);
        if (first) add_point(d, json_object_get(to, "still"), segment < 1, u * at[0] + v * at[1], at[2]);
    }
    wf_arena_free(&a);
    return s;
}

/* What numbers are multiplied with and called: {"m/s": [2.24, "mph"], ...}; empty in metric units. */
static json_t *units_part(struct wf_doc *d, const char *units)
{
    json_t *o = wf_doc_object(d);
    const struct wf_page_unit *u;
    for (size_t i = 0; (u = wf_page_unit_row(units, i))->from; i++) {
        json_t *pair = wf_doc_put(d, o, u->from, wf_doc_array(d));
        wf_doc_add(d, pair, json_real(u->factor));
        wf_doc_add(d, pair, json_string(u->to));
    }
    return o;
}

/* Where the columns of the key frames stand: run, key, time, wind, level, base and end (along, z). */
struct frame_columns {
    size_t run, key, time, wind, level, at[4];
};

static enum wf_status open_frames(struct wf_csv *c, const char *path, struct wf_arena *a,
                                  struct wf_diag *diag, struct frame_columns *k, struct wf_err *e)
{
    static const char *const name[] = { "along0_m", "z0_m", "along1_m", "z1_m" };
    if (wf_csv_open(c, path, a, diag, e)) return e->code;
    *k =
        (struct frame_columns){ wf_csv_need(c, "run"),      wf_csv_need(c, "key"),   wf_csv_need(c, "time_s"),
                                wf_csv_need(c, "wind_m_s"), wf_csv_need(c, "level"), { 0 } };
    for (size_t i = 0; i < 4; i++) k->at[i] = wf_csv_need(c, name[i]);
    return diag->errors ? wf_fail(e, WF_EINPUT, "%s: is no table of key frames", path) : WF_OK;
}

/* The frame of that number, the next one made if need be. NULL: no run that is shown, or a frame is left out.
 */
static json_t *frame_of(struct wf_doc *d, json_t *runs, double run, double key, double time, double wind)
{
    json_t *keys = json_object_get(json_array_get(runs, (size_t)run - 1), "keys");
    if (keys && (size_t)key == json_array_size(keys)) {
        json_t *o = wf_doc_add(d, keys, wf_doc_object(d));
        wf_doc_number(d, o, "time", time);
        wf_doc_number(d, o, "wind", wind);
        wf_doc_put(d, o, "lines", wf_doc_array(d));
    }
    return json_array_get(keys, (size_t)key);
}

/* Segments of the key frames into their runs, the stem's alone where `stem`; with runs NULL they are counted:
 * n[0] all, n[1] those of stems. */
static enum wf_status read_frames(const char *path, json_t *runs, bool stem, struct wf_doc *d, size_t n[2],
                                  struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag diag = { .arena = &a };
    struct wf_csv c;
    struct frame_columns k = { 0 };
    enum wf_status s = open_frames(&c, path, &a, &diag, &k, e);
    while (!s && wf_csv_next(&c)) {
        double run, key, time, wind, level, at[4];
        bool read = wf_csv_number(&c, k.run, 1, 1e6, &run) && wf_csv_number(&c, k.key, 0, 1e6, &key) &&
                    wf_csv_number(&c, k.time, 0, 1e9, &time) && wf_csv_number(&c, k.wind, -1e3, 1e3, &wind) &&
                    wf_csv_number(&c, k.level, 0, 1e3, &level);
        for (size_t i = 0; i < 4 && read; i++) read = wf_csv_number(&c, k.at[i], -1e6, 1e6, &at[i]);
        if (!read) s = wf_fail(e, WF_EINPUT, "%s: is no table of key frames", path);
        if (s || !runs) {
            if (!s) n[0]++, n[1] += level < 1;
            continue;
        }
        json_t *frame = stem && level >= 1 ? NULL : frame_of(d, runs, run, key, time, wind);
        for (size_t i = 0; frame && i < 4; i++)
            wf_doc_add(d, json_object_get(frame, "lines"), json_real(rounded(at[i])));
    }
    wf_arena_free(&a);
    return s;
}

/* A cell that may be empty. */
static double cell(struct wf_csv *c, size_t column)
{
    double x;
    return column != WF_CSV_NONE && wf_csv_value(c, column, &x) == WF_CSV_NUMBER ? x : NAN;
}

/* Numbers of the key frames, from the table of all frames: both are in the order of time. */
static enum wf_status read_series(const char *path, json_t *runs, struct wf_doc *d, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag diag = { .arena = &a };
    struct wf_csv c;
    size_t next[TREES];
    enum wf_status s = wf_csv_open(&c, path, &a, &diag, e);
    if (s) return wf_arena_free(&a), s;
    size_t in = wf_csv_need(&c, "run"), when = wf_csv_need(&c, "time_s"),
           tip = wf_csv_need(&c, "tip_deflection_m"), moment = wf_csv_need(&c, "base_moment_N_m"),
           safety = wf_csv_column(&c, "safety"), beyond = wf_csv_column(&c, "beyond_breakage");
    if (diag.errors) s = wf_fail(e, WF_EINPUT, "%s: is no table of frames", path);
    for (size_t i = 0; i < TREES; i++) next[i] = 1; /* 0 is the unloaded tree */
    while (!s && wf_csv_next(&c)) {
        double run = cell(&c, in), time = cell(&c, when);
        if (!(run >= 1 && run <= TREES)) continue;
        json_t *keys = json_object_get(json_array_get(runs, (size_t)run - 1), "keys"), *o;
        while ((o = json_array_get(keys, next[(size_t)run - 1])) &&
               json_number_value(json_object_get(o, "time")) <= time) {
            wf_doc_number(d, o, "tip", cell(&c, tip));
            wf_doc_number(d, o, "moment", cell(&c, moment) / 1e3);
            wf_doc_number(d, o, "safety", cell(&c, safety));
            wf_doc_flag(d, o, "broken", cell(&c, beyond) > 0);
            next[(size_t)run - 1]++;
        }
    }
    wf_arena_free(&a);
    return s;
}

/* The runs of a document in time that have several key frames; `runs` stays empty where the page would become
 * too heavy even with stems alone. */
static enum wf_status frames_part(struct wf_doc *d, json_t *o, const char *folder, const json_t *results,
                                  struct wf_err *e)
{
    char path[WF_PATH_MAX], all[WF_PATH_MAX];
    size_t n[2] = { 0 }, i;
    json_t *runs = wf_doc_put(d, o, "runs", wf_doc_array(d)), *x;
    enum wf_status s = wf_folder_path(folder, "tables/frames.csv", path, e);
    if (!s) s = wf_folder_path(folder, "tables/series.csv", all, e);
    if (!s) s = read_frames(path, NULL, false, d, n, e);
    if (s || n[1] > POINTS / 2) return s;
    json_array_foreach(json_object_get(results, "runs"), i, x) if (i < TREES)
    {
        json_t *run = wf_doc_add(d, runs, wf_doc_object(d));
        if (json_number_value(json_object_get(x, "keys")) > 1) wf_doc_put(d, run, "keys", wf_doc_array(d));
    }
    wf_doc_flag(d, o, "stems", n[0] > POINTS / 2);
    s = read_frames(path, runs, n[0] > POINTS / 2, d, n, e);
    return s ? s : read_series(all, runs, d, e);
}

static enum wf_status trees_part(struct wf_doc *d, json_t *o, const char *folder, const json_t *results,
                                 struct wf_err *e)
{
    char path[WF_PATH_MAX];
    json_t *trees = wf_doc_put(d, o, "trees", wf_doc_array(d)), *x;
    size_t i, n = 0, rows;
    json_array_foreach(json_object_get(results, "trees"), i, x) if (i < TREES)
        wf_doc_add(d, trees, tree_part(d, x));
    enum wf_status s = wf_folder_path(folder, "tables/shape.csv", path, e);
    if (!s) s = read_shapes(path, results, trees, false, true, d, &n, e);
    return s ? s : read_shapes(path, results, trees, n <= POINTS, false, d, &rows, e);
}

/* ---- Rain ---- */

/* What key frames of rain are of, and the lines of their scene. */
static const char *const rain_events[] = { "hit", "wood", "ran", "merged", "hung", "fell", "rebound", "end" };
static const char *const rain_lines[] = { "branch", "petiole", "edge", "vein" };

/* The row of that name; NULL: none. */
static const char *named(const char *const *row, size_t n, const char *name)
{
    for (size_t i = 0; i < n; i++)
        if (!strcmp(row[i], name)) return row[i];
    return NULL;
}

enum { COLUMNS = 8 };
struct table {
    struct wf_csv c;
    struct wf_arena a;
    struct wf_diag diag;
    size_t column[COLUMNS]; /* first run and, but of the course in time, key */
};

/* Open FOLDER/tables/NAME.csv with these columns; closed by wf_arena_free(&t->a). */
static enum wf_status open_table(struct table *t, const char *folder, const char *name, const char *columns,
                                 struct wf_err *e)
{
    char path[WF_PATH_MAX], file[64], one[32];
    *t = (struct table){ .diag = { .arena = &t->a } };
    snprintf(file, sizeof file, "tables/%s.csv", name);
    enum wf_status s = wf_folder_path(folder, file, path, e);
    const char *kept = s ? NULL : wf_arena_text(&t->a, path);
    if (!s && !kept) s = wf_fail(e, WF_ENOMEM, "no memory for %s", path);
    if (!s) s = wf_csv_open(&t->c, kept, &t->a, &t->diag, e);
    for (int n = 0, at = 0, i = 0; !s && sscanf(columns + at, "%31s%n", one, &n) == 1; at += n)
        t->column[i++] = wf_csv_need(&t->c, one);
    return s || !t->diag.errors ? s : wf_fail(e, WF_EINPUT, "%s: is no table of rain", kept);
}

static const char rain_scene[] = "run key kind x0_m z0_m x1_m z1_m";

/* Lines of the scene: n[0] all, n[1] without the veins of leaves. */
static enum wf_status count_lines(const char *folder, size_t n[2], struct wf_err *e)
{
    struct table t;
    enum wf_status s = open_table(&t, folder, "scene", rain_scene, e);
    while (!s && wf_csv_next(&t.c)) n[0]++, n[1] += strcmp(wf_csv_text(&t.c, t.column[2]), "vein") != 0;
    wf_arena_free(&t.a);
    return s;
}

/* The key frame that a row is of, counted from 1; NULL: of no run that is shown. */
static json_t *key_of(json_t *runs, struct table *t)
{
    double run = cell(&t->c, t->column[0]), key = cell(&t->c, t->column[1]);
    if (!(run >= 1 && run <= TREES && key >= 1 && key <= POINTS)) return NULL;
    json_t *of = json_array_get(runs, (size_t)run - 1);
    return json_array_get(json_object_get(of, "keys"), (size_t)key - 1);
}

static enum wf_status read_keys(const char *folder, json_t *runs, struct wf_doc *d, struct wf_err *e)
{
    struct table t;
    enum wf_status s = open_table(&t, folder, "keys", "run key event time_s leaf drops", e);
    while (!s && wf_csv_next(&t.c)) {
        double run = cell(&t.c, t.column[0]);
        const char *event = named(rain_events, WF_COUNT(rain_events), wf_csv_text(&t.c, t.column[2]));
        json_t *keys =
            run >= 1 && run <= TREES ? json_object_get(json_array_get(runs, (size_t)run - 1), "keys") : NULL;
        if (!keys || !event || json_array_size(keys) >= POINTS) continue;
        json_t *o = wf_doc_add(d, keys, wf_doc_object(d));
        wf_doc_text(d, o, "event", event);
        wf_doc_number(d, o, "time", cell(&t.c, t.column[3]));
        wf_doc_number(d, o, "leaf", cell(&t.c, t.column[4]));
        wf_doc_number(d, o, "drops", cell(&t.c, t.column[5]));
        for (size_t i = 0; i < WF_COUNT(rain_lines); i++) wf_doc_put(d, o, rain_lines[i], wf_doc_array(d));
        wf_doc_put(d, o, "air", wf_doc_array(d));
    }
    wf_arena_free(&t.a);
    return s;
}

/* A place to 0.01 mm: leaves move little. */
static json_t *place(double x) { return json_real(isfinite(x) ? round(x * 1e5) / 1e5 : 0); }

static enum wf_status read_scene(const char *folder, json_t *runs, bool veins, struct wf_doc *d,
                                 struct wf_err *e)
{
    struct table t;
    enum wf_status s = open_table(&t, folder, "scene", rain_scene, e);
    while (!s && wf_csv_next(&t.c)) {
        const char *kind = named(rain_lines, WF_COUNT(rain_lines) - !veins, wf_csv_text(&t.c, t.column[2]));
        json_t *to = kind ? json_object_get(key_of(runs, &t), kind) : NULL;
        for (size_t i = 3; to && i < 7; i++) wf_doc_add(d, to, place(cell(&t.c, t.column[i])));
    }
    wf_arena_free(&t.a);
    if (s) return s;
    /* drops in the air: where they are, and where they were 4 ms before */
    s = open_table(&t, folder, "air", "run key x_m z_m vx_m_s vz_m_s", e);
    for (size_t n = 0; !s && n < POINTS && wf_csv_next(&t.c);) {
        json_t *to = json_object_get(key_of(runs, &t), "air");
        double x = cell(&t.c, t.column[2]), z = cell(&t.c, t.column[3]);
        if (!to) continue;
        wf_doc_add(d, to, place(x)), wf_doc_add(d, to, place(z));
        wf_doc_add(d, to, place(x - 0.004 * cell(&t.c, t.column[4])));
        wf_doc_add(d, to, place(z - 0.004 * cell(&t.c, t.column[5])));
        n++;
    }
    wf_arena_free(&t.a);
    return s;
}

/* Numbers of the key frames: the first row of the course in time at each, or after it. */
static enum wf_status read_course(const char *folder, json_t *runs, struct wf_doc *d, struct wf_err *e)
{
    static const char *const key[] = { "held", "film", "fell", "tip", "moment" };
    struct table t;
    size_t next[TREES] = { 0 };
    enum wf_status s =
        open_table(&t, folder, "series", "run time_s held_mg film_mg fell_mg tip_up_mm branch_moment_mNm", e);
    while (!s && wf_csv_next(&t.c)) {
        double run = cell(&t.c, t.column[0]), time = cell(&t.c, t.column[1]);
        if (!(run >= 1 && run <= TREES)) continue;
        json_t *keys = json_object_get(json_array_get(runs, (size_t)run - 1), "keys"), *o;
        while ((o = json_array_get(keys, next[(size_t)run - 1])) &&
               json_number_value(json_object_get(o, "time")) <= time * (1 + 1e-6)) {
            for (size_t i = 0; i < WF_COUNT(key); i++)
                wf_doc_number(d, o, key[i], cell(&t.c, t.column[i + 2]));
            next[(size_t)run - 1]++;
        }
    }
    wf_arena_free(&t.a);
    return s;
}

/* The runs of rain; `runs` stays empty where the page would become too heavy. */
static enum wf_status rain_part(struct wf_doc *d, json_t *o, const char *folder, const json_t *results,
                                struct wf_err *e)
{
    size_t n[2] = { 0 }, i;
    json_t *runs = wf_doc_put(d, o, "runs", wf_doc_array(d)), *x;
    enum wf_status s = count_lines(folder, n, e);
    if (s || n[1] > POINTS / 2) return s;
    json_array_foreach(json_object_get(results, "runs"), i, x) if (i < TREES)
        wf_doc_put(d, wf_doc_add(d, runs, wf_doc_object(d)), "keys", wf_doc_array(d));
    s = read_keys(folder, runs, d, e);
    if (!s) s = read_scene(folder, runs, n[0] <= POINTS / 2, d, e);
    return s ? s : read_course(folder, runs, d, e);
}

/* Has the document something to play? */
static bool moves(const json_t *results)
{
    const json_t *x;
    size_t i;
    json_array_foreach(json_object_get(results, "runs"), i,
                       x) if (json_number_value(json_object_get(x, "keys")) > 1) return true;
    return json_is_array(json_object_get(results, "trees"));
}

enum wf_status wf_live_data(const char *folder, const json_t *results, const char *units, struct wf_arena *a,
                            const char **out, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    *out = NULL;
    if (!moves(results)) return WF_OK;
    json_t *o = wf_doc_object(&d);
    wf_doc_put(&d, o, "units", units_part(&d, units));
    bool time = json_is_array(json_object_get(results, "runs"));
    const char *schema = text_of(json_object_get(results, "schema"), "name");
    bool rain = schema && !strcmp(schema, "windfirm-rain");
    enum wf_status s = (rain ? rain_part : time ? frames_part : trees_part)(&d, o, folder, results, e);
    bool none = time && !json_array_size(json_object_get(o, "runs"));
    char *text = s || none || d.failed ? NULL : json_dumps(o, JSON_COMPACT | JSON_REAL_PRECISION(7));
    *out = text ? wf_arena_print(a, "%s", text) : NULL;
    if (!s && !*out && !none) s = wf_fail(e, WF_ENOMEM, "%s: no memory for the page", folder);
    free(text);
    json_decref(o);
    return s;
}
