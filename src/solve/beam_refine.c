#include "solve/beam_refine.h"
#include "solve/vec.h"

/* End of row i seen from its base. */
static void seen_from_base(const struct wf_beam *b, size_t i, double place[3], double L[9])
{
    size_t from = (size_t)b->mesh.first[i];
    struct wf_beam_pose ground;
    const struct wf_beam_pose *base = wf_beam_base(b, from, &ground), *end = &b->pose[b->mesh.last[i]];
    double d[3] = { end->r[0] - base->r[0], end->r[1] - base->r[1], end->r[2] - base->r[2] };
    m3_apply_transposed(base->L, d, place);
    m3_mul_transposed(base->L, end->L, L);
}

void wf_tree_reach(const struct wf_tree *t, double *reach)
{
    for (size_t i = 0; i < t->n; i++) reach[i] = 0;
    for (size_t i = t->n; i-- > 0;) {
        if (t->parent[i] < 0) continue;
        double far = reach[i] + wf_tree_length(t, i);
        if (far > reach[t->parent[i]]) reach[t->parent[i]] = far;
    }
}

double wf_beam_mesh_error(const struct wf_beam *coarse, const struct wf_beam *fine, const double *reach,
                          double *share)
{
    const struct wf_tree *t = fine->mesh.tree;
    double worst = 0;
    for (size_t i = 0; i < t->n; i++) {
        double a[3], b[3], A[9], B[9], R[9], turn[3];
        double kc = coarse->mesh.last[i] - coarse->mesh.first[i] + 1,
               kf = fine->mesh.last[i] - fine->mesh.first[i] + 1;
        double fall = pow(kf / kc, 4) - 1; /* error(coarse) = error(fine) (kf/kc)^4 */
        seen_from_base(coarse, i, a, A);
        seen_from_base(fine, i, b, B);
        m3_mul_transposed(A, B, R);
        rotation_vector(R, turn);
        v3_add(a, -1, b);
        if (fall > 0) share[i] = (sqrt(wf_dot(a, a)) + reach[i] * sqrt(wf_dot(turn, turn))) / fall;
    }
    /* the worst path from the ground: summed upwards in place of the rows' own shares, then undone */
    for (size_t i = 0; i < t->n; i++) {
        if (t->parent[i] >= 0) share[i] += share[t->parent[i]];
        worst = fmax(worst, share[i]);
    }
    for (size_t i = t->n; i-- > 0;)
        if (t->parent[i] >= 0) share[i] -= share[t->parent[i]];
    return worst;
}
