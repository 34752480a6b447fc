#include "cmd/series_perform.h"
#include "cmd/pages.h"
#include "out/results.h"
#include "out/series.h"
#include "study/explain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

char *wf_series_typed(int argc, char **argv, struct wf_arena *a)
{
    char *text = wf_arena_text(a, "windfirm");
    for (int i = 0; text && i < argc; i++) text = wf_arena_print(a, "%s %s", text, argv[i]);
    return text;
}

/* A file a run names, or a shipped one. `file`: that of the runs; NULL: they were typed. */
static const char *named(const char *room, const char *name, const char *file, struct wf_arena *a)
{
    return wf_shipped(room, file ? wf_beside(file, name, a) : name, a);
}

/* Species and model of a run. Every mistake is printed. */
static enum wf_status read_run(const struct wf_series_plan_run *r, const char *file, struct wf_arena *a,
                               struct wf_series_spec *out, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_species *sp = WF_TAKE(a, 1, struct wf_species);
    struct wf_model *m = WF_TAKE(a, 1, struct wf_model);
    struct wf_err why[2] = { { 0 }, { 0 } };
    if (!sp || !m) return wf_fail(e, WF_ENOMEM, "no memory");
    enum wf_status s = wf_species_read(named("species", r->species, file, a), a, sp, &d, &why[0]);
    enum wf_status t = wf_model_read(named("models", r->model, file, a), a, m, &d, &why[1]);
    wf_print_findings(&d, false);
    if (s || t) return wf_fail(e, s ? s : t, "run '%s': %s", r->name, s ? why[0].text : why[1].text);
    return wf_series_plan_spec(r, sp, m, a, out, e);
}

static void print(const struct wf_series_page *p)
{
    printf("%s\n\n%4s  %-34s%10s%12s%12s%12s\n", p->title, "run", "", "frames", "wind m/s", "tip mean m",
           "most m");
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        double sum = 0, most = 0, wind = 0, n = 0;
        for (size_t k = 0; k < s->frames; k++) {
            wind += s->wind[k] / (double)s->frames;
            if (isfinite(s->deflection[k])) sum += s->deflection[k], most = fmax(most, s->deflection[k]), n++;
        }
        printf("%4zu  %-34s%10zu%12.2f%12.4g%12.4g\n", r + 1, s->spec.name, s->frames, wind, sum / n, most);
    }
    printf("\n");
}

/* Findings of all runs, those that several have in common once. */
static void print_findings(const struct wf_diag *diag, size_t runs, bool quiet, struct wf_arena *a)
{
    struct wf_diag once = { .arena = a };
    for (size_t r = 0; r < runs; r++)
        for (const struct wf_finding *w = diag[r].first; w; w = w->next)
            wf_diag_warn(&once, w->code, "%s", w->text);
    wf_print_findings(&once, quiet);
}

static enum wf_status run_all(const struct wf_series_job *j, struct wf_series *series, struct wf_diag *diag,
                              struct wf_arena *a, struct wf_err *e)
{
    const struct wf_series_plan *plan = j->plan;
    for (size_t r = 0; r < plan->runs; r++) {
        struct wf_series_spec spec;
        diag[r].arena = a;
        enum wf_status s = read_run(&plan->run[r], plan->file, a, &spec, e);
        if (s) return s;
        wf_progress("run %zu of %zu: %s ...", r + 1, plan->runs, spec.name);
        s = wf_series_run(&spec, a, &diag[r], &series[r], e);
        wf_progress(NULL);
        if (s) wf_print_findings(&diag[r], j->quiet);
        if (s) return s;
    }
    return WF_OK;
}

/* Every method on the trees of the runs that ask for it. What it warns of stands with the run. */
static enum wf_status explain_runs(const struct wf_series_plan *plan, const struct wf_series *series,
                                   struct wf_diag *diag, struct wf_arena *a, struct wf_series_page *page,
                                   struct wf_err *e)
{
    struct wf_explained *of = WF_TAKE(a, plan->runs, struct wf_explained);
    struct wf_explain *made = WF_TAKE(a, plan->runs, struct wf_explain);
    enum wf_status s = of && made ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
    page->explain = of;
    for (size_t r = 0; r < plan->runs && !s; r++) {
        const struct wf_series *x = &series[r];
        if (!plan->run[r].explain || strcmp(plan->run[r].explain, "yes") != 0) continue;
        wf_progress("every method on the tree of run %zu ...", r + 1);
        s = wf_explain_run(&x->an, &x->spec.solve, x->spec.speed, a, &diag[r], &made[r], e);
        wf_progress(NULL);
        of[page->explained++] = (struct wf_explained){
            .run = r + 1, .name = x->spec.name, .of = &made[r], .tree = &x->an.tree, .speed = x->spec.speed
        };
    }
    return s;
}

int wf_series_perform(const struct wf_series_job *j, struct wf_arena *a)
{
    const struct wf_series_plan *plan = j->plan;
    struct wf_err e = { 0 };
    struct wf_series *series = WF_TAKE(a, plan->runs, struct wf_series);
    struct wf_diag *diag = WF_TAKE(a, plan->runs, struct wf_diag);
    struct wf_series_run *run = WF_TAKE(a, plan->runs, struct wf_series_run);
    struct wf_series_page page = { .title = plan->title,
                                   .note = plan->note,
                                   .command = j->command,
                                   .version = WF_VERSION,
                                   .date = wf_run_date(a),
                                   .n = plan->runs,
                                   .run = run };
    if (!series || !diag || !run || !page.date || !j->command) {
        wf_fail(&e, WF_ENOMEM, "no memory");
        return wf_complain(&e);
    }
    for (size_t r = 0; r < plan->runs; r++) run[r] = (struct wf_series_run){ &series[r], &diag[r] };
    enum wf_status s = run_all(j, series, diag, a, &e);
    if (!s) s = explain_runs(plan, series, diag, a, &page, &e);
    if (s) return wf_complain(&e);
    if (!j->quiet) print(&page);
    fflush(stdout);
    print_findings(diag, plan->runs, j->quiet, a);
    s = wf_series_tables(&page, j->folder, &e);
    if (!s && j->vtk) s = wf_series_vtk(&page, j->folder, &e);
    if (!s && j->page) s = wf_pages_make(j->folder, j->language, a, &e);
    if (s) return wf_complain(&e);
    if (!j->quiet) printf("\nTables%s%s: %s\n", j->vtk ? ", frames" : "", j->page ? ", page" : "", j->folder);
    return 0;
}
