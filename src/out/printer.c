/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/printer.h"
#include "out/folder.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The Python that WeasyPrint is installed for: the one in the first line of its program, written as a path or
 * as "/usr/bin/env python3"; otherwise the python3 of PATH. */
static bool python_of(const char *program, char path[static WF_PATH_MAX])
{
    char line[WF_PATH_MAX] = "", *rest = NULL;
    FILE *f = fopen(program, "rb");
    bool script = f && fgets(line, sizeof line, f) && !strncmp(line, "#!", 2);
    if (f) fclose(f);
    const char *word = script ? strtok_r(line + 2, " \t\r\n", &rest) : NULL;
    const char *last = word ? strrchr(word, '/') : NULL;
    if (last && !strcmp(last, "/env")) {
        word = strtok_r(NULL, " \t\r\n", &rest);
        if (word && !strncmp(word, "python", 6) && !strchr(word, '/')) return wf_program_found(word, path);
    } else if (last && *word == '/' && !strncmp(last, "/python", 7) && !access(word, X_OK)) {
        snprintf(path, WF_PATH_MAX, "%s", word);
        return true;
    }
    return wf_program_found("python3", path);
}

/* Is the file a whole PDF? */
static bool whole_pdf(const char *path)
{
    char head[5] = "", tail[8] = "";
    FILE *pdf = fopen(path, "rb");
    if (!pdf) return false;
    size_t n = fread(head, 1, 4, pdf);
    head[n] = '\0';
    n = fseek(pdf, -7, SEEK_END) ? 0 : fread(tail, 1, 7, pdf);
    tail[n] = '\0';
    fclose(pdf);
    return !strcmp(head, "%PDF") && strstr(tail, "%%EOF");
}

static enum wf_status begin(struct wf_printer *p, struct wf_err *e)
{
    char driver[WF_PATH_MAX];
    p->program = (struct wf_program){ .name = "weasyprint", .package = "weasyprint" };
    enum wf_status code = wf_report_asset_anywhere("pdf.py", driver, e);
    if (code) return code;
    if (!wf_program_found(p->program.name, p->program.path) || !python_of(p->program.path, p->program.path))
        return wf_program_missing(&p->program, e);
    /* The whole path: from a bare name Python looks for its modules beside the first python3 of PATH, which
     * may be another one. -E: PYTHONPATH may name the current folder. */
    p->program.argv = (const char *const[]){ p->program.path, "-E", driver, NULL };
    code = wf_program_start(&p->program, true, &p->running, e);
    p->program.argv = NULL;
    return code;
}

static enum wf_status end(struct wf_printer *p, char said[static WF_SAID_MAX], struct wf_err *e)
{
    p->pages = 0;
    return wf_program_end(&p->program, &p->running, said, e);
}

/* Give the order to the process, which is started where none runs. Whether it was heard shows in the answer.
 */
static enum wf_status give(struct wf_printer *p, struct wf_err *e)
{
    enum wf_status code = p->pages ? WF_OK : begin(p, e);
    if (code) return code;
    p->pages++;
    (void)wf_program_tell(&p->running, p->order, p->ordered);
    return WF_OK;
}

/* Wait for the answer. A process that ends at a page has failed at it, or at the pages before: the page is
 * then given to a new one. Returned: WF_OK and what was said. */
static enum wf_status hear(struct wf_printer *p, char said[static WF_SAID_MAX], struct wf_err *e)
{
    for (;;) {
        bool first = p->pages == 1;
        said[0] = '\0';
        if (wf_program_hear(&p->running, said)) return WF_OK;
        enum wf_status code = end(p, said, first ? e : NULL);
        if (first)
            return code ? code : wf_fail(e, WF_EOUTPUT, "%s ended at a page: %s", p->program.name, said);
        if ((code = give(p, e))) return code;
    }
}

enum wf_status wf_page_take(struct wf_printer *p, struct wf_err *e)
{
    char said[WF_SAID_MAX];
    if (!p->ordered) return WF_OK;
    enum wf_status code = hear(p, said, e);
    /* WeasyPrint continues after an error */
    if (!code && strstr(said, "ERROR"))
        code = wf_fail(e, WF_EOUTPUT, "%s: WeasyPrint says: %s", p->file.path, said);
    if (!code && !whole_pdf(p->file.temporary))
        code = wf_fail(e, WF_EOUTPUT, "%s: the file is not complete (is the disk full?)", p->file.path);
    if (!code) code = wf_file_commit(&p->file, e);
    wf_file_abandon(&p->file);
    p->ordered = 0;
    return code;
}

enum wf_status wf_page_print(struct wf_printer *p, const char *folder, const char *page, struct wf_err *e)
{
    char pdf[64];
    snprintf(pdf, sizeof pdf, "%.40s.pdf", page);
    enum wf_status code = wf_page_take(p, e);
    if (!code) code = wf_folder_begin(&p->file, folder, pdf, e);
    if (code) return code;
    /* folder, page and file, each ended by a zero byte */
    int n = snprintf(p->order, sizeof p->order, "%s%c%.40s.html%c%s%c", folder, 0, page, 0,
                     p->file.temporary + strlen(folder) + 1, 0);
    if (n < 0 || (size_t)n >= sizeof p->order)
        code = wf_fail(e, WF_EOUTPUT, "%s: the name is too long", p->file.path);
    p->ordered = code ? 0 : (size_t)n;
    if (!code) code = give(p, e);
    if (!code && !p->late) return wf_page_take(p, e);
    if (code) wf_file_abandon(&p->file), p->ordered = 0;
    return code;
}

void wf_printer_close(struct wf_printer *p)
{
    char said[WF_SAID_MAX] = "";
    if (p->pages) (void)end(p, said, NULL);
    wf_file_abandon(&p->file);
    p->ordered = 0;
}
