/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "close.h"
#include "data/out/folder.h"
#include "data/out/mock.h"
#include "out/printer.h"
#include "out/report.h"
#include <signal.h>
#include <sys/wait.h>

static const double winds[] = { 10, 15, 25 };

struct fixture {
    struct wf_arena arena;
    struct folder folder;
    struct wf_diag diag;
    struct wf_err e;
    struct wf_printer printer;
    char *path; /* PATH as it was */
};

static int setup(void **state)
{
    struct fixture *f = calloc(1, sizeof *f);
    if (!f || !folder_make(&f->folder)) return -1;
    f->diag.arena = &f->arena;
    f->path = strdup(getenv("PATH") ? getenv("PATH") : "/usr/bin:/bin");
    *state = f;
    return f->path ? 0 : -1;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    wf_printer_close(&f->printer);
    setenv("PATH", f->path, 1);
    unsetenv("WINDFIRM_SHARE");
    folder_remove(&f->folder);
    wf_arena_free(&f->arena);
    free(f->path);
    free(f);
    return 0;
}

static bool installed(const char *program)
{
    char list[8192], path[512], *rest = NULL;
    snprintf(list, sizeof list, "%s", getenv("PATH") ? getenv("PATH") : "");
    for (char *dir = strtok_r(list, ":", &rest); dir; dir = strtok_r(NULL, ":", &rest)) {
        snprintf(path, sizeof path, "%s/%s", dir, program);
        if (!access(path, X_OK)) return true;
    }
    return false;
}

static bool skipped(const char *program)
{
    if (installed(program)) return false;
    print_message("skipped: %s is not installed\n", program);
    return true;
}

/* A PATH that knows of one program alone (NULL: of none). */
static void only(struct fixture *f, const char *program)
{
    char list[8192], path[512], bin[128], *rest = NULL;
    snprintf(bin, sizeof bin, "%s/bin", f->folder.path);
    mkdir(bin, 0700);
    snprintf(list, sizeof list, "%s", f->path);
    for (char *dir = strtok_r(list, ":", &rest); dir && program; dir = strtok_r(NULL, ":", &rest)) {
        char link[160];
        snprintf(path, sizeof path, "%s/%s", dir, program);
        snprintf(link, sizeof link, "%s/%s", bin, program);
        if (!access(path, X_OK) && !symlink(path, link)) break;
    }
    setenv("PATH", bin, 1);
}

static void results(struct fixture *f, struct wf_run run)
{
    if (wf_results_write(&run, f->folder.path, &f->e)) fail_msg("%s", f->e.text);
}

static bool warned(const struct fixture *f, const char *words)
{
    for (const struct wf_finding *w = f->diag.first; w; w = w->next)
        if (strstr(w->text, words)) return true;
    return false;
}

static size_t times(const char *text, const char *word)
{
    size_t n = 0;
    while ((text = strstr(text, word))) n++, text++;
    return n;
}

/* The words of the printed page, by pdftotext. */
static char *printed(struct fixture *f)
{
    char command[512];
    snprintf(command, sizeof command, "pdftotext -layout %s/report.pdf %s/report.txt", f->folder.path,
             f->folder.path);
    assert_int_equal(system(command), 0);
    return folder_read(&f->folder, "report.txt");
}

static void whole_report(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot") || skipped("weasyprint")) return;
    results(f, mock_run(2, winds, 3, &f->arena));
    if (wf_report_make(f->folder.path, NULL, &f->printer, &f->diag, &f->e)) fail_msg("%s", f->e.text);
    assert_int_equal(f->diag.warnings, 0);
    assert_false(folder_has_leftovers(&f->folder));
    char *html = folder_read(&f->folder, "report.html");
    assert_non_null(html);
    assert_int_equal(times(html, "<svg"), 4);
    assert_null(strstr(html, "currentColor"));
    assert_null(strstr(html, "href=\"report.css\""));
    assert_null(strstr(html, "NaN"));
    assert_non_null(strstr(html, "It does not break at any wind up to"));
    assert_non_null(strstr(html, "Overturning was not assessed: soil and anchorage unknown."));
    free(html);
    if (skipped("pdftotext")) return;
    char *text = printed(f);
    assert_non_null(strstr(text, "Trees in the wind: Moso bamboo, Weeping willow"));
    assert_non_null(strstr(text, "In a mean wind of 25 m/s Moso bamboo bends most"));
    assert_non_null(strstr(text, "page 1 of"));
    assert_non_null(strstr(text, "Wood Handbook. 2010"));
    free(text);
}

/* One WeasyPrint prints several pages; after one that ended another is started. */
static void one_printer(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot") || skipped("weasyprint")) return;
    results(f, mock_run(1, winds, 1, &f->arena));
    for (size_t page = 1; page <= 3; page++) {
        if (wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                           &f->e))
            fail_msg("%s", f->e.text);
        assert_int_equal(f->printer.pages, page < 3 ? page : 1);
        char *pdf = folder_read(&f->folder, "report.pdf");
        assert_non_null(pdf);
        assert_memory_equal(pdf, "%PDF", 4);
        free(pdf);
        assert_int_equal(remove(folder_file(&f->folder, "report.pdf")), 0);
        if (page == 2) assert_int_equal(kill(f->printer.running.child, SIGKILL), 0);
    }
    wf_printer_close(&f->printer);
    assert_int_equal(f->printer.pages, 0);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1); /* nothing is left */
    if (wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, NULL, &f->diag, &f->e))
        fail_msg("%s", f->e.text);
    assert_false(folder_has(&f->folder, "report.pdf"));
}

/* Fonts in a PDF have the outlines and widths of the fonts they are cut from. */
static void fonts_are_cut_down(void **state)
{
    (void)state;
    if (skipped("weasyprint")) return;
    FILE *run = popen(
        "fonts=$(find /usr/share/fonts -name 'Liberation*-Regular.ttf' -o -name wqy-microhei.ttc -o -name "
        "DejaVuSans.ttf); $(sed -n '1s/^#!//p' $(command -v weasyprint)) tests/glyphs.py reports/pdf.py "
        "$fonts 2>&1; echo $fonts | wc -w",
        "r");
    char said[2048] = "";
    size_t n = run ? fread(said, 1, sizeof said - 1, run) : 0, fonts = 0, compared = 0;
    said[n] = '\0';
    assert_int_equal(pclose(run), 0);
    if (sscanf(said, "%zu %zu", &compared, &fonts) != 2 || compared != fonts || !fonts) fail_msg("%s", said);
}

/* Chinese page, one tree, more wind speeds than are drawn. */
static void chinese(void **state)
{
    struct fixture *f = *state;
    double speed[12];
    if (skipped("gnuplot")) return;
    for (int i = 0; i < 12; i++) speed[i] = 5 + 3 * i;
    results(f, mock_run(1, speed, 12, &f->arena));
    only(f, "gnuplot");
    assert_int_equal(wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "zh" }, &f->printer,
                                    &f->diag, &f->e),
                     WF_EMISSING);
    char *html = folder_read(&f->folder, "report.html");
    assert_non_null(strstr(html, "毛竹的风荷载响应"));
    assert_non_null(strstr(html, "图中绘出 12 个风速中的 5 个"));
    assert_non_null(strstr(html, ">梢端挠度 [m]</"));
    assert_null(strstr(html, "Tip deflection"));
    free(html);
}

/* Without WeasyPrint the page is there, and the message names the package. */
static void no_weasyprint(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot")) return;
    results(f, mock_run(2, winds, 3, &f->arena));
    only(f, "gnuplot");
    assert_int_equal(wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer,
                                    &f->diag, &f->e),
                     WF_EMISSING);
    assert_string_equal(f->e.text, "weasyprint is not installed: install the package weasyprint");
    assert_true(folder_has(&f->folder, "report.html"));
    assert_false(folder_has(&f->folder, "report.pdf"));
    assert_false(folder_has_leftovers(&f->folder));
}

/* Without gnuplot the results and the page stay, and each figure's place says why it is empty. */
static void no_gnuplot(void **state)
{
    struct fixture *f = *state;
    results(f, mock_run(2, winds, 3, &f->arena));
    only(f, NULL);
    assert_int_equal(wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer,
                                    &f->diag, &f->e),
                     WF_EMISSING);
    assert_string_equal(f->e.text, "gnuplot is not installed: install the package gnuplot-nox");
    assert_true(warned(f, "install the package weasyprint"));
    assert_int_equal(f->diag.warnings, 2);
    char *html = folder_read(&f->folder, "report.html");
    assert_int_equal(times(html, "This figure could not be drawn: gnuplot is not installed"), 4);
    assert_true(folder_has(&f->folder, "results.json"));
    assert_false(folder_has(&f->folder, "plots/tip.svg"));
    assert_false(folder_has_leftovers(&f->folder));
    free(html);
}

/* Trees without answers, without strength, without any: figures are drawn and the words say so. */
static void missing_values(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot")) return;
    struct wf_run run = mock_run(3, winds, 3, &f->arena);
    struct wf_analysis *a = (struct wf_analysis *)(uintptr_t)run.analysis;
    for (size_t k = 0; k < 3; k++) {
        a[0].at[k] = (struct wf_at_speed){ .speed = winds[k], .status = WF_EUNSTABLE };
        a[1].at[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety = NAN;
    }
    for (size_t k = 1; k < MOCK_SWEEP; k++) a[0].sweep[k].status = WF_EUNSTABLE;
    for (size_t k = 0; k < MOCK_SWEEP; k++) a[1].sweep[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety = NAN;
    a[0].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical = (struct wf_critical){
        .outcome = WF_CRITICAL_UNSOLVED, .speed = NAN, .speed_low = 0.5, .speed_high = 1
    };
    a[1].breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical = (struct wf_critical){
        .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .speed_low = NAN, .speed_high = NAN
    };
    mock_settle(&a[0]);
    mock_settle(&a[1]);
    results(f, run);
    only(f, "gnuplot");
    (void)wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                         &f->e);
    assert_string_equal(f->e.text, "weasyprint is not installed: install the package weasyprint");
    char *html = folder_read(&f->folder, "report.html");
    assert_int_equal(times(html, "<svg"), 4);
    assert_non_null(strstr(html, "Moso bamboo has no result at any of the specified wind speeds."));
    assert_non_null(strstr(html, "no equilibrium was found between 0.5 and 1.0"));
    assert_non_null(strstr(html, "whether it breaks cannot be said"));
    assert_null(strstr(html, "NaN"));
    free(html);
}

/* Nobody has a strength: no curves of safety, and a caption that says so. */
static void no_strength(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot")) return;
    struct wf_run run = mock_run(1, winds, 1, &f->arena);
    struct wf_analysis *a = (struct wf_analysis *)(uintptr_t)run.analysis;
    a->at->worst[WF_BREAKAGE][WF_SCOPE_TREE].safety = NAN;
    for (size_t k = 0; k < MOCK_SWEEP; k++) a->sweep[k].worst[WF_BREAKAGE][WF_SCOPE_TREE].safety = NAN;
    a->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical = (struct wf_critical){
        .outcome = WF_CRITICAL_NO_STRENGTH, .speed = NAN, .speed_low = NAN, .speed_high = NAN
    };
    mock_settle(a);
    results(f, run);
    only(f, "gnuplot");
    (void)wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                         &f->e);
    assert_string_equal(f->e.text, "weasyprint is not installed: install the package weasyprint");
    char *html = folder_read(&f->folder, "report.html");
    assert_non_null(strstr(html, "No safety factors: no modulus of rupture is given."));
    free(html);
}

/* What is drawn of a figure of one tree: how often a word stands in it. */
static size_t drawn(struct fixture *f, struct wf_run run, const char *figure, const char *word)
{
    results(f, run);
    (void)wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                         &f->e);
    assert_string_equal(f->e.text, "weasyprint is not installed: install the package weasyprint");
    char *svg = folder_read(&f->folder, figure);
    assert_non_null(svg);
    size_t n = times(svg, word);
    free(svg);
    return n;
}

/* A run of one tree and its analysis, to be drawn without pages; false: there is no gnuplot. */
static bool to_be_drawn(struct fixture *f, size_t n, struct wf_run *run, struct wf_analysis **a)
{
    if (skipped("gnuplot")) return false;
    *run = mock_run(1, winds, n, &f->arena);
    *a = (struct wf_analysis *)(uintptr_t)run->analysis;
    only(f, "gnuplot");
    return true;
}

/* The curves of safety are interrupted where there is no equilibrium. */
static void no_equilibrium(void **state)
{
    struct fixture *f = *state;
    struct wf_run run;
    struct wf_analysis *a;
    if (!to_be_drawn(f, 3, &run, &a)) return;
    const size_t whole = drawn(f, run, "plots/safety.svg", "M");
    for (size_t k = 12; k < 15; k++) a->sweep[k].status = WF_EUNSTABLE;
    assert_int_equal(drawn(f, run, "plots/safety.svg", "M"), whole + 2); /* of the tree, of its parts */
}

/* The axis of the stress reaches the largest, which is at the top end of a segment. */
static void stress_at_a_top_end(void **state)
{
    struct fixture *f = *state;
    struct wf_run run;
    struct wf_analysis *a;
    if (!to_be_drawn(f, 1, &run, &a)) return;
    assert_int_equal(drawn(f, run, "plots/stem.svg", "1000<"), 0);
    a->at->breakage.stress1[MOCK_SEGMENTS / 2] = 1e9;
    assert_int_equal(drawn(f, run, "plots/stem.svg", "1000<"), 1);
}

/* The curves end below the wind at which the tree is lost: no circle is promised. */
static void loss_beyond_the_curves(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot")) return;
    struct wf_run run = mock_run(1, winds, 3, &f->arena);
    struct wf_analysis *a = (struct wf_analysis *)(uintptr_t)run.analysis;
    a->breaks[WF_BREAKAGE][WF_SCOPE_TREE].critical = (struct wf_critical){
        .outcome = WF_CRITICAL_FOUND, .speed = 40.26, .speed_low = 40.2, .speed_high = 40.3
    };
    mock_settle(a);
    only(f, "gnuplot");
    assert_int_equal(drawn(f, run, "report.html", "Circles: "), 1);
    a->sweep_n = 31;
    assert_int_equal(drawn(f, run, "report.html", "Circles: "), 0);
    assert_int_equal(drawn(f, run, "report.html", "The tree is lost at 40.3 m/"), 1);
}

/* Names are text, not markup, not gnuplot, not a stylesheet. */
static void hostile_names(void **state)
{
    struct fixture *f = *state;
    if (skipped("gnuplot")) return;
    struct wf_run run = mock_run(2, winds, 3, &f->arena);
    struct wf_species *sp = (struct wf_species *)(uintptr_t)run.analysis[0].species;
    sp->name = "O'Neil's <b>\"_^{x}\" `date` {9}\x01\n%d";
    run.command = "windfirm compare '</style><script>alert(1)</script>'";
    results(f, run);
    only(f, "gnuplot");
    (void)wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                         &f->e);
    assert_string_equal(f->e.text, "weasyprint is not installed: install the package weasyprint");
    char *html = folder_read(&f->folder, "report.html");
    assert_non_null(strstr(html, "O'Neil's &lt;b&gt;\"_^{x}\" `date` {9}� %d"));
    assert_null(strstr(html, "<script>alert"));
    assert_int_equal(times(html, "<script>"), 1); /* the page's own */
    free(html);
}

/* The scripts are a user's to run again, into another kind of picture. */
static void scripts_by_hand(void **state)
{
    struct fixture *f = *state;
    char command[512];
    if (skipped("gnuplot")) return;
    results(f, mock_run(2, winds, 3, &f->arena));
    only(f, "gnuplot");
    (void)wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "en" }, &f->printer, &f->diag,
                         &f->e);
    snprintf(command, sizeof command, "cd reports/plots && gnuplot -c shapes.gp %s %s/mine.pdf",
             f->folder.path, f->folder.path);
    assert_int_equal(system(command), 0);
    char *pdf = folder_read(&f->folder, "mine.pdf");
    assert_non_null(pdf);
    assert_memory_equal(pdf, "%PDF", 4);
    free(pdf);
}

static void refuse(struct fixture *f, const char *json, const char *words)
{
    FILE *out = fopen(folder_file(&f->folder, "results.json"), "w");
    assert_non_null(out);
    fputs(json, out);
    fclose(out);
    f->e = (struct wf_err){ 0 };
    assert_int_equal(wf_report_make(f->folder.path, NULL, &f->printer, &f->diag, &f->e), WF_EINPUT);
    if (!strstr(f->e.text, words)) fail_msg("%s: not said: %s", f->e.text, words);
    assert_false(folder_has(&f->folder, "report.html"));
}

static void wrong_input(void **state)
{
    struct fixture *f = *state;
    assert_int_equal(wf_report_make(f->folder.path, NULL, &f->printer, &f->diag, &f->e), WF_EINPUT);
    assert_non_null(strstr(f->e.text, "a results folder?"));
    refuse(f, "{ \"schema\": ", "results.json:1:");
    refuse(f, "{ \"schema\": 1 }", "is not a results document of windfirm");
    refuse(f, "{ \"schema\": {\"name\": \"windfirm-results\", \"version\": 9}}", "results of version 9");
    refuse(f, "{ \"schema\": {\"name\": \"windfirm-results\", \"version\": 1}}",
           "trees: at least one is needed");
    refuse(f, "{ \"schema\": {\"name\": \"windfirm-results\", \"version\": 1}, \"trees\": [{}]}",
           "tables/summary.csv");
    f->e = (struct wf_err){ 0 };
    assert_int_equal(wf_report_make(f->folder.path, &(struct wf_page_style){ .language = "fr" }, &f->printer,
                                    &f->diag, &f->e),
                     WF_EUSAGE);
    assert_non_null(strstr(f->e.text, "allowed: en, zh"));
}

/* Scripts and stylesheets that are not there, or broken, are named. */
static void wrong_assets(void **state)
{
    struct fixture *f = *state;
    char share[128];
    results(f, mock_run(1, winds, 1, &f->arena));
    setenv("WINDFIRM_SHARE", "/nowhere", 1);
    assert_int_equal(wf_report_make(f->folder.path, NULL, &f->printer, &f->diag, &f->e), WF_EINPUT);
    assert_non_null(strstr(f->e.text, "/nowhere/reports/report.css: cannot be read; set WINDFIRM_SHARE"));
    f->e = (struct wf_err){ 0 };
    snprintf(share, sizeof share, "%s", f->folder.path);
    mkdir(folder_file(&f->folder, "reports"), 0700);
    static const char *const asset[] = { "reports/report.css",  "reports/picture.js", "reports/live.js",
                                         "reports/figures.xsl", "reports/report.xsl", "reports/strings.xml" };
    for (size_t i = 0; i < 6; i++) {
        FILE *out = fopen(folder_file(&f->folder, asset[i]), "w");
        assert_non_null(out);
        fputs(i == 5 ? "<strings/>" : i > 2 ? "<no stylesheet" : "", out);
        fclose(out);
    }
    setenv("WINDFIRM_SHARE", share, 1);
    assert_int_equal(wf_report_make(f->folder.path, NULL, &f->printer, &f->diag, &f->e), WF_EINPUT);
    assert_non_null(strstr(f->e.text, ".xsl:1: "));
    assert_false(folder_has_leftovers(&f->folder));
}

#define T(name) cmocka_unit_test_setup_teardown(name, setup, teardown)

int main(void)
{
    const struct CMUnitTest tests[] = { T(whole_report),
                                        T(one_printer),
                                        T(fonts_are_cut_down),
                                        T(chinese),
                                        T(no_weasyprint),
                                        T(no_gnuplot),
                                        T(missing_values),
                                        T(no_strength),
                                        T(no_equilibrium),
                                        T(stress_at_a_top_end),
                                        T(loss_beyond_the_curves),
                                        T(hostile_names),
                                        T(scripts_by_hand),
                                        T(wrong_input),
                                        T(wrong_assets) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
