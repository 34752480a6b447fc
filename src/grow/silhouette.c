/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/silhouette.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include "data/crown_mass.h"
#include "data/species.h"
#include <math.h>

/* ---- Outlines ---- */

/* Twice the area of the triangle a b c, positive to the left. */
static double turn(const struct wf_outline *o, size_t a, size_t b, size_t c)
{
    return (o->x[b] - o->x[a]) * (o->z[c] - o->z[a]) - (o->z[b] - o->z[a]) * (o->x[c] - o->x[a]);
}

static bool within(const struct wf_outline *o, size_t a, size_t b, size_t c)
{
    return fmin(o->x[a], o->x[b]) <= o->x[c] && o->x[c] <= fmax(o->x[a], o->x[b]) &&
           fmin(o->z[a], o->z[b]) <= o->z[c] && o->z[c] <= fmax(o->z[a], o->z[b]);
}

/* Have the sides a b and c d a point in common? */
static bool meet(const struct wf_outline *o, size_t a, size_t b, size_t c, size_t d)
{
    double p = turn(o, a, b, c), q = turn(o, a, b, d), r = turn(o, c, d, a), s = turn(o, c, d, b);
    if (((p > 0 && q < 0) || (p < 0 && q > 0)) && ((r > 0 && s < 0) || (r < 0 && s > 0))) return true;
    return (p == 0 && within(o, a, b, c)) || (q == 0 && within(o, a, b, d)) ||
           (r == 0 && within(o, c, d, a)) || (s == 0 && within(o, c, d, b));
}

static enum wf_status check_sides(const struct wf_outline *o, struct wf_err *e)
{
    size_t n = o->n;
    for (size_t i = 0; i < n; i++)
        for (size_t k = i + 2; k < n; k++) {
            if (i == 0 && k == n - 1) continue; /* neighbours */
            if (meet(o, i, i + 1, k, (k + 1) % n))
                return wf_fail(e, WF_EINPUT,
                               "the crown's outline crosses itself: the side from point %zu to %zu and the "
                               "side from point %zu to %zu",
                               i + 1, i + 2, k + 1, (k + 1) % n + 1);
        }
    return WF_OK;
}

static enum wf_status check_outline(const struct wf_outline *o, struct wf_err *e)
{
    double unused;
    if (o->n < 3 || o->n > WF_OUTLINE_POINTS)
        return wf_fail(e, WF_EINPUT, "the crown's outline has %zu points; 3 to %d are allowed", o->n,
                       (int)WF_OUTLINE_POINTS);
    for (size_t i = 0; i < o->n; i++) {
        if (!isfinite(o->x[i]) || !isfinite(o->z[i]))
            return wf_fail(e, WF_EINPUT, "point %zu of the crown's outline is not a number", i + 1);
        if (o->z[i] < 0)
            return wf_fail(e, WF_EINPUT,
                           "point %zu of the crown's outline is %g m below the ground; z is the height "
                           "above it",
                           i + 1, -o->z[i]);
    }
    enum wf_status s = check_sides(o, e);
    if (!s && !(wf_outline_strip(o, 0, INFINITY, &unused) > 0))
        s = wf_fail(e, WF_EINPUT, "the crown's outline has no area");
    return s;
}

/* Does the outline run clockwise? */
static bool clockwise(const struct wf_outline *o)
{
    double whole = 0;
    for (size_t i = 1; i < o->n; i++) whole += o->x[i - 1] * o->z[i] - o->x[i] * o->z[i - 1];
    if (o->n) whole += o->x[o->n - 1] * o->z[0] - o->x[0] * o->z[o->n - 1];
    return whole < 0;
}

/* The integrals of x dz and x z dz along every side between the heights are area and moment, by Green. */
double wf_outline_strip(const struct wf_outline *o, double from, double to, double *moment)
{
    double area = 0, first = 0;
    for (size_t i = 0; i < o->n; i++) {
        size_t k = i + 1 < o->n ? i + 1 : 0;
        double za = o->z[i], zb = o->z[k];
        if ((za <= from && zb <= from) || (za >= to && zb >= to)) continue;
        double xa = o->x[i], xb = o->x[k], a = fmin(fmax(za, from), to), b = fmin(fmax(zb, from), to);
        if (a == b) continue;
        double slope = (xb - xa) / (zb - za), pa = xa + slope * (a - za), pb = xa + slope * (b - za);
        area += 0.5 * (pa + pb) * (b - a);
        first += (b - a) * (pa * (2 * a + b) + pb * (a + 2 * b)) / 6;
    }
    bool turned = clockwise(o);
    *moment = turned ? -first : first;
    return turned ? -area : area;
}

static bool same_point(const struct wf_silhouette *s, size_t i, size_t k)
{
    return s->x[i] == s->x[k] && s->z[i] == s->z[k];
}

enum wf_status wf_outline_read(const char *path, struct wf_silhouette *s, struct wf_arena *a,
                               struct wf_diag *d, struct wf_err *e)
{
    struct wf_csv csv = { 0 };
    struct wf_units *units;
    double unit[2] = { 1, 1 };
    s->points = 0;
    s->x = WF_TAKE(a, WF_OUTLINE_POINTS + 1, double);
    s->z = WF_TAKE(a, WF_OUTLINE_POINTS + 1, double);
    if (!s->x || !s->z) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (wf_csv_open(&csv, path, a, d, e)) return e ? e->code : WF_EINPUT;
    if (wf_units_open(&units, e)) return e ? e->code : WF_EINPUT;
    size_t x = wf_column_need(&csv, units, "x_m", WF_DIM_LENGTH, &unit[0], e);
    size_t z = wf_column_need(&csv, units, "z_m", WF_DIM_LENGTH, &unit[1], e);
    wf_units_close(units);
    while (s->points <= WF_OUTLINE_POINTS && wf_csv_next(&csv)) {
        bool read = wf_column_number(&csv, x, unit[0], -1000, 1000, &s->x[s->points]);
        if (wf_column_number(&csv, z, unit[1], -1000, 1000, &s->z[s->points]) && read &&
            !(s->points && same_point(s, s->points, s->points - 1)))
            s->points++;
    }
    if (s->points > 3 && same_point(s, s->points - 1, 0)) s->points--; /* closed */
    if (csv.mistakes) return wf_fail(e, WF_EINPUT, "%s: the outline was not read", path);
    struct wf_err why = { 0 };
    enum wf_status bad = check_outline(&(struct wf_outline){ s->points, s->x, s->z }, &why);
    return bad ? wf_fail(e, bad, "%s: %s", path, why.text) : WF_OK;
}

/* ---- Forms ---- */

static bool given(double v) { return v > 0; }

enum { FORM_POINTS = 129 }; /* of one side; those of curved forms */

/* Half the breadth over half the width at relative height t. */
static double form_half(enum wf_crown_form form, double t)
{
    switch (form) {
    case WF_FORM_TRIANGLE:
        return 1 - t;
    case WF_FORM_DIAMOND:
        return 1 - fabs(2 * t - 1);
    case WF_FORM_ELLIPSE:
        return sqrt(fmax(0, 1 - (2 * t - 1) * (2 * t - 1)));
    case WF_FORM_PARABOLOID:
        return sqrt(fmax(0, 1 - t));
    default:
        return 1;
    }
}

static const double form_factor[] = { [WF_FORM_ELLIPSE] = 0.78539816339744831,
                                      [WF_FORM_TRIANGLE] = 0.5,
                                      [WF_FORM_DIAMOND] = 0.5,
                                      [WF_FORM_PARABOLOID] = 2.0 / 3.0,
                                      [WF_FORM_RECTANGLE] = 1 };

double wf_silhouette_area(const struct wf_silhouette *s)
{
    double unused;
    if (given(s->area)) return s->area;
    if (s->points)
        return wf_outline_strip(&(struct wf_outline){ s->points, s->x, s->z }, 0, INFINITY, &unused);
    return given(s->width) && given(s->depth) ? form_factor[s->form] * s->width * s->depth : (double)NAN;
}

enum wf_status wf_silhouette_check(const struct wf_silhouette *s, struct wf_err *e)
{
    const char *why, *wrong = wf_silhouette_wrong(s, &why);
    if (wrong) return wf_fail(e, WF_EINPUT, "%s %s", wrong, why);
    if (!s->points) return WF_OK;
    return check_outline(&(struct wf_outline){ s->points, s->x, s->z }, e);
}

bool wf_silhouette_ends(const struct wf_silhouette *s, double height, double *base, double *top)
{
    *base = *top = height;
    if (given(s->width) && given(s->depth)) *base = height - s->depth;
    if (s->points) *base = INFINITY, *top = 0;
    for (size_t i = 0; i < s->points; i++) *base = fmin(*base, s->z[i]), *top = fmax(*top, s->z[i]);
    return *base < *top;
}

/* An outline from half breadths at relative heights 0..1 of base..top, with this area. */
static void symmetric(struct wf_outline *o, const double *t, const double *half, size_t n, double base,
                      double top, double area)
{
    double unused;
    o->n = 2 * n;
    for (size_t i = 0; i < n; i++) {
        o->z[i] = o->z[2 * n - 1 - i] = base + t[i] * (top - base);
        o->x[i] = half[i], o->x[2 * n - 1 - i] = -half[i];
    }
    double scale = area / wf_outline_strip(o, -INFINITY, INFINITY, &unused);
    for (size_t i = 0; i < o->n; i++) o->x[i] *= scale;
}

/* The outline of what the model says of its crown. Returned: n 0 when an area is all that is known. */
static enum wf_status find_outline(const struct wf_model *m, double height, struct wf_arena *a,
                                   struct wf_outline *o, struct wf_err *e)
{
    const struct wf_silhouette *s = &m->silhouette;
    const struct wf_along *shape = &m->crown_shape;
    size_t n = s->points || given(s->width) ? FORM_POINTS : 2 + shape->n;
    double *t = WF_TAKE(a, n, double), *half = WF_TAKE(a, n, double), base, top;
    *o = (struct wf_outline){ s->points, s->x, s->z };
    if (s->points) return WF_OK;
    o->x = WF_TAKE(a, 2 * n, double), o->z = WF_TAKE(a, 2 * n, double);
    if (!t || !half || !o->x || !o->z) return wf_fail(e, WF_ENOMEM, "no memory for the crown's outline");
    if (given(s->width)) {
        (void)wf_silhouette_ends(s, height, &base, &top);
        if (base < -1e-9 * height) /* rounding of a leaning stem's height is no depth */
            return wf_fail(e, WF_EINPUT, "%s: a crown %g m deep lies below the ground; the tree is %g m high",
                           m->key, s->depth, height);
        for (size_t i = 0; i < n; i++) {
            t[i] = 0.5 - 0.5 * cos(3.14159265358979324 * (double)i / (double)(n - 1));
            half[i] = form_half(s->form, t[i]);
        }
        symmetric(o, t, half, n, base, top, wf_silhouette_area(s));
    } else if (m->crown_base < m->crown_top) {
        size_t k = 0;
        if (!shape->n || shape->s[0] > 0) t[k++] = 0;
        for (size_t i = 0; i < shape->n; i++) t[k++] = shape->s[i];
        if (!shape->n || shape->s[shape->n - 1] < 1) t[k++] = 1;
        for (size_t i = 0; i < k; i++) half[i] = wf_along_at(shape, t[i], 1);
        double up = height / m->height; /* of a leaning stem */
        symmetric(o, t, half, k, m->crown_base * up, m->crown_top * up, s->area);
    }
    return WF_OK;
}

struct wf_outline_size wf_silhouette_size(const struct wf_model *m, double height)
{
    const struct wf_silhouette *s = &m->silhouette;
    struct wf_outline_size size = { wf_silhouette_area(s), NAN, NAN, NAN };
    struct wf_arena scratch = { 0 };
    struct wf_outline o;
    double left = INFINITY, right = -INFINITY, base = INFINITY, top = -INFINITY, moment;
    bool drawn = s->points || given(s->width);
    if (drawn && !find_outline(m, height, &scratch, &o, NULL)) {
        for (size_t i = 0; i < o.n; i++) {
            left = fmin(left, o.x[i]), right = fmax(right, o.x[i]);
            base = fmin(base, o.z[i]), top = fmax(top, o.z[i]);
        }
        double area = wf_outline_strip(&o, -INFINITY, INFINITY, &moment);
        size.centre = moment / area, size.height = top - base;
        size.breadth = s->points ? right - left : s->width;
    }
    wf_arena_free(&scratch);
    return size;
}

/* ---- On the tree ---- */

struct carriers {
    struct wf_tree *t;
    bool stem;      /* the tree is a stem without branches, or several */
    bool leafy;     /* carriers are rows with leaves */
    double *weight; /* per row; 0: it carries nothing */
};

static double sail_of(const struct wf_tree *t)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (t->sail0[i] + t->sail1[i]) * wf_tree_length(t, i);
    return sum;
}

static enum wf_status find_carriers(struct wf_tree *t, struct wf_arena *a, struct carriers *c,
                                    struct wf_err *e)
{
    size_t *above = WF_TAKE(a, t->n, size_t), *tips = WF_TAKE(a, t->n, size_t);
    *c = (struct carriers){ .t = t, .stem = true, .weight = WF_TAKE(a, t->n, double) };
    if (!above || !tips || !c->weight) return wf_fail(e, WF_ENOMEM, "no memory for %zu segments", t->n);
    for (size_t i = t->n; i-- > 0;) {
        int32_t p = t->parent[i];
        if (!above[i]) tips[i] = 1;
        if (p >= 0) above[p]++, tips[p] += tips[i];
        c->stem = c->stem && above[i] <= 1 && t->z1[i] > t->z0[i];
        c->leafy = c->leafy || t->leaf0[i] + t->leaf1[i] > 0;
    }
    for (size_t i = 0; i < t->n; i++) {
        bool link = !(t->density[i] > 0);
        double own = c->leafy ? 0.5 * (t->leaf0[i] + t->leaf1[i]) : tips[i] == 1 && !link;
        c->weight[i] = own * wf_tree_length(t, i);
    }
    return WF_OK;
}

/* Every row of a stem carries what is beside it; the lowest and the highest also what is below and above.
 * The two ends of a row follow from area and centre of its strip. */
static void onto_stem(struct wf_tree *t, const struct wf_outline *o, double factor)
{
    double top = wf_tree_height(t);
    for (size_t i = 0; i < t->n; i++) {
        double from = t->z0[i] > 0 ? t->z0[i] : -INFINITY, to = t->z1[i] < top ? t->z1[i] : INFINITY, moment;
        double area = wf_outline_strip(o, from, to, &moment);
        t->sail0[i] = t->sail1[i] = 0;
        if (!(area > 0)) continue;
        double sum = 2 * area / wf_tree_length(t, i), at = (moment / area - t->z0[i]) / (t->z1[i] - t->z0[i]);
        t->sail1[i] = factor * fmin(fmax(sum * (3 * at - 1), 0), sum);
        t->sail0[i] = factor * sum - t->sail1[i];
    }
}

enum { STRIPS = 32 };
struct strip {
    double weight, height; /* of the carriers in it */
    double area;           /* that they carry */
};

static size_t strip_of(const struct wf_tree *t, size_t i, double base, double top)
{
    double at = (0.5 * (t->z0[i] + t->z1[i]) - base) / (top - base);
    return at >= 0 && at < 1 ? (size_t)(at * STRIPS) : at == 1 ? STRIPS - 1 : STRIPS;
}

/* Area at a height, to the strips with carriers below and above it, by the lever. */
static void share_out(struct strip *s, double area, double z)
{
    size_t below = STRIPS, over = STRIPS;
    for (size_t k = 0; k < STRIPS; k++) {
        if (!(s[k].weight > 0)) continue;
        if (s[k].height <= z) below = k;
        if (s[k].height > z && over == STRIPS) over = k;
    }
    double up = below == STRIPS  ? 1
                : over == STRIPS ? 0
                                 : (z - s[below].height) / (s[over].height - s[below].height);
    if (below < STRIPS) s[below].area += area * (1 - up);
    if (over < STRIPS) s[over].area += area * up;
}

static enum wf_status onto_branches(const struct carriers *c, const struct wf_outline *o, double factor,
                                    struct wf_err *e)
{
    struct wf_tree *t = c->t;
    struct strip strip[STRIPS + 1] = { 0 };
    double base = INFINITY, top = 0, found = 0;
    for (size_t i = 0; i < o->n; i++) base = fmin(base, o->z[i]), top = fmax(top, o->z[i]);
    for (size_t i = 0; i < t->n; i++) {
        struct strip *s = &strip[strip_of(t, i, base, top)];
        s->weight += c->weight[i], s->height += c->weight[i] * 0.5 * (t->z0[i] + t->z1[i]);
    }
    for (size_t k = 0; k < STRIPS; k++)
        if (strip[k].weight > 0) strip[k].height /= strip[k].weight, found += strip[k].weight;
    if (!(found > 0))
        return wf_fail(e, WF_EINPUT,
                       "%s: no shoot of the tree lies between %.4g and %.4g m, where its crown is", t->name,
                       base, top);
    for (size_t k = 0; k < STRIPS; k++) {
        double step = (top - base) / STRIPS, moment;
        double area = wf_outline_strip(o, base + step * (double)k, base + step * (double)(k + 1), &moment);
        if (area > 0) share_out(strip, area, moment / area);
    }
    for (size_t i = 0; i < t->n; i++) {
        size_t k = strip_of(t, i, base, top);
        double own = k < STRIPS && c->weight[i] > 0 ? strip[k].area * c->weight[i] / strip[k].weight : 0;
        t->sail0[i] = t->sail1[i] = factor * own / wf_tree_length(t, i);
    }
    return WF_OK;
}

/* An area alone: as the leaves are spread, or evenly over the shoots. */
static enum wf_status onto_leaves(const struct carriers *c, const struct wf_model *m, double sail,
                                  struct wf_err *e)
{
    struct wf_tree *t = c->t;
    double all = 0, now = sail_of(t);
    if (c->stem && !(now > 0))
        return wf_fail(e, WF_EINPUT,
                       "%s: a frontal area alone does not say where on the stem the crown is; give crown "
                       "width and depth, or an outline",
                       m->key);
    for (size_t i = 0; i < t->n; i++) all += c->weight[i];
    for (size_t i = 0; i < t->n; i++)
        if (now > 0)
            t->sail0[i] *= sail / now, t->sail1[i] *= sail / now;
        else
            t->sail0[i] = t->sail1[i] = sail * c->weight[i] / all / wf_tree_length(t, i);
    return WF_OK;
}

/* Share of the frontal area that is left in the model's season. */
static double season_share(const struct wf_model *m, bool stem, struct wf_diag *d)
{
    const double bare = 0.5; /* leaves raise the load 2 to 3 times: Angelou, Dellwik and Mann 2019 */
    const struct wf_silhouette *s = &m->silhouette;
    if (m->season == WF_LEAF_ON) return 1;
    if (!isnan(s->leafless)) return s->leafless;
    if (stem)
        wf_diag_warn(d, "leaf-off-share",
                     "%s: without leaves the crown's load is taken as %g of that in leaf; leaves raised the "
                     "load of an open-grown oak 2 to 3 times (Angelou et al. 2019). leaf_off_share sets it",
                     m->name, bare);
    return stem ? bare : 0;
}

static void check_areas(const struct wf_model *m, const struct wf_species *sp, double area, struct wf_diag *d)
{
    const double most = 3; /* rule of ours */
    double leaves = m->leaf_area_on * sp->crown.frontal_share.value;
    if (!(leaves > 0) || (area < most * leaves && leaves < most * area)) return;
    wf_diag_warn(d, "crown-areas",
                 "%s: the frontal area %.4g m2 and the leaf area %.4g m2 contradict each other: by the "
                 "species' frontal share %.3g the leaves show %.4g m2. The frontal area is taken for the "
                 "wind, the leaf area for the leaves' mass and rain",
                 m->name, area, m->leaf_area_on, sp->crown.frontal_share.value, leaves);
}

/* An outline of another tree, or in another unit, would hang on this one's tip. */
static enum wf_status check_top(const struct wf_model *m, double height, struct wf_err *e)
{
    const double most = 1.25; /* rule of ours */
    double top = 0;
    for (size_t i = 0; i < m->silhouette.points; i++) top = fmax(top, m->silhouette.z[i]);
    if (top <= most * height) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: the crown's outline ends %.4g m above the ground; the tree is %.4g m high", m->key,
                   top, height);
}

static void check_centre(const struct wf_model *m, const struct wf_outline *o, const struct wf_tree *t,
                         struct wf_diag *d)
{
    double moment, area = wf_outline_strip(o, -INFINITY, INFINITY, &moment), first = 0, sail = sail_of(t);
    for (size_t i = 0; i < t->n; i++)
        first += wf_tree_length(t, i) *
                 (t->sail0[i] * (2 * t->z0[i] + t->z1[i]) + t->sail1[i] * (t->z0[i] + 2 * t->z1[i])) / 6;
    if (sail > 0 && fabs(first / sail - moment / area) > 0.02 * moment / area)
        wf_diag_warn(d, "crown-centre",
                     "%s: the centre of the crown's outline is %.4g m above the ground, that of the parts of "
                     "the tree that carry it %.4g m",
                     m->name, moment / area, first / sail);
}

static enum wf_status onto_area(const struct wf_model *m, const struct wf_species *sp, struct carriers *c,
                                struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_outline o;
    double area = wf_silhouette_area(&m->silhouette),
           factor =
               season_share(m, c->stem, d) * sp->crown.drag_coefficient.value * (1 - m->silhouette.thinned);
    enum wf_status s = find_outline(m, wf_tree_height(c->t), a, &o, e);
    if (!s) s = check_top(m, wf_tree_height(c->t), e);
    if (s) return s;
    check_areas(m, sp, area, d);
    bool by_leaves = !o.n || (given(m->silhouette.area) && sail_of(c->t) > 0);
    if (by_leaves) return onto_leaves(c, m, factor * area, e);
    if (c->stem)
        onto_stem(c->t, &o, factor);
    else
        s = onto_branches(c, &o, factor, e);
    if (!s) check_centre(m, &o, c->t, d);
    return s;
}

/* Mass of the crown as the model gives it [kg]; 0: it does not. */
static enum wf_status crown_mass(const struct wf_model *m, const struct wf_species *sp,
                                 const struct wf_tree *t, struct wf_diag *d, double *mass, struct wf_err *e)
{
    const struct wf_silhouette *s = &m->silhouette;
    const struct wf_outline_size seen = wf_silhouette_size(m, wf_tree_height(t));
    const struct wf_crown_size size = { wf_tree_breast(t).diameter, seen.breadth, seen.height,
                                        m->season == WF_LEAF_ON };
    struct wf_err why = { WF_OK, "" };
    const struct wf_crown_rule *r;
    const struct wf_crown_kind *kind;
    *mass = given(s->density) ? s->density * WF_PI / 12 * seen.breadth * seen.breadth * seen.height : s->mass;
    *mass *= 1 - s->thinned;
    if (!s->by) return WF_OK;
    enum wf_status status = wf_crown_rule_mass(s->by, sp->key, &size, mass, &r, &kind, &why);
    *mass *= 1 - s->thinned;
    if (status) return wf_fail(e, status, "%s: crown_mass_by: %s", m->key, why.text);
    wf_diag_warn(d, "crown-mass-by", "%s: branches and leaves are taken as %.4g kg by %s:%s, %s (%s); for %s",
                 m->name, *mass, r->name, kind->name, r->title, r->source, r->validity);
    return WF_OK;
}

static enum wf_status onto_mass(const struct wf_model *m, const struct carriers *c, double mass,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_tree *t = c->t;
    double sail = sail_of(t);
    if (!given(mass)) {
        if (c->stem && sail > 0)
            wf_diag_warn(
                d, "crown-mass",
                "%s: the crown's mass is that of its leaves (%.4g m2) alone, without branch wood: "
                "sway is too fast and weight too low. crown_mass, crown_density or crown_mass_by gives it",
                m->name, m->leaf_area);
        return WF_OK;
    }
    if (!c->stem)
        return wf_fail(e, WF_EINPUT,
                       "%s: crown mass is for a tree without branches; the branches drawn have their own",
                       m->key);
    if (!(sail > 0) && m->season == WF_LEAF_OFF && m->silhouette.leafless == 0 &&
        wf_silhouette_area(&m->silhouette) > 0)
        return wf_fail(
            e, WF_EINPUT,
            "%s: a leaf_off_share of 0 leaves nothing of the crown for the wind to catch; its branches "
            "are not drawn and catch it. Give more than 0; 0.5 is taken unless it is given",
            m->key);
    if (!(sail > 0))
        return wf_fail(e, WF_EINPUT, "%s: crown mass is given, but the tree has no crown to carry it",
                       m->key);
    for (size_t i = 0; i < t->n; i++)
        t->burden0[i] = mass * t->sail0[i] / sail, t->burden1[i] = mass * t->sail1[i] / sail;
    return WF_OK;
}

enum wf_status wf_silhouette_onto(const struct wf_model *m, const struct wf_species *sp, struct wf_tree *t,
                                  struct wf_diag *d, struct wf_err *e)
{
    const struct wf_silhouette *s = &m->silhouette;
    struct wf_arena scratch = { 0 };
    struct carriers c;
    bool area = !isnan(wf_silhouette_area(s));
    double mass = 0;
    if (!area && !given(s->mass) && !given(s->density) && !s->by) return WF_OK;
    enum wf_status status = wf_silhouette_check(s, e);
    if (!status && !sp->crown.drag_coefficient.given)
        status = wf_fail(e, WF_EINPUT, "%s: the model has a crown, but the species table %s has no 'crown'",
                         m->key, sp->key);
    if (!status) status = find_carriers(t, &scratch, &c, e);
    if (!status && area) status = onto_area(m, sp, &c, &scratch, d, e);
    if (!status) status = crown_mass(m, sp, t, d, &mass, e);
    if (!status) status = onto_mass(m, &c, mass, d, e);
    wf_arena_free(&scratch);
    return status;
}
