/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/figures.h"
#include "out/folder.h"
#include "out/program.h"
#include "out/xml.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum wf_status wf_report_asset(const char *name, char *path, size_t size, struct wf_err *e)
{
    const char *share = getenv("WINDFIRM_SHARE");
    int n = snprintf(path, size, "%s/reports/%s", share && *share ? share : WF_SHARE, name);
    if (n < 0 || (size_t)n >= size) return wf_fail(e, WF_EINPUT, "WINDFIRM_SHARE: the name is too long");
    if (!access(path, R_OK)) return WF_OK;
    return wf_fail(e, WF_EINPUT,
                   "%s: cannot be read; set WINDFIRM_SHARE to the folder that holds windfirm's reports/",
                   path);
}

/* Does the file end in </svg>? gnuplot leaves an empty file after a fault and half a one on a full disk. */
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

/* gnuplot takes names that begin with '<' or '|' for commands. */
static const char *plain_name(const char *path, char room[static WF_PATH_MAX])
{
    if (path[0] == '/' || path[0] == '.') return path;
    int n = snprintf(room, WF_PATH_MAX, "./%s", path);
    return n < WF_PATH_MAX ? room : path;
}

enum wf_status wf_figures_run(const char *folder, const struct wf_figure *g, const char *picture,
                              const char *language, struct wf_err *e)
{
    char script[WF_PATH_MAX], part[64], from[WF_PATH_MAX], to[WF_PATH_MAX], run[24], said[WF_SAID_MAX];
    snprintf(part, sizeof part, "plots/%.40s.gp", g->script);
    snprintf(run, sizeof run, "%zu", g->run);
    enum wf_status code = wf_report_asset(part, script, sizeof script, e);
    if (code) return code;
    const char *const argv[] = { "gnuplot", "-c", script, plain_name(folder, from), plain_name(picture, to),
                                 language,  run,  NULL };
    code = wf_program_run(argv, "gnuplot-nox", said, e);
    if (!code && *said) code = wf_fail(e, WF_EOUTPUT, "%s/plots/%s: gnuplot says: %s", folder, g->name, said);
    return code;
}

enum wf_status wf_figures_draw(const char *folder, const struct wf_figure *g, const char *language,
                               xmlDoc **svg, struct wf_err *e)
{
    char style[WF_PATH_MAX], part[64];
    struct wf_file f = { 0 };
    xmlDoc *drawn;
    *svg = NULL;
    enum wf_status code = wf_report_asset("svg.xsl", style, sizeof style, e);
    snprintf(part, sizeof part, "plots/%.40s.svg", g->name);
    if (!code) code = wf_folder_begin(&f, folder, part, e);
    if (code) return code;
    code = wf_figures_run(folder, g, f.temporary, language, e);
    if (!code && !complete(f.temporary))
        code = wf_fail(e, WF_EOUTPUT, "%s: the figure is not complete (is the disk full?)", f.path);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (code || (code = wf_xml_read(f.path, &drawn, e))) return code;
    code = wf_xml_transform(style, drawn, NULL, NULL, svg, e);
    xmlFreeDoc(drawn);
    return code;
}
