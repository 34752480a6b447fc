/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/cavity.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "base/text.h"
#include "base/units.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- The list of a file ---- */

#define T struct wf_cavity
static const struct wf_yaml_row cavity_rows[] = {
    WF_KEY_LENGTH("from", from, "m", 0, 150, "Height above the ground at which the cavity begins.",
                  .absent = "0, the ground", .example = "0.8 m"),
    WF_KEY_LENGTH("to", to, "m", 0.01, 150, "Height at which it ends.",
                  .absent = "twice 'at', at most the stem's end", .example = "2.4 m"),
    WF_KEY_LENGTH(
        "at", at, "m", 0, 150,
        "Height at which it was measured. Between from and to it keeps its share of the stem's radius.",
        .required = true, .example = "1.3 m"),
    WF_KEY_LENGTH(
        "wall", wall, "mm", 1e-3, 5,
        "Sound wall of a round cavity, without bark: radius of the wood less that of the cavity. With "
        "'centre' the thinnest wall is less by the distance of the centre.",
        .absent = "needed unless 'rays' are given", .example = "80 mm"),
    WF_KEY_TEXT(
        "centre", centre,
        "Where the cavity's centre is, from the stem's axis: a distance and a direction, from +x towards "
        "+y as that of the wind.",
        .absent = "on the axis", .example = "3 cm towards 120 deg"),
    WF_KEY_ANGLE("opening", opening, 1. / 360, 350. / 360,
                 "Angle over which there is no wall, seen from the cavity's centre.",
                 .absent = "a closed wall", .example = "90 deg"),
    WF_KEY_ANGLE("facing", facing, -1, 1, "Direction of the opening's middle, from +x towards +y.",
                 .absent = "that of the centre", .example = "120 deg"),
    WF_KEY_TEXT(
        "rays", rays_file,
        "In place of a round cavity, a table of a tomograph (CSV: angle_deg, outer_m, sound_m); the path "
        "is from the folder of this file.",
        .absent = "a round cavity", .example = "section.csv"),
    { .key = NULL },
};

/* "3 cm towards 120 deg". */
static bool read_centre(struct wf_cavity *c, struct wf_err *e)
{
    static const char word[] = " towards ";
    char way[40];
    const char *at = strstr(c->centre, word);
    if (!at || (size_t)(at - c->centre) >= sizeof way)
        return wf_fail(e, WF_EINPUT,
                       "'%.60s' is not a distance and a direction, for example '3 cm towards 120 deg'",
                       c->centre) == WF_OK;
    (void)snprintf(way, sizeof way, "%.*s", (int)(at - c->centre), c->centre);
    struct wf_units *u = NULL;
    enum wf_status s = wf_units_open(&u, e);
    if (!s) s = wf_quantity_read_as(u, way, WF_DIM_LENGTH, "cm", &c->offset, e);
    if (!s) s = wf_quantity_read_as(u, at + strlen(word), WF_DIM_ANGLE, "deg", &c->towards, e);
    wf_units_close(u);
    if (!s && !(c->offset >= 0 && c->offset < 5))
        s = wf_fail(e, WF_EINPUT, "'%.60s': the distance is outside 0 to 5 m", c->centre);
    return s == WF_OK;
}

/* What is wrong with the keys of one cavity beside each other. Returned: the key, NULL: nothing. */
static const char *cavity_wrong(const struct wf_cavity *c, const char **why)
{
    bool round = !isnan(c->wall), open = c->opening > 0;
    *why = "needs 'wall' or 'rays': an opening is of a cavity";
    if (!round && !c->rays_file && (open || c->centre)) return open ? "opening" : "centre";
    *why = "needs 'wall', for example 'wall: 80 mm', or 'rays' with a table";
    if (!round && !c->rays_file) return "";
    *why = "is not used beside 'rays', which say where the wall is";
    if (c->rays_file && (round || c->centre || open || !isnan(c->facing)))
        return round ? "wall" : c->centre ? "centre" : open ? "opening" : "facing";
    *why = "is not used without 'opening'";
    if (!open && !isnan(c->facing)) return "facing";
    *why = "needs 'facing', the direction of its middle, for example 'facing: 120 deg'";
    if (open && !(c->offset > 0) && isnan(c->facing)) return "opening";
    *why = "is not above 'from'";
    if (!(c->to > c->from)) return "to";
    *why = "is not between 'from' and 'to'";
    return c->at < c->from || c->at > c->to ? "at" : NULL;
}

static void cavity_finish(struct wf_yaml *y, void *cavity)
{
    struct wf_cavity *c = cavity;
    struct wf_err e = { 0 };
    struct wf_yaml_mark mark = wf_yaml_where(y, "");
    c->line = mark.line, c->column = mark.column;
    if (!wf_yaml_has(y, "from")) c->from = 0;
    if (!wf_yaml_has(y, "to")) c->to = 2 * c->at, c->to_assumed = true;
    if (!wf_yaml_has(y, "opening")) c->opening = 0;
    bool written = wf_yaml_has(y, "wall") && isnan(c->wall); /* and reported */
    if (c->centre && !read_centre(c, &e)) wf_yaml_error(y, "centre", "%s", e.text);
    const char *why,
        *wrong = written || isnan(c->at + c->to + c->from + c->opening) ? NULL : cavity_wrong(c, &why);
    if (wrong && !e.code) wf_yaml_error(y, wrong, "%s", why);
}

const struct wf_yaml_table wf_cavity_table = { .title = "a cavity",
                                               .row = cavity_rows,
                                               .size = sizeof(struct wf_cavity),
                                               .finish = cavity_finish,
                                               .doc = "" };
#undef T

struct cavity_list {
    size_t n;
    struct wf_cavity *list;
};
#define T struct cavity_list
static const struct wf_yaml_row list_rows[] = {
    WF_KEY_LIST("cavities", list, n, wf_cavity_table, "The cavities of a tree.", .required = true),
    { .key = NULL },
};
static const struct wf_yaml_table list_table = { .title = "a list of cavities", .row = list_rows, .doc = "" };
#undef T

/* ---- Rays ---- */

static const double most_gap = WF_TURN / 6 * (1 + 1e-9); /* between two rays [rad] */

/* Report what is wrong with the last ray. Returned: whether the next is to be compared with it. */
static bool check_ray(struct wf_csv *c, const struct wf_cavity *r, const size_t column[3])
{
    size_t k = r->rays;
    double before = k ? r->angle[k - 1] : r->angle[0], gap = r->angle[k] - before;
    if (r->sound[k] > r->outer[k])
        wf_csv_mistake(c, column[2], "%g m is beyond the outline at %g m", r->sound[k], r->outer[k]);
    if (gap > most_gap)
        wf_csv_mistake(c, column[0], "leaves a gap of %.4g deg after the ray before; at most 60 deg",
                       360 / WF_TURN * gap);
    if (!k || gap > 0) return true;
    wf_csv_mistake(c, column[0],
                   "%g deg does not follow the %g deg before; sort the rays by angle, each once",
                   360 / WF_TURN * r->angle[k], 360 / WF_TURN * before);
    return false;
}

static void read_rays(struct wf_csv *c, struct wf_units *u, struct wf_cavity *r, struct wf_err *e)
{
    double factor[3];
    const size_t column[3] = { wf_column_need(c, u, "angle_deg", WF_DIM_ANGLE, &factor[0], e),
                               wf_column_need(c, u, "outer_m", WF_DIM_LENGTH, &factor[1], e),
                               wf_column_need(c, u, "sound_m", WF_DIM_LENGTH, &factor[2], e) };
    while (r->rays < WF_RAYS_MAX && wf_csv_next(c)) {
        size_t k = r->rays, before = c->mistakes;
        (void)wf_column_number(c, column[0], factor[0], -WF_TURN, 2 * WF_TURN, &r->angle[k]);
        (void)wf_column_number(c, column[1], factor[1], 1e-3, 10, &r->outer[k]);
        (void)wf_column_number(c, column[2], factor[2], 0, 10, &r->sound[k]);
        if (c->mistakes == before && check_ray(c, r, column)) r->rays++;
    }
    if (c->mistakes) return;
    char text[160] = "";
    double closing = r->rays ? WF_TURN - (r->angle[r->rays - 1] - r->angle[0]) : WF_TURN;
    if (r->rays < WF_RAYS_MIN)
        (void)snprintf(text, sizeof text, "%zu rays; a section needs at least %d", r->rays, (int)WF_RAYS_MIN);
    else if (wf_csv_next(c))
        (void)snprintf(text, sizeof text, "more than %d rays", (int)WF_RAYS_MAX);
    else if (!(closing > 0 && closing <= most_gap))
        (void)snprintf(
            text, sizeof text,
            "the section is not closed: from the last ray to the first are %.4g deg; more than 0 and at "
            "most 60",
            360 / WF_TURN * closing);
    if (*text) wf_csv_report(c, c->row_line, 0, text);
}

static enum wf_status cavity_rays_read(const char *path, struct wf_arena *a, struct wf_cavity *out,
                                       struct wf_diag *d, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_units *units = NULL;
    out->rays = 0, out->rays_file = path;
    out->angle = WF_TAKE(a, WF_RAYS_MAX + 1, double);
    out->outer = WF_TAKE(a, WF_RAYS_MAX + 1, double);
    out->sound = WF_TAKE(a, WF_RAYS_MAX + 1, double);
    if (!out->angle || !out->outer || !out->sound) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    if (!s) s = wf_units_open(&units, e);
    if (!s) read_rays(&csv, units, out, e);
    wf_units_close(units);
    return s ? s : csv.mistakes ? wf_fail(e, WF_EINPUT, "%s: the section was not read", path) : WF_OK;
}

/* A path from the folder of a file. */
static const char *beside(const char *file, const char *path, struct wf_arena *a)
{
    const char *slash = strrchr(file, '/');
    return slash && *path != '/' ? wf_arena_print(a, "%.*s/%s", (int)(slash - file), file, path) : path;
}

enum wf_status wf_cavities_settle(const char *file, struct wf_cavity *list, size_t n, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_err *e)
{
    enum wf_status worst = WF_OK;
    if (n > WF_CAVITIES_MAX)
        return wf_fail(e, WF_EINPUT, "%s: %zu cavities; at most %d", file, n, (int)WF_CAVITIES_MAX);
    for (size_t i = 0; i < n; i++) {
        struct wf_cavity *c = &list[i];
        if (!c->file) c->file = file;
        for (size_t k = 0; k < i; k++) {
            if (!(c->from < list[k].to && list[k].from < c->to)) continue;
            wf_diag_error(d, c->file, c->line, c->column,
                          "cavities: %g m to %g m overlaps the one from %g m to %g m; describe them as one, "
                          "or say in a file "
                          "where each begins and ends",
                          c->from, c->to, list[k].from, list[k].to);
            worst = wf_fail(e, WF_EINPUT, "%s: cavities overlap", file);
        }
        if (!c->rays_file || c->rays) continue;
        const char *path = beside(file, c->rays_file, a);
        struct wf_err why = { 0 };
        enum wf_status s =
            path ? cavity_rays_read(path, a, c, d, &why) : wf_fail(&why, WF_ENOMEM, "%s: no memory", file);
        if (s && !d->errors) wf_diag_error(d, c->file, c->line, c->column, "rays: %s", why.text);
        if (s && !worst) worst = wf_fail(e, s, "%s", why.text);
    }
    return worst;
}

/* ---- The command line ---- */

/* AT:WALL or AT:FILE. */
static enum wf_status read_short(char *text, struct wf_arena *a, struct wf_cavity *out, struct wf_diag *d,
                                 struct wf_err *e)
{
    char *rest = strchr(text, ':');
    struct wf_units *u = NULL;
    *out = (struct wf_cavity){ .wall = NAN, .facing = NAN, .file = "--cavity" };
    *rest++ = '\0';
    enum wf_status s = wf_units_open(&u, e);
    if (!s) s = wf_quantity_read_as(u, text, WF_DIM_LENGTH, "m", &out->at, e);
    if (!s && !(out->at > 0 && out->at <= 150))
        s = wf_fail(e, WF_EINPUT, "'%.40s': the height is outside 0 to 150 m", text);
    out->to = 2 * out->at, out->to_assumed = true;
    bool number = strchr("0123456789.+-", *rest) && !strstr(rest, ".csv");
    if (!s && number) s = wf_quantity_read_as(u, rest, WF_DIM_LENGTH, "mm", &out->wall, e);
    if (!s && number && !(out->wall >= 1e-3 && out->wall <= 5))
        s = wf_fail(e, WF_EINPUT, "'%.40s': the wall is outside 1 mm to 5 m", rest);
    wf_units_close(u);
    if (!s && !number) s = cavity_rays_read(rest, a, out, d, e);
    return s;
}

static enum wf_status read_list(const char *path, struct wf_arena *a, struct cavity_list *out,
                                struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s = wf_yaml_read(path, &list_table, out, a, d, e);
    return s ? s : wf_cavities_settle(path, out->list, out->n, a, d, e);
}

enum wf_status wf_cavities_asked(const char *text, struct wf_arena *a, struct wf_cavity **out, size_t *n,
                                 struct wf_diag *d, struct wf_err *e)
{
    struct wf_cavity *list = *out = WF_TAKE(a, WF_CAVITIES_MAX, struct wf_cavity);
    char *rest = wf_arena_text(a, text), *item;
    enum wf_status s = list && rest ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for the cavities");
    for (*n = 0; !s && (item = wf_list_item(&rest));) {
        struct cavity_list more = { .n = 1 };
        struct wf_cavity one;
        struct wf_err why = { 0 };
        if (strchr(item, ':'))
            s = read_short(item, a, &one, d, &why), more.list = &one;
        else
            s = read_list(item, a, &more, d, &why);
        if (s && why.code) (void)wf_fail(e, s, "--cavity: %s", why.text);
        if (!s && *n + more.n > WF_CAVITIES_MAX)
            s = wf_fail(e, WF_EINPUT, "--cavity: more than %d cavities", (int)WF_CAVITIES_MAX);
        for (size_t i = 0; !s && i < more.n; i++) list[(*n)++] = more.list[i];
    }
    return s ? s : wf_cavities_settle("--cavity", list, *n, a, d, e);
}
