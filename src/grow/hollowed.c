/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/hollowed.h"
#include "base/num.h"
#include "data/hollow.h"
#include "data/section.h"
#include "data/species.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The thickest row of the stem at a height, and the place in it. Returned: -1 when the stem does not reach
 * it. */
static int32_t stem_at(const struct wf_tree *t, double height, double *s)
{
    int32_t found = -1;
    double thickest = 0;
    for (size_t i = 0; i < t->n; i++) {
        double low = t->z0[i], rise = t->z1[i] - low, share = (height - low) / rise;
        if (t->parent[i] < 0 && height < low && height >= 0) share = 0; /* a scan begins above the ground */
        if (t->level[i] != 0 || !(rise > 0) || !(share >= 0 && share <= 1)) continue;
        double r = wf_between(t->r0[i], t->r1[i], share);
        if (r > thickest) thickest = r, found = (int32_t)i, *s = share;
    }
    return found;
}

/* ---- Bark ---- */

static void say_bark(const struct wf_model *m, const struct wf_tree *t, enum wf_bark_kind kind,
                     struct wf_diag *d)
{
    const struct wf_breast b = wf_tree_breast(t);
    size_t i = b.row < 0 ? 0 : (size_t)b.row;
    double s = b.row < 0 ? 0 : b.place;
    double outer = wf_between(t->r0[i], t->r1[i], s), wood = wf_wood_radius(t, i, s),
           left = pow(wood / outer, 3);
    wf_diag_warn(
        d, "bark",
        "%s: the stem's strength and stiffness are those of the wood within the bark, %.3g mm %s at a "
        "diameter of %.4g mm: %.0f %% of the section modulus over bark. Bark counts as mass; branches are "
        "taken over bark",
        m->name, 1e3 * (outer - wood),
        kind == WF_BARK_MEASURED  ? "as measured"
        : kind == WF_BARK_ASSUMED ? "assumed, for the species table has none,"
                                  : "by the species' law",
        2e3 * outer, 100 * left);
}

static enum wf_status bark_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                                struct wf_tree *t, struct wf_diag *d, struct wf_err *e)
{
    bool scan = m->generator == WF_GENERATOR_MEASURED, measured = m->bark.kind >= WF_BARK_MEASURED;
    enum wf_bark_kind kind = m->bark.kind;
    if (kind == WF_BARK_BY_TREE) kind = scan && sp->bark.given ? WF_BARK_SPECIES : WF_BARK_NONE;
    if (scan && m->bark.kind == WF_BARK_BY_TREE && kind == WF_BARK_NONE && !sp->level[0].wall.n)
        wf_diag_warn(
            d, "bark",
            "%s: the measured radii are taken as wood; the species table %s says nothing of bark, which "
            "makes 10 to 40 %% of the section modulus of other species' stems. --bark gives its thickness",
            m->name, sp->key);
    if (kind == WF_BARK_NONE) return WF_OK;
    if (kind == WF_BARK_SPECIES && !sp->bark.given)
        return wf_fail(
            e, WF_EINPUT,
            "%s: bark 'species': the species table %s has no 'bark'; give a thickness, such as 15 mm", m->key,
            sp->key);
    double s = 0, share = 0;
    const struct wf_breast b = wf_tree_breast(t);
    int32_t at = b.row < 0 ? stem_at(t, wf_tree_height(t), &s) : -1; /* a stem that ends below: its top */
    double radius = b.row >= 0 ? 0.5 * b.diameter : at < 0 ? t->r0[0] : wf_between(t->r0[at], t->r1[at], s);
    if (measured) share = m->bark.thickness / radius;
    if (share > 0.5)
        return wf_fail(e, WF_EINPUT,
                       "%s: bark of %.4g mm on a stem of %.4g mm radius at 1.3 m; at most half the radius",
                       m->key, 1e3 * m->bark.thickness, 1e3 * radius);
    enum wf_status status = wf_tree_alloc_bark(t, a, e);
    for (size_t i = 0; i < t->n && !status; i++) {
        if (t->level[i] != 0) continue;
        t->bark0[i] = measured ? share * t->r0[i] : wf_bark_by_law(&sp->bark, 2 * t->r0[i]);
        t->bark1[i] = measured ? share * t->r1[i] : wf_bark_by_law(&sp->bark, 2 * t->r1[i]);
    }
    if (!status) say_bark(m, t, kind, d);
    return status;
}

/* ---- Cavities ---- */

static enum wf_status mistake(const struct wf_cavity *c, const char *key, struct wf_diag *d, const char *text)
{
    wf_diag_error(d, c->file, c->line, c->column, "cavity at %g m: %s%s", c->at, key, text);
    return WF_EINPUT;
}

/* A round cavity in a stem whose wood has that radius. */
static enum wf_status round_section(const struct wf_cavity *c, double radius, struct wf_arena *a,
                                    struct wf_hollow *out, struct wf_diag *d, struct wf_err *e)
{
    char text[240];
    double cavity = radius - c->wall;
    *text = '\0';
    if (!(cavity > 0))
        (void)snprintf(
            text, sizeof text,
            "%.4g mm: the wood of the stem has a radius of %.4g mm there, so that no cavity is left; the "
            "wall must be less",
            1e3 * c->wall, 1e3 * radius);
    else if (!(c->offset < c->wall))
        (void)snprintf(
            text, sizeof text,
            "%.4g mm: with its centre %.4g mm off the axis the cavity is larger than the stem of %.4g mm "
            "radius; the wall must be above that distance, or give the section as 'rays'",
            1e3 * c->wall, 1e3 * c->offset, 1e3 * radius);
    if (*text) return mistake(c, "wall: ", d, text);
    return wf_hollow_round(cavity / radius, c->offset / radius, c->towards, c->opening,
                           isnan(c->facing) ? c->towards : c->facing, a, out, e);
}

/* The section of a tomograph. Given: radius of the wood, thickness of the bark there. */
static enum wf_status ray_section(const struct wf_cavity *c, double radius, double bark, struct wf_arena *a,
                                  struct wf_hollow *out, struct wf_diag *d, struct wf_err *e)
{
    double *outer = WF_TAKE(a, c->rays, double), *sound = WF_TAKE(a, c->rays, double), area = 0;
    char text[240];
    if (!outer || !sound) return wf_fail(e, WF_ENOMEM, "no memory for %zu rays", c->rays);
    for (size_t k = 0; k < c->rays; k++) {
        size_t next = (k + 1) % c->rays;
        area += 0.5 * c->outer[k] * c->outer[next] * sin(c->angle[next] - c->angle[k]);
        outer[k] = fmax(c->outer[k] - bark, 1e-3 * c->outer[k]) / radius;
        sound[k] = fmin(c->sound[k] / radius, outer[k]);
    }
    double there = sqrt(fmax(area, 0) / WF_PI), stem = radius + bark;
    (void)snprintf(
        text, sizeof text,
        "%.60s: its outline has the area of a circle of %.4g mm radius, the stem has %.4g mm at that "
        "height; within 25 %% is allowed",
        c->rays_file, 1e3 * there, 1e3 * stem);
    if (!(there > 0.8 * stem && there < 1.25 * stem)) return mistake(c, "rays: ", d, text);
    return wf_hollow_rays(c->rays, c->angle, outer, sound, a, out, e);
}

static enum wf_status make_section(const struct wf_cavity *c, const struct wf_tree *t, int32_t row, double s,
                                   struct wf_arena *a, struct wf_hollow *out, struct wf_diag *d,
                                   struct wf_err *e)
{
    struct wf_err why = { 0 };
    double outer = wf_between(t->r0[row], t->r1[row], s), wood = wf_wood_radius(t, (size_t)row, s);
    enum wf_status status = c->rays ? ray_section(c, wood, outer - wood, a, out, d, &why)
                                    : round_section(c, wood, a, out, d, &why);
    if (status == WF_EINPUT && why.code) (void)mistake(c, "", d, why.text);
    if (status && status != WF_EINPUT) return wf_fail(e, status, "%s", why.text);
    if (!status && out->open)
        wf_diag_warn(
            d, "opening",
            "cavity at %g m: its wall is open; the strength is an upper bound, cracking at the opening is "
            "not assessed",
            c->at);
    return status;
}

/* Mark the rows of the stem that pass through a row: those below it, and the thickest above. */
static void mark_stem(const struct wf_tree *t, int32_t row, bool *on)
{
    for (int32_t i = row; i >= 0 && t->level[i] == 0; i = t->parent[i]) on[i] = true;
    for (int32_t last = row; last >= 0;) {
        int32_t next = -1;
        for (int32_t i = last + 1; i < (int32_t)t->n; i++)
            if (t->parent[i] == last && t->level[i] == 0 && (next < 0 || t->r0[i] > t->r0[next])) next = i;
        if (next >= 0) on[next] = true;
        last = next;
    }
}

/* What one run needs. */
struct hollowing {
    const struct wf_model *m;
    struct wf_arena *a; /* of what stays */
    struct wf_hollow *section;
    bool *on; /* rows x cavities: of the stem that has the cavity */
    size_t cavities;
};

/* Shares of row i at which it is cut, from 0; the last is followed by 1. Returned: how many pieces. */
static size_t cuts_of(const struct hollowing *h, const struct wf_tree *t, size_t i, double *cut)
{
    const double near = 1e-3; /* [m] */
    double rise = t->z1[i] - t->z0[i], length = wf_tree_length(t, i);
    size_t n = 1;
    cut[0] = 0;
    for (size_t k = 0; k < h->cavities; k++)
        for (int end = 0; end < 2 && h->on[i * h->cavities + k]; end++) {
            double s = ((end ? h->m->cavity[k].to : h->m->cavity[k].from) - t->z0[i]) / rise;
            if (s * length > near && (1 - s) * length > near) cut[n++] = s;
        }
    qsort(cut, n, sizeof *cut, wf_ascending);
    size_t kept = 1;
    for (size_t k = 1; k < n; k++)
        if ((cut[k] - cut[kept - 1]) * length > near) cut[kept++] = cut[k];
    cut[kept] = 1;
    return kept;
}

/* Give a row the section of the cavity that it lies in. */
static void set_row(const struct hollowing *h, struct wf_tree *t, size_t at, size_t from)
{
    double axis[3] = { t->x1[at] - t->x0[at], t->y1[at] - t->y0[at], t->z1[at] - t->z0[at] }, x[3], y[3];
    double middle = 0.5 * (t->z0[at] + t->z1[at]), turn = 0;
    for (size_t k = 0; k < h->cavities; k++) {
        const struct wf_cavity *c = &h->m->cavity[k];
        if (!h->on[from * h->cavities + k] || !(middle > c->from && middle < c->to)) continue;
        t->section->hollow[at] = &h->section[k];
        t->section->cavity[at] = (int32_t)k;
        turn = 0.5 * atan2(h->section[k].xy, 0.5 * (h->section[k].xx - h->section[k].yy));
    }
    wf_section_axes(axis, x, y);
    for (size_t k = 0; k < 3; k++) t->section->up[3 * at + k] = cos(turn) * x[k] + sin(turn) * y[k];
}

/* The tree with its rows cut where cavities end. */
static enum wf_status cut_rows(const struct hollowing *h, struct wf_tree *t, struct wf_arena *scratch,
                               struct wf_err *e)
{
    struct wf_tree out;
    int32_t *last = WF_TAKE(scratch, t->n, int32_t);
    double *cut = WF_TAKE(scratch, 2 * h->cavities + 2, double);
    size_t total = 0;
    if (!last || !cut) return wf_fail(e, WF_ENOMEM, "no memory for %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) total += cuts_of(h, t, i, cut);
    enum wf_status s = wf_tree_alloc(&out, total, h->a, e);
    if (!s && t->bark0) s = wf_tree_alloc_bark(&out, h->a, e);
    if (!s) s = wf_tree_alloc_hollow(&out, h->a, e);
    if (s) return s;
    out.name = t->name;
    for (size_t i = 0, at = 0; i < t->n; i++) {
        size_t pieces = cuts_of(h, t, i, cut);
        for (size_t k = 0; k < pieces; k++, at++) {
            wf_tree_copy_part(t, i, cut[k], cut[k + 1], &out, at);
            out.parent[at] = k ? (int32_t)at - 1 : t->parent[i] < 0 ? -1 : last[t->parent[i]];
            set_row(h, &out, at, i);
        }
        last[i] = (int32_t)at - 1;
    }
    *t = out;
    return WF_OK;
}

/* Check every cavity against the tree and make its section. */
static enum wf_status make_sections(struct hollowing *h, const struct wf_tree *t, bool *on, struct wf_diag *d,
                                    struct wf_err *e)
{
    double top = 0;
    bool wrong = false;
    char text[160];
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] == 0) top = fmax(top, t->z1[i]);
    for (size_t k = 0; k < h->cavities; k++) {
        const struct wf_cavity *c = &h->m->cavity[k];
        double s = 0;
        int32_t row = stem_at(t, c->at, &s);
        bool above = c->at > top || row < 0;
        (void)snprintf(text, sizeof text, "%g m is above the stem, which ends at %.4g m",
                       above ? c->at : c->to, top);
        if (above || (c->to > top && !c->to_assumed)) {
            (void)mistake(c, above ? "at: " : "to: ", d, text), wrong = true;
            continue;
        }
        for (size_t i = 0; i < t->n; i++) on[i] = false;
        mark_stem(t, row, on);
        for (size_t i = 0; i < t->n; i++) h->on[i * h->cavities + k] = on[i];
        enum wf_status status = make_section(c, t, row, s, h->a, &h->section[k], d, e);
        if (status && status != WF_EINPUT) return status;
        wrong = wrong || status;
    }
    return wrong ? wf_fail(e, WF_EINPUT, "%s: the cavities do not fit the stem", h->m->key) : WF_OK;
}

static enum wf_status cavities_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                                    struct wf_tree *t, struct wf_diag *d, struct wf_err *e)
{
    if (!m->cavities) return WF_OK;
    if (sp->level[0].wall.n)
        return wf_fail(e, WF_EINPUT, "%s: cavities are of solid stems; the stem of %s has a wall of its own",
                       m->key, sp->key);
    struct wf_arena scratch = { 0 };
    struct hollowing h = { .m = m, .a = a, .cavities = m->cavities };
    bool *on = WF_TAKE(&scratch, t->n, bool);
    h.section = WF_TAKE(a, m->cavities, struct wf_hollow);
    h.on = WF_TAKE(&scratch, t->n * m->cavities, bool);
    enum wf_status s = on && h.section && h.on ? make_sections(&h, t, on, d, e)
                                               : wf_fail(e, WF_ENOMEM, "no memory for the cavities");
    if (!s) s = cut_rows(&h, t, &scratch, e);
    wf_arena_free(&scratch);
    return s;
}

enum wf_status wf_hollow_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_tree *t, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s = bark_onto(m, sp, a, t, d, e);
    return s ? s : cavities_onto(m, sp, a, t, d, e);
}
