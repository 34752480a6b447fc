/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Methods against beam theory, branch by branch. */
#include "made.h"
#include "study/explain.h"
#include <string.h>

struct explained {
    struct made in;
    struct wf_explain out;
};

static void explain(struct explained *x, const char *model, double speed)
{
    struct made *m = &x->in;
    made_read(m, "species/poplar.yaml", model);
    m->an = (struct wf_analysis){ .species = &m->species,
                                  .model = &m->model,
                                  .solver = wf_solvers[0],
                                  .scenario = m->scenario };
    if (wf_analysis_set_up(&m->an, NULL, &m->arena, &m->diag, &m->err) ||
        wf_explain_run(&m->an, &m->options, speed, &m->arena, &m->diag, &x->out, &m->err))
        fail_msg("%s", m->err.text);
}

static size_t method(const struct wf_explain *x, const char *name)
{
    for (size_t k = 0; k < x->methods; k++)
        if (!strcmp(x->method[k]->name, name)) return k;
    fail_msg("no method %s", name);
    return 0;
}

static void branches(void **state)
{
    (void)state;
    struct explained m;
    explain(&m, "models/zhao2013_ifs.yaml", 4);
    const struct wf_explain *x = &m.out;
    assert_int_equal(x->axes, 1 + 12 + 96);
    size_t rod = method(x, "rod"), chain = method(x, "chain"), printed = method(x, "chain-as-printed"),
           cube = method(x, "deflect-as-printed");
    size_t close = 0, small = 0;
    for (size_t b = 0; b < x->axes; b++) {
        assert_close(x->axis[b].ratio[rod], 1, 2e-3); /* but for stretch */
        close += x->axis[b].ratio[chain] > 0.8 && x->axis[b].ratio[chain] < 1.25;
        small += x->axis[b].ratio[printed] < 0.3;
        assert_true(x->axis[b].ratio[cube] < 0.05);
        assert_true(x->axis[b].last >= x->axis[b].first + 4);
    }
    assert_true(x->axis[0].ratio[printed] < 0.05 && small > 100);
    assert_true(close > 100); /* a few twigs lie along the wind or bear little of it */
    assert_close(x->tip[rod], 1, 1e-3);
    wf_arena_free(&m.in.arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(branches) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
