/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* UTF-8. */

/* Length of the well-formed sequence at s; 0 when there is none. */
static size_t utf8_sequence(const unsigned char *s, size_t left)
{
    unsigned c = s[0];
    if (c == 0) return 0;
    if (c < 0x80) return 1;
    size_t n = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
    if (c < 0xC2 || c > 0xF4 || n > left) return 0;
    for (size_t i = 1; i < n; i++)
        if ((s[i] & 0xC0) != 0x80) return 0;
    if ((c == 0xE0 && s[1] < 0xA0) || (c == 0xED && s[1] > 0x9F)) return 0;
    if ((c == 0xF0 && s[1] < 0x90) || (c == 0xF4 && s[1] > 0x8F)) return 0;
    return n;
}

/* Whether the next eight bytes are all ASCII and not NUL. Checked first, because most text is ASCII. */
static bool ascii_eight(const unsigned char *s)
{
    uint64_t w;
    memcpy(&w, s, sizeof w);
    const uint64_t high = UINT64_C(0x8080808080808080), low = UINT64_C(0x0101010101010101);
    return !((w | (w - low)) & high);
}

bool wf_utf8_valid(const char *text, size_t size, struct wf_utf8_fault *fault)
{
    const unsigned char *s = (const unsigned char *)text;
    size_t i = 0;
    while (i < size) {
        if (size - i >= 8 && ascii_eight(s + i)) {
            i += 8;
            continue;
        }
        size_t n = utf8_sequence(s + i, size - i);
        if (!n) break;
        i += n;
    }
    if (i == size) return true;
    *fault = (struct wf_utf8_fault){ .line = 1, .column = 1, .byte = s[i] };
    for (size_t k = 0; k < i; k++) {
        if (s[k] == '\n') {
            fault->line++;
            fault->column = 1;
        } else if ((s[k] & 0xC0) != 0x80) {
            fault->column++;
        }
    }
    return false;
}

/* Text of users. */

enum { BAD_BYTE = 0xFFFD };

/* The character at s and its length in bytes; a byte that begins none is one character, BAD_BYTE. */
static uint32_t character(const char *s, size_t *length)
{
    const unsigned char *b = (const unsigned char *)s;
    size_t n = utf8_sequence(b, strnlen(s, 4));
    *length = n ? n : 1;
    if (n < 2) return n ? b[0] : BAD_BYTE;
    uint32_t c = b[0] & (0x7Fu >> n);
    for (size_t i = 1; i < n; i++) c = c << 6 | (b[i] & 0x3Fu);
    return c;
}

/* Does it act on a terminal instead of being shown? */
static bool acts(uint32_t c)
{
    return (c < 0x20 && c != '\t') || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E || c == 0x200F ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

const char *wf_text_for_terminal(const char *text, char end, struct wf_arena *a)
{
    enum { ESCAPE_MAX = 6 }; /* bytes of \u202e; of a byte that acts at most \x1b */
    size_t n, size = strlen(text);
    char *out = WF_TAKE(a, ESCAPE_MAX * size + 1, char), *to = out;
    for (const char *s = text; out && *s; s += n) {
        uint32_t c = character(s, &n);
        if (*s == end)
            *to++ = '\n';
        else if (n == 1 && (c == BAD_BYTE || acts(c)))
            to += snprintf(to, ESCAPE_MAX + 1, "\\x%02x", (unsigned)(unsigned char)*s);
        else if (acts(c))
            to += snprintf(to, ESCAPE_MAX + 1, "\\u%04x", (unsigned)c);
        else
            to = (char *)memcpy(to, s, n) + n;
    }
    if (out) *to = '\0';
    return out;
}

const char *wf_text_for_xml(const char *text, struct wf_arena *a)
{
    static const char replacement[] = "\xEF\xBF\xBD";
    size_t n;
    char *out = WF_TAKE(a, 3 * strlen(text) + 1, char), *to = out;
    for (const char *s = text; out && *s; s += n) {
        uint32_t c = character(s, &n);
        bool allowed = c >= 0x20 ? c < BAD_BYTE || c > 0xFFFF : c == '\t' || c == '\n' || c == '\r';
        to = (char *)memcpy(to, allowed ? s : replacement, allowed ? n : 3) + (allowed ? n : 3);
    }
    if (out) *to = '\0';
    return out;
}

/* Columns a character takes: 2 for wide East Asian ones, by their blocks (Unicode Standard Annex 11). */
static size_t columns_of(uint32_t c)
{
    bool wide = (c >= 0x1100 && c < 0x1160) || (c >= 0x2E80 && c < 0xA4D0) || (c >= 0xAC00 && c < 0xD7A4) ||
                (c >= 0xF900 && c < 0xFB00) || (c >= 0xFE30 && c < 0xFE70) || (c >= 0xFF00 && c < 0xFF61) ||
                (c >= 0x1F300 && c < 0x1FB00) || (c >= 0x20000 && c < 0x40000);
    return wide ? 2 : 1;
}

/* Does a file's name begin here: at the start, or behind a blank, a quote or a bracket? */
static bool begins_path(const char *text, const char *p)
{
    return *p == '/' && (p == text || strchr(" \t\n'\"(=", p[-1]));
}

const char *wf_text_without_folders(const char *text, struct wf_arena *a)
{
    char *out = WF_TAKE(a, strlen(text) + 1, char), *to = out;
    for (const char *p = text; out && *p;) {
        size_t n = begins_path(text, p) ? strcspn(p, " \t\n'\"(),;") : 0;
        const char *last = p;
        for (size_t i = 0; i < n; i++)
            if (p[i] == '/' && i + 1 < n) last = p + i;
        if (last > p) p = last + 1;
        *to++ = *p++;
    }
    return out;
}

const char *wf_text_shortened(const char *text, size_t columns, struct wf_arena *a)
{
    size_t n, used = 0, end = 0, at = 0;
    for (; text[at] && used <= columns; at += n) {
        used += columns_of(character(text + at, &n));
        if (used + 1 <= columns) end = at + n; /* the ellipsis takes a column */
    }
    if (used <= columns) return wf_arena_text(a, text);
    return wf_arena_print(a, "%.*s\xE2\x80\xA6", (int)end, text);
}

/* Other encodings. */

static size_t utf8_put(char *to, unsigned c)
{
    if (c < 0x80) {
        to[0] = (char)c;
        return 1;
    }
    if (c < 0x800) {
        to[0] = (char)(0xC0 | c >> 6), to[1] = (char)(0x80 | (c & 0x3F));
        return 2;
    }
    if (c < 0x10000) {
        to[0] = (char)(0xE0 | c >> 12), to[1] = (char)(0x80 | (c >> 6 & 0x3F)),
        to[2] = (char)(0x80 | (c & 0x3F));
        return 3;
    }
    to[0] = (char)(0xF0 | c >> 18), to[1] = (char)(0x80 | (c >> 12 & 0x3F));
    to[2] = (char)(0x80 | (c >> 6 & 0x3F)), to[3] = (char)(0x80 | (c & 0x3F));
    return 4;
}

enum wf_utf16 wf_utf16_order(const char *text, size_t size)
{
    const unsigned char *s = (const unsigned char *)text;
    if (size < 2) return WF_UTF16_NOT;
    if (s[0] == 0xFF && s[1] == 0xFE) return WF_UTF16_LITTLE;
    if (s[0] == 0xFE && s[1] == 0xFF) return WF_UTF16_BIG;
    if (size < 4) return WF_UTF16_NOT;
    if (s[0] && !s[1] && s[2] && !s[3]) return WF_UTF16_LITTLE;
    return !s[0] && s[1] && !s[2] && s[3] ? WF_UTF16_BIG : WF_UTF16_NOT;
}

size_t wf_utf16_to_utf8(const char *text, size_t size, enum wf_utf16 order, char *to)
{
    const unsigned char *s = (const unsigned char *)text;
    size_t n = 0, high = order == WF_UTF16_BIG ? 0 : 1;
    if (size % 2) return (size_t)-1;
    for (size_t i = 0; i < size; i += 2) {
        unsigned c = (unsigned)s[i + high] << 8 | s[i + 1 - high];
        if (c == 0xFEFF && !i) continue;
        if (!c || (c >= 0xDC00 && c <= 0xDFFF)) return (size_t)-1;
        if (c >= 0xD800 && c <= 0xDBFF) {
            i += 2;
            unsigned low = i < size ? (unsigned)s[i + high] << 8 | s[i + 1 - high] : 0;
            if (low < 0xDC00 || low > 0xDFFF) return (size_t)-1;
            c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
        }
        n += utf8_put(to + n, c);
    }
    return n;
}

size_t wf_cp1252_to_utf8(const char *text, size_t size, char *to)
{
    /* 0x80 to 0x9F; the others are their own code points. 0: not in the code page. */
    static const unsigned short upper[32] = {
        0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178
    };
    const unsigned char *s = (const unsigned char *)text;
    size_t n = 0;
    for (size_t i = 0; i < size; i++) {
        unsigned c = s[i];
        if (c >= 0x80 && c < 0xA0) c = upper[c - 0x80];
        bool control = c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
        if (!c || control || c == 0x7F || utf8_sequence(s + i, size - i) > 1) return (size_t)-1;
        n += utf8_put(to + n, c);
    }
    return n;
}

/* The byte of Windows-1252 that a character of `n` bytes is; '?': none. */
static char cp1252_byte(const char *character, size_t n)
{
    char utf8[4];
    for (unsigned b = 0x80; b <= 0xFF; b++) {
        char byte = (char)b;
        if (wf_cp1252_to_utf8(&byte, 1, utf8) == n && !memcmp(utf8, character, n)) return byte;
    }
    return '?';
}

char *wf_utf8_to_cp1252(const char *text, struct wf_arena *a)
{
    char *out = wf_arena_text(a, text), *to = out;
    for (const char *p = text; out && *p;) {
        size_t n = 1;
        while (((unsigned char)p[n] & 0xC0) == 0x80) n++;
        *to++ = n == 1 ? *p : cp1252_byte(p, n);
        p += n;
    }
    if (out) *to = '\0';
    return out;
}

/* Names. */

static unsigned char ascii_lower(char c)
{
    return (unsigned char)(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
}

/* U+00C0 to U+017F without accents and in lower case; \xDF is two letters. */
static const char without_accent[] =
    "aaaaaaaceeeeiiiidnooooox"
    "ouuuuytsaaaaaaaceeeeiiii"
    "dnooooo ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiii"
    "jjkkkllllllllllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
_Static_assert(sizeof without_accent == 0x180 - 0xC0 + 1, "one letter for each character");

const char *wf_text_folded(const char *text, struct wf_arena *a)
{
    enum { SHARP_S = 0xDF };
    size_t n;
    char *out = WF_TAKE(a, 2 * strlen(text) + 1, char), *to = out;
    for (const char *s = text; out && *s; s += n) {
        uint32_t c = character(s, &n);
        bool blank = c == '-' || c == '_' || c == ' ', accent = c >= 0x300 && c < 0x370;
        if (accent || (blank && to > out && to[-1] == ' ')) continue;
        if (c < 0x80)
            *to++ = blank ? ' ' : (char)ascii_lower((char)c);
        else if (c >= 0xC0 && c < 0x180)
            *to++ = without_accent[c - 0xC0];
        else
            to = (char *)memcpy(to, s, n) + n;
        if (c == SHARP_S) *to++ = 's';
    }
    if (out) *to = '\0';
    return out;
}

/* Suggestions. */

enum { WORD_MAX = 63 };

static size_t least_size(size_t a, size_t b) { return a < b ? a : b; }

/* The characters of a word, ASCII in lower case. Returned: how many; WORD_MAX + 1: too many. */
static size_t word_characters(const char *word, uint32_t out[static WORD_MAX])
{
    size_t n = 0, length;
    for (const char *s = word; *s; s += length) {
        uint32_t c = character(s, &length);
        if (n == WORD_MAX) return WORD_MAX + 1;
        out[n++] = c < 0x80 ? ascii_lower((char)c) : c;
    }
    return n;
}

size_t wf_word_distance(const char *a, const char *b)
{
    uint32_t x[WORD_MAX], y[WORD_MAX];
    size_t n = word_characters(a, x), m = word_characters(b, y);
    if (n > WORD_MAX || m > WORD_MAX) return (size_t)-1;
    size_t row[3][WORD_MAX + 1]; /* rows i-2, i-1, i of the table, in turn */
    for (size_t j = 0; j <= m; j++) row[0][j] = j;
    for (size_t i = 1; i <= n; i++) {
        size_t *now = row[i % 3], *before = row[(i + 2) % 3], *earlier = row[(i + 1) % 3];
        now[0] = i;
        for (size_t j = 1; j <= m; j++) {
            now[j] =
                least_size(before[j - 1] + (x[i - 1] != y[j - 1]), least_size(before[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1])
                now[j] = least_size(now[j], earlier[j - 2] + 1);
        }
    }
    return row[n % 3][m];
}

int wf_word_is_near(const char *word, size_t distance)
{
    uint32_t letters[WORD_MAX];
    size_t n = word_characters(word, letters);
    return distance <= (n <= 4 ? 1u : n <= 8 ? 2u : 3u);
}

/* Whether one word begins with the other, as "youngs" and "youngs_modulus". */
static bool is_short_form(const char *a, const char *b)
{
    size_t n = 0;
    while (a[n] && b[n] && ascii_lower(a[n]) == ascii_lower(b[n])) n++;
    return n >= 3 && (!a[n] || !b[n]);
}

const char *wf_nearest(const char *word, const char *const *known, size_t n)
{
    const char *best = NULL;
    size_t best_distance = (size_t)-1;
    for (size_t i = 0; i < n; i++) {
        size_t d = wf_word_distance(word, known[i]);
        if (d < best_distance && wf_word_is_near(word, d)) {
            best = known[i];
            best_distance = d;
        }
    }
    for (size_t i = 0; i < n && !best; i++)
        if (is_short_form(word, known[i])) best = known[i];
    return best;
}

char *wf_text_trim(char *text)
{
    text += strspn(text, " ");
    for (size_t n = strlen(text); n && text[n - 1] == ' ';) text[--n] = '\0';
    return text;
}

char *wf_list_item(char **rest)
{
    char *item = *rest, *comma = item ? strchr(item, ',') : NULL;
    if (!item) return NULL;
    *rest = comma ? comma + 1 : NULL;
    if (comma) *comma = '\0';
    item += strspn(item, " \t");
    for (size_t n = strlen(item); n && (item[n - 1] == ' ' || item[n - 1] == '\t'); n--) item[n - 1] = '\0';
    return item;
}

struct wf_hint wf_did_you_mean(const char *word, const char *const *known, size_t n)
{
    struct wf_hint hint = { "" };
    const char *near = wf_nearest(word, known, n);
    if (near) snprintf(hint.text, sizeof hint.text, "; did you mean '%s'?", near);
    return hint;
}

struct wf_hint wf_did_you_mean_or(const char *word, const char *const *known, size_t n, const char *otherwise)
{
    struct wf_hint hint = wf_did_you_mean(word, known, n);
    if (*hint.text) return hint;
    size_t used = (size_t)snprintf(hint.text, sizeof hint.text, "; %s", otherwise);
    for (size_t i = 0; i < n && used < sizeof hint.text; i++)
        used += (size_t)snprintf(hint.text + used, sizeof hint.text - used, "%s%s", i ? ", " : "", known[i]);
    return hint;
}

char *wf_base64(const void *bytes, size_t n, struct wf_arena *a)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *from = bytes;
    char *text = WF_TAKE(a, (n + 2) / 3 * 4 + 1, char), *to = text;
    for (size_t i = 0; text && i < n; i += 3) {
        unsigned x = 0;
        for (size_t k = 0; k < 3; k++) x = x << 8 | (i + k < n ? from[i + k] : 0u);
        for (size_t k = 0; k < 4; k++) *to++ = i + k > n ? '=' : digit[x >> (18 - 6 * k) & 63];
    }
    if (text) *to = '\0';
    return text;
}

bool wf_text_among(const char *names, const char *text)
{
    struct wf_arena scratch = { 0 };
    const char *folded = wf_text_folded(text, &scratch);
    size_t n = folded ? strlen(folded) : 0;
    bool found = false;
    for (const char *at = names; n && *at && !found; at += strcspn(at, " "), at += *at == ' ') {
        found = strcspn(at, " ") == n;
        for (size_t i = 0; i < n && found; i++) found = at[i] == (folded[i] == ' ' ? '_' : folded[i]);
    }
    wf_arena_free(&scratch);
    return found;
}
