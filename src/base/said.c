/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/said.h"
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A conversion of a format. */
struct conversion {
    char spec[32]; /* "%8.3f" with the stars replaced and without width */
    int width;
    char length; /* 'l', 'L' (long long), 'z', 'j', 't', 'D' (long double) or NUL */
    char type;
};

/* Arguments that are being taken; a va_list is passed on by its address. */
struct taking {
    struct wf_arena *a;
    va_list args;
};

static const char *read_length(const char *p, char *length)
{
    *length = '\0';
    for (; *p && strchr("hlzjtL", *p); p++)
        *length = *p == 'L' ? 'D' : *p == 'l' && *length == 'l' ? 'L' : *p;
    if (*length == 'h') *length = '\0'; /* passed as an int */
    return p;
}

/* Read the conversion behind a '%'. Returned: what follows it; NULL: it is of no use here. */
static const char *read_conversion(const char *p, struct taking *t, struct conversion *c)
{
    char flags[8] = "", digits[12] = "";
    size_t f = 0;
    for (; *p && strchr("-+ #0", *p) && f < sizeof flags - 1; p++) flags[f++] = *p;
    bool left = strchr(flags, '-') != NULL;
    c->width = 0;
    if (*p == '*')
        c->width = va_arg(t->args, int), p++;
    else
        c->width = (int)strtol(p, (char **)&p, 10);
    if (left && c->width > 0) c->width = -c->width;
    if (*p == '.') {
        long places = p[1] == '*' ? va_arg(t->args, int) : strtol(p + 1, NULL, 10);
        p += p[1] == '*' ? 2 : 1 + (ptrdiff_t)strspn(p + 1, "0123456789");
        snprintf(digits, sizeof digits, ".%ld", places);
    }
    p = read_length(p, &c->length);
    c->type = *p;
    if (!*p || !strchr("diouxXcsfFeEgGaAp", *p)) return NULL;
    char plain[8] = "";
    for (size_t i = 0, n = 0; flags[i]; i++)
        if (flags[i] != '-' && flags[i] != '0') plain[n++] = flags[i];
    bool zeros = strchr(flags, '0') && c->width > 0; /* zeros before a number are part of it */
    char wide[12] = "";
    if (zeros) snprintf(wide, sizeof wide, "0%d", c->width), c->width = 0;
    static const char *const lengths[] = {
        ['l'] = "l", ['L'] = "ll", ['z'] = "z", ['j'] = "j", ['t'] = "t", ['D'] = "L"
    };
    snprintf(c->spec, sizeof c->spec, "%%%s%s%s%s%c", plain, wide, digits,
             c->length ? lengths[(int)c->length] : "", c->type);
    return p + 1;
}

static char *print_whole(struct taking *t, const struct conversion *c)
{
    switch (c->length) {
    case 'l':
        return wf_arena_print(t->a, c->spec, va_arg(t->args, long));
    case 'L':
        return wf_arena_print(t->a, c->spec, va_arg(t->args, long long));
    case 'z':
        return wf_arena_print(t->a, c->spec, va_arg(t->args, size_t));
    case 'j':
        return wf_arena_print(t->a, c->spec, va_arg(t->args, intmax_t));
    case 't':
        return wf_arena_print(t->a, c->spec, va_arg(t->args, ptrdiff_t));
    default:
        return wf_arena_print(t->a, c->spec, va_arg(t->args, int));
    }
}

static char *print_one(struct taking *t, const struct conversion *c)
{
    if (c->type == 's') return wf_arena_print(t->a, c->spec, va_arg(t->args, const char *));
    if (c->type == 'p') return wf_arena_print(t->a, c->spec, va_arg(t->args, void *));
    if (strchr("fFeEgGaA", c->type))
        return c->length == 'D' ? wf_arena_print(t->a, c->spec, va_arg(t->args, long double))
                                : wf_arena_print(t->a, c->spec, va_arg(t->args, double));
    return print_whole(t, c);
}

bool wf_said_take(struct wf_arena *a, const char *fmt, va_list args, struct wf_said *out)
{
    struct taking t = { .a = a };
    char *message = WF_TAKE(a, 2 * strlen(fmt) + 8, char), *to = message;
    bool whole = message != NULL;
    *out = (struct wf_said){ .message = message };
    va_copy(t.args, args);
    for (const char *p = fmt; *p && whole;) {
        struct conversion c;
        if (*p != '%' || p[1] == '%') {
            *to++ = *p;
            p += *p == '%' ? 2 : 1;
            continue;
        }
        p = read_conversion(p + 1, &t, &c);
        whole = p && out->n < WF_SAID_MOST && (out->arg[out->n] = print_one(&t, &c));
        if (!whole) break;
        out->width[out->n++] = c.width;
        to += sprintf(to, "{%zu}", out->n);
    }
    va_end(t.args);
    if (whole) *to = '\0';
    if (!whole) *out = (struct wf_said){ 0 };
    return whole;
}

const struct wf_said *wf_said_copy(const struct wf_said *said, struct wf_arena *a)
{
    struct wf_said *copy = said ? WF_TAKE(a, 1, struct wf_said) : NULL;
    if (!copy) return NULL;
    *copy = *said;
    bool whole = (copy->message = wf_arena_text(a, said->message)) != NULL;
    for (size_t k = 0; k < said->n && whole; k++)
        whole = (copy->arg[k] = wf_arena_text(a, said->arg[k])) != NULL;
    return whole ? copy : NULL;
}

/* The number of "{12}"; 0: none. `end`: behind it. */
static size_t place_of(const char *p, const char **end)
{
    if (*p != '{') return 0;
    char *behind;
    unsigned long k = strtoul(p + 1, &behind, 10);
    *end = behind + 1;
    return behind > p + 1 && *behind == '}' ? k : 0;
}

char *wf_said_put(struct wf_arena *a, const char *message, const char *const *arg, size_t n)
{
    size_t size = strlen(message) + 1;
    const char *end;
    for (const char *p = message; *p; p++) {
        size_t k = place_of(p, &end);
        if (k >= 1 && k <= n) size += strlen(arg[k - 1]);
    }
    char *text = WF_TAKE(a, size, char), *to = text;
    for (const char *p = message; text && *p;) {
        size_t k = place_of(p, &end);
        if (k >= 1 && k <= n) {
            to = stpcpy(to, arg[k - 1]);
            p = end;
        } else
            *to++ = *p++;
    }
    if (text) *to = '\0';
    return text;
}
