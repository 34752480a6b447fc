/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_BEAM_ELIMINATE_H
#define WF_SOLVE_BEAM_ELIMINATE_H
/* Linearisation of one element and its elimination (static condensation) between its base and the part
 * above; residual of its material law. */
#include "solve/beam_element.h"

/* What an elimination is to do besides. */
struct wf_beam_also {
    bool guard; /* treat an element by itself if the linear step would move it too far (far from equilibrium;
                   the tangent is then not exact) */
    bool apart; /* returned: some element was; else as it is */
    struct wf_beam_stability *count; /* NULL, or increased by the number of directions in which this element,
                                        with all above it, is unstable: negative pivots of its tangent in
                                        terms of strains */
    struct wf_beam_small *small;     /* NULL, or filled */
    double (*change)[3];             /* of the loads, where they grow; NULL: they do not. Then: */
    struct wf_beam_shape *side; /* its g become the changes of the strains; `side` of the reactions and of the
                                   answer is taken and returned as k and x are */
};

/* Linearise and eliminate one element. Given: the present state; in *node the reaction of everything above
 * its end. Returned: *answer; *node becomes the change of the end for a change p of the base, K p + k; the
 * reaction on the base is added to *below; u->g becomes the strain under the present forces. false when the
 * eliminated block is singular. */
bool wf_beam_eliminate(const struct wf_beam_part *p, struct wf_beam_shape *u, const double base_L[9],
                       const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                       const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                       struct wf_beam_reaction *node, struct wf_beam_answer *answer,
                       struct wf_beam_reaction *below, struct wf_beam_also *also);

/* As wf_beam_eliminate for a section that is not round; flat in the deformed state. */
bool wf_beam_eliminate_flat(const struct wf_beam_part *p, const struct wf_beam_flat *flat,
                            struct wf_beam_shape *u, const double base_L[9],
                            const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                            const struct wf_line_load load[2], const struct wf_beam_wrench at[2],
                            struct wf_beam_reaction *node, struct wf_beam_answer *answer,
                            struct wf_beam_reaction *below, struct wf_beam_also *also);

/* Newton correction of an eliminated element. Given: change p of its base. Returned: dv[2][3], changes of
 * the unknowns in base axes; end[6], change of the end by *node as wf_beam_eliminate left it. */
void wf_beam_correct(const struct wf_beam_shape *u, const double base_L[9],
                     const struct wf_beam_answer *answer, const struct wf_beam_reaction *node,
                     const double p[6], double dv[2][3], double end[6]);

/* The same where the loads grow, without the correction. */
void wf_beam_correct_side(const struct wf_beam_shape *u, const double base_L[9],
                          const struct wf_beam_answer *answer, const struct wf_beam_reaction *node,
                          const double p[6], double dv[2][3], double end[6]);

/* Add the material law residual of one element, with internal forces `at` at its Gauss points, to *sum. flat
 * NULL: round section. */
void wf_beam_misfit_add(const struct wf_beam_part *p, const struct wf_beam_shape *u, const double base_L[9],
                        const struct wf_beam_creep *creep, const struct wf_beam_stage *s,
                        const struct wf_beam_flat *flat, const struct wf_beam_wrench at[2],
                        struct wf_beam_misfit *sum);
#endif
