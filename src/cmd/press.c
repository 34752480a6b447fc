/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/press.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "out/workbook.h"
#include <stdint.h>

void wf_press_open(struct wf_press *p, size_t threads)
{
    size_t n = wf_parallel_threads(threads);
    *p = (struct wf_press){ .places = n < WF_PRESS_MAX ? n : WF_PRESS_MAX, .failed = SIZE_MAX };
    for (size_t i = 0; i < p->places; i++) p->place[i].printer.late = true;
}

/* The page of a place is there: put its folder in place. */
static enum wf_status take(struct wf_press *p, struct wf_press_place *x, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err pdf = { 0 };
    if (!x->taken) return WF_OK;
    if (wf_page_take(&x->printer, &pdf)) {
        wf_run_plain(&x->run, pdf.text);
        wf_diag_warn(&d, "no-pdf", "%s", pdf.text);
        if (!x->drawn) x->drawn = pdf.code, x->why = pdf;
    }
    wf_print_findings(&d, false);
    enum wf_status s = wf_run_commit(&x->run, e);
    wf_run_abandon(&x->run);
    wf_arena_free(&a);
    x->taken = false;
    if (!s && x->drawn && x->drawn != WF_EMISSING) s = wf_fail(e, x->drawn, "%s", x->why.text);
    if (s && x->number < p->failed) p->failed = x->number;
    return s;
}

enum wf_status wf_press_put(struct wf_press *p, struct wf_run_folder *r, size_t number,
                            const struct wf_pages *pages, struct wf_arena *a, struct wf_err *e)
{
    struct wf_press_place *x = &p->place[p->next++ % p->places];
    struct wf_diag d = { .arena = a };
    enum wf_status s = take(p, x, e);
    x->run = *r, x->taken = true, x->number = number;
    x->drawn = WF_OK, x->why = (struct wf_err){ 0 };
    *r = (struct wf_run_folder){ 0 };
    if (!s && wf_interrupted()) s = wf_run_mark(&x->run, "interrupted", e);
    if (!s && pages->xlsx) s = wf_workbook_make(x->run.stage, &d, e);
    if (!s && !pages->none) x->drawn = wf_results_draw(&x->run, pages, &x->printer, &d, &x->why);
    wf_print_findings(&d, false);
    if (!s) return WF_OK;
    wf_run_abandon(&x->run);
    x->taken = false;
    if (number < p->failed) p->failed = number;
    return s;
}

size_t wf_press_placed(const struct wf_press *p, size_t end)
{
    for (size_t k = 0; k < p->places; k++)
        if (p->place[k].taken && p->place[k].number < end) end = p->place[k].number;
    return p->failed < end ? p->failed : end;
}

enum wf_status wf_press_drain(struct wf_press *p, struct wf_err *e)
{
    enum wf_status first = WF_OK;
    for (size_t k = 0; k < p->places; k++) {
        enum wf_status s = take(p, &p->place[(p->next + k) % p->places], first ? &(struct wf_err){ 0 } : e);
        if (!first) first = s;
    }
    return first;
}

void wf_press_close(struct wf_press *p)
{
    for (size_t k = 0; k < p->places; k++) {
        wf_printer_close(&p->place[k].printer);
        if (p->place[k].taken) wf_run_abandon(&p->place[k].run);
    }
}
