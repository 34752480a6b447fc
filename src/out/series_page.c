/* The page of runs in time: what was run, panels of key frames, courses in time, amplitudes, warnings. */
#include "out/html.h"
#include "out/series_parts.h"
#include <math.h>
#include <string.h>

static void runs(const struct wf_series_page *p, FILE *f)
{
    fputs("<h2>What was run</h2>\n<table class=\"data runs\"><caption>Deflection is that of the stem's tip "
          "from the unloaded "
          "shape.</caption><thead><tr><th>run</th><th>species, model</th><th>method</th><th "
          "class=\"r\">wind<span "
          "class=\"u\">m/s, "
          "mean</span></th><th class=\"r\">E<span class=\"u\">GPa, stem</span></th><th class=\"r\">mean<span "
          "class=\"u\">m</span></th><th class=\"r\">most"
          "<span class=\"u\">m</span></th><th class=\"r\">share<span class=\"u\">of "
          "height</span></th></tr></thead>",
          f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        double sum = 0, most = 0, n = 0, wind = 0;
        for (size_t k = 0; k < s->frames; k++) wind += s->wind[k] / (double)s->frames;
        for (size_t k = 0; k < s->frames; k++)
            if (isfinite(s->deflection[k])) sum += s->deflection[k], most = fmax(most, s->deflection[k]), n++;
        fprintf(f, "<tbody><tr><td>%zu. ", r + 1);
        wf_html_text(f, s->spec.name);
        fprintf(f, "</td><td>%s, %s</td><td>%s; %s; %s%s%s%s; profile %s</td>", s->spec.species->key,
                s->spec.model->key, s->spec.preset->name, s->spec.solver->name,
                s->spec.gust ? s->spec.gust : "steady wind", s->across ? ", 3 components" : "",
                s->spec.shelter ? "; shelter " : "", s->spec.shelter ? s->spec.shelter->name : "",
                s->an.scenario.profile);
        wf_html_number(f, "%.3g", wind), wf_html_number(f, "%.3g", s->an.tree.youngs[0] / 1e9);
        wf_html_number(f, "%.3g", sum / n), wf_html_number(f, "%.3g", most),
            wf_html_number(f, "%.3g", most / s->an.tallness);
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
        "<h2>Amplitude by level</h2>\n<table class=\"data runs\"><caption>Half of the way along the wind "
        "between the "
        "extreme "
        "places of an axis' end, mean over the axes of a level; own: against the foot of the axis; windward, "
        "leeward: axes whose end lies on that side of the "
        "stem.</caption><thead><tr><th>run</th><th>level</th>"
        "<th>axes</th><th class=\"r\">mean<span class=\"u\">m</span></th><th class=\"r\">largest<span "
        "class=\"u\">m</span></th><th class=\"r\">own"
        "<span class=\"u\">m</span></th><th class=\"r\">windward<span class=\"u\">m</span></th><th "
        "class=\"r\">leeward<span "
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
            if (k == 0) fprintf(f, "%zu. ", r + 1), wf_html_text(f, s->spec.name);
            fprintf(f, "</td><td>%zu</td><td>%zu</td>", k, l->axes);
            wf_html_number(f, "%.3g", l->swing_mean), wf_html_number(f, "%.3g", l->swing_most),
                wf_html_number(f, "%.3g", l->own_mean);
            wf_html_number(f, "%.3g", l->windward), wf_html_number(f, "%.3g", l->leeward);
            fputs("</tr>\n", f);
        }
        fputs("</tbody>", f);
    }
    fputs("</table>\n", f);
}

static void warnings(const struct wf_series_page *p, FILE *f)
{
    struct wf_arena scratch = { 0 };
    const struct wf_diag **of = WF_TAKE(&scratch, p->n, const struct wf_diag *);
    for (size_t r = 0; of && r < p->n; r++) of[r] = p->run[r].diag;
    if (of) wf_html_findings(f, of, p->n);
    wf_arena_free(&scratch);
}

static enum wf_status figures(const struct wf_series_page *p, const char *folder, FILE *f, struct wf_diag *d)
{
    enum wf_status first = WF_OK;
    bool course = false, single = false, leafy = false;
    char name[32], caption[400];
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        course = course || s->frames > 1, single = single || s->spec.keys == 1;
        leafy = leafy || (s->frames > 1 && s->leaves.n > 0);
    }
    size_t swept;
    if (single) {
        fputs("<h2>Bent shapes</h2>\n", f);
        if (wf_series_sweep(p, &swept)) {
            const struct wf_series *s = p->run[swept].series;
            snprintf(caption, sizeof caption,
                     "Deflection of the stem's tip by Young's modulus, %.60s in %.3g m/s, all else the same.",
                     s->spec.species->name, s->spec.speed);
            wf_html_figure(folder, &(struct wf_figure){ "modulus", "modulus", 0 }, caption, f, d, &first);
        }
        wf_html_figure(
            folder, &(struct wf_figure){ "frames_all", "frames", 0 },
            "The runs side by side, seen across the wind, which blows to the right. Grey: the unloaded tree. "
            "Dashed: the plumb line of its height. One scale for all, equal both ways, metres.",
            f, d, &first);
    }
    for (size_t r = 0, shown = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        if (s->spec.keys < 2) continue;
        if (!shown++) fputs("<h2>Key frames</h2>\n", f);
        snprintf(name, sizeof name, "frames_%zu", r + 1);
        snprintf(caption, sizeof caption,
                 "Run %zu, %.200s: key frames with their time and wind speed, seen across the wind, which "
                 "blows to the right; metres. Grey: the unloaded tree, dashed: its plumb line.",
                 r + 1, s->spec.name);
        wf_html_figure(folder, &(struct wf_figure){ name, "frames", r + 1 }, caption, f, d, &first);
    }
    if (course) {
        fputs("<h2>In time</h2>\n", f);
        wf_html_figure(
            folder, &(struct wf_figure){ "series", "series", 0 },
            "Wind at the reference height, and deflection of the stem's tip from the unloaded shape.", f, d,
            &first);
    }
    if (leafy)
        wf_html_figure(
            folder, &(struct wf_figure){ "leaf_angles", "leaf_angles", 0 },
            "How the first leaf of a run turns on its stalk: swing and twist in proportion to the wind "
            "(Tang and others 2012, eq 13), or turns theta about x, y and z from three noises (Zhao and "
            "Zhang 2013). A look alone: these angles enter no load.",
            f, d, &first);
    return first;
}

enum wf_status wf_series_report(const struct wf_series_page *p, const char *folder, struct wf_diag *d,
                                struct wf_err *e)
{
    char html[WF_PATH_MAX], pdf[WF_PATH_MAX];
    const struct wf_html_head head = { p->title, p->note, p->command, p->version, p->date };
    enum wf_status drawn = WF_OK;
    struct wf_file f = { 0 };
    snprintf(html, sizeof html, "%.4000s/series.html", folder);
    snprintf(pdf, sizeof pdf, "%.4000s/series.pdf", folder);
    enum wf_status status = wf_html_begin(&f, html, &head, e);
    if (!status) {
        runs(p, f.stream);
        drawn = figures(p, folder, f.stream, d);
        levels(p, f.stream);
        for (size_t i = 0; i < p->explained; i++)
            wf_explain_section(&p->explain[i], folder, f.stream, d, &drawn);
        warnings(p, f.stream);
        status = wf_html_end(&f, e);
    }
    wf_file_abandon(&f);
    if (status) return status;
    status = wf_html_print(html, pdf, d);
    return drawn ? drawn : status;
}
