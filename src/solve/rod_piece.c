#include "solve/rod_piece.h"
#include <math.h>

#define PI 3.14159265358979323846

static double between(double a, double b, double s) { return a + (b - a) * s; }

void wf_rod_section_at(const struct wf_tree *t, const struct wf_loads *l, size_t i, double s,
                       struct wf_rod_section *out)
{
    double a = between(t->r0[i], t->r1[i], s), b = between(t->i0[i], t->i1[i], s);
    double a2 = a * a, b2 = b * b, inertia = 0.25 * PI * (a2 * a2 - b2 * b2);
    out->ei = t->stiff ? t->stiff[4 * i + 2] : t->youngs[i] * inertia;
    out->gj = t->stiff ? t->stiff[4 * i + 3] : t->shear[i] * 2 * inertia;
    out->line = (struct wf_line_point){ .diameter = 2 * a,
                                        .drag = t->drag[i],
                                        .lift = t->lift[i],
                                        .sail = between(t->sail0[i], t->sail1[i], s),
                                        .mass = t->density[i] * PI * (a2 - b2) +
                                                between(t->burden0[i], t->burden1[i], s) };
    for (size_t k = 0; k < 3; k++)
        out->dead[k] = l->line ? l->point_scale * between(l->line[6 * i + k], l->line[6 * i + 3 + k], s) : 0;
}

/* Size of the load on a row and its end, on the unloaded shape [N]. */
static double load_size(const struct wf_tree *t, const struct wf_loads *l, size_t i)
{
    struct wf_rod_section section;
    struct wf_line_load load;
    double mass = t->mass1 ? t->mass1[i] * l->gravity * fabs(l->weight_scale) : 0;
    double x[3] = { 0.5 * (t->x0[i] + t->x1[i]), 0.5 * (t->y0[i] + t->y1[i]), 0.5 * (t->z0[i] + t->z1[i]) };
    double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    double chord = sqrt(wf_dot(axis, axis));
    for (int k = 0; k < 3; k++) axis[k] /= chord;
    wf_rod_section_at(t, l, i, 0.5, &section);
    wf_line_load(l, &section.line, x, axis, &load);
    v3_add(load.force, 1, section.dead);
    return mass + wf_tree_length(t, i) * sqrt(wf_dot(load.force, load.force));
}

struct wf_rod_piece *wf_rod_cut(const struct wf_tree *t, const struct wf_loads *l, int32_t least,
                                struct wf_arena *a, size_t *n)
{
    const double reach = 1.5, most = 32;
    double *above = WF_TAKE(a, t->n, double);
    int32_t *cut = WF_TAKE(a, t->n, int32_t), *last = WF_TAKE(a, t->n, int32_t);
    *n = 0;
    if (!above || !cut || !last) return NULL;
    for (size_t k = 0; k < l->points; k++)
        above[l->point[k].segment] +=
            fabs(l->point_scale) * sqrt(wf_dot(l->point[k].force, l->point[k].force));
    for (size_t i = t->n; i-- > 0;) {
        struct wf_rod_section s0, s1;
        wf_rod_section_at(t, l, i, 0, &s0);
        wf_rod_section_at(t, l, i, 1, &s1);
        above[i] += load_size(t, l, i);
        if (t->parent[i] >= 0) above[t->parent[i]] += above[i];
        double pieces = ceil(wf_tree_length(t, i) * sqrt(above[i] / fmin(s0.ei, s1.ei)) / reach);
        cut[i] = (int32_t)fmin(fmax(pieces, least), most);
        *n += (size_t)cut[i];
    }
    struct wf_rod_piece *piece = WF_TAKE(a, *n, struct wf_rod_piece);
    int32_t at = 0;
    for (size_t i = 0; piece && i < t->n; i++) {
        for (int32_t k = 0; k < cut[i]; k++, at++) {
            struct wf_rod_section s0, s1;
            struct wf_rod_piece *p = &piece[at];
            p->row = (int32_t)i;
            p->parent = k ? at - 1 : t->parent[i] < 0 ? -1 : last[t->parent[i]];
            p->last = k + 1 == cut[i];
            p->s0 = (double)k / cut[i], p->s1 = (double)(k + 1) / cut[i];
            p->h = wf_tree_length(t, i) / cut[i];
            wf_rod_section_at(t, l, i, p->s0, &s0);
            wf_rod_section_at(t, l, i, p->s1, &s1);
            p->stiffness = fmin(s0.ei, s1.ei);
            p->first_step = 1;
        }
        last[i] = at - 1;
    }
    return piece;
}
