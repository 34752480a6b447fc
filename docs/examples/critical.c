/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a tree's tip moves in a mean wind, and the mean wind whose gusts break it.
 * cc critical.c $(pkg-config --cflags --libs windfirm) -o critical
 * ./critical SPECIES.yaml MODEL.yaml SPEED_IN_M_PER_S */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <windfirm/windfirm.h>

int main(int argc, char **argv)
{
    static struct wf_arena memory;
    static struct wf_err why;
    static struct wf_diag findings;
    struct wf_species species;
    struct wf_model *model;
    struct wf_scenario scenario;
    struct wf_search search;
    struct wf_solve_options options;
    struct wf_analysis tree;
    double speed = argc > 3 ? atof(argv[3]) : 0;
    if (argc != 4) return fprintf(stderr, "usage: %s SPECIES MODEL SPEED\n", argv[0]), 2;

    findings.arena = &memory;
    wf_scenario_default(&scenario);
    wf_search_default(&search);
    wf_solve_options_default(&options);
    if (wf_species_read(argv[1], &wf_laws, &memory, &species, &findings, &why) ||
        wf_model_open(argv[2], &memory, &model, &findings, &why) ||
        wf_analyze(&species, model, &scenario, &search, wf_solver_named("beam"), &options, &speed, 1, &memory,
                   &findings, &tree, &why))
        return fprintf(stderr, "%s\n", why.text), 1;
    double lost = INFINITY; /* the lowest wind at which the stem fails, or the root */
    for (int c = 0; c < WF_CRITERIA; c++) {
        const struct wf_critical *at = &tree.breaks[c][WF_SCOPE_STEM].critical;
        if (wf_criteria[c].loses_tree && at->outcome == WF_CRITICAL_FOUND) lost = fmin(lost, at->speed);
    }
    printf("tip %.3f m, critical wind %.2f m/s\n", tree.at[0].steady.tip_deflection, lost);
    wf_arena_free(&memory);
    return 0;
}
