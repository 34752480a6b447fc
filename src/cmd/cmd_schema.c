#include "base/near.h"
#include "base/yaml.h"
#include "cmd/cmd.h"
#include "data/model_schema.h"
#include "data/species_schema.h"
#include "fit/study.h"
#include <stdio.h>
#include <string.h>

int wf_cmd_schema(int argc, char **argv)
{
    static const char about[] = "  windfirm schema species\n  windfirm schema model\n  windfirm schema fit";
    static const char *const word[] = { "species", "model", "fit" };
    static const struct wf_yaml_table *const table[] = { &wf_species_table, &wf_model_table,
                                                         &wf_fit_study_table };
    static const struct wf_option none[] = { { 0 } };
    struct wf_arena arena = { 0 };
    struct wf_args args;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, none, about, 1, 1, &arena, &args);
    if (code < 0) {
        const char *near = wf_nearest(args.operand[0], word, 3);
        size_t k = 0;
        while (k < 3 && strcmp(args.operand[0], word[k]) != 0) k++;
        if (k == 3) {
            fprintf(stderr, "windfirm schema: '%s' is neither species nor model nor fit%s%s%s\n",
                    args.operand[0], near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
            code = 2;
        } else {
            const char *text = wf_yaml_schema(table[k], &arena, &e);
            code = text ? (fputs(text, stdout), 0) : wf_complain(&e);
        }
    }
    wf_arena_free(&arena);
    return code;
}
