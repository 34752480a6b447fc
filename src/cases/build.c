/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/build.h"
#include "base/csv.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/section.h"
#include "load/scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double or_else(double v, double otherwise) { return isnan(v) ? otherwise : v; }

static double case_length(const struct wf_case *c)
{
    return c->shape == WF_SHAPE_ARC ? c->arc[0] * c->arc[1] : c->length;
}

/* Outer and inner radius at base and tip [m]. Where EI is given without a radius: length/1000 at the base, a
 * slender rod of bending stiffness EI, so that only EI matters. */
static void case_radius(const struct wf_case *c, double outer[2], double inner[2])
{
    outer[0] = or_else(c->radius[0], case_length(c) / 1000.0);
    outer[1] = or_else(c->radius[1], outer[0]) * or_else(c->taper, 1.0);
    for (int k = 0; k < 2; k++) inner[k] = or_else(c->inner[k], 0.0);
}

/* Tree files. */

enum tree_column { ID, PARENT, X0, Y0, Z0, X1, Y1, Z1, R0, R1, LEVEL, TREE_COLUMNS };
static const char *const tree_column_names[TREE_COLUMNS] = { "id",      "parent",  "x0",   "y0",
                                                             "z0",      "x1",      "y1",   "z1",
                                                             "radius0", "radius1", "level" };

struct tree_row {
    long long id, parent, level;
    double v[R1 + 1]; /* X0..R1 */
};

struct by_id {
    long long id;
    int32_t row;
};

static int compare_ids(const void *a, const void *b)
{
    const struct by_id *x = a, *y = b;
    return (x->id > y->id) - (x->id < y->id);
}

static bool tree_row_read(struct wf_csv *f, const size_t at[TREE_COLUMNS], struct tree_row *r)
{
    bool ok = wf_csv_integer(f, at[ID], 1, INT64_MAX, &r->id);
    ok &= wf_csv_integer(f, at[PARENT], 0, INT64_MAX, &r->parent);
    ok &= wf_csv_integer(f, at[LEVEL], 0, 1000, &r->level);
    for (size_t k = X0; k <= Z1; k++) ok &= wf_csv_number(f, at[k], -1e6, 1e6, &r->v[k]);
    for (size_t k = R0; k <= R1; k++) ok &= wf_csv_number(f, at[k], 1e-9, 1e3, &r->v[k]);
    return ok;
}

static enum wf_status tree_from_rows(const struct tree_row *r, size_t n, const char *path, struct wf_arena *a,
                                     struct wf_tree *t, struct wf_err *e)
{
    struct by_id *index = WF_TAKE(a, n, struct by_id);
    if (!index) return wf_fail(e, WF_ENOMEM, "%s: no memory for %zu rows", path, n);
    for (size_t i = 0; i < n; i++) index[i] = (struct by_id){ r[i].id, (int32_t)i };
    qsort(index, n, sizeof *index, compare_ids);
    if (wf_tree_alloc(t, n, a, e)) return e->code;
    for (size_t i = 0; i < n; i++) {
        struct by_id key = { r[i].parent, 0 },
                     *found = r[i].parent ? bsearch(&key, index, n, sizeof key, compare_ids) : NULL;
        if (r[i].parent && (!found || found->row >= (int32_t)i))
            return wf_fail(e, WF_EINPUT, "%s: row with id %lld: its parent %lld is not a row above it", path,
                           r[i].id, r[i].parent);
        t->parent[i] = found ? found->row : -1;
        t->id[i] = r[i].id;
        t->level[i] = (int32_t)r[i].level;
        t->x0[i] = r[i].v[X0], t->y0[i] = r[i].v[Y0], t->z0[i] = r[i].v[Z0];
        t->x1[i] = r[i].v[X1], t->y1[i] = r[i].v[Y1], t->z1[i] = r[i].v[Z1];
        t->r0[i] = r[i].v[R0], t->r1[i] = r[i].v[R1];
    }
    return WF_OK;
}

enum wf_status wf_case_tree_read(const char *path, struct wf_arena *a, struct wf_tree *t, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_csv f;
    size_t at[TREE_COLUMNS];
    struct wf_list rows = { 0 };
    if (wf_csv_open(&f, path, a, &d, e)) return e->code;
    for (size_t k = 0; k < TREE_COLUMNS; k++) at[k] = wf_csv_need(&f, tree_column_names[k]);
    while (!d.errors && wf_csv_next(&f)) {
        struct tree_row r;
        if (tree_row_read(&f, at, &r) && !wf_list_add(&rows, &r, sizeof r, a))
            return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    }
    if (d.errors) {
        char text[900];
        return wf_fail(e, WF_EINPUT, "%s", wf_finding_print(d.first, text, sizeof text));
    }
    if (!rows.n) return wf_fail(e, WF_EINPUT, "%s: no rows", path);
    return tree_from_rows(rows.data, rows.n, path, a, t, e);
}

/* The structure of a validation case as a tree of rows, before any splitting. */

static void add_share(double *s, size_t *n, const struct wf_place *p)
{
    if (p->kind == WF_PLACE_AT) s[(*n)++] = p->share;
}

/* Row boundaries as shares of the length: evenly spaced, and at every place that the case names. */
static double *boundaries(const struct wf_case *c, struct wf_arena *a, size_t *rows)
{
    size_t even = (size_t)c->rows, n = 0, kept = 0;
    double *s = WF_TAKE(a, even + 1 + c->loads.n + c->masses.n + c->wants.n, double);
    if (!s) return NULL;
    for (size_t i = 0; i <= even; i++) s[n++] = (double)i / (double)even;
    const struct wf_case_load *l = c->loads.data;
    const struct wf_case_mass *m = c->masses.data;
    const struct wf_want *w = c->wants.data;
    for (size_t i = 0; i < c->loads.n; i++) add_share(s, &n, &l[i].at);
    for (size_t i = 0; i < c->masses.n; i++) add_share(s, &n, &m[i].at);
    for (size_t i = 0; i < c->wants.n; i++) add_share(s, &n, &w[i].at);
    qsort(s, n, sizeof *s, wf_ascending);
    for (size_t i = 1; i < n; i++)
        if (s[i] - s[kept] > 1e-9) s[++kept] = s[i];
    *rows = kept;
    return s;
}

/* Point of the unloaded axis at arc length s [m]: straight, or on a circle with root tangent f that bends
 * towards n. */
static void axis_point(const struct wf_case *c, const double f[3], const double n[3], double s, double x[3])
{
    double r = c->arc[0], u = s, v = 0.0;
    if (c->shape == WF_SHAPE_ARC) u = r * sin(s / r), v = r * (1.0 - cos(s / r));
    for (int j = 0; j < 3; j++) x[j] = u * f[j] + v * n[j];
}

static void unit_vector(const double in[3], double out[3])
{
    double size = sqrt(wf_dot(in, in));
    for (int j = 0; j < 3; j++) out[j] = in[j] / size;
}

static enum wf_status single_axis(const struct wf_case *c, struct wf_arena *a, struct wf_setup *s,
                                  struct wf_tree *t, struct wf_err *e)
{
    const double least_top = 0.004; /* share of the length below the tip where a power taper ends */
    bool arc = c->shape == WF_SHAPE_ARC;
    double length = case_length(c), f[3], n[3] = { 0 }, curvature[3];
    size_t rows;
    double *share = boundaries(c, a, &rows);
    if (!share) return wf_fail(e, WF_ENOMEM, "no memory");
    if (wf_tree_alloc(t, rows, a, e)) return e->code;
    if (arc && !(t->bend = WF_TAKE(a, 3 * rows, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    s->end = share + 1;
    unit_vector(arc ? c->arc_from : c->direction, f);
    if (arc) unit_vector(c->arc_towards, n);
    wf_cross(f, n, curvature);
    for (size_t i = 0; i < rows; i++) {
        double x[3], r[2], q[2];
        t->parent[i] = (int32_t)i - 1;
        t->id[i] = (int64_t)i + 1;
        axis_point(c, f, n, share[i] * length, x);
        t->x0[i] = x[0], t->y0[i] = x[1], t->z0[i] = x[2];
        axis_point(c, f, n, share[i + 1] * length, x);
        t->x1[i] = x[0], t->y1[i] = x[1], t->z1[i] = x[2];
        for (size_t k = 0; k < 2; k++) {
            case_radius(c, r, q);
            double at = share[i + k], outer = wf_between(r[0], r[1], at), inner = wf_between(q[0], q[1], at);
            if (!isnan(c->taper_power)) outer = r[0] * pow(fmax(1.0 - at, least_top), c->taper_power);
            (k ? t->r1 : t->r0)[i] = outer;
            (k ? t->i1 : t->i0)[i] = inner;
        }
        for (size_t j = 0; arc && j < 3; j++) t->bend[3 * i + j] = curvature[j] / c->arc[0];
    }
    return WF_OK;
}

static enum wf_status branch_rows(const struct wf_case *c, struct wf_arena *a, struct wf_tree *t,
                                  struct wf_err *e)
{
    const struct wf_case_branch *b = c->branches.data;
    const struct wf_case_node *node = c->nodes.data;
    if (wf_tree_alloc(t, c->branches.n, a, e)) return e->code;
    for (size_t i = 0; i < c->branches.n; i++) {
        const struct wf_case_node *from = node, *to = node;
        while (from->id != b[i].from) from++;
        while (to->id != b[i].to) to++;
        t->parent[i] = -1;
        for (size_t k = 0; k < i; k++)
            if (b[k].to == b[i].from) t->parent[i] = (int32_t)k;
        t->level[i] = t->parent[i] < 0 ? 0 : t->level[t->parent[i]] + 1;
        t->id[i] = b[i].to;
        t->x0[i] = from->x[0], t->y0[i] = from->x[1], t->z0[i] = from->x[2];
        t->x1[i] = to->x[0], t->y1[i] = to->x[1], t->z1[i] = to->x[2];
        t->r0[i] = b[i].radius[0], t->r1[i] = b[i].radius[1];
    }
    return WF_OK;
}

/* Read the tree file beside the case file, or in the folder that WINDFIRM_REFERENCE names (for files too
 * large to ship). */
static enum wf_status read_tree_file(const struct wf_case *c, struct wf_arena *a, struct wf_tree *t,
                                     struct wf_err *e)
{
    const char *slash = strrchr(c->file, '/'), *folder = getenv("WINDFIRM_REFERENCE");
    const char *beside =
        wf_arena_print(a, "%.*s%s", slash ? (int)(slash - c->file + 1) : 0, c->file, c->tree_file);
    const char *apart = folder ? wf_arena_print(a, "%s/%s", folder, c->tree_file) : NULL;
    if (!beside) return wf_fail(e, WF_ENOMEM, "no memory");
    if (access(beside, R_OK) == 0) return wf_case_tree_read(beside, a, t, e);
    if (apart && access(apart, R_OK) == 0) return wf_case_tree_read(apart, a, t, e);
    return wf_fail(e, WF_EMISSING, "tree file %s is not there%s", c->tree_file,
                   folder ? "" : "; WINDFIRM_REFERENCE can name a folder that holds it");
}

/* Parents, coordinates, radii and ids of the case's structure; s->end for a single axis. Errors: WF_EINPUT,
 * WF_ENOMEM; WF_EMISSING when a tree file does not exist. */
static enum wf_status case_shape_build(const struct wf_case *c, struct wf_arena *a, struct wf_setup *s,
                                       struct wf_tree *t, struct wf_err *e)
{
    switch (c->shape) {
    case WF_SHAPE_CANTILEVER:
    case WF_SHAPE_ARC:
        return single_axis(c, a, s, t, e);
    case WF_SHAPE_BRANCHES:
        return branch_rows(c, a, t, e);
    case WF_SHAPE_TREE:
        return read_tree_file(c, a, t, e);
    case WF_SHAPE_FLOW:
    case WF_SHAPE_GUST:
    case WF_SHAPE_FIT:
    case WF_SHAPE_NONE:
        break;
    }
    return wf_fail(e, WF_EINTERNAL, "%s:%zu: a case without a structure", c->file, c->line);
}

/* Splitting rows. */

/* Point at share s of a row's arc: on the chord of a straight row, on the circle of a curved one. A circle
 * of curvature vector k (perpendicular to the chord of length c, direction d) starts in the direction d
 * rotated back by half its angle about k. */
static void point_at(const struct wf_tree *t, size_t i, double s, double x[3])
{
    double base[3] = { t->x0[i], t->y0[i], t->z0[i] }, chord[3], along[3], side[3];
    for (int j = 0; j < 3; j++) chord[j] = (double[]){ t->x1[i], t->y1[i], t->z1[i] }[j] - base[j];
    double c = sqrt(wf_dot(chord, chord)),
           kappa = t->bend ? sqrt(wf_dot(t->bend + 3 * i, t->bend + 3 * i)) : 0.0;
    if (kappa * c < 1e-12) {
        for (int j = 0; j < 3; j++) x[j] = base[j] + s * chord[j];
        return;
    }
    double angle = 2.0 * asin(0.5 * kappa * c), unit[3];
    for (int j = 0; j < 3; j++) unit[j] = t->bend[3 * i + (size_t)j] / kappa, along[j] = chord[j] / c;
    wf_cross(unit, along, side);
    /* tangent at the base: cos(a/2) d - sin(a/2) (k x d); its normal: cos(a/2) (k x d) + sin(a/2) d */
    double ch = cos(0.5 * angle), sh = sin(0.5 * angle), u = sin(s * angle) / kappa,
           v = (1.0 - cos(s * angle)) / kappa;
    for (int j = 0; j < 3; j++)
        x[j] = base[j] + u * (ch * along[j] - sh * side[j]) + v * (ch * side[j] + sh * along[j]);
}

static void split_row(const struct wf_tree *t, const double *line, size_t i, size_t pieces, struct wf_tree *o,
                      double *out_line)
{
    for (size_t p = 0; p < pieces; p++) {
        size_t j = i * pieces + p;
        double s0 = (double)p / (double)pieces, s1 = (double)(p + 1) / (double)pieces, x[3];
        o->parent[j] = p                  ? (int32_t)j - 1
                       : t->parent[i] < 0 ? -1
                                          : (int32_t)((size_t)t->parent[i] * pieces + pieces - 1);
        o->level[j] = t->level[i];
        o->id[j] = t->id[i];
        point_at(t, i, s0, x);
        o->x0[j] = x[0], o->y0[j] = x[1], o->z0[j] = x[2];
        point_at(t, i, s1, x);
        o->x1[j] = x[0], o->y1[j] = x[1], o->z1[j] = x[2];
        double *const pair[][4] = { { t->r0, t->r1, o->r0, o->r1 },
                                    { t->i0, t->i1, o->i0, o->i1 },
                                    { t->sail0, t->sail1, o->sail0, o->sail1 },
                                    { t->leaf0, t->leaf1, o->leaf0, o->leaf1 },
                                    { t->burden0, t->burden1, o->burden0, o->burden1 } };
        for (size_t k = 0; k < WF_COUNT(pair); k++) {
            pair[k][2][j] = wf_between(pair[k][0][i], pair[k][1][i], s0);
            pair[k][3][j] = wf_between(pair[k][0][i], pair[k][1][i], s1);
        }
        double *const same[][2] = { { t->youngs, o->youngs },
                                    { t->shear, o->shear },
                                    { t->density, o->density },
                                    { t->strength, o->strength },
                                    { t->drag, o->drag },
                                    { t->lift, o->lift },
                                    { t->damping, o->damping },
                                    { t->compressive, o->compressive },
                                    { t->shearing, o->shearing },
                                    { t->tangential, o->tangential },
                                    { t->transverse, o->transverse } };
        for (size_t k = 0; k < WF_COUNT(same); k++) same[k][1][j] = same[k][0][i];
        if (t->bend) memcpy(o->bend + 3 * j, t->bend + 3 * i, 3 * sizeof(double));
        if (t->stiff) memcpy(o->stiff + 4 * j, t->stiff + 4 * i, 4 * sizeof(double));
        if (t->mass1) o->mass1[j] = p + 1 == pieces ? t->mass1[i] : 0.0;
        for (size_t k = 0; line && k < 3; k++) {
            out_line[6 * j + k] = wf_between(line[6 * i + k], line[6 * i + 3 + k], s0);
            out_line[6 * j + 3 + k] = wf_between(line[6 * i + k], line[6 * i + 3 + k], s1);
        }
    }
}

enum wf_status wf_tree_split(const struct wf_tree *t, const double *line, size_t pieces, struct wf_arena *a,
                             struct wf_tree *out, double **out_line, struct wf_err *e)
{
    size_t n = t->n * pieces;
    if (pieces == 0 || n / pieces != t->n || n > INT32_MAX)
        return wf_fail(e, WF_EINPUT, "a mesh of %zu x %zu rows is too fine", t->n, pieces);
    if (wf_tree_alloc(out, n, a, e)) return e->code;
    out->name = t->name;
    *out_line = line ? WF_TAKE(a, 6 * n, double) : NULL;
    if (t->bend) out->bend = WF_TAKE(a, 3 * n, double);
    if (t->stiff) out->stiff = WF_TAKE(a, 4 * n, double);
    if (t->mass1) out->mass1 = WF_TAKE(a, n, double);
    if ((line && !*out_line) || (t->bend && !out->bend) || (t->stiff && !out->stiff) ||
        (t->mass1 && !out->mass1))
        return wf_fail(e, WF_ENOMEM, "no memory for a tree of %zu rows", n);
    for (size_t i = 0; i < t->n; i++) split_row(t, line, i, pieces, out, *out_line);
    return WF_OK;
}

/* Material, loads and options. */

/* Breadth of the crown over its largest at a height z [m] of a stem of length l: a diamond from the side. */
static double diamond(const struct wf_case_gust *g, double l, double z)
{
    double in = (z - (l - g->crown_depth)) / g->crown_depth;
    return in > 0.0 && in < 1.0 ? 1.0 - fabs(2.0 * in - 1.0) : 0.0;
}

/* Drag area, mass and strength of the crown and wood of a cantilever that is a stem onto its rows. */
static void case_crown(const struct wf_case *c, struct wf_tree *t)
{
    const struct wf_case_gust *g = &c->gust;
    double profile = 0.0;
    for (size_t i = 0; i < t->n; i++)
        if (!isnan(g->strength)) t->strength[i] = g->strength;
    if (isnan(g->crown_depth) || c->shape != WF_SHAPE_CANTILEVER) return;
    for (size_t i = 0; i < t->n; i++) {
        double b0 = diamond(g, c->length, t->z0[i]), b1 = diamond(g, c->length, t->z1[i]);
        profile += 0.5 * (b0 + b1) * (t->z1[i] - t->z0[i]);
        t->sail0[i] = b0 * g->crown_width * g->crown_drag, t->sail1[i] = b1 * g->crown_width * g->crown_drag;
        t->burden0[i] = b0 * g->crown_mass, t->burden1[i] = b1 * g->crown_mass;
    }
    for (size_t i = 0; i < t->n; i++) t->burden0[i] /= profile, t->burden1[i] /= profile;
}

/* Section and material of every row. Returned: *ei, *mass: bending stiffness and mass per length at the base
 * of a single axis. */
static enum wf_status case_material(const struct wf_case *c, struct wf_tree *t, struct wf_arena *a,
                                    double *ei, double *mass, struct wf_err *e)
{
    double r = t->r0[0], q = t->i0[0], area = wf_ring_area(r, q), inertia = wf_ring_inertia(r, q);
    double youngs = or_else(c->youngs, c->ei / inertia), poisson = or_else(c->poisson, 0.0);
    double shear = or_else(c->shear, 0.5 * youngs / (1.0 + poisson));
    *mass = or_else(c->mass_per_length, or_else(c->density * area, isnan(c->weight_parameter) ? 0.0 : 1.0));
    *ei = youngs * inertia;
    double density = or_else(c->density, *mass / area);
    bool direct = !isnan(c->ea);
    if (direct && !(t->stiff = WF_TAKE(a, 4 * t->n, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < t->n; i++) {
        t->youngs[i] = youngs;
        t->shear[i] = shear;
        t->density[i] = density;
        t->drag[i] = c->axis_drag ? c->drag : or_else(c->drag, 0.0);
        t->sail0[i] = t->sail1[i] = or_else(c->crown_area, 0.0);
        if (direct) memcpy(t->stiff + 4 * i, (double[]){ c->ea, c->ga, c->ei, c->gj }, 4 * sizeof(double));
    }
    case_crown(c, t);
    return WF_OK;
}

/* Dead loads per length: uniform, and proportional to the radius (given at the base). */
static double *case_line_load(const struct wf_case *c, const struct wf_tree *t, struct wf_arena *a)
{
    double *line = WF_TAKE(a, 6 * t->n, double);
    for (size_t i = 0; line && i < t->n; i++)
        for (size_t k = 0; k < 3; k++) {
            double uniform = or_else(c->line_load[k], 0.0),
                   by_radius = or_else(c->line_by_radius[k], 0.0) / t->r0[0];
            line[6 * i + k] = uniform + by_radius * t->r0[i];
            line[6 * i + 3 + k] = uniform + by_radius * t->r1[i];
        }
    return line;
}

/* Row of a place before splitting; -1 the base, -2 no such place. */
static int32_t row_of_place(const struct wf_setup *s, const struct wf_tree *t, const struct wf_place *p)
{
    switch (p->kind) {
    case WF_PLACE_BASE:
    case WF_PLACE_NONE:
    case WF_PLACE_POINT:
        return -1;
    case WF_PLACE_TIP:
        return (int32_t)t->n - 1;
    case WF_PLACE_AT:
        if (p->share < 1e-9) return -1;
        for (size_t i = 0; i < t->n; i++)
            if (fabs(s->end[i] - p->share) <= 1e-9) return (int32_t)i;
        return -2;
    case WF_PLACE_NODE:
    case WF_PLACE_ROW:
        for (size_t i = 0; i < t->n; i++)
            if (t->id[i] == p->id) return (int32_t)i;
        return -2;
    }
    return -2;
}

int32_t wf_setup_row(const struct wf_setup *s, const struct wf_place *p)
{
    return p->row < 0 ? -1 : s->last[p->row];
}

static enum wf_status find_place(const struct wf_case *c, const struct wf_setup *s, const struct wf_tree *t,
                                 struct wf_place *p, size_t line, struct wf_err *e)
{
    p->row = row_of_place(s, t, p);
    if (p->row > -2) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s:%zu: there is no node or row %lld", c->file, line, (long long)p->id);
}

/* Find the rows of every place that the case names; add point masses to the tree. */
static enum wf_status find_places(const struct wf_case *c, const struct wf_setup *s, struct wf_tree *t,
                                  struct wf_arena *a, struct wf_err *e)
{
    struct wf_case_load *l = c->loads.data;
    struct wf_case_mass *m = c->masses.data;
    struct wf_want *w = c->wants.data;
    for (size_t i = 0; i < c->loads.n; i++)
        if (find_place(c, s, t, &l[i].at, l[i].line, e)) return e->code;
    for (size_t i = 0; i < c->wants.n; i++)
        if (find_place(c, s, t, &w[i].at, w[i].line, e)) return e->code;
    if (c->masses.n && !(t->mass1 = WF_TAKE(a, t->n, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < c->masses.n; i++) {
        if (find_place(c, s, t, &m[i].at, m[i].line, e)) return e->code;
        if (m[i].at.row >= 0) t->mass1[m[i].at.row] += m[i].mass;
    }
    return WF_OK;
}

static enum wf_status case_point_loads(const struct wf_case *c, struct wf_setup *s, struct wf_arena *a,
                                       struct wf_err *e)
{
    const struct wf_case_load *l = c->loads.data;
    struct wf_point_load *p = WF_TAKE(a, c->loads.n, struct wf_point_load);
    if (!p) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < c->loads.n; i++) {
        if (wf_setup_row(s, &l[i].at) < 0)
            return wf_fail(e, WF_EINPUT, "%s:%zu: the base is fixed; a load there has no effect", c->file,
                           l[i].line);
        p[i].segment = wf_setup_row(s, &l[i].at);
        p[i].kind = l[i].follower ? WF_POINT_FOLLOWER : WF_POINT_DEAD;
        memcpy(l[i].moment ? p[i].moment : p[i].force, l[i].value, sizeof l[i].value);
    }
    s->loads.point = p;
    s->loads.points = c->loads.n;
    return WF_OK;
}

/* The scene's uniform wind; the wind of a case may have an upward component, which an azimuth cannot give. */
static void uniform_wind(const double u[3], double speed, struct wf_wind *out)
{
    struct wf_scenario scene;
    wf_scenario_default(&scene);
    scene.profile = "uniform";
    wf_scenario_wind(&scene, out);
    out->speed = speed;
    for (int k = 0; k < 3; k++) out->direction[k] = u[k] / speed;
}

/* Wind, air and gravity. Air and laws are numbers of the case, not of a site and a species: it may be water,
 * or have a density by its Cauchy number 1/2 rho Cd D U^2 L^3/EI; weight parameter m g L^3/EI with base
 * values. */
static void set_case_loads(const struct wf_case *c, struct wf_setup *s, double ei, double mass,
                           double diameter)
{
    double u[3] = { or_else(c->wind[0], isnan(c->cauchy) ? 0.0 : 1.0), or_else(c->wind[1], 0.0),
                    or_else(c->wind[2], 0.0) };
    double length = case_length(c), speed = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    wf_loads_default(&s->loads);
    s->loads.air_density = or_else(c->air_density, s->loads.air_density);
    s->loads.air_viscosity = or_else(c->air_viscosity, s->loads.air_viscosity);
    if (c->axis_drag) s->loads.axis_drag = c->axis_drag, s->loads.axis_drag_par = c->axis_drag_par;
    s->loads.streamline = c->streamlining, s->loads.streamline_par = c->streamlining_par;
    s->loads.gravity = or_else(c->gravity, 0.0);
    if (!isnan(c->weight_parameter)) s->loads.gravity = c->weight_parameter * ei / (mass * pow(length, 3));
    if (speed > 0.0) {
        uniform_wind(u, speed, &s->wind);
        s->loads.wind = &s->wind;
        if (!isnan(c->cauchy))
            s->loads.air_density =
                2.0 * c->cauchy * ei / (c->drag * diameter * speed * speed * pow(length, 3));
    }
}

static void set_case_options(const struct wf_case *c, struct wf_solve_options *o)
{
    wf_solve_options_default(o);
    o->inextensible = c->model == WF_MODEL_K;
    o->shear_flexible = c->model == WF_MODEL_SR;
    o->shear_factor = or_else(c->shear_factor, 0.0);
    o->tolerance = or_else(c->accuracy, o->tolerance);
    o->mesh_tolerance = or_else(c->mesh_tolerance, o->mesh_tolerance);
    for (int k = 0; k < 2; k++) o->root_stiffness[k] = or_else(c->spring[k], 0.0);
}

enum wf_status wf_setup_build(const struct wf_case *c, size_t pieces, struct wf_arena *a, struct wf_setup *s,
                              struct wf_err *e)
{
    struct wf_tree rows;
    double ei, mass, *line = NULL, *split_line;
    *s = (struct wf_setup){ 0 };
    if (case_shape_build(c, a, s, &rows, e) || case_material(c, &rows, a, &ei, &mass, e) ||
        find_places(c, s, &rows, a, e))
        return e->code;
    set_case_loads(c, s, ei, mass, 2.0 * rows.r0[0]);
    set_case_options(c, &s->options);
    if ((!isnan(c->line_load[0]) || !isnan(c->line_by_radius[0])) && !(line = case_line_load(c, &rows, a)))
        return wf_fail(e, WF_ENOMEM, "no memory");
    if (wf_tree_split(&rows, line, pieces, a, &s->tree, &split_line, e)) return e->code;
    s->tree.name = c->name;
    s->loads.line = split_line;
    s->rows = rows.n;
    if (!(s->last = WF_TAKE(a, rows.n, int32_t))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < rows.n; i++) s->last[i] = (int32_t)((i + 1) * pieces - 1);
    return case_point_loads(c, s, a, e);
}
