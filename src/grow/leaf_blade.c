/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/leaf_blade.h"
#include <math.h>
#include <string.h>

const struct wf_leaf_form wf_leaf_forms[] = {
    { "ovate", "beech, birch", 0.5, 1.0, 0.62 },
    { "elliptic", "many broadleaves", 0.5, 0.5, 0.5 },
    { "deltoid", "poplar", 0.3, 1.0, 0.9 },
    { "obovate", "oak without its lobes", 1.0, 0.5, 0.55 },
    { "lanceolate", "willow, bamboo", 0.7, 1.0, 0.16 },
    { 0 },
};

const struct wf_leaf_form *wf_leaf_form_named(const char *name)
{
    for (const struct wf_leaf_form *f = wf_leaf_forms; f->name; f++)
        if (!strcmp(f->name, name)) return f;
    return NULL;
}

double wf_blade_half(const struct wf_blade *b, double x)
{
    double s = x / b->length, p = b->form->p, q = b->form->q, most = p / (p + q);
    if (!(s > 0 && s < 1)) return 0;
    return b->half * pow(s / most, p) * pow((1 - s) / (1 - most), q);
}

double wf_blade_slope(const struct wf_blade *b, double x)
{
    double s = x / b->length;
    if (!(s > 0 && s < 1)) return 0;
    return wf_blade_half(b, x) * (b->form->p / s - b->form->q / (1 - s)) / b->length;
}

double wf_blade_area(const struct wf_blade *b)
{
    enum { PARTS = 2000 };
    double sum = 0; /* s = u^2 (3 - 2 u): smooth at both ends */
    for (int i = 0; i < PARTS; i++) {
        double u = (i + 0.5) / PARTS;
        sum += 2 * wf_blade_half(b, b->length * u * u * (3 - 2 * u)) * 6 * u * (1 - u) / PARTS;
    }
    return sum * b->length;
}

static void put_triangle(struct wf_blade_mesh *m, size_t a, size_t b, size_t c)
{
    int32_t *t = m->corner + 3 * m->triangles++;
    t[0] = (int32_t)a, t[1] = (int32_t)b, t[2] = (int32_t)c;
}

enum wf_status wf_blade_mesh_make(const struct wf_blade *b, size_t along, size_t across, struct wf_arena *a,
                                  struct wf_blade_mesh *out, struct wf_err *e)
{
    size_t wide = 2 * across + 1;
    if (!(b->length > 0) || !(b->half > 0) || along < 2 || !across)
        return wf_fail(e, WF_EINPUT, "a leaf needs an area: its length is %g m and its half width %g m",
                       b->length, b->half);
    *out = (struct wf_blade_mesh){ .at = WF_TAKE(a, 2 * (along + 1) * wide, double),
                                   .corner = WF_TAKE(a, 3 * 4 * along * across, int32_t) };
    if (!out->at || !out->corner) return wf_fail(e, WF_ENOMEM, "not enough memory for a leaf");
    for (size_t i = 0; i <= along; i++) {
        double u = (double)i / (double)along, x = b->length * u * u * (3 - 2 * u), w = wf_blade_half(b, x);
        for (size_t j = 0; j < wide; j++) {
            double *at = out->at + 2 * out->points++;
            at[0] = x, at[1] = w * ((double)j / (double)across - 1);
        }
    }
    for (size_t i = 0; i < along; i++)
        for (size_t j = 0; j + 1 < wide; j++) { /* the rows of both ends are a point: half a square there */
            size_t k = i * wide + j;
            if (i) put_triangle(out, k, k + wide, k + 1);
            if (i + 1 < along) put_triangle(out, k + 1, k + wide, k + wide + 1);
        }
    return WF_OK;
}
