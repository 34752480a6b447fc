#include "solve/chain_variants.h"
#include "solve/chain.h"

#define VARIANT(id, called, spread, handed, turned)                                                          \
    static enum wf_status solve_##id(const struct wf_tree *t, const struct wf_loads *l,                      \
                                     const struct wf_solve_options *o, struct wf_arena *a,                   \
                                     struct wf_response *r, struct wf_diag *d, struct wf_err *e)             \
    {                                                                                                        \
        static const struct wf_chain_scheme scheme = {                                                       \
            .smear = spread, .moment = handed, .carry = turned, .taper = 1, .weight = 1                      \
        };                                                                                                   \
        return wf_chain_solve(&scheme, t, l, o, a, r, d, e);                                                 \
    }                                                                                                        \
    static const struct wf_solver id = { .name = called,                                                     \
                                         .title = "a way between the printed and the corrected chain",       \
                                         .source = "variants of Tang et al. 2012, eqs 5-12",                 \
                                         .validity = "to compare schemes; not for trees",                    \
                                         .small_deflection = true,                                           \
                                         .solve = solve_##id }

VARIANT(s1, "chain-S1", 1, 0, 0);
VARIANT(s1_turned, "chain-S1-turned", 1, 0, 1);
VARIANT(s2, "chain-S2", 0, 0, 0);
VARIANT(s2_turned, "chain-S2-turned", 0, 0, 1);
VARIANT(s3, "chain-S3", 1, 1, 0);
VARIANT(s3_turned, "chain-S3-turned", 1, 1, 1);
VARIANT(s4, "chain-S4", 0, 1, 0);
VARIANT(s4_turned, "chain-S4-turned", 0, 1, 1);

const struct wf_solver *const wf_chain_variants[] = { &s1,        &s1_turned, &s2,        &s2_turned, &s3,
                                                      &s3_turned, &s4,        &s4_turned, NULL };
