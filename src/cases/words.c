/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cases/words.h"
#include "base/num.h"
#include "base/text.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool wf_words_wrong(struct wf_words *w, size_t k, const char *fmt, ...)
{
    char text[512];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    wf_diag_error(w->diag, w->file, w->line, k < w->n ? w->column[k] : w->end_column, "%s: %s", w->key, text);
    return false;
}

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool wf_words_split(struct wf_words *w, const char *text, size_t length)
{
    char *copy = WF_TAKE(w->arena, 2 * (length + 1), char), *rest = copy ? copy + length + 1 : NULL;
    w->n = w->next = 0;
    w->key = "";
    w->rest = "";
    if (!copy) return wf_words_wrong(w, 0, "no memory");
    memcpy(copy, text, length);
    size_t i = 0, characters = 1, behind_key = 0;
    while (i < length) {
        if (is_blank(copy[i])) {
            i++, characters++;
            continue;
        }
        if (copy[i] == '#') break;
        if (w->n == WF_WORDS_MAX) break; /* only prose is that long, and its readers use `rest` */
        w->column[w->n] = characters;
        w->word[w->n] = copy + i;
        for (; i < length && !is_blank(copy[i]); i++)
            characters += (copy[i] & 0xC0) != 0x80; /* UTF-8 continuation */
        w->end_column = characters;
        if (!w->n++) behind_key = i;
        if (i < length) copy[i++] = '\0', characters++;
    }
    if (!w->n) return true;
    w->key = w->word[0];
    w->next = 1;
    memcpy(rest, text + behind_key, length - behind_key);
    for (size_t k = length - behind_key; k > 0 && is_blank(rest[k - 1]); k--) rest[k - 1] = '\0';
    while (is_blank(*rest)) rest++;
    w->rest = rest;
    return true;
}

const char *wf_words_peek(const struct wf_words *w) { return w->next < w->n ? w->word[w->next] : NULL; }

bool wf_words_skip(struct wf_words *w, const char *text)
{
    const char *s = wf_words_peek(w);
    if (!s || strcmp(s, text) != 0) return false;
    w->next++;
    return true;
}

bool wf_words_choice(struct wf_words *w, const char *what, const char *const *known, size_t n, size_t *out)
{
    char all[512] = "";
    const char *s = wf_words_peek(w);
    for (*out = 0; s && *out < n; ++*out)
        if (!strcmp(s, known[*out])) {
            w->next++;
            return true;
        }
    for (size_t i = 0, used = 0; i < n && used < sizeof all; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", known[i]);
    if (!s) return wf_words_wrong(w, w->n, "%s is missing; one of: %s", what, all);
    return wf_words_wrong(w, w->next, "unknown %s '%s'%s", what, s,
                          wf_did_you_mean_or(s, known, n, "one of: ").text);
}

bool wf_words_number(struct wf_words *w, const char *what, double *out)
{
    const char *s = wf_words_peek(w);
    if (!s) return wf_words_wrong(w, w->n, "%s is missing", what);
    const char *end = s + strlen(s);
    if (wf_number_read(s, end, '.', out) != end)
        return wf_words_wrong(w, w->next, "%s: '%s' is not a number", what, s);
    w->next++;
    return true;
}

bool wf_words_whole(struct wf_words *w, const char *what, long long low, long long high, long long *out)
{
    const char *s = wf_words_peek(w);
    char *end;
    if (!s) return wf_words_wrong(w, w->n, "%s is missing", what);
    errno = 0;
    *out = strtoll(s, &end, 10);
    if (*end || errno || *out < low || *out > high)
        return wf_words_wrong(w, w->next, "%s: '%s' is not a whole number in %lld..%lld", what, s, low, high);
    w->next++;
    return true;
}

/* Does the word begin like a number? What follows may then be its unit. */
static bool begins_number(const char *s)
{
    s += *s == '+' || *s == '-';
    s += *s == '.';
    return *s >= '0' && *s <= '9';
}

static const char *unit_words(struct wf_words *w, const char *stop)
{
    char *text = wf_arena_text(w->arena, "");
    for (const char *s; text && (s = wf_words_peek(w)) && !(stop && !strcmp(s, stop)); w->next++)
        text = wf_arena_print(w->arena, "%s%s%s", text, *text ? " " : "", s);
    return text;
}

static bool convert_quantity(struct wf_words *w, size_t at, enum wf_dimension d, const char *unit,
                             double *value)
{
    struct wf_err e = { WF_OK, "" };
    const char *end = w->word[at] + strlen(w->word[at]);
    if (w->plain) {
        if (wf_number_read(w->word[at], end, '.', value) == end) return true;
        return wf_words_wrong(w, at, "'%s' is not a number", w->word[at]);
    }
    const char *text = wf_arena_print(w->arena, "%s %s", w->word[at], unit);
    if (!text) return wf_words_wrong(w, at, "no memory");
    return wf_quantity_read(w->units, text, d, value, &e) == WF_OK || wf_words_wrong(w, at, "%s", e.text);
}

bool wf_words_quantities(struct wf_words *w, enum wf_dimension d, size_t low, size_t high, bool gaps,
                         const char *stop, double *out, size_t *count, const char **unit_text)
{
    size_t from = w->next, n = 0;
    for (const char *s; n < high && (s = wf_words_peek(w)); n++, w->next++)
        if (!begins_number(s) && !(gaps && !strcmp(s, "-"))) break;
    if (n < low && w->next < w->n)
        return wf_words_wrong(w, w->next, "'%s' is not a number", w->word[w->next]);
    if (n < low)
        return wf_words_wrong(w, w->n, "%zu number%s expected, %zu found", low, low == 1 ? "" : "s", n);
    size_t unit_at = w->next;
    const char *unit = unit_words(w, stop);
    if (!unit) return wf_words_wrong(w, unit_at, "no memory");
    if (*unit && w->plain)
        return wf_words_wrong(w, unit_at, "'%s': a non-dimensional case has numbers without units", unit);
    for (size_t i = 0; i < n; i++) {
        if (!strcmp(w->word[from + i], "-"))
            out[i] = NAN;
        else if (!convert_quantity(w, from + i, d, unit, &out[i]))
            return false;
    }
    *count = n;
    if (unit_text) *unit_text = unit;
    return true;
}

bool wf_words_end(struct wf_words *w)
{
    if (w->next >= w->n) return true;
    return wf_words_wrong(w, w->next, "'%s' is not expected here", w->word[w->next]);
}

bool wf_list_add(struct wf_list *l, const void *element, size_t size, struct wf_arena *a)
{
    if (l->n >= l->room) {
        size_t room = 2 * l->n + 4;
        void *data = wf_arena_take(a, room, size);
        if (!data) return false;
        if (l->n) memcpy(data, l->data, l->n * size);
        l->data = data;
        l->room = room;
    }
    memcpy((char *)l->data + l->n++ * size, element, size);
    return true;
}
