/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Option rows: values from text into the command's options struct, and the text that explains a row. */
#include "cmd/option.h"
#include "base/num.h"
#include "base/said.h"
#include "base/text.h"
#include "base/yaml.h"
#include "out/page_units.h"
#include "out/tongue.h"
#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The system of units of stdout, and the beginning of a line that is held back, in the arena. */
static struct {
    const char *system, *begun;
    struct wf_arena arena;
} turning;

/* Print the whole lines of what was held back and of `text` in the units that are set. */
static int put_turned(const char *text)
{
    const char *all = wf_arena_print(&turning.arena, "%s%s", turning.begun ? turning.begun : "", text),
               *last = all ? strrchr(all, '\n') : NULL;
    struct wf_arena before = turning.arena;
    turning.arena = (struct wf_arena){ 0 };
    size_t whole = last ? (size_t)(last - all) + 1 : 0;
    const char *lines = whole ? wf_arena_print(&before, "%.*s", (int)whole, all) : "",
               *turned = lines ? wf_page_units_turned(turning.system, lines, NULL, &before) : NULL;
    turning.begun = all ? wf_arena_text(&turning.arena, all + whole) : NULL;
    int n = turned && turning.begun && fputs(turned, stdout) >= 0 ? (int)strlen(text) : -1;
    wf_arena_free(&before);
    return n;
}

void wf_show_in(const char *system)
{
    const char *rest =
        turning.begun ? wf_page_units_turned(turning.system, turning.begun, NULL, &turning.arena) : NULL;
    if (rest) (void)fputs(rest, stdout);
    wf_arena_free(&turning.arena);
    turning.begun = NULL, turning.system = system;
}

const char *wf_show_units(void) { return turning.system; }

static int put(FILE *to, const char *text, char end)
{
    struct wf_arena a = { 0 };
    const char *safe = text ? wf_text_for_terminal(text, end, &a) : NULL;
    bool turned = turning.system && to == stdout;
    int n = !safe ? -1 : turned ? put_turned(safe) : fputs(safe, to) >= 0 ? (int)strlen(safe) : -1;
    wf_arena_free(&a);
    return n;
}

int wf_show_text(FILE *to, const char *text) { return put(to, text, '\n'); }

/* A control character that a text does not hold; NUL when it holds all of them. */
static char unused_in(const char *text)
{
    char c = 1;
    while (c == '\t' || c == '\n' || (c < ' ' && strchr(text, c))) c++;
    return c < ' ' ? c : '\0';
}

/* Without memory: the beginning of the text, in one line of plain letters. */
static int put_short(FILE *to, const char *fmt, va_list list)
{
    char text[512];
    (void)vsnprintf(text, sizeof text - 1, fmt, list);
    for (char *s = text; *s; s++)
        if (*s < ' ' || *s > '~') *s = s[1] || *s != '\n' ? '?' : '\n';
    return fputs(text, to) >= 0 ? (int)strlen(text) : -1;
}

/* The text of a message, with `end` in the place of the line ends of its format. Returned: to be freed; NULL
 * without memory. */
static char *message(const char *fmt, va_list list, char *end)
{
    va_list again;
    va_copy(again, list);
    char *text = NULL, *marked = strdup(fmt);
    int n = marked ? vasprintf(&text, fmt, list) : -1;
    if (n >= 0) *end = unused_in(text), free(text);
    for (char *s = marked; s && (s = strchr(s, '\n'));) *s = *end ? *end : ' ';
    if (n >= 0) n = vasprintf(&text, marked, again);
    va_end(again);
    free(marked);
    return n >= 0 ? text : NULL;
}

/* The language of the terminal; NULL: English. */
static struct wf_tongue *spoken;

static void fall_silent(void)
{
    wf_tongue_close(spoken);
    spoken = NULL;
}

void wf_show_language(const char *language)
{
    struct wf_err unsaid = { 0 };
    if (spoken || !strcmp(language, "en") || wf_tongue_open(language, &spoken, &unsaid)) return;
    (void)atexit(fall_silent);
}

void wf_show_name(const char *name, const char *own)
{
    if (spoken) wf_tongue_name(spoken, name, own);
}

char *wf_show_words(const struct wf_said *said, struct wf_arena *a)
{
    return spoken && said ? wf_tongue_say(spoken, said, a) : NULL;
}

/* A message in the language of the terminal. Returned: bytes, -1 where it has no translation. */
static int show_words(FILE *to, const char *fmt, va_list list)
{
    struct wf_arena a = { 0 };
    struct wf_said said;
    bool whole = spoken && wf_said_take(&a, fmt, list, &said);
    for (size_t k = 0; whole && k < said.n; k++) {
        char *one = wf_arena_text(&a, said.arg[k]);
        for (char *s = one; s && *s; s++)
            if (*s == '\n') *s = ' '; /* line ends are those of the format */
        whole = (said.arg[k] = one) != NULL;
    }
    char *text = whole ? wf_tongue_say(spoken, &said, &a) : NULL;
    int n = text ? put(to, text, '\n') : -1;
    wf_arena_free(&a);
    return n;
}

int wf_show(FILE *to, const char *fmt, ...)
{
    char end = '\0';
    va_list list, again;
    va_start(list, fmt);
    int spoke = show_words(to, fmt, list);
    va_end(list);
    if (spoke >= 0) return spoke;
    va_start(list, fmt);
    va_copy(again, list);
    char *text = message(fmt, list, &end);
    int n = put(to, text, end);
    if (n < 0 && !ferror(to)) n = put_short(to, fmt, again);
    va_end(list);
    va_end(again);
    free(text);
    return n;
}

bool wf_option_given(const struct wf_args *args, size_t member)
{
    size_t k = 0;
    while (args->option[k].name && args->option[k].member != member) k++;
    assert(args->option[k].name); /* a member that no row fills */
    return args->given[k];
}

bool wf_option_unused(bool unused, char why[static WF_WHY], const char *fmt, ...)
{
    va_list list;
    if (!unused) return false;
    va_start(list, fmt);
    vsnprintf(why, WF_WHY, fmt, list);
    va_end(list);
    return true;
}

/* Add a mistake to the text, as far as there is room. */
static void sink_add(struct wf_sink *s, const char *name, const char *text)
{
    size_t used = strlen(s->text);
    name += strspn(name, "-"); /* a cell is no option */
    snprintf(s->text + used, sizeof s->text - used, "%s%s%s%s", s->n++ ? "; " : "", name, *name ? ": " : "",
             text);
}

void wf_option_mistake(struct wf_reading *r, const char *key, const char *name, const char *fmt, ...)
{
    va_list list;
    char text[2048];
    va_start(list, fmt);
    vsnprintf(text, sizeof text, fmt, list);
    va_end(list);
    if (key && r->yaml)
        wf_yaml_error(r->yaml, key, "%s", text);
    else if (r->sink)
        sink_add(r->sink, name, text);
    else
        wf_show(stderr, "windfirm %s: %s%s%s\n", r->command, name, *name ? ": " : "", text);
    r->mistakes++;
}

void *wf_option_member(const struct wf_reading *r, size_t k)
{
    return (char *)r->args + r->args->option[k].member;
}

void wf_option_clear(struct wf_reading *r)
{
    for (size_t k = 0; k < r->options; k++) {
        void *member = wf_option_member(r, k);
        switch (r->args->option[k].kind) {
        case WF_OPTION_FLAG:
            *(bool *)member = false;
            break;
        case WF_OPTION_TEXT:
        case WF_OPTION_PATH:
        case WF_OPTION_STUDY:
        case WF_OPTION_TEXTS:
        case WF_OPTION_CHOICE:
            *(const char **)member = NULL;
            break;
        case WF_OPTION_NUMBER:
        case WF_OPTION_SPEED:
            *(double *)member = NAN;
            break;
        case WF_OPTION_WHOLE:
            *(size_t *)member = 0;
            break;
        case WF_OPTION_SPEEDS:
            *(struct wf_speeds *)member = (struct wf_speeds){ 0 };
            break;
        }
    }
}

const char *wf_option_unit(const char *text)
{
    double value;
    while (*text == ' ') text++;
    const char *stop = wf_number_read(text, text + strlen(text), '.', &value);
    while (stop && *stop == ' ') stop++;
    return stop;
}

/* A quantity to SI; a plain number is one of `unit`. */
static enum wf_status to_si(struct wf_reading *r, const struct wf_option *o, const char *text,
                            const char *unit, double *si, struct wf_err *e)
{
    char with_unit[256];
    const char *own = wf_option_unit(text);
    if (unit && own && !*own) {
        snprintf(with_unit, sizeof with_unit, "%s %s", text, unit);
        text = with_unit;
    }
    return wf_quantity_read(r->units, text, o->dimension, si, e);
}

bool wf_option_quantity(struct wf_reading *r, size_t k, const char *text, const char *unit, double low,
                        double *si)
{
    const struct wf_option *o = &r->args->option[k];
    struct wf_err e = { 0 };
    char low_text[32], high_text[32];
    double si_low, si_high;
    snprintf(low_text, sizeof low_text, "%.17g", low);
    snprintf(high_text, sizeof high_text, "%.17g", o->high);
    if (to_si(r, o, text, unit, si, &e) || to_si(r, o, low_text, o->unit, &si_low, &e) ||
        to_si(r, o, high_text, o->unit, &si_high, &e)) {
        r->no_memory = r->no_memory || e.code == WF_ENOMEM;
        wf_option_mistake(r, r->key[k], o->name, "%s", e.text);
        return false;
    }
    const double slack = 1e-12; /* relative to the bound: a bound of 0 has no slack */
    if (*si >= si_low - slack * fabs(si_low) && *si <= si_high + slack * fabs(si_high)) return true;
    wf_option_mistake(r, r->key[k], o->name, "%.100s is outside %.6g..%.6g%s%s", text, low, o->high,
                      o->unit ? " " : "", o->unit ? o->unit : "");
    return false;
}

/* The words that a choice may be. Returned: how many; `list` holds them where they come from `choices`. */
size_t wf_option_choices(const struct wf_option *o, const char *word[static WF_OPTION_CHOICES], char *list,
                         size_t size)
{
    size_t n = 0;
    char *rest = NULL;
    for (; o->word && n < WF_OPTION_CHOICES && o->word(n); n++) word[n] = o->word(n);
    if (o->word) return n;
    snprintf(list, size, "%s", o->choices);
    for (char *w = strtok_r(list, "|", &rest); w && n < WF_OPTION_CHOICES; w = strtok_r(NULL, "|", &rest))
        word[n++] = w;
    return n;
}

static void check_choice(struct wf_reading *r, size_t k, const char *text)
{
    const struct wf_option *o = &r->args->option[k];
    const char *word[WF_OPTION_CHOICES];
    char list[512];
    size_t n = wf_option_choices(o, word, list, sizeof list);
    for (size_t i = 0; i < n; i++)
        if (strcmp(text, word[i]) == 0) return;
    const char *meant = o->meant ? o->meant(text) : NULL;
    if (meant) {
        *(const char **)wf_option_member(r, k) = meant;
        return;
    }
    char all[768] = "";
    for (size_t i = 0, used = 0; i < n && used < sizeof all; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", word[i]);
    wf_option_mistake(r, r->key[k], o->name, "'%.100s' is none of %s%s", text, all,
                      wf_did_you_mean(text, word, n).text);
}

static void take_flag(struct wf_reading *r, size_t k, const char *text)
{
    static const char *const word[] = { "yes", "true", "no", "false" };
    size_t i = 0;
    while (i < 4 && strcmp(text, word[i]) != 0) i++;
    if (i == 4) wf_option_mistake(r, r->key[k], "", "'%.60s' is neither yes nor no", text);
    r->args->given[k] = *(bool *)wf_option_member(r, k) = i < 2;
}

static bool has_empty_item(const char *list)
{
    bool empty = true;
    for (const char *p = list; *p; p++) {
        if (*p == ',' && empty) return true;
        empty = *p == ',' || (empty && *p == ' ');
    }
    return empty;
}

static void take_text(struct wf_reading *r, size_t k, const char *text)
{
    const struct wf_option *o = &r->args->option[k];
    const char **member = wf_option_member(r, k);
    bool list = o->kind == WF_OPTION_TEXTS, adds = list && *member;
    if (list && has_empty_item(text))
        wf_option_mistake(r, r->key[k], o->name, "'%.100s': an item of the list is empty", text);
    *member = adds ? wf_arena_print(r->arena, "%s,%s", *member, text) : text;
    if (!*member) wf_option_mistake(r, r->key[k], o->name, "out of memory");
}

static void take_whole(struct wf_reading *r, size_t k, const char *text)
{
    const struct wf_option *o = &r->args->option[k];
    double value = 0;
    if (!wf_option_quantity(r, k, text, o->unit, o->low, &value)) return;
    if (value != floor(value)) wf_option_mistake(r, r->key[k], o->name, "%.100s is not a whole number", text);
    *(size_t *)wf_option_member(r, k) = (size_t)llround(value);
}

void wf_option_take(struct wf_reading *r, size_t k, const char *text)
{
    const struct wf_option *o = &r->args->option[k];
    const size_t before = r->mistakes;
    r->text[k] = text;
    switch (o->kind) {
    case WF_OPTION_FLAG:
        take_flag(r, k, text);
        break;
    case WF_OPTION_TEXT:
    case WF_OPTION_PATH:
    case WF_OPTION_STUDY:
    case WF_OPTION_TEXTS:
        take_text(r, k, text);
        break;
    case WF_OPTION_CHOICE:
        take_text(r, k, text);
        check_choice(r, k, text);
        break;
    case WF_OPTION_NUMBER:
        wf_option_quantity(r, k, text, o->unit, o->low, wf_option_member(r, k));
        break;
    case WF_OPTION_WHOLE:
        take_whole(r, k, text);
        break;
    case WF_OPTION_SPEED:
    case WF_OPTION_SPEEDS:
        break;
    }
    r->failed[k] = r->mistakes > before;
}

void wf_option_text(const struct wf_option *o, char text[static WF_OPTION_DOC])
{
    *text = '\0';
    FILE *to = fmemopen(text, WF_OPTION_DOC, "w");
    if (!to) return;
    const char *unit = o->unit ? o->unit : "", *word[WF_OPTION_CHOICES];
    char list[512];
    wf_show(to, "%s", o->help);
    if (o->kind == WF_OPTION_CHOICE) {
        size_t n = wf_option_choices(o, word, list, sizeof list);
        for (size_t i = 0; i < n; i++) fprintf(to, "%s%s", i ? ", " : ": ", word[i]);
    }
    bool wind = o->kind == WF_OPTION_SPEED || o->kind == WF_OPTION_SPEEDS;
    if (o->kind == WF_OPTION_NUMBER || o->kind == WF_OPTION_WHOLE || wind)
        fprintf(to, " (%.6g..%.6g%s%s)", o->low, o->high, *unit ? " " : "", unit);
    if (wind) wf_show(to, "; or a grade: beaufort:8, cma:typhoon, hko:typhoon");
    if (o->initial)
        fprintf(to, " [%s%s%s]", o->initial, o->kind != WF_OPTION_CHOICE && *unit ? " " : "",
                o->kind != WF_OPTION_CHOICE ? unit : "");
    fclose(to);
}
