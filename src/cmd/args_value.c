#include "base/near.h"
#include "base/number.h"
#include "cmd/args.h"
#include "cmd/wind_speed.h"
#include "wind/scale.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Behind the number at the start of `text`, blanks skipped: its unit, "" for none. NULL: no number there. */
static const char *unit_of(const char *text)
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
    const char *own = unit_of(text);
    if (unit && own && !*own) {
        snprintf(with_unit, sizeof with_unit, "%s %s", text, unit);
        text = with_unit;
    }
    return wf_quantity_read(r->units, text, o->dimension, si, e);
}

/* Read one number and hold it against the row's bounds, which are in the row's own unit. */
static bool number(struct wf_reading *r, const struct wf_option *o, const char *text, const char *unit,
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
    double slack = 1e-12 * fmax(fabs(si_low), fabs(si_high));
    if (*si >= si_low - slack && *si <= si_high + slack) return true;
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
    fprintf(stderr, "windfirm %s: %s: '%.100s' is none of ", r->command, o->name, text);
    for (size_t i = 0; i < n; i++) fprintf(stderr, "%s%s", i ? ", " : "", word[i]);
    fprintf(stderr, "%s%s%s\n", near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
    r->mistakes++;
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

enum { SPEEDS_MAX = 1000 };

/* "5:40:1": from, to, step. */
static void range(struct wf_reading *r, const struct wf_option *o, char *text, const char *unit,
                  double *speed, size_t *n)
{
    char *colon = strchr(text, ':'), *second = strchr(colon + 1, ':');
    struct wf_option step = *o;
    double from, to, by;
    if (!second || strchr(second + 1, ':')) {
        wf_args_mistake(r, o->name, "'%.100s': a range is written from:to:step, for example 5:40:1", text);
        return;
    }
    *colon = *second = '\0';
    step.low = 1e-3;
    if (!number(r, o, text, unit, &from) || !number(r, o, colon + 1, unit, &to) ||
        !number(r, &step, second + 1, unit, &by))
        return;
    double count = floor((to - from) / by * (1 + 1e-12) + 1e-9) + 1.0;
    if (from > to)
        wf_args_mistake(r, o->name, "a range runs from the lower to the higher speed");
    else if (count > (double)(SPEEDS_MAX - *n))
        wf_args_mistake(r, o->name, "more than %d wind speeds", SPEEDS_MAX);
    else
        for (size_t k = 0; k < (size_t)count; k++) speed[(*n)++] = from + by * (double)k;
}

/* The unit behind the last number holds for every plain number of the list: "5:40:5 km/h", "20,40 km/h".
 * A unit further left only would leave the numbers after it in doubt. Returned: false when in doubt. */
static bool shared_unit(const struct wf_option *o, const char *text, const char **unit)
{
    bool earlier = false;
    *unit = o->unit;
    for (const char *p = text;; p++) {
        const char *own = unit_of(p), *next = strpbrk(p, ",:");
        if (!next) {
            if (own && *own) *unit = own;
            return !(earlier && own && !*own);
        }
        earlier = earlier || (own && own < next);
        p = next;
    }
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* "beaufort:8", "cma:typhoon": what it is taken as is said on stderr. */
static void grade(struct wf_reading *r, const struct wf_option *o, const char *text, double *speed)
{
    struct wf_err e = { 0 };
    if (wf_wind_speed_read(text, "in-land", stderr, speed, &e)) wf_args_mistake(r, o->name, "%s", e.text);
}

static void speeds(struct wf_reading *r, const struct wf_option *o, const char *text)
{
    char *rest = NULL, *list = wf_arena_text(r->arena, text);
    double *speed = WF_TAKE(r->arena, SPEEDS_MAX + 1, double);
    const char *unit;
    size_t n = 0, before = r->mistakes;
    if (!list || !speed) {
        wf_args_mistake(r, o->name, "out of memory");
        return;
    }
    if (!shared_unit(o, text, &unit)) {
        wf_args_mistake(r, o->name, "'%.100s': write the unit behind the last number; it then holds for all",
                        text);
        return;
    }
    for (char *item = strtok_r(list, ",", &rest); item && n <= SPEEDS_MAX;
         item = strtok_r(NULL, ",", &rest)) {
        if (wf_wind_scale_is(item))
            grade(r, o, item, &speed[n++]);
        else if (strchr(item, ':'))
            range(r, o, item, unit, speed, &n);
        else if (number(r, o, item, unit, &speed[n]))
            n++;
    }
    if (n > SPEEDS_MAX) wf_args_mistake(r, o->name, "more than %d wind speeds", SPEEDS_MAX);
    if (n == 0 && r->mistakes == before) wf_args_mistake(r, o->name, "no wind speed is given");
    qsort(speed, n, sizeof *speed, ascending);
    r->out->speed = speed;
    r->out->speeds = 0;
    for (size_t k = 0; k < n; k++) /* the same speed twice is one */
        if (r->out->speeds == 0 || speed[k] > speed[r->out->speeds - 1] + 1e-9)
            speed[r->out->speeds++] = speed[k];
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
        number(r, o, text, o->unit, &r->out->number[k]);
        break;
    case WF_OPTION_SPEEDS:
        speeds(r, o, text);
        break;
    }
}
