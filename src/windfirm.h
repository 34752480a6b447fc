/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WINDFIRM_H
#define WF_WINDFIRM_H
/* windfirm: what wind does to a tree. The one header of the library: #include <windfirm/windfirm.h>, flags by
 * `pkg-config --cflags --libs windfirm`. docs/api.md explains it, docs/examples/critical.c uses it.
 *
 * Everything is SI (m, N, Pa, kg, rad, s, K). Structs are open: read and change them. Names begin wf_ or WF_.
 * Every function that can fail returns an enum wf_status, WF_OK = 0, and says why in a struct wf_err.
 *
 *   struct wf_arena memory = { 0 };                  all results live here until wf_arena_free
 *   struct wf_diag findings = { .arena = &memory };  mistakes of files, warnings of runs
 *   struct wf_err why = { 0 };                       the first error, in words
 */

/* Version of this header. Before 1.0 a minor version may break programs; docs/changes.md lists every break.
 */
#define WF_VERSION_MAJOR 0
#define WF_VERSION_MINOR 18
#define WF_VERSION_PATCH 0
#define WF_VERSION "0.18.0"

/* ---- Memory, errors, findings ----
 *
 * wf_arena_free(&memory) gives back all that was made in an arena; WF_TAKE(&memory, n, T) takes from it.
 * wf_status_text(s): words of a status; why.text: what went wrong, with names and numbers.
 * wf_finding_print(f, buffer, size): one finding as "file:line:column: error: text"; the list starts at
 * findings.first. */
#include "base/arena.h"
#include "base/err.h"

/* ---- Species: materials and crown ----
 *
 * wf_species_read(path, &wf_laws, &memory, &species, &findings, &why) reads a species table.
 * species.level[0].youngs_modulus.value and its neighbours may be changed before the analysis.
 * wf_laws (load/load.h) are the laws of drag a table may choose from. */
#include "data/law.h"
#include "data/species.h"

/* ---- Trees ----
 *
 * A struct wf_model is an architecture without materials; it stays closed:
 *   wf_model_open(path, &memory, &model, &findings, &why)             from a model file
 *   wf_model_scanned(path, NULL, &memory, &model, &findings, &why)    from a scan (QSM, MTG, CSV, MATLAB)
 *   wf_model_leaves(model, area, &why), wf_model_stands(model, true)  its leaves; drawn as it stands
 * wf_grow(model, &species, &memory, &tree, &findings, &why) clothes it: a struct wf_tree, columns with one
 * row a segment, every parent before its children. A tree can also be filled in by hand: wf_tree_alloc, then
 * wf_tree_check. */
#include "data/tree.h"
#include "grow/grow.h"

/* ---- Wind and loads ----
 *
 * wf_scenario_default(&scenario): power law 0.16 at 10 m towards +x, 15 C, sea level, 9.81 m/s2. Change its
 * fields: profile (a row of wf_profiles), roughness, azimuth, temperature, altitude, ...
 * wf_scenario_check refuses what cannot be blown; wf_scenario_loads turns it, with a species, into the wind
 * field and the loads that solvers take. Dead and follower point loads, line loads: struct wf_loads. */
#include "load/load.h"
#include "load/scene.h"
#include "wind/wind.h"

/* ---- Solvers ----
 *
 * wf_solver_named("beam"): geometrically exact beams, the default; others are rows of wf_solvers.
 * wf_solve_options_default(&options). solver->solve(&tree, &loads, &options, &memory, &response, &findings,
 * &why) is the shortest way from a tree and loads to its bent shape and section forces, struct wf_response.
 */
#include "solve/solve.h"

/* ---- Failure ----
 *
 * wf_breakage_check: forces and stresses in the sections of a solved tree. wf_criteria: criteria as rows,
 * wf_criteria_check: the place nearest to failure for each, in the whole tree, the stem and the branches.
 * wf_critical_search: the lowest wind speed at which any function of it reaches 1. */
#include "fail/fail.h"

/* ---- Analysis: all of it for one tree ----
 *
 * wf_search_default(&search): critical wind speeds are searched for up to 60 m/s, or 1.2 times the
 * highest of the n speeds where that is more.
 * wf_analyze(&species, model, &scenario, &search, wf_solver_named("beam"), &options, speeds, n, &memory,
 *            &findings, &analysis, &why)
 * grows the tree, bends it at n wind speeds at the scenario's reference height, searches the critical wind
 * speeds and samples curves. Of struct wf_analysis:
 *   at[k]                                  the k-th speed: status, tip_deflection, base_moment, response, ...
 *   breaks[WF_BREAKAGE][WF_SCOPE_TREE]     .critical.outcome, .critical.speed [m/s]; .row: where it breaks
 *   sweep[0 .. sweep_n)                    totals from 0 upwards, for curves
 *   tree, loads, wind                      what was analysed
 * wf_analyze returns WF_OK where a single speed has no equilibrium: at[k].status says so. */
#include "study/analysis.h"

/* ---- Wind from all around ----
 *
 * struct wf_directions_request q = { .n = 16 };
 * wf_directions_run(&analysis, &options, &q, &memory, &directions, &why): the same for evenly spaced
 * directions; directions.direction[k].breaks, .from. */
#include "study/directions.h"

#endif
