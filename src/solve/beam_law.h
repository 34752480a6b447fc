#ifndef WF_SOLVE_BEAM_LAW_H
#define WF_SOLVE_BEAM_LAW_H
/* The section's law in bending and torsion. flat NULL, a constant where these are inlined: a round section.
 */
#include "solve/beam_element.h"
#include "solve/vec.h"
#include "solve/wide.h"

/* y = G^-1 x: moment of a curvature */
WF_INLINE void law_hold(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const double x[3], double y[3])
{
    double more = flat ? flat->more[j] * wf_dot(flat->across[j], x) : 0;
    v3_section(p->ei[j], p->gj[j], s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* y = G x: curvature of a moment */
WF_INLINE void law_give(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                        const struct wf_beam_stage *s, int j, const double x[3], double y[3])
{
    double more = flat ? flat->give[j] * wf_dot(flat->across[j], x) : 0;
    v3_section(1 / p->ei[j], 1 / p->gj[j], s->t[j], x, y);
    if (flat) v3_add(y, more, flat->across[j]);
}

/* C += G^-1 B */
WF_INLINE void law_hold_mul(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                            const struct wf_beam_stage *s, int j, const double B[9], double C[9])
{
    m3_add_section_mul(C, p->ei[j], p->gj[j], s->t[j], B);
    if (!flat) return;
    double row[3];
    m3_apply_transposed(B, flat->across[j], row);
    m3_add_outer(C, flat->more[j], flat->across[j], row);
}
#endif
