#include "cmd/wind_speed.h"
#include "base/num.h"
#include "wind/scale.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { SPEEDS_MAX = 1000 };

const char *wf_averaging_word(size_t i) { return wf_averaging_laws[i].name; }

/* The winds of one option. */
struct winds {
    struct wf_reading *r;
    const struct wf_option *o;
    const char *law; /* asked for; NULL: the one that suits           */
    double share;    /* 10-min mean over a plain speed as typed       */
    size_t n;
    double *speed; /* SPEEDS_MAX + 1 [m/s] */
};

__attribute__((format(printf, 2, 3))) static void say(struct winds *w, const char *fmt, ...)
{
    char line[1024];
    va_list list;
    va_start(list, fmt);
    vsnprintf(line, sizeof line, fmt, list);
    va_end(list);
    const char *before = w->r->out->winds_said;
    w->r->out->winds_said =
        wf_arena_print(w->r->arena, "%s%s%s", before ? before : "", before ? "; " : "", line);
}

static const char *source_of(const char *law)
{
    const struct wf_averaging_law *l = wf_averaging_laws;
    while (strcmp(l->name, law) != 0) l++;
    return l->source;
}

/* "beaufort:8", "cma:typhoon". */
static void grade(struct winds *w, const char *text)
{
    struct wf_scale_wind g;
    struct wf_err e = { 0 };
    double *speed = &w->speed[w->n++];
    char range[48];
    if (wf_wind_scale_parse(text, &g, &e)) {
        wf_args_mistake(w->r, w->o->name, "%s", e.text);
        return;
    }
    const char *law = w->law ? w->law : g.scale->law;
    bool other = g.scale->averaging != WF_MEAN_TIME;
    *speed = g.speed;
    if (other && wf_wind_average(law, g.speed, g.scale->averaging, WF_MEAN_TIME, speed, &e)) {
        wf_args_mistake(w->r, w->o->name, "%s: %s", text, e.text);
        return;
    }
    snprintf(range, sizeof range, isfinite(g.grade->high) ? "%.1f to %.1f m/s" : "from %.1f m/s",
             g.grade->low, g.grade->high);
    say(w, "%s: %s, %s averaged over %g min at %g m (%s)", text, g.grade->text, range,
        g.scale->averaging / 60.0, g.scale->height, g.scale->source);
    if (other)
        say(w, "%.1f m/s taken as %.1f m/s over 10 min by the law '%s' (%s)", g.speed, *speed, law,
            source_of(law));
    else
        say(w, "taken as %.1f m/s", *speed);
}

/* "5:40:1": from, to, step. */
static void range(struct winds *w, char *text, const char *unit)
{
    char *colon = strchr(text, ':'), *second = strchr(colon + 1, ':');
    struct wf_option step = *w->o;
    double from, to, by;
    if (!second || strchr(second + 1, ':')) {
        wf_args_mistake(w->r, w->o->name, "'%.100s': a range is written from:to:step, for example 5:40:1",
                        text);
        return;
    }
    *colon = *second = '\0';
    step.low = 1e-3;
    if (!wf_args_quantity(w->r, w->o, text, unit, &from) ||
        !wf_args_quantity(w->r, w->o, colon + 1, unit, &to) ||
        !wf_args_quantity(w->r, &step, second + 1, unit, &by))
        return;
    double count = floor((to - from) / by * (1 + 1e-12) + 1e-9) + 1.0;
    if (from > to)
        wf_args_mistake(w->r, w->o->name, "a range runs from the lower to the higher speed");
    else if (count > (double)(SPEEDS_MAX - w->n))
        wf_args_mistake(w->r, w->o->name, "more than %d wind speeds", SPEEDS_MAX);
    else
        for (size_t k = 0; k < (size_t)count; k++) w->speed[w->n++] = w->share * (from + by * (double)k);
}

/* The unit behind the last number holds for every plain number of the list: "5:40:5 km/h", "20,40 km/h".
 * A unit further left only would leave the numbers after it in doubt. Returned: false when in doubt. */
static bool shared_unit(const struct wf_option *o, const char *text, const char **unit)
{
    bool earlier = false;
    *unit = o->unit;
    for (const char *p = text;; p++) {
        const char *own = wf_args_unit(p), *next = strpbrk(p, ",:");
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

static void list(struct winds *w, char *text, const char *unit)
{
    char *rest = NULL;
    size_t before = w->r->mistakes;
    for (char *item = strtok_r(text, ",", &rest); item && w->n <= SPEEDS_MAX;
         item = strtok_r(NULL, ",", &rest)) {
        if (wf_wind_scale_is(item))
            grade(w, item);
        else if (strchr(item, ':'))
            range(w, item, unit);
        else if (wf_args_quantity(w->r, w->o, item, unit, &w->speed[w->n]))
            w->speed[w->n++] *= w->share;
    }
    if (w->n > SPEEDS_MAX) wf_args_mistake(w->r, w->o->name, "more than %d wind speeds", SPEEDS_MAX);
    if (w->n == 0 && w->r->mistakes == before) wf_args_mistake(w->r, w->o->name, "no wind speed is given");
    qsort(w->speed, w->n, sizeof *w->speed, ascending);
}

/* Into the row of a list, the same speed once. */
static void keep(struct winds *w)
{
    struct wf_args *out = w->r->out;
    out->speed = w->speed;
    out->speeds = 0;
    for (size_t k = 0; k < w->n; k++)
        if (out->speeds == 0 || w->speed[k] > w->speed[out->speeds - 1] + 1e-9)
            w->speed[out->speeds++] = w->speed[k];
}

static void read_winds(struct winds *w, size_t row)
{
    const char *unit, *text = w->r->out->text[row];
    char *copy = wf_arena_text(w->r->arena, text);
    w->speed = WF_TAKE(w->r->arena, SPEEDS_MAX + 1, double);
    if (!copy || !w->speed) {
        wf_args_mistake(w->r, w->o->name, "out of memory");
    } else if (w->o->kind == WF_OPTION_SPEED && strchr(text, ',')) {
        wf_args_mistake(w->r, w->o->name, "'%.100s': one wind speed is taken", text);
    } else if (!shared_unit(w->o, text, &unit)) {
        wf_args_mistake(w->r, w->o->name,
                        "'%.100s': write the unit behind the last number; it then holds for all", text);
    } else {
        list(w, copy, unit);
        if (w->o->kind == WF_OPTION_SPEEDS)
            keep(w);
        else if (w->n > 1)
            wf_args_mistake(w->r, w->o->name, "'%.100s': one wind speed is taken", text);
        else if (w->n == 1)
            w->r->out->number[row] = w->speed[0];
    }
}

/* What plain speeds are multiplied by; said once. */
static double share_of(struct winds *w, double time)
{
    struct wf_err e = { 0 };
    const char *law = w->law ? w->law : "durst";
    double share = 1.0;
    bool allowed = time >= 1.0 && time <= 3600.0; /* else the option is complained of already */
    if (!allowed || time == WF_MEAN_TIME) return 1.0;
    if (wf_wind_average(law, 1.0, time, WF_MEAN_TIME, &share, &e)) {
        wf_args_mistake(w->r, "--averaging-time", "%s", e.text);
        return 1.0;
    }
    say(w, "winds named are averaged over %g s and taken times %.4g, as the %s, by the law '%s' (%s)", time,
        share,
        time < WF_MEAN_TIME ? "10-min mean in which they are the strongest"
                            : "strongest 10-min mean within that time",
        law, source_of(law));
    return share;
}

void wf_args_winds(struct wf_reading *r)
{
    for (size_t k = 0; k < r->options; k++) {
        const struct wf_option *o = &r->out->option[k];
        bool wind = o->kind == WF_OPTION_SPEED || o->kind == WF_OPTION_SPEEDS;
        if (!wind || !r->out->text[k]) continue;
        struct winds w = { .r = r, .o = o, .law = wf_args_text(r->out, "--averaging") };
        w.share = share_of(&w, wf_args_number(r->out, "--averaging-time"));
        read_winds(&w, k);
    }
}
