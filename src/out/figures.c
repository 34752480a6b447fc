/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/figures.h"
#include "out/doc.h"
#include "out/program.h"
#include "out/xml.h"
#include <stdio.h>
#include <string.h>

/* Does the file end in </svg>? gnuplot leaves an empty file after an error and an incomplete one on a full
 * disk. */
static bool complete(const char *path)
{
    static const char tail[] = "</svg>";
    char last[64];
    FILE *f = fopen(path, "rb");
    if (!f) return false;
    long back = (long)sizeof last - 1;
    if (fseek(f, -back, SEEK_END)) rewind(f);
    size_t n = fread(last, 1, sizeof last - 1, f);
    fclose(f);
    last[n] = '\0';
    return strstr(last, tail) != NULL;
}

/* What gnuplot said although it drew the figure: warnings are passed on, anything else is a failure. */
static enum wf_status judge(const char *folder, const char *name, char *said, struct wf_diag *d,
                            struct wf_err *e)
{
    char *rest = NULL;
    bool warned = false;
    for (char *line = strtok_r(said, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        if (!line[strspn(line, " \t\r")]) continue;
        const char *text = strstr(line, "warning: ");
        if (!text) return wf_fail(e, WF_EOUTPUT, "%s/plots/%s: gnuplot says: %s", folder, name, line);
        if (d && !warned)
            wf_diag_warn(d, "figure-warning", "%s/plots/%s: gnuplot says: %s", folder, name,
                         text + strlen("warning: "));
        warned = true;
    }
    return WF_OK;
}

/* gnuplot, and the path of a script of reports/plots. */
static enum wf_status gnuplot(struct wf_program *p, const char *folder, const char *script,
                              char path[static WF_PATH_MAX], struct wf_err *e)
{
    char part[64];
    *p = (struct wf_program){ .name = "gnuplot", .package = "gnuplot-nox", .folder = folder };
    snprintf(part, sizeof part, "plots/%.40s.gp", script);
    enum wf_status code = wf_report_asset_anywhere(part, path, e);
    if (code) return code;
    return wf_program_found(p->name, p->path) ? WF_OK : wf_program_missing(p, e);
}

enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_diag *d, struct wf_err *e)
{
    char script[WF_PATH_MAX], number[24], said[WF_SAID_MAX];
    struct wf_program p;
    snprintf(number, sizeof number, "%zu", g->run);
    enum wf_status code = gnuplot(&p, folder, g->script, script, e);
    if (code) return code;
    /* -d: the user's own ~/.gnuplot is not read */
    p.argv = (const char *const[]){ p.name, "-d", "-c", script, ".", picture, language, number, NULL };
    code = wf_program_run(&p, said, e);
    return code ? code : judge(folder, g->name, said, d, e);
}

/* The name inside the folder of a file that wf_folder_begin began there. */
static const char *inside(const char *folder, const struct wf_file *f)
{
    return f->temporary + strlen(folder) + 1;
}

/* Draw several figures by one gnuplot. Returned: whether all of them were drawn without a word. */
static bool draw_together(const char *folder, const struct wf_figure *g, size_t n, const char *language,
                          const struct wf_file *f)
{
    char script[WF_PATH_MAX], said[WF_SAID_MAX], list[WF_FIGURES_MAX * 160] = "";
    struct wf_program p;
    size_t used = 0;
    for (size_t k = 0; k < n; k++) {
        size_t room = sizeof list - used;
        int wide = snprintf(list + used, room, "%.40s %s %zu ", g[k].script, inside(folder, &f[k]), g[k].run);
        if (wide < 0 || (size_t)wide >= room) return false;
        used += (size_t)wide;
    }
    if (gnuplot(&p, folder, "several", script, NULL)) return false;
    p.argv = (const char *const[]){ p.name, "-d", "-c", script, ".", list, language, NULL };
    if (wf_program_run(&p, said, NULL) || *said) return false;
    for (size_t k = 0; k < n; k++)
        if (!complete(f[k].temporary)) return false;
    return true;
}

/* The drawn figure gets its name and is read. */
static enum wf_status take(struct wf_file *f, const char *style, xmlDoc **svg, struct wf_err *e)
{
    xmlDoc *drawn;
    enum wf_status code =
        complete(f->temporary)
            ? WF_OK
            : wf_fail(e, WF_EOUTPUT, "%s: the figure is not complete (is the disk full?)", f->path);
    if (!code) code = wf_file_commit(f, e);
    if (code || (code = wf_xml_read(f->path, &drawn, e))) return code;
    code = wf_xml_transform(style, drawn, NULL, svg, e);
    xmlFreeDoc(drawn);
    return code;
}

void wf_figures_draw(const char *folder, const struct wf_figure *g, size_t n, const char *language,
                     xmlDoc **svg, struct wf_diag *d, struct wf_err *why)
{
    char style[WF_PATH_MAX], part[64];
    struct wf_file f[WF_FIGURES_MAX] = { 0 };
    bool begun = true;
    for (size_t k = 0; k < n; k++) {
        svg[k] = NULL, why[k] = (struct wf_err){ 0 };
        snprintf(part, sizeof part, "plots/%.40s.svg", g[k].name);
        if (!wf_report_asset("svg.xsl", style, sizeof style, &why[k]))
            (void)wf_folder_begin(&f[k], folder, part, &why[k]);
        begun = begun && !why[k].code;
    }
    /* one that makes gnuplot say something is drawn by itself, so that its words are known */
    bool drawn = begun && n > 1 && draw_together(folder, g, n, language, f);
    for (size_t k = 0; k < n; k++) {
        if (!why[k].code && !drawn)
            (void)wf_figures_run(folder, &g[k], inside(folder, &f[k]), language, d, &why[k]);
        if (!why[k].code) (void)take(&f[k], style, &svg[k], &why[k]);
        wf_file_abandon(&f[k]);
    }
}
