#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include <math.h>
#include <string.h>

const char *wf_args_unit(const char *text)
{
    double value;
    while (*text == ' ') text++;
    const char *stop = wf_number_read(text, text + strlen(text), '.', &value);
    while (stop && *stop == ' ') stop++;
    return stop;
}

/* A quantity to SI; a plain number is one of `unit`. */
static enum wf_status quantity(struct wf_reading *r, const struct wf_option *o, const char *text,
                               const char *unit, double *si, struct wf_err *e)
{
    char with_unit[256];
    const char *own = wf_args_unit(text);
    if (unit && own && !*own) {
        snprintf(with_unit, sizeof with_unit, "%s %s", text, unit);
        text = with_unit;
    }
    return wf_quantity_read(r->units, text, o->dimension, si, e);
}

bool wf_args_quantity(struct wf_reading *r, const struct wf_option *o, const char *text, const char *unit,
                      double *si)
{
    struct wf_err e = { 0 };
    char low[32], high[32];
    double si_low, si_high;
    snprintf(low, sizeof low, "%.17g", o->low);
    snprintf(high, sizeof high, "%.17g", o->high);
    if (quantity(r, o, text, unit, si, &e) || quantity(r, o, low, o->unit, &si_low, &e) ||
        quantity(r, o, high, o->unit, &si_high, &e)) {
        wf_args_mistake(r, o->name, "%s", e.text);
        return false;
    }
    const double slack = 1e-12; /* of the bound itself: a bound of 0 has none */
    if (*si >= si_low - slack * fabs(si_low) && *si <= si_high + slack * fabs(si_high)) return true;
    wf_args_mistake(r, o->name, "%.100s is outside %.6g..%.6g%s%s", text, o->low, o->high, o->unit ? " " : "",
                    o->unit ? o->unit : "");
    return false;
}

static void choice(struct wf_reading *r, const struct wf_option *o, const char *text)
{
    const char *word[WF_CHOICES_MAX];
    char list[512];
    size_t n = wf_args_choices(o, word, list, sizeof list);
    for (size_t i = 0; i < n; i++)
        if (strcmp(text, word[i]) == 0) return;
    const char *near = wf_nearest(text, word, n);
    char all[768] = "";
    for (size_t i = 0, used = 0; i < n && used < sizeof all; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", word[i]);
    wf_args_mistake(r, o->name, "'%.100s' is none of %s%s%s%s", text, all, near ? "; did you mean '" : "",
                    near ? near : "", near ? "'?" : "");
}

size_t wf_args_choices(const struct wf_option *o, const char *word[static WF_CHOICES_MAX], char *list,
                       size_t size)
{
    size_t n = 0;
    char *rest = NULL;
    for (; o->word && n < WF_CHOICES_MAX && o->word(n); n++) word[n] = o->word(n);
    if (o->word) return n;
    snprintf(list, size, "%s", o->choices);
    for (char *w = strtok_r(list, "|", &rest); w && n < WF_CHOICES_MAX; w = strtok_r(NULL, "|", &rest))
        word[n++] = w;
    return n;
}

void wf_args_value(struct wf_reading *r, size_t k, const char *text)
{
    const struct wf_option *o = &r->out->option[k];
    bool adds = o->kind == WF_OPTION_TEXTS && r->out->text[k];
    r->out->text[k] = adds ? wf_arena_print(r->arena, "%s,%s", r->out->text[k], text) : text;
    if (!r->out->text[k]) wf_args_mistake(r, o->name, "out of memory");
    switch (o->kind) {
    case WF_OPTION_FLAG:
    case WF_OPTION_TEXT:
    case WF_OPTION_TEXTS:
        break;
    case WF_OPTION_CHOICE:
        choice(r, o, text);
        break;
    case WF_OPTION_NUMBER:
        wf_args_quantity(r, o, text, o->unit, &r->out->number[k]);
        break;
    case WF_OPTION_WHOLE:
        if (wf_args_quantity(r, o, text, o->unit, &r->out->number[k]) &&
            r->out->number[k] != floor(r->out->number[k]))
            wf_args_mistake(r, o->name, "%.100s is not a whole number", text);
        break;
    case WF_OPTION_SPEED:
    case WF_OPTION_SPEEDS: /* wf_args_winds reads them when the other options are known */
        break;
    }
}
