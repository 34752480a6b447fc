/* What a slab's cells are: rules in wind/shelter.h. */
#include "wind/shelter.h"
#include "wind/shelter_parts.h"
#include <math.h>

/* One slab: its cells as rows of `across`, `up` of them. */
struct sheet {
    const struct wf_shelter *s;
    size_t first; /* cell of the slab's corner */
    uint8_t *class;
    double *width;
};

static bool covered(const struct sheet *h, long i, long k)
{
    if (i < 0 || k < 0 || i >= (long)h->s->across || k >= (long)h->s->up) return false;
    uint8_t c = h->class[(size_t)k * h->s->across + (size_t)i];
    return c == WF_CELL_TRANSMITTING || c == WF_CELL_CYLINDER;
}

/* Runs of covered cells along a line of `n` cells that lie `stride` apart: those that end at open cells and
 * are narrow enough are cylinders. `sign` marks the direction of the run. */
static void runs(struct sheet *h, size_t start, size_t stride, size_t n, double step, double widest,
                 double sign)
{
    for (size_t i = 0; i < n;) {
        size_t end = i;
        double solid = 0.0;
        for (; end < n && h->class[start + end * stride] != WF_CELL_NONE; end++)
            solid += step * wf_shelter_coverage(h->s, h->first + start + end * stride);
        if (end > i && (double)(end - i) * step <= widest + 2.0 * step)
            for (size_t j = i; j < end; j++) {
                size_t cell = start + j * stride;
                if (h->class[cell] == WF_CELL_CYLINDER && fabs(h->width[cell]) <= solid) continue;
                h->class[cell] = WF_CELL_CYLINDER;
                h->width[cell] = sign * solid;
            }
        i = end + 1;
    }
}

/* Whether a covered cell stands within `gap` cells in the direction (di, dk). */
static bool wall(const struct sheet *h, size_t i, size_t k, long di, long dk)
{
    for (long step = 1; step <= (long)h->s->request.gap; step++)
        if (covered(h, (long)i + step * di, (long)k + step * dk)) return true;
    return false;
}

static void gaps(struct sheet *h)
{
    for (size_t k = 0; k < h->s->up; k++)
        for (size_t i = 0; i < h->s->across; i++) {
            uint8_t *c = &h->class[k * h->s->across + i];
            if (*c != WF_CELL_NONE) continue;
            bool beside = wall(h, i, k, -1, 0) && wall(h, i, k, 1, 0),
                 above = wall(h, i, k, 0, -1) && wall(h, i, k, 0, 1);
            if (beside && above)
                *c = WF_CELL_HOLE;
            else if (beside || above)
                *c = WF_CELL_SLIT;
            if (*c == WF_CELL_SLIT) h->width[k * h->s->across + i] = beside ? h->s->step[1] : -h->s->step[2];
        }
}

void wf_shelter_classify(struct wf_shelter *s, double thickest)
{
    size_t cells = s->up * s->across;
    for (size_t p = 0; p < s->slabs; p++) {
        struct sheet h = { s, p * cells, s->class + p * cells, s->width + p * cells };
        bool any = false;
        for (size_t c = 0; c < cells; c++) {
            bool solid = (s->wood[h.first + c] > 0.0 || s->leaf[h.first + c] > 0.0) &&
                         wf_shelter_coverage(s, h.first + c) > s->request.clear;
            h.class[c] = solid ? WF_CELL_TRANSMITTING : WF_CELL_NONE;
            any = any || solid;
        }
        if (!any) continue;
        for (size_t k = 0; k < s->up; k++) runs(&h, k * s->across, 1, s->across, s->step[1], thickest, 1.0);
        for (size_t i = 0; i < s->across; i++) runs(&h, i, s->across, s->up, s->step[2], thickest, -1.0);
        gaps(&h);
    }
}
