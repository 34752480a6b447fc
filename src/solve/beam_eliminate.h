/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ELIMINATE_H
#define WF_SOLVE_BEAM_ELIMINATE_H
/* Linearisation of one element and its elimination between its base and what is above. */
#include "solve/beam_element.h"

/* Linearise and eliminate the element. Given: the present state, and in *node the reaction of all that is
 * above its end. Returned: *answer; in *node how the end itself answers a change p of the base, K p + k; the
 * reaction handed down is added to *below. u->g becomes the strain under the present forces. guard: stiffen
 * an element whose linear answer leaps (far from equilibrium; the tangent is then not exact). count (may be
 * NULL) goes up by the number of directions in which this element, with all above it, is unstable: negative
 * pivots of its tangent by strains. small (may be
 * NULL): filled. false when the eliminated block is singular. */
bool wf_beam_eliminate(const struct wf_beam_part *p, struct wf_beam_shape *u, const double base_L[9],
                       const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                       const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                       struct wf_beam_reaction *node, struct wf_beam_answer *answer,
                       struct wf_beam_reaction *below, bool guard, struct wf_beam_stability *count,
                       struct wf_beam_small *small);

/* The same for a section that is not round, flat turned with the element. */
bool wf_beam_eliminate_flat(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                            struct wf_beam_shape *u, const double base_L[9],
                            const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                            const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                            struct wf_beam_reaction *node, struct wf_beam_answer *answer,
                            struct wf_beam_reaction *below, bool guard, struct wf_beam_stability *count,
                            struct wf_beam_small *small);

/* Newton correction of the unknowns from the change p of the base: dv[2][3] in base axes; end[6] = change of
 * the end, as node (see above) has it. */
void wf_beam_correct(const struct wf_beam_shape *u, const double base_L[9],
                     const struct wf_beam_answer *answer, const struct wf_beam_reaction *node,
                     const double p[6], double dv[2][3], double end[6]);

void wf_beam_misfit_add(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double base_L[9],
                        const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                        const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                        struct wf_beam_misfit *sum);
#endif
