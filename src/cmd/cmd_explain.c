#include "cmd/pages.h"
#include "cmd/profile_options.h"
#include "cmd/wind_speed.h"
#include "out/explain.h"
#include "study/limits.h"
#include "study/preset.h"
#include "study/scenario.h"
#include <math.h>
#include <stdio.h>

const struct wf_option wf_explain_options[] = {
    WF_STUDY_FILE_OPTION,
    { .name = "--model",
      .letter = "-m",
      .kind = WF_OPTION_TEXT,
      .value = "MODEL",
      .help = "tree model: a file, or the name of a shipped one" },
    WF_WIND_OPTIONS(0.01, 100, "mean wind at the reference height"),
    WF_PROFILE_OPTIONS,
    WF_AZIMUTH_OPTION,
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/explain",
      .help = "where table, plot and page go" },
    { .name = "--no-report", .kind = WF_OPTION_FLAG, .help = "write the table only" },
    WF_LANG_OPTION,
    { .name = "--quiet", .letter = "-q", .kind = WF_OPTION_FLAG, .help = "print errors only" },
    { 0 },
};

static const char about[] = "SPECIES is a species table. Every solver bends the same tree in the same wind; "
                            "for each branch the table gives "
                            "its own bending (less what its foot does) over that of the beam engine: where a "
                            "published method, as printed "
                            "or corrected, can be trusted, and where it cannot.\n"
                            "\n"
                            "  windfirm explain poplar --model zhao2013_ifs --wind 10";

static void print(const struct wf_explain *x, double speed, double height)
{
    printf("Wind %.4g m/s, a 10-min mean at %.6g m\n", speed, height);
    printf("Own bending of the branches over that by beam theory, middle of each level\n\n%-18s%10s%10s",
           "method", "tip", "within 5%");
    for (int32_t l = 0; l <= wf_explain_top(x); l++) printf("   level %d", (int)l);
    printf("\n");
    for (size_t m = 0; m < x->methods; m++) {
        printf("%-18s%10.4g%9.0f%%", x->method[m]->name, x->tip[m], 100 * wf_explain_share(x, m, 0.05));
        for (int32_t l = 0; l <= wf_explain_top(x); l++) {
            struct wf_explain_spread s;
            wf_explain_spread(x, m, l, &s);
            printf("%10.4g", s.middle);
        }
        printf("\n");
    }
    printf("\n");
}

/* What the printed methods leave out on this tree. */
static void departures(const struct wf_analysis *an, struct wf_diag *d)
{
    for (const struct wf_preset *p = wf_presets; p->name; p++) {
        struct wf_analysis as = *an;
        if (p->solver) as.solver = wf_solver_named(p->solver);
        wf_preset_warn(p, &as, d);
    }
}

static enum wf_status run(const struct wf_args *g, const struct wf_doc_head *head, struct wf_arena *a,
                          struct wf_err *e)
{
    struct wf_diag d = { .arena = a }, leaves = { .arena = a };
    struct wf_species sp;
    struct wf_model m;
    struct wf_explain x;
    struct wf_solve_options o;
    struct wf_analysis an = { .species = &sp, .model = &m, .solver = wf_solvers[0] };
    bool quiet = wf_args_given(g, "--quiet");
    const struct wf_profile_words profile = wf_profile_asked(g);
    wf_scenario_default(&an.scenario);
    an.scenario.azimuth = wf_args_number(g, "--azimuth");
    wf_solve_options_default(&o);
    enum wf_status s = wf_species_read(wf_shipped("species", g->operand[0], a), a, &sp, &d, e);
    if (!s) s = wf_model_read(wf_shipped("models", wf_args_text(g, "--model"), a), a, &m, &d, e);
    if (!s) s = wf_scenario_profile(&an.scenario, &profile, a, &d, e);
    if (!s) s = wf_scenario_check(&an.scenario, e);
    if (!s) s = wf_analysis_set_up(&an, a, &d, e);
    if (!s) wf_limits_profile(&an.scenario, an.tallness, m.name, &d);
    if (!s) s = wf_explain_run(&an, &o, wf_args_number(g, "--wind"), a, &d, &x, e);
    if (!s && !quiet) print(&x, wf_args_number(g, "--wind"), an.scenario.reference_height);
    fflush(stdout);
    wf_print_findings(&d, quiet);
    if (s) return s;
    departures(&an, &leaves);
    const struct wf_explained of = { .run = 1,
                                     .name = wf_arena_print(a, "%s, %s", sp.key, m.key),
                                     .of = &x,
                                     .tree = &an.tree,
                                     .speed = wf_args_number(g, "--wind"),
                                     .findings = &leaves };
    const char *folder = wf_args_text(g, "--output");
    s = of.name ? wf_explain_write(&of, head, folder, e) : wf_fail(e, WF_ENOMEM, "no memory");
    if (!s && !wf_args_given(g, "--no-report")) s = wf_pages_make(folder, wf_args_text(g, "--lang"), a, e);
    if (!s && !quiet)
        printf("\nTable%s: %s\n", wf_args_given(g, "--no-report") ? "" : ", plot, page", folder);
    return s;
}

int wf_cmd_explain(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct wf_args g;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, wf_explain_options, about, 1, 1, &arena, &g);
    if (code < 0 && !wf_args_text(&g, "--model")) {
        fprintf(stderr, "windfirm explain: --model is needed, for example --model models/culm.yaml\n");
        code = 2;
    }
    if (code < 0) {
        struct wf_doc_head head;
        enum wf_status s = wf_pages_head(argc, argv, &arena, &head, &e);
        code = s || run(&g, &head, &arena, &e) ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
