#include "out/figures.h"
#include "base/file.h"
#include "out/program.h"
#include "out/xml.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *const wf_figures[] = { "shapes", "tip", "safety", "stem", NULL };

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

static enum wf_status begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    int n = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (n < 0 || (size_t)n >= sizeof path)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    return wf_file_begin(f, path, e);
}

enum wf_status wf_figures_prepare(const char *folder, xmlDoc *report, struct wf_err *e)
{
    char style[WF_PATH_MAX], plots[WF_PATH_MAX];
    struct wf_file f = { 0 };
    xmlDoc *result;
    int n = snprintf(plots, sizeof plots, "%s/plots", folder);
    if (n < 0 || (size_t)n >= sizeof plots)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    enum wf_status code = wf_mkdirs(plots, e);
    if (!code) code = wf_report_asset("figures.xsl", style, sizeof style, e);
    if (!code) code = begin(&f, folder, "plots/run.gp", e);
    if (code) return code;
    code = wf_xml_transform(style, report, NULL, f.stream, &result, e);
    if (!code) {
        xmlFreeDoc(result);
        code = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    return code;
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

static enum wf_status plot(const char *script, const char *folder, const struct wf_file *f, struct wf_err *e)
{
    char said[WF_SAID_MAX];
    const char *const argv[] = { "gnuplot", "-c", script, folder, f->temporary, NULL };
    enum wf_status code = wf_program_run(argv, "gnuplot-nox", said, e);
    if (code) return code;
    if (*said) return wf_fail(e, WF_EOUTPUT, "%s: gnuplot says: %s", f->path, said);
    if (!complete(f->temporary))
        return wf_fail(e, WF_EOUTPUT, "%s: the figure is not complete (is the disk full?)", f->path);
    return WF_OK;
}

enum wf_status wf_figures_draw(const char *folder, const char *name, xmlDoc **svg, struct wf_err *e)
{
    char script[WF_PATH_MAX], style[WF_PATH_MAX], part[64];
    struct wf_file f = { 0 };
    xmlDoc *drawn;
    *svg = NULL;
    snprintf(part, sizeof part, "plots/%s.gp", name);
    enum wf_status code = wf_report_asset(part, script, sizeof script, e);
    if (!code) code = wf_report_asset("svg.xsl", style, sizeof style, e);
    snprintf(part, sizeof part, "plots/%s.svg", name);
    if (!code) code = begin(&f, folder, part, e);
    if (code) return code;
    code = plot(script, folder, &f, e);
    if (!code) code = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (code || (code = wf_xml_read(f.path, &drawn, e))) return code;
    code = wf_xml_transform(style, drawn, NULL, NULL, svg, e);
    xmlFreeDoc(drawn);
    return code;
}
