/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/tree.h"
#include "base/num.h"
#include "base/vec3.h"
#include <math.h>
#include <stdbool.h>

enum { ROWS_LISTED = 100 };

enum wf_status wf_tree_alloc(struct wf_tree *t, size_t n, struct wf_arena *a, struct wf_err *e)
{
    *t = (struct wf_tree){ .n = n, .anchorage = NAN };
    double **column[] = { &t->x0,         &t->y0,        &t->z0,      &t->x1,          &t->y1,
                          &t->z1,         &t->r0,        &t->r1,      &t->i0,          &t->i1,
                          &t->youngs,     &t->shear,     &t->density, &t->strength,    &t->drag,
                          &t->lift,       &t->damping,   &t->sail0,   &t->sail1,       &t->leaf0,
                          &t->leaf1,      &t->burden0,   &t->burden1, &t->compressive, &t->shearing,
                          &t->tangential, &t->transverse };
    t->parent = WF_TAKE(a, n, int32_t);
    t->level = WF_TAKE(a, n, int32_t);
    t->id = WF_TAKE(a, n, int64_t);
    bool ok = t->parent && t->level && t->id && n <= INT32_MAX;
    for (size_t k = 0; ok && k < WF_COUNT(column); k++) ok = (*column[k] = WF_TAKE(a, n, double)) != NULL;
    if (!ok) return wf_fail(e, WF_ENOMEM, "no memory for a tree of %zu segments", n);
    for (size_t i = 0; i < n; i++) {
        t->parent[i] = -1;
        t->id[i] = (int64_t)i + 1;
        t->drag[i] = NAN;
    }
    return WF_OK;
}

enum wf_status wf_tree_alloc_sections(struct wf_tree *t, struct wf_arena *a, struct wf_err *e)
{
    struct wf_tree_sections *c = t->section = WF_TAKE(a, 1, struct wf_tree_sections);
    bool ok = c != NULL;
    double **const column[] = { &c->width0, &c->width1, &c->height0, &c->height1, &c->side0,
                                &c->side1,  &c->mix0,   &c->mix1,    &c->up };
    for (size_t k = 0; ok && k < WF_COUNT(column); k++)
        ok = (*column[k] = WF_TAKE(a, (k < 6 ? 1 : 3) * t->n, double)) != NULL;
    return ok ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for the sections of %zu segments", t->n);
}

static double part_of(double a, double b, double s) { return s <= 0 ? a : s >= 1 ? b : a + (b - a) * s; }

static void copy_section(const struct wf_tree_sections *from, size_t i, double s0, double s1,
                         struct wf_tree_sections *to, size_t at)
{
    double *const ends[][4] = {
        { from->width0, from->width1, to->width0, to->width1 },
        { from->height0, from->height1, to->height0, to->height1 },
        { from->side0, from->side1, to->side0, to->side1 },
    };
    for (size_t k = 0; k < WF_COUNT(ends); k++) {
        ends[k][2][at] = part_of(ends[k][0][i], ends[k][1][i], s0);
        ends[k][3][at] = part_of(ends[k][0][i], ends[k][1][i], s1);
    }
    for (size_t k = 0; k < 3; k++) {
        to->mix0[3 * at + k] = part_of(from->mix0[3 * i + k], from->mix1[3 * i + k], s0);
        to->mix1[3 * at + k] = part_of(from->mix0[3 * i + k], from->mix1[3 * i + k], s1);
        to->up[3 * at + k] = from->up[3 * i + k];
    }
    if (from->hollow) to->hollow[at] = from->hollow[i];
    if (from->cavity) to->cavity[at] = from->cavity[i];
}

/* What the row carried on the day of the shape. */
static void copy_standing(const struct wf_tree_standing *from, size_t i, double s0, double s1,
                          struct wf_tree_standing *to, size_t at)
{
    to->burden0[at] = part_of(from->burden0[i], from->burden1[i], s0);
    to->burden1[at] = part_of(from->burden0[i], from->burden1[i], s1);
    if (!from->side0) return;
    to->side0[at] = part_of(from->side0[i], from->side1[i], s0);
    to->side1[at] = part_of(from->side0[i], from->side1[i], s1);
}

void wf_tree_copy_part(const struct wf_tree *from, size_t i, double s0, double s1, struct wf_tree *to,
                       size_t at)
{
    double *const ends[][4] = {
        { from->x0, from->x1, to->x0, to->x1 },
        { from->y0, from->y1, to->y0, to->y1 },
        { from->z0, from->z1, to->z0, to->z1 },
        { from->r0, from->r1, to->r0, to->r1 },
        { from->i0, from->i1, to->i0, to->i1 },
        { from->sail0, from->sail1, to->sail0, to->sail1 },
        { from->leaf0, from->leaf1, to->leaf0, to->leaf1 },
        { from->burden0, from->burden1, to->burden0, to->burden1 },
        { from->bark0, from->bark1, to->bark0, to->bark1 }, /* the last: there may be none */
    };
    double *const single[][2] = { { from->youngs, to->youngs },
                                  { from->shear, to->shear },
                                  { from->density, to->density },
                                  { from->strength, to->strength },
                                  { from->drag, to->drag },
                                  { from->lift, to->lift },
                                  { from->damping, to->damping },
                                  { from->compressive, to->compressive },
                                  { from->shearing, to->shearing },
                                  { from->tangential, to->tangential },
                                  { from->transverse, to->transverse } };
    for (size_t k = 0; k < WF_COUNT(ends) - !from->bark0; k++) {
        ends[k][2][at] = part_of(ends[k][0][i], ends[k][1][i], s0);
        ends[k][3][at] = part_of(ends[k][0][i], ends[k][1][i], s1);
    }
    for (size_t k = 0; k < WF_COUNT(single); k++) single[k][1][at] = single[k][0][i];
    to->level[at] = from->level[i];
    to->id[at] = from->id[i];
    if (from->section) copy_section(from->section, i, s0, s1, to->section, at);
    if (from->standing && to->standing) copy_standing(from->standing, i, s0, s1, to->standing, at);
}

enum wf_status wf_tree_alloc_bark(struct wf_tree *t, struct wf_arena *a, struct wf_err *e)
{
    t->bark0 = WF_TAKE(a, t->n, double);
    t->bark1 = WF_TAKE(a, t->n, double);
    return t->bark0 && t->bark1 ? WF_OK
                                : wf_fail(e, WF_ENOMEM, "no memory for the bark of %zu segments", t->n);
}

enum wf_status wf_tree_alloc_hollow(struct wf_tree *t, struct wf_arena *a, struct wf_err *e)
{
    enum wf_status s = t->section ? WF_OK : wf_tree_alloc_sections(t, a, e);
    if (s) return s;
    t->section->hollow = WF_TAKE(a, t->n, const struct wf_hollow *);
    t->section->cavity = WF_TAKE(a, t->n, int32_t);
    if (!t->section->hollow || !t->section->cavity)
        return wf_fail(e, WF_ENOMEM, "no memory for the cavities of %zu segments", t->n);
    for (size_t i = 0; i < t->n; i++) t->section->cavity[i] = -1;
    return WF_OK;
}

enum wf_status wf_tree_alloc_like(const struct wf_tree *like, size_t n, struct wf_arena *a,
                                  struct wf_tree *out, struct wf_err *e)
{
    enum wf_status s = wf_tree_alloc(out, n, a, e);
    if (!s && like->bark0) s = wf_tree_alloc_bark(out, a, e);
    if (!s && like->section) s = wf_tree_alloc_sections(out, a, e);
    if (!s && like->section && like->section->cavity) s = wf_tree_alloc_hollow(out, a, e);
    if (!s && like->mass1 && !(out->mass1 = WF_TAKE(a, n, double)))
        s = wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", n);
    if (s) return s;
    out->name = like->name, out->anchorage = like->anchorage, out->room = like->room;
    return WF_OK;
}

static double *copy_column(const double *from, size_t n, struct wf_arena *a)
{
    double *to = WF_TAKE(a, n, double);
    if (to) memcpy(to, from, n * sizeof *to);
    return to;
}

enum wf_status wf_tree_stand(struct wf_tree *t, const struct wf_tree *worn, struct wf_arena *a,
                             struct wf_err *e)
{
    struct wf_tree_standing *s = WF_TAKE(a, 1, struct wf_tree_standing);
    const struct wf_tree_sections *c = worn->section;
    if (s) {
        s->burden0 = copy_column(worn->burden0, t->n, a);
        s->burden1 = copy_column(worn->burden1, t->n, a);
        if (c) s->side0 = copy_column(c->side0, t->n, a);
        if (c) s->side1 = copy_column(c->side1, t->n, a);
    }
    t->standing = s;
    if (s && s->burden0 && s->burden1 && (!c || (s->side0 && s->side1))) return WF_OK;
    return wf_fail(e, WF_ENOMEM, "not enough memory for the burden of %zu segments", t->n);
}

double wf_tree_height(const struct wf_tree *t)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < t->n; i++) {
        if (t->parent[i] < 0) low = fmin(low, t->z0[i]);
        high = fmax(high, fmax(t->z0[i], t->z1[i]));
    }
    return t->n ? high - low : 0.0;
}

double wf_tree_thickness(const struct wf_tree *t, size_t i, double place)
{
    return 2 * (isnan(place) ? fmax(t->r0[i], t->r1[i]) : wf_between(t->r0[i], t->r1[i], place));
}

double wf_tree_length(const struct wf_tree *t, size_t i)
{
    double c[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    double chord = sqrt(wf_dot(c, c));
    if (!t->bend) return chord;
    const double *k = t->bend + 3 * i;
    double half = 0.5 * chord * sqrt(wf_dot(k, k));
    return half > 0 ? chord * (asin(fmin(half, 1.0)) / half) : chord;
}

/* What is wrong with the section of row i; NULL: nothing. */
static const char *section_row_fault(const struct wf_tree *t, size_t i)
{
    const struct wf_tree_sections *c = t->section;
    const double *up = c->up + 3 * i, *m0 = c->mix0 + 3 * i, *m1 = c->mix1 + 3 * i;
    double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    if (c->width0[i] == 0 && c->width1[i] == 0) return NULL; /* by its radii */
    double least = fmin(fmin(c->width0[i], c->width1[i]), fmin(c->height0[i], c->height1[i]));
    if (!(least > 0 && isfinite(c->width0[i] + c->width1[i] + c->height0[i] + c->height1[i])))
        return "a width or height of the section is not positive";
    for (int k = 0; k < 3; k++)
        if (!(m0[k] >= 0 && m1[k] >= 0)) return "the share of a section's shape is negative";
    if (!(fabs(m0[0] + m0[1] + m0[2] - 1) < 1e-9 && fabs(m1[0] + m1[1] + m1[2] - 1) < 1e-9))
        return "the shares of a section's shapes do not sum up to 1";
    if (!(fabs(wf_dot(up, up) - 1) < 1e-9 && fabs(wf_dot(up, axis)) < 1e-9 * sqrt(wf_dot(axis, axis))))
        return "the section's height is not measured across the segment";
    if (!isfinite(c->side0[i] + c->side1[i])) return "the first moment of the hanging mass is not finite";
    if (t->stiff || t->bend) return "a section that is not round needs a straight row of given moduli";
    return t->i0[i] > 0 || t->i1[i] > 0 ? "a section that is not round is solid" : NULL;
}

/* What is wrong with row i; NULL: nothing. */
static const char *row_fault(const struct wf_tree *t, size_t i)
{
    const double finite[] = { t->x0[i],         t->y0[i],        t->z0[i],          t->x1[i],
                              t->y1[i],         t->z1[i],        t->r0[i],          t->r1[i],
                              t->i0[i],         t->i1[i],        t->youngs[i],      t->shear[i],
                              t->density[i],    t->strength[i],  t->lift[i],        t->damping[i],
                              t->sail0[i],      t->sail1[i],     t->leaf0[i],       t->leaf1[i],
                              t->burden0[i],    t->burden1[i],   t->compressive[i], t->shearing[i],
                              t->tangential[i], t->transverse[i] };
    for (size_t k = 0; k < WF_COUNT(finite); k++)
        if (!isfinite(finite[k])) return "a value is not a finite number";
    if (t->parent[i] < -1 || t->parent[i] >= (int32_t)i) return "the parent is not an earlier row";
    if (!(wf_tree_length(t, i) > 0)) return "the segment has no length";
    if (!(t->r0[i] > 0 && t->r1[i] > 0)) return "the outer radius is not positive";
    if (!(t->i0[i] >= 0 && t->i1[i] >= 0)) return "the inner radius is negative";
    if (!(t->i0[i] < t->r0[i] && t->i1[i] < t->r1[i])) return "the inner radius is not below the outer";
    if (t->bark0 && !(t->bark0[i] >= 0 && t->bark1[i] >= 0)) return "the bark is not 0 or more";
    if (t->bark0 && !(t->bark0[i] < t->r0[i] - t->i0[i] && t->bark1[i] < t->r1[i] - t->i1[i]))
        return "the bark leaves no wood";
    if (!t->stiff && !(t->youngs[i] > 0 && t->shear[i] > 0)) return "a modulus is not positive";
    for (size_t k = 0; t->stiff && k < 4; k++)
        if (!(t->stiff[4 * i + k] > 0 && isfinite(t->stiff[4 * i + k])))
            return "a given stiffness is not positive";
    if (!(t->density[i] >= 0 && t->burden0[i] >= 0 && t->burden1[i] >= 0)) return "a mass is negative";
    if (t->mass1 && !(t->mass1[i] >= 0 && isfinite(t->mass1[i])))
        return "the point mass is negative or not finite";
    if (isinf(t->drag[i]) || t->drag[i] < 0) return "the drag coefficient is negative or infinite";
    if (!(t->sail0[i] >= 0 && t->sail1[i] >= 0 && t->leaf0[i] >= 0 && t->leaf1[i] >= 0))
        return "an area is negative";
    if (!(t->strength[i] >= 0 && t->damping[i] >= 0)) return "the strength or damping ratio is negative";
    if (!(t->compressive[i] >= 0 && t->shearing[i] >= 0 && t->tangential[i] >= 0 && t->transverse[i] >= 0))
        return "a strength, or the stiffness across the grain, is negative";
    if (t->bend) {
        const double *k = t->bend + 3 * i, curvature = hypot(hypot(k[0], k[1]), k[2]);
        double c[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
        double chord = hypot(hypot(c[0], c[1]), c[2]);
        if (!isfinite(curvature)) return "the initial curvature is not finite";
        if (curvature * chord > 2) return "the initial curvature is too strong for the distance of its ends";
        if (fabs(k[0] * c[0] + k[1] * c[1] + k[2] * c[2]) > 1e-9 * curvature * chord)
            return "the initial curvature is not across the segment";
    }
    return t->section ? section_row_fault(t, i) : NULL;
}

enum wf_status wf_tree_check(const struct wf_tree *t, struct wf_diag *d, struct wf_err *e)
{
    const char *name = t->name ? t->name : "tree";
    size_t bad = 0;
    if (!t->n) return wf_fail(e, WF_EINPUT, "%s: the tree has no segments", name);
    for (size_t i = 0; i < t->n; i++) {
        const char *text = row_fault(t, i);
        if (!text) continue;
        if (++bad <= ROWS_LISTED)
            wf_diag_error(d, NULL, 0, 0, "%s: segment %lld: %s", name, (long long)t->id[i], text);
    }
    if (bad > ROWS_LISTED)
        wf_diag_error(d, NULL, 0, 0, "%s: %zu more segments are wrong", name, bad - (size_t)ROWS_LISTED);
    return bad ? wf_fail(e, WF_EINPUT, "%s: %zu of %zu segments are wrong", name, bad, t->n) : WF_OK;
}

void wf_tree_scale(struct wf_tree *t, double length, double radius)
{
    double *const longer[] = { t->x0, t->y0, t->z0, t->x1, t->y1, t->z1 };
    double *const thicker[] = { t->r0, t->r1, t->i0, t->i1 };
    double *const thinner[] = { t->sail0, t->sail1, t->leaf0, t->leaf1, t->burden0, t->burden1 };
    for (size_t i = 0; i < t->n; i++) {
        for (size_t k = 0; k < WF_COUNT(longer); k++) longer[k][i] *= length;
        for (size_t k = 0; k < WF_COUNT(thicker); k++) thicker[k][i] *= radius;
        for (size_t k = 0; k < WF_COUNT(thinner); k++) thinner[k][i] /= length;
        if (t->section && t->section->side0) t->section->side0[i] /= length, t->section->side1[i] /= length;
        for (size_t k = 0; t->bend && k < 3; k++) t->bend[3 * i + k] /= length;
    }
}

/* The thickest row of level 0 on a row; -1: none. Returned: *several, whether there are more. */
static int32_t limb_on(const struct wf_tree *t, int32_t below, bool *several)
{
    int32_t limb = -1;
    for (size_t i = (size_t)(below + 1); i < t->n; i++) {
        if (t->level[i] != 0 || t->parent[i] != below) continue;
        *several = *several || (limb >= 0 && below >= 0);
        if (limb < 0 || t->r0[i] > t->r0[limb]) limb = (int32_t)i;
    }
    return limb;
}

struct wf_breast wf_tree_breast(const struct wf_tree *t)
{
    struct wf_breast b = { .row = -1, .place = NAN, .diameter = NAN };
    bool several = false;
    int32_t row = limb_on(t, -1, &several);
    double along = row < 0 ? 0 : fmax(0, t->z0[row]); /* a scan may begin above the ground */
    for (; row >= 0; row = limb_on(t, row, &several)) {
        double length = wf_tree_length(t, (size_t)row), share = (WF_BREAST_HEIGHT - along) / length;
        b.forked = several;
        along += length;
        if (share > 1) continue;
        b.row = row, b.place = fmax(0, share);
        b.diameter = wf_tree_thickness(t, (size_t)row, b.place);
        break;
    }
    return b;
}

size_t wf_tip_row(const struct wf_tree *t)
{
    size_t tip = 0;
    double highest = -INFINITY;
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] == 0 && t->z1[i] > highest) {
            highest = t->z1[i];
            tip = i;
        }
    return tip;
}

bool wf_tree_branched(const struct wf_tree *t)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->level[i] > 0) return true;
    return false;
}

size_t wf_top_row(const struct wf_tree *t)
{
    size_t top = wf_tip_row(t);
    for (size_t i = 0; i < t->n; i++)
        if (t->z1[i] > t->z1[top]) top = i;
    return top;
}

const char *wf_scope_name(enum wf_scope s)
{
    static const char *const names[WF_SCOPES] = { "tree", "stem", "branches" };
    return names[s];
}

bool wf_scope_holds(enum wf_scope s, const struct wf_tree *t, size_t row)
{
    if (t->doubtful && t->doubtful[row]) return false;
    return s == WF_SCOPE_TREE || (t->level[row] == 0) == (s == WF_SCOPE_STEM);
}

double wf_along_at(const struct wf_along *a, double s, double fallback)
{
    if (!a->n) return fallback;
    if (!(s > a->s[0])) return a->v[0];
    for (size_t i = 1; i < a->n; i++)
        if (s <= a->s[i]) {
            double w = (s - a->s[i - 1]) / (a->s[i] - a->s[i - 1]);
            return a->v[i - 1] + w * (a->v[i] - a->v[i - 1]);
        }
    return a->v[a->n - 1];
}

size_t wf_tree_base(const struct wf_tree *t, size_t i)
{
    while (t->parent[i] >= 0) i = (size_t)t->parent[i];
    return i;
}

size_t wf_tree_stem_at(const struct wf_tree *t, double height, double *place)
{
    size_t found = t->n;
    double thickest = 0;
    for (size_t i = 0; i < t->n; i++) {
        double rise = t->z1[i] - t->z0[i], share = (t->z0[wf_tree_base(t, i)] + height - t->z0[i]) / rise;
        if (t->level[i] != 0 || !(rise > 0) || !(share > 0 && share <= 1)) continue;
        double r = wf_between(t->r0[i], t->r1[i], share);
        if (r > thickest) thickest = r, found = i, *place = share;
    }
    return found;
}

enum wf_status wf_tree_cut(struct wf_tree *t, size_t row, double place, struct wf_arena *a, struct wf_err *e)
{
    const double near = 1e-3; /* [m] */
    struct wf_tree out;
    if ((1 - place) * wf_tree_length(t, row) <= near) return WF_OK;
    enum wf_status s = wf_tree_alloc_like(t, t->n + 1, a, &out, e);
    if (s) return s;
    for (size_t i = 0; i < t->n; i++) {
        size_t at = i + (i > row);
        int32_t below = t->parent[i];
        out.parent[at] = below < 0 ? -1 : below + (below >= (int32_t)row);
        wf_tree_copy_part(t, i, 0, i == row ? place : 1, &out, at);
        if (t->mass1) out.mass1[at] = i == row ? 0 : t->mass1[i];
    }
    out.parent[row + 1] = (int32_t)row;
    wf_tree_copy_part(t, row, place, 1, &out, row + 1);
    if (t->mass1) out.mass1[row + 1] = t->mass1[row];
    *t = out;
    return WF_OK;
}
