/* A stem whose section is not round. */
#include "base/vec.h"
#include "grow/stem.h"
#include <math.h>

/* Width, height and shares of the shapes at a place of the stem [m]. */
static void section_at(const struct wf_model *m, double at, double *width, double *height, double mix[3])
{
    size_t k = 1;
    while (k + 1 < m->sections && m->section[k].at < at) k++;
    const struct wf_stem_section *a = &m->section[k - 1], *b = &m->section[k];
    double s = fmin(fmax((at - a->at) / (b->at - a->at), 0), 1);
    *width = a->width + s * (b->width - a->width);
    *height = a->height + s * (b->height - a->height);
    for (int i = 0; i < 3; i++) mix[i] = 0;
    mix[a->shape] += 1 - s;
    mix[b->shape] += s;
}

/* The height's direction: in the plane of the lean, turned about the axis. */
static void upward(const struct wf_model *m, double up[3])
{
    double axis[3] = { sin(m->lean) * cos(m->lean_azimuth), sin(m->lean) * sin(m->lean_azimuth),
                       cos(m->lean) };
    double plain[3] = { -cos(m->lean) * cos(m->lean_azimuth), -cos(m->lean) * sin(m->lean_azimuth),
                        sin(m->lean) };
    double side[3];
    wf_cross(axis, plain, side);
    for (int k = 0; k < 3; k++) up[k] = cos(m->turn) * plain[k] + sin(m->turn) * side[k];
}

/* Volume of a row: the area is a cubic of the length, which Simpson's rule takes exactly. */
static double volume(const struct wf_tree *t, size_t i)
{
    return wf_tree_length(t, i) / 6 *
           (wf_tree_area(t, i, 0) + 4 * wf_tree_area(t, i, 0.5) + wf_tree_area(t, i, 1));
}

/* Masses of one piece onto its rows, from..to - 1. */
static void load_piece(const struct wf_stem_mass *p, double from, size_t first, size_t end, struct wf_tree *t)
{
    double sum = 0, length = p->to - from, side = (p->left - p->right) * p->lever / length;
    for (size_t i = first; i < end; i++) sum += volume(t, i);
    for (size_t i = first; i < end; i++) {
        if (!isnan(p->own)) t->density[i] = p->own / sum;
        t->burden0[i] = t->burden1[i] = (p->left + p->right) / length;
        t->section->side0[i] = t->section->side1[i] = side;
    }
}

enum wf_status wf_stem_sections(const struct wf_model *m, const double *s, struct wf_tree *t,
                                struct wf_arena *a, struct wf_err *e)
{
    enum wf_status status = wf_tree_alloc_sections(t, a, e);
    if (status) return status;
    struct wf_tree_sections *c = t->section;
    for (size_t i = 0; i < t->n; i++) {
        upward(m, c->up + 3 * i);
        section_at(m, s[i] * m->height, &c->width0[i], &c->height0[i], c->mix0 + 3 * i);
        section_at(m, s[i + 1] * m->height, &c->width1[i], &c->height1[i], c->mix1 + 3 * i);
        t->r0[i] = sqrt(wf_tree_area(t, i, 0) / M_PI);
        t->r1[i] = sqrt(wf_tree_area(t, i, 1) / M_PI);
    }
    for (size_t k = 0, i = 0; k < m->masses; k++) {
        size_t first = i;
        while (i < t->n && (s[i] + s[i + 1]) * m->height < 2 * m->mass[k].to) i++;
        load_piece(&m->mass[k], k ? m->mass[k - 1].to : 0, first, i, t);
    }
    return WF_OK;
}
