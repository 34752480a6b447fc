#include "solve/beam_vibrate.h"
#include "solve/gauss.h"
#include "solve/vec.h"

size_t wf_beam_motion_size(const struct wf_beam *b) { return b->mesh.n * (b->mesh.mass1 ? 11 : 8); }

enum wf_status wf_beam_small_prepare(struct wf_beam *b, struct wf_arena *a, struct wf_err *e)
{
    b->small = WF_TAKE(a, b->mesh.n, struct wf_beam_small);
    if (!b->small) return wf_fail(e, WF_ENOMEM, "no room for the small motions of %zu elements", b->mesh.n);
    b->frozen = true;
    b->misfit = (struct wf_beam_misfit){ 0 };
    wf_beam_sweep_up(b);
    if (!wf_beam_sweep_down(b, true, NULL))
        return wf_fail(e, WF_EUNSTABLE, "the tree has no stiffness left in the state it is to sway about");
    return WF_OK;
}

static void apply6(double A[6][6], const double x[6], double y[6])
{
    for (int i = 0; i < 6; i++)
        for (int c = 0; c < 6; c++) y[i] += A[i][c] * x[c];
}

/* One element under inertia forces f and twisting moments c at its Gauss points and the wrench k from above:
 * y at a fixed base, stretch, and the wrench handed down. */
static void answer_down(const struct wf_beam_part *p, const struct wf_beam_stage *s, struct wf_beam_small *q,
                        double f[2][3], double c[2][3], const double k[6], double y[6], double stretch[2][3],
                        double down[6])
{
    double turn[2][3], d[6];
    for (int j = 0; j < 2; j++) {
        double own[3], n[3], give[3], lever[3];
        for (int i = 0; i < 3; i++) {
            own[i] = p->h * (gauss_down[j][0] * f[0][i] + gauss_down[j][1] * f[1][i]);
            n[i] = k[i] + own[i];
        }
        v3_section(p->cs[j], p->ca[j], s->t[j], n, stretch[j]);
        v3_section(p->cs[j], p->ca[j], s->t[j], own, give);
        m3_apply(q->Vn[j], k, turn[j]);
        wf_cross(s->rp[j], own, lever);
        v3_add(turn[j], 1, lever);
        wf_cross(q->n[j], give, lever);
        v3_add(turn[j], -1, lever);
        v3_add(turn[j], 1, c[j]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 2; j++)
            d[3 * j + i] = k[3 + i] + p->h * (gauss_down[j][0] * turn[0][i] + gauss_down[j][1] * turn[1][i]);
        down[i] = k[i] + 0.5 * p->h * (f[0][i] + f[1][i]);
        down[3 + i] = k[3 + i] + 0.5 * p->h * (turn[0][i] + turn[1][i]);
    }
    memset(y, 0, 6 * sizeof *y);
    apply6(q->R, d, y);
    apply6(q->T, y, down);
}

/* Motion of one element on the change `base` of its base: Gauss points (displacement, twist) and end. */
static void answer_up(const struct wf_beam_part *p, const struct wf_beam_stage *s, struct wf_beam_answer *x,
                      struct wf_beam_small *q, const double base[6], double y[6], double stretch[2][3],
                      double motion[8], double end[6])
{
    double dr[2][3], spin[2][3];
    apply6(x->X, base, y);
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++) spin[j][i] = base[3 + i] + y[3 * j + i];
        m3_apply(q->Y[j], spin[j], dr[j]);
        v3_add(dr[j], 1, stretch[j]);
    }
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 3; i++)
            motion[4 * j + i] = base[i] + p->h * (gauss_up[j][0] * dr[0][i] + gauss_up[j][1] * dr[1][i]);
        motion[4 * j + 3] = wf_dot(s->t[j], spin[j]);
    }
    for (int i = 0; i < 3; i++) {
        end[i] = base[i] + 0.5 * p->h * (dr[0][i] + dr[1][i]);
        end[3 + i] = base[3 + i];
        for (int c = 0; c < 6; c++) end[3 + i] += q->P[3 + i][c] * y[c];
    }
}

void wf_beam_inertia_answer(struct wf_beam *b, const double *in, double *out, double (*ends)[6])
{
    size_t n = b->mesh.n;
    double(*y)[6] = b->change; /* free while nothing is being solved */
    double(*stretch)[2][3] = b->dv;
    for (size_t i = 0; i < n; i++) {
        memset(&b->wrench[i], 0, sizeof b->wrench[i]);
        if (b->mesh.mass1)
            for (size_t k = 0; k < 3; k++) b->wrench[i].n[k] = b->mesh.mass1[i] * in[8 * n + 3 * i + k];
    }
    for (size_t i = n; i-- > 0;) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        const struct wf_beam_stage *s = &b->stage[i];
        double f[2][3], c[2][3], k[6], down[6];
        for (int j = 0; j < 2; j++)
            for (int l = 0; l < 3; l++) {
                f[j][l] = p->line[j].mass * in[8 * i + 4 * (size_t)j + (size_t)l];
                c[j][l] = p->spin[j] * in[8 * i + 4 * (size_t)j + 3] * s->t[j][l];
            }
        memcpy(k, b->wrench[i].n, 3 * sizeof *k), memcpy(k + 3, b->wrench[i].m, 3 * sizeof *k);
        answer_down(p, s, &b->small[i], f, c, k, y[i], stretch[i], down);
        if (p->parent >= 0) {
            v3_add(b->wrench[p->parent].n, 1, down);
            v3_add(b->wrench[p->parent].m, 1, down + 3);
        } else {
            memset(b->root_change[p->row], 0, sizeof b->root_change[p->row]);
            m3_apply(b->root_give[p->row], down + 3, b->root_change[p->row] + 3);
        }
    }
    for (size_t i = 0; i < n; i++) {
        const struct wf_beam_part *p = &b->mesh.part[i];
        double end[6];
        const double *base = p->parent >= 0 ? y[p->parent] : b->root_change[p->row];
        answer_up(p, &b->stage[i], &b->answer[i], &b->small[i], base, y[i], stretch[i], out + 8 * i, end);
        memcpy(y[i], end, sizeof end); /* the element's end, base of those above */
        if (b->mesh.mass1) memcpy(out + 8 * n + 3 * i, end, 3 * sizeof *out);
        if (ends) memcpy(ends[i], end, sizeof end);
    }
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
