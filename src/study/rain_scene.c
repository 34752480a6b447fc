/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/rain_scene.h"
#include "base/num.h"
#include "base/vec3.h"
#include "data/species.h"
#include "solve/prism_rest.h"
#include <math.h>
#include <string.h>

void wf_scene_spec_default(struct wf_scene_spec *s)
{
    *s = (struct wf_scene_spec){ .form = &wf_leaf_forms[0],
                                 .leaves = 5,
                                 .leaf_length = 0.08,
                                 .petiole = 0.03,
                                 .branch = 0.4,
                                 .radius = { 3e-3, 1.5e-3 },
                                 .height = 2,
                                 .rise = 0.2,
                                 .droop = 0.5,
                                 .fold = 0.15,
                                 .petiole_radius = 0.8e-3,
                                 .petiole_youngs = 0.5e9,
                                 .petiole_density = 900,
                                 .bend_over_twist = 4.3,
                                 .prisms = 16,
                                 .petiole_prisms = 4,
                                 .vein_prisms = 6,
                                 .mesh = { 24, 10 } };
}

void wf_scene_spec_leaf(struct wf_scene_spec *s)
{
    const struct wf_crown *c = &s->species->crown;
    const struct wf_blade unit = { s->form, 1, s->form->breadth / 2 };
    if (c->leaf_area.given) s->leaf_length = sqrt(c->leaf_area.value / wf_blade_area(&unit));
    if (c->petiole_length.given) s->petiole = c->petiole_length.value;
    if (c->petiole_diameter.given) s->petiole_radius = c->petiole_diameter.value / 2;
    if (c->petiole_modulus.given) s->petiole_youngs = c->petiole_modulus.value;
}

/* ---- An axis of a tree ---- */

/* The row that goes on with the axis of row i; t->n: none. */
static size_t row_after(const struct wf_tree *t, size_t i)
{
    for (size_t k = i + 1; k < t->n; k++)
        if (t->parent[k] == (int32_t)i && t->level[k] == t->level[i]) return k;
    return t->n;
}

static size_t axis_base(const struct wf_tree *t, size_t i)
{
    while (t->parent[i] >= 0 && t->level[t->parent[i]] == t->level[i]) i = (size_t)t->parent[i];
    return i;
}

static double axis_length(const struct wf_tree *t, size_t i, size_t *rows)
{
    double length = 0;
    for (*rows = 0; i < t->n; i = row_after(t, i)) length += wf_tree_length(t, i), ++*rows;
    return length;
}

/* Base of the longest axis of the highest level, or of the axis with that segment; t->n: there is none. */
static size_t find_axis(const struct wf_tree *t, int64_t id)
{
    size_t best = t->n, rows;
    int32_t level = 0;
    double longest = 0;
    for (size_t i = 0; i < t->n; i++) {
        if (id && t->id[i] == id) return axis_base(t, i);
        if (t->level[i] > level) level = t->level[i];
    }
    for (size_t i = 0; i < t->n && !id; i++) {
        if (t->level[i] != level || axis_base(t, i) != i) continue;
        double length = axis_length(t, i, &rows);
        if (length > longest) longest = length, best = i;
    }
    return best;
}

enum wf_status wf_scene_axis(const struct wf_tree *t, int64_t id, struct wf_scene_spec *s, struct wf_arena *a,
                             struct wf_err *e)
{
    enum { LEAST = 8, MOST = 256 };
    size_t base = find_axis(t, id), rows, n = 0;
    if (base == t->n) return wf_fail(e, WF_EINPUT, "the tree has no segment with the id %lld", (long long)id);
    s->branch = axis_length(t, base, &rows);
    size_t cuts = (LEAST + rows - 1) / rows;
    if (rows * cuts > MOST)
        return wf_fail(e, WF_EINPUT, "the axis has %zu segments; at most %d are taken", rows, MOST);
    double *nodes = WF_TAKE(a, 3 * (rows * cuts + 1), double);
    double *thick = WF_TAKE(a, rows * cuts + 1, double);
    if (!nodes || !thick) return wf_fail(e, WF_ENOMEM, "not enough memory for the branch");
    const double foot[3] = { t->x0[base], t->y0[base], 0 };
    s->radius[0] = t->r0[base], s->height = t->z0[base];
    for (size_t i = base; i < t->n; i = row_after(t, i)) {
        const double low[3] = { t->x0[i], t->y0[i], t->z0[i] }, high[3] = { t->x1[i], t->y1[i], t->z1[i] };
        for (size_t k = n ? 1 : 0; k <= cuts; k++, n++) {
            double share = (double)k / (double)cuts;
            for (size_t c = 0; c < 3; c++) nodes[3 * n + c] = wf_between(low[c], high[c], share) - foot[c];
            thick[n] = wf_between(t->r0[i], t->r1[i], share);
        }
        s->radius[1] = t->r1[i];
    }
    s->nodes = nodes, s->thick = thick, s->node_count = n;
    s->wood = wf_species_wood(s->species, t->level[base], t->r0[base]);
    return WF_OK;
}

/* ---- Axes ---- */

/* Columns of an axis, filled segment by segment. */
static enum wf_status open_axis(struct wf_prism_axis *x, size_t segments, struct wf_arena *a,
                                struct wf_err *e)
{
    *x = (struct wf_prism_axis){ .segments = segments, .on = -1 };
    x->place = WF_TAKE(a, 3 * (segments + 1), double);
    x->bending = WF_TAKE(a, segments, double), x->torsion = WF_TAKE(a, segments, double);
    x->mass = WF_TAKE(a, segments + 1, double), x->polar = WF_TAKE(a, segments + 1, double);
    x->plate = WF_TAKE(a, segments + 1, double), x->half = WF_TAKE(a, segments + 1, double);
    if (!x->place || !x->bending || !x->torsion || !x->mass || !x->polar || !x->plate || !x->half)
        return wf_fail(e, WF_ENOMEM, "not enough memory for the scene");
    return WF_OK;
}

/* A round segment of mean radius r and length h: half its mass on each of its nodes. */
static void set_segment(struct wf_prism_axis *x, size_t i, double r, double h, double youngs, double shear,
                        double density)
{
    double inertia = WF_PI / 4 * r * r * r * r;
    ((double *)x->bending)[i] = youngs * inertia;
    ((double *)x->torsion)[i] = 2 * shear * inertia;
    for (size_t k = i; k < i + 2; k++) {
        ((double *)x->mass)[k] += density * WF_PI * r * r * h / 2;
        ((double *)x->polar)[k] += density * inertia * h;
    }
}

static enum wf_status make_branch(const struct wf_scene_spec *s, struct wf_arena *a, struct wf_prism_axis *x,
                                  struct wf_err *e)
{
    const struct wf_level *wood = s->wood;
    size_t n = s->nodes ? s->node_count - 1 : s->prisms;
    enum wf_status status = open_axis(x, n, a, e);
    double *place = (double *)x->place, length = 0, done = 0;
    if (status) return status;
    for (size_t i = 0; i <= n; i++) {
        double at = s->branch * (double)i / (double)n;
        const double straight[3] = { at * cos(s->rise), 0, s->height + at * sin(s->rise) };
        memcpy(place + 3 * i, s->nodes ? s->nodes + 3 * i : straight, sizeof straight);
    }
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < n; i++) {
            double d[3];
            for (size_t c = 0; c < 3; c++) d[c] = place[3 * i + 3 + c] - place[3 * i + c];
            double h = sqrt(wf_dot(d, d));
            if (!pass) {
                length += h;
                continue;
            }
            double r = s->thick ? (s->thick[i] + s->thick[i + 1]) / 2
                                : wf_between(s->radius[0], s->radius[1], (done + h / 2) / length);
            double shear =
                wood->shear_modulus.given ? wood->shear_modulus.value : wood->youngs_modulus.value / 16;
            set_segment(x, i, r, h, wood->youngs_modulus.value, shear, wood->density.value);
            done += h;
        }
    /* up, or where the branch stands upright to the side */
    double up = place[5] - place[2];
    x->normal[hypot(place[3] - place[0], place[4] - place[1]) < 0.1 * fabs(up) ? 0 : 2] = 1;
    return WF_OK;
}

/* Where a leaf stands and points to: sides in turn, the last one straight on. */
static void leaf_way(const struct wf_scene_spec *s, const double *place, size_t sections, size_t k,
                     size_t *on, double way[3])
{
    double share = s->leaves > 1 ? 0.35 + 0.65 * (double)k / (double)(s->leaves - 1) : 1;
    bool last = k + 1 == s->leaves;
    double azimuth = last ? 0 : (k % 2 ? -1 : 1) * 1.05;
    *on = (size_t)(share * (double)(sections - 1) + 0.5);
    if (*on < 1) *on = 1;
    /* forward along the branch as seen from above; an upright one has none of its own */
    double forward[2] = { place[3 * *on] - place[3 * *on - 3], place[3 * *on + 1] - place[3 * *on - 2] };
    double size = hypot(forward[0], forward[1]), up = place[3 * *on + 2] - place[3 * *on - 1];
    if (size < 1e-6 * fabs(up)) forward[0] = size = 1, forward[1] = 0;
    double c = cos(azimuth) / size, q = sin(azimuth) / size;
    way[0] = (c * forward[0] - q * forward[1]) * cos(s->droop);
    way[1] = (c * forward[1] + q * forward[0]) * cos(s->droop);
    way[2] = -sin(s->droop);
}

static enum wf_status make_leaf(const struct wf_scene_spec *s, const struct wf_blade *b, const double from[3],
                                const double way[3], struct wf_arena *a, struct wf_prism_axis *x,
                                struct wf_err *e)
{
    size_t n = s->petiole_prisms + s->vein_prisms;
    enum wf_status status = open_axis(x, n, a, e);
    if (status) return status;
    double *place = (double *)x->place, along = 0, mass = s->species->crown.leaf_mass_per_area.value;
    double h[2] = { s->petiole / (double)s->petiole_prisms, s->leaf_length / (double)s->vein_prisms };
    for (size_t i = 0; i <= n; i++) {
        bool vein = i >= s->petiole_prisms;
        double step = vein ? h[1] : h[0], at = vein ? (double)(i - s->petiole_prisms) * h[1] : 0;
        for (size_t c = 0; c < 3; c++) place[3 * i + c] = from[c] + along * way[c];
        if (i < n) {
            double r = s->petiole_radius * (vein ? 1 - 0.5 * (at + h[1] / 2) / s->leaf_length : 1);
            double shear = s->petiole_youngs / (2 * s->bend_over_twist);
            set_segment(x, i, r, step, s->petiole_youngs, shear, s->petiole_density);
        }
        along += step;
        enum { PARTS = 40 }; /* of the strip of blade that a node of the vein carries */
        double area = 0, second = 0;
        for (int k = 0; k < PARTS && vein; k++) {
            double w = wf_blade_half(b, at + ((k + 0.5) / PARTS - 0.5) * h[1]), dx = h[1] / PARTS;
            area += 2 * w * dx, second += 2 * w * w * w * dx;
        }
        ((double *)x->plate)[i] = mass * area;
        ((double *)x->half)[i] = area > 0 ? sqrt(second / area) : 0;
    }
    double up = way[2];
    for (int c = 0; c < 3; c++) x->normal[c] = (c == 2) - up * way[c];
    x->diagonal = s->diagonal, x->restoring = s->restoring, x->fold = tan(s->fold);
    return WF_OK;
}

/* ---- Blades, wood, boxes ---- */

void wf_scene_blade_point(const struct wf_rain_scene *s, size_t k, const double at[2],
                          struct wf_prism_point *out)
{
    const struct wf_scene_leaf *l = &s->leaf[k];
    double u = fmin(fmax(at[0] / l->length, 0), 1) * (double)l->vein, share[3];
    size_t i = u >= (double)l->vein ? l->vein - 1 : (size_t)u;
    double t = u - (double)i;
    wf_prism_shares(l->arm, at[1] * cos(s->spec.fold), fabs(at[1]) * sin(s->spec.fold), share);
    out->n = 6;
    for (int j = 0; j < 6; j++) {
        out->vertex[j] = (int32_t)(3 * (l->blade + i)) + j;
        out->share[j] = share[j % 3] * (j < 3 ? 1 - t : t);
    }
}

void wf_scene_wood_point(size_t section, double share, struct wf_prism_point *out)
{
    out->n = 6;
    for (int j = 0; j < 6; j++) {
        out->vertex[j] = (int32_t)(3 * section) + j;
        out->share[j] = (j < 3 ? 1 - share : share) / 3;
    }
}

/* Radius of the wood at the node of a section. */
static double wood_radius(const struct wf_rain_scene *s, size_t axis, size_t node, size_t nodes)
{
    if (axis) return s->spec.petiole_radius;
    if (s->spec.thick) return s->spec.thick[node];
    return wf_between(s->spec.radius[0], s->spec.radius[1], (double)node / (double)(nodes - 1));
}

static enum wf_status make_bodies(struct wf_rain_scene *s, struct wf_arena *a, struct wf_err *e)
{
    size_t n = s->spec.leaves, triangles = n * s->mesh.triangles, bodies = 0;
    size_t wood = s->sections - 1 + n * s->spec.petiole_prisms;
    struct wf_body *body = WF_TAKE(a, triangles + wood, struct wf_body);
    s->places = n * s->mesh.points + s->prism.sections;
    s->place = WF_TAKE(a, 3 * s->places, double);
    s->point = WF_TAKE(a, s->places, struct wf_prism_point);
    if (!body || !s->place || !s->point) return wf_fail(e, WF_ENOMEM, "not enough memory for the scene");
    for (size_t k = 0; k < n; k++) {
        int32_t first = (int32_t)(k * s->mesh.points);
        s->leaf[k].mesh = (size_t)first;
        for (size_t i = 0; i < s->mesh.points; i++)
            wf_scene_blade_point(s, k, s->mesh.at + 2 * i, &s->point[(size_t)first + i]);
        for (size_t t = 0; t < s->mesh.triangles; t++, bodies++) {
            body[bodies].part = (int32_t)k;
            for (int c = 0; c < 3; c++) body[bodies].at[c] = first + s->mesh.corner[3 * t + (size_t)c];
        }
    }
    int32_t axes = (int32_t)(n * s->mesh.points);
    for (size_t i = 0; i < s->prism.sections; i++)
        wf_scene_wood_point(i, 0, &s->point[(size_t)axes + i]), s->point[(size_t)axes + i].n = 3;
    for (size_t k = 0; k <= n; k++) {
        size_t from = (size_t)s->prism.first[k], nodes = k ? s->spec.petiole_prisms + 1 : s->sections;
        for (size_t i = 0; i + 1 < nodes; i++)
            body[bodies++] =
                (struct wf_body){ .at = { axes + (int32_t)(from + i), axes + (int32_t)(from + i + 1), -1 },
                                  .part = (int32_t)(n + 1 + from + i),
                                  .r0 = wood_radius(s, k, i, nodes),
                                  .r1 = wood_radius(s, k, i + 1, nodes) };
    }
    s->vertices = n * s->mesh.points + s->prism.sections, s->facets = triangles + wood;
    for (size_t i = 0; i < s->places; i++) wf_prism_at(&s->point[i], s->rest, s->place + 3 * i);
    return wf_hits_build(body, bodies, s->place, a, &s->hits, e);
}

static enum wf_status check(const struct wf_scene_spec *s, struct wf_err *e)
{
    if (s->leaves < 1 || s->leaves > 64)
        return wf_fail(e, WF_EUSAGE, "a scene has 1 to 64 leaves, not %zu", s->leaves);
    if (!(s->leaf_length > 0) || !(s->petiole > 0) || !(s->branch > 0) || !(s->radius[0] > 0) ||
        !(s->radius[1] > 0) || !(s->petiole_radius > 0))
        return wf_fail(e, WF_EINPUT, "leaf, petiole and branch need a length and a radius above 0");
    if (!(s->species->crown.leaf_mass_per_area.value > 0))
        return wf_fail(e, WF_EINPUT, "species '%s' has no leaves: its table gives no leaf_mass_per_area",
                       s->species->key);
    return WF_OK;
}

/* Let the prisms sag under their weight. */
static enum wf_status sag(struct wf_rain_scene *s, double gravity, struct wf_arena *a, struct wf_err *e)
{
    size_t n = 9 * s->prism.sections;
    double *f = WF_TAKE(a, n, double);
    s->rest = WF_TAKE(a, n, double);
    if (!f || !s->rest) return wf_fail(e, WF_ENOMEM, "not enough memory for the scene");
    memcpy(s->rest, s->prism.rest, n * sizeof *f);
    wf_prism_weight(&s->prism, gravity, f);
    return wf_prism_settle(&s->prism, f, s->rest, a, e);
}

enum wf_status wf_scene_make(const struct wf_scene_spec *spec, double gravity, struct wf_arena *a,
                             struct wf_rain_scene *out, struct wf_err *e)
{
    enum wf_status status = check(spec, e);
    if (status) return status;
    *out = (struct wf_rain_scene){ .spec = *spec };
    struct wf_rain_scene *s = out;
    if (!s->spec.wood) s->spec.wood = wf_species_level(spec->species, (int32_t)spec->species->levels - 1);
    spec = &s->spec;
    s->blade =
        (struct wf_blade){ spec->form, spec->leaf_length, spec->leaf_length * spec->form->breadth / 2 };
    if ((status = wf_blade_mesh_make(&s->blade, spec->mesh[0], spec->mesh[1], a, &s->mesh, e))) return status;
    struct wf_prism_axis *axis = WF_TAKE(a, spec->leaves + 1, struct wf_prism_axis);
    s->leaf = WF_TAKE(a, spec->leaves, struct wf_scene_leaf);
    if (!axis || !s->leaf) return wf_fail(e, WF_ENOMEM, "not enough memory for the scene");
    if ((status = make_branch(spec, a, &axis[0], e))) return status;
    axis[0].diagonal = spec->diagonal, axis[0].restoring = spec->restoring;
    s->sections = axis[0].segments + 1;
    size_t section = s->sections;
    for (size_t k = 0; k < spec->leaves; k++) {
        double way[3];
        size_t on;
        leaf_way(spec, axis[0].place, s->sections, k, &on, way);
        if ((status = make_leaf(spec, &s->blade, axis[0].place + 3 * on, way, a, &axis[k + 1], e)))
            return status;
        axis[k + 1].on = (int32_t)on;
        s->leaf[k] = (struct wf_scene_leaf){ .first = section,
                                             .blade = section + spec->petiole_prisms,
                                             .vein = spec->vein_prisms,
                                             .length = spec->leaf_length };
        section += axis[k + 1].segments + 1;
    }
    if ((status = wf_prism_make(axis, spec->leaves + 1, a, &s->prism, e))) return status;
    for (size_t k = 0; k < spec->leaves; k++) s->leaf[k].arm = s->prism.arm[k + 1];
    if ((status = sag(s, gravity, a, e))) return status;
    return make_bodies(s, a, e);
}

/* ---- In motion ---- */

void wf_scene_follow(struct wf_rain_scene *s, const double *x)
{
    for (size_t i = 0; i < s->places; i++) wf_prism_at(&s->point[i], x, s->place + 3 * i);
    wf_hits_refit(&s->hits, s->place);
}

void wf_scene_lie(const struct wf_rain_scene *s, const double *x, size_t k, double (*up)[3])
{
    for (size_t i = 0; i <= s->leaf[k].vein; i++) {
        double centre[3], along[3], left[3], normal[3];
        wf_prism_frame(&s->prism, x, s->leaf[k].blade + i, centre, along, left, normal);
        up[i][0] = along[2], up[i][1] = left[2], up[i][2] = normal[2];
    }
}

void wf_scene_normal(const struct wf_rain_scene *s, const double *x, size_t k, const double at[2],
                     double out[3])
{
    double u = fmin(fmax(at[0] / s->leaf[k].length, 0), 1) * (double)s->leaf[k].vein;
    double centre[3], along[3], left[3], normal[3], side = at[1] > 0 ? 1 : at[1] < 0 ? -1 : 0;
    wf_prism_frame(&s->prism, x, s->leaf[k].blade + (size_t)(u + 0.5), centre, along, left, normal);
    for (int c = 0; c < 3; c++) out[c] = cos(s->spec.fold) * normal[c] - side * sin(s->spec.fold) * left[c];
}
