/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/live.h"
#include "base/csv.h"
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

enum wf_status wf_live_data(const char *folder, const json_t *results, const char *units, struct wf_arena *a,
                            const char **out, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    char path[WF_PATH_MAX];
    json_t *o = wf_doc_object(&d), *trees = wf_doc_put(&d, o, "trees", wf_doc_array(&d)), *x;
    size_t i, n = 0, rows;
    json_array_foreach(json_object_get(results, "trees"), i, x) if (i < TREES)
        wf_doc_add(&d, trees, tree_part(&d, x));
    wf_doc_put(&d, o, "units", units_part(&d, units));
    enum wf_status s = wf_folder_path(folder, "tables/shape.csv", path, e);
    if (!s) s = read_shapes(path, results, trees, false, true, &d, &n, e);
    if (!s) s = read_shapes(path, results, trees, n <= POINTS, false, &d, &rows, e);
    char *text = s || d.failed ? NULL : json_dumps(o, JSON_COMPACT | JSON_REAL_PRECISION(7));
    *out = text ? wf_arena_print(a, "%s", text) : NULL;
    if (!s && !*out) s = wf_fail(e, WF_ENOMEM, "%s: no memory for the page", folder);
    free(text);
    json_decref(o);
    return s;
}
