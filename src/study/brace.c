/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/brace.h"
#include "base/num.h"
#include "base/text.h"
#include "base/units.h"
#include "data/model.h"
#include "study/removal.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *option_of(bool rod) { return rod ? "--rod" : "--cable"; }

/* ---- Reading ---- */

enum { PARTS = 8 };

static enum wf_status read_value(struct wf_units *u, const char *text, const char *what,
                                 enum wf_dimension dimension, const char *unit, double low, double high,
                                 const char *range, double *out, struct wf_err *e)
{
    struct wf_err why = { WF_OK, "" };
    if (wf_quantity_read_as(u, text, dimension, unit, out, &why))
        return wf_fail(e, WF_EUSAGE, "%s: %.200s", what, why.text);
    if (*out >= low && *out <= high) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "%s: '%.40s' is outside %s", what, text, range);
}

/* "id:14", "id:14@40%" or a height. */
static enum wf_status read_point(struct wf_units *u, const char *text, struct wf_brace_point *out,
                                 struct wf_err *e)
{
    char *end;
    *out = (struct wf_brace_point){ .name = text, .height = NAN, .share = 1 };
    if (strncmp(text, "id:", 3))
        return read_value(u, text, "height", WF_DIM_LENGTH, "m", 0.5, 120, "0.5 to 120 m", &out->height, e);
    errno = 0;
    out->id = strtoll(text + 3, &end, 10);
    if (end > text + 3 && *end == '@' && !errno) {
        const char *rest = wf_number_read(end + 1, end + strlen(end), '.', &out->share);
        out->share /= 100;
        if (rest && !strcmp(rest, "%") && out->share >= 0.01 && out->share <= 1) return WF_OK;
    } else if (end > text + 3 && !*end && !errno)
        return WF_OK;
    return wf_fail(e, WF_EUSAGE,
                   "'%.40s': id: and the number of a segment, whose end it is, or a place in it from 1%% to "
                   "100%%, for example id:14 or id:14@40%%",
                   text);
}

/* What may follow the stiffness. */
static enum wf_status read_rest(struct wf_units *u, const char *text, struct wf_brace *out, struct wf_err *e)
{
    if (!strncmp(text, "breaks ", 7))
        return read_value(u, text + 7, "breaking load", WF_DIM_FORCE, "N", 1, 1e7, "1 N to 10 MN",
                          &out->breaking, e);
    if (!strncmp(text, "slack ", 6) && out->rod)
        return wf_fail(e, WF_EUSAGE, "'%.40s': a rod pulls and pushes, and has no slack", text);
    if (!strncmp(text, "slack ", 6))
        return read_value(u, text + 6, "slack", WF_DIM_LENGTH, "m", 0, 5, "0 to 5 m", &out->slack, e);
    return read_value(u, text, "pretension", WF_DIM_FORCE, "N", out->rod ? -1e6 : 0, 1e6,
                      out->rod ? "-1000 to 1000 kN" : "0 to 1000 kN", &out->pretension, e);
}

/* The parts of a text apart by ':', "id:14" as one. Returned: their number. */
static size_t split(char *text, char *part[PARTS])
{
    size_t n = 0;
    while (text && n < PARTS) {
        char *at = text + strspn(text, " "), *next = strchr(strncmp(at, "id:", 3) ? at : at + 3, ':');
        if (next) *next++ = '\0';
        part[n++] = wf_text_trim(text);
        text = next;
    }
    return text ? 0 : n;
}

static enum wf_status read_brace(struct wf_units *u, char *text, struct wf_brace *out, struct wf_err *e)
{
    char *part[PARTS];
    size_t n = split(text, part);
    if (n < 3 || n > 6)
        return wf_fail(
            e, WF_EUSAGE,
            "it is FROM:TO:STIFFNESS with or without :PRETENSION, :slack LENGTH and :breaks FORCE, "
            "for example id:14:id:27:200kN/m:1kN:breaks 40kN");
    enum wf_status s = WF_OK;
    for (int k = 0; k < 2 && !s; k++) s = read_point(u, part[k], &out->end[k], e);
    if (!s)
        s = read_value(u, part[2], "stiffness", WF_DIM_FORCE_PER_LENGTH, "N/m", 1, 1e9, "1 N/m to 1 GN/m",
                       &out->stiffness, e);
    for (size_t k = 3; k < n && !s; k++) s = read_rest(u, part[k], out, e);
    if (!s && out->slack > 0 && out->pretension > 0)
        s = wf_fail(e, WF_EUSAGE, "it has either a pretension or slack");
    return s;
}

enum wf_status wf_braces_read(const char *text, bool rod, struct wf_arena *a, struct wf_brace *out, size_t *n,
                              struct wf_err *e)
{
    char *rest = wf_arena_text(a, text), *item;
    struct wf_units *u = NULL;
    struct wf_err why = { WF_OK, "" };
    if (!rest) return wf_fail(e, WF_ENOMEM, "not enough memory for cables");
    for (char *p = rest; (p = strchr(p, ';'));) *p = ',';
    enum wf_status s = wf_units_open(&u, e);
    for (; !s && (item = wf_list_item(&rest)); (*n)++) {
        if (*n == WF_LINKS_MAX) {
            s = wf_fail(e, WF_EUSAGE, "%s: more than %d cables and rods", option_of(rod), (int)WF_LINKS_MAX);
            break;
        }
        char shown[48];
        (void)snprintf(shown, sizeof shown, "%.40s", item);
        out[*n] = (struct wf_brace){ .rod = rod, .breaking = NAN };
        if ((s = read_brace(u, item, &out[*n], &why)))
            (void)wf_fail(e, s, "%s: '%s': %s", option_of(rod), shown, why.text);
    }
    wf_units_close(u);
    return s;
}

/* ---- On the tree ---- */

/* The row of a segment, of the rows that it may be cut into, and the place in it. Returned: t->n: none. */
static size_t segment_at(const struct wf_tree *t, const struct wf_brace_point *p, double *place)
{
    double whole = 0, below = 0;
    size_t found = t->n;
    for (size_t i = 0; i < t->n; i++) whole += t->id[i] == p->id ? wf_tree_length(t, i) : 0;
    for (size_t i = 0; i < t->n; i++) {
        if (t->id[i] != p->id || below >= p->share * whole * (1 - 1e-9)) continue;
        double own = wf_tree_length(t, i);
        *place = fmin(1, (p->share * whole - below) / own);
        below += own, found = i;
    }
    return found;
}

/* Cut the tree at a point. Returned: *row, which ends there. */
static enum wf_status cut_at(struct wf_analysis *an, const struct wf_brace *b, int end, struct wf_arena *a,
                             int32_t *row, struct wf_err *e)
{
    const struct wf_brace_point *p = &b->end[end];
    const char *without = an->scenario.removed ? ", once branches are removed" : "";
    double place = 1, lengthened = an->misread ? an->misread->height : 1;
    size_t found = isnan(p->height) ? segment_at(&an->tree, p, &place)
                                    : wf_tree_stem_at(&an->tree, lengthened * p->height, &place);
    if (found == an->tree.n && isnan(p->height))
        return wf_fail(e, WF_EINPUT,
                       "%s: %s: the tree has no segment %lld%s; the column 'segment' of tables/segments.csv "
                       "numbers them",
                       an->model->name, option_of(b->rod), p->id, without);
    if (found == an->tree.n)
        return wf_fail(e, WF_EINPUT, "%s: %s: the stem does not reach %.4g m", an->model->name,
                       option_of(b->rod), p->height);
    *row = (int32_t)found;
    return wf_tree_cut(&an->tree, found, place, a, e);
}

static enum wf_status link_of(const struct wf_analysis *an, const struct wf_brace *b, struct wf_link *out,
                              struct wf_err *e)
{
    const struct wf_tree *t = &an->tree;
    const double near = 1e-3; /* [m] */
    size_t from = (size_t)out->segment[0], to = (size_t)out->segment[1];
    double length = hypot(hypot(t->x1[to] - t->x1[from], t->y1[to] - t->y1[from]), t->z1[to] - t->z1[from]);
    out->stiffness = b->stiffness, out->pushes = b->rod;
    out->length = length + b->slack - b->pretension / b->stiffness;
    if (from == to || length < near)
        return wf_fail(e, WF_EINPUT, "%s: %s: both ends, %.60s and %.60s, are in the same place",
                       an->model->name, option_of(b->rod), b->end[0].name, b->end[1].name);
    if (out->length > 0.5 * length && out->length < 2 * length) return WF_OK;
    return wf_fail(
        e, WF_EINPUT,
        "%s: %s: a pretension of %.4g N with %.4g N/m changes its length of %.4g m by more than half",
        an->model->name, option_of(b->rod), b->pretension, b->stiffness, length);
}

/* Rows above a cut have moved, and the end of the row that was cut with them. */
static void follow_cut(int32_t *row, int32_t cut) { *row += *row >= cut; }

enum wf_status wf_braces_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    const struct wf_scenario *sc = &an->scenario;
    const bool branched = wf_tree_branched(&an->tree);
    if (!sc->braces) return WF_OK;
    if (!branched && sc->removed)
        return wf_fail(e, WF_EINPUT, "%s: %s: no branch is left without '%.80s' that it could be fixed to",
                       an->model->name, option_of(sc->brace->rod), sc->removed->name);
    if (!branched)
        return wf_fail(e, WF_EINPUT,
                       "%s: %s joins two points of a tree with branches; this one has a stem alone (a card "
                       "draws no branches). A model, a scan or a fit has them",
                       an->model->name, option_of(sc->brace->rod));
    struct wf_link *link = WF_TAKE(a, sc->braces, struct wf_link);
    struct wf_tie *tie = WF_TAKE(a, an->loads.ties + 1, struct wf_tie);
    if (!link || !tie) return wf_fail(e, WF_ENOMEM, "not enough memory for cables");
    for (size_t k = 0; k < an->loads.ties; k++) tie[k] = an->loads.tie[k];
    enum wf_status s = WF_OK;
    for (size_t k = 0; k < 2 * sc->braces && !s; k++) {
        size_t before = an->tree.n;
        int32_t *row = &link[k / 2].segment[k % 2];
        s = cut_at(an, &sc->brace[k / 2], (int)(k % 2), a, row, e);
        if (an->tree.n == before) continue;
        for (size_t i = 0; i < k; i++) follow_cut(&link[i / 2].segment[i % 2], *row);
        for (size_t i = 0; i < an->loads.ties; i++) follow_cut(&tie[i].segment, *row);
    }
    for (size_t k = 0; k < sc->braces && !s; k++) s = link_of(an, &sc->brace[k], &link[k], e);
    an->loads.link = link, an->loads.links = sc->braces;
    if (an->loads.ties) an->loads.tie = tie;
    return s;
}

const struct wf_at_speed *wf_brace_worst(const struct wf_analysis *an, size_t k)
{
    const struct wf_at_speed *worst = NULL;
    for (size_t i = 0; i < an->n; i++)
        if (!an->at[i].status && (!worst || fabs(an->at[i].link[k]) > fabs(worst->link[k])))
            worst = &an->at[i];
    return worst;
}
