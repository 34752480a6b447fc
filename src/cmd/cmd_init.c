/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Begin a file of one's own: a commented starter with the keys that matter most, under a name. */
#include "base/file.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "out/template.h"
#include <stdio.h>
#include <string.h>

struct init_options {
    struct wf_args args;
    const char *output;
};
#define OPTIONS struct init_options
static const struct wf_option options[] = {
    TEXT("--output", output, "FILE", NULL, "where it is written; - prints it [NAME.yaml; of template NAME]",
         .letter = "-o"),
    { 0 },
};

static const char place[] = "NAME"; /* stands for the name in the starters, models/starters */

/* The starter with the name in the place of NAME. NULL: no memory. */
static const char *named(const char *starter, const char *name, struct wf_arena *a)
{
    char *text = wf_arena_text(a, "");
    for (const char *from = starter, *at; text; from = at + strlen(place)) {
        if (!(at = strstr(from, place))) return wf_arena_print(a, "%s%s", text, from);
        text = wf_arena_print(a, "%s%.*s%s", text, (int)(at - from), from, name);
    }
    return NULL;
}

/* Before a starter the line by which editors find its schema, where that is installed. NULL: no memory. */
static const char *with_schema(const char *kind, const char *text, struct wf_arena *a)
{
    static const struct {
        const char *kind, *room;
    } rooms[] = { { "species", "species" },
                  { "model", "models" },
                  { "study", "models/studies" },
                  { "fit", "models/field" } };
    for (size_t k = 0; k < sizeof rooms / sizeof *rooms; k++) {
        if (strcmp(rooms[k].kind, kind) != 0) continue;
        const char *path = wf_arena_print(a, "%s/%s/schema.json", wf_share(), rooms[k].room);
        if (!path) return NULL;
        if (wf_file_is_there(path))
            return wf_arena_print(a, "# yaml-language-server: $schema=%s\n%s", path, text);
    }
    return text;
}

static enum wf_status write_new(const char *path, const char *text, struct wf_err *e)
{
    struct wf_file f;
    if (wf_file_is_there(path))
        return wf_fail(e, WF_EINPUT, "%s is there already; it is not overwritten: another name, or -o FILE",
                       path);
    enum wf_status s = wf_file_begin(&f, path, e);
    if (s) return s;
    fputs(text, f.stream);
    return wf_file_commit(&f, e);
}

static enum wf_status check_name(const char *name, struct wf_err *e)
{
    size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
    bool good = n && !name[n] && name[0] != '-' && n <= 64;
    return good ? WF_OK
                : wf_fail(e, WF_EUSAGE, "the name '%s' must be of at most 64 letters, digits, '_' and '-'",
                          name);
}

/* A folder of templates of pages, to change. */
static enum wf_status init_template(const char *name, const char *output, struct wf_err *e)
{
    const char *to = output && strcmp(output, "-") != 0 ? output : name;
    enum wf_status s = check_name(name, e);
    if (!s) s = wf_template_copy(to, e);
    if (!s) wf_show(stdout, "%s written: change its files, and give its name to --template\n", to);
    return s;
}

static enum wf_status init(const char *kind, const char *name, const char *output, struct wf_arena *a,
                           struct wf_err *e)
{
    const char **known;
    struct wf_bytes starter;
    static const char room[] = "models/starters";
    size_t n = wf_shipped_names(wf_share(), room, a, &known), k = 0;
    while (k < n && strcmp(known[k], kind) != 0) k++;
    if (k == n)
        return wf_fail(e, WF_EUSAGE, "there is no starter for '%s'%s", kind,
                       wf_did_you_mean_or(kind, known, n, "there are: ").text);
    enum wf_status s = check_name(name, e);
    const char *path = wf_arena_print(a, "%s/%s/%s.yaml", wf_share(), room, kind);
    if (!s) s = path ? wf_file_read_text(path, a, &starter, e) : wf_fail(e, WF_ENOMEM, "no memory");
    if (s) return s;
    const char *text = named(starter.data, name, a),
               *to = output ? output : wf_arena_print(a, "%s.yaml", name);
    if (!text || !to) return wf_fail(e, WF_ENOMEM, "no memory");
    text = with_schema(kind, text, a);
    if (!text) return wf_fail(e, WF_ENOMEM, "no memory");
    if (strcmp(to, "-") == 0) return (void)wf_show_text(stdout, text), WF_OK;
    if (!(s = write_new(to, text, e)))
        wf_show(stdout, "%s written: edit its values; its first lines say how it is used\n", to);
    return s;
}

int wf_cmd_init(int argc, char **argv)
{
    static const char about[] =
        "KIND is that of a starter: tree (a card of what is measured with a tape, for assess), species (a "
        "table of wood and crown), model (the shape of a tree), study "
        "(an analysis "
        "with its options), fit (a pulling test); or template (a folder of stylesheets, words and style of "
        "pages, for --template).\n"
        "  windfirm init tree gate\n  windfirm init model my_oak\n  windfirm init study storm -o "
        "storms/january.yaml";
    struct wf_arena arena = { 0 };
    struct init_options o;
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, options, about, 2, 2, &arena, &o.args);
    if (code < 0) {
        bool pages = !strcmp(o.args.operand[0], "template");
        enum wf_status s = pages ? init_template(o.args.operand[1], o.output, &e)
                                 : init(o.args.operand[0], o.args.operand[1], o.output, &arena, &e);
        code = s ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}
