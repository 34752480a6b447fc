/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/yaml.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "data/model.h"
#include "data/species.h"
#include "fit/calibration.h"
#include "load/drag.h"
#include <string.h>

struct schema_options {
    struct wf_args args;
    bool json_schema;
};
#define OPTIONS struct schema_options
static const struct wf_option options[] = {
    FLAG("--json-schema", json_schema, "as a JSON Schema (draft-07), with which editors complete and check"),
    { 0 },
};

/* The rows of a kind of file; NULL: no memory. */
static const struct wf_yaml_table *species_table(struct wf_arena *a) { return wf_species_table(&wf_laws, a); }
static const struct wf_yaml_table *model_table(struct wf_arena *a) { return (void)a, &wf_model_table; }
static const struct wf_yaml_table *fit_table(struct wf_arena *a) { return (void)a, &wf_calibration_table; }

int wf_cmd_schema(int argc, char **argv)
{
    static const char about[] = "  windfirm schema species\n  windfirm schema model\n  windfirm schema fit\n"
                                "  windfirm schema study\n  windfirm schema model --json-schema";
    enum { KINDS = 4 };
    static const char *const word[KINDS] = { "species", "model", "fit", "study" };
    static const struct wf_yaml_table *(*const table[KINDS])(
        struct wf_arena *) = { species_table, model_table, fit_table, wf_args_study_table };
    struct wf_arena arena = { 0 };
    struct schema_options o;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 1, 1, &arena, &o.args);
    if (code < 0) {
        size_t k = 0;
        while (k < KINDS && strcmp(o.args.operand[0], word[k]) != 0) k++;
        if (k == KINDS) {
            wf_show(stderr, "windfirm schema: '%s' is none of species, model, fit, study%s\n",
                    o.args.operand[0], wf_did_you_mean(o.args.operand[0], word, KINDS).text);
            code = 2;
        } else {
            const struct wf_yaml_table *t = table[k](&arena);
            const char *text =
                o.json_schema ? wf_yaml_json_schema(t, &arena, &e) : wf_yaml_schema(t, &arena, &e);
            code = text ? (wf_show_text(stdout, text), 0) : wf_complain(&e);
        }
    }
    wf_arena_free(&arena);
    return code;
}
