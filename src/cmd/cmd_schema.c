/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/yaml.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "data/model.h"
#include "data/species.h"
#include "fit/calibration.h"
#include "load/drag.h"
#include <stdio.h>
#include <string.h>

int wf_cmd_schema(int argc, char **argv)
{
    static const char about[] = "  windfirm schema species\n  windfirm schema model\n  windfirm schema fit\n"
                                "  windfirm schema study";
    enum { WORDS = 4 };
    static const char *const word[WORDS] = { "species", "model", "fit", "study" };
    static const struct wf_yaml_table *const table[WORDS] = { NULL, &wf_model_table, &wf_calibration_table,
                                                              NULL };
    static const struct wf_option none[] = { { 0 } };
    struct wf_arena arena = { 0 };
    struct wf_args args;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, none, about, 1, 1, &arena, &args);
    if (code < 0) {
        size_t k = 0;
        while (k < WORDS && strcmp(args.operand[0], word[k]) != 0) k++;
        if (k == WORDS) {
            wf_show(stderr, "windfirm schema: '%s' is none of species, model, fit, study%s\n",
                    args.operand[0], wf_did_you_mean(args.operand[0], word, WORDS).text);
            code = 2;
        } else {
            const char *text = table[k] ? wf_yaml_schema(table[k], &arena, &e)
                               : k == 0 ? wf_species_schema(&wf_laws, &arena, &e)
                                        : wf_args_study_schema(&arena, &e);
            code = text ? (wf_show_text(stdout, text), 0) : wf_complain(&e);
        }
    }
    wf_arena_free(&arena);
    return code;
}
