#include "base/file.h"
#include "cmd/profile_options.h"
#include "cmd/wind_speed.h"
#include "out/figures.h"
#include "study/explain.h"
#include "study/limits.h"
#include "study/scenario.h"
#include <libxml/tree.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const struct wf_option wf_explain_options[] = {
    WF_STUDY_FILE_OPTION,
    { .name = "--model",
      .letter = "-m",
      .kind = WF_OPTION_TEXT,
      .value = "MODEL",
      .help = "tree model: a file, or the name of a shipped one" },
    WF_WIND_OPTIONS(0.01, 100, "mean wind at the reference height"),
    WF_PROFILE_OPTIONS,
    { .name = "--output",
      .letter = "-o",
      .kind = WF_OPTION_TEXT,
      .value = "FOLDER",
      .initial = "out/explain",
      .help = "where the table and the plot go" },
    { .name = "--no-plots", .kind = WF_OPTION_FLAG, .help = "write the table only" },
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

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Middle ratio of a method over the branches of a level. */
static double median(const struct wf_explain *x, size_t method, int32_t level, double *room)
{
    size_t n = 0;
    for (size_t b = 0; b < x->axes; b++)
        if (x->axis[b].level == level && isfinite(x->axis[b].ratio[method]))
            room[n++] = x->axis[b].ratio[method];
    qsort(room, n, sizeof *room, ascending);
    return n ? 0.5 * (room[(n - 1) / 2] + room[n / 2]) : NAN;
}

static int32_t top_level(const struct wf_explain *x)
{
    int32_t top = 0;
    for (size_t b = 0; b < x->axes; b++) top = x->axis[b].level > top ? x->axis[b].level : top;
    return top;
}

static void print(const struct wf_explain *x, double speed, double height, double *room)
{
    printf("Wind %.4g m/s, a 10-min mean at %.6g m\n", speed, height);
    printf("Own bending of the branches over that by beam theory, middle of each level\n\n%-18s%10s",
           "method", "tip");
    for (int32_t l = 0; l <= top_level(x); l++) printf("   level %d", (int)l);
    printf("\n");
    for (size_t m = 0; m < x->methods; m++) {
        printf("%-18s%10.4g", x->method[m]->name, x->tip[m]);
        for (int32_t l = 0; l <= top_level(x); l++) printf("%10.4g", median(x, m, l, room));
        printf("\n");
    }
    printf("\n");
}

static enum wf_status begin(struct wf_file *f, const char *folder, const char *sub, const char *name,
                            struct wf_err *e)
{
    char path[WF_PATH_MAX];
    snprintf(path, sizeof path, "%.4000s/%s", folder, sub);
    enum wf_status s = wf_mkdirs(path, e);
    snprintf(path, sizeof path, "%.4000s/%s/%s", folder, sub, name);
    return s ? s : wf_file_begin(f, path, e);
}

static void table(FILE *f, const struct wf_explain *x, const struct wf_tree *t)
{
    fputs("branch,level,segment,base_height_m,length_m,base_radius_m,beam_m", f);
    for (size_t m = 0; m < x->methods; m++) fprintf(f, ",%s", x->method[m]->name);
    fputc('\n', f);
    for (size_t b = 0; b < x->axes; b++) {
        const struct wf_explain_axis *o = &x->axis[b];
        fprintf(f, "%zu,%d,%lld,%.6g,%.6g,%.6g,%.6g", b + 1, (int)o->level, (long long)t->id[o->first],
                o->height, o->length, o->radius, o->beam);
        for (size_t m = 0; m < x->methods; m++)
            isfinite(o->ratio[m]) ? fprintf(f, ",%.6g", o->ratio[m]) : fputc(',', f);
        fputc('\n', f);
    }
}

static void facts(FILE *f, const struct wf_explain *x)
{
    double low = 0.5, high = 2;
    for (size_t b = 0; b < x->axes; b++)
        for (size_t m = 0; m < x->methods; m++)
            if (x->axis[b].ratio[m] > 0 && isfinite(x->axis[b].ratio[m]))
                low = fmin(low, x->axis[b].ratio[m]), high = fmax(high, x->axis[b].ratio[m]);
    fprintf(f, "METHODS = %zu\nFIRST = 7\nLEVELS = %d\nLOW = %g\nHIGH = %g\narray NAME[%zu] = [", x->methods,
            (int)top_level(x) + 1, pow(10, floor(log10(low))), pow(10, ceil(log10(high))), x->methods);
    for (size_t m = 0; m < x->methods; m++) fprintf(f, "%s'%s'", m ? ", " : "", x->method[m]->name);
    fputs("]\n", f);
}

static enum wf_status write(const struct wf_explain *x, const struct wf_tree *t, const char *folder,
                            bool plots, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = begin(&f, folder, "tables", "explain.csv", e);
    if (!s) table(f.stream, x, t), s = wf_file_commit(&f, e);
    if (!s) s = begin(&f, folder, "plots", "run.gp", e);
    if (!s) facts(f.stream, x), s = wf_file_commit(&f, e);
    if (s || !plots) return s;
    xmlDoc *svg = NULL;
    s = wf_figures_draw(folder, "explain", &svg, e);
    if (svg) xmlFreeDoc(svg);
    return s;
}

static enum wf_status run(const struct wf_args *g, struct wf_arena *a, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_species sp;
    struct wf_model m;
    struct wf_explain x;
    struct wf_solve_options o;
    struct wf_analysis an = { .species = &sp, .model = &m, .solver = wf_solvers[0] };
    const char *folder = wf_args_text(g, "--output");
    bool quiet = wf_args_given(g, "--quiet");
    const struct wf_profile_words profile = wf_profile_asked(g);
    wf_scenario_default(&an.scenario);
    wf_solve_options_default(&o);
    enum wf_status s = wf_species_read(wf_shipped("species", g->operand[0], a), a, &sp, &d, e);
    if (!s) s = wf_model_read(wf_shipped("models", wf_args_text(g, "--model"), a), a, &m, &d, e);
    if (!s) s = wf_scenario_profile(&an.scenario, &profile, a, &d, e);
    if (!s) s = wf_scenario_check(&an.scenario, e);
    if (!s) s = wf_analysis_set_up(&an, a, &d, e);
    if (!s) wf_limits_profile(&an.scenario, an.tallness, m.name, &d);
    if (!s) s = wf_explain_run(&an, &o, wf_args_number(g, "--wind"), a, &d, &x, e);
    double *room = s ? NULL : WF_TAKE(a, x.axes, double);
    if (room && !quiet) print(&x, wf_args_number(g, "--wind"), an.scenario.reference_height, room);
    fflush(stdout);
    wf_print_findings(&d, quiet);
    if (!s) s = write(&x, &an.tree, folder, !wf_args_given(g, "--no-plots"), e);
    if (!s && !quiet) printf("\nTable and plot: %s\n", folder);
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
    if (code < 0) code = run(&g, &arena, &e) ? wf_complain(&e) : 0;
    wf_arena_free(&arena);
    return code;
}
