/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/guy.h"
#include "base/num.h"
#include "base/text.h"
#include "base/units.h"
#include "data/model.h"
#include "wind/wind.h"
#include <math.h>
#include <string.h>

/* ---- Reading ---- */

/* The parts of a guy, in their order; the last may be left out. */
static const struct part {
    const char *name;
    enum wf_dimension dimension;
    const char *unit;
    double low, high; /* in SI; of the angle any */
    const char *range;
    size_t offset;
} parts[] = {
    { "height", WF_DIM_LENGTH, "m", 0.5, 120, "0.5 to 120 m", offsetof(struct wf_guy, height) },
    { "distance of the anchor", WF_DIM_LENGTH, "m", 0.5, 300, "0.5 to 300 m",
      offsetof(struct wf_guy, distance) },
    { "direction of the anchor", WF_DIM_ANGLE, "deg", -2 * WF_PI, 2 * WF_PI, "-360 to 360 deg",
      offsetof(struct wf_guy, towards) },
    { "stiffness", WF_DIM_FORCE_PER_LENGTH, "N/m", 1, 1e9, "1 N/m to 1 GN/m",
      offsetof(struct wf_guy, stiffness) },
    { "pretension", WF_DIM_FORCE, "N", 0, 1e6, "0 to 1000 kN", offsetof(struct wf_guy, pretension) },
};

static enum wf_status read_part(struct wf_units *u, const struct part *p, const char *text,
                                struct wf_guy *out, struct wf_err *e)
{
    double *value = (double *)((char *)out + p->offset);
    struct wf_err why = { WF_OK, "" };
    if (wf_quantity_read_as(u, text, p->dimension, p->unit, value, &why))
        return wf_fail(e, WF_EUSAGE, "--guy: %s: %.200s", p->name, why.text);
    if (*value >= p->low && *value <= p->high) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "--guy: %s: '%.40s' is outside %s", p->name, text, p->range);
}

static enum wf_status read_guy(struct wf_units *u, char *text, double north, struct wf_guy *out,
                               struct wf_err *e)
{
    const char *whole = text;
    size_t n = 0;
    enum wf_status s = WF_OK;
    *out = (struct wf_guy){ .pretension = 0 };
    for (char *next; text && !s && n < WF_COUNT(parts); n++, text = next) {
        if ((next = strchr(text, ':'))) *next++ = '\0';
        s = read_part(u, &parts[n], text, out, e);
    }
    if (!s && (text || n + 1 < WF_COUNT(parts)))
        return wf_fail(e, WF_EUSAGE,
                       "--guy: '%.40s...': a guy is HEIGHT:DISTANCE:TOWARDS:STIFFNESS with or without "
                       ":PRETENSION, for example 9m:8m:225deg:400kN/m:2kN",
                       whole);
    out->azimuth = wf_wind_azimuth(out->towards + WF_PI, north);
    return s;
}

enum wf_status wf_guys_read(const char *text, double north, struct wf_arena *a, const struct wf_guy **out,
                            size_t *n, struct wf_err *e)
{
    struct wf_guy *list = WF_TAKE(a, WF_TIES_MAX, struct wf_guy);
    char *rest = wf_arena_text(a, text), *item;
    struct wf_units *u = NULL;
    if (!list || !rest) return wf_fail(e, WF_ENOMEM, "not enough memory for guys");
    for (char *p = rest; (p = strchr(p, ';'));) *p = ',';
    enum wf_status s = wf_units_open(&u, e);
    for (*n = 0; !s && (item = wf_list_item(&rest)); (*n)++)
        s = *n < WF_TIES_MAX ? read_guy(u, item, north, &list[*n], e)
                             : wf_fail(e, WF_EUSAGE, "--guy: more than %d guys", (int)WF_TIES_MAX);
    wf_units_close(u);
    *out = list;
    return s;
}

/* ---- On the tree ---- */

/* Cut the tree at a height. Returned: *row, which ends there. */
static enum wf_status cut_at(struct wf_analysis *an, double height, struct wf_arena *a, int32_t *row,
                             struct wf_err *e)
{
    double place = 0, lengthened = an->misread ? an->misread->height : 1;
    size_t found = wf_tree_stem_at(&an->tree, lengthened * height, &place);
    if (found == an->tree.n)
        return wf_fail(e, WF_EINPUT, "%s: --guy: the stem does not reach %.4g m", an->model->name, height);
    *row = (int32_t)found;
    return wf_tree_cut(&an->tree, found, place, a, e);
}

static enum wf_status tie(const struct wf_tree *t, const struct wf_guy *g, struct wf_tie *out,
                          struct wf_err *e)
{
    size_t row = (size_t)out->segment, base = wf_tree_base(t, row);
    const double foot[3] = { t->x0[base], t->y0[base], t->z0[base] };
    const double away[3] = { g->distance * cos(g->azimuth), g->distance * sin(g->azimuth), 0 };
    const double end[3] = { t->x1[row], t->y1[row], t->z1[row] };
    double length = 0;
    for (int k = 0; k < 3; k++) {
        out->anchor[k] = foot[k] + away[k];
        length = hypot(length, end[k] - out->anchor[k]);
    }
    out->stiffness = g->stiffness;
    out->length = length - g->pretension / g->stiffness;
    if (out->length > 0.5 * length) return WF_OK;
    return wf_fail(
        e, WF_EINPUT,
        "--guy: a pretension of %.4g N stretches a guy of %.4g N/m by more than half of its %.4g m",
        g->pretension, g->stiffness, length);
}

enum wf_status wf_guys_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_scenario *sc = &an->scenario;
    struct wf_tie *list = sc->guys ? WF_TAKE(a, sc->guys, struct wf_tie) : NULL;
    enum wf_status s = WF_OK;
    if (!sc->guys) return WF_OK;
    if (!list) return wf_fail(e, WF_ENOMEM, "not enough memory for guys");
    for (size_t k = 0; k < sc->guys && !s; k++) {
        size_t before = an->tree.n;
        s = cut_at(an, sc->guy[k].height, a, &list[k].segment, e);
        bool cut = an->tree.n > before; /* rows above the cut have moved */
        for (size_t i = 0; i < k && cut; i++) list[i].segment += list[i].segment >= list[k].segment;
    }
    for (size_t k = 0; k < sc->guys && !s; k++) s = tie(&an->tree, &sc->guy[k], &list[k], e);
    an->loads.tie = list, an->loads.ties = sc->guys;
    return s;
}
