/* The law "feng1999": flows of the classes superposed, as the paper prints them.
 *
 * What is printed: the cylinder f = Q(z + a^2/z) with the remark that the wind is back beyond 5 to 7 radii;
 * the hole f = Q/(2 pi) ln z with radial speed like 1/r; the slit psi = -Q(R - R1); 20 % through a cell that
 * is covered altogether; superposition. What is not printed is how a flow's strength follows from the wind
 * and what happens behind a cell that is covered in part. Here: transmitting  the wind behind is 1 - (1 - T)
 * coverage of the wind before, and stays so; cylinder      the disturbance of eq. (6) by a stem of the run's
 * solid width, in the plane across the stem, behind it up to 7 radii; farther off the wind counts as
 * undisturbed; hole, slit    the wall around them is taken as one, T of the wind passes everywhere; the rest
 * of the wind comes through the hole and spreads by eq. (7), with speed (1 - T) U at the radius r0 of a
 *                 circle of the cell's area, or through the slit by eq. (8) as printed, with speed (1 - T) U
 *                 on its middle; both up to 20 r0 (for a slit r0 is half its width).
 * Nothing bounds the sum: many holes side by side can blow more than the wind. */
#include "wind/potential.h"
#include "wind/shelter_parts.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* A flow that starts at a place of the grid: how far it is followed, and its velocity over that of the wind
 * at a point along, across and up from there. */
struct flow {
    double strength;    /* of the wind that meets it [-] */
    double centre[2];   /* across, up [m] */
    double radius;      /* a or r0 [m] */
    double length;      /* of a slit [m] */
    bool level;         /* stem or slit lies across instead of standing up */
    double reach, half; /* [m]; half its extent along its own axis */
    void (*velocity)(const struct flow *f, const double x[3], double u[3]);
};

static void cylinder(const struct flow *f, const double x[3], double u[3])
{
    double plane[2] = { x[0], f->level ? x[2] : x[1] }, v[2];
    u[0] = u[1] = u[2] = 0.0;
    if (hypot(plane[0], plane[1]) <= f->radius) return;
    wf_flow_cylinder(1.0, f->radius, 0.0, plane, v);
    u[0] = v[0] - 1.0;
    u[f->level ? 2 : 1] = v[1];
}

static void hole(const struct flow *f, const double x[3], double u[3])
{
    double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    double v[3], strength = 2.0 * pi * f->radius;
    const double plane[3] = { fmax(r, f->radius), 0.0, 0.0 };
    wf_flow_line_source(strength, plane, v);
    for (int k = 0; k < 3; k++) u[k] = v[0] * x[k] / r;
}

static void slit(const struct flow *f, const double x[3], double u[3])
{
    int own = f->level ? 1 : 2, side = f->level ? 2 : 1;
    double off = hypot(x[0], x[side]), v[2];
    wf_feng_slit(0.5, f->length, (double[]){ x[own] + 0.5 * f->length, off }, v);
    u[0] = v[1] * x[0] / off;
    u[side] = v[1] * x[side] / off;
    u[own] = v[0];
}

/* First of n cells whose centre lies beyond a place [cells]. */
static size_t beyond(double at, size_t n) { return (size_t)fmin(fmax(ceil(at - 0.5), 0.0), (double)n); }

/* Add a flow that starts in slab k to the planes behind. */
static void blow(struct wf_shelter *s, size_t k, const struct flow *f)
{
    double wide[2] = { f->reach, f->reach };
    if (f->half > 0.0) wide[f->level ? 0 : 1] = f->half;
    size_t first[2], last[2];
    const size_t n[2] = { s->across, s->up };
    for (int d = 0; d < 2; d++) {
        /* a centre just as far as the reach belongs to it on both sides */
        double at = (f->centre[d] - s->low[d + 1]) / s->step[d + 1], far = wide[d] / s->step[d + 1] + 1e-6;
        first[d] = beyond(at - far, n[d]);
        last[d] = beyond(at + far, n[d]);
    }
    for (size_t p = k; p < s->planes; p++) {
        double x[3] = { ((double)(p - k) + WF_SHELTER_LAG) * s->step[0] }, u[3];
        if (x[0] > f->reach) return;
        for (size_t j = first[1]; j < last[1]; j++)
            for (size_t i = first[0]; i < last[0]; i++) {
                size_t cell = (p * s->up + j) * s->across + i;
                x[1] = s->low[1] + ((double)i + 0.5) * s->step[1] - f->centre[0];
                x[2] = s->low[2] + ((double)j + 0.5) * s->step[2] - f->centre[1];
                f->velocity(f, x, u);
                for (int d = 0; d < 3; d++) s->part[d][cell] -= f->strength * u[d];
            }
    }
}

/* Cells of one class and width that follow each other along a line: one stem's width, or one slit's length.
 */
struct line {
    size_t start, stride, n; /* first cell of the slab, distance to the next */
    bool level;              /* the line runs across */
};

static void follow(struct wf_shelter *s, size_t k, const double *wind, const struct line *l,
                   enum wf_cell_class class, bool positive, double share)
{
    size_t slab = k * s->up * s->across;
    const int axis = l->level ? 1 : 2;
    for (size_t i = 0; i < l->n;) {
        size_t cell = l->start + i * l->stride, end = i;
        double width = s->width[slab + cell], weight = 0.0, sum = 0.0, arrives = 0.0;
        for (; end < l->n; end++) {
            size_t c = l->start + end * l->stride;
            if (s->class[slab + c] != class || s->width[slab + c] != width || (width > 0.0) != positive)
                break;
            double w = class == WF_CELL_CYLINDER ? wf_shelter_coverage(s, slab + c) : 1.0;
            weight += w;
            sum += w * ((double)end + 0.5);
            arrives += w * wind[c];
        }
        if (end == i) {
            i++;
            continue;
        }
        double place[2] = { s->low[1] + ((double)(cell % s->across) + 0.5) * s->step[1],
                            s->low[2] + ((double)(cell / s->across) + 0.5) * s->step[2] };
        place[axis - 1] = s->low[axis] + sum / weight * s->step[axis];
        struct flow f = { .centre = { place[0], place[1] }, .strength = share * arrives / weight };
        if (class == WF_CELL_CYLINDER) {
            f.velocity = cylinder;
            f.level = !positive;
            f.radius = 0.5 * fabs(width);
            f.reach = 7.0 * f.radius;
            f.half = 0.5 * s->step[positive ? 2 : 1];
        } else {
            f.velocity = slit;
            f.level = l->level;
            f.radius = 0.5 * fabs(width);
            f.reach = 20.0 * f.radius;
            f.length = (double)(end - i) * s->step[axis];
            f.half = 0.5 * f.length + f.reach;
        }
        blow(s, k, &f);
        i = end;
    }
}

static void holes(struct wf_shelter *s, size_t k, const double *wind, double share)
{
    size_t cells = s->up * s->across;
    for (size_t c = 0; c < cells; c++) {
        if (s->class[k * cells + c] != WF_CELL_HOLE) continue;
        struct flow f = { .strength = share * wind[c],
                          .centre = { s->low[1] + ((double)(c % s->across) + 0.5) * s->step[1],
                                      s->low[2] + ((double)(c / s->across) + 0.5) * s->step[2] },
                          .radius = sqrt(s->step[1] * s->step[2] / pi),
                          .velocity = hole };
        f.reach = 20.0 * f.radius;
        blow(s, k, &f);
    }
}

/* What passes straight on through each cell of slab k. */
static void pass(const struct wf_shelter *s, size_t k, double least, double *wind)
{
    size_t cells = s->up * s->across;
    for (size_t c = 0; c < cells; c++) {
        size_t cell = k * cells + c;
        enum wf_cell_class class = s->class[cell];
        if (class == WF_CELL_TRANSMITTING) wind[c] *= 1.0 - (1.0 - least) * wf_shelter_coverage(s, cell);
        if (class == WF_CELL_HOLE || class == WF_CELL_SLIT) wind[c] *= least;
    }
}

enum wf_status wf_shelter_feng(struct wf_shelter *s, struct wf_arena *scratch, struct wf_err *e)
{
    size_t cells = s->up * s->across;
    double least = wf_shelter_speed_share(&s->request), *wind = WF_TAKE(scratch, cells, double);
    if (!wind) return wf_fail(e, WF_ENOMEM, "no room for a plane of %zu cells", cells);
    for (size_t c = 0; c < cells; c++) wind[c] = 1.0;
    for (size_t p = 0; p < s->planes; p++) {
        if (p < s->slabs) {
            for (size_t k = 0; k < s->up; k++) {
                const struct line row = { k * s->across, 1, s->across, true };
                follow(s, p, wind, &row, WF_CELL_CYLINDER, true, 1.0);
                follow(s, p, wind, &row, WF_CELL_SLIT, false, 1.0 - least);
            }
            for (size_t i = 0; i < s->across; i++) {
                const struct line column = { i, s->across, s->up, false };
                follow(s, p, wind, &column, WF_CELL_CYLINDER, false, 1.0);
                follow(s, p, wind, &column, WF_CELL_SLIT, true, 1.0 - least);
            }
            holes(s, p, wind, 1.0 - least);
            pass(s, p, least, wind);
        }
        for (size_t c = 0; c < cells; c++) s->part[0][p * cells + c] += 1.0 - wind[c];
    }
    return WF_OK;
}
