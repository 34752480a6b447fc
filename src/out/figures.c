/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/figures.h"
#include "base/num.h"
#include "base/said.h"
#include "out/doc.h"
#include "out/folder.h"
#include "out/page_units.h"
#include "out/program.h"
#include "out/tongue.h"
#include "out/xml.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- What the figures of a page say ---- */

void wf_figures_units(struct wf_plot_data *p, const char *units)
{
    char key[40];
    const struct wf_page_unit *u;
    for (size_t i = 0; (u = wf_page_unit_row(units, i))->from; i++) {
        (void)snprintf(key, sizeof key, "UNIT.%.24s", u->from);
        wf_plot_data_text(p, key, 0, u->to);
        (void)snprintf(key, sizeof key, "FACTOR.%.24s", u->from);
        wf_plot_data_number(p, key, 0, u->factor);
    }
}

/* Facts that are names, sentences or quantities. */
static const struct spoken {
    const char *fact;
    const char *strings; /* what a name begins with as a key of the strings; NULL: it is a text */
    const char *column;  /* metric unit of its numbers, "": it stands behind them; NULL: it has none */
} spoken[] = { { "NAME", NULL, NULL },        { "GROUP", NULL, NULL },   { "TEST", NULL, NULL },
               { "METHOD", "method.", NULL }, { "LAW", "law.", NULL },   { "MODEL", "gust.", NULL },
               { "P_VALUE", NULL, "" },       { "L_LENGTH", NULL, "m" }, { "L_DIAMETER", NULL, "mm" },
               { "LEVEL", NULL, NULL } };

/* A page's language and units. */
struct speech {
    const struct wf_tongue *tongue;
    const char *units;
};

/* The text of a quoted cell of plot data: its octal escapes are characters. */
static char *unquoted(const char *cell, struct wf_arena *a)
{
    char *text = wf_arena_text(a, cell + 1), *to = text;
    if (!text) return NULL;
    for (const char *p = text; *p && *p != '"'; p++) {
        const char digits[4] = { p[1], p[1] ? p[2] : '\0', p[1] && p[2] ? p[3] : '\0', '\0' };
        bool escape = *p == '\\' && strlen(digits) == 3 && !digits[strspn(digits, "01234567")];
        *to++ = escape ? (char)strtoul(digits, NULL, 8) : *p;
        if (escape) p += 3;
    }
    *to = '\0';
    return text;
}

/* A fact in the language and the units of a page. */
static const char *in_words(const struct speech *s, const struct spoken *of, const char *text,
                            struct wf_arena *a)
{
    const char *key = of->strings ? wf_arena_print(a, "%s%s", of->strings, text) : NULL;
    if (key) {
        const char *own = wf_tongue_text(s->tongue, key);
        return own == key ? text : own;
    }
    const char *own =
        wf_tongue_say(s->tongue, &(struct wf_said){ .message = "{1}", .n = 1, .arg = { text } }, a);
    if (own) text = own;
    if (!of->column) return text;
    const struct wf_page_unit *unit = wf_page_unit_find(s->units, of->column, strlen(of->column));
    return *of->column && !unit ? text : wf_page_units_turned(s->units, text, unit, a);
}

/* A row that is kept as it is, and below it what the page calls it. */
static void say_row(struct wf_plot_data *p, const char *row, const struct speech *s, struct wf_arena *a)
{
    const char *index = strchr(row, ','), *cell = index ? strchr(index + 1, ',') : NULL;
    fprintf(p->f.stream, "%s\n", row);
    if (!cell || cell[1] != '"') return;
    for (size_t i = 0; i < WF_COUNT(spoken); i++) {
        char key[40];
        size_t n = strlen(spoken[i].fact);
        if ((size_t)(index - row) != n || strncmp(row, spoken[i].fact, n) != 0) continue;
        char *text = unquoted(cell + 1, a);
        const char *own = text ? in_words(s, &spoken[i], text, a) : NULL;
        (void)snprintf(key, sizeof key, "SAID.%s", spoken[i].fact);
        if (own && strcmp(own, text) != 0) wf_plot_data_text(p, key, strtoul(index + 1, NULL, 10), own);
    }
}

/* Is it a row that an earlier page added? */
static bool added(const char *row)
{
    static const char *const begin[] = { "SAID.", "UNIT.", "FACTOR." };
    for (size_t i = 0; i < WF_COUNT(begin); i++)
        if (!strncmp(row, begin[i], strlen(begin[i]))) return true;
    return false;
}

enum wf_status wf_figures_say(const char *folder, const char *name, const char *units,
                              const struct wf_tongue *t, struct wf_err *e)
{
    char path[WF_PATH_MAX], part[64], *rest = NULL;
    const struct speech speech = { t, units };
    struct wf_arena a = { 0 };
    struct wf_bytes text;
    struct wf_plot_data p = { 0 };
    (void)snprintf(part, sizeof part, "plots/%.40s.csv", name);
    enum wf_status code = wf_folder_path(folder, part, path, e);
    if (code || access(path, F_OK)) return code;
    code = wf_file_read_text(path, &a, &text, e);
    if (!code) code = wf_plot_data_begin(&p, folder, name, e);
    if (!code) {
        (void)strtok_r(text.data, "\n", &rest); /* the head */
        for (char *row; (row = strtok_r(NULL, "\n", &rest));)
            if (!added(row)) say_row(&p, row, &speech, &a);
        wf_figures_units(&p, units);
        code = wf_plot_data_end(&p, e);
    }
    wf_file_abandon(&p.f);
    wf_arena_free(&a);
    return code;
}

/* ---- Drawing ---- */

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
