/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/folder.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum wf_status wf_folder_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e)
{
    int n = snprintf(path, WF_PATH_MAX, "%s/%s", folder, name);
    if (n >= 0 && n < WF_PATH_MAX) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
}

enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    enum wf_status s = wf_folder_path(folder, name, path, e);
    return s ? s : wf_file_begin(f, path, e);
}

enum wf_status wf_folder_make(const char *folder, struct wf_err *e)
{
    static const char *const sub[] = { "tables", "plots" };
    enum wf_status s = WF_OK;
    for (int i = 0; i < 2 && !s; i++) {
        char path[WF_PATH_MAX];
        s = wf_folder_path(folder, sub[i], path, e);
        if (!s) s = wf_mkdirs(path, e);
    }
    return s;
}

enum { TEXT_MAX = 1024 }; /* a title or a label; longer ones are cut [bytes] */

enum wf_status wf_plot_data_begin(struct wf_plot_data *p, const char *folder, const char *name,
                                  struct wf_err *e)
{
    char file[64];
    snprintf(file, sizeof file, "plots/%.40s.csv", name);
    *p = (struct wf_plot_data){ 0 };
    enum wf_status s = wf_folder_begin(&p->f, folder, file, e);
    if (!s) fputs("key,index,value\n", p->f.stream);
    return s;
}

void wf_plot_data_number(struct wf_plot_data *p, const char *key, size_t index, double x)
{
    char text[40];
    snprintf(text, sizeof text, "%.15g", x);
    char *e = strchr(text, 'e');
    if (!isfinite(x))
        fprintf(p->f.stream, "%s,%zu,NaN\n", key, index);
    else if (e && !strchr(text, '.')) /* gnuplot reads 1e-5 in a text as a whole number with a tail */
        fprintf(p->f.stream, "%s,%zu,%.*s.0%s\n", key, index, (int)(e - text), text, e);
    else
        fprintf(p->f.stream, "%s,%zu,%s\n", key, index, text);
}

void wf_plot_data_count(struct wf_plot_data *p, const char *key, size_t index, size_t n)
{
    fprintf(p->f.stream, "%s,%zu,%zu\n", key, index, n);
}

void wf_plot_data_text(struct wf_plot_data *p, const char *key, size_t index, const char *text)
{
    FILE *f = p->f.stream;
    fprintf(f, "%s,%zu,\"", key, index);
    for (const char *c = text ? text : ""; *c; c++)
        if (*c == '"' || *c == ',' || *c == '\\')
            fprintf(f, "\\%03o", (unsigned)*c);
        else
            fputc((unsigned char)*c < 0x20 ? ' ' : *c, f);
    fputs("\"\n", f);
}

/* Cut behind a whole character. */
static void cut(char *text)
{
    size_t n = strlen(text);
    if (n < TEXT_MAX - 1) return;
    while (n > 0 && ((unsigned char)text[n - 1] & 0xc0) == 0x80) n--;
    if (n > 0 && (unsigned char)text[n - 1] >= 0xc0) n--;
    text[n] = '\0';
}

void wf_plot_data_print(struct wf_plot_data *p, const char *key, size_t index, const char *fmt, ...)
{
    char text[TEXT_MAX];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    cut(text);
    wf_plot_data_text(p, key, index, text);
}

enum wf_status wf_plot_data_parse(struct wf_plot_data *p, const char *key, size_t index, const char *text,
                                  struct wf_err *e)
{
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end) return wf_fail(e, WF_EINPUT, "%s: '%.100s' is not a number", key, text);
    wf_plot_data_number(p, key, index, x);
    return WF_OK;
}

enum wf_status wf_plot_data_end(struct wf_plot_data *p, struct wf_err *e) { return wf_file_commit(&p->f, e); }
