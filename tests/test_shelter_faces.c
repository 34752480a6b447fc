/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the wind inside a crown is not smooth: the faces of its cells. */
#include "wind/shelter_laws.h"
#include "base/vec3.h"
#include "beam_cases.h"
#include "wind/shelter.h"

/* Distance to the next face: a step there ends on a whole cell, and none is nearer. */
static void faces_of_cells(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_shelter s;
    struct wf_shelter_request q;
    struct wf_wind field;
    beam_tree3(&c);
    beam_blow(&c, 3, 4, 0);
    wf_shelter_request_default(&q);
    q.slabs = 8, q.cells = 16;
    if (wf_shelter_make(&c.tree, &c.wind, &q, &c.arena, &s, &c.err)) fail_msg("%s", c.err.text);
    wf_shelter_field(&s, &field);
    for (int k = 0; k < 40; k++) {
        double x[3] = { 0.03 * k - 0.4, 0.3 - 0.02 * k, 0.05 * k }, a = 0.7 * k, to[3], near = 1;
        const double t[3] = { 0.6 * cos(a), 0.6 * sin(a), 0.8 };
        double far = field.clear(&field, x, t);
        for (int j = 0; j < 3; j++) to[j] = x[j] + far * t[j];
        for (int j = 0; j < 3; j++) {
            double at = (wf_dot(s.axis[j], to) - s.low[j]) / s.step[j];
            near = fmin(near, fabs(at - round(at)));
        }
        assert_true(far > 0 && near < 1e-9);
    }
    beam_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(faces_of_cells) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
