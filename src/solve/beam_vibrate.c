#include "solve/beam_vibrate.h"
#include "solve/beam_small.h"
#include "solve/vec.h"

size_t wf_beam_motion_size(const struct wf_beam *b) { return b->mesh.n * (b->mesh.mass1 ? 11 : 8); }

/* Inertia of the motion `ctx` at the Gauss points. */
static void inertia(const void *ctx, const struct wf_beam *b, size_t i, struct wf_beam_disturbance *out)
{
    const double *motion = (const double *)ctx + 8 * i;
    const struct wf_beam_part *p = &b->mesh.part[i];
    for (int j = 0; j < 2; j++)
        for (int c = 0; c < 3; c++) {
            out->force[j][c] = p->line[j].mass * motion[4 * j + c];
            out->couple[j][c] = p->spin[j] * motion[4 * j + 3] * b->stage[i].t[j][c];
        }
}

void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*node)[6],
                            double (*ends)[6])
{
    size_t n = b->mesh.n;
    struct wf_beam_small_answer x = { .motion = out, .ends = ends };
    for (size_t i = 0; b->mesh.mass1 && i < n; i++)
        for (size_t c = 0; c < 3; c++) {
            node[i][c] = b->mesh.mass1[i] * in[8 * n + 3 * i + c];
            node[i][3 + c] = 0;
        }
    wf_beam_answer_small(b, inertia, in, b->mesh.mass1 ? (const double(*)[6])node : NULL, NULL, &x);
    for (size_t i = 0; b->mesh.mass1 && i < n; i++) memcpy(out + 8 * n + 3 * i, ends[i], 3 * sizeof *out);
}

void wf_beam_motion_mass(const struct wf_beam *b, double *mass)
{
    size_t n = b->mesh.n;
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        for (size_t j = 0; j < 2; j++) {
            for (size_t c = 0; c < 3; c++) mass[8 * i + 4 * j + c] = 0.5 * p->h * p->line[j].mass;
            mass[8 * i + 4 * j + 3] = 0.5 * p->h * p->spin[j];
        }
        for (size_t c = 0; b->mesh.mass1 && c < 3; c++) mass[8 * n + 3 * i + c] = b->mesh.mass1[i];
    }
}
