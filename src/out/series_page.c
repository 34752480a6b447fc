/* The page of runs in time: what was run, panels of key frames, courses in time, amplitudes, warnings. */
#include "base/file.h"
#include "out/figures.h"
#include "out/program.h"
#include "out/series.h"
#include <libxml/tree.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

static void words(FILE *f, const char *text)
{
    for (; text && *text; text++) switch (*text) {
        case '<':
            fputs("&lt;", f);
            break;
        case '>':
            fputs("&gt;", f);
            break;
        case '&':
            fputs("&amp;", f);
            break;
        default:
            fputc(*text, f);
        }
}

static void cell(FILE *f, const char *format, double x)
{
    fputs("<td class=\"r\">", f);
    if (isfinite(x))
        fprintf(f, format, x);
    else
        fputs("-", f);
    fputs("</td>", f);
}

static void runs(const struct wf_series_page *p, FILE *f)
{
    fputs(
        "<table class=\"data\"><caption>What was run. Deflection is that of the stem's tip from the unloaded "
        "shape.</caption><thead><tr><th>run</th><th>species, model</th><th>method</th><th>wind<span "
        "class=\"u\">m/s, "
        "mean</span></th><th>E<span class=\"u\">GPa, stem</span></th><th>mean<span "
        "class=\"u\">m</span></th><th>most"
        "<span class=\"u\">m</span></th><th>share<span class=\"u\">of height</span></th></tr></thead>",
        f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        double sum = 0, most = 0, n = 0, wind = 0;
        for (size_t k = 0; k < s->frames; k++) wind += s->wind[k] / (double)s->frames;
        for (size_t k = 0; k < s->frames; k++)
            if (isfinite(s->deflection[k])) sum += s->deflection[k], most = fmax(most, s->deflection[k]), n++;
        fprintf(f, "<tbody><tr><td>%zu. ", r + 1);
        words(f, s->spec.name);
        fprintf(f, "</td><td>%s, %s</td><td>%s; %s; %s%s%s%s; profile %s</td>", s->spec.species->key,
                s->spec.model->key, s->spec.preset->name, s->spec.solver->name,
                s->spec.gust ? s->spec.gust : "steady wind", s->across ? ", 3 components" : "",
                s->spec.shelter ? "; shelter " : "", s->spec.shelter ? s->spec.shelter->name : "",
                s->an.scenario.profile);
        cell(f, "%.3g", wind), cell(f, "%.3g", s->an.tree.youngs[0] / 1e9);
        cell(f, "%.3g", sum / n), cell(f, "%.3g", most), cell(f, "%.3g", most / s->an.tallness);
        fputs("</tr></tbody>\n", f);
    }
    fputs("</table>\n", f);
}

static void levels(const struct wf_series_page *p, FILE *f)
{
    bool any = false;
    for (size_t r = 0; r < p->n; r++) any = any || p->run[r].series->frames > 1;
    if (!any) return;
    fputs(
        "<table class=\"data\"><caption>Amplitude by level: half of the way along the wind between the "
        "extreme "
        "places of an axis' end, mean over the axes of a level; own: against the foot of the axis; windward, "
        "leeward: axes whose end lies on that side of the "
        "stem.</caption><thead><tr><th>run</th><th>level</th>"
        "<th>axes</th><th>mean<span class=\"u\">m</span></th><th>largest<span "
        "class=\"u\">m</span></th><th>own"
        "<span class=\"u\">m</span></th><th>windward<span class=\"u\">m</span></th><th>leeward<span "
        "class=\"u\">m"
        "</span></th></tr></thead>",
        f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        if (s->frames < 2) continue;
        fputs("<tbody>", f);
        for (size_t k = 0; k < s->levels; k++) {
            const struct wf_series_level *l = &s->level[k];
            fputs("<tr><td>", f);
            if (k == 0) fprintf(f, "%zu. ", r + 1), words(f, s->spec.name);
            fprintf(f, "</td><td>%zu</td><td>%zu</td>", k, l->axes);
            cell(f, "%.3g", l->swing_mean), cell(f, "%.3g", l->swing_most), cell(f, "%.3g", l->own_mean);
            cell(f, "%.3g", l->windward), cell(f, "%.3g", l->leeward);
            fputs("</tr>\n", f);
        }
        fputs("</tbody>", f);
    }
    fputs("</table>\n", f);
}

static bool said_before(const struct wf_series_page *p, size_t run, const struct wf_finding *w)
{
    for (size_t r = 0; r < run; r++)
        for (const struct wf_finding *v = p->run[r].diag->first; v; v = v->next)
            if (!strcmp(v->text, w->text)) return true;
    return false;
}

static void warnings(const struct wf_series_page *p, FILE *f)
{
    fputs("<h2>Where these answers leave physics</h2>\n<dl>", f);
    for (size_t r = 0; r < p->n; r++)
        for (const struct wf_finding *w = p->run[r].diag->first; w; w = w->next) {
            if (said_before(p, r, w)) continue;
            fprintf(f, "<dt>%s</dt><dd>", w->code ? w->code : "");
            words(f, w->text);
            fputs("</dd>\n", f);
        }
    fputs("</dl>\n", f);
}

static enum wf_status hang(FILE *f, xmlDoc *svg, struct wf_err *e)
{
    xmlBuffer *b = xmlBufferCreate();
    int size = b ? xmlNodeDump(b, svg, xmlDocGetRootElement(svg), 0, 0) : -1;
    if (size > 0) fwrite(xmlBufferContent(b), 1, (size_t)size, f);
    if (b) xmlBufferFree(b);
    return size > 0 ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory for a figure");
}

/* Which run's key frames plots/frames.gp draws next; 0: the first key frame of every run. */
static enum wf_status choose(const char *folder, const struct wf_series_page *p, size_t shown,
                             struct wf_err *e)
{
    char path[WF_PATH_MAX];
    struct wf_file f = { 0 };
    struct wf_arena scratch = { 0 };
    struct wf_bytes facts = { 0 };
    snprintf(path, sizeof path, "%.4000s/plots/run.gp", folder);
    enum wf_status status = wf_file_read(path, &scratch, &facts, e);
    if (!status) status = wf_file_begin(&f, path, e);
    if (!status) {
        char *old = strstr(facts.data, "SHOWN = ");
        fwrite(facts.data, 1, old ? (size_t)(old - facts.data) : facts.size, f.stream);
        fprintf(f.stream, "SHOWN = %zu\n", shown);
        status = wf_file_commit(&f, e);
    }
    (void)p;
    wf_arena_free(&scratch);
    return status;
}

static enum wf_status figure(const char *folder, const char *script, const char *name, const char *caption,
                             FILE *f, struct wf_err *e)
{
    xmlDoc *svg = NULL;
    char from[WF_PATH_MAX], to[WF_PATH_MAX];
    enum wf_status status = wf_figures_draw(folder, script, &svg, e);
    if (status) return status;
    snprintf(from, sizeof from, "%.4000s/plots/%s.svg", folder, script);
    snprintf(to, sizeof to, "%.4000s/plots/%s.svg", folder, name);
    if (strcmp(from, to) != 0 && rename(from, to))
        status = wf_fail(e, WF_EOUTPUT, "%s: cannot be renamed", from);
    fputs("<figure>", f);
    if (!status) status = hang(f, svg, e);
    fputs("<figcaption>", f);
    words(f, caption);
    fputs("</figcaption></figure>\n", f);
    xmlFreeDoc(svg);
    return status;
}

/* A figure that cannot be made is a warning; the page says so in its place. */
static void figure_or_word(const char *folder, const char *script, const char *name, const char *caption,
                           FILE *f, struct wf_diag *d, enum wf_status *first)
{
    struct wf_err why = { 0 };
    enum wf_status status = figure(folder, script, name, caption, f, &why);
    if (!status) return;
    if (!*first) *first = status;
    wf_diag_warn(d, "no-figure", "%s", why.text);
    fputs("<p class=\"missing\">", f);
    words(f, why.text);
    fputs("</p>\n", f);
}

static enum wf_status figures(const struct wf_series_page *p, const char *folder, FILE *f, struct wf_diag *d,
                              struct wf_err *e)
{
    enum wf_status first = WF_OK;
    bool course = false, single = false;
    char name[32], caption[400];
    for (size_t r = 0; r < p->n; r++)
        course = course || p->run[r].series->frames > 1, single = single || p->run[r].series->spec.keys == 1;
    if (single && !choose(folder, p, 0, e))
        figure_or_word(
            folder, "frames", "frames_all",
            "The runs side by side, seen across the wind, which blows to the right. Grey: the unloaded tree. "
            "Dashed: the plumb line of its height. One scale for all, equal both ways, metres.",
            f, d, &first);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        if (s->spec.keys < 2 || choose(folder, p, r + 1, e)) continue;
        snprintf(name, sizeof name, "frames_%zu", r + 1);
        snprintf(caption, sizeof caption,
                 "Run %zu, %.200s: key frames with their time and wind speed, seen across the wind, which "
                 "blows to the "
                 "right; metres. Grey: the unloaded tree.",
                 r + 1, s->spec.name);
        figure_or_word(folder, "frames", name, caption, f, d, &first);
    }
    if (course)
        figure_or_word(folder, "series", "series",
                       "Wind at the reference height, and deflection of the stem's tip.", f, d, &first);
    return first;
}

static enum wf_status write_page(const struct wf_series_page *p, const char *folder, const char *path,
                                 struct wf_diag *d, enum wf_status *drawn, struct wf_err *e)
{
    char style[WF_PATH_MAX];
    struct wf_file f = { 0 };
    struct wf_arena scratch = { 0 };
    struct wf_bytes css = { 0 };
    enum wf_status status = wf_report_asset("report.css", style, sizeof style, e);
    if (!status) status = wf_file_read_text(style, &scratch, &css, e);
    if (!status) status = wf_file_begin(&f, path, e);
    if (!status) {
        fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>", f.stream);
        words(f.stream, p->title);
        fprintf(f.stream, "</title><style>%s</style></head><body>\n<h1>", css.data);
        words(f.stream, p->title);
        fputs("</h1>\n<p class=\"sub\"><span class=\"program\">windfirm ", f.stream);
        words(f.stream, p->version), fputs("</span>, ", f.stream), words(f.stream, p->date);
        fputs("</p>\n<p class=\"note\"><code>", f.stream), words(f.stream, p->command);
        fputs("</code></p>\n", f.stream);
        if (p->note)
            fputs("<div class=\"summary\"><p>", f.stream), words(f.stream, p->note),
                fputs("</p></div>\n", f.stream);
        runs(p, f.stream);
        *drawn = figures(p, folder, f.stream, d, e);
        levels(p, f.stream);
        warnings(p, f.stream);
        fputs("</body></html>\n", f.stream);
        status = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    wf_arena_free(&scratch);
    return status;
}

static enum wf_status print_page(const char *html, const char *folder, struct wf_err *e)
{
    char path[WF_PATH_MAX], said[WF_SAID_MAX];
    struct wf_file f = { 0 };
    snprintf(path, sizeof path, "%.4000s/series.pdf", folder);
    enum wf_status status = wf_file_begin(&f, path, e);
    if (status) return status;
    const char *const argv[] = { "weasyprint", "-q", html, f.temporary, NULL };
    status = wf_program_run(argv, "weasyprint", said, e);
    if (!status) status = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return status;
}

enum wf_status wf_series_report(const struct wf_series_page *p, const char *folder, struct wf_diag *d,
                                struct wf_err *e)
{
    char html[WF_PATH_MAX];
    enum wf_status drawn = WF_OK;
    struct wf_err why = { 0 };
    snprintf(html, sizeof html, "%.4000s/series.html", folder);
    enum wf_status status = write_page(p, folder, html, d, &drawn, e);
    if (status) return status;
    status = print_page(html, folder, &why);
    if (status) wf_diag_warn(d, "no-pdf", "%s", why.text);
    return drawn ? drawn : status;
}
