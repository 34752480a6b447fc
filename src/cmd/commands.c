/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/commands.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/said.h"
#include "data/model.h"
#include "data/species.h"
#include "data/species_names.h"
#include "load/drag.h"
#include "out/page_units.h"
#include "out/printer.h"
#include "out/report.h"
#include "out/results.h"
#include "out/workbook.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

const struct wf_command wf_commands[] = {
    { "analyze", "SPECIES --model MODEL --wind SPEEDS [option...]",
      "What the wind does to one species on one tree model: loads, bending, stress, safety, critical wind "
      "speed.",
      wf_cmd_analyze },
    { "assess", "[CARD | TABLE] [option...]",
      "One tree as it is measured with a tape: is it safe enough in a given wind, and how sure is that?",
      wf_cmd_assess },
    { "compare", "SPECIES SPECIES... --model MODEL --wind SPEEDS [option...]",
      "The same for several species on the same tree model, side by side.", wf_cmd_compare },
    { "fit", "STUDY [--data FILE] [--free NAMES] [option...]",
      "Fit stiffness, root and other parameters to pull tests, wind and sway records, with intervals.",
      wf_cmd_fit },
    { "explain", "SPECIES --model MODEL [option...]",
      "How far each method, as printed and corrected, is from beam theory, branch by branch.",
      wf_cmd_explain },
    { "fragility", "SPECIES --model MODEL | --tree FILE [option...]",
      "How likely a tree is lost in which wind, by samples of what is not known exactly.", wf_cmd_fragility },
    { "import", "FILE... [-o FILE] [option...]",
      "Read measured trees from the files other programs write, repair them, write them in one form.",
      wf_cmd_import },
    { "init", "KIND NAME [-o FILE]",
      "Begin a tree card, a species table, a model or a study: a commented file with the keys that matter.",
      wf_cmd_init },
    { "modes", "SPECIES --model MODEL | --tree FILE [option...]",
      "Natural frequencies of a tree in still air and in wind: how it moves in each, and its damping.",
      wf_cmd_modes },
    { "papers", "NAME | FILE | list | schema [option...]",
      "The runs of a published paper, by its method as printed and corrected, with key frames on a page.",
      wf_cmd_papers },
    { "rain", "[option...]",
      "Rain on a branch with leaves: drops hit, run, merge, hang and fall, and the branch vibrates.",
      wf_cmd_rain },
    { "report", "FOLDER... [option...]",
      "Draw plots and pages again from the results.json and tables of earlier runs.", wf_cmd_report },
    { "schema", "species|model|fit|study [--json-schema]",
      "Every key of a species table, a tree model, a calibration study or a file of options, with range and "
      "default.",
      wf_cmd_schema },
    { "shelter", "--model MODEL | --tree FILE --species SPECIES [option...]",
      "The wind inside and behind a tree, and how its windward and leeward branches bend in it.",
      wf_cmd_shelter },
    { "series", "SPECIES --model MODEL [option...]",
      "A tree in a wind that changes: time series, key frames, trajectories.", wf_cmd_series },
    { "simulate-test", "STUDY [option...]",
      "Simulate the readings of a planned test, and say which sensors would determine what.",
      wf_cmd_simulate_test },
    { "species", "list | show NAME", "The species tables that are shipped, and what is in one.",
      wf_cmd_species },
    { "terrain", "[option...]",
      "Ground generated or read from a height model: exposure and speed-up of the wind at each place.",
      wf_cmd_terrain },
    { "tree", "info FILE... | draw [FILE] [option...]",
      "Size of measured trees, and what had to be repaired; a picture of a measured tree or a model.",
      wf_cmd_tree },
    { "validate", "[PATH...] [option...]", "Run validation cases and compare with their sources.",
      wf_cmd_validate },
    { "wind", "MODEL | list | rose | extremes [option...]",
      "A gusty wind by one of the gust models, compared with what was specified, written and drawn.",
      wf_cmd_wind },
    { 0 },
};

int wf_exit_code(enum wf_status s)
{
    switch (s) {
    case WF_OK:
        return 0;
    case WF_EUSAGE:
    case WF_EINPUT:
        return 2;
    default:
        return 1;
    }
}

int wf_complain(const struct wf_err *e)
{
    wf_progress_clear();
    wf_show(stderr, "windfirm: %s\n", e->text[0] ? e->text : wf_status_text(e->code));
    return wf_exit_code(e->code);
}

/* A mistake keeps the units of the file that it is about; a warning is in those of the terminal. One without
 * a translation stays in English, the word before it too. */
static void print_finding(const struct wf_finding *f)
{
    struct wf_arena a = { 0 };
    char place[512], code[80] = "", line[2048];
    struct wf_finding said = *f;
    const struct wf_said whole = { .message = "{1}", .n = 1, .arg = { f->text } };
    const char *own = wf_show_words(f->said, &a);
    if (!own) own = wf_show_words(&whole, &a);
    if (own) said.text = own;
    const char *turned = wf_show_units() && f->severity != WF_ERROR
                             ? wf_page_units_turned(wf_show_units(), said.text, NULL, &a)
                             : NULL;
    if (turned) said.text = turned;
    if (f->code) (void)snprintf(code, sizeof code, " [%s]", f->code);
    if (own && strcmp(own, f->text) != 0)
        wf_show(stderr, "%s%s%s: %s\n", wf_finding_place(f, place, sizeof place),
                f->severity == WF_ERROR ? "error" : "warning", code, said.text);
    else
        wf_show(stderr, "%s\n", wf_finding_print(&said, line, sizeof line));
    wf_arena_free(&a);
}

void wf_print_findings(const struct wf_diag *d, bool quiet)
{
    wf_progress_clear();
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->severity == WF_ERROR || !quiet) print_finding(f);
}

const char *wf_share(void)
{
    const char *named = getenv("WINDFIRM_SHARE");
    return named && *named ? named : WF_SHARE;
}

enum wf_status wf_shipped(const char *room, const char *name, struct wf_arena *a, const char **path,
                          struct wf_diag *d, struct wf_err *e)
{
    *path = name;
    const char *dot = strchr(name, '.'); /* "Acer sp.", "Qu. robur" are no files */
    bool file = strchr(name, '/') || (dot && dot[1] && dot[1] != ' ');
    if (file || wf_file_is_there(name)) return WF_OK;
    enum wf_status s = strcmp(room, "species") == 0 ? wf_species_path(wf_share(), name, &wf_laws, a, path, e)
                                                    : wf_shipped_path(wf_share(), room, name, a, path, e);
    if (!s && access(name, F_OK) == 0)
        wf_diag_warn(d, "folder-passed-over",
                     "%s is a folder here; the shipped file of that name is taken: %s", name, *path);
    return s;
}

enum wf_status wf_species_named(const char *name, struct wf_arena *a, struct wf_species *out,
                                struct wf_diag *d, struct wf_err *e)
{
    const char *path;
    enum wf_status s = wf_shipped("species", name, a, &path, d, e);
    if (!s) s = wf_species_read(path, &wf_laws, a, out, d, e);
    if (!s) wf_show_name(out->name, out->name_zh);
    return s;
}

enum wf_status wf_model_named(const char *name, struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                              struct wf_err *e)
{
    const char *path;
    enum wf_status s = wf_shipped("models", name, a, &path, d, e);
    return s ? s : wf_model_read(path, a, out, d, e);
}

bool wf_begins_with_key(const char *path, const char *key, struct wf_arena *a)
{
    struct wf_bytes text;
    struct wf_err e = { 0 };
    if (access(path, R_OK) || wf_file_read_text(path, a, &text, &e)) return false;
    for (const char *p = text.data; p && *p; p = strchr(p, '\n') ? strchr(p, '\n') + 1 : NULL)
        if (*p != '#' && *p != '\n' && *p != '\r') return strncmp(p, key, strlen(key)) == 0;
    return false;
}

const char *wf_beside(const char *file, const char *name, struct wf_arena *a)
{
    const char *slash = strrchr(file, '/');
    if (!slash || name[0] == '/') return name;
    const char *path = wf_arena_print(a, "%.*s/%s", (int)(slash - file), file, name);
    return path && wf_file_is_there(path) ? path : name;
}

static bool line_there;
static const double patience = 2; /* a run that is shorter says nothing [s] */

/* "4 s left" */
static void add_time(double left, const char *of, char *text, size_t size)
{
    size_t n = strlen(text);
    bool minutes = left >= 90, hours = left >= 5400;
    (void)snprintf(text + n, size - n, ", %.*f %s left%s", hours ? 1 : 0,
                   left / (hours     ? 3600
                           : minutes ? 60
                                     : 1),
                   hours     ? "h"
                   : minutes ? "min"
                             : "s",
                   of);
}

/* How many steps, their share, their rate, and the time for the others where it can be told. */
static void add_steps(const struct wf_stage *s, char *text, size_t size)
{
    size_t n = strlen(text);
    bool share = s->of && s->done <= s->of;
    if (share)
        n += (size_t)snprintf(text + n, size - n, ": %zu of %s%zu, %.0f %%", s->done,
                              s->about ? "about " : "", s->of, 100.0 * (double)s->done / (double)s->of);
    else if (s->done)
        n += (size_t)snprintf(text + n, size - n, ": %zu", s->done);
    if (!s->done) return;
    (void)snprintf(text + n, size - n, ", %.3g/s", (double)s->done / s->seconds);
    if (share) add_time(s->seconds * (double)(s->of - s->done) / (double)s->done, "", text, size);
}

static void show_stage(const struct wf_stage *s)
{
    char text[400] = "", item[64] = "";
    struct winsize w = { 0 };
    if (s->run < patience || !s->what[0]) return;
    if (s->items > 1) (void)snprintf(item, sizeof item, "%zu of %zu: ", s->item, s->items);
    (void)snprintf(text, sizeof text, "%s%s", item, s->what);
    add_steps(s, text, sizeof text);
    if (s->items > 1 && s->item > 1)
        add_time(s->run * (double)(s->items - s->item + 1) / (double)(s->item - 1), " for all", text,
                 sizeof text);
    size_t wide = ioctl(STDERR_FILENO, TIOCGWINSZ, &w) || !w.ws_col ? 80 : w.ws_col, n = strlen(text);
    if (n >= wide)
        for (n = wide - 1; n && ((unsigned char)text[n] & 0xc0) == 0x80;) n--;
    line_there = true;
    fputs("\r", stderr);
    wf_show(stderr, "%.*s", (int)n, text);
    fputs("\033[K", stderr);
    fflush(stderr);
}

void wf_progress_start(bool quiet)
{
    if (!quiet && isatty(STDERR_FILENO)) wf_progress_watch(show_stage);
}

void wf_progress_clear(void)
{
    if (!line_there) return;
    line_there = false;
    fputs("\r\033[K", stderr);
    fflush(stderr);
}

enum wf_status wf_results_begin(struct wf_run_folder *r, const char *folder, const char *page,
                                struct wf_err *e)
{
    wf_interrupt_catch();
    return wf_run_begin(r, folder, page, e);
}

/* A finding about the stage, as one about the folder; an error stays an error with its file. */
static void add_plain(const struct wf_run_folder *r, const struct wf_finding *f, struct wf_diag *d)
{
    char *text = wf_arena_text(d->arena, f->text), *file = f->file ? wf_arena_text(d->arena, f->file) : NULL;
    if (text) wf_run_plain(r, text);
    if (file) wf_run_plain(r, file);
    if (f->severity == WF_ERROR)
        wf_diag_error(d, file, f->line, f->column, "%s", text ? text : f->text);
    else
        wf_diag_warn(d, f->code, "%s", text ? text : f->text);
}

enum wf_status wf_results_draw(const struct wf_run_folder *r, const struct wf_pages *pages,
                               struct wf_printer *printer, struct wf_diag *d, struct wf_err *e)
{
    struct wf_diag found = { .arena = d->arena };
    wf_stage_begin(0, false, "drawing plots and pages");
    const struct wf_page_style style = {
        .language = pages->lang, .units = pages->units, .templates = pages->templates, .docx = pages->docx
    };
    enum wf_status s = wf_report_make(r->stage, &style, pages->no_pdf ? NULL : printer, &found, e);
    wf_progress_clear();
    wf_run_plain(r, e->text);
    for (const struct wf_finding *f = found.first; f; f = f->next) add_plain(r, f, d);
    return s;
}

enum wf_status wf_results_end(struct wf_run_folder *r, const struct wf_pages *pages, struct wf_arena *a,
                              bool *whole, struct wf_err *e)
{
    struct wf_diag d = { .arena = a };
    struct wf_printer printer = { 0 };
    struct wf_err why = { 0 };
    bool drawing = pages && !pages->none;
    enum wf_status drawn = WF_OK;
    enum wf_status s = wf_interrupted() ? wf_run_mark(r, "interrupted", e) : WF_OK;
    if (!s && pages && pages->xlsx) s = wf_workbook_make(r->stage, &d, e);
    if (!s && drawing) drawn = wf_results_draw(r, pages, &printer, &d, &why);
    wf_printer_close(&printer);
    wf_print_findings(&d, false);
    if (whole) *whole = drawing && !drawn;
    if (!s) s = wf_run_commit(r, e);
    wf_run_abandon(r);
    if (s || drawn == WF_OK || drawn == WF_EMISSING) return s;
    return wf_fail(e, drawn, "%s", why.text);
}

/* A word as a shell takes it: in quotes where it is empty or has characters that a shell would interpret.
 * Returned: NULL without memory. */
static const char *quoted(const char *word, struct wf_arena *a)
{
    if (*word && !word[strcspn(word, " \t\r\n'\"\\$`&*?[]{}()<>|;#~!")]) return word;
    char *text = WF_TAKE(a, 4 * strlen(word) + 3, char), *to = text;
    if (!text) return NULL;
    *to++ = '\'';
    for (; *word; word++)
        if (*word == '\'')
            to = stpcpy(to, "'\\''");
        else
            *to++ = *word;
    strcpy(to, "'");
    return text;
}

char *wf_command_line(int argc, char **argv, struct wf_arena *a)
{
    char *text = wf_arena_text(a, "windfirm");
    for (int i = 0; text && i < argc; i++) {
        const char *word = quoted(argv[i], a);
        text = word ? wf_arena_print(a, "%s %s", text, word) : NULL;
    }
    return text;
}

enum wf_status wf_pages_head(int argc, char **argv, struct wf_arena *a, struct wf_doc_head *out,
                             struct wf_err *e)
{
    char *text = wf_command_line(argc, argv, a);
    *out = (struct wf_doc_head){ .command = text, .version = WF_VERSION, .date = wf_run_date(a) };
    return text && out->date ? WF_OK : wf_fail(e, WF_ENOMEM, "no memory");
}

int wf_command_perform(int argc, char **argv, wf_perform *perform, void *work, bool quiet, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_doc_head head;
    struct wf_run_folder f = { 0 };
    struct wf_err e = { 0 };
    enum wf_status s = wf_pages_head(argc, argv, a, &head, &e);
    if (!s) s = perform(work, &head, &f, a, &d, &e);
    wf_run_abandon(&f);
    fflush(stdout);
    wf_print_findings(&d, quiet);
    return s ? wf_complain(&e) : 0;
}
