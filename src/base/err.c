/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/err.h"
#include "base/said.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum wf_status wf_fail(struct wf_err *e, enum wf_status code, const char *fmt, ...)
{
    if (!e || e->code != WF_OK) return code;
    va_list args;
    va_start(args, fmt);
    e->code = code;
    (void)vsnprintf(e->text, sizeof e->text, fmt, args);
    va_end(args);
    return code;
}

const char *wf_status_text(enum wf_status code)
{
    static const char *const words[WF_STATUS_COUNT] = {
        [WF_OK] = "ok",
        [WF_EUSAGE] = "wrong usage",
        [WF_EINPUT] = "wrong input",
        [WF_EOUTPUT] = "could not write a result",
        [WF_ENOMEM] = "out of memory",
        [WF_ENOCONV] = "no convergence",
        [WF_EUNSTABLE] = "no equilibrium",
        [WF_EMISSING] = "a program or part is not installed",
        [WF_EINTERNAL] = "internal error in windfirm",
        [WF_EINTERRUPTED] = "interrupted",
    };
    return (unsigned)code < WF_STATUS_COUNT ? words[code] : "unknown status";
}

/* Append a finding. It is counted even when there is no memory to keep its text. */
static void add_finding(struct wf_diag *d, struct wf_finding f, const char *text)
{
    *(f.severity == WF_ERROR ? &d->errors : &d->warnings) += 1;
    struct wf_finding *node = WF_TAKE(d->arena, 1, struct wf_finding);
    if (!node) return;
    f.text = wf_arena_text(d->arena, text);
    if (f.file) f.file = wf_arena_text(d->arena, f.file);
    if (f.code) f.code = wf_arena_text(d->arena, f.code);
    f.said = wf_said_copy(f.said, d->arena);
    if (!f.text) return;
    *node = f;
    if (d->last)
        d->last->next = node;
    else
        d->first = node;
    d->last = node;
}

void wf_diag_error(struct wf_diag *d, const char *file, size_t line, size_t column, const char *fmt, ...)
{
    char text[2048];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    add_finding(d, (struct wf_finding){ .severity = WF_ERROR, .file = file, .line = line, .column = column },
                text);
}

static bool known_warning(const struct wf_diag *d, const char *code, const char *text)
{
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->severity == WF_WARNING && f->code && !strcmp(f->code, code) && !strcmp(f->text, text))
            return true;
    return false;
}

void wf_diag_warn(struct wf_diag *d, const char *code, const char *fmt, ...)
{
    char text[2048];
    va_list args, again;
    struct wf_arena scratch = { 0 };
    struct wf_said said;
    struct wf_finding f = { .severity = WF_WARNING, .code = code };
    if (d->mute) return;
    va_start(args, fmt);
    va_copy(again, args);
    (void)vsnprintf(text, sizeof text, fmt, args);
    if (!known_warning(d, code, text)) {
        if (wf_said_take(&scratch, fmt, again, &said)) f.said = &said;
        add_finding(d, f, text);
    }
    va_end(again);
    va_end(args);
    wf_arena_free(&scratch);
}

void wf_diag_pass(struct wf_diag *d, const struct wf_finding *warning)
{
    struct wf_finding f = *warning;
    f.next = NULL;
    if (!known_warning(d, f.code, f.text)) add_finding(d, f, f.text);
}

static bool precedes(const struct wf_finding *a, const struct wf_finding *b)
{
    if (!a->line || !b->line) return a->line && !b->line;
    return a->line < b->line || (a->line == b->line && a->column < b->column);
}

void wf_diag_sort(struct wf_diag *d, struct wf_finding *before)
{
    struct wf_finding **start = before ? &before->next : &d->first, *rest = *start;
    *start = NULL;
    for (struct wf_finding *f = rest, *next; f; f = next) {
        struct wf_finding **at = start;
        while (*at && !precedes(f, *at)) at = &(*at)->next;
        next = f->next;
        f->next = *at;
        *at = f;
        if (!f->next) d->last = f;
    }
}

char *wf_finding_place(const struct wf_finding *f, char *buf, size_t size)
{
    char place[48] = "";
    if (f->line && f->column)
        (void)snprintf(place, sizeof place, "%zu:%zu:", f->line, f->column);
    else if (f->line)
        (void)snprintf(place, sizeof place, "%zu:", f->line);
    (void)snprintf(buf, size, "%s%s%s%s", f->file ? f->file : "", f->file ? ":" : "", place,
                   f->file || *place ? " " : "");
    return buf;
}

char *wf_finding_print(const struct wf_finding *f, char *buf, size_t size)
{
    char place[512];
    (void)snprintf(buf, size, "%s%s%s%s%s: %s", wf_finding_place(f, place, sizeof place),
                   f->severity == WF_ERROR ? "error" : "warning", f->code ? " [" : "", f->code ? f->code : "",
                   f->code ? "]" : "", f->text);
    return buf;
}
