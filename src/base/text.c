/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include <stdint.h>
#include <string.h>

/* Length of the well-formed sequence at s, 0 when there is none. */
static size_t sequence(const unsigned char *s, size_t left)
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

/* Eight bytes that are all plain ASCII and not NUL: nothing to check. Most of every file is. */
static bool plain8(const unsigned char *s)
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
        if (size - i >= 8 && plain8(s + i)) {
            i += 8;
            continue;
        }
        size_t n = sequence(s + i, size - i);
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
