#include "cases/want.h"
#include "base/num.h"
#include "cases/measure.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

bool wf_place_read(struct wf_words *w, struct wf_place *p)
{
    static const char *const known[] = { "base", "tip", "node", "row", "at" };
    size_t kind;
    long long id;
    *p = (struct wf_place){ .row = -1 };
    if (!wf_words_choice(w, "place", known, WF_COUNT(known), &kind)) return false;
    p->kind =
        (enum wf_place_kind[]){ WF_PLACE_BASE, WF_PLACE_TIP, WF_PLACE_NODE, WF_PLACE_ROW, WF_PLACE_AT }[kind];
    if (p->kind == WF_PLACE_NODE || p->kind == WF_PLACE_ROW) {
        if (!wf_words_whole(w, "node or row id", 0, INT64_MAX, &id)) return false;
        p->id = id;
    }
    if (p->kind == WF_PLACE_AT) {
        if (!wf_words_number(w, "share of the length", &p->share)) return false;
        if (p->share < 0.0 || p->share > 1.0)
            return wf_words_wrong(w, w->next - 1, "a share of the length lies in 0..1, not %g", p->share);
    }
    return true;
}

static bool quantity_read(struct wf_words *w, const struct wf_quantity **q)
{
    const char *names[64];
    size_t n = 0, k;
    while (n < 64 && wf_quantities[n].name) names[n] = wf_quantities[n].name, n++;
    if (!wf_words_choice(w, "quantity", names, n, &k)) return false;
    *q = &wf_quantities[k];
    return true;
}

static bool where_read(struct wf_words *w, struct wf_want *want)
{
    long long number;
    size_t n;
    switch (want->quantity->need) {
    case WF_NEED_NOTHING:
        return true;
    case WF_NEED_PLACE:
        return wf_place_read(w, &want->at);
    case WF_NEED_NUMBER:
        if (!wf_words_whole(w, "number of the mode", 1, 1000, &number)) return false;
        want->number = (size_t)number;
        return true;
    case WF_NEED_NAME:
        if (!wf_words_peek(w)) return wf_words_wrong(w, w->n, "the name of a fitted parameter is expected");
        want->name = w->word[w->next++];
        return true;
    case WF_NEED_POINT:
        break;
    }
    want->at.kind = WF_PLACE_POINT;
    for (n = 0; n < 3; n++)
        if (!wf_words_number(w, "coordinate of the point", &want->at.point[n])) return false;
    return true;
}

static bool tolerance_read(struct wf_words *w, struct wf_want *want)
{
    size_t at = w->next;
    want->tolerance = NAN;
    if (!wf_words_skip(w, "within")) return true;
    want->absolute = wf_words_skip(w, "absolute");
    if (!wf_words_number(w, "tolerance", &want->tolerance)) return false;
    if (want->tolerance <= 0.0) return wf_words_wrong(w, w->next - 1, "a tolerance is positive");
    if (want->absolute) want->tolerance *= want->unit_factor;
    if (!want->absolute && want->tolerance > 0.5)
        return wf_words_wrong(w, at, "a relative tolerance above 0.5 proves nothing");
    return true;
}

/* A relative tolerance needs something to be relative to. */
static bool tolerance_fits(struct wf_words *w, const struct wf_want *want)
{
    double size = 0.0;
    for (int i = 0; i < 3; i++)
        if (!isnan(want->value[i])) size += fabs(want->value[i]);
    if (size > 0.0 || want->absolute) return true;
    return wf_words_wrong(w, w->n, "the wanted value is zero: say 'within absolute TOLERANCE'");
}

static bool unit_read(struct wf_words *w, struct wf_want *want)
{
    struct wf_err e = { WF_OK, "" };
    want->unit_factor = 1.0;
    if (!*want->unit) return true;
    const char *one = wf_arena_print(w->arena, "1 %s", want->unit);
    if (!one || wf_quantity_read(w->units, one, want->quantity->dimension, &want->unit_factor, &e))
        return wf_words_wrong(w, w->n, "%s", one ? e.text : "no memory");
    return true;
}

bool wf_want_read(struct wf_words *w, struct wf_want *want)
{
    static const char *const component[] = { "x", "y", "z", "norm" };
    *want = (struct wf_want){ .line = w->line, .component = 0, .value = { NAN, NAN, NAN } };
    if (!quantity_read(w, &want->quantity) || !where_read(w, want)) return false;
    size_t low = 1, at = w->next, count;
    if (want->quantity->vector) {
        want->component = -1;
        for (int k = 0; k < 4 && want->component < 0; k++)
            if (wf_words_skip(w, component[k])) want->component = k;
        if (want->component < 0) low = 3;
        if (low == 3 && !(wf_words_peek(w) && strchr("+-.0123456789", *wf_words_peek(w))))
            return wf_words_wrong(w, at, "a vector: say x, y, z or norm and one value, or three values");
    }
    if (!wf_words_quantities(w, want->quantity->dimension, low, low, low == 3, "within", want->value, &count,
                             &want->unit) ||
        !unit_read(w, want) || !tolerance_read(w, want))
        return false;
    if (low == 3 && isnan(want->value[0]) && isnan(want->value[1]) && isnan(want->value[2]))
        return wf_words_wrong(w, at, "no value is wanted");
    return tolerance_fits(w, want) && wf_words_end(w);
}

void wf_want_print(const struct wf_want *w, int component, char *buf, size_t size)
{
    static const char *const axis[] = { " x", " y", " z", " norm" };
    char at[128] = "";
    switch (w->at.kind) {
    case WF_PLACE_NONE:
        break;
    case WF_PLACE_BASE:
        (void)snprintf(at, sizeof at, " base");
        break;
    case WF_PLACE_TIP:
        (void)snprintf(at, sizeof at, " tip");
        break;
    case WF_PLACE_NODE:
        (void)snprintf(at, sizeof at, " node %lld", (long long)w->at.id);
        break;
    case WF_PLACE_ROW:
        (void)snprintf(at, sizeof at, " row %lld", (long long)w->at.id);
        break;
    case WF_PLACE_AT:
        (void)snprintf(at, sizeof at, " at %g", w->at.share);
        break;
    case WF_PLACE_POINT:
        (void)snprintf(at, sizeof at, " %g %g %g", w->at.point[0], w->at.point[1], w->at.point[2]);
    }
    if (w->name) (void)snprintf(at, sizeof at, " %s", w->name);
    if (w->number) (void)snprintf(at, sizeof at, " %zu", w->number);
    (void)snprintf(buf, size, "%s%s%s", w->quantity->name, at, w->quantity->vector ? axis[component] : "");
}
