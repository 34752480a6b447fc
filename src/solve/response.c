#include "solve/solve.h"

enum wf_status wf_response_alloc(struct wf_response *r, size_t n, struct wf_arena *a, struct wf_err *e)
{
    double **const column[] = { &r->end,     &r->turn,     &r->force0,   &r->moment0, &r->force1,
                                &r->moment1, &r->tangent0, &r->tangent1, &r->load };
    *r = (struct wf_response){ .n = n };
    for (size_t i = 0; i < sizeof column / sizeof *column; i++)
        if (!(*column[i] = WF_TAKE(a, 3 * n, double)))
            return wf_fail(e, WF_ENOMEM, "no room for the response of %zu segments", n);
    return WF_OK;
}

void wf_solve_options_default(struct wf_solve_options *o)
{
    *o = (struct wf_solve_options){
        .tolerance = 1e-9, .mesh_tolerance = 1e-6, .iterations_max = 100, .threads = 1
    };
}
