/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/wind_speed.h"
#include "base/num.h"
#include "base/text.h"
#include "load/scene.h"
#include "wind/category.h"
#include "wind/climate.h"
#include "wind/design.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { SPEEDS_MAX = 1000 };

const char *wf_averaging_word(size_t i) { return wf_averaging_laws[i].name; }

bool wf_averaging_row_unused(const void *options, const struct wf_option *o, char *why)
{
    const struct wf_averaging *g = (const void *)((const char *)options + o->group);
    if (o->member - o->group == offsetof(struct wf_averaging, time))
        return wf_option_unused(!g->time_used, why,
                                "on grades of a scale and design winds, which have their own");
    return wf_option_unused(!g->law_used && !g->climate, why, "where the winds are 10-min means already");
}

/* The winds of one option. */
struct winds {
    struct wf_reading *r;
    size_t k; /* row */
    const struct wf_option *o;
    struct wf_averaging *beside;
    const char *law; /* specified; NULL: durst, or that of a scale    */
    double time;     /* plain speeds are averaged over [s]            */
    bool worded;     /* by a word before them                         */
    double share;    /* 10-min mean over a plain speed as typed       */
    size_t n;
    double *speed;                       /* SPEEDS_MAX + 1 [m/s] */
    size_t plain;                        /* of these, without grades */
    double *typed;                       /* as typed [m/s] */
    const struct wf_profile_words *site; /* NULL: the command has none */
    struct wf_wind_place at;             /* where the winds are measured */
};

#define winds_mistake(w, ...) wf_option_mistake((w)->r, (w)->r->key[(w)->k], (w)->o->name, __VA_ARGS__)

__attribute__((format(printf, 2, 3))) static void say(struct winds *w, const char *fmt, ...)
{
    char line[1024];
    va_list list;
    va_start(list, fmt);
    vsnprintf(line, sizeof line, fmt, list);
    va_end(list);
    const char *before = w->r->args->winds_said;
    w->r->args->winds_said =
        wf_arena_print(w->r->arena, "%s%s%s", before ? before : "", before ? "; " : "", line);
}

/* With that many decimals, or as many digits as it has. */
static const char *number_text(const struct winds *w, double x, int decimals)
{
    return decimals < 0 ? wf_arena_print(w->r->arena, "%.4g", x)
                        : wf_arena_print(w->r->arena, "%.*f", decimals, x);
}

/* The same by parts. Given: parts, NULL after the last. */
static void note(struct winds *w, const char *kind, const char *const *part)
{
    struct wf_wind_note **end = &w->r->args->wind_notes, *made = WF_TAKE(w->r->arena, 1, struct wf_wind_note);
    if (!made) return;
    *made = (struct wf_wind_note){ .kind = kind };
    for (size_t k = 0; k < WF_WIND_PARTS && part[k]; k++) made->part[k] = part[k];
    while (*end) end = (struct wf_wind_note **)&(*end)->next;
    *end = made;
}

static const char *source_of(const char *law)
{
    const struct wf_averaging_law *l = wf_averaging_laws;
    while (strcmp(l->name, law) != 0) l++;
    return l->source;
}

/* "beaufort:8", "cma:typhoon". Returned: its scale; NULL after a mistake. */
static const struct wf_wind_scale *read_grade(struct winds *w, const char *text)
{
    struct wf_scale_wind g;
    struct wf_err e = { 0 };
    double *speed = &w->speed[w->n++];
    char range[48];
    if (w->worded) {
        winds_mistake(w, "'%.60s': a grade has its averaging time; write it without the word before the list",
                      text);
        return NULL;
    }
    if (wf_wind_scale_parse(text, &g, &e)) {
        winds_mistake(w, "%s", e.text);
        return NULL;
    }
    const char *law = w->law ? w->law : g.scale->law;
    bool other = g.scale->averaging != WF_MEAN_TIME;
    *speed = g.speed;
    w->beside->law_used |= other;
    if (other && wf_wind_average(law, &w->at, g.speed, g.scale->averaging, WF_MEAN_TIME, speed, &e)) {
        winds_mistake(w, "%s: %s", text, e.text);
        return NULL;
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
    note(w, "grade",
         (const char *[]){ text, g.grade->text, number_text(w, g.grade->low, 1),
                           isfinite(g.grade->high) ? number_text(w, g.grade->high, 1) : "",
                           number_text(w, g.scale->averaging / 60.0, -1), number_text(w, *speed, 1), NULL });
    return g.scale;
}

/* "5:40:1": from, to, step. */
static void read_range(struct winds *w, char *text, const char *unit)
{
    char *colon = strchr(text, ':'), *second = strchr(colon + 1, ':');
    const double least_step = 1e-3; /* in the unit of the row */
    double from, to, by;
    if (!second || strchr(second + 1, ':')) {
        winds_mistake(w, "'%.100s': a range is written from:to:step, for example 5:40:1", text);
        return;
    }
    *colon = *second = '\0';
    if (!wf_option_quantity(w->r, w->k, text, unit, w->o->low, &from) ||
        !wf_option_quantity(w->r, w->k, colon + 1, unit, w->o->low, &to) ||
        !wf_option_quantity(w->r, w->k, second + 1, unit, least_step, &by))
        return;
    double count = floor((to - from) / by * (1 + 1e-12) + 1e-9) + 1.0;
    if (from > to)
        winds_mistake(w, "a range runs from the lower to the higher speed");
    else if (count > (double)(SPEEDS_MAX - w->n))
        winds_mistake(w, "more than %d wind speeds", SPEEDS_MAX);
    else
        for (size_t k = 0; k < (size_t)count; k++) w->speed[w->n++] = w->share * (from + by * (double)k);
}

/* The unit after the last number holds for every plain number of the list: "5:40:5 km/h", "20,40 km/h". A
 * unit given with an earlier number only makes the numbers after it ambiguous. Returned: false then. */
static bool shared_unit(const struct wf_option *o, const char *text, const char **unit)
{
    bool earlier = false;
    *unit = o->unit;
    for (const char *p = text;; p++) {
        const char *own = wf_option_unit(p), *next = strpbrk(p, ",:");
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

/* Whether an item behind a grade is a grade of the same scale: any word, and a number without a unit that is
 * a grade ("beaufort:8,9"; in "beaufort:8,30" the second is a speed). */
static bool follows_grade(const struct winds *w, const struct wf_wind_scale *scale, const char *item,
                          const char *unit)
{
    if (!scale || strchr(item, ':')) return false;
    if (!wf_option_unit(item)) return true;
    const struct wf_wind_grade *g = scale->grade;
    while (g->name && strcmp(g->name, item) != 0) g++;
    return g->name && unit == w->o->unit;
}

/* One item that is no grade. Returned: its first speed; NAN after a mistake. */
static double read_speed(struct winds *w, char *item, const char *unit)
{
    size_t from = w->n;
    if (strchr(item, ':'))
        read_range(w, item, unit);
    else if (wf_option_quantity(w->r, w->k, item, unit, w->o->low, &w->speed[w->n]))
        w->speed[w->n++] *= w->share;
    for (size_t k = from; k < w->n; k++) w->typed[w->plain++] = w->speed[k] / w->share;
    w->beside->time_used = true;
    w->beside->law_used |= w->time != WF_MEAN_TIME;
    return w->n > from ? w->speed[from] : (double)NAN;
}

/* "10,5" is two speeds, or 10.5 with a decimal comma: ask. */
static void question_order(struct winds *w, const char *whole)
{
    const char *comma = strchr(whole, ',');
    int first = (int)(comma - whole);
    if (strchr(comma + 1, ',') || strchr(whole, ':'))
        winds_mistake(w, "'%.100s': speeds are written in rising order; a decimal number has a point", whole);
    else
        winds_mistake(
            w,
            "'%.100s': speeds are written in rising order; did you mean the one speed '%.*s.%.40s' or "
            "the two speeds '%.40s,%.*s'?",
            whole, first, whole, comma + 1, comma + 1, first, whole);
}

/* Words before the first speed, which say what all speeds of the list are. */
static const struct {
    const char *word, *plural;
    double time; /* [s] */
} times[] = {
    { "gust:", "3-s gusts", WF_GUST_TIME },
    { "hourly:", "hourly means", 3600.0 },
    { "mean:", "10-min means", WF_MEAN_TIME },
};

size_t wf_wind_time_word(const char *text, size_t *which)
{
    for (*which = 0; *which < WF_COUNT(times); ++*which)
        if (strncmp(text, times[*which].word, strlen(times[*which].word)) == 0)
            return strlen(times[*which].word);
    return 0;
}

static void read_list(struct winds *w, char *text, const char *unit, const char *whole)
{
    const struct wf_wind_scale *scale = NULL;
    size_t before = w->r->mistakes, word;
    double last = 0.0;
    bool falls = false, empty = false;
    for (char *rest = text, *item; w->n <= SPEEDS_MAX && (item = wf_list_item(&rest));) {
        if (!*item) {
            empty = true;
        } else if (wf_wind_time_word(item, &word)) {
            winds_mistake(w, "'%.60s': the word stands once, before the first speed, and holds for all",
                          item);
        } else if (wf_wind_scale_is(item)) {
            scale = read_grade(w, item);
        } else if (follows_grade(w, scale, item, unit)) {
            char *grade = wf_arena_print(w->r->arena, "%s:%s", scale->name, item);
            scale = read_grade(w, grade ? grade : item);
        } else {
            double speed = read_speed(w, item, unit);
            falls |= speed < last;
            last = fmax(last, w->n ? w->speed[w->n - 1] : 0.0);
            scale = NULL;
        }
    }
    if (w->n > SPEEDS_MAX) winds_mistake(w, "more than %d wind speeds", SPEEDS_MAX);
    if (w->n == 0 && w->r->mistakes == before)
        winds_mistake(w, "no wind speed is given");
    else if (empty)
        winds_mistake(w, "'%.100s': an item of the list is empty", whole);
    if (falls && w->r->mistakes == before) question_order(w, whole);
    qsort(w->speed, w->n, sizeof *w->speed, ascending);
}

/* The speeds of a list, each once. */
static void keep_list(const struct winds *w, struct wf_speeds *out)
{
    *out = (struct wf_speeds){ .speed = w->speed };
    for (size_t k = 0; k < w->n; k++)
        if (out->n == 0 || w->speed[k] > w->speed[out->n - 1] + 1e-9) w->speed[out->n++] = w->speed[k];
}

/* Take the word off the text, and the averaging time from it. */
static void take_time(struct winds *w, const char **text)
{
    w->time = w->beside->time;
    for (size_t i, n; (n = wf_wind_time_word(*text, &i)); *text += n) {
        if (w->beside->time != WF_MEAN_TIME)
            winds_mistake(w, "'%.100s': the averaging time is given twice (--averaging-time)", *text);
        if (w->worded) winds_mistake(w, "'%.100s': one word of an averaging time is taken", *text);
        w->time = times[i].time;
        w->worded = true;
    }
}

/* The plain speeds: "30, 36 m/s", or "5 to 40 m/s" where there are many. Given: what they are multiplied by.
 */
static const char *list_text(const struct winds *w, double share)
{
    enum { SHOWN = 8 };
    const size_t n = w->plain;
    const char *text = n ? wf_arena_print(w->r->arena, "%.4g", share * w->typed[0]) : "";
    if (n > SHOWN) return wf_arena_print(w->r->arena, "%s to %.4g m/s", text, share * w->typed[n - 1]);
    for (size_t k = 1; k < n && text; k++)
        text = wf_arena_print(w->r->arena, "%s, %.4g", text, share * w->typed[k]);
    return text ? wf_arena_print(w->r->arena, "%s m/s", text) : NULL;
}

/* What was typed, and in brackets what it was converted to. */
static void say_typed(struct winds *w)
{
    char what[64], by[512];
    const char *law = w->law ? w->law : wf_averaging_usual(w->time);
    const char *typed = list_text(w, 1.0), *means = list_text(w, w->share);
    snprintf(what, sizeof what, "means over %g s", w->time);
    for (size_t i = 0; i < WF_COUNT(times); i++)
        if (times[i].time == w->time) snprintf(what, sizeof what, "%s", times[i].plural);
    if (!w->law && w->time == WF_GUST_TIME && w->site && w->site->gust_factor > 0.0)
        snprintf(by, sizeof by, "by the gust factor given");
    else
        snprintf(by, sizeof by, "by the law '%s': %s", law, source_of(law));
    say(w, "wind given: %s of %s at %.4g m over terrain %s (10-min means of %s: times %.4g, as the %s, %s)",
        what, typed ? typed : "", w->at.height, w->at.terrain->name, means ? means : "", w->share,
        w->time < WF_MEAN_TIME ? "10-min mean in which they are the strongest"
                               : "strongest 10-min mean within that time",
        by);
    bool factor = !w->law && w->time == WF_GUST_TIME && w->site && w->site->gust_factor > 0.0;
    note(w, "typed",
         (const char *[]){ number_text(w, w->time, -1), typed, number_text(w, w->at.height, -1),
                           w->at.terrain->name, means, number_text(w, w->share, -1), factor ? "given" : law,
                           NULL });
}

/* 10-min mean over a plain speed. */
static double share_of(struct winds *w)
{
    struct wf_err e = { 0 };
    const char *law = w->law ? w->law : wf_averaging_usual(w->time);
    double share = 1.0, factor = w->site ? w->site->gust_factor : NAN;
    bool allowed = w->time >= 1.0 && w->time <= 3600.0; /* else the mistake was already reported */
    if (!allowed || w->time == WF_MEAN_TIME) return 1.0;
    if (!w->law && w->time == WF_GUST_TIME && factor > 0.0) return 1.0 / factor;
    if (wf_wind_average(law, &w->at, 1.0, w->time, WF_MEAN_TIME, &share, &e)) {
        wf_option_mistake(w->r, w->r->key[w->k], "--averaging-time", "%s", e.text);
        return 1.0;
    }
    if (w->time == WF_GUST_TIME) w->beside->gust = 1.0 / share;
    return share;
}

static void read_speeds(struct winds *w, const char *whole, const char *text)
{
    const char *unit;
    char *copy = wf_arena_text(w->r->arena, text);
    if (!copy)
        winds_mistake(w, "out of memory");
    else if (w->o->kind == WF_OPTION_SPEED && strchr(text, ','))
        winds_mistake(w, "'%.100s': one wind speed is taken", whole);
    else if (!shared_unit(w->o, text, &unit))
        winds_mistake(w, "'%.100s': write the unit behind the last number; it then holds for all", whole);
    else
        read_list(w, copy, unit, whole);
}

/* What the basic wind is: as the code says, or once in the years that were specified. */
static void design_words(const struct wf_design_words *words, const struct wf_design_wind *found, char *out,
                         size_t size)
{
    if (isnan(words->years))
        snprintf(out, size, "%s", found->code->basic);
    else if (words->region)
        snprintf(out, size, "regional gust at 10 m over TC2 of region %.20s, once in %.6g years",
                 words->region, words->years);
    else
        snprintf(out, size, "once in %.6g years; from %.4g m/s, %s", words->years,
                 isnan(words->basic) ? sqrt(2.0 * words->pressure / found->code->air) : words->basic,
                 found->code->basic);
}

/* The wind of a design code, which stands for the winds that are not typed. */
static void take_design(struct winds *w)
{
    struct wf_design_words words = w->site->design;
    struct wf_design_wind found;
    struct wf_err e = { 0 };
    const struct wf_site_kind *kind = wf_site_kind_named(w->site->site);
    if (kind && !words.terrain) words.terrain = kind->category;
    size_t k = 0;
    while (strcmp(w->r->args->option[k].name, "--design") != 0) k++;
    if (w->r->args->given[w->k]) {
        winds_mistake(w, "has no effect beside a design wind, --design");
    } else if (wf_design_find(&words, &found, &e)) {
        wf_option_mistake(w->r, w->r->key[k], "--design", "%s", e.text);
    } else {
        char rare[256];
        design_words(&words, &found, rare, sizeof rare);
        w->speed[w->n++] = found.open;
        say(w,
            "design wind of %s: basic wind %.4g m/s (%s); terrain %s%s: 10-min mean %.4g m/s and gust %.4g "
            "m/s "
            "at %s (10-min mean in open country: %.4g m/s; %s)",
            found.code->title, found.basic, rare, found.terrain->name,
            words.terrain || !found.code->terrain[1].name ? "" : " (assumed)", found.mean, found.gust,
            strcmp(found.code->name, "arborist") ? "10 m" : "the tree", found.open, found.code->source);
        note(w, "design",
             (const char *[]){ found.code->name, number_text(w, found.basic, -1), found.terrain->name,
                               number_text(w, found.mean, -1), number_text(w, found.gust, -1),
                               number_text(w, found.open, -1),
                               isnan(words.years) ? NULL : number_text(w, words.years, -1), NULL });
    }
}

static void read_wind(struct winds *w, const char *whole)
{
    const char *text = whole;
    void *member = wf_option_member(w->r, w->k);
    w->speed = WF_TAKE(w->r->arena, SPEEDS_MAX + 1, double);
    w->typed = WF_TAKE(w->r->arena, SPEEDS_MAX + 1, double);
    if (!w->speed || !w->typed) {
        winds_mistake(w, "out of memory");
        return;
    }
    take_time(w, &text);
    w->share = share_of(w);
    size_t before = w->r->mistakes;
    bool design = w->site && w->site->design.code;
    if (design)
        take_design(w);
    else
        read_speeds(w, whole, text);
    if (w->r->mistakes > before) return;
    if (!design && w->share != 1.0 && w->beside->time_used) say_typed(w);
    if (w->o->kind == WF_OPTION_SPEEDS)
        keep_list(w, member);
    else if (w->n > 1)
        winds_mistake(w, "'%.100s': one wind speed is taken", whole);
    else if (w->n == 1)
        *(double *)member = w->speed[0];
}

/* The site's words, of a command that has them. */
static const struct wf_profile_words *site_words(const struct wf_reading *r)
{
    for (size_t k = 0; k < r->options; k++)
        if (strcmp(r->args->option[k].name, "--design") == 0)
            return (const void *)((const char *)r->args + r->args->option[k].group);
    return NULL;
}

void wf_winds_read(struct wf_reading *r)
{
    const struct wf_profile_words *site = site_words(r);
    for (size_t k = 0; k < r->options; k++) {
        const struct wf_option *o = &r->args->option[k];
        bool wind = o->kind == WF_OPTION_SPEED || o->kind == WF_OPTION_SPEEDS;
        if (!wind || (!r->text[k] && !(site && site->design.code))) continue;
        struct wf_averaging *beside = (void *)((char *)r->args + o->averaging);
        struct winds w = { .r = r, .k = k, .o = o, .beside = beside, .law = beside->law, .site = site };
        w.at = site ? wf_profile_place(site) : (struct wf_wind_place){ wf_category_open(), 10.0 };
        beside->time_used = beside->law_used = false;
        read_wind(&w, r->text[k] ? r->text[k] : "");
    }
}
